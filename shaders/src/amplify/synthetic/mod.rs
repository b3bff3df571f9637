//! A made-up control mesh for tests, benches and examples: a jittered icosphere with continents,
//! rivers and lakes.
//!
//! No geology: heights are a few smooth waves, drained by a priority flood.

mod drain;
mod icosphere;

use super::control::{ControlMesh, ControlVertex, VertexKind};
use super::fixed::{GRAINS, ONE, metres};
use super::seed::{draw, pcg, share};
use icosphere::{UnitVector, connect, icosphere, jitter};

pub use icosphere::facing;

/// Height of the waves that make continents, metres.
const WAVES_M: f64 = 1500.0;

/// Height of the noise that makes depressions, metres.
const NOISE_M: f64 = 250.0;

/// A planet of 20·4^`depth` faces and a radius in metres.
///
/// ```
/// use pangaea_shaders::amplify::synthetic::control_mesh;
///
/// let mesh = control_mesh(6_371_000, 2, 1);
/// assert_eq!(mesh.faces.len(), 20 * 4 * 4);
/// assert_eq!(mesh.vertices.len() + mesh.faces.len(), mesh.edges.len() + 2);
/// ```
pub fn control_mesh(radius_m: u32, depth: u32, seed: u32) -> ControlMesh {
    let (points, triangles) = icosphere(depth);
    let points = jitter(&points, &triangles, seed);
    let (edges, faces) = connect(&triangles);
    let vertices = (0..)
        .zip(points)
        .map(|(i, p)| vertex(p, pcg(seed ^ pcg(i)), seed))
        .collect();
    let mut mesh = ControlMesh {
        radius_m,
        vertices,
        edges,
        faces,
    };
    drain::drain(&mut mesh);
    mesh
}

/// A dry vertex with a seed of its own on the planet of another seed.
fn vertex(p: UnitVector, seed: u32, planet: u32) -> ControlVertex {
    let real = ground(p, seed, planet);
    let height = real as i32;
    let (kind, crust, oceanic) = if real > 0.0 {
        (VertexKind::Terrain, height * 2 + metres(300), 0)
    } else {
        (VertexKind::Sea, height, u16::MAX)
    };
    ControlVertex {
        direction: p.map(|x| (x * f64::from(ONE)).round() as i32),
        seed,
        height,
        bed: height,
        water: height,
        flow: 0,
        crust,
        kind: kind as u8,
        valley: (draw(seed, 4) & 3) as u8,
        worn: unorm16(f64::from(share(planet, 77)) / 12_800.0 + p[0] / 4.0),
        collision: unorm16(p[1]),
        wetness: unorm16(0.5 + p[2]),
        plateau: unorm16(p[0] * p[1]),
        hills: unorm16(p[1] - p[2]),
        oceanic,
        ocean_age: unorm16(p[0] + 0.5),
        fold: [0; 3],
        ridge: [0; 3],
    }
}

/// Height of a vertex above the sea, grains.
fn ground(p: UnitVector, seed: u32, planet: u32) -> f64 {
    let noise = f64::from(share(seed, 3)) / 65_536.0;
    (waves(p, planet) * WAVES_M + noise * NOISE_M + 0.01) * f64::from(GRAINS)
}

/// Six waves of random directions and falling height; most of the planet is sea.
fn waves(p: UnitVector, planet: u32) -> f64 {
    let mut sum = -0.15;
    for k in 0..6 {
        let frequency = 1.5 + f64::from(k);
        let d = [0, 1, 2].map(|i| f64::from(share(planet, 10 * k + i)) / 32_768.0 - 1.0);
        let turn = frequency * (p[0] * d[0] + p[1] * d[1] + p[2] * d[2]) + f64::from(k);
        // A polynomial of one turn in place of a sine, whose bits would differ between machines.
        let x = turn - turn.floor();
        sum += (16.0 * x * (1.0 - x) * (1.0 - 2.0 * x)) / (1.0 + f64::from(k));
    }
    sum
}

/// A share of 0..1 in 16 bits.
fn unorm16(share: f64) -> u16 {
    (share.clamp(0.0, 1.0) * 65_535.0) as u16
}
