//! Bends are those of real rivers, pieces join without a kink, and the nearest point is the nearest.

use super::*;
use crate::amplify::fixed::{GRAINS, metres};

/// Half a wave of a river of 100 m, grains.
const HALF_WAVE_GRAINS: i32 = metres(550);

/// A straight piece of a slow river of 100 m, `waves` half-waves of it long.
fn piece(k: u32, waves: f64) -> (Wander, i32) {
    piece_of(k, waves, [0, 1].map(|end| drawn(k + end)))
}

/// The winding of a slow river's vertex.
fn drawn(k: u32) -> i16 {
    winding(0, pcg(k), pcg(k) & 2 == 0)
}

/// A piece with windings at its ends.
fn piece_of(k: u32, waves: f64, winding: [i16; 2]) -> (Wander, i32) {
    let axis = (waves * f64::from(HALF_WAVE_GRAINS)) as i32;
    let segment = RiverSegment {
        ends: [[k as i32, 0, 0], [0, k as i32, 7]],
        winding,
        ..RiverSegment::default()
    };
    let wander = Wander::new(&segment, axis, [HALF_WAVE_GRAINS; 2]).unwrap();
    (wander, axis)
}

/// Places of a river along its axis, metres.
fn places(wander: &Wander, axis: i32) -> Vec<[f64; 2]> {
    let shares = (0..=4096).map(|k| k * Q16 / 4096);
    shares.map(|at| place(wander, axis, at)).collect()
}

/// The place of a river beside a share of its axis, metres.
fn place(wander: &Wander, axis: i32, at: i32) -> [f64; 2] {
    let beside = wander.at(at, axis);
    let along = f64::from(axis) * f64::from(at) / 65_536.0 + f64::from(beside.along);
    [along, f64::from(beside.across)].map(|x| x / 1024.0)
}

fn way([a, b]: [[f64; 2]; 2]) -> f64 {
    let [x, y] = [a[0] - b[0], a[1] - b[1]];
    (x * x + y * y).sqrt()
}

/// Unit vector from one place to another.
fn heading([a, b]: [[f64; 2]; 2]) -> [f64; 2] {
    let size = way([a, b]);
    [(b[0] - a[0]) / size, (b[1] - a[1]) / size]
}

/// Cosine of the angle between two unit vectors.
fn cosine(u: [f64; 2], v: [f64; 2]) -> f64 {
    u[0] * v[0] + u[1] * v[1]
}

#[test]
fn slow_rivers_wind_and_steep_ones_do_not() {
    for seed in 0..500 {
        let per_mille = |fall: f64| i32::from(winding(q16(fall / 1000.0), seed, true));
        let full = per_mille(0.0);
        assert!((27_850..32_768).contains(&full), "{full}");
        assert_eq!(per_mille(1.0), full);
        // Half-way between 1 and 10.
        assert!((2 * per_mille(5.5) - full).abs() < 120);
        assert_eq!((per_mille(10.0), per_mille(80.0)), (0, 0));
        assert_eq!(winding(0, seed, false), -(full as i16));
    }
}

/// A piece winds by half and more, 10 to 14 widths a wave, and turns by less than 60 degrees over a
/// width.
#[test]
fn bends_are_round_and_uneven() {
    let [mut sinuosities, mut reaches] = [const { Vec::new() }; 2];
    let mut half_waves = 0;
    for k in 1..200 {
        let (wander, axis) = piece(k, 6.0);
        let places = places(&wander, axis);
        let length: f64 = places.windows(2).map(|p| way([p[0], p[1]])).sum();
        sinuosities.push(length / (f64::from(axis) / 1024.0));
        half_waves += places
            .windows(2)
            .filter(|p| p[0][1] * p[1][1] < 0.0)
            .count()
            + 1;
        // Over a way of about a width.
        let step = (100.0 / length * 4096.0) as usize;
        for p in places.windows(step + 2).step_by(8) {
            let [u, v] = [[p[0], p[1]], [p[step], p[step + 1]]].map(heading);
            // Where the way is no longer than a width.
            if way([p[0], p[step]]) < 105.0 {
                assert!(cosine(u, v) > 0.5, "{k}: {u:?} {v:?}");
            }
        }
        let reach = places.iter().map(|p| p[1].abs()).fold(0.0, f64::max);
        reaches.push(reach);
    }
    sinuosities.sort_by(f64::total_cmp);
    assert!((1.5..2.0).contains(&sinuosities[100]), "{sinuosities:?}");
    let wave = 2.0 * 199.0 * 33.0 / half_waves as f64;
    assert!((10.0..14.0).contains(&wave), "{wave}");
    reaches.sort_by(f64::total_cmp);
    assert!(reaches[180] > 1.2 * reaches[20], "{reaches:?}");
}

/// Where two pieces meet the river crosses the axis in one direction, to the side that the vertex
/// has.
#[test]
fn pieces_join_without_a_kink() {
    for k in 1..300 {
        let [first, middle, last] = [0, 1, 2].map(|end| drawn(k + end));
        let waves = 2.5 + f64::from(k % 40) / 8.0;
        let above = piece_of(k, waves, [first, middle]);
        let below = piece_of(k + 7_000, 9.5 - waves, [middle, last]);
        let [above, below] = [above, below].map(|(wander, axis)| places(&wander, axis));
        let end = above.len() - 1;
        assert!(above[end][1].abs() < 1.0 && below[0][1].abs() < 1.0);
        let [u, v] = [[above[end - 8], above[end]], [below[0], below[8]]].map(heading);
        assert_eq!(u[1] > 0.0, middle > 0, "{k} {u:?}");
        // 16 degrees.
        assert!(cosine(u, v) > 0.96, "{k}: {u:?} {v:?}");
    }
}

#[test]
fn the_nearest_place_is_that_of_thousands() {
    let [mut near, mut far] = [const { Vec::new() }; 2];
    for k in 1..200 {
        let (wander, axis) = piece(k, 6.0);
        let places = places(&wander, axis);
        for i in 0..20 {
            let at = (share(pcg(k), i) / 2 + Q16 / 4).clamp(0, Q16);
            let across = (share(pcg(k), 100 + i) - Q16 / 2) / 96 * GRAINS;
            let place = Beside { along: 0, across };
            let here = [
                f64::from(axis) * f64::from(at) / 65_536.0,
                f64::from(across),
            ];
            let here = here.map(|x| x / 1024.0);
            let want = places
                .iter()
                .map(|&p| way([p, here]))
                .fold(f64::MAX, f64::min);
            let got = f64::from(wander.nearest(at, axis, place).distance) / 1024.0;
            // Beside the bed, half of 100 m, it is right. Between two bends it may be that of the
            // farther one, which draws no bed where none is.
            if want < 75.0 {
                assert!((got - want).abs() < 20.0, "{k} {i}: {got} {want}");
                near.push((got - want).abs());
            } else {
                assert!(got > 60.0, "{k} {i}: {got} {want}");
                far.push((got - want).abs() / want);
            }
        }
    }
    near.sort_by(f64::total_cmp);
    far.sort_by(f64::total_cmp);
    let [near, far] = [near, far].map(|off| off[off.len() / 10 * 9]);
    assert!(near < 3.0 && far < 0.1, "{near} {far}");
}

/// Short pieces, long ones of brooks and those beyond any edge run straight or fit 32 bits.
#[test]
fn extreme_pieces_stay_in_32_bits() {
    for (axis, half_wave) in [
        (metres(190_000), metres(60)),
        (metres(190_000), metres(18_000)),
    ] {
        let segment = RiverSegment {
            ends: [[1, 2, 3], [4, 5, 6]],
            winding: [i16::MAX, i16::MIN + 1],
            ..RiverSegment::default()
        };
        let wander = Wander::new(&segment, axis, [half_wave; 2]).unwrap();
        for at in (0..=Q16).step_by(257) {
            for across in [-axis, -half_wave, 0, half_wave / 3, axis] {
                let place = Beside {
                    along: axis / 4,
                    across,
                };
                let nearest = wander.nearest(at, axis + axis / 2, place);
                assert!(nearest.distance >= 0 && (0..=Q16).contains(&nearest.along));
            }
        }
        assert!(Wander::new(&segment, half_wave - 1, [half_wave; 2]).is_none());
        assert!(Wander::new(&segment, metres(200_001), [half_wave; 2]).is_none());
    }
}
