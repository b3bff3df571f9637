//! The floor that timings are measured by.

use crate::crust::{Crust, CrustKind, Orogeny};
use crate::parallel::CHUNK;
use rayon::prelude::*;
use std::hint::black_box;
use std::time::Instant;

/// The floor of all timings in ms: one parallel sweep in fixed chunks that reads and writes every
/// crust column once, the median of several. A step that takes 6 floors moves six times the memory,
/// or computes as long.
///
/// The columns come from memory, not from a cache: before each sweep as much other data is written
/// as passes through the caches in a step.
pub fn floor(crust: &Crust) -> f64 {
    const SWEEPS: usize = 9;
    const OTHER_DATA: usize = 64 << 20;
    let mut crust = crust.clone();
    let mut other = vec![0_u8; OTHER_DATA];
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

/// Changes every value of every column.
fn sweep(crust: &mut Crust) {
    let Crust {
        frame,
        kind,
        thickness,
        elevation,
        ocean_age,
        ridge,
        orogeny_age,
        orogeny,
        fold,
    } = crust;
    let small = (
        frame.par_chunks_mut(CHUNK),
        kind.par_chunks_mut(CHUNK),
        orogeny.par_chunks_mut(CHUNK),
    );
    let scalars = (
        thickness.par_chunks_mut(CHUNK),
        elevation.par_chunks_mut(CHUNK),
    );
    let ages = (
        ocean_age.par_chunks_mut(CHUNK),
        orogeny_age.par_chunks_mut(CHUNK),
    );
    let vectors = (ridge.par_chunks_mut(CHUNK), fold.par_chunks_mut(CHUNK));
    let all = (
        small.into_par_iter(),
        scalars.into_par_iter(),
        ages.into_par_iter(),
        vectors.into_par_iter(),
    );
    all.into_par_iter().for_each(
        |((frame, kind, orogeny), (thickness, elevation), (age, folded), (ridge, fold))| {
            frame.iter_mut().for_each(|f| *f ^= 1);
            kind.iter_mut().for_each(|k| {
                *k = if *k == CrustKind::Oceanic {
                    CrustKind::Continental
                } else {
                    CrustKind::Oceanic
                };
            });
            orogeny.iter_mut().for_each(|o| {
                *o = if *o == Orogeny::Andean {
                    Orogeny::Himalayan
                } else {
                    Orogeny::Andean
                };
            });
            for column in [thickness, elevation, age, folded] {
                column.iter_mut().for_each(|x| *x = 1.0 - *x);
            }
            for column in [ridge, fold] {
                column.iter_mut().for_each(|v| *v = -*v);
            }
        },
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sweep_changes_every_value() {
        let crust = Crust::ocean(3 * CHUNK + 5, &crate::params::TectonicParams::default());
        let mut swept = crust.clone();
        sweep(&mut swept);
        for i in 0..crust.len() {
            assert!(swept.frame[i] != crust.frame[i] && swept.kind[i] != crust.kind[i]);
            assert!(
                swept.orogeny[i] != crust.orogeny[i] && swept.thickness[i] != crust.thickness[i]
            );
            assert!(
                swept.elevation[i] != crust.elevation[i]
                    && swept.ocean_age[i] != crust.ocean_age[i]
            );
            assert!(swept.orogeny_age[i] != crust.orogeny_age[i]);
        }
    }
}
