// The place of a new river vertex: on the curve between its ends, and, while edges are longer than a
// few bends of the river, moved aside from it.

// The course of a river along an edge.
struct Course {
    // Whether a river runs from end to end.
    is_known: bool,
    // The axis of its valley.
    curve: Curve,
    // Whether finer levels keep it.
    is_kept: bool,
}

// Where the vertex that halves a river edge lies half-way along its course.
fn on_course(
    course: Course,
    seed: u32,
    a: Vertex,
    b: Vertex,
    opposite: array<MaybeVertex, 2>,
) -> Shares {
    if !opposite[0].is_known || !opposite[1].is_known {
        return Shares();
    }
    let ab = difference(b.direction, a.direction);
    let ax = difference(opposite[0].vertex.direction, a.direction);
    let ay = difference(opposite[1].vertex.direction, a.direction);
    let off = off_middle(course.curve, ab);
    let corners = array(stance_of(ab, ax), stance_of(ab, ay));
    // Shares of the ways up to both corners, on whichever side the course bends.
    let up = share_along(upright(ab, ax, corners[0]), off.off);
    let down = share_along(upright(ab, ay, corners[1]), off.off);
    let sway = select(mul_q16(centred_share(seed, 12u), SWAY), 0, course.is_kept);
    let aside = max(up, 0) - max(down, 0) + sway;
    let is_second = aside < 0;
    let stances = turned(corners, is_second);
    let weight = unless_flat(stances);
    // A sixth at most: the bounds allow no more.
    let wx = weigh(weight, min(abs(aside), Q16 / 6));
    let towards_b = weigh(weight, off.share) - weigh(stances[0].along << 4u, wx);
    let weights = within_bounds(towards_b, wx, stances);
    return Shares(true, weights.x, weights.y, is_second);
}

// Where the middle of the course lies: share of the edge from its middle, and the vector across the
// edge.
fn off_middle(curve: Curve, ab: vec3<i32>) -> NearestPoint {
    let off = curve_at(curve, Q16 / 2) - ab / 2;
    let along = share_along(ab, off);
    return NearestPoint(along, off - weigh3(along, ab));
}

// The vector from the line of an edge up to a corner.
fn upright(ab: vec3<i32>, corner: vec3<i32>, stance: Stance) -> vec3<i32> {
    let along = clamp(stance.along << 4u, 1 - 2 * Q16, 2 * Q16 - 1);
    return corner - weigh3(along, ab);
}
