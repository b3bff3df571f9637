// Pass: the air, a shell around the globe that is blended over it (premultiplied).
//
// In:  vertex buffer   0 position (f32x3, globe axes, planet radii)
//      group 3         0 air (uniform)
// Out: premultiplied colour, linear.
//
// From outside the front of the shell is drawn and covers the disc and its rim; from inside only
// the back of the shell is seen, the sky.

#import bevy_pbr::mesh_functions::get_world_from_local
#import bevy_pbr::mesh_view_bindings::view
#import bevy_pbr::view_transformations::position_world_to_clip
#import pangaea_shaders::globe::light::{air, shoulder}

// A uniform of the shell.
struct Air {
    // xyz: unit vector to the sun, globe axes. w: scale height in planet radii.
    sun: vec4<f32>,
    // Radius of the shell in planet radii.
    top: f32,
    // Strength, 0..=1.
    strength: f32,
    pad0: f32,
    pad1: f32,
}

@group(#{MATERIAL_BIND_GROUP}) @binding(0) var<uniform> shell: Air;

struct Varying {
    @builtin(position) clip: vec4<f32>,
    // World space.
    @location(0) world: vec3<f32>,
    // Centre of the planet, world space.
    @location(1) @interpolate(flat) centre: vec3<f32>,
    // xyz unit vector to the sun, world axes. w planet radius in world units.
    @location(2) @interpolate(flat) sun: vec4<f32>,
}

@vertex
fn vertex(@builtin(instance_index) instance: u32, @location(0) position: vec3<f32>) -> Varying {
    let world_from_local = get_world_from_local(instance);
    let scale = length(world_from_local[0].xyz);
    var out: Varying;
    out.world = (world_from_local * vec4(position * shell.top, 1.0)).xyz;
    out.clip = position_world_to_clip(out.world);
    out.centre = world_from_local[3].xyz;
    out.sun = vec4(normalize((world_from_local * vec4(shell.sun.xyz, 0.0)).xyz), scale);
    return out;
}

@fragment
fn fragment(in: Varying, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    let camera = (view.world_position - in.centre) / in.sun.w;
    let outside = dot(camera, camera) > shell.top * shell.top;
    if front != outside {
        discard;
    }
    let ray = normalize((in.world - view.world_position) / in.sun.w);
    let along = -dot(camera, ray);
    let closest = camera + max(along, 0.0) * ray;
    let nearest = length(closest);
    let ground = along > 0.0 && nearest < 1.0;
    var point = normalize(closest);
    var grazing = 0.0;
    if ground {
        point = camera + (along - sqrt(1.0 - nearest * nearest)) * ray;
        grazing = -dot(point, ray);
    }
    let seen = air(nearest, point, grazing, ground, in.sun.xyz, -ray, shell.sun.w);
    // The shell has an end where real air has none: fade out before it.
    let fade = shell.strength * (1.0 - smoothstep(0.7 * (shell.top - 1.0), shell.top - 1.0, nearest - 1.0));
    return fade * vec4(shoulder(seen.xyz), seen.w);
}
