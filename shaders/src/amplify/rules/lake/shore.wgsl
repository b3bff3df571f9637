// Shores and floors of lakes of ours: one continuous height from the floor up to the land.

// Between two vertices of a lake: its floor, or an island where that is shallow.
fn lake_floor(rules: Rules, edge: u32, context: EdgeContext) -> VertexGround {
    let a = context.a;
    let b = context.b;
    let level = context.new_vertex.lake_level;
    let between = level - (a.bed + (b.bed - a.bed) / 2);
    if edge == RIVER_EDGE {
        return under(level - between, level);
    }
    let depth = between + deepening(rules, context, between);
    // Waves of one edge: of longer ones whole rings of vertices would emerge.
    let uneven = shore_relief(rules, context, mul_q16(depth, FLOOR_RELIEF), EDGE_BITS);
    let over = max(uneven, uneven / 4) - depth;
    if over < 0 {
        return under(level + over, level);
    }
    return vertex_ground_dry(TERRAIN, level + 1 + over);
}

// How much deeper a lake is than between its vertices, grains.
fn deepening(rules: Rules, context: EdgeContext, depth: i32) -> i32 {
    // Halved once more on every level: a parabola, which has no creases.
    let basin = mul_q16(full_relief(rules, context), DEEPENING) >> min(context.level, 16u);
    return min(min(basin, depth), max(DEEPEST - depth, 0));
}

// Between a lake and land that is not lower: lake or land, as the height lies below the level or
// above.
fn lake_shore(rules: Rules, context: EdgeContext) -> VertexGround {
    let level = context.new_vertex.lake_level;
    let first_is_lake = context.a.kind == LAKE && context.a.water == level;
    let depth = level - select(context.b.bed, context.a.bed, first_is_lake);
    let rise = select(context.a.height, context.b.height, first_is_lake) - level;
    let most = mul_q16(depth / 2 + rise / 2, SHORE_RELIEF);
    let kept = Q16 - hollow(rules, context, rise + depth);
    let even = mul_q16(rise / 2 - depth / 2, kept);
    let height = even + shore_relief(rules, context, most, EDGE_BITS + 1u);
    if height <= 0 {
        return under(level - shelving(context.level, -height, depth), level);
    }
    let over = onto_land(rules, context, height, rise);
    return vertex_ground_dry(TERRAIN, level + max(over, 1));
}

// How far the shore lies from where an even slope would cross the water, towards the middle of its
// edge, Q16. Ends of the edge differ by `fall` grains.
fn hollow(rules: Rules, context: EdgeContext, fall: i32) -> i32 {
    let drawn = HOLLOW[0] - HOLLOW[1] * i32(min(context.level, 16u));
    // Halves, so that no edge of any planet is too long.
    let steep = mul_q16(context.length / 2, uneven_steepness(rules, context.new_vertex));
    return mul_q16(max(drawn, 0), ratio(steep, max(fall / 2, 1)));
}

// Relief of the ground in and beside a lake, at most `most` grains high or deep. Its waves on level 0
// are 2^`wave` direction units.
fn shore_relief(rules: Rules, context: EdgeContext, most: i32, wave: u32) -> i32 {
    let noise = gradient(
        context.new_vertex.direction,
        wave - min(context.level, 16u),
        LAKE_SHORE_SEED + context.level,
    );
    let calm = linear_step(LAKE_CALM_LEVELS[0], LAKE_CALM_LEVELS[1], i32(context.level));
    let height = min(mul_q16(full_relief(rules, context), Q16 - calm), most);
    return mul_q16(height, clamp(mul_q16(noise, STRETCH), -Q16, Q16));
}

// Relief of the land over an edge, grains.
fn full_relief(rules: Rules, context: EdgeContext) -> i32 {
    let steep = uneven_steepness(rules, context.new_vertex);
    return mul_q16(context.span, mul_q16(steep, ROUGHNESS));
}

// Depth where the even slope from the shore down to a `depth` has that of `even`.
fn shelving(level: u32, depth_of_even: i32, depth: i32) -> i32 {
    let even = min(depth_of_even, max(depth, DEEPEST));
    if level >= STRAIGHT_LEVEL || even >= depth {
        return even;
    }
    // The root of the power 1.5, which is 0.75.
    return mul_q16(depth, sqrt_q16(pow_1_5(ratio(even, depth))));
}

// Height over the lake of land on the way from the shore, where the even slope has `even`, up to the
// land's `rise`.
fn onto_land(rules: Rules, context: EdgeContext, even: i32, rise: i32) -> i32 {
    if context.level >= rules.fine_level {
        return even;
    }
    let slope = hillslope(rules, lifted_context(context));
    let inland = ratio(2 * even, max(rise, 1));
    return mix(even, slope - context.new_vertex.lake_level, inland);
}
