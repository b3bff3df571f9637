//! What covers every sample of the lattice now.
//!
//! A sample takes its crust from the frame on top: values by barycentric interpolation, categories
//! from the nearest sample. *Mixed triangles*: corners of other frames, and of the other kind of
//! crust than the nearest, are dropped and the weights renormalised, so that a coast stays as sharp
//! as it was. *A frame at rest* copies bits. Continental crust that lies below another frame is
//! noted, for the ledger.

use crate::crust::surface::Cover;
use crate::crust::{Crust, CrustKind, Frame, Frames, Orogeny, Surface};
use crate::parallel::CHUNK;
use crate::plate::PlateId;
use crate::plate::overlap::{FrameHit, OverlapIndex, upper};
use crate::plate::polarity::PolarityMemory;
use crate::sphere::{Location, SphereMesh};
use bevy::math::{DQuat, DVec3};
use bevy::prelude::*;
use rayon::prelude::*;

/// Chunks that are projected between two looks at the clock.
pub const CHUNKS_PER_SLICE: usize = 4;

/// What a projection reads.
#[derive(Clone, Copy)]
pub struct ProjectInput<'a> {
    /// Samples and triangles.
    pub mesh: &'a SphereMesh,
    /// The state.
    pub crust: &'a Crust,
    /// Frames.
    pub frames: &'a Frames,
    /// Which frames cover a point; must fit the frames' rotations.
    pub overlap: &'a OverlapIndex,
    /// Who goes under whom.
    pub polarity: &'a PolarityMemory,
}

/// Notes of a projection that only a resample needs, per sample.
#[derive(Clone, Debug, Default)]
pub struct Notes {
    /// Share of continental corners in the triangle, 0..1; negative where nothing covers.
    pub weight: Vec<f32>,
    /// Thickness in km of continental crust below the one on top.
    pub below: Vec<f32>,
    /// Layers of continental crust below: those of the same plate, and those of other plates.
    pub layers: Vec<[u8; 2]>,
}

/// One sample's crust.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Frame on top.
    pub frame: u16,
    /// Type.
    pub kind: CrustKind,
    /// Thickness in km.
    pub thickness: f32,
    /// Elevation in km.
    pub elevation: f32,
    /// Age of ocean floor in My.
    pub ocean_age: f32,
    /// Ridge direction.
    pub ridge: Vec3,
    /// Age of the orogeny in My.
    pub orogeny_age: f32,
    /// Type of the orogeny.
    pub orogeny: Orogeny,
    /// Fold direction.
    pub fold: Vec3,
}

impl Row {
    /// The row of sample `i`.
    pub fn read(crust: &Crust, i: usize) -> Self {
        Self {
            frame: crust.frame[i],
            kind: crust.kind[i],
            thickness: crust.thickness[i],
            elevation: crust.elevation[i],
            ocean_age: crust.ocean_age[i],
            ridge: crust.ridge[i],
            orogeny_age: crust.orogeny_age[i],
            orogeny: crust.orogeny[i],
            fold: crust.fold[i],
        }
    }

    /// Stores the row as sample `i`.
    pub fn write(&self, crust: &mut Crust, i: usize) {
        crust.frame[i] = self.frame;
        crust.kind[i] = self.kind;
        crust.thickness[i] = self.thickness;
        crust.elevation[i] = self.elevation;
        crust.ocean_age[i] = self.ocean_age;
        crust.ridge[i] = self.ridge;
        crust.orogeny_age[i] = self.orogeny_age;
        crust.orogeny[i] = self.orogeny;
        crust.fold[i] = self.fold;
    }
}

/// What one sample of the lattice found.
struct Found {
    row: Row,
    plate: PlateId,
    cover: Cover,
    weight: f32,
    below: f32,
    layers: [u8; 2],
}

/// Gives all columns the length of the lattice.
pub fn prepare(surface: &mut Surface, notes: &mut Notes, n: usize) {
    if surface.len() != n {
        let params = crate::params::TectonicParams::default();
        surface.crust = Crust::ocean(n, &params);
        surface.plate = vec![PlateId::default(); n];
        surface.cover = vec![Cover::One; n];
        surface.trench = vec![0.0; n];
    }
    notes.weight.resize(n, 0.0);
    notes.below.resize(n, 0.0);
    notes.layers.resize(n, [0; 2]);
}

/// Projects the chunks from `first` on, a slice of them. Returns the next chunk; done when it is
/// past the end.
pub fn project_slice(
    input: &ProjectInput,
    surface: &mut Surface,
    notes: &mut Notes,
    first: usize,
) -> usize {
    let n = input.mesh.len();
    let end = (first + CHUNKS_PER_SLICE).min(n.div_ceil(CHUNK));
    let range = first * CHUNK..(end * CHUNK).min(n);
    // Before anything has moved every sample is covered by itself alone.
    let at_rest = input.frames.iter().all(Frame::is_at_rest);
    macro_rules! chunks {
        ($($column:expr),+) => { ($($column[range.clone()].par_chunks_mut(CHUNK)),+).into_par_iter() };
    }
    let Surface {
        crust,
        plate,
        cover,
        trench,
        ..
    } = surface;
    let Crust {
        frame,
        kind,
        thickness,
        elevation,
        ocean_age,
        ridge,
        orogeny_age,
        orogeny,
        fold,
    } = crust;
    let scalars = chunks!(
        frame,
        kind,
        thickness,
        elevation,
        ocean_age,
        orogeny_age,
        orogeny
    );
    let rest = chunks!(
        ridge,
        fold,
        plate,
        cover,
        trench,
        notes.weight,
        notes.below,
        notes.layers
    );
    (scalars, rest)
        .into_par_iter()
        .enumerate()
        .for_each(|(chunk, (scalars, rest))| {
            let (frame, kind, thickness, elevation, ocean_age, orogeny_age, orogeny) = scalars;
            let (ridge, fold, plate, cover, trench, weight, below, layers) = rest;
            for k in 0..frame.len() {
                let found = find(input, at_rest, (first + chunk) * CHUNK + k);
                let row = found.row;
                (frame[k], kind[k], thickness[k], elevation[k]) =
                    (row.frame, row.kind, row.thickness, row.elevation);
                (ocean_age[k], orogeny_age[k], orogeny[k]) =
                    (row.ocean_age, row.orogeny_age, row.orogeny);
                (ridge[k], fold[k]) = (row.ridge, row.fold);
                (plate[k], cover[k], trench[k]) = (found.plate, found.cover, 0.0);
                (weight[k], below[k], layers[k]) = (found.weight, found.below, found.layers);
            }
        });
    end
}

fn find(input: &ProjectInput, at_rest: bool, i: usize) -> Found {
    let ProjectInput {
        mesh,
        crust,
        frames,
        overlap,
        polarity,
    } = *input;
    if at_rest {
        return Found {
            row: Row::read(crust, i),
            plate: frames.plate(crust.frame[i]),
            cover: Cover::One,
            weight: f32::from(u8::from(crust.is_continental(i))),
            below: 0.0,
            layers: [0; 2],
        };
    }
    let p = mesh.points()[i];
    let mut hits = overlap.covering(mesh, crust, p);
    let Some(mut top) = hits.next() else {
        return Found {
            row: Row::read(crust, i),
            plate: PlateId::default(),
            cover: Cover::Ridge,
            weight: -1.0,
            below: 0.0,
            layers: [0; 2],
        };
    };
    let mut count = Cover::One;
    for hit in hits {
        top = upper(crust, frames, polarity, top, hit, p);
        count = Cover::Several;
    }
    let (row, weight) = sample_frame(input, top, None);
    // Few samples are covered twice: it is cheaper to find the frames again than to keep them.
    let (below, layers) = if count == Cover::Several {
        buried(input, p, top)
    } else {
        (0.0, [0; 2])
    };
    Found {
        row,
        plate: frames.plate(top.frame),
        cover: count,
        weight,
        below,
        layers,
    }
}

/// The crust of a frame at a hit, and the share of continental corners. `kind` asks for crust of
/// that kind, where the triangle has some, instead of the nearest sample's.
pub fn sample_frame(input: &ProjectInput, hit: FrameHit, kind: Option<CrustKind>) -> (Row, f32) {
    let ProjectInput {
        mesh,
        crust,
        frames,
        ..
    } = *input;
    let frame = frames[usize::from(hit.frame)];
    let nearest = hit.sample as usize;
    let wanted = kind.unwrap_or(crust.kind[nearest]);
    if frame.is_at_rest() && wanted == crust.kind[nearest] && mesh.points()[nearest] == hit.local {
        let weight = f32::from(u8::from(crust.is_continental(nearest)));
        return (Row::read(crust, nearest), weight);
    }
    let at = mesh.locate_from(hit.local, hit.sample);
    let mut weight = [0.0, 0.0];
    for (&i, &w) in at.vertices.iter().zip(&at.weights) {
        if crust.frame[i as usize] == hit.frame {
            weight[usize::from(crust.is_continental(i as usize))] += w;
        }
    }
    let share = if weight[0] + weight[1] > 0.0 {
        weight[1] / (weight[0] + weight[1])
    } else {
        0.0
    };
    let row = blend(crust, &at, hit.frame, wanted).unwrap_or_else(|| Row::read(crust, nearest));
    (turned(row, frame.rotation), share as f32)
}

/// The barycentric mean over the corners of one frame and kind.
fn blend(crust: &Crust, at: &Location, frame: u16, kind: CrustKind) -> Option<Row> {
    let mut sum = [0.0f64; 5];
    let (mut ridge, mut fold) = (DVec3::ZERO, DVec3::ZERO);
    let mut nearest = (0.0, None);
    for (&i, &w) in at.vertices.iter().zip(&at.weights) {
        let i = i as usize;
        if crust.frame[i] != frame || crust.kind[i] != kind || w <= 0.0 {
            continue;
        }
        let values = [
            1.0,
            crust.thickness[i],
            crust.elevation[i],
            crust.ocean_age[i],
            crust.orogeny_age[i],
        ];
        for (sum, value) in sum.iter_mut().zip(values) {
            *sum += w * f64::from(value);
        }
        // Ridges are lines without a head: corners are turned to the same side before they are
        // added.
        let r = crust.ridge[i].as_dvec3();
        ridge += if r.dot(ridge) < 0.0 { -r * w } else { r * w };
        fold += crust.fold[i].as_dvec3() * w;
        if w > nearest.0 {
            nearest = (w, Some(i));
        }
    }
    let i = nearest.1?;
    let mean = |k: usize| (sum[k] / sum[0]) as f32;
    Some(Row {
        frame,
        kind,
        thickness: mean(1),
        elevation: mean(2),
        ocean_age: mean(3),
        ridge: ridge.normalize_or_zero().as_vec3(),
        orogeny_age: mean(4),
        orogeny: crust.orogeny[i],
        fold: (fold / sum[0]).as_vec3(),
    })
}

fn turned(row: Row, rotation: DQuat) -> Row {
    let turn = |v: Vec3| (rotation * v.as_dvec3()).as_vec3();
    Row {
        ridge: turn(row.ridge),
        fold: turn(row.fold),
        ..row
    }
}

/// Continental crust below the frame on top at `p`: thickness in km, and layers of the same and of
/// other plates.
fn buried(input: &ProjectInput, p: DVec3, top: FrameHit) -> (f32, [u8; 2]) {
    let ProjectInput {
        mesh,
        crust,
        frames,
        overlap,
        ..
    } = *input;
    let plate = frames.plate(top.frame);
    let mut below = 0.0;
    let mut layers = [0; 2];
    for hit in overlap
        .covering(mesh, crust, p)
        .filter(|hit| hit.frame != top.frame)
    {
        if crust.is_continental(hit.sample as usize) {
            below += crust.thickness[hit.sample as usize];
            layers[usize::from(frames.plate(hit.frame) != plate)] += 1;
        }
    }
    (below, layers)
}
