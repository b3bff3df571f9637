// Gullies: dry drainage lines that cut the slopes between rivers.

// The vertex that halves a gully edge.
fn gully_along(rules: Rules, context: EdgeContext) -> VertexGround {
    let xi = share(context.new_vertex.seed, 0u);
    let ends = ordered(context.a.height, context.b.height);
    var rise = GULLY_LEAST_RISE;
    if rules.landforms != 0u {
        rise = min(HOLLOW_RISE + HOLLOW_LOSS * i32(min(context.level, HOLLOW_LEVELS)), rise);
    }
    let height = mix(ends.x, ends.y, rise + mul_q16(xi, DRAWN_RISE));
    // A gully that ends in a river must lie above it.
    let joins = vertex_is_wet(context.a) || vertex_is_wet(context.b);
    let river = select(context.a.height, context.b.height, vertex_is_wet(context.b));
    // Its land lies below the river: no share of the way reaches above it.
    if joins && height <= river {
        return vertex_ground_dry(GULLY, gully_above_river(rules, context, river));
    }
    return vertex_ground_dry(GULLY, height);
}

// Height of a gully over a river that its land does not overtop, grains.
fn gully_above_river(rules: Rules, context: EdgeContext, river: i32) -> i32 {
    let ours = rules.landforms != 0u;
    let least = select(LEAST_RISE_FROM_RIVER, OUR_LEAST_RISE_FROM_RIVER, ours);
    let most = min(mul_q16(context.length, RISE_FROM_RIVER), MOST_RISE_FROM_RIVER);
    return river + least + mul_q16(most, share(context.new_vertex.seed, 0u));
}

// Whether an internal edge of a level becomes a tributary of the river at its junction.
fn is_tributary(rules: Rules, level: u32, flow: i32, height: i32, spring: i32, seed: u32) -> bool {
    let levels = rules.tributary_levels;
    if level < levels.x || level >= levels.y || spring <= height {
        return false;
    }
    // Great rivers branch less.
    let refused = mul_q16(GREAT_RIVER_REFUSAL, smoothstep(0, GREAT_FLOW, flow));
    return share(seed, 8u) > refused;
}

// Whether an internal edge becomes a gully.
fn is_gully(rules: Rules, level: u32, off_gully: bool, height: i32, tip: i32, seed: u32) -> bool {
    if level >= rules.gully_levels || tip <= height {
        return false;
    }
    let high_enough = rules.landforms != 0u || tip > height + LEAST_HILLSLOPE;
    return !off_gully || (share(seed, 9u) < rules.gully_branching && high_enough);
}

// Whether a valley is to lead down from the vertex that halves an edge between two ends.
fn is_drained(edge: u32, level: u32, seed: u32, a: Vertex, b: Vertex) -> bool {
    if level >= COARSE_LEVELS || edge != TERRAIN_EDGE {
        return true;
    }
    let is_first = is_below(gully_end_of(a), gully_end_of(b));
    let lower_is_drained = select(b.is_drained, a.is_drained, is_first);
    return lower_is_drained && share(seed, 21u) < DRAINED_SHARE[level];
}

// Most that the floor of a valley rises over its lower end up to the middle of an edge of a coarse
// level, grains.
fn most_rise(level: u32, slope: i32, xi: i32) -> i32 {
    let least = VALLEY_RISE[min(level, COARSE_LEVELS - 1u)];
    return mul_q16(slope, least + mul_q16(xi, least));
}

// What decides which of two ends is the lower one.
struct GullyEnd {
    height: i32,
    seed: u32,
}

fn gully_end_of(vertex: Vertex) -> GullyEnd {
    return GullyEnd(vertex.height, vertex.seed);
}

// What decides whether new land drains.
struct GullyMid {
    kind: u32,
    height: i32,
    is_drained: bool,
}

// Whether new dry land drains by a gully along the half of its edge that leads to `end`.
fn drains(rules: Rules, level: u32, mid: GullyMid, end: GullyEnd, other: GullyEnd) -> bool {
    let has_gullies = rules.landforms != 0u && level < rules.gully_levels;
    return has_gullies && mid.is_drained && leads_down(mid, end, other);
}

// Whether the half of an edge that leads to `end` is the way down of the dry land in its middle.
fn leads_down(mid: GullyMid, end: GullyEnd, other: GullyEnd) -> bool {
    return mid.kind == TERRAIN && mid.height > end.height && is_below(end, other);
}

// Whether an end of an edge is the lower one. Seeds decide between level ends.
fn is_below(end: GullyEnd, other: GullyEnd) -> bool {
    return end.height < other.height || (end.height == other.height && end.seed < other.seed);
}
