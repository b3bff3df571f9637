//! Distance to the subduction front on every overriding plate.
//!
//! The front is the rim of the overriding plate, so in that plate's frame it stands still. What a
//! step changes is which samples of the rim override: one that left the front is forgotten by all
//! that it was nearest to, and they hear from their neighbours again; one that is new spreads its
//! position. So a step costs what has changed, and the field remembers: it is state. It is found
//! anew on frames that gained or lost samples, and after a resample.
//!
//! Policies: distance is measured within one frame, around gaps but not across them. A sample that
//! overrides no more stays on the front for [`HOLD`] steps, without any uplift: what passes below
//! it often makes it override again.

use crate::crust::FrameId;
use crate::parallel;
use crate::plate::boundary::Rim;
use crate::plate::contact::{Contacts, Role};
use crate::sphere::SphereMesh;
use crate::sphere::nearest_source::{SourceField, UNREACHED, spread_on};
use bevy::prelude::*;
use rayon::prelude::*;

/// Steps after which a sample that overrides no more leaves the front.
pub const HOLD: u8 = 4;

/// Frames that spread between two looks at the clock.
const BATCH: usize = 8;

/// What a front is found from.
#[derive(Clone, Copy)]
pub struct FrontInput<'a> {
    /// Samples and triangles.
    pub mesh: &'a SphereMesh,
    /// The frame of every sample.
    pub frame: &'a [FrameId],
    /// The rims.
    pub rim: &'a Rim,
    /// What their samples meet.
    pub contacts: &'a Contacts,
    /// How far from the front distances are wanted, in radians.
    pub reach: f64,
}

/// The nearest sample of the front, for every sample on its frame.
#[derive(Component, Clone, Debug)]
pub struct FrontField {
    /// Whether everything must be found anew at the next step.
    pub stale: bool,
    /// How far from the front distances are known, in radians.
    pub(crate) reach: f64,
    /// The nearest sample of the front.
    pub(crate) nearest: SourceField,
    /// The samples of the front in order, each with the steps since it last overrode, below
    /// [`HOLD`].
    pub(crate) front: Vec<(u32, u8)>,
    /// Spreads of this step that are still to be done, one for each frame, the largest last. Never
    /// saved: it is empty between steps.
    pub(crate) pending: Option<Vec<Vec<(u32, u32)>>>,
}

impl FrontField {
    /// The field of `n` samples before any front was seen.
    pub fn new(n: usize) -> Self {
        Self {
            stale: true,
            reach: 0.0,
            nearest: SourceField::new(n),
            front: Vec::new(),
            pending: None,
        }
    }

    /// The sample of the front that is nearest to sample `i` of its frame, and the distance in
    /// radians.
    #[inline]
    pub fn nearest(&self, i: u32) -> Option<(u32, f32)> {
        self.nearest.nearest(i)
    }

    /// Forgets everything on frames that have gained or lost samples.
    pub fn forget(&mut self, frame: &[FrameId], touched: &[FrameId]) {
        let field = &self.nearest;
        parallel::chunks(frame.len()).for_each(|range| {
            let touched = range.filter(|&i| touched.contains(&frame[i]));
            touched.for_each(|i| field.reset(i as u32));
        });
    }

    /// Takes in which samples of the rim override now. Ends early where it should `stop`; called
    /// again in the same step it goes on. Returns whether it is done.
    pub fn refresh(&mut self, input: &FrontInput, stop: impl Fn() -> bool) -> bool {
        let &FrontInput {
            mesh, frame, reach, ..
        } = input;
        let mut pending = match self.pending.take() {
            Some(pending) => pending,
            None => self.begin(input),
        };
        let field = &self.nearest;
        let spread = |start: Vec<(u32, u32)>| {
            let open = |from: u32, to: u32| frame[from as usize] == frame[to as usize];
            spread_on(
                mesh,
                field,
                &start,
                reach,
                |source| mesh.point(source),
                open,
            );
        };
        while !pending.is_empty() {
            let rest = pending.len().saturating_sub(BATCH);
            pending.par_drain(rest..).with_max_len(1).for_each(spread);
            // Each call does some of the work, or one that is late would never end.
            if stop() && !pending.is_empty() {
                self.pending = Some(pending);
                return false;
            }
        }
        true
    }

    /// Finds what the spreads of this step start from.
    fn begin(&mut self, input: &FrontInput) -> Vec<Vec<(u32, u32)>> {
        let &FrontInput {
            mesh,
            frame,
            rim,
            contacts,
            reach,
        } = input;
        if self.stale || self.reach != reach {
            self.nearest.clear();
            self.front.clear();
            self.reach = reach;
            self.stale = false;
        }
        let gone = self.advance(rim, contacts);
        let mut start = self.cut_off(mesh, frame, &gone);
        let new = self
            .front
            .iter()
            .filter(|&&(i, _)| self.nearest.source(i) != i);
        start.extend(new.map(|&(i, _)| (i, i)));
        // Frames do not touch each other's samples: each spreads on its own.
        start.par_sort_unstable_by_key(|&(i, source)| (frame[i as usize], i, source));
        start.dedup();
        let frames = start.chunk_by(|a, b| frame[a.0 as usize] == frame[b.0 as usize]);
        let mut frames: Vec<_> = frames.map(<[_]>::to_vec).collect();
        frames.sort_by_key(Vec::len);
        frames
    }

    /// Takes in which samples override now. Returns those that have left the front.
    fn advance(&mut self, rim: &Rim, contacts: &Contacts) -> Vec<u32> {
        let mut gone = Vec::new();
        let mut front = Vec::with_capacity(self.front.len());
        let mut old = core::mem::take(&mut self.front).into_iter().peekable();
        let mut wait = |(i, age): (u32, u8), front: &mut Vec<(u32, u8)>| {
            if age + 1 < HOLD && self.nearest.source(i) == i {
                front.push((i, age + 1));
            } else {
                gone.push(i);
            }
        };
        let overriding = rim
            .samples
            .iter()
            .zip(&contacts.0)
            .filter(|(_, c)| c.role == Role::Overriding);
        for (&i, _) in overriding {
            while let Some(waiting) = old.next_if(|&(k, _)| k < i) {
                wait(waiting, &mut front);
            }
            old.next_if(|&(k, _)| k == i);
            front.push((i, 0));
        }
        old.for_each(|waiting| wait(waiting, &mut front));
        self.front = front;
        gone
    }

    /// Forgets what is nearest to the samples that are `gone`. Returns the samples around, from
    /// which what they hold goes on.
    fn cut_off(&self, mesh: &SphereMesh, frame: &[FrameId], gone: &[u32]) -> Vec<(u32, u32)> {
        if gone.is_empty() {
            return Vec::new();
        }
        let mut is_gone = vec![0_u64; mesh.len().div_ceil(64)];
        gone.iter()
            .for_each(|&i| is_gone[i as usize / 64] |= 1 << (i % 64));
        let field = &self.nearest;
        let lost = parallel::map_chunks(mesh.len(), |range| {
            let mut lost = Vec::new();
            for i in range.map(|i| i as u32) {
                let source = field.source(i);
                if source != UNREACHED && is_gone[source as usize / 64] >> (source % 64) & 1 == 1 {
                    field.reset(i);
                    lost.push(i);
                }
            }
            lost
        });
        let around = |i: &u32| {
            let own = frame[*i as usize];
            let ring = mesh
                .ring(*i)
                .iter()
                .filter(move |&&j| frame[j as usize] == own);
            ring.map(|&j| (j, field.source(j)))
                .filter(|&(_, source)| source != UNREACHED)
        };
        lost.iter().flatten().flat_map(around).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plate::contact::Contact;
    use crate::random::{Purpose, Stream};

    /// A rim of all samples in a band, of which those overrides that `overrides`.
    fn front(mesh: &SphereMesh, overrides: impl Fn(u32) -> bool) -> (Rim, Contacts) {
        let samples: Vec<u32> = (0..mesh.len() as u32)
            .filter(|&i| mesh.point(i).z.abs() < 0.02)
            .collect();
        let role = |&i: &u32| {
            if overrides(i) {
                Role::Overriding
            } else {
                Role::Sliding
            }
        };
        let contacts = samples
            .iter()
            .map(|i| Contact {
                role: role(i),
                ..default()
            })
            .collect();
        (
            Rim {
                samples,
                ..default()
            },
            Contacts(contacts),
        )
    }

    #[test]
    fn a_changing_front_is_followed_as_if_it_were_found_anew() {
        let mesh = SphereMesh::fibonacci(6000).unwrap();
        let frame: Vec<FrameId> = mesh.points().iter().map(|p| u16::from(p.x > 0.0)).collect();
        let (stream, reach) = (Stream::new(7, Purpose::Relief, 0), 0.4);
        let mut field = FrontField::new(mesh.len());
        for step in 0..40_u64 {
            // Segments of the front turn on and off, and single samples flicker.
            let segment =
                |i: u32, step: u64| (((mesh.point(i).y * 4.0 + 4.0) as u64) << 8) | (step / 7);
            let on = |i: u32, step: u64| {
                stream.unit(segment(i, step)) < 0.6
                    && stream.unit((u64::from(i) << 16) | step) < 0.8
            };
            let (rim, contacts) = front(&mesh, |i| on(i, step));
            let input = FrontInput {
                mesh: &mesh,
                frame: &frame,
                rim: &rim,
                contacts: &contacts,
                reach,
            };
            assert!(field.refresh(&input, || false));
            let held = |i: u32| (0..u64::from(HOLD)).any(|ago| ago <= step && on(i, step - ago));
            let sources: Vec<u32> = rim.samples.iter().copied().filter(|&i| held(i)).collect();
            let (mut wrong, mut reached) = (0, 0);
            for i in 0..mesh.len() as u32 {
                let p = mesh.point(i);
                let here = sources
                    .iter()
                    .filter(|&&s| frame[s as usize] == frame[i as usize]);
                let nearest = here
                    .map(|&s| crate::math::angle_between(p, mesh.point(s)))
                    .fold(f64::INFINITY, f64::min);
                let found = field
                    .nearest(i)
                    .map_or(f64::INFINITY, |(_, d)| f64::from(d));
                reached += usize::from(nearest < reach);
                if nearest < 0.999 * reach && (found - nearest).abs() > 1e-5 {
                    wrong += 1;
                    // As in any spread, a source cut off by others may be missed by a sample's
                    // width.
                    assert!(
                        (found - nearest).abs() < 0.3 * mesh.spacing(),
                        "{found} instead of {nearest}"
                    );
                }
                assert!(nearest < 1.001 * reach || found == f64::INFINITY);
            }
            assert!(50 * wrong < reached, "step {step}: {wrong} of {reached}");
        }
    }
}
