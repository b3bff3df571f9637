use super::*;
use crate::crust::{CrustKind, Frame};
use crate::params::TectonicParams;
use proptest::prelude::*;

/// Two plates, a hemisphere each.
fn two_plates(mesh: &SphereMesh) -> (Crust, Frames) {
    let mut crust = Crust::ocean(mesh.len(), &TectonicParams::default());
    for (frame, point) in crust.frame.iter_mut().zip(mesh.points()) {
        *frame = FrameId::from(point.x > 0.0);
    }
    let frames = [0, 1].map(|id| Frame {
        rotation: crate::math::rotation(DVec3::Z, 0.3 * f64::from(id)),
        ..Frame::at_rest(PlateId(id))
    });
    (crust, Frames(frames.to_vec()))
}

/// Terranes without their numbers, which depend on history, in an order that does not.
fn unnumbered(census: &TerraneCensus, frames: &Frames) -> Vec<Terrane> {
    let mut terranes: Vec<Terrane> = census.terranes(frames, 6370.0).collect();
    for terrane in &mut terranes {
        terrane.number = 0;
    }
    terranes.sort_by(|a, b| {
        a.centroid
            .to_array()
            .partial_cmp(&b.centroid.to_array())
            .unwrap()
    });
    terranes
}

proptest! {
    /// Islands that rise one after the other, grow and grow together are the terranes that a new
    /// census finds, to the bit.
    #[test]
    fn a_census_that_grows_equals_a_new_one(rising in prop::collection::vec(0_u32..600, 1..500)) {
        let mesh = SphereMesh::fibonacci(600).unwrap();
        let (mut crust, frames) = two_plates(&mesh);
        let mut census = TerraneCensus::new(&mesh, &crust);
        prop_assert_eq!(census.len(), 0);
        for together in rising.chunks(7) {
            for &i in together {
                if !crust.is_continental(i as usize) {
                    crust.kind[i as usize] = CrustKind::Continental;
                    census.grown.push(i);
                }
            }
            census.catch_up(&mesh, &crust);
            let anew = TerraneCensus::new(&mesh, &crust);
            prop_assert_eq!(unnumbered(&census, &frames), unnumbered(&anew, &frames));
        }
    }
}

/// Frames of two plates, and one more on each for what is broken off.
fn four_frames(frames: &Frames) -> Frames {
    Frames(frames.iter().chain(frames.iter()).copied().collect())
}

proptest! {
    /// Land that goes to another frame, in pieces of any shape, while other land rises, is counted
    /// as a new census counts it, to the bit.
    #[test]
    fn a_census_of_moving_land_equals_a_new_one(
        changes in prop::collection::vec((0_u32..600, 0_u32..40, 0_u16..4), 1..60),
    ) {
        let mesh = SphereMesh::fibonacci(600).unwrap();
        let (mut crust, frames) = two_plates(&mesh);
        let frames = four_frames(&frames);
        for i in 0..600 {
            let is_land = mesh.points()[i].z > 0.2 || i % 7 == 0;
            crust.kind[i] = [CrustKind::Oceanic, CrustKind::Continental][usize::from(is_land)];
        }
        let mut census = TerraneCensus::new(&mesh, &crust);
        for (first, count, frame) in changes {
            let moved = first..(first + count).min(600);
            for i in moved.clone() {
                crust.frame[i as usize] = frame;
            }
            census.moved.extend(moved);
            let risen = first as usize;
            if !crust.is_continental(risen) {
                crust.kind[risen] = CrustKind::Continental;
                census.grown.push(first);
            }
            census.catch_up(&mesh, &crust);
            let anew = TerraneCensus::new(&mesh, &crust);
            prop_assert_eq!(unnumbered(&census, &frames), unnumbered(&anew, &frames));
        }
    }
}

#[test]
fn a_planet_of_land_is_two_terranes_of_half_its_area() {
    let mesh = SphereMesh::fibonacci(3000).unwrap();
    let (mut crust, frames) = two_plates(&mesh);
    crust.kind.fill(CrustKind::Continental);
    let terranes: Vec<Terrane> = TerraneCensus::new(&mesh, &crust)
        .terranes(&frames, 1.0)
        .collect();
    let half = 2.0 * crate::math::PI;
    assert_eq!(terranes.len(), 2);
    for terrane in &terranes {
        assert!((terrane.area - half).abs() < 0.02 * half, "{terrane:?}");
    }
    // The frame of the second plate has turned by 0.3 about the pole.
    let second = terranes.iter().find(|terrane| terrane.frame == 1).unwrap();
    let middle = DVec3::new(crate::math::cos(0.3), crate::math::sin(0.3), 0.0);
    assert!(second.centroid.distance(middle) < 0.02, "{second:?}");
}
