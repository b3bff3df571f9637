// Edges of the sea: sea floor, shore, and the slope from one to the other.

// Whether an edge has an end in the sea or at the shore.
fn is_shore(a: u32, b: u32) -> bool {
    return a == SEA || a == COAST || b == SEA || b == COAST;
}

// The vertex of an edge with an end in the sea, or at the shore.
fn coast_halve(rules: Rules, context: EdgeContext) -> VertexGround {
    let a = context.a.kind;
    let b = context.b.kind;
    if a == SEA && b == SEA {
        return under_water(sea_floor(rules, context));
    }
    if rules.landforms != 0u {
        return coast_shore(context);
    }
    if a == COAST && b == COAST {
        return vertex_ground_dry(COAST, 0);
    }
    if (a == SEA || a == COAST) && (b == SEA || b == COAST) {
        return under_water(sea_floor(rules, context));
    }
    // Between land and sea print and release keep the mean.
    return by_sign(coast_between(context, 0));
}

// The middle of an edge at the shore: the face there, moved by the level's octave.
fn coast_shore(context: EdgeContext) -> VertexGround {
    let relief = coast_relief_around(context);
    let mean = level_between(context);
    if context.level >= STRAIGHT_LEVEL {
        return by_sign(mean);
    }
    let bend = coast_relief_bend(relief, context);
    let before = coast_relief_away(relief, mean) + mul_q16(bend, EVEN);
    let moved = mul_q16(coast_noise(context), most_shore_move(context, relief));
    // Far from the shore the ground keeps its height.
    let away = before + mul_q16(moved, square(Q16 - min(abs(before), Q16)));
    var ground = by_sign(coast_relief_height(relief, away));
    // A lake's shore must hold its water back, so it is land.
    let touches_lake = context.a.kind == LAKE || context.b.kind == LAKE;
    if abs(away) < SHORE_REACH && !touches_lake {
        ground.kind = COAST;
    }
    return ground;
}

// The heights beside a shore, grains: how high the land stands over the sea within the faces of an
// edge, and how deep the sea is.
struct CoastRelief {
    land: i32,
    sea: i32,
}

fn coast_relief_around(context: EdgeContext) -> CoastRelief {
    let land = max(context.range.y, 0);
    let sea = max(-context.range.x, 0);
    return CoastRelief(
        max(max(land, mul_q16(sea, LEAST_SIDE)), 1),
        max(max(sea, mul_q16(land, LEAST_SIDE)), 1),
    );
}

// How far a height is from the shore: 1 at the highest land, -1 at the deepest sea; Q16.
fn coast_relief_away(relief: CoastRelief, height: i32) -> i32 {
    if height > 0 {
        return ratio(height, relief.land);
    }
    return -ratio(-height, relief.sea);
}

// How much farther from the shore the mean of an edge's ends is, by their distance, than the mean of
// their heights.
fn coast_relief_bend(relief: CoastRelief, context: EdgeContext) -> i32 {
    let a = vertex_surface(context.a);
    let b = vertex_surface(context.b);
    let places = (coast_relief_away(relief, a) + coast_relief_away(relief, b)) / 2;
    return places - coast_relief_away(relief, a + (b - a) / 2);
}

// The height so far from the shore.
fn coast_relief_height(relief: CoastRelief, away: i32) -> i32 {
    return mul_q16(select(relief.sea, relief.land, away > 0), away);
}

// Height between the ends, grains: of the face, or of the water of ends that are wet.
fn level_between(context: EdgeContext) -> i32 {
    if vertex_is_wet(context.a) || vertex_is_wet(context.b) {
        let a = vertex_surface(context.a);
        return a + (vertex_surface(context.b) - a) / 2;
    }
    return context.face;
}

// How much farther than its ends the middle of an edge is moved by the octaves of the level, about
// -1..1 in Q16.
fn coast_noise(context: EdgeContext) -> i32 {
    let cell = EDGE_BITS - min(context.level, 16u);
    let places = array(
        context.a.direction,
        context.b.direction,
        context.new_vertex.direction,
    );
    // At the ends and in the middle a long octave that counts twice, and a short one.
    var sums = array(0, 0, 0);
    for (var k = 0u; k < 6u; k++) {
        let octave = cell - k % 2u;
        let noise = gradient(places[k / 2u], octave, SHORE_SEED + octave);
        sums[k / 2u] += select(2 * noise, noise, k % 2u == 1u);
    }
    return sums[2] - (sums[0] / 2 + sums[1] / 2);
}

// How far the noise moves the shore at most, as a share of the edge, Q16.
fn most_shore_move(context: EdgeContext, relief: CoastRelief) -> i32 {
    let level = i32(min(context.level, 16u));
    let plain = max(PLAIN_MOVE[0] - level * PLAIN_MOVE[1], LEAST_MOVE);
    let loss = mul_q16(Q16 - context.new_vertex.worn, YOUNG_LOSS);
    let rocky = mul_q16(ROCKY_MOVE, Q16 - loss);
    let slope = ratio(relief.land / 2 + relief.sea / 2, context.length);
    return mix(plain, rocky, smoothstep(ROCKY[0], ROCKY[1], slope));
}

// Height of the sea floor between two places of it.
fn sea_floor(rules: Rules, context: EdgeContext) -> i32 {
    let a = context.a.height;
    let b = context.b.height;
    if rules.landforms == 0u {
        return a + (b - a) / 2;
    }
    // The draw is wide at coarse levels and narrows with each finer one.
    let spread = FLOOR_SPREAD - SPREAD_LOSS * i32(min(context.level, 14u));
    // Less sway in shallow water: at most a sixth of the depth at the deeper end.
    let most_sway = min(mul_q16(context.length, FLOOR_SWAY), -min(a, b) / 6);
    let sway = mul_q16(most_sway, centred_share(context.new_vertex.seed, 1u));
    // Never dry: between two vertices of the sea there is no shore.
    return min(coast_between(context, spread) + sway, -GRAINS / 4);
}

// A height between the ends, drawn from the middle `spread` (Q16) of their difference.
fn coast_between(context: EdgeContext, spread: i32) -> i32 {
    let ends = ordered(context.a.height, context.b.height);
    let toss = centred_share(context.new_vertex.seed, 0u);
    return mix(ends.x, ends.y, Q16 / 2 + mul_q16(toss, spread));
}

// Sea floor or land, as the height is below or above the sea.
fn by_sign(height: i32) -> VertexGround {
    if height <= 0 {
        return under_water(height);
    }
    return vertex_ground_dry(TERRAIN, height);
}

// Sea floor: its water is the sea's.
fn under_water(height: i32) -> VertexGround {
    return VertexGround(SEA, height, height, max(height, 0));
}
