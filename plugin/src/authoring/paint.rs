//! Brushes on the crust.

use super::command::{Brush, PaintTarget};
use crate::crust::isostasy::Isostasy;
use crate::crust::{Crust, CrustKind, Frames, Orogeny};
use crate::math::{angle_between, direction, smoothstep};
use crate::params::TectonicParams;
use crate::plate::PlateId;
use crate::sphere::SphereMesh;

/// The parts of a planet that a brush reads and writes.
pub(super) struct Scene<'a> {
    /// Samples.
    pub mesh: &'a SphereMesh,
    /// Parameters.
    pub params: &'a TectonicParams,
    /// Frames.
    pub frames: &'a Frames,
    /// Planet radius in km.
    pub radius: f64,
    /// The crust.
    pub crust: &'a mut Crust,
}

/// Elevation in km of land that a brush makes.
const NEW_LAND: f32 = 0.3;

/// Applies a brush. Its numbers have been checked.
pub(super) fn paint(scene: &mut Scene, target: &PaintTarget, brush: &Brush) {
    for i in 0..scene.crust.len() {
        let strength = strength(scene, target, i);
        if strength > 0.0 {
            stroke(scene, i, brush, strength);
        }
    }
}

/// Switches the crust type of all samples of a plate.
pub(super) fn kind_of_plate(scene: &mut Scene, plate: PlateId, kind: CrustKind) {
    for i in 0..scene.crust.len() {
        if scene.frames.plate(scene.crust.frame[i]) == plate {
            set_kind(scene, i, kind);
        }
    }
}

/// How strongly the brush touches sample `i`, 0..1: full in the inner half of a disc, fading to its
/// edge.
fn strength(scene: &Scene, target: &PaintTarget, i: usize) -> f64 {
    match target {
        PaintTarget::Everywhere => 1.0,
        PaintTarget::Disc { center, radius } => {
            let frame = &scene.frames[usize::from(scene.crust.frame[i])];
            let p = frame.to_world(scene.mesh.points()[i]);
            let d = angle_between(p, direction(center.0, center.1)) * scene.radius;
            if d <= *radius {
                smoothstep(2.0 * (1.0 - d / radius.max(1e-9)))
            } else {
                0.0
            }
        }
    }
}

fn stroke(scene: &mut Scene, i: usize, brush: &Brush, strength: f64) {
    match *brush {
        Brush::Raise(dz) => {
            set_elevation(scene, i, scene.crust.elevation[i] + (dz * strength) as f32)
        }
        Brush::Elevation(z) => set_elevation(scene, i, z as f32),
        Brush::Kind(kind) => set_kind(scene, i, kind),
    }
}

/// Moves a sample to `z` km, within the elevations of the planet; its thickness follows.
fn set_elevation(scene: &mut Scene, i: usize, z: f32) {
    let (low, high) = (
        scene.params.trench_elevation as f32,
        scene.params.summit_elevation as f32,
    );
    let (z, old) = (z.clamp(low, high), scene.crust.elevation[i]);
    let law = Isostasy::new(scene.params);
    let thickness = scene.crust.thickness[i] + law.thickening(old, z - old);
    scene.crust.thickness[i] = thickness.max(0.5 * scene.params.ocean_thickness as f32);
    scene.crust.elevation[i] = z;
}

fn set_kind(scene: &mut Scene, i: usize, kind: CrustKind) {
    let crust = &mut *scene.crust;
    if crust.kind[i] == kind {
        return;
    }
    crust.kind[i] = kind;
    crust.orogeny[i] = Orogeny::None;
    crust.orogeny_age[i] = 0.0;
    match kind {
        CrustKind::Continental => {
            crust.elevation[i] = NEW_LAND;
            crust.thickness[i] = Isostasy::new(scene.params).thickness(NEW_LAND);
        }
        CrustKind::Oceanic => {
            crust.elevation[i] = scene.params.ridge_elevation as f32;
            crust.thickness[i] = scene.params.ocean_thickness as f32;
            crust.ocean_age[i] = 0.0;
        }
    }
}
