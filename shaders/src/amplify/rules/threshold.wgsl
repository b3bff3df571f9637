// Threshold hillslopes: the sides of valleys stand at the angle of their rock.

// Whether the ground of a level rises so.
fn threshold_holds(level: u32) -> bool {
    return THRESHOLD_LEVELS[0] <= level && level < THRESHOLD_LEVELS[1];
}

// Height of the middle of an edge, grains.
fn threshold_height(context: EdgeContext, land: EdgeLand) -> i32 {
    let high = max(context.a.height, context.b.height);
    let tangent = threshold_tangent(context, land);
    let over_ends = edge_land_rise(context.length / 2, tangent);
    let cones = max(lowest_cone(context, over_ends, tangent), least(context));
    let over = cones - high;
    if over <= 0 {
        return cones;
    }
    // Crests keep below the crust elevation, as those of coarser levels.
    let most = room(context, land.steep);
    let taken = max(part(context.level, land.draws.chi), land.draws.crest);
    return high + mul_q16(mul_q16(most, ratio(over, over + most + 1)), taken);
}

// Tangent of the slopes around a new vertex, Q16.
fn threshold_tangent(context: EdgeContext, land: EdgeLand) -> i32 {
    let kept = mix(STEEPNESS[0], STEEPNESS[1], context.new_vertex.worn);
    let folded = Q16 + (land.draws.bulge - Q16) / FOLDED;
    return mul_q16(mul_q16(kept, folded), land.steep);
}
