// A sample of the globe: unpacked, and placed in space.
//
// Lengths are in planet radii, elevations in km, directions in the globe's own axes (north = +y).
// `relief` is exaggeration / planet radius, in 1/km: it turns an elevation into planet radii.

#define_import_path pangaea_shaders::globe::sample

// One sample of the crust as it is drawn.
struct Sample {
    // Elevation of the land in km.
    land: f32,
    // Elevation of the sea floor in km.
    floor: f32,
    // Gradient of the visible one of the two in km per radian, in the tangent basis of the sample.
    gradient: vec2<f32>,
    // Colour of the overlay, linear.
    color: vec3<f32>,
    // 1 where the ground stands out (a selected plate), else 0.
    marked: f32,
    // Side of the coast: 1 land, -1 sea, between them near the coast, which is where it is 0.
    coast: f32,
    // How far the coast may be moved, 0..=1.
    rough: f32,
}

// Largest elevation in km and steepest gradient in km per radian that can be packed.
const MAX_ELEVATION: f32 = 32.0;
const MAX_GRADIENT: f32 = 8192.0;

// From sRGB, as overlays give it, to linear light (IEC 61966-2-1).
fn linear_from_srgb(srgb: vec3<f32>) -> vec3<f32> {
    let low = srgb / 12.92;
    let high = pow((srgb + 0.055) / 1.055, vec3(2.4));
    return select(high, low, srgb <= vec3(0.04045));
}

// A sample from its four words: elevations, gradient, colour, coast.
fn unpack_sample(words: vec4<u32>) -> Sample {
    let heights = MAX_ELEVATION * unpack2x16snorm(words.x);
    let color = unpack4x8unorm(words.z);
    let coast = unpack2x16snorm(words.w);
    return Sample(
        heights.x,
        heights.y,
        MAX_GRADIENT * unpack2x16snorm(words.y),
        linear_from_srgb(color.xyz),
        color.w,
        coast.x,
        coast.y,
    );
}

// The elevation that is drawn at a sample.
fn drawn_elevation(s: Sample) -> f32 {
    return select(s.floor, s.land, s.coast > 0.0);
}

// Two unit vectors perpendicular to the unit vector `n` and to each other (Duff et al. 2017).
// The packing of gradients uses the same formula on the same numbers.
fn tangent_basis(n: vec3<f32>) -> mat2x3<f32> {
    let s = select(-1.0, 1.0, n.z >= 0.0);
    let a = -1.0 / (s + n.z);
    let b = n.x * n.y * a;
    return mat2x3<f32>(
        vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x),
        vec3(b, s + n.y * n.y * a, -n.y),
    );
}

// Normal of the displaced surface at the direction `n`. Not of unit length, so that it may be
// interpolated between samples.
fn surface_normal(n: vec3<f32>, gradient: vec2<f32>, relief: f32) -> vec3<f32> {
    return n - relief * (tangent_basis(n) * gradient);
}

// Distance from the planet's centre. With `sea` the surface does not go below sea level.
fn displaced_radius(elevation: f32, relief: f32, sea: bool) -> f32 {
    return 1.0 + relief * select(elevation, max(elevation, 0.0), sea);
}
