// Final ground and water of a vertex.

// Ground and water after carving.
struct Carved {
    // Ground, grains.
    ground: i32,
    // Level of the water, grains: also where it lies under dry ground; NO_WATER away from it.
    water: i32,
}

// Dry ground away from all water, grains.
fn carved_dry(ground: i32) -> Carved {
    return Carved(ground, NO_WATER);
}

// Whether the ground lies under water.
fn carved_is_wet(carved: Carved) -> bool {
    return carved.water > carved.ground;
}

// The ground of a vertex after its river has carved it.
fn valley_carve(scale: PlanetScale, rules: Rules, vertex: Vertex) -> Carved {
    let reach = reach_of(scale, rules, vertex);
    // It may wind past a vertex of its own.
    if vertex.kind == RIVER && vertex.river_distance <= reach.half_bed {
        return in_river(reach, vertex);
    }
    let knows_river = vertex.river_distance < FAR;
    if vertex.kind == LAKE {
        return Carved(min(vertex.bed, vertex.water), vertex.water);
    }
    if is_under_sea(vertex) {
        // Relief that would emerge is held under the sea by its own bounds.
        let floor_of_sea = vertex.height
            + ocean_relief(vertex, planet_scale_edge_grains(scale, 0u));
        let bed = select(floor_of_sea, under_sea(reach, vertex), knows_river);
        return Carved(min(floor_of_sea, bed), 0);
    }
    if vertex.kind == COAST && !knows_river {
        return Carved(vertex.height, 0);
    }
    if !knows_river || all(vertex.river.flow == vec2(0)) {
        return carved_dry(vertex.height);
    }
    return beside_river(scale, reach, vertex);
}

// Whether the sea covers a vertex: coasts of ours stand at any height.
fn is_under_sea(vertex: Vertex) -> bool {
    return vertex.kind == SEA || (vertex.kind == COAST && vertex.height < 0);
}

// A vertex of a river, in its own bed or in that of a larger river, whose water may stand higher
// there.
fn in_river(reach: Reach, vertex: Vertex) -> Carved {
    let water = min(reach.water, max(vertex.water, vertex.bed));
    let distance = min(vertex.river_distance, reach.half_bed);
    return Carved(reach_bed(reach, distance) - (reach.water - water), water);
}

// The bed that a river has on the floor of the sea, grains.
fn under_sea(reach: Reach, vertex: Vertex) -> i32 {
    if vertex.river_distance < reach.half_bed {
        return reach_bed(reach, vertex.river_distance);
    }
    return vertex.height;
}

// The ground beside a river.
fn beside_river(scale: PlanetScale, reach: Reach, vertex: Vertex) -> Carved {
    let distance = vertex.river_distance;
    if distance < reach.half_bed {
        return Carved(reach_bed(reach, distance), reach.water);
    }
    let ground = dry_ground(vertex, reach, section_width(scale, vertex, reach));
    if distance <= KNOWN_WATER * reach.half_bed {
        return Carved(ground, reach.water);
    }
    return carved_dry(ground);
}

// Height of the ground beyond a river's bed, grains; `valley` is the half-width of its valley.
fn dry_ground(vertex: Vertex, reach: Reach, valley: i32) -> i32 {
    let distance = vertex.river_distance;
    let beyond = distance - reach.half_bed;
    let raw = vertex.height;
    // Far from the river land may lie lower than its plain.
    let low_land = max(beyond - min(valley, PLAIN_WIDTH * reach.half_bed), 0) / LOW_LAND_SLOPE;
    let edge = min(ROUND_EDGE, beyond / EDGE_GROWTH);
    let side = vertex.section;
    let plain_top = reach.water + 2 * reach_bank(reach) - low_land;
    let lowest = mix(min(side.height, raw), raw, side.own);
    // High above the plain its relief does not show.
    if lowest > plain_top + edge {
        return lowest;
    }
    let plain = flood_plain(vertex.direction, reach, distance) - low_land;
    // The valley's side never raises ground above the land beside it.
    return smooth_max(mix(min(side.height, max(raw, plain)), raw, side.own), plain, edge);
}
