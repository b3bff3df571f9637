//! The ground of the base mesh and its landforms: the control maps C, A, P and B of paper 002 §3,
//! from the crust or from a user's maps. (W comes with the climate.) The laws are those of
//! `landform`.

use super::base::{BaseMesh, Transfer};
use super::landform::{BELOW, Crustal};
use crate::climate::{EARTH_RADIUS, EquirectMap, MapError};
use crate::crust::Surface;
use crate::math;
use crate::parallel;
use bevy::math::Vec3;
use pangaea_shaders::amplify::fixed::GRAINS;

/// Ground and landforms per vertex of a base mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Terrain {
    /// Base ground, the level of the valleys, in grains.
    pub ground: Vec<i32>,
    /// C: the level that summits reach, in grains.
    pub crust: Vec<i32>,
    /// A: age of the last orogeny in My; infinite where there was none.
    pub age: Vec<f32>,
    /// Share of continental collision in it, 0..=1.
    pub collision: Vec<f32>,
    /// P: presence of plateaus, 0..=1.
    pub plateau: Vec<f32>,
    /// B: presence of hills, 0..=1.
    pub hills: Vec<f32>,
    /// Share of oceanic crust, 0..=1.
    pub oceanic: Vec<f32>,
    /// Age of the ocean floor in My.
    pub ocean_age: Vec<f32>,
    /// Fold direction, undirected; unit length or zero.
    pub fold: Vec<Vec3>,
    /// Direction of the ridge that made the ocean floor, undirected; unit length or zero.
    pub ridge: Vec<Vec3>,
}

/// Maps of a user, from which a planet is made without a simulation (paper 002 §3).
#[derive(Clone, Debug, PartialEq)]
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
    /// Refuses maps of what no planet is.
    ///
    /// # Errors
    /// [`MapError::Range`].
    pub fn check(&self) -> Result<(), MapError> {
        let Self {
            crust,
            age,
            plateau,
            hills,
        } = self;
        let metres = "from -15 to 15 km: the values look like metres";
        EquirectMap::check(
            Some(crust),
            "the elevation of the crust",
            -15.0..=15.0,
            metres,
        )?;
        let past = 0.0..=f32::INFINITY;
        EquirectMap::check(
            age.as_ref(),
            "the age of the orogeny",
            past,
            "at least 0 My",
        )?;
        EquirectMap::check(
            plateau.as_ref(),
            "the presence of plateaus",
            0.0..=1.0,
            "from 0 to 1",
        )?;
        EquirectMap::check(
            hills.as_ref(),
            "the presence of hills",
            0.0..=1.0,
            "from 0 to 1",
        )
    }
}

impl Terrain {
    /// The terrain of a simulated planet.
    pub fn from_surface(base: &BaseMesh, transfer: &Transfer, surface: &Surface) -> Self {
        let crustal = parallel::map(base.mesh.len(), |i| {
            Crustal::between(surface, transfer.corners(i as usize))
        });
        Self::new(base, &crustal, None, None)
    }

    /// The terrain of a user's maps.
    pub fn from_maps(base: &BaseMesh, maps: &TerrainMaps) -> Self {
        let crustal = parallel::map(base.mesh.len(), |i| {
            let p = base.mesh.point(i);
            let elevation = maps.crust.at(p);
            let high = math::smoothstep(f64::from((elevation - 0.4) / 1.2)) as f32;
            Crustal {
                elevation,
                folded: if maps.age.is_some() { 1.0 } else { high },
                age: maps.age.as_ref().map_or(100.0, |age| age.at(p).max(0.0)),
                collision: 0.5,
                oceanic: if elevation < -2.0 { 1.0 } else { 0.0 },
                ocean_age: 80.0,
                noise: 0.0,
                ..Crustal::default()
            }
        });
        Self::new(base, &crustal, maps.plateau.as_ref(), maps.hills.as_ref())
    }

    /// `n` vertices of deep sea.
    pub fn ocean(n: usize) -> Self {
        let floor = to_grains(-5.0);
        Self {
            ground: vec![floor; n],
            crust: vec![floor; n],
            age: vec![f32::INFINITY; n],
            oceanic: vec![1.0; n],
            collision: vec![0.0; n],
            plateau: vec![0.0; n],
            hills: vec![0.0; n],
            ocean_age: vec![100.0; n],
            fold: vec![Vec3::ZERO; n],
            ridge: vec![Vec3::ZERO; n],
        }
    }

    fn new(
        base: &BaseMesh,
        crustal: &[Crustal],
        plateau: Option<&EquirectMap>,
        hills: Option<&EquirectMap>,
    ) -> Self {
        let mesh = &base.mesh;
        let given =
            |map: Option<&EquirectMap>, i: u32| map.map(|m| m.at(mesh.point(i)).clamp(0.0, 1.0));
        let forms: Vec<[f32; 4]> = parallel::map(mesh.len(), |i| {
            let own = &crustal[i as usize];
            let steepness = steepness(base, crustal, i);
            let plateau =
                given(plateau, i).unwrap_or_else(|| own.plateau(steepness, base.noise[i as usize]));
            let hills = given(hills, i).unwrap_or_else(|| own.hills() * (1.0 - plateau));
            let relief = own.relief(plateau);
            let ground = own.ground(relief, steepness, base.noise[i as usize]);
            [
                ground,
                own.elevation.max(ground) + (1.0 - BELOW) * relief,
                plateau,
                hills,
            ]
        });
        let column = |k: usize| forms.iter().map(|f| f[k]).collect::<Vec<f32>>();
        let grains = |k: usize| forms.iter().map(|f| to_grains(f[k])).collect::<Vec<i32>>();
        let of = |value: fn(&Crustal) -> f32| crustal.iter().map(value).collect::<Vec<f32>>();
        Self {
            ground: grains(0),
            crust: grains(1),
            plateau: column(2),
            hills: column(3),
            age: of(|c| {
                if c.folded > 0.02 {
                    c.age
                } else {
                    f32::INFINITY
                }
            }),
            collision: of(|c| c.collision),
            oceanic: of(|c| c.oceanic),
            ocean_age: of(|c| c.ocean_age),
            fold: crustal.iter().map(|c| c.fold).collect(),
            ridge: crustal.iter().map(|c| c.ridge).collect(),
        }
    }

    /// The base ground in km, as the climate sees it.
    pub fn elevation_km(&self) -> Vec<f32> {
        self.ground
            .iter()
            .map(|&z| z as f32 / (1000.0 * GRAINS as f32))
            .collect()
    }
}

/// Highest ground in km that the amplifier takes, and lowest below the sea.
const HIGHEST: f32 = 100.0;

/// Grains of a height in km, at most 100 km high or deep; what is not a number is at sea level.
pub fn to_grains(km: f32) -> i32 {
    (f64::from(km.clamp(-HIGHEST, HIGHEST)) * 1000.0 * f64::from(GRAINS)).round() as i32
}

/// Steepest slope of the crust from vertex `i` to a neighbour, as on an Earth-sized planet.
fn steepness(base: &BaseMesh, crustal: &[Crustal], i: u32) -> f32 {
    let p = base.mesh.point(i);
    let z = crustal[i as usize].elevation;
    let slope = |&j: &u32| {
        let way = ((base.mesh.point(j) - p).length() * EARTH_RADIUS) as f32;
        (crustal[j as usize].elevation - z).abs() / way
    };
    base.mesh.ring(i).iter().map(slope).fold(0.0, f32::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math;

    #[test]
    fn maps_of_no_planet_are_refused() {
        let map = |value: f32| {
            EquirectMap::from_fn(8, |lat, _| if lat > 60.0 { value } else { 0.5 }).unwrap()
        };
        let plain = || TerrainMaps {
            crust: map(-11.0),
            age: None,
            plateau: None,
            hills: None,
        };
        let error = TerrainMaps {
            crust: map(8848.0),
            ..plain()
        }
        .check()
        .unwrap_err();
        assert!(
            error.to_string().contains("8848 at pixel 0") && error.to_string().contains("metres")
        );
        let refused = |maps: TerrainMaps| matches!(maps.check(), Err(MapError::Range { .. }));
        assert!(refused(TerrainMaps {
            age: Some(map(-1.0)),
            ..plain()
        }));
        assert!(refused(TerrainMaps {
            plateau: Some(map(1.1)),
            ..plain()
        }));
        assert!(refused(TerrainMaps {
            hills: Some(map(-0.1)),
            ..plain()
        }));
        assert_eq!(
            TerrainMaps {
                age: Some(map(4000.0)),
                hills: Some(map(1.0)),
                ..plain()
            }
            .check(),
            Ok(())
        );
    }

    #[test]
    fn heights_beyond_all_bounds_are_clamped() {
        let (top, metre) = (100_000 * GRAINS, 1e-3);
        assert_eq!(
            [metre, 1e9, f32::NEG_INFINITY, f32::NAN].map(to_grains),
            [GRAINS, top, -top, 0]
        );
    }

    #[test]
    fn maps_alone_make_a_terrain() {
        let base = BaseMesh::new(1, 0.05).unwrap();
        let crust = EquirectMap::from_fn(32, |lat, _| (lat / 20.0) as f32).unwrap();
        let ones = EquirectMap::from_fn(4, |_, _| 0.5).unwrap();
        let maps = TerrainMaps {
            crust,
            age: None,
            plateau: Some(ones),
            hills: None,
        };
        let terrain = Terrain::from_maps(&base, &maps);
        assert!(terrain.plateau.iter().all(|&p| p == 0.5));
        for (i, p) in base.mesh.points().iter().enumerate() {
            let z = math::lat_lon(*p).0 / 20.0;
            let found = f64::from(terrain.ground[i]) / 1_024_000.0;
            assert!(found < z + 0.6 && found > z - 1.4, "{z} {found}");
            assert!(terrain.crust[i] >= terrain.ground[i]);
        }
    }
}
