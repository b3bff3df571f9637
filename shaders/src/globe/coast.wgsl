// Coasts finer than the samples: noise that bends the coast by less than a spacing.
//
// It is made up, for the eye only: nothing but the coast changes, and what the planet holds does
// not change at all. It depends on the direction alone, so it stands still.

#define_import_path pangaea_shaders::globe::coast

// How far a coast may move, as a share of the spacing of samples.
const REACH: f32 = 0.6;

// A number in -1..1 for a point of the integer lattice (the mixer of Jarzynski and Olano 2020).
fn lattice_value(p: vec3<i32>) -> f32 {
    var v = bitcast<vec3<u32>>(p) * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> vec3(16u);
    v.x += v.y * v.z;
    return f32(v.x >> 8u) * (2.0 / 16777216.0) - 1.0;
}

// Smooth noise in -1..1 with features of unit size.
fn value_noise(p: vec3<f32>) -> f32 {
    let cell = floor(p);
    let f = p - cell;
    let w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    let i = vec3<i32>(cell);
    let a = mix(lattice_value(i), lattice_value(i + vec3(1, 0, 0)), w.x);
    let b = mix(lattice_value(i + vec3(0, 1, 0)), lattice_value(i + vec3(1, 1, 0)), w.x);
    let c = mix(lattice_value(i + vec3(0, 0, 1)), lattice_value(i + vec3(1, 0, 1)), w.x);
    let d = mix(lattice_value(i + vec3(0, 1, 1)), lattice_value(i + vec3(1, 1, 1)), w.x);
    return mix(mix(a, b, w.y), mix(c, d, w.y), w.z);
}

// The side of the coast at `direction`, ragged: land where it is positive.
// `rough` says how far the coast may move, 0..=1; `spacing` is that of the samples in radians.
fn ragged(coast: f32, rough: f32, direction: vec3<f32>, spacing: f32) -> f32 {
    let amplitude = REACH * rough;
    if abs(coast) >= amplitude {
        return coast;
    }
    let p = normalize(direction) / spacing;
    let shift = 0.5 * value_noise(0.45 * p) + 0.4 * value_noise(1.1 * p + 7.0) + 0.24 * value_noise(2.3 * p + 19.0)
        + 0.14 * value_noise(5.1 * p + 31.0) + 0.07 * value_noise(11.0 * p + 43.0);
    return coast + amplitude * clamp(shift, -1.0, 1.0);
}
