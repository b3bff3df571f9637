//! Rain: moisture carried along the prevailing wind.
//!
//! A column of air follows the wind from vertex to vertex. With m the water that it carries, c what
//! it can carry and r = m / c the relative humidity:
//! - over the sea it is moistened towards r = 0.8 (less where it sinks) within some 700 km;
//! - it rains e(φ) r m / L per km: e says how air rises in its belt, much at the equator (the
//!   convergence of the
//!   trades) and on the storm tracks, little where it sinks (15 to 35°); where it sinks over land
//! it is also dried;
//! - of rain on land half evaporates again and goes on, in the tropics most of it;
//! - where the ground rises the air cools, c falls, and what is too much rains out (orographic
//!   rain; cf. Smith and
//!   Barstad 2004, whose efficiencies are a third to a half); behind the crest m is spent and c is
//! large again: a shadow.
//!
//! c follows the Magnus form of the vapour pressure at the ground's temperature. L = 5000 km and
//! the scale to mm are fitted to Earth: 2 m at the equator, 0.6 m on tropical seas, 1 m on the
//! storm tracks, 0.2 m at the poles. Eddies mix neighbouring columns within 300 km.

use super::wind::Belts;
use super::{EARTH_RADIUS, Winds};
use crate::math;
use crate::parallel;
use crate::sphere::SphereMesh;

/// Relative humidity that the sea gives.
const SEA_HUMIDITY: f32 = 0.8;
/// Way over the sea on which air is moistened, km.
const MOISTENING: f32 = 700.0;
/// L: way on which air would lose its water at e = r = 1, km.
const RAIN_LENGTH: f32 = 5000.0;
/// Way on which sinking air over land is dried, km.
const DRYING: f32 = 1500.0;
/// Share of the rain on land that evaporates again, where it is cold and where it is hot.
const RECYCLING: [f32; 2] = [0.5, 0.85];
/// Share of the water beyond what rising air can hold that rains out within a vertex's width.
const CONDENSATION: f32 = 0.3;
/// Way within which eddies mix columns, km.
const MIXING: f32 = 300.0;
/// From the model's units of water per km to mm per year.
const SCALE: f32 = 7.4e6;
/// What no rain over a whole vertex exceeds, mm per year: steep walls turn part of the air aside.
const HEAVIEST: f32 = 6000.0;
/// Sweeps: the first two carry moisture around the planet, the third settles what was mixed against
/// the wind.
const SWEEPS: usize = 3;

/// Rain in mm per year at every vertex, from temperatures in °C and heights in km: the mean of two
/// seasons.
pub(super) fn rain(
    mesh: &SphereMesh,
    winds: &Winds,
    temperature: &[f32],
    height: &(dyn Fn(u32) -> f32 + Sync),
) -> Vec<f32> {
    // Air does not follow every peak and hollow.
    let smoothed = smooth(mesh, temperature);
    let season = |belts: &Belts| season(mesh, belts, &smoothed, height);
    let (north, south) = rayon::join(|| season(&winds.seasons[0]), || season(&winds.seasons[1]));
    let rain = parallel::map(mesh.len(), |i| {
        let sum = 0.5 * (north[i as usize] + south[i as usize]);
        sum / (1.0 + (sum / HEAVIEST) * (sum / HEAVIEST)).sqrt()
    });
    smooth(mesh, &smooth(mesh, &rain))
}

/// Half of each value and half of the mean around it.
fn smooth(mesh: &SphereMesh, field: &[f32]) -> Vec<f32> {
    parallel::map(mesh.len(), |i| {
        let ring = mesh.ring(i);
        let mean = ring.iter().map(|&j| field[j as usize]).sum::<f32>() / ring.len() as f32;
        0.5 * (field[i as usize] + mean)
    })
}

fn season(
    mesh: &SphereMesh,
    belts: &Belts,
    temperature: &[f32],
    height: &(dyn Fn(u32) -> f32 + Sync),
) -> Vec<f32> {
    let zones = zones();
    let columns: Vec<Column> = parallel::map(mesh.len(), |i| {
        let k = i as usize;
        let season = mesh.point(i).z as f32 * belts.shift.signum() as f32;
        Column::new(
            zone(&zones, belts.latitude[k]),
            season,
            temperature[k],
            height(i) < 0.0,
        )
    });
    let mut water: Vec<f32> = columns.iter().map(|c| 0.7 * c.capacity).collect();
    let mut rain = vec![0.0; mesh.len()];
    for _ in 0..SWEEPS {
        for &i in &belts.order {
            let k = i as usize;
            let up = belts.upwind[k];
            let [a, b] = up.from.map(|j| water[j as usize]);
            let way = (up.distance * EARTH_RADIUS as f32).max(1.0);
            let ring = mesh.ring(i);
            let around = ring.iter().map(|&j| water[j as usize]).sum::<f32>() / ring.len() as f32;
            let carried = a + (b - a) * up.weight;
            let mixed = carried + (around - carried) * (way / (MIXING + way));
            (water[k], rain[k]) = columns[k].pass(mixed, way);
        }
    }
    rain
}

/// Steps of the table of zones per degree.
const ZONES: f32 = 4.0;

/// How readily it rains and how strongly air sinks, by the distance from the belts' middle in
/// quarters of a degree.
fn zones() -> Vec<[f32; 2]> {
    let zone = |step: u32| {
        let beyond = f64::from(step) / f64::from(ZONES);
        let bell = |centre: f64, width: f64| {
            math::exp(-((beyond - centre) / width) * ((beyond - centre) / width))
        };
        let storms = math::smoothstep((beyond - 27.0) / 30.0);
        [
            (0.2 + 1.5 * bell(0.0, 9.0) + 2.6 * storms) as f32,
            bell(24.0, 7.0) as f32,
        ]
    };
    (0..=110 * ZONES as u32).map(zone).collect()
}

/// The zone at a distance from the belts' middle in degrees.
fn zone(zones: &[[f32; 2]], beyond: f32) -> [f32; 2] {
    let x = beyond * ZONES;
    let below = (x as usize).min(zones.len() - 2);
    let t = x - below as f32;
    core::array::from_fn(|k| zones[below][k] + (zones[below + 1][k] - zones[below][k]) * t)
}

/// What the air meets at a vertex.
#[derive(Clone, Copy)]
struct Column {
    capacity: f32,
    /// e: how readily it rains.
    rising: f32,
    /// How strongly air sinks, 0..1.
    sinking: f32,
    /// Share of the rain that evaporates again.
    recycling: f32,
    is_sea: bool,
}

impl Column {
    /// `season` is the sine of the latitude, positive in the summer hemisphere.
    fn new(zone: [f32; 2], season: f32, temperature: f32, is_sea: bool) -> Self {
        // Summers are warmer, on land more so.
        let swing = if is_sea { 3.0 } else { 9.0 };
        let warmth = math::smoothstep((f64::from(temperature) - 5.0) / 20.0) as f32;
        Self {
            capacity: capacity(temperature + swing * season),
            rising: zone[0],
            sinking: zone[1],
            recycling: RECYCLING[0] + (RECYCLING[1] - RECYCLING[0]) * warmth,
            is_sea,
        }
    }

    /// Passes air with `water` along `way` km: the water that it carries on, and the rain in mm per
    /// year.
    #[inline]
    fn pass(&self, water: f32, way: f32) -> (f32, f32) {
        // x / (1 + x) stands for 1 - exp(-x): the same for short ways, and never more than there
        // is.
        let share = |x: f32| x / (1.0 + x);
        let humidity = (water / self.capacity).min(1.0);
        let falls = water * share(self.rising * humidity * way / RAIN_LENGTH);
        let excess = (water - self.capacity).max(0.0) * CONDENSATION;
        let rain = falls + excess;
        let left = if self.is_sea {
            let dry = (water - rain).max(0.0);
            let humid = SEA_HUMIDITY * (1.0 - 0.35 * self.sinking) * self.capacity;
            dry + (humid - dry).max(0.0) * share(way / MOISTENING)
        } else {
            (water - rain + self.recycling * falls) * (1.0 - share(self.sinking * way / DRYING))
        };
        (left, rain / way * SCALE)
    }
}

/// What air at a temperature in °C can carry, 1 at 15 °C (Magnus form of the saturation vapour
/// pressure, WMO 2008).
fn capacity(temperature: f32) -> f32 {
    let t = f64::from(temperature).clamp(-90.0, 60.0);
    (math::exp(17.62 * t / (243.12 + t)) / 2.79) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn capacity_doubles_within_11_degrees() {
        assert!((capacity(15.0) - 1.0).abs() < 0.01);
        assert!((1.8..2.2).contains(&(capacity(26.0) / capacity(15.0))));
        assert!((1.9..2.5).contains(&(capacity(5.0) / capacity(-5.0))));
    }

    #[test]
    fn water_is_spent_on_land_and_regained_at_sea() {
        let land = Column {
            capacity: 1.0,
            rising: 1.0,
            sinking: 0.0,
            recycling: 0.5,
            is_sea: false,
        };
        let (left, rain) = land.pass(0.6, 50.0);
        assert!(left < 0.6 && rain > 0.0);
        let half_recycled = (0.6 - left) * SCALE / 50.0;
        assert!((half_recycled / (0.5 * rain) - 1.0).abs() < 1e-3);
        let sea = Column {
            is_sea: true,
            ..land
        };
        assert!(sea.pass(0.1, 50.0).0 > 0.1);
        // Lifted air rains more, and the air behind the crest less.
        let crest = Column {
            capacity: 0.3,
            ..land
        };
        let (behind, much) = crest.pass(0.6, 50.0);
        assert!(much > 3.0 * rain && land.pass(behind, 50.0).1 < 0.75 * rain);
    }
}
