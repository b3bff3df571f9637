// The size of a planet: how lengths of directions become metres, and how long an edge of a level
// is.

// Constants of one planet.
struct PlanetScale {
    // Radius at sea level, metres.
    radius_m: u32,
    // Grains in a unit of direction, Q20.
    grains_per_unit: u32,
    // Sixteenths of a metre in four units of direction, Q20.
    sixteenths_per_four: u32,
    // Mean edge of the control mesh, sixteenths of a metre.
    edge: u32,
}

// Length of a difference of directions, grains.
fn planet_scale_grains(scale: PlanetScale, d: vec3<i32>) -> i32 {
    return mul_shift(u32(length(d.x, d.y, d.z)), scale.grains_per_unit, 20u);
}

// Distance between two directions, anywhere on the sphere, along the chord; sixteenths of a metre.
fn planet_scale_chord(scale: PlanetScale, a: vec3<i32>, b: vec3<i32>) -> i32 {
    // Opposite directions are 2 ONE apart, which an i32 does not hold.
    let d = difference(a >> vec3(2u), b >> vec3(2u));
    return planet_scale_sixteenths(scale, u32(length(d.x, d.y, d.z)));
}

// A length in four units of direction as sixteenths of a metre.
fn planet_scale_sixteenths(scale: PlanetScale, fours: u32) -> i32 {
    return mul_shift(fours, scale.sixteenths_per_four, 20u);
}

// Theoretical edge of a level, grains: that of level 0 halved `level` times.
fn planet_scale_edge_grains(scale: PlanetScale, level: u32) -> i32 {
    // 64 grains in a sixteenth of a metre, doubled, for a shift of at least 1.
    return mul_shift(scale.edge, 128u, 1u + level);
}
