//! The local engine against the whole refinement, by brute force.

use super::base::Base;
use super::fixed::ONE;
use super::ground::{Caps, RefinedGround, refine};
use super::local::LocalGround;
use super::locate::{depth, sides};
use super::mark::View;
use super::rules::Rules;
use super::seed::{pcg, share};
use super::synthetic::control_mesh;
use super::topology::SplitMark;
use super::vertex::Vertex;

fn direction(k: u32) -> [i32; 3] {
    let p = [0, 1, 2].map(|i| f64::from(share(pcg(k), i)) - 32_768.0);
    let n = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
    p.map(|x| (x / n * f64::from(ONE)).round() as i32)
}

/// Moves a direction by up to `range` units and back on the sphere.
fn nearby(direction: [i32; 3], k: u32, range: i32) -> [i32; 3] {
    let p = [0, 1, 2].map(|i| {
        f64::from(direction[i as usize] + (share(pcg(k), i) - 32_768) * (range / 32_768).max(1))
    });
    let n = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
    p.map(|x| (x / n * f64::from(ONE)).round() as i32)
}

/// All leaves of a level that contain a direction.
fn brute(ground: &RefinedGround, level: u32, direction: [i32; 3]) -> Vec<[Vertex; 3]> {
    let Some(faces) = ground.levels.get(level as usize).map(|l| &l.faces) else {
        return Vec::new();
    };
    let near =
        |v: &Vertex| (0..3).all(|i| (v.direction[i] >> 3).abs_diff(direction[i] >> 3) < 1 << 26);
    faces
        .iter()
        .filter(|f| f.mark != SplitMark::Split)
        .map(|f| f.vertices.map(|v| &ground.vertices[v as usize]))
        .filter(|c| near(c[0]) && depth(sides(direction, *c)) >= 0.0)
        .map(|c| c.map(|v| *v))
        .collect()
}

#[test]
fn leaf_is_that_of_the_whole_planet() {
    let base = Base::new(&control_mesh(300_000, 3, 7)).unwrap();
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
    let base = Base::new(&control_mesh(300_000, 3, 7)).unwrap();
    let rules = Rules::default();
    let rivers: Vec<[i32; 3]> = base
        .vertices
        .iter()
        .filter(|v| v.is_wet())
        .map(|v| v.direction)
        .collect();
    for k in 0..30 {
        let centre = if k % 2 == 0 {
            direction(k)
        } else {
            nearby(rivers[pcg(k) as usize % rivers.len()], k, 1 << 20)
        };
        let level = 9 + k % 9;
        let radius = (20_000_u32 >> level).max(2);
        let ground = refine(
            &base,
            &rules,
            &View::disc(centre, 3 * radius, level),
            &Caps::default(),
        );
        // Units in a metre: ONE / radius.
        let range = (f64::from(ONE) / 300_000.0 * f64::from(radius)) as i32;
        let mut local = LocalGround::new(&base, &rules);
        for j in 0..20 {
            let at = nearby(centre, 1000 * k + j, range);
            let leaf = local.leaf(at, level, None);
            let fresh = LocalGround::new(&base, &rules).leaf(at, level, Some(j));
            assert_eq!(leaf, fresh, "a query depends on the one before it");
            let found = brute(&ground, level, at);
            // From the straight levels on a point within two units of an edge may lie across it.
            let margin = sides(at, leaf.vertices.each_ref());
            let inside = depth(margin) > if level > 11 { 0.02 } else { 0.0 };
            assert!(
                found.contains(&leaf.vertices) || !inside,
                "level {level}, {k}, {j}, depth {}",
                depth(margin)
            );
        }
    }
}

#[test]
fn any_direction_gets_an_answer() {
    let base = Base::new(&control_mesh(300_000, 3, 7)).unwrap();
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
    let base = Base::new(&control_mesh(300_000, 3, 7)).unwrap();
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
