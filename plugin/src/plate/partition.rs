//! Initial plates: a spherical Voronoi partition with warped distances (paper 000 §3).
//!
//! The distance of a sample to a centroid is the chord from the *displaced* sample, less the
//! centroid's weight. The displacement is a vector noise of several octaves, so borders are
//! irregular at every scale; weights make a few plates large and most of them small, as on Earth.
//!
//! ```text
//! placement  caps on the sphere, and the choice among random places
//! sites      where the plates are and how large
//! motions    how they move
//! voronoi    the cell of every sample
//! regions    connected regions; what is cut off goes to what surrounds it
//! ```
//!
//! Policies:
//! - A sample as near to two centroids belongs to the one with the lower index.
//! - A plate is one connected region. Its largest piece stays (the one with the lowest sample among
//!   equals), others go to what surrounds them.
//! - Every plate has a sample. One without takes the sample nearest to its
//!   centroid that another plate can spare.

mod motions;
mod placement;
mod regions;
mod sites;
mod voronoi;

pub(in crate::plate) use motions::motions;
pub(in crate::plate) use placement::{cap_radius, first_or_best};
pub(in crate::plate) use regions::connected_regions;
pub(in crate::plate) use sites::{PlateSite, sites};

use crate::crust::FrameId;
use crate::noise::Noise;
use crate::planet::PlanetRecipe;
use crate::random::Purpose;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use regions::keep_connected;
use voronoi::warped_voronoi;

/// The plate of every sample. `recipe` is valid ([`PlanetRecipe::validate`]).
pub(in crate::plate) fn initial_partition(
    recipe: &PlanetRecipe,
    mesh: &SphereMesh,
) -> Vec<FrameId> {
    let sites = sites(recipe);
    let centroids: Vec<_> = sites.iter().map(|site| site.centroid).collect();
    let weights: Vec<_> = sites.iter().map(|site| site.weight).collect();
    let samples: Vec<u32> = (0..mesh.len() as u32).collect();
    let noise = Noise::new(recipe.seed, Purpose::BorderWarp, 0);
    let warp = recipe.params.border_warp;
    let mut owner = warped_voronoi(mesh, &samples, &centroids, &weights, &noise, warp);
    seed_empty(mesh, &centroids, &mut owner);
    keep_connected(mesh, &samples, &mut owner);
    owner
}

/// Gives each plate without a sample the nearest one to its centroid that another plate can spare.
fn seed_empty(mesh: &SphereMesh, centroids: &[DVec3], owner: &mut [u16]) {
    let mut count = vec![0_u32; centroids.len()];
    for &plate in &*owner {
        count[usize::from(plate)] += 1;
    }
    for (plate, &centroid) in centroids.iter().enumerate() {
        if count[plate] > 0 {
            continue;
        }
        // The last sample of another plate is not taken.
        let spare = |&i: &u32| count[usize::from(owner[i as usize])] > 1;
        let far = |&i: &u32| (mesh.point(i) - centroid).length_squared();
        let samples = (0..mesh.len() as u32).filter(spare);
        if let Some(i) = samples.min_by(|a, b| far(a).total_cmp(&far(b))) {
            count[usize::from(owner[i as usize])] -= 1;
            count[plate] = 1;
            owner[i as usize] = plate as u16;
        }
    }
}
