//! From a text to a recipe, or to the line of the mistake.

use crate::io::IoError;
use crate::io::text::{TextError, parse, read_text};
use crate::params::ParamError;
use crate::planet::{PlanetError, PlanetRecipe};
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
        PlanetError::Param(ParamError::OutOfRange(refused)) => Some(refused.name),
        PlanetError::OutOfRange(refused) => refused.name.split(' ').next_back(),
        PlanetError::TooManyPlates { .. } => Some("plates"),
        PlanetError::Sphere(_) => Some("samples"),
        PlanetError::Param(ParamError::Order { lower, .. }) => Some(lower),
        PlanetError::Param(ParamError::Unknown(_)) => None,
    }
}

/// The only line that sets the field `name`, counted from 1; `None` if there is no such line, or
/// several.
fn line_of(text: &str, name: &str) -> Option<usize> {
    let mut found = (1..)
        .zip(text.lines())
        .filter(|(_, line)| sets_field(line, name));
    let (first, _) = found.next()?;
    found.next().is_none().then_some(first)
}

/// Whether the line holds `name:` as a word of its own.
fn sets_field(line: &str, name: &str) -> bool {
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

#[cfg(test)]
#[path = "recipe_tests.rs"]
mod tests;
