//! Figures of a planet, as `stats.json` holds them.

mod compute;

pub use compute::StatsInput;

use crate::crust::Cause;
use crate::schedule::StageTimings;
use bevy::prelude::*;
use serde::ser::{Serialize, SerializeMap, Serializer};

/// The figures of a planet. Shares are of the planet's area unless said otherwise.
///
/// ```
/// use bevy::prelude::*;
/// use bevy_pangaea::io::{Stats, Timings, capture, digest, stats::StatsInput};
/// use bevy_pangaea::{prelude::*, spawn::PlanetState};
///
/// let mut app = App::new();
/// app.add_plugins(PangaeaPlugins);
/// let recipe = PlanetRecipe { samples: 1000, plate_count: 8, land: 0.3, ..default() };
/// let planet = PlanetState::new(&recipe)?.spawn(app.world_mut());
///
/// let state = capture(app.world(), planet).ok_or("in the middle of a step")?;
/// let input = StatsInput::from_world(app.world(), planet).ok_or("no planet")?;
/// let stats = Stats::new(&input, digest(&state), Timings::default());
/// assert!((stats.land_fraction - 0.3).abs() < 0.05);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
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
    pub elevation_km: ElevationFigures,
    /// Age of oceanic crust in My.
    pub ocean_age_my: OceanAgeFigures,
    /// Share per 250 m of elevation from -11 km to 11 km, ascending; area beyond counts to the
    /// ends.
    pub hypsometry: Vec<f64>,
    /// Share of folded crust.
    pub orogeny_fraction: OrogenyFraction,
    /// Changes of the area of continental crust by cause.
    pub ledger: LedgerShares,
    /// Figures of rivers and lakes, if the ground was baked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hydrology: Option<crate::hydrology::HydrologyStats>,
    /// Wall-clock times.
    pub timings_ms: Timings,
    /// Highest memory use of the process in MB (10^6 bytes), if the system tells.
    pub peak_rss_mb: Option<f64>,
}

/// Elevation in km.
#[derive(Clone, Copy, Debug, PartialEq, Reflect, serde::Serialize)]
pub struct ElevationFigures {
    /// Lowest.
    pub min: f64,
    /// Highest.
    pub max: f64,
    /// Mean over the area.
    pub mean: f64,
}

/// Age of oceanic crust in My; 0 on a planet without oceanic crust.
#[derive(Clone, Copy, Debug, PartialEq, Reflect, serde::Serialize)]
pub struct OceanAgeFigures {
    /// Mean over its area.
    pub mean: f64,
    /// Oldest.
    pub max: f64,
}

/// Shares of folded crust.
#[derive(Clone, Copy, Debug, PartialEq, Reflect, serde::Serialize)]
pub struct OrogenyFraction {
    /// Last folded above a subduction zone.
    pub andean: f64,
    /// Last folded by a continental collision.
    pub himalayan: f64,
}

/// Changes of the continental area by cause, as shares of the area at the beginning (of the planet's
/// area, if it began without continents), and the largest share that one resample left
/// unexplained.
#[derive(Clone, Debug, PartialEq, Reflect)]
pub struct LedgerShares {
    /// Shares in the order of [`Cause::ALL`].
    pub causes: [f64; Cause::ALL.len()],
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

/// Wall-clock times in ms; `None` for events that did not happen or were not measured.
#[derive(Clone, Copy, Debug, Default, PartialEq, Reflect, serde::Serialize)]
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
    /// One parallel sweep that reads and writes every crust column once: no step can take less.
    pub floor: Option<f64>,
}

impl Timings {
    /// The times that the stages measured.
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

impl Stats {
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

/// Highest resident memory of this process in MB (10^6 bytes), if the system tells.
pub fn peak_rss_mb() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kib: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kib * 1024.0 / 1e6)
}
