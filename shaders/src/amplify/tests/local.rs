//! Queries of single directions against the whole refinement, by brute force.

use super::*;
use crate::amplify::local::{Leaf, LocalGround};
use crate::amplify::locate::{depth, sides};
use crate::amplify::topology::SplitMark;

/// Moves a direction by up to `range` units and back on the sphere.
fn nearby(direction: [i32; 3], k: u32, range: i32) -> [i32; 3] {
    let step = |i| (share(pcg(k), i) - 32_768) * (range / 32_768).max(1);
    unit([0, 1, 2].map(|i| f64::from(direction[i as usize] + step(i))))
}

/// All leaves of a level that contain a direction.
fn brute(ground: &RefinedGround, level: u32, direction: [i32; 3]) -> Vec<[Vertex; 3]> {
    let Some(level) = ground.levels.get(level as usize) else {
        return Vec::new();
    };
    let leaves = level.faces().filter(|(_, s)| s.mark != SplitMark::Split);
    leaves
        .map(|(f, _)| ground.vertices.gather(f.vertices))
        .filter(|c| is_near(c[0], direction) && depth(sides(direction, *c)) >= 0.0)
        .map(|c| c.map(|v| *v))
        .collect()
}

fn is_near(vertex: &Vertex, direction: [i32; 3]) -> bool {
    (0..3).all(|i| (vertex.direction[i] >> 3).abs_diff(direction[i] >> 3) < 1 << 26)
}

#[test]
fn leaf_is_that_of_the_whole_planet() {
    let base = planet();
    for rules in [Rules::default(), Rules::RELEASE] {
        let mut local = LocalGround::new(&base, &rules);
        for level in [0, 1, 2, 4] {
            let ground = refine(&base, &rules, &View::whole(level), &Caps::default());
            for k in 0..80 {
                let at = direction(k);
                let leaf = local.leaf(at, level, None);
                assert!(
                    brute(&ground, level, at).contains(&leaf.vertices),
                    "level {level}, {k}"
                );
            }
        }
    }
}

#[test]
fn leaf_is_that_of_a_fine_patch() {
    let base = planet();
    for k in 0..30 {
        let centre = nearby(anywhere_or_on_river(&base, k), k, 1 << 20);
        let level = 9 + k % 9;
        let radius = (20_000_u32 >> level).max(2);
        let ground = refined(&base, &View::disc(centre, 3 * radius, level));
        // Units in a metre: ONE / radius.
        let range = (f64::from(ONE) / 300_000.0 * f64::from(radius)) as i32;
        let mut local = LocalGround::new(&base, &Rules::default());
        for j in 0..20 {
            let at = nearby(centre, 1000 * k + j, range);
            let leaf = local.leaf(at, level, None);
            let fresh = LocalGround::new(&base, &Rules::default()).leaf(at, level, Some(j));
            assert_eq!(leaf, fresh, "a query depends on the one before it");
            check_found(&leaf, at, &brute(&ground, level, at));
        }
    }
}

/// Checks that a leaf is among those that a refinement has at a direction.
fn check_found(leaf: &Leaf, at: [i32; 3], found: &[[Vertex; 3]]) {
    // From the straight levels on a point within two units of an edge may lie across it.
    let depth = depth(sides(at, leaf.vertices.each_ref()));
    let is_inside = depth > if leaf.level > 11 { 0.02 } else { 0.0 };
    assert!(
        found.contains(&leaf.vertices) || !is_inside,
        "level {}, depth {depth}",
        leaf.level
    );
}

#[test]
fn any_direction_gets_an_answer() {
    let base = planet();
    let mut local = LocalGround::new(&base, &Rules::default());
    for at in [
        [0; 3],
        [i32::MIN; 3],
        [i32::MAX, 0, 0],
        [0, i32::MIN, 1],
        [1, 1, 1],
        [-ONE, 0, 0],
    ] {
        for level in [0, 3, 17, u32::MAX] {
            let leaf = local.leaf(at, level, Some(u32::MAX));
            assert_eq!(leaf.level, level.min(17));
            assert!(leaf.height_m(at).is_finite());
        }
    }
}

#[test]
fn forgetting_changes_nothing() {
    let base = planet();
    let rules = Rules::default();
    let mut local = LocalGround::new(&base, &rules);
    let first: Vec<_> = (0..300)
        .map(|k| local.leaf(direction(k), 17, None))
        .collect();
    let mut lazy = local.lazy().clone();
    assert!(!lazy.is_empty());
    lazy.clear();
    assert!(lazy.is_empty());
    // A thousand queries later everything has been forgotten at least once.
    for k in 0..1500 {
        local.leaf(direction(10_000 + k), 17, None);
    }
    for (k, leaf) in (0..).zip(first) {
        assert_eq!(local.leaf(direction(k), 17, None), leaf);
    }
}
