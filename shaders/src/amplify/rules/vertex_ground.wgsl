// The ground that a rule gives to a new vertex.

struct VertexGround {
    // Kind of the vertex.
    kind: u32,
    // Ground, grains.
    height: i32,
    // River bed or lake floor, grains; equals `height` at dry vertices.
    bed: i32,
    // Water surface, grains; equals `bed` at dry vertices.
    water: i32,
}

// Dry ground of one kind.
fn vertex_ground_dry(kind: u32, height: i32) -> VertexGround {
    return VertexGround(kind, height, height, height);
}
