//! A vertex of the ground with its attributes (paper 002 Table 1), and an edge that is split as the
//! rules see it.
//!
//! A vertex is made once, by the edge that it halves, from data of coarser levels; no view changes
//! a bit of it.

use super::arith::isqrt;
use super::control::{ControlVertex, VertexKind};
use super::fixed::{Q16, metres};
use super::seed::pcg;

/// A distance that means "nowhere near", grains.
pub const FAR: i32 = metres(2_000_000);

crate::wgsl::shared!(
    FAR,
    TERRAIN = VertexKind::Terrain as u32,
    SEA = VertexKind::Sea as u32,
    COAST = VertexKind::Coast as u32,
    RIVER = VertexKind::River as u32,
    LAKE = VertexKind::Lake as u32,
    GULLY = VertexKind::Gully as u32,
);

/// A piece of river. Vertices around it carry it by value, so that their distance to it is a true
/// one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct RiverSegment {
    /// Directions of its ends, upstream first, in units of 1 / `ONE` of the radius.
    pub ends: [[i32; 3]; 2],
    /// Headings of the river there, unit tangents times 32767; zero stands for the way from end to
    /// end.
    pub headings: [[i16; 3]; 2],
    /// Water surface at the ends, grains.
    pub water: [i32; 2],
    /// Flow φ at the ends, Q16; where an arm of a delta leaves its apex, the whole river's.
    pub flow: [i32; 2],
    /// Tides at the ends, as [`Vertex::tide`].
    pub tide: [u16; 2],
    /// Flow φ of the vertices at the ends, Q16: both pieces at a vertex have its waves.
    pub waves: [u16; 2],
    /// Windings at the ends, as [`Vertex::winding`].
    pub winding: [i16; 2],
    /// Level on which its river was born, 0 for one of the control mesh.
    pub birth: u8,
    /// Level of the edge it was.
    pub level: u8,
    /// Whether it is a lake from end to end, which has shores but no bed.
    pub is_lake: bool,
}

/// A valley's side at a place: its height, and how much of the ground that the graphs made is left.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct ValleySection {
    /// Height of the side, grains.
    pub height: i32,
    /// Share of the ground's own height, Q16: 0 on the valley's floor, 1 beyond its rim.
    pub own: i32,
}

impl ValleySection {
    /// Where there is no valley.
    #[inline]
    pub const fn outside(height: i32) -> Self {
        Self { height, own: Q16 }
    }

    /// Half-way between two places.
    #[inline]
    pub const fn between(a: Self, b: Self) -> Self {
        Self {
            height: a.height + (b.height - a.height) / 2,
            own: (a.own + b.own) / 2,
        }
    }
}

/// One vertex of the ground.
///
/// Most of its fields are a [`ControlVertex`]'s. It does not hold one: a control vertex is packed
/// for whoever bakes a planet, with its flow and its kind as plain numbers, and rules name the
/// fields that they read without a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct Vertex {
    /// Unit direction from the planet's centre, each component times `ONE`.
    pub direction: [i32; 3],
    /// Ground above sea level before carving, grains.
    pub height: i32,
    /// Seed of its random numbers.
    pub seed: u32,
    /// River bed or lake floor, grains; equals `height` at dry vertices.
    pub bed: i32,
    /// Water surface, grains; equals `bed` at dry vertices.
    pub water: i32,
    /// Discharge in 2⁻³² of 200,000 m³/s: an integer, so that junctions conserve it; 0 at dry
    /// vertices.
    pub discharge: u32,
    /// The nearest river's segment; meaningless where `river_distance` is [`FAR`].
    pub river: RiverSegment,
    /// Distance to `river`, grains; [`FAR`] without one.
    pub river_distance: i32,
    /// Where along `river` its nearest point lies, Q16 from the upstream end.
    pub river_along: i32,
    /// Where the river flows through a vertex of one, a unit tangent times 32767; else zero.
    pub heading: [i16; 3],
    /// The side of the river's valley here.
    pub section: ValleySection,
    /// The lake that it lies in or beside; 0 for none.
    pub lake: u32,
    /// Level of that lake, grains: dry ground beside a lake never lies below it.
    pub lake_level: i32,
    /// Crust elevation C above sea level, grains: the level that summits reach.
    pub crust: i32,
    /// Kind: ground, sea, coast, river, lake or gully.
    pub kind: VertexKind,
    /// Level that made it; 0 in the control mesh.
    pub level: u8,
    /// Valley archetype (e_r), a `ValleyShape`'s number.
    pub valley: u8,
    /// How much wider a river is here than its discharge makes it, in 256ths of an octave; see
    /// [`estuary`](super::rules::estuary).
    pub tide: u16,
    /// Whether a river or gully already branches here.
    pub branched: bool,
    /// Whether a valley leads down from it; so at every vertex of level 0.
    pub is_drained: bool,
    /// How far age has worn the land (A), Q16; see [`ControlVertex::worn`].
    pub worn: u16,
    /// How much the river winds here, Q15, and how it crosses its valley's axis: positive from the
    /// right to the left; see [`meander`](super::rules::meander).
    pub winding: i16,
    /// Whether `river` is the piece of its own river that it lies on, which finer levels keep.
    pub keeps_course: bool,
    /// Share of continental collision in the orogeny, Q16.
    pub collision: u16,
    /// Wetness W, Q16.
    pub wetness: u16,
    /// Plateau presence P, Q16.
    pub plateau: u16,
    /// Hill presence B, Q16.
    pub hills: u16,
    /// Share of oceanic crust, Q16.
    pub oceanic: u16,
    /// Age of the ocean floor, 1/64 My.
    pub ocean_age: u16,
    /// Relief of the sea floor before it fades towards the shore, grains; 0 at a vertex of level 0,
    /// which draws it when it is asked for. See [`ocean`](super::rules::ocean).
    pub swell: i32,
    /// Fold direction (undirected, tangent), components times 32767; zero where there is none.
    pub fold: [i16; 3],
    /// Ridge direction of the ocean floor (undirected, tangent), components times 32767; zero where
    /// there is none.
    pub ridge: [i16; 3],
}

impl Default for Vertex {
    fn default() -> Self {
        Self::from_control(&ControlVertex::default())
    }
}

impl Vertex {
    /// A vertex of level 0.
    pub fn from_control(control: &ControlVertex) -> Self {
        // The square of a whole 1, 65,536, would leave 32 bits.
        let flow = control.flow.min(0xffff);
        Self {
            direction: control.direction,
            height: control.height,
            seed: control.seed,
            bed: control.bed,
            water: control.water,
            discharge: flow * flow,
            river: RiverSegment::default(),
            river_distance: FAR,
            river_along: 0,
            heading: [0; 3],
            section: ValleySection::outside(control.height),
            lake: lake_number(control),
            lake_level: control.water,
            crust: control.crust,
            kind: VertexKind::from_number(control.kind),
            level: 0,
            valley: control.valley,
            tide: 0,
            branched: false,
            is_drained: true,
            worn: control.worn,
            winding: 0,
            keeps_course: false,
            collision: control.collision,
            wetness: control.wetness,
            plateau: control.plateau,
            hills: control.hills,
            oceanic: control.oceanic,
            ocean_age: control.ocean_age,
            swell: 0,
            fold: control.fold,
            ridge: control.ridge,
        }
    }

    /// Flow φ = sqrt(discharge / 200,000 m³/s), Q16.
    #[inline]
    pub fn flow(&self) -> i32 {
        isqrt(self.discharge) as i32
    }

    /// Height of its ground, or of the water that covers it; grains.
    #[inline]
    pub fn surface(&self) -> i32 {
        if self.is_wet() {
            self.water
        } else {
            self.height
        }
    }

    /// Whether it is a vertex of a river that lies in the bed of a larger one.
    #[inline]
    pub fn is_in_larger_river(&self) -> bool {
        let is_own = self.keeps_course || self.river.ends[0] == self.river.ends[1];
        self.kind == VertexKind::River && self.river_distance < FAR && !is_own
    }

    /// Whether water stands or runs here on land.
    #[inline]
    pub fn is_wet(&self) -> bool {
        matches!(self.kind, VertexKind::River | VertexKind::Lake)
    }
}

/// An edge as a vertex's rule sees it: its ends, and the vertex that halves it, which has
/// everything but its elevation.
#[derive(Clone, Copy, Debug)]
pub struct EdgeContext<'a> {
    /// One end; the upstream one of a river edge, the wet one of an edge between a river and land.
    pub a: &'a Vertex,
    /// The other end.
    pub b: &'a Vertex,
    /// The new vertex: displaced direction, seed, level (that of the edge + 1), distances to river
    /// and gully, the lake around it, and the parents' average of C, A, W, P, B, collision, ocean
    /// and directions.
    pub new: &'a Vertex,
    /// Height of the flat face where the new vertex lies, grains: the mean of the ends, but for the
    /// sideways displacement.
    pub face: i32,
    /// Lowest and highest ground of the corners of the faces beside the edge, grains; of its ends
    /// alone on levels that know no faces.
    pub range: [i32; 2],
    /// Whether no corner of the edge's faces lies below the water of its ends: there a new lake
    /// finds ground to hold it.
    pub is_dammed: bool,
    /// How far the ground beside the edge bends up: a quarter of the height of the opposite corners
    /// over the ends, grains.
    pub curvature: i32,
    /// The corners opposite to the edge, on levels that know them.
    pub beside: [Option<CornerBeside>; 2],
    /// Whether dry land drains along the edge without a gully.
    pub is_descent: bool,
    /// Length of the edge, grains.
    pub length: i32,
    /// Mean length of the edges of its level, grains.
    pub span: i32,
    /// Level of the edge, 0..16 (the paper's λ).
    pub level: u32,
    /// Radius of the planet, metres.
    pub radius_m: u32,
}

/// A corner of a face beside an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CornerBeside {
    /// Its ground, grains.
    pub height: i32,
    /// How far it is from the new vertex, grains.
    pub distance: i32,
}

/// The number of a control vertex's lake; 0 on dry land and in rivers. Vertices of a lake have its
/// level in common, so the level gives the number.
const fn lake_number(control: &ControlVertex) -> u32 {
    if control.kind == VertexKind::Lake as u8 {
        // Odd, so never the 0 of no lake.
        pcg(control.water as u32) | 1
    } else {
        0
    }
}

impl<'a> EdgeContext<'a> {
    /// The end that is wet, and the other: of an edge between water and land.
    pub fn wet_end_first(&self) -> (&'a Vertex, &'a Vertex) {
        if self.a.is_wet() {
            (self.a, self.b)
        } else {
            (self.b, self.a)
        }
    }
}
