//! Which of two plates goes under, with a memory, so that a front does not flicker.
//!
//! Where the kinds of crust differ the ocean goes under, and nothing need be remembered. Between
//! equal kinds the decision is kept per pair of plates and *segment* of their front: the part of it
//! in one of 384 bins of the world, about 1000 km across. A new segment takes over what most
//! segments of the pair decided; the first decides by age: the older ocean floor goes under, and
//! between continents the plate with the smaller number overrides. A segment turns over when its
//! mean ages speak against it by more than
//! [`TectonicParams::polarity_hysteresis`](crate::params::TectonicParams), and not within
//! [`LEAST_STEPS_BETWEEN_TURNS`] steps of the last turn.

use super::PlateId;
use crate::sphere::cube::CubeGrid;
use bevy::math::DVec3;
use bevy::prelude::*;

/// Bins along the edge of a face: 6 x 8 x 8 of them, about 1000 km across on Earth.
const BINS_PER_EDGE: usize = 8;

/// A decision stands for so many steps at least: 20 My with the default step.
pub const LEAST_STEPS_BETWEEN_TURNS: u16 = 10;

/// A pair of plates in the order of their numbers.
pub type Pair = (PlateId, PlateId);

/// A segment of a front: the pair of plates and the bin of the world.
pub type FrontKey = (Pair, u16);

/// The memory of one segment of a front.
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
pub struct FrontSegment {
    /// The plates.
    pub pair: Pair,
    /// The bin of the world.
    pub bin: u16,
    /// Whether the first plate of the pair goes under.
    pub first_under: bool,
    /// Steps with evidence since the decision, no more than 65,535.
    pub held: u16,
}

/// Decisions about all segments, ordered by pair and bin.
#[derive(Component, Clone, Debug, Default, PartialEq, Reflect)]
#[reflect(Component)]
pub struct PolarityMemory(pub Vec<FrontSegment>);

/// Evidence for one or the other polarity in a segment: ages of the ocean floors that meet.
#[derive(Clone, Copy, Debug, Default, Reflect)]
pub struct Evidence {
    /// Sums of ages of the first and of the second plate in My.
    pub age: [f64; 2],
    /// Number of meetings summed.
    pub count: u32,
}

impl Evidence {
    /// Adds one meeting of floors of the given ages in My.
    pub(super) fn add(&mut self, ages: [f64; 2]) {
        self.age[0] += ages[0];
        self.age[1] += ages[1];
        self.count += 1;
    }

    /// Mean age in My by which the floor of the first plate is older.
    fn excess(&self) -> f64 {
        (self.age[0] - self.age[1]) / f64::from(self.count.max(1))
    }
}

impl FrontSegment {
    /// Weighs the evidence of one more step, and turns over if it speaks clearly against the
    /// decision. Ages are in My.
    fn hear(&mut self, excess: f64, hysteresis: f64) {
        // Only steps with evidence count: a front at rest does not grow ripe for a turn.
        self.held = self.held.saturating_add(1);
        let against = if self.first_under { -excess } else { excess };
        if against > hysteresis && self.held >= LEAST_STEPS_BETWEEN_TURNS {
            self.first_under = !self.first_under;
            self.held = 0;
        }
    }
}

/// The bin of the world that holds `p`.
pub fn bin(p: DVec3) -> u16 {
    CubeGrid::new(BINS_PER_EDGE).cell(p) as u16
}

/// The pair of two plates, and whether the first argument is its second member.
pub fn pair(a: PlateId, b: PlateId) -> (Pair, bool) {
    if a <= b {
        ((a, b), false)
    } else {
        ((b, a), true)
    }
}

impl PolarityMemory {
    /// The plate of the two that goes under at `p`, if a front of theirs was ever seen.
    pub fn under(&self, a: PlateId, b: PlateId, p: DVec3) -> Option<PlateId> {
        let (pair, _) = pair(a, b);
        let first_under = match self.find(pair, bin(p)) {
            Some(at) => self.0[at].first_under,
            // Where the two have not met yet, they will do as elsewhere.
            None => self.majority(pair)?,
        };
        Some(if first_under { pair.0 } else { pair.1 })
    }

    /// Place of a segment in the memory, if it was ever seen.
    fn find(&self, pair: Pair, bin: u16) -> Option<usize> {
        let key = |segment: &FrontSegment| (segment.pair, segment.bin);
        self.0.binary_search_by_key(&(pair, bin), key).ok()
    }

    /// The decision of most segments of a pair; in a tie the first plate goes under.
    fn majority(&self, pair: Pair) -> Option<bool> {
        let start = self.0.partition_point(|s| s.pair < pair);
        let mut count = [0; 2];
        for segment in self.0[start..].iter().take_while(|s| s.pair == pair) {
            count[usize::from(segment.first_under)] += 1;
        }
        // Two that never met have no majority, not even a tie.
        (count != [0; 2]).then_some(count[1] >= count[0])
    }

    /// Decides by the evidence of one step, which is ordered by pair and bin. `hysteresis` is the
    /// difference of mean ages in My that turns a decision over.
    pub fn update(&mut self, evidence: &[(FrontKey, Evidence)], hysteresis: f64) {
        let mut fresh = Vec::new();
        for &((pair, bin), seen) in evidence {
            let excess = seen.excess();
            match self.find(pair, bin) {
                Some(at) => self.0[at].hear(excess, hysteresis),
                None => fresh.push(FrontSegment {
                    pair,
                    bin,
                    first_under: self.majority(pair).unwrap_or(excess > 0.0),
                    held: 0,
                }),
            }
        }
        // New segments wait until all are known: those of one step do not follow each other.
        if !fresh.is_empty() {
            self.0.extend(fresh);
            self.0.sort_by_key(|s| (s.pair, s.bin));
        }
    }

    /// Forgets plates that are gone.
    pub fn retain(&mut self, alive: impl Fn(PlateId) -> bool) {
        self.0.retain(|s| alive(s.pair.0) && alive(s.pair.1));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen(age: [f64; 2]) -> Evidence {
        Evidence { age, count: 1 }
    }

    /// The plate that goes under after a step in which floor of an age in My meets one of 60 My.
    fn under_after(memory: &mut PolarityMemory, age: f64) -> Option<PlateId> {
        let key = ((PlateId(1), PlateId(4)), bin(DVec3::X));
        memory.update(&[(key, seen([age, 60.0]))], 15.0);
        memory.under(PlateId(4), PlateId(1), DVec3::X)
    }

    #[test]
    fn the_older_goes_under_and_stays_under() {
        let mut memory = PolarityMemory::default();
        assert_eq!(memory.under(PlateId(1), PlateId(4), DVec3::X), None);
        for flicker in [80.0, 50.0, 100.0, 46.0, 74.0] {
            assert_eq!(
                under_after(&mut memory, flicker),
                Some(PlateId(1)),
                "{flicker}"
            );
        }
        for _ in 1..LEAST_STEPS_BETWEEN_TURNS {
            under_after(&mut memory, 44.0);
        }
        assert_eq!(under_after(&mut memory, 44.0), Some(PlateId(4)));
    }

    #[test]
    fn new_segments_follow_the_majority_of_their_pair() {
        let pair = (PlateId(0), PlateId(9));
        let mut memory = PolarityMemory::default();
        memory.update(&[((pair, 3), seen([90.0, 10.0]))], 15.0);
        memory.update(&[((pair, 7), seen([10.0, 20.0]))], 15.0);
        assert_eq!(memory.0.len(), 2);
        assert!(memory.0.iter().all(|s| s.first_under));
        memory.retain(|id| id != PlateId(9));
        assert!(memory.0.is_empty());
    }
}
