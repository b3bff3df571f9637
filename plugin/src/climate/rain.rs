//! Rain: moisture carried along the prevailing wind.
//!
//! A column of air follows the wind from vertex to vertex. With m the water that it carries, c the
//! most that it can carry and r = m / c the relative humidity:
//! - over the sea it is moistened towards r = 0.8 (less where it sinks) within some 700 km;
//! - it rains e(φ) r m / L per km: e says how air rises in its belt, much at the equator (the
//!   convergence of the trades) and on the storm tracks, little where it sinks (15 to 35°); where
//!   it sinks over land it is also dried;
//! - of rain on land half evaporates again and goes on, in the tropics most of it;
//! - where the ground rises the air cools, c falls, and a part of the excess rains out (orographic
//!   rain; cf. Smith and Barstad 2004, whose efficiencies are a third to a half); behind the crest
//!   m is spent and c is large again: a rain shadow.
//!
//! c follows the Magnus form of the vapour pressure at the ground's temperature. L = 5000 km and
//! the scale to mm are fitted to Earth: 2 m at the equator, 0.6 m on tropical seas, 1 m on the
//! storm tracks, 0.2 m at the poles. Eddies mix neighbouring columns within 300 km.
//!
//! Lengths without a source are fitted to the same four figures and to the width of Earth's
//! deserts.

use super::wind::{WindBelts, Winds};
use crate::math;
use crate::parallel;
use crate::sphere::SphereMesh;

/// Relative humidity that the sea gives to the air (Peixoto and Oort 1992: 0.75 to 0.85).
const SEA_HUMIDITY: f32 = 0.8;

/// Part of that humidity that is lost where air sinks most: subtropical inversions hold it down.
const SEA_HUMIDITY_LOST: f32 = 0.35;

/// Relative humidity of all columns before the first sweep.
const FIRST_HUMIDITY: f32 = 0.7;

/// Way over the sea on which air is moistened, km.
const MOISTENING_KM: f32 = 700.0;

/// L: way on which air would lose its water at e = r = 1, km.
const RAIN_LENGTH_KM: f32 = 5000.0;

/// Way on which sinking air over land is dried, km.
const DRYING_KM: f32 = 1500.0;

/// Share of the rain on land that evaporates again where it is cold, and where it is hot (Brubaker,
/// Entekhabi and Eagleson 1993: least in Eurasia, most in the Amazon basin).
const RECYCLING: [f32; 2] = [0.5, 0.85];

/// Mean temperature in °C at which recycling begins to grow, and how far above it is greatest.
const RECYCLING_C: [f64; 2] = [5.0, 20.0];

/// Summer less mean temperature in °C at the poles, at sea and on land. (Between seasons it grows
/// with the sine of the latitude.)
const SUMMER_WARMTH_C: [f32; 2] = [3.0, 9.0];

/// Share of the water beyond the capacity of rising air that rains out within a vertex's width.
const CONDENSATION: f32 = 0.3;

/// From the model's units of water per km to mm per year.
const MM_PER_YEAR: f32 = 7.4e6;

/// Rain in mm per year that a vertex's mean approaches and never reaches: steep walls turn part of
/// the air aside. The wettest slopes on Earth have twice as much, but not over 50 km.
const HEAVIEST_MM: f32 = 6000.0;

/// Sweeps: the first two carry moisture around the planet, the third settles the part that was
/// mixed against the wind.
const SWEEPS: usize = 3;

/// Rain in mm per year at every vertex, from temperatures in °C and heights in km: the mean of two
/// seasons.
pub(super) fn rain(
    mesh: &SphereMesh,
    winds: &Winds,
    temperature: &[f32],
    height: &[f32],
) -> Vec<f32> {
    // Air does not follow every peak and hollow, whose temperatures these are.
    let smoothed = smooth(mesh, temperature);
    let [north, south] = &winds.seasons;
    // Each season is one sweep after the other; the two do not depend on each other.
    let (north, south) = rayon::join(
        || season(mesh, north, &smoothed, height),
        || season(mesh, south, &smoothed, height),
    );
    let rain = parallel::map(mesh.len(), |i| {
        let mean = 0.5 * (north[i as usize] + south[i as usize]);
        // Bends off smoothly instead of cutting peaks.
        mean / (1.0 + (mean / HEAVIEST_MM) * (mean / HEAVIEST_MM)).sqrt()
    });
    // Rain falls downwind of where it forms, by a vertex or two.
    smooth(mesh, &smooth(mesh, &rain))
}

/// Half of each value and half of the mean around it.
fn smooth(mesh: &SphereMesh, field: &[f32]) -> Vec<f32> {
    parallel::map(mesh.len(), |i| {
        0.5 * (field[i as usize] + ring_mean(mesh, field, i))
    })
}

/// The mean of a field over the neighbours of vertex `i`.
fn ring_mean(mesh: &SphereMesh, field: &[f32], i: u32) -> f32 {
    let ring = mesh.ring(i);
    ring.iter().map(|&j| field[j as usize]).sum::<f32>() / ring.len() as f32
}

/// Rain of one season in mm per year.
fn season(mesh: &SphereMesh, belts: &WindBelts, temperature: &[f32], height: &[f32]) -> Vec<f32> {
    let columns = columns(mesh, belts, temperature, height);
    let mut water: Vec<f32> = columns
        .iter()
        .map(|column| FIRST_HUMIDITY * column.capacity)
        .collect();
    // The first sweeps only bring the water to where it rains in the last.
    for _ in 1..SWEEPS {
        let path = &belts.path;
        path.sweep(&mut water, |k, arriving, way| {
            columns[k].pass(arriving, way).0
        });
    }
    let mut rain = vec![0.0; mesh.len()];
    belts.path.sweep(&mut water, |k, arriving, way| {
        let (left, fallen) = columns[k].pass(arriving, way);
        rain[belts.order[k] as usize] = fallen;
        left
    });
    rain
}

/// The columns of air over all vertices, in the order of the wind.
fn columns(
    mesh: &SphereMesh,
    belts: &WindBelts,
    temperature: &[f32],
    height: &[f32],
) -> Vec<Column> {
    let zones = zones();
    parallel::map(mesh.len(), |place| {
        let i = belts.order[place as usize];
        let k = i as usize;
        let summer = mesh.point(i).z as f32 * belts.shift.signum() as f32;
        let zone = zone_at(&zones, belts.latitude[k]);
        Column::new(zone, summer, temperature[k], height[k] < 0.0)
    })
}

/// Entries of the table of zones per degree.
const ZONES_PER_DEGREE: f32 = 4.0;

/// Largest distance from the belts' middle in degrees: a pole, and the seasonal shift.
const FARTHEST_ZONE_DEG: u32 = 110;

/// Vertical motion of the air in a zone.
#[derive(Clone, Copy)]
struct Zone {
    /// e: how readily it rains.
    rising: f32,
    /// How strongly air sinks, 0..1.
    sinking: f32,
}

/// The zones by distance from the belts' middle in quarters of a degree.
fn zones() -> Vec<Zone> {
    (0..=FARTHEST_ZONE_DEG * ZONES_PER_DEGREE as u32)
        .map(|step| Zone::new(f64::from(step) / f64::from(ZONES_PER_DEGREE)))
        .collect()
}

/// The zone at a distance from the belts' middle in degrees.
fn zone_at(zones: &[Zone], beyond: f32) -> Zone {
    let x = beyond * ZONES_PER_DEGREE;
    let below = (x as usize).min(zones.len() - 2);
    let t = x - below as f32;
    let (a, b) = (zones[below], zones[below + 1]);
    Zone {
        rising: a.rising + (b.rising - a.rising) * t,
        sinking: a.sinking + (b.sinking - a.sinking) * t,
    }
}

impl Zone {
    /// The zone at a distance from the belts' middle in degrees: a convergence 9° wide about the
    /// middle, storm tracks that set in from 27 to 57°, and between them, about 24°, sinking air.
    fn new(beyond: f64) -> Self {
        let storms = math::smoothstep((beyond - 27.0) / 30.0);
        Self {
            rising: (0.2 + 1.5 * bell(beyond, 0.0, 9.0) + 2.6 * storms) as f32,
            sinking: bell(beyond, 24.0, 7.0) as f32,
        }
    }
}

/// Gauss' bell about a centre, 1/e at a width.
fn bell(x: f64, centre: f64, width: f64) -> f64 {
    math::exp(-((x - centre) / width) * ((x - centre) / width))
}

/// The air over a vertex.
#[derive(Clone, Copy)]
struct Column {
    /// c: most water that it can carry, in units of that of air at 15 °C.
    capacity: f32,
    zone: Zone,
    /// Share of the rain that evaporates again.
    recycling: f32,
    is_sea: bool,
}

impl Column {
    /// `summer` is the sine of the latitude, positive in the summer hemisphere.
    fn new(zone: Zone, summer: f32, temperature: f32, is_sea: bool) -> Self {
        let swing = SUMMER_WARMTH_C[usize::from(!is_sea)];
        let [first, width] = RECYCLING_C;
        let warmth = math::smoothstep((f64::from(temperature) - first) / width) as f32;
        Self {
            capacity: capacity(temperature + swing * summer),
            zone,
            recycling: RECYCLING[0] + (RECYCLING[1] - RECYCLING[0]) * warmth,
            is_sea,
        }
    }

    /// Passes air with `water` along `way` km: the water that it carries on, and the rain in mm per
    /// year.
    #[inline]
    fn pass(&self, water: f32, way: f32) -> (f32, f32) {
        // Beyond 1 the water condenses, below.
        let humidity = (water / self.capacity).min(1.0);
        let falls = water * share(self.zone.rising * humidity * way / RAIN_LENGTH_KM);
        // Air that rises over ground cools, and holds less than it brought along.
        let excess = (water - self.capacity).max(0.0) * CONDENSATION;
        let rain = falls + excess;
        let left = if self.is_sea {
            // Moistened towards the sea's humidity, but never dried by it.
            let dry = (water - rain).max(0.0);
            let humidity = SEA_HUMIDITY * (1.0 - SEA_HUMIDITY_LOST * self.zone.sinking);
            dry + (humidity * self.capacity - dry).max(0.0) * share(way / MOISTENING_KM)
        } else {
            // Orographic rain runs off too fast to evaporate again.
            let kept = 1.0 - share(self.zone.sinking * way / DRYING_KM);
            (water - rain + self.recycling * falls) * kept
        };
        (left, rain / way * MM_PER_YEAR)
    }
}

/// The share that is lost on a way of `x` decay lengths. x / (1 + x) stands for 1 - exp(-x): the
/// same for short ways, and never more than all.
fn share(x: f32) -> f32 {
    x / (1.0 + x)
}

/// Most water that air at a temperature in °C can carry, 1 at 15 °C (Magnus form of the saturation
/// vapour pressure, WMO 2008).
fn capacity(temperature: f32) -> f32 {
    let t = f64::from(temperature).clamp(-90.0, 60.0);
    (math::exp(17.62 * t / (243.12 + t)) / 2.79) as f32
}

#[cfg(test)]
#[path = "rain_tests.rs"]
mod tests;
