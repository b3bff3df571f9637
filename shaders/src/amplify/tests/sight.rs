//! The ground that a camera sees, against reals; and meshes of cameras that look one way.

use super::topology::{check_closed, uses};
use super::views::{by_path, tangents};
use super::*;
use crate::amplify::scale::PlanetScale;
use crate::amplify::sight::{RINGS, Sight, horizon};
use crate::amplify::topology::{Level, NONE, SplitMark};
use std::collections::BTreeMap;

/// A real camera over a planet, lengths in metres.
struct RealCamera {
    place: Vector,
    forward: Vector,
    radius_m: f64,
    horizon_m: f64,
    sharpness: f64,
}

fn dot(u: Vector, v: Vector) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

impl RealCamera {
    fn new(base: &Base, view: &View) -> Self {
        let radius_m = f64::from(base.scale.radius_m);
        let altitude = f64::from(view.altitude.unwrap()) / 16.0;
        let up = view.direction.map(|x| f64::from(x) / f64::from(ONE));
        Self {
            place: up.map(|x| x * (radius_m + altitude)),
            forward: view.forward.map(|x| f64::from(x) / 65_536.0),
            radius_m,
            horizon_m: f64::from(view.horizon) / 16.0,
            sharpness: f64::from(view.sharpness) / 256.0,
        }
    }

    /// Distance of the middle of a face, and the same as it counts.
    fn distances(&self, corners: [&Vertex; 3]) -> [f64; 2] {
        let height = corners
            .map(|v| f64::from(v.height) / 1024.0)
            .iter()
            .sum::<f64>()
            / 3.0;
        let sum = [0, 1, 2].map(|i| {
            let of = corners.map(|v| f64::from(v.direction[i]) / f64::from(ONE));
            of.iter().sum::<f64>() / 3.0
        });
        let centre = sum.map(|x| x * (self.radius_m + height));
        let way = [0, 1, 2].map(|i| centre[i] - self.place[i]);
        let distance = dot(way, way).sqrt();
        // The slope that three rings allow, and the factor q beside the field of view of 120°. From
        // on high the distance itself grows faster than the way along the ground.
        let stretch = (dot(self.place, self.place).sqrt() / self.radius_m).sqrt();
        let slope = (self.sharpness / stretch / 4.5).max(1.0);
        let most = ((slope - 1.0) / 4.5).min(3.0);
        let t = ((0.5 - dot(way, self.forward) / distance) / 0.5).clamp(0.0, 1.0);
        let q = 1.0 + most * t * t * (3.0 - 2.0 * t);
        let hidden = (distance - self.horizon_m).max(0.0);
        let weighted = (distance * q).max(distance + hidden * (slope - 1.0));
        [distance, weighted]
    }
}

/// A camera that looks along the ground, `turn` of four ways, over a place.
fn looking(base: &Base, direction: [i32; 3], turn: usize, altitude: u32, c: u32) -> View {
    let [east, north] = tangents(direction);
    let side = [east, north][turn % 2].map(|x| if turn < 2 { x } else { -x });
    View {
        forward: side.map(|x| (x * 65_536.0).round() as i32),
        sharpness: c << 8,
        ..View::camera(&base.scale, direction, altitude, 12)
    }
}

/// Altitudes from the ground to orbit, metres.
const ALTITUDES_M: [u32; 6] = [2, 3_000, 50_000, 400_000, 5_000_000, 60_000_000];

#[test]
fn the_faces_that_are_split_are_those_of_reals() {
    for radius_m in [300_000, 6_371_000] {
        let base = Base::new(&control_mesh(radius_m, 4, 7)).unwrap();
        let [mut split, mut whole] = [0; 2];
        for (k, altitude) in (0..).zip(ALTITUDES_M) {
            for turn in 0..4 {
                let view = looking(&base, direction(k), turn, altitude, 30);
                let [s, w] = check_splits(&base, &view);
                split += s;
                whole += w;
            }
        }
        assert!(split > 1000 && whole > 1000, "{split} {whole}");
    }
}

/// Compares every face of the control mesh with the reals, at all levels; returns how many are
/// split and how many are not.
fn check_splits(base: &Base, view: &View) -> [usize; 2] {
    let (sight, real) = (Sight::new(&base.scale, view), RealCamera::new(base, view));
    let edge_m = f64::from(base.scale.edge) / 16.0;
    let mut counts = [0; 2];
    for face in &base.level.faces {
        let corners = face.vertices.map(|v| &base.vertices[v as usize]);
        let [distance, weighted] = real.distances(corners);
        // Ground high above a small sphere counts as if on it but for its height, and a
        // camera knows its way to a metre. The slope makes more of both.
        let unclear = real.sharpness / 4.5 * (0.007 * distance + 1.0);
        for level in 0..12 {
            let bound = real.sharpness * edge_m / f64::from(1 << level);
            let is_split = sight.splits(level, corners);
            let is_clear = (weighted - bound).abs() > unclear;
            assert!(
                !is_clear || is_split == (weighted < bound),
                "level {level}: {weighted} {bound} {view:?}"
            );
            counts[usize::from(!is_split)] += 1;
        }
    }
    counts
}

#[test]
fn the_horizon_is_where_tangents_meet_the_sphere() {
    for radius_m in [50_000, 6_371_000, 10_000_000] {
        let scale = PlanetScale::new(&control_mesh(radius_m, 2, 1));
        for altitude_m in [0, 2, 300, 40_000, 900_000, 67_000_000] {
            let tangent = |h: f64| (2.0 * f64::from(radius_m) * h + h * h).sqrt();
            let want = tangent(f64::from(altitude_m)) + tangent(10_000.0);
            let got = f64::from(horizon(&scale, altitude_m * 16)) / 16.0;
            assert!((got / want - 1.0).abs() < 1e-3, "{got} {want}");
        }
    }
}

/// Ground over four edges of the control mesh beyond the horizon is not refined.
#[test]
fn nothing_is_refined_far_beyond_the_horizon() {
    let base = Base::new(&control_mesh(6_371_000, 5, 3)).unwrap();
    let view = looking(&base, on_river(&base, 2), 0, 2, 117);
    let sight = Sight::new(&base.scale, &view);
    let far = view.horizon + (f64::from(base.scale.edge) * 4.6) as i32;
    let mut seen = 0;
    for face in &base.level.faces {
        let corners = face.vertices.map(|v| &base.vertices[v as usize]);
        let distance = sight.distance(corners);
        assert!(distance < far || !sight.splits(0, corners), "{distance}");
        seen += u32::from(sight.splits(0, corners));
    }
    assert!(seen > 10 && base.scale.edge > RINGS, "{seen}");
}

/// Four cameras at one place look four ways: their meshes are whole, every split edge has both
/// faces, and what they share are the same vertices.
#[test]
fn cameras_that_look_one_way_have_whole_meshes() {
    let base = planet();
    for (k, c) in (0..).zip([6, 12, 24, 40]) {
        let mut known = BTreeMap::new();
        let mut shared = 0;
        for turn in 0..4 {
            let view = View {
                horizon: 30_000 * 16,
                ..looking(&base, on_river(&base, k), turn, 40 << (2 * k), c)
            };
            let ground = refined(&base, &view);
            check_split_edges(&ground);
            for (name, vertex) in by_path(&ground) {
                if let Some(other) = known.insert(name, vertex) {
                    assert_eq!(other, vertex, "{name:x}");
                    shared += 1;
                }
            }
        }
        assert!(shared > 500, "{shared}");
    }
}

/// No edge that is split lacks a face, and with all ground kept the surface is closed.
fn check_split_edges(ground: &RefinedGround) {
    let edges = ground.levels.iter().flat_map(Level::edges);
    for (edge, _) in edges.filter(|(_, s)| s.mark == SplitMark::Split) {
        assert!(!edge.faces.contains(&NONE));
    }
}

#[test]
fn a_camera_that_looks_one_way_sees_a_closed_surface() {
    let base = planet();
    for turn in 0..4 {
        let view = View {
            horizon: i32::MAX,
            ..looking(&base, on_river(&base, 5), turn, 20, 40)
        };
        let one_way = refined(&base, &view);
        check_closed(&uses(&one_way));
        let all_round = refined(
            &base,
            &View {
                forward: [0; 3],
                ..view
            },
        );
        assert!(one_way.vertices.len() * 3 < all_round.vertices.len() * 2);
    }
}
