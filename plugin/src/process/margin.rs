//! Passive margins: sediment from the land fills the floor beside it up to a slope (paper 000 §4.5,
//! sediment accretion; the paper names passive margins as missing, §7.5).
//!
//! ```text
//! z' = min(z + eps_t dt, max over neighbours j of z_j - s |p - p_j|)    where that exceeds z
//! ```
//!
//! s is the slope that falls from the sea to the abyss within the margin's width. Subsidence works
//! against it, so a margin far from any land disappears again. Slopes change slowly: every
//! [`STEPS_BETWEEN_FILLINGS`] steps are enough.

use crate::crust::Crust;
use crate::parallel;
use crate::params::TectonicParams;
use crate::planet::GeologicClock;
use crate::schedule::{CurrentPlanet, Stage, StepCursor, TectonicStep, TectonicSystems};
use crate::sphere::SphereMesh;
use crate::view::PlanetQuery;
use bevy::prelude::*;

/// Steps between two fillings.
pub const STEPS_BETWEEN_FILLINGS: u64 = 4;

/// Adds [`margin`] to the step.
pub struct MarginPlugin;

impl Plugin for MarginPlugin {
    fn build(&self, app: &mut App) {
        let set = TectonicSystems::Process(Stage::SurfaceProcesses);
        app.add_systems(
            TectonicStep,
            margin
                .in_set(set)
                .after(super::surface_processes::surface_processes),
        );
    }
}

/// Fills the margins of the current planet.
pub fn margin(
    current: Res<CurrentPlanet>,
    mut planets: Query<(PlanetQuery, &GeologicClock, &StepCursor, &mut Crust)>,
) {
    let Ok((planet, clock, cursor, mut crust)) = planets.get_mut(current.0) else {
        return;
    };
    let view = planet.view();
    // A stage that holds runs this system in each of its time slices; the crust is filled in the
    // last.
    let due = !cursor.is_held() && clock.step.is_multiple_of(STEPS_BETWEEN_FILLINGS);
    if view.params.processes.sediment && due && view.params.margin_width > 0.0 {
        fill(view.mesh, &mut crust, view.params, view.radius);
    }
}

/// Fills what lies below the slope of its neighbours, as much as [`STEPS_BETWEEN_FILLINGS`] steps
/// allow.
fn fill(mesh: &SphereMesh, crust: &mut Crust, params: &TectonicParams, radius: f64) {
    let slope = -params.abyss_elevation / params.margin_width;
    // Neighbours are taken to be a spacing apart.
    let drop = (slope * mesh.spacing() * radius) as f32;
    let most = (params.sediment * params.time_step * STEPS_BETWEEN_FILLINGS as f64) as f32;
    let raised = |i: usize| Some((i, raised(mesh, crust, i, drop, most)?));
    // All rises are found before one is written: the order of samples decides nothing.
    let filled = parallel::map_chunks(crust.len(), |range| {
        range.filter_map(raised).collect::<Vec<_>>()
    });
    for (i, z) in filled.into_iter().flatten() {
        crust.elevation[i] = z;
    }
}

/// Elevation in km of sample `i` once sediment has raised it up to `drop` km below its highest
/// neighbour, by at most `most` km; `None` for continents, and where it lies as high already.
fn raised(mesh: &SphereMesh, crust: &Crust, i: usize, drop: f32, most: f32) -> Option<f32> {
    let z = crust.elevation[i];
    let target = highest_neighbour(mesh, crust, i) - drop;
    (!crust.is_continental(i) && z < target).then(|| z + (target - z).min(most))
}

/// Elevation in km of the highest neighbour on the same frame, at most sea level: sediment lies
/// below the sea.
fn highest_neighbour(mesh: &SphereMesh, crust: &Crust, i: usize) -> f32 {
    let own = crust.frame[i];
    let neighbours = mesh.ring(i as u32).iter().map(|&j| j as usize);
    neighbours
        .filter(|&j| crust.frame[j] == own)
        .map(|j| crust.elevation[j].min(0.0))
        .fold(f32::NEG_INFINITY, f32::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crust::CrustKind;

    #[test]
    fn a_cliff_becomes_a_slope_and_the_far_floor_stays() {
        let params = TectonicParams::default();
        let mesh = SphereMesh::fibonacci(20_000).unwrap();
        let mut crust = Crust::ocean(mesh.len(), &params);
        for i in 0..mesh.len() {
            if mesh.points()[i].z > 0.0 {
                crust.kind[i] = CrustKind::Continental;
                crust.elevation[i] = 0.5;
            }
        }
        for _ in 0..20 {
            fill(&mesh, &mut crust, &params, 6370.0);
        }
        let drop = (6.0 / params.margin_width * mesh.spacing() * 6370.0) as f32;
        for i in 0..mesh.len() {
            let z = mesh.points()[i].z;
            let beside = mesh.ring(i as u32).iter().any(|&j| mesh.point(j).z > 0.0);
            if z <= 0.0 && beside {
                assert!((crust.elevation[i] + drop).abs() < 1e-4);
            } else if z < -0.1 {
                assert_eq!(crust.elevation[i], -6.0);
            }
        }
    }
}
