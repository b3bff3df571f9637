//! What the ground is made of: a rule of thumb for footsteps, materials and plants.
//!
//! Angles and temperatures are those of the field: loose rock comes to rest at 33 to 38°, snow does
//! not hold on walls steeper than about 50°, trees end where the year's mean falls below about 0
//! °C, glaciers live where it is far below. Not modelled: seasons, soil, fire, what people do.

use crate::climate::temperature::{LAPSE_RATE, temperature};

/// Warmth and wetness of a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Climate {
    /// Mean of the year in °C.
    pub temperature_c: f32,
    /// Wetness, from 0 (desert) to 1 (rain forest); W of paper 002 §3.
    pub wetness: f32,
}

/// Cooling with height in °C per m.
pub(super) const LAPSE: f32 = (LAPSE_RATE / 1000.0) as f32;

impl Climate {
    /// The climate of a latitude, given by its sine, at `height_m` above the sea: as warm as bakes
    /// have it ([`temperature`]), and half wet everywhere.
    pub fn of_latitude(sin_latitude: f64, height_m: f32) -> Self {
        Self {
            temperature_c: temperature(sin_latitude, height_m / 1000.0),
            wetness: 0.5,
        }
    }
}

/// What the ground is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum GroundSurface {
    /// Bare rock: walls, and steep ground in deserts.
    #[default]
    Rock = 0,
    /// Loose stones at their angle of rest, and gravel in fast rivers.
    Scree,
    /// Sand: beaches and deserts.
    Sand,
    /// Mud: marshes, and the beds of lakes and slow rivers.
    Mud,
    /// Grass, and what grows where trees do not.
    Grass,
    /// Forest.
    Forest,
    /// Snow that stays all year.
    Snow,
    /// Ice of glaciers.
    Ice,
    /// The ground of the sea.
    SeaFloor,
}

impl GroundSurface {
    /// All of them, in the order of their numbers.
    pub const ALL: [Self; 9] = [
        Self::Rock,
        Self::Scree,
        Self::Sand,
        Self::Mud,
        Self::Grass,
        Self::Forest,
        Self::Snow,
        Self::Ice,
        Self::SeaFloor,
    ];

    /// Its name in files: `rock`, `scree`, `sand`, `mud`, `grass`, `forest`, `snow`, `ice`,
    /// `sea_floor`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rock => "rock",
            Self::Scree => "scree",
            Self::Sand => "sand",
            Self::Mud => "mud",
            Self::Grass => "grass",
            Self::Forest => "forest",
            Self::Snow => "snow",
            Self::Ice => "ice",
            Self::SeaFloor => "sea_floor",
        }
    }
}

/// What [`classify`] goes by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Site {
    /// Height of the ground above sea level in m.
    pub height_m: f32,
    /// Level of the water in m; the height of the ground where it is dry.
    pub water_m: f32,
    /// Slope in degrees, 0 to 90.
    pub slope_deg: f32,
    /// Warmth and wetness.
    pub climate: Climate,
}

/// Slopes in degrees: where scree begins and ends, where snow no longer holds, what counts as flat.
const REST: f32 = 33.0;
const WALL: f32 = 38.0;
const SNOW_HOLDS: f32 = 50.0;
const GENTLE: f32 = 6.0;
const FLAT: f32 = 1.0;

/// Means of the year in °C: below, snow stays; below, glaciers live; above, trees grow.
const SNOW_LINE: f32 = -3.0;
const GLACIER: f32 = -10.0;
const TREE_LINE: f32 = 1.0;

/// Wetness: below, desert; above, forest; above, marsh where it is flat.
const DESERT: f32 = 0.15;
const WOODED: f32 = 0.4;
const MARSH: f32 = 0.85;

/// Height of a beach above the sea in m.
const BEACH: f32 = 3.0;

/// What the ground is made of. The first rule that fits wins:
///
/// 1. under water: the sea's floor where the water is at sea level or below; else mud, or scree on
/// slopes over 6°;
/// 2. below -3 °C: ice on slopes under 33° below -10 °C, snow on slopes under 50°;
/// 3. rock on slopes over 38°; scree over 33°;
/// 4. sand within 3 m above the sea on slopes under 6°;
/// 5. where wetness is below 0.15: sand on slopes under 6°, else rock;
/// 6. mud where it is flatter than 1° and wetness is over 0.85;
/// 7. forest above 1 °C where wetness is over 0.4;
/// 8. grass.
///
/// What is not a number fits no rule.
pub fn classify(site: &Site) -> GroundSurface {
    let Site {
        height_m,
        water_m,
        slope_deg: slope,
        climate: Climate {
            temperature_c,
            wetness,
        },
    } = *site;
    if water_m > height_m {
        return match () {
            () if water_m <= 0.0 => GroundSurface::SeaFloor,
            () if slope > GENTLE => GroundSurface::Scree,
            () => GroundSurface::Mud,
        };
    }
    match () {
        () if temperature_c < GLACIER && slope < REST => GroundSurface::Ice,
        () if temperature_c < SNOW_LINE && slope < SNOW_HOLDS => GroundSurface::Snow,
        () if slope > WALL => GroundSurface::Rock,
        () if slope > REST => GroundSurface::Scree,
        () if height_m.abs() < BEACH && slope < GENTLE => GroundSurface::Sand,
        () if wetness < DESERT && slope < GENTLE => GroundSurface::Sand,
        () if wetness < DESERT => GroundSurface::Rock,
        () if wetness > MARSH && slope < FLAT => GroundSurface::Mud,
        () if wetness > WOODED && temperature_c > TREE_LINE => GroundSurface::Forest,
        () => GroundSurface::Grass,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kind(
        height_m: f32,
        water_m: f32,
        slope_deg: f32,
        temperature_c: f32,
        wetness: f32,
    ) -> GroundSurface {
        classify(&Site {
            height_m,
            water_m,
            slope_deg,
            climate: Climate {
                temperature_c,
                wetness,
            },
        })
    }

    #[test]
    fn places_that_one_knows_are_what_they_are() {
        use GroundSurface::*;
        for (place, expected, found) in [
            ("abyss", SeaFloor, kind(-4000.0, 0.0, 1.0, 10.0, 0.5)),
            ("lake", Mud, kind(300.0, 320.0, 2.0, 10.0, 0.5)),
            ("rapids", Scree, kind(300.0, 301.0, 12.0, 10.0, 0.5)),
            ("beach", Sand, kind(1.0, 1.0, 3.0, 20.0, 0.5)),
            ("dunes", Sand, kind(400.0, 400.0, 4.0, 25.0, 0.02)),
            ("wadi", Rock, kind(400.0, 400.0, 20.0, 25.0, 0.02)),
            ("steppe", Grass, kind(400.0, 400.0, 2.0, 8.0, 0.3)),
            ("jungle", Forest, kind(200.0, 200.0, 10.0, 26.0, 0.95)),
            ("marsh", Mud, kind(50.0, 50.0, 0.2, 10.0, 0.95)),
            ("alp", Grass, kind(2300.0, 2300.0, 20.0, 0.0, 0.6)),
            ("talus", Scree, kind(2600.0, 2600.0, 35.0, 0.0, 0.6)),
            ("north face", Rock, kind(3500.0, 3500.0, 65.0, -6.0, 0.6)),
            ("firn", Snow, kind(3500.0, 3500.0, 30.0, -5.0, 0.6)),
            ("ice cap", Ice, kind(2500.0, 2500.0, 1.0, -30.0, 0.3)),
        ] {
            assert_eq!(found, expected, "{place}");
        }
    }

    #[test]
    fn climate_cools_to_the_poles_and_upwards() {
        let t = |sin, height| Climate::of_latitude(sin, height).temperature_c;
        assert!(t(0.0, 0.0) > 25.0 && t(1.0, 0.0) < -10.0);
        assert!((t(0.0, 0.0) - t(0.0, 1000.0) - 6.5).abs() < 1e-4);
        assert_eq!(
            t(0.3, 2500.0),
            temperature(0.3, 2.5),
            "one law for bakes and for questions"
        );
        assert_eq!(t(0.5, -4000.0), t(-0.5, 0.0));
    }

    #[test]
    fn names_and_numbers_are_unique_and_nonsense_does_not_panic() {
        for (i, surface) in GroundSurface::ALL.into_iter().enumerate() {
            assert_eq!(surface as usize, i);
            assert!(
                GroundSurface::ALL
                    .iter()
                    .filter(|other| other.name() == surface.name())
                    .count()
                    == 1
            );
        }
        assert_eq!(
            kind(f32::NAN, f32::NAN, f32::NAN, f32::NAN, f32::NAN),
            GroundSurface::Grass
        );
    }
}
