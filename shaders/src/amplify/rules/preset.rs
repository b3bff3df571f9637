//! The numbers of the rules, and their presets: ours, the paper's print, its authors' release.

use super::nodes::Form;
use crate::amplify::fixed::{q16, tan_deg};

/// First level whose edges stay straight and whose faces decide nothing: a vertex then follows from
/// its parents alone, but for a river beside it. Its edges are 25 m long on an Earth-sized planet.
pub const STRAIGHT_LEVEL: u32 = 11;

/// First level, in our rules, at which a vertex lies on the face where it was moved to, not at its
/// edge's height: edges of 800 m and less on an Earth-sized planet, the size of a hillside. An even
/// slope stays even under sideways moves.
pub(super) const FACE_LEVEL: u32 = 6;

crate::wgsl::shared!(STRAIGHT_LEVEL, FACE_LEVEL,);

/// Constants of the subdivision rules. Shares and tangents are Q16, heights and lengths grains,
/// levels are the paper's λ: 0 halves the control mesh's edges of about 52 km.
///
/// ```
/// use pangaea_shaders::amplify::fixed::q16;
/// use pangaea_shaders::amplify::rules::Rules;
///
/// // The default rules, with twice as many lakes.
/// let rules = Rules { lake_chance: 2 * Rules::default().lake_chance, ..Rules::default() };
/// assert!(rules.lake_chance < q16(1.0));
/// assert_ne!(rules, Rules::PAPER);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rules {
    /// Form of the young mountains' α and of the hills.
    pub form: Form,
    /// Whether crests and slopes follow the landform's own steepness, and fade with the level so
    /// that the ground's spectrum is that of real relief; off, they follow the printed constants.
    pub landforms: bool,
    /// Rise of a crest over the higher river, per length of the edge halved: 0.2.
    pub crest_rise: i32,
    /// Tangent of the slopes of a young belt of continental collision.
    pub steep_collision: i32,
    /// Tangent of the slopes of a young belt of subduction.
    pub steep_subduction: i32,
    /// Tangent of the slopes of old land.
    pub steep_old: i32,
    /// Levels whose river edges fall more on their first half, so that the long profile is hollow:
    /// first and one beyond the last.
    pub hollow_levels: [u32; 2],
    /// Share of its fall that a river edge of those levels has on its first half; 0.75 in the
    /// release.
    pub hollow_fall: i32,
    /// First level whose halving is that of fine ground: 10.
    pub fine_level: u32,
    /// Levels of internal edges that may become tributaries, first and one beyond the last.
    pub tributary_levels: [u32; 2],
    /// One beyond the last level on which a tributary's edge goes on above its new spring (R4a);
    /// from there on that half is ground (R4b, always so in the release).
    pub extension_levels: u32,
    /// One beyond the last level of internal edges that may become gullies.
    pub gully_levels: u32,
    /// Chance that an eligible internal edge becomes a gully off a gully.
    pub gully_branching: i32,
    /// One beyond the last level on which lakes form: 5.
    pub lake_levels: u32,
    /// Chance of a lake where water abounds.
    pub lake_chance: i32,
    /// Rise of a tributary along its first half, tangent: that of 3°.
    pub spring_slope: i32,
    /// Width of a river in metres at a discharge of 1 m³/s on an Earth-sized planet; it grows with
    /// the root of the discharge: 4.8 (Leopold and Maddock 1953).
    pub channel_width: i32,
    /// Whether valleys are shaped by their archetype's curve; off, all have the released bank.
    pub archetypes: bool,
}

impl Default for Rules {
    fn default() -> Self {
        Self {
            form: Form::Release,
            landforms: true,
            crest_rise: q16(0.2),
            steep_collision: q16(1.95),
            steep_subduction: q16(0.98),
            steep_old: q16(1.3),
            hollow_levels: [1, 8],
            hollow_fall: q16(0.65),
            fine_level: 10,
            tributary_levels: [0, 4],
            extension_levels: 5,
            gully_levels: 9,
            gully_branching: q16(0.68665),
            lake_levels: 6,
            lake_chance: q16(0.06866),
            spring_slope: tan_deg(3.0),
            channel_width: q16(4.8),
            archetypes: true,
        }
    }
}

impl Rules {
    /// As printed in paper 002: α and hills of Appendix A, tributaries on internal edges of 3 to
    /// 25 km, which are those of levels 0 to 3. Where the print has no number, the release's.
    pub const PAPER: Self = Self {
        form: Form::Paper,
        landforms: false,
        crest_rise: q16(0.2),
        steep_collision: q16(0.4),
        steep_subduction: q16(0.4),
        steep_old: q16(0.4),
        hollow_levels: [0, 8],
        hollow_fall: q16(0.75),
        fine_level: 10,
        tributary_levels: [0, 4],
        extension_levels: 4,
        gully_levels: 8,
        gully_branching: q16(0.25),
        lake_levels: 5,
        lake_chance: q16(0.1),
        spring_slope: tan_deg(3.0),
        channel_width: q16(4.8),
        archetypes: true,
    };

    /// As in the authors' released source, which spans α over 0..1 and branches on two levels only.
    pub const RELEASE: Self = Self {
        form: Form::Release,
        tributary_levels: [0, 2],
        extension_levels: 0,
        archetypes: false,
        ..Self::PAPER
    };

    /// Its words in a uniform: those of its fields, in their order.
    pub fn words(&self) -> [u32; 20] {
        [
            self.form as u32,
            self.landforms.into(),
            self.crest_rise as u32,
            self.steep_collision as u32,
            self.steep_subduction as u32,
            self.steep_old as u32,
            self.hollow_levels[0],
            self.hollow_levels[1],
            self.hollow_fall as u32,
            self.fine_level,
            self.tributary_levels[0],
            self.tributary_levels[1],
            self.extension_levels,
            self.gully_levels,
            self.gully_branching as u32,
            self.lake_levels,
            self.lake_chance as u32,
            self.spring_slope as u32,
            self.channel_width as u32,
            self.archetypes.into(),
        ]
    }
}
