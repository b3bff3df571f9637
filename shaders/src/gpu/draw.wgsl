// The ground and its water as lit triangles.
//
// Positions are relative to the camera: exact differences of integers first, then numbers of 32
// bits.

struct GroundCamera {
    // From the planet's axes, with the camera at their origin, to the clip space.
    clip_from_planet: mat4x4<f32>,
    // The camera's direction from the planet's centre, each component times ONE.
    direction: vec3<i32>,
    // Its height above the sea, grains.
    height: i32,
    // What both leave of its place, in units of length.
    rest: vec3<f32>,
    // Units of length in a metre.
    metre: f32,
    // The direction of the sun.
    sun: vec3<f32>,
    // Metres in a unit of direction.
    unit: f32,
    // What colours show: a number of DRAW_NATURAL and the like.
    colours: u32,
}

@group(0) @binding(1) var<uniform> ground_camera: GroundCamera;

struct Drawn {
    @builtin(position) clip: vec4<f32>,
    // Where the corner is from the camera, units of length.
    @location(0) place: vec3<f32>,
    @location(1) @interpolate(flat) normal: vec3<f32>,
    @location(2) colour: vec3<f32>,
    // Depth of the water, metres.
    @location(3) depth: f32,
    // Place in the triangle.
    @location(4) corner: vec3<f32>,
}

// Where a place is from the camera, units of length.
fn from_camera(direction: vec3<i32>, height: i32) -> vec3<f32> {
    let camera = ground_camera.direction;
    // Halves of words: differences across the planet leave 32 bits.
    let high = (direction >> vec3(16u)) - (camera >> vec3(16u));
    let low = (direction & vec3(0xffff)) - (camera & vec3(0xffff));
    let way = vec3<f32>(high) * 65536.0 + vec3<f32>(low);
    let up = vec3<f32>(camera) / f32(ONE);
    let metres = f32(height) / f32(GRAINS);
    let higher = f32(height - ground_camera.height) / f32(GRAINS);
    // The way along the sphere of the place's own height, then up from the camera's.
    let along = way * (ground_camera.unit + metres / f32(ONE));
    return (along + up * higher) * ground_camera.metre - ground_camera.rest;
}

// The three corners of a triangle: numbers of vertices, and what is shown of them.
struct TriangleCorners {
    vertices: array<u32, 3>,
    shown: array<Carved, 3>,
}

fn triangle_corners(triangle: u32) -> TriangleCorners {
    let vertices = triangles[triangle];
    return TriangleCorners(
        vertices,
        array(shown[vertices[0]], shown[vertices[1]], shown[vertices[2]]),
    );
}

// A corner of a triangle whose corners have some heights.
fn drawn_corner(corners: TriangleCorners, heights: vec3<i32>, corner: u32) -> Drawn {
    let a = from_camera(vertex_cores[corners.vertices[0]].direction, heights.x);
    let b = from_camera(vertex_cores[corners.vertices[1]].direction, heights.y);
    let c = from_camera(vertex_cores[corners.vertices[2]].direction, heights.z);
    let place = array(a, b, c)[corner];
    let across = vec3(
        (b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y),
        (b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z),
        (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x),
    );
    let shares = vec3(
        select(0.0, 1.0, corner == 0u),
        select(0.0, 1.0, corner == 1u),
        select(0.0, 1.0, corner == 2u),
    );
    return Drawn(
        ground_camera.clip_from_planet * vec4(place, 1.0),
        place,
        across * inverseSqrt(max(across.x * across.x + across.y * across.y + across.z * across.z, 1e-30)),
        vec3(0.0),
        0.0,
        shares,
    );
}

// The ground.
@vertex
fn draw_ground(
    @builtin(vertex_index) corner: u32,
    @builtin(instance_index) triangle: u32,
) -> Drawn {
    let corners = triangle_corners(triangle);
    let carved = corners.shown;
    let heights = vec3(carved[0].ground, carved[1].ground, carved[2].ground);
    var drawn = drawn_corner(corners, heights, corner);
    let vertex = corners.vertices[corner];
    drawn.colour = ground_colour(vertex, carved[corner], drawn.normal);
    return drawn;
}

// The water: where none of a triangle's corners is wet there is none.
@vertex
fn draw_water(
    @builtin(vertex_index) corner: u32,
    @builtin(instance_index) triangle: u32,
) -> Drawn {
    let corners = triangle_corners(triangle);
    let carved = corners.shown;
    let wet = vec3(
        carved_is_wet(carved[0]),
        carved_is_wet(carved[1]),
        carved_is_wet(carved[2]),
    );
    if !any(wet) {
        return Drawn();
    }
    let water = vec3(carved[0].water, carved[1].water, carved[2].water);
    let ground = vec3(carved[0].ground, carved[1].ground, carved[2].ground);
    let lowest = select(vec3(0x7fffffff), water, wet);
    let highest = select(vec3(-0x7fffffff), water, wet);
    let low = min(min(lowest.x, lowest.y), lowest.z);
    let high = max(max(highest.x, highest.y), highest.z);
    // Over dry corners the surface goes on under the ground.
    let level = select(min(clamp(water, vec3(low), vec3(high)), ground), water, wet);
    var drawn = drawn_corner(corners, level, corner);
    drawn.depth = f32(level[corner] - ground[corner]) / f32(GRAINS);
    return drawn;
}

// The colour of the ground at a vertex, linear.
fn ground_colour(vertex: u32, carved: Carved, normal: vec3<f32>) -> vec3<f32> {
    let course = vertex_courses[vertex];
    let kind = vertex_course_kind(course);
    switch ground_camera.colours & 15u {
        case DRAW_LEVEL: {
            return level_colour((course.winding_marks >> COURSE_LEVEL) & 31u);
        }
        case DRAW_KIND: {
            return kind_colour(kind);
        }
        default: {
            return natural_colour(vertex, carved, normal);
        }
    }
}

// Grass where it is wet, sand where it is dry, rock where it is steep, snow where it is high.
fn natural_colour(vertex: u32, carved: Carved, normal: vec3<f32>) -> vec3<f32> {
    let land = vertex_lands[vertex];
    let direction = vec3<f32>(vertex_cores[vertex].direction) / f32(ONE);
    let upright = normal.x * direction.x + normal.y * direction.y + normal.z * direction.z;
    let metres = f32(carved.ground) / f32(GRAINS);
    if metres < 0.0 {
        return vec3(0.09, 0.085, 0.06);
    }
    let wet = f32(halves(land.wetness_plateau).x) / f32(Q16);
    let grass = blend_colours(vec3(0.13, 0.16, 0.055), vec3(0.045, 0.1, 0.03), wet * 2.0 - 0.7);
    let soil = blend_colours(vec3(0.42, 0.33, 0.2), grass, wet * 3.0 - 0.5);
    let rock = blend_colours(vec3(0.16, 0.145, 0.13), vec3(0.27, 0.22, 0.17), 1.0 - wet * 2.0);
    let steep = (0.94 - upright) / 0.16;
    let bare = blend_colours(soil, rock, max(steep, metres / 1500.0 - 1.8));
    // The snow line sinks to the sea at the poles.
    let line = 5200.0 * (1.0 - direction.z * direction.z * 1.15);
    let snow = (metres - line) / 500.0 + min(upright * 4.0 - 3.1, 0.4);
    return blend_colours(bare, vec3(0.62, 0.65, 0.7), snow);
}

fn blend_colours(a: vec3<f32>, b: vec3<f32>, share: f32) -> vec3<f32> {
    return a + (b - a) * clamp(share, 0.0, 1.0);
}

// Levels from blue to red.
fn level_colour(level: u32) -> vec3<f32> {
    let t = f32(level) / 17.0;
    return clamp(vec3(t * 2.0 - 0.6, 1.0 - abs(t * 2.0 - 1.0), 1.2 - t * 2.0), vec3(0.05), vec3(0.9));
}

// Ground, sea, coast, river, lake and gully.
fn kind_colour(kind: u32) -> vec3<f32> {
    let colours = array(
        vec3(0.35, 0.32, 0.27),
        vec3(0.05, 0.12, 0.3),
        vec3(0.8, 0.7, 0.4),
        vec3(0.1, 0.35, 0.9),
        vec3(0.1, 0.7, 0.8),
        vec3(0.55, 0.2, 0.15),
    );
    return colours[min(kind, 5u)];
}

// How bright a face is to the sun and to the sky.
fn daylight(normal: vec3<f32>, place: vec3<f32>) -> vec3<f32> {
    let sun = ground_camera.sun;
    let towards = max(normal.x * sun.x + normal.y * sun.y + normal.z * sun.z, 0.0);
    let up = vec3<f32>(ground_camera.direction) / f32(ONE);
    let sky = 0.5 + 0.5 * (normal.x * up.x + normal.y * up.y + normal.z * up.z);
    return vec3(1.75, 1.65, 1.48) * towards + vec3(0.24, 0.3, 0.42) * sky;
}

// Air between the camera and a place.
fn hazed(colour: vec3<f32>, place: vec3<f32>) -> vec3<f32> {
    let way = inverseSqrt(max(place.x * place.x + place.y * place.y + place.z * place.z, 1e-20));
    let metres = 1.0 / (way * ground_camera.metre);
    let camera_metres = f32(ground_camera.height) / f32(GRAINS);
    // Thinner the higher the camera is.
    let dense = exp(-max(camera_metres, 0.0) / 9000.0);
    let kept = exp(-metres * dense / 90000.0);
    return vec3(0.42, 0.55, 0.75) * (1.0 - kept) + colour * kept;
}

@fragment
fn light_ground(drawn: Drawn) -> @location(0) vec4<f32> {
    var colour = drawn.colour * daylight(drawn.normal, drawn.place);
    if (ground_camera.colours & DRAW_WIREFRAME) != 0u {
        let edge = min(min(drawn.corner.x, drawn.corner.y), drawn.corner.z);
        let width = fwidth(edge);
        colour *= clamp(edge / max(width, 1e-6), 0.25, 1.0);
    }
    return vec4(hazed(colour, drawn.place), 1.0);
}

@fragment
fn light_water(drawn: Drawn) -> @location(0) vec4<f32> {
    let shallow = vec3(0.06, 0.17, 0.18);
    let deep = vec3(0.012, 0.045, 0.1);
    let seen = 1.0 - exp(-max(drawn.depth, 0.0) / 12.0);
    let colour = blend_colours(shallow, deep, seen) * daylight(drawn.normal, drawn.place);
    let opaque = clamp(0.35 + drawn.depth / 6.0, 0.35, 0.97);
    return vec4(hazed(colour, drawn.place), opaque);
}
