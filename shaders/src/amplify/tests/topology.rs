//! Meshes are closed, and no triangle is turned over.

use super::*;
use crate::amplify::synthetic::facing;
use crate::amplify::topology::NONE;
use std::collections::{BTreeMap, BTreeSet};

/// How often every directed edge of the triangles is used.
pub(super) fn uses(ground: &RefinedGround) -> BTreeMap<[u32; 2], u32> {
    let mut uses = BTreeMap::new();
    for t in ground.triangles() {
        for i in 0..3 {
            let edge = [t.vertices[i], t.vertices[(i + 1) % 3]];
            assert_ne!(edge[0], NONE);
            *uses.entry(edge).or_insert(0) += 1;
        }
    }
    uses
}

pub(super) fn check_closed(uses: &BTreeMap<[u32; 2], u32>) {
    for (&[a, b], &n) in uses {
        assert_eq!((n, uses.get(&[b, a])), (1, Some(&1)), "edge {a} {b}");
    }
}

#[test]
fn every_interior_edge_is_used_twice() {
    let base = planet();
    for k in 0..6 {
        let whole = View {
            horizon: i32::MAX,
            ..camera(on_river(&base, k), 300, 8)
        };
        let uses = uses(&refined(&base, &whole));
        check_closed(&uses);
        // A closed surface without handles.
        let triangles = uses.len() / 3;
        let vertices: BTreeSet<u32> = uses.keys().map(|e| e[0]).collect();
        assert_eq!(triangles, 2 * vertices.len() - 4);
    }
}

/// Faces of all levels, and the triangles that leaves become beside finer ones.
#[test]
fn no_triangle_turns_over() {
    let base = planet();
    for rules in [Rules::default(), Rules::PAPER, Rules::RELEASE] {
        check_facing(&refine(&base, &rules, &View::whole(4), &Caps::default()));
        let mut fans = 0;
        for k in 0..10 {
            let view = View::disc(on_river(&base, k), 100, 12);
            let ground = refine(&base, &rules, &view, &Caps::default());
            check_facing(&ground);
            fans += in_fans(&ground);
        }
        assert!(fans > 5_000, "{fans}");
    }
}

/// How many triangles share their leaf with others.
fn in_fans(ground: &RefinedGround) -> usize {
    let triangles = ground.triangles();
    let leaves = triangles.chunk_by(|t, u| (t.level, t.face) == (u.level, u.face));
    leaves.map(<[_]>::len).filter(|&n| n > 1).sum()
}

fn check_facing(ground: &RefinedGround) {
    let faces = (0..)
        .zip(&ground.levels)
        .flat_map(|(index, level)| level.faces().map(move |(face, _)| (index, face.vertices)));
    let leaves = ground.triangles();
    let triangles = leaves.iter().map(|t| (t.level, t.vertices));
    let mut least = f64::MAX;
    for (level, corners) in faces.chain(triangles) {
        let corners = corners.map(|v| {
            let direction = ground.vertices[v as usize].direction;
            direction.map(|x| f64::from(x) / f64::from(ONE))
        });
        let edge = f64::from(ground.scale.edge_grains(level)) / 1024.0;
        let edge = edge / f64::from(ground.scale.radius_m);
        least = least.min(facing(corners) / (edge * edge));
    }
    assert!(
        least > 0.0,
        "twice the least area over a squared edge: {least}"
    );
}

#[test]
fn any_radius_gives_whole_ground() {
    for radius in [50_000, 1_000_000, 10_000_000] {
        let base = Base::new(&control_mesh(radius, 3, 3)).unwrap();
        for k in 0..3 {
            let view = View {
                altitude: None,
                horizon: i32::MAX,
                ..camera(on_river(&base, k), 0, 17)
            };
            let ground = refined(&base, &view);
            assert_eq!(ground.levels.len(), 18);
            check_facing(&ground);
            check_closed(&uses(&ground));
            let is_fine_river = |v: &&Vertex| v.level > 12 && v.kind == VertexKind::River;
            let rivers = ground.vertices.iter().filter(is_fine_river).count();
            assert!(rivers > 5, "radius {radius}: {rivers}");
        }
    }
}
