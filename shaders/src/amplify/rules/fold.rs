//! Folds: ranges and the longitudinal valleys between them, along the fold axis f of an orogeny
//! (paper 000 §4.1, the direction in which an uplift folds its crust).
//!
//! Stripes of phasor noise lie across f: anticlines, where the draws of the coarse levels are high
//! and bulges great, and synclines, where both are low. They bend with the axis, fork and end. All
//! coarse levels see the same stripes, so a crest goes on from one edge to the next.
//!
//! An axis has no sign: which flank of a fold is the steeper (vergence) would need the side of the
//! belt's front, which the control mesh does not carry.

use super::ocean::phasor::{PacketCache, StripeNoise};
use super::ocean::{across, unit_axis};
use crate::amplify::arith::{mix, mul_q16, smoothstep};
use crate::amplify::fixed::{Q16, q16};
use crate::amplify::seed::share;
use crate::amplify::vertex::{EdgeContext, Vertex};

/// Packets of 104 km, with folds every 23 km: ranges of the Zagros and of the Appalachians stand 10
/// to 30 km apart.
const FOLDS: StripeNoise = StripeNoise {
    cell: 25,
    waves: q16(4.5),
    seed: 0xf01d_0001,
};

/// One beyond the last level that folds shape: its edges are shorter than a sixth of a fold.
const FOLD_LEVELS: u32 = 5;

/// Agreement of the packets at which folds set in, and at which they are full.
const FOLD_PRESENCE: [i32; 2] = [q16(0.1), q16(0.2)];

/// How much a full anticline adds to a bulge, and a syncline takes from it.
const FOLDED_BULGE: i32 = q16(0.8);

/// Random numbers of an edge's rise, and how folds change its bulge; Q16.
#[derive(Clone, Copy, Debug)]
pub(super) struct RiseDraws {
    /// How far the bulge, and the middle of a hillside, are drawn up.
    pub(super) xi: i32,
    /// How much of the room a crest takes, and how steep the ground may stand.
    pub(super) chi: i32,
    /// Factor of the bulge.
    pub(super) bulge: i32,
}

impl RiseDraws {
    /// The draws of a new vertex: its own, and on the coarse levels of folded land those of its
    /// fold.
    pub(super) fn of(context: &EdgeContext) -> Self {
        let new = context.new;
        let [xi, chi] = [0, 1].map(|k| share(new.seed, k));
        if context.level >= FOLD_LEVELS || new.fold == [0; 3] {
            return Self {
                xi,
                chi,
                bulge: Q16,
            };
        }
        let Fold { height, presence } = Fold::at(new);
        Self {
            xi: mix(xi, height, presence),
            chi: mix(chi, height, presence),
            bulge: Q16 + mul_q16(mul_q16(2 * height - Q16, presence), FOLDED_BULGE),
        }
    }
}

/// Where in a fold a vertex lies; shares in Q16.
#[derive(Clone, Copy, Debug)]
struct Fold {
    /// 0 in the syncline, 1 on the anticline.
    height: i32,
    /// How far the land is folded.
    presence: i32,
}

impl Fold {
    fn at(vertex: &Vertex) -> Self {
        // Scaled, or folds would widen where axes differ.
        let (unit, agreement) = unit_axis(vertex.fold);
        let axis = across(vertex.direction, unit);
        let stripes = FOLDS.at(&mut PacketCache::default(), vertex.direction, axis);
        let [onset, full] = FOLD_PRESENCE;
        let presence = smoothstep(onset, full, stripes.presence);
        Self {
            height: (stripes.cosine + Q16) / 2,
            presence: mul_q16(presence, 2 * agreement),
        }
    }
}
