// The land at the middle of an edge: how steep it is, and how low it may stand.

// The land at the middle of an edge, as all rules of its rise see it.
struct EdgeLand {
    // Tangent of its slopes, Q16.
    steep: i32,
    // Rise of such a slope over half of the edge, grains.
    slope: i32,
    // Its draws.
    draws: RiseDraws,
}

fn edge_land_of(rules: Rules, context: EdgeContext) -> EdgeLand {
    let steep = steepness(rules, context.new_vertex);
    return EdgeLand(steep, edge_land_slope(context, steep), rise_draws_of(context));
}

// Whether an edge is no longer than a hillside.
fn is_small(context: EdgeContext) -> bool {
    return context.level >= FACE_LEVEL;
}

// Rise over half the edge at the landform's steepness, grains.
fn edge_land_slope(context: EdgeContext, steep: i32) -> i32 {
    // An edge along a thin face is long, but the rock beside it is no larger than that of others.
    let shorter = min(context.length, context.span);
    return edge_land_rise(select(context.length, shorter, is_small(context)) / 2, steep);
}

// Rise of a slope of a tangent (Q16) over a distance, grains.
fn edge_land_rise(distance: i32, tangent: i32) -> i32 {
    return min(mul_q16(distance, tangent), MOST_SLOPE);
}

// The lowest of the cones over the corners around the middle of an edge, grains.
fn lowest_cone(context: EdgeContext, over_ends: i32, tangent: i32) -> i32 {
    var lowest = min(context.a.height, context.b.height) + over_ends;
    for (var side = 0u; side < 2u; side++) {
        let corner = context.beside[side];
        if corner.is_known {
            lowest = min(lowest, corner.height + edge_land_rise(corner.distance, tangent));
        }
    }
    return lowest;
}

// The lowest that the middle of an edge may stand, so that it drains to the lower end.
fn least(context: EdgeContext) -> i32 {
    let ends = ordered(context.a.height, context.b.height);
    // The last term lifts the middle of a level edge, by a 4096th of its length.
    let lowest = mix(ends.x, ends.y, EDGE_LEAST_RISE) + max(context.length >> 12u, 1);
    // A small face drains to its lowest corner, which need not be an end of the edge.
    return select(lowest, min(lowest, context.face), is_small(context));
}
