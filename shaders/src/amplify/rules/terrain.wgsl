// Open ground: mountains, peaks, terraces, hills and plateaus.

// The ground in the middle of an edge of the ground.
fn terrain_halve(rules: Rules, context: EdgeContext) -> VertexGround {
    return vertex_ground_dry(TERRAIN, terrain_height(rules, context));
}

// Height in the middle of an edge of the ground, grains.
fn terrain_height(rules: Rules, context: EdgeContext) -> i32 {
    let made = context.new_vertex;
    let form = landform_of(rules, made);
    let ours = rules.landforms != 0u;
    let fading = peak_fading(made.crust, context.level);
    let ends = ordered(context.a.height, context.b.height);
    var lowest = lowest_terrace(form);
    var onset = OUR_TERRACE_ONSET;
    var bare = 0;
    if ours {
        bare = divide(rules, context);
    } else {
        lowest -= mul_q16(polar(made), POLAR_TERRACES);
        onset = TERRACE_ONSET;
        bare = mountain(rules, context, form);
    }
    let stepped = terraced(rules, context, form, vec2(lowest, lowest + onset), bare);
    if ours {
        return shaped(rules, context, form, stepped, fading);
    }
    let raised = peaks(made, form, ends.x, stepped, fading);
    let hilly = max(raised + terrain_hills(rules, context, form, fading), LEAST_HILLY);
    // A plateau has no peaks and no hills.
    return plateau(hilly, stepped, made.plateau);
}

// Ours: over terraces hills no steeper than a few degrees, and plateaus. It stays above its lower
// end, so that it drains there, and under the crust.
fn shaped(rules: Rules, context: EdgeContext, form: Landform, stepped: i32, fading: i32) -> i32 {
    let made = context.new_vertex;
    let ends = ordered(context.a.height, context.b.height);
    // Hills must not overturn the slope they stand on, or vertices would lose their way down.
    var hilly = stepped;
    if !context.is_descent {
        let steep = max(form.steep, LEAST_HILL_SLOPE);
        let limit = mul_q16(context.length, steep) / OUR_HILL_LIMIT;
        hilly += clamp(terrain_hills(rules, context, form, fading), 0, limit);
    }
    let held = plateau(hilly, ends.x + (ends.y - ends.x) / 2, made.plateau);
    return max(min(held, max(ends.y, made.crust)), ends.x + 1);
}

// Classic mountains: young and old, wet and dry.
fn mountain(rules: Rules, context: EdgeContext, form: Landform) -> i32 {
    let delta = scale_dependency(context.level);
    let xi = share(context.new_vertex.seed, 0u);
    let fresh = young(rules.form, delta, xi);
    let worn = mix(old_wet(delta, xi), old_dry(delta, xi), form.dry);
    // Age shows less on fine levels.
    let aged = mul_q16(form.old, Q16 - level_share(context.level));
    return nodes_between(context.a.height, context.b.height, saturate(mix(fresh, worn, aged)));
}

// level / 10, at most 1; Q16.
fn level_share(level: u32) -> i32 {
    return i32(min(level, 10u)) * Q16 / 10;
}

// Steps of 700 m on dry old rock, which set in over the heights of `onset`.
fn terraced(
    rules: Rules,
    context: EdgeContext,
    form: Landform,
    onset: vec2<i32>,
    height: i32,
) -> i32 {
    if form.dry == 0 || form.old == 0 {
        return height;
    }
    let weight = mul_q16(
        mul_q16(form.old, Q16 - square(level_share(context.level))),
        mul_q16(sqrt_q16(form.dry), linear_step(onset.x, onset.y, height)),
    );
    // Treads with smooth risers; at low heights a draw takes vertices back towards their tread,
    // which makes ragged edges.
    let stepped = terrace(height, TERRACE_STEP);
    let tread = floor_to(height, TERRACE_STEP);
    let at = select(stepped, height, rules.landforms != 0u);
    let low = Q16 - smoothstep(RAGGED_HEIGHTS[0], RAGGED_HEIGHTS[1], at);
    // Nine tenths of the way at most: some of the riser stays.
    let ragged = mul_q16(share(context.new_vertex.seed, 1u), low) / 10 * 9;
    return mix(height, mix(stepped, tread, ragged), weight);
}

// Height at which terraces begin: lower in deserts and in youth; grains.
fn lowest_terrace(form: Landform) -> i32 {
    return LOWEST_TERRACE - mul_q16(form.dry, DESERT_TERRACES - mul_q16(form.old, OLD_TERRACES));
}

// The squared sine of a vertex's latitude, Q16.
fn polar(vertex: Vertex) -> i32 {
    return square(ratio(saturating_abs(vertex.direction.z), ONE));
}

// How far peaks and hills have faded at a level, 0..1 Q16: later under low crust.
fn peak_fading(crust: i32, level: u32) -> i32 {
    let low = Q16 - linear_step(0, FULL_CRUST, crust);
    // Over six levels under crust of 5 km, over nine under the lowest.
    let span = 6 * Q16 + 3 * low;
    return arith_smooth(smoothstep(0, span, i32(level) * Q16));
}

// Peaks pull the ground of coarse levels towards their own height under the crust elevation.
fn peaks(made: Vertex, form: Landform, low: i32, height: i32, fading: i32) -> i32 {
    let xi = share(made.seed, 2u);
    let worn = mix(peak_old_wet(xi, made.crust), peak_old_dry(xi, made.crust), form.dry);
    let peak = mix(peak_young(xi, made.crust), worn, form.old) + PEAK_BASE;
    let rise = PEAK_RISE[0] + mul_q16(linear_step(0, FULL_CRUST, made.crust), PEAK_RISE[1]);
    let foot = low + mul_q16(mul_q16(rise, share(made.seed, 5u)), Q16 - fading);
    return max(mix(peak, height, fading), foot);
}

// Hills, away from rivers and deserts; an offset in grains.
fn terrain_hills(rules: Rules, context: EdgeContext, form: Landform, fading: i32) -> i32 {
    let made = context.new_vertex;
    let ours = rules.landforms != 0u;
    let is_bare = select(form.dry >= DRIEST_HILLS, form.dry > OUR_DRIEST_HILLS, ours);
    if made.hills == 0 || is_bare {
        return 0;
    }
    var away = Q16;
    if made.river_distance < FAR {
        away = smoothstep(0, HILLS_AWAY, made.river_distance);
    }
    let offset = hill(
        rules.form,
        share(made.seed, 3u),
        share(made.seed, 4u),
        context.length,
        made.hills,
    );
    return mul_q16(mul_q16(offset, Q16 - fading), away);
}
