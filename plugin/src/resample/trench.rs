//! Trenches: where crust goes under it bends down towards z_t, over 150 to 200 km before the front.
//!
//! The bend is an offset that is derived anew from the contacts, never state: the uplift reads the
//! crust that is not bent, or the Andes would vanish. No profile is given in the papers; this is
//! level at the front and at its end.

use crate::crust::{Crust, CrustKind, Frames, Surface};
use crate::math::smoothstep;
use crate::params::TectonicParams;
use crate::plate::boundary::Rim;
use crate::plate::contact::{Contacts, Role};
use crate::sphere::SphereMesh;
use crate::sphere::nearest_source::{SourceScratch, nearest_sources};
use bevy::math::DVec3;

/// Plates that converge at this speed in km/My or faster have the deepest trenches.
pub const FULL_DEPTH_SPEED: f64 = 20.0;

/// Bends the oceanic crust of `surface` that goes under.
pub fn bend(
    mesh: &SphereMesh,
    crust: &Crust,
    frames: &Frames,
    rim: &Rim,
    contacts: &Contacts,
    params: &TectonicParams,
    radius: f64,
    surface: &mut Surface,
    scratch: &mut SourceScratch,
) {
    let mut fronts = Vec::new();
    let mut seeds: Vec<(u32, DVec3)> = Vec::new();
    for (k, contact) in contacts.0.iter().enumerate() {
        if contact.role == Role::Overriding && !contact.other_continental {
            let i = rim.samples[k];
            let frame = &frames[usize::from(crust.frame[i as usize])];
            let p = frame.to_world(mesh.point(i)).normalize();
            seeds.push((mesh.nearest(p), p));
            fronts.push((contact.other, f64::from(contact.approach)));
        }
    }
    let near = 0.5 * mesh.spacing();
    let width = params.trench_width / radius;
    let mut goes_under = vec![false; frames.len()];
    for (k, frame) in frames.iter().enumerate() {
        goes_under[k] = fronts.iter().any(|(under, _)| *under == frame.plate);
    }
    let (kind, top) = (&surface.crust.kind, &surface.crust.frame);
    let bends = |_, to: u32| {
        kind[to as usize] == CrustKind::Oceanic
            && goes_under.get(usize::from(top[to as usize])) == Some(&true)
    };
    let reached = nearest_sources(mesh, scratch, &seeds, width + near, bends);
    for ((&i, &source), &d) in reached
        .samples
        .iter()
        .zip(&reached.source)
        .zip(&reached.distance)
    {
        let i = i as usize;
        let (under, approach) = fronts[source as usize];
        if surface.plate[i] != under || surface.crust.kind[i] == CrustKind::Continental {
            continue;
        }
        let depth = profile((f64::from(d) - near) / width) * (approach / FULL_DEPTH_SPEED).min(1.0);
        let room = params.trench_elevation as f32 - surface.crust.elevation[i];
        surface.trench[i] = (room * depth as f32).min(0.0);
    }
}

/// Share of the way to z_t, at `x` widths from the front.
pub fn profile(x: f64) -> f64 {
    1.0 - smoothstep(x)
}

#[cfg(test)]
mod tests {
    use super::profile;

    #[test]
    fn the_bend_begins_level_and_ends_level() {
        assert_eq!(profile(-0.2), 1.0);
        assert_eq!(profile(0.0), 1.0);
        assert_eq!(profile(0.5), 0.5);
        assert_eq!(profile(1.0), 0.0);
        assert!(profile(0.01) > 0.999 && profile(0.99) < 0.001);
    }
}
