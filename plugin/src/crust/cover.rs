//! Which frames cover a point: frames, not moved points.
//!
//! A point is rotated into a frame; the frame covers it if the nearest sample of the lattice belongs
//! to that frame. Candidates come from two coarse tables of bins on a cube: which frames have samples
//! in or near a bin of the lattice (renewed when frames gain or lose samples), and which of those bins
//! may lie over a bin of the world (renewed when frames move).
//!
//! Policies. *Several frames of one plate*: the terrane lies on top, of two terranes the later one.
//! *Several plates*: continental crust lies on top of oceanic; of equal kinds the polarity of the front
//! decides; where there is none, the younger ocean floor, then the lower plate number.

use super::bins::CubeGrid;
use super::columns::{Crust, CrustKind};
use super::frame::{Frame, FrameId};
use crate::parallel;
use crate::plate::contact::PolarityMemory;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use bevy::prelude::*;

/// A frame that covers a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The frame.
    pub frame: FrameId,
    /// The nearest sample of the lattice, which belongs to the frame.
    pub sample: u32,
    /// The point in lattice coordinates of the frame.
    pub local: DVec3,
}

/// The frames that cover a point; more than eight never matter.
#[derive(Clone, Copy, Debug)]
pub struct Hits {
    hits: [Hit; 8],
    len: usize,
}

impl Default for Hits {
    fn default() -> Self {
        Self { hits: [Hit { frame: 0, sample: 0, local: DVec3::ZERO }; 8], len: 0 }
    }
}

impl Hits {
    fn push(&mut self, hit: Hit) {
        if self.len < self.hits.len() {
            self.hits[self.len] = hit;
            self.len += 1;
        }
    }

    /// The hits in order of their frames.
    pub fn as_slice(&self) -> &[Hit] {
        &self.hits[..self.len]
    }
}

/// Candidate tables for the frames of one planet.
#[derive(Component, Clone, Debug)]
pub struct CoverIndex {
    grid: CubeGrid,
    /// Centre and radius, as a chord, of each bin.
    bins: Vec<(DVec3, f64)>,
    /// Number of 64-bit words of a set of frames.
    words: usize,
    /// Frames with samples in or near each bin of the lattice.
    lattice: Vec<u64>,
    /// Frames that may cover each bin of the world.
    world: Vec<u64>,
}

impl Default for CoverIndex {
    fn default() -> Self {
        Self { grid: CubeGrid::new(1), bins: Vec::new(), words: 0, lattice: Vec::new(), world: Vec::new() }
    }
}

impl CoverIndex {
    /// Builds both tables.
    pub fn new(mesh: &SphereMesh, frame: &[FrameId], frames: &[Frame]) -> Self {
        // Bins several samples wide are touched by few samples; more of them cost more at every turn
        // than they save at look-ups.
        let cells = ((mesh.len() as f64 / 6.0).sqrt() / 5.0).clamp(2.0, 20.0) as usize;
        let grid = CubeGrid::new(cells);
        let words = frames.len().div_ceil(64).max(1);
        let bins = (0..grid.len()).map(|cell| (grid.center(cell), grid.radius(cell))).collect();
        let mut index = Self { grid, bins, words, lattice: Vec::new(), world: Vec::new() };
        index.lattice = index.mark_lattice(mesh, frame);
        index.turn(frames);
        index
    }

    fn mark_lattice(&self, mesh: &SphereMesh, frame: &[FrameId]) -> Vec<u64> {
        let size = self.grid.len() * self.words;
        // No point is farther from its nearest sample than the circumradius of a triangle; Fibonacci
        // triangles stay below one spacing, and random points are not resampled.
        let reach = 1.1 * mesh.spacing();
        let block = 64 * parallel::CHUNK;
        let parts = {
            use rayon::prelude::*;
            (0..mesh.len().div_ceil(block))
                .into_par_iter()
                .map(|b| {
                    let mut marks = vec![0u64; size];
                    let end = ((b + 1) * block).min(mesh.len());
                    for (&p, &id) in mesh.points()[b * block..end].iter().zip(&frame[b * block..end]) {
                        let id = usize::from(id);
                        self.grid.visit_near(p, reach, |cell| {
                            marks[cell * self.words + id / 64] |= 1 << (id % 64);
                        });
                    }
                    marks
                })
                .collect::<Vec<_>>()
        };
        parts.into_iter().fold(vec![0; size], |mut all, part| {
            all.iter_mut().zip(part).for_each(|(a, b)| *a |= b);
            all
        })
    }

    /// Renews the table of the world after frames have moved.
    pub fn turn(&mut self, frames: &[Frame]) {
        let mut world = vec![0u64; self.lattice.len()];
        for cell in 0..self.grid.len() {
            let marks = &self.lattice[cell * self.words..(cell + 1) * self.words];
            let (center, reach) = self.bins[cell];
            for id in ones(marks) {
                let p = frames[id].to_world(center);
                self.grid.visit_near(p, reach, |at| {
                    world[at * self.words + id / 64] |= 1 << (id % 64);
                });
            }
        }
        self.world = world;
    }

    /// The bin of the world that holds `p`.
    #[inline]
    fn candidates(&self, p: DVec3) -> &[u64] {
        let cell = self.grid.cell(p);
        &self.world[cell * self.words..(cell + 1) * self.words]
    }

    /// The frame's hit at `p`, if it covers the point.
    #[inline]
    pub fn hit(
        &self,
        mesh: &SphereMesh,
        crust: &Crust,
        frames: &[Frame],
        id: FrameId,
        p: DVec3,
    ) -> Option<Hit> {
        let frame = &frames[usize::from(id)];
        let local = if frame.is_at_rest() { p } else { frame.to_lattice(p).normalize() };
        let cell = self.grid.cell(local);
        let word = self.lattice[cell * self.words + usize::from(id) / 64];
        if word >> (id % 64) & 1 == 0 {
            return None;
        }
        let sample = mesh.nearest(local);
        (crust.frame[sample as usize] == id).then_some(Hit { frame: id, sample, local })
    }

    /// All frames that cover the unit direction `p`, in order of their numbers.
    pub fn covering(&self, mesh: &SphereMesh, crust: &Crust, frames: &[Frame], p: DVec3) -> Hits {
        self.covering_if(mesh, crust, frames, p, |_| true)
    }

    /// The frames of a choice that cover the unit direction `p`, in order of their numbers.
    pub fn covering_if(
        &self,
        mesh: &SphereMesh,
        crust: &Crust,
        frames: &[Frame],
        p: DVec3,
        choice: impl Fn(&Frame) -> bool,
    ) -> Hits {
        let mut hits = Hits::default();
        for id in ones(self.candidates(p)) {
            if choice(&frames[id])
                && let Some(hit) = self.hit(mesh, crust, frames, id as FrameId, p)
            {
                hits.push(hit);
            }
        }
        hits
    }
}

/// Positions of the ones in a set.
fn ones(words: &[u64]) -> impl Iterator<Item = usize> + '_ {
    words.iter().enumerate().flat_map(|(k, &word)| {
        let mut rest = word;
        core::iter::from_fn(move || {
            let bit = rest.trailing_zeros() as usize;
            rest &= rest.wrapping_sub(1);
            (bit < 64).then_some(k * 64 + bit)
        })
    })
}

/// Whether the crust of `a` lies on top of that of `b` at `p`.
pub fn overrides(
    crust: &Crust,
    frames: &[Frame],
    polarity: &PolarityMemory,
    a: Hit,
    b: Hit,
    p: DVec3,
) -> bool {
    let (fa, fb) = (&frames[usize::from(a.frame)], &frames[usize::from(b.frame)]);
    if fa.plate == fb.plate {
        return (fa.terrane, a.frame) > (fb.terrane, b.frame);
    }
    let (i, j) = (a.sample as usize, b.sample as usize);
    match (crust.kind[i], crust.kind[j]) {
        (CrustKind::Continental, CrustKind::Oceanic) => true,
        (CrustKind::Oceanic, CrustKind::Continental) => false,
        _ => match polarity.under(fa.plate, fb.plate, p) {
            Some(under) => under == fb.plate,
            None => {
                let (age_a, age_b) = (crust.ocean_age[i], crust.ocean_age[j]);
                if age_a == age_b { fa.plate < fb.plate } else { age_a < age_b }
            }
        },
    }
}

/// The hit that lies on top at `p`; none if nothing covers the point.
pub fn topmost(
    crust: &Crust,
    frames: &[Frame],
    polarity: &PolarityMemory,
    hits: &Hits,
    p: DVec3,
) -> Option<Hit> {
    hits.as_slice()
        .iter()
        .copied()
        .reduce(|top, hit| if overrides(crust, frames, polarity, hit, top, p) { hit } else { top })
}
