//! The sweep that ages, wears and floats all crust once per step (paper 000 §4.5).
//!
//! One pass over the columns applies, in this order, [coherent noise](super::relief_noise),
//! [`erosion`](super::erosion) and isostatic adjustment to continents, and
//! [`subsidence`](super::ocean_floor) to ocean floor. *Arcs become land*: ocean crust above sea
//! level turns continental, with an Andean orogeny of age 0.

use super::erosion::{adjustment, eroded, wear};
use super::ocean_floor::Subsidence;
use super::relief_noise::{self, ReliefNoise};
use crate::crust::isostasy::Isostasy;
use crate::crust::{Cause, Crust, CrustChunk, CrustKind, Ledger, Orogeny};
use crate::params::TectonicParams;
use crate::planet::GeologicClock;
use crate::plate::census::TerraneCensus;
use crate::schedule::{CurrentPlanet, Stage, StepCursor, TectonicStep, TectonicSystems};
use crate::sphere::SphereMesh;
use crate::view::PlanetQuery;
use bevy::prelude::*;
use rayon::prelude::*;

/// Adds [`surface_processes`] to the step.
pub struct SurfaceProcessesPlugin;

impl Plugin for SurfaceProcessesPlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(
            TectonicStep,
            surface_processes.in_set(TectonicSystems::Process(Stage::SurfaceProcesses)),
        );
    }
}

/// Wears, sinks and ages the crust of the current planet.
pub fn surface_processes(
    current: Res<CurrentPlanet>,
    mut planets: Query<(
        (PlanetQuery, &GeologicClock),
        (&mut Crust, &mut Ledger, &mut TerraneCensus),
        (&mut ReliefNoise, &mut StepCursor),
    )>,
) {
    let Ok((state, (mut crust, mut ledger, mut census), (mut noise, mut cursor))) =
        planets.get_mut(current.0)
    else {
        return;
    };
    let (planet, clock) = state;
    let view = planet.view();
    if view.params.processes.noise && !noise.prepare(&view, || cursor.out_of_time()) {
        cursor.hold();
        return;
    }
    let law = SurfaceLaw::new(view.params, clock.time);
    let changes = sweep(view.mesh, &mut crust, &noise, &law);
    census.grown.extend(&changes.arcs);
    changes.book(&mut ledger, view.square());
}

/// Changes of a sweep on continents, per square of the radius.
#[derive(Clone, Debug, Default)]
struct Changes {
    /// Samples of ocean crust that became land, in order.
    arcs: Vec<u32>,
    /// Steradians of ocean crust that became land.
    arc_area: f64,
    /// Its volume; all volumes are in km times steradians.
    arc_volume: f64,
    /// Volume that eroded, negative.
    erosion: f64,
    /// Volume that the noise added or took.
    noise: f64,
}

impl Changes {
    fn plus(mut self, other: Self) -> Self {
        self.arcs.extend(other.arcs);
        Self {
            arcs: self.arcs,
            arc_area: self.arc_area + other.arc_area,
            arc_volume: self.arc_volume + other.arc_volume,
            erosion: self.erosion + other.erosion,
            noise: self.noise + other.noise,
        }
    }

    /// `square` is the square of the planet's radius in km.
    fn book(&self, ledger: &mut Ledger, square: f64) {
        let arcs = (self.arc_area * square, self.arc_volume * square);
        ledger.book(Cause::ArcGrowth, arcs.0, arcs.1);
        ledger.book(Cause::Erosion, 0.0, self.erosion * square);
        ledger.book(Cause::Noise, 0.0, self.noise * square);
    }
}

/// Everything that a sweep needs to know, for one time.
struct SurfaceLaw {
    /// Time step in My.
    dt: f32,
    /// Share of its elevation that land loses; `None` where nothing erodes.
    wear: Option<f32>,
    /// Share of the distance to balance that is made good.
    adjustment: f32,
    isostasy: Isostasy,
    subsidence: Subsidence,
    /// Highest continental elevation in km.
    ceiling: f32,
    /// Weights of the two noise patterns in km.
    noise: [f32; 2],
}

impl SurfaceLaw {
    fn new(params: &TectonicParams, time: f64) -> Self {
        Self {
            dt: params.time_step as f32,
            wear: params.processes.erosion.then(|| wear(params)),
            adjustment: adjustment(params),
            isostasy: Isostasy::new(params),
            subsidence: Subsidence::new(params),
            ceiling: params.summit_elevation as f32,
            noise: relief_noise::weights(params, time),
        }
    }

    /// Moves the elevation `z` and thickness `e` in km of continental crust on by one step. The
    /// noise raises it by `wave` km; `area` is in steradians.
    #[inline]
    fn continent(&self, z: &mut f32, e: &mut f32, wave: f32, area: f64, changes: &mut Changes) {
        let before = *e;
        *e += self.isostasy.thickening(*z, wave);
        *z += wave;
        let after_noise = *e;
        if let Some(wear) = self.wear {
            let lost = eroded(wear, *z);
            *e += self.isostasy.thickening(*z, -lost);
            *z -= lost;
        }
        changes.noise += f64::from(after_noise - before) * area;
        changes.erosion += f64::from(*e - after_noise) * area;
        // Noise and erosion took the thickness along; floating moves the elevation alone.
        *z += (self.isostasy.elevation(*e) - *z) * self.adjustment;
        *z = z.min(self.ceiling);
    }

    /// Moves ocean floor on by one step; `true` if it rose above the sea.
    #[inline]
    fn ocean_floor(&self, chunk: &mut CrustChunk, k: usize) -> bool {
        chunk.ocean_age[k] += self.dt;
        let balance = self.isostasy.elevation(chunk.thickness[k]);
        chunk.elevation[k] = self.subsidence.step(chunk.elevation[k], balance);
        chunk.elevation[k] > 0.0
    }
}

fn sweep(mesh: &SphereMesh, crust: &mut Crust, noise: &ReliefNoise, law: &SurfaceLaw) -> Changes {
    let n = crust.len();
    let parts: Vec<Changes> = crust
        .chunks_mut(0..n)
        .into_par_iter()
        .map(|chunk| sweep_chunk(mesh, chunk, noise, law))
        .collect();
    parts.into_iter().fold(Changes::default(), Changes::plus)
}

fn sweep_chunk(
    mesh: &SphereMesh,
    mut chunk: CrustChunk,
    noise: &ReliefNoise,
    law: &SurfaceLaw,
) -> Changes {
    let mut changes = Changes::default();
    let samples = chunk.start..chunk.start + chunk.kind.len();
    let areas = &mesh.areas()[samples.clone()];
    let silent = law.noise == [0.0; 2];
    // Switched off, the patterns were not prepared, or are of another wavelength.
    let patterns = noise.patterns(samples).filter(|_| !silent);
    for (k, &area) in areas.iter().enumerate() {
        chunk.orogeny_age[k] += law.dt;
        if chunk.kind[k] == CrustKind::Continental {
            let wave = patterns.map_or(0.0, |[a, b]| law.noise[0] * a[k] + law.noise[1] * b[k]);
            let (z, e) = (&mut chunk.elevation[k], &mut chunk.thickness[k]);
            law.continent(z, e, wave, area, &mut changes);
        } else if law.ocean_floor(&mut chunk, k) {
            become_land(&mut chunk, k);
            changes.arcs.push((chunk.start + k) as u32);
            changes.arc_area += area;
            changes.arc_volume += f64::from(chunk.thickness[k]) * area;
        }
    }
    changes
}

/// Makes the chunk's sample `k` the land of a young arc.
fn become_land(chunk: &mut CrustChunk, k: usize) {
    chunk.kind[k] = CrustKind::Continental;
    chunk.orogeny[k] = Orogeny::Andean;
    chunk.orogeny_age[k] = 0.0;
}
