//! The ground of a planet, amplified from its control mesh: the ground that players see, on the
//! CPU.
//!
//! Every answer has the bits of any other way to refine the ground there. Engines keep the patches
//! of their last question, so questions that lie close together are asked of the same one: a batch
//! is cut into runs, and each run has an engine to itself.

use super::check::{check_count, checked};
use super::error::GroundError;
use super::ground::{Ground, check_same_length};
use super::sample::{NormalStencil, Sample};
use super::surface::{ClimateSample, LAPSE_RATE_C_PER_M};
use crate::control::Bake;
use bevy::math::DVec3;
use pangaea_shaders::amplify::base::Base;
use pangaea_shaders::amplify::control::ControlMesh;
use pangaea_shaders::amplify::fixed::{GRAINS, ONE, Q16};
use pangaea_shaders::amplify::local::{Leaf, LocalGround};
use pangaea_shaders::amplify::locate::sides;
use pangaea_shaders::amplify::rules::Rules;
use pangaea_shaders::amplify::vertex::Vertex;
use rayon::prelude::*;
use std::sync::{Arc, Mutex};

/// Questions of a batch that one engine answers in a row: enough to profit from those that it
/// remembers.
const HEIGHTS_PER_RUN: usize = 512;

/// Vertices that all engines at rest may keep together: about 230 MB.
const MOST_AT_REST: usize = 400_000;

/// Height in m by which rules may leave the bounds of the control mesh: crests over summits, beds
/// under rivers, seamounts.
const RULES_MARGIN_M: f64 = 3000.0;

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
    /// ```
    /// use bevy::math::DVec3;
    /// use bevy_pangaea::query::{Ground, PlanetGround, Rules};
    /// use pangaea_shaders::amplify::synthetic::control_mesh;
    ///
    /// // A made-up planet of 1280 faces.
    /// let ground = PlanetGround::new(&control_mesh(6_370_000, 3, 7), Rules::default())?;
    /// let here = ground.sample(DVec3::new(0.4, 0.3, 0.8), 10)?;
    /// assert!(here.water_m >= here.height_m);
    /// # Ok::<(), bevy_pangaea::query::GroundError>(())
    /// ```
    ///
    /// # Errors
    /// [`GroundError::Unavailable`] if the control mesh is not whole.
    pub fn new(control: &ControlMesh, rules: Rules) -> Result<Self, GroundError> {
        let base =
            Base::new(control).map_err(|error| GroundError::Unavailable(error.to_string()))?;
        let vertices = control.vertices.iter();
        let lowest = vertices.clone().map(|v| v.height.min(v.bed)).min();
        let highest = vertices.map(|v| v.height.max(v.crust)).max();
        Ok(Self {
            base: Arc::new(base),
            rules,
            temperature: Arc::default(),
            bounds_m: [
                metres(lowest.unwrap_or(0)) - RULES_MARGIN_M,
                metres(highest.unwrap_or(0)) + RULES_MARGIN_M,
            ],
            engines: Mutex::default(),
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
        let what = "the number of temperatures";
        check_count(what, temperature.len(), [n, n])?;
        check_count(
            "the number of control vertices",
            control.vertices.len(),
            [n, n],
        )?;
        let vertices = temperature.iter().zip(&control.vertices);
        let at_sea_level = vertices.map(|(at_ground, vertex)| {
            let height_m = (vertex.height.max(0) / GRAINS) as f32;
            at_ground + LAPSE_RATE_C_PER_M * height_m
        });
        self.temperature = Arc::new(at_sea_level.collect());
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
        // The lock is held only to take and to put back: work goes on in parallel.
        // A poisoned lock costs only speed: a new engine gives the same answers.
        let resting = self.engines.lock().ok().and_then(|mut all| all.pop());
        let mut engine =
            resting.unwrap_or_else(|| LocalGround::new(self.base.clone(), &self.rules));
        let answer = work(&mut engine);
        // As many engines as threads may come to rest: one that has more than its share is dropped.
        let share = MOST_AT_REST / rayon::current_num_threads();
        if engine.lazy().len() <= share
            && let Ok(mut all) = self.engines.lock()
        {
            all.push(engine);
        }
        answer
    }

    /// Heights at as many directions, all from one engine.
    fn run(&self, directions: &[DVec3], level: u8, heights: &mut [f32]) -> Result<(), GroundError> {
        self.with_engine(|engine| heights_on(engine, directions, level, heights))
    }

    /// The climate at a unit direction, for a ground that is `height_m` above the sea.
    ///
    /// Climate has no finer detail than the control mesh, which is asked itself: an engine that was
    /// asked for level 0 would forget its way to the leaf of its last question.
    fn climate_at(&self, unit: DVec3, height_m: f32) -> ClimateSample {
        let at = quantised(unit);
        let face = self.base.locate(at, None);
        let corners = self.base.level.faces[face as usize].vertices;
        let vertices = corners.map(|v| &self.base.vertices[v as usize]);
        let weights = weights_in(vertices, at);
        let mean = |value: [f64; 3]| (0..3).map(|k| weights[k] * value[k]).sum::<f64>() as f32;
        let wetness = vertices.map(|v| f64::from(v.wetness) / f64::from(Q16));
        let mut climate = ClimateSample {
            wetness: mean(wetness),
            ..ClimateSample::of_latitude(unit.z, height_m)
        };
        if !self.temperature.is_empty() {
            let at_sea_level = mean(corners.map(|v| f64::from(self.temperature[v as usize])));
            climate.temperature_c = at_sea_level - LAPSE_RATE_C_PER_M * height_m.max(0.0);
        }
        climate
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
        check_same_length(directions, heights)?;
        if directions.len() <= HEIGHTS_PER_RUN {
            return self.run(directions, level, heights);
        }
        let runs = directions
            .par_chunks(HEIGHTS_PER_RUN)
            .zip(heights.par_chunks_mut(HEIGHTS_PER_RUN));
        // Collected first: which of several errors is told must not depend on the threads.
        let results: Vec<_> = runs
            .map(|(directions, heights)| self.run(directions, level, heights))
            .collect();
        results.into_iter().collect()
    }

    fn water(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        let at = quantised(checked(direction, level)?);
        let found = |engine: &mut Engine| engine.leaf_with_water(at, u32::from(level), None);
        let (leaf, water) = self.with_engine(found);
        Ok(water_m(&leaf, water, at))
    }

    fn climate(&self, direction: DVec3, height_m: f32) -> Result<ClimateSample, GroundError> {
        let unit = checked(direction, 0)?;
        Ok(self.climate_at(unit, height_m))
    }

    fn sample(&self, direction: DVec3, level: u8) -> Result<Sample, GroundError> {
        let up = checked(direction, level)?;
        // Single questions would make the unit direction a unit once more: so it has their bits.
        let unit = checked(up, level)?;
        let at = quantised(unit);
        let stencil = NormalStencil::new(unit, self.radius_m(), level)?;
        self.with_engine(|engine| {
            let (leaf, water) = engine.leaf_with_water(at, u32::from(level), None);
            let height_m = leaf.height_m(at) as f32;
            // The four neighbours lie in the leaf or beside it: the engine remembers the way.
            let mut heights = [0.0; 4];
            heights_on(engine, &stencil.around, level, &mut heights)?;
            Ok(Sample::new(
                up,
                height_m,
                water_m(&leaf, water, at),
                stencil.normal(heights),
                self.climate_at(unit, height_m),
            ))
        })
    }

    fn bounds_m(&self) -> [f64; 2] {
        self.bounds_m
    }
}

/// Heights at as many directions, one after the other.
fn heights_on(
    engine: &mut Engine,
    directions: &[DVec3],
    level: u8,
    heights: &mut [f32],
) -> Result<(), GroundError> {
    for (direction, height) in directions.iter().zip(heights) {
        let at = quantised(checked(*direction, level)?);
        *height = engine.leaf(at, u32::from(level), None).height_m(at) as f32;
    }
    Ok(())
}

/// Level of the water at a direction in a leaf in m; the height of the ground where it is dry.
fn water_m(leaf: &Leaf, water: Option<f64>, at: [i32; 3]) -> f32 {
    let ground = leaf.height_m(at) as f32;
    // Where 32 bits cannot tell the water's level from the ground, it is dry.
    water.map_or(ground, |level| (level as f32).max(ground))
}

/// Shares of the corners of a face of the control mesh at a direction in it, with the bits of
/// [`Leaf::weights`].
fn weights_in([a, b, c]: [&Vertex; 3], at: [i32; 3]) -> [f64; 3] {
    let [opposite_c, opposite_a, opposite_b] = sides(at, [a, b, c]).map(|side| side.max(0.0));
    let sum = opposite_c + opposite_a + opposite_b;
    if sum > 0.0 {
        [opposite_a / sum, opposite_b / sum, opposite_c / sum]
    } else {
        [1.0 / 3.0; 3]
    }
}

/// A unit vector in the integers of the amplifier.
pub(super) fn quantised(unit: DVec3) -> [i32; 3] {
    (unit * f64::from(ONE)).round().to_array().map(|x| x as i32)
}

fn metres(grains: i32) -> f64 {
    f64::from(grains) / f64::from(GRAINS)
}

#[cfg(test)]
#[path = "planet_tests.rs"]
mod tests;
