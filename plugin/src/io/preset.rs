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

use super::IoError;
use super::text::{TextError, parse, read_text};
use crate::params::ParamError;
use crate::planet::{PlanetError, PlanetRecipe};
use bevy::asset::io::Reader;
use bevy::asset::{AssetLoader, LoadContext};
use bevy::prelude::*;
use std::path::Path;

/// Reads and checks a recipe.
///
/// ```
/// use bevy_pangaea::io::preset::parse_recipe;
///
/// let recipe = parse_recipe("(seed: 7, land: 0.4, params: (erosion: 0.05))")?;
/// assert_eq!((recipe.seed, recipe.params.erosion), (7, 0.05));
///
/// let refused = parse_recipe("(\n    land: 2,\n)").unwrap_err();
/// assert_eq!(refused.line, 2);
/// # Ok::<(), bevy_pangaea::io::TextError>(())
/// ```
///
/// # Errors
/// [`TextError`] names the line of what is refused.
pub fn parse_recipe(text: &str) -> Result<PlanetRecipe, TextError> {
    let recipe: PlanetRecipe = parse(text)?;
    recipe.validate().map_err(|error| TextError {
        line: field_of(&error)
            .and_then(|field| line_of(text, field))
            .unwrap_or(0),
        problem: error.to_string(),
    })?;
    Ok(recipe)
}

/// The name in the text of the field that an error is about.
fn field_of(error: &PlanetError) -> Option<&str> {
    match error {
        PlanetError::Param(ParamError::OutOfRange { name, .. }) => Some(name),
        PlanetError::OutOfRange { field, .. } => field.split(' ').next_back(),
        PlanetError::TooManyPlates { .. } => Some("plates"),
        PlanetError::Sphere(_) => Some("samples"),
        PlanetError::Param(ParamError::Order { lower, .. }) => Some(lower),
        PlanetError::Param(ParamError::Unknown(_)) => None,
    }
}

/// The line that sets the field `name`, if there is exactly one.
fn line_of(text: &str, name: &str) -> Option<usize> {
    let mut found = (1..)
        .zip(text.lines())
        .filter(|(_, line)| sets(line, name))
        .map(|(number, _)| number);
    let first = found.next()?;
    found.next().is_none().then_some(first)
}

/// Whether a line sets the field `name`, and not one whose name ends in it.
fn sets(line: &str, name: &str) -> bool {
    line.match_indices(name).any(|(at, _)| {
        let before = line[..at].chars().next_back();
        let after = line[at + name.len()..].trim_start();
        after.starts_with(':') && !before.is_some_and(|c| c.is_alphanumeric() || c == '_')
    })
}

/// Loads a recipe from a file.
///
/// # Errors
/// [`IoError`] names the file and, where there is one, the line.
pub fn load_preset(path: &Path) -> Result<PlanetRecipe, IoError> {
    parse_recipe(&read_text(path)?).map_err(|error| error.in_file(path))
}

/// Loads `*.planet.ron` as an asset, so that a preset can be edited while a game runs.
#[derive(Default, TypePath)]
pub struct PlanetRecipeLoader;

/// Registers [`PlanetRecipe`] as an asset and [`PlanetRecipeLoader`] as its loader, in apps that
/// have assets.
pub struct PresetPlugin;

impl Plugin for PresetPlugin {
    fn build(&self, _app: &mut App) {}

    fn finish(&self, app: &mut App) {
        if app.world().contains_resource::<AssetServer>() {
            app.init_asset::<PlanetRecipe>()
                .register_asset_loader(PlanetRecipeLoader);
        }
    }
}

/// Why an asset is no recipe.
#[derive(Debug, thiserror::Error)]
pub enum RecipeLoadError {
    /// The file cannot be read.
    #[error("cannot read the preset: {0}")]
    Read(#[from] std::io::Error),
    /// The file is no UTF-8.
    #[error("the preset is no UTF-8 text")]
    NotText,
    /// The recipe is refused.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_empty_preset_is_the_default_planet() {
        assert_eq!(parse_recipe("()"), Ok(PlanetRecipe::default()));
    }

    #[test]
    fn fields_are_read() {
        let recipe = parse_recipe(
            "(samples: 5000, plates: [(centroid: (10, -60), pole: (55, 20), speed: 40),
              (centroid: (-20, 120))], continents: [(center: (0, 0), radius: 900)],
              params: (erosion: 0.5, processes: (noise: false), ocean_floor: Paper))",
        )
        .unwrap();
        assert_eq!(recipe.plates[0].pole, Some((55.0, 20.0)));
        assert_eq!(recipe.plates[1].pole, None);
        assert_eq!(recipe.params.erosion, 0.5);
        assert!(!recipe.params.processes.noise && recipe.params.processes.drift);
    }

    #[test]
    fn what_is_written_is_read() {
        let recipe = PlanetRecipe {
            seed: u64::MAX,
            land: 0.123_456_789,
            ..PlanetRecipe::default()
        };
        assert_eq!(parse_recipe(&ron::to_string(&recipe).unwrap()), Ok(recipe));
    }

    #[test]
    fn errors_name_the_line() {
        let line = |text: &str| parse_recipe(text).unwrap_err().line;
        assert_eq!(line("(\n  seed: 1,\n  sampels: 5,\n)"), 3);
        assert_eq!(line("(\n  samples: 1000000000000,\n)"), 2);
        assert_eq!(line("(\n  seed: 1,\n  samples: 99,\n)"), 3);
        assert_eq!(line("(\n  params: (\n    erosion: 9,\n  ),\n)"), 3);
        assert_eq!(line("(\n  land: NaN,\n)"), 2);
        assert_eq!(line("(\n\n  radius: -inf\n)"), 3);
        let error = parse_recipe("(\n  samples: 5000,\n  plate_count: 100000\n)").unwrap_err();
        assert!(error.problem.contains("100000"), "{error}");
        assert!(
            !parse_recipe("(seed: \"a\nb\")")
                .unwrap_err()
                .to_string()
                .contains('\n')
        );
    }

    const NOT_NUMBERS: [&str; 5] = ["NaN", "inf", "-inf", "1e300", "-1e300"];

    fn assert_refused(text: &str) {
        assert!(parse_recipe(text).is_err(), "{text}");
    }

    #[test]
    fn every_number_of_a_planet_is_checked() {
        for bad in NOT_NUMBERS {
            assert_refused(&format!("(radius: {bad})"));
            assert_refused(&format!("(land: {bad})"));
            for info in crate::params::TectonicParams::TABLE {
                assert_refused(&format!("(params: ({}: {bad}))", info.name));
            }
        }
    }

    #[test]
    fn every_number_of_plates_and_continents_is_checked() {
        for bad in NOT_NUMBERS {
            for plate in [
                format!("(centroid: ({bad}, 0))"),
                format!("(centroid: (0, {bad}))"),
                format!("(centroid: (0, 0), speed: {bad})"),
                format!("(centroid: (0, 0), pole: ({bad}, 0))"),
                format!("(centroid: (0, 0), pole: (0, {bad}))"),
            ] {
                assert_refused(&format!("(plates: [(centroid: (1, 1)), {plate}])"));
            }
            for disc in [
                format!("(center: ({bad}, 0), radius: 100)"),
                format!("(center: (0, {bad}), radius: 100)"),
                format!("(center: (0, 0), radius: {bad})"),
            ] {
                assert_refused(&format!("(continents: [{disc}])"));
            }
        }
    }
}
