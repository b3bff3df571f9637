// The rules that give a new vertex its ground.

// The ground of the vertex that halves an edge: picks the rule by the configuration (kind, edge,
// kind).
fn rules_halve(rules: Rules, edge: u32, context: EdgeContext) -> VertexGround {
    var seen = context;
    var is_beside = false;
    if rules.landforms != 0u && context.new_vertex.lake != 0u {
        let lake_edge = lake_edge_of(edge, context);
        if lake_edge == LAKE_FLOOR {
            return of_kind(edge, lake_floor(rules, edge, context));
        }
        if lake_edge == LAKE_INFLOW {
            return inflow(context);
        }
        if lake_edge == LAKE_SHORE {
            return of_kind(edge, lake_shore(rules, context));
        }
        is_beside = lake_edge == LAKE_BESIDE;
        if is_beside {
            seen = lifted_context(context);
        }
    }
    let ground = graph(rules, edge, is_beside, seen);
    if is_beside {
        return beside_lake(context, ground);
    }
    return ground;
}

// The same where no lake is near, and beside one, at whose level the ends stand.
fn graph(rules: Rules, edge: u32, is_beside: bool, context: EdgeContext) -> VertexGround {
    let a = context.a.kind;
    let b = context.b.kind;
    let ours = rules.landforms != 0u;
    // Between two waters, or over a valley that lies lower than the lake.
    if is_beside && (a == LAKE || b == LAKE) {
        return of_kind(edge, between_rivers(rules, context));
    }
    if edge == RIVER_EDGE {
        return river_halve(rules, context);
    }
    // Into the sea a gully of ours runs no farther than the shore.
    if edge == GULLY_EDGE && !(ours && is_shore(a, b)) {
        return gully_along(rules, context);
    }
    if a == SEA || b == SEA || (a == COAST && b == COAST) || (ours && is_shore(a, b)) {
        return coast_halve(rules, context);
    }
    if a == LAKE && b == LAKE {
        return lake_between(rules, context);
    }
    if is_wet(a) && is_wet(b) {
        return between_rivers(rules, context);
    }
    if is_wet(a) || is_wet(b) {
        let lake = new_widened(rules, context);
        if lake.kind == LAKE {
            return lake;
        }
        return from_river(rules, context);
    }
    if context.level >= rules.fine_level {
        return fine_halve(rules, context);
    }
    if a == GULLY && b == GULLY {
        return between_gullies(rules, context);
    }
    if a == GULLY || b == GULLY {
        return from_gully(rules, context);
    }
    return terrain_halve(rules, context);
}
