// Pass: lines of constant width on a globe: plate boundaries, arrows, directions.
//
// In:  vertex buffer   0 this end (f32x3, unit, globe axes)   1 other end (the same)
//                      2 elevations of this and the other end in km (f32x2)
//                      3 x: side of the line, -1 or 1; y: half the width in pixels, where the
//                        picture is 720 pixels high (f32x2)
//                      4 colour, sRGB (unorm8x4)
//      group 3         0 line (uniform)
// Out: colour, linear.

#import bevy_pbr::mesh_functions::get_world_from_local
#import bevy_pbr::mesh_view_bindings::view
#import bevy_pbr::view_transformations::position_world_to_clip
#import pangaea_shaders::globe::sample::{linear_from_srgb, displaced_radius}

// A uniform of all lines of a globe.
struct Line {
    // Exaggeration / planet radius in 1/km.
    relief: f32,
    // How much nearer than they are lines are drawn, as a share of their distance: keeps them above
    // the ground.
    lift: f32,
    pad0: f32,
    pad1: f32,
}

@group(#{MATERIAL_BIND_GROUP}) @binding(0) var<uniform> line: Line;

struct Input {
    @builtin(instance_index) instance: u32,
    @location(0) here: vec3<f32>,
    @location(1) there: vec3<f32>,
    @location(2) elevation: vec2<f32>,
    @location(3) side: vec2<f32>,
    @location(4) color: vec4<f32>,
}

struct Varying {
    @builtin(position) clip: vec4<f32>,
    @location(0) color: vec3<f32>,
}

@vertex
fn vertex(in: Input) -> Varying {
    let world_from_local = get_world_from_local(in.instance);
    let here = in.here * displaced_radius(in.elevation.x, line.relief, false);
    let there = in.there * displaced_radius(in.elevation.y, line.relief, false);
    let a = position_world_to_clip((world_from_local * vec4(here, 1.0)).xyz);
    let b = position_world_to_clip((world_from_local * vec4(there, 1.0)).xyz);
    let size = view.viewport.zw;
    let along = (b.xy / max(b.w, 1e-6) - a.xy / max(a.w, 1e-6)) * size;
    let forward = select(vec2(1.0, 0.0), normalize(along), dot(along, along) > 1e-12);
    // Each end looks towards the other, so sides are mirrored between them; the index order knows.
    let across = vec2(-forward.y, forward.x);
    let half_width = max(in.side.y * size.y / 720.0, 0.6);
    // Half a width of cap hides the gaps between joined segments.
    let offset = half_width * (in.side.x * across - 0.7 * forward);
    var out: Varying;
    out.clip = a;
    out.clip.x += 2.0 * offset.x / size.x * a.w;
    out.clip.y += 2.0 * offset.y / size.y * a.w;
    out.clip.z *= 1.0 + line.lift;
    out.color = linear_from_srgb(in.color.xyz);
    return out;
}

@fragment
fn fragment(in: Varying) -> @location(0) vec4<f32> {
    return vec4(in.color, 1.0);
}
