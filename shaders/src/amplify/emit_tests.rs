//! Leaves with two split edges never get a triangle that is turned over.

use super::*;
use crate::amplify::fixed::ONE;
use crate::amplify::seed::draw;
use crate::amplify::synthetic::facing;

/// A share of 0..1.
fn random(seed: u32, k: u32) -> f64 {
    f64::from(draw(seed, k)) / f64::from(u32::MAX)
}

/// A point of a face of the given height and lean, 5 degrees wide, near the north pole.
fn point(shape: [f64; 2], [_, b, c]: [f64; 3]) -> Vertex {
    let [x, y] = [b + c * shape[0], c * shape[1]].map(|x| x * 0.09);
    let length = (x * x + y * y + 1.0).sqrt();
    Vertex {
        direction: [x, y, 1.0].map(|x| (x / length * f64::from(ONE)).round() as i32),
        ..Vertex::default()
    }
}

/// Shares of the corners that a middle between the first two may have: a third of both at least,
/// and 0.175 of the far corner at most, towards it or away; see `edge_split::place`. Half of them
/// lie at a corner of these bounds.
fn middle(seed: u32) -> [f64; 3] {
    let extreme = |x: f64| if random(seed, 9) < 0.5 { x.round() } else { x };
    let far = (extreme(random(seed, 1)) * 2.0 - 1.0) * 0.175;
    let free = 1.0 - far - 2.0 / 3.0;
    let first = 1.0 / 3.0 + extreme(random(seed, 2)) * free;
    [first, 1.0 - far - first, far]
}

/// A leaf whose first two edges are split.
const LEAF: Turned = Turned {
    corners: [0, 1, 2],
    mids: [3, 4, NONE],
};

/// A random leaf: its corners and the two middles.
fn leaf(k: u32) -> [Vertex; 5] {
    // Corners lean by up to two edges either way, and are a sixth to two edges high.
    let shape = [random(k, 20) * 5.0 - 2.0, 0.17 + random(k, 21) * 1.83];
    let ([p, q, r], [s, t, u]) = (middle(k), middle(k + 1_000_000));
    let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    [a, b, c, [p, q, r], [u, s, t]].map(|shares| point(shape, shares))
}

/// Least area of some triangles.
fn least(vertices: &[Vertex], triangles: &[[u32; 3]]) -> f64 {
    let corners = |t: &[u32; 3]| t.map(|v| real(&vertices[v as usize]));
    let areas = triangles.iter().map(|t| facing(corners(t)));
    areas.fold(f64::MAX, f64::min)
}

/// Where a vertex lies, in radii.
fn real(vertex: &Vertex) -> [f64; 3] {
    vertex.direction.map(|x| f64::from(x) / f64::from(ONE))
}

#[test]
fn no_fan_of_two_middles_turns_over() {
    let mut saved = [0; 2];
    for k in 0..100_000 {
        let vertices = leaf(k);
        let fan = LEAF.thirds(VertexView::of(&vertices));
        assert!(least(&vertices, &fan) > 0.0, "{k}: {vertices:?}");
        let is_by_c = fan[1] == [0, 3, 2];
        let other = if is_by_c {
            [[0, 3, 4], [0, 4, 2]]
        } else {
            [[0, 3, 2], [3, 4, 2]]
        };
        saved[usize::from(is_by_c)] += u32::from(least(&vertices, &other) <= 0.0);
    }
    // For some middles the other diagonal would not do, either way.
    assert!(saved.iter().all(|&n| n > 10), "{saved:?}");
}
