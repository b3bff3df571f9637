// Pass: a face decides what lies along its inner edges.

// What a face's decision depends on in one of its edges.
struct DecidingEdge {
    // Its kind.
    kind: u32,
    // Its ends.
    ends: vec2<u32>,
    // The vertex that halves it, its kind before any face changed it.
    mid: VertexCore,
    mid_kind: u32,
}

// Pass: the inner edges of faces of a level.
@compute @workgroup_size(GROUP)
fn face_decide(@builtin(global_invocation_id) id: vec3<u32>) {
    let level = level_uniform.level;
    if id.x >= level_size().made.decided || level >= STRAIGHT_LEVEL {
        return;
    }
    let face = decided[id.x];
    let sides = out_face_sides[face].edges;
    let corners = face_corners[face].vertices;
    let kinds = vec3(
        edge_state_kind(edge_states[sides.x]),
        edge_state_kind(edge_states[sides.y]),
        edge_state_kind(edge_states[sides.z]),
    );
    var inner = 0u;
    for (var k = 0u; k < 3u; k++) {
        let other = (k + 2u) % 3u;
        let drains_here = kinds[k] != TERRAIN_EDGE;
        // Drainage begins between a drained edge and ground: between two of a kind there is no corner
        // to drain, or it drains already.
        if drains_here != (kinds[other] != TERRAIN_EDGE) {
            let low = select(other, k, drains_here);
            let high = select(k, other, drains_here);
            let drain = corner_drainage(face, corners, sides, vec3(k, low, high));
            let to_second = select(1u, 0u, drains_here);
            inner |= inner_number(drain, to_second) << (8u * k);
        }
    }
    // All of the three bytes: nothing is left of an earlier run.
    let marks = out_face_sides[face].marks & ((1u << FACE_INNER) - 1u);
    out_face_sides[face].marks = marks | (inner << FACE_INNER);
}

// The number of a drain along an inner edge, to its first or to its second end.
fn inner_number(drain: u32, to_second: u32) -> u32 {
    if drain == TERRAIN_EDGE {
        return 0u;
    }
    return select(GULLY_TO_FIRST, RIVER_TO_FIRST, drain == RIVER_EDGE) + to_second;
}

fn deciding_edge(edge: u32) -> DecidingEdge {
    let state = edge_states[edge];
    return DecidingEdge(
        edge_state_kind(state),
        edge_joins[edge].vertices,
        vertex_cores[state.mid],
        vertex_course_kind(vertex_courses[state.mid]),
    );
}

// The draw of the corner on one side of a river edge, at the junction that halves it: a tributary
// comes from the side with the higher one.
fn junction_draw(junction: u32, side: u32) -> u32 {
    return pcg(junction ^ side);
}

// The kind of the inner edge that cuts a corner off. `places` are those of the corner, of the drained
// edge and of the ground's edge.
fn corner_drainage(face: u32, corners: vec3<u32>, sides: vec3<u32>, places: vec3<u32>) -> u32 {
    let rules = level_uniform.rules;
    let level = level_uniform.level;
    let low = deciding_edge(sides[places.y]);
    let high = deciding_edge(sides[places.z]);
    let corner = corners[places.x];
    let is_drain = low.mid_kind == RIVER || low.mid_kind == GULLY;
    // Only at the upstream corner can a tributary meet its river at an acute angle.
    if !is_drain || high.mid_kind != TERRAIN || corner != low.ends.x {
        return TERRAIN_EDGE;
    }
    // The way of the drained edge's water, from the corner downstream.
    let upstream = vertex_cores[corner];
    let flow = difference(vertex_cores[low.ends.y].direction, upstream.direction);
    let into = difference(low.mid.direction, high.mid.direction);
    if dot(flow, into) <= 0 || high.mid.height <= low.mid.water {
        return TERRAIN_EDGE;
    }
    let height = low.mid.height;
    let tip = high.mid.height;
    let seed = pcg(low.mid.seed ^ pcg(high.mid.seed));
    // A gully has no water to share: off it only gullies branch.
    let off_gully = low.mid_kind == GULLY;
    if !off_gully && joins_river(face, corners, sides[places.y], low, upstream, corner) {
        let root = i32(isqrt(low.mid.discharge));
        if is_tributary(rules, level, root, height, tip, seed) {
            return RIVER_EDGE;
        }
    }
    return select(TERRAIN_EDGE, GULLY_EDGE, is_gully(rules, level, off_gully, height, tip, seed));
}

// Whether a tributary may join a river from this face: the river gains water, does not wind, and the
// draw at the junction falls on this side.
fn joins_river(
    face: u32,
    corners: vec3<u32>,
    river: u32,
    low: DecidingEdge,
    upstream: VertexCore,
    corner: u32,
) -> bool {
    // A river that winds about its axis passes the middle of its edge aside.
    let flow = i32(isqrt(upstream.discharge));
    let scale = level_uniform.sight.scale;
    if keeps_course(scale, level_uniform.rules, level_uniform.level, flow) {
        return false;
    }
    // The face beyond compares the same two draws the other way round, so one of them is chosen
    // without either asking the other.
    let beyond = edge_joins_beyond(edge_joins[river], face);
    if beyond == NONE {
        return false;
    }
    let here = vertex_cores[corner_off(corners, low.ends)].seed;
    let there = vertex_cores[corner_off(face_corners[beyond].vertices, low.ends)].seed;
    if junction_draw(low.mid.seed, here) <= junction_draw(low.mid.seed, there) {
        return false;
    }
    // A tributary brings what the river gains between the corner and the junction.
    let least_gain = select(upstream.discharge + 1u, 0xffffffffu, upstream.discharge == 0xffffffffu);
    return is_wet(vertex_course_kind(vertex_courses[corner])) && low.mid.discharge > least_gain;
}
