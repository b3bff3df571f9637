//! Gaps: samples that no frame covers (paper 000 §4.3).
//!
//! The nearest rim and the nearest rim of another plate are found along the mesh. *Diverging
//! plates* leave new ocean floor between them, the [`ridge`](super::ridge)'s. *Plates that do not
//! diverge, and holes within one plate*: a gap is not always an ocean. It is filled from the
//! nearest rim. Only cracks below `widest_crack` between two continents are filled with
//! continental crust; a wider gap that closes again was an ocean when it opened, and takes the
//! nearer oceanic rim's floor, or new floor where there is none. *Triple junctions*: the two
//! nearest plates decide.

use super::input::GapInput;
use super::project::ProjectNotes;
use super::ridge::{Between, Opening, ridge_row};
use crate::crust::surface::Cover;
use crate::crust::{CrustKind, CrustRow, Surface};
use crate::ids::PlateId;
use crate::parallel;
use crate::sphere::SphereMesh;
use crate::sphere::angle_of_chord;
use crate::sphere::components::Components;
use crate::sphere::nearest_source::{SourceField, UNREACHED, extend_nearest_sources};
use rayon::prelude::*;

/// Radians beyond which no rim is looked for: more than half of the sphere.
const FARTHEST_RIM: f64 = 2.0;

/// For every sample of a gap its nearest rim, and the nearest rim of another plate; memory to be
/// used again.
#[derive(Clone, Debug, Default)]
pub(super) struct GapRims {
    first: SourceField,
    second: SourceField,
}

impl GapRims {
    /// The plate of the rim nearest to sample `i`; `None` for a covered sample, which is not in the
    /// field.
    fn nearest_plate(&self, surface: &Surface, i: u32) -> Option<PlateId> {
        match self.first.source(i) {
            UNREACHED => None,
            rim => Some(surface.plate[rim as usize]),
        }
    }

    fn clear(&mut self, n: usize) {
        for field in [&mut self.first, &mut self.second] {
            if field.len() != n {
                *field = SourceField::new(n);
            }
            field.clear();
        }
    }
}

/// Makes crust for every sample of the projection that nothing covers. Returns how many became
/// ridge crust.
pub(super) fn fill_gaps(
    input: &GapInput,
    surface: &mut Surface,
    notes: &ProjectNotes,
    rims: &mut GapRims,
) -> usize {
    let mesh = input.planet.mesh;
    let gaps = uncovered(notes);
    if gaps.is_empty() {
        return 0;
    }
    rims.clear(mesh.len());
    find_rims(mesh, &gaps, notes, surface, rims);
    // Rows are made of covered samples alone: none depends on another.
    let filled = parallel::map_chunks(gaps.len(), |range| {
        gaps[range]
            .iter()
            .filter_map(|&i| fill(input, surface, rims, i))
            .collect::<Vec<_>>()
    });
    let mut made = 0;
    for (i, filling) in filled.into_iter().flatten() {
        surface.plate[i] = filling.plate;
        surface.cover[i] = filling.cover;
        surface.crust.set_row(i, &filling.row);
        made += usize::from(filling.cover == Cover::Ridge);
    }
    made
}

/// Samples that nothing covers, in order.
fn uncovered(notes: &ProjectNotes) -> Vec<u32> {
    parallel::map_chunks(notes.weight.len(), |range| {
        range
            .filter(|&i| notes.weight[i] < 0.0)
            .map(|i| i as u32)
            .collect::<Vec<_>>()
    })
    .concat()
}

/// Finds both rims of every sample. No distance crosses from one gap to another: each is searched
/// by itself, the largest first.
fn find_rims(
    mesh: &SphereMesh,
    gaps: &[u32],
    notes: &ProjectNotes,
    surface: &Surface,
    rims: &GapRims,
) {
    let uncovered = |i: u32| notes.weight[i as usize] < 0.0;
    let pieces = Components::new(mesh, uncovered, |_, _| true);
    let mut of_piece = vec![Vec::new(); pieces.count];
    for &i in gaps {
        of_piece[pieces.of[i as usize] as usize].push(i);
    }
    // So that no thread waits for a large one at last.
    of_piece.sort_by_key(|gap| core::cmp::Reverse(gap.len()));
    of_piece.par_iter().with_max_len(1).for_each(|gap| {
        let piece = pieces.of[gap[0] as usize];
        nearest_rims(mesh, gap, &rims.first, |i| pieces.of[i as usize] == piece);
        second_rims(mesh, gap, surface, rims);
    });
}

/// For every sample of a gap the nearest rim.
fn nearest_rims(mesh: &SphereMesh, gap: &[u32], first: &SourceField, inside: impl Fn(u32) -> bool) {
    let mut seeds: Vec<u32> = gap
        .iter()
        .flat_map(|&i| mesh.ring(i).iter().copied().filter(|&j| !inside(j)))
        .collect();
    seeds.sort_unstable();
    seeds.dedup();
    // Rims stay out of the field: they may belong to several gaps.
    let mut start: Vec<(u32, u32)> = Vec::new();
    for &rim in &seeds {
        let beside = mesh.ring(rim).iter().filter(|&&i| inside(i));
        start.extend(beside.map(|&i| (i, rim)));
    }
    extend_nearest_sources(
        mesh,
        first,
        &start,
        FARTHEST_RIM,
        |rim| mesh.point(rim),
        |_, to| inside(to),
    );
}

/// For every sample of a gap the nearest rim of another plate than the nearest rim's: the search
/// begins where the regions of two plates meet within the gap.
fn second_rims(mesh: &SphereMesh, gap: &[u32], surface: &Surface, rims: &GapRims) {
    let nearest_plate = |i: u32| rims.nearest_plate(surface, i);
    // In a hole within one plate no regions meet: the search ends where it begins, and its samples
    // have no second rim.
    let mut start = Vec::new();
    for &i in gap {
        for &j in mesh.ring(i) {
            let (here, there) = (nearest_plate(i), nearest_plate(j));
            if here.is_some() && there.is_some() && here != there {
                start.push((i, rims.first.source(j)));
            }
        }
    }
    extend_nearest_sources(
        mesh,
        &rims.second,
        &start,
        FARTHEST_RIM,
        |rim| mesh.point(rim),
        |from, to| nearest_plate(to).is_some() && nearest_plate(from) == nearest_plate(to),
    );
}

/// New crust at a sample of a gap.
struct Filling {
    row: CrustRow,
    plate: PlateId,
    cover: Cover,
}

/// New crust at sample `i`, which belongs to the nearest rim's plate.
fn fill(input: &GapInput, surface: &Surface, rims: &GapRims, i: u32) -> Option<(usize, Filling)> {
    let between = Between {
        sample: i,
        near: rims.first.source(i),
        far: rims.second.source(i),
    };
    // Beyond the reach of the search: it keeps the crust that the projection left there.
    if between.near == UNREACHED {
        return None;
    }
    let plate = surface.plate[between.near as usize];
    let ridge = if between.far == UNREACHED {
        None
    } else {
        ridge_row(input, surface, &between, Opening::Measured)
    };
    let filling = match ridge {
        Some(row) => Filling {
            row,
            plate,
            cover: Cover::Ridge,
        },
        None => Filling {
            row: closing_row(input, surface, &between),
            plate,
            cover: Cover::Filled,
        },
    };
    Some((i as usize, filling))
}

/// Crust of a gap that is not opening.
fn closing_row(input: &GapInput, surface: &Surface, between: &Between) -> CrustRow {
    let own = surface.crust.row(between.near as usize);
    // A hole within one plate, or the nearer rim is ocean floor: that goes on.
    if between.far == UNREACHED || own.kind == CrustKind::Oceanic {
        return own;
    }
    let across = surface.crust.row(between.far as usize);
    // Ocean floor from the other side, but on the own plate: continents do not grow into gaps.
    if across.kind == CrustKind::Oceanic {
        return CrustRow {
            frame: own.frame,
            ..across
        };
    }
    let mesh = input.planet.mesh;
    let p = mesh.point(between.sample);
    let width = angle_of_chord(p.distance(mesh.point(between.near)))
        + angle_of_chord(p.distance(mesh.point(between.far)));
    if width * input.planet.radius < input.planet.params.widest_crack {
        own
    } else {
        ridge_row(input, surface, between, Opening::Past).unwrap_or(own)
    }
}
