//! Lakes: their shores and floors, and rivers that widen to new ones (paper 002 §5.3, Figs. 14, 15;
//! rule R3 with a lake).
//!
//! In ours a shore is a contour of the ground at the lake's level (`shore`). Dry ground beside a
//! lake never lies below it: where the land does, the ground is made as if its ends stood at the
//! lake's level, a sill as wide as the edge. So every lake has one level, and no walls.

mod new;
mod shore;

use super::preset::Rules;
use super::valley::Carved;
use super::{EdgeKind, VertexGround, crest, graph};
use crate::amplify::control::VertexKind;
use crate::amplify::vertex::{EdgeContext, Vertex};
pub use new::{chance, widened};
use shore::{floor, shore};

/// Print and release: the floor between two vertices of one lake, or a crest between two lakes.
pub fn between(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let (a, b) = (context.a, context.b);
    if a.lake != b.lake || a.water != b.water {
        return crest::between_rivers(rules, context);
    }
    under(a.bed + (b.bed - a.bed) / 2, a.water)
}

/// Ours: the vertex of an edge in or beside a lake.
pub fn halve(rules: &Rules, edge: EdgeKind, context: &EdgeContext) -> VertexGround {
    let level = context.new.lake_level;
    let is_lake = |v: &Vertex| v.kind == VertexKind::Lake && v.water == level;
    let is_level = |v: &Vertex| v.is_wet() && v.water == level;
    let (a, b) = (context.a, context.b);
    if (is_lake(a) && is_level(b)) || (is_lake(b) && is_level(a)) {
        return of_kind(edge, floor(rules, edge, context));
    }
    if edge == EdgeKind::River {
        return if is_lake(b) && a.is_wet() {
            inflow(context)
        } else {
            graph(rules, edge, context)
        };
    }
    let (lake, land) = if is_lake(a) { (a, b) } else { (b, a) };
    if is_lake(lake) && !land.is_wet() && land.height >= level {
        return of_kind(edge, shore(rules, context, lake, land));
    }
    beside(rules, edge, context)
}

/// A river that flows into a lake: the lake reaches as far up its valley as the river's bed lies
/// below it.
fn inflow(context: &EdgeContext) -> VertexGround {
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

/// Beside a lake: the ground is made as if its ends stood at the lake's level at least.
fn beside(rules: &Rules, edge: EdgeKind, context: &EdgeContext) -> VertexGround {
    let level = context.new.lake_level;
    let ground = lifted(context, level, |lifted| {
        if lifted.a.kind == VertexKind::Lake || lifted.b.kind == VertexKind::Lake {
            // Between two waters, or over a valley that lies lower than the lake.
            of_kind(edge, crest::between_rivers(rules, lifted))
        } else {
            graph(rules, edge, lifted)
        }
    });
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

/// Runs a rule on an edge whose ends stand at a level at least, or at their water.
fn lifted<T>(context: &EdgeContext, level: i32, rule: impl FnOnce(&EdgeContext) -> T) -> T {
    let [a, b] = [context.a, context.b].map(|end| match end.kind {
        VertexKind::Sea | VertexKind::Coast => *end,
        _ => Vertex {
            height: end.height.max(level).max(end.water),
            ..*end
        },
    });
    rule(&EdgeContext {
        a: &a,
        b: &b,
        face: context.face.max(a.height.min(b.height)),
        ..*context
    })
}

/// Dry ground on a gully's edge is a gully.
fn of_kind(edge: EdgeKind, ground: VertexGround) -> VertexGround {
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
