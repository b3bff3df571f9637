// Passes: what a level makes, counted in blocks of items, and the edges' marks on the way.

// Values of the items of the group that runs, and sums of rows of them. Four numbers are summed at
// once.
var<workgroup> group_values: array<vec4<u32>, BLOCK>;
var<workgroup> row_sums: array<vec4<u32>, SUM_ROWS>;

// Items that an edge of a mark makes.
fn level_counts_of_edge(mark: u32) -> LevelCounts {
    return LevelCounts(select(0u, 1u, mark != LEAF), select(0u, 2u, mark == SPLIT), 0u, 0u);
}

// Items that a face of a mark makes.
fn level_counts_of_face(mark: u32) -> LevelCounts {
    return LevelCounts(0u, 0u, select(0u, 4u, mark == SPLIT), select(0u, 1u, mark != LEAF));
}

// Both.
fn level_counts_and(a: LevelCounts, b: LevelCounts) -> LevelCounts {
    return counts_of(vector_of(a) + vector_of(b));
}

// Edges of the next level: halves, and three inner edges for every four faces.
fn level_counts_edges(made: LevelCounts) -> u32 {
    return made.halves + made.children / 4u * 3u;
}

fn vector_of(made: LevelCounts) -> vec4<u32> {
    return vec4(made.mids, made.halves, made.children, made.decided);
}

fn counts_of(sums: vec4<u32>) -> LevelCounts {
    return LevelCounts(sums.x, sums.y, sums.z, sums.w);
}

// Sums over the items of a group before one, and over all of them.
struct GroupSums {
    before: vec4<u32>,
    all: vec4<u32>,
}

// The sums at an item. Every item of the group must call it, with its number in the group. Waiting
// for one another costs more than adding: by rows they wait three times, in pairs seventeen.
fn summed(item: u32, value: vec4<u32>) -> GroupSums {
    group_values[item] = value;
    workgroupBarrier();
    if item < SUM_ROWS {
        row_sums[item] = sum_of_values(item * SUM_ROW, (item + 1u) * SUM_ROW);
    }
    workgroupBarrier();
    let row = item / SUM_ROW;
    var sums = GroupSums();
    for (var i = 0u; i < SUM_ROWS; i++) {
        if i == row {
            sums.before = sums.all;
        }
        sums.all += row_sums[i];
    }
    sums.before += sum_of_values(row * SUM_ROW, item);
    // The memory may be used again.
    workgroupBarrier();
    return sums;
}

// The sum of the values from one item to before another.
fn sum_of_values(start: u32, end: u32) -> vec4<u32> {
    var sum = vec4(0u);
    for (var i = start; i < end; i++) {
        sum += group_values[i];
    }
    return sum;
}

// Marks edges as the greater of their faces' marks, and counts a block of them.
@compute @workgroup_size(BLOCK)
fn count_edges(
    @builtin(workgroup_id) block: vec3<u32>,
    @builtin(local_invocation_index) item: u32,
) {
    let edge = block.x * BLOCK + item;
    var made = LevelCounts();
    if edge < level_size().edges {
        let faces = edge_joins[edge].faces;
        let mark = max(mark_of_face(faces.x), mark_of_face(faces.y));
        out_edge_states[edge].marks = edge_marks_with(out_edge_states[edge].marks, mark);
        made = level_counts_of_edge(mark);
    }
    let sums = summed(item, vector_of(made));
    if item == 0u {
        write_block(block.x, sums.all, 0u);
    }
}

// Counts a block of faces, and the triangles that they become.
@compute @workgroup_size(BLOCK)
fn count_faces(
    @builtin(workgroup_id) block: vec3<u32>,
    @builtin(local_invocation_index) item: u32,
) {
    let face = block.x * BLOCK + item;
    var made = vec4(0u);
    if face < level_size().faces {
        let marks = face_sides[face].marks;
        made = vector_of(level_counts_of_face(face_mark(marks)));
        // Faces make no vertices, so the place of those is free.
        made.x = face_triangles(marks);
    }
    let sums = summed(item, made);
    if item == 0u {
        write_block(first_face_block() + block.x, vec4(0u, sums.all.yzw), sums.all.x);
    }
}

// The mark of a face; that of a leaf beyond the rim.
fn mark_of_face(face: u32) -> u32 {
    if face == NONE {
        return LEAF;
    }
    return face_mark(face_sides[face].marks);
}

fn write_block(block: u32, made: vec4<u32>, triangles: u32) {
    out_block_counts[block] = BlockCounts(counts_of(made), triangles, array(0u, 0u, 0u));
}
