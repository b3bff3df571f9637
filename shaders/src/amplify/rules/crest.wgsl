// Crests: the ground between two rivers, or between two gullies.

// The crest between two rivers: above both.
fn between_rivers(rules: Rules, context: EdgeContext) -> VertexGround {
    let drawn = share(context.new_vertex.seed, 0u);
    return vertex_ground_dry(TERRAIN, crest_height(rules, context, LEAST_OVER_RIVERS, drawn));
}

// The crest between two gullies: above both.
fn between_gullies(rules: Rules, context: EdgeContext) -> VertexGround {
    let xi = share(context.new_vertex.seed, 0u);
    let drawn = cliff(xi, mul_q16(square(xi), xi), context.new_vertex.plateau);
    return vertex_ground_dry(TERRAIN, crest_height(rules, context, LEAST_OVER_GULLIES, drawn));
}

// Height of a crest, grains.
fn crest_height(rules: Rules, context: EdgeContext, over: i32, drawn: i32) -> i32 {
    if rules.landforms != 0u {
        return divide(rules, context);
    }
    if context.level >= rules.fine_level {
        return fine_height(rules, context);
    }
    let rise = mul_q16(context.length, rules.crest_rise);
    let over_drains = max(context.a.height, context.b.height) + min(rise, over);
    let kept = Q16 - mul_q16(square(drawn), DRAWN_SHARE);
    return max(over_drains, mul_q16(min(rise, context.new_vertex.crust), kept));
}
