//! Estuaries: where the sea drowns a valley, tides widen the river towards its mouth as a funnel,
//! W(x) = W₀ 2^(x / l) along the way x (H. Savenije, Salinity and Tides in Alluvial Estuaries,
//! 2005: widths of estuaries are exponential, e-folding in 10 to 100 km).
//!
//! A vertex of a river carries the binary logarithm of its widening, its *tide*: it is linear along
//! the river, so that halves of edges have the mean of their ends.

use crate::amplify::arith::{linear_step, mix, mul_q16, square};
use crate::amplify::fixed::{Q16, metres, q16};

/// An octave of a tide: a widening by two.
pub const OCTAVE: i32 = 256;

/// Fall of a shelf up to which a mouth is widened least, and from which on most: deep water beside
/// the land has filled with no sediment.
const SHELF_FALL: [i32; 2] = [q16(0.002), q16(0.01)];

/// Least and most tide of a mouth: 4 and 16 times as wide as the river.
const MOUTH_TIDE: [i32; 2] = [2 * OCTAVE, 4 * OCTAVE];

/// Way along which a brook's funnel doubles its width, as a share of the control mesh's edge: 13 km
/// of 52.
const OCTAVE_LENGTH: i32 = q16(0.25);

/// How much more of it a river of flow φ = 1 has, grains: ten of its widths.
const GREAT_OCTAVE: i32 = metres(21_470);

/// How much of an octave's widening goes evenly with its part.
const WIDENING: i32 = q16(0.65617);

crate::wgsl::shared!(OCTAVE, WIDENING,);

/// Tide of a mouth before a shelf that falls so much, Q16.
pub fn mouth(fall: i32) -> i32 {
    let steep = linear_step(SHELF_FALL[0], SHELF_FALL[1], fall);
    mix(MOUTH_TIDE[0], MOUTH_TIDE[1], steep)
}

/// Tide of a river of a flow (Q16) at `way` grains up from a place with a tide; `edge` is the
/// control mesh's, grains.
pub fn upstream(tide: i32, way: i32, flow: i32, edge: i32) -> i32 {
    let octave = mul_q16(edge, OCTAVE_LENGTH) + mul_q16(GREAT_OCTAVE, flow);
    // Per octave in sixteenths of the way, which stays in 32 bits over several edges.
    let loss = way / (octave / OCTAVE).max(1);
    (tide - loss).max(0)
}

/// A width, grains, at a tide.
///
/// ```
/// use pangaea_shaders::amplify::rules::estuary::{OCTAVE, widened};
///
/// assert_eq!([0, OCTAVE, 3 * OCTAVE].map(|tide| widened(1000, tide)), [1000, 2000, 8000]);
/// ```
pub fn widened(width: i32, tide: i32) -> i32 {
    // 2^f of a fraction f, within 0.3 %: 1 + 0.65617 f + 0.34383 f², exact at both ends.
    let f = (tide % OCTAVE) * (Q16 / OCTAVE);
    let part = Q16 + mul_q16(f, WIDENING) + mul_q16(square(f), Q16 - WIDENING);
    mul_q16(width, part) << (tide / OCTAVE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_are_exponential() {
        // Roots of two, by quarters of an octave.
        let quarters = [1.0, 1.189_207, std::f64::consts::SQRT_2, 1.681_793];
        for (quarter, root) in (0..).zip(quarters) {
            for octave in 0..5 {
                let found = widened(100_000, octave * OCTAVE + quarter * OCTAVE / 4);
                let expected = 1e5 * root * f64::from(1 << octave);
                let off = f64::from(found) / expected - 1.0;
                assert!(off.abs() < 0.004, "{octave} {quarter}: {found} {expected}");
            }
        }
        let widths = (0..5 * OCTAVE).map(|tide| widened(100_000, tide));
        assert!(widths.is_sorted());
    }

    #[test]
    fn tides_of_mouths_follow_their_shelves() {
        let per_mille = |x: f64| mouth(q16(x / 1000.0));
        assert_eq!(
            [0.0, 2.0, 10.0, 80.0].map(per_mille),
            [512, 512, 1024, 1024]
        );
        assert!((per_mille(6.0) - 768).abs() <= 1);
    }

    #[test]
    fn a_funnel_halves_over_an_octave_of_the_way() {
        let edge = metres(52_000);
        let km = |x: i32| upstream(1024, metres(1000 * x), 0, edge);
        assert_eq!(km(0), 1024);
        assert!((km(13) - 768).abs() <= 1 && (km(26) - 512).abs() <= 1);
        assert_eq!([km(53), km(300)], [0, 0]);
        // The greatest rivers' are as long as 34.5 km an octave.
        assert!((upstream(1024, metres(34_470), Q16, edge) - 768).abs() <= 1);
    }
}
