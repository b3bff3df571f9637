//! The place of a river that is nearest to a direction.
//!
//! First that of the axis of its valley, then, in the frame of the axis there, that of the river
//! which winds about it.

use super::reach::{Reach, width};
use crate::amplify::arith::{length, mix, mul_q16, smoothstep};
use crate::amplify::curve::Curve;
use crate::amplify::fixed::{Q16, difference, q16, weigh};
use crate::amplify::geometry::{is_left, share_along};
use crate::amplify::rules::Rules;
use crate::amplify::rules::meander::{Beside, HALF_WAVE, Nearest, Wander};
use crate::amplify::scale::PlanetScale;
use crate::amplify::vertex::RiverSegment;

/// How much a way along the river counts beyond the end of a piece, upstream and downstream; Q16.
/// Beyond its upper end the bed narrows slowly, so that below a confluence it widens as slowly;
/// beyond its lower end it stops, and the next piece goes on.
const BEYOND_END: [i32; 2] = [q16(0.6), q16(1.9)];

crate::wgsl::shared!(BEYOND_END,);

/// The place of a river that is nearest to a direction.
#[derive(Clone, Copy, Debug)]
pub struct RiverPlace {
    /// The river there.
    pub reach: Reach,
    /// Where along its segment it is, Q16.
    pub along: i32,
    /// Distance to it, grains.
    pub distance: i32,
    /// Distance to the belt that its bends sweep, from which its valley's side rises; grains.
    pub belt: i32,
}

impl RiverPlace {
    /// The place of a segment's river that is nearest to a direction.
    pub fn nearest(
        scale: &PlanetScale,
        rules: &Rules,
        segment: &RiverSegment,
        direction: [i32; 3],
    ) -> Self {
        let curve = segment.curve();
        let (along, off) = curve.nearest(direction);
        if let Some(wander) = wander(scale, rules, segment) {
            let axis = Axis::at(scale, &curve, segment, along);
            let nearest = wander.nearest(along, axis.speed, axis.beside(scale, off));
            return Self::winding(scale, rules, segment, &nearest);
        }
        let mut place = Self {
            reach: Reach::at(scale, rules, segment, along),
            along,
            distance: scale.grains(off),
            belt: scale.grains(off),
        };
        if along == 0 || along == Q16 {
            let tangent = if segment.is_point() {
                segment.headings[0].map(|x| i32::from(x) << 14)
            } else {
                curve.quarter_tangent(along)
            };
            let is_lower = along == Q16 || segment.is_point();
            let off = stretched(off, tangent, BEYOND_END[usize::from(is_lower)]);
            place.stretch(scale.grains(off));
        }
        place
    }

    /// The place of a river that winds.
    fn winding(
        scale: &PlanetScale,
        rules: &Rules,
        segment: &RiverSegment,
        nearest: &Nearest,
    ) -> Self {
        let &Nearest {
            along,
            distance,
            belt,
            ..
        } = nearest;
        let mut place = Self {
            reach: Reach::at(scale, rules, segment, along),
            along,
            distance,
            belt,
        };
        if along == 0 || along == Q16 {
            let share = BEYOND_END[usize::from(along == Q16)];
            let [x, y, _] = stretched(nearest.off, nearest.tangent, share);
            place.stretch(length(x, y, 0));
        }
        place
    }

    /// Takes another distance near the bed; away from it the true one stays.
    fn stretch(&mut self, distance: i32) {
        let bed = self.reach.half_bed;
        let far = smoothstep(
            bed.saturating_mul(2),
            bed.saturating_mul(3).max(1),
            self.distance,
        );
        if far < Q16 {
            self.distance = mix(distance, self.distance, far);
        }
    }
}

/// How the river of a segment winds; `None` where it does not.
pub fn wander(scale: &PlanetScale, rules: &Rules, segment: &RiverSegment) -> Option<Wander> {
    if !rules.landforms || segment.winding == [0, 0] || segment.is_point() {
        return None;
    }
    let axis = scale.grains(difference(segment.ends[1], segment.ends[0]));
    let half_waves = segment
        .waves
        .map(|flow| mul_q16(width(scale, rules, i32::from(flow)), HALF_WAVE));
    Wander::new(segment, axis, half_waves)
}

/// The axis of a valley at a place.
struct Axis {
    /// The way up from the planet's centre.
    up: [i32; 3],
    /// A quarter of the tangent.
    tangent: [i32; 3],
    /// Length of the whole tangent, grains.
    speed: i32,
}

impl Axis {
    fn at(scale: &PlanetScale, curve: &Curve, segment: &RiverSegment, along: i32) -> Self {
        let tangent = curve.quarter_tangent(along);
        Self {
            up: segment.ends[0],
            tangent,
            speed: scale.grains(tangent).saturating_mul(4),
        }
    }

    /// A vector from there in the axis's frame.
    fn beside(&self, scale: &PlanetScale, off: [i32; 3]) -> Beside {
        let share = share_along(self.tangent, off);
        let across = [0, 1, 2].map(|i| off[i] - weigh(share, self.tangent[i]));
        let distance = scale.grains(across);
        Beside {
            along: mul_q16(self.speed / 4, share),
            across: if is_left(self.up, self.tangent, across) {
                distance
            } else {
                -distance
            },
        }
    }
}

/// A vector whose part along a tangent counts by a share of its length, Q16.
fn stretched(off: [i32; 3], tangent: [i32; 3], share: i32) -> [i32; 3] {
    let along = mul_q16(share_along(tangent, off), share - Q16);
    [0, 1, 2].map(|i| off[i] + weigh(along, tangent[i]))
}
