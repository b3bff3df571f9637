//! The laws of a refinement: conforming, unflipped, view-independent, water downhill, lakes level,
//! flow conserved.

use super::base::{BadMesh, Base};
use super::control::{ControlMesh, VertexKind};
use super::fixed::{GRAINS, ONE};
use super::ground::{Caps, RefinedGround, refine};
use super::mark::View;
use super::rules::{EdgeKind, Rules};
use super::seed::{pcg, share};
use super::synthetic::{control_mesh, facing};
use super::topology::{NONE, SplitMark};
use super::vertex::Vertex;
use std::collections::BTreeMap;

fn planet() -> (ControlMesh, Base) {
    let mesh = control_mesh(300_000, 3, 7);
    let base = Base::new(&mesh).unwrap();
    (mesh, base)
}

fn direction(k: u32) -> [i32; 3] {
    let p = [0, 1, 2].map(|i| f64::from(share(pcg(k), i)) - 32_768.0);
    let n = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
    p.map(|x| (x / n * f64::from(ONE)).round() as i32)
}

/// The direction of a random river vertex.
fn on_river(base: &Base, k: u32) -> [i32; 3] {
    let rivers: Vec<&Vertex> = base
        .vertices
        .iter()
        .filter(|v| v.kind == VertexKind::River)
        .collect();
    rivers[pcg(k) as usize % rivers.len()].direction
}

fn camera(direction: [i32; 3], altitude_m: i32, level: u32) -> View {
    View {
        direction,
        altitude: Some(altitude_m * GRAINS),
        radius: 0,
        sides: [[0; 3]; 2],
        sharpness: 12 << 8,
        level,
        horizon: 100_000 * 16,
    }
}

/// 128-bit names of all vertices by their path from the control mesh.
fn paths(ground: &RefinedGround, seeds: &mut BTreeMap<u128, Vertex>) -> Vec<u128> {
    let mut names = vec![0_u128; ground.vertices.len()];
    let start = ground.levels[0]
        .edges
        .iter()
        .flat_map(|e| e.vertices)
        .max()
        .unwrap() as usize
        + 1;
    for (name, vertex) in names.iter_mut().zip(&ground.vertices).take(start) {
        let d = vertex.direction.map(|x| u128::from(x as u32));
        *name = d[0] | d[1] << 32 | d[2] << 64;
    }
    for level in &ground.levels {
        for edge in level.edges.iter().filter(|e| e.mark == SplitMark::Split) {
            let [a, b] = edge.vertices.map(|v| names[v as usize]);
            let (a, b) = (a.min(b), a.max(b));
            let mixed =
                (a.rotate_left(17) ^ b).wrapping_mul(0x2545_F491_4F6C_DD1D_9E37_79B9_7F4A_7C15);
            names[edge.mid as usize] = mixed ^ (mixed >> 61) ^ (b.wrapping_add(a.wrapping_mul(3)));
        }
    }
    for (v, &name) in names.iter().enumerate() {
        if name != 0 {
            seeds.insert(name, ground.vertices[v]);
        }
    }
    names
}

#[test]
fn every_interior_edge_is_used_twice() {
    let (_, base) = planet();
    for k in 0..6 {
        let whole = View {
            horizon: i32::MAX,
            ..camera(on_river(&base, k), 300, 8)
        };
        let ground = refine(&base, &Rules::default(), &whole, &Caps::default());
        let mut uses = BTreeMap::new();
        for t in ground.triangles() {
            for i in 0..3 {
                let (a, b) = (t.vertices[i], t.vertices[(i + 1) % 3]);
                assert_ne!(a, NONE);
                *uses.entry((a, b)).or_insert(0) += 1;
            }
        }
        for (&(a, b), &n) in &uses {
            assert_eq!((n, uses.get(&(b, a))), (1, Some(&1)), "edge {a} {b}");
        }
        // A closed surface without handles.
        let triangles = uses.len() / 3;
        let vertices: std::collections::BTreeSet<u32> = uses.keys().map(|e| e.0).collect();
        assert_eq!(triangles, 2 * vertices.len() - 4);
    }
}

#[test]
fn no_face_turns_over() {
    let (_, base) = planet();
    for rules in [Rules::default(), Rules::PAPER, Rules::RELEASE] {
        let ground = refine(&base, &rules, &View::whole(4), &Caps::default());
        check_facing(&ground);
        for k in 0..10 {
            let view = View::disc(on_river(&base, k), 100, 12);
            check_facing(&refine(&base, &rules, &view, &Caps::default()));
        }
    }
}

fn check_facing(ground: &RefinedGround) {
    let (mut worst, mut flipped, mut n) = (f64::MAX, 0, 0);
    for (index, level) in ground.levels.iter().enumerate() {
        let edge = f64::from(ground.scale.edge_grains(index as u32))
            / f64::from(ground.scale.radius_m)
            / 1024.0;
        for face in &level.faces {
            let corners = face.vertices.map(|v| {
                ground.vertices[v as usize]
                    .direction
                    .map(|x| f64::from(x) / f64::from(ONE))
            });
            let area = facing(corners) / (edge * edge);
            worst = worst.min(area);
            flipped += u32::from(area <= 0.0);
            n += 1;
        }
    }
    assert_eq!(flipped, 0, "of {n}; smallest {worst}");
}

#[test]
fn cameras_agree_on_every_vertex() {
    let (_, base) = planet();
    let rules = Rules::default();
    for k in 0..12 {
        let centre = if k % 3 == 0 {
            direction(k)
        } else {
            on_river(&base, k)
        };
        let near = [0, 1, 2]
            .map(|i| centre[i as usize] + (share(pcg(k + 99), i) - 32_768) * (1 << (k % 6)));
        let views = [
            camera(centre, 50, 12),
            camera(near, 400, 12),
            View::disc(near, 60, 12),
            camera(direction(k + 50), 9_000, 8),
        ];
        let mut known = BTreeMap::new();
        let mut shared = 0;
        for view in views {
            let ground = refine(&base, &rules, &view, &Caps::default());
            let mut seen = BTreeMap::new();
            paths(&ground, &mut seen);
            for (name, vertex) in seen {
                if let Some(other) = known.insert(name, vertex) {
                    assert_eq!(other, vertex, "{name:x}");
                    shared += 1;
                }
            }
        }
        assert!(shared > 500, "{shared}");
    }
}

#[test]
fn water_runs_downhill_and_lakes_are_level() {
    let (_, base) = planet();
    for rules in [Rules::default(), Rules::PAPER, Rules::RELEASE] {
        let (mut rivers, mut lakes) = (0, 0);
        for k in 0..8 {
            let ground = refine(
                &base,
                &rules,
                &camera(on_river(&base, k), 100, 13),
                &Caps::default(),
            );
            let mut levels = BTreeMap::new();
            for vertex in &ground.vertices {
                assert!(vertex.water >= vertex.bed, "{vertex:?}");
                if vertex.kind == VertexKind::Lake {
                    assert_eq!(
                        *levels.entry(vertex.lake).or_insert(vertex.water),
                        vertex.water
                    );
                    lakes += 1;
                }
            }
            for edge in ground
                .levels
                .iter()
                .flat_map(|l| &l.edges)
                .filter(|e| e.kind == EdgeKind::River)
            {
                let [up, down] = edge.vertices.map(|v| &ground.vertices[v as usize]);
                if up.kind == VertexKind::River && down.kind == VertexKind::River {
                    assert!(
                        up.bed >= down.bed && up.water >= down.water,
                        "{up:?} {down:?}"
                    );
                    rivers += 1;
                }
            }
            for level in &ground.levels {
                for edge in level
                    .edges
                    .iter()
                    .filter(|e| e.kind == EdgeKind::River && e.mark == SplitMark::Split)
                {
                    let [up, down] = edge.vertices.map(|v| &ground.vertices[v as usize]);
                    let mid = &ground.vertices[edge.mid as usize];
                    if mid.kind == VertexKind::River
                        && up.kind == VertexKind::River
                        && up.bed >= down.bed + 2
                    {
                        assert!(
                            up.bed > mid.bed && mid.bed > down.bed,
                            "{up:?} {mid:?} {down:?}"
                        );
                    }
                }
            }
        }
        assert!(rivers > 1000 && lakes > 10, "{rivers} {lakes}");
    }
}

#[test]
fn junctions_conserve_discharge() {
    let (_, base) = planet();
    let mut junctions = 0;
    for k in 0..8 {
        let ground = refine(
            &base,
            &Rules::default(),
            &View {
                horizon: i32::MAX,
                ..camera(on_river(&base, k), 100, 10)
            },
            &Caps::default(),
        );
        for level in &ground.levels {
            let mut arriving = BTreeMap::new();
            for edge in level.edges.iter().filter(|e| e.kind == EdgeKind::River) {
                let [up, down] = edge.vertices;
                assert!(edge.arriving >= ground.vertices[up as usize].discharge);
                let sum = arriving.entry(down).or_insert((0_u64, 0));
                (sum.0, sum.1) = (sum.0 + u64::from(edge.arriving), sum.1 + 1);
            }
            for (v, (sum, count)) in arriving {
                let vertex = &ground.vertices[v as usize];
                if vertex.is_wet() && closed(level, v) {
                    assert_eq!(u64::from(vertex.discharge), sum, "{vertex:?}");
                    junctions += u32::from(count > 1);
                }
            }
        }
    }
    assert!(junctions > 10, "{junctions}");
}

#[test]
fn any_radius_gives_whole_ground() {
    for radius in [50_000, 1_000_000, 10_000_000] {
        let base = Base::new(&control_mesh(radius, 3, 3)).unwrap();
        for k in 0..3 {
            let centre = on_river(&base, k);
            let view = View {
                altitude: None,
                horizon: i32::MAX,
                ..camera(centre, 0, 17)
            };
            let ground = refine(&base, &Rules::default(), &view, &Caps::default());
            assert_eq!(ground.levels.len(), 18);
            check_facing(&ground);
            let mut uses = BTreeMap::new();
            for t in ground.triangles() {
                for i in 0..3 {
                    *uses
                        .entry((t.vertices[i], t.vertices[(i + 1) % 3]))
                        .or_insert(0) += 1;
                }
            }
            assert!(
                uses.iter()
                    .all(|(&(a, b), &n)| n == 1 && uses.get(&(b, a)) == Some(&1))
            );
            let rivers = ground
                .vertices
                .iter()
                .filter(|v| v.level > 12 && v.kind == VertexKind::River)
                .count();
            assert!(rivers > 5, "radius {radius}: {rivers}");
        }
    }
}

/// The precision table: how far integer directions stray, in units of 3 mm on Earth.
#[test]
fn directions_stay_on_the_sphere_and_halves_are_halves() {
    let base = Base::new(&control_mesh(6_371_000, 5, 3)).unwrap();
    for k in 0..4 {
        let ground = refine(
            &base,
            &Rules::default(),
            &View::disc(on_river(&base, k), 20, 17),
            &Caps::default(),
        );
        for (index, level) in ground.levels.iter().enumerate() {
            let mut worst = [0.0_f64; 2];
            for edge in level.edges.iter().filter(|e| e.mark == SplitMark::Split) {
                let point = |v: u32| ground.vertices[v as usize].direction.map(f64::from);
                let [a, b, m] = [edge.vertices[0], edge.vertices[1], edge.mid].map(point);
                let norm = |p: [f64; 3]| (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
                worst[0] = worst[0].max((norm(m) - f64::from(ONE)).abs());
                if index >= 11 {
                    let half = [0, 1, 2].map(|i| (a[i] + b[i]) / 2.0 - m[i]);
                    worst[1] = worst[1].max(norm(half));
                }
            }
            // Away from the sphere: 5 cm on Earth. From the middle of the edge: half a unit a
            // component.
            assert!(
                worst[0] < 16.0 && worst[1] < 0.9,
                "level {index}: {worst:?}"
            );
        }
    }
}

#[test]
fn a_cap_drops_whole_levels() {
    let (_, base) = planet();
    let caps = Caps {
        vertices: 20_000,
        faces: 9_000,
    };
    let view = camera(on_river(&base, 1), 50, 12);
    let ground = refine(&base, &Rules::default(), &view, &caps);
    let capped = ground.capped.unwrap();
    assert_eq!(ground.levels.len() as u32, capped + 1);
    assert!(
        ground.vertices.len() <= caps.vertices
            && ground.levels.iter().all(|l| l.faces.len() <= caps.faces)
    );
    let whole = refine(
        &base,
        &Rules::default(),
        &View {
            level: capped,
            ..view
        },
        &Caps::default(),
    );
    assert_eq!(whole.vertices, ground.vertices);
}

#[test]
fn bad_meshes_are_refused() {
    let (good, _) = planet();
    let spoil = |change: &dyn Fn(&mut ControlMesh)| {
        let mut mesh = good.clone();
        change(&mut mesh);
        Base::new(&mesh).map(|_| ()).unwrap_err()
    };
    assert_eq!(spoil(&|m| m.radius_m = 0), BadMesh::Radius);
    assert_eq!(spoil(&|m| m.faces.clear()), BadMesh::Size);
    assert_eq!(
        spoil(&|m| m.vertices[5].direction = [0; 3]),
        BadMesh::Vertex(5)
    );
    assert_eq!(
        spoil(&|m| m.vertices[6].height = i32::MIN),
        BadMesh::Vertex(6)
    );
    assert_eq!(
        spoil(&|m| m.faces[7].edges[1] = 1_000_000),
        BadMesh::Face(7)
    );
    assert_eq!(
        spoil(&|m| m.faces[8].vertices[0] = m.faces[8].vertices[1]),
        BadMesh::Face(8)
    );
    assert!(matches!(
        spoil(&|m| m.edges[9].faces[1] = u32::MAX),
        BadMesh::Face(_) | BadMesh::Edge(9)
    ));
}

/// Whether all faces around a vertex exist in a level.
fn closed(level: &super::topology::Level, v: u32) -> bool {
    level
        .edges
        .iter()
        .filter(|e| e.vertices.contains(&v))
        .all(|e| !e.faces.contains(&NONE))
}

/// A square has the faces of the disc around it wherever they reach into it, with the same
/// vertices.
#[test]
fn a_square_has_all_faces_of_its_disc_that_reach_into_it() {
    let (_, base) = planet();
    let rules = Rules::default();
    for k in 0..10 {
        let centre = if k % 2 == 0 {
            direction(k)
        } else {
            on_river(&base, k)
        };
        let unit = centre.map(|x| f64::from(x) / f64::from(ONE));
        let scale = 1.0 / (unit[0] * unit[0] + unit[1] * unit[1]).sqrt();
        let east = [-unit[1] * scale, unit[0] * scale, 0.0];
        let north = [
            unit[1] * east[2] - unit[2] * east[1],
            unit[2] * east[0] - unit[0] * east[2],
            unit[0] * east[1] - unit[1] * east[0],
        ];
        let sides = [east, north].map(|side| side.map(|x| (x * 65_536.0).round() as i32));
        let radius = 40;
        let disc = refine(
            &base,
            &rules,
            &View::disc(centre, radius, 16),
            &Caps::default(),
        );
        let view = View::square(centre, sides, radius, 16);
        let square = refine(&base, &rules, &view, &Caps::default());
        let faces = super::ground::refine_faces(&base, &rules, &view, &Caps::default());
        assert_eq!(
            (&faces.vertices, &faces.levels[16].faces),
            (&square.vertices, &square.levels[16].faces)
        );
        // Half a side in units of direction.
        let half = f64::from(radius) / 2.0_f64.sqrt() / 300_000.0 * f64::from(ONE);
        let within = |v: &Vertex| {
            let off = [0, 1, 2].map(|i| f64::from(v.direction[i]) - f64::from(centre[i]));
            [east, north]
                .iter()
                .all(|s| (0..3).map(|i| s[i] * off[i]).sum::<f64>().abs() < half)
        };
        let inside = |ground: &RefinedGround| -> std::collections::BTreeSet<_> {
            let corners =
                |f: &super::topology::Face| f.vertices.map(|v| ground.vertices[v as usize]);
            let faces = ground.levels[16]
                .faces
                .iter()
                .map(corners)
                .filter(|c| c.iter().any(within));
            faces
                .map(|c| c.map(|v| (v.direction, v.height, v.seed, v.river.ends)))
                .collect()
        };
        let (found, wanted) = (inside(&square), inside(&disc));
        assert!(
            wanted.len() > 1000 && found == wanted,
            "{k}: {} of {}",
            found.len(),
            wanted.len()
        );
        assert!(square.levels[16].faces.len() < disc.levels[16].faces.len() * 3 / 4);
    }
}
