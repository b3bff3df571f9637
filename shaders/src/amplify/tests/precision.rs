//! How far integer directions stray, in units of 3 mm on Earth.

use super::*;
use crate::amplify::rules::EdgeKind;
use crate::amplify::topology::{Edge, Level, SplitMark};

fn norm(p: Vector) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt()
}

/// Ends and middles of the split edges of a level.
fn halved<'a>(
    ground: &'a RefinedGround,
    level: &'a Level,
) -> impl Iterator<Item = [Vector; 3]> + 'a {
    // Rivers keep their course, which need not run straight.
    let is_straight = |e: &Edge| e.kind != EdgeKind::River;
    let split = level.edges().filter(|(_, s)| s.mark == SplitMark::Split);
    split
        .filter(move |(e, _)| is_straight(e))
        .map(|(edge, split)| {
            let [a, b] = edge.vertices;
            [a, b, split.mid].map(|v| ground.vertices[v as usize].direction.map(f64::from))
        })
}

#[test]
fn directions_stay_on_the_sphere_and_halves_are_halves() {
    let base = Base::new(&control_mesh(6_371_000, 5, 3)).unwrap();
    for k in 0..4 {
        let ground = refined(&base, &View::disc(on_river(&base, k), 20, 17));
        for (index, level) in ground.levels.iter().enumerate() {
            for [a, b, mid] in halved(&ground, level) {
                // 5 cm on Earth.
                let off_sphere = (norm(mid) - f64::from(ONE)).abs();
                assert!(off_sphere < 16.0, "level {index}: {off_sphere}");
                // Half a unit a component.
                let off_middle = norm([0, 1, 2].map(|i| (a[i] + b[i]) / 2.0 - mid[i]));
                assert!(
                    index < 11 || off_middle < 0.9,
                    "level {index}: {off_middle}"
                );
            }
        }
    }
}
