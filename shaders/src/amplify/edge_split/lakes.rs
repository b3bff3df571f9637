//! Lakes around a new vertex, and their one level.
//!
//! Dry ground beside a lake stands at its level at least, or it would be flooded. So a new vertex
//! must know the lakes that it may come to lie beside: those of its edge's ends and of the corners
//! beyond. Straight edges have no corners; there a vertex asks what its ends knew.

use crate::amplify::control::VertexKind;
use crate::amplify::rules::{EdgeKind, Rules, STRAIGHT_LEVEL};
use crate::amplify::seed::pcg;
use crate::amplify::vertex::Vertex;

/// Number and level (grains) of the lake around the vertex that halves an edge; number 0 for none.
/// Of several the highest: ground that holds it back holds back the others.
pub(super) fn around(level: u32, ends: [&Vertex; 2], opposite: [Option<&Vertex>; 2]) -> (u32, i32) {
    let corners = ends.into_iter().chain(opposite.into_iter().flatten());
    let lakes = corners.filter(|v| v.kind == VertexKind::Lake);
    match lakes.max_by_key(|v| v.lake_level) {
        Some(lake) => (lake.lake, lake.lake_level),
        None => known(level, ends),
    }
}

/// The lake that the ends of an edge lie beside.
fn known(level: u32, [a, b]: [&Vertex; 2]) -> (u32, i32) {
    let by = |end: &Vertex| (end.lake, end.lake_level);
    match (a.lake, b.lake) {
        (0, 0) => (0, 0),
        // Both hold back the lower of two lakes.
        (1.., 1..) if a.lake_level <= b.lake_level => by(a),
        (1.., 1..) => by(b),
        (1.., 0) if goes_on(level, a, b) => by(a),
        (0, 1..) if goes_on(level, b, a) => by(b),
        _ => (0, 0),
    }
}

/// Whether a lake that one end of an edge knows may reach the other, too: a corner of coarser
/// levels knows none, and may lie at a shore nevertheless.
fn goes_on(level: u32, end: &Vertex, other: &Vertex) -> bool {
    level >= STRAIGHT_LEVEL && other.surface() >= end.lake_level
}

/// Whether the corners beyond an edge hold back water at the level of its wet ends.
pub(super) fn is_dammed(ends: [&Vertex; 2], opposite: [Option<&Vertex>; 2]) -> bool {
    let wet = ends.into_iter().filter(|v| v.is_wet());
    let level = wet.map(|v| v.water).max().unwrap_or(i32::MIN);
    let holds = |corner: Option<&Vertex>| corner.is_some_and(|v| v.surface() >= level);
    opposite.into_iter().all(holds)
}

/// Settles the lake and the discharge of a new vertex, and keeps water from rising downstream.
pub(super) fn settle(rules: &Rules, edge: EdgeKind, new: &mut Vertex, a: &Vertex, b: &Vertex) {
    if !rules.landforms {
        keep_level(new, a, b);
    }
    match new.kind {
        VertexKind::Lake => fill(edge, new, a, b),
        // Water never lies below that of the lower end.
        VertexKind::River => new.water = new.water.max(new.bed).max(b.water),
        _ => new.discharge = 0,
    }
}

/// Gives a new vertex of a lake its number, level and discharge.
fn fill(edge: EdgeKind, new: &mut Vertex, a: &Vertex, b: &Vertex) {
    if new.lake == 0 {
        // All lakes that widen one river vertex are one.
        let river = if a.is_wet() { a } else { b };
        new.lake = pcg(river.seed) | 1;
    }
    new.lake_level = new.water;
    if edge != EdgeKind::River {
        // What flows through a lake leaves it by its river.
        new.discharge = a.discharge.min(b.discharge);
    }
}

/// Print and release: keeps lakes level, whatever the graph says, and their water off the land.
fn keep_level(new: &mut Vertex, a: &Vertex, b: &Vertex) {
    if is_one_lake(a, b) {
        // Between two vertices of one lake its surface goes on, whatever was drawn.
        new.kind = VertexKind::Lake;
        new.height = a.bed + (b.bed - a.bed) / 2;
        new.bed = new.height;
        new.water = a.water;
    } else if new.kind == VertexKind::Terrain {
        for lake in [a, b].iter().filter(|v| v.kind == VertexKind::Lake) {
            new.height = new.height.max(lake.water + 1);
        }
        new.bed = new.height;
        new.water = new.height;
    }
}

/// Whether two vertices lie in the same lake, or in a lake and in a river that has its level.
fn is_one_lake(a: &Vertex, b: &Vertex) -> bool {
    let is_lake = a.kind == VertexKind::Lake || b.kind == VertexKind::Lake;
    is_lake && a.is_wet() && b.is_wet() && a.water == b.water
}
