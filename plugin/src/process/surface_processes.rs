//! The sweep that ages, wears and floats all crust once per step (paper 000 §4.5).
//!
//! One pass over the columns applies, in this order, coherent noise, [`erosion`](super::erosion)
//! and isostatic adjustment to continents, and [`subsidence`](super::ocean_floor) to ocean floor.
//! *Arcs become land*: ocean crust above sea level turns continental, with an Andean orogeny of age
//! 0.
//!
//! Reads: crust. Writes: elevation, thickness, ages, kind, orogeny.

use crate::crust::isostasy::Isostasy;
use crate::crust::{Cause, Crust, CrustKind, Ledger, Orogeny};
use crate::math::{PI, sin_cos};
use crate::noise::Noise;
use crate::parallel::CHUNK;
use crate::params::TectonicParams;
use crate::planet::{GeologicClock, Lattice, Planet};
use crate::plate::terrane::TerraneCensus;
use crate::process::erosion::{adjustment, eroded, wear};
use crate::process::ocean_floor::Subsidence;
use crate::random::Purpose;
use crate::schedule::{CurrentPlanet, Stage, StepCursor, TectonicStep, TectonicSystems};
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use bevy::prelude::*;
use rayon::prelude::*;

/// Period in My over which the noise wanders through its two patterns: what it raises it lowers
/// again.
pub const NOISE_PERIOD: f64 = 160.0;

/// Samples whose noise is evaluated between two looks at the clock.
const PER_SLICE: usize = 8 * CHUNK;

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

/// Two patterns of low-frequency coherent noise, one value per sample; they depend on seed and
/// wavelength only.
#[derive(Component, Clone, Debug, Default)]
pub struct ReliefNoise {
    wavelength: f64,
    patterns: [Vec<f32>; 2],
}

impl ReliefNoise {
    /// Evaluates the patterns, unless they are there already. Ends early where it should `stop`;
    /// called again it goes on. Returns whether they are complete.
    pub fn prepare(
        &mut self,
        mesh: &SphereMesh,
        planet: &Planet,
        wavelength: f64,
        stop: impl Fn() -> bool,
    ) -> bool {
        if self.wavelength != wavelength || self.patterns[0].len() > mesh.len() {
            *self = Self {
                wavelength,
                ..default()
            };
        }
        let frequency = planet.radius / wavelength;
        let noise = [0, 1].map(|id| Noise::new(planet.seed, Purpose::Relief, id));
        while self.patterns[1].len() < mesh.len() {
            let start = self.patterns[1].len();
            let points = &mesh.points()[start..(start + PER_SLICE).min(mesh.len())];
            for (noise, pattern) in noise.iter().zip(&mut self.patterns) {
                let value = |&p: &DVec3| noise.fractal(p, frequency, 3) as f32;
                pattern.par_extend(points.par_iter().with_min_len(CHUNK).map(value));
            }
            // Each call does some of the work, or one that is late would never end.
            if stop() && self.patterns[1].len() < mesh.len() {
                return false;
            }
        }
        true
    }
}

/// Wears, sinks and ages the crust of the current planet.
pub fn surface_processes(
    current: Res<CurrentPlanet>,
    mut planets: Query<(
        (&Planet, &Lattice, &TectonicParams, &GeologicClock),
        (&mut Crust, &mut Ledger, &mut TerraneCensus),
        (&mut ReliefNoise, &mut StepCursor),
    )>,
) {
    let Ok((input, (mut crust, mut ledger, mut census), (mut noise, mut cursor))) =
        planets.get_mut(current.0)
    else {
        return;
    };
    let (planet, lattice, params, clock) = input;
    let wavelength = params.noise_wavelength;
    if params.processes.noise
        && !noise.prepare(lattice, planet, wavelength, || cursor.out_of_time())
    {
        cursor.hold();
        return;
    }
    let booked = sweep(
        lattice,
        &mut crust,
        &noise,
        &ReliefLaw::new(params, clock.time),
    );
    if booked.arc_area > 0.0 {
        census.stale = true;
    }
    let square = planet.radius * planet.radius;
    ledger.book(
        Cause::ArcGrowth,
        booked.arc_area * square,
        booked.arc_volume * square,
    );
    ledger.book(Cause::Erosion, 0.0, booked.erosion * square);
    ledger.book(Cause::Noise, 0.0, booked.noise * square);
}

/// What a sweep changed on continents, per square of the radius.
#[derive(Clone, Copy, Debug, Default)]
struct Booked {
    arc_area: f64,
    arc_volume: f64,
    erosion: f64,
    noise: f64,
}

/// Everything that a sweep needs to know, for one time.
struct ReliefLaw {
    dt: f32,
    /// Share of its elevation that land loses.
    wear: Option<f32>,
    adjustment: f32,
    isostasy: Isostasy,
    subsidence: Subsidence,
    /// Highest continental elevation in km.
    ceiling: f32,
    /// Weights of the two noise patterns in km.
    noise: [f32; 2],
}

impl ReliefLaw {
    fn new(params: &TectonicParams, time: f64) -> Self {
        let (s, c) = sin_cos(2.0 * PI * time / NOISE_PERIOD);
        let amplitude = if params.processes.noise {
            params.noise_amplitude * params.time_step
        } else {
            0.0
        };
        Self {
            dt: params.time_step as f32,
            wear: params.processes.erosion.then(|| wear(params)),
            adjustment: adjustment(params),
            isostasy: Isostasy::new(params),
            subsidence: Subsidence::new(params),
            ceiling: params.summit_elevation as f32,
            noise: [(amplitude * c) as f32, (amplitude * s) as f32],
        }
    }
}

fn sweep(mesh: &SphereMesh, crust: &mut Crust, noise: &ReliefNoise, law: &ReliefLaw) -> Booked {
    let silent = law.noise == [0.0; 2];
    let parts: Vec<Booked> = (
        crust.kind.par_chunks_mut(CHUNK),
        crust.elevation.par_chunks_mut(CHUNK),
        crust.thickness.par_chunks_mut(CHUNK),
        crust.ocean_age.par_chunks_mut(CHUNK),
        crust.orogeny.par_chunks_mut(CHUNK),
        crust.orogeny_age.par_chunks_mut(CHUNK),
    )
        .into_par_iter()
        .enumerate()
        .map(
            |(chunk, (kind, elevation, thickness, ocean_age, orogeny, orogeny_age))| {
                let mut booked = Booked::default();
                let start = chunk * CHUNK;
                let areas = &mesh.areas()[start..start + kind.len()];
                let patterns = noise
                    .patterns
                    .each_ref()
                    .map(|p| p.get(start..start + kind.len()));
                for k in 0..kind.len() {
                    let area = areas[k];
                    let (z, e) = (&mut elevation[k], &mut thickness[k]);
                    orogeny_age[k] += law.dt;
                    if kind[k] == CrustKind::Continental {
                        let wave = match patterns {
                            [Some(a), Some(b)] if !silent => {
                                law.noise[0] * a[k] + law.noise[1] * b[k]
                            }
                            _ => 0.0,
                        };
                        law.continent(z, e, wave, area, &mut booked);
                    } else {
                        ocean_age[k] += law.dt;
                        *z = law.subsidence.step(*z, law.isostasy.elevation(*e));
                        if *z > 0.0 {
                            kind[k] = CrustKind::Continental;
                            orogeny[k] = Orogeny::Andean;
                            orogeny_age[k] = 0.0;
                            booked.arc_area += area;
                            booked.arc_volume += f64::from(*e) * area;
                        }
                    }
                }
                booked
            },
        )
        .collect();
    parts
        .into_iter()
        .fold(Booked::default(), |sum, part| Booked {
            arc_area: sum.arc_area + part.arc_area,
            arc_volume: sum.arc_volume + part.arc_volume,
            erosion: sum.erosion + part.erosion,
            noise: sum.noise + part.noise,
        })
}

impl ReliefLaw {
    /// One step of continental crust.
    #[inline]
    fn continent(&self, z: &mut f32, e: &mut f32, wave: f32, area: f64, booked: &mut Booked) {
        let before = *e;
        *e += self.isostasy.thickening(*z, wave);
        *z += wave;
        let noisy = *e;
        if let Some(wear) = self.wear {
            let lost = eroded(wear, *z);
            *e += self.isostasy.thickening(*z, -lost);
            *z -= lost;
        }
        booked.noise += f64::from(noisy - before) * area;
        booked.erosion += f64::from(*e - noisy) * area;
        *z += (self.isostasy.elevation(*e) - *z) * self.adjustment;
        *z = z.min(self.ceiling);
    }
}
