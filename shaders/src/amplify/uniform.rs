//! Data that all items of a level's passes have in common.

use super::rules::Rules;
use super::scale::PlanetScale;

/// Data that all items of a level's passes have in common, as a uniform holds it.
#[derive(Clone, Copy, Debug)]
pub struct LevelUniform<'a> {
    /// The planet's constants.
    pub scale: &'a PlanetScale,
    /// The rules.
    pub rules: &'a Rules,
    /// The level that is split.
    pub level: u32,
}
