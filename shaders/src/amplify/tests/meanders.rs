//! Rivers wind as their slope has it, without corners, on beds that fall.

use super::*;
use crate::amplify::ground::RefinedGround;
use crate::amplify::local::LocalGround;
use crate::amplify::rules::{EdgeKind, valley};
use crate::amplify::topology::{Edge, SplitMark};
use crate::amplify::vertex::RiverSegment;
use core::ops::Range;
use std::collections::BTreeMap;

/// Width of a river at a flow φ of 1 on a planet of the Earth's size, metres.
const FULL_WIDTH_M: f64 = 2_147.0;

/// Level that rivers are followed on.
const LEVEL: u32 = 8;

/// Places of a river from a vertex down, a tenth of its width apart, and its water there.
struct Course {
    /// Metres.
    places: Vec<Vector>,
    /// Metres.
    water: Vec<f64>,
    /// Metres.
    width: f64,
}

/// A planet of low land: its rivers fall twenty times less than others.
fn plains() -> Base {
    lowered(20)
}

/// A planet whose land and water stand lower by a factor.
fn lowered(factor: i32) -> Base {
    let mut mesh = control_mesh(800_000, 4, 5);
    for vertex in &mut mesh.vertices {
        for height in [&mut vertex.height, &mut vertex.bed, &mut vertex.water] {
            *height /= factor;
        }
    }
    Base::new(&mesh).unwrap()
}

/// The course from a river vertex down, as far as a disc around it is refined.
fn course(base: &Base, from: [i32; 3]) -> Course {
    let ground = refined(base, &View::disc(from, 12_000, LEVEL));
    let start = ground.vertices.iter().find(|v| v.direction == from);
    let flow = f64::from(start.unwrap().flow()) / 65_536.0;
    let width = FULL_WIDTH_M * flow * f64::from(ground.scale.radius_m) / 6_371_000.0;
    let mut course = Course {
        places: Vec::new(),
        water: Vec::new(),
        width,
    };
    let mut last = None;
    for segment in segments(&ground, from) {
        if last != Some(segment.ends) {
            follow(&ground, &segment, &mut course);
            last = Some(segment.ends);
        }
    }
    course
}

/// Pieces of the river from a vertex down.
fn segments(ground: &RefinedGround, from: [i32; 3]) -> Vec<RiverSegment> {
    let edges = ground.levels[LEVEL as usize].edges();
    let rivers = edges.filter(|(e, s)| e.kind == EdgeKind::River && s.mark != SplitMark::Split);
    let next: BTreeMap<u32, &Edge> = rivers.map(|(e, _)| (e.vertices[0], e)).collect();
    let start = ground.vertices.iter().position(|v| v.direction == from);
    let first = start.and_then(|v| next.get(&(v as u32)));
    let edges = std::iter::successors(first.copied(), |e| next.get(&e.vertices[1]).copied());
    let pieces = edges.map_while(|edge| piece(ground, edge));
    pieces.take(4_000).collect()
}

/// The river of an edge, if finer levels keep it.
fn piece(ground: &RefinedGround, edge: &Edge) -> Option<RiverSegment> {
    let ends = ground.vertices.gather(edge.vertices);
    if ends.iter().any(|v| v.kind != VertexKind::River) {
        return None;
    }
    let kept = RiverSegment::kept(&ground.scale, &Rules::default(), edge, LEVEL, ends);
    // Tides straighten a river before its mouth.
    kept.filter(|piece| piece.tide == [0; 2])
}

/// Adds the places of a piece to a course.
fn follow(ground: &RefinedGround, segment: &RiverSegment, course: &mut Course) {
    for at in (0..65_536).step_by(16) {
        let place = winding_place(ground, segment, at);
        let is_far = |last: &Vector| distance(*last, place) > course.width / 10.0;
        if course.places.last().is_none_or(is_far) {
            course.places.push(place);
            let [up, down] = segment.water.map(|w| f64::from(w) / 1024.0);
            course
                .water
                .push(up + (down - up) * f64::from(at) / 65_536.0);
        }
    }
}

/// The middle of a river at a share of its axis, metres from the planet's centre.
fn winding_place(ground: &RefinedGround, segment: &RiverSegment, at: i32) -> Vector {
    let metre = f64::from(ONE) / f64::from(ground.scale.radius_m);
    let curve = segment.curve();
    let (way, tangent) = (curve.at(at), curve.quarter_tangent(at));
    let axis = [0, 1, 2].map(|i| f64::from(segment.ends[0][i] + way[i]) / metre);
    let Some(wander) = valley::wander(&ground.scale, &Rules::default(), segment) else {
        return axis;
    };
    let beside = wander.at(at, 4 * ground.scale.grains(tangent));
    let forth = tangent.map(f64::from);
    let left = cross(axis, forth);
    let [x, y] = [beside.along, beside.across].map(|grains| f64::from(grains) / 1024.0);
    let [forth, left] = [forth, left].map(|v| v.map(|c| c / norm(v)));
    [0, 1, 2].map(|i| axis[i] + x * forth[i] + y * left[i])
}

fn cross(u: Vector, v: Vector) -> Vector {
    [0, 1, 2].map(|i| {
        let [j, k] = [(i + 1) % 3, (i + 2) % 3];
        u[j] * v[k] - u[k] * v[j]
    })
}

fn norm(v: Vector) -> f64 {
    distance(v, [0.0; 3])
}

/// Cosine of the angle between two vectors.
fn cosine(u: Vector, v: Vector) -> f64 {
    (0..3).map(|i| u[i] * v[i]).sum::<f64>() / norm(u) / norm(v)
}

fn distance(p: Vector, q: Vector) -> f64 {
    let square = |i: usize| (p[i] - q[i]) * (p[i] - q[i]);
    (0..3).map(square).sum::<f64>().sqrt()
}

/// Courses from forty river vertices.
fn courses(base: &Base) -> Vec<Course> {
    let courses = (0..40).map(|k| course(base, on_river(base, k)));
    courses.filter(|c| c.places.len() > 200).collect()
}

/// Slope and sinuosity of the stretches of a course that are 20 widths long as the crow flies.
fn stretches(course: &Course) -> Vec<(f64, f64)> {
    let places = &course.places;
    let (mut start, mut length) = (0, 0.0);
    let mut found = Vec::new();
    for i in 1..places.len() {
        length += distance(places[i - 1], places[i]);
        let chord = distance(places[start], places[i]);
        if chord >= 20.0 * course.width {
            let fall = course.water[start] - course.water[i];
            found.push((fall / length, length / chord));
            (start, length) = (i, 0.0);
        }
    }
    found
}

fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

#[test]
fn slow_rivers_meander_and_steep_ones_run_on() {
    let slow = sinuosity(&plains(), 0.0..0.001);
    assert!((1.5..2.2).contains(&slow), "{slow}");
    let steep = sinuosity(&lowered(1), 0.01..1.0);
    assert!((1.0..1.25).contains(&steep), "{steep}");
}

/// Median sinuosity of the stretches whose slope is in a range.
fn sinuosity(base: &Base, slopes: Range<f64>) -> f64 {
    let found = courses(base);
    let found = found.iter().flat_map(stretches);
    let these = found.filter(|(slope, _)| slopes.contains(slope));
    let these: Vec<f64> = these.map(|(_, sinuosity)| sinuosity).collect();
    assert!(these.len() > 25, "{slopes:?}: {}", these.len());
    median(these)
}

/// Over a width of travel no river turns by more than 60 degrees, but at few places.
#[test]
fn courses_have_no_corners() {
    let [mut sharp, mut all] = [0; 2];
    for course in courses(&plains()) {
        let ways = course
            .places
            .windows(2)
            .map(|p| [0, 1, 2].map(|i| p[1][i] - p[0][i]));
        let ways: Vec<Vector> = ways.collect();
        for pair in ways.windows(11) {
            let (u, v) = (pair[0], pair[10]);
            sharp += u32::from(cosine(u, v) < 0.5);
            all += 1;
        }
    }
    assert!(all > 10_000 && sharp * 500 < all, "{sharp} of {all}");
}

/// Along its middle a river is wet and nowhere rises, and its bed lies under it.
#[test]
fn water_falls_along_the_course() {
    let base = plains();
    let mut local = LocalGround::new(&base, &Rules::default());
    let [mut wet, mut all] = [0; 2];
    for course in courses(&base).iter().take(12) {
        let mut last = f64::MAX;
        for &place in course.places.iter().step_by(7) {
            // Fine enough that leaves know the bed, which coarser ones lay upon the ground.
            let (_, water) = local.leaf_with_water(unit(place), 16, None);
            all += 1;
            let Some(level) = water else { continue };
            // A larger river or a lake that it comes to stands no higher.
            assert!(level <= last + 0.05, "{level} {last}");
            last = level;
            wet += 1;
        }
    }
    assert!(all > 1_500 && wet * 100 > all * 97, "{wet} of {all}");
}

/// The way between two shares of a piece, metres.
fn chord(ground: &RefinedGround, segment: &RiverSegment, shares: [i32; 2]) -> Vector {
    let [a, b] = shares.map(|at| winding_place(ground, segment, at));
    [0, 1, 2].map(|i| b[i] - a[i])
}

/// Both pieces of a river at a vertex are there in one direction.
#[test]
fn pieces_join_in_one_direction() {
    let base = plains();
    let mut joints = 0;
    for k in 0..12 {
        let from = on_river(&base, k);
        let ground = refined(&base, &View::disc(from, 12_000, LEVEL));
        let pieces = segments(&ground, from);
        for pair in pieces.windows(2).filter(|p| p[0].ends[1] == p[1].ends[0]) {
            let u = chord(&ground, &pair[0], [65_200, 65_500]);
            let v = chord(&ground, &pair[1], [36, 336]);
            // 12 degrees.
            assert!(cosine(u, v) > 0.978, "{u:?} {v:?}");
            joints += 1;
        }
    }
    assert!(joints > 20, "{joints}");
}
