//! Water of grown planets: every lake has one level on every level of the ground, and its shore is
//! where the ground rises over it; rivers run downhill and keep within their banks.

use pangaea_shaders::amplify::base::Base;
use pangaea_shaders::amplify::control::VertexKind;
use pangaea_shaders::amplify::fixed::ONE;
use pangaea_shaders::amplify::local::LocalGround;
use pangaea_shaders::amplify::rules::{EdgeKind, Rules};
use pangaea_shaders::amplify::vertex::Vertex;
use pangaea_tests::grown::GrownPlanet;
use std::sync::Arc;

type Vector = [f64; 3];

/// Points of a square's side.
const SIDE: usize = 48;

/// Ground and water of one point, metres.
#[derive(Clone, Copy)]
struct Point {
    ground: f64,
    water: Option<f64>,
    /// The lake that all corners of its leaf lie in; 0 for none.
    lake: u32,
}

/// Points of a square around a direction, `step` metres apart, on a level.
fn square(
    local: &mut LocalGround<Arc<Base>>,
    centre: [i32; 3],
    step: f64,
    level: u32,
) -> Vec<Point> {
    let metre = f64::from(ONE) / f64::from(local.base().scale.radius_m);
    let up = centre.map(|x| f64::from(x) / f64::from(ONE));
    let east = unit([-up[1], up[0], 0.0]);
    let north = cross(up, east);
    let point = |k: usize| {
        let [x, y] = [k % SIDE, k / SIDE].map(|i| (i as f64 - SIDE as f64 / 2.0) * step * metre);
        let at = [0, 1, 2].map(|i| up[i] * f64::from(ONE) + x * east[i] + y * north[i]);
        let at = unit(at).map(|x| (x * f64::from(ONE)).round() as i32);
        let (leaf, water) = local.leaf_with_water(at, level, None);
        let ground = leaf.height_m(at);
        let [a, b, c] = leaf.vertices.map(|v| {
            if v.kind == VertexKind::Lake {
                v.lake
            } else {
                0
            }
        });
        let lake = if a == b && b == c { a } else { 0 };
        Point {
            ground,
            water,
            lake,
        }
    };
    (0..SIDE * SIDE).map(point).collect()
}

fn unit(v: Vector) -> Vector {
    let size = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / size)
}

fn cross(u: Vector, v: Vector) -> Vector {
    [0, 1, 2].map(|i| {
        let [j, k] = [(i + 1) % 3, (i + 2) % 3];
        u[j] * v[k] - u[k] * v[j]
    })
}

/// Neighbours to the east and south of a point of a square.
fn neighbours(k: usize) -> impl Iterator<Item = usize> {
    let east = (k % SIDE + 1 < SIDE).then_some(k + 1);
    let south = (k + SIDE < SIDE * SIDE).then_some(k + SIDE);
    east.into_iter().chain(south)
}

/// Pairs of a wet point and a dry one beside it.
fn shores(points: &[Point]) -> impl Iterator<Item = (f64, Point)> {
    let pairs = (0..points.len()).flat_map(|k| neighbours(k).map(move |n| [k, n]));
    pairs.filter_map(|pair| {
        let [a, b] = pair.map(|k| points[k]);
        match (a.water, b.water) {
            (Some(water), None) => Some((water, b)),
            (None, Some(water)) => Some((water, a)),
            _ => None,
        }
    })
}

/// Vertices of a kind, spread over the planet.
fn vertices(base: &Base, kind: VertexKind, count: usize) -> Vec<Vertex> {
    let mut found: Vec<Vertex> = base
        .vertices
        .iter()
        .filter(|v| v.kind == kind)
        .copied()
        .collect();
    found.sort_by_key(|v| v.seed);
    found.truncate(count);
    found
}

/// A lake's water stands at its level on every level, and the land at its shore above it.
fn assert_lakes_are_level(base: &Arc<Base>) {
    let mut local = LocalGround::new(base.clone(), &Rules::default());
    let mut wet = 0;
    let [mut low, mut shore] = [0; 2];
    // Lagoons share their level with the sea and the rivers that reach it.
    let lakes = vertices(base, VertexKind::Lake, usize::MAX);
    for lake in lakes.iter().filter(|v| v.lake_level > 20 * 1024).take(12) {
        let level_m = f64::from(lake.lake_level) / 1024.0;
        for (level, step) in [(5, 800.0), (8, 200.0), (11, 25.0)] {
            let points = square(&mut local, lake.direction, step, level);
            let is_level = |water: f64| (water - level_m).abs() < 0.05;
            for point in points.iter().filter(|p| p.lake == lake.lake) {
                assert!(
                    point.water.is_some_and(is_level),
                    "{:?} {level_m}",
                    point.water
                );
                wet += 1;
            }
            for (_, dry) in shores(&points).filter(|&(water, _)| is_level(water)) {
                shore += 1;
                low += u32::from(dry.ground < level_m - 0.05);
            }
        }
    }
    eprintln!("{wet} points of lakes, {low} of {shore} at shores lie too low");
    assert!(
        wet > 5_000 && shore > 200 && low * 50 < shore,
        "{wet} {low} {shore}"
    );
}

/// The land beside a river stands above its water.
fn assert_rivers_keep_to_their_banks(base: &Arc<Base>) {
    let mut local = LocalGround::new(base.clone(), &Rules::default());
    let [mut low, mut shore] = [0; 2];
    for river in vertices(base, VertexKind::River, 40) {
        let width = 2_147.0 * f64::from(river.flow()) / 65_536.0;
        let points = square(&mut local, river.direction, width / 4.0, 15);
        for (water, dry) in shores(&points) {
            shore += 1;
            low += u32::from(dry.ground < water - 0.05);
        }
    }
    eprintln!("{low} of {shore} points at banks lie too low");
    assert!(shore > 1_000 && low * 50 < shore, "{low} {shore}");
}

/// From vertex to vertex rivers fall.
fn assert_rivers_run_downhill(base: &Arc<Base>) {
    let mut local = LocalGround::new(base.clone(), &Rules::default());
    let rivers = base
        .level
        .edges
        .iter()
        .filter(|e| e.kind == EdgeKind::River);
    let mut both = 0;
    for edge in rivers.step_by(7).take(300) {
        let ends = edge.vertices.map(|v| base.vertices[v as usize].direction);
        let [up, down] = ends.map(|at| local.leaf_with_water(at, 13, None).1);
        if let (Some(up), Some(down)) = (up, down) {
            assert!(up >= down - 0.01, "{up} {down}");
            both += 1;
        }
    }
    assert!(both > 100, "{both}");
}

fn assert_laws(seed: u64, count: u64) {
    let grown = GrownPlanet::new(seed, 20_000, count);
    let base = grown.ground.base();
    assert_rivers_run_downhill(base);
    assert_rivers_keep_to_their_banks(base);
    assert_lakes_are_level(base);
}

#[test]
fn the_water_of_planet_5_keeps_its_level() {
    assert_laws(5, 75);
}

#[test]
fn the_water_of_planet_8_keeps_its_level() {
    assert_laws(8, 125);
}
