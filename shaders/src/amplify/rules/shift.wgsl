// How far a new vertex moves sideways from the middle of its edge.

// A sideways displacement; shares in Q16.
struct Shift {
    // Place along the edge from its first end.
    along: i32,
    // Share of the way to the triangle's barycentre.
    inward: i32,
    // Whether the triangle is that of the edge's second face.
    second: bool,
    // Share of the displacement that is kept; 0 keeps the middle.
    weight: i32,
}

// The displacement of the vertex that halves an edge between two kinds of vertices. Of the new
// vertex the seed and the wetness are read.
fn shift(
    rules: Rules,
    edge: u32,
    kinds: vec2<u32>,
    level: u32,
    seed: u32,
    wetness: i32,
) -> Shift {
    let mouth = river_mouth(kinds.x, kinds.y);
    if rules.landforms == 0u && edge == RIVER_EDGE && mouth != NO_MOUTH {
        return spring_shift(seed, mouth);
    }
    // Uniform between a third and two thirds.
    return Shift(
        LEAST_SHIFT + mul_q16(share(seed, 12u), LEAST_SHIFT),
        LEAST_SHIFT + mul_q16(share(seed, 14u), LEAST_SHIFT),
        share(seed, 13u) >= Q16 / 2,
        shift_weight(rules, edge, kinds, level, wetness),
    );
}

// The place of a spring whose tributary joins at an end of its edge: on the edge, nearer to the land.
fn spring_shift(seed: u32, mouth: u32) -> Shift {
    let up = SPRING_PLACE[0] + mul_q16(share(seed, 12u), SPRING_PLACE[1]);
    return Shift(select(Q16 - up, up, mouth == 0u), 0, false, Q16);
}

// How much of the displacement an edge takes, Q16.
fn shift_weight(rules: Rules, edge: u32, kinds: vec2<u32>, level: u32, wetness: i32) -> i32 {
    let ours = rules.landforms != 0u;
    // Vertices of ours move less on the coarsest levels.
    let calm = select(Q16, CALM, ours && CALM_LEVELS[0] <= level && level < CALM_LEVELS[1]);
    if edge == GULLY_EDGE {
        return select(Q16, mul_q16(calm, GULLY_WEIGHT), ours);
    }
    if edge == RIVER_EDGE {
        let straightened = linear_step(STRAIGHTENING_LEVELS[0], STRAIGHTENING_LEVELS[1], i32(level));
        let weight = Q16 - arith_smooth(straightened) / 2;
        return select(0, weight, ours || level > LAST_STRAIGHT_RIVER);
    }
    if any(kinds == vec2(LAKE)) {
        return LAKE_WEIGHT;
    }
    let is_coast = any(kinds == vec2(COAST));
    if is_coast && ours {
        // The shore's noise bends it: what is moved less keeps the shape of its triangles.
        return select(0, mul_q16(calm, COAST_WEIGHT), level < COAST_LEVELS);
    }
    if is_coast || any(kinds == vec2(SEA)) {
        return select(0, Q16, level < COAST_LEVELS);
    }
    if ours {
        return mul_q16(calm, by_dryness(GROUND_WEIGHT, wetness));
    }
    return select(0, by_dryness(RELEASED_GROUND_WEIGHT, wetness), level < GROUND_LEVELS);
}

// A share of wet ground, and what dry ground adds to it; Q16.
fn by_dryness(weights: array<i32, 2>, wetness: i32) -> i32 {
    return weights[0] + mul_q16(dryness(wetness), weights[1]);
}
