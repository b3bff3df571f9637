//! Marks on the globe: the poles of the selected plate, the rift line being drawn, the ring of the
//! brush.
//!
//! Marks are drawn over the relief; what lies behind the horizon is left out here.

use super::camera::OrbitCamera;
use super::panels::paint::PaintForm;
use super::state::{Look, PlanetReader, Pointer, Selection, Tool, View};
use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::math::{any_tangent, rotation};
use bevy_pangaea::render::to_bevy;

const MARK: Color = Color::srgb(1.0, 0.74, 0.4);
const LIVE: Color = Color::srgb(1.0, 1.0, 1.0);

/// Gizmos that are never hidden by the relief.
#[derive(Default, Reflect, GizmoConfigGroup)]
pub struct MarkGizmos;

/// Draws over everything and a little wider than usual.
pub fn configure(mut store: ResMut<GizmoConfigStore>) {
    let (config, _) = store.config_mut::<MarkGizmos>();
    config.depth_bias = -1.0;
    config.line.width = 2.5;
}

/// Draws the marks of the moment.
pub fn draw(
    mut gizmos: Gizmos<MarkGizmos>,
    reader: PlanetReader,
    cameras: Query<&OrbitCamera>,
    (look, pointer, selection): (Res<Look>, Res<Pointer>, Res<Selection>),
    (tool, brush): (Res<Tool>, Res<PaintForm>),
) {
    let (Some(view), Ok(camera)) = (reader.view(), cameras.single()) else {
        return;
    };
    let mut pen = Pen {
        gizmos: &mut gizmos,
        view: &view,
        look: &look,
        eye: camera.transform().translation,
    };
    if let Some(plate) = selection.0.and_then(|id| view.plates.get(id)) {
        pen.pole(plate.motion.axis);
        pen.pole(-plate.motion.axis);
    }
    match &*tool {
        Tool::Select => {}
        Tool::RiftLine { points, .. } => {
            points
                .windows(2)
                .for_each(|pair| pen.arc(pair[0], pair[1], MARK));
            points
                .iter()
                .for_each(|&point| pen.ring(point, 0.008, MARK));
            if let (Some(&last), Some(ground)) = (points.last(), pointer.ground) {
                pen.arc(last, ground, LIVE.with_alpha(0.6));
            }
        }
        Tool::Paint => {
            if let Some(ground) = pointer.ground {
                pen.ring(ground, brush.radius / view.planet.radius, LIVE);
            }
        }
    }
}

struct Pen<'a, 'w, 's> {
    gizmos: &'a mut Gizmos<'w, 's, MarkGizmos>,
    view: &'a View<'a>,
    look: &'a Look,
    eye: Vec3,
}

impl Pen<'_, '_, '_> {
    /// The point of the drawn ground at a direction, if it is on this side of the horizon.
    fn ground(&self, direction: DVec3) -> Option<Vec3> {
        let elevation = self.view.surface.at(self.view.mesh, direction).elevation;
        let drawn = if self.look.sea {
            elevation.max(0.0)
        } else {
            elevation
        };
        let relief = drawn * self.look.exaggeration / self.view.planet.radius as f32;
        let up = to_bevy(direction);
        (up.dot(self.eye) > 1.0 - 2.0 * relief.max(0.0)).then(|| up * (1.0 + relief))
    }

    /// A great-circle arc.
    fn arc(&mut self, a: DVec3, b: DVec3, color: Color) {
        let angle = bevy_pangaea::math::angle_between(a, b);
        let across = a.cross(b);
        if across.length_squared() < 1e-16 {
            return;
        }
        let axis = across.normalize();
        let pieces = (angle / 0.02).ceil().max(1.0) as usize;
        let along = (0..=pieces).map(|i| rotation(axis, angle * i as f64 / pieces as f64) * a);
        self.line(along, color);
    }

    /// A circle on the ground, its radius in radians.
    fn ring(&mut self, center: DVec3, radius: f64, color: Color) {
        let start = rotation(any_tangent(center), radius) * center;
        let pieces = 64;
        let turn = |i: usize| rotation(center, bevy_pangaea::math::TAU * i as f64 / pieces as f64);
        self.line((0..=pieces).map(|i| turn(i) * start), color);
    }

    fn line(&mut self, points: impl Iterator<Item = DVec3>, color: Color) {
        let mut last = None;
        for point in points {
            let here = self.ground(point);
            if let (Some(a), Some(b)) = (last, here) {
                self.gizmos.line(a, b, color);
            }
            last = here;
        }
    }

    /// A pin at a pole of rotation.
    fn pole(&mut self, axis: DVec3) {
        if let Some(foot) = self.ground(axis) {
            self.gizmos.line(foot, to_bevy(axis) * 1.12, MARK);
            self.ring(axis, 0.02, MARK);
        }
    }
}
