// The side of a valley: how high it stands over the river, by its archetype.

// The four archetypes of a valley's side, height over distance, both 0..1 in Q16.
fn archetype(shape: u32, distance: i32) -> i32 {
    let x = saturate(distance);
    switch shape & 3u {
        case 0u: {
            // Half linear, so that the side starts steeply at the river.
            return x / 2 + square(x) / 2;
        }
        case 1u: {
            // A riser, and a quarter of a parabola that keeps the floor from being level.
            return mul_q16(riser(FLOOR_RISER, x), Q16 - x / 4) + square(x) / 4;
        }
        case 2u: {
            return mul_q16(square(x), x);
        }
        default: {
            return (riser(LOWER_RISER, x) + riser(UPPER_RISER, x)) / 2;
        }
    }
}

// A smooth rise from 0 to 1 between two places.
fn riser(ends: array<i32, 2>, x: i32) -> i32 {
    return smoothstep(ends[0], ends[1], x);
}

// The side that the valley of a vertex's river has at the vertex.
fn section(scale: PlanetScale, rules: Rules, vertex: Vertex) -> ValleySection {
    if vertex.river_distance >= FAR || all(vertex.river.flow == vec2(0)) {
        // A lake's shore: no stream shapes it.
        return valley_section_outside(vertex.height);
    }
    let reach = reach_of(scale, rules, vertex);
    // The side begins where the bed ends.
    let away = max(vertex.river_distance - reach.half_bed, 0);
    let width = section_width(scale, vertex, reach);
    if away >= width {
        return valley_section_outside(vertex.height);
    }
    let x = ratio(away, width);
    // Greater rivers have gentler sides.
    let tangent = mix(SIDE_SLOPE[0], SIDE_SLOPE[1], reach.strength);
    let shape = select(0u, vertex.valley, rules.archetypes != 0u);
    let rise = mul_q16(mul_q16(width, tangent), archetype(shape, x));
    // It stands on the bank and never above the crust.
    let most = max(vertex.crust - reach.water, 0);
    return ValleySection(saturating_add(reach.water, min(rise, most)), riser(OWN_HEIGHT, x));
}

// Half-width of a vertex's valley, grains.
fn section_width(scale: PlanetScale, vertex: Vertex, reach: Reach) -> i32 {
    let valley = reach_half_valley(reach, planet_scale_edge_grains(scale, 0u));
    // An eighth short, so that the valley has ended where vertices no longer know the river.
    return max(min(valley, river_segment_reach(vertex.river, scale) / 8 * 7), 1);
}
