//! The rows of a vertex: numbers of 16 bits are two in a word, the first in its lower half.

use super::row;
use crate::amplify::control::VertexKind;
use crate::amplify::rules::valley::Carved;
use crate::amplify::vertex::{RiverSegment, Vertex};

/// Where a vertex is, how high, its seed and its water.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct VertexCore {
    /// Unit direction, as [`Vertex::direction`].
    pub direction: [i32; 3],
    /// Ground above sea level before carving, grains.
    pub height: i32,
    /// Seed of its random numbers.
    pub seed: u32,
    /// River bed or lake floor, grains.
    pub bed: i32,
    /// Water surface, grains.
    pub water: i32,
    /// Discharge, as [`Vertex::discharge`].
    pub discharge: u32,
}

row!(VertexCore {
    direction,
    height,
    seed,
    bed,
    water,
    discharge,
});

impl From<&Vertex> for VertexCore {
    fn from(vertex: &Vertex) -> Self {
        Self {
            direction: vertex.direction,
            height: vertex.height,
            seed: vertex.seed,
            bed: vertex.bed,
            water: vertex.water,
            discharge: vertex.discharge,
        }
    }
}

/// How a river runs through a vertex, and what the vertex was before the faces beside it settled it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct VertexCourse {
    /// Crust elevation, grains.
    pub crust: i32,
    /// The first two components of the heading.
    pub heading: u32,
    /// The third, and the tide.
    pub heading_tide: u32,
    /// The winding, and from bit 16 kind (3 bits), level (5), valley (2), and whether a valley leads
    /// down.
    pub winding_marks: u32,
}

row!(VertexCourse {
    crust,
    heading,
    heading_tide,
    winding_marks,
});

/// The land at a vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct VertexLand {
    /// Relief of the sea floor, grains: of vertices of level 0, too.
    pub swell: i32,
    /// Number of its lake.
    pub lake: u32,
    /// Level of its lake, grains.
    pub lake_level: i32,
    /// [`Vertex::worn`] and [`Vertex::collision`].
    pub worn_collision: u32,
    /// [`Vertex::wetness`] and [`Vertex::plateau`].
    pub wetness_plateau: u32,
    /// [`Vertex::hills`] and [`Vertex::oceanic`].
    pub hills_oceanic: u32,
    /// [`Vertex::ocean_age`] and the fold's first component.
    pub ocean_age_fold: u32,
    /// The fold's other components.
    pub fold: u32,
    /// The first two components of the ridge.
    pub ridge: u32,
    /// The third.
    pub ridge_end: u32,
}

row!(VertexLand {
    swell,
    lake,
    lake_level,
    worn_collision,
    wetness_plateau,
    hills_oceanic,
    ocean_age_fold,
    fold,
    ridge,
    ridge_end,
});

/// The river that is nearest to a vertex, and what the faces beside the vertex settled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct VertexRiver {
    /// Directions of the segment's ends.
    pub ends: [[i32; 3]; 2],
    /// Headings at both ends.
    pub headings: [u32; 3],
    /// Water at the ends, grains.
    pub water: [i32; 2],
    /// Flow at the ends.
    pub flow: u32,
    /// Tide at the ends.
    pub tide: u32,
    /// Waves at the ends.
    pub waves: u32,
    /// Winding at the ends.
    pub winding: u32,
    /// Birth (bits 0 to 4) and level (5 to 9) of the segment, whether it is a lake (10); kind of the
    /// vertex (11 to 13), whether a river branches there (14), whether the segment is its own (15),
    /// whether a valley leads down from it (16).
    pub marks: u32,
    /// Distance to the river, grains.
    pub distance: i32,
    /// Where along the segment that is, Q16.
    pub along: i32,
    /// Height of the valley's side, grains.
    pub section_height: i32,
    /// Share of the ground's own height, Q16.
    pub section_own: i32,
}

row!(VertexRiver {
    ends,
    headings,
    water,
    flow,
    tide,
    waves,
    winding,
    marks,
    distance,
    along,
    section_height,
    section_own,
});

row!(Carved { ground, water });

/// Lowest bits of the kind, the level and the valley in [`VertexCourse::winding_marks`], and the bit
/// of a vertex from which a valley leads down.
const COURSE: [u32; 4] = [16, 19, 24, 26];

/// Lowest bit of the segment's level in [`VertexRiver::marks`], and the bit of a lake.
const SEGMENT: [u32; 2] = [5, 10];

/// Lowest bit of the kind in [`VertexRiver::marks`], and the bits of a branched vertex, of one whose
/// segment is its own, and of one from which a valley leads down.
const RIVER: [u32; 4] = [11, 14, 15, 16];

crate::wgsl::shared!(
    COURSE_KIND = COURSE[0],
    COURSE_LEVEL = COURSE[1],
    COURSE_VALLEY = COURSE[2],
    COURSE_DRAINED = COURSE[3],
    SEGMENT_LEVEL = SEGMENT[0],
    SEGMENT_LAKE = SEGMENT[1],
    RIVER_KIND = RIVER[0],
    RIVER_BRANCHED = RIVER[1],
    RIVER_KEEPS_COURSE = RIVER[2],
    RIVER_DRAINED = RIVER[3],
);

/// A word of two numbers of 16 bits.
fn packed([low, high]: [u16; 2]) -> u32 {
    u32::from(low) | u32::from(high) << 16
}

/// The same of signed ones.
fn packed_signed(pair: [i16; 2]) -> u32 {
    packed(pair.map(|number| number as u16))
}

/// With the kind that the vertex had before the faces beside it settled it.
impl From<(&Vertex, VertexKind)> for VertexCourse {
    fn from((vertex, kind): (&Vertex, VertexKind)) -> Self {
        let [x, y, z] = vertex.heading;
        let numbers = [kind as u32, vertex.level.into(), vertex.valley.into()];
        let marks =
            (numbers[0] << COURSE[0]) | (numbers[1] << COURSE[1]) | (numbers[2] << COURSE[2]);
        Self {
            crust: vertex.crust,
            heading: packed_signed([x, y]),
            heading_tide: packed([z as u16, vertex.tide]),
            winding_marks: packed_signed([vertex.winding, 0])
                | marks
                | u32::from(vertex.is_drained) << COURSE[3],
        }
    }
}

/// With the relief of the sea floor there.
impl From<(&Vertex, i32)> for VertexLand {
    fn from((vertex, swell): (&Vertex, i32)) -> Self {
        let [fold, ridge] = [vertex.fold, vertex.ridge];
        Self {
            swell,
            lake: vertex.lake,
            lake_level: vertex.lake_level,
            worn_collision: packed([vertex.worn, vertex.collision]),
            wetness_plateau: packed([vertex.wetness, vertex.plateau]),
            hills_oceanic: packed([vertex.hills, vertex.oceanic]),
            ocean_age_fold: packed([vertex.ocean_age, fold[0] as u16]),
            fold: packed_signed([fold[1], fold[2]]),
            ridge: packed_signed([ridge[0], ridge[1]]),
            ridge_end: packed_signed([ridge[2], 0]),
        }
    }
}

impl From<&Vertex> for VertexRiver {
    fn from(vertex: &Vertex) -> Self {
        let segment = &vertex.river;
        let [from, to] = segment.headings;
        Self {
            ends: segment.ends,
            headings: [[from[0], from[1]], [from[2], to[0]], [to[1], to[2]]].map(packed_signed),
            water: segment.water,
            // A root of 32 bits.
            flow: packed(segment.flow.map(|flow| flow as u16)),
            tide: packed(segment.tide),
            waves: packed(segment.waves),
            winding: packed_signed(segment.winding),
            marks: segment_marks(segment) | vertex_marks(vertex),
            distance: vertex.river_distance,
            along: vertex.river_along,
            section_height: vertex.section.height,
            section_own: vertex.section.own,
        }
    }
}

/// The bits of a segment in [`VertexRiver::marks`].
fn segment_marks(segment: &RiverSegment) -> u32 {
    u32::from(segment.birth)
        | u32::from(segment.level) << SEGMENT[0]
        | u32::from(segment.is_lake) << SEGMENT[1]
}

/// The bits of a vertex there.
fn vertex_marks(vertex: &Vertex) -> u32 {
    (vertex.kind as u32) << RIVER[0]
        | u32::from(vertex.branched) << RIVER[1]
        | u32::from(vertex.keeps_course) << RIVER[2]
        | u32::from(vertex.is_drained) << RIVER[3]
}
