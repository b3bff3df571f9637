// A piece of river between two of its vertices, and its course.

// The segment between two vertices of a river that was born on level `birth`; `level` is that of its
// edge. `arriving` is the discharge at its lower end, where others may join it.
fn river_segment_between(
    birth: u32,
    level: u32,
    up: Vertex,
    down: Vertex,
    arriving: u32,
) -> RiverSegment {
    let joins = !runs_into(down, arriving);
    let flow = vec2(i32(isqrt(up.discharge)), i32(isqrt(arriving)));
    return RiverSegment(
        array(up.direction, down.direction),
        array(up.heading, arrival(up, down, arriving)),
        vec2(up.water, down.water),
        flow,
        vec2(up.tide, down.tide),
        // A smaller river joins with waves of its own, and straight.
        vec2(min(flow.x, flow.y), select(vertex_flow(down), flow.y, joins)),
        vec2(up.winding, select(down.winding, 0, joins)),
        birth,
        level,
        up.kind == LAKE && down.kind == LAKE,
    );
}

// A piece of river that there may be.
struct MaybeSegment {
    segment: RiverSegment,
    is_known: bool,
}

// The piece of its own river that an edge of a level follows, where finer levels keep it: that of a
// coarser level, of which the edge is a part, or the edge's own.
fn river_segment_kept(
    scale: PlanetScale,
    rules: Rules,
    birth: u32,
    arriving: u32,
    level: u32,
    a: Vertex,
    b: Vertex,
) -> MaybeSegment {
    if is_part_of_piece(birth, a) {
        return MaybeSegment(a.river, true);
    }
    if is_part_of_piece(birth, b) {
        return MaybeSegment(b.river, true);
    }
    let segment = river_segment_between(birth, level, a, b, arriving);
    return MaybeSegment(segment, keeps_own(scale, rules, arriving, level, a, b));
}

// Whether there is such a piece.
fn river_segment_is_kept(
    scale: PlanetScale,
    rules: Rules,
    birth: u32,
    arriving: u32,
    level: u32,
    a: Vertex,
    b: Vertex,
) -> bool {
    let is_part = is_part_of_piece(birth, a) || is_part_of_piece(birth, b);
    return is_part || keeps_own(scale, rules, arriving, level, a, b);
}

// Whether the edges at an end are part of its piece: a tributary that joins the piece was born
// later.
fn is_part_of_piece(birth: u32, end: Vertex) -> bool {
    return end.keeps_course && end.river.birth == birth;
}

// Widest half-width of its valley, grains.
fn river_segment_reach(segment: RiverSegment, scale: PlanetScale) -> i32 {
    if segment.birth == 0u {
        return FAR;
    }
    return planet_scale_edge_grains(scale, segment.birth) / 2;
}

// Whether it is a single vertex of a river.
fn river_segment_is_point(segment: RiverSegment) -> bool {
    return all(segment.ends[0] == segment.ends[1]);
}

// The axis of its valley.
fn river_segment_curve(segment: RiverSegment) -> Curve {
    return curve_new(segment.ends, segment.headings);
}

// Whether the river along an edge has come to a larger one, in whose bed an end lies: until their
// junction it has no course of its own.
fn is_lost(a: Vertex, b: Vertex) -> bool {
    return vertex_is_in_larger_river(a) || vertex_is_in_larger_river(b);
}

// Whether finer levels keep the piece that an edge of a level makes.
fn keeps_own(
    scale: PlanetScale,
    rules: Rules,
    arriving: u32,
    level: u32,
    up: Vertex,
    down: Vertex,
) -> bool {
    let runs_on = up.kind == RIVER && (down.kind == RIVER || down.kind == SEA);
    let flow = i32(isqrt(arriving));
    return runs_on && !is_lost(up, down) && keeps_course(scale, rules, level, flow);
}

// Whether a river goes on beyond the lower end of its piece: the sea and a larger river end it.
fn runs_into(down: Vertex, arriving: u32) -> bool {
    return vertex_is_wet(down) && arriving >= down.discharge / 2u;
}

// Heading of a river where it arrives at the lower end of its piece.
fn arrival(up: Vertex, down: Vertex, arriving: u32) -> vec3<i32> {
    if runs_into(down, arriving) {
        return down.heading;
    }
    if !vertex_is_wet(down) {
        // The sea has no heading.
        return vec3(0);
    }
    // A smaller river joins the larger one at an acute angle.
    return heading_of(heading_of(difference(down.direction, up.direction)) + down.heading);
}
