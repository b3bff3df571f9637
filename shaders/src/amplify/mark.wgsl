// Passes: a face decides whether it is split for a view, then whether it lies beside a split one.

// Marks the faces of a level that are split; all others become leaves.
@compute @workgroup_size(GROUP)
fn mark_split(@builtin(global_invocation_id) id: vec3<u32>) {
    let face = id.x;
    if face >= level_size().faces {
        return;
    }
    let corners = face_corners[face].vertices;
    let places = array(corner_at(corners.x), corner_at(corners.y), corner_at(corners.z));
    let split = sight_splits(level_uniform.sight, level_uniform.level, places);
    out_face_splits[face] = select(0u, 1u, split);
}

// What the distance of a face depends on in a vertex.
fn corner_at(vertex: u32) -> Corner {
    return Corner(vertex_cores[vertex].direction, vertex_cores[vertex].height);
}

// Marks the faces beside a split one as halo. It reads which faces are split and writes the marks,
// so no item sees what another writes.
@compute @workgroup_size(GROUP)
fn mark_halo(@builtin(global_invocation_id) id: vec3<u32>) {
    let face = id.x;
    if face >= level_size().faces {
        return;
    }
    if face_splits[face] != 0u {
        out_face_sides[face].marks = SPLIT;
        return;
    }
    let edges = out_face_sides[face].edges;
    let finer = split_beyond(edges.x, face) + split_beyond(edges.y, face) + split_beyond(edges.z, face);
    let mark = select(LEAF, HALO, finer > 0u);
    // All of the word: nothing is left of an earlier run.
    out_face_sides[face].marks = mark | (finer << FACE_FINER);
}

// 1 where the face on the other side of an edge is split.
fn split_beyond(edge: u32, face: u32) -> u32 {
    let other = edge_joins_beyond(edge_joins[edge], face);
    if other == NONE {
        return 0u;
    }
    return face_splits[other];
}
