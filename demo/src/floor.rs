//! The floor of all timings: how long memory takes to move the crust once.

use bevy_pangaea::crust::{Crust, CrustKind, Orogeny};
use bevy_pangaea::parallel::CHUNK;
use rayon::prelude::*;
use std::hint::black_box;
use std::time::Instant;

/// Sweeps of which the median counts.
const SWEEPS: usize = 9;

/// Bytes written between two sweeps: as many as pass through the caches in a step.
const OTHER_DATA_BYTES: usize = 64 << 20;

/// The floor of all timings in ms: one parallel sweep in fixed chunks that reads and writes every
/// crust column once, the median of several. A step that takes 6 floors moves six times the memory,
/// or computes as long.
///
/// The columns come from memory, not from a cache: before each sweep other data is written.
pub fn memory_floor_ms(crust: &Crust) -> f64 {
    let mut crust = crust.clone();
    let mut other = vec![0_u8; OTHER_DATA_BYTES];
    let mut times: Vec<f64> = (0..SWEEPS)
        .map(|k| {
            other
                .par_chunks_mut(1 << 20)
                .for_each(|chunk| chunk.fill(k as u8));
            black_box(&other);
            let start = Instant::now();
            sweep(&mut crust);
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    black_box(&crust);
    times.sort_by(f64::total_cmp);
    times[SWEEPS / 2]
}

/// Changes every value of every column, all columns side by side.
fn sweep(crust: &mut Crust) {
    let tags = (
        crust.frame.par_chunks_mut(CHUNK),
        crust.kind.par_chunks_mut(CHUNK),
        crust.orogeny.par_chunks_mut(CHUNK),
    );
    let shape = (
        crust.thickness.par_chunks_mut(CHUNK),
        crust.elevation.par_chunks_mut(CHUNK),
    );
    let ages = (
        crust.ocean_age.par_chunks_mut(CHUNK),
        crust.orogeny_age.par_chunks_mut(CHUNK),
    );
    let vectors = (
        crust.ridge.par_chunks_mut(CHUNK),
        crust.fold.par_chunks_mut(CHUNK),
    );
    let all = (
        tags.into_par_iter(),
        shape.into_par_iter(),
        ages.into_par_iter(),
        vectors.into_par_iter(),
    );
    all.into_par_iter().for_each(
        |((frame, kind, orogeny), (thickness, elevation), (age, folded), (ridge, fold))| {
            frame.iter_mut().for_each(|frame| *frame ^= 1);
            kind.iter_mut().for_each(|kind| *kind = other_kind(*kind));
            orogeny.iter_mut().for_each(|o| *o = other_orogeny(*o));
            for column in [thickness, elevation, age, folded] {
                column.iter_mut().for_each(|x| *x = 1.0 - *x);
            }
            for column in [ridge, fold] {
                column.iter_mut().for_each(|v| *v = -*v);
            }
        },
    );
}

fn other_kind(kind: CrustKind) -> CrustKind {
    match kind {
        CrustKind::Oceanic => CrustKind::Continental,
        CrustKind::Continental => CrustKind::Oceanic,
    }
}

fn other_orogeny(orogeny: Orogeny) -> Orogeny {
    match orogeny {
        Orogeny::Andean => Orogeny::Himalayan,
        Orogeny::None | Orogeny::Himalayan => Orogeny::Andean,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bevy_pangaea::params::TectonicParams;

    #[test]
    fn a_sweep_changes_every_value() {
        let crust = Crust::ocean(3 * CHUNK + 5, &TectonicParams::default());
        let mut swept = crust.clone();
        sweep(&mut swept);
        for i in 0..crust.len() {
            assert_ne!(swept.frame[i], crust.frame[i]);
            assert_ne!(swept.kind[i], crust.kind[i]);
            assert_ne!(swept.orogeny[i], crust.orogeny[i]);
            assert_ne!(swept.thickness[i], crust.thickness[i]);
            assert_ne!(swept.elevation[i], crust.elevation[i]);
            assert_ne!(swept.ocean_age[i], crust.ocean_age[i]);
            assert_ne!(swept.orogeny_age[i], crust.orogeny_age[i]);
        }
    }
}
