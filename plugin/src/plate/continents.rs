//! Initial crust: continents with shelves and old worn belts, and an ocean floor that knows its
//! age.
//!
//! ```text
//! lobes      which plates carry continents, and discs that make their rough shapes
//! field      "continentality" of every sample: distance into the lobes, with fractal noise
//! land       the level of the field that gives the wanted share of land; no specks, no ponds
//! heights    profile from the interior over coast and shelf to the abyss
//! belts      old mountain belts
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

mod belts;
mod field;
mod heights;
mod land;
mod lobes;
mod seafloor;

use super::motion::PlateMotion;
use super::partition::{motions, sites};
use crate::crust::isostasy::Isostasy;
use crate::crust::{Crust, CrustKind, FrameId};
use crate::parallel::map_chunks;
use crate::planet::PlanetRecipe;
use crate::sphere::SphereMesh;
use belts::FOLDED_STRENGTH;
use heights::Heights;
use land::Land;
use lobes::Continents;

/// Area of continental crust, shelves included, relative to the area of land; 1.3 on Earth.
const CONTINENTAL_PER_LAND: f64 = 1.25;

/// Samples that a given disc must cover, so that its land stays when the coast is warped and specks
/// are removed: nine in ten discs of so many samples have land, of discs of four samples two in
/// five, of two next to none (measured on 500 to 10,000 samples).
const HELD_DISC_SAMPLES: f64 = 10.0;

/// Samples that all random land must cover, so that its pieces stay: with 30 some four fifths of it
/// do, with 15 a fifth, with 8 none (measured on 500 and 4,000 samples).
const HELD_LAND_SAMPLES: f64 = 30.0;

/// Deepest continental crust relative to the depth of the abyss: continents end half way down their
/// slope.
const DEEPEST_CONTINENT: f32 = 0.5;

/// Motions of the initial plates: as given, or random, slower for plates that carry continents.
pub(super) fn initial_motions(recipe: &PlanetRecipe) -> Vec<PlateMotion> {
    let sites = sites(recipe);
    let continents = Continents::new(recipe, &sites);
    motions(recipe, &sites, |site| continents.cover(site))
}

/// Radius in km of the smallest disc of a recipe whose land so many samples can hold.
///
/// ```
/// use bevy_pangaea::planet::PlanetRecipe;
/// use bevy_pangaea::plate::smallest_continent_km;
///
/// let coarse = PlanetRecipe { samples: 500, ..Default::default() };
/// assert_eq!(smallest_continent_km(&coarse).round(), 1802.0);
/// ```
pub fn smallest_continent_km(recipe: &PlanetRecipe) -> f64 {
    // A flat disc: π r² is the area of that many samples.
    recipe.radius * (4.0 * HELD_DISC_SAMPLES / f64::from(recipe.samples)).sqrt()
}

/// The smallest share of random land that the samples of a recipe can hold.
pub fn smallest_land(recipe: &PlanetRecipe) -> f64 {
    HELD_LAND_SAMPLES / f64::from(recipe.samples)
}

/// The crust of a new planet. `recipe` is valid, `owner` is the plate of every sample of `mesh`.
///
/// ```
/// # use bevy_pangaea::{planet::PlanetRecipe, plate, sphere::SphereMesh};
/// let recipe = PlanetRecipe { seed: 7, land: 0.3, ..Default::default() };
/// let mesh = SphereMesh::fibonacci(4000)?;
/// let (_, owner) = plate::initial_plates(&recipe, &mesh);
/// let crust = plate::initial_crust(&recipe, &mesh, &owner);
/// let land = (0..mesh.len()).filter(|&i| crust.elevation[i] > 0.0).count();
/// assert!((land as f64 / 4000.0 - 0.3).abs() < 0.01);
/// # Ok::<(), bevy_pangaea::sphere::SphereError>(())
/// ```
pub fn initial_crust(recipe: &PlanetRecipe, mesh: &SphereMesh, owner: &[FrameId]) -> Crust {
    let land = initial_land(recipe, mesh);
    let coast = land.coast_distance(mesh);
    let heights = Heights::new(recipe, mesh);
    let motions = initial_motions(recipe);
    // Ridges begin beyond the shelf: along the coast itself margins are passive.
    let passive = |i: usize| coast[i] * recipe.radius > heights.shelf_width(mesh.point(i as u32));
    let floor = seafloor::seafloor(recipe, mesh, owner, &motions, passive);
    let mut crust = Crust::ocean(mesh.len(), &recipe.params);
    crust.frame.copy_from_slice(owner);
    crust.elevation = heights.elevation(mesh, &land.mask, &coast, &floor.elevation);
    mark_continents(recipe, mesh, &land, &mut crust);
    let law = Isostasy::new(&recipe.params);
    // Continental crust floats at its elevation; oceanic crust keeps its thickness and has an age.
    for i in 0..crust.len() {
        if crust.is_continental(i) {
            crust.thickness[i] = law.thickness(crust.elevation[i]);
        } else {
            crust.ocean_age[i] = floor.age[i];
            crust.ridge[i] = floor.ridge[i];
        }
    }
    fold_belts(&mut crust, mesh, &heights, &coast);
    crust
}

/// The land of the recipe's continents.
fn initial_land(recipe: &PlanetRecipe, mesh: &SphereMesh) -> Land {
    let continents = Continents::new(recipe, &sites(recipe));
    let field = field::continentality(recipe, mesh, &continents);
    // Given discs say what is land; the share of random continents is met exactly.
    let share = recipe.continents.is_empty().then_some(recipe.land);
    land::land(mesh, field, share)
}

/// Makes land and shelves continental.
fn mark_continents(recipe: &PlanetRecipe, mesh: &SphereMesh, land: &Land, crust: &mut Crust) {
    let area = land.area(mesh) * (CONTINENTAL_PER_LAND - 1.0);
    let deepest = DEEPEST_CONTINENT * recipe.params.abyss_elevation as f32;
    for i in land::shelf(mesh, &land.mask, &crust.elevation, area, deepest) {
        crust.kind[i as usize] = CrustKind::Continental;
    }
    for (kind, &is_land) in crust.kind.iter_mut().zip(&land.mask) {
        if is_land {
            *kind = CrustKind::Continental;
        }
    }
}

/// Writes type, age and fold direction of the old belts.
fn fold_belts(crust: &mut Crust, mesh: &SphereMesh, heights: &Heights, coast: &[f64]) {
    let belts = map_chunks(mesh.len(), |range| {
        let land = range.filter(|&i| crust.elevation[i] > 0.0);
        let belts = land.map(|i| (i, heights.belts.at(mesh.point(i as u32), coast[i])));
        let folded = belts.filter(|(_, belt)| belt.strength > FOLDED_STRENGTH);
        folded.collect::<Vec<_>>()
    });
    for (i, belt) in belts.into_iter().flatten() {
        crust.orogeny[i] = belt.orogeny;
        crust.orogeny_age[i] = belt.age as f32;
        crust.fold[i] = belt.fold.as_vec3();
    }
}

#[cfg(test)]
mod tests;
