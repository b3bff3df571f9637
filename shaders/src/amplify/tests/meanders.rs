//! Rivers wind as their slope has it, on a mesh that stays whole.

use super::*;
use crate::amplify::ground::RefinedGround;
use crate::amplify::rules::EdgeKind;
use crate::amplify::topology::{Level, NONE, SplitMark};
use std::collections::{BTreeMap, BTreeSet};

/// Width of a river at a flow φ of 1, metres.
const FULL_WIDTH_M: f64 = 2_147.0;

/// A piece of river 20 widths long as the crow flies.
struct Stretch {
    slope: f64,
    sinuosity: f64,
    /// Turns from one side to the other.
    turns: usize,
}

/// A planet of low land: its rivers fall twenty times less than others.
fn plains() -> Base {
    let mut mesh = control_mesh(800_000, 4, 5);
    for vertex in &mut mesh.vertices {
        for height in [&mut vertex.height, &mut vertex.bed, &mut vertex.water] {
            *height /= 20;
        }
    }
    Base::new(&mesh).unwrap()
}

fn width_m(vertex: &Vertex) -> f64 {
    FULL_WIDTH_M * f64::from(vertex.flow()) / 65_536.0
}

/// The way of the water from a vertex on, as far as it is refined to a level.
fn downstream(ground: &RefinedGround, from: [i32; 3], level: usize) -> Vec<u32> {
    let rivers = ground.levels[level]
        .edges()
        .filter(|(e, _)| e.kind == EdgeKind::River);
    let drawn = rivers.filter(|(_, s)| s.mark != SplitMark::Split);
    let next: BTreeMap<u32, u32> = drawn.map(|(e, _)| (e.vertices[0], e.vertices[1])).collect();
    let is_start = |v: &Vertex| v.direction == from;
    let start = ground.vertices.iter().position(is_start);
    let start = start.map(|v| v as u32);
    let is_river = |v: &u32| is_river(&ground.vertices[*v as usize]);
    std::iter::successors(start, |v| next.get(v).copied().filter(is_river)).collect()
}

fn is_river(vertex: &Vertex) -> bool {
    vertex.kind == VertexKind::River
}

/// Place on the ground, metres.
fn place(ground: &RefinedGround, v: u32) -> Vector {
    let metre = f64::from(ONE) / f64::from(ground.scale.radius_m);
    ground.vertices[v as usize]
        .direction
        .map(|x| f64::from(x) / metre)
}

fn distance(p: Vector, q: Vector) -> f64 {
    let square = |x: f64| x * x;
    (0..3).map(|i| square(p[i] - q[i])).sum::<f64>().sqrt()
}

/// Cuts a way into stretches.
fn stretches(ground: &RefinedGround, way: &[u32]) -> Vec<Stretch> {
    let places: Vec<Vector> = way.iter().map(|&v| place(ground, v)).collect();
    let mut found = Vec::new();
    let (mut start, mut length) = (0, 0.0);
    for i in 1..way.len() {
        length += distance(places[i - 1], places[i]);
        let chord = distance(places[start], places[i]);
        let [up, down] = [start, i].map(|i| &ground.vertices[way[i] as usize]);
        if chord >= 20.0 * width_m(up) {
            found.push(Stretch {
                slope: f64::from(up.water - down.water) / 1024.0 / length,
                sinuosity: length / chord,
                turns: turns(&places[start..=i], width_m(up)),
            });
            (start, length) = (i, 0.0);
        }
    }
    found
}

/// How often a way turns back towards its chord after it has left it by more than a width.
fn turns(places: &[Vector], width: f64) -> usize {
    let (first, last) = (places[0], places[places.len() - 1]);
    let along = [0, 1, 2].map(|i| last[i] - first[i]);
    let normal = [
        first[1] * along[2] - first[2] * along[1],
        first[2] * along[0] - first[0] * along[2],
        first[0] * along[1] - first[1] * along[0],
    ];
    let size = distance(normal, [0.0; 3]);
    let aside = |p: &Vector| (0..3).map(|i| (p[i] - first[i]) * normal[i]).sum::<f64>() / size;
    // A turn is an extreme that the way comes back from by two thirds of a width.
    let (mut count, mut side, mut extreme) = (0, 0.0, 0.0);
    for y in places.iter().map(aside) {
        if (y - extreme) * side >= 0.0 && side != 0.0 {
            extreme = y;
        } else if (y - extreme).abs() > width / 1.5 {
            count += 1;
            side = (y - extreme).signum();
            extreme = y;
        }
    }
    count
}

/// All stretches of the rivers of some discs.
fn all_stretches(base: &Base) -> Vec<Stretch> {
    let mut found = Vec::new();
    for k in 0..40 {
        let from = on_river(base, k);
        let view = View::disc(from, 12_000, 9);
        let ground = refined(base, &view);
        found.extend(stretches(&ground, &downstream(&ground, from, 9)));
    }
    found
}

fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

#[test]
fn slow_rivers_meander_and_steep_ones_run_on() {
    let sinuosity = |base: &Base, low: f64, high: f64| {
        let found = all_stretches(base);
        let these = found.iter().filter(|s| (low..high).contains(&s.slope));
        let (sinuosity, waves): (Vec<f64>, Vec<f64>) = these
            .map(|s| (s.sinuosity, 40.0 / s.turns.max(1) as f64))
            .unzip();
        assert!(sinuosity.len() > 25, "{low}: {}", sinuosity.len());
        (median(sinuosity), median(waves))
    };
    let (slow, wave) = sinuosity(&plains(), 0.0, 0.001);
    assert!(slow > 1.5 && (10.0..14.0).contains(&wave), "{slow} {wave}");
    let (steep, _) = sinuosity(&planet(), 0.01, 1.0);
    assert!((1.0..1.25).contains(&steep), "{steep}");
}

/// The river that leaves its edge is whole: it comes to every apex and goes on from it.
#[test]
fn every_apex_lies_on_one_river() {
    let base = plains();
    let mut apexes = 0;
    for k in 0..6 {
        let ground = refined(&base, &View::disc(on_river(&base, k), 6_000, 9));
        for level in &ground.levels {
            let rim = rim(level);
            let is_apex = |v: &u32| ground.vertices[*v as usize].bend.is_apex();
            for (v, [leaving, arriving]) in rivers_at(level) {
                if is_apex(&v) && !rim.contains(&v) {
                    assert!(leaving == 1 && arriving > 0, "{leaving} {arriving}");
                    apexes += 1;
                }
            }
        }
    }
    assert!(apexes > 100, "{apexes}");
}

/// Vertices at which faces are missing in a level.
fn rim(level: &Level) -> BTreeSet<u32> {
    let open = level.mesh.edges.iter().filter(|e| e.faces.contains(&NONE));
    open.flat_map(|e| e.vertices).collect()
}

/// How many rivers of a level leave its vertices, and arrive there.
fn rivers_at(level: &Level) -> BTreeMap<u32, [usize; 2]> {
    let mut rivers: BTreeMap<u32, [usize; 2]> = BTreeMap::new();
    for edge in level
        .mesh
        .edges
        .iter()
        .filter(|e| e.kind == EdgeKind::River)
    {
        for (end, v) in edge.vertices.into_iter().enumerate() {
            rivers.entry(v).or_default()[end] += 1;
        }
    }
    rivers
}
