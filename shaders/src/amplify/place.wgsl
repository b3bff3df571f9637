// Passes: every item that makes others gets the place of the first of them, and joins the list of
// those that do.

// Places what a block of edges makes.
@compute @workgroup_size(BLOCK)
fn place_edges(
    @builtin(workgroup_id) block: vec3<u32>,
    @builtin(local_invocation_index) item: u32,
) {
    let edge = block.x * BLOCK + item;
    let exists = edge < level_size().edges && !level_is_whole();
    if edge < level_size().edges && level_is_whole() {
        out_edge_states[edge].mid = NONE;
        out_edge_states[edge].child = NONE;
    }
    var mark = LEAF;
    if exists {
        mark = edge_state_mark(out_edge_states[edge]);
    }
    let sums = summed(item, vector_of(level_counts_of_edge(mark)));
    let before = counts_of(vector_of(block_counts[block.x].made) + sums.before);
    if exists {
        let mid = level_size().first_vertex + before.mids;
        out_edge_states[edge].mid = select(NONE, mid, mark != LEAF);
        out_edge_states[edge].child = select(NONE, before.halves, mark == SPLIT);
    }
    if mark != LEAF {
        out_halved[before.mids] = edge;
    }
}

// Places what a block of faces makes.
@compute @workgroup_size(BLOCK)
fn place_faces(
    @builtin(workgroup_id) block: vec3<u32>,
    @builtin(local_invocation_index) item: u32,
) {
    let face = block.x * BLOCK + item;
    let exists = face < level_size().faces && !level_is_whole();
    if face < level_size().faces && level_is_whole() {
        out_face_corners[face].child = NONE;
    }
    var mark = LEAF;
    if exists {
        mark = face_mark(face_sides[face].marks);
    }
    let sums = summed(item, vector_of(level_counts_of_face(mark)));
    let block_made = block_counts[first_face_block() + block.x].made;
    let before = counts_of(vector_of(block_made) + sums.before);
    if exists {
        out_face_corners[face].child = select(NONE, before.children, mark == SPLIT);
    }
    if mark != LEAF {
        out_decided[before.decided] = face;
    }
}
