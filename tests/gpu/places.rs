//! Bits of plane geometry, of the courses of rivers, and of lengths on a planet.

use super::arithmetic::any_share;
use pangaea_shaders::amplify::curve::{Curve, heading_of};
use pangaea_shaders::amplify::geometry::{
    Q12, Stance, damped_projection, dot, is_left, least_areas, nearest_on, share_along,
};
use pangaea_shaders::amplify::scale::PlanetScale;
use pangaea_tests::gpu::{assert_call, assert_twin};

const GEOMETRY: &str = "amplify/geometry";
const CURVE: &str = "amplify/curve";
const SCALE: &str = "amplify/scale";

type Vector = [i32; 3];

/// Directions near the first: of the others the numbers are differences, 2 bits shorter.
fn beside<const N: usize>(places: [Vector; N], bits: u32) -> [Vector; N] {
    let first = places[0].map(|x| x >> 1);
    let mut places = places.map(|p| [0, 1, 2].map(|i| first[i] + (p[i] >> bits)));
    places[0] = first;
    places
}

#[test]
fn products_of_vectors_have_the_same_bits() {
    assert_twin(GEOMETRY, "dot", Some, |(u, v)| dot(u, v));
    assert_twin(GEOMETRY, "share_along", Some, |(u, v)| share_along(u, v));
    assert_twin(GEOMETRY, "damped_projection", Some, |(u, v)| {
        damped_projection(u, v)
    });
    assert_twin(GEOMETRY, "is_left", Some, |(up, along, v)| {
        u32::from(is_left(up, along, v))
    });
    let near = |(corners,): ([Vector; 4],)| Some((beside(corners, 3),));
    assert_twin(GEOMETRY, "least_areas", near, |(corners,)| {
        least_areas(corners)
    });
}

#[test]
fn nearest_points_have_the_same_bits() {
    let near = |(ends, p): ([Vector; 2], Vector)| {
        let [a, b, p] = beside([ends[0], ends[1], p], 3);
        Some(([a, b], p))
    };
    assert_twin(GEOMETRY, "nearest_on", near, |(ends, p)| {
        nearest_on(ends, p)
    });
}

#[test]
fn stances_of_triangles_have_the_same_bits() {
    assert_twin(GEOMETRY, "stance_of", Some, |(edge, corner)| {
        let stance = Stance::of(edge, corner);
        (stance.along, stance.height)
    });
    let bounded = |(along, height): (i32, i32)| Some((along.clamp(-7 * Q12, 7 * Q12), height));
    assert_twin(GEOMETRY, "stance_overhang", bounded, |(along, height)| {
        Stance { along, height }.overhang()
    });
}

/// A course: its ends less than 15° apart, and its headings.
type Course = ([Vector; 2], [[i16; 3]; 2]);

fn course((ends, headings): Course) -> Course {
    (beside(ends, 3), headings)
}

#[test]
fn points_of_courses_have_the_same_bits() {
    let at = "fn at(ends: array<vec3<i32>, 2>, headings: array<vec3<i32>, 2>, share: i32) \
              -> array<vec3<i32>, 2> {
        let curve = curve_new(ends, headings);
        return array(curve_at(curve, share), curve_quarter_tangent(curve, share));
    }";
    let input = |(river, share): (Course, i32)| Some((course(river), any_share(share)));
    assert_call(CURVE, at, "at", input, |((ends, headings), share)| {
        let curve = Curve::new(ends, headings);
        [curve.at(share), curve.quarter_tangent(share)]
    });
}

#[test]
fn nearest_points_of_courses_have_the_same_bits() {
    let nearest = "fn nearest(ends: array<vec3<i32>, 2>, headings: array<vec3<i32>, 2>, \
                   p: vec3<i32>) -> NearestPoint {
        return curve_nearest(curve_new(ends, headings), p);
    }";
    let input = |((ends, headings), p): (Course, Vector)| {
        let [a, b, p] = beside([ends[0], ends[1], p], 3);
        Some((([a, b], headings), p))
    };
    assert_call(CURVE, nearest, "nearest", input, |((ends, headings), p)| {
        Curve::new(ends, headings).nearest(p)
    });
}

#[test]
fn headings_have_the_same_bits() {
    assert_twin(CURVE, "heading_of", Some, |(v,)| heading_of(v));
}

/// The words of a planet's scale.
type ScaleWords = [u32; 4];

fn planet([radius_m, grains_per_unit, sixteenths_per_four, edge]: ScaleWords) -> PlanetScale {
    PlanetScale {
        radius_m,
        grains_per_unit,
        sixteenths_per_four,
        edge,
    }
}

#[test]
fn lengths_on_a_planet_have_the_same_bits() {
    let near = |(scale, d): (ScaleWords, Vector)| Some((scale, d.map(|x| x >> 1)));
    assert_twin(SCALE, "planet_scale_grains", near, |(scale, d)| {
        planet(scale).grains(d)
    });
    assert_twin(SCALE, "planet_scale_chord", Some, |(scale, a, b)| {
        planet(scale).chord(a, b)
    });
    assert_twin(SCALE, "planet_scale_sixteenths", Some, |(scale, fours)| {
        planet(scale).sixteenths(fours)
    });
    let level = |(scale, level): (ScaleWords, u32)| Some((scale, level % 18));
    assert_twin(
        SCALE,
        "planet_scale_edge_grains",
        level,
        |(scale, level)| planet(scale).edge_grains(level),
    );
}
