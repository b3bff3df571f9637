//! Whatever a recipe asks for and its planet will not have, known before it is grown.

use crate::params::shown;
use crate::planet::PlanetRecipe;
use crate::plate::{smallest_continent_km, smallest_land};
use pangaea_shaders::amplify::base::RADII_M;
use thiserror::Error;

/// Something that a recipe asks for and its planet will not have.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum RecipeWarning {
    /// Given continents that fall through the samples.
    #[error(
        "{small} of {all} continents are smaller than {least_km:.0} km in radius, the least that \
         {samples} samples can hold: they may have no land"
    )]
    SmallContinents {
        /// Continents that are too small.
        small: usize,
        /// All given continents.
        all: usize,
        /// Radius in km of the smallest continent that stays.
        least_km: f64,
        /// Samples of the planet.
        samples: u32,
    },
    /// A share of land that falls through the samples.
    #[error(
        "a share of land of {} is less than {least:.1e}, the least that {samples} samples can \
         hold: there may be no land",
        shown(*land)
    )]
    LittleLand {
        /// Share of land.
        land: f64,
        /// Smallest share that stays.
        least: f64,
        /// Samples of the planet.
        samples: u32,
    },
    /// A planet too large for ground finer than its samples.
    #[error(
        "there is no ground to query or export on a planet of {} km radius, only on those of {} to \
         {} km",
        shown(*radius),
        RADII_M.start() / 1000,
        RADII_M.end() / 1000
    )]
    NoGround {
        /// Radius in km.
        radius: f64,
    },
}

impl PlanetRecipe {
    /// Tells, before the planet is grown, of what the recipe asks for and the planet will not have.
    /// For a recipe that is spawned these go to the log. One that is refused has none.
    ///
    /// ```
    /// use bevy_pangaea::planet::{DiscRecipe, PlanetRecipe};
    ///
    /// let island = DiscRecipe { center: (0.0, 0.0), radius: 200.0 };
    /// let mut recipe = PlanetRecipe { continents: vec![island], ..Default::default() };
    /// assert_eq!(recipe.warnings(), []);
    ///
    /// recipe.samples = 500;
    /// let warning = recipe.warnings()[0].to_string();
    /// assert!(warning.contains("smaller than 1802 km"));
    /// ```
    pub fn warnings(&self) -> Vec<RecipeWarning> {
        if self.validate().is_err() {
            return Vec::new();
        }
        let land = if self.continents.is_empty() {
            self.little_land()
        } else {
            self.small_continents()
        };
        [land, self.no_ground()].into_iter().flatten().collect()
    }

    fn small_continents(&self) -> Option<RecipeWarning> {
        let least_km = smallest_continent_km(self);
        let is_small = |radius: f64| radius < least_km;
        let small = self
            .continents
            .iter()
            .filter(|disc| is_small(disc.radius))
            .count();
        (small > 0).then_some(RecipeWarning::SmallContinents {
            small,
            all: self.continents.len(),
            least_km,
            samples: self.samples,
        })
    }

    fn little_land(&self) -> Option<RecipeWarning> {
        let least = smallest_land(self);
        (self.land > 0.0 && self.land < least).then_some(RecipeWarning::LittleLand {
            land: self.land,
            least,
            samples: self.samples,
        })
    }

    fn no_ground(&self) -> Option<RecipeWarning> {
        // Rounded as it is for the ground.
        let metres = (self.radius * 1000.0).round() as u32;
        (!RADII_M.contains(&metres)).then_some(RecipeWarning::NoGround {
            radius: self.radius,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planet::DiscRecipe;

    /// A planet with a continent of each radius in km.
    fn with_continents(samples: u32, radii: &[f64]) -> PlanetRecipe {
        PlanetRecipe {
            samples,
            continents: radii.iter().copied().map(disc).collect(),
            ..PlanetRecipe::default()
        }
    }

    fn disc(radius: f64) -> DiscRecipe {
        let center = (0.0, 0.0);
        DiscRecipe { center, radius }
    }

    fn with_land(land: f64) -> PlanetRecipe {
        PlanetRecipe {
            samples: 500,
            land,
            ..PlanetRecipe::default()
        }
    }

    fn with_radius(radius: f64) -> PlanetRecipe {
        PlanetRecipe {
            radius,
            ..PlanetRecipe::default()
        }
    }

    #[test]
    fn continents_that_samples_cannot_hold_are_counted() {
        // Ten of 500 samples cover as much as a disc of 1800 km.
        let radii = [200.0, 1700.0, 1900.0, 3000.0];
        let warnings = with_continents(500, &radii).warnings();
        let [RecipeWarning::SmallContinents { small, all, .. }] = warnings[..] else {
            panic!("{warnings:?}");
        };
        assert_eq!((small, all), (2, 4));
        let text = warnings[0].to_string();
        assert!(
            text.contains("2 of 4 continents") && text.contains("1802 km"),
            "{text}"
        );
        assert_eq!(with_continents(60_000, &radii).warnings(), []);
    }

    #[test]
    fn continents_of_small_planets_are_measured_by_them() {
        let mut moon = with_continents(500, &[600.0]);
        moon.radius = 1737.0;
        assert_eq!(moon.warnings(), []);
        moon.continents[0].radius = 400.0;
        assert_eq!(moon.warnings().len(), 1);
    }

    #[test]
    fn a_share_of_land_that_samples_cannot_hold_is_told() {
        for good in [0.0, 0.06, 0.3] {
            assert_eq!(with_land(good).warnings(), [], "{good}");
        }
        let text = with_land(0.01).warnings()[0].to_string();
        assert!(text.contains("0.01") && text.contains("6.0e-2"), "{text}");
    }

    #[test]
    fn a_radius_without_ground_is_told() {
        for good in [50.0, 6370.0, 10_000.0] {
            assert_eq!(with_radius(good).warnings(), [], "{good}");
        }
        let text = with_radius(12_000.0).warnings()[0].to_string();
        assert!(
            text.contains("12000 km") && text.contains("50 to 10000 km"),
            "{text}"
        );
    }
}
