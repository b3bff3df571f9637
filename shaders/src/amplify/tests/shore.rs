//! Coasts have no straight sides, and land and sea win as much of each other.
//!
//! The control mesh is as fine as that of a planet. Its ground rises evenly from south to north, so
//! that without rules the shore would run along the equator: on one side of the planet a plain's,
//! on the other a rocky one.

use super::*;
use crate::amplify::control::{ControlMesh, ControlVertex};
use crate::amplify::local::LocalGround;

/// Radius in metres.
const RADIUS_M: f64 = 6_371_000.0;

/// Pixels of 500 m along the equator and across it.
const SIZE: [usize; 2] = [448, 256];

/// Metres of a pixel.
const PIXEL_M: f64 = 500.0;

/// Level of the ground: edges of 200 m.
const LEVEL: u32 = 8;

/// Height of the ground at a control vertex in metres, and what it is: coasts are wide enough that
/// no edge joins land and sea.
fn slope(vertex: ControlVertex) -> ControlVertex {
    let north_m = f64::from(vertex.direction[2]) / f64::from(ONE) * RADIUS_M;
    let way = if vertex.direction[1] > 0 { 300.0 } else { 30.0 };
    let height = (north_m.clamp(-5e5, 5e5) / way) as i32 * GRAINS;
    let kind = match north_m {
        y if y > 50_000.0 => VertexKind::Terrain,
        y if y < -50_000.0 => VertexKind::Sea,
        _ => VertexKind::Coast,
    };
    ControlVertex {
        direction: vertex.direction,
        seed: vertex.seed,
        height,
        bed: height,
        water: height.max(0),
        crust: height,
        kind: kind as u8,
        ..ControlVertex::default()
    }
}

/// An even slope without rivers.
fn even_slope() -> ControlMesh {
    let mut mesh = control_mesh(RADIUS_M as u32, 7, 3);
    mesh.vertices = mesh.vertices.into_iter().map(slope).collect();
    mesh.edges.iter_mut().for_each(|edge| edge.river = 0);
    mesh
}

/// Which pixels about a longitude are land, by rows from the south.
fn land(base: &Base, east: f64) -> Vec<[bool; SIZE[0]]> {
    let mut ground = LocalGround::new(base, &Rules::default());
    let mut is_land = |x, y| height(&mut ground, [x, y], east) > 0.0;
    let rows = 0..SIZE[1];
    rows.map(|y| core::array::from_fn(|x| is_land(x, y)))
        .collect()
}

/// Height of the ground at a pixel about a longitude, metres.
fn height(ground: &mut LocalGround<&Base>, [x, y]: [usize; 2], east: f64) -> f64 {
    let place = |k: usize, n: usize| (k as f64 - 0.5 * n as f64) * PIXEL_M / RADIUS_M;
    let at = unit([1.0, place(x, SIZE[0]) + east, place(y, SIZE[1])]);
    ground.leaf(at, LEVEL, None).height_m(at)
}

/// Boxes of a size in pixels through which the shore runs. Neighbours share their border, so that
/// none passes between them.
fn boxes(land: &[[bool; SIZE[0]]], size: usize) -> usize {
    let is_mixed = |x, y| is_mixed(land, size, [x, y]);
    let columns = (0..SIZE[0]).step_by(size);
    let at = |x| (0..SIZE[1]).step_by(size).filter(move |&y| is_mixed(x, y));
    columns.flat_map(at).count()
}

/// Whether the box from a pixel on holds land and sea.
fn is_mixed(land: &[[bool; SIZE[0]]], size: usize, [x, y]: [usize; 2]) -> bool {
    let row = |y: usize| &land[y][x..(x + size + 1).min(SIZE[0])];
    let mut pixels = (y..(y + size + 1).min(SIZE[1])).flat_map(row);
    let first = land[y][x];
    pixels.any(|&l| l != first)
}

/// The northernmost sea of every column, in pixels.
fn shore(land: &[[bool; SIZE[0]]]) -> Vec<f64> {
    let last_sea = |x: usize| (0..SIZE[1]).rev().find(|&y| !land[y][x]).unwrap_or(0);
    (0..SIZE[0]).map(|x| last_sea(x) as f64).collect()
}

/// Whether a shore stays within a pixel of its chord.
fn is_straight(shore: &[f64]) -> bool {
    let n = (shore.len() - 1) as f64;
    let chord = |i: usize| shore[0] + (shore[shore.len() - 1] - shore[0]) * i as f64 / n;
    (0..shore.len()).all(|i| (shore[i] - chord(i)).abs() <= 1.0)
}

/// How many boxes of 1 km the shore runs through for one of 8 km: 8 to the power of its dimension.
fn fine_to_coarse(land: &[[bool; SIZE[0]]]) -> f64 {
    let [fine, coarse] = [2, 16].map(|size| boxes(land, size) as f64);
    fine / coarse
}

#[test]
fn coasts_have_no_straight_sides_and_land_keeps_its_area() {
    let base = Base::new(&even_slope()).unwrap();
    let [plain, rocky] = [0.3, -0.3].map(|east| land(&base, east));
    // Dimensions of real coasts are 1.0 (South Africa) to 1.25 (Britain), of rocky ones up to 1.5
    // (Norway); B. Mandelbrot, How long is the coast of Britain?, 1967; J. Feder, Fractals, 1988.
    let ratios = [&plain, &rocky].map(|land| fine_to_coarse(land));
    // Of dimensions 1.05 to 1.3.
    assert!((8.9..14.9).contains(&ratios[0]), "{ratios:?}");
    // Of dimensions 1.12 to 1.5.
    assert!((10.3..22.6).contains(&ratios[1]), "{ratios:?}");
    for land in [plain, rocky] {
        let dry = land.iter().flatten().filter(|&&l| l).count();
        let share = dry as f64 / (SIZE[0] * SIZE[1]) as f64;
        // Half, but for what chance leaves on a coast of 224 km.
        assert!((share - 0.5).abs() < 0.04, "{share}");

        let shore = shore(&land);
        let longest = (2..SIZE[0])
            .rev()
            .find(|&n| shore.windows(n).any(is_straight));
        assert!(longest.unwrap_or(0) < 28, "{longest:?} pixels of 500 m");
    }
}
