//! Water runs downhill, discharge is conserved.

use super::*;
use crate::amplify::carve::carve_all;
use crate::amplify::rules::EdgeKind;
use crate::amplify::topology::{Edge, Level, NONE, SplitMark, gather};
use std::collections::BTreeMap;

/// Views of rivers from 100 m, under all presets.
fn river_views() -> impl Iterator<Item = RefinedGround> {
    let base = planet();
    [Rules::default(), Rules::PAPER, Rules::RELEASE]
        .into_iter()
        .flat_map(|rules| (0..8).map(move |k| (rules, k)))
        .map(move |(rules, k)| {
            let view = camera(on_river(&base, k), 100, 13);
            refine(&base, &rules, &view, &Caps::default())
        })
}

fn edges(ground: &RefinedGround) -> impl Iterator<Item = &Edge> {
    ground.levels.iter().flat_map(|level| &level.edges)
}

fn is_river(vertex: &Vertex) -> bool {
    vertex.kind == VertexKind::River
}

#[test]
fn water_runs_downhill() {
    let mut rivers = 0;
    for ground in river_views() {
        assert!(ground.vertices.iter().all(|v| v.water >= v.bed));
        for edge in edges(&ground).filter(|e| e.kind == EdgeKind::River) {
            let [up, down] = gather(&ground.vertices, edge.vertices);
            if !is_river(up) || !is_river(down) {
                continue;
            }
            assert!(
                up.bed >= down.bed && up.water >= down.water,
                "{up:?} {down:?}"
            );
            rivers += 1;
            if edge.mark == SplitMark::Split && up.bed >= down.bed + 2 {
                let mid = &ground.vertices[edge.mid as usize];
                let falls = up.bed > mid.bed && mid.bed > down.bed;
                assert!(falls || !is_river(mid), "{up:?} {mid:?} {down:?}");
            }
        }
    }
    assert!(rivers > 3000, "{rivers}");
}

/// Once carved, along every piece of river that is drawn, into lakes and the sea too: no water rises
/// downstream, and no bed but where it enters a lake. Neighbours may share a height, as the fall of
/// a slow river on fine edges is less than a grain.
#[test]
fn carved_water_runs_downhill() {
    let [mut rivers, mut mouths] = [0; 2];
    for ground in river_views() {
        let carved = carve_all(&ground.scale, &ground.vertices);
        let drawn = edges(&ground).filter(|e| e.mark != SplitMark::Split);
        for edge in drawn.filter(|e| e.kind == EdgeKind::River) {
            let [up, down] = gather(&ground.vertices, edge.vertices);
            let [above, below] = gather(&carved, edge.vertices);
            // No water comes from beyond a spring.
            if !is_river(up) {
                continue;
            }
            assert!(above.water >= below.water, "{up:?} {down:?}");
            let into_lake = down.kind == VertexKind::Lake;
            assert!(into_lake || above.ground >= below.ground, "{up:?} {down:?}");
            rivers += 1;
            mouths += u32::from(down.kind == VertexKind::Sea);
        }
    }
    assert!(rivers > 4_000 && mouths > 20, "{rivers} {mouths}");
}

#[test]
fn junctions_conserve_discharge() {
    let base = planet();
    let mut junctions = 0;
    for k in 0..8 {
        let view = View {
            horizon: i32::MAX,
            ..camera(on_river(&base, k), 100, 10)
        };
        let ground = refined(&base, &view);
        for level in &ground.levels {
            junctions += check_junctions(&ground, level);
        }
    }
    assert!(junctions > 10, "{junctions}");
}

/// Checks that everything that arrives at a vertex makes its discharge; returns how many vertices
/// have two rivers or more.
fn check_junctions(ground: &RefinedGround, level: &Level) -> usize {
    let mut arriving: BTreeMap<u32, Vec<u64>> = BTreeMap::new();
    for edge in level.edges.iter().filter(|e| e.kind == EdgeKind::River) {
        let [up, down] = edge.vertices;
        assert!(edge.arriving >= ground.vertices[up as usize].discharge);
        let into = arriving.entry(down).or_default();
        into.push(u64::from(edge.arriving));
    }
    arriving.retain(|&v, _| ground.vertices[v as usize].is_wet() && is_inside(level, v));
    for (&v, rivers) in &arriving {
        let vertex = &ground.vertices[v as usize];
        assert_eq!(
            u64::from(vertex.discharge),
            rivers.iter().sum(),
            "{vertex:?}"
        );
    }
    arriving.values().filter(|rivers| rivers.len() > 1).count()
}

/// Whether all faces around a vertex exist in a level.
fn is_inside(level: &Level, v: u32) -> bool {
    let mut around = level.edges.iter().filter(|e| e.vertices.contains(&v));
    around.all(|e| !e.faces.contains(&NONE))
}
