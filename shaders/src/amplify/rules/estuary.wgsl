// Estuaries: where the sea drowns a valley, tides widen the river towards its mouth as a funnel.

// A width, grains, at a tide.
fn estuary_widened(width: i32, tide: i32) -> i32 {
    // 2^f of a fraction f, within 0.3 %: 1 + 0.65617 f + 0.34383 f^2, exact at both ends.
    let f = (tide % OCTAVE) * (Q16 / OCTAVE);
    let part = Q16 + mul_q16(f, WIDENING) + mul_q16(square(f), Q16 - WIDENING);
    return mul_q16(width, part) << u32(tide / OCTAVE);
}
