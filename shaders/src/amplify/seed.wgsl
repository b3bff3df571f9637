// Random numbers without state: a vertex's seed comes from its parents' seeds, its draws from its
// own.

// The PCG-RXS-M-XS permutation of 32 bits (M. O'Neill, PCG, 2014).
fn pcg(value: u32) -> u32 {
    let state = value * PCG_FACTOR + PCG_STEP;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * PCG_OUTPUT;
    return (word >> 22u) ^ word;
}

// Seed of the vertex between two others; the same for both orders.
fn between(a: u32, b: u32) -> u32 {
    // Without the inner permutation this would be linear in the seeds, as their sum is.
    return pcg(min(a, b) ^ pcg(max(a, b) + PARENT_STEP));
}

// The `k`th random number of a seed, 32 bits.
fn draw(seed: u32, k: u32) -> u32 {
    return pcg(seed + k * DRAW_STEP);
}

// The `k`th random share of a seed, Q16, 0..65,536 exclusive.
fn share(seed: u32, k: u32) -> i32 {
    return i32(draw(seed, k) >> 16u);
}

// The `k`th random number of a seed in -1/2..1/2, Q16; at the same time its `k`th share less a half.
fn centred_share(seed: u32, k: u32) -> i32 {
    return share(seed, k) - Q16 / 2;
}
