// Lakes: their shores and floors.

// Print and release: the floor between two vertices of one lake, or a crest between two lakes.
fn lake_between(rules: Rules, context: EdgeContext) -> VertexGround {
    let a = context.a;
    let b = context.b;
    if a.lake != b.lake || a.water != b.water {
        return between_rivers(rules, context);
    }
    return under(a.bed + (b.bed - a.bed) / 2, a.water);
}

// How an edge in or beside a lake gets its vertex, in ours: a number of LAKE_FLOOR and the like.
fn lake_edge_of(edge: u32, context: EdgeContext) -> u32 {
    let a = context.a;
    let b = context.b;
    let level = context.new_vertex.lake_level;
    let first_is_lake = a.kind == LAKE && a.water == level;
    let second_is_lake = b.kind == LAKE && b.water == level;
    let first_is_level = vertex_is_wet(a) && a.water == level;
    let second_is_level = vertex_is_wet(b) && b.water == level;
    if (first_is_lake && second_is_level) || (second_is_lake && first_is_level) {
        return LAKE_FLOOR;
    }
    if edge == RIVER_EDGE {
        return select(LAKE_AWAY, LAKE_INFLOW, second_is_lake && vertex_is_wet(a));
    }
    let land_is_wet = select(vertex_is_wet(a), vertex_is_wet(b), first_is_lake);
    let land = select(a.height, b.height, first_is_lake);
    let has_shore = first_is_lake || second_is_lake;
    return select(LAKE_BESIDE, LAKE_SHORE, has_shore && !land_is_wet && land >= level);
}

// A river that flows into a lake: the lake reaches as far up its valley as the river's bed lies
// below it.
fn inflow(context: EdgeContext) -> VertexGround {
    let river = context.a;
    let lake = context.b;
    let bed = river.bed + (lake.bed - river.bed) / 2;
    let water = bed + max(river.water - river.bed, 0);
    if water <= lake.water {
        return under(bed, lake.water);
    }
    return VertexGround(RIVER, bed, bed, min(water, river.water));
}

// The ground beside a lake: dry where `ground` that was made with its ends at the lake's level lies
// below it.
fn beside_lake(context: EdgeContext, ground: VertexGround) -> VertexGround {
    let level = context.new_vertex.lake_level;
    let is_dry = ground.kind != SEA && !is_wet(ground.kind);
    if is_dry && ground.height <= level {
        // A hollow under the level becomes a rise over it.
        return vertex_ground_dry(ground.kind, level + 1 + (level - ground.height) / 4);
    }
    return ground;
}

// An edge whose ends stand at the lake's level at least, or at their water.
fn lifted_context(context: EdgeContext) -> EdgeContext {
    var out = context;
    out.a.height = lifted_height(context.a, context.new_vertex.lake_level);
    out.b.height = lifted_height(context.b, context.new_vertex.lake_level);
    out.face = max(context.face, min(out.a.height, out.b.height));
    return out;
}

fn lifted_height(end: Vertex, level: i32) -> i32 {
    let over_water = max(max(end.height, level), end.water);
    return select(over_water, end.height, end.kind == SEA || end.kind == COAST);
}

// Dry ground on a gully's edge is a gully.
fn of_kind(edge: u32, ground: VertexGround) -> VertexGround {
    if edge == GULLY_EDGE && ground.kind == TERRAIN {
        return vertex_ground_dry(GULLY, ground.height);
    }
    return ground;
}

// A lake's floor under its water, grains: a grain below it at least.
fn under(bed: i32, water: i32) -> VertexGround {
    let below = min(bed, water - 1);
    return VertexGround(LAKE, below, below, water);
}

// Ground and water beside a lake: the lake's level goes on under its shore, and no valley is cut
// below it.
fn held(vertex: Vertex, carved: Carved) -> Carved {
    let is_river = carved_is_wet(carved) || vertex_is_wet(vertex);
    if vertex.lake == 0u || is_river || vertex.kind == SEA {
        return carved;
    }
    return Carved(max(carved.ground, vertex.lake_level), vertex.lake_level);
}
