//! Tides of level 0: from the mouths up the rivers.

use super::arms::river_edges;
use crate::amplify::arith::ratio;
use crate::amplify::control::{ControlMesh, VertexKind};
use crate::amplify::fixed::difference;
use crate::amplify::rules::estuary;
use crate::amplify::scale::PlanetScale;
use crate::amplify::vertex::Vertex;

/// Gives rivers before the sea their tides. Deltas have none: their rivers push the sea back.
pub(super) fn flood(scale: &PlanetScale, mesh: &ControlMesh, vertices: &mut [Vertex]) {
    let rivers: Vec<[usize; 2]> = river_edges(mesh).collect();
    let mut leaving = vec![0_u32; vertices.len()];
    let mut largest: Vec<Option<usize>> = vec![None; vertices.len()];
    for &[up, down] in &rivers {
        leaving[up] += 1;
        // Of equal rivers the seed decides, not the number of a vertex.
        let rank = |v: usize| (vertices[v].discharge, vertices[v].seed);
        if largest[down].is_none_or(|other| rank(up) > rank(other)) {
            largest[down] = Some(up);
        }
    }
    let length = |vertices: &[Vertex], [up, down]: [usize; 2]| {
        let [up, down] = [up, down].map(|v| vertices[v].direction);
        scale.grains(difference(down, up))
    };
    for &[mouth, sea] in &rivers {
        let ends_in_sea = vertices[sea].kind == VertexKind::Sea;
        let splits = |v: usize| leaving[v] > 1;
        if !ends_in_sea || splits(mouth) || largest[mouth].is_some_and(splits) {
            continue;
        }
        let fall = ratio(-vertices[sea].height, length(vertices, [mouth, sea]));
        let mut tide = estuary::mouth(fall);
        // It widens on into the sea.
        raise(&mut vertices[sea], tide + estuary::OCTAVE);
        raise(&mut vertices[mouth], tide);
        let mut at = mouth;
        while let Some(up) = largest[at].filter(|_| tide > 0) {
            let way = length(vertices, [up, at]);
            tide = estuary::upstream(tide, way, vertices[up].flow(), scale.edge_grains(0));
            raise(&mut vertices[up], tide);
            at = up;
        }
    }
}

/// Raises the tide of a vertex: several rivers may end in one.
fn raise(vertex: &mut Vertex, tide: i32) {
    vertex.tide = vertex.tide.max(tide as u16);
}
