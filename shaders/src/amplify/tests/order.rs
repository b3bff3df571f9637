//! No number of a vertex, edge or face, and no order of the work changes a bit.

use super::views::by_path;
use super::*;
use crate::amplify::carve::{CarveCache, carve, carve_all};
use crate::amplify::control::{ControlEdge, ControlFace, ControlMesh};
use crate::amplify::count::count_edges;
use crate::amplify::emit::emit_leaves;
use crate::amplify::mark::{mark_halo, mark_split};
use crate::amplify::sight::Sight;
use crate::amplify::topology::{Items, Level, SplitMark};

/// The numbers below `count` in a random order.
fn shuffled(count: usize, seed: u32) -> Vec<u32> {
    let mut order: Vec<u32> = (0..count as u32).collect();
    order.sort_unstable_by_key(|&i| pcg(pcg(i) ^ seed));
    order
}

/// Where every item of an order stands in it.
fn places(order: &[u32]) -> Vec<u32> {
    let mut places = vec![0; order.len()];
    for (place, &item) in (0..).zip(order) {
        places[item as usize] = place;
    }
    places
}

/// The same mesh with its vertices, edges and faces in another order, and each face from another
/// corner on. Edges keep their direction, which is no number but tells their sides apart.
fn renumbered(mesh: &ControlMesh, seed: u32) -> ControlMesh {
    let [vertices, edges, faces] = [mesh.vertices.len(), mesh.edges.len(), mesh.faces.len()]
        .map(|count| shuffled(count, seed));
    let [vertex, edge, face] = [&vertices, &edges, &faces].map(|order| places(order));
    let vertices = vertices.iter().map(|&v| mesh.vertices[v as usize]);
    let edges = edges.iter().map(|&e| {
        let from = &mesh.edges[e as usize];
        ControlEdge {
            vertices: from.vertices.map(|v| vertex[v as usize]),
            faces: from.faces.map(|f| face[f as usize]),
            ..*from
        }
    });
    let faces = faces.iter().map(|&f| {
        let from = turned(&mesh.faces[f as usize], pcg(f ^ seed) as usize);
        ControlFace {
            vertices: from.vertices.map(|v| vertex[v as usize]),
            edges: from.edges.map(|e| edge[e as usize]),
        }
    });
    ControlMesh {
        radius_m: mesh.radius_m,
        vertices: vertices.collect(),
        edges: edges.collect(),
        faces: faces.collect(),
    }
}

/// A face from another corner on.
fn turned(face: &ControlFace, by: usize) -> ControlFace {
    let turn = |all: [u32; 3]| [0, 1, 2].map(|i| all[(i + by % 3) % 3]);
    ControlFace {
        vertices: turn(face.vertices),
        edges: turn(face.edges),
    }
}

/// How the edges and the faces of a level are marked.
fn marks(level: &Level) -> [Vec<SplitMark>; 2] {
    let edges = level.edges.iter().map(|e| e.mark).collect();
    let faces = level.faces.iter().map(|f| f.mark).collect();
    [edges, faces]
}

#[test]
fn numbers_of_the_control_mesh_change_no_bit() {
    let mesh = control_mesh(300_000, 3, 7);
    let base = Base::new(&mesh).unwrap();
    for rules in [Rules::default(), Rules::PAPER, Rules::RELEASE] {
        for k in 0..2 {
            let other = Base::new(&renumbered(&mesh, k)).unwrap();
            let view = View::disc(on_river(&base, k), 500, 13);
            let [want, got] =
                [&base, &other].map(|base| refine(base, &rules, &view, &Caps::default()));
            assert_ne!(want.vertices, got.vertices, "nothing was moved");
            assert_eq!(want.triangles().len(), got.triangles().len());
            let [want, got] = [&want, &got].map(by_path);
            assert!(want.len() > 10_000 && want == got, "{k}");
        }
    }
}

#[test]
fn vertices_are_carved_in_any_order() {
    let base = planet();
    for k in 0..6 {
        let ground = refined(&base, &View::disc(anywhere_or_on_river(&base, k), 500, 13));
        let want = carve_all(&ground.scale, &Rules::default(), &ground.vertices);
        let mut cache = CarveCache::default();
        for v in shuffled(ground.vertices.len(), k) {
            let v = v as usize;
            let got = carve(
                &mut cache,
                &ground.scale,
                &Rules::default(),
                &ground.vertices[v],
            );
            assert_eq!(got, want[v]);
        }
    }
}

#[test]
fn faces_and_edges_are_marked_in_any_order() {
    let base = planet();
    for k in 0..3 {
        let view = camera(on_river(&base, k), 200, 10);
        let ground = refined(&base, &view);
        let sight = Sight::new(&base.scale, &view);
        let mut split = 0;
        for (index, level) in (0..10).zip(&ground.levels) {
            let mut again = Level::new(level.mesh.clone(), Items::all(&level.mesh));
            let Level {
                mesh, edges, faces, ..
            } = &mut again;
            let order = shuffled(faces.len(), k);
            mark_split(&sight, index, mesh, ground.vertices.view(), &order, faces);
            mark_halo(mesh, &shuffled(faces.len(), k + 1), faces);
            let order = shuffled(mesh.edges.len(), k);
            count_edges(mesh, &order, faces, edges);
            // Whatever the view reaches of level 0, the rest of the planet takes no part.
            assert_eq!(marks(&again), marks(level));
            let [_, faces] = marks(level);
            split += faces.iter().filter(|&&m| m == SplitMark::Split).count();
        }
        assert!(split > 1_000, "{split}");
    }
}

#[test]
fn leaves_become_triangles_in_any_order() {
    let base = planet();
    let ground = refined(&base, &camera(on_river(&base, 4), 200, 10));
    let mut triangles = Vec::new();
    for (index, level) in ground.levels.iter().enumerate().rev() {
        let order = shuffled(level.items.faces.len(), 9);
        let items: Vec<u32> = order
            .iter()
            .map(|&i| level.items.faces[i as usize])
            .collect();
        let vertices = ground.vertices.view();
        emit_leaves(index as u32, level, vertices, &items, &mut triangles);
    }
    // Back in the order of levels and leaves; the triangles of a leaf stay in theirs.
    triangles.sort_by_key(|t| (t.level, t.face));
    assert!(triangles.len() > 5_000 && triangles == ground.triangles());
}
