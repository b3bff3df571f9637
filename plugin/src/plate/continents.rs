//! Initial crust: continents with shelves and old worn belts, and an ocean floor that knows its
//! age.
//!
//! ```text
//! lobes      which plates carry continents, and discs that make their rough shapes
//! field      "continentality" of every sample: distance into the lobes, with fractal noise
//! land       the level of the field that gives the wanted share of land; no specks, no puddles
//! distance   distance to the coast, and to the ridges
//! relief     profile from the interior over coast and shelf to the abyss; old belts
//! seafloor   age and ridge direction of the ocean floor
//! ```
//!
//! Papers 000 and 004 raise whole plates to one height, which leaves cliffs and an active margin on
//! every side. Here continents sit on some plates, cross some borders, and have passive margins.
//!
//! Policies:
//! - Land share is met to a fraction of a sample, unless discs are given: they say what is land.
//! - Continental crust reaches below the sea until it covers [`CONTINENTAL_PER_LAND`] times the
//!   land.
//! - Distances are in km, but shrink with planets smaller than Earth, and are never so short that
//!   samples could not show them.

mod distance;
mod field;
mod heights;
mod land;
mod lobes;
mod seafloor;

pub(in crate::plate) use lobes::Continents;

use super::partition::sites;
use crate::crust::isostasy::Isostasy;
use crate::crust::{Crust, CrustKind, FrameId, Orogeny};
use crate::planet::PlanetRecipe;
use crate::sphere::SphereMesh;
use heights::Heights;

/// Area of continental crust, shelves included, relative to the area of land; 1.3 on Earth.
pub const CONTINENTAL_PER_LAND: f64 = 1.25;

/// Deepest continental crust relative to the depth of the abyss: continents end on their slope.
const DEEPEST_CONTINENT: f32 = 0.5;

/// The crust of a new planet. `recipe` is valid, `owner` is the plate of every sample of `mesh`.
pub fn initial_crust(recipe: &PlanetRecipe, mesh: &SphereMesh, owner: &[FrameId]) -> Crust {
    let continents = Continents::new(recipe, &sites(recipe));
    let field = field::continentality(recipe, mesh, &continents);
    let share = recipe.continents.is_empty().then_some(recipe.land);
    let land = land::land(mesh, field, share);
    let coast = land.coast_distance(mesh);
    let relief = Heights::new(recipe, mesh);
    let passive = |i: usize| coast[i] * recipe.radius > relief.shelf_width(mesh.point(i as u32));
    let floor = seafloor::seafloor(recipe, mesh, owner, passive);
    let mut crust = Crust::ocean(mesh.len(), &recipe.params);
    crust.frame.copy_from_slice(owner);
    crust.elevation = relief.elevation(mesh, &land.mask, &coast, &floor.elevation);
    let share = land.area(mesh) * (CONTINENTAL_PER_LAND - 1.0);
    let deepest = DEEPEST_CONTINENT * recipe.params.abyss_elevation as f32;
    for i in land::shelf(mesh, &land.mask, &crust.elevation, share, deepest) {
        crust.kind[i as usize] = CrustKind::Continental;
    }
    let law = Isostasy::new(&recipe.params);
    for i in 0..crust.len() {
        if land.mask[i] {
            crust.kind[i] = CrustKind::Continental;
        }
        if crust.is_continental(i) {
            crust.thickness[i] = law.thickness(crust.elevation[i]);
        } else {
            crust.ocean_age[i] = floor.age[i];
            crust.ridge[i] = floor.ridge[i];
        }
    }
    fold_belts(&mut crust, mesh, &relief, &coast);
    crust
}

/// Writes type, age and fold direction of the old belts.
fn fold_belts(crust: &mut Crust, mesh: &SphereMesh, relief: &Heights, coast: &[f64]) {
    let belts = crate::parallel::map_chunks(mesh.len(), |range| {
        let belt = |i: usize| {
            let folded = crust.elevation[i] > 0.0;
            let belt = folded.then(|| relief.belt(mesh.point(i as u32), coast[i]))?;
            (belt.strength > heights::FOLDED).then_some((i, belt))
        };
        range.filter_map(belt).collect::<Vec<_>>()
    });
    for (i, belt) in belts.into_iter().flatten() {
        crust.orogeny[i] = if belt.collision {
            Orogeny::Himalayan
        } else {
            Orogeny::Andean
        };
        crust.orogeny_age[i] = belt.age as f32;
        crust.fold[i] = belt.fold.as_vec3();
    }
}

#[cfg(test)]
mod tests;
