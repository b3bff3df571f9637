//! A jittered icosphere: its points, faces and edges.

use crate::amplify::control::{ControlEdge, ControlFace};
use crate::amplify::seed::{pcg, share};
use std::collections::BTreeMap;

/// A point on the unit sphere.
pub(super) type UnitVector = [f64; 3];

/// Greatest squared distance of neighbours among the corners of an icosahedron: 1.106 and rounding.
const NEIGHBOUR_SQUARE: f64 = 1.2;

/// Most share of the way to a neighbour that a point is moved by, either way and for two
/// neighbours.
const JITTER: f64 = 0.45;

fn unit(p: UnitVector) -> UnitVector {
    let n = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
    p.map(|x| x / n)
}

/// Points and faces of a sphere of 20·4^`depth` faces.
pub(super) fn icosphere(depth: u32) -> (Vec<UnitVector>, Vec<[u32; 3]>) {
    let mut points = icosahedron();
    let mut triangles = faces_of_icosahedron(&points);
    for _ in 0..depth {
        triangles = quartered(&triangles, &mut points);
    }
    (points, triangles)
}

fn icosahedron() -> Vec<UnitVector> {
    // The corners of three golden rectangles, each normal to the other two.
    let g = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let mut points = Vec::new();
    for (a, b) in [(1.0, g), (-1.0, g), (1.0, -g), (-1.0, -g)] {
        points.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]].map(unit));
    }
    points
}

/// All triples of neighbours, counter-clockwise from outside.
fn faces_of_icosahedron(points: &[UnitVector]) -> Vec<[u32; 3]> {
    let mut triangles = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                let corners = [i, j, k].map(|v| points[v]);
                if are_neighbours(corners) {
                    let [a, b, c] = [i as u32, j as u32, k as u32];
                    let is_outward = facing(corners) > 0.0;
                    triangles.push(if is_outward { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    triangles
}

/// Whether three corners of an icosahedron are each other's neighbours.
fn are_neighbours([a, b, c]: [UnitVector; 3]) -> bool {
    [[a, b], [b, c], [c, a]].into_iter().all(|[p, q]| {
        let squares = (0..3).map(|i| (p[i] - q[i]) * (p[i] - q[i]));
        squares.sum::<f64>() < NEIGHBOUR_SQUARE
    })
}

/// Four triangles for every one; the middles of edges are added to the points.
fn quartered(triangles: &[[u32; 3]], points: &mut Vec<UnitVector>) -> Vec<[u32; 3]> {
    let mut middles = BTreeMap::new();
    let mut finer = Vec::with_capacity(triangles.len() * 4);
    for &[a, b, c] in triangles {
        let m = [[a, b], [b, c], [c, a]].map(|[a, b]| {
            let made = middles.entry([a.min(b), a.max(b)]);
            *made.or_insert_with(|| add_middle(points, [a, b]))
        });
        finer.extend([[a, m[0], m[2]], [b, m[1], m[0]], [c, m[2], m[1]], m]);
    }
    finer
}

/// Adds the middle of an edge to the points.
fn add_middle(points: &mut Vec<UnitVector>, edge: [u32; 2]) -> u32 {
    let [p, q] = edge.map(|v| points[v as usize]);
    points.push(unit([0, 1, 2].map(|i| p[i] + q[i])));
    points.len() as u32 - 1
}

/// Positive where three points turn counter-clockwise seen from outside.
pub fn facing([a, b, c]: [UnitVector; 3]) -> f64 {
    let [u, v] = [b, c].map(|p| [0, 1, 2].map(|i| p[i] - a[i]));
    let n = [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ];
    n[0] * a[0] + n[1] * a[1] + n[2] * a[2]
}

/// Moves every point by up to a fifth of an edge towards or from two of its neighbours.
pub(super) fn jitter(points: &[UnitVector], triangles: &[[u32; 3]], seed: u32) -> Vec<UnitVector> {
    let mut moved = points.to_vec();
    let mut done = vec![false; points.len()];
    for t in triangles {
        for k in 0..3 {
            // Once, in the first of its triangles.
            if !std::mem::replace(&mut done[t[k] as usize], true) {
                let turned = [0, 1, 2].map(|i| t[(k + i) % 3]);
                moved[t[k] as usize] = jittered(points, turned, seed);
            }
        }
    }
    moved
}

/// The first of three points, moved towards or from the others.
fn jittered(points: &[UnitVector], triangle: [u32; 3], seed: u32) -> UnitVector {
    let [p, a, b] = triangle.map(|v| points[v as usize]);
    let [x, y] = [1, 2].map(|i| {
        let random = f64::from(share(pcg(seed ^ triangle[0]), i)) / 65_536.0 - 0.5;
        random * JITTER
    });
    unit([0, 1, 2].map(|i| p[i] + x * (a[i] - p[i]) + y * (b[i] - p[i])))
}

/// Edges between faces, numbered as they are met.
pub(super) fn connect(triangles: &[[u32; 3]]) -> (Vec<ControlEdge>, Vec<ControlFace>) {
    let mut index = BTreeMap::new();
    let mut edges: Vec<ControlEdge> = Vec::new();
    let mut faces = Vec::new();
    for (f, &vertices) in (0..).zip(triangles) {
        let around = [0, 1, 2].map(|k| {
            let [a, b] = [vertices[k], vertices[(k + 1) % 3]];
            let e = *index.entry((a.min(b), a.max(b))).or_insert(edges.len());
            if e == edges.len() {
                edges.push(ControlEdge {
                    vertices: [a, b],
                    faces: [f, u32::MAX],
                    river: 0,
                });
            } else {
                edges[e].faces[1] = f;
            }
            e as u32
        });
        faces.push(ControlFace {
            vertices,
            edges: around,
        });
    }
    (edges, faces)
}
