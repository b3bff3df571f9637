//! The material of the ground: a rule of thumb for footsteps, materials and plants.
//!
//! Angles and temperatures are those of the field: loose rock comes to rest at 33 to 38°, snow does
//! not hold on walls steeper than about 50°, trees end where the year's mean falls below about 0
//! °C, glaciers live where it is far below. Not modelled: seasons, soil, fire, people.

use crate::climate::{LAPSE_RATE_K_PER_KM, mean_temperature};
use crate::named::named_enum;
use bevy::reflect::Reflect;

/// Warmth and wetness of a place.
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
pub struct ClimateSample {
    /// Mean of the year in °C.
    pub temperature_c: f32,
    /// Wetness, from 0 (desert) to 1 (rain forest); W of paper 002 §3.
    pub wetness: f32,
}

/// Cooling with height in °C per m.
pub(super) const LAPSE_RATE_C_PER_M: f32 = (LAPSE_RATE_K_PER_KM / 1000.0) as f32;

impl ClimateSample {
    /// The climate of a latitude, given by its sine, at `height_m` above the sea: as warm as bakes
    /// have it ([`mean_temperature`]), and half wet everywhere.
    pub fn of_latitude(sin_latitude: f64, height_m: f32) -> Self {
        Self {
            temperature_c: mean_temperature(sin_latitude, height_m / 1000.0),
            wetness: 0.5,
        }
    }
}

named_enum! {
    /// Material of the ground.
    #[derive(Default)]
    pub enum GroundSurface {
        /// Bare rock: walls, and steep ground in deserts.
        #[default]
        Rock = "rock",
        /// Loose stones at their angle of rest, and gravel in fast rivers.
        Scree = "scree",
        /// Sand: beaches and deserts.
        Sand = "sand",
        /// Mud: marshes, and the beds of lakes and slow rivers.
        Mud = "mud",
        /// Grass, and other plants where trees do not grow.
        Grass = "grass",
        /// Forest.
        Forest = "forest",
        /// Snow that stays all year.
        Snow = "snow",
        /// Ice of glaciers.
        Ice = "ice",
        /// The ground of the sea.
        SeaFloor = "sea_floor",
    }
}

/// The conditions that decide the material of a place; see [`classify`].
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
pub struct GroundConditions {
    /// Height of the ground above sea level in m.
    pub height_m: f32,
    /// Level of the water in m; the height of the ground where it is dry.
    pub water_m: f32,
    /// Slope in degrees, 0 to 90.
    pub slope_deg: f32,
    /// Warmth and wetness.
    pub climate: ClimateSample,
}

/// Slope in degrees at which loose rock comes to rest: scree begins.
const ANGLE_OF_REPOSE_DEG: f32 = 33.0;

/// Slope in degrees on which no loose rock stays: walls begin.
const BARE_ROCK_DEG: f32 = 38.0;

/// Slope in degrees from which snow slides off.
const SNOW_SLIDES_DEG: f32 = 50.0;

/// Slope in degrees up to which water and wind leave sand and mud.
const GENTLE_DEG: f32 = 6.0;

/// Slope in degrees up to which water stands in the ground.
const FLAT_DEG: f32 = 1.0;

/// Mean of the year in °C below which snow stays.
const SNOW_LINE_C: f32 = -3.0;

/// Mean of the year in °C below which glaciers live.
const GLACIER_C: f32 = -10.0;

/// Mean of the year in °C above which trees grow.
const TREE_LINE_C: f32 = 1.0;

/// Wetness below which there is desert.
const DESERT_WETNESS: f32 = 0.15;

/// Wetness above which there is forest.
const FOREST_WETNESS: f32 = 0.4;

/// Wetness above which flat ground is marsh.
const MARSH_WETNESS: f32 = 0.85;

/// Height of a beach above the sea in m: the reach of storm waves.
const BEACH_M: f32 = 3.0;

/// The material of the ground. The first rule that fits wins:
///
/// 1. under water: the sea's floor where the water is at sea level or below; else mud, or scree on
///    slopes over 6°;
/// 2. below -3 °C: ice on slopes under 33° below -10 °C, snow on slopes under 50°;
/// 3. rock on slopes over 38°; scree over 33°;
/// 4. sand within 3 m above the sea on slopes under 6°;
/// 5. where wetness is below 0.15: sand on slopes under 6°, else rock;
/// 6. mud where it is flatter than 1° and wetness is over 0.85;
/// 7. forest above 1 °C where wetness is over 0.4;
/// 8. grass.
///
/// NaN fits no rule.
///
/// ```
/// use bevy_pangaea::query::{ClimateSample, GroundConditions, GroundSurface, classify};
///
/// let north_face = GroundConditions {
///     height_m: 3500.0,
///     water_m: 3500.0,
///     slope_deg: 65.0,
///     climate: ClimateSample { temperature_c: -6.0, wetness: 0.6 },
/// };
/// assert_eq!(classify(&north_face), GroundSurface::Rock);
/// ```
pub fn classify(at: &GroundConditions) -> GroundSurface {
    if at.water_m > at.height_m {
        return under_water(at);
    }
    frozen(at)
        .or_else(|| loose(at))
        .unwrap_or_else(|| overgrown(at))
}

/// Rule 1.
fn under_water(at: &GroundConditions) -> GroundSurface {
    if at.water_m <= 0.0 {
        GroundSurface::SeaFloor
    } else if at.slope_deg > GENTLE_DEG {
        GroundSurface::Scree
    } else {
        GroundSurface::Mud
    }
}

/// Rule 2.
fn frozen(at: &GroundConditions) -> Option<GroundSurface> {
    let temperature = at.climate.temperature_c;
    if temperature < GLACIER_C && at.slope_deg < ANGLE_OF_REPOSE_DEG {
        Some(GroundSurface::Ice)
    } else if temperature < SNOW_LINE_C && at.slope_deg < SNOW_SLIDES_DEG {
        Some(GroundSurface::Snow)
    } else {
        None
    }
}

/// Rules 3 to 5: no soil.
fn loose(at: &GroundConditions) -> Option<GroundSurface> {
    let slope = at.slope_deg;
    if slope > BARE_ROCK_DEG {
        return Some(GroundSurface::Rock);
    }
    if slope > ANGLE_OF_REPOSE_DEG {
        return Some(GroundSurface::Scree);
    }
    // Waves keep beaches bare, drought keeps deserts bare.
    let is_desert = at.climate.wetness < DESERT_WETNESS;
    let is_beach = at.height_m.abs() < BEACH_M;
    if (is_beach || is_desert) && slope < GENTLE_DEG {
        Some(GroundSurface::Sand)
    } else if is_desert {
        Some(GroundSurface::Rock)
    } else {
        None
    }
}

/// Rules 6 to 8.
fn overgrown(at: &GroundConditions) -> GroundSurface {
    let ClimateSample {
        temperature_c,
        wetness,
    } = at.climate;
    if wetness > MARSH_WETNESS && at.slope_deg < FLAT_DEG {
        GroundSurface::Mud
    } else if wetness > FOREST_WETNESS && temperature_c > TREE_LINE_C {
        GroundSurface::Forest
    } else {
        GroundSurface::Grass
    }
}

#[cfg(test)]
#[path = "surface_tests.rs"]
mod tests;
