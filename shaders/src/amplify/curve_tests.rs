//! Courses join without a kink, and the nearest point of one is the nearest.

use super::*;
use crate::amplify::seed::pcg;

/// A random number of -1..1.
fn random(k: u32, i: u32) -> f64 {
    f64::from(pcg(pcg(k) ^ i)) / 2_147_483_648.0 - 1.0
}

/// A course of 100,000 units to the east, whose headings are up to 45° off.
fn course(k: u32) -> Curve {
    let headings = [0, 1].map(|i| heading(random(k, i)));
    Curve::new([[0; 3], [100_000, 0, 0]], headings)
}

/// The heading of a slope to the north.
fn heading(slope: f64) -> [i16; 3] {
    let size = (1.0 + slope * slope).sqrt();
    [1.0, slope, 0.0].map(|x| (x / size * 32_767.0) as i16)
}

fn norm(v: [i32; 3]) -> f64 {
    v.map(f64::from).iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn tangents_at_the_ends_are_the_headings() {
    for k in 0..500 {
        let curve = course(k);
        for (i, share) in [(0, 0), (1, Q16)] {
            let [x, y, _] = curve.quarter_tangent(share).map(f64::from);
            assert!((y / x - random(k, i)).abs() < 2e-3, "{k} {x} {y}");
        }
        assert_eq!((curve.at(0), curve.at(Q16)), ([0; 3], [100_000, 0, 0]));
    }
}

#[test]
fn the_nearest_point_is_that_of_a_thousand() {
    for k in 0..4_000 {
        let curve = course(k);
        let p = [random(k, 2) * 90_000.0 + 50_000.0, random(k, 3) * 60_000.0];
        let p = [p[0] as i32, p[1] as i32, 0];
        let off = |i: i32| norm(curve.off(i * (Q16 / 1024), p));
        let want = (0..=1024).map(off).fold(f64::MAX, f64::min);
        let got = norm(curve.nearest(p).1);
        // Exact near the course, by a tenth too far where that bends around the point.
        let slack = 300.0 + 0.1 * (want - 10_000.0).max(0.0);
        assert!(got > want - 80.0 && got < want + slack, "{k}: {want} {got}");
    }
}

#[test]
fn without_headings_the_course_is_straight() {
    let straight = Curve::new([[0; 3], [90_000, 30_000, 0]], [[0; 3]; 2]);
    assert_eq!(straight.at(Q16 / 2), [45_000, 15_000, 0]);
    let way = heading_of([90_000, 30_000, 0]);
    let headed = Curve::new([[0; 3], [90_000, 30_000, 0]], [way; 2]);
    assert!(norm(difference(headed.at(Q16 / 3), straight.at(Q16 / 3))) < 40.0);
}

#[test]
fn headings_have_the_length_of_one() {
    for k in 0..2_000 {
        let bits = 4 + k % 26;
        let v = [0, 1, 2].map(|i| (pcg(pcg(k) ^ i) as i32) >> (32 - bits));
        let size = norm(heading_of(v).map(i32::from));
        assert!((size - 32_767.0).abs() < 40.0, "{k} {size}");
    }
    assert_eq!(heading_of([0; 3]), [0; 3]);
}
