// Pass: every vertex gets the ground that a level shows of it.

// Ground and water that a level shows of a vertex, in Q16.
fn show(scale: PlanetScale, rules: Rules, vertex: Vertex, carved: Carved, level: i32) -> Carved {
    let edge = planet_scale_edge_grains(scale, 0u);
    let lifted = carved.ground + coarse_lift(rules, vertex, carved.ground, edge, level);
    return Carved(lifted, carved.water);
}

// Pass: what a view shows of the vertices that a level has made.
@compute @workgroup_size(GROUP)
fn show_all(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= level_size().made.mids {
        return;
    }
    show_at(level_size().first_vertex + id.x);
}

// Pass: what it shows of the vertices of the control mesh.
@compute @workgroup_size(GROUP)
fn show_base(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x < level_size().first_vertex {
        show_at(id.x);
    }
}

fn show_at(at: u32) {
    let core = vertex_cores[at];
    let vertex = vertex_of_rows(core, vertex_courses[at], vertex_lands[at], vertex_rivers[at]);
    let sight = level_uniform.sight;
    let level = view_shown_level(sight, Corner(core.direction, core.height));
    out_shown[at] = show(sight.scale, level_uniform.rules, vertex, carved[at], level);
}
