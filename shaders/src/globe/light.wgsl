// How the globe is lit: sun, twilight, sea and air. Pure functions of unit vectors.
//
// The light is chosen for reading a planet, not measured: the terminator is soft, the night keeps a
// little light, slopes that face away from the centre of the disc are shaded even at noon.

#define_import_path pangaea_shaders::globe::light

// Share of daylight where the sun stands at the sine `altitude` above the horizon. Twilight
// reaches some 8 degrees into the night.
fn daylight(altitude: f32) -> f32 {
    return smoothstep(-0.14, 0.3, altitude);
}

// Colour of the sunlight: white when high, warm when low.
fn sun_color(altitude: f32) -> vec3<f32> {
    return mix(vec3(1.0, 0.56, 0.34), vec3(1.0, 0.985, 0.96), smoothstep(-0.1, 0.4, altitude));
}

// Light on ground with the unit normal `normal` at the direction `up`.
// `night` is the share of light that remains where the sun does not shine, 0..1.
fn ground_light(normal: vec3<f32>, up: vec3<f32>, sun: vec3<f32>, night: f32) -> vec3<f32> {
    let altitude = dot(up, sun);
    let day = daylight(altitude);
    let direct = max(dot(normal, sun), 0.0) * day;
    // Half a unit of skylight fills the shadows, less in valleys' walls than on level ground.
    let sky = day * (0.12 + 0.1 * dot(normal, up));
    let steep = mix(1.0, dot(normal, up), 0.55);
    let lit = (1.02 * direct) * sun_color(altitude) + sky * vec3(0.75, 0.88, 1.1);
    let dark = night * vec3(0.78, 0.9, 1.15) * (0.6 + 0.4 * steep);
    return steep * lit + dark * (1.0 - 0.85 * day);
}

// Glint of the sun and the sky's mirror image on water, to be added to the lit water.
// `eye` is the unit vector towards the camera; `depth` is in km and not negative.
fn sea_gloss(up: vec3<f32>, sun: vec3<f32>, eye: vec3<f32>, depth: f32) -> vec3<f32> {
    let altitude = dot(up, sun);
    let day = daylight(altitude);
    let half_way = normalize(sun + eye + vec3(0.0, 1e-6, 0.0));
    let facing = max(dot(up, half_way), 0.0);
    let glint = 0.1 * pow(facing, 260.0) + 0.03 * pow(facing, 36.0);
    let fresnel = pow(1.0 - max(dot(up, eye), 0.0), 4.0);
    let deep = smoothstep(0.0, 0.2, depth);
    return day * deep * (glint * vec3(0.8, 0.92, 1.0) * sun_color(altitude) + 0.1 * fresnel * vec3(0.35, 0.6, 1.0));
}

// Keeps highlights from clipping: linear up to 0.7, then a soft shoulder that ends at 1.
fn shoulder(color: vec3<f32>) -> vec3<f32> {
    let over = max(color - 0.7, vec3(0.0));
    return min(color, vec3(0.7)) + 0.3 * (1.0 - exp(-over / 0.3));
}

// Air between the camera and the planet along one ray: rgb is premultiplied light, a is how much of
// what lies behind is hidden.
//
// `nearest` is the distance of the ray's closest point from the centre in planet radii, `point` the
// unit direction that the light is taken at: where the ray meets the ground, else its closest
// point. `grazing` is the cosine between the ray and the vertical there; `ground` says whether the
// ray ends on the planet. `thickness` is the scale height in planet radii. Columns follow Chapman's
// function to leading order.
fn air(nearest: f32, point: vec3<f32>, grazing: f32, ground: bool, sun: vec3<f32>, eye: vec3<f32>, thickness: f32) -> vec4<f32> {
    let tangent = sqrt(6.2831853 / thickness);
    let slant = 1.0 / (grazing + 1.0 / (0.5 * tangent + grazing));
    let height = max(nearest - 1.0, 0.0);
    let column = select(tangent * exp(-height / thickness), min(slant, 0.5 * tangent), ground);
    let altitude = dot(point, sun);
    // Before the disc the haze ends with the day; at the rim the sun still reaches the high air.
    let day = smoothstep(select(-0.2, -0.04, ground), 0.34, altitude);
    // The day is blue; along the rim twilight is red.
    let twilight = mix(vec3(1.0, 0.45, 0.22), vec3(0.3, 0.42, 0.75), select(0.0, 0.75, ground));
    let hue = mix(twilight, vec3(0.24, 0.52, 1.0), smoothstep(-0.1, 0.3, altitude));
    let forward = pow(max(-dot(eye, sun), 0.0), 6.0);
    let amount = 1.0 - exp(-0.042 * column);
    let light = (hue + 0.6 * forward * vec3(1.0, 0.7, 0.5)) * amount * day;
    return vec4(light, amount * mix(0.1, 0.5, day));
}
