// Integer arithmetic of the rules: products, ratios, roots and blends of Q16 shares and of grains.

// floor(a b / 2^16); it must fit an i32.
fn mul_q16(a: i32, b: i32) -> i32 {
    return mul_round_q16(a, b, 0u);
}

// a (1 - t) + b t for a share t in Q16; exact at both ends, whose difference must fit an i32.
fn mix(a: i32, b: i32, t: i32) -> i32 {
    return a + mul_q16(b - a, t);
}

// Lower and higher of two.
fn ordered(a: i32, b: i32) -> vec2<i32> {
    return vec2(min(a, b), max(a, b));
}

// The number of 0..1 in Q16 that is nearest to t.
fn saturate(t: i32) -> i32 {
    return clamp(t, 0, Q16);
}

// floor(a / b) in Q16 for a, b >= 0, saturated to 0..1; 1 where b is 0. Exact for b < 2^24, else
// within 2^-22 of the share.
fn ratio(a: i32, b: i32) -> i32 {
    if a <= 0 {
        return select(0, Q16, b <= 0);
    }
    // Saturation comes first, so that the digits below are true fractions.
    if a >= b {
        return Q16;
    }
    // Two digits of eight bits, so that the remainder never leaves 32 bits.
    // The divisor keeps 24 bits, so that a remainder has room for eight more.
    let shift = less(bit_length(u32(b)), 24u);
    let divisor = u32(b) >> shift;
    let first = (u32(a) >> shift) << 8u;
    let second = (first % divisor) << 8u;
    return i32(((first / divisor) << 8u) + second / divisor);
}

// A ratio of -1..1 in Q16; `whole` is not negative, and nothing is a part of 0.
fn signed_ratio(part: i32, whole: i32) -> i32 {
    if part == 0 {
        return 0;
    }
    let share = ratio(abs(part), whole);
    return select(share, -share, part < 0);
}

// Where x stands between two edges, 0..1 in Q16, linear. `low` < `high`.
fn linear_step(low: i32, high: i32, x: i32) -> i32 {
    return ratio(x - low, high - low);
}

// 3t^2 - 2t^3 of a share in Q16; monotone, 0 at 0 and 1 at 1.
fn arith_smooth(t: i32) -> i32 {
    let share = saturate(t);
    return mul_q16(mul_q16(share, share), 3 * Q16 - 2 * share);
}

// The cubic Hermite step from 0 at `low` to 1 at `high`, Q16.
fn smoothstep(low: i32, high: i32, x: i32) -> i32 {
    return arith_smooth(linear_step(low, high, x));
}

// floor(sqrt(x)), exact.
fn isqrt(x: u32) -> u32 {
    if x == 0u {
        return 0u;
    }
    // Shifted by pairs of bits, so that the root has sixteen bits.
    let shift = countLeadingZeros(x) & ~1u;
    let y = x << shift;
    // The guess is a parabola of u = y / 2^30 in 1..4, within 0.5 %.
    let u = y >> 16u;
    let bend = (((u * u) >> 16u) * ROOT_SQUARE) >> 16u;
    let guess = ROOT_CONSTANT + ((u * ROOT_SLOPE) >> 15u) - bend;
    // One step of Newton's never ends below the root, and at most one above.
    var root = (guess + y / guess) >> 1u;
    if root > 0xffffu || root * root > y {
        root -= 1u;
    }
    return root >> (shift / 2u);
}

// sqrt(t) of a share in Q16, rounded down to a multiple of 2^-16.
fn sqrt_q16(t: i32) -> i32 {
    if t >= Q16 {
        return Q16;
    }
    // sqrt(t / 2^16) in Q16 is sqrt(t 2^16).
    return i32(isqrt(u32(max(t, 0)) << 16u));
}

// t^1.5 of a share in Q16.
fn pow_1_5(t: i32) -> i32 {
    return mul_q16(t, sqrt_q16(t));
}

// t^2 of a share in Q16.
fn square(t: i32) -> i32 {
    return mul_q16(t, t);
}

// Length of a vector of components below 2^30, rounded; relative error below 2^-13.
fn length(x: i32, y: i32, z: i32) -> i32 {
    let v = unsigned_abs3(vec3(x, y, z));
    // Three squares of 15-bit numbers sum to less than 2^32.
    let shift = less(bit_length(v.x | v.y | v.z), 15u);
    let short = v >> vec3(shift);
    let root = isqrt(short.x * short.x + short.y * short.y + short.z * short.z);
    return i32(root << shift);
}

// cos(2 pi t) of a phase whose whole turn is 2^16, Q16. Error below 0.001; even and periodic to the
// last bit.
fn cos_turn(t: i32) -> i32 {
    // Folded to a quarter: x in 0..=2^14 from a crest, sign by half turns.
    let turn = t & 0xffff;
    let half = select(turn, Q16 - turn, turn > 0x8000);
    let beyond = half > 0x4000;
    let x = select(half, 0x8000 - half, beyond);
    // cos(pi u / 2) with u = x / 2^14: 1 - u^2 (a - u^2 (b - c u^2)), a - b + c = 1.
    let u2 = square(x << 2u);
    let inner = COSINE_B - mul_q16(COSINE_C, u2);
    let cosine = Q16 - mul_q16(COSINE_A - mul_q16(inner, u2), u2);
    return select(cosine, -cosine, beyond);
}
