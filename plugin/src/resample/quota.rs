//! Continental crust is conserved: area by quota, volume by scale.
//!
//! What lies below another frame loses its area: *stacking* where both belong to one plate, *forced subduction*
//! where not. Its thickness is added to what lies above; what exceeds the root of the highest mountains falls off as
//! *delamination*. Continental crust that fills a crack is stretched: area without volume, booked as *rifting*. Nearest assignment alone would let the rest of the area flicker by 0.1 to 0.2 %, so samples of
//! the coast, ranked by the share of continental corners in their triangle, change kind until the area is the
//! ledger's; less than half a sample is left, and carried to the next resample. Thicknesses are scaled so that the volume is the ledger's.

use crate::crust::cover::topmost;
use crate::crust::isostasy::Isostasy;
use crate::crust::ledger::measure;
use crate::crust::{Cause, Crust, CrustKind, Ledger, Surface};
use crate::params::TectonicParams;
use crate::resample::project::{Notes, ProjectInput, sample_frame};
use crate::sphere::SphereMesh;

/// Books what was buried and brings the projected crust to the area and the volume that the ledger expects.
pub fn conserve(
    input: &ProjectInput,
    params: &TectonicParams,
    radius: f64,
    surface: &mut Surface,
    notes: &Notes,
    ledger: &mut Ledger,
) {
    let before = measure(input.crust, input.mesh, radius);
    let square = radius * radius;
    let mut lost = [0.0; 2];
    for (i, layers) in notes.layers.iter().enumerate() {
        for (lost, &count) in lost.iter_mut().zip(layers) {
            *lost += f64::from(count) * input.mesh.areas()[i];
        }
    }
    ledger.book(Cause::Stacking, -lost[0] * square, 0.0);
    ledger.book(Cause::ForcedSubduction, -lost[1] * square, 0.0);
    let stretched: f64 = (0..surface.len())
        .filter(|&i| notes.weight[i] < 0.0 && surface.crust.is_continental(i))
        .map(|i| input.mesh.areas()[i])
        .sum();
    ledger.book(Cause::Rifting, stretched * square, 0.0);
    let target = before.area + (stretched - lost[0] - lost[1]) * square + ledger.carried_area;
    flip_coast(input, surface, notes, target / square);
    let shed = stack(params, &mut surface.crust, input.mesh, notes) * square;
    ledger.book(Cause::Delamination, 0.0, -shed);
    scale_volume(&mut surface.crust, input.mesh, radius, before.volume - shed);
    let after = measure(&surface.crust, input.mesh, radius);
    ledger.carried_area = target - after.area;
    ledger.check(after);
}

/// Lets samples of the coast change kind until the continental area is `target` steradians as nearly as it can be.
fn flip_coast(input: &ProjectInput, surface: &mut Surface, notes: &Notes, target: f64) {
    let areas = input.mesh.areas();
    let area: f64 = (0..areas.len()).filter(|&i| surface.crust.is_continental(i)).map(|i| areas[i]).sum();
    let mut missing = target - area;
    let to = if missing > 0.0 { CrustKind::Continental } else { CrustKind::Oceanic };
    let mut coast: Vec<(f32, u32)> = (0..areas.len() as u32)
        .filter_map(|i| {
            let weight = notes.weight[i as usize];
            let share = if to == CrustKind::Continental { weight } else { 1.0 - weight };
            let candidate = weight >= 0.0 && share > 0.02 && surface.crust.kind[i as usize] != to;
            candidate.then_some((-share, i))
        })
        .collect();
    coast.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    for (_, i) in coast {
        let change = if to == CrustKind::Continental { areas[i as usize] } else { -areas[i as usize] };
        // Half a sample too much is as good as half a sample too little.
        if (missing - change).abs() >= missing.abs() {
            break;
        }
        let p = input.mesh.point(i);
        let hits = input.cover.covering(input.mesh, input.crust, input.frames, p);
        let Some(top) = topmost(input.crust, input.frames, input.polarity, &hits, p) else { continue };
        let (row, _) = sample_frame(input, top, Some(to));
        if row.kind == to {
            row.write(&mut surface.crust, i as usize);
            missing -= change;
        }
    }
}

/// Adds what is buried to the crust above. Returns the volume that falls off, per square of the radius.
fn stack(params: &TectonicParams, crust: &mut Crust, mesh: &SphereMesh, notes: &Notes) -> f64 {
    let thickest = Isostasy::new(params).thickness(params.summit_elevation as f32);
    let mut shed = 0.0;
    for i in 0..crust.len() {
        if notes.below[i] > 0.0 && crust.is_continental(i) {
            crust.thickness[i] += notes.below[i];
        }
        if notes.below[i] > 0.0 && crust.is_continental(i) && crust.thickness[i] > thickest {
            shed += f64::from(crust.thickness[i] - thickest) * mesh.areas()[i];
            crust.thickness[i] = thickest;
        }
    }
    shed
}

/// Scales continental thicknesses so that the volume is `target` km³.
fn scale_volume(crust: &mut Crust, mesh: &SphereMesh, radius: f64, target: f64) {
    // Rounding to single precision leaves a little; a second pass takes it.
    for _ in 0..2 {
        let volume = measure(crust, mesh, radius).volume;
        if volume <= 0.0 || volume == target {
            return;
        }
        let scale = target / volume;
        for i in 0..crust.len() {
            if crust.is_continental(i) {
                crust.thickness[i] = (f64::from(crust.thickness[i]) * scale) as f32;
            }
        }
    }
}
