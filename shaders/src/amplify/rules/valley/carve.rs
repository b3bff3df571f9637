//! Final ground and water of a vertex.

use super::plain::{PlainCache, flood_plain, smooth_max};
use super::reach::Reach;
use super::section::width;
use crate::amplify::arith::mix;
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::metres;
use crate::amplify::rules::{Rules, ocean};
use crate::amplify::scale::PlanetScale;
use crate::amplify::vertex::{FAR, ValleySection, Vertex};
use ocean::OceanCache;

/// Level of the water where there is none near: far below any ground, grains.
pub const NO_WATER: i32 = metres(-900_000);

/// Half-beds from the middle of a river up to which ground knows its water.
const KNOWN_WATER: i32 = 2;

/// Most width of the round edge between a flood plain and its valley's side, in height; grains.
const ROUND_EDGE: i32 = metres(2);

/// That edge grows with the distance from the bed, 1 in 4: at the bed's rim there is none.
const EDGE_GROWTH: i32 = 4;

/// Half-beds from the bed's rim up to which no land lies lower than the flood plain: as far as
/// rivers wind.
const PLAIN_WIDTH: i32 = 10;

/// From there on land may lie lower, by 1 in 40 of the distance.
const LOW_LAND_SLOPE: i32 = 40;

crate::wgsl::shared!(
    NO_WATER,
    KNOWN_WATER,
    ROUND_EDGE,
    EDGE_GROWTH,
    PLAIN_WIDTH,
    LOW_LAND_SLOPE,
);

/// Ground and water after carving.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct Carved {
    /// Ground, grains.
    pub ground: i32,
    /// Level of the water, grains: also where it lies under dry ground beside its river, its lake
    /// or the sea; [`NO_WATER`] away from them.
    pub water: i32,
}

impl Carved {
    /// Dry ground away from all water, grains.
    pub const fn dry(ground: i32) -> Self {
        Self {
            ground,
            water: NO_WATER,
        }
    }

    /// Whether the ground lies under water.
    pub const fn is_wet(&self) -> bool {
        self.water > self.ground
    }
}

/// Noise drawn for an earlier vertex. It saves work and changes no result.
#[derive(Clone, Debug, Default)]
pub struct CarveCache {
    ocean: OceanCache,
    plain: PlainCache,
}

/// The ground of a vertex after its river has carved it. `cache` is shared by the vertices of a
/// patch.
pub fn carve(
    cache: &mut CarveCache,
    scale: &PlanetScale,
    rules: &Rules,
    vertex: &Vertex,
) -> Carved {
    if vertex.kind == VertexKind::River {
        let reach = Reach::of(scale, rules, vertex);
        // It may wind past a vertex of its own.
        if vertex.river_distance <= reach.half_bed {
            return in_river(&reach, vertex);
        }
    }
    let knows_river = vertex.river_distance < FAR;
    match vertex.kind {
        VertexKind::Lake => Carved {
            ground: vertex.bed.min(vertex.water),
            water: vertex.water,
        },
        _ if is_under_sea(vertex) => {
            // Relief that would emerge is held under the sea by its own bounds.
            let edge = scale.edge_grains(0);
            let floor = vertex.height + ocean::relief(&mut cache.ocean, vertex, edge);
            let river = knows_river.then(|| Reach::of(scale, rules, vertex));
            Carved {
                ground: floor.min(river.map_or(floor, |reach| under_sea(&reach, vertex))),
                water: 0,
            }
        }
        VertexKind::Coast if !knows_river => Carved {
            ground: vertex.height,
            water: 0,
        },
        _ if !knows_river || vertex.river.flow == [0, 0] => Carved::dry(vertex.height),
        _ => beside(cache, scale, rules, vertex),
    }
}

/// Whether the sea covers a vertex: coasts of ours stand at any height.
fn is_under_sea(vertex: &Vertex) -> bool {
    vertex.kind == VertexKind::Sea || vertex.kind == VertexKind::Coast && vertex.height < 0
}

/// A vertex of a river, in its own bed or in that of a larger river, whose water may stand higher
/// there.
fn in_river(reach: &Reach, vertex: &Vertex) -> Carved {
    let water = reach.water.min(vertex.water.max(vertex.bed));
    let distance = vertex.river_distance.min(reach.half_bed);
    Carved {
        ground: reach.bed(distance) - (reach.water - water),
        water,
    }
}

/// The bed that a river has on the floor of the sea, grains.
fn under_sea(reach: &Reach, vertex: &Vertex) -> i32 {
    if vertex.river_distance < reach.half_bed {
        reach.bed(vertex.river_distance)
    } else {
        vertex.height
    }
}

/// The ground beside a river.
fn beside(cache: &mut CarveCache, scale: &PlanetScale, rules: &Rules, vertex: &Vertex) -> Carved {
    let reach = Reach::of(scale, rules, vertex);
    let distance = vertex.river_distance;
    if distance < reach.half_bed {
        return Carved {
            ground: reach.bed(distance),
            water: reach.water,
        };
    }
    let valley = width(scale, vertex, &reach);
    let ground = dry_ground(cache, vertex, &reach, valley);
    if distance <= KNOWN_WATER * reach.half_bed {
        Carved {
            ground,
            water: reach.water,
        }
    } else {
        Carved::dry(ground)
    }
}

/// Height of the ground beyond a river's bed, grains; `valley` is the half-width of its valley.
fn dry_ground(cache: &mut CarveCache, vertex: &Vertex, reach: &Reach, valley: i32) -> i32 {
    let beyond = vertex.river_distance - reach.half_bed;
    let raw = vertex.height;
    // Far from the river land may lie lower than its plain.
    let low_land = (beyond - valley.min(PLAIN_WIDTH * reach.half_bed)).max(0) / LOW_LAND_SLOPE;
    let edge = ROUND_EDGE.min(beyond / EDGE_GROWTH);
    let ValleySection { height, own } = vertex.section;
    let plain_top = reach.water + 2 * reach.bank() - low_land;
    let least = mix(height.min(raw), raw, own);
    // High above the plain its relief does not show.
    if least > plain_top + edge {
        return least;
    }
    let distance = vertex.river_distance;
    let plain = flood_plain(&mut cache.plain, vertex.direction, reach, distance) - low_land;
    // The valley's side never raises ground above the land beside it.
    let side = mix(height.min(raw.max(plain)), raw, own);
    smooth_max(side, plain, edge)
}
