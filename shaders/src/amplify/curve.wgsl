// The course of a river between two of its vertices: the cubic that leaves the one and reaches the
// other along their headings (C. Hermite), so that pieces of a river join without a kink.

// A piece of a river's course.
struct Curve {
    ends: array<vec3<i32>, 2>,
    // From its start to its end.
    chord: vec3<i32>,
    // How far the tangents at both ends differ from the chord.
    bends: array<vec3<i32>, 2>,
}

// The course between two directions less than 15 degrees apart, upstream first. A heading is a
// unit tangent times 32767; zero stands for the way from end to end.
fn curve_new(ends: array<vec3<i32>, 2>, headings: array<vec3<i32>, 2>) -> Curve {
    let chord = difference(ends[1], ends[0]);
    let size = length(chord.x, chord.y, chord.z);
    let bends = array(bend(headings[0], chord, size), bend(headings[1], chord, size));
    return Curve(ends, chord, bends);
}

// The way from its start to the point at a share of it, Q16.
fn curve_at(curve: Curve, share: i32) -> vec3<i32> {
    let rest = Q16 - share;
    let middle = mul_q16(share, rest);
    let first = weigh3(mul_q16(middle, rest), curve.bends[0]);
    let second = weigh3(mul_q16(middle, share), curve.bends[1]);
    return weigh3(share, curve.chord) + first - second;
}

// A quarter of its tangent at a share of it, which fits 32 bits whatever the bends.
fn curve_quarter_tangent(curve: Curve, share: i32) -> vec3<i32> {
    let first = mul_q16(Q16 - share, Q16 - 3 * share);
    let second = mul_q16(share, 2 * Q16 - 3 * share);
    let leaving = weigh3(first, shifted(curve.bends[0], 2u));
    let arriving = weigh3(second, shifted(curve.bends[1], 2u));
    return shifted(curve.chord, 2u) + leaving - arriving;
}

// The vector from its point at a share of it to `p`.
fn curve_off(curve: Curve, share: i32, p: vec3<i32>) -> vec3<i32> {
    // From the end itself, whose distance must not hang on rounding of the way there.
    if share >= Q16 {
        return difference(p, curve.ends[1]);
    }
    return difference(difference(p, curve.ends[0]), curve_at(curve, share));
}

// Where its point nearest to `p` lies.
fn curve_nearest(curve: Curve, p: vec3<i32>) -> NearestPoint {
    let chord = nearest_on(curve.ends, p);
    if all(curve.bends[0] == vec3(0)) && all(curve.bends[1] == vec3(0)) {
        return chord;
    }
    var share = chord.share;
    for (var i = 0u; i < STEPS; i++) {
        let off = shifted(curve_off(curve, share, p), 2u);
        share = saturate(share + damped_projection(curve_quarter_tangent(curve, share), off));
    }
    return NearestPoint(share, curve_off(curve, share, p));
}

// How far the tangent of a heading differs from the chord. A heading far from the chord, which
// would make a loop, has a short tangent.
fn bend(heading: vec3<i32>, chord: vec3<i32>, size: i32) -> vec3<i32> {
    if all(heading == vec3(0)) || size == 0 {
        return vec3(0);
    }
    // The chord's components get 14 bits: three products with 15 fit 32.
    let shift = less(bit_length(u32(size)), 14u);
    let along = product(heading, shifted(chord, shift));
    // 1 up to 60 degrees from the chord, 0 across it.
    let kept = ratio(2 * max(along / UNIT, 0), max(size >> shift, 1));
    let tangent = vec3(
        weigh(mul_q16(2 * heading.x, kept), size),
        weigh(mul_q16(2 * heading.y, kept), size),
        weigh(mul_q16(2 * heading.z, kept), size),
    );
    return tangent - chord;
}

// The heading of a vector: its direction times 32767; zero for the zero vector.
fn heading_of(v: vec3<i32>) -> vec3<i32> {
    // Fifteen bits, of long and of short vectors: their products with the unit fit 32.
    let all = unsigned_abs3(v);
    let bits = bit_length(all.x | all.y | all.z);
    let scaled = (v >> vec3(less(bits, 15u))) << vec3(less(15u, bits));
    let size = max(length(scaled.x, scaled.y, scaled.z), 1);
    return clamp(scaled * UNIT / size, vec3(-UNIT), vec3(UNIT));
}
