//! How the figures are computed: sums over samples, weighted by their areas.

use super::{
    ElevationFigures, LedgerShares, OceanAgeFigures, OrogenyFraction, Stats, Timings, peak_rss_mb,
};
use crate::crust::{Cause, Crust, CrustKind, Ledger, Orogeny, PlanetSurface, Surface};
use crate::math::PI;
use crate::parallel;
use crate::planet::{GeologicClock, Lattice, Planet};
use crate::plate::Plates;
use crate::sphere::SphereMesh;
use bevy::prelude::*;

/// Bins of the hypsometry: 250 m each, from -11 km to 11 km.
pub(super) const HYPSOMETRY_BINS: usize = 88;

/// The parts of a planet that figures are computed from.
#[derive(Clone, Copy)]
pub struct StatsInput<'a> {
    /// Samples and areas.
    pub mesh: &'a SphereMesh,
    /// The planet as it is now.
    pub surface: &'a Surface,
    /// The clock.
    pub clock: &'a GeologicClock,
    /// The account of continental crust.
    pub ledger: &'a Ledger,
    /// Radius in km.
    pub radius: f64,
    /// Number of plates.
    pub plates: usize,
}

impl<'a> StatsInput<'a> {
    /// The parts of a planet in a world; `None` if the entity is no planet.
    pub fn from_world(world: &'a World, planet: Entity) -> Option<Self> {
        Some(Self {
            mesh: &world.get::<Lattice>(planet)?.0,
            surface: world.get::<PlanetSurface>(planet)?,
            clock: world.get::<GeologicClock>(planet)?,
            ledger: world.get::<Ledger>(planet)?,
            radius: world.get::<Planet>(planet)?.radius,
            plates: world.get::<Plates>(planet).map_or(0, |plates| plates.len()),
        })
    }
}

impl Stats {
    /// Computes the figures. `digest` is that of the state.
    pub fn new(input: &StatsInput, digest: String, timings_ms: Timings) -> Self {
        let &StatsInput { mesh, surface, .. } = input;
        let crust = &surface.crust;
        let shares = AreaShares::new(mesh, surface.len());
        let elevation = |i: usize| f64::from(surface.elevation(i));
        Self {
            digest,
            samples: mesh.len(),
            plates: input.plates,
            steps: input.clock.step,
            time_my: input.clock.time,
            land_fraction: shares.of(|i| elevation(i) > 0.0),
            continental_fraction: shares.of(|i| crust.kind[i] != CrustKind::Oceanic),
            elevation_km: elevation_figures(&shares, elevation),
            ocean_age_my: ocean_age_figures(&shares, crust),
            hypsometry: hypsometry((0..shares.samples).map(|i| (elevation(i), shares.area(i)))),
            orogeny_fraction: OrogenyFraction {
                andean: shares.of(|i| crust.orogeny[i] == Orogeny::Andean),
                himalayan: shares.of(|i| crust.orogeny[i] == Orogeny::Himalayan),
            },
            ledger: ledger_shares(input.ledger, 4.0 * PI * input.radius * input.radius),
            hydrology: None,
            timings_ms,
            peak_rss_mb: peak_rss_mb(),
        }
    }
}

/// Shares of the planet's area.
struct AreaShares<'a> {
    mesh: &'a SphereMesh,
    samples: usize,
}

impl<'a> AreaShares<'a> {
    /// Shares of the first `samples` of a mesh.
    fn new(mesh: &'a SphereMesh, samples: usize) -> Self {
        Self {
            mesh,
            samples: samples.min(mesh.len()),
        }
    }

    /// The share of sample `i`.
    fn area(&self, i: usize) -> f64 {
        self.mesh.area(i as u32) / (4.0 * PI)
    }

    /// The share of the samples that belong.
    fn of(&self, belongs: impl Fn(usize) -> bool + Sync + Send) -> f64 {
        parallel::sum(
            self.samples,
            |i| if belongs(i) { self.area(i) } else { 0.0 },
        )
    }

    /// The sum of a value over the area.
    fn sum(&self, value: impl Fn(usize) -> f64 + Sync + Send) -> f64 {
        parallel::sum(self.samples, |i| value(i) * self.area(i))
    }
}

fn elevation_figures(
    shares: &AreaShares,
    elevation: impl Fn(usize) -> f64 + Sync + Send,
) -> ElevationFigures {
    let (min, max) = (0..shares.samples)
        .map(&elevation)
        .map(|z| (z, z))
        .reduce(|(low, high), (z, _)| (low.min(z), high.max(z)))
        .unwrap_or_default();
    ElevationFigures {
        min,
        max,
        mean: shares.sum(elevation),
    }
}

fn ocean_age_figures(shares: &AreaShares, crust: &Crust) -> OceanAgeFigures {
    let oceanic = |i: usize| crust.kind[i] == CrustKind::Oceanic;
    let age = |i: usize| f64::from(crust.ocean_age[i]);
    let area = shares.of(oceanic);
    // Continents have an ocean age that means nothing.
    let age_sum = parallel::sum(shares.samples, |i| {
        if oceanic(i) {
            age(i) * shares.area(i)
        } else {
            0.0
        }
    });
    let oldest = (0..shares.samples).filter(|&i| oceanic(i)).map(age);
    OceanAgeFigures {
        mean: if area > 0.0 { age_sum / area } else { 0.0 },
        max: oldest.fold(0.0, f64::max),
    }
}

fn ledger_shares(ledger: &Ledger, planet_area: f64) -> LedgerShares {
    let whole = if ledger.initial.area > 0.0 {
        ledger.initial.area
    } else {
        planet_area
    };
    LedgerShares {
        causes: Cause::ALL.map(|cause| ledger.of(cause).area / whole),
        unexplained_max: ledger.unexplained_max,
    }
}

/// Shares per bin of (elevation in km, area); the sum is 1 if there is any area.
fn hypsometry(samples: impl Iterator<Item = (f64, f64)>) -> Vec<f64> {
    let mut bins = vec![0.0; HYPSOMETRY_BINS];
    for (z, area) in samples {
        // Beyond the ends, the ends: the conversion saturates below 0.
        let bin = ((z + 11.0) * 4.0).floor() as usize;
        bins[bin.min(HYPSOMETRY_BINS - 1)] += area;
    }
    let sum: f64 = bins.iter().sum();
    if sum > 0.0 {
        bins.iter_mut().for_each(|bin| *bin /= sum);
    }
    bins
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
