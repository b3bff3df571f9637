// Pass: exclusive prefix sums over blocks, which give every block its place among what all make.

// Replaces the counts of every block by those of all blocks before it; writes the sum of all, the
// sizes of the next level and the groups that run over both. One group does it.
@compute @workgroup_size(BLOCK)
fn scan(@builtin(local_invocation_index) item: u32) {
    let level = level_uniform.level;
    var sizes = out_level_sizes[level];
    let blocks = blocks_of(sizes.edges) + blocks_of(sizes.faces);
    // Every item of the group has a run of blocks.
    let run = (blocks + BLOCK - 1u) / BLOCK;
    let start = min(item * run, blocks);
    let end = min(start + run, blocks);
    var made = vec4(0u);
    var triangles = 0u;
    for (var block = start; block < end; block++) {
        made += vector_of(out_block_counts[block].made);
        triangles += out_block_counts[block].triangles;
    }
    let made_sums = summed(item, made);
    let triangle_sums = summed(item, vec4(triangles, 0u, 0u, 0u));
    write_run(start, end, made_sums.before, triangle_sums.before.x);
    if item == 0u {
        sizes.made = counts_of(made_sums.all);
        var triangles_of_level = triangle_sums.all.x;
        if !level_sizes_fits(sizes, triangles_of_level, level_uniform.caps) {
            // All faces of the level are leaves.
            sizes.made = LevelCounts();
            triangles_of_level = sizes.faces;
        }
        let next = level_sizes_next(sizes, triangles_of_level);
        out_level_sizes[level] = sizes;
        out_level_sizes[level + 1u] = next;
        // Those of the next level's own items are written again when it is counted.
        out_level_args[level] = level_args_new(sizes);
        out_level_args[level + 1u] = level_args_new(next);
    }
}

// Replaces the counts of a run of blocks by those of all before each.
fn write_run(start: u32, end: u32, made_before: vec4<u32>, triangles_before: u32) {
    var made = made_before;
    var triangles = triangles_before;
    for (var block = start; block < end; block++) {
        let counts = out_block_counts[block];
        out_block_counts[block] = BlockCounts(counts_of(made), triangles, counts.unused);
        made += vector_of(counts.made);
        triangles += counts.triangles;
    }
}

// Whether the buffers hold what a level makes, and its leaves. Of what it makes all could be leaves.
fn level_sizes_fits(sizes: LevelSizes, triangles: u32, caps: LevelCaps) -> bool {
    let made = sizes.made;
    let all_triangles = sizes.first_triangle + triangles + made.children;
    return sizes.first_vertex + made.mids <= caps.vertices
        && level_counts_edges(made) <= caps.edges
        && made.children <= caps.faces
        && all_triangles <= caps.triangles;
}

// Sizes of the level after one that becomes so many triangles.
fn level_sizes_next(sizes: LevelSizes, triangles: u32) -> LevelSizes {
    let first_vertex = sizes.first_vertex + sizes.made.mids;
    let first_triangle = sizes.first_triangle + triangles;
    let edges = level_counts_edges(sizes.made);
    return LevelSizes(edges, sizes.made.children, first_vertex, first_triangle, LevelCounts());
}

// The groups of a level of some sizes.
fn level_args_new(sizes: LevelSizes) -> LevelArgs {
    return LevelArgs(
        groups(sizes.faces, GROUP),
        groups(sizes.edges, BLOCK),
        groups(sizes.faces, BLOCK),
        groups(sizes.made.mids, GROUP),
        groups(sizes.made.decided, GROUP),
        0u,
    );
}

// Groups of a size that hold so many items.
fn groups(items: u32, size: u32) -> array<u32, 3> {
    return array((items + size - 1u) / size, 1u, 1u);
}
