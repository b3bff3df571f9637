// The rows of a vertex, and the whole of it.

// Where a vertex is, how high, its seed and its water.
struct VertexCore {
    // Unit direction from the planet's centre, each component times ONE.
    direction: vec3<i32>,
    // Ground above sea level before carving, grains.
    height: i32,
    // Seed of its random numbers.
    seed: u32,
    // River bed or lake floor, grains.
    bed: i32,
    // Water surface, grains.
    water: i32,
    // Discharge in 2^-32 of 200,000 m3/s.
    discharge: u32,
}

// How a river runs through a vertex, and what the vertex was before the faces beside it settled it.
struct VertexCourse {
    // Crust elevation, grains.
    crust: i32,
    // The first two components of the heading, half a word each.
    heading: u32,
    // The third, and the tide.
    heading_tide: u32,
    // The winding, and from bit 16 kind (3), level (5), valley (2), and whether a valley leads down.
    winding_marks: u32,
}

// What the land at a vertex is like; two numbers a word.
struct VertexLand {
    // Relief of the sea floor, grains.
    swell: i32,
    // Number of its lake.
    lake: u32,
    // Level of its lake, grains.
    lake_level: i32,
    worn_collision: u32,
    wetness_plateau: u32,
    hills_oceanic: u32,
    // Age of the ocean floor, and the fold's first component.
    ocean_age_fold: u32,
    // The fold's other components.
    fold: u32,
    // The first two components of the ridge.
    ridge: u32,
    // The third.
    ridge_end: u32,
}

// The river that is nearest to a vertex, and what the faces beside the vertex settled.
struct VertexRiver {
    // Directions of the segment's ends.
    ends: array<array<i32, 3>, 2>,
    // Headings at both ends, half a word each component.
    headings: array<u32, 3>,
    // Water at the ends, grains.
    water: array<i32, 2>,
    // Flow, tide, waves and winding at the ends, half a word each.
    flow: u32,
    tide: u32,
    waves: u32,
    winding: u32,
    // Birth (bits 0 to 4) and level (5 to 9) of the segment, whether it is a lake (10); kind of the
    // vertex (11 to 13), whether a river branches there (14), whether the segment is its own (15),
    // whether a valley leads down from it (16).
    marks: u32,
    // Distance to the river, grains.
    distance: i32,
    // Where along the segment that is, Q16.
    along: i32,
    // Height of the valley's side, grains.
    section_height: i32,
    // Share of the ground's own height, Q16.
    section_own: i32,
}

// Two halves of a word, as signed numbers.
fn signed_halves(word: u32) -> vec2<i32> {
    return vec2(i32(word << 16u) >> 16u, i32(word) >> 16u);
}

// Two halves of a word.
fn halves(word: u32) -> vec2<i32> {
    return vec2(i32(word & 0xffffu), i32(word >> 16u));
}

// A word of two numbers of 16 bits.
fn packed(low: i32, high: i32) -> u32 {
    return (u32(low) & 0xffffu) | (u32(high) << 16u);
}

fn vertex_course_kind(course: VertexCourse) -> u32 {
    return (course.winding_marks >> COURSE_KIND) & 7u;
}

fn vertex_river_kind(river: VertexRiver) -> u32 {
    return (river.marks >> RIVER_KIND) & 7u;
}

fn vertex_river_is_branched(river: VertexRiver) -> bool {
    return (river.marks & (1u << RIVER_BRANCHED)) != 0u;
}

fn vertex_river_is_drained(river: VertexRiver) -> bool {
    return (river.marks & (1u << RIVER_DRAINED)) != 0u;
}

// The segment of a row.
fn vertex_river_segment(river: VertexRiver) -> RiverSegment {
    let ends = river.ends;
    let headings = river.headings;
    let first = signed_halves(headings[0]);
    let second = signed_halves(headings[1]);
    let third = signed_halves(headings[2]);
    return RiverSegment(
        array(vec3(ends[0][0], ends[0][1], ends[0][2]), vec3(ends[1][0], ends[1][1], ends[1][2])),
        array(vec3(first, second.x), vec3(second.y, third)),
        vec2(river.water[0], river.water[1]),
        halves(river.flow),
        halves(river.tide),
        halves(river.waves),
        signed_halves(river.winding),
        river.marks & 31u,
        (river.marks >> SEGMENT_LEVEL) & 31u,
        (river.marks & (1u << SEGMENT_LAKE)) != 0u,
    );
}

// A vertex of its rows.
fn vertex_of_rows(
    core: VertexCore,
    course: VertexCourse,
    land: VertexLand,
    river: VertexRiver,
) -> Vertex {
    var out = Vertex();
    out.direction = core.direction;
    out.height = core.height;
    out.seed = core.seed;
    out.bed = core.bed;
    out.water = core.water;
    out.discharge = core.discharge;
    out.crust = course.crust;
    let heading_tide = signed_halves(course.heading_tide);
    out.heading = vec3(signed_halves(course.heading), heading_tide.x);
    out.tide = heading_tide.y & 0xffff;
    out.winding = signed_halves(course.winding_marks).x;
    out.level = (course.winding_marks >> COURSE_LEVEL) & 31u;
    out.valley = (course.winding_marks >> COURSE_VALLEY) & 3u;
    out.swell = land.swell;
    out.lake = land.lake;
    out.lake_level = land.lake_level;
    let worn_collision = halves(land.worn_collision);
    out.worn = worn_collision.x;
    out.collision = worn_collision.y;
    let wetness_plateau = halves(land.wetness_plateau);
    out.wetness = wetness_plateau.x;
    out.plateau = wetness_plateau.y;
    let hills_oceanic = halves(land.hills_oceanic);
    out.hills = hills_oceanic.x;
    out.oceanic = hills_oceanic.y;
    let age_fold = signed_halves(land.ocean_age_fold);
    out.ocean_age = age_fold.x & 0xffff;
    out.fold = vec3(age_fold.y, signed_halves(land.fold));
    out.ridge = vec3(signed_halves(land.ridge), signed_halves(land.ridge_end).x);
    out.river = vertex_river_segment(river);
    out.river_distance = river.distance;
    out.river_along = river.along;
    out.section = ValleySection(river.section_height, river.section_own);
    out.kind = vertex_river_kind(river);
    out.branched = vertex_river_is_branched(river);
    out.keeps_course = (river.marks & (1u << RIVER_KEEPS_COURSE)) != 0u;
    out.is_drained = vertex_river_is_drained(river);
    return out;
}

fn vertex_core_of(vertex: Vertex) -> VertexCore {
    return VertexCore(
        vertex.direction,
        vertex.height,
        vertex.seed,
        vertex.bed,
        vertex.water,
        vertex.discharge,
    );
}

fn vertex_course_of(vertex: Vertex) -> VertexCourse {
    let marks = (vertex.kind << COURSE_KIND) | (vertex.level << COURSE_LEVEL)
        | (vertex.valley << COURSE_VALLEY) | (u32(vertex.is_drained) << COURSE_DRAINED);
    return VertexCourse(
        vertex.crust,
        packed(vertex.heading.x, vertex.heading.y),
        packed(vertex.heading.z, vertex.tide),
        packed(vertex.winding, 0) | marks,
    );
}

fn vertex_land_of(vertex: Vertex) -> VertexLand {
    return VertexLand(
        vertex.swell,
        vertex.lake,
        vertex.lake_level,
        packed(vertex.worn, vertex.collision),
        packed(vertex.wetness, vertex.plateau),
        packed(vertex.hills, vertex.oceanic),
        packed(vertex.ocean_age, vertex.fold.x),
        packed(vertex.fold.y, vertex.fold.z),
        packed(vertex.ridge.x, vertex.ridge.y),
        packed(vertex.ridge.z, 0),
    );
}

fn vertex_river_of(vertex: Vertex) -> VertexRiver {
    let segment = vertex.river;
    let from_end = segment.ends[0];
    let to_end = segment.ends[1];
    let leaving = segment.headings[0];
    let arriving = segment.headings[1];
    let of_segment = segment.birth | (segment.level << SEGMENT_LEVEL)
        | (u32(segment.is_lake) << SEGMENT_LAKE);
    let of_vertex = (vertex.kind << RIVER_KIND) | (u32(vertex.branched) << RIVER_BRANCHED)
        | (u32(vertex.keeps_course) << RIVER_KEEPS_COURSE)
        | (u32(vertex.is_drained) << RIVER_DRAINED);
    return VertexRiver(
        array(array(from_end.x, from_end.y, from_end.z), array(to_end.x, to_end.y, to_end.z)),
        array(
            packed(leaving.x, leaving.y),
            packed(leaving.z, arriving.x),
            packed(arriving.y, arriving.z),
        ),
        array(segment.water.x, segment.water.y),
        packed(segment.flow.x, segment.flow.y),
        packed(segment.tide.x, segment.tide.y),
        packed(segment.waves.x, segment.waves.y),
        packed(segment.winding.x, segment.winding.y),
        of_segment | of_vertex,
        vertex.river_distance,
        vertex.river_along,
        vertex.section.height,
        vertex.section.own,
    );
}
