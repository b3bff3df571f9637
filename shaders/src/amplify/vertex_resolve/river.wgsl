// The nearest river of a vertex: a true distance to the course of a segment, less half of its bed.

// Nearest segment found so far.
struct NearestRiver {
    // Distance to its bank, negative in its bed, and charges; grains.
    cost: i32,
    distance: i32,
    // Distance to the belt of its bends, grains.
    belt: i32,
    along: i32,
    segment: RiverSegment,
    // Whether it runs along a face of the vertex, or through an end of its edge.
    is_beside: bool,
    // Whether it is the vertex's own, and keeps its course on finer levels.
    keeps_course: bool,
}

// A river that a vertex may be nearest to.
struct Offer {
    is_known: bool,
    segment: RiverSegment,
    // How far the river may have moved since, grains.
    charge: i32,
}

// No river yet.
fn nearest_river_none() -> NearestRiver {
    var out = NearestRiver();
    out.cost = 0x7fffffff;
    out.distance = FAR;
    out.belt = FAR;
    return out;
}

// Whether a vertex lies among the bends of a river, which winds away from the edges beside which
// valleys are measured.
fn nearest_river_is_near(river: NearestRiver, scale: PlanetScale, rules: Rules) -> bool {
    let reach = reach_at(scale, rules, river.segment, river.along);
    return any(river.segment.winding != vec2(0)) && river.distance / BENDS < reach.half_bed;
}

// The side of its valley at a vertex, which rises beside the belt of its bends.
fn nearest_river_section(
    river: NearestRiver,
    scale: PlanetScale,
    rules: Rules,
    vertex: Vertex,
) -> ValleySection {
    var seen = vertex;
    seen.river = river.segment;
    seen.river_distance = min(river.distance, river.belt);
    seen.river_along = river.along;
    return section(scale, rules, seen);
}

// Takes a segment if its bank is nearer; one beyond its reach counts as far.
fn nearest_river_offer(
    found: NearestRiver,
    scale: PlanetScale,
    rules: Rules,
    level: u32,
    direction: vec3<i32>,
    offer: Offer,
) -> NearestRiver {
    let place = river_place_nearest(scale, rules, offer.segment, direction);
    // Quarters of FAR: distance, charge and penalty together stay in 32 bits.
    let distance = min(place.distance, FAR / 4);
    // Beyond its reach a tributary counts only where no other river is known.
    let is_beyond = distance > river_segment_reach(offer.segment, scale);
    let winds = any(offer.segment.winding != vec2(0));
    let bank = cost_of_bank(scale, level, winds, distance, place.reach.half_bed);
    let cost = bank + offer.charge + select(0, FAR / 4, is_beyond);
    if cost >= found.cost {
        return found;
    }
    return NearestRiver(
        cost,
        distance,
        place.belt,
        place.along,
        offer.segment,
        found.is_beside,
        found.keeps_course,
    );
}

// Distance to a bank, negative in the bed. A winding river may come to the vertices that are made
// around this one: until it is farther off than they are, it counts as the nearest.
fn cost_of_bank(
    scale: PlanetScale,
    level: u32,
    winds: bool,
    distance: i32,
    half_bed: i32,
) -> i32 {
    let bank = distance - half_bed;
    if !winds || bank <= 0 {
        return bank;
    }
    let around = planet_scale_edge_grains(scale, level);
    return max(bank - min(around, NEAR_BANK * half_bed), bank / 64);
}

// How far the river of a segment may move on finer levels, grains.
fn most_move(scale: PlanetScale, rules: Rules, segment: RiverSegment) -> i32 {
    // A single vertex stays where it is.
    let keeps = keeps_course(scale, rules, segment.level, segment.flow.y);
    if river_segment_is_point(segment) || keeps || segment.level >= STRAIGHT_LEVEL {
        return 0;
    }
    return planet_scale_edge_grains(scale, segment.level) / 3;
}
