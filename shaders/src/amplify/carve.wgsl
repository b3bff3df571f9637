// Pass: every vertex gets its final ground and water from its river's valley.

// Final ground and water of a vertex.
fn carve(scale: PlanetScale, rules: Rules, vertex: Vertex) -> Carved {
    return held(vertex, valley_carve(scale, rules, vertex));
}

// Pass: the vertices that a level has made.
@compute @workgroup_size(GROUP)
fn carve_all(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= level_size().made.mids {
        return;
    }
    carve_at(level_size().first_vertex + id.x);
}

// Pass: the vertices of the control mesh.
@compute @workgroup_size(GROUP)
fn carve_base(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x < level_size().first_vertex {
        carve_at(id.x);
    }
}

fn carve_at(at: u32) {
    let vertex = vertex_of_rows(
        vertex_cores[at],
        vertex_courses[at],
        vertex_lands[at],
        vertex_rivers[at],
    );
    out_carved[at] = carve(level_uniform.sight.scale, level_uniform.rules, vertex);
}
