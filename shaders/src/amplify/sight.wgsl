// How far ground counts as lying from a view. What a camera does not see counts as farther than it
// is, and so is refined less.

// A view of a planet with everything that its faces have in common.
struct Sight {
    scale: PlanetScale,
    view: View,
    // Length of a chord seen from the camera's altitude, Q10.
    stretch: u32,
    // Cosine between the view's direction and straight up, Q16.
    upward: i32,
    // Most that the factor beside the field of view exceeds 1 by, Q8.
    excess: u32,
    // Growth of the distance beyond the horizon, Q8; at least 1.
    slope: u32,
}

// What a face's distance depends on in each of its corners.
struct Corner {
    direction: vec3<i32>,
    height: i32,
}

// Distance from the camera or the disc to a face's centre, sixteenths of a metre.
fn sight_distance(sight: Sight, corners: array<Corner, 3>) -> i32 {
    let middle = centre(corners);
    return sight_outside(sight, middle, sight_straight(sight, middle, sight_above(sight, corners)));
}

// The same as the face counts: farther where a camera does not see it.
fn sight_weighted(sight: Sight, corners: array<Corner, 3>) -> i32 {
    let middle = centre(corners);
    let above = sight_above(sight, corners);
    let straight = sight_straight(sight, middle, above);
    let distance = sight_outside(sight, middle, straight);
    if sight.view.radius > 0 {
        return distance;
    }
    let beyond = sight_beyond_horizon(sight, distance);
    if sight.excess == 0u || all(sight.view.forward == vec3(0)) {
        return beyond;
    }
    let q = sight_factor(sight, sight_ahead(sight, middle, above), straight);
    return max(beyond, mul_shift(u32(distance), q, 8u));
}

// Whether a face of a level is split.
fn sight_splits(sight: Sight, level: u32, corners: array<Corner, 3>) -> bool {
    // The bound of a level beyond the finest is never asked for.
    if level >= sight.view.level {
        return false;
    }
    return sight_weighted(sight, corners) < view_bound(sight.view, sight.scale, level);
}

// Height of the camera above the middle of a face, sixteenths of a metre; 0 for a disc.
fn sight_above(sight: Sight, corners: array<Corner, 3>) -> i32 {
    if sight.view.has_altitude == 0u {
        return 0;
    }
    let heights = corners[0].height / GRAINS_IN_SIXTEENTH
        + corners[1].height / GRAINS_IN_SIXTEENTH
        + corners[2].height / GRAINS_IN_SIXTEENTH;
    return clamp(sight.view.altitude, -MOST_ABOVE / 2, MOST_ABOVE) - heights / 3;
}

// Distance from the view's centre to a direction, `above` of which lies straight down.
fn sight_straight(sight: Sight, middle: vec3<i32>, above: i32) -> i32 {
    // |p - q|^2 = (a - b)^2 + 4ab sin^2(phi / 2) for points at a and b from the planet's centre.
    let chord = u32(planet_scale_chord(sight.scale, middle, sight.view.direction));
    let ground = min(mul_shift(chord, sight.stretch, 10u), MOST_ABOVE);
    return length(ground, clamp(above, -MOST_ABOVE, MOST_ABOVE), 0);
}

// Distance outside the disc or the square; of a camera, all of it.
fn sight_outside(sight: Sight, middle: vec3<i32>, straight: i32) -> i32 {
    let outside = max(saturating_sub(straight, sight.view.radius), 0);
    // A square lies in its disc; the greater distance outside of the two counts.
    return max(outside, view_beside(sight.view, sight.scale, middle));
}

// How far ahead of the camera a direction lies, `above` of which is straight down; sixteenths of a
// metre.
fn sight_ahead(sight: Sight, middle: vec3<i32>, above: i32) -> i32 {
    // Quarters of units, so that opposite sides of the planet keep 32 bits.
    let offset = difference(middle >> vec3(2u), sight.view.direction >> vec3(2u));
    let along = dot_q16(offset, sight.view.forward);
    let size = planet_scale_sixteenths(sight.scale, unsigned_abs(along));
    let level = select(size, -size, along < 0);
    return saturating_sub(level, mul_q16(clamp(above, -MOST_ABOVE, MOST_ABOVE), sight.upward));
}

// The factor of ground so far ahead at a distance, Q8.
fn sight_factor(sight: Sight, ahead: i32, distance: i32) -> u32 {
    let share = ratio(saturating_abs(ahead), distance);
    let cosine = select(share, -share, ahead < 0);
    let rise = arith_smooth(linear_step(0, BAND, sight.view.field - cosine));
    return (1u << 8u) + ((sight.excess * u32(rise)) >> 16u);
}

// A distance as it counts: beyond the horizon it grows by the slope.
fn sight_beyond_horizon(sight: Sight, distance: i32) -> i32 {
    let hidden = max(saturating_sub(distance, sight.view.horizon), 0);
    let steep = mul_shift(u32(hidden), sight.slope, 8u);
    return saturating_add(distance - hidden, steep);
}

// Direction of the middle of a face.
fn centre(corners: array<Corner, 3>) -> vec3<i32> {
    let a = corners[0].direction;
    let ab = difference(corners[1].direction, a);
    let ac = difference(corners[2].direction, a);
    return a + (ab + ac) / 3;
}
