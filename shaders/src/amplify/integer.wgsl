// What Rust's integers have and WGSL's have not, under the names of Rust's standard library.

// |x|, that of the least number included.
fn unsigned_abs(x: i32) -> u32 {
    return select(u32(x), 0u - u32(x), x < 0);
}

fn unsigned_abs3(v: vec3<i32>) -> vec3<u32> {
    return select(vec3<u32>(v), vec3<u32>(0u) - vec3<u32>(v), v < vec3<i32>(0));
}

// Bits that a number needs: 0 for 0.
fn bit_length(x: u32) -> u32 {
    return 32u - countLeadingZeros(x);
}

// a - b, at least 0.
fn less(a: u32, b: u32) -> u32 {
    return max(a, b) - b;
}

// a + b, held within 32 bits.
fn saturating_add(a: i32, b: i32) -> i32 {
    let sum = a + b;
    // It leaves them where both have the sign that the sum has not.
    let left = ((a ^ sum) & (b ^ sum)) < 0;
    return select(sum, (a >> 31u) ^ 0x7fffffff, left);
}

// a - b, held within 32 bits.
fn saturating_sub(a: i32, b: i32) -> i32 {
    let difference = a - b;
    let left = ((a ^ b) & (a ^ difference)) < 0;
    return select(difference, (a >> 31u) ^ 0x7fffffff, left);
}

fn saturating_abs(x: i32) -> i32 {
    return i32(min(unsigned_abs(x), 0x7fffffffu));
}
