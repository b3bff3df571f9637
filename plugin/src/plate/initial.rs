//! The plates of a new planet: where they are and how they move.

use super::continents::initial_motions;
use super::motion::PlateMotion;
use super::partition::initial_partition;
use crate::ids::FrameId;
use crate::planet::PlanetRecipe;
use crate::sphere::SphereMesh;

/// The motions of the initial plates and the plate of every sample.
///
/// `recipe` is valid ([`PlanetRecipe::validate`]). Plate k is the k-th of `recipe.plates`, or one
/// of `recipe.plate_count` random ones, the largest first.
///
/// ```
/// # use bevy_pangaea::{planet::PlanetRecipe, plate::initial_plates, sphere::SphereMesh};
/// let recipe = PlanetRecipe { seed: 7, plate_count: 12, ..Default::default() };
/// let mesh = SphereMesh::fibonacci(2000)?;
/// let (motions, plate_of) = initial_plates(&recipe, &mesh);
/// assert_eq!((motions.len(), plate_of.len()), (12, 2000));
/// // Every plate has samples.
/// assert!((0..12).all(|plate| plate_of.contains(&plate)));
/// # Ok::<(), bevy_pangaea::sphere::SphereError>(())
/// ```
pub fn initial_plates(
    recipe: &PlanetRecipe,
    mesh: &SphereMesh,
) -> (Vec<PlateMotion>, Vec<FrameId>) {
    (initial_motions(recipe), initial_partition(recipe, mesh))
}

#[cfg(test)]
mod tests;
