//! Threshold hillslopes: ground that rises from its valleys as steeply as its rock bears.
//!
//! Where rivers cut faster than rock weathers, landslides hold all slopes at one angle, however fast
//! the land rises (Burbank et al. 1996; Montgomery and Brandon 2002). The middle of an edge then
//! stands where the cones over the corners around it meet:
//!
//! ```text
//! h = min (h_c + s · d_c)
//! ```
//!
//! with the height h_c of a corner, its distance d_c and the tangent s. On an even side of a valley
//! that is the side itself; between two valleys it is a sharp crest, which stands the higher the
//! farther they are apart, and between the tributaries of a valley a spur. So ground of this kind
//! needs no draw of its own. Worn land creeps to slopes gentler than its rock would bear.

use super::divide::{part, room};
use super::edge_land::{EdgeLand, least, lowest_cone, rise};
use crate::amplify::arith::{mix, mul_q16, ratio};
use crate::amplify::fixed::{Q16, q16};
use crate::amplify::vertex::EdgeContext;

/// Levels whose ground is of this kind, first and one beyond the last: edges of 13 to 1.6 km, twice
/// the length of hillsides. Longer ones span whole ranges, shorter ones the roughness of hillsides.
const LEVELS: [u32; 2] = [2, 6];

/// Tangent of threshold slopes, as a share of the landform's, and that of worn land.
const STEEPNESS: [i32; 2] = [q16(0.5), q16(0.4)];

/// Part of a fold's bulge by which slopes on anticlines are steeper, and in synclines gentler.
const FOLDED: i32 = 2;

crate::wgsl::shared!(THRESHOLD_LEVELS = LEVELS, STEEPNESS, FOLDED,);

/// Whether the ground of a level rises so.
pub(super) const fn holds(level: u32) -> bool {
    LEVELS[0] <= level && level < LEVELS[1]
}

/// Height of the middle of an edge, grains.
pub(super) fn height(context: &EdgeContext, land: &EdgeLand) -> i32 {
    let high = context.a.height.max(context.b.height);
    let tangent = tangent(context, land);
    let over_ends = rise(context.length / 2, tangent);
    let cones = lowest_cone(context, over_ends, tangent).max(least(context));
    let over = cones - high;
    if over <= 0 {
        return cones;
    }
    // Crests keep below C, as those of coarser levels.
    let room = room(context, land.steep);
    let part = part(context.level, land.draws.chi).max(land.draws.crest);
    high + mul_q16(mul_q16(room, ratio(over, over + room + 1)), part)
}

/// Tangent s of the slopes around a new vertex, Q16.
fn tangent(context: &EdgeContext, land: &EdgeLand) -> i32 {
    let [young, old] = STEEPNESS;
    let share = mix(young, old, i32::from(context.new.worn));
    let folded = Q16 + (land.draws.bulge - Q16) / FOLDED;
    mul_q16(mul_q16(share, folded), land.steep)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::amplify::fixed::metres;
    use crate::amplify::rules::Rules;
    use crate::amplify::rules::graph_tests::between_two;
    use crate::amplify::vertex::{CornerBeside, Vertex};

    /// Land of a young belt, unfolded, under a crust so high that it bounds nothing.
    fn land(height: i32) -> Vertex {
        Vertex {
            height,
            bed: height,
            crust: metres(60_000),
            ..Vertex::default()
        }
    }

    /// The middle of an edge of 8 km between two heights, its tangent, and the lowest cone; `beside`
    /// are the corners.
    fn middle(ends: [i32; 2], beside: [Option<CornerBeside>; 2]) -> (i32, i32) {
        let [a, b] = ends.map(land);
        let new = land(0);
        let context = EdgeContext {
            beside,
            ..between_two([&a, &b], &new, 4, metres(8_000))
        };
        let edge = EdgeLand::of(&Rules::default(), &context);
        (height(&context, &edge), tangent(&context, &edge))
    }

    fn corner(height: i32) -> Option<CornerBeside> {
        Some(CornerBeside {
            height,
            distance: metres(7_000),
        })
    }

    #[test]
    fn an_even_side_of_a_valley_stays_even() {
        let (_, tangent) = middle([0; 2], [None; 2]);
        // Down the slope: the upper end stands a whole edge higher, the corners half-way.
        let whole = mul_q16(metres(8_000), tangent);
        let (found, _) = middle([0, whole], [corner(whole / 2); 2]);
        assert!((found - whole / 2).abs() <= 1, "{found} of {whole}");
        // Across it: one corner below, one above.
        let beside = mul_q16(metres(7_000), tangent);
        let (found, _) = middle(
            [metres(2_000); 2],
            [-beside, beside].map(|rise| corner(metres(2_000) + rise)),
        );
        // A level edge rises by a 4096th of its length.
        assert!((found - metres(2_000)).abs() <= metres(2), "{found}");
    }

    #[test]
    fn crests_stand_as_high_as_their_valleys_are_far_apart() {
        let (found, tangent) = middle([0; 2], [None; 2]);
        let cone = mul_q16(metres(4_000), tangent);
        // Less what the room under the crust and the draw of it leave.
        assert!(found > cone / 3 && found < cone, "{found} of {cone}");
        // A deep valley beside a crest holds it down.
        let (held, _) = middle([0; 2], [corner(-metres(6_000)); 2]);
        assert!(0 < held && held < cone / 10, "{held} of {cone}");
    }

    /// The tangent of slopes in a belt of collision that is worn so far.
    fn tangent_of_worn(worn: u16) -> i32 {
        let collided = Vertex {
            worn,
            collision: u16::MAX,
            ..land(0)
        };
        let context = between_two([&collided; 2], &collided, 4, metres(8_000));
        tangent(&context, &EdgeLand::of(&Rules::default(), &context))
    }

    #[test]
    fn worn_land_is_gentler() {
        assert!(tangent_of_worn(u16::MAX) < tangent_of_worn(0));
    }
}
