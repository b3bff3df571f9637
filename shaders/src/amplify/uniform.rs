//! Data that all items of a level's passes have in common.

use super::rows::LevelCaps;
use super::rules::Rules;
use super::scale::PlanetScale;
use super::sight::Sight;

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

/// The uniform of a level's passes on a GPU: the view, in which the planet's constants are, the rules,
/// what the buffers hold, and the level.
pub fn level_words(sight: &Sight, level: u32, rules: &Rules, caps: &LevelCaps) -> [u32; 56] {
    let mut words = [0; 56];
    words[..28].copy_from_slice(&sight.words());
    words[28..48].copy_from_slice(&rules.words());
    words[48..52].copy_from_slice(&[caps.vertices, caps.edges, caps.faces, caps.triangles]);
    words[52] = level;
    words
}
