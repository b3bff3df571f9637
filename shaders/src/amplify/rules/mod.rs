//! The rules that give a new vertex its ground: paper 002 §5.2, §5.3, §6 and Appendix A; paper 000
//! §5 for the ocean.
//!
//! Pure functions of grains, shares in Q16 and seeds, in the 32-bit operations that WGSL has.
//! [`halve`] picks the compute graph by the edge's configuration; each graph has its file. No rule
//! reads anything finer than the edge, so no view changes a bit of its result.
//!
//! Constants are in the units of [`fixed`](super::fixed); "release" names the source that the
//! authors of paper 002 published, numbers without a source are chosen here by eye and by the
//! statistics of real relief.

pub mod nodes;
pub mod noise;
pub mod preset;

pub mod ocean;

pub mod coarse;
pub mod coast;
pub mod crest;
pub mod divide;
pub mod edge_land;
pub mod estuary;
pub mod fine;
pub mod fold;
pub mod gully;
pub mod lake;
pub mod landform;
pub mod meander;
pub mod rise;
pub mod river;
pub mod shift;
pub mod slope;
pub mod terrain;
pub mod threshold;

pub mod valley;

use super::control::VertexKind;
use super::vertex::EdgeContext;
pub use preset::Rules;

/// First level whose edges stay straight and whose faces decide nothing: a vertex then follows from
/// its parents alone, but for a river beside it. Its edges are 25 m long on an Earth-sized planet.
pub const STRAIGHT_LEVEL: u32 = 11;

/// First level, in our rules, at which a vertex lies on the face where it was moved to, not at its
/// edge's height: edges of 800 m and less on an Earth-sized planet, the size of a hillside. An even
/// slope stays even under sideways moves.
const FACE_LEVEL: u32 = 6;

/// Kind of an edge (the paper's edge types R and T; gullies have their own).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum EdgeKind {
    /// Ground.
    #[default]
    Terrain = 0,
    /// A river runs along it, from the first end to the second.
    River = 1,
    /// A dry drainage line runs along it, from the first end to the second.
    Gully = 2,
}

/// The ground that a rule gives to a new vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexGround {
    /// Kind of the vertex.
    pub kind: VertexKind,
    /// Ground, grains.
    pub height: i32,
    /// River bed or lake floor, grains; equals `height` at dry vertices.
    pub bed: i32,
    /// Water surface, grains; equals `bed` at dry vertices.
    pub water: i32,
}

impl VertexGround {
    /// Dry ground of one kind.
    #[inline]
    pub const fn dry(kind: VertexKind, height: i32) -> Self {
        Self {
            kind,
            height,
            bed: height,
            water: height,
        }
    }
}

/// The ground of the vertex that halves an edge: picks the rule by the configuration (kind, edge,
/// kind).
pub fn halve(rules: &Rules, edge: EdgeKind, context: &EdgeContext) -> VertexGround {
    if rules.landforms && context.new.lake != 0 {
        lake::halve(rules, edge, context)
    } else {
        graph(rules, edge, context)
    }
}

/// The same where no lake is near.
fn graph(rules: &Rules, edge: EdgeKind, context: &EdgeContext) -> VertexGround {
    use VertexKind::{Coast, Gully, Lake, River, Sea};
    let (a, b) = (context.a.kind, context.b.kind);
    match edge {
        EdgeKind::River => return river::halve(rules, context),
        // Into the sea a gully of ours runs no farther than the shore.
        EdgeKind::Gully if rules.landforms && coast::is_shore(a, b) => {}
        EdgeKind::Gully => return gully::along(rules, context),
        EdgeKind::Terrain => {}
    }
    match (a, b) {
        (Sea, _) | (_, Sea) | (Coast, Coast) => coast::halve(rules, context),
        _ if rules.landforms && coast::is_shore(a, b) => coast::halve(rules, context),
        (Lake, Lake) => lake::between(rules, context),
        (River | Lake, River | Lake) => crest::between_rivers(rules, context),
        (River | Lake, _) | (_, River | Lake) => {
            lake::widened(rules, context).unwrap_or_else(|| slope::from_river(rules, context))
        }
        _ if context.level >= rules.fine_level => fine::halve(rules, context),
        (Gully, Gully) => crest::between_gullies(rules, context),
        (Gully, _) | (_, Gully) => slope::from_gully(rules, context),
        _ => terrain::halve(rules, context),
    }
}

#[cfg(test)]
mod graph_tests;
#[cfg(test)]
mod preset_tests;
