use super::*;
use crate::query::{Ground, PatchTree};
use crate::random::{Purpose, Stream};
use pangaea_shaders::amplify::rules::Rules;
use pangaea_shaders::amplify::synthetic::control_mesh;

fn ground() -> PlanetGround {
    PlanetGround::new(&control_mesh(6_370_000, 3, 7), Rules::default()).unwrap()
}

/// The longest side of a level, as its error has it.
fn longest(ground: &PlanetGround, level: u8) -> f64 {
    match ground.collider(DVec3::X, f64::INFINITY, level) {
        Err(GroundError::Length { max, .. }) => max,
        other => panic!("{other:?}"),
    }
}

/// Shares of the side of the place of test point `k`: the corners first, then anywhere.
fn shares(stream: &Stream, k: u64) -> [f64; 2] {
    if k < 4 {
        [k & 1, k >> 1].map(|far| 0.4999 * if far == 0 { 1.0 } else { -1.0 })
    } else {
        [0, 1].map(|n| stream.unit(2 * k + n) - 0.5)
    }
}

/// Lets points fall on a collider from above its square, corners included.
fn assert_covered(ground: &PlanetGround, up: DVec3, side: f64, level: u8) {
    let up = up.normalize();
    let tree = PatchTree::new(ground.collider(up, side, level).unwrap()).unwrap();
    let (east, north) = east_north(up);
    let stream = Stream::new(7, Purpose::ReliefSites, 0);
    for k in 0..200 {
        let [x, y] = shares(&stream, k);
        let place = up * ground.radius_m() + (east * x + north * y) * side;
        let down = -place.normalize();
        let above = down * -(ground.radius_m() + 3e5);
        let hit = tree.cast(above, down, 6e5).unwrap();
        assert!(
            hit.is_some(),
            "a hole in {side} m of level {level} at {up}, {k}"
        );
    }
}

#[test]
fn whatever_falls_on_the_square_hits_the_collider() {
    let ground = ground();
    let stream = Stream::new(8, Purpose::ReliefSites, 0);
    for (side, level) in [
        (0.1, 17),
        (0.001, 17),
        (64.0, 5),
        (64.0, 17),
        (1000.0, 14),
        (1e5, 9),
        (2e6, 3),
    ] {
        for k in 0..8 {
            assert_covered(&ground, stream.direction(2 * k), side, level);
        }
    }
    assert_covered(&ground, DVec3::Z, 64.0, 17);
    assert_covered(&ground, -DVec3::Z, 1e6, 0);
}

#[test]
fn the_longest_side_is_one_that_is_made() {
    let ground = ground();
    assert_eq!(longest(&ground, 3), 0.5 * 6_370_000.0);
    for level in [5, 13] {
        let side = longest(&ground, level);
        assert_covered(&ground, DVec3::new(0.2, -0.5, 0.4), side, level);
    }
}

/// Whether a triangle reaches into a square of 2 m.
fn meets(corners: [[f64; 2]; 3]) -> bool {
    let square = TangentSquare::new(DVec3::X, 1000.0, 2.0);
    square.meets(corners.map(|corner| Some(DVec2::from_array(corner))))
}

#[test]
fn a_square_meets_what_crosses_it() {
    let around = [[-50.0, -50.0], [50.0, -50.0], [0.0, 90.0]];
    let sliver = [[-9.0, 0.1], [9.0, 0.0], [9.0, 0.2]];
    let corner_within = [[0.5, 0.5], [9.0, 9.0], [9.0, 8.0]];
    assert!(meets(around) && meets(sliver) && meets(corner_within));
}

#[test]
fn a_square_meets_nothing_else() {
    let beside = [[1.1, -5.0], [1.1, 5.0], [9.0, 0.0]];
    let across_a_corner = [[0.0, 2.1], [2.1, 0.0], [9.0, 9.0]];
    assert!(!meets(beside) && !meets(across_a_corner));
    let square = TangentSquare::new(DVec3::X, 1000.0, 2.0);
    assert!(!square.meets([Some(DVec2::ZERO), Some(DVec2::X), None]));
    assert_eq!(square.place([-5, 0, 0]), None);
    assert_eq!(square.place([10, 2, -1]), Some(DVec2::new(200.0, -100.0)));
}
