//! Arrows of velocity, and axes of folding and of ridges.
//!
//! They stand on an even, sparse subset of the samples: those nearest to the points of a small
//! Fibonacci lattice.

use super::ground::LineGround;
use super::list::{LineEnd, LineStyle, Lines};
use crate::math;
use crate::overlay::palette::Rgba;
use crate::sphere::SphereMesh;
use bevy::math::{DVec3, Vec3};

/// Half width in pixels of arrows and axes.
const HALF_WIDTH: f32 = 0.9;
/// Colour of arrows on the dark end of the ramp of speeds.
const LIGHT: Rgba = [250, 250, 244, 255];
/// Colour of arrows on its light end, and of axes.
const DARK: Rgba = [16, 18, 24, 255];

/// Arrows on a planet.
const ARROWS: usize = 1500;
/// Axes on a planet.
const AXES: usize = 7000;

/// Length in radians of the arrow of the fastest plate.
const ARROW_LENGTH: f64 = 0.085;
/// Share of the greatest speed below which a plate has no arrows.
const LEAST_SPEED_SHARE: f64 = 0.01;
/// Longest barb of an arrow in radians.
const MAX_BARB: f64 = 0.012;
/// Length in radians of an axis.
const AXIS_LENGTH: f64 = 0.018;

/// Adds arrows along the velocities of plates.
pub(super) fn add_velocities(lines: &mut Lines, ground: &LineGround) {
    let input = ground.input;
    for i in sites(input.mesh, ARROWS) {
        let plate = input.surface.plate[i as usize];
        let velocity = input
            .plates
            .angular_velocity(plate)
            .cross(input.mesh.point(i));
        let share = velocity.length() * input.planet.radius / input.params.max_speed;
        if share.is_finite() && share >= LEAST_SPEED_SHARE {
            add_arrow(lines, ground, i, velocity.normalize(), share);
        }
    }
}

/// Adds an arrow at sample `i` along a unit tangent vector, for a `share` of the greatest speed.
fn add_arrow(lines: &mut Lines, ground: &LineGround, i: u32, along: DVec3, share: f64) {
    let p = ground.input.mesh.point(i);
    let across = p.cross(along);
    let elevation = ground.height(i);
    let end = |ahead: f64, aside: f64| line_end(p + ahead * along + aside * across, elevation);
    let style = LineStyle {
        half_width: HALF_WIDTH,
        // Light on the dark end of the ramp, dark on its light end.
        color: if share < 0.6 { LIGHT } else { DARK },
    };
    let length = ARROW_LENGTH * share.min(1.5);
    let barb = (0.35 * length).min(MAX_BARB);
    let tip = end(length, 0.0);
    lines.add(end(0.0, 0.0), tip, style);
    for side in [-0.6, 0.6] {
        lines.add(tip, end(length - barb, side * barb), style);
    }
}

/// The end of a line in a direction of any length.
fn line_end(direction: DVec3, elevation: f32) -> LineEnd {
    LineEnd {
        direction: direction.normalize(),
        elevation,
    }
}

/// Adds short lines along the tangent vectors of the samples; no line for a vector of zero.
pub(super) fn add_axes(lines: &mut Lines, ground: &LineGround, axes: &[Vec3]) {
    let mesh = ground.input.mesh;
    let style = LineStyle {
        half_width: HALF_WIDTH,
        color: DARK,
    };
    for i in sites(mesh, AXES) {
        let (p, axis) = (mesh.point(i), axes[i as usize].as_dvec3());
        let along = axis - p * axis.dot(p);
        // Axes are unit vectors or zero; one that stands upright has no direction on the ground.
        if along.length_squared() > 0.25 {
            let half = 0.5 * AXIS_LENGTH * along.normalize();
            let elevation = ground.height(i);
            let [tail, tip] = [-half, half].map(|offset| line_end(p + offset, elevation));
            lines.add(tail, tip, style);
        }
    }
}

/// At most `count` samples, evenly spread, in order, each once.
fn sites(mesh: &SphereMesh, count: usize) -> Vec<u32> {
    let count = count.min(mesh.len() / 3);
    let golden = math::PI * (3.0 - 5.0_f64.sqrt());
    let mut sites: Vec<u32> = (0..count)
        .map(|k| {
            let z = 1.0 - (2.0 * k as f64 + 1.0) / count as f64;
            let (sin, cos) = math::sin_cos(golden * k as f64);
            let r = (1.0 - z * z).sqrt();
            mesh.nearest(DVec3::new(r * cos, r * sin, z))
        })
        .collect();
    // Two points of the lattice may have one nearest sample.
    sites.sort_unstable();
    sites.dedup();
    sites
}
