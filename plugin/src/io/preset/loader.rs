//! Presets as assets.

use super::recipe::parse_recipe;
use crate::io::TextError;
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
    /// It is no UTF-8.
    #[error("the preset is no UTF-8 text")]
    NotText,
    /// It is refused.
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
        let text = core::str::from_utf8(&bytes).map_err(|_| RecipeLoadError::NotText)?;
        Ok(parse_recipe(text)?)
    }

    fn extensions(&self) -> &[&str] {
        &["planet.ron"]
    }
}
