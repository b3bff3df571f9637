//! A resample keeps continental crust: its area by changing coasts, its volume by scaling.
//!
//! Crust below another frame loses its area: *stacking* where both belong to one plate, *forced
//! subduction* where not. Its thickness is added to what lies above; what exceeds the root of the
//! highest mountains falls off as *delamination*. Continental crust that fills a crack is
//! stretched: area without volume, booked as *rifting*. Nearest assignment alone would let the rest
//! of the area flicker by 0.1 to 0.2 %, so samples of the coast, ranked by the share of continental
//! corners in their triangle, change kind until the area is the ledger's; less than half a sample
//! is left, and carried to the next resample. Thicknesses are scaled so that the volume is the
//! ledger's.

use super::blend::sample_frame;
use super::input::ProjectInput;
use super::project::ProjectNotes;
use crate::crust::isostasy::Isostasy;
use crate::crust::ledger::measure;
use crate::crust::{Cause, Crust, CrustKind, Ledger, Surface};
use crate::parallel::{self, CHUNK};
use crate::params::TectonicParams;
use crate::sphere::SphereMesh;
use crate::view::PlanetView;
use rayon::prelude::*;

/// Share of corners of the other kind, by weight, up to which a sample of the coast never changes.
const LEAST_SHARE: f32 = 0.02;

/// Books what was buried and brings the projected crust to the area and the volume that the ledger
/// expects.
pub(super) fn conserve(
    input: &ProjectInput,
    planet: &PlanetView,
    surface: &mut Surface,
    notes: &ProjectNotes,
    ledger: &mut Ledger,
) {
    let (mesh, radius) = (input.mesh, planet.radius);
    let square = planet.square();
    let before = measure(input.crust, mesh, radius);
    let [stacked, forced] = buried_area(mesh, notes);
    let stretched = stretched_area(mesh, surface, notes);
    ledger.book(Cause::Stacking, -stacked * square, 0.0);
    ledger.book(Cause::ForcedSubduction, -forced * square, 0.0);
    ledger.book(Cause::Rifting, stretched * square, 0.0);
    // Coasts first: what is buried thickens whatever is continental then. Scaling comes last and
    // makes up for the rounding of all.
    let target = before.area + (stretched - stacked - forced) * square + ledger.carried_area;
    change_coast(input, surface, notes, target / square);
    let shed = stack(planet.params, &mut surface.crust, mesh, notes) * square;
    ledger.book(Cause::Delamination, 0.0, -shed);
    scale_volume(&mut surface.crust, mesh, radius, before.volume - shed);
    let after = measure(&surface.crust, mesh, radius);
    ledger.carried_area = target - after.area;
    ledger.check(after);
}

/// Steradians of continental crust under crust of the same plate, and under that of others. A
/// sample counts once for every layer below it.
fn buried_area(mesh: &SphereMesh, notes: &ProjectNotes) -> [f64; 2] {
    let mut area = [0.0; 2];
    // Found by many threads, but summed in order: the same bits on any number of them.
    for i in samples_where(notes.layers.len(), |i| notes.layers[i] != [0; 2]) {
        for (area, &layers) in area.iter_mut().zip(&notes.layers[i]) {
            *area += f64::from(layers) * mesh.areas()[i];
        }
    }
    area
}

/// Steradians of cracks that continental crust fills.
fn stretched_area(mesh: &SphereMesh, surface: &Surface, notes: &ProjectNotes) -> f64 {
    samples_where(surface.len(), |i| {
        // A negative weight: no frame covered the sample.
        notes.weight[i] < 0.0 && surface.crust.is_continental(i)
    })
    .into_iter()
    .map(|i| mesh.areas()[i])
    .sum()
}

/// The samples that a condition holds for, in order.
fn samples_where(n: usize, condition: impl Fn(usize) -> bool + Sync + Send) -> Vec<usize> {
    parallel::map_chunks(n, |range| {
        range.filter(|&i| condition(i)).collect::<Vec<_>>()
    })
    .concat()
}

/// Lets samples of the coast change kind until the continental area is `target` steradians as
/// nearly as it can be.
fn change_coast(input: &ProjectInput, surface: &mut Surface, notes: &ProjectNotes, target: f64) {
    let areas = input.mesh.areas();
    let land = samples_where(areas.len(), |i| surface.crust.is_continental(i));
    let area: f64 = land.into_iter().map(|i| areas[i]).sum();
    let mut missing = target - area;
    let (to, sign) = if missing > 0.0 {
        (CrustKind::Continental, 1.0)
    } else {
        (CrustKind::Oceanic, -1.0)
    };
    for i in ranked_coast(surface, notes, to) {
        let change = sign * areas[i as usize];
        // Half a sample too much is as good as half a sample too little.
        if (missing - change).abs() >= missing.abs() {
            break;
        }
        if change_kind(input, surface, i, to) {
            missing -= change;
        }
    }
}

/// The samples that have another kind than `to` and corners of that kind, those with the largest
/// share of them first.
fn ranked_coast(surface: &Surface, notes: &ProjectNotes, to: CrustKind) -> Vec<u32> {
    let share = |i: usize| share_of(to, notes.weight[i]);
    let coast = samples_where(surface.len(), |i| {
        notes.weight[i] >= 0.0 && share(i) > LEAST_SHARE && surface.crust.kind[i] != to
    });
    let mut ranked: Vec<(f32, u32)> = coast.into_iter().map(|i| (-share(i), i as u32)).collect();
    // The largest share first; of equals the lower number, or the sort would be free to choose.
    ranked.par_sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    ranked.into_iter().map(|(_, i)| i).collect()
}

/// The share of corners of a kind, from that of continental ones.
fn share_of(kind: CrustKind, continental: f32) -> f32 {
    match kind {
        CrustKind::Continental => continental,
        CrustKind::Oceanic => 1.0 - continental,
    }
}

/// Gives sample `i` the crust of kind `to` that the frame on top has there; `false` if it has none.
fn change_kind(input: &ProjectInput, surface: &mut Surface, i: u32, to: CrustKind) -> bool {
    let &ProjectInput {
        mesh,
        crust,
        frames,
        overlap,
        polarity,
    } = input;
    let Some(top) = overlap.top_if(mesh, crust, frames, polarity, mesh.point(i), |_| true) else {
        return false;
    };
    let (row, _) = sample_frame(input, top, Some(to));
    if row.kind == to {
        surface.crust.set_row(i as usize, &row);
    }
    row.kind == to
}

/// Adds what is buried to the crust above. Returns the volume that falls off, per square of the
/// radius.
fn stack(
    params: &TectonicParams,
    crust: &mut Crust,
    mesh: &SphereMesh,
    notes: &ProjectNotes,
) -> f64 {
    let thickest = Isostasy::new(params).thickness(params.summit_elevation as f32);
    let mut shed = 0.0;
    let above = samples_where(crust.len(), |i| {
        notes.below[i] > 0.0 && crust.is_continental(i)
    });
    // Where the coast has moved off, what is buried thickens nothing; the scaling spreads it.
    for i in above {
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
            for (kind, e) in kind.iter().zip(thickness) {
                if *kind == CrustKind::Continental {
                    *e = (f64::from(*e) * scale) as f32;
                }
            }
        });
    }
}
