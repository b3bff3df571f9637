// Folds: ranges and the longitudinal valleys between them, along the fold axis of an orogeny.

// The level that summits reach at the vertex that halves an edge, grains.
fn summits(rules: Rules, level: u32, made: Vertex, a: Vertex, b: Vertex) -> i32 {
    let is_folded = rules.landforms != 0u && any(made.fold != vec3(0));
    if !is_folded || level >= SUNKEN_LEVELS {
        return made.crust;
    }
    let first = max(a.height, 0);
    let relief = max(made.crust - first - (max(b.height, 0) - first) / 2, 0);
    let axis = fold_axis_of(made);
    let strengths = fold_axis_strengths(axis);
    var stripes = FOLDS;
    if level == 0u {
        stripes = RANGES;
    }
    let wave = fold_axis_wave(axis, stripes, strengths[min(level, 1u)], 0);
    // In a depression crests sink, too.
    let low = max(Q16 - wave.height, (Q16 - fold_axis_culmination(axis)) / 2);
    return made.crust - mul_q16(relief, mul_q16(mul_q16(low, wave.share), SUNKEN[level]));
}

// Random numbers of an edge's rise, and how folds change its bulge; Q16.
struct RiseDraws {
    // How far the bulge, and the middle of a hillside, are drawn up.
    xi: i32,
    // How much of the room a crest takes, and how steep the ground may stand.
    chi: i32,
    // Factor of the bulge.
    bulge: i32,
    // Least share of the room that a crest takes.
    crest: i32,
}

// The draws of a new vertex: its own, and on the coarse levels of folded land those of its fold.
fn rise_draws_of(context: EdgeContext) -> RiseDraws {
    let made = context.new_vertex;
    let xi = share(made.seed, 0u);
    let chi = share(made.seed, 1u);
    if context.level >= FOLD_LEVELS || all(made.fold == vec3(0)) {
        return RiseDraws(xi, chi, Q16, 0);
    }
    let fold = fold_at(context);
    let strength = mul_q16(fold.presence, fold.culmination);
    let swing = mul_q16(mul_q16(2 * fold.height - Q16, strength), FOLDED_BULGE);
    return RiseDraws(
        mix(xi, fold.height, fold.presence),
        mix(chi, fold.height, fold.presence),
        max(Q16 + swing, 0),
        mul_q16(mul_q16(square(fold.height), strength), CREST),
    );
}

// Where in a fold the middle of an edge lies; shares in Q16.
struct Fold {
    // 0 in the syncline, 1 on the anticline.
    height: i32,
    // How far the land is folded.
    presence: i32,
    // 0 in a depression along the axis, 1 in a culmination.
    culmination: i32,
}

fn fold_at(context: EdgeContext) -> Fold {
    let axis = fold_axis_of(context.new_vertex);
    let lean = fold_axis_lean(axis, context);
    let strengths = fold_axis_strengths(axis);
    let weights = FOLD_WEIGHTS[min(context.level, 2u)];
    var height = Q16 / 2;
    var most = 0;
    for (var k = 0u; k < 2u; k++) {
        var stripes = RANGES;
        if k == 1u {
            stripes = FOLDS;
        }
        let wave = fold_axis_wave(axis, stripes, strengths[k], lean);
        height += mul_q16(mul_q16(wave.height - Q16 / 2, wave.share), weights[k]);
        most = max(most, wave.share);
    }
    let culmination = fold_axis_culmination(axis);
    return Fold(saturate(height), mul_q16(most, mix(DEPRESSED, Q16, culmination)), culmination);
}

// A set of stripes at a place; shares in Q16.
struct FoldWave {
    // 0 in the trough, 1 on the crest.
    height: i32,
    // How far it is there.
    share: i32,
}

// The way that folds run at a vertex.
struct FoldAxis {
    direction: vec3<i32>,
    worn: i32,
    hills: i32,
    // Across them; a unit tangent times 32767.
    across: vec3<i32>,
    // How far neighbours' axes agree, Q16.
    agreement: i32,
}

fn fold_axis_of(vertex: Vertex) -> FoldAxis {
    // Scaled, or folds would widen where axes differ.
    let axis = unit_axis(vertex.fold);
    return FoldAxis(
        vertex.direction,
        vertex.worn,
        vertex.hills,
        across(vertex.direction, axis.unit),
        2 * axis.size,
    );
}

// A set of stripes of such a strength, whose crests lean so far towards `across`, Q16.
fn fold_axis_wave(axis: FoldAxis, stripes: StripeNoise, strength: i32, lean: i32) -> FoldWave {
    if strength == 0 {
        return FoldWave(Q16 / 2, 0);
    }
    let phasor = stripe_noise_at(stripes, axis.direction, axis.across);
    // The sine is positive on the flank that `across` points to: the crest moves there.
    let leant = mul_q16(mul_q16(phasor.sine, phasor.cosine), lean);
    let presence = smoothstep(PRESENCE[0], PRESENCE[1], phasor.presence);
    return FoldWave(saturate((phasor.cosine + leant + Q16) / 2), mul_q16(presence, strength));
}

// Shares that age has left of great ranges and of folds, Q16.
fn fold_axis_strengths(axis: FoldAxis) -> vec2<i32> {
    let old = linear_step(BELT_HILLS[0], BELT_HILLS[1], axis.hills);
    return vec2(
        mul_q16(mix(Q16, mul_q16(LEFT_BY_AGE[0], old), axis.worn), axis.agreement),
        mul_q16(mix(Q16, mul_q16(LEFT_BY_AGE[1], old), axis.worn), axis.agreement),
    );
}

// How high ranges stand, from depressions along the axis to culminations; Q16.
fn fold_axis_culmination(axis: FoldAxis) -> i32 {
    let noise = fbm(2u, axis.direction, CULMINATION_CELL, Q16 / 2, CULMINATION_SEED);
    return smoothstep(CULMINATION[0], CULMINATION[1], noise);
}

// How far crests at the middle of an edge lean across the axis, Q16.
fn fold_axis_lean(axis: FoldAxis, context: EdgeContext) -> i32 {
    let way = difference(context.b.direction, context.a.direction);
    let unit = max(length(way.x, way.y, way.z) >> 15u, 1);
    let parts = clamp(way / unit, vec3(-0x8000), vec3(0x8000)) * axis.across / 0x8000;
    let cosine = 2 * (parts.x + parts.y + parts.z);
    let fall = (context.a.crust - context.b.crust) / 2;
    let full = max(mul_q16(context.length / 2, FRONTAL_SLOPE), 1);
    let share_of_fall = ratio(abs(fall), full) * sign(fall);
    return mul_q16(mul_q16(share_of_fall, clamp(cosine, -Q16, Q16)), VERGENCE);
}
