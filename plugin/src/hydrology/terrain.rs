//! The ground of the base mesh and its landforms: the control maps C, A, P and B of paper 002 §3,
//! from the crust or from a user's maps. (W comes with the climate.) The laws are those of
//! `landform`.

use super::base::{BaseMesh, Transfer};
use super::landform::{CrustSample, RELIEF_BELOW_MEAN, lowered_summits};
use super::terrain_maps::TerrainMaps;
use crate::climate::{EARTH_RADIUS, EquirectMap};
use crate::crust::Surface;
use crate::{math, parallel};
use bevy::math::Vec3;
use bevy::reflect::Reflect;
use pangaea_shaders::amplify::fixed::GRAINS;

/// Ground and landforms per vertex of a base mesh.
#[derive(Clone, Debug, Default, PartialEq, Reflect)]
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

/// Share of folded crust from which on a vertex has an age of orogeny.
const LEAST_FOLDED: f32 = 0.02;

impl Terrain {
    /// The terrain of a simulated planet.
    pub fn from_surface(base: &BaseMesh, transfer: &Transfer, surface: &Surface) -> Self {
        let crust = parallel::map(base.mesh.len(), |i| {
            CrustSample::between(surface, transfer.corners(i as usize))
        });
        Self::new(base, &crust, None, None)
    }

    /// The terrain of a user's maps.
    ///
    /// ```
    /// use bevy_pangaea::climate::EquirectMap;
    /// use bevy_pangaea::hydrology::{BaseMesh, Terrain, TerrainMaps};
    ///
    /// let base = BaseMesh::new(1, 0.1)?;
    /// let crust = EquirectMap::from_fn(32, |lat, _| lat as f32 / 30.0)?;
    /// let maps = TerrainMaps { crust, age: None, plateau: None, hills: None };
    /// maps.check()?;
    /// let terrain = Terrain::from_maps(&base, &maps);
    /// assert_eq!(terrain.ground.len(), base.mesh.len());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_maps(base: &BaseMesh, maps: &TerrainMaps) -> Self {
        let crust = parallel::map(base.mesh.len(), |i| maps.crust_at(base.mesh.point(i)));
        Self::new(base, &crust, maps.plateau.as_ref(), maps.hills.as_ref())
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
        crust: &[CrustSample],
        plateau: Option<&EquirectMap>,
        hills: Option<&EquirectMap>,
    ) -> Self {
        let forms: Vec<VertexRelief> = parallel::map(base.mesh.len(), |i| {
            let p = base.mesh.point(i);
            let share = |map: &EquirectMap| map.at(p).map(|share| share.clamp(0.0, 1.0));
            let (plateau, hills) = (plateau.and_then(share), hills.and_then(share));
            VertexRelief::new(base, crust, i, plateau, hills)
        });
        Self {
            ground: column(&forms, |f| to_grains(f.ground)),
            crust: column(&forms, |f| to_grains(f.summits)),
            plateau: column(&forms, |f| f.plateau),
            hills: column(&forms, |f| f.hills),
            age: column(crust, orogeny_age),
            collision: column(crust, |c| c.collision),
            oceanic: column(crust, |c| c.oceanic),
            ocean_age: column(crust, |c| c.ocean_age),
            fold: column(crust, |c| c.fold),
            ridge: column(crust, |c| c.ridge),
        }
    }

    /// The base ground in km, as the climate sees it.
    pub fn elevation_km(&self) -> Vec<f32> {
        column(&self.ground, |&z| z as f32 / (1000.0 * GRAINS as f32))
    }
}

/// The relief of one vertex.
struct VertexRelief {
    /// Level of the valleys in km.
    ground: f32,
    /// C: level of the summits in km.
    summits: f32,
    /// P, 0..=1.
    plateau: f32,
    /// B, 0..=1.
    hills: f32,
}

impl VertexRelief {
    /// The relief of vertex `i` of a base mesh with such crust; maps may give the presence of
    /// plateaus and hills.
    fn new(
        base: &BaseMesh,
        crust: &[CrustSample],
        i: u32,
        plateau: Option<f32>,
        hills: Option<f32>,
    ) -> Self {
        let own = &crust[i as usize];
        let noise = base.noise[i as usize];
        let steepness = steepness(base, crust, i);
        let plateau = plateau.unwrap_or_else(|| own.plateau(steepness, noise));
        // A place is a plateau or hills, not both; maps of a user are taken as they are.
        let hills = hills.unwrap_or_else(|| own.hills() * (1.0 - plateau));
        let relief = own.relief(plateau);
        let ground = own.ground(relief, steepness, noise);
        // The noise may lift the valleys above the mean: summits still rise over them.
        let summits = own.elevation.max(ground) + (1.0 - RELIEF_BELOW_MEAN) * relief;
        let lowered = lowered_summits(summits);
        // Valleys are cut along, and the relief stays; but ground that a user gave is as it is.
        let ground = ground - own.noise * (summits - lowered);
        Self {
            ground,
            summits: lowered.max(ground),
            plateau,
            hills,
        }
    }
}

/// One value of all vertices.
fn column<V: Sync, T: Send>(vertices: &[V], value: impl Fn(&V) -> T + Sync + Send) -> Vec<T> {
    parallel::map(vertices.len(), |i| value(&vertices[i as usize]))
}

/// A: age of the last orogeny in My; infinite where there was none.
fn orogeny_age(crust: &CrustSample) -> f32 {
    if crust.folded > LEAST_FOLDED {
        crust.age
    } else {
        f32::INFINITY
    }
}

/// Highest ground in km that the amplifier takes, and lowest below the sea.
const HIGHEST_KM: f32 = 100.0;

/// Grains of a height in km, at most 100 km high or deep; NaN is at sea level.
fn to_grains(km: f32) -> i32 {
    let km = f64::from(km.clamp(-HIGHEST_KM, HIGHEST_KM));
    math::nearest(km * 1000.0 * f64::from(GRAINS)) as i32
}

/// Steepest slope of the crust from vertex `i` to a neighbour, as on an Earth-sized planet.
fn steepness(base: &BaseMesh, crust: &[CrustSample], i: u32) -> f32 {
    let p = base.mesh.point(i);
    let z = crust[i as usize].elevation;
    let mut steepest = 0.0_f32;
    for &j in base.mesh.ring(i) {
        let way = ((base.mesh.point(j) - p).length() * EARTH_RADIUS) as f32;
        steepest = steepest.max((crust[j as usize].elevation - z).abs() / way);
    }
    steepest
}

#[cfg(test)]
#[path = "terrain_tests.rs"]
mod tests;
