use super::*;
use crate::math::{direction, rotation};
use crate::random::Purpose;

fn warp(amplitude: f64) -> Warp {
    Warp {
        noise: Noise::new(1, Purpose::RiftWarp, 0),
        amplitude,
        frequency: 6.0,
    }
}

fn cap(center: DVec3, reach: f64) -> Vec<DVec3> {
    let stream = Stream::new(2, Purpose::RiftShape, 0);
    (0..4000)
        .map(|i| (center + stream.direction(i) * reach).normalize())
        .filter(|p| angle_between(*p, center) < reach)
        .collect()
}

/// Normal velocity across every line is positive: fragments move away from each other wherever they
/// touch.
fn opens(shape: &RiftShape, plate: &[DVec3], far_end: bool) {
    let motions = shape.motions(plate, 0.006, far_end).unwrap();
    let mut touching = 0;
    for p in plate {
        let (a, _) = shape.split(*p, 1.0);
        for k in 0..6 {
            let (s, c) = sin_cos(TAU * f64::from(k) / 6.0);
            let t = any_tangent(*p);
            let step = (t * c + p.cross(t) * s) * 0.01;
            let q = (*p + step).normalize();
            let (b, _) = shape.split(q, 1.0);
            if a != b {
                touching += 1;
                // Over 20 My neither fragment may run into the other: points of a moved by its
                // motion relative to b stay in a.
                let relative = motions[a] - motions[b];
                for age in [2.0, 10.0, 20.0] {
                    let moved = rotation(relative.normalize(), relative.length() * age) * *p;
                    assert_ne!(shape.split(moved, 1.0).0, b, "{p} enters after {age} My");
                }
            }
        }
    }
    assert!(touching > 20);
}

#[test]
fn all_shapes_open() {
    let center = direction(20.0, 50.0);
    let plate = cap(center, 0.5);
    let stream = Stream::new(4, Purpose::RiftShape, 7);
    for counter in 0..6 {
        for far_end in [false, true] {
            let shape = RiftShape::random(&stream, counter, center, 0.5, 2, warp(0.05));
            opens(&shape, &plate, far_end);
        }
    }
    for fragments in [3, 4] {
        let shape = RiftShape::random(&stream, 9, center, 0.5, fragments, warp(0.0));
        assert_eq!(shape.fragments(), fragments as usize);
        opens(&shape, &plate, false);
    }
    let points = vec![
        direction(0.0, 40.0),
        direction(20.0, 48.0),
        direction(40.0, 60.0),
    ];
    opens(
        &RiftShape::Path {
            points,
            warp: warp(0.01),
        },
        &plate,
        true,
    );
}

#[test]
fn the_gap_grows_with_the_distance_from_the_pole() {
    let shape = RiftShape::Line {
        center: DVec3::Z,
        radius: 0.5 * PI,
        origin: DVec3::X,
        all_round: false,
        warp: warp(0.0),
    };
    let plate = cap(DVec3::X, 0.4);
    let motions = shape.motions(&plate, 0.006, true).unwrap();
    let relative = motions[0] - motions[1];
    let opening = |lon: f64| relative.cross(direction(0.0, lon)).dot(DVec3::Z);
    assert!(opening(20.0) > 0.0);
    assert!(opening(0.0) > opening(20.0) && opening(-20.0) > opening(0.0));
    assert!((opening(-22.9) - 0.006).abs() < 2e-4);
}

#[test]
fn a_path_is_followed_and_extended() {
    let points = vec![
        direction(0.0, 0.0),
        direction(0.0, 10.0),
        direction(10.0, 20.0),
    ];
    let shape = RiftShape::Path {
        points,
        warp: warp(0.0),
    };
    for (lat, lon, left) in [
        (1.0, 5.0, 0),
        (-1.0, 5.0, 1),
        (1.0, -30.0, 0),
        (-1.0, -30.0, 1),
        (9.0, 14.0, 0),
        (1.0, 16.0, 1),
    ] {
        assert_eq!(shape.split(direction(lat, lon), 1.0).0, left, "{lat} {lon}");
    }
    assert!((shape.split(direction(2.0, 5.0), 1.0).1 - 2.0_f64.to_radians()).abs() < 1e-9);
}

/// Bites all round the border of a cap of `extent` radians about `center`, at 30° S, 70° E.
fn bites(stream: &Stream, center: DVec3, extent: f64) -> impl Iterator<Item = RiftShape> {
    (0..48).map(move |k| {
        let at = rotation(center, 0.7 * k as f64) * direction(-30.0 + extent.to_degrees(), 70.0);
        let outward = (at * at.dot(center) - center).normalize();
        RiftShape::bite(stream, k, at, outward, warp(0.05))
    })
}

/// Share of a plate that a shape gives to the first fragment.
fn first_share(shape: &RiftShape, plate: &[DVec3]) -> f64 {
    let first = plate.iter().filter(|p| shape.split(**p, 0.0).0 == 0);
    first.count() as f64 / plate.len() as f64
}

#[test]
fn plates_wider_than_half_the_sphere_shed_bites() {
    let stream = Stream::new(5, Purpose::RiftShape, 3);
    let center = direction(-30.0, 70.0);
    for extent in [1.6, 1.75, 1.9_f64] {
        let all = (0..12_000).map(|i| Stream::new(2, Purpose::RiftShape, 0).direction(i));
        let plate: Vec<DVec3> = all.filter(|p| angle_between(*p, center) < extent).collect();
        let line = |counter| RiftShape::random(&stream, counter, center, 1.0, 2, warp(0.05));
        assert!(
            (0..8).all(|k| line(k).motions(&plate, 0.006, true).is_none()),
            "no great circle opens"
        );
        let good: Vec<_> = bites(&stream, center, extent)
            .filter(|bite| {
                (0.025..0.975).contains(&first_share(bite, &plate))
                    && bite.motions(&plate, 0.006, true).is_some()
            })
            .collect();
        eprintln!("{extent} {}", good.len());
        assert!(good.len() >= 8, "{extent}: {}", good.len());
        for bite in good {
            opens(&bite, &plate, true);
        }
    }
}

#[test]
fn a_plate_all_round_opens_along_half_of_a_circle() {
    let stream = Stream::new(6, Purpose::RiftShape, 1);
    let all: Vec<DVec3> = (0..4000).map(|i| stream.direction(i)).collect();
    for counter in 0..4 {
        let shape = RiftShape::halves(&stream, counter, warp(0.0));
        let first = all.iter().filter(|p| shape.split(**p, 0.0).0 == 0).count();
        assert!((1900..2100).contains(&first), "{first}");
        let motions = shape.motions(&all, 0.006, counter % 2 == 0).unwrap();
        let RiftShape::Line { center, .. } = shape else {
            panic!("a line")
        };
        let (mut opening, mut closing) = (0, 0);
        for p in all.iter().filter(|p| p.dot(center).abs() < 0.05) {
            let apart = (motions[0] - motions[1]).cross(*p).dot(center);
            if apart > 0.0 {
                opening += 1
            } else {
                closing += 1
            }
            assert!(apart.abs() < 0.0061);
        }
        assert!(opening > 60 && closing > 60, "{opening} {closing}");
    }
}
