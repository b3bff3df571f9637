// The two rows of an edge.

// Everything that an edge joins.
struct EdgeJoins {
    // Its ends.
    vertices: vec2<u32>,
    // The faces on both sides, or NONE; the first has the edge in its winding direction.
    faces: vec2<u32>,
}

// The kind of an edge, and a run's part in it.
struct EdgeState {
    // The vertex that halves it; NONE where it is a leaf.
    mid: u32,
    // Its first half in the next level; NONE where it is not split.
    child: u32,
    // Discharge that arrives at the second vertex of a river edge.
    arriving: u32,
    // Kind, birth, whether it is a descent, and mark, a byte each from the lowest.
    marks: u32,
}

// The face on the other side of one of an edge's faces, or NONE.
fn edge_joins_beyond(edge: EdgeJoins, face: u32) -> u32 {
    return select(edge.faces.x, edge.faces.y, edge.faces.x == face);
}

fn edge_state_mark(edge: EdgeState) -> u32 {
    return edge.marks >> EDGE_MARK;
}

// The marks of an edge that keeps all but its mark.
fn edge_marks_with(marks: u32, mark: u32) -> u32 {
    return (marks & ((1u << EDGE_MARK) - 1u)) | (mark << EDGE_MARK);
}

// The state of an edge that a level has just got.
fn new_edge_state(kind: u32, birth: u32, arriving: u32) -> EdgeState {
    return EdgeState(NONE, NONE, arriving, kind | (birth << EDGE_BIRTH));
}

fn edge_state_kind(edge: EdgeState) -> u32 {
    return edge.marks & 255u;
}

// Level on which its river was born.
fn edge_state_birth(edge: EdgeState) -> u32 {
    return (edge.marks >> EDGE_BIRTH) & 255u;
}

// Whether dry land drains along it without a gully.
fn edge_state_is_descent(edge: EdgeState) -> bool {
    return ((edge.marks >> EDGE_DESCENT) & 1u) != 0u;
}
