//! Edges of the sea: sea floor, shore, and the slope from one to the other.

use super::super::arith::{mix, mul_q16};
use super::super::control::VertexKind;
use super::super::fixed::{GRAINS, Q16};
use super::super::seed::share;
use super::super::vertex::EdgeContext;
use super::preset::Rules;
use super::{VertexGround, terrain};

/// The vertex of an edge with an end in the sea, or along the shore.
///
/// Between land and sea it keeps the mean elevation, as the release does, drawn a little at random:
/// the sign of the height makes the shore. Along the shore bays and headlands alternate. Under
/// water the floor is smooth: its relief is noise, laid on once the subdivision is done.
pub fn halve(rules: &Rules, context: &EdgeContext) -> VertexGround {
    use VertexKind::{Coast, Sea};
    let (a, b) = (context.a, context.b);
    match (a.kind, b.kind) {
        (Coast, Coast) => along_shore(rules, context),
        (Sea, Sea) | (Sea, Coast) | (Coast, Sea) => under_water(floor(rules, context)),
        _ => {
            let (low, high) = terrain::ordered(a.height, b.height);
            let xi = share(context.new.seed, 0);
            // Where the shore crosses an edge is drawn anew at every level: no length of coast is
            // straight.
            let spread = if rules.landforms {
                54_000 - 2_000 * context.level.min(16) as i32
            } else {
                0
            };
            let height = mix(low, high, Q16 / 2 + mul_q16(xi - Q16 / 2, spread));
            if height <= 0 {
                under_water(height)
            } else {
                VertexGround::dry(VertexKind::Terrain, height)
            }
        }
    }
}

/// The middle of an edge along the shore: a bay or a headland in ours, so that no coast runs
/// straight; the shore itself at the finest levels, and in print and release.
fn along_shore(rules: &Rules, context: &EdgeContext) -> VertexGround {
    if !rules.landforms || context.level > 11 {
        return VertexGround::dry(VertexKind::Coast, 0);
    }
    // Six in a thousand of the edge either way, at most 40 m; headlands a little oftener than bays.
    let toss = share(context.new.seed, 1) - 26_214;
    let height = mul_q16(mul_q16(context.length, 393).min(40 * GRAINS), 2 * toss);
    if height < 0 {
        under_water(height)
    } else {
        VertexGround::dry(VertexKind::Terrain, height.max(1))
    }
}

/// Height of the sea floor between two places of it: the mean, and in ours a little to either side,
/// in proportion to the fall and to the edge, so that no facet of the control mesh shows.
fn floor(rules: &Rules, context: &EdgeContext) -> i32 {
    let (a, b) = (context.a.height, context.b.height);
    if !rules.landforms {
        return a + (b - a) / 2;
    }
    let (low, high) = terrain::ordered(a, b);
    let xi = share(context.new.seed, 0);
    let spread = 32_768 - 2_000 * context.level.min(14) as i32;
    let between = mix(low, high, Q16 / 2 + mul_q16(xi - Q16 / 2, spread));
    let toss = share(context.new.seed, 1) - Q16 / 2;
    // Up to 0.4 % of the edge either way, less in shallow water.
    let sway = mul_q16(mul_q16(context.length, 524).min(-low / 6), toss);
    (between + sway).min(-GRAINS / 4)
}

/// Sea floor: its water is the sea's.
fn under_water(height: i32) -> VertexGround {
    VertexGround {
        kind: VertexKind::Sea,
        height,
        bed: height,
        water: 0.max(height),
    }
}
