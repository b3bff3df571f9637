//! The drainage of a planet: from ground and climate to rivers and lakes.

use super::base::BaseMesh;
use super::coast::{ShoreClass, regularise};
use super::flood::{NO_VERTEX, Routes, priority_flood};
use super::flow;
use super::growth::grow;
use super::network::RiverNetwork;
use super::order;
use super::profile::{Channels, NO_LAKE, Profile};
use super::sinks::{WaterBalance, close_basins};
use super::terrain::Terrain;
use crate::climate::Climate;
use crate::parallel;
use bevy::reflect::Reflect;

/// Where the water of a lake goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Reflect)]
#[repr(u8)]
pub enum LakeKind {
    /// On to the sea.
    Draining = 0,
    /// Out of the lake, but to a lake or a sink from which it never reaches the sea.
    Passing = 1,
    /// Only into the air: the lake has no outlet.
    Closed = 2,
}

/// Where the water of a planet goes, per vertex of its base mesh.
#[derive(Clone, Debug, Default, PartialEq, Reflect)]
pub struct Drainage {
    /// Sea, coast or land.
    pub shore: Vec<ShoreClass>,
    /// The ground after coasts were regularised, grains.
    pub ground: Vec<i32>,
    /// Order, receivers and depressions.
    pub routes: Routes,
    /// Runoff of each vertex on land in m³ per year.
    pub supply: Vec<u64>,
    /// Discharge in m³ per year; at coasts that of the rivers that end there.
    pub discharge: Vec<u64>,
    /// Horton–Strahler order; 0 in the sea and on coasts.
    pub strahler: Vec<u8>,
    /// The coast or sink that each vertex drains to.
    pub basin: Vec<u32>,
    /// Water levels, beds and lakes.
    pub profile: Profile,
    /// Radius of the planet in km.
    pub radius: f64,
}

impl Drainage {
    /// The drainage of `terrain` under `climate` on a planet of `radius` km. Terrain and climate
    /// are those of the vertices of `base`.
    ///
    /// ```
    /// use bevy_pangaea::climate::{Climate, ClimateMaps, EquirectMap};
    /// use bevy_pangaea::hydrology::{BaseMesh, Drainage, RiverNetwork, Terrain, TerrainMaps};
    ///
    /// // A continent around the equator, 2 km high in its middle, on a coarse base mesh.
    /// let base = BaseMesh::new(1, 0.06)?;
    /// let crust = EquirectMap::from_fn(32, |lat, _| 2.0 - lat.abs() as f32 / 15.0)?;
    /// let maps = TerrainMaps { crust, age: None, plateau: None, hills: None };
    /// let terrain = Terrain::from_maps(&base, &maps);
    /// let elevation = terrain.elevation_km();
    /// let climate = Climate::new(&base.mesh, &base.winds, &elevation, &ClimateMaps::default());
    /// let drainage =
    ///     Drainage::new(&base, 6370.0, &terrain, &climate, RiverNetwork::Drainage);
    ///
    /// // All water arrives: at the coasts or in lakes without an outlet.
    /// let ends = |i: &usize| drainage.routes.receiver[*i] == bevy_pangaea::hydrology::NO_VERTEX;
    /// let arrived: u64 = (0..drainage.len()).filter(ends).map(|i| drainage.discharge[i]).sum();
    /// assert_eq!(arrived, drainage.supply.iter().sum::<u64>());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        base: &BaseMesh,
        radius: f64,
        terrain: &Terrain,
        climate: &Climate,
        network: RiverNetwork,
    ) -> Self {
        let mesh = &base.mesh;
        let mut ground = terrain.ground.clone();
        // Vertices that a terrain lacks lie just under the sea.
        ground.resize(mesh.len(), -1);
        let shore = regularise(mesh, &mut ground);
        let mut routes = match network {
            RiverNetwork::Drainage => priority_flood(mesh, &shore, &ground),
            RiverNetwork::Grown => grow(base, &shore, &ground, terrain),
        };
        let supply = flow::supply(mesh, radius, climate, &routes);
        let closed = match network {
            RiverNetwork::Drainage => {
                let balance = WaterBalance {
                    mesh,
                    radius,
                    ground: &ground,
                    supply: &supply,
                    loss: &flow::volumes(mesh, radius, &climate.open_water_loss),
                };
                close_basins(&balance, &mut routes)
            }
            RiverNetwork::Grown => Vec::new(),
        };
        // Closed basins have turned receivers around: the discharge is that of the final routes.
        let discharge = flow::accumulate(&routes, &supply);
        let earth_like = parallel::map(mesh.len(), |i| {
            flow::earth_like(discharge[i as usize], radius)
        });
        let channels = Channels {
            routes: &routes,
            ground: &ground,
            discharge: &earth_like,
            network,
        };
        let orders = || rayon::join(|| order::strahler(&routes), || order::basins(&routes));
        let (profile, (strahler, basin)) = rayon::join(|| channels.profile(&closed), orders);
        Self {
            strahler,
            basin,
            shore,
            ground,
            routes,
            supply,
            discharge,
            profile,
            radius,
        }
    }

    /// Number of vertices.
    pub fn len(&self) -> usize {
        self.ground.len()
    }

    /// Whether there are no vertices.
    pub fn is_empty(&self) -> bool {
        self.ground.is_empty()
    }

    /// Discharge of vertex `i` in m³/s.
    pub fn discharge_m3s(&self, i: usize) -> f64 {
        flow::per_second(self.discharge[i])
    }

    /// Discharge of vertex `i` in m³/s as it would be on an Earth-sized planet: the measure by
    /// which rivers are ranked.
    pub fn earth_like_discharge(&self, i: usize) -> f64 {
        flow::earth_like(self.discharge[i], self.radius)
    }

    /// Whether vertex `i` lies in a lake.
    pub fn is_lake(&self, i: usize) -> bool {
        self.profile.lake[i] != NO_LAKE
    }

    /// The kind of the lake that covers vertex `i`; `None` where there is no lake.
    pub fn lake_kind(&self, i: usize) -> Option<LakeKind> {
        let lake = self.profile.lakes.get(self.profile.lake[i] as usize)?;
        Some(match lake.outlet {
            NO_VERTEX => LakeKind::Closed,
            _ if self.is_endorheic(i) => LakeKind::Passing,
            _ => LakeKind::Draining,
        })
    }

    /// Whether the water of vertex `i` never reaches the sea.
    pub fn is_endorheic(&self, i: usize) -> bool {
        let basin = self.basin[i];
        basin != NO_VERTEX && self.shore[basin as usize] == ShoreClass::Land
    }
}

#[cfg(test)]
#[path = "drainage_tests.rs"]
mod tests;
