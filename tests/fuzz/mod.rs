//! Damaged files: no reader panics or hangs, and whatever one accepts is valid.
//!
//! Ten thousand damaged inputs for each reader, a million with `PANGAEA_SOAK=1`.

mod archives;
mod elevations;
mod maps;
mod pictures;
mod saves;
mod side_files;
mod texts;

use bevy::prelude::*;
use bevy_pangaea::io;
use bevy_pangaea::io::save::{read_from, write_to};
use bevy_pangaea::schedule::run_steps;
use bevy_pangaea::spawn::PlanetState;
use pangaea_tests::shape::small;
use pangaea_tests::world::app;

/// A world in which accepted planets take a step.
struct Trial(App);

impl Trial {
    fn new() -> Self {
        Self(app())
    }

    /// Takes one step with a planet. The result must be a planet that a file can hold: it is written
    /// and read again with the same digest.
    fn lives_on(&mut self, state: PlanetState) {
        let world = self.0.world_mut();
        let planet = state.spawn(world);
        run_steps(world, planet, 1);
        let after = io::capture(world, planet).expect("the planet stands between two steps");
        world.despawn(planet);
        let again = read_from(&saved(&after)).expect("what was written can be read");
        assert_eq!(io::digest(&after), io::digest(&again));
    }
}

/// The bytes of a save.
fn saved(state: &PlanetState) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_to(state, &mut bytes).expect("memory can be written");
    bytes
}

/// The smallest planet, with a few plates.
fn tiny(seed: u64) -> PlanetState {
    let mut recipe = small(seed, 100);
    recipe.plate_count = 6;
    PlanetState::new(&recipe).expect("a valid recipe")
}
