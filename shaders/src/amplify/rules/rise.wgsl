// How high the ground between two drains stands: the common part of all graphs of ours.

// Height of the middle of an edge between two drains or on open ground.
fn divide(rules: Rules, context: EdgeContext) -> i32 {
    return rise_height(rules, context, DIVIDE_BULGE);
}

// Height of the middle of an edge between a drain and the land above it.
fn hillslope(rules: Rules, context: EdgeContext) -> i32 {
    // On longer edges there is a divide between the drain and the land.
    return rise_height(rules, context, select(DIVIDE_BULGE, SLOPE_BULGE, is_small(context)));
}

// Height of the middle of an edge. `bulge` (Q16) is the share of the full slope by which it overtops
// the higher end.
fn rise_height(rules: Rules, context: EdgeContext, bulge: i32) -> i32 {
    let land = edge_land_of(rules, context);
    let ends = ordered(context.a.height, context.b.height);
    let is_floor = context.level < COARSE_LEVELS && context.new_vertex.is_drained;
    var risen = 0;
    if !is_floor && threshold_holds(context.level) {
        risen = threshold_height(context, land) + rise_bend(context);
    } else {
        risen = rise_crest(rules, context, land, bulge);
        if is_floor {
            let most = most_rise(context.level, land.slope, land.draws.xi);
            risen = min(risen, max(least(context), ends.x + most));
        }
    }
    if context.level > LAST_CREST_LEVEL || context.is_descent {
        let kept = (ends.y - ends.x) / LEAST_STEP;
        return clamp(risen, ends.x + kept, ends.y - kept);
    }
    return risen;
}

// Height of the middle of an edge between a crest, if its ends are level, and an even hillside.
fn rise_crest(rules: Rules, context: EdgeContext, land: EdgeLand, bulge: i32) -> i32 {
    let high = max(context.a.height, context.b.height);
    let whole = mul_q16(bulge, land.draws.bulge);
    let even_share = evenness(context, land.slope);
    // Between level ends the ground is a crest, beside a whole slope a hillside, in between both.
    // Squared, so that a hillside stays one until its ends are nearly level.
    let towards_crest = mul_q16(mul_q16(even_share, even_share), min(whole, Q16));
    let even = mix(hillside(rules, context, land.draws.xi), high, towards_crest);
    let full = mul_q16(mul_q16(land.slope, even_share), whole);
    let crest = even + gain(context, land.draws, land.steep, full) + rise_bend(context);
    return max(min(crest, steepest(context, land)), least(context));
}

// The highest that the middle of an edge may stand over the corners around it.
fn steepest(context: EdgeContext, land: EdgeLand) -> i32 {
    let kept = STEEPEST[0] + mul_q16(land.draws.chi, STEEPEST[1]);
    return lowest_cone(context, mul_q16(land.slope, kept), mul_q16(kept, land.steep));
}

// How far the middle of a coarse edge bends up, grains.
fn rise_bend(context: EdgeContext) -> i32 {
    return select(0, context.curvature, context.level < BENT_LEVELS);
}

// Height of the middle of an edge on an even hillside.
fn hillside(rules: Rules, context: EdgeContext, xi: i32) -> i32 {
    if is_small(context) {
        // On the face itself, so that an even slope stays even under sideways moves.
        let roughness = mul_q16(rough(rules, context), HILLSIDE_ROUGHNESS);
        return context.face - foot(context) + roughness;
    }
    let ends = ordered(context.a.height, context.b.height);
    return mix(ends.x, ends.y, SPUR[min(context.level, 2u)] + mul_q16(xi, DRAWN_HILLSIDE));
}

// How far a hillside is hollow over the gully at its foot, grains.
fn foot(context: EdgeContext) -> i32 {
    let rise = context.b.height - context.a.height;
    let lower = select(context.a.kind, context.b.kind, rise < 0);
    return select(0, abs(rise) / HOLLOW_FOOT, lower == GULLY);
}
