//! The crust that covers every sample of the lattice now.
//!
//! A sample takes its crust from the frame on top. Continental crust that lies below another frame
//! is noted, for the ledger.

use super::blend::sample_frame;
use super::input::ProjectInput;
use crate::crust::surface::Cover;
use crate::crust::{Crust, CrustChunk, CrustRow, Frame, Surface};
use crate::ids::PlateId;
use crate::parallel::CHUNK;
use crate::params::TectonicParams;
use crate::plate::overlap::{FrameHit, upper};
use bevy::math::DVec3;
use bevy::prelude::*;
use rayon::prelude::*;

/// Chunks that are projected between two looks at the clock.
const CHUNKS_PER_TIME_SLICE: usize = 4;

/// Notes of a projection that only a resample needs, per sample.
#[derive(Clone, Debug, Default)]
pub(crate) struct ProjectNotes {
    /// Share of continental corners in the triangle, 0..1; negative where nothing covers.
    pub weight: Vec<f32>,
    /// Thickness in km of continental crust below the one on top.
    pub below: Vec<f32>,
    /// Layers of continental crust below: those of the same plate, and those of other plates.
    pub layers: Vec<[u8; 2]>,
}

/// The projection of one sample.
struct ProjectedSample {
    row: CrustRow,
    plate: PlateId,
    cover: Cover,
    weight: f32,
    below: f32,
    layers: [u8; 2],
}

/// Gives all columns the length of the lattice.
pub(super) fn prepare(surface: &mut Surface, notes: &mut ProjectNotes, n: usize) {
    if surface.len() != n {
        surface.crust = Crust::ocean(n, &TectonicParams::default());
        surface.plate = vec![PlateId::default(); n];
        surface.cover = vec![Cover::One; n];
        surface.trench = vec![0.0; n];
    }
    notes.weight.resize(n, 0.0);
    notes.below.resize(n, 0.0);
    notes.layers.resize(n, [0; 2]);
}

/// Projects some of the chunks from `first` on. Returns the next chunk; the projection is complete
/// when it is past the end.
pub(super) fn project_chunks(
    input: &ProjectInput,
    surface: &mut Surface,
    notes: &mut ProjectNotes,
    first: usize,
) -> usize {
    let n = input.mesh.len();
    let end = (first + CHUNKS_PER_TIME_SLICE).min(n.div_ceil(CHUNK));
    let range = first * CHUNK..(end * CHUNK).min(n);
    // Before anything has moved every sample is covered by itself alone.
    let at_rest = input.frames.iter().all(Frame::is_at_rest);
    let of_surface = (
        surface.crust.chunks_mut(range.clone()),
        surface.plate[range.clone()].par_chunks_mut(CHUNK),
        surface.cover[range.clone()].par_chunks_mut(CHUNK),
        surface.trench[range.clone()].par_chunks_mut(CHUNK),
    );
    let of_notes = (
        notes.weight[range.clone()].par_chunks_mut(CHUNK),
        notes.below[range.clone()].par_chunks_mut(CHUNK),
        notes.layers[range].par_chunks_mut(CHUNK),
    );
    (of_surface.into_par_iter(), of_notes.into_par_iter())
        .into_par_iter()
        .for_each(|((crust, plate, cover, trench), (weight, below, layers))| {
            let mut chunk = ProjectedChunk {
                crust,
                plate,
                cover,
                trench,
                weight,
                below,
                layers,
            };
            chunk.project(input, at_rest);
        });
    end
}

/// The columns of a projection over one chunk of samples.
struct ProjectedChunk<'a> {
    crust: CrustChunk<'a>,
    plate: &'a mut [PlateId],
    cover: &'a mut [Cover],
    trench: &'a mut [f32],
    weight: &'a mut [f32],
    below: &'a mut [f32],
    layers: &'a mut [[u8; 2]],
}

impl ProjectedChunk<'_> {
    fn project(&mut self, input: &ProjectInput, at_rest: bool) {
        for k in 0..self.plate.len() {
            let found = project_sample(input, at_rest, self.crust.start + k);
            self.crust.set_row(k, &found.row);
            self.plate[k] = found.plate;
            self.cover[k] = found.cover;
            // Trenches are bent anew once the projection is complete.
            self.trench[k] = 0.0;
            self.weight[k] = found.weight;
            self.below[k] = found.below;
            self.layers[k] = found.layers;
        }
    }
}

fn project_sample(input: &ProjectInput, at_rest: bool, i: usize) -> ProjectedSample {
    let &ProjectInput {
        mesh,
        crust,
        frames,
        overlap,
        polarity,
    } = input;
    // A sample that nothing covers keeps its own crust until the gaps are filled.
    let own = ProjectedSample {
        row: crust.row(i),
        plate: PlateId::default(),
        cover: Cover::Ridge,
        weight: -1.0,
        below: 0.0,
        layers: [0; 2],
    };
    if at_rest {
        return ProjectedSample {
            plate: frames.plate(crust.frame[i]),
            cover: Cover::One,
            weight: f32::from(u8::from(crust.is_continental(i))),
            ..own
        };
    }
    let p = mesh.points()[i];
    let mut hits = overlap.covering(mesh, crust, p);
    let Some(mut top) = hits.next() else {
        return own;
    };
    let mut cover = Cover::One;
    for hit in hits {
        top = upper(crust, frames, polarity, top, hit, p);
        cover = Cover::Several;
    }
    let (row, weight) = sample_frame(input, top, None);
    // Few samples are covered twice: it is cheaper to find the frames again than to keep them.
    let (below, layers) = if cover == Cover::Several {
        buried(input, p, top)
    } else {
        (0.0, [0; 2])
    };
    ProjectedSample {
        row,
        plate: frames.plate(top.frame),
        cover,
        weight,
        below,
        layers,
    }
}

/// Continental crust below the frame on top at `p`: thickness in km, and layers of the same and of
/// other plates.
fn buried(input: &ProjectInput, p: DVec3, top: FrameHit) -> (f32, [u8; 2]) {
    let &ProjectInput { crust, frames, .. } = input;
    let plate = frames.plate(top.frame);
    let mut below = 0.0;
    let mut layers = [0; 2];
    for hit in input.overlap.covering(input.mesh, crust, p) {
        if hit.frame != top.frame && crust.is_continental(hit.sample as usize) {
            below += crust.thickness[hit.sample as usize];
            // Stacked by its own plate, or forced under another: two causes in the ledger.
            layers[usize::from(frames.plate(hit.frame) != plate)] += 1;
        }
    }
    (below, layers)
}
