//! Distance to the subduction front on every overriding plate.
//!
//! The front is the rim of the overriding plate, so it stands still in that plate's frame. From one
//! step to the next only a few samples of the rim join it or leave it, and the work of a step is
//! that of these changes. Where a sample has left, those that it was nearest to forget it, and the
//! search goes on from their neighbours that know another; where a sample has joined, the search
//! goes on from it. So the field depends on earlier steps and is saved with the state. It is found
//! anew on frames that gained or lost samples, and everywhere after a resample.
//!
//! Policies: distance is measured within one frame, around gaps but not across them. A sample that
//! overrides no more stays on the front for [`STEPS_ON_FRONT`] steps, without any uplift: what
//! passes below it often makes it override again.

use crate::crust::FrameId;
use crate::parallel;
use crate::plate::boundary::Rim;
use crate::plate::contact::{Contacts, Role};
use crate::sphere::SphereMesh;
use crate::sphere::nearest_source::{SourceField, UNREACHED, extend_nearest_sources};
use bevy::prelude::*;
use rayon::prelude::*;

/// Steps after which a sample that overrides no more leaves the front.
pub const STEPS_ON_FRONT: u8 = 4;

/// Frames that are searched between two looks at the clock.
const FRAMES_PER_LOOK: usize = 8;

/// Where a search starts: a sample, and the sample of the front that it hands on.
type Start = (u32, u32);

/// The state that a front is found from.
#[derive(Clone, Copy)]
pub struct FrontInput<'a> {
    /// Samples and triangles.
    pub mesh: &'a SphereMesh,
    /// The frame of every sample.
    pub frame: &'a [FrameId],
    /// The rims.
    pub rim: &'a Rim,
    /// The contacts of their samples.
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
    /// [`STEPS_ON_FRONT`].
    pub(crate) front: Vec<(u32, u8)>,
    /// Searches of this step that are still to be done, one for each frame, the largest last. Never
    /// saved: `None` between steps.
    pub(crate) pending: Option<Vec<Vec<Start>>>,
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

    /// Brings the field up to the samples of the rim that override now. Returns early, with false,
    /// where `stop` says so; the next call of the same step goes on. True when it is done.
    pub fn follow(&mut self, input: &FrontInput, stop: impl Fn() -> bool) -> bool {
        let mut pending = match self.pending.take() {
            Some(pending) => pending,
            None => self.begin(input),
        };
        let field = &self.nearest;
        while !pending.is_empty() {
            let rest = pending.len().saturating_sub(FRAMES_PER_LOOK);
            // Frames differ much in size: each is a task of its own.
            let batch = pending.par_drain(rest..).with_max_len(1);
            batch.for_each(|start| input.search(field, &start));
            // Each call does some of the work, or one that is late would never end.
            if stop() && !pending.is_empty() {
                self.pending = Some(pending);
                return false;
            }
        }
        true
    }

    /// Finds where the searches of this step start.
    fn begin(&mut self, input: &FrontInput) -> Vec<Vec<Start>> {
        if self.stale || self.reach != input.reach {
            self.nearest.clear();
            self.front.clear();
            self.reach = input.reach;
            self.stale = false;
        }
        let gone = self.advance(input.rim, input.contacts);
        let mut start = self.forget_gone(input, &gone);
        let front = self.front.iter().map(|&(i, _)| i);
        // A sample that has been on the front for a while is its own nearest.
        let new = front.filter(|&i| self.nearest.source(i) != i);
        start.extend(new.map(|i| (i, i)));
        // Frames do not touch each other's samples: each is searched on its own.
        let frame_of = |i: u32| input.frame[i as usize];
        start.par_sort_unstable_by_key(|&(i, source)| (frame_of(i), i, source));
        start.dedup();
        let by_frame = start.chunk_by(|a, b| frame_of(a.0) == frame_of(b.0));
        let mut by_frame: Vec<_> = by_frame.map(<[_]>::to_vec).collect();
        // Batches are taken from the end: the largest first, so that no thread waits for one at
        // last.
        by_frame.sort_by_key(Vec::len);
        by_frame
    }

    /// Updates the front to the samples that override now. Returns those that have left it.
    fn advance(&mut self, rim: &Rim, contacts: &Contacts) -> Vec<u32> {
        let mut gone = Vec::new();
        let mut front = Vec::with_capacity(self.front.len());
        let mut old = core::mem::take(&mut self.front).into_iter().peekable();
        let roles = contacts.0.iter().map(|contact| contact.role);
        let overriding = rim.samples.iter().zip(roles);
        for (&i, _) in overriding.filter(|&(_, role)| role == Role::Overriding) {
            // Both lists are in sample order: what the old front has before this sample overrides
            // no more.
            while let Some(waiting) = old.next_if(|&(k, _)| k < i) {
                self.wait(waiting, &mut front, &mut gone);
            }
            old.next_if(|&(k, _)| k == i);
            front.push((i, 0));
        }
        old.for_each(|waiting| self.wait(waiting, &mut front, &mut gone));
        self.front = front;
        gone
    }

    /// Keeps a sample that overrides no more on the front for one more step, or lets it go. One
    /// that was forgotten with its frame is no source any more.
    fn wait(&self, (i, age): (u32, u8), front: &mut Vec<(u32, u8)>, gone: &mut Vec<u32>) {
        if age + 1 < STEPS_ON_FRONT && self.nearest.source(i) == i {
            front.push((i, age + 1));
        } else {
            gone.push(i);
        }
    }

    /// Forgets the samples `gone` wherever they are nearest. Returns the samples around the places
    /// that forgot, each with the source that it knows, to search on from.
    fn forget_gone(&self, input: &FrontInput, gone: &[u32]) -> Vec<Start> {
        if gone.is_empty() {
            return Vec::new();
        }
        let n = input.mesh.len();
        let mut is_gone = vec![0_u64; n.div_ceil(64)];
        for &i in gone {
            is_gone[i as usize / 64] |= 1 << (i % 64);
        }
        let is_gone = |i: u32| is_gone[i as usize / 64] >> (i % 64) & 1 == 1;
        let field = &self.nearest;
        let lost = parallel::map_chunks(n, |range| {
            let mut lost = Vec::new();
            for i in range.map(|i| i as u32) {
                let source = field.source(i);
                if source != UNREACHED && is_gone(source) {
                    field.reset(i);
                    lost.push(i);
                }
            }
            lost
        });
        // Only after all are forgotten: what a neighbour still holds is good then.
        let lost = lost.iter().flatten();
        lost.flat_map(|&i| input.known_around(field, i)).collect()
    }
}

impl FrontInput<'_> {
    /// Whether two samples are on one frame.
    fn together(&self, i: u32, j: u32) -> bool {
        self.frame[i as usize] == self.frame[j as usize]
    }

    /// Hands sources on from `start` within their frame.
    fn search(&self, field: &SourceField, start: &[Start]) {
        extend_nearest_sources(
            self.mesh,
            field,
            start,
            self.reach,
            |source| self.mesh.point(source),
            |from, to| self.together(from, to),
        );
    }

    /// The neighbours of sample `i` on its frame that know a source, each with that source.
    fn known_around(&self, field: &SourceField, i: u32) -> impl Iterator<Item = Start> {
        let ring = self.mesh.ring(i).iter().copied();
        ring.filter(move |&j| self.together(i, j))
            .map(|j| (j, field.source(j)))
            .filter(|&(_, source)| source != UNREACHED)
    }
}

#[cfg(test)]
mod tests;
