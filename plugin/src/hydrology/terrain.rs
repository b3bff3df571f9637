//! The ground of the base mesh and its landforms: the control maps C, A, P and B of paper 002 §3, from the crust or
//! from a user's maps. (W comes with the climate.)
//!
//! Crust is sampled every 50 to 200 km; what lies between is *relief*. It stands about the mean elevation z of the crust:
//! valleys a third of it below, summits two thirds above. So C, the level that summits reach, is z + 0.65 R, and the
//! base ground, on which rivers run, is z - 0.35 R. R spans from the valley floors to the highest summits: in real belts
//! that is the largest range within 10 km, half again the median one. It is 4.4 km in young Himalayan belts (Karakoram
//! 3.8, Everest 4.4), 3.0 km in young Andean ones (Patagonia 2.7, Aconcagua 3.4), 0.85 km once they are 200 My old
//! (Appalachians and Scottish Highlands 1.1), and some tens of metres where nothing was folded. A low belt has no more
//! of it than one and a half times its mean elevation, however old (Scottish Highlands 1.2, Patagonia 1.75).
//!
//! - P, plateau: high, level crust of young belts: what lies behind the Andean and Himalayan fronts, less where ranges
//!   cross it. Its relief is two fifths of its belt's (Altiplano: 1.3 km, beside 2.1 km at Aconcagua).
//! - B, hills: old belts, and the forelands of moderate height.
//!
//! Policies. Values are interpolated; ages and directions come from those corners that have them. Directions have no sign:
//! they are turned to the side of the heaviest corner first.

use super::base::{BaseMesh, Transfer};
use crate::climate::{EARTH_RADIUS, EquirectMap};
use crate::crust::{Orogeny, Surface};
use crate::math;
use crate::overlay::relief::per_sample;
use bevy::math::Vec3;
use pangaea_shaders::amplify::fixed::GRAINS;

/// R in km of a young belt of subduction, of a young belt of collision, and of a worn one.
const SUBDUCTION: f32 = 3.0;
const COLLISION: f32 = 4.4;
const WORN: f32 = 0.85;

/// Age in My of belts that are worn down to hills.
const OLD: f32 = 200.0;

/// Most relief of a belt per mean elevation: its valleys end at the sea.
const RELIEF_OF_MEAN: f32 = 1.5;

/// Share of the relief that a plateau lacks.
const LEVELLED: f32 = 0.6;

/// Share of the relief that lies below the mean elevation.
const BELOW: f32 = 0.35;

/// Roughness of slopes in km per unit of steepness: the height that they gain within an edge.
const SLOPE_ROUGHNESS: f32 = 45.0;

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
    /// Elevation of the crust in km, negative under the sea.
    pub crust: EquirectMap,
    /// A: age of the last orogeny in My; without it, high ground counts as folded 100 My ago.
    pub age: Option<EquirectMap>,
    /// P: presence of plateaus, 0..=1.
    pub plateau: Option<EquirectMap>,
    /// B: presence of hills, 0..=1.
    pub hills: Option<EquirectMap>,
}

/// What is known of the crust at a vertex.
#[derive(Clone, Copy, Default)]
struct Crustal {
    elevation: f32,
    folded: f32,
    age: f32,
    collision: f32,
    oceanic: f32,
    ocean_age: f32,
    fold: Vec3,
    ridge: Vec3,
    /// Share of the noise between samples that is added: none to maps, which bring relief of their own.
    noise: f32,
}

impl Terrain {
    /// The terrain of a simulated planet.
    pub fn from_surface(base: &BaseMesh, transfer: &Transfer, surface: &Surface) -> Self {
        let crustal = per_sample(&base.mesh, |i| Crustal::between(surface, transfer.corners(i as usize)));
        Self::new(base, &crustal, None, None)
    }

    /// The terrain of a user's maps.
    pub fn from_maps(base: &BaseMesh, maps: &TerrainMaps) -> Self {
        let crustal = per_sample(&base.mesh, |i| {
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
        let given = |map: Option<&EquirectMap>, i: u32| map.map(|m| m.at(mesh.point(i)).clamp(0.0, 1.0));
        let forms: Vec<[f32; 4]> = per_sample(mesh, |i| {
            let own = &crustal[i as usize];
            let steepness = steepness(base, crustal, i);
            let plateau = given(plateau, i).unwrap_or_else(|| own.plateau(steepness, base.noise[i as usize]));
            let hills = given(hills, i).unwrap_or_else(|| own.hills() * (1.0 - plateau));
            let relief = own.relief(plateau);
            let ground = own.ground(relief, steepness, base.noise[i as usize]);
            [ground, own.elevation.max(ground) + (1.0 - BELOW) * relief, plateau, hills]
        });
        let column = |k: usize| forms.iter().map(|f| f[k]).collect::<Vec<f32>>();
        let grains = |k: usize| forms.iter().map(|f| to_grains(f[k])).collect::<Vec<i32>>();
        let of = |value: fn(&Crustal) -> f32| crustal.iter().map(value).collect::<Vec<f32>>();
        Self {
            ground: grains(0),
            crust: grains(1),
            plateau: column(2),
            hills: column(3),
            age: of(|c| if c.folded > 0.02 { c.age } else { f32::INFINITY }),
            collision: of(|c| c.collision),
            oceanic: of(|c| c.oceanic),
            ocean_age: of(|c| c.ocean_age),
            fold: crustal.iter().map(|c| c.fold).collect(),
            ridge: crustal.iter().map(|c| c.ridge).collect(),
        }
    }

    /// The base ground in km, as the climate sees it.
    pub fn elevation_km(&self) -> Vec<f32> {
        self.ground.iter().map(|&z| z as f32 / (1000.0 * GRAINS as f32)).collect()
    }
}

/// Grains of a height in km; what is not a number is at sea level.
pub fn to_grains(km: f32) -> i32 {
    (f64::from(km) * 1000.0 * f64::from(GRAINS)).round() as i32
}

impl Crustal {
    fn between(surface: &Surface, (corners, weights): ([usize; 3], [f32; 3])) -> Self {
        let crust = &surface.crust;
        let total =
            |value: &dyn Fn(usize) -> f32| (0..3).map(|k| weights[k] * value(corners[k])).sum::<f32>();
        let mean_of = |weight: &dyn Fn(usize) -> f32, value: &dyn Fn(usize) -> f32| {
            let sum = total(weight);
            if sum > 0.0 { total(&|i| weight(i) * value(i)) / sum } else { 0.0 }
        };
        let folded = |i: usize| f32::from(u8::from(crust.orogeny[i] != Orogeny::None));
        let oceanic = |i: usize| if crust.is_continental(i) { 0.0 } else { 1.0 };
        let axis = |vectors: &[Vec3]| {
            let heaviest = (0..3).max_by(|&a, &b| weights[a].total_cmp(&weights[b])).unwrap_or(0);
            let lead = vectors[corners[heaviest]];
            let sum: Vec3 = (0..3)
                .map(|k| {
                    let v = vectors[corners[k]];
                    weights[k] * if v.dot(lead) < 0.0 { -v } else { v }
                })
                .sum();
            sum.normalize_or_zero()
        };
        Self {
            elevation: total(&|i| surface.elevation(i)),
            folded: total(&folded),
            age: mean_of(&folded, &|i| crust.orogeny_age[i]),
            collision: mean_of(&folded, &|i| f32::from(u8::from(crust.orogeny[i] == Orogeny::Himalayan))),
            oceanic: total(&oceanic),
            ocean_age: mean_of(&oceanic, &|i| crust.ocean_age[i]),
            fold: axis(&crust.fold),
            ridge: axis(&crust.ridge),
            noise: 1.0,
        }
    }

    /// How much of a young belt's relief is left, 0..=1.
    fn youth(&self) -> f32 {
        1.0 - smooth(self.age / OLD)
    }

    /// R in km.
    fn relief(&self, plateau: f32) -> f32 {
        let z = self.elevation;
        let plain = 0.05 + 0.08 * z.clamp(0.0, 3.0);
        let young = SUBDUCTION + (COLLISION - SUBDUCTION) * self.collision;
        let belt = (WORN + (young - WORN) * self.youth()).min(RELIEF_OF_MEAN * z);
        let relief = plain + (belt - plain).max(0.0) * self.folded;
        relief * (1.0 - LEVELLED * plateau) * smooth((z + 0.3) / 0.4)
    }

    /// Base ground in km: valleys lie below the mean, and the noise of the base mesh makes them wind. On slopes it
    /// must be stronger, or rivers would run down side by side and never meet.
    fn ground(&self, relief: f32, steepness: f32, noise: f32) -> f32 {
        let z = self.elevation;
        let low = if z > 0.0 { (z - BELOW * relief).max(0.4 * z) } else { z };
        // Deep floor is the amplifier's alone.
        let rough = 0.06 + 0.2 * relief + SLOPE_ROUGHNESS * steepness.min(0.02);
        low + self.noise * noise * rough * smooth((z + 1.5) / 1.3)
    }

    /// P. Tibet and the Altiplano rise by less than 200 m in 100 km, the flanks of their belts by 1 to 4 km. Where the
    /// noise between samples is high a range crosses the plateau.
    fn plateau(&self, steepness: f32, noise: f32) -> f32 {
        let high = smooth((self.elevation - 1.8) / 1.6);
        let level = 1.0 - smooth((steepness - 0.002) / 0.008);
        let basin = 1.0 - smooth(self.noise * noise / 0.5);
        high * level * basin * self.folded * (0.3 + 0.7 * self.youth())
    }

    fn hills(&self) -> f32 {
        let z = self.elevation;
        let old = self.folded * (1.0 - self.youth()) * smooth(z / 0.3);
        let foreland = (1.0 - self.folded) * smooth((z - 0.25) / 0.5);
        (old + 0.7 * foreland).min(1.0)
    }
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

fn smooth(x: f32) -> f32 {
    math::smoothstep(f64::from(x)) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn belt(elevation: f32, age: f32, collision: f32) -> Crustal {
        Crustal { elevation, folded: 1.0, age, collision, ..Crustal::default() }
    }

    #[test]
    fn belts_differ_by_kind_and_age() {
        let himalaya = belt(4.5, 10.0, 1.0).relief(0.0);
        let andes = belt(3.5, 10.0, 0.0).relief(0.0);
        let old = belt(1.0, 300.0, 1.0).relief(0.0);
        let plain = Crustal { elevation: 0.2, ..Crustal::default() }.relief(0.0);
        // Largest relief within 10 km of measured tiles: Karakoram to Annapurna, Patagonia to the Andes of Chile, and no
        // more than the Appalachians.
        assert!((3.8..5.6).contains(&himalaya) && (2.6..4.0).contains(&andes), "{himalaya} {andes}");
        assert!((0.7..1.06).contains(&old) && plain < 0.1, "{old} {plain}");
        assert!(belt(4.5, 10.0, 1.0).relief(1.0) < 0.5 * himalaya);
        assert_eq!(belt(-4.0, 10.0, 1.0).relief(0.0), 0.0);
    }

    #[test]
    fn low_belts_keep_their_valleys_above_the_sea() {
        for age in [10.0, 100.0, 300.0] {
            for z in [0.05, 0.2, 0.5, 1.0, 2.0] {
                let low = belt(z, age, 1.0);
                let relief = low.relief(0.0);
                assert!(
                    relief <= 1.5 * z + 0.06 && low.ground(relief, 0.0, 0.0) > 0.0,
                    "{z} km, {age} My: {relief}"
                );
            }
        }
        // The Scottish Highlands: 0.54 km high in the mean.
        assert!(belt(0.54, 400.0, 1.0).relief(0.0) > 0.66);
    }

    #[test]
    fn plateaus_are_high_and_level_and_hills_are_old() {
        let high = Crustal { noise: 1.0, ..belt(4.5, 10.0, 1.0) };
        assert!(high.plateau(0.002, -0.1) > 0.9);
        assert_eq!(high.plateau(0.03, -0.1), 0.0);
        assert_eq!(high.plateau(0.002, 0.5), 0.0, "a range");
        assert_eq!(belt(0.5, 10.0, 1.0).plateau(0.0, 0.0), 0.0);
        assert!(belt(0.6, 400.0, 0.5).hills() > 0.9 && belt(3.0, 5.0, 0.5).hills() < 0.1);
    }

    #[test]
    fn maps_alone_make_a_terrain() {
        let base = BaseMesh::new(1, 0.05).unwrap();
        let crust = EquirectMap::from_fn(32, |lat, _| (lat / 20.0) as f32).unwrap();
        let ones = EquirectMap::from_fn(4, |_, _| 0.5).unwrap();
        let maps = TerrainMaps { crust, age: None, plateau: Some(ones), hills: None };
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
