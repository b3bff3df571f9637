//! No view changes a bit.

use super::*;
use crate::amplify::ground::refine_faces;
use crate::amplify::topology::{Face, SplitMark};
use std::collections::{BTreeMap, BTreeSet};

/// All vertices by names of 128 bits, which follow from their paths from the control mesh.
pub(super) fn by_path(ground: &RefinedGround) -> BTreeMap<u128, Vertex> {
    let mut names = vec![0_u128; ground.vertices.len()];
    let base = ground.levels[0].edges().flat_map(|(e, _)| e.vertices);
    for v in base {
        let [x, y, z] = ground.vertices[v as usize]
            .direction
            .map(|x| u128::from(x as u32));
        names[v as usize] = x | y << 32 | z << 64;
    }
    for (v, vertex) in (0..).zip(&ground.vertices) {
        let (Some(parents), Some(origin)) = (ground.parents(v), ground.origin(v)) else {
            continue;
        };
        let above = vertex.level - 1;
        // The halo's middles are not settled: nothing is drawn with them.
        if ground.levels[above as usize].edges[origin as usize].mark == SplitMark::Split {
            let [a, b] = parents.map(|p| names[p as usize]);
            names[v as usize] = middle_name(a.min(b), a.max(b));
        }
    }
    let named = names.into_iter().zip(ground.vertices.iter().copied());
    named.filter(|&(name, _)| name != 0).collect()
}

fn middle_name(a: u128, b: u128) -> u128 {
    let mixed = (a.rotate_left(17) ^ b).wrapping_mul(0x2545_F491_4F6C_DD1D_9E37_79B9_7F4A_7C15);
    mixed ^ (mixed >> 61) ^ (b.wrapping_add(a.wrapping_mul(3)))
}

/// Two cameras and a disc near one place, and a camera far from it.
fn neighbouring_views(base: &Base, k: u32) -> [View; 4] {
    let centre = if k.is_multiple_of(3) {
        direction(k)
    } else {
        on_river(base, k)
    };
    let step = |i: u32| (share(pcg(k + 99), i) - 32_768) * (1 << (k % 6));
    let near = [0, 1, 2].map(|i| centre[i as usize] + step(i));
    [
        camera(centre, 50, 12),
        camera(near, 400, 12),
        View::disc(near, 60, 12),
        camera(direction(k + 50), 9_000, 8),
    ]
}

#[test]
fn cameras_agree_on_every_vertex() {
    let base = planet();
    for k in 0..12 {
        let mut known = BTreeMap::new();
        let mut shared = 0;
        for view in neighbouring_views(&base, k) {
            for (name, vertex) in by_path(&refined(&base, &view)) {
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
fn a_cap_drops_whole_levels_of_a_disc() {
    let base = planet();
    let caps = Caps {
        vertices: 20_000,
        faces: 9_000,
    };
    let view = View::disc(on_river(&base, 1), 2_000, 12);
    let ground = refine(&base, &Rules::default(), &view, &caps);
    let level = ground.capped.unwrap();
    assert_eq!(ground.levels.len() as u32, level + 1);
    assert!(ground.vertices.len() <= caps.vertices);
    assert!(ground.levels.iter().all(|l| l.faces.len() <= caps.faces));
    let whole = refined(&base, &View { level, ..view });
    // Levels above the finest of a disc have wider margins, so there are more of them.
    assert!(whole.vertices.len() <= ground.vertices.len() * 2);
}

/// At half of what it needs a camera has coarser ground everywhere, and the finest under it still.
#[test]
fn a_cap_makes_all_ground_of_a_camera_coarser() {
    let base = planet();
    for k in 0..6 {
        let view = View {
            sharpness: 24 << 8,
            altitude: None,
            ..camera(on_river(&base, k), 0, 14)
        };
        let whole = refined(&base, &view);
        let vertices = base.vertices.len();
        let caps = Caps {
            vertices: vertices + (whole.vertices.len() - vertices) / 2,
            ..Caps::default()
        };
        let ground = refine(&base, &Rules::default(), &view, &caps);
        assert_eq!((ground.capped, ground.levels.len()), (None, 15));
        assert!(ground.vertices.len() <= caps.vertices);
        assert!(ground.vertices.len() > caps.vertices / 3, "too coarse");
        // As a camera of the lower sharpness has it; the halves of the caps are met again.
        assert!(
            (11 << 8..23 << 8).contains(&ground.sharpness),
            "{}",
            ground.sharpness
        );
        let sharpness = ground.sharpness;
        let lower = refined(&base, &View { sharpness, ..view });
        assert_eq!(lower.vertices, ground.vertices);
    }
}

fn dot(u: Vector, v: Vector) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

/// Unit tangents to the east and to the north.
pub(super) fn tangents(direction: [i32; 3]) -> [Vector; 2] {
    let up = direction.map(|x| f64::from(x) / f64::from(ONE));
    let scale = 1.0 / (up[0] * up[0] + up[1] * up[1]).sqrt();
    let east = [-up[1] * scale, up[0] * scale, 0.0];
    let north = [
        up[1] * east[2] - up[2] * east[1],
        up[2] * east[0] - up[0] * east[2],
        up[0] * east[1] - up[1] * east[0],
    ];
    [east, north]
}

/// A square on the ground, in units of direction.
struct Area {
    centre: [i32; 3],
    tangents: [Vector; 2],
    half_side: f64,
}

impl Area {
    /// The square whose corners lie at a radius from its centre.
    fn new(base: &Base, centre: [i32; 3], radius_m: u32) -> Self {
        let half_side = f64::from(radius_m) / 2.0_f64.sqrt();
        Self {
            centre,
            tangents: tangents(centre),
            half_side: half_side / f64::from(base.scale.radius_m) * f64::from(ONE),
        }
    }

    /// Its tangents in Q16.
    fn sides(&self) -> [[i32; 3]; 2] {
        let q16 = |x: f64| (x * 65_536.0).round() as i32;
        self.tangents.map(|side| side.map(q16))
    }

    fn contains(&self, vertex: &Vertex) -> bool {
        let off = [0, 1, 2].map(|i| f64::from(vertex.direction[i]) - f64::from(self.centre[i]));
        self.tangents
            .iter()
            .all(|&side| dot(side, off).abs() < self.half_side)
    }

    /// Faces of a level that reach into it.
    fn faces(&self, ground: &RefinedGround, level: usize) -> BTreeSet<[([i32; 3], i32, u32); 3]> {
        let corners = |f: &Face| f.vertices.map(|v| ground.vertices[v as usize]);
        let faces = ground.levels[level].mesh.faces.iter().map(corners);
        faces
            .filter(|c| c.iter().any(|v| self.contains(v)))
            .map(|c| c.map(|v| (v.direction, v.height, v.seed)))
            .collect()
    }
}

/// A square has the faces of the disc around it wherever they reach into it, with the same
/// vertices.
#[test]
fn a_square_has_all_faces_of_its_disc_that_reach_into_it() {
    const RADIUS_M: u32 = 40;
    let base = planet();
    for k in 0..10 {
        let centre = anywhere_or_on_river(&base, k);
        let area = Area::new(&base, centre, RADIUS_M);
        let square = refined(&base, &View::square(centre, area.sides(), RADIUS_M, 16));
        let disc = refined(&base, &View::disc(centre, RADIUS_M, 16));
        let [found, wanted] = [&square, &disc].map(|ground| area.faces(ground, 16));
        assert!(wanted.len() > 1000 && found == wanted, "{k}");
        assert!(square.levels[16].faces.len() < disc.levels[16].faces.len() * 3 / 4);
    }
}

#[test]
fn faces_alone_are_those_of_the_whole_refinement() {
    let base = planet();
    let view = View::disc(on_river(&base, 3), 40, 16);
    let want = refined(&base, &view);
    let got = refine_faces(&base, &Rules::default(), &view, &Caps::default());
    assert_eq!(got.vertices, want.vertices);
    assert_eq!(got.levels[16].mesh.faces, want.levels[16].mesh.faces);
    assert!(got.levels[16].edges.is_empty() && !want.levels[16].edges.is_empty());
}
