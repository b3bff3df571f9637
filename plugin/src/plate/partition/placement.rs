//! Caps on the sphere, and the choice among random places for them.

use crate::math;

/// Angular radius in rad of a cap that covers `share` of the sphere.
pub(in crate::plate) fn cap_radius(share: f64) -> f64 {
    math::acos(1.0 - 2.0 * share)
}

/// The first candidate whose score reaches `enough`, or else the one with the highest score.
pub(in crate::plate) fn first_or_best<T: Copy>(
    candidates: impl Iterator<Item = T>,
    score: impl Fn(T) -> f64,
    enough: f64,
) -> Option<T> {
    let mut best: Option<(T, f64)> = None;
    for candidate in candidates {
        let score = score(candidate);
        if best.is_none_or(|(_, highest)| score > highest) {
            best = Some((candidate, score));
        }
        if score >= enough {
            break;
        }
    }
    best.map(|(candidate, _)| candidate)
}
