//! Lines on a globe: plate boundaries by kind, the outline of the selected plate, arrows of
//! velocity, axes of folding and of ridges, rivers of a bake.
//!
//! A boundary runs through the middles of the edges whose ends belong to different plates, and
//! through the centres of triangles where three plates meet. Arrows stand on an even, sparse subset
//! of the samples: those nearest to the points of a small Fibonacci lattice.

use super::{Globe, to_bevy};
use crate::control::Bake;
use crate::math;
use crate::overlay::palette::Rgba;
use crate::overlay::{BoundaryKind, Overlay, OverlayInput, boundaries, rivers};
use bevy::asset::RenderAssetUsages;
use bevy::math::DVec3;
use bevy::mesh::{Indices, MeshVertexAttribute, PrimitiveTopology, VertexFormat};
use bevy::prelude::*;

/// The other end of a line, a direction.
pub(super) const OTHER: MeshVertexAttribute = MeshVertexAttribute::new(
    "PangaeaOtherEnd",
    0x70a9_6ae5_0000_0002,
    VertexFormat::Float32x3,
);
/// Elevations of both ends in km.
pub(super) const HEIGHTS: MeshVertexAttribute = MeshVertexAttribute::new(
    "PangaeaHeights",
    0x70a9_6ae5_0000_0003,
    VertexFormat::Float32x2,
);
/// Side of the line, and half its width in pixels.
pub(super) const SIDE: MeshVertexAttribute = MeshVertexAttribute::new(
    "PangaeaSide",
    0x70a9_6ae5_0000_0004,
    VertexFormat::Float32x2,
);
/// Colour in sRGB.
pub(super) const COLOR: MeshVertexAttribute = MeshVertexAttribute::new(
    "PangaeaLineColor",
    0x70a9_6ae5_0000_0005,
    VertexFormat::Unorm8x4,
);

/// Half widths in pixels of a picture of 720 lines.
const BOUNDARY_WIDTH: f32 = 1.1;
const OUTLINE_WIDTH: f32 = 2.0;
const ARROW_WIDTH: f32 = 0.9;
/// Of the lowest order that is drawn, and how much wider a river grows than on a map.
const RIVER_WIDTH: (f32, f32) = (0.45, 1.6);

const OUTLINE: Rgba = [255, 255, 255, 255];
const LIGHT: Rgba = [250, 250, 244, 255];
const DARK: Rgba = [16, 18, 24, 255];

/// Arrows and axes on a planet.
const ARROWS: usize = 1500;
const AXES: usize = 7000;

/// Length in radians of the arrow of the fastest plate, and of an axis.
const ARROW_LENGTH: f64 = 0.085;
const AXIS_LENGTH: f64 = 0.018;

/// Lines being collected.
#[derive(Default)]
pub(super) struct Lines {
    here: Vec<[f32; 3]>,
    there: Vec<[f32; 3]>,
    heights: Vec<[f32; 2]>,
    sides: Vec<[f32; 2]>,
    colors: Vec<[u8; 4]>,
}

/// An end of a line: unit direction in planet coordinates, drawn elevation in km.
type End = (DVec3, f32);

impl Lines {
    fn add(&mut self, a: End, b: End, half_width: f32, color: Rgba) {
        let (p, q) = (to_bevy(a.0).to_array(), to_bevy(b.0).to_array());
        for (here, there, heights) in [(p, q, [a.1, b.1]), (q, p, [b.1, a.1])] {
            for side in [-1.0, 1.0] {
                self.here.push(here);
                self.there.push(there);
                self.heights.push(heights);
                self.sides.push([side, half_width]);
                self.colors.push(color);
            }
        }
    }

    /// Number of lines.
    pub(super) fn len(&self) -> usize {
        self.here.len() / 4
    }

    /// Two triangles a line. Never empty: without lines there is one of no length in the planet's
    /// centre.
    pub(super) fn into_mesh(mut self) -> Mesh {
        if self.len() == 0 {
            self.add((DVec3::ZERO, 0.0), (DVec3::ZERO, 0.0), 0.0, DARK);
        }
        // The ends look at each other, so side -1 of one is opposite to side 1 of the other.
        let quad = |k: u32| [0, 1, 2, 0, 2, 3].map(|corner| 4 * k + corner);
        let indices = (0..self.len() as u32).flat_map(quad).collect();
        Mesh::new(
            PrimitiveTopology::TriangleList,
            RenderAssetUsages::RENDER_WORLD,
        )
        .with_inserted_attribute(Mesh::ATTRIBUTE_POSITION, self.here)
        .with_inserted_attribute(OTHER, self.there)
        .with_inserted_attribute(HEIGHTS, self.heights)
        .with_inserted_attribute(SIDE, self.sides)
        .with_inserted_attribute(
            COLOR,
            bevy::mesh::VertexAttributeValues::Unorm8x4(self.colors),
        )
        .with_inserted_indices(Indices::U32(indices))
    }
}

/// All lines that `globe` asks for, on ground of the `elevation` in km at which samples are drawn.
pub(super) fn collect(
    input: &OverlayInput,
    globe: &Globe,
    elevation: impl Fn(usize) -> f32,
) -> Lines {
    let mut lines = Lines::default();
    let drawn = |i: u32| {
        let elevation = elevation(i as usize);
        if globe.sea {
            elevation.max(0.0)
        } else {
            elevation
        }
    };
    if globe.boundaries || globe.overlay == Overlay::Plates || globe.selected.is_some() {
        add_boundaries(&mut lines, input, globe, &drawn);
    }
    match globe.overlay {
        Overlay::Velocity => add_velocities(&mut lines, input, &drawn),
        Overlay::FoldDirection => add_axes(&mut lines, input, &input.surface.crust.fold, &drawn),
        Overlay::RidgeDirection => add_axes(&mut lines, input, &input.surface.crust.ridge, &drawn),
        overlay => input
            .bake
            .into_iter()
            .for_each(|bake| add_rivers(&mut lines, input, overlay, bake, &drawn)),
    }
    lines
}

fn add_boundaries(
    lines: &mut Lines,
    input: &OverlayInput,
    globe: &Globe,
    drawn: &dyn Fn(u32) -> f32,
) {
    let kinds = boundaries(input);
    let all = globe.boundaries || globe.overlay == Overlay::Plates;
    let plate = |i: u32| input.surface.plate[i as usize];
    let style = |i: u32, j: u32| {
        let selected = globe
            .selected
            .is_some_and(|s| (plate(i) == s) != (plate(j) == s));
        let kind = [kinds[i as usize], kinds[j as usize]]
            .into_iter()
            .find(|&k| k != BoundaryKind::None);
        match (selected, kind) {
            (true, _) => Some((OUTLINE_WIDTH, OUTLINE)),
            (false, Some(kind)) if all => Some((BOUNDARY_WIDTH, kind.color())),
            _ => None,
        }
    };
    let middle = |i: u32, j: u32| -> End {
        let p = (input.mesh.point(i) + input.mesh.point(j)).normalize();
        (p, 0.5 * (drawn(i) + drawn(j)))
    };
    for &[a, b, c] in input.mesh.triangles() {
        let crossed =
            [(a, b), (b, c), (c, a)].map(|(i, j)| (plate(i) != plate(j)).then_some((i, j)));
        let mut ends = crossed.into_iter().flatten();
        match (ends.next(), ends.next(), ends.next()) {
            (Some(first), Some(second), None) => {
                if let Some((width, color)) = style(first.0, first.1) {
                    lines.add(
                        middle(first.0, first.1),
                        middle(second.0, second.1),
                        width,
                        color,
                    );
                }
            }
            (Some(_), Some(_), Some(_)) => {
                let p = input.mesh.point(a) + input.mesh.point(b) + input.mesh.point(c);
                let centre = (p.normalize(), (drawn(a) + drawn(b) + drawn(c)) / 3.0);
                for (i, j) in crossed.into_iter().flatten() {
                    if let Some((width, color)) = style(i, j) {
                        lines.add(middle(i, j), centre, width, color);
                    }
                }
            }
            _ => {}
        }
    }
}

fn add_velocities(lines: &mut Lines, input: &OverlayInput, drawn: &dyn Fn(u32) -> f32) {
    let fastest = input.params.max_speed;
    for i in sites(input, ARROWS) {
        let p = input.mesh.point(i);
        let velocity = input
            .plates
            .angular_velocity(input.surface.plate[i as usize])
            .cross(p);
        let share = velocity.length() * input.planet.radius / fastest;
        if !share.is_finite() || share < 0.01 {
            continue;
        }
        // Light on the dark end of the ramp, dark on its light end.
        let color = if share < 0.6 { LIGHT } else { DARK };
        let along = velocity.normalize();
        let across = p.cross(along);
        let length = ARROW_LENGTH * share.min(1.5);
        let barb = (0.35 * length).min(0.012);
        let height = drawn(i);
        let on =
            |forward: f64, aside: f64| ((p + forward * along + aside * across).normalize(), height);
        lines.add(on(0.0, 0.0), on(length, 0.0), ARROW_WIDTH, color);
        for side in [-0.6, 0.6] {
            lines.add(
                on(length, 0.0),
                on(length - barb, side * barb),
                ARROW_WIDTH,
                color,
            );
        }
    }
}

fn add_rivers(
    lines: &mut Lines,
    input: &OverlayInput,
    overlay: Overlay,
    bake: &Bake,
    drawn: &dyn Fn(u32) -> f32,
) {
    let end = |i: u32| -> End {
        let p = bake.mesh().point(i);
        (
            p,
            input.mesh.locate(p).interpolate(|k| f64::from(drawn(k))) as f32,
        )
    };
    for stretch in rivers::reaches(overlay, bake) {
        let [from, to] = stretch.ends.map(end);
        let half = RIVER_WIDTH.0 + RIVER_WIDTH.1 * stretch.half_width() as f32;
        lines.add(from, to, half, stretch.color);
    }
}

fn add_axes(lines: &mut Lines, input: &OverlayInput, axes: &[Vec3], drawn: &dyn Fn(u32) -> f32) {
    for i in sites(input, AXES) {
        let (p, axis) = (input.mesh.point(i), axes[i as usize].as_dvec3());
        let along = axis - p * axis.dot(p);
        if along.length_squared() > 0.25 {
            let half = 0.5 * AXIS_LENGTH * along.normalize();
            let height = drawn(i);
            let end = |offset: DVec3| ((p + offset).normalize(), height);
            lines.add(end(-half), end(half), ARROW_WIDTH, DARK);
        }
    }
}

/// At most `count` samples, evenly spread, in order, each once.
fn sites(input: &OverlayInput, count: usize) -> Vec<u32> {
    let count = count.min(input.mesh.len() / 3);
    let golden = math::PI * (3.0 - 5.0_f64.sqrt());
    let mut sites: Vec<u32> = (0..count)
        .map(|k| {
            let z = 1.0 - (2.0 * k as f64 + 1.0) / count as f64;
            let (sin, cos) = math::sin_cos(golden * k as f64);
            let r = (1.0 - z * z).sqrt();
            input.mesh.nearest(DVec3::new(r * cos, r * sin, z))
        })
        .collect();
    sites.sort_unstable();
    sites.dedup();
    sites
}

#[cfg(test)]
#[path = "lines_tests.rs"]
mod tests;
