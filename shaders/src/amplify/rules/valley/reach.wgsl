// Width, depth and water of a river at a place of it.

// Half-width of the bed of a river of a flow (Q16), grains.
fn half_bed_of(scale: PlanetScale, rules: Rules, flow: i32) -> i32 {
    let on_earth = mul_q16(mul_q16(rules.channel_width, HALF_ROOT), flow);
    // Planets are larger than the Earth, too.
    let size = ratio(i32(scale.radius_m), 2 * EARTH_RADIUS_M);
    return max(2 * mul_q16(on_earth, size), LEAST_HALF_BED);
}

// Width of a river of a flow (Q16), grains.
fn reach_width(scale: PlanetScale, rules: Rules, flow: i32) -> i32 {
    return 2 * half_bed_of(scale, rules, flow);
}

// Flow along a segment, between those at its ends, Q16: linear, but from the apex of a delta an arm
// narrows to its own over the first quarter.
fn flow_along(flow: vec2<i32>, along: i32) -> i32 {
    if flow.x <= flow.y {
        return mix(flow.x, flow.y, along);
    }
    return mix(flow.y, flow.x, square(saturate(Q16 - APEX * along)));
}

// Whether a river of a flow (Q16) keeps its course from the edges of a level on.
fn keeps_course(scale: PlanetScale, rules: Rules, level: u32, flow: i32) -> bool {
    let width = reach_width(scale, rules, flow);
    let longest = select(width * PIECE_WIDTHS, 0x7fffffff, width > 0x7fffffff / PIECE_WIDTHS);
    let is_short = planet_scale_edge_grains(scale, level) <= longest;
    return rules.landforms != 0u && (level >= LAST_COURSE_LEVEL || is_short);
}

// The river at a point of it.
struct Reach {
    // Water surface, grains.
    water: i32,
    // Half of the water's width, grains; 0 in a lake.
    half_bed: i32,
    // Depth of the bed in its middle, grains.
    depth: i32,
    // Root of its flow, Q16.
    strength: i32,
}

// The river where a vertex is nearest to its segment.
fn reach_of(scale: PlanetScale, rules: Rules, vertex: Vertex) -> Reach {
    return reach_at(scale, rules, vertex.river, vertex.river_along);
}

// The river at a share of a segment, Q16. Water is linear between its ends.
fn reach_at(scale: PlanetScale, rules: Rules, segment: RiverSegment, along: i32) -> Reach {
    let t = saturate(along);
    let flow = flow_along(segment.flow, t);
    let strength = sqrt_q16(flow);
    let half_bed = select(half_bed_of(scale, rules, flow), 0, segment.is_lake);
    let tide = mix(segment.tide.x, segment.tide.y, t);
    let slenderness = ratio(
        1 << 8u,
        mix(WIDTH_OVER_DEPTH[0], WIDTH_OVER_DEPTH[1], strength),
    );
    let width = select(2 * half_bed, 0x7fffffff, half_bed > 0x3fffffff);
    return Reach(
        mix(segment.water.x, segment.water.y, t),
        estuary_widened(half_bed, tide),
        mul_q16(width, slenderness),
        strength,
    );
}

// Ground in the bed at a distance of at most its half-width from its middle, grains.
fn reach_bed(reach: Reach, distance: i32) -> i32 {
    let up = square(ratio(distance, reach.half_bed));
    return reach.water - mul_q16(reach.depth, Q16 - up);
}

// Height of its banks over the water, grains; 0 in a lake.
fn reach_bank(reach: Reach) -> i32 {
    let bank = mul_q16(reach.depth, BANK[0]) + BANK[1];
    return min(min(bank, HIGHEST_BANK), reach.half_bed);
}

// Half-width of its valley in grains, on a planet whose control mesh has edges of `edge` grains.
fn reach_half_valley(reach: Reach, edge: i32) -> i32 {
    let share_of_edge = mix(HALF_VALLEY[0], HALF_VALLEY[1], square(reach.strength));
    return mul_q16(edge, share_of_edge);
}
