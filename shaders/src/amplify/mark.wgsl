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

// Level that the view shows at a vertex, Q16: that of the leaves at its distance, evenly from one to
// the next.
fn view_shown_level(sight: Sight, vertex: Corner) -> i32 {
    let finest = i32(sight.view.level) * Q16;
    let distance = max(sight_distance(sight, array(vertex, vertex, vertex)), 1);
    let sharpness = view_clamped_sharpness(sight.view);
    // Half a level finer than the split: leaves of two levels meet there.
    let farthest = mul_shift(sight.scale.edge, sharpness + sharpness / 2u, 8u);
    if distance >= farthest {
        return 0;
    }
    // Levels go by the logarithm of the distance, linear between powers of two.
    let halvings = firstLeadingBit(u32(farthest / distance));
    let nearest = farthest >> halvings;
    let part = ratio(2 * (nearest - distance), nearest);
    return min(i32(halvings) * Q16 + part, finest);
}
