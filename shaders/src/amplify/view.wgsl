// The ground that a picture asks for, and how finely.

// The part of the ground that is refined, and how finely: for a camera, or a disc or a square of
// ground. In the order of a uniform without holes.
struct View {
    // Direction of its centre, in units of 1 / ONE.
    direction: vec3<i32>,
    // Height of its centre above sea level, sixteenths of a metre; 0 where it has none.
    altitude: i32,
    // Unit tangents, Q16: only the square in the disc whose sides run along them is refined evenly;
    // zero for the whole disc.
    first_side: vec3<i32>,
    // Radius of the disc that is refined evenly, sixteenths of a metre; 0 for a camera.
    radius: i32,
    second_side: vec3<i32>,
    // Ground farther than this from the centre is not seen, sixteenths of a metre.
    horizon: i32,
    // Unit vector that a camera looks along, Q16; zero if it looks all round.
    forward: vec3<i32>,
    // Cosine of the angle from `forward` within which ground is seen, Q16.
    field: i32,
    // 1 where distances have the altitude in them, 0 where they are along the ground.
    has_altitude: u32,
    // How many times coarser ground is where a camera does not look, Q8.
    outside: u32,
    // Distance over edge length at which a face is split, Q8.
    sharpness: u32,
    // Finest level, 0..=17.
    level: u32,
}

// The sharpness within its limits.
fn view_clamped_sharpness(view: View) -> u32 {
    return clamp(view.sharpness, LEAST_SHARPNESS, MOST_SHARPNESS);
}

// Distance within which a face of a level is split, sixteenths of a metre.
fn view_bound(view: View, scale: PlanetScale, level: u32) -> i32 {
    // A camera, of radius 0, refines no ground evenly.
    let finest = view.radius > 0 && level + 1u == view.level;
    let sharpness = select(view_clamped_sharpness(view), RIM_SHARPNESS, finest);
    return mul_shift(scale.edge, sharpness, 8u + level);
}

// How far a direction lies beside the square, across the nearer pair of its sides; sixteenths of a
// metre, at most 0 within them.
fn view_beside(view: View, scale: PlanetScale, direction: vec3<i32>) -> i32 {
    if all(view.first_side == vec3(0)) && all(view.second_side == vec3(0)) {
        return 0;
    }
    // Quarters of units, so that opposite sides of the planet keep 32 bits.
    let offset = difference(direction >> vec3(2u), view.direction >> vec3(2u));
    let x = unsigned_abs(dot_q16(offset, view.first_side));
    let y = unsigned_abs(dot_q16(offset, view.second_side));
    // Half a side is the radius over the root of two.
    return planet_scale_sixteenths(scale, max(x, y)) - mul_q16(view.radius, HALF_SIDE);
}
