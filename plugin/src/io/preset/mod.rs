//! Presets `*.planet.ron`: recipes of planets, as files and as assets.
//!
//! ```ron
//! (
//!     seed: 7,
//!     samples: 60000,
//!     plates: [
//!         (centroid: (10, -60), pole: (55, 20), speed: 40),
//!         (centroid: (-20, 120)),
//!     ],
//!     continents: [(center: (10, -60), radius: 2500)],
//!     params: (erosion: 0.05, processes: (noise: false)),
//! )
//! ```
//! Fields that are left out have their defaults; an unknown field is an error.
//!
//! ```text
//! recipe     from a text to a recipe, or to the line of the mistake
//! loader     presets as assets
//! follow     PlanetPreset: a planet that follows its preset
//! ```

mod recipe;

mod loader;

mod follow;

pub use follow::PlanetPreset;
pub use loader::{PlanetRecipeLoader, RecipeLoadError};
pub use recipe::{load_preset, parse_recipe};

use crate::planet::PlanetRecipe;
use bevy::prelude::*;

/// Presets: [`PlanetRecipe`] as an asset with [`PlanetRecipeLoader`] as its loader, in apps that
/// have assets, and planets that follow a [`PlanetPreset`].
pub struct PresetPlugin;

impl Plugin for PresetPlugin {
    fn build(&self, app: &mut App) {
        let assets_are_there = resource_exists::<Assets<PlanetRecipe>>;
        app.add_systems(PreUpdate, follow::follow.run_if(assets_are_there));
    }

    // The asset server may be added after this plugin.
    fn finish(&self, app: &mut App) {
        if app.world().contains_resource::<AssetServer>() {
            app.init_asset::<PlanetRecipe>()
                .register_asset_reflect::<PlanetRecipe>()
                .register_asset_loader(PlanetRecipeLoader);
        }
    }
}
