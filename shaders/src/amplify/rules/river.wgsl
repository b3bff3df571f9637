// Along a river, and at its spring.

// The vertex that halves a river edge: a bed between those of its ends, or the spring of a
// tributary.
fn river_halve(rules: Rules, context: EdgeContext) -> VertexGround {
    switch river_mouth(context.a.kind, context.b.kind) {
        case 0u: {
            return spring(rules, context, context.a, context.b);
        }
        case 1u: {
            return spring(rules, context, context.b, context.a);
        }
        default: {
            return along_river(rules, context);
        }
    }
}

// The end of a river edge, 0 or 1, at which the tributary joins whose spring halves the edge; NONE
// where the river runs from end to end.
fn river_mouth(a: u32, b: u32) -> u32 {
    if is_wet(a) && b == TERRAIN {
        return 0u;
    }
    return select(NO_MOUTH, 1u, !is_wet(a) && is_wet(b));
}

// The bed falls from one end to the other, at the coarse levels more on the first half than on the
// second. Water likewise.
fn along_river(rules: Rules, context: EdgeContext) -> VertexGround {
    let up = context.a;
    let down = context.b;
    let levels = rules.hollow_levels;
    let is_hollow = levels.x <= context.level && context.level < levels.y;
    let share_of_fall = select(Q16 / 2, rules.hollow_fall, is_hollow);
    let bed = descend(up.bed, down.bed, share_of_fall);
    let water = descend(up.water, down.water, share_of_fall);
    if rules.landforms != 0u && down.water == 0 {
        // The sea stands in a drowned valley as far inland as the bed lies below it.
        let level = bed + max(up.water - up.bed, 0);
        return river_ground(bed, min(water, max(level, 0)));
    }
    return river_ground(bed, water);
}

// A height that falls from `up` to `down`, strictly between the two where they are two grains apart
// or more.
fn descend(up: i32, down: i32, share_of_fall: i32) -> i32 {
    let fall = up - down;
    if fall < 2 {
        return down + max(fall, 0);
    }
    return up - clamp(mul_q16(fall, share_of_fall), 1, fall - 1);
}

// The spring of a tributary, on the way from its mouth to the land above.
fn spring(rules: Rules, context: EdgeContext, mouth: Vertex, land: Vertex) -> VertexGround {
    let reach = mul_q16(context.length, rules.spring_slope);
    // Not steeper than a brook may be, nor farther up than the land.
    let gentle = mouth.bed + min(mul_q16(reach, SPRING_REACH), MOST_SPRING_RISE);
    let xi = share(context.new_vertex.seed, 0u);
    // Land may lie below the mouth; the spring never does.
    let land_above = max(land.height, mouth.bed + 2);
    let drawn = mix(mouth.bed, land_above, LEAST_SPRING + mul_q16(xi, DRAWN_SPRING));
    let bed = max(min(gentle, drawn), mouth.bed + 1);
    let depth = select(0, SPRING_DEPTH, rules.landforms != 0u);
    return river_ground(bed, min(mouth.water, bed + depth));
}

// A river's bed under its water, which never lies below it; grains.
fn river_ground(bed: i32, water: i32) -> VertexGround {
    return VertexGround(RIVER, bed, bed, max(water, bed));
}
