// What a coarse level shows of a vertex: the land around it, not its own bed.

// How far a level shows a vertex above its own `ground`, grains. `level` is in Q16: between two
// levels it changes evenly. `edge` is the mean edge of level 0, grains.
fn coarse_lift(rules: Rules, vertex: Vertex, ground: i32, edge: i32, level: i32) -> i32 {
    let is_land = vertex.kind == TERRAIN || vertex.kind == GULLY || vertex.kind == RIVER;
    let whole = u32(max(level, 0) >> 16u);
    // Mouths lie at sea level: the shore stays where it is.
    if !is_land || rules.landforms == 0u || whole >= RESOLVED_LEVEL || ground <= 0 {
        return 0;
    }
    let steep = steepness(rules, vertex);
    let most = max(max(vertex.crust, 0) - ground, 0);
    let worn_gain = Q16 + mul_q16(WORN_GAIN, vertex.worn);
    let here = level_lift(vertex.kind, whole, edge, steep, most);
    let finer = level_lift(vertex.kind, whole + 1u, edge, steep, most);
    return mul_q16(mix(here, finer, level & (Q16 - 1)), worn_gain);
}

// The same of a whole level, before what worn land gains.
fn level_lift(kind: u32, level: u32, edge: i32, steep: i32, most: i32) -> i32 {
    if level >= RESOLVED_LEVEL {
        return 0;
    }
    var shown = SHOWN_OPEN_GROUND[level];
    if kind == GULLY {
        shown = SHOWN_GULLY[level];
    } else if kind == RIVER {
        shown = SHOWN_RIVER[level];
    }
    let rise = 2 * min(mul_q16((edge >> level) / 2, steep), MOST_RISE);
    return mul_q16(mul_q16(most, ratio(rise, most + rise)), shown);
}
