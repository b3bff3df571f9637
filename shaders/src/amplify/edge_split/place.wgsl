// The place of a new vertex: the middle of its edge, moved sideways.

// Where a vertex lies on a face beside its edge: shares of two of the face's corners, Q16. That of
// the edge's first end is the rest.
struct Shares {
    // Whether it lies there, and not in the middle.
    is_known: bool,
    // Of the edge's second end.
    end: i32,
    // Of the corner opposite to the edge.
    corner: i32,
    // Whether the face is the edge's second one.
    is_second: bool,
}

// A place, and the height of the flat face there.
struct Placed {
    // Unit direction times ONE.
    direction: vec3<i32>,
    // Height of the flat face, grains.
    face: i32,
    // Relief of the sea floor there, grains.
    swell: i32,
}

// Where the vertex that halves an edge lies, moved sideways within its safe zone.
fn shares(
    rules: Rules,
    edge: u32,
    level: u32,
    made: Vertex,
    a: Vertex,
    b: Vertex,
    opposite: array<MaybeVertex, 2>,
) -> Shares {
    let is_open = !(opposite[0].is_known && opposite[1].is_known);
    if is_open || level >= STRAIGHT_LEVEL {
        return Shares();
    }
    let moved = shift(rules, edge, vec2(a.kind, b.kind), level, made.seed, made.wetness);
    // Rivers keep the course that their rule draws.
    let is_centred = rules.landforms != 0u && edge != RIVER_EDGE;
    if moved.weight <= 0 && !is_centred {
        return Shares();
    }
    let ab = difference(b.direction, a.direction);
    let x = stance_of(ab, difference(opposite[0].vertex.direction, a.direction));
    let y = stance_of(ab, difference(opposite[1].vertex.direction, a.direction));
    return displaced(moved, is_centred, array(x, y));
}

// Places the vertex that halves an edge: on a face beside it, or in its middle.
fn place(
    seed: u32,
    shares: Shares,
    a: Vertex,
    b: Vertex,
    opposite: array<MaybeVertex, 2>,
) -> Placed {
    let ab = difference(b.direction, a.direction);
    if !shares.is_known {
        return middle(seed, a, b, ab);
    }
    if shares.is_second {
        return at_shares(a, b, opposite[1].vertex, shares);
    }
    return at_shares(a, b, opposite[0].vertex, shares);
}

// The middle of an edge. Halves round to either side by the seed, so that no direction is favoured.
fn middle(seed: u32, a: Vertex, b: Vertex, ab: vec3<i32>) -> Placed {
    let odd = i32((seed >> 7u) & 1u);
    let swell = swells(a, b, b);
    // Both shares are a half, so the deficit is a quarter of the edge's square.
    return Placed(
        lift(a.direction + ((ab + odd) >> vec3(1u)), square_q32(ab) / 4u),
        a.height + (b.height - a.height) / 2,
        swell.x + (swell.y - swell.x) / 2,
    );
}

// A place moved sideways; `corners` are the stances of those opposite to the edge.
fn displaced(moved: Shift, is_centred: bool, corners: array<Stance, 2>) -> Shares {
    // Towards the first of these, away from the second.
    let stances = turned(corners, moved.second);
    var pull = drawn_pull(moved, stances);
    if is_centred {
        pull = centred_pull(pull, stances);
    }
    let weights = within_bounds(
        pull.towards_b,
        pull.to_corner,
        turned(stances, pull.is_turned),
    );
    return Shares(true, weights.x, weights.y, moved.second != pull.is_turned);
}

// The stances of both corners, in the other order where they are turned.
fn turned(stances: array<Stance, 2>, is_turned: bool) -> array<Stance, 2> {
    if is_turned {
        return array(stances[1], stances[0]);
    }
    return stances;
}

// The place whose shares of the edge's end and of a corner are given.
fn at_shares(a: Vertex, b: Vertex, x: Vertex, shares: Shares) -> Placed {
    let ab = difference(b.direction, a.direction);
    let ax = difference(x.direction, a.direction);
    let swell = swells(a, b, x);
    return Placed(
        blend(a.direction, ab, ax, shares.end, shares.corner),
        on_face(vec3(a.height, b.height, x.height), shares),
        on_face(swell, shares),
    );
}

// A number at shares of a face, of the numbers at its corners.
fn on_face(corners: vec3<i32>, shares: Shares) -> i32 {
    let to_end = weigh(shares.end, corners.y - corners.x);
    return corners.x + to_end + weigh(shares.corner, corners.z - corners.x);
}

// How far a new vertex is drawn from the middle of its edge; shares in Q16.
struct Pull {
    // Whether the corner is the second of the two beside the edge.
    is_turned: bool,
    // Towards the edge's second end.
    towards_b: i32,
    // Towards the corner, at least 0.
    to_corner: i32,
}

// The drawn displacement, towards the first corner.
fn drawn_pull(moved: Shift, stances: array<Stance, 2>) -> Pull {
    let weight = weigh(moved.weight, unless_flat(stances));
    let third = moved.inward / 3;
    // The barycentre lies a third of the way to the corner.
    let to_corner = weigh(weight, third);
    let along = weigh(Q16 - moved.inward, moved.along) + third;
    // A corner that leans over an end of the edge draws upwards only, not along.
    let overhang = q12(to_corner, stance_overhang(stances[0]));
    return Pull(false, weigh(weight, along - Q16 / 2) - overhang, to_corner);
}

// A displacement with that to Loop's place added: an eighth of the sum of the corners' offsets from
// the middle.
fn centred_pull(drawn: Pull, stances: array<Stance, 2>) -> Pull {
    let x = stances[0];
    let y = stances[1];
    let eighth = linear_step(CENTRED[0], CENTRED[1], min(x.height, y.height)) / 8;
    // Lengths of the edge, Q16: along it, and over it towards x.
    let along = drawn.towards_b + q12(drawn.to_corner, x.along)
        + q12(eighth, x.along + y.along - Q12);
    let up = q12(drawn.to_corner, x.height) + q12(eighth, x.height - y.height);
    let is_turned = up < 0;
    let corner_height = select(x.height, y.height, is_turned);
    let to_corner = (abs(up) << 12u) / corner_height;
    let corner_along = select(x.along, y.along, is_turned);
    return Pull(is_turned, along - q12(to_corner, corner_along), to_corner);
}

// Share of a displacement that the triangles beside an edge bear, Q16: flat ones would get flatter.
fn unless_flat(stances: array<Stance, 2>) -> i32 {
    let lower = min(stances[0].height, stances[1].height);
    return linear_step(FLATNESS[0], FLATNESS[1], lower);
}

// The shares of a displacement by `towards_b` along the edge and by `wx` towards the first corner,
// scaled until all bounds hold.
fn within_bounds(towards_b: i32, wx: i32, stances: array<Stance, 2>) -> vec2<i32> {
    let x = stances[0];
    let y = stances[1];
    // In the face beyond, the vertex has less of its corner than nothing.
    let owed = wx * (x.height >> 3u) / max(y.height >> 3u, 1);
    let in_beyond = towards_b + q12(wx, x.along) + q12(owed, y.along);
    let loss = max(end_loss(towards_b, wx), end_loss(in_beyond, -owed));
    // The whole displacement is scaled until all bounds hold in both faces.
    let far = min(ratio(MOST_FAR_CORNER, wx), ratio(MOST_FAR_CORNER, owed));
    let kept = min(ratio(MOST_END_LOSS, loss), far);
    return vec2(Q16 / 2 + weigh(kept, towards_b), weigh(kept, wx));
}

// How much of its halves the nearer end of an edge loses to a vertex that is drawn `towards_b`, and
// by `far` to the far corner.
fn end_loss(towards_b: i32, far: i32) -> i32 {
    return max(-towards_b, towards_b + far);
}

// A share times a number in Q12 of at most 7.
fn q12(part: i32, number: i32) -> i32 {
    return (part * (number >> 4u)) >> 8u;
}

// The point a + w_b ab + w_x ax, lifted to the sphere by its exact deficit, the sum of w_i w_j
// |p_i - p_j|^2.
fn blend(a: vec3<i32>, ab: vec3<i32>, ax: vec3<i32>, wb: i32, wx: i32) -> vec3<i32> {
    // Barycentric coordinates; those of the ends and the corner sum to 1.
    let wa = Q16 - wb - wx;
    let point = a + weigh3(wb, ab) + weigh3(wx, ax);
    // Shares below 1 in Q16, their products in Q32.
    let deficit = mul_high(u32(wa) * u32(wb), square_q32(ab))
        + mul_high(u32(wa) * u32(wx), square_q32(ax))
        + mul_high(u32(wb) * u32(wx), square_q32(difference(ax, ab)));
    return lift(point, deficit);
}
