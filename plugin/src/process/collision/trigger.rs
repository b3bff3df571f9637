//! Where continents overlap deeply enough to collide.

use super::suture::CollisionInput;
use crate::crust::{Crust, FrameId, Frames};
use crate::math::sin_cos;
use crate::plate::boundary::Rim;
use crate::plate::contact::{Contacts, Role};
use rayon::prelude::*;

/// Positions on the rim where continents of two plates converge, in order.
pub(super) fn meeting_continents(rim: &Rim, contacts: &Contacts, crust: &Crust) -> Vec<usize> {
    contacts
        .0
        .iter()
        .enumerate()
        .filter(|(k, contact)| {
            matches!(contact.role, Role::Overriding | Role::Subducting)
                && contact.other_continental
                && crust.is_continental(rim.samples[*k] as usize)
        })
        .map(|(k, _)| k)
        .collect()
}

impl CollisionInput<'_> {
    /// The first place of every pair of frames where continents overlap by `trigger` radians, in
    /// the order of the rim.
    pub(super) fn deep_overlaps(
        &self,
        meeting: &[usize],
        trigger: f64,
        crust: &Crust,
        frames: &Frames,
    ) -> Vec<usize> {
        let deep: Vec<usize> = meeting
            .par_iter()
            .with_min_len(64)
            .copied()
            .filter(|&k| self.overlap_by(k, trigger, crust, frames))
            .collect();
        let mut pairs: Vec<(FrameId, FrameId)> = Vec::new();
        let mut firsts = Vec::new();
        for k in deep {
            let own = crust.frame[self.rim.samples[k] as usize];
            let pair = (own, self.contacts.0[k].frame);
            // One collision moves the whole terrane, and with it the other places of the pair.
            if !pairs.contains(&pair) {
                pairs.push(pair);
                firsts.push(k);
            }
        }
        firsts
    }

    /// Whether the other plate's continent lies under rim sample `k` and for `length` radians
    /// behind it, against the relative motion; seen in steps of half a sample.
    fn overlap_by(&self, k: usize, length: f64, crust: &Crust, frames: &Frames) -> bool {
        let mesh = self.planet.mesh;
        let contact = &self.contacts.0[k];
        let sample = self.rim.samples[k];
        let frame = &frames[usize::from(crust.frame[sample as usize])];
        let p = mesh.point(sample);
        let Some(forward) = contact.relative.cross(p).try_normalize() else {
            return false;
        };
        let stride = 0.5 * mesh.spacing();
        // The far end first: most overlaps are short.
        (0..=(length / stride) as usize).rev().all(|step| {
            let (s, c) = sin_cos(stride * step as f64);
            let back = frame.to_world(p * c - forward * s);
            let hit = self.overlap.hit(mesh, crust, contact.frame, back);
            hit.is_some_and(|hit| crust.is_continental(hit.sample as usize))
        })
    }
}
