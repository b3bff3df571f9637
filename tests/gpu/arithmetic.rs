//! Bits of integer and fixed-point arithmetic, and of random numbers.

use pangaea_shaders::amplify::arith::{
    cos_turn, isqrt, length, linear_step, mix, mul_q16, ordered, pow_1_5, ratio, saturate,
    signed_ratio, smooth, smoothstep, sqrt_q16, square,
};
use pangaea_shaders::amplify::fixed::{Q16, lift, mul_high, mul_shift, square_q32, weigh};
use pangaea_shaders::amplify::seed::{between, centred_share, draw, pcg, share};
use pangaea_tests::gpu::assert_twin;

const FIXED: &str = "amplify/fixed";
const ARITH: &str = "amplify/arith";
const SEED: &str = "amplify/seed";

/// Pairs whose product in Q16 fits 32 bits, rounded or not.
fn fits((a, b): (i32, i32)) -> Option<(i32, i32)> {
    let product = (i64::from(a) * i64::from(b) + 0x8000) >> 16;
    i32::try_from(product).is_ok().then_some((a, b))
}

/// A share of 0..1 made of any number.
pub(super) fn any_share(t: i32) -> i32 {
    if t.unsigned_abs() <= Q16 as u32 {
        t.abs()
    } else {
        t & 0xffff
    }
}

#[test]
fn wide_products_have_the_same_bits() {
    assert_twin(FIXED, "mul_high", Some, |(a, b)| mul_high(a, b));
    let shift = |(a, b, shift): (u32, u32, u32)| Some((a, b, 1 + shift % 31));
    assert_twin(FIXED, "mul_shift", shift, |(a, b, shift)| {
        mul_shift(a, b, shift)
    });
    assert_twin(FIXED, "weigh", fits, |(w, d)| weigh(w, d));
    assert_twin(ARITH, "mul_q16", fits, |(a, b)| mul_q16(a, b));
}

#[test]
fn places_on_the_sphere_have_the_same_bits() {
    // A chord below 60°.
    let small = |(d,): ([i32; 3],)| Some((d.map(|x| x >> 2),));
    assert_twin(FIXED, "square_q32", small, |(d,)| square_q32(d));
    let deficit = |(p, e): ([i32; 3], u32)| Some((p.map(|x| x >> 1), e >> 2));
    assert_twin(FIXED, "lift", deficit, |(p, e)| lift(p, e));
}

#[test]
fn ratios_and_roots_have_the_same_bits() {
    let positive = |(a, b): (i32, i32)| Some((a & i32::MAX, b & i32::MAX));
    assert_twin(ARITH, "ratio", positive, |(a, b)| ratio(a, b));
    let whole = |(a, b): (i32, i32)| (a != i32::MIN).then_some((a, b & i32::MAX));
    assert_twin(ARITH, "signed_ratio", whole, |(a, b)| signed_ratio(a, b));
    assert_twin(ARITH, "isqrt", Some, |(x,)| isqrt(x));
    assert_twin(ARITH, "sqrt_q16", Some, |(t,)| sqrt_q16(t));
    let near = |(x, y, z): (i32, i32, i32)| Some((x >> 1, y >> 1, z >> 1));
    assert_twin(ARITH, "length", near, |(x, y, z)| length(x, y, z));
}

#[test]
fn roots_of_squares_and_their_neighbours_have_the_same_bits() {
    let near_square = |(x,): (u32,)| Some(((x >> 16).pow(2).wrapping_add(x % 3).wrapping_sub(1),));
    assert_twin(ARITH, "isqrt", near_square, |(x,)| isqrt(x));
}

#[test]
fn steps_and_blends_have_the_same_bits() {
    let halves = |(a, b, t): (i32, i32, i32)| Some((a >> 1, b >> 1, any_share(t)));
    assert_twin(ARITH, "mix", halves, |(a, b, t)| mix(a, b, t));
    let between = |(low, high, x): (i32, i32, i32)| {
        let (low, high, x) = (low >> 1, high >> 1, x >> 1);
        (low < high && x.checked_sub(low).is_some()).then_some((low, high, x))
    };
    assert_twin(ARITH, "linear_step", between, |(a, b, x)| {
        linear_step(a, b, x)
    });
    assert_twin(ARITH, "smoothstep", between, |(a, b, x)| {
        smoothstep(a, b, x)
    });
    assert_twin(ARITH, "arith_smooth", Some, |(t,)| smooth(t));
    assert_twin(ARITH, "saturate", Some, |(t,)| saturate(t));
    assert_twin(ARITH, "ordered", Some, |(a, b)| ordered(a, b));
}

#[test]
fn powers_and_waves_have_the_same_bits() {
    assert_twin(
        ARITH,
        "pow_1_5",
        |(t,)| Some((any_share(t),)),
        |(t,)| pow_1_5(t),
    );
    let small = |(t,): (i32,)| fits((t, t)).map(|_| (t,));
    assert_twin(ARITH, "square", small, |(t,)| square(t));
    assert_twin(ARITH, "cos_turn", Some, |(t,)| cos_turn(t));
}

#[test]
fn random_numbers_have_the_same_bits() {
    assert_twin(SEED, "pcg", Some, |(x,)| pcg(x));
    assert_twin(SEED, "between", Some, |(a, b)| between(a, b));
    assert_twin(SEED, "draw", Some, |(seed, k)| draw(seed, k));
    assert_twin(SEED, "share", Some, |(seed, k)| share(seed, k));
    assert_twin(SEED, "centred_share", Some, |(seed, k)| {
        centred_share(seed, k)
    });
}
