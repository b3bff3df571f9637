//! Marks on the globe: the poles of the selected plate, a plate's drag, the rift line being drawn,
//! the ring of the brush.
//!
//! Marks are drawn over the relief; the part behind the horizon is left out here.

use super::drag::motion_at;
use super::orbit::OrbitCamera;
use super::panels::paint::PaintForm;
use super::state::{DraggedPlate, Look, PlateDrag, Pointer, Selection, Tool};
use super::view::{PlanetReader, ShownView};
use bevy::ecs::system::SystemParam;
use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::math::{TAU, angle_between, any_tangent, rotation};
use bevy_pangaea::render::to_bevy;

/// Colour of marks that stay.
const FIXED_COLOR: Color = Color::srgb(1.0, 0.74, 0.4);
/// Colour of marks that follow the pointer.
const LIVE_COLOR: Color = Color::srgb(1.0, 1.0, 1.0);
/// Longest piece of a great-circle arc in radians.
const ARC_PIECE: f64 = 0.02;
/// Pieces of a ring.
const RING_PIECES: usize = 64;
/// Radius of the ring around a point in radians.
const POINT_RADIUS: f64 = 0.008;
/// Length of an arrow's barbs in radians of the globe.
const BARB_LENGTH: f64 = 0.03;
/// Angle of an arrow's barbs to its shaft in radians.
const BARB_ANGLE: f64 = 0.45;

/// Gizmos that are never hidden by the relief.
#[derive(Default, Reflect, GizmoConfigGroup)]
pub struct MarkGizmos;

/// Draws over everything and a little wider than usual.
pub fn configure(mut store: ResMut<GizmoConfigStore>) {
    let (config, _) = store.config_mut::<MarkGizmos>();
    // In front of everything, whatever its depth.
    config.depth_bias = -1.0;
    config.line.width = 2.5;
}

/// The things that the user points at and works with.
#[derive(SystemParam)]
pub struct Marked<'w> {
    look: Res<'w, Look>,
    pointer: Res<'w, Pointer>,
    selection: Res<'w, Selection>,
    drag: Res<'w, PlateDrag>,
    tool: Res<'w, Tool>,
    brush: Res<'w, PaintForm>,
}

/// Draws the marks of the moment.
pub fn draw(
    mut gizmos: Gizmos<MarkGizmos>,
    reader: PlanetReader,
    cameras: Query<&OrbitCamera>,
    marked: Marked,
) {
    let (Some(view), Ok(camera)) = (reader.view(), cameras.single()) else {
        return;
    };
    let mut marks = Marks {
        gizmos: &mut gizmos,
        view: &view,
        look: &marked.look,
        eye: camera.transform().translation,
    };
    let pointed = marked.pointer.ground;
    match marked.drag.0 {
        Some(dragged) => marks.drag(dragged, pointed),
        None => marks.poles_of(&marked.selection),
    }
    match (&*marked.tool, pointed) {
        (Tool::RiftLine { points, .. }, _) => marks.rift_line(points, pointed),
        (Tool::Paint, Some(ground)) => {
            marks.ring(ground, marked.brush.radius / view.planet.radius, LIVE_COLOR);
        }
        (Tool::Paint, None) | (Tool::Select, _) => {}
    }
}

struct Marks<'a, 'w, 's> {
    gizmos: &'a mut Gizmos<'w, 's, MarkGizmos>,
    view: &'a ShownView<'a>,
    look: &'a Look,
    eye: Vec3,
}

impl Marks<'_, '_, '_> {
    /// The poles about which the selected plate turns.
    fn poles_of(&mut self, selection: &Selection) {
        let plates = self.view.plates;
        if let Some(plate) = selection.0.and_then(|id| plates.get(id)) {
            self.pole(plate.motion.axis, FIXED_COLOR);
            self.pole(-plate.motion.axis, FIXED_COLOR);
        }
    }

    /// The way of a dragged plate, and the poles about which it would turn.
    fn drag(&mut self, dragged: DraggedPlate, pointed: Option<DVec3>) {
        self.ring(dragged.from, POINT_RADIUS, FIXED_COLOR);
        let Some(to) = pointed else { return };
        let Some(motion) = motion_at(dragged, to, self.view) else {
            return;
        };
        self.arc(dragged.from, to, LIVE_COLOR);
        self.arrowhead(dragged.from, to, LIVE_COLOR);
        self.pole(motion.pole, LIVE_COLOR);
        self.pole(-motion.pole, LIVE_COLOR);
    }

    /// The points of a rift line, and the piece that a click would add.
    fn rift_line(&mut self, points: &[DVec3], pointed: Option<DVec3>) {
        for pair in points.windows(2) {
            self.arc(pair[0], pair[1], FIXED_COLOR);
        }
        for &point in points {
            self.ring(point, POINT_RADIUS, FIXED_COLOR);
        }
        if let (Some(&last), Some(ground)) = (points.last(), pointed) {
            self.arc(last, ground, LIVE_COLOR.with_alpha(0.6));
        }
    }

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
        // The horizon of the unit sphere is where up · eye = 1. Raised ground shows from beyond it.
        (up.dot(self.eye) > 1.0 - 2.0 * relief.max(0.0)).then(|| up * (1.0 + relief))
    }

    /// A great-circle arc.
    fn arc(&mut self, a: DVec3, b: DVec3, color: Color) {
        let angle = angle_between(a, b);
        let across = a.cross(b);
        if across.length_squared() < 1e-16 {
            return;
        }
        let axis = across.normalize();
        let pieces = (angle / ARC_PIECE).ceil().max(1.0) as usize;
        let along = (0..=pieces).map(|i| rotation(axis, angle * i as f64 / pieces as f64) * a);
        self.line(along, color);
    }

    /// The head of an arrow that comes from `from` along a great circle and points at `to`.
    fn arrowhead(&mut self, from: DVec3, to: DVec3, color: Color) {
        let across = from.cross(to).normalize_or_zero();
        // Back along the shaft, then to either side about the tip.
        let back = rotation(across, -BARB_LENGTH) * to;
        for angle in [-BARB_ANGLE, BARB_ANGLE] {
            self.arc(rotation(to, angle) * back, to, color);
        }
    }

    /// A circle on the ground, its radius in radians.
    fn ring(&mut self, center: DVec3, radius: f64, color: Color) {
        let start = rotation(any_tangent(center), radius) * center;
        let around = (0..=RING_PIECES).map(|i| TAU * i as f64 / RING_PIECES as f64);
        self.line(around.map(|angle| rotation(center, angle) * start), color);
    }

    fn line(&mut self, points: impl Iterator<Item = DVec3>, color: Color) {
        let mut last = None;
        for point in points {
            let here = self.ground(point);
            // A piece with one end behind the horizon is left out as a whole.
            if let (Some(a), Some(b)) = (last, here) {
                self.gizmos.line(a, b, color);
            }
            last = here;
        }
    }

    /// A pin at a pole of rotation.
    fn pole(&mut self, axis: DVec3, color: Color) {
        if let Some(foot) = self.ground(axis) {
            self.gizmos.line(foot, to_bevy(axis) * 1.12, color);
            self.ring(axis, 0.02, color);
        }
    }
}
