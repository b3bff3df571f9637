//! Tides of level 0: from the mouths up the rivers.

use super::arms::{BaseRivers, LargestAbove};
use crate::amplify::arith::ratio;
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::difference;
use crate::amplify::rules::estuary;
use crate::amplify::scale::PlanetScale;
use crate::amplify::vertex::Vertex;

/// Gives rivers before the sea their tides. Deltas have none: their rivers push the sea back.
/// `largest` is the river that arrives at each vertex, up which the tide goes.
pub(super) fn flood(
    scale: &PlanetScale,
    network: &BaseRivers,
    largest: &LargestAbove,
    vertices: &mut [Vertex],
) {
    let below = &network.below;
    let parts = |v: usize| below.of(v).len() > 1;
    for &mouth in network.upper_ends() {
        let in_delta = parts(mouth) || largest.of(mouth).is_some_and(parts);
        let Some(&sea) = below.of(mouth).first().filter(|_| !in_delta) else {
            continue;
        };
        if vertices[sea].kind == VertexKind::Sea {
            let fall = ratio(-vertices[sea].height, length(scale, vertices, [mouth, sea]));
            let tide = estuary::mouth(fall);
            // It widens on into the sea.
            raise(&mut vertices[sea], tide + estuary::OCTAVE);
            run_up(scale, largest, vertices, mouth, tide);
        }
    }
}

/// Leads the tide of a mouth up its river until it has gone.
fn run_up(
    scale: &PlanetScale,
    largest: &LargestAbove,
    vertices: &mut [Vertex],
    mouth: usize,
    mut tide: i32,
) {
    raise(&mut vertices[mouth], tide);
    let mut at = mouth;
    while let Some(up) = largest.of(at).filter(|_| tide > 0) {
        let way = length(scale, vertices, [up, at]);
        tide = estuary::upstream(tide, way, vertices[up].flow(), scale.edge_grains(0));
        raise(&mut vertices[up], tide);
        at = up;
    }
}

/// Length of the way between two vertices, grains.
pub(super) fn length(scale: &PlanetScale, vertices: &[Vertex], ends: [usize; 2]) -> i32 {
    let [up, down] = ends.map(|v| vertices[v].direction);
    scale.grains(difference(down, up))
}

/// Raises the tide of a vertex: several rivers may end in one.
fn raise(vertex: &mut Vertex, tide: i32) {
    vertex.tide = vertex.tide.max(tide as u16);
}
