// Gradient noise on integer directions: an exact lattice of cells of 2^k units, from continents to
// half a metre. The Rust twin keeps the hashes of a cell's corners from call to call.

// One step of the linear congruential generator of Numerical Recipes.
fn congruential(x: u32) -> u32 {
    return x * CONGRUENTIAL_FACTOR + CONGRUENTIAL_STEP;
}

// A hash of a lattice cell, well mixed in all bits (three rounds in the manner of pcg3d, M.
// Jarzynski and M. Olano, Hash functions for GPU rendering, 2020).
fn cell_hash(x: u32, y: u32, z: u32, seed: u32) -> u32 {
    var a = congruential(x) ^ seed;
    var b = congruential(y);
    var c = congruential(z);
    a += b * c;
    b += c * a;
    c += a * b;
    a ^= a >> 16u;
    b ^= b >> 16u;
    c ^= c >> 16u;
    a += b * c;
    b += c * a;
    c += a * b;
    return c ^ (a >> 16u) ^ (b << 16u);
}

// 6t^5 - 15t^4 + 10t^3 of a share.
fn fade(t: i32) -> i32 {
    // By Horner: t^3 (t (6t - 15) + 10).
    let cube = mul_q16(mul_q16(t, t), t);
    return mul_q16(cube, mul_q16(t, 6 * t - 15 * Q16) + 10 * Q16);
}

// Dot product of a corner's gradient, one of the twelve (+-1, +-1, 0) and their like, with the
// offset from it.
fn gradient_dot(hash: u32, x: i32, y: i32, z: i32) -> i32 {
    // Sixteen cases, four of them twice, as in Perlin's table.
    let u = select(y, x, (hash & 8u) == 0u);
    let v = select(select(z, x, (hash & 13u) == 12u), y, (hash & 12u) == 0u);
    return select(-u, u, (hash & 1u) == 0u) + select(-v, v, (hash & 2u) == 0u);
}

// A cell of the noise's lattice.
struct NoiseCell {
    // Number of the cell on each axis.
    address: vec3<u32>,
    // The last number on an axis: the lattice is periodic, after its last cell comes its first.
    top: u32,
    seed: u32,
}

// The gradient's dot product at the corner that is `corner` cells (each 0 or 1) from the address.
fn corner_dot(cell: NoiseCell, corner: vec3<u32>, place: vec3<i32>) -> i32 {
    let at = (cell.address + corner) & vec3(cell.top);
    // `gradient_dot` reads the low four bits: these come from the middle of the hash.
    let hash = cell_hash(at.x, at.y, at.z, cell.seed) >> 7u;
    let offset = place - vec3<i32>(corner) * Q16;
    return gradient_dot(hash, offset.x, offset.y, offset.z);
}

// The noise on the edge of the cell at (j, k) of its cross-section.
fn blend_along_x(cell: NoiseCell, j: u32, k: u32, place: vec3<i32>, fade_x: i32) -> i32 {
    let near = corner_dot(cell, vec3(0u, j, k), place);
    let far = corner_dot(cell, vec3(1u, j, k), place);
    return mix(near, far, fade_x);
}

// Gradient noise of wavelength 2^`cell` direction units at a point, about -1..1 in Q16, mean 0;
// `cell` 1..=30.
fn gradient(point: vec3<i32>, cell: u32, seed: u32) -> i32 {
    // Adding the origin may wrap: the lattice is periodic in 32 bits.
    let moved = vec3<u32>(point) + vec3(origin(0u, seed), origin(1u, seed), origin(2u, seed));
    let home = NoiseCell(moved >> vec3(cell), 0xffffffffu >> cell, seed);
    let inside = moved & vec3((1u << cell) - 1u);
    // The place within the cell as a share of it, whatever its size.
    let place = vec3<i32>((inside << vec3(less(16u, cell))) >> vec3(less(cell, 16u)));
    let u = fade(place.x);
    let v = fade(place.y);
    let w = fade(place.z);
    let near = mix(blend_along_x(home, 0u, 0u, place, u), blend_along_x(home, 1u, 0u, place, u), v);
    let far = mix(blend_along_x(home, 0u, 1u, place, u), blend_along_x(home, 1u, 1u, place, u), v);
    return mix(near, far, w);
}

// Origin of a seed's lattice on an axis: octaves must not share the zeros of their lattices.
fn origin(axis: u32, seed: u32) -> u32 {
    return (seed ^ (axis * AXIS_FACTOR)) * ORIGIN_FACTOR;
}

// A sum of octaves of `gradient`, each half the wavelength and `gain` (Q16) of the amplitude of the
// last; at most `cell` octaves.
fn fbm(octaves: u32, point: vec3<i32>, cell: u32, gain: i32, seed: u32) -> i32 {
    var sum = 0;
    var weight = Q16;
    for (var octave = 0u; octave < min(octaves, cell); octave++) {
        let octave_seed = seed + octave * OCTAVE_STEP;
        sum += mul_q16(gradient(point, cell - octave, octave_seed), weight);
        weight = mul_q16(weight, gain);
    }
    return sum;
}
