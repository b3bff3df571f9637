// Lakes around a new vertex, and their one level.

// A lake: its number, 0 for none, and its level.
struct KnownLake {
    number: u32,
    level: i32,
}

// The lake around the vertex that halves an edge. Of several the highest: ground that holds it back
// holds back the others.
fn lake_around(level: u32, a: Vertex, b: Vertex, opposite: array<MaybeVertex, 2>) -> KnownLake {
    var found = KnownLake(0u, -0x7fffffff);
    // Of those of one level the last.
    found = higher_lake(found, a, true);
    found = higher_lake(found, b, true);
    found = higher_lake(found, opposite[0].vertex, opposite[0].is_known);
    found = higher_lake(found, opposite[1].vertex, opposite[1].is_known);
    if found.number != 0u {
        return found;
    }
    return known_lake(level, a, b);
}

fn higher_lake(found: KnownLake, corner: Vertex, is_known: bool) -> KnownLake {
    if is_known && corner.kind == LAKE && corner.lake_level >= found.level {
        return KnownLake(corner.lake, corner.lake_level);
    }
    return found;
}

// The lake that the ends of an edge lie beside.
fn known_lake(level: u32, a: Vertex, b: Vertex) -> KnownLake {
    let first = KnownLake(a.lake, a.lake_level);
    let second = KnownLake(b.lake, b.lake_level);
    if a.lake != 0u && b.lake != 0u {
        // Both hold back the lower of two lakes.
        if a.lake_level <= b.lake_level {
            return first;
        }
        return second;
    }
    if a.lake != 0u && goes_on(level, a, b) {
        return first;
    }
    if b.lake != 0u && goes_on(level, b, a) {
        return second;
    }
    return KnownLake(0u, 0);
}

// Whether a lake that one end of an edge knows may reach the other, too.
fn goes_on(level: u32, end: Vertex, other: Vertex) -> bool {
    return level >= STRAIGHT_LEVEL && vertex_surface(other) >= end.lake_level;
}

// Whether the corners beyond an edge hold back water at the level of its wet ends.
fn is_dammed(a: Vertex, b: Vertex, opposite: array<MaybeVertex, 2>) -> bool {
    let none = -0x7fffffff - 1;
    let first = select(none, a.water, vertex_is_wet(a));
    let second = select(none, b.water, vertex_is_wet(b));
    let level = max(first, second);
    let x = opposite[0];
    let y = opposite[1];
    let first_holds = x.is_known && vertex_surface(x.vertex) >= level;
    return first_holds && y.is_known && vertex_surface(y.vertex) >= level;
}

// Settles the lake and the discharge of a new vertex, and keeps water from rising downstream.
fn lakes_settle(rules: Rules, edge: u32, made: Vertex, a: Vertex, b: Vertex) -> Vertex {
    var out = made;
    if rules.landforms == 0u {
        out = keep_level(out, a, b);
    }
    if out.kind == LAKE {
        return fill(edge, out, a, b);
    }
    if out.kind == RIVER {
        // Water never lies below that of the lower end.
        out.water = max(max(out.water, out.bed), b.water);
    } else {
        out.discharge = 0u;
    }
    return out;
}

// A new vertex of a lake with its number, level and discharge.
fn fill(edge: u32, made: Vertex, a: Vertex, b: Vertex) -> Vertex {
    var out = made;
    if out.lake == 0u {
        // All lakes that widen one river vertex are one.
        out.lake = pcg(select(b.seed, a.seed, vertex_is_wet(a))) | 1u;
    }
    out.lake_level = out.water;
    if edge != RIVER_EDGE {
        // What flows through a lake leaves it by its river.
        out.discharge = min(a.discharge, b.discharge);
    }
    return out;
}

// Print and release: keeps lakes level, whatever the graph says, and their water off the land.
fn keep_level(made: Vertex, a: Vertex, b: Vertex) -> Vertex {
    var out = made;
    if is_one_lake(a, b) {
        // Between two vertices of one lake its surface goes on, whatever was drawn.
        out.kind = LAKE;
        out.height = a.bed + (b.bed - a.bed) / 2;
        out.bed = out.height;
        out.water = a.water;
    } else if out.kind == TERRAIN {
        if a.kind == LAKE {
            out.height = max(out.height, a.water + 1);
        }
        if b.kind == LAKE {
            out.height = max(out.height, b.water + 1);
        }
        out.bed = out.height;
        out.water = out.height;
    }
    return out;
}

// Whether two vertices lie in the same lake, or in a lake and in a river that has its level.
fn is_one_lake(a: Vertex, b: Vertex) -> bool {
    let has_lake = a.kind == LAKE || b.kind == LAKE;
    return has_lake && vertex_is_wet(a) && vertex_is_wet(b) && a.water == b.water;
}
