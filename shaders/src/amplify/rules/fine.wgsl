// Fine ground: what the slopes of hillsides are between gullies.

// The ground in the middle of a fine edge.
fn fine_halve(rules: Rules, context: EdgeContext) -> VertexGround {
    return vertex_ground_dry(TERRAIN, fine_height(rules, context));
}

// Height in the middle of a fine edge: in ours that of the face there, and the level's own
// roughness.
fn fine_height(rules: Rules, context: EdgeContext) -> i32 {
    let ends = ordered(context.a.height, context.b.height);
    let toss = centred_share(context.new_vertex.seed, 0u);
    if rules.landforms == 0u {
        return released_height(context, ends, toss);
    }
    let drawn = mul_q16(ends.y - ends.x, mul_q16(toss, FACE_SPREAD));
    return context.face + drawn + rough(rules, context);
}

// Between the ends, in a span that narrows with the level, then up to length / 6.82 above (release).
fn released_height(context: EdgeContext, ends: vec2<i32>, toss: i32) -> i32 {
    let seed = context.new_vertex.seed;
    let level = i32(min(context.level, 16u));
    let spread = Q16 - level * level * NARROWING;
    let base = mix(ends.x, ends.y, Q16 / 2 + mul_q16(spread, toss));
    let roughness = mul_q16(share(seed, 1u), share(seed, 2u));
    let raised = base + mul_q16(mul_q16(context.length, roughness), MOST_DRAWN_UP);
    return mix(base, raised, mul_q16(share(seed, 3u), share(seed, 4u)));
}

// Roughness of a level: noise whose cells are two edges wide, a third of the slope high.
fn rough(rules: Rules, context: EdgeContext) -> i32 {
    let noise = gradient(
        context.new_vertex.direction,
        EDGE_BITS + 1u - min(context.level, 16u),
        ROUGHNESS_SEED + context.level,
    );
    // `span`, not `length`: long edges of thin faces are no rougher than others.
    let slope = uneven_steepness(rules, context.new_vertex);
    return mul_q16(mul_q16(context.span, slope), noise) / 3;
}
