// Pass: an edge gets the vertex that halves it.

// Pass: the vertices that halve edges of a level, in the order of the list.
@compute @workgroup_size(GROUP)
fn edge_split(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= level_size().made.mids {
        return;
    }
    let edge = halved[id.x];
    let joins = edge_joins[edge];
    let state = edge_states[edge];
    let level = level_uniform.level;
    let a = split_vertex(joins.vertices.x);
    let b = split_vertex(joins.vertices.y);
    // Straight edges do not move sideways and need no corners; rivers keep their course.
    let has_corners = level < STRAIGHT_LEVEL || edge_state_kind(state) == RIVER_EDGE;
    let opposite = array(
        split_corner(joins, joins.faces.x, has_corners),
        split_corner(joins, joins.faces.y, has_corners),
    );
    var made = split(
        level_uniform.sight.scale,
        level_uniform.rules,
        state,
        level,
        a,
        b,
        opposite,
    );
    made.swell = ocean_settle(made, a, b);
    out_vertex_cores[state.mid] = vertex_core_of(made);
    out_vertex_courses[state.mid] = vertex_course_of(made);
    out_vertex_lands[state.mid] = vertex_land_of(made);
    out_vertex_rivers[state.mid] = vertex_river_of(made);
}

// A vertex of a coarser level.
fn split_vertex(vertex: u32) -> Vertex {
    return vertex_of_rows(
        out_vertex_cores[vertex],
        out_vertex_courses[vertex],
        out_vertex_lands[vertex],
        out_vertex_rivers[vertex],
    );
}

// The corner of a face that is no end of its edge.
fn split_corner(joins: EdgeJoins, face: u32, is_asked: bool) -> MaybeVertex {
    if face == NONE || !is_asked {
        return MaybeVertex();
    }
    return MaybeVertex(split_vertex(corner_off(face_corners[face].vertices, joins.vertices)), true);
}

// The vertex that halves an edge of a level, but for the sea floor's relief. `a` and `b` are the ends
// of the edge, in its order.
fn split(
    scale: PlanetScale,
    rules: Rules,
    edge: EdgeState,
    level: u32,
    a: Vertex,
    b: Vertex,
    opposite: array<MaybeVertex, 2>,
) -> Vertex {
    let kind = edge_state_kind(edge);
    var made = average(a, b, level);
    let length = planet_scale_grains(scale, difference(b.direction, a.direction));
    let course = course_of(scale, rules, edge, level, a, b);
    var where_to = Shares();
    if course.is_known {
        where_to = on_course(course, made.seed, a, b, opposite);
    } else {
        where_to = shares(rules, kind, level, made, a, b, opposite);
    }
    let placed = place(made.seed, where_to, a, b, opposite);
    made.direction = placed.direction;
    made.swell = placed.swell;
    made.crust = summits(rules, level, made, a, b);
    if kind == RIVER_EDGE {
        made = lead_river(made, course, a, b, opposite, length);
    }
    // An estimate for the rules; the faces beside the edge settle it later.
    made.river_distance = expected_distance(kind, a, b, length);
    made.discharge = gathered(a, edge);
    let lake = lake_around(level, a, b, opposite);
    made.lake = lake.number;
    made.lake_level = lake.level;
    made.is_drained = is_drained(kind, level, made.seed, a, b);
    let x = opposite[0];
    let y = opposite[1];
    let context = EdgeContext(
        a,
        b,
        made,
        placed.face,
        range_of(a, b, opposite),
        is_dammed(a, b, opposite),
        curvature_of(a, b, opposite),
        array(corner_beside(scale, made, x), corner_beside(scale, made, y)),
        edge_state_is_descent(edge),
        length,
        planet_scale_edge_grains(scale, level),
        level,
        scale.radius_m,
    );
    // The rules see the vertex complete but for its ground.
    let ground = rules_halve(rules, kind, context);
    made.kind = ground.kind;
    made.height = ground.height;
    made.bed = ground.bed;
    made.water = ground.water;
    return lakes_settle(rules, kind, made, a, b);
}

// A corner opposite to the edge that a new vertex halves, as the new vertex sees it.
fn corner_beside(scale: PlanetScale, made: Vertex, corner: MaybeVertex) -> CornerBeside {
    if !corner.is_known {
        return CornerBeside();
    }
    let way = difference(corner.vertex.direction, made.direction);
    return CornerBeside(true, corner.vertex.height, planet_scale_grains(scale, way));
}

// Lowest and highest ground of an edge's ends and of the corners beyond it.
fn range_of(a: Vertex, b: Vertex, opposite: array<MaybeVertex, 2>) -> vec2<i32> {
    var range = ordered(a.height, b.height);
    for (var side = 0u; side < 2u; side++) {
        let height = select(opposite[0].vertex.height, opposite[1].vertex.height, side == 1u);
        if select(opposite[0].is_known, opposite[1].is_known, side == 1u) {
            range = vec2(min(range.x, height), max(range.y, height));
        }
    }
    return range;
}

// Leads a river through the vertex that halves its edge: its heading there, its tide, its winding.
fn lead_river(
    made: Vertex,
    course: Course,
    a: Vertex,
    b: Vertex,
    opposite: array<MaybeVertex, 2>,
    length: i32,
) -> Vertex {
    var out = made;
    var way = difference(b.direction, a.direction);
    if course.is_known {
        way = curve_quarter_tangent(course.curve, Q16 / 2);
    }
    out.heading = heading_of(way);
    out.tide = (a.tide + b.tide) >> 1u;
    // A lake may come to lie here, which has no bends.
    if b.kind != LAKE {
        let fall = ratio(saturating_sub(a.water, b.water), max(length, 1));
        // The side that a tributary would come from.
        out.winding = winding(fall, made.seed, comes_from_left(made.seed, opposite));
    }
    return out;
}

// Whether a tributary would join at a junction of a seed from the left.
fn comes_from_left(seed: u32, opposite: array<MaybeVertex, 2>) -> bool {
    if !opposite[0].is_known || !opposite[1].is_known {
        return opposite[0].is_known;
    }
    let left = junction_draw(seed, opposite[0].vertex.seed);
    return left > junction_draw(seed, opposite[1].vertex.seed);
}

// The course of a river along its edge.
fn course_of(
    scale: PlanetScale,
    rules: Rules,
    edge: EdgeState,
    level: u32,
    a: Vertex,
    b: Vertex,
) -> Course {
    let is_river = edge_state_kind(edge) == RIVER_EDGE;
    if !is_river || rules.landforms == 0u || !vertex_is_wet(a) {
        return Course();
    }
    let birth = edge_state_birth(edge);
    let river = river_segment_between(birth, level, a, b, edge.arriving);
    let is_kept = river_segment_is_kept(scale, rules, birth, edge.arriving, level, a, b);
    return Course(true, river_segment_curve(river), is_kept);
}

// How far the ground beside an edge bends up, grains.
fn curvature_of(a: Vertex, b: Vertex, opposite: array<MaybeVertex, 2>) -> i32 {
    let x = opposite[0];
    let y = opposite[1];
    if !x.is_known || !y.is_known {
        return 0;
    }
    return (x.vertex.height - a.height) / 4 + (y.vertex.height - b.height) / 4;
}

// Discharge in the middle of an edge: on a river, half of what the edge gains has come by then. An
// arm of a delta loses the other arms' at its upper end.
fn gathered(up: Vertex, edge: EdgeState) -> u32 {
    if edge_state_kind(edge) != RIVER_EDGE {
        return 0u;
    }
    if edge.arriving < up.discharge {
        return edge.arriving;
    }
    return up.discharge + (edge.arriving - up.discharge) / 2u;
}

// A vertex whose maps are the mean of its parents', without a place, a height or water.
fn average(a: Vertex, b: Vertex, level: u32) -> Vertex {
    var out = Vertex();
    out.direction = a.direction;
    out.seed = between(a.seed, b.seed);
    out.river_distance = FAR;
    out.section = valley_section_between(a.section, b.section);
    out.crust = a.crust + (b.crust - a.crust) / 2;
    out.kind = TERRAIN;
    out.level = level + 1u;
    out.valley = select(b.valley, a.valley, (out.seed & 1u) == 0u);
    out.worn = (a.worn + b.worn) >> 1u;
    out.collision = (a.collision + b.collision) >> 1u;
    out.wetness = (a.wetness + b.wetness) >> 1u;
    out.plateau = (a.plateau + b.plateau) >> 1u;
    out.hills = (a.hills + b.hills) >> 1u;
    out.oceanic = (a.oceanic + b.oceanic) >> 1u;
    out.ocean_age = (a.ocean_age + b.ocean_age) >> 1u;
    out.fold = undirected_mean(a.fold, b.fold);
    out.ridge = undirected_mean(a.ridge, b.ridge);
    return out;
}

// Mean of two undirected vectors: the second is turned to the first's side.
fn undirected_mean(a: vec3<i32>, b: vec3<i32>) -> vec3<i32> {
    // Components of 15 bits, halved so that three products fit.
    let along = product(shifted(a, 1u), shifted(b, 1u));
    // An axis has no sign: the nearer of the two directions counts.
    return (a + select(b, -b, along < 0)) / 2;
}

// The nearest river's distance as the parents know it.
fn expected_distance(kind: u32, a: Vertex, b: Vertex, length: i32) -> i32 {
    if kind == RIVER_EDGE {
        return 0;
    }
    let d = a.river_distance;
    let e = b.river_distance;
    if d == 0 && e == 0 {
        return length / 2;
    }
    // FAR is no number to average: the end that knows a river counts.
    if d == FAR || e == FAR {
        let known = select(d, e, d == FAR);
        return select(min(known, FAR - length / 2) + length / 2, FAR, known == FAR);
    }
    return d / 2 + e / 2;
}
