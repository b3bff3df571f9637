//! Pass: the faces of the control mesh that a view reaches, compacted to level 0 of its ground.

use super::base::Base;
use super::mark::View;
use super::topology::{Edge, Face, Level, NONE};
use super::vertex::Vertex;

/// Rings of faces kept around what is split, so that no edge that is split lacks a face.
const MARGIN: i32 = 8;

/// Level 0 of a view's ground: the vertices and the level.
pub fn cull(base: &Base, view: &View) -> (Vec<Vertex>, Level) {
    if view.horizon == i32::MAX && view.radius == i32::MAX {
        return (base.vertices.clone(), base.level.clone());
    }
    let edge = base.planet.edge.min(i32::MAX as u32 / 16) as i32;
    let reach = view.horizon.max(view.bound(&base.planet, 0)).saturating_add(edge * MARGIN);
    let ground = View { altitude: None, radius: 0, ..*view };
    let near = |face: &Face| {
        let corners = face.vertices.map(|v| &base.vertices[v as usize]);
        ground.distance(&base.planet, corners) < reach.saturating_add(view.radius)
    };
    let kept: Vec<u32> = (0..).zip(&base.level.faces).filter(|(_, f)| near(f)).map(|(i, _)| i).collect();
    compact(base, &kept)
}

/// Some faces of the control mesh as a level of their own, in the given order.
pub fn compact(base: &Base, kept: &[u32]) -> (Vec<Vertex>, Level) {
    let mut places = Places::default();
    for (i, &f) in (0..).zip(kept) {
        places.faces.insert(f, i);
        for k in 0..3 {
            let face = &base.level.faces[f as usize];
            places.vertices.insert(face.vertices[k], 0);
            places.edges.insert(face.edges[k], 0);
        }
    }
    for (i, place) in (0..).zip(places.vertices.values_mut()) {
        *place = i;
    }
    for (i, place) in (0..).zip(places.edges.values_mut()) {
        *place = i;
    }
    let vertices = places.vertices.keys().map(|&v| base.vertices[v as usize]).collect();
    let edges = places.edges.keys().map(|&e| places.edge(&base.level.edges[e as usize])).collect();
    let faces = kept.iter().map(|&f| places.face(f, &base.level.faces[f as usize])).collect();
    (vertices, Level { edges, faces })
}

/// Where items of the control mesh went; ordered maps, so that the order of the items stays.
#[derive(Default)]
struct Places {
    vertices: std::collections::BTreeMap<u32, u32>,
    edges: std::collections::BTreeMap<u32, u32>,
    faces: std::collections::BTreeMap<u32, u32>,
}

impl Places {
    fn edge(&self, edge: &Edge) -> Edge {
        let vertices = edge.vertices.map(|v| self.vertices[&v]);
        let faces = edge.faces.map(|f| self.faces.get(&f).copied().unwrap_or(NONE));
        Edge { vertices, faces, ..*edge }
    }

    fn face(&self, index: u32, face: &Face) -> Face {
        Face::new(face.vertices.map(|v| self.vertices[&v]), face.edges.map(|e| self.edges[&e]), index)
    }
}
