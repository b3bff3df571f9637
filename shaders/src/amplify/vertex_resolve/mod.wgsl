// Pass: a new vertex settles its kind and its distances, once the faces on both sides have decided.

// Requests of faces to a new vertex.
struct Requests {
    // Whether a gully starts here.
    gully_tip: bool,
    // Whether a tributary starts here.
    river_tip: bool,
    // Whether a tributary ends here.
    junction: bool,
}

// The edge that a new vertex halves, and what lies around it.
struct VertexContext {
    edge: EdgeState,
    ends: vec2<u32>,
    // The corners opposite to it, or NONE.
    opposite: vec2<u32>,
    // The other edges of the two faces, in the order of their winding, or NONE.
    beside: array<u32, 4>,
    requests: Requests,
}

// Pass: the vertices of split edges settle. Each reads the middles of the edges beside its own, but
// of those only what no settling changes.
@compute @workgroup_size(GROUP)
fn vertex_resolve(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= level_size().made.mids {
        return;
    }
    let edge = halved[id.x];
    let state = edge_states[edge];
    if edge_state_mark(state) != SPLIT {
        return;
    }
    let scale = level_uniform.sight.scale;
    let rules = level_uniform.rules;
    let around = around_edge(edge, state);
    var settled = resolved_vertex(state.mid);
    let river = nearest_river(scale, rules, around, settled);
    // Beside a river the side is measured; elsewhere it stays the mean of the parents.
    if river.is_beside || nearest_river_is_near(river, scale, rules) {
        settled.section = nearest_river_section(river, scale, rules, settled);
    }
    settled.river = river.segment;
    settled.river_distance = river.distance;
    settled.river_along = river.along;
    settled.keeps_course = river.keeps_course;
    settled.branched = around.requests.junction;
    // Only ground becomes a gully, and not where a tributary will spring.
    let is_tip = around.requests.gully_tip && !around.requests.river_tip;
    if is_tip && settled.kind == TERRAIN {
        settled.kind = GULLY;
    }
    out_vertex_rivers[state.mid] = vertex_river_of(settled);
}

// The surroundings of the vertex that halves an edge.
fn around_edge(edge: u32, state: EdgeState) -> VertexContext {
    let joins = edge_joins[edge];
    var around = VertexContext();
    around.edge = state;
    around.ends = joins.vertices;
    around.opposite = vec2(NONE);
    around.beside = array(NONE, NONE, NONE, NONE);
    for (var side = 0u; side < 2u; side++) {
        let face = joins.faces[side];
        if face == NONE {
            continue;
        }
        let sides = face_sides[face];
        around.opposite[side] = corner_off(face_corners[face].vertices, joins.vertices);
        let k = select(select(2u, 1u, sides.edges.y == edge), 0u, sides.edges.x == edge);
        around.requests = requests_and(around.requests, requests_of(sides.marks, k));
        // The face's other two edges, in the order of its winding.
        around.beside[2u * side] = sides.edges[(k + 1u) % 3u];
        around.beside[2u * side + 1u] = sides.edges[(k + 2u) % 3u];
    }
    return around;
}

// The requests of a face of some marks to the vertex on its `k`th edge.
fn requests_of(marks: u32, k: u32) -> Requests {
    // m_k is first on the inner edge of corner k, second on that of corner k + 1.
    let first = face_inner(marks, k);
    let second = face_inner(marks, (k + 1u) % 3u);
    return Requests(
        first == GULLY_TO_SECOND || second == GULLY_TO_FIRST,
        first == RIVER_TO_SECOND || second == RIVER_TO_FIRST,
        first == RIVER_TO_FIRST || second == RIVER_TO_SECOND,
    );
}

// The requests of both faces.
fn requests_and(a: Requests, b: Requests) -> Requests {
    return Requests(
        a.gully_tip || b.gully_tip,
        a.river_tip || b.river_tip,
        a.junction || b.junction,
    );
}

// What settling reads of a vertex; its kind is that before any face changed it.
fn resolved_vertex(vertex: u32) -> Vertex {
    let course = vertex_courses[vertex];
    var out = vertex_of_rows(
        vertex_cores[vertex],
        course,
        VertexLand(),
        out_vertex_rivers[vertex],
    );
    out.kind = vertex_course_kind(course);
    return out;
}

// The same without what settling changes.
fn unresolved_vertex(vertex: u32) -> Vertex {
    let course = vertex_courses[vertex];
    var out = vertex_of_rows(vertex_cores[vertex], course, VertexLand(), VertexRiver());
    out.kind = vertex_course_kind(course);
    return out;
}

// The nearest river of a new vertex of the level after that of the pass.
fn nearest_river(
    scale: PlanetScale,
    rules: Rules,
    around: VertexContext,
    made: Vertex,
) -> NearestRiver {
    let level = level_uniform.level;
    let a = resolved_vertex(around.ends.x);
    let b = resolved_vertex(around.ends.y);
    let wet = vertex_is_wet(made);
    let own = own_river(scale, rules, around, made, a, b);
    var found = nearest_river_none();
    // First those along the edges of both faces, or the vertex's own, then inherited ones.
    for (var k = 0u; k < 12u; k++) {
        var offer = Offer();
        if k >= 8u {
            offer = inherited(scale, rules, around, made, own, k - 8u);
        } else if !wet {
            offer = river_beside(scale, rules, around.beside[k / 2u], k % 2u);
        } else if k == 0u {
            offer = own.offer;
        }
        if offer.is_known {
            found = nearest_river_offer(found, scale, rules, level, made.direction, offer);
        }
        if k == 7u {
            // A vertex beside a brook may lie in the bed of the river that the brook joins.
            found.is_beside = wet || found.cost < 0x7fffffff;
        }
    }
    found.is_beside = found.is_beside || vertex_is_wet(a) || vertex_is_wet(b);
    found.keeps_course = own.is_kept && is_same_segment(own.offer.segment, found.segment);
    return found;
}

// The river that a wet vertex lies on.
struct OwnRiver {
    offer: Offer,
    // Whether finer levels keep the piece.
    is_kept: bool,
    // Whether a larger river has it.
    is_lost: bool,
}

fn own_river(
    scale: PlanetScale,
    rules: Rules,
    around: VertexContext,
    made: Vertex,
    a: Vertex,
    b: Vertex,
) -> OwnRiver {
    if !vertex_is_wet(made) {
        return OwnRiver();
    }
    let level = level_uniform.level;
    let birth = edge_state_birth(around.edge);
    let is_river = edge_state_kind(around.edge) == RIVER_EDGE && made.kind == RIVER;
    let arriving = around.edge.arriving;
    var piece = MaybeSegment();
    if is_river {
        piece = river_segment_kept(scale, rules, birth, arriving, level, a, b);
    }
    if !piece.is_known {
        let point = river_segment_between(birth, level + 1u, made, made, made.discharge);
        piece.segment = point;
    }
    // Between a larger river, into which its course has led, and their junction it has no other.
    let lost = is_river && is_lost(a, b);
    return OwnRiver(Offer(piece.is_known || !lost, piece.segment, 0), piece.is_known, lost);
}

// A river along an edge of a face beside the vertex: one of its halves while edges still move, else
// the whole edge.
fn river_beside(scale: PlanetScale, rules: Rules, edge: u32, half: u32) -> Offer {
    if edge == NONE {
        return Offer();
    }
    let state = edge_states[edge];
    if edge_state_kind(state) != RIVER_EDGE {
        return Offer();
    }
    let level = level_uniform.level;
    let ends = edge_joins[edge].vertices;
    let up = resolved_vertex(ends.x);
    let down = resolved_vertex(ends.y);
    let birth = edge_state_birth(state);
    let kept = river_segment_kept(scale, rules, birth, state.arriving, level, up, down);
    if kept.is_known {
        return Offer(half == 0u, kept.segment, 0);
    }
    if is_lost(up, down) {
        return Offer();
    }
    return half_beside(state, level, up, down, half);
}

// One of the newest segments that are known of a river edge of a level, upstream first.
fn half_beside(edge: EdgeState, level: u32, up: Vertex, down: Vertex, half: u32) -> Offer {
    let has_mid = edge_state_mark(edge) != LEAF;
    let is_up_wet = vertex_is_wet(up);
    // No river runs above a spring.
    let is_halved = has_mid && (!is_up_wet || level < STRAIGHT_LEVEL);
    if half == 0u && !(is_halved && is_up_wet) {
        return Offer();
    }
    if !is_halved && !is_up_wet {
        return Offer();
    }
    var from_end = up;
    var to_end = down;
    var arriving = edge.arriving;
    if is_halved {
        let mid = unresolved_vertex(edge.mid);
        if half == 0u {
            to_end = mid;
            arriving = mid.discharge;
        } else {
            from_end = mid;
        }
    }
    let segment_level = select(level, level + 1u, is_halved);
    let birth = edge_state_birth(edge);
    let segment = river_segment_between(birth, segment_level, from_end, to_end, arriving);
    return Offer(true, segment, 0);
}

// The segment of a parent or, while edges move, of an opposite corner, numbered from 0.
fn inherited(
    scale: PlanetScale,
    rules: Rules,
    around: VertexContext,
    made: Vertex,
    own: OwnRiver,
    k: u32,
) -> Offer {
    let wet = vertex_is_wet(made);
    if wet && made.kind != RIVER {
        return Offer();
    }
    // A river may lie in the bed of a larger one.
    let is_free = !wet || (!own.is_kept && own.is_lost);
    let flow = select(2 * vertex_flow(made), 0, is_free);
    let giver = inherited_from(around, k);
    if giver == NONE || !gives_river(giver, flow) {
        return Offer();
    }
    // The same segment often comes from several neighbours.
    for (var j = 0u; j < k; j++) {
        let other = inherited_from(around, j);
        if other != NONE && gives_river(other, flow) && has_same_ends(giver, other) {
            return Offer();
        }
    }
    let segment = vertex_river_segment(out_vertex_rivers[giver]);
    return Offer(true, segment, most_move(scale, rules, segment));
}

// The vertex from which a segment is inherited, or NONE.
fn inherited_from(around: VertexContext, k: u32) -> u32 {
    if k < 2u {
        return around.ends[k];
    }
    return select(NONE, around.opposite[k - 2u], level_uniform.level < STRAIGHT_LEVEL);
}

// Whether a vertex knows a river of at least a flow.
fn gives_river(vertex: u32, flow: i32) -> bool {
    let river = out_vertex_rivers[vertex];
    return river.distance < FAR && halves(river.flow).y >= flow;
}

fn has_same_ends(a: u32, b: u32) -> bool {
    let x = vertex_river_segment(out_vertex_rivers[a]).ends;
    let y = vertex_river_segment(out_vertex_rivers[b]).ends;
    return all(x[0] == y[0]) && all(x[1] == y[1]);
}

fn is_same_segment(a: RiverSegment, b: RiverSegment) -> bool {
    let same_ends = all(a.ends[0] == b.ends[0]) && all(a.ends[1] == b.ends[1]);
    let first = all(a.headings[0] == b.headings[0]);
    let same_way = first && all(a.headings[1] == b.headings[1]);
    let same_water = all(a.water == b.water) && all(a.flow == b.flow) && all(a.tide == b.tide);
    let same_bends = all(a.waves == b.waves) && all(a.winding == b.winding);
    let same_marks = a.birth == b.birth && a.level == b.level && a.is_lake == b.is_lake;
    return same_ends && same_way && same_water && same_bends && same_marks;
}
