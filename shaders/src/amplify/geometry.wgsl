// Plane geometry of small differences of directions, in 32 bits.

// Bits to shift right so that every component of both vectors is below 2^14.
fn common_shift(u: vec3<i32>, v: vec3<i32>) -> u32 {
    let all = unsigned_abs3(u) | unsigned_abs3(v);
    // The bits of all components together have the length of the longest.
    return less(bit_length(all.x | all.y | all.z), 14u);
}

fn shifted(v: vec3<i32>, shift: u32) -> vec3<i32> {
    return v >> vec3(shift);
}

fn product(u: vec3<i32>, v: vec3<i32>) -> i32 {
    return u.x * v.x + u.y * v.y + u.z * v.z;
}

// Dot product in a scale of its own: the sign is that of the exact one, but for angles within
// 2^-13 of a right one.
fn dot(u: vec3<i32>, v: vec3<i32>) -> i32 {
    let shift = common_shift(u, v);
    return product(shifted(u, shift), shifted(v, shift));
}

// Dot product of a vector and a unit vector in Q16.
fn dot_q16(v: vec3<i32>, unit: vec3<i32>) -> i32 {
    return mul_q16(v.x, unit.x) + mul_q16(v.y, unit.y) + mul_q16(v.z, unit.z);
}

// Of three vectors of 13 bits; with a normal of 14 its product with it fits 32.
fn area(u: vec3<i32>, v: vec3<i32>, normal: vec3<i32>) -> i32 {
    return product(shifted(cross(u, v), 14u), normal);
}

// The lesser triangle's area of a small quadrilateral cut along its diagonal 0-2, and along 1-3,
// as seen from outside and in one scale; below 0 where a triangle turns over.
fn least_areas(corners: array<vec3<i32>, 4>) -> vec2<i32> {
    let a = corners[0];
    let sides = array(difference(corners[1], a), difference(corners[2], a), difference(corners[3], a));
    // Sides of 13 bits, their differences of 14, so that no sum of products leaves 32.
    let shift = max(common_shift(sides[0], sides[1]), common_shift(sides[2], sides[2])) + 1u;
    let b = shifted(sides[0], shift);
    let c = shifted(sides[1], shift);
    let d = shifted(sides[2], shift);
    let normal = shifted(a, 17u);
    let beyond = area(difference(c, b), difference(d, b), normal);
    return vec2(min(area(b, c, normal), area(c, d, normal)), min(area(b, d, normal), beyond));
}

fn cross(u: vec3<i32>, v: vec3<i32>) -> vec3<i32> {
    return u.yzx * v.zxy - u.zxy * v.yzx;
}

// Whether a small vector points to the left of another, seen from outside at a direction.
fn is_left(up: vec3<i32>, along: vec3<i32>, v: vec3<i32>) -> bool {
    let shift = common_shift(along, v);
    let turn = shifted(cross(shifted(along, shift), shifted(v, shift)), 14u);
    return product(turn, shifted(up, 17u)) > 0;
}

// Where a point lies beside a line: the share of the way in Q16 at the point nearest to it, and
// the vector from there to it.
struct NearestPoint {
    share: i32,
    off: vec3<i32>,
}

// Where the point of a segment nearest to `p` lies.
fn nearest_on(ends: array<vec3<i32>, 2>, p: vec3<i32>) -> NearestPoint {
    // Projected on the line of the segment, then held between its ends.
    let along = difference(ends[1], ends[0]);
    let to = difference(p, ends[0]);
    let shift = common_shift(along, to);
    let u = shifted(along, shift);
    let whole = product(u, u);
    let part = product(u, shifted(to, shift));
    // A segment too short for this scale counts as its nearer end.
    var t = 0;
    if part > 0 && whole != 0 {
        t = ratio(part, whole);
    }
    // From the end itself, whose distance must not hang on rounding of the way there.
    if t >= Q16 {
        return NearestPoint(t, difference(p, ends[1]));
    }
    return NearestPoint(t, to - weigh3(t, along));
}

// The share of `along` on which the foot of `v` lies, Q16, -1..1.
fn share_along(along: vec3<i32>, v: vec3<i32>) -> i32 {
    let shift = common_shift(along, v);
    let u = shifted(along, shift);
    return signed_ratio(product(u, shifted(v, shift)), product(u, u));
}

// The share of `along` on which the foot of `v` lies, Q16, -1..1. The share is the smaller the
// farther `v` reaches: as a step towards the nearest point of a curve it then never overshoots.
fn damped_projection(along: vec3<i32>, v: vec3<i32>) -> i32 {
    let shift = common_shift(along, v);
    let u = shifted(along, shift);
    let w = shifted(v, shift);
    // Each of them is below 3 * 2^28.
    let across = length(w.x, w.y, w.z) * length(u.x, u.y, u.z);
    return signed_ratio(product(u, w), product(u, u) + across / 2);
}

// How a corner of a triangle stands over the opposite edge, in lengths of the edge, Q12, each at
// most 7.
struct Stance {
    // Where it projects: 0 at the edge's start, 1 at its end.
    along: i32,
    // Its height over the edge's line, at least 1/64.
    height: i32,
}

// The stance of a corner, both vectors from the edge's start.
fn stance_of(edge: vec3<i32>, corner: vec3<i32>) -> Stance {
    let shift = common_shift(edge, corner);
    let u = shifted(edge, shift);
    let v = shifted(corner, shift);
    // Shares of the squared edge in Q12; an edge without length must not divide by 0.
    let unit = max(product(u, u) >> 12u, 1);
    // Twice the area: the height times the edge.
    let area = cross(u, v);
    // Up to here the products of the displacement fit 32 bits.
    let most = 7 * Q12;
    let along = clamp(product(u, v) / unit, -most, most);
    return Stance(along, clamp(length(area.x, area.y, area.z) / unit, Q12 / 64, most));
}

// How far beyond the edge it projects: negative before the start, positive beyond the end, 0 over
// it; Q12.
fn stance_overhang(stance: Stance) -> i32 {
    return min(stance.along, 0) + max(stance.along - Q12, 0);
}
