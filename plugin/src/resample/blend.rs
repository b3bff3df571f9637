//! The crust of one frame at a point: values by barycentric interpolation, categories from the
//! nearest sample.
//!
//! *Mixed triangles*: corners of other frames, and of the other kind of crust than the nearest, are
//! dropped and the weights renormalised, so that a coast stays as sharp as it was. *A frame at
//! rest* copies bits.

use super::input::ProjectInput;
use crate::crust::{Crust, CrustKind, CrustRow, FrameId};
use crate::plate::overlap::FrameHit;
use crate::sphere::Location;
use bevy::math::{DQuat, DVec3};
use bevy::prelude::*;

/// The crust of a frame at a hit, in world coordinates, and the share of continental corners.
/// `kind` asks for crust of that kind, where the triangle has some, instead of the nearest
/// sample's.
pub(super) fn sample_frame(
    input: &ProjectInput,
    hit: FrameHit,
    kind: Option<CrustKind>,
) -> (CrustRow, f32) {
    let &ProjectInput { mesh, crust, .. } = input;
    let frame = input.frames[usize::from(hit.frame)];
    let nearest = hit.sample as usize;
    let wanted = kind.unwrap_or(crust.kind[nearest]);
    if frame.is_at_rest() && wanted == crust.kind[nearest] && mesh.points()[nearest] == hit.local {
        // On the sample itself there is nothing to blend, and a copy keeps its bits.
        let share = f32::from(u8::from(crust.is_continental(nearest)));
        return (crust.row(nearest), share);
    }
    let at = mesh.locate_from(hit.local, hit.sample);
    let share = continental_share(crust, &at, hit.frame);
    // At the rim of a frame the triangle may have no corner of that kind.
    let row = blend(crust, &at, hit.frame, wanted).unwrap_or_else(|| crust.row(nearest));
    (to_world(row, frame.rotation), share as f32)
}

/// The share of continental crust among the corners of one frame, by weight; 0 where it has none.
fn continental_share(crust: &Crust, at: &Location, frame: FrameId) -> f64 {
    let mut weight = [0.0, 0.0];
    for (&i, &w) in at.vertices.iter().zip(&at.weights) {
        if crust.frame[i as usize] == frame {
            weight[usize::from(crust.is_continental(i as usize))] += w;
        }
    }
    let sum = weight[0] + weight[1];
    if sum > 0.0 { weight[1] / sum } else { 0.0 }
}

/// Sums over the corners of a triangle, each times its weight.
#[derive(Default)]
struct BlendSums {
    weight: f64,
    thickness: f64,
    elevation: f64,
    ocean_age: f64,
    orogeny_age: f64,
    ridge: DVec3,
    fold: DVec3,
}

impl BlendSums {
    fn add(&mut self, crust: &Crust, i: usize, w: f64) {
        self.weight += w;
        self.thickness += w * f64::from(crust.thickness[i]);
        self.elevation += w * f64::from(crust.elevation[i]);
        self.ocean_age += w * f64::from(crust.ocean_age[i]);
        self.orogeny_age += w * f64::from(crust.orogeny_age[i]);
        // Ridges are lines without a head: corners are turned to the same side before they are
        // added.
        let ridge = crust.ridge[i].as_dvec3();
        if ridge.dot(self.ridge) < 0.0 {
            self.ridge += -ridge * w;
        } else {
            self.ridge += ridge * w;
        }
        self.fold += crust.fold[i].as_dvec3() * w;
    }

    fn mean(&self, sum: f64) -> f32 {
        (sum / self.weight) as f32
    }
}

/// The barycentric mean over the corners of one frame and kind.
fn blend(crust: &Crust, at: &Location, frame: FrameId, kind: CrustKind) -> Option<CrustRow> {
    let mut sums = BlendSums::default();
    let mut largest_weight = 0.0;
    let mut nearest = None;
    for (&i, &w) in at.vertices.iter().zip(&at.weights) {
        let i = i as usize;
        if crust.frame[i] != frame || crust.kind[i] != kind || w <= 0.0 {
            continue;
        }
        sums.add(crust, i, w);
        if w > largest_weight {
            largest_weight = w;
            nearest = Some(i);
        }
    }
    Some(CrustRow {
        thickness: sums.mean(sums.thickness),
        elevation: sums.mean(sums.elevation),
        ocean_age: sums.mean(sums.ocean_age),
        ridge: sums.ridge.normalize_or_zero().as_vec3(),
        orogeny_age: sums.mean(sums.orogeny_age),
        // A mean, not a direction: the length says how strongly crust is folded.
        fold: (sums.fold / sums.weight).as_vec3(),
        // What has no mean. Where no corner is of that kind the means are 0 / 0, and the whole row
        // is dropped here.
        ..crust.row(nearest?)
    })
}

fn to_world(row: CrustRow, rotation: DQuat) -> CrustRow {
    let turn = |v: Vec3| (rotation * v.as_dvec3()).as_vec3();
    CrustRow {
        ridge: turn(row.ridge),
        fold: turn(row.fold),
        ..row
    }
}
