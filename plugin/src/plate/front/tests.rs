//! A front that changes is followed as if it were found anew.

use super::*;
use crate::math::angle_between;
use crate::plate::contact::Contact;
use crate::random::{Purpose, Stream};

const REACH: f64 = 0.4;

/// The samples in a band around the equator.
fn band(mesh: &SphereMesh) -> Rim {
    let samples = (0..mesh.len() as u32).filter(|&i| mesh.point(i).z.abs() < 0.02);
    Rim {
        samples: samples.collect(),
        ..default()
    }
}

/// Contacts of a rim, of which those samples override that `overrides`.
fn contacts(rim: &Rim, overrides: impl Fn(u32) -> bool) -> Contacts {
    let mut contacts = vec![Contact::default(); rim.len()];
    for (contact, &i) in contacts.iter_mut().zip(&rim.samples) {
        if overrides(i) {
            contact.role = Role::Overriding;
        }
    }
    Contacts(contacts)
}

/// Whether sample `i` overrides in a step: segments turn on and off, and single samples flicker.
fn overrides(mesh: &SphereMesh, stream: Stream, i: u32, step: u64) -> bool {
    let segment = (((mesh.point(i).y * 4.0 + 4.0) as u64) << 8) | (step / 7);
    stream.unit(segment) < 0.6 && stream.unit((u64::from(i) << 16) | step) < 0.8
}

/// Compares the field with the distances to all `sources` on the same frame.
fn check(input: &FrontInput, field: &FrontField, sources: &[u32]) {
    let mesh = input.mesh;
    let mut wrong = 0;
    let mut reached = 0;
    for i in 0..mesh.len() as u32 {
        let own = sources.iter().filter(|&&s| input.together(s, i));
        let angles = own.map(|&s| angle_between(mesh.point(i), mesh.point(s)));
        let nearest = angles.fold(f64::INFINITY, f64::min);
        let found = field.nearest(i);
        let found = found.map_or(f64::INFINITY, |(_, distance)| f64::from(distance));
        reached += usize::from(nearest < REACH);
        if nearest < 0.999 * REACH && (found - nearest).abs() > 1e-5 {
            wrong += 1;
            // As in any search, a source cut off by others may be missed by a sample's width.
            let off = (found - nearest).abs();
            assert!(off < 0.3 * mesh.spacing(), "{found} instead of {nearest}");
        }
        assert!(nearest < 1.001 * REACH || found == f64::INFINITY);
    }
    assert!(50 * wrong < reached, "{wrong} of {reached}");
}

#[test]
fn a_changing_front_is_followed_as_if_it_were_found_anew() {
    let mesh = SphereMesh::fibonacci(6000).unwrap();
    let frame: Vec<FrameId> = mesh.points().iter().map(|p| u16::from(p.x > 0.0)).collect();
    let rim = band(&mesh);
    let stream = Stream::new(7, Purpose::Relief, 0);
    let mut field = FrontField::new(mesh.len());
    for step in 0..40_u64 {
        let contacts = contacts(&rim, |i| overrides(&mesh, stream, i, step));
        let input = FrontInput {
            mesh: &mesh,
            frame: &frame,
            rim: &rim,
            contacts: &contacts,
            reach: REACH,
        };
        assert!(field.follow(&input, || false));
        let since = step.saturating_sub(u64::from(STEPS_ON_FRONT) - 1);
        let is_source = |&i: &u32| (since..=step).any(|step| overrides(&mesh, stream, i, step));
        let sources: Vec<u32> = rim.samples.iter().copied().filter(is_source).collect();
        check(&input, &field, &sources);
    }
}
