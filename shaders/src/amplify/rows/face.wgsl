// The two rows of a face.

// The edges of a face, and what a run decided of it.
struct FaceSides {
    // edges[i] joins the corners i and i + 1.
    edges: vec3<u32>,
    // Mark (bits 0 to 3), how many of its neighbours are split although it is not (4 to 7), and its
    // inner edges, a byte each.
    marks: u32,
}

// The corners of a face, counter-clockwise from outside, and its children.
struct FaceCorners {
    vertices: vec3<u32>,
    // Its first child in the next level; NONE where it is not split.
    child: u32,
}

fn face_mark(marks: u32) -> u32 {
    return marks & 15u;
}

// How many triangles a face becomes: none where it is split, one more for every finer neighbour.
fn face_triangles(marks: u32) -> u32 {
    return select(1u + ((marks >> FACE_FINER) & 15u), 0u, face_mark(marks) == SPLIT);
}

// Drainage along the inner edge at a corner.
fn face_inner(marks: u32, corner: u32) -> u32 {
    return (marks >> (FACE_INNER + 8u * corner)) & 255u;
}

// The corner of a face that is no end of one of its edges.
fn corner_off(corners: vec3<u32>, ends: vec2<u32>) -> u32 {
    if all(vec2(corners.x) != ends) {
        return corners.x;
    }
    return select(corners.z, corners.y, all(vec2(corners.y) != ends));
}
