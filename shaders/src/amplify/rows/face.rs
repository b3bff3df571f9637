//! The two rows of a face.

use super::row;
use crate::amplify::topology::{Face, FaceSplit, Inner, NONE, SplitMark};

/// The edges of a face, and what a run decided of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct FaceSides {
    /// Its edges, as [`Face::edges`].
    pub edges: [u32; 3],
    /// Mark (bits 0 to 3), how many of its neighbours are split although it is not (4 to 7), and
    /// its inner edges, a byte each.
    pub marks: u32,
}

row!(FaceSides { edges, marks });

/// The corners of a face, and its children.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct FaceCorners {
    /// Its corners, as [`Face::vertices`].
    pub vertices: [u32; 3],
    /// Its first child in the next level; [`NONE`] where it is not split.
    pub child: u32,
}

row!(FaceCorners { vertices, child });

/// Lowest bit of the number of finer neighbours in [`FaceSides::marks`].
const FINER: u32 = 4;

/// Lowest bit of the first inner edge in [`FaceSides::marks`].
const INNER: u32 = 8;

crate::wgsl::shared!(
    FACE_FINER = FINER,
    FACE_INNER = INNER,
    RIVER_TO_FIRST = Inner::RiverToFirst as u32,
    RIVER_TO_SECOND = Inner::RiverToSecond as u32,
    GULLY_TO_FIRST = Inner::GullyToFirst as u32,
    GULLY_TO_SECOND = Inner::GullyToSecond as u32,
);

/// The number is that of the split faces beside one that is not, which tells how many triangles it
/// becomes.
impl From<(&Face, &FaceSplit, u32)> for FaceSides {
    fn from((face, split, finer): (&Face, &FaceSplit, u32)) -> Self {
        let [a, b, c] = split.inner.map(|inner| inner as u32);
        let inner = a | b << 8 | c << 16;
        Self {
            edges: face.edges,
            marks: split.mark as u32 | finer << FINER | inner << INNER,
        }
    }
}

impl From<(&Face, &FaceSplit)> for FaceCorners {
    fn from((face, split): (&Face, &FaceSplit)) -> Self {
        let is_split = split.mark == SplitMark::Split;
        Self {
            vertices: face.vertices,
            child: if is_split { split.child } else { NONE },
        }
    }
}

impl From<(FaceSides, FaceCorners)> for Face {
    fn from((sides, corners): (FaceSides, FaceCorners)) -> Self {
        Self {
            vertices: corners.vertices,
            edges: sides.edges,
        }
    }
}

/// The first child of a face that has none is 0.
impl From<(FaceSides, FaceCorners)> for FaceSplit {
    fn from((FaceSides { marks, .. }, corners): (FaceSides, FaceCorners)) -> Self {
        let is_split = corners.child != NONE;
        Self {
            child: if is_split { corners.child } else { 0 },
            inner: [0, 8, 16].map(|shift| inner((marks >> (INNER + shift)) as u8)),
            mark: SplitMark::from_number(marks as u8 & 15),
        }
    }
}

/// The drainage of a number; none for a number that stands for none.
const fn inner(number: u8) -> Inner {
    match number {
        1 => Inner::RiverToFirst,
        2 => Inner::RiverToSecond,
        3 => Inner::GullyToFirst,
        4 => Inner::GullyToSecond,
        _ => Inner::Terrain,
    }
}
