// Banks, levees and flood plains.

// Ground outside the bed of a river as its floods leave it, grains.
fn flood_plain(direction: vec3<i32>, reach: Reach, distance: i32) -> i32 {
    let bank = reach_bank(reach);
    let beyond_bed = distance - reach.half_bed;
    let width = max(BANK_WIDTH[0] * bank, reach.half_bed / BANK_WIDTH[1]);
    let beyond_bank = beyond_bed - width;
    if beyond_bank < 0 {
        // As steep as the bed's rim below, level at its top.
        let left = Q16 - ratio(beyond_bed, width);
        return reach.water + mul_q16(bank, Q16 - square(left));
    }
    // Half of the bank's height is left at the levee's foot, where it ends in a curve.
    let fallen = arith_smooth(ratio(beyond_bank, LEVEE_LENGTH * bank));
    let over_water = bank - mul_q16(bank / 2, fallen);
    return reach.water + over_water + plain_relief(direction, reach, over_water, beyond_bank);
}

// Relief of a flood plain, grains.
fn plain_relief(direction: vec3<i32>, reach: Reach, over_water: i32, beyond_bank: i32) -> i32 {
    let far = FULL_RELIEF[0] + FULL_RELIEF[1] * reach.half_bed;
    let most = min(mul_q16(over_water, MOST_RELIEF), HIGHEST_RELIEF);
    let height = mul_q16(most, arith_smooth(ratio(beyond_bank, far)));
    if height == 0 {
        return 0;
    }
    let noise = fbm(PLAIN_OCTAVES, direction, LONGEST_WAVE, PLAIN_GAIN, PLAIN_SEED);
    return mul_q16(height, clamp(noise, -Q16, Q16));
}

// The higher of two heights, with a round edge between them that begins where they differ by `edge`
// grains and is a quarter of that high.
fn smooth_max(a: i32, b: i32, edge: i32) -> i32 {
    let near = max(edge - abs(a - b), 0);
    let rounded = mul_q16(near, ratio(near, max(edge, 1))) / 4;
    return max(a, b) + rounded;
}
