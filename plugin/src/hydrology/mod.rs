//! Hydrology: where the rain goes (paper 002 §4).
//!
//! In: the base mesh, its ground and its climate. Out: [`Drainage`].
//!
//! ```text
//! base      the base mesh: Poisson-disk points, triangles, winds; once per seed
//! terrain   the ground and the landforms of its vertices, from the crust or from a user's maps
//! landform  what the crust says about the relief around a vertex
//! coast     sea, coast and land, such that estuaries have room
//! flood     which way water leaves every place
//! sinks     basins without an outlet
//! flow      discharge, to the last cubic metre
//! profile   levels, beds and lakes along the rivers
//! order     Horton-Strahler order, basins
//! growth    the paper's own network, grown from the coasts; a preset
//! stats     figures: Horton's ratios, Hack's exponent
//! ```
//!
//! Heights are whole grains of 1/1024 m ([`pangaea_shaders::amplify::fixed`]), water is whole cubic
//! metres per year: what is conserved is conserved to the last unit.

pub mod base;

pub mod terrain;

mod landform;

pub mod coast;

pub mod flood;

mod sinks;

pub mod flow;

pub mod profile;

pub mod order;

pub mod growth;

pub mod stats;

pub use base::{BaseMesh, Transfer};
pub use coast::Site;
pub use flood::{NONE, Routes};
pub use growth::RiverNetwork;
pub use profile::{Lake, Profile};
pub use sinks::incision;
pub use stats::HydrologyStats;
pub use terrain::{Terrain, TerrainMaps};

use crate::climate::Climate;

/// Where the water of a lake goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum LakeKind {
    /// On to the sea.
    Draining = 0,
    /// Out of the lake, but to a lake or a sink from which it never reaches the sea.
    Passing = 1,
    /// Nowhere but into the air: the lake has no outlet.
    Closed = 2,
}

/// Where the water of a planet goes, per vertex of its base mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drainage {
    /// Sea, coast or land.
    pub sites: Vec<Site>,
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
    pub fn new(
        base: &BaseMesh,
        radius: f64,
        terrain: &Terrain,
        climate: &Climate,
        network: RiverNetwork,
    ) -> Self {
        let mesh = &base.mesh;
        let mut ground = terrain.ground.clone();
        ground.resize(mesh.len(), -1);
        let sites = coast::regularise(mesh, &mut ground);
        let (routes, closed) = match network {
            RiverNetwork::Drainage => Self::drain(base, radius, &sites, &ground, climate),
            RiverNetwork::Grown => (growth::grow(base, &sites, &ground, terrain), Vec::new()),
        };
        let supply = flow::supply(mesh, radius, climate, &routes);
        let discharge = flow::accumulate(&routes, &supply);
        let earth_like = |i: u32| flow::earth_like(discharge[i as usize], radius);
        let profile = profile::profile(mesh, &routes, &ground, earth_like, &closed, network);
        let strahler = order::strahler(&routes);
        let basin = order::basins(&routes);
        Self {
            sites,
            ground,
            routes,
            supply,
            discharge,
            strahler,
            basin,
            profile,
            radius,
        }
    }

    fn drain(
        base: &BaseMesh,
        radius: f64,
        sites: &[Site],
        ground: &[i32],
        climate: &Climate,
    ) -> (Routes, Vec<sinks::Closed>) {
        let mesh = &base.mesh;
        let mut routes = flood::flood(mesh, sites, ground);
        let supply = flow::supply(mesh, radius, climate, &routes);
        let loss = flow::volumes(mesh, radius, &climate.open_water_loss);
        let balance = sinks::Balance {
            mesh,
            radius,
            ground,
            supply: &supply,
            loss: &loss,
        };
        let closed = sinks::close_basins(&balance, &mut routes);
        (routes, closed)
    }

    /// Number of vertices.
    pub fn len(&self) -> usize {
        self.ground.len()
    }

    /// Whether there are no vertices.
    pub fn is_empty(&self) -> bool {
        self.ground.is_empty()
    }

    /// Discharge of vertex `i` in m³/s as it would be on an Earth-sized planet: what rivers are
    /// ranked by.
    pub fn earth_like_discharge(&self, i: usize) -> f64 {
        flow::earth_like(self.discharge[i], self.radius)
    }

    /// Whether vertex `i` lies in a lake.
    pub fn is_lake(&self, i: usize) -> bool {
        self.profile.lake[i] != NONE
    }

    /// The kind of the lake that covers vertex `i`; none where there is no lake.
    pub fn lake_kind(&self, i: usize) -> Option<LakeKind> {
        let lake = self.profile.lakes.get(self.profile.lake[i] as usize)?;
        Some(match lake.outlet {
            NONE => LakeKind::Closed,
            _ if self.is_endorheic(i) => LakeKind::Passing,
            _ => LakeKind::Draining,
        })
    }

    /// Whether the water of vertex `i` never reaches the sea.
    pub fn is_endorheic(&self, i: usize) -> bool {
        self.basin[i] != NONE && self.sites[self.basin[i] as usize] == Site::Land
    }
}

#[cfg(test)]
#[path = "hydrology_tests.rs"]
mod tests;
