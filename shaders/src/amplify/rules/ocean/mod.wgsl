// The ocean floor's relief: transform faults, abyssal hills, and gradient noise.
//
// A buffer of vertices holds the relief of those of level 0, too, which Rust draws when it is asked
// for.

// Gradient noise of some octaves.
struct Roughness {
    // Height where the noise is 1, grains.
    height: i32,
    // Binary logarithm of the longest wavelength, in direction units.
    cell: u32,
    // Amplitude of an octave, as a share of the one before; Q16.
    gain: i32,
    octaves: u32,
    seed: u32,
}

// Offset of the sea floor at a vertex, grains. `edge` is the mean edge of the control mesh, grains.
fn ocean_relief(vertex: Vertex, edge: i32) -> i32 {
    let depth = -vertex.height;
    if depth <= 0 {
        return 0;
    }
    // Small planets have small oceans.
    let size = ratio(edge, FULL_RELIEF_EDGE);
    let offset = mul_q16(vertex.swell, size);
    // At most half the depth upwards, so that no relief reaches the surface.
    return min(mul_q16(offset, smoothstep(0, FULL_RELIEF_DEPTH, depth)), depth / 2);
}

// The relief that a vertex of a coarse level draws, grains. On land there is none.
fn ocean_drawn(vertex: Vertex) -> i32 {
    if vertex.height >= 0 {
        return 0;
    }
    var noises = array(0, 0);
    for (var k = 0u; k < 2u; k++) {
        var layer = FINE;
        if k == 1u {
            layer = COARSE;
        }
        noises[k] = fbm(layer.octaves, vertex.direction, layer.cell, layer.gain, layer.seed);
    }
    let rough = mul_q16(FINE.height, noises[0]) + mul_q16(COARSE.height, noises[1]);
    // No spreading is even: hills of one patch are up to five times as high as another's.
    let uneven = Q16 / 4 + saturate(Q16 / 2 + noises[1]);
    return rough + ridge_relief(vertex, uneven);
}

// The relief at vertices of an edge and of a face beside it; 0 where the new vertex draws its own.
fn swells(a: Vertex, b: Vertex, x: Vertex) -> vec3<i32> {
    // An edge has the level of one of its ends.
    if max(max(a.level, b.level), x.level) < SWELL_LEVEL {
        return vec3(0);
    }
    return vec3(a.swell, b.swell, x.swell);
}

// The relief at the vertex that halves an edge, which has that of the flat face there.
fn ocean_settle(made: Vertex, a: Vertex, b: Vertex) -> i32 {
    if made.level <= SWELL_LEVEL {
        return ocean_drawn(made);
    }
    return made.swell + grit(made, a, b);
}

// How far the vertex that halves an edge lies off the sea floor between its ends, grains.
fn grit(made: Vertex, a: Vertex, b: Vertex) -> i32 {
    if a.height >= 0 && b.height >= 0 {
        return 0;
    }
    var most = GRIT;
    for (var finer = SWELL_LEVEL + 1u; finer < made.level; finer++) {
        most = mul_q16(most, FINE.gain);
    }
    return mul_q16(2 * share(made.seed, 14u) - Q16, most);
}

// Transform faults and abyssal hills, grains; `uneven` is the hills' height relative to the mean,
// Q16.
fn ridge_relief(vertex: Vertex, uneven: i32) -> i32 {
    if vertex.oceanic == 0 || all(vertex.ridge == vec3(0)) {
        return 0;
    }
    // Hyperbolic in the age: sediment buries quickly first, then ever more slowly.
    let young = ratio(HALF_AGE, HALF_AGE + vertex.ocean_age);
    let ridge = unit_axis(vertex.ridge);
    let agreement = smoothstep(AGREEMENT[0], AGREEMENT[1], 2 * ridge.size);
    // Faults run across the ridge, the floor spreads across it.
    var sum = 0;
    for (var k = 0u; k < 2u; k++) {
        var stripes = FAULTS;
        var axis = ridge.unit;
        if k == 1u {
            stripes = HILLS;
            axis = across(vertex.direction, ridge.unit);
        }
        let phasor = stripe_noise_at(stripes, vertex.direction, axis);
        let height = select(fault(phasor), abyssal_hill(phasor, uneven), k == 1u);
        let unburied = UNBURIED[k] + mul_q16(young, Q16 - UNBURIED[k]);
        sum += mul_q16(height, unburied);
    }
    return mul_q16(mul_q16(sum, agreement), vertex.oceanic);
}

// A transform fault before sediment, grains: a sharp trough.
fn fault(stripes: Phasor) -> i32 {
    // ((1 - cos) / 2)^4 is a trough where the cosine is -1.
    let trough = square(square((Q16 - stripes.cosine) / 2));
    let presence = smoothstep(FAULT_PRESENCE[0], FAULT_PRESENCE[1], stripes.presence);
    // A sixth of the depth stands as rims above the floor, the rest lies below it.
    return mul_q16(mul_q16(FAULT_DEPTH, Q16 / 6 - trough), presence);
}

// An abyssal hill before sediment, grains.
fn abyssal_hill(stripes: Phasor, uneven: i32) -> i32 {
    let wave = mul_q16(mul_q16(HILL_HEIGHT, uneven), stripes.cosine);
    return mul_q16(wave, stripes.presence);
}

// A mean of axes at unit length, and how long it is, at least 1; both times 32767.
struct UnitAxis {
    unit: vec3<i32>,
    size: i32,
}

fn unit_axis(axis: vec3<i32>) -> UnitAxis {
    let size = clamp(length(axis.x, axis.y, axis.z), 1, 32767);
    return UnitAxis(clamp(axis * 32767 / size, vec3(-32767), vec3(32767)), size);
}

// The direction along the ground at a place that is perpendicular to an axis; components times
// 32767.
fn across(direction: vec3<i32>, axis: vec3<i32>) -> vec3<i32> {
    // 15 bits of each, so that their products fit 32.
    let perpendicular = cross(direction >> vec3(16u), axis) / (ONE >> 16u);
    return clamp(perpendicular, vec3(-32767), vec3(32767));
}
