// One vertex of the ground, and an edge as the rule of its new vertex sees it.

// A piece of river. Vertices around it carry it by value, so that their distance to it is a true
// one.
struct RiverSegment {
    // Directions of its ends, upstream first.
    ends: array<vec3<i32>, 2>,
    // Headings of the river there, unit tangents times 32767; zero stands for the way from end to
    // end.
    headings: array<vec3<i32>, 2>,
    // Water surface at the ends, grains.
    water: vec2<i32>,
    // Flow at the ends, Q16; where an arm of a delta leaves its apex, the whole river's.
    flow: vec2<i32>,
    // Tides at the ends.
    tide: vec2<i32>,
    // Flow of the vertices at the ends, Q16: both pieces at a vertex have its waves.
    waves: vec2<i32>,
    // Windings at the ends, Q15.
    winding: vec2<i32>,
    // Level on which its river was born, 0 for one of the control mesh.
    birth: u32,
    // Level of the edge it was.
    level: u32,
    // Whether it is a lake from end to end, which has shores but no bed.
    is_lake: bool,
}

// A valley's side at a place: its height, and how much of the ground that the graphs made is left.
struct ValleySection {
    // Height of the side, grains.
    height: i32,
    // Share of the ground's own height, Q16: 0 on the valley's floor, 1 beyond its rim.
    own: i32,
}

// Where there is no valley.
fn valley_section_outside(height: i32) -> ValleySection {
    return ValleySection(height, Q16);
}

// Half-way between two places.
fn valley_section_between(a: ValleySection, b: ValleySection) -> ValleySection {
    return ValleySection(a.height + (b.height - a.height) / 2, (a.own + b.own) / 2);
}

// One vertex of the ground.
struct Vertex {
    // Unit direction from the planet's centre, each component times ONE.
    direction: vec3<i32>,
    // Ground above sea level before carving, grains.
    height: i32,
    // Seed of its random numbers.
    seed: u32,
    // River bed or lake floor, grains; equals `height` at dry vertices.
    bed: i32,
    // Water surface, grains; equals `bed` at dry vertices.
    water: i32,
    // Discharge in 2^-32 of 200,000 m3/s; 0 at dry vertices.
    discharge: u32,
    // The nearest river's segment; meaningless where `river_distance` is FAR.
    river: RiverSegment,
    // Distance to `river`, grains; FAR without one.
    river_distance: i32,
    // Where along `river` its nearest point lies, Q16 from the upstream end.
    river_along: i32,
    // Where the river flows through a vertex of one, a unit tangent times 32767; else zero.
    heading: vec3<i32>,
    // The side of the river's valley here.
    section: ValleySection,
    // The lake that it lies in or beside; 0 for none.
    lake: u32,
    // Level of that lake, grains.
    lake_level: i32,
    // Crust elevation C above sea level, grains: the level that summits reach.
    crust: i32,
    // Kind: ground, sea, coast, river, lake or gully.
    kind: u32,
    // Level that made it; 0 in the control mesh.
    level: u32,
    // Valley archetype.
    valley: u32,
    // How much wider a river is here than its discharge makes it, in 256ths of an octave.
    tide: i32,
    // Whether a river or gully already branches here.
    branched: bool,
    // Whether a valley leads down from it.
    is_drained: bool,
    // How far age has worn the land, Q16.
    worn: i32,
    // How much the river winds here, Q15, positive where it crosses its axis to the left.
    winding: i32,
    // Whether `river` is the piece of its own river that it lies on, which finer levels keep.
    keeps_course: bool,
    // Share of continental collision in the orogeny, Q16.
    collision: i32,
    // Wetness, Q16.
    wetness: i32,
    // Plateau presence, Q16.
    plateau: i32,
    // Hill presence, Q16.
    hills: i32,
    // Share of oceanic crust, Q16.
    oceanic: i32,
    // Age of the ocean floor, 1/64 My.
    ocean_age: i32,
    // Relief of the sea floor before it fades towards the shore, grains.
    swell: i32,
    // Fold direction, components times 32767; zero where there is none.
    fold: vec3<i32>,
    // Ridge direction of the ocean floor, components times 32767; zero where there is none.
    ridge: vec3<i32>,
}

// A vertex that there may be.
struct MaybeVertex {
    vertex: Vertex,
    is_known: bool,
}

// Flow: the root of the discharge over 200,000 m3/s, Q16.
fn vertex_flow(vertex: Vertex) -> i32 {
    return i32(isqrt(vertex.discharge));
}

// Height of its ground, or of the water that covers it; grains.
fn vertex_surface(vertex: Vertex) -> i32 {
    return select(vertex.height, vertex.water, vertex_is_wet(vertex));
}

// Whether it is a vertex of a river that lies in the bed of a larger one.
fn vertex_is_in_larger_river(vertex: Vertex) -> bool {
    let is_own = vertex.keeps_course || all(vertex.river.ends[0] == vertex.river.ends[1]);
    return vertex.kind == RIVER && vertex.river_distance < FAR && !is_own;
}

// Whether water stands or runs here on land.
fn vertex_is_wet(vertex: Vertex) -> bool {
    return is_wet(vertex.kind);
}

// Whether water stands or runs on land at vertices of a kind.
fn is_wet(kind: u32) -> bool {
    return kind == RIVER || kind == LAKE;
}

// An edge as a vertex's rule sees it: its ends, and the vertex that halves it, which has everything
// but its elevation.
struct EdgeContext {
    // One end; the upstream one of a river edge.
    a: Vertex,
    // The other end.
    b: Vertex,
    // The new vertex.
    new_vertex: Vertex,
    // Height of the flat face where the new vertex lies, grains.
    face: i32,
    // Lowest and highest ground of the corners of the faces beside the edge, grains.
    range: vec2<i32>,
    // Whether no corner of the edge's faces lies below the water of its ends.
    is_dammed: bool,
    // How far the ground beside the edge bends up, grains.
    curvature: i32,
    // The corners opposite to the edge.
    beside: array<CornerBeside, 2>,
    // Whether dry land drains along the edge without a gully.
    is_descent: bool,
    // Length of the edge, grains.
    length: i32,
    // Mean length of the edges of its level, grains.
    span: i32,
    // Level of the edge, 0..16.
    level: u32,
    // Radius of the planet, metres.
    radius_m: u32,
}

// A corner of a face beside an edge.
struct CornerBeside {
    is_known: bool,
    // Its ground, grains.
    height: i32,
    // How far it is from the new vertex, grains.
    distance: i32,
}

// The end that is wet, and the other: of an edge between water and land.
fn edge_context_wet_end_first(context: EdgeContext) -> array<Vertex, 2> {
    if vertex_is_wet(context.a) {
        return array(context.a, context.b);
    }
    return array(context.b, context.a);
}
