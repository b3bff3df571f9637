//! Figures of a planet (`stats.json`).

use crate::crust::{Cause, CrustKind, Ledger, Orogeny, Surface};
use crate::parallel;
use crate::planet::GeologicClock;
use crate::schedule::StageTimings;
use crate::sphere::SphereMesh;
use serde::ser::{Serialize, SerializeMap, Serializer};

/// Bins of the hypsometry: 250 m each, from -11 km to 11 km.
pub const BINS: usize = 88;

/// The figures of a planet. Shares are of the planet's area unless said otherwise.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Stats {
    /// Hash over all state in hexadecimal digits.
    pub digest: String,
    /// Number of samples.
    pub samples: usize,
    /// Number of plates.
    pub plates: usize,
    /// Steps taken.
    pub steps: u64,
    /// Geological time in My.
    pub time_my: f64,
    /// Share above the sea.
    pub land_fraction: f64,
    /// Share of continental crust.
    pub continental_fraction: f64,
    /// Elevation in km, trenches included.
    pub elevation_km: Elevation,
    /// Age of oceanic crust in My.
    pub ocean_age_my: OceanAge,
    /// Share per 250 m of elevation from -11 km to 11 km, ascending; what lies beyond counts to the
    /// ends.
    pub hypsometry: Vec<f64>,
    /// Share of folded crust.
    pub orogeny_fraction: OrogenyFraction,
    /// What changed the area of continental crust.
    pub ledger: LedgerShares,
    /// Figures of rivers and lakes, where the ground was baked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hydrology: Option<crate::hydrology::HydrologyStats>,
    /// Wall-clock times.
    pub timings_ms: Timings,
    /// Highest memory use of the process in MB (10^6 bytes), where the system tells.
    pub peak_rss_mb: Option<f64>,
}

/// Elevation in km.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Elevation {
    /// Lowest.
    pub min: f64,
    /// Highest.
    pub max: f64,
    /// Mean over the area.
    pub mean: f64,
}

/// Age of oceanic crust in My; 0 where there is none.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct OceanAge {
    /// Mean over its area.
    pub mean: f64,
    /// Oldest.
    pub max: f64,
}

/// Shares of folded crust.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct OrogenyFraction {
    /// Last folded above a subduction zone.
    pub andean: f64,
    /// Last folded by a continental collision.
    pub himalayan: f64,
}

/// Changes of the continental area by cause, as shares of the area that there was at the beginning
/// (of the planet's area, if there was none), and the largest share that one resample left
/// unexplained.
#[derive(Clone, Debug, PartialEq)]
pub struct LedgerShares {
    /// Shares in the order of [`Cause::ALL`].
    pub causes: [f64; 11],
    /// Worst share of the continental area without a cause.
    pub unexplained_max: f64,
}

impl Serialize for LedgerShares {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(Cause::ALL.len() + 1))?;
        for (cause, share) in Cause::ALL.into_iter().zip(self.causes) {
            map.serialize_entry(cause.name(), &share)?;
        }
        map.serialize_entry("unexplained_max", &self.unexplained_max)?;
        map.end()
    }
}

/// Wall-clock times in ms; `None` where nothing of the kind happened or was measured.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct Timings {
    /// Making the mesh.
    pub mesh: Option<f64>,
    /// Mean of a step without resampling and rifting.
    pub step_mean: Option<f64>,
    /// Longest such step.
    pub step_max: Option<f64>,
    /// Mean of a resampling with new ocean crust.
    pub resample_mean: Option<f64>,
    /// Mean of a rifting.
    pub rift_mean: Option<f64>,
    /// The whole simulation.
    pub total: Option<f64>,
    /// One parallel sweep over all columns: see [`floor`](super::floor()).
    pub floor: Option<f64>,
}

impl Timings {
    /// What the stages measured.
    pub fn of_stages(stages: &StageTimings) -> Self {
        let mean = |(count, ms): (u32, f64)| (count > 0).then(|| ms / f64::from(count));
        let steps = stages.steps > 0;
        Self {
            step_mean: steps.then(|| stages.step_mean_ms()),
            step_max: steps.then_some(stages.step_max_ms),
            resample_mean: mean(stages.resample),
            rift_mean: mean(stages.rift),
            ..Self::default()
        }
    }
}

/// What figures are computed from.
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

impl Stats {
    /// Computes the figures. `digest` is that of the state.
    pub fn new(input: &StatsInput, digest: String, timings_ms: Timings) -> Self {
        let StatsInput {
            mesh,
            surface,
            clock,
            ledger,
            radius,
            plates,
        } = *input;
        let crust = &surface.crust;
        let sphere = 4.0 * crate::math::PI;
        let area = |i: usize| mesh.area(i as u32) / sphere;
        let n = surface.len().min(mesh.len());
        let share = |belongs: &(dyn Fn(usize) -> bool + Sync)| {
            parallel::sum(n, |i| if belongs(i) { area(i) } else { 0.0 })
        };
        let elevation = |i: usize| f64::from(surface.elevation(i));
        let range = (0..n)
            .map(elevation)
            .fold(None, |range: Option<(f64, f64)>, z| {
                Some(range.map_or((z, z), |(low, high)| (low.min(z), high.max(z))))
            });
        let (min, max) = range.unwrap_or((0.0, 0.0));
        let oceanic = |i: usize| crust.kind[i] == CrustKind::Oceanic;
        let ocean_area = share(&oceanic);
        let age = |i: usize| f64::from(crust.ocean_age[i]);
        let ocean_age = parallel::sum(n, |i| if oceanic(i) { age(i) * area(i) } else { 0.0 });
        Self {
            digest,
            samples: mesh.len(),
            plates,
            steps: clock.step,
            time_my: clock.time,
            land_fraction: share(&|i| elevation(i) > 0.0),
            continental_fraction: share(&|i| !oceanic(i)),
            elevation_km: Elevation {
                min,
                max,
                mean: parallel::sum(n, |i| elevation(i) * area(i)),
            },
            ocean_age_my: OceanAge {
                mean: if ocean_area > 0.0 {
                    ocean_age / ocean_area
                } else {
                    0.0
                },
                max: (0..n).filter(|&i| oceanic(i)).map(age).fold(0.0, f64::max),
            },
            hypsometry: hypsometry((0..n).map(|i| (elevation(i), area(i)))),
            orogeny_fraction: OrogenyFraction {
                andean: share(&|i| crust.orogeny[i] == Orogeny::Andean),
                himalayan: share(&|i| crust.orogeny[i] == Orogeny::Himalayan),
            },
            ledger: shares(ledger, sphere * radius * radius),
            hydrology: None,
            timings_ms,
            peak_rss_mb: peak_rss_mb(),
        }
    }

    /// The figures with those of a bake's rivers and lakes.
    pub fn with_bake(mut self, bake: &crate::control::Bake) -> Self {
        self.hydrology = Some(crate::hydrology::HydrologyStats::new(
            bake.mesh(),
            &bake.climate,
            &bake.drainage,
        ));
        self
    }
}

fn shares(ledger: &Ledger, planet_area: f64) -> LedgerShares {
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
    let mut bins = vec![0.0; BINS];
    for (z, area) in samples {
        // Beyond the ends, the ends: the conversion saturates below 0.
        let bin = ((z + 11.0) * 4.0).floor() as usize;
        bins[bin.min(BINS - 1)] += area;
    }
    let sum: f64 = bins.iter().sum();
    if sum > 0.0 {
        bins.iter_mut().for_each(|bin| *bin /= sum);
    }
    bins
}

/// Highest resident memory of this process in MB (10^6 bytes), if the system tells.
pub fn peak_rss_mb() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kib: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kib * 1024.0 / 1e6)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crust::Crust;

    #[test]
    fn hypsometry_has_open_ends_and_sum_one() {
        let bins = hypsometry(
            [
                (-50.0, 1.0),
                (-11.0, 1.0),
                (-0.01, 1.0),
                (0.0, 3.0),
                (10.99, 1.0),
                (99.0, 1.0),
            ]
            .into_iter(),
        );
        assert_eq!(bins.len(), BINS);
        assert_eq!(
            (bins[0], bins[43], bins[44], bins[87]),
            (0.25, 0.125, 0.375, 0.25)
        );
        assert!((bins.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        assert_eq!(hypsometry(core::iter::empty()), vec![0.0; BINS]);
    }

    #[test]
    fn figures_of_two_hemispheres() {
        let mesh = SphereMesh::fibonacci(2000).unwrap();
        let mut crust = Crust::ocean(mesh.len(), &crate::params::TectonicParams::default());
        for (i, p) in mesh.points().iter().enumerate() {
            crust.ocean_age[i] = 50.0;
            if p.z > 0.0 {
                crust.kind[i] = CrustKind::Continental;
                crust.elevation[i] = 1.0;
                crust.orogeny[i] = Orogeny::Himalayan;
            }
        }
        let n = mesh.len();
        let surface = Surface {
            plate: vec![crate::plate::PlateId(0); n],
            cover: vec![crate::crust::Cover::One; n],
            trench: vec![0.0; n],
            crust,
            ..Surface::default()
        };
        let (clock, ledger) = (GeologicClock::default(), Ledger::default());
        let input = StatsInput {
            mesh: &mesh,
            surface: &surface,
            clock: &clock,
            ledger: &ledger,
            radius: 6370.0,
            plates: 1,
        };
        let stats = Stats::new(&input, "00".into(), Timings::default());
        assert!((stats.land_fraction - 0.5).abs() < 1e-3);
        assert!((stats.continental_fraction - 0.5).abs() < 1e-3);
        assert_eq!(
            (stats.elevation_km.min, stats.elevation_km.max),
            (-6.0, 1.0)
        );
        assert!((stats.elevation_km.mean + 2.5).abs() < 1e-2);
        assert!((stats.ocean_age_my.mean - 50.0).abs() < 1e-9);
        assert_eq!(stats.orogeny_fraction.andean, 0.0);
        assert!(
            (stats.hypsometry[20] - 0.5).abs() < 1e-3 && (stats.hypsometry[48] - 0.5).abs() < 1e-3
        );
    }
}
