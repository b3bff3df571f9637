//! Trenches: where crust goes under it bends down towards z_t, over 150 to 200 km before the front.
//!
//! The bend is an offset that is derived anew from the contacts, never state: the uplift reads the
//! crust that is not bent, or the Andes would vanish. No profile is given in the papers; this one
//! is level at the front and at its end.

use crate::crust::{Crust, CrustKind, Frame, Frames, Surface};
use crate::ids::PlateId;
use crate::math::smoothstep;
use crate::plate::boundary::Rim;
use crate::plate::contact::Contacts;
use crate::sphere::nearest_source::{SourceScratch, nearest_sources};
use crate::view::PlanetView;
use bevy::math::DVec3;

/// The state from which trenches follow.
pub(super) struct TrenchInput<'a> {
    /// Samples, parameters, size.
    pub planet: PlanetView<'a>,
    /// The crust in its frames.
    pub crust: &'a Crust,
    /// Frames.
    pub frames: &'a Frames,
    /// Rims of the frames.
    pub rim: &'a Rim,
    /// Contacts of the rims.
    pub contacts: &'a Contacts,
}

impl TrenchInput<'_> {
    /// Offset in km, not positive, of floor at `z` km that is bent by the share `depth` of its way
    /// to z_t.
    fn offset(&self, z: f32, depth: f64) -> f32 {
        let room = self.planet.params.trench_elevation as f32 - z;
        // Floor below z_t already is not lifted.
        (room * depth as f32).min(0.0)
    }
}

/// A place of a front under which ocean floor sinks.
struct SinkingFront {
    /// The plate that goes under.
    plate: PlateId,
    /// Speed at which the plates approach each other in km/My.
    approach: f64,
}

impl SinkingFront {
    /// Share of the way to z_t that floor is bent, at `x` widths from the front, where trenches
    /// have their full depth from `full_speed` km/My on.
    fn depth(&self, x: f64, full_speed: f64) -> f64 {
        let fast = (self.approach / full_speed).min(1.0);
        profile(x) * fast
    }
}

/// Bends the oceanic crust of `surface` that goes under.
pub(super) fn bend(input: &TrenchInput, surface: &mut Surface, scratch: &mut SourceScratch) {
    let mesh = input.planet.mesh;
    let (fronts, seeds) = sinking_fronts(input);
    // Front samples belong to the overriding plate, on average half a spacing behind the front.
    let behind = 0.5 * mesh.spacing();
    let width = input.planet.params.trench_width / input.planet.radius;
    let full_speed = input.planet.params.trench_speed;
    let goes_under = frames_going_under(input.frames, &fronts);
    let reached = nearest_sources(mesh, scratch, &seeds, width + behind, |_, to| {
        is_sinking_floor(&surface.crust, &goes_under, to as usize)
    });
    let nearest = reached.source.iter().zip(&reached.distance);
    for (&i, (&source, &d)) in reached.samples.iter().zip(nearest) {
        let i = i as usize;
        let front = &fronts[source as usize];
        // The search runs over all plates that go under; each bends at its own fronts alone.
        if surface.plate[i] != front.plate || surface.crust.kind[i] == CrustKind::Continental {
            continue;
        }
        let depth = front.depth((f64::from(d) - behind) / width, full_speed);
        surface.trench[i] = input.offset(surface.crust.elevation[i], depth);
    }
}

/// Whether each frame belongs to a plate that goes under somewhere.
fn frames_going_under(frames: &Frames, fronts: &[SinkingFront]) -> Vec<bool> {
    let goes_under = |frame: &Frame| fronts.iter().any(|front| front.plate == frame.plate);
    frames.iter().map(goes_under).collect()
}

/// Whether sample `i` is ocean floor on one of the frames that go under.
fn is_sinking_floor(crust: &Crust, goes_under: &[bool], i: usize) -> bool {
    crust.kind[i] == CrustKind::Oceanic
        && goes_under.get(usize::from(crust.frame[i])) == Some(&true)
}

/// Places where ocean floor goes under, and the samples below them with their exact directions.
fn sinking_fronts(input: &TrenchInput) -> (Vec<SinkingFront>, Vec<(u32, DVec3)>) {
    let mesh = input.planet.mesh;
    let mut fronts = Vec::new();
    let mut seeds = Vec::new();
    for (k, contact) in input.contacts.0.iter().enumerate() {
        if contact.is_over_sinking_floor() {
            let i = input.rim.samples[k];
            let frame = &input.frames[usize::from(input.crust.frame[i as usize])];
            let p = frame.to_world(mesh.point(i)).normalize();
            seeds.push((mesh.nearest(p), p));
            fronts.push(SinkingFront {
                plate: contact.other,
                approach: f64::from(contact.approach),
            });
        }
    }
    (fronts, seeds)
}

/// Share of the way to z_t at `x` widths from a fast front.
fn profile(x: f64) -> f64 {
    1.0 - smoothstep(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slow_trenches_are_shallow() {
        let plate = PlateId(1);
        let front = |approach| SinkingFront { plate, approach };
        let depths = [10.0, 40.0, 90.0].map(|approach| front(approach).depth(0.0, 40.0));
        assert_eq!(depths, [0.25, 1.0, 1.0]);
    }

    #[test]
    fn the_bend_begins_level_and_ends_level() {
        assert_eq!(profile(-0.2), 1.0);
        assert_eq!(profile(0.0), 1.0);
        assert_eq!(profile(0.5), 0.5);
        assert_eq!(profile(1.0), 0.0);
        assert!(profile(0.01) > 0.999 && profile(0.99) < 0.001);
    }
}
