//! Lakes have one level each, shores that hold it, and no steps.

use super::*;
use crate::amplify::carve::{Carved, carve_all};
use crate::amplify::control::{ControlMesh, ControlVertex};
use crate::amplify::fixed::{difference, metres};
use crate::amplify::local::LocalGround;
use crate::amplify::rules::EdgeKind;
use crate::amplify::topology::{Edge, SplitMark, gather};
use std::collections::{BTreeMap, BTreeSet};

/// A small planet with lakes that rivers enter and leave, and with some in dry hollows.
fn planet() -> Base {
    let mut mesh = control_mesh(300_000, 4, 7);
    for (v, around) in neighbours(&mesh).into_iter().enumerate() {
        let surface = |&w: &usize| mesh.vertices[w].height.max(mesh.vertices[w].water);
        let lowest = around.iter().map(surface).min().unwrap();
        let vertex = &mesh.vertices[v];
        // On every river and in every eighth hollow, but none beside another or the sea.
        let is_river = vertex.kind == VertexKind::River as u8;
        let is_hollow = vertex.kind == VertexKind::Terrain as u8 && v % 8 == 0;
        let by_lake = around
            .iter()
            .any(|&w| mesh.vertices[w].kind == VertexKind::Lake as u8);
        if by_lake || lowest <= 0 || !(is_river || is_hollow) {
            continue;
        }
        let level = if is_river { vertex.water } else { lowest };
        flood(&mut mesh.vertices[v], level, metres(10 + v as i32 % 50));
    }
    Base::new(&mesh).unwrap()
}

/// Vertices that share an edge with each vertex.
fn neighbours(mesh: &ControlMesh) -> Vec<Vec<usize>> {
    let mut around = vec![Vec::new(); mesh.vertices.len()];
    for edge in &mesh.edges {
        let [a, b] = edge.vertices.map(|v| v as usize);
        around[a].push(b);
        around[b].push(a);
    }
    around
}

/// Makes a vertex a lake of a depth.
fn flood(vertex: &mut ControlVertex, level: i32, depth: i32) {
    vertex.kind = VertexKind::Lake as u8;
    vertex.water = level;
    vertex.bed = level - depth;
    vertex.height = vertex.bed;
}

/// Views of lakes from 100 m under the default rules, where lakes are frequent.
fn lake_views(base: &Base) -> impl Iterator<Item = RefinedGround> {
    let rules = Rules {
        lake_chance: 4 * Rules::default().lake_chance,
        ..Rules::default()
    };
    (0..24).map(move |k| {
        let at = if k % 4 == 0 {
            on_river(base, k)
        } else {
            on_lake(base, k)
        };
        refine(base, &rules, &camera(at, 100, 14), &Caps::default())
    })
}

/// The direction of a place between a random lake vertex and a vertex beside it.
fn on_lake(base: &Base, k: u32) -> [i32; 3] {
    let shores: Vec<&Edge> = base
        .level
        .edges
        .iter()
        .filter(|e| is_shore(base, e))
        .collect();
    let shore = shores[pcg(k) as usize % shores.len()];
    let [a, b] = gather(&base.vertices, shore.vertices);
    unit([0, 1, 2].map(|i| f64::from(a.direction[i]) + f64::from(b.direction[i])))
}

fn is_shore(base: &Base, edge: &Edge) -> bool {
    let [a, b] = gather(&base.vertices, edge.vertices);
    is_lake(a) != is_lake(b)
}

fn is_lake(vertex: &Vertex) -> bool {
    vertex.kind == VertexKind::Lake
}

fn is_dry(vertex: &Vertex) -> bool {
    use VertexKind::{Coast, Gully, Terrain};
    matches!(vertex.kind, Terrain | Gully | Coast)
}

/// Edges of the finest level of each place: those that are drawn.
fn drawn(ground: &RefinedGround) -> impl Iterator<Item = (usize, &Edge)> {
    let levels = ground.levels.iter().enumerate();
    levels.flat_map(|(index, level)| {
        let leaves = level.edges().filter(|(_, s)| s.mark == SplitMark::Leaf);
        leaves.map(move |(edge, _)| (index, edge))
    })
}

/// The surface over any triangle with a lake's corner is level, over its dry corners too.
#[test]
fn surfaces_are_level() {
    let base = planet();
    let [mut wet, mut shores] = [0, 0];
    for ground in lake_views(&base) {
        let carved = carve_all(&ground.scale, &Rules::default(), &ground.vertices);
        for triangle in ground.triangles() {
            let corners = ground.vertices.gather(triangle.vertices);
            let [ground, water] = columns(gather(&carved, triangle.vertices));
            let Some(k) = corners.iter().position(|v| is_lake(v)) else {
                continue;
            };
            for j in (0..3).filter(|&j| !corners[j].is_wet()) {
                // Corners of coarser levels may know no lake, or a higher one, and rivers leave.
                let is_shore = corners[j].lake == corners[k].lake && is_dry(corners[j]);
                if is_shore && (water[j] <= ground[j]) {
                    assert_eq!(water[j], water[k], "{:?} {:?}", corners[j], corners[k]);
                    shores += 1;
                }
            }
            for j in (0..3).filter(|&j| is_lake(corners[j])) {
                assert_eq!(water[j], water[k], "{:?} {:?}", corners[j], corners[k]);
                wet += 1;
            }
        }
    }
    assert!(wet > 20_000 && shores > 2_000, "{wet} {shores}");
}

/// Heights of ground and of water.
fn columns(corners: [&Carved; 3]) -> [[i32; 3]; 2] {
    [corners.map(|c| c.ground), corners.map(|c| c.water)]
}

/// Over a box of a lake all wet points have one level, at every level of a query.
#[test]
fn queries_find_one_level() {
    let base = planet();
    let mut points = 0;
    for k in 0..12 {
        let at = on_lake(&base, k);
        let mut levels: BTreeMap<u32, BTreeSet<i32>> = BTreeMap::new();
        for level in [4, 8, 12, 16] {
            let mut local = LocalGround::new(&base, &Rules::default());
            for i in 0..100 {
                let step = [i % 10 - 5, i / 10 - 5, 0].map(|s| f64::from(s) * 300_000.0);
                let p = unit([0, 1, 2].map(|i| f64::from(at[i]) + step[i]));
                let leaf = local.leaf(p, level, None);
                for (vertex, carved) in leaf.vertices.iter().zip(leaf.carved) {
                    if is_lake(vertex) {
                        levels.entry(vertex.lake).or_default().insert(carved.water);
                        points += 1;
                    }
                }
            }
        }
        for (lake, levels) in levels {
            assert_eq!(levels.len(), 1, "{lake} {levels:?}");
        }
    }
    assert!(points > 2_000, "{points}");
}

/// Dry ground beside a lake stands at its level at least, and no other lake touches it.
#[test]
fn shores_hold_their_lake() {
    let base = planet();
    let [mut shores, mut inside] = [0, 0];
    for ground in lake_views(&base) {
        let carved = carve_all(&ground.scale, &Rules::default(), &ground.vertices);
        for (level, edge) in drawn(&ground).filter(|(level, _)| *level > 0) {
            let [a, b] = ground.vertices.gather(edge.vertices);
            if is_lake(a) && is_lake(b) {
                assert_eq!((a.lake, a.water), (b.lake, b.water), "{level} {a:?} {b:?}");
                inside += 1;
            }
            let [g, h] = gather(&carved, edge.vertices);
            for (lake, shore, there) in [(a, b, h), (b, a, g)] {
                if is_lake(lake) && is_dry(shore) {
                    // It may lie in the bed of a river that flows in or out.
                    let holds = there.ground >= lake.water || there.water > there.ground;
                    assert!(holds, "{level} {there:?} {lake:?} {shore:?}");
                    shores += 1;
                }
            }
        }
    }
    assert!(shores > 2_000 && inside > 10_000, "{shores} {inside}");
}

/// Rivers enter a lake from above it and leave it below.
#[test]
fn rivers_enter_and_leave_at_the_level() {
    let base = planet();
    let [mut into, mut out] = [0, 0];
    for ground in lake_views(&base) {
        let edges = ground.levels.iter().flat_map(|level| &level.mesh.edges);
        for edge in edges.filter(|e| e.kind == EdgeKind::River) {
            let [up, down] = ground.vertices.gather(edge.vertices);
            if up.is_wet() && is_lake(down) {
                assert!(up.water >= down.water, "{up:?} {down:?}");
                into += u32::from(!is_lake(up));
            } else if is_lake(up) && down.is_wet() {
                assert!(up.water >= down.water, "{up:?} {down:?}");
                out += 1;
            }
        }
    }
    assert!(into > 20 && out > 5, "{into} {out}");
}

/// No wall stands at a shore: it is no steeper than the land.
#[test]
fn shores_have_no_steps() {
    let base = planet();
    let [mut shores, mut land] = [const { Vec::new() }; 2];
    for ground in lake_views(&base) {
        let carved = carve_all(&ground.scale, &Rules::default(), &ground.vertices);
        for (_, edge) in drawn(&ground).filter(|(level, _)| *level > 6) {
            let [a, b] = ground.vertices.gather(edge.vertices);
            let [g, h] = gather(&carved, edge.vertices).map(|c| c.ground);
            let length = ground.scale.grains(difference(b.direction, a.direction));
            let slope = f64::from((g - h).abs()) / f64::from(length.max(1));
            if is_dry(a) && is_dry(b) {
                land.push(slope);
            } else if is_lake(a) != is_lake(b) && (is_dry(a) || is_dry(b)) {
                shores.push(slope);
            }
        }
    }
    let counts = [shores.len(), land.len()];
    let [shores, land] =
        [shores, land].map(|slopes| [percentile(&slopes, 50), percentile(&slopes, 99)]);
    assert!(counts[0] > 1_000, "{counts:?} {shores:?} {land:?}");
    assert!(shores[1] < 1.5 * land[1], "{shores:?} {land:?}");
}

fn percentile(values: &[f64], percent: usize) -> f64 {
    let mut values = values.to_vec();
    values.sort_by(f64::total_cmp);
    values[(values.len() - 1) * percent / 100]
}
