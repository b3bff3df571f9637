// Passes: faces are quartered. A face (v0, v1, v2) with midpoints m0 (of v0 v1), m1, m2 becomes the
// corner faces c_k = (v_k, m_k, m_k-1) and the middle c3 = (m0, m1, m2). Its inner edge i_k = (m_k,
// m_k-1) cuts the corner k off.

// Discharge that a tributary brings to a junction: a quarter to a half of what its river has gained
// since the upstream vertex.
fn tributary(junction: VertexCore, upstream: VertexCore) -> u32 {
    let quarter = less(junction.discharge, upstream.discharge) / 4u;
    return quarter + mul_high(quarter, u32(share(junction.seed, 20u)) << 16u);
}

// Number of the first inner edge of a split face among the next level's edges: they follow the
// halves, three a face.
fn first_inner(child: u32) -> u32 {
    return level_size().made.halves + child / 4u * 3u;
}

// Pass: the three inner edges of every split face.
@compute @workgroup_size(GROUP)
fn grow_inner(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= level_size().made.decided {
        return;
    }
    let face = decided[id.x];
    let sides = face_sides[face];
    if face_mark(sides.marks) != SPLIT {
        return;
    }
    let child = face_corners[face].child;
    for (var corner = 0u; corner < 3u; corner++) {
        inner_edge(first_inner(child) + corner, child, sides, corner);
    }
}

// Writes the inner edge of a split face at a corner.
fn inner_edge(place: u32, child: u32, sides: FaceSides, corner: u32) {
    let beside = vec2(sides.edges[corner], sides.edges[(corner + 2u) % 3u]);
    let mids = vec2(edge_states[beside.x].mid, edge_states[beside.y].mid);
    let faces = vec2(child + corner, child + 3u);
    let inner = face_inner(sides.marks, corner);
    let is_river = inner == RIVER_TO_FIRST || inner == RIVER_TO_SECOND;
    // i_k runs m_k, m_k-1 as the corner child winds, which is therefore the first of its faces.
    let reversed = inner == RIVER_TO_FIRST || inner == GULLY_TO_FIRST;
    out_finer_edge_joins[place] = EdgeJoins(
        select(mids, mids.yx, reversed),
        select(faces, faces.yx, reversed),
    );
    if is_river {
        // A tributary joins the river at its second end.
        let river = select(beside.y, beside.x, reversed);
        let junction = vertex_cores[select(mids.y, mids.x, reversed)];
        let upstream = vertex_cores[edge_joins[river].vertices.x];
        let arriving = tributary(junction, upstream);
        let birth = level_uniform.level + 1u;
        out_finer_edge_states[place] = new_edge_state(RIVER_EDGE, birth, arriving);
    } else {
        let is_gully = inner == GULLY_TO_FIRST || inner == GULLY_TO_SECOND;
        let kind = select(TERRAIN_EDGE, GULLY_EDGE, is_gully);
        out_finer_edge_states[place] = new_edge_state(kind, 0u, 0u);
    }
}

// Pass: the four children of every split face.
@compute @workgroup_size(GROUP)
fn grow_faces(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= level_size().made.decided {
        return;
    }
    let face = decided[id.x];
    let corners = face_corners[face];
    if corners.child != NONE {
        quarter(face_sides[face].edges, corners);
    }
}

// Writes the four children of a split face.
fn quarter(edges: vec3<u32>, corners: FaceCorners) {
    let mids = vec3(
        edge_states[edges.x].mid,
        edge_states[edges.y].mid,
        edge_states[edges.z].mid,
    );
    let inner = first_inner(corners.child);
    for (var k = 0u; k < 3u; k++) {
        let other = (k + 2u) % 3u;
        let corner = corners.vertices[k];
        let halves = vec2(half_at(edges[k], corner), half_at(edges[other], corner));
        let vertices = vec3(corner, mids[k], mids[other]);
        new_face(corners.child + k, vertices, vec3(halves.x, inner + k, halves.y));
    }
    // The middle winds m0, m1, m2; m_k m_k+1 is the inner edge that cuts corner k + 1 off.
    new_face(corners.child + 3u, mids, vec3(inner + 1u, inner + 2u, inner));
}

// The half of an edge that ends at a corner.
fn half_at(edge: u32, corner: u32) -> u32 {
    return edge_states[edge].child + select(0u, 1u, edge_joins[edge].vertices.x != corner);
}

fn new_face(place: u32, vertices: vec3<u32>, edges: vec3<u32>) {
    out_finer_face_sides[place] = FaceSides(edges, LEAF);
    out_finer_face_corners[place] = FaceCorners(vertices, NONE);
}

// Pass: the two halves of every split edge. New dry land drains along one of them.
@compute @workgroup_size(GROUP)
fn grow_halves(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= level_size().made.mids {
        return;
    }
    let edge = halved[id.x];
    let state = edge_states[edge];
    if edge_state_mark(state) == SPLIT {
        let joins = edge_joins[edge];
        new_half(state.child, joins, state, joins.vertices.x, joins.vertices.y, true);
        new_half(state.child + 1u, joins, state, joins.vertices.y, joins.vertices.x, false);
    }
}

// Writes a half of an edge, that at `end`.
fn new_half(
    place: u32,
    joins: EdgeJoins,
    edge: EdgeState,
    end: u32,
    other: u32,
    is_first: bool,
) {
    let along = half_kind(edge, end, other, is_first);
    let faces = vec2(child_at(joins.faces.x, end), child_at(joins.faces.y, end));
    let vertices = select(vec2(edge.mid, end), vec2(end, edge.mid), is_first);
    out_finer_edge_joins[place] = EdgeJoins(
        select(vertices, vertices.yx, along.is_reversed),
        select(faces, faces.yx, along.is_reversed),
    );
    var birth = 0u;
    var arriving = 0u;
    if along.kind == RIVER_EDGE {
        // The birth bounds the width of the valley; what arrives keeps the discharge whole.
        birth = edge_state_birth(edge);
        arriving = edge.arriving;
        if is_first {
            arriving = arriving_at(edge.mid, vertex_cores[end]);
        }
    }
    var state = new_edge_state(along.kind, birth, arriving);
    state.marks |= select(0u, 1u << EDGE_DESCENT, along.is_descent);
    out_finer_edge_states[place] = state;
}

// The child that a face has at a vertex, or NONE.
fn child_at(face: u32, vertex: u32) -> u32 {
    if face == NONE {
        return NONE;
    }
    let corners = face_corners[face];
    // Child k keeps corner k. A face of the halo has no children.
    let at = corners.vertices == vec3(vertex);
    let child = corners.child + select(select(2u, 1u, at.y), 0u, at.x);
    return select(child, NONE, corners.child == NONE);
}

// Kind and direction of a half of an edge.
struct HalfKind {
    // Ground, river or gully.
    kind: u32,
    // Whether it runs against the edge.
    is_reversed: bool,
    // Whether dry land drains along it without a gully.
    is_descent: bool,
}

// Kind and direction of the half of an edge at an end.
fn half_kind(edge: EdgeState, end: u32, other: u32, is_first: bool) -> HalfKind {
    let rules = level_uniform.rules;
    let level = level_uniform.level;
    let kind = edge_state_kind(edge);
    let is_descent = edge_state_is_descent(edge);
    if kind == RIVER_EDGE {
        let is_spring = is_first && !is_wet(vertex_river_kind(vertex_rivers[end]));
        // The land above the spring drained along the river, and goes on so.
        if is_spring && level >= rules.extension_levels {
            return HalfKind(TERRAIN_EDGE, false, true);
        }
    }
    if kind != TERRAIN_EDGE {
        return HalfKind(kind, false, is_descent);
    }
    let river = vertex_rivers[edge.mid];
    let mid = GullyMid(
        vertex_river_kind(river),
        vertex_cores[edge.mid].height,
        vertex_river_is_drained(river),
    );
    let ends = array(gully_end(end), gully_end(other));
    if drains(rules, level, mid, ends[0], ends[1]) {
        return HalfKind(GULLY_EDGE, is_first, false);
    }
    // Edges of finer levels keep between their ends, and their halves depend on no vertex.
    let leads = level < rules.gully_levels && leads_down(mid, ends[0], ends[1]);
    return HalfKind(kind, false, is_descent || leads);
}

fn gully_end(vertex: u32) -> GullyEnd {
    let core = vertex_cores[vertex];
    return GullyEnd(core.height, core.seed);
}

// Discharge that arrives at a new river vertex from upstream: all but what its tributary brings.
fn arriving_at(vertex: u32, up: VertexCore) -> u32 {
    let mid = vertex_cores[vertex];
    // The tributary joins at the middle itself, not on the way to it.
    if vertex_river_is_branched(vertex_rivers[vertex]) {
        return mid.discharge - tributary(mid, up);
    }
    return mid.discharge;
}
