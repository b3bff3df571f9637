//! Brushes on the crust.

use super::command::{Brush, PaintTarget};
use crate::crust::isostasy::Isostasy;
use crate::crust::{Crust, CrustKind, Frames, Orogeny};
use crate::math::{angle_between, direction, smoothstep};
use crate::plate::PlateId;
use crate::view::PlanetView;

/// Crust under edit, with the parts of its planet that edits read.
pub(super) struct CrustEdit<'a> {
    /// Samples, parameters, radius.
    pub planet: PlanetView<'a>,
    /// Where samples are now.
    pub frames: &'a Frames,
    /// The crust.
    pub crust: &'a mut Crust,
}

/// Elevation of land that a brush makes.
const NEW_LAND_KM: f32 = 0.3;

/// Applies a brush. Its numbers have been checked.
pub(super) fn paint(edit: &mut CrustEdit, target: &PaintTarget, brush: &Brush) {
    for i in 0..edit.crust.len() {
        let strength = strength(edit, target, i);
        if strength > 0.0 {
            stroke(edit, i, brush, strength);
        }
    }
}

/// Switches the crust type of all samples of a plate.
pub(super) fn set_plate_kind(edit: &mut CrustEdit, plate: PlateId, kind: CrustKind) {
    for i in 0..edit.crust.len() {
        if edit.frames.plate(edit.crust.frame[i]) == plate {
            set_kind(edit, i, kind);
        }
    }
}

/// How strongly the brush touches sample `i`, 0..1: full in the inner half of a disc, fading to its
/// edge.
fn strength(edit: &CrustEdit, target: &PaintTarget, i: usize) -> f64 {
    match target {
        PaintTarget::Everywhere => 1.0,
        PaintTarget::Disc { center, radius } => {
            let frame = &edit.frames[usize::from(edit.crust.frame[i])];
            let p = frame.to_world(edit.planet.mesh.points()[i]);
            let d = angle_between(p, direction(center.0, center.1)) * edit.planet.radius;
            if d <= *radius {
                smoothstep(2.0 * (1.0 - d / radius.max(1e-9)))
            } else {
                0.0
            }
        }
    }
}

fn stroke(edit: &mut CrustEdit, i: usize, brush: &Brush, strength: f64) {
    match *brush {
        Brush::Raise(dz) => {
            set_elevation(edit, i, edit.crust.elevation[i] + (dz * strength) as f32)
        }
        Brush::Elevation(z) => set_elevation(edit, i, z as f32),
        Brush::Kind(kind) => set_kind(edit, i, kind),
    }
}

/// Moves a sample to `z` km, within the elevations of the planet; its thickness follows.
fn set_elevation(edit: &mut CrustEdit, i: usize, z: f32) {
    let params = edit.planet.params;
    let old = edit.crust.elevation[i];
    let z = z.clamp(
        params.trench_elevation as f32,
        params.summit_elevation as f32,
    );
    let law = Isostasy::new(params);
    let thickness = edit.crust.thickness[i] + law.thickening(old, z - old);
    // Crust is never thinner than half of an ocean's.
    edit.crust.thickness[i] = thickness.max(0.5 * params.ocean_thickness as f32);
    edit.crust.elevation[i] = z;
}

fn set_kind(edit: &mut CrustEdit, i: usize, kind: CrustKind) {
    let crust = &mut *edit.crust;
    if crust.kind[i] == kind {
        return;
    }
    crust.kind[i] = kind;
    crust.orogeny[i] = Orogeny::None;
    crust.orogeny_age[i] = 0.0;
    match kind {
        CrustKind::Continental => {
            crust.elevation[i] = NEW_LAND_KM;
            crust.thickness[i] = Isostasy::new(edit.planet.params).thickness(NEW_LAND_KM);
        }
        CrustKind::Oceanic => {
            crust.elevation[i] = edit.planet.params.ridge_elevation as f32;
            crust.thickness[i] = edit.planet.params.ocean_thickness as f32;
            crust.ocean_age[i] = 0.0;
        }
    }
}
