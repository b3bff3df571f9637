//! Lakes: their shores and floors, and rivers that widen to new ones (paper 002 §5.3, Figs. 14, 15;
//! rule R3 with a lake).
//!
//! In ours a shore is a contour of the ground at the lake's level (`shore`). Dry ground beside a
//! lake never lies below it: where the land does, the ground is made as if its ends stood at the
//! lake's level, a sill as wide as the edge. So every lake has one level, and no walls.

pub(in crate::amplify) mod new;
pub(in crate::amplify) mod shore;

use super::crest;
use super::edge_kind::EdgeKind;
use super::preset::Rules;
use super::valley::Carved;
use super::vertex_ground::VertexGround;
use crate::amplify::control::VertexKind;
use crate::amplify::vertex::{EdgeContext, Vertex};
pub use new::{chance, widened};
pub(super) use shore::{floor, shore};

crate::wgsl::shared!(
    LAKE_FLOOR = LakeEdge::Floor as u32,
    LAKE_INFLOW = LakeEdge::Inflow as u32,
    LAKE_SHORE = LakeEdge::Shore as u32,
    LAKE_AWAY = LakeEdge::Away as u32,
    LAKE_BESIDE = LakeEdge::Beside as u32,
);

/// Print and release: the floor between two vertices of one lake, or a crest between two lakes.
pub fn between(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let (a, b) = (context.a, context.b);
    if a.lake != b.lake || a.water != b.water {
        return crest::between_rivers(rules, context);
    }
    under(a.bed + (b.bed - a.bed) / 2, a.water)
}

/// How an edge in or beside a lake gets its vertex, in ours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LakeEdge {
    /// Under its water.
    Floor,
    /// Along a river that flows into it.
    Inflow,
    /// Between it and land that is not lower.
    Shore,
    /// As if there were no lake: along a river that goes on.
    Away,
    /// On the land beside it.
    Beside,
}

impl LakeEdge {
    /// That of an edge of a kind whose new vertex knows a lake.
    pub(super) fn of(edge: EdgeKind, context: &EdgeContext) -> Self {
        let level = context.new.lake_level;
        let is_lake = |v: &Vertex| v.kind == VertexKind::Lake && v.water == level;
        let is_level = |v: &Vertex| v.is_wet() && v.water == level;
        let (a, b) = (context.a, context.b);
        if (is_lake(a) && is_level(b)) || (is_lake(b) && is_level(a)) {
            return Self::Floor;
        }
        if edge == EdgeKind::River {
            return if is_lake(b) && a.is_wet() {
                Self::Inflow
            } else {
                Self::Away
            };
        }
        let land = if is_lake(a) { b } else { a };
        let has_shore = is_lake(a) || is_lake(b);
        if has_shore && !land.is_wet() && land.height >= level {
            Self::Shore
        } else {
            Self::Beside
        }
    }
}

/// A river that flows into a lake: the lake reaches as far up its valley as the river's bed lies
/// below it.
pub(super) fn inflow(context: &EdgeContext) -> VertexGround {
    let (river, lake) = (context.a, context.b);
    let level = lake.water;
    let bed = river.bed + (lake.bed - river.bed) / 2;
    let water = bed + (river.water - river.bed).max(0);
    if water <= level {
        return under(bed, level);
    }
    VertexGround {
        kind: VertexKind::River,
        height: bed,
        bed,
        water: water.min(river.water),
    }
}

/// The ground beside a lake: dry where `ground` that was made with its ends at the lake's level
/// lies below it.
pub(super) fn beside(context: &EdgeContext, ground: VertexGround) -> VertexGround {
    let level = context.new.lake_level;
    let is_dry = !matches!(
        ground.kind,
        VertexKind::Sea | VertexKind::River | VertexKind::Lake
    );
    if is_dry && ground.height <= level {
        // A hollow under the level becomes a rise over it.
        let height = level + 1 + (level - ground.height) / 4;
        return VertexGround::dry(ground.kind, height);
    }
    ground
}

/// The ends of an edge, and the height of its face, raised to the level of a lake.
pub(super) struct Lifted {
    a: Vertex,
    b: Vertex,
    face: i32,
}

impl Lifted {
    /// Those of an edge, which then stand at the lake's level at least, or at their water.
    pub(super) fn of(context: &EdgeContext) -> Self {
        let level = context.new.lake_level;
        let [a, b] = [context.a, context.b].map(|end| lifted(end, level));
        Self {
            face: context.face.max(a.height.min(b.height)),
            a,
            b,
        }
    }

    /// The edge with these ends.
    pub(super) fn context<'a>(&'a self, of: &EdgeContext<'a>) -> EdgeContext<'a> {
        EdgeContext {
            a: &self.a,
            b: &self.b,
            face: self.face,
            ..*of
        }
    }
}

/// An end of an edge beside a lake of a level.
fn lifted(end: &Vertex, level: i32) -> Vertex {
    match end.kind {
        VertexKind::Sea | VertexKind::Coast => *end,
        _ => Vertex {
            height: end.height.max(level).max(end.water),
            ..*end
        },
    }
}

/// Dry ground on a gully's edge is a gully.
pub(super) fn of_kind(edge: EdgeKind, ground: VertexGround) -> VertexGround {
    if edge == EdgeKind::Gully && ground.kind == VertexKind::Terrain {
        return VertexGround::dry(VertexKind::Gully, ground.height);
    }
    ground
}

/// A lake's floor under its water, grains: a grain below it at least.
fn under(bed: i32, water: i32) -> VertexGround {
    let bed = bed.min(water - 1);
    VertexGround {
        kind: VertexKind::Lake,
        height: bed,
        bed,
        water,
    }
}

/// Ground and water beside a lake: the lake's level goes on under its shore, and no valley is cut
/// below it.
pub fn held(vertex: &Vertex, carved: Carved) -> Carved {
    let is_river = carved.is_wet() || vertex.is_wet();
    if vertex.lake == 0 || is_river || vertex.kind == VertexKind::Sea {
        return carved;
    }
    Carved {
        ground: carved.ground.max(vertex.lake_level),
        water: vertex.lake_level,
    }
}
