//! Planets whose plates, coasts and ages are known.

use bevy_pangaea::crust::isostasy::Isostasy;
use bevy_pangaea::crust::ledger::measure;
use bevy_pangaea::math::lat_lon;
use bevy_pangaea::planet::PlateRecipe;
use bevy_pangaea::prelude::*;
use bevy_pangaea::spawn::PlanetState;

/// A small random planet, as users make them.
pub fn small(seed: u64, samples: u32) -> PlanetRecipe {
    PlanetRecipe {
        seed,
        samples,
        ..PlanetRecipe::default()
    }
}

/// A recipe of given plates, with straight borders, without land, on which nothing happens by
/// chance. A plate is the latitude and longitude of its centroid and of its pole in degrees, and
/// its speed in km/My.
pub fn given(samples: u32, plates: &[((f64, f64), (f64, f64), f64)]) -> PlanetRecipe {
    let mut recipe = PlanetRecipe {
        samples,
        land: 0.0,
        ..PlanetRecipe::default()
    };
    recipe.plates = plates
        .iter()
        .map(|&(centroid, pole, speed)| PlateRecipe {
            centroid,
            pole: Some(pole),
            speed,
        })
        .collect();
    recipe.params.border_warp = 0.0;
    recipe.params.processes.rifting = false;
    recipe.params.processes.noise = false;
    recipe
}

/// Two hemispheres that meet at the meridians 0 and 180. Plate 0 lies in the west, plate 1 in the
/// east; both turn about the north pole at the given speeds in km/My, eastward where positive.
pub fn hemispheres(samples: u32, west: f64, east: f64) -> PlanetRecipe {
    given(
        samples,
        &[
            ((0.0, -90.0), (90.0, 0.0), west),
            ((0.0, 90.0), (90.0, 0.0), east),
        ],
    )
}

/// Six plates at rest, the faces of a cube; plate 0 is around latitude 0, longitude 0.
pub fn cube(samples: u32) -> PlanetRecipe {
    let centroids = [
        (0.0, 0.0),
        (0.0, 90.0),
        (0.0, 180.0),
        (0.0, -90.0),
        (90.0, 0.0),
        (-90.0, 0.0),
    ];
    given(
        samples,
        &centroids.map(|centroid| (centroid, (90.0, 0.0), 0.0)),
    )
}

/// Crust at one place of a hand-made planet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Floor {
    /// Continental crust that floats at this elevation in km.
    Land(f32),
    /// Ocean floor of this age in My.
    Ocean(f32),
}

/// The planet of a recipe with crust as `floor(plate, latitude, longitude)` says.
pub fn shaped(recipe: &PlanetRecipe, floor: impl Fn(u32, f64, f64) -> Floor) -> PlanetState {
    let mut state = PlanetState::new(recipe).expect("the recipe of a test is valid");
    let crust = &mut state.crust;
    for i in 0..crust.len() {
        let (lat, lon) = lat_lon(state.lattice.0.points()[i]);
        let plate = state.frames.plate(crust.frame[i]).0;
        lay(crust, i, floor(plate, lat, lon), &recipe.params);
    }
    state.ledger.initial = measure(crust, &state.lattice.0, recipe.radius);
    state
}

/// Gives sample `i` crust that was never folded.
fn lay(crust: &mut Crust, i: usize, floor: Floor, params: &TectonicParams) {
    crust.orogeny[i] = Orogeny::None;
    match floor {
        Floor::Land(z) => {
            crust.kind[i] = CrustKind::Continental;
            crust.elevation[i] = z;
            crust.thickness[i] = Isostasy::new(params).thickness(z);
            crust.ocean_age[i] = 0.0;
        }
        Floor::Ocean(age) => {
            crust.kind[i] = CrustKind::Oceanic;
            crust.elevation[i] = params.abyss_elevation as f32;
            crust.thickness[i] = params.ocean_thickness as f32;
            crust.ocean_age[i] = age;
        }
    }
}
