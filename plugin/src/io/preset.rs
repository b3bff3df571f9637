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

use super::{IoError, read_text};
use crate::params::ParamError;
use crate::planet::{PlanetError, PlanetRecipe};
use bevy::asset::io::Reader;
use bevy::asset::{AssetLoader, LoadContext};
use bevy::prelude::*;
use ron::extensions::Extensions;
use serde::de::DeserializeOwned;
use std::path::Path;

/// What is wrong with a text, and in which line (0: in none in particular).
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("line {line}: {problem}")]
pub struct TextError {
    /// Line from 1, or 0.
    pub line: usize,
    /// What is wrong.
    pub problem: String,
}

impl TextError {
    pub(super) fn in_file(self, path: &Path) -> IoError {
        IoError::Text {
            path: path.to_path_buf(),
            line: self.line,
            problem: self.problem,
        }
    }
}

/// Reads RON in which `Some(..)` may be left out.
pub(super) fn parse<T: DeserializeOwned>(text: &str) -> Result<T, TextError> {
    let options = ron::Options::default().with_default_extension(Extensions::IMPLICIT_SOME);
    options.from_str(text).map_err(|error| {
        // The parser quotes the text it met; a message stays on one line.
        let problem = error
            .code
            .to_string()
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ");
        TextError {
            line: error.span.start.line,
            problem,
        }
    })
}

/// Reads and checks a recipe.
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

/// The only line that sets the field `name`; none if there are several, or none.
fn line_of(text: &str, name: &str) -> Option<usize> {
    let sets = |line: &str| {
        line.match_indices(name).any(|(at, _)| {
            let before = line[..at].chars().next_back();
            let after = line[at + name.len()..].trim_start();
            after.starts_with(':') && !before.is_some_and(|c| c.is_alphanumeric() || c == '_')
        })
    };
    let mut found = text
        .lines()
        .enumerate()
        .filter(|(_, line)| sets(line))
        .map(|(i, _)| i + 1);
    let first = found.next()?;
    found.next().is_none().then_some(first)
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

    #[test]
    fn every_number_of_a_preset_is_checked() {
        for bad in ["NaN", "inf", "-inf", "1e300", "-1e300"] {
            for field in ["radius", "land"] {
                assert!(
                    parse_recipe(&format!("({field}: {bad})")).is_err(),
                    "{field}: {bad}"
                );
            }
            for info in crate::params::TectonicParams::TABLE {
                assert!(
                    parse_recipe(&format!("(params: ({}: {bad}))", info.name)).is_err(),
                    "{}",
                    info.name
                );
            }
            for plate in [
                format!("(centroid: ({bad}, 0))"),
                format!("(centroid: (0, {bad}))"),
                format!("(centroid: (0, 0), speed: {bad})"),
                format!("(centroid: (0, 0), pole: ({bad}, 0))"),
                format!("(centroid: (0, 0), pole: (0, {bad}))"),
            ] {
                let text = format!("(plates: [(centroid: (1, 1)), {plate}])");
                assert!(parse_recipe(&text).is_err(), "{text}");
            }
            for disc in [
                format!("(center: ({bad}, 0), radius: 100)"),
                format!("(center: (0, {bad}), radius: 100)"),
                format!("(center: (0, 0), radius: {bad})"),
            ] {
                assert!(
                    parse_recipe(&format!("(continents: [{disc}])")).is_err(),
                    "{disc}"
                );
            }
        }
    }
}
