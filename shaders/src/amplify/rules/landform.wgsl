// Character of the land at a vertex: how old, how dry, how steep.

// Character of the land at a vertex; shares and tangents in Q16.
struct Landform {
    // 0 for a young orogeny, 1 from 200 My on; dryness ages land too.
    old: i32,
    // 1 where rock is bare of water and soil.
    dry: i32,
    // Tangent of its slopes.
    steep: i32,
}

// How dry land of a wetness is, Q16.
fn dryness(wetness: i32) -> i32 {
    return Q16 - smoothstep(DRY_WETNESS[0], DRY_WETNESS[1], wetness);
}

// Character of the land at a vertex.
fn landform_of(rules: Rules, vertex: Vertex) -> Landform {
    let dry = dryness(vertex.wetness);
    let old = vertex.worn + mul_q16(dry, AGE_OF_DRYNESS);
    return Landform(min(old, Q16), dry, steepness(rules, vertex));
}

// Tangent of the land's slopes with the unevenness of its soil, Q16.
fn uneven_steepness(rules: Rules, vertex: Vertex) -> i32 {
    return steepness(rules, vertex) + SOIL_SLOPE;
}

// Tangent of the land's slopes, Q16.
fn steepness(rules: Rules, vertex: Vertex) -> i32 {
    if rules.landforms == 0u {
        return rules.steep_old;
    }
    let young = mix(rules.steep_subduction, rules.steep_collision, vertex.collision);
    let steep = mix(young, rules.steep_old, vertex.worn);
    // Low land has little to cut; a plateau keeps half its steepness, in the valleys that cut it.
    let crust = max(vertex.crust, 0);
    let relief = square(ratio(crust, crust + HALF_RELIEF_CRUST));
    return mul_q16(mul_q16(steep, relief), Q16 - vertex.plateau / 2);
}
