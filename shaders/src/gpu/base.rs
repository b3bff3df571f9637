//! The rows of a control mesh, as the buffers hold them.

use crate::amplify::base::Base;
use crate::amplify::rows::{
    EdgeJoins, EdgeState, FaceCorners, FaceSides, LevelSizes, VertexCore, VertexCourse, VertexLand,
    VertexRiver, words,
};
use crate::amplify::rules::ocean::{OceanCache, swell};
use crate::amplify::scale::PlanetScale;
use crate::amplify::topology::{EdgeSplit, FaceSplit};
use crate::amplify::vertex::Vertex;
use std::thread;

/// Words of the columns of a control mesh.
#[derive(Clone, Debug)]
pub struct BaseRows {
    pub(super) scale: PlanetScale,
    pub(super) sizes: LevelSizes,
    pub(super) columns: Vec<(&'static str, Vec<u32>)>,
}

impl BaseRows {
    /// Those of a control mesh; threads share the work.
    pub fn new(base: &Base) -> Self {
        let level = &base.level;
        let sizes = LevelSizes {
            edges: level.edges.len() as u32,
            faces: level.faces.len() as u32,
            first_vertex: base.vertices.len() as u32,
            ..LevelSizes::default()
        };
        let edge = EdgeSplit::default();
        let face = FaceSplit::default();
        let edges = &level.edges;
        let faces = &level.faces;
        let states = edges.iter().map(|row| EdgeState::from((row, &edge)));
        let sides = faces.iter().map(|row| FaceSides::from((row, &face, 0)));
        let corners = faces.iter().map(|row| FaceCorners::from((row, &face)));
        let vertices = &base.vertices;
        let courses = vertices.iter().map(|v| VertexCourse::from((v, v.kind)));
        Self {
            scale: base.scale,
            sizes,
            columns: vec![
                ("vertex_cores", words(vertices.iter().map(VertexCore::from))),
                ("vertex_courses", words(courses)),
                ("vertex_lands", lands(vertices)),
                (
                    "vertex_rivers",
                    words(vertices.iter().map(VertexRiver::from)),
                ),
                ("edge_joins", words(edges.iter().map(EdgeJoins::from))),
                ("edge_states", words(states)),
                ("face_sides", words(sides)),
                ("face_corners", words(corners)),
            ],
        }
    }

    /// The planet's constants.
    pub const fn scale(&self) -> &PlanetScale {
        &self.scale
    }

    /// Its bytes: what an upload moves.
    pub fn bytes(&self) -> u64 {
        let words = self.columns.iter().map(|(_, words)| words.len() as u64);
        4 * words.sum::<u64>()
    }
}

/// Rows of the land, whose sea floors are dear: a part for each thread.
fn lands(vertices: &[Vertex]) -> Vec<u32> {
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let part = vertices.len().div_ceil(threads).max(1);
    let parts = thread::scope(|scope| {
        let threads = vertices.chunks(part).map(|part| scope.spawn(|| rows(part)));
        let threads: Vec<_> = threads.collect();
        let parts = threads.into_iter().map(|thread| thread.join());
        parts.collect::<Result<Vec<_>, _>>()
    });
    // A thread that could not finish leaves the work to this one.
    parts.map_or_else(|_| rows(vertices), |parts| parts.concat())
}

fn rows(vertices: &[Vertex]) -> Vec<u32> {
    let mut cache = OceanCache::default();
    let row = |vertex: &Vertex| VertexLand::from((vertex, swell(&mut cache, vertex)));
    words(vertices.iter().map(row))
}
