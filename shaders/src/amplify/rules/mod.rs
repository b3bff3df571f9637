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

pub mod edge_kind;
pub mod nodes;
pub mod noise;
pub mod preset;
pub mod vertex_ground;

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
pub use edge_kind::EdgeKind;
use lake::{LakeEdge, Lifted};
pub use preset::{Rules, STRAIGHT_LEVEL};
pub use vertex_ground::VertexGround;

/// The ground of the vertex that halves an edge: picks the rule by the configuration (kind, edge,
/// kind).
pub fn halve(rules: &Rules, edge: EdgeKind, context: &EdgeContext) -> VertexGround {
    if !rules.landforms || context.new.lake == 0 {
        return graph(rules, edge, context);
    }
    match LakeEdge::of(edge, context) {
        LakeEdge::Floor => lake::of_kind(edge, lake::floor(rules, edge, context)),
        LakeEdge::Inflow => lake::inflow(context),
        LakeEdge::Shore => lake::of_kind(edge, lake::shore(rules, context)),
        LakeEdge::Away => graph(rules, edge, context),
        LakeEdge::Beside => {
            let lifted = Lifted::of(context);
            let ground = beside_lake(rules, edge, &lifted.context(context));
            lake::beside(context, ground)
        }
    }
}

/// The same of an edge beside a lake, at whose level its ends stand.
fn beside_lake(rules: &Rules, edge: EdgeKind, context: &EdgeContext) -> VertexGround {
    if context.a.kind == VertexKind::Lake || context.b.kind == VertexKind::Lake {
        // Between two waters, or over a valley that lies lower than the lake.
        lake::of_kind(edge, crest::between_rivers(rules, context))
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
