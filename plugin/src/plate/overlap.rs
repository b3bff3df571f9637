//! Which frames cover a point: frames, not moved points.
//!
//! A point is rotated into a frame; the frame covers it if the nearest sample of the lattice
//! belongs to that frame. Candidates come from tables of bins on a cube: which frames have samples
//! in or near a bin of the lattice (renewed when frames gain or lose samples; fine for look-ups,
//! coarse for what follows), and which of the coarse ones may lie over a bin of the world (renewed
//! when frames move).
//!
//! Policies. *Several frames of one plate*: the terrane lies on top, of two terranes the later one.
//! *Several plates*: continental crust lies on top of oceanic; of equal kinds the polarity of the
//! front decides; where there is none, the younger ocean floor, then the lower plate number.

use super::polarity::PolarityMemory;
use crate::crust::{Crust, CrustKind, Frame};
use crate::ids::FrameId;
use crate::parallel;

use crate::sphere::SphereMesh;
use crate::sphere::bins::CubeGrid;
use bevy::math::{DMat3, DVec3};
use bevy::prelude::*;
use rayon::prelude::*;
use std::sync::Arc;

/// A frame that covers a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameHit {
    /// The frame.
    pub frame: FrameId,
    /// The nearest sample of the lattice, which belongs to the frame.
    pub sample: u32,
    /// The point in lattice coordinates of the frame.
    pub local: DVec3,
}

/// What never changes about the bins of a lattice.
#[derive(Debug)]
struct Bins {
    grid: CubeGrid,
    /// Centre and radius, as a chord, of each bin.
    shape: Vec<(DVec3, f64)>,
    /// Where the samples of each bin begin in `samples`, and where the last ones end.
    start: Vec<u32>,
    /// The samples in or near each bin, in order.
    samples: Vec<u32>,
    /// Number of samples of the lattice.
    lattice: usize,
}

impl Bins {
    /// Bins that are `width` samples wide, but no more than `most` along the edge of a face.
    fn new(mesh: &SphereMesh, width: f64, most: f64) -> Self {
        let cells = ((mesh.len() as f64 / 6.0).sqrt() / width).clamp(2.0, most) as usize;
        let grid = CubeGrid::new(cells);
        let shape = (0..grid.len())
            .map(|cell| (grid.center(cell), grid.radius(cell)))
            .collect();
        // No point is farther from its nearest sample than the circumradius of a triangle;
        // Fibonacci triangles stay below one spacing, and random points are not resampled.
        let reach = 1.1 * mesh.spacing();
        let near = parallel::map_chunks(mesh.len(), |range| {
            let mut near = Vec::with_capacity(range.len() * 3 / 2);
            for i in range {
                grid.visit_near(mesh.points()[i], reach, |cell| {
                    near.push((cell as u32, i as u32))
                });
            }
            near
        });
        let mut start = vec![0_u32; grid.len() + 1];
        for &(cell, _) in near.iter().flatten() {
            start[cell as usize + 1] += 1;
        }
        for cell in 0..grid.len() {
            start[cell + 1] += start[cell];
        }
        let mut next = start.clone();
        let mut samples = vec![0; start[grid.len()] as usize];
        for (cell, i) in near.into_iter().flatten() {
            let at = &mut next[cell as usize];
            samples[*at as usize] = i;
            *at += 1;
        }
        Self {
            grid,
            shape,
            start,
            samples,
            lattice: mesh.len(),
        }
    }

    fn samples(&self, cell: usize) -> &[u32] {
        &self.samples[self.start[cell] as usize..self.start[cell + 1] as usize]
    }

    /// Marks in sets of `words` words which frames have samples in or near each bin.
    fn mark(&self, frame: &[FrameId], words: usize, marks: &mut Vec<u64>) {
        marks.clear();
        marks.resize(self.grid.len() * words, 0);
        marks
            .par_chunks_mut(BLOCK * words)
            .enumerate()
            .for_each(|(block, marks)| {
                for (k, marks) in marks.chunks_mut(words).enumerate() {
                    for &i in self.samples(block * BLOCK + k) {
                        let id = usize::from(frame[i as usize]);
                        marks[id / 64] |= 1 << (id % 64);
                    }
                }
            });
    }
}

impl Default for Bins {
    fn default() -> Self {
        let grid = CubeGrid::new(1);
        let start = vec![0; grid.len() + 1];
        Self {
            grid,
            shape: Vec::new(),
            start,
            samples: Vec::new(),
            lattice: 0,
        }
    }
}

/// Bins per unit of parallel work.
const BLOCK: usize = 64;

/// Samples across a fine bin: wide enough to be touched by few samples, narrow enough to be missed
/// by most frames that do not cover a point.
const FINE: f64 = 3.0;

/// The same for coarse bins. More of them cost more at every turn than they save at look-ups.
const COARSE: f64 = 5.0;

/// Most coarse bins along the edge of a face.
const MOST_COARSE: f64 = 16.0;

/// Candidate tables for the frames of one planet.
#[derive(Component, Clone, Debug, Default)]
pub struct OverlapIndex {
    fine: Arc<Bins>,
    coarse: Arc<Bins>,
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

    /// Renews all tables after frames have gained or lost samples.
    pub fn update(&mut self, mesh: &SphereMesh, frame: &[FrameId], frames: &[Frame]) {
        if self.fine.lattice != mesh.len() {
            self.fine = Arc::new(Bins::new(mesh, FINE, f64::INFINITY));
            self.coarse = Arc::new(Bins::new(mesh, COARSE, MOST_COARSE));
        }
        self.words = frames.len().div_ceil(64).max(1);
        self.fine.mark(frame, self.words, &mut self.near);
        self.coarse.mark(frame, self.words, &mut self.lattice);
        self.turn(frames);
    }

    /// Renews the table of the world after frames have moved.
    pub fn turn(&mut self, frames: &[Frame]) {
        self.to_lattice.clear();
        self.to_lattice.extend(
            frames
                .iter()
                .map(|frame| DMat3::from_quat(frame.rotation.conjugate())),
        );
        let (bins, words, lattice) = (&self.coarse, self.words, &self.lattice);
        let blocks = (0..bins.shape.len().div_ceil(BLOCK))
            .into_par_iter()
            .map(|block| {
                let mut found: Vec<(u32, u32)> = Vec::with_capacity(16 * BLOCK);
                for cell in block * BLOCK..((block + 1) * BLOCK).min(bins.shape.len()) {
                    let (center, reach) = bins.shape[cell];
                    for id in ones(&lattice[cell * words..(cell + 1) * words]) {
                        let p = frames[id].to_world(center);
                        bins.grid
                            .visit_near(p, reach, |at| found.push((at as u32, id as u32)));
                    }
                }
                found
            });
        let blocks: Vec<_> = blocks.collect();
        self.world.clear();
        self.world.resize(lattice.len(), 0);
        for (cell, id) in blocks.into_iter().flatten() {
            self.world[cell as usize * words + id as usize / 64] |= 1 << (id % 64);
        }
    }

    /// The bin of the world that holds `p`.
    #[inline]
    fn candidates(&self, p: DVec3) -> &[u64] {
        let cell = self.coarse.grid.cell(p);
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
        let cell = self.fine.grid.cell(local);
        let word = self.near[cell * self.words + usize::from(id) / 64];
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
        let hits = ones(self.candidates(p))
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
        ones(self.candidates(p)).filter_map(move |id| self.hit(mesh, crust, id as FrameId, p))
    }
}

/// Positions of the ones in a set.
#[inline]
fn ones(words: &[u64]) -> Ones<'_> {
    let (&rest, later) = words.split_first().unwrap_or((&0, &[]));
    Ones {
        rest,
        base: 0,
        later,
    }
}

/// See [`ones`].
struct Ones<'a> {
    rest: u64,
    base: usize,
    later: &'a [u64],
}

impl Iterator for Ones<'_> {
    type Item = usize;

    #[inline]
    fn next(&mut self) -> Option<usize> {
        while self.rest == 0 {
            let (&word, later) = self.later.split_first()?;
            (self.rest, self.later) = (word, later);
            self.base += 64;
        }
        let bit = self.rest.trailing_zeros() as usize;
        self.rest &= self.rest - 1;
        Some(self.base + bit)
    }
}

/// Whether the crust of `a` lies on top of that of `b` at `p`.
pub fn overrides(
    crust: &Crust,
    frames: &[Frame],
    polarity: &PolarityMemory,
    a: FrameHit,
    b: FrameHit,
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
                if age_a == age_b {
                    fa.plate < fb.plate
                } else {
                    age_a < age_b
                }
            }
        },
    }
}

/// Which of two hits at `p` lies on top.
#[inline]
pub fn upper(
    crust: &Crust,
    frames: &[Frame],
    polarity: &PolarityMemory,
    a: FrameHit,
    b: FrameHit,
    p: DVec3,
) -> FrameHit {
    if overrides(crust, frames, polarity, b, a, p) {
        b
    } else {
        a
    }
}
