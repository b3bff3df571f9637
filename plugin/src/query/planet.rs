//! The ground of a planet, amplified from its control mesh: what the player sees, on the CPU.
//!
//! Every answer has the bits of any other way to refine the ground there (DESIGN: twins). Engines
//! keep the patches of their last question, so questions that lie close together are asked of the
//! same one: a batch is cut into runs, and each run has an engine to itself.

use super::ground::same_length;
use super::{Climate, Ground, GroundError, LAPSE, checked};
use crate::control::Bake;
use bevy::math::DVec3;
use pangaea_shaders::amplify::base::Base;
use pangaea_shaders::amplify::control::{ControlMesh, ControlVertex};
use pangaea_shaders::amplify::fixed::{GRAINS, ONE};
use pangaea_shaders::amplify::local::{Leaf, LocalGround};
use pangaea_shaders::amplify::rules::Rules;
use rayon::prelude::*;
use std::sync::{Arc, Mutex};

/// Questions of a batch that one engine answers in a row: enough to profit from what it remembers.
const RUN: usize = 512;

type Engine = LocalGround<Arc<Base>>;

/// The amplified ground of one planet. Cheap to clone; clones share the control mesh.
#[derive(Debug)]
pub struct PlanetGround {
    base: Arc<Base>,
    rules: Rules,
    /// Temperature at sea level in °C per control vertex; empty where only the latitude is known.
    temperature: Arc<Vec<f32>>,
    bounds_m: [f64; 2],
    /// Engines at rest.
    engines: Mutex<Vec<Engine>>,
}

impl PlanetGround {
    /// The ground that `rules` grow from `control`.
    ///
    /// # Errors
    /// [`GroundError::Unavailable`] if the control mesh is not whole.
    pub fn new(control: &ControlMesh, rules: Rules) -> Result<Self, GroundError> {
        let base =
            Base::new(control).map_err(|error| GroundError::Unavailable(error.to_string()))?;
        let metres = |grains: i32| f64::from(grains) / f64::from(GRAINS);
        let lowest = control
            .vertices
            .iter()
            .map(|v| v.height.min(v.bed))
            .min()
            .unwrap_or(0);
        let highest = control
            .vertices
            .iter()
            .map(|v| v.height.max(v.crust))
            .max()
            .unwrap_or(0);
        // Rules add to what the control mesh says: crests over summits, beds under rivers,
        // seamounts.
        let bounds_m = [metres(lowest) - 3000.0, metres(highest) + 3000.0];
        let (temperature, engines) = (Arc::default(), Mutex::default());
        Ok(Self {
            base: Arc::new(base),
            rules,
            temperature,
            bounds_m,
            engines,
        })
    }

    /// The ground of a baked planet, with its climate.
    ///
    /// # Errors
    /// [`GroundError::Unavailable`] if there is no ground for a planet of that radius.
    pub fn of_bake(bake: &Bake, rules: Rules) -> Result<Self, GroundError> {
        Self::new(&bake.control, rules)?.with_temperature(&bake.control, &bake.climate.temperature)
    }

    /// The same with the temperature at the ground in °C of every vertex of its `control` mesh,
    /// from which that of all other heights follows.
    ///
    /// # Errors
    /// [`GroundError::Count`] if there is not one temperature per vertex.
    pub fn with_temperature(
        mut self,
        control: &ControlMesh,
        temperature: &[f32],
    ) -> Result<Self, GroundError> {
        let n = self.base.vertices.len();
        if temperature.len() != n || control.vertices.len() != n {
            let what = "the number of temperatures";
            return Err(GroundError::Count {
                what,
                value: temperature.len(),
                min: n,
                max: n,
            });
        }
        let at_sea_level =
            |(t, v): (&f32, &ControlVertex)| t + LAPSE * (v.height.max(0) / GRAINS) as f32;
        self.temperature = Arc::new(
            temperature
                .iter()
                .zip(&control.vertices)
                .map(at_sea_level)
                .collect(),
        );
        Ok(self)
    }

    /// Level 0 of the ground.
    pub fn base(&self) -> &Arc<Base> {
        &self.base
    }

    /// The rules that grow it.
    pub fn rules(&self) -> &Rules {
        &self.rules
    }

    /// The triangle of a level that contains a direction, with all that its corners know.
    ///
    /// # Errors
    /// [`GroundError::NotADirection`], [`GroundError::Level`].
    pub fn leaf(&self, direction: DVec3, level: u8) -> Result<Leaf, GroundError> {
        Ok(self.leaf_at(quantised(checked(direction, level)?), level))
    }

    /// The same at a direction that was checked.
    pub(super) fn leaf_at(&self, at: [i32; 3], level: u8) -> Leaf {
        self.with_engine(|engine| engine.leaf(at, u32::from(level), None))
    }

    /// Lends an engine at rest, or a new one.
    fn with_engine<T>(&self, work: impl FnOnce(&mut Engine) -> T) -> T {
        let resting =
            |engines: &Mutex<Vec<Engine>>| engines.lock().ok().and_then(|mut all| all.pop());
        let mut engine = resting(&self.engines)
            .unwrap_or_else(|| LocalGround::new(self.base.clone(), &self.rules));
        let answer = work(&mut engine);
        if let Ok(mut all) = self.engines.lock() {
            all.push(engine);
        }
        answer
    }
}

impl Clone for PlanetGround {
    fn clone(&self) -> Self {
        Self {
            base: self.base.clone(),
            rules: self.rules,
            temperature: self.temperature.clone(),
            bounds_m: self.bounds_m,
            engines: Mutex::default(),
        }
    }
}

/// A unit vector in the integers of the amplifier.
pub(super) fn quantised(unit: DVec3) -> [i32; 3] {
    (unit * f64::from(ONE)).round().to_array().map(|x| x as i32)
}

impl Ground for PlanetGround {
    fn radius_m(&self) -> f64 {
        f64::from(self.base.scale.radius_m)
    }

    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        let mut height = [0.0];
        self.heights(&[direction], level, &mut height)?;
        Ok(height[0])
    }

    fn heights(
        &self,
        directions: &[DVec3],
        level: u8,
        heights: &mut [f32],
    ) -> Result<(), GroundError> {
        same_length(directions, heights)?;
        let run = |directions: &[DVec3], heights: &mut [f32]| {
            self.with_engine(|engine| {
                for (direction, height) in directions.iter().zip(heights) {
                    let at = quantised(checked(*direction, level)?);
                    *height = engine.leaf(at, u32::from(level), None).height_m(at) as f32;
                }
                Ok(())
            })
        };
        if directions.len() <= RUN {
            return run(directions, heights);
        }
        let runs = directions.par_chunks(RUN).zip(heights.par_chunks_mut(RUN));
        let results: Vec<_> = runs
            .map(|(directions, heights)| run(directions, heights))
            .collect();
        results.into_iter().collect()
    }

    fn water(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        let at = quantised(checked(direction, level)?);
        let leaf = self.leaf_at(at, level);
        Ok(water_m(&leaf, at).max(leaf.height_m(at)) as f32)
    }

    fn climate(&self, direction: DVec3, height_m: f32) -> Result<Climate, GroundError> {
        let unit = checked(direction, 0)?;
        let at = quantised(unit);
        let leaf = self.leaf_at(at, 0);
        let weights = leaf.weights(at);
        let mean = |value: [f64; 3]| (0..3).map(|k| weights[k] * value[k]).sum::<f64>() as f32;
        let wetness = mean(leaf.vertices.map(|v| f64::from(v.wetness) / 65_536.0));
        let corners = self.base.level.faces[leaf.base_face as usize].vertices;
        let mut climate = Climate {
            wetness,
            ..Climate::of_latitude(unit.z, height_m)
        };
        if !self.temperature.is_empty() {
            let sea_level = mean(corners.map(|v| f64::from(self.temperature[v as usize])));
            climate.temperature_c = sea_level - LAPSE * height_m.max(0.0);
        }
        Ok(climate)
    }

    fn bounds_m(&self) -> [f64; 2] {
        self.bounds_m
    }
}

/// Level of the water at a direction in a leaf in m: below the ground where it is dry.
fn water_m(leaf: &Leaf, at: [i32; 3]) -> f64 {
    let weights = leaf.weights(at);
    let sum: f64 = (0..3)
        .map(|k| weights[k] * f64::from(leaf.carved[k].water))
        .sum();
    sum / f64::from(GRAINS)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::query::sample;
    use crate::random::{Purpose, Stream};
    use pangaea_shaders::amplify::synthetic::control_mesh;

    fn ground() -> PlanetGround {
        PlanetGround::new(&control_mesh(6_370_000, 3, 7), Rules::default()).unwrap()
    }

    fn directions(n: u64) -> Vec<DVec3> {
        let stream = Stream::new(1, Purpose::ReliefSites, 0);
        (0..n).map(|i| stream.direction(2 * i)).collect()
    }

    #[test]
    fn a_batch_has_the_bits_of_single_questions_in_any_order() {
        let (batch, single) = (ground(), ground());
        let directions = directions(1500);
        let mut heights = vec![0.0; directions.len()];
        batch.heights(&directions, 6, &mut heights).unwrap();
        for (direction, height) in directions.iter().zip(&heights).rev().step_by(7) {
            assert_eq!(
                single.height(*direction * 3.5, 6).unwrap().to_bits(),
                height.to_bits()
            );
        }
        assert_eq!(
            single.clone().height(directions[0], 6),
            batch.height(directions[0], 6)
        );
    }

    #[test]
    fn water_is_never_below_the_ground_and_the_ground_is_within_its_bounds() {
        let ground = ground();
        let [low, high] = ground.bounds_m();
        for direction in directions(300) {
            let here = sample(&ground, direction, 9).unwrap();
            assert!(here.water_m >= here.height_m);
            assert!(
                (low..=high).contains(&f64::from(here.height_m)),
                "{} m",
                here.height_m
            );
            assert!(here.normal.dot(direction) > 0.0);
        }
    }

    #[test]
    fn fine_levels_refine_what_coarse_ones_say() {
        let ground = ground();
        for direction in directions(40) {
            let [coarse, fine, finest] =
                [12, 15, 17].map(|level| ground.height(direction, level).unwrap());
            // Triangles of 13 m and of 0.4 m on the same slope.
            assert!(
                (coarse - fine).abs() < 30.0 && (fine - finest).abs() < 5.0,
                "{coarse} {fine} {finest}"
            );
        }
    }

    #[test]
    fn temperature_follows_height_from_what_the_control_mesh_has() {
        let control = control_mesh(6_370_000, 3, 7);
        let heights = control
            .vertices
            .iter()
            .map(|v| (v.height.max(0) / GRAINS) as f32);
        let temperature: Vec<f32> = heights.map(|height| 20.0 - LAPSE * height).collect();
        let ground = ground().with_temperature(&control, &temperature).unwrap();
        for direction in directions(20) {
            let found = ground.climate(direction, 1000.0).unwrap();
            assert!(
                (found.temperature_c - 13.5).abs() < 1e-3 && (0.0..=1.0).contains(&found.wetness)
            );
        }
        assert!(matches!(
            ground.with_temperature(&control, &temperature[1..]),
            Err(GroundError::Count { .. })
        ));
    }

    #[test]
    fn a_collider_is_the_ground_and_covers_its_square() {
        let ground = ground();
        for (direction, side, level) in [
            (DVec3::X, 300.0, 17),
            (DVec3::new(0.3, -0.2, 0.9), 40_000.0, 10),
        ] {
            let patch = ground.collider(direction, side, level).unwrap();
            // The test's control mesh is some sixteen times coarser than a planet's.
            assert!(
                patch.triangles.len() > 100,
                "{} triangles",
                patch.triangles.len()
            );
            let mut area = 0.0;
            for triangle in &patch.triangles {
                let [a, b, c] =
                    triangle.map(|i| patch.origin + patch.positions[i as usize].as_dvec3());
                let normal = (b - a).cross(c - a);
                area += 0.5 * normal.dot(direction.normalize());
                assert!(normal.dot(a) > 0.0, "a face is flipped");
                let middle = (a + b + c) / 3.0;
                let height = f64::from(ground.height(middle, level).unwrap());
                let error = middle.length() - 6_370_000.0 - height;
                // A flat triangle sinks below the ball by its edge squared over twice the radius; 5
                // mm are those of f32.
                let edge = (b - a).length().max((c - b).length()).max((a - c).length());
                let sag = edge * edge / (2.0 * 6_370_000.0);
                assert!(
                    error.abs() < sag + 0.005,
                    "{error} m beside an edge of {edge} m"
                );
            }
            assert!(
                area > side * side,
                "{area} m² in triangles for a square of {side} m"
            );
        }
        assert!(matches!(
            ground.collider(DVec3::X, 1e6, 17),
            Err(GroundError::Length { .. })
        ));
        assert!(matches!(
            ground.collider(DVec3::X, f64::NAN, 17),
            Err(GroundError::Length { .. })
        ));
    }

    #[test]
    fn bad_questions_and_meshes_are_errors() {
        let ground = ground();
        assert_eq!(ground.height(DVec3::X, 18), Err(GroundError::Level(18)));
        assert_eq!(
            ground.heights(&[DVec3::X, DVec3::NAN], 3, &mut [0.0; 2]),
            Err(GroundError::NotADirection)
        );
        let mut broken = control_mesh(6_370_000, 2, 7);
        broken.faces.pop();
        assert!(matches!(
            PlanetGround::new(&broken, Rules::default()),
            Err(GroundError::Unavailable(_))
        ));
        let none = ControlMesh {
            radius_m: 0,
            ..broken
        };
        assert!(matches!(
            PlanetGround::new(&none, Rules::default()),
            Err(GroundError::Unavailable(_))
        ));
    }
}
