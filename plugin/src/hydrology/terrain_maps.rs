//! A planet of maps: what a user gives instead of a simulation (paper 002 §3), and the crust that
//! it means.

use super::landform::CrustSample;
use crate::climate::{EquirectMap, MapError};
use crate::crust::isostasy::Isostasy;
use crate::crust::{CrustKind, CrustRow, Orogeny};
use crate::math;
use crate::params::TectonicParams;
use bevy::math::DVec3;
use bevy::prelude::{Component, ReflectComponent};
use bevy::reflect::Reflect;

/// Maps of a user, from which a planet is made without a simulation (paper 002 §3). The crust must
/// be whole; where another map is void it counts as not given.
///
/// As a component of a planet they are its ground: bakes read them instead of its surface.
#[derive(Component, Clone, Debug, PartialEq, Reflect)]
#[reflect(Component, Clone, Debug, PartialEq)]
pub struct TerrainMaps {
    /// Elevation of the crust in km, -15..=15, negative under the sea.
    pub crust: EquirectMap,
    /// A: age of the last orogeny in My, at least 0; without it, high ground counts as folded 100
    /// My ago.
    pub age: Option<EquirectMap>,
    /// P: presence of plateaus, 0..=1.
    pub plateau: Option<EquirectMap>,
    /// B: presence of hills, 0..=1.
    pub hills: Option<EquirectMap>,
}

impl TerrainMaps {
    /// Highest ground in km that a map may have, and lowest below the sea.
    pub(crate) const HIGHEST_KM: f32 = 15.0;

    /// Refuses maps with values that no planet has.
    ///
    /// # Errors
    /// [`MapError::Range`]; [`MapError::Void`] for a crust with voids.
    pub fn check(&self) -> Result<(), MapError> {
        // The usual mistake gets its own words.
        let kilometres = "from -15 to 15 km: the values look like metres";
        let what = "the elevation of the crust";
        let range = -Self::HIGHEST_KM..=Self::HIGHEST_KM;
        EquirectMap::check(Some(&self.crust), what, range, kilometres)?;
        self.crust.check_whole(what)?;
        let past = 0.0..=f32::INFINITY;
        let age = self.age.as_ref();
        EquirectMap::check(age, "the age of the orogeny", past, "at least 0 My")?;
        for (map, what) in [
            (&self.plateau, "the presence of plateaus"),
            (&self.hills, "the presence of hills"),
        ] {
            EquirectMap::check(map.as_ref(), what, 0.0..=1.0, "from 0 to 1")?;
        }
        Ok(())
    }

    /// Maps that are given, with the names that files have for them: `elevation`, `age`, `plateaus`,
    /// `hills`.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, &EquirectMap)> {
        let all = [
            ("elevation", Some(&self.crust)),
            ("age", self.age.as_ref()),
            ("plateaus", self.plateau.as_ref()),
            ("hills", self.hills.as_ref()),
        ];
        all.into_iter().filter_map(|(name, map)| Some((name, map?)))
    }

    /// The crust at a unit direction, as a lattice without plates holds it: continental above the
    /// middle of the slopes, as thick as floats at its height.
    pub(crate) fn crust_row(&self, p: DVec3, params: &TectonicParams) -> CrustRow {
        let sample = self.crust_at(p);
        let is_oceanic = sample.oceanic > 0.5;
        let floating = Isostasy::new(params).thickness(sample.elevation);
        CrustRow {
            kind: if is_oceanic {
                CrustKind::Oceanic
            } else {
                CrustKind::Continental
            },
            // Deeper than old ocean floor nothing floats: trenches are bent.
            thickness: floating.max(params.ocean_thickness as f32),
            elevation: sample.elevation,
            ocean_age: if is_oceanic { sample.ocean_age } else { 0.0 },
            orogeny_age: sample.age.min(OLDEST_MY),
            orogeny: self.orogeny(&sample),
            ..CrustRow::ocean(params)
        }
    }

    /// The belt that a place belongs to: only a map of ages tells of belts, and none of their kinds;
    /// those that continents folded are the more usual.
    fn orogeny(&self, sample: &CrustSample) -> Orogeny {
        if self.age.is_some() && sample.folded > 0.5 && sample.elevation > 0.0 {
            Orogeny::Himalayan
        } else {
            Orogeny::None
        }
    }

    /// The crust that the maps mean at a unit direction.
    pub(super) fn crust_at(&self, p: DVec3) -> CrustSample {
        let elevation = self.crust.at(p).unwrap_or(VOID_ELEVATION_KM);
        let age = self.age.as_ref().and_then(|age| age.at(p));
        let folded = match age {
            // Whoever gives ages gives them for all ground.
            Some(_) => 1.0,
            None => {
                math::smoothstep(f64::from((elevation - FOLDED_FROM_KM) / FOLDED_WITHIN_KM)) as f32
            }
        };
        CrustSample {
            elevation,
            folded,
            age: age.map_or(UNKNOWN_AGE_MY, |age| age.max(0.0)),
            // A map does not say which kind of belt built its mountains.
            collision: 0.5,
            oceanic: if elevation < OCEAN_BELOW_KM { 1.0 } else { 0.0 },
            ocean_age: UNKNOWN_OCEAN_AGE_MY,
            noise: 0.0,
            ..CrustSample::default()
        }
    }
}

/// Oldest orogeny in My that the crust's columns hold.
const OLDEST_MY: f32 = 1e6;

/// Elevation in km of a void of the crust, which no map that was checked has: sea.
const VOID_ELEVATION_KM: f32 = -1.0;

/// Elevation in km from which on ground of unknown age counts as folded in part.
const FOLDED_FROM_KM: f32 = 0.4;

/// Further rise in km to ground that counts as folded altogether: plains are lower than 400 m,
/// mountains higher than 1600 m.
const FOLDED_WITHIN_KM: f32 = 1.2;

/// Age in My of the orogeny of folded ground of unknown age: half worn down.
const UNKNOWN_AGE_MY: f32 = 100.0;

/// Elevation in km below which the crust of maps is oceanic: the middle of continental slopes.
const OCEAN_BELOW_KM: f32 = -2.0;

/// Age in My of the ocean floor of maps: near the mean of Earth's (64 My, Seton et al. 2020).
const UNKNOWN_OCEAN_AGE_MY: f32 = 80.0;
