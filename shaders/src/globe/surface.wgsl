// Pass: the ground and the sea of a globe, or its triangles as lines (WIREFRAME).
//
// In:  vertex buffer   0 direction (f32x3, unit, globe axes)   1 number of the sample (u32)
//      group 3         0 globe (uniform)
//                      1 samples (storage, four words each: see sample.wgsl)
// Out: colour, linear.

#import bevy_pbr::mesh_functions::get_world_from_local
#import bevy_pbr::mesh_view_bindings::view
#import bevy_pbr::view_transformations::position_world_to_clip
#import pangaea_shaders::globe::sample::{unpack_sample, drawn_elevation, surface_normal, displaced_radius}
#import pangaea_shaders::globe::light::{ground_light, sea_gloss, shoulder}
#import pangaea_shaders::globe::coast::ragged

// A uniform of the whole globe.
struct Globe {
    // xyz: unit vector to the sun, globe axes. w: share of light that remains at night, 0..1.
    sun: vec4<f32>,
    // Exaggeration / planet radius in 1/km.
    relief: f32,
    // Bit 0: the surface stops at sea level. Bit 1: colour is the elevation's tint, else the
    // samples' colour. Bit 2: the coast is drawn as a line.
    flags: u32,
    // Number of stops of the tint, 0..=24.
    stops: u32,
    // Distance between samples in radians.
    spacing: f32,
    // Tint of the elevation: xyz linear colour, w elevation in km, ascending.
    tint: array<vec4<f32>, 24>,
    // Colour of triangle edges, linear.
    wire: vec4<f32>,
}

@group(#{MATERIAL_BIND_GROUP}) @binding(0) var<uniform> globe: Globe;
@group(#{MATERIAL_BIND_GROUP}) @binding(1) var<storage, read> samples: array<vec4<u32>>;

// Slopes are lit as if they were this much steeper than they are drawn: hill shading.
const SHADING: f32 = 2.0;

// Elevations in km of the lowest land and of the highest sea floor that are drawn beside a sea.
const BEACH: f32 = 0.03;
const SHOAL: f32 = -0.08;

const SEA: u32 = 1u;
const TINT: u32 = 2u;
const COAST: u32 = 4u;

struct Input {
    @builtin(instance_index) instance: u32,
    @location(0) direction: vec3<f32>,
    @location(1) sample: u32,
}

struct Varying {
    @builtin(position) clip: vec4<f32>,
    // World space.
    @location(0) world: vec3<f32>,
    // Normal of the ground for shading, world axes, not of unit length.
    @location(1) normal: vec3<f32>,
    // Direction from the centre, world axes, not of unit length.
    @location(2) up: vec3<f32>,
    // xyz overlay colour, linear. w is 1 where the ground stands out.
    @location(3) color: vec4<f32>,
    // Unit vector to the sun, world axes; the same everywhere.
    @location(4) sun: vec3<f32>,
    // Direction from the centre, globe axes, not of unit length.
    @location(5) site: vec3<f32>,
    // Elevations of land and sea floor in km, side of the coast, how far it may move: see
    // sample.wgsl.
    @location(6) shape: vec4<f32>,
}

@vertex
fn vertex(in: Input) -> Varying {
    let s = unpack_sample(samples[in.sample]);
    let radius = displaced_radius(drawn_elevation(s), globe.relief, (globe.flags & SEA) != 0u);
    let world_from_local = get_world_from_local(in.instance);
    var out: Varying;
    out.world = (world_from_local * vec4(in.direction * radius, 1.0)).xyz;
    out.clip = position_world_to_clip(out.world);
    // A globe is turned, moved and scaled evenly, so normals turn like directions.
    out.normal = (world_from_local * vec4(surface_normal(in.direction, s.gradient, SHADING * globe.relief), 0.0)).xyz;
    out.up = (world_from_local * vec4(in.direction, 0.0)).xyz;
    out.color = vec4(s.color, s.marked);
    out.site = in.direction;
    out.shape = vec4(s.land, s.floor, s.coast, s.rough);
    out.sun = normalize((world_from_local * vec4(globe.sun.xyz, 0.0)).xyz);
#ifdef WIREFRAME
    // Nearer by a ten-thousandth of the distance (depth is reversed): lines win over their
    // triangles.
    out.clip.z *= 1.0003;
#endif
    return out;
}

// Colour of the elevation `z` in km.
fn tint(z: f32) -> vec3<f32> {
    var above = 1u;
    while above + 1u < globe.stops && z >= globe.tint[above].w {
        above += 1u;
    }
    let low = globe.tint[above - 1u];
    let high = globe.tint[above];
    return mix(low.xyz, high.xyz, clamp((z - low.w) / max(high.w - low.w, 1e-6), 0.0, 1.0));
}

@fragment
fn fragment(in: Varying) -> @location(0) vec4<f32> {
    let up = normalize(in.up);
    let ground = normalize(in.normal);
#ifdef WIREFRAME
    return vec4(globe.wire.xyz, 1.0);
#else
    let coast = ragged(in.shape.z, in.shape.w, in.site, globe.spacing);
    // Width of a pixel across the coast, which is drawn as soft as that.
    let pixel = max(fwidth(coast), 1e-5);
    let sea = (globe.flags & SEA) != 0u;
    let water = select(0.0, 1.0 - smoothstep(-0.7 * pixel, 0.7 * pixel, coast), sea);
    let depth = max(-in.shape.y, -SHOAL);
    var albedo = in.color.xyz;
    if (globe.flags & TINT) != 0u {
        albedo = vec3(0.0);
        if water < 1.0 {
            albedo = (1.0 - water) * tint(select(in.shape.x, max(in.shape.x, BEACH), sea));
        }
        if water > 0.0 {
            albedo += water * tint(-depth);
        }
    }
    albedo = mix(albedo, vec3(1.0), 0.22 * in.color.w);
    let sun = in.sun;
    if (globe.flags & COAST) != 0u {
        // The coast as a thin dark line, where colours do not show it.
        albedo *= 0.35 + 0.65 * smoothstep(0.4, 1.3, abs(coast) / pixel);
    }
    // The sea floor shows through the water, as on an atlas.
    let normal = normalize(mix(ground, up, 0.6 * water));
    var color = albedo * ground_light(normal, up, sun, globe.sun.w);
    if water > 0.0 && (globe.flags & TINT) != 0u {
        let eye = normalize(view.world_position - in.world);
        color += water * sea_gloss(up, sun, eye, depth);
    }
    return vec4(shoulder(color), 1.0);
#endif
}
