// The ground's columns: buffers, and where passes bind them. `finer_` names those of the next level,
// `out_` those that a pass writes, and whose own rows it may read.

// What the items of a level have in common.
@group(0) @binding(0) var<uniform> level_uniform: LevelUniform;

@group(1) @binding(0) var<storage, read> vertex_cores: array<VertexCore>;
@group(1) @binding(1) var<storage, read> edge_joins: array<EdgeJoins>;
@group(1) @binding(2) var<storage, read> edge_states: array<EdgeState>;
@group(1) @binding(3) var<storage, read> face_sides: array<FaceSides>;
@group(1) @binding(4) var<storage, read> face_corners: array<FaceCorners>;
@group(1) @binding(5) var<storage, read> face_splits: array<u32>;
@group(1) @binding(6) var<storage, read> block_counts: array<BlockCounts>;
@group(1) @binding(7) var<storage, read> halved: array<u32>;
@group(1) @binding(8) var<storage, read> decided: array<u32>;
@group(1) @binding(9) var<uniform> level_sizes: array<LevelSizes, LEVELS>;
@group(1) @binding(15) var<storage, read> triangles: array<array<u32, 3>>;
@group(1) @binding(16) var<storage, read> vertex_courses: array<VertexCourse>;
@group(1) @binding(17) var<storage, read> vertex_lands: array<VertexLand>;
@group(1) @binding(18) var<storage, read> vertex_rivers: array<VertexRiver>;
@group(1) @binding(19) var<storage, read> carved: array<Carved>;
@group(1) @binding(20) var<storage, read> shown: array<Carved>;

@group(1) @binding(32) var<storage, read_write> out_vertex_cores: array<VertexCore>;
@group(1) @binding(34) var<storage, read_write> out_edge_states: array<EdgeState>;
@group(1) @binding(35) var<storage, read_write> out_face_sides: array<FaceSides>;
@group(1) @binding(36) var<storage, read_write> out_face_corners: array<FaceCorners>;
@group(1) @binding(37) var<storage, read_write> out_face_splits: array<u32>;
@group(1) @binding(38) var<storage, read_write> out_block_counts: array<BlockCounts>;
@group(1) @binding(39) var<storage, read_write> out_halved: array<u32>;
@group(1) @binding(40) var<storage, read_write> out_decided: array<u32>;
@group(1) @binding(41) var<storage, read_write> out_level_sizes: array<LevelSizes>;
@group(1) @binding(42) var<storage, read_write> out_level_args: array<LevelArgs>;
@group(1) @binding(43) var<storage, read_write> out_finer_edge_joins: array<EdgeJoins>;
@group(1) @binding(44) var<storage, read_write> out_finer_edge_states: array<EdgeState>;
@group(1) @binding(45) var<storage, read_write> out_finer_face_sides: array<FaceSides>;
@group(1) @binding(46) var<storage, read_write> out_finer_face_corners: array<FaceCorners>;
@group(1) @binding(47) var<storage, read_write> out_triangles: array<array<u32, 3>>;
@group(1) @binding(48) var<storage, read_write> out_vertex_courses: array<VertexCourse>;
@group(1) @binding(49) var<storage, read_write> out_vertex_lands: array<VertexLand>;
@group(1) @binding(50) var<storage, read_write> out_vertex_rivers: array<VertexRiver>;
@group(1) @binding(51) var<storage, read_write> out_carved: array<Carved>;
@group(1) @binding(52) var<storage, read_write> out_shown: array<Carved>;

// Sizes of the level that a pass runs over.
fn level_size() -> LevelSizes {
    return level_sizes[level_uniform.level];
}

// Whether no face of the level is split, whatever its marks ask for: the buffers hold no more.
fn level_is_whole() -> bool {
    return level_size().made.children == 0u;
}

// The first block of faces, which follow on those of edges.
fn first_face_block() -> u32 {
    return blocks_of(level_size().edges);
}

// Blocks that hold so many items.
fn blocks_of(items: u32) -> u32 {
    return (items + BLOCK - 1u) / BLOCK;
}
