//! Presets as assets.

use super::recipe::parse_recipe;
use crate::io::text::{TextError, decode};
use crate::planet::PlanetRecipe;
use bevy::asset::io::Reader;
use bevy::asset::{AssetLoader, LoadContext};
use bevy::prelude::*;

/// Loads `*.planet.ron` as an asset, so that a preset can be edited while a game runs.
#[derive(Default, TypePath)]
pub struct PlanetRecipeLoader;

/// Why an asset is no recipe.
#[derive(Debug, thiserror::Error)]
pub enum RecipeLoadError {
    /// It cannot be read.
    #[error("cannot read the preset: {0}")]
    Read(#[from] std::io::Error),
    /// It is no text, or is refused.
    #[error(transparent)]
    Text(#[from] TextError),
}

impl AssetLoader for PlanetRecipeLoader {
    type Asset = PlanetRecipe;
    type Settings = ();
    type Error = RecipeLoadError;

    async fn load(
        &self,
        reader: &mut dyn Reader,
        _settings: &(),
        _context: &mut LoadContext<'_>,
    ) -> Result<PlanetRecipe, RecipeLoadError> {
        let mut bytes = Vec::new();
        reader.read_to_end(&mut bytes).await?;
        Ok(parse_recipe(&decode(&bytes)?)?)
    }

    fn extensions(&self) -> &[&str] {
        &["planet.ron"]
    }
}
