//! Which frames cover a point: frames, not moved points.
//!
//! A point is rotated into a frame; the frame covers it if the nearest sample of the lattice
//! belongs to that frame. Candidates come from tables of bins on a cube:
//!
//! | table | says | follows from |
//! |---|---|---|
//! | lattice, fine | which frames have samples in or near a bin | the samples of frames |
//! | lattice, coarse | the same | the samples of frames |
//! | world, coarse | which frames may cover a bin of the world | the coarse table and rotations |
//!
//! A look-up asks the world for candidates and the fine table about each of them, before it pays
//! for the nearest sample.
//!
//! Policies. *Several frames of one plate*: the terrane lies on top, of two terranes the later one.
//! *Several plates*: continental crust lies on top of oceanic; of equal kinds the polarity of the
//! front decides, and between plates that have not met the younger ocean floor, then the lower
//! plate number.

mod bins;
mod frame_set;
mod order;

pub use order::upper;

use super::polarity::PolarityMemory;
use crate::crust::{Crust, Frame};
use crate::ids::FrameId;
use crate::sphere::SphereMesh;
use bevy::math::{DMat3, DVec3};
use bevy::prelude::*;
use bins::{BINS_PER_TASK, LatticeBins};
use frame_set::{insert, members};
use rayon::prelude::*;
use std::sync::Arc;

/// Samples across a fine bin: wide enough to be touched by few samples, narrow enough to be missed
/// by most frames that do not cover a point.
const FINE_WIDTH: f64 = 3.0;

/// Samples across a coarse bin. More of them cost more at every turn than they save at look-ups.
const COARSE_WIDTH: f64 = 5.0;

/// Most coarse bins along the edge of a face.
const MOST_COARSE: f64 = 16.0;

/// A frame that covers a point.
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
pub struct FrameHit {
    /// The frame.
    pub frame: FrameId,
    /// The nearest sample of the lattice, which belongs to the frame.
    pub sample: u32,
    /// The point in lattice coordinates of the frame.
    pub local: DVec3,
}

/// Candidate tables for the frames of one planet.
#[derive(Component, Clone, Debug, Default)]
pub struct OverlapIndex {
    fine: Arc<LatticeBins>,
    coarse: Arc<LatticeBins>,
    /// Number of 64-bit words of a set of frames.
    words: usize,
    /// Frames with samples in or near each fine bin of the lattice.
    near: Vec<u64>,
    /// Frames that may cover each coarse bin of the world.
    world: Vec<u64>,
    /// Frames with samples in or near each coarse bin of the lattice.
    lattice: Vec<u64>,
    /// The way from the world to the lattice for every frame: a matrix turns a point at half the
    /// cost of a quaternion.
    to_lattice: Vec<DMat3>,
}

impl OverlapIndex {
    /// Builds all tables.
    pub fn new(mesh: &SphereMesh, frame: &[FrameId], frames: &[Frame]) -> Self {
        let mut index = Self::default();
        index.update(mesh, frame, frames);
        index
    }

    /// Updates all tables after frames have gained or lost samples.
    pub fn update(&mut self, mesh: &SphereMesh, frame: &[FrameId], frames: &[Frame]) {
        // Bins depend on the lattice alone and are shared by clones of a planet.
        if self.fine.samples() != mesh.len() {
            self.fine = Arc::new(LatticeBins::new(mesh, FINE_WIDTH, f64::INFINITY));
            self.coarse = Arc::new(LatticeBins::new(mesh, COARSE_WIDTH, MOST_COARSE));
        }
        self.words = frames.len().div_ceil(64).max(1);
        self.fine.mark(frame, self.words, &mut self.near);
        self.coarse.mark(frame, self.words, &mut self.lattice);
        self.turn(frames);
    }

    /// Updates the table of the world after frames have moved.
    pub fn turn(&mut self, frames: &[Frame]) {
        let to_lattice = |frame: &Frame| DMat3::from_quat(frame.rotation.conjugate());
        self.to_lattice.clear();
        self.to_lattice.extend(frames.iter().map(to_lattice));
        let blocks: Vec<Vec<(u32, u32)>> = (0..self.coarse.len().div_ceil(BINS_PER_TASK))
            .into_par_iter()
            .map(|block| self.turned_bins(block, frames))
            .collect();
        self.world.clear();
        self.world.resize(self.lattice.len(), 0);
        for (cell, id) in blocks.into_iter().flatten() {
            let start = cell as usize * self.words;
            insert(&mut self.world[start..start + self.words], id as usize);
        }
    }

    /// Pairs of bins of the world and frames that one block of bins of the lattice may cover.
    fn turned_bins(&self, block: usize, frames: &[Frame]) -> Vec<(u32, u32)> {
        let bins = &self.coarse;
        let mut found = Vec::with_capacity(16 * BINS_PER_TASK);
        let start = block * BINS_PER_TASK;
        for cell in start..(start + BINS_PER_TASK).min(bins.len()) {
            let (center, reach) = bins.shape(cell);
            for id in members(&self.lattice[cell * self.words..(cell + 1) * self.words]) {
                // Bins are turned instead of samples: a circle is a circle in every frame.
                let p = frames[id].to_world(center);
                let near = |at| found.push((at as u32, id as u32));
                bins.grid().visit_near(p, reach, near);
            }
        }
        found
    }

    /// The frames that may cover `p`.
    #[inline]
    fn candidates(&self, p: DVec3) -> &[u64] {
        let cell = self.coarse.grid().cell(p);
        &self.world[cell * self.words..(cell + 1) * self.words]
    }

    /// A vector of the world in lattice coordinates of a frame.
    #[inline]
    pub fn to_lattice(&self, id: FrameId, v: DVec3) -> DVec3 {
        self.to_lattice[usize::from(id)] * v
    }

    /// The frame's hit at the unit direction `p`, if it covers the point. Frames made since the
    /// last [`turn`](Self::turn) cover nothing yet.
    #[inline]
    pub fn hit(&self, mesh: &SphereMesh, crust: &Crust, id: FrameId, p: DVec3) -> Option<FrameHit> {
        // A frame at rest keeps the bits of `p`; the others keep its length as well as rounding
        // can.
        let local = *self.to_lattice.get(usize::from(id))? * p;
        let cell = self.fine.grid().cell(local);
        // The fine table says whether the frame has samples anywhere near.
        let word = self.near[cell * self.words + usize::from(id) / 64];
        // Most candidates end here, without a search.
        if word >> (id % 64) & 1 == 0 {
            return None;
        }
        let sample = mesh.nearest(local);
        (crust.frame[sample as usize] == id).then_some(FrameHit {
            frame: id,
            sample,
            local,
        })
    }

    /// The hit on top at the unit direction `p` among a choice of frames.
    #[inline]
    pub fn top_if(
        &self,
        mesh: &SphereMesh,
        crust: &Crust,
        frames: &[Frame],
        polarity: &PolarityMemory,
        p: DVec3,
        choice: impl Fn(&Frame) -> bool,
    ) -> Option<FrameHit> {
        let hits = members(self.candidates(p))
            .filter(|&id| choice(&frames[id]))
            .filter_map(|id| self.hit(mesh, crust, id as FrameId, p));
        hits.reduce(|top, hit| upper(crust, frames, polarity, top, hit, p))
    }

    /// The hits of all frames that cover the unit direction `p`, in order of their numbers.
    #[inline]
    pub fn covering(
        &self,
        mesh: &SphereMesh,
        crust: &Crust,
        p: DVec3,
    ) -> impl Iterator<Item = FrameHit> {
        members(self.candidates(p)).filter_map(move |id| self.hit(mesh, crust, id as FrameId, p))
    }
}
