// Pass: leaf faces become triangles.
//
// A leaf beside finer ones has midpoints on one, two or three edges and becomes as many triangles
// more, so that every interior edge is used exactly twice and none has a vertex inside.

// The triangles of a block of faces, in the order of the faces.
@compute @workgroup_size(BLOCK)
fn emit_leaves(
    @builtin(workgroup_id) block: vec3<u32>,
    @builtin(local_invocation_index) item: u32,
) {
    let face = block.x * BLOCK + item;
    var made = 0u;
    if face < level_size().faces {
        made = face_triangles(face_sides[face].marks);
    }
    if level_is_whole() {
        if face < level_size().faces {
            let corners = face_corners[face].vertices;
            let place = level_size().first_triangle + face;
            out_triangles[place] = array(corners.x, corners.y, corners.z);
        }
        made = 0u;
    }
    let sums = summed(item, vec4(made, 0u, 0u, 0u));
    let before = block_counts[first_face_block() + block.x].triangles;
    if made > 0u {
        emit(face, level_size().first_triangle + before + sums.before.x);
    }
}

// A face turned so that its first split edge is ab.
struct Turned {
    corners: vec3<u32>,
    // Middles of ab, bc, ca; NONE where an edge is whole.
    mids: vec3<u32>,
}

// Writes up to four triangles of a leaf, the first at a place.
fn emit(face: u32, place: u32) {
    let corners = face_corners[face].vertices;
    let edges = face_sides[face].edges;
    let mids = vec3(split_mid(edges.x), split_mid(edges.y), split_mid(edges.z));
    let turned = turned_new(corners, mids);
    let split = vec3<u32>(mids != vec3(NONE));
    switch split.x + split.y + split.z {
        // Every pattern of split edges is one of four after turning the face.
        case 0u: {
            out_triangles[place] = array(corners.x, corners.y, corners.z);
        }
        case 1u: {
            write_halves(place, turned);
        }
        case 2u: {
            write_thirds(place, turned);
        }
        default: {
            write_quarters(place, turned);
        }
    }
}

// The middle of an edge that is split. Edges of the halo have one too, but no triangle ends there.
fn split_mid(edge: u32) -> u32 {
    let state = edge_states[edge];
    return select(NONE, state.mid, edge_state_mark(state) == SPLIT);
}

// Split edges follow one another, and the edge before the first is whole. The face stays as it is
// where all three edges are split, or none is.
fn turned_new(corners: vec3<u32>, mids: vec3<u32>) -> Turned {
    if mids.y != NONE && mids.x == NONE {
        return Turned(corners.yzx, mids.yzx);
    }
    if mids.z != NONE && mids.y == NONE {
        return Turned(corners.zxy, mids.zxy);
    }
    return Turned(corners, mids);
}

// The triangles where ab alone is split.
fn write_halves(place: u32, face: Turned) {
    let ab = face.mids.x;
    out_triangles[place] = array(face.corners.x, ab, face.corners.z);
    out_triangles[place + 1u] = array(ab, face.corners.y, face.corners.z);
}

// The triangles where ab and bc are split. The quadrilateral a, ab, bc, c is cut so that the lesser
// of its triangles is as large as can be.
fn write_thirds(place: u32, face: Turned) {
    let a = face.corners.x;
    let ab = face.mids.x;
    let bc = face.mids.y;
    let c = face.corners.z;
    let around = array(
        vertex_cores[a].direction,
        vertex_cores[ab].direction,
        vertex_cores[bc].direction,
        vertex_cores[c].direction,
    );
    let least = least_areas(around);
    // Seeds, not indices: those hang on the view.
    let drawn = vertex_cores[ab].seed > vertex_cores[bc].seed;
    out_triangles[place] = array(ab, face.corners.y, bc);
    if least.y > least.x || (least.y == least.x && drawn) {
        out_triangles[place + 1u] = array(a, ab, c);
        out_triangles[place + 2u] = array(ab, bc, c);
    } else {
        out_triangles[place + 1u] = array(a, ab, bc);
        out_triangles[place + 2u] = array(a, bc, c);
    }
}

// The triangles where all edges are split.
fn write_quarters(place: u32, face: Turned) {
    let corners = face.corners;
    let mids = face.mids;
    out_triangles[place] = array(corners.x, mids.x, mids.z);
    out_triangles[place + 1u] = array(corners.y, mids.y, mids.x);
    out_triangles[place + 2u] = array(corners.z, mids.z, mids.y);
    out_triangles[place + 3u] = array(mids.x, mids.y, mids.z);
}
