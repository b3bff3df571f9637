// Rows about whole levels and blocks of items: what they make, and how many groups run over them.

// Numbers of items that edges and faces make in the next level.
struct LevelCounts {
    // New vertices: of split and halo edges.
    mids: u32,
    // Halves of split edges.
    halves: u32,
    // Children of split faces.
    children: u32,
    // Faces whose inner edges are decided: split and halo.
    decided: u32,
}

// Items that a block makes, before the scan; after it those that the blocks before it make. The
// blocks of faces follow on those of edges.
struct BlockCounts {
    made: LevelCounts,
    // Triangles of leaves.
    triangles: u32,
    unused: array<u32, 3>,
}

// Sizes of a level, and what it makes.
struct LevelSizes {
    edges: u32,
    faces: u32,
    // Vertices of all coarser levels and of itself: the number of the first that it makes.
    first_vertex: u32,
    // Triangles of all coarser levels.
    first_triangle: u32,
    made: LevelCounts,
}

// What the buffers of a run hold.
struct LevelCaps {
    // Vertices of all levels.
    vertices: u32,
    // Edges of a level.
    edges: u32,
    // Faces of a level.
    faces: u32,
    // Triangles of all leaves.
    triangles: u32,
}

// Groups that the passes of a level run with: arguments of indirect dispatches.
struct LevelArgs {
    // Over its faces, in groups.
    faces: array<u32, 3>,
    // Over its edges, in blocks.
    edge_blocks: array<u32, 3>,
    // Over its faces, in blocks.
    face_blocks: array<u32, 3>,
    // Over its edges that get a vertex, in groups.
    halved: array<u32, 3>,
    // Over its faces that decide, in groups.
    decided: array<u32, 3>,
    unused: u32,
}
