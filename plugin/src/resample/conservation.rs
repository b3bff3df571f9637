//! Continental crust is conserved: area by quota, volume by scale.
//!
//! What lies below another frame loses its area: *stacking* where both belong to one plate, *forced
//! subduction* where not. Its thickness is added to what lies above; what exceeds the root of the
//! highest mountains falls off as *delamination*. Continental crust that fills a crack is
//! stretched: area without volume, booked as *rifting*. Nearest assignment alone would let the rest
//! of the area flicker by 0.1 to 0.2 %, so samples of the coast, ranked by the share of continental
//! corners in their triangle, change kind until the area is the ledger's; less than half a sample
//! is left, and carried to the next resample. Thicknesses are scaled so that the volume is the
//! ledger's.

use crate::crust::isostasy::Isostasy;
use crate::crust::ledger::measure;
use crate::crust::{Cause, Crust, CrustKind, Ledger, Surface};
use crate::parallel::{self, CHUNK};
use crate::params::TectonicParams;
use crate::resample::project::{Notes, ProjectInput, sample_frame};
use crate::sphere::SphereMesh;
use rayon::prelude::*;

/// Books what was buried and brings the projected crust to the area and the volume that the ledger
/// expects.
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
    for i in chosen(notes.layers.len(), |i| notes.layers[i] != [0; 2]) {
        for (lost, &count) in lost.iter_mut().zip(&notes.layers[i]) {
            *lost += f64::from(count) * input.mesh.areas()[i];
        }
    }
    ledger.book(Cause::Stacking, -lost[0] * square, 0.0);
    ledger.book(Cause::ForcedSubduction, -lost[1] * square, 0.0);
    let stretched = chosen(surface.len(), |i| {
        notes.weight[i] < 0.0 && surface.crust.is_continental(i)
    });
    let stretched: f64 = stretched.into_iter().map(|i| input.mesh.areas()[i]).sum();
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

/// The samples of a choice, in order.
fn chosen(n: usize, choice: impl Fn(usize) -> bool + Sync + Send) -> Vec<usize> {
    parallel::map_chunks(n, |range| range.filter(|&i| choice(i)).collect::<Vec<_>>()).concat()
}

/// Lets samples of the coast change kind until the continental area is `target` steradians as
/// nearly as it can be.
fn flip_coast(input: &ProjectInput, surface: &mut Surface, notes: &Notes, target: f64) {
    let areas = input.mesh.areas();
    let land = chosen(areas.len(), |i| surface.crust.is_continental(i));
    let area: f64 = land.into_iter().map(|i| areas[i]).sum();
    let mut missing = target - area;
    let to = if missing > 0.0 {
        CrustKind::Continental
    } else {
        CrustKind::Oceanic
    };
    let share = |i: usize| {
        let weight = notes.weight[i];
        if to == CrustKind::Continental {
            weight
        } else {
            1.0 - weight
        }
    };
    let coast = chosen(areas.len(), |i| {
        notes.weight[i] >= 0.0 && share(i) > 0.02 && surface.crust.kind[i] != to
    });
    let mut coast: Vec<(f32, u32)> = coast.into_iter().map(|i| (-share(i), i as u32)).collect();
    coast.par_sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    for (_, i) in coast {
        let change = if to == CrustKind::Continental {
            areas[i as usize]
        } else {
            -areas[i as usize]
        };
        // Half a sample too much is as good as half a sample too little.
        if (missing - change).abs() >= missing.abs() {
            break;
        }
        let p = input.mesh.point(i);
        let &ProjectInput {
            mesh,
            crust,
            frames,
            overlap,
            polarity,
        } = input;
        let Some(top) = overlap.top_if(mesh, crust, frames, polarity, p, |_| true) else {
            continue;
        };
        let (row, _) = sample_frame(input, top, Some(to));
        if row.kind == to {
            row.write(&mut surface.crust, i as usize);
            missing -= change;
        }
    }
}

/// Adds what is buried to the crust above. Returns the volume that falls off, per square of the
/// radius.
fn stack(params: &TectonicParams, crust: &mut Crust, mesh: &SphereMesh, notes: &Notes) -> f64 {
    let thickest = Isostasy::new(params).thickness(params.summit_elevation as f32);
    let mut shed = 0.0;
    for i in chosen(crust.len(), |i| {
        notes.below[i] > 0.0 && crust.is_continental(i)
    }) {
        crust.thickness[i] += notes.below[i];
        if crust.thickness[i] > thickest {
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
        let columns = (
            crust.kind.par_chunks(CHUNK),
            crust.thickness.par_chunks_mut(CHUNK),
        );
        columns.into_par_iter().for_each(|(kind, thickness)| {
            for (_, e) in kind
                .iter()
                .zip(thickness)
                .filter(|(kind, _)| **kind == CrustKind::Continental)
            {
                *e = (f64::from(*e) * scale) as f32;
            }
        });
    }
}
