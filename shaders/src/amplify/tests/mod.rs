//! The laws of a refinement.

mod deltas;
mod lakes;
mod local;
mod meanders;
mod meshes;
mod order;
mod precision;
mod range;
mod shore;
mod sight;
mod topology;
mod valleys;
mod views;
mod water;

use super::base::Base;
use super::control::VertexKind;
use super::fixed::{GRAINS, ONE};
use super::ground::{Caps, RefinedGround, refine};
use super::mark::View;
use super::rules::Rules;
use super::seed::{pcg, share};
use super::synthetic::control_mesh;
use super::vertex::Vertex;

/// A vector of reals.
type Vector = [f64; 3];

/// A small planet: 1280 faces on a radius of 300 km.
fn planet() -> Base {
    Base::new(&control_mesh(300_000, 3, 7)).unwrap()
}

/// The ground of a view under the default rules.
fn refined(base: &Base, view: &View) -> RefinedGround {
    refine(base, &Rules::default(), view, &Caps::default())
}

/// The nearest integer direction of a vector.
fn unit(p: Vector) -> [i32; 3] {
    let n = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
    p.map(|x| (x / n * f64::from(ONE)).round() as i32)
}

/// A random direction.
fn direction(k: u32) -> [i32; 3] {
    unit([0, 1, 2].map(|i| f64::from(share(pcg(k), i)) - 32_768.0))
}

/// A random direction of every other number, else that of a random river vertex.
fn anywhere_or_on_river(base: &Base, k: u32) -> [i32; 3] {
    if k.is_multiple_of(2) {
        direction(k)
    } else {
        on_river(base, k)
    }
}

/// The direction of a random river vertex.
fn on_river(base: &Base, k: u32) -> [i32; 3] {
    let is_river = |v: &&Vertex| v.kind == VertexKind::River;
    let rivers: Vec<&Vertex> = base.vertices.iter().filter(is_river).collect();
    rivers[pcg(k) as usize % rivers.len()].direction
}

fn camera(direction: [i32; 3], altitude_m: i32, level: u32) -> View {
    View {
        direction,
        altitude: Some(altitude_m * 16),
        radius: 0,
        sharpness: 12 << 8,
        horizon: 100_000 * 16,
        ..View::whole(level)
    }
}
