// Slopes beside rivers and gullies.

// The slope beside a river.
fn from_river(rules: Rules, context: EdgeContext) -> VertexGround {
    let ends = edge_context_wet_end_first(context);
    if has_common_slope(rules, context) {
        return vertex_ground_dry(TERRAIN, common_slope(rules, context));
    }
    return vertex_ground_dry(TERRAIN, slope_above_river(context, ends[0], ends[1]));
}

// The slope beside a gully.
fn from_gully(rules: Rules, context: EdgeContext) -> VertexGround {
    if has_common_slope(rules, context) {
        return vertex_ground_dry(TERRAIN, common_slope(rules, context));
    }
    if context.a.kind == GULLY {
        return vertex_ground_dry(TERRAIN, slope_above_gully(context, context.a, context.b));
    }
    return vertex_ground_dry(TERRAIN, slope_above_gully(context, context.b, context.a));
}

// Whether slopes are none of their own: those of fine ground, and all of ours.
fn has_common_slope(rules: Rules, context: EdgeContext) -> bool {
    return context.level >= rules.fine_level || rules.landforms != 0u;
}

// Height of such a slope, grains.
fn common_slope(rules: Rules, context: EdgeContext) -> i32 {
    if context.level >= rules.fine_level {
        return fine_height(rules, context);
    }
    return hillslope(rules, context);
}

// A share of the way from a river up to the land; land below its river rises over it. Grains.
fn slope_above_river(context: EdgeContext, river: Vertex, land: Vertex) -> i32 {
    let xi = share(context.new_vertex.seed, 0u);
    let r = cliff(xi, mul_q16(square(xi), xi), context.new_vertex.plateau);
    if land.height < river.height {
        return river.height + mul_q16(low_land_rise(context, river), drawn_share(LOW_LAND_SHARE, r));
    }
    return mix(river.height, land.height, drawn_share(RIVER_SHARE, r));
}

// A share of the way from a gully up to a little over the land; land below its gully rises over it.
// Grains.
fn slope_above_gully(context: EdgeContext, gully: Vertex, land: Vertex) -> i32 {
    let xi = share(context.new_vertex.seed, 0u);
    let r = cliff(xi, square(xi), context.new_vertex.plateau);
    let way = drawn_share(GULLY_SHARE, r);
    if land.height < gully.height {
        return gully.height + mul_q16(low_land_rise(context, gully), way);
    }
    let most = max(context.new_vertex.crust - land.height, LEAST_ROOM_OVER_LAND);
    let aim = land.height + min(most, mul_q16(context.length, AIM_OVER_LAND));
    return mix(gully.height, aim, way);
}

// Most that land below its drain rises over it, grains.
fn low_land_rise(context: EdgeContext, drain: Vertex) -> i32 {
    let most = max(context.new_vertex.crust - drain.height, LEAST_ROOM_OVER_DRAIN);
    return min(most, mul_q16(context.length, RISE_FROM_DRAIN));
}

// A least share and what a draw adds to it, Q16.
fn drawn_share(bounds: array<i32, 2>, drawn: i32) -> i32 {
    return bounds[0] + mul_q16(drawn, bounds[1]);
}
