//! The column of vertices: first those of the control mesh, which all runs of a planet share, then
//! those of a run, level after level in the order of the edges that they halve.

use super::vertex::Vertex;
use core::iter::Chain;
use core::ops::Index;
use core::slice::Iter;
use std::sync::Arc;

/// Vertices of all levels. One number names a vertex in both parts: a run's follow on the control
/// mesh's.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Vertices {
    base: Arc<Vec<Vertex>>,
    grown: Vec<Vertex>,
}

impl Vertices {
    /// Those of a control mesh.
    pub const fn new(base: Arc<Vec<Vertex>>) -> Self {
        Self {
            base,
            grown: Vec::new(),
        }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.base.len() + self.grown.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Those of the control mesh.
    pub fn base(&self) -> &[Vertex] {
        &self.base
    }

    /// Those that the run made.
    pub fn grown(&self) -> &[Vertex] {
        &self.grown
    }

    /// All, to be read.
    #[inline]
    pub fn view(&self) -> VertexView<'_> {
        VertexView {
            base: &self.base,
            grown: &self.grown,
        }
    }

    /// Some, by their numbers.
    #[inline]
    pub fn gather<const N: usize>(&self, vertices: [u32; N]) -> [&Vertex; N] {
        self.view().gather(vertices)
    }

    /// Appends so many; returns the others to be read, and the new ones to be written.
    pub fn append(&mut self, count: usize) -> (VertexView<'_>, &mut [Vertex]) {
        let before = self.grown.len();
        self.grown.resize(before + count, Vertex::default());
        let (grown, new) = self.grown.split_at_mut(before);
        let base = &self.base;
        (VertexView { base, grown }, new)
    }

    /// One that the run made, to be written.
    #[inline]
    pub fn grown_mut(&mut self, vertex: u32) -> &mut Vertex {
        &mut self.grown[vertex as usize - self.base.len()]
    }

    /// All, in the order of their numbers.
    pub fn iter(&self) -> Chain<Iter<'_, Vertex>, Iter<'_, Vertex>> {
        self.base.iter().chain(&self.grown)
    }
}

impl Index<usize> for Vertices {
    type Output = Vertex;

    #[inline]
    fn index(&self, vertex: usize) -> &Vertex {
        self.view().get(vertex as u32)
    }
}

impl<'a> IntoIterator for &'a Vertices {
    type Item = &'a Vertex;
    type IntoIter = Chain<Iter<'a, Vertex>, Iter<'a, Vertex>>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// Vertices of all levels, to be read.
#[derive(Clone, Copy, Debug)]
pub struct VertexView<'a> {
    base: &'a [Vertex],
    grown: &'a [Vertex],
}

impl<'a> VertexView<'a> {
    /// The vertices of a slice.
    pub const fn of(vertices: &'a [Vertex]) -> Self {
        Self {
            base: vertices,
            grown: &[],
        }
    }

    /// One, by its number.
    #[inline]
    pub fn get(self, vertex: u32) -> &'a Vertex {
        let place = vertex as usize;
        match self.base.get(place) {
            Some(vertex) => vertex,
            None => &self.grown[place - self.base.len()],
        }
    }

    /// Some, by their numbers.
    #[inline]
    pub fn gather<const N: usize>(self, vertices: [u32; N]) -> [&'a Vertex; N] {
        vertices.map(|v| self.get(v))
    }
}
