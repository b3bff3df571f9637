//! Water runs downhill, discharge is conserved.

use super::views::tangents;
use super::*;
use crate::amplify::carve::carve_all;
use crate::amplify::emit;
use crate::amplify::local::LocalGround;
use crate::amplify::rules::EdgeKind;
use crate::amplify::topology::{Edge, EdgeSplit, Level, NONE, SplitMark, gather};
use std::collections::BTreeMap;

/// Views of rivers from 100 m, under all presets.
fn river_views() -> impl Iterator<Item = (Rules, RefinedGround)> {
    let base = planet();
    [Rules::default(), Rules::PAPER, Rules::RELEASE]
        .into_iter()
        .flat_map(|rules| (0..8).map(move |k| (rules, k)))
        .map(move |(rules, k)| {
            let view = camera(on_river(&base, k), 100, 13);
            (rules, refine(&base, &rules, &view, &Caps::default()))
        })
}

fn edges(ground: &RefinedGround) -> impl Iterator<Item = (&Edge, &EdgeSplit)> {
    ground.levels.iter().flat_map(Level::edges)
}

fn is_river(vertex: &Vertex) -> bool {
    vertex.kind == VertexKind::River
}

#[test]
fn water_runs_downhill() {
    let mut rivers = 0;
    for (_, ground) in river_views() {
        assert!(ground.vertices.iter().all(|v| v.water >= v.bed));
        for (edge, split) in edges(&ground).filter(|(e, _)| e.kind == EdgeKind::River) {
            let [up, down] = ground.vertices.gather(edge.vertices);
            if !is_river(up) || !is_river(down) {
                continue;
            }
            assert!(
                up.bed >= down.bed && up.water >= down.water,
                "{up:?} {down:?}"
            );
            rivers += 1;
            if split.mark == SplitMark::Split && up.bed >= down.bed + 2 {
                let mid = &ground.vertices[split.mid as usize];
                let falls = up.bed > mid.bed && mid.bed > down.bed;
                assert!(falls || !is_river(mid), "{up:?} {mid:?} {down:?}");
            }
        }
    }
    assert!(rivers > 3000, "{rivers}");
}

/// Once carved, along every piece of river that is drawn, into lakes and the sea too: no water rises
/// downstream, and no bed but where it enters a lake. Neighbours may share a height, as the fall of
/// a slow river on fine edges is less than a grain. Rivers of print and release follow their edges,
/// ours wind about them.
#[test]
fn carved_water_runs_downhill() {
    let [mut rivers, mut mouths] = [0; 2];
    for (rules, ground) in river_views().filter(|(rules, _)| !rules.landforms) {
        let carved = carve_all(&ground.scale, &rules, &ground.vertices);
        let drawn = edges(&ground).filter(|(_, s)| s.mark != SplitMark::Split);
        for (edge, _) in drawn.filter(|(e, _)| e.kind == EdgeKind::River) {
            let [up, down] = ground.vertices.gather(edge.vertices);
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
    assert!(rivers > 2_500 && mouths > 20, "{rivers} {mouths}");
}

/// Lake corners of one triangle have one level once carved, so every surface of hanging triangles
/// has.
#[test]
fn surfaces_of_lakes_are_level() {
    let mut sides = 0;
    for (rules, ground) in river_views() {
        let carved = carve_all(&ground.scale, &rules, &ground.vertices);
        for triangle in ground.triangles() {
            let is_lake = |v: &u32| ground.vertices[*v as usize].kind == VertexKind::Lake;
            let lake = triangle.vertices.into_iter().filter(is_lake);
            let levels: Vec<i32> = lake.map(|v| carved[v as usize].water).collect();
            assert!(
                levels.windows(2).all(|pair| pair[0] == pair[1]),
                "{levels:?}"
            );
            sides += levels.len().saturating_sub(1);
        }
    }
    assert!(sides > 1_500, "{sides}");
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
    for edge in level
        .mesh
        .edges
        .iter()
        .filter(|e| e.kind == EdgeKind::River)
    {
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
    let mut around = level.mesh.edges.iter().filter(|e| e.vertices.contains(&v));
    around.all(|e| !e.faces.contains(&NONE))
}

/// The surface of the water is level over a lake and its shores, and no sheet of it climbs a bank:
/// over dry corners it stands within the levels of the wet ones, or under the ground.
#[test]
fn water_does_not_climb_its_banks() {
    let mut shores = 0;
    for (rules, ground) in river_views() {
        let carved = carve_all(&ground.scale, &rules, &ground.vertices);
        for sheet in emit::water(&ground, &rules, &ground.triangles(), &carved) {
            let corners = gather(&carved, sheet.ground.vertices);
            let wet = || corners.iter().filter(|c| c.is_wet());
            assert!(wet().count() > 0);
            let highest = wet().map(|c| c.water).max().unwrap_or(i32::MIN);
            for (corner, level) in corners.iter().zip(sheet.water) {
                assert!(level <= highest && (corner.is_wet() || level <= corner.ground));
            }
            let vertices = ground.vertices.gather(sheet.ground.vertices);
            let is_lake = |k: &usize| vertices[*k].kind == VertexKind::Lake;
            let is_bank = |k: &usize| corners[*k].ground > highest;
            let is_shore = (0..3).all(|k| is_lake(&k) || is_bank(&k));
            shores += u32::from(is_shore);
            // 2 cm.
            let is_level = sheet
                .water
                .iter()
                .all(|&level| highest - level < GRAINS / 50);
            assert!(is_level || !is_shore, "{corners:?} {:?}", sheet.water);
        }
    }
    assert!(shores > 1_000, "{shores}");
}

/// A valley has as much water at every level, whatever the size of its leaves.
#[test]
fn the_share_of_water_is_that_of_any_level() {
    let base = Base::new(&control_mesh(6_371_000, 6, 3)).unwrap();
    let mut local = LocalGround::new(&base, &Rules::default());
    let sites: Vec<_> = (0..5).map(|k| on_river(&base, k)).collect();
    let shares = [6, 8, 10, 13, 17].map(|level| {
        let share = |&centre: &[i32; 3]| wet_share(&mut local, centre, level);
        sites.iter().map(share).sum::<f64>() / 5.0
    });
    let [least, most] = [f64::min, f64::max].map(|pick| shares.into_iter().reduce(pick).unwrap());
    assert!(most > 0.008 && least > 0.8 * most, "{shares:?}");
}

/// Share of wet points in a square of 12 km around a direction.
fn wet_share(local: &mut LocalGround<&Base>, centre: [i32; 3], level: u32) -> f64 {
    let side = 30;
    let step = f64::from(ONE) / 6_371_000.0 * 400.0;
    let [east, north] = tangents(centre);
    let mut wet = 0;
    for k in 0..side * side {
        let [x, y] = [k % side, k / side].map(|i| f64::from(i - side / 2) * step);
        let at = [0, 1, 2].map(|i| f64::from(centre[i]) + x * east[i] + y * north[i]);
        let (_, water) = local.leaf_with_water(unit(at), level, None);
        wet += u32::from(water.is_some());
    }
    f64::from(wet) / f64::from(side * side)
}
