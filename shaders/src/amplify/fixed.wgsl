// Fixed-point numbers of the ground: products of 64 bits, built from halves of 16.

// High word of the product of two 32-bit numbers, exact.
fn mul_high(a: u32, b: u32) -> u32 {
    let low = vec2(a & 0xffffu, b & 0xffffu);
    let high = vec2(a >> 16u, b >> 16u);
    // No sum of these leaves 32 bits: (2^16 - 1)^2 + 2 (2^16 - 1) = 2^32 - 1.
    let first = high.x * low.y + ((low.x * low.y) >> 16u);
    let second = low.x * high.y + (first & 0xffffu);
    return high.x * high.y + (first >> 16u) + (second >> 16u);
}

// floor(a b / 2^shift) for 1 <= shift <= 31, saturated at 2^31 - 1.
fn mul_shift(a: u32, b: u32, shift: u32) -> i32 {
    let high = mul_high(a, b);
    if (high >> (shift - 1u)) != 0u {
        return 0x7fffffff;
    }
    return i32((high << (32u - shift)) | ((a * b) >> shift));
}

// floor((a b + rounding) / 2^16), of whose 32 bits none may be lost.
fn mul_round_q16(a: i32, b: i32, rounding: u32) -> i32 {
    let low = vec2(u32(a) & 0xffffu, u32(b) & 0xffffu);
    // Of the four products of halves that of the lower ones alone has bits below 2^16.
    let lost = (low.x * low.y + rounding) >> 16u;
    return (a >> 16u) * b + i32(low.x) * (b >> 16u) + i32(lost);
}

// The product of a share of -2..2 in Q16 and a difference of directions, rounded to the nearest; it
// must fit an i32.
fn weigh(w: i32, d: i32) -> i32 {
    return mul_round_q16(w, d, 0x8000u);
}

fn weigh3(w: i32, d: vec3<i32>) -> vec3<i32> {
    return vec3(weigh(w, d.x), weigh(w, d.y), weigh(w, d.z));
}

// Difference of two directions, which must be less than 60 degrees apart.
fn difference(to: vec3<i32>, start: vec3<i32>) -> vec3<i32> {
    return to - start;
}

// Square of a difference of directions in 2^-32 of the squared radius: below a quarter.
fn square_q32(d: vec3<i32>) -> u32 {
    var sum = 0u;
    for (var i = 0u; i < 3u; i++) {
        let x = unsigned_abs(d[i]);
        // x 2^32 / ONE: the component in 2^-32 of the radius.
        let scaled = 2u * x + mul_high(x, INVERSE_FRACTION);
        sum += mul_high(scaled, scaled);
    }
    return sum;
}

// Point near the sphere -> point on it. `deficit` is 1 - |p|^2 in 2^-32; corrected to its third
// power; right to 4 units.
fn lift(p: vec3<i32>, deficit: u32) -> vec3<i32> {
    // 1/sqrt(1 - e) - 1 = e/2 + 3e^2/8 + 5e^3/16. A deficit e is below 1/4, so that thrice its
    // square fits 32 bits.
    let second = mul_high(deficit, deficit);
    let third = mul_high(second, deficit);
    let factor = deficit / 2u + second * 3u / 8u + third * 5u / 16u;
    var out = p;
    for (var i = 0u; i < 3u; i++) {
        let x = unsigned_abs(p[i]);
        // Rounded to the nearest by the highest bit that is lost.
        let step = i32(mul_high(x, factor) + ((x * factor) >> 31u));
        out[i] = select(p[i] + step, p[i] - step, p[i] < 0);
    }
    return out;
}
