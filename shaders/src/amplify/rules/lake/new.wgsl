// Rivers that widen to new lakes.

// Chance that the edge from a river vertex to the land above becomes a lake, Q16.
fn chance(rules: Rules, level: u32, river: Vertex, crust: i32, wetness: i32) -> i32 {
    let first = select(0u, FIRST_LAKE_LEVEL, rules.landforms != 0u);
    let is_lake_level = first <= level && level < rules.lake_levels;
    if !is_lake_level || river.bed <= LEAST_BED || river.branched {
        return 0;
    }
    // Less likely by a quarter with every level.
    let coarse = Q16 - i32(min(level - first, 4u)) * (Q16 / 4);
    // High crust counts twice as much as a high bed: most lakes lie in mountains.
    let high = smoothstep(HIGH_BEDS[0], HIGH_BEDS[1], river.bed)
        + 2 * smoothstep(HIGH_CRUST[0], HIGH_CRUST[1], crust);
    let wet = Q16 - mul_q16(dryness(wetness), DRY_LOSS);
    return mul_q16(mul_q16(mul_q16(rules.lake_chance, coarse), high), wet);
}

// A slope beside a river with a lake: the new vertex lies under the river's water. Of kind TERRAIN
// where no lake forms.
fn new_widened(rules: Rules, context: EdgeContext) -> VertexGround {
    let none = vertex_ground_dry(TERRAIN, 0);
    let ends = edge_context_wet_end_first(context);
    let river = ends[0];
    let land = ends[1];
    // Land lower than the water is the valley below: no lake there.
    let on_land = land.kind == TERRAIN || land.kind == GULLY;
    if !on_land || river.kind != RIVER || land.height <= river.water {
        return none;
    }
    // The valley below may also lie beside the edge.
    let ours = rules.landforms != 0u;
    let has_room = context.is_dammed && context.new_vertex.lake == 0u;
    if river.water <= river.bed || (ours && !has_room) {
        return none;
    }
    let bed = new_bed(rules, context, river.bed);
    let over = context.range.y - river.water;
    // Depths and heights of land are far from the ends of 32 bits.
    if ours && over > LAND_OVER_DEPTH * (river.water - bed) {
        return none;
    }
    let made = context.new_vertex;
    let likely = chance(rules, context.level, river, made.crust, made.wetness);
    if share(made.seed, 10u) < likely {
        return under(bed, river.water);
    }
    return none;
}

// Floor of a new lake under the bed of its river, a metre above the sea at least; grains.
fn new_bed(rules: Rules, context: EdgeContext, bed: i32) -> i32 {
    var depth = LEAST_DEPTH + mul_q16(DRAWN_DEPTH, share(context.new_vertex.seed, 11u));
    if rules.landforms != 0u {
        depth = min(depth, mul_q16(context.length, DEPTH_OF_EDGE));
    }
    return bed - max(min(depth, bed - GRAINS), 0);
}
