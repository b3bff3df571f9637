//! Land that a coarse level shows: its own ground, and the mean of what finer levels will build
//! upon it.
//!
//! Vertices of coarse levels are beds of rivers and gullies, and the feet of slopes: finer levels
//! add the land between them. A map of such a level would show the land too low, at level 0 by a
//! third. In the mean finer levels gain a share of what the slope allows within an edge and of the
//! room under C, whichever is less:
//!
//! ```text
//! lift = k · room · rise / (room + rise),  room = C - ground,  rise = edge · steepness
//! ```
//!
//! The shares k are fitted by least squares to the ground of level 9 at the land of 36,000 directions
//! of three planets. They fade as the edges become shorter than the spacing of valleys: from level 5
//! on the ground is what it is, within a hundredth.

use super::landform::steepness;
use super::preset::Rules;
use crate::amplify::arith::{mix, mul_q16, ratio};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{Q16, metres, q16};
use crate::amplify::vertex::Vertex;

/// First level that shows the ground as it is.
pub const RESOLVED_LEVEL: u32 = 8;

/// Share k by level at dry ground.
const OPEN_GROUND: [i32; RESOLVED_LEVEL as usize] = [
    q16(0.238),
    q16(0.373),
    q16(0.323),
    q16(0.246),
    q16(0.185),
    q16(0.048),
    0,
    0,
];

/// The same in the bed of a gully.
const GULLY: [i32; RESOLVED_LEVEL as usize] = [
    q16(0.342),
    q16(0.246),
    q16(0.173),
    q16(0.117),
    q16(0.074),
    0,
    0,
    0,
];

/// The same in the bed of a river: less, for its valley floor stays.
const RIVER: [i32; RESOLVED_LEVEL as usize] = [
    q16(0.279),
    q16(0.174),
    q16(0.121),
    q16(0.045),
    q16(0.013),
    0,
    0,
    0,
];

/// How much more land gains that is worn down altogether: its hills are laid on what slopes build.
const WORN_GAIN: i32 = q16(0.1);

/// Most rise within half an edge, grains: products of it fit 32 bits on any planet.
const MOST_RISE: i32 = metres(400_000);

crate::wgsl::shared!(
    RESOLVED_LEVEL,
    SHOWN_OPEN_GROUND = OPEN_GROUND,
    SHOWN_GULLY = GULLY,
    SHOWN_RIVER = RIVER,
    WORN_GAIN,
    MOST_RISE,
);

/// How far a level shows a vertex above its own `ground`, grains. `level` is in Q16: between two
/// levels it changes evenly. `edge` is the mean edge of level 0, grains.
///
/// Lakes, coasts and the sea are shown as they are: their level is that of all the water around.
/// So is all ground of the presets of print and release.
pub fn lift(rules: &Rules, vertex: &Vertex, ground: i32, edge: i32, level: i32) -> i32 {
    let shares = match vertex.kind {
        VertexKind::Terrain => OPEN_GROUND,
        VertexKind::Gully => GULLY,
        VertexKind::River => RIVER,
        VertexKind::Lake | VertexKind::Coast | VertexKind::Sea => return 0,
    };
    let whole = (level.max(0) >> 16) as u32;
    // Mouths lie at sea level: the shore stays where it is.
    if !rules.landforms || whole >= RESOLVED_LEVEL || ground <= 0 {
        return 0;
    }
    let steep = steepness(rules, vertex);
    let room = (vertex.crust.max(0) - ground).max(0);
    let gain = Q16 + mul_q16(WORN_GAIN, i32::from(vertex.worn));
    let [here, finer] = [whole, whole + 1].map(|level| {
        let share = shares.get(level as usize).copied().unwrap_or(0);
        let rise = 2 * mul_q16((edge >> level) / 2, steep).min(MOST_RISE);
        mul_q16(mul_q16(room, ratio(rise, room + rise)), share)
    });
    mul_q16(mix(here, finer, level & (Q16 - 1)), gain)
}
