//! What lies where no frame does (paper 000 §4.3).
//!
//! The two nearest rims of different plates are found by spreading. *Diverging plates*: the ridge
//! runs halfway between the rims, and the floor is younger the nearer it is:
//!
//! ```text
//! alpha = d_G / (d_G + d_P)          z = alpha z_mean + (1 - alpha) z_G(d_G)
//! z_G(d) = z_a + (z_r - z_a) 2^(-d / sigma)            r = (p - q) x p
//! age = T d_G / (d_G + d_P),  T the shorter of the time since the last resample and the time that the gap needed
//! ```
//!
//! d_G is the distance to the ridge, d_P to the rim, q the projection of p onto the ridge. sigma
//! grows with the spreading rate, so that z_G agrees with the subsidence of floor that spread at
//! that rate; the parameter holds for [`REFERENCE_RATE`].
//!
//! *Plates that do not diverge, and holes within one plate*: a gap is not always an ocean. It is
//! filled from the nearest rim. Only cracks below [`WIDEST_CRACK`] between two continents are
//! filled with continental crust; a wider gap that closes again was an ocean when it opened, and
//! takes the nearer oceanic rim's floor, or new floor where there is none. *Triple junctions*: the
//! two nearest plates decide.

use crate::crust::surface::Cover;
use crate::crust::{CrustKind, Orogeny, Surface};
use crate::math::exp2;
use crate::parallel;
use crate::params::TectonicParams;
use crate::plate::PlateTable;
use crate::resample::project::{Notes, Row};
use crate::sphere::SphereMesh;
use crate::sphere::angle_of_chord;
use crate::sphere::components::Components;
use crate::sphere::nearest_source::{SourceField, UNREACHED, extend_nearest_sources};
use bevy::math::DVec3;
use bevy::prelude::*;
use rayon::prelude::*;

/// Half-spreading rate in km/My at which `ridge_width` agrees with the default `subsidence_time`.
pub const REFERENCE_RATE: f64 = 12.8;

/// Widest gap in km between continents that do not diverge, which their crust fills by stretching.
pub const WIDEST_CRACK: f64 = 120.0;

/// What filling gaps reads.
pub struct GapInput<'a> {
    /// Samples and triangles.
    pub mesh: &'a SphereMesh,
    /// The plates.
    pub plates: &'a PlateTable,
    /// Parameters.
    pub params: &'a TectonicParams,
    /// Planet radius in km.
    pub radius: f64,
    /// Time since the last resample in My.
    pub elapsed: f64,
}

/// The nearest and the second rim of every sample of a gap; memory to be used again.
#[derive(Clone, Debug, Default)]
pub struct Rims([SourceField; 2]);

/// Makes crust for every sample of the projection that nothing covers. Returns how many became
/// ridge crust.
pub fn fill_gaps(input: &GapInput, surface: &mut Surface, notes: &Notes, rims: &mut Rims) -> usize {
    let mesh = input.mesh;
    let open = |i: u32| notes.weight[i as usize] < 0.0;
    let gaps = parallel::map_chunks(mesh.len(), |range| {
        range
            .map(|i| i as u32)
            .filter(|&i| open(i))
            .collect::<Vec<_>>()
    });
    let gaps = gaps.concat();
    if gaps.is_empty() {
        return 0;
    }
    for field in &mut rims.0 {
        if field.len() != mesh.len() {
            *field = SourceField::new(mesh.len());
        }
        field.clear();
    }
    let [first, second] = &rims.0;
    let parts = Components::new(mesh, open, |_, _| true);
    let mut of_part = vec![Vec::new(); parts.count];
    gaps.iter()
        .for_each(|&i| of_part[parts.of[i as usize] as usize].push(i));
    // No distance crosses from one gap to another: each is a spread of its own, the largest first.
    of_part.sort_by_key(|gap| core::cmp::Reverse(gap.len()));
    of_part.par_iter().with_max_len(1).for_each(|gap| {
        let part = parts.of[gap[0] as usize];
        nearest_rims(mesh, gap, first, |i| parts.of[i as usize] == part);
        second_rims(mesh, gap, first, surface, second);
    });
    // Rows are made of covered samples alone: none depends on another.
    let rows = parallel::map_chunks(gaps.len(), |range| {
        let row = |&i: &u32| {
            let (near, far) = (first.source(i), second.source(i));
            if near == UNREACHED {
                return None;
            }
            let ridge = if far == UNREACHED {
                None
            } else {
                ridge_row(input, surface, i, near, far, false)
            };
            let cover = if ridge.is_some() {
                Cover::Ridge
            } else {
                Cover::Filled
            };
            let row = ridge.unwrap_or_else(|| filled_row(input, surface, i, near, far));
            Some((i as usize, surface.plate[near as usize], cover, row))
        };
        gaps[range].iter().filter_map(row).collect::<Vec<_>>()
    });
    let mut made = 0;
    for (k, plate, cover, row) in rows.into_iter().flatten() {
        surface.plate[k] = plate;
        surface.cover[k] = cover;
        made += usize::from(cover == Cover::Ridge);
        row.write(&mut surface.crust, k);
    }
    made
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
        start.extend(
            mesh.ring(rim)
                .iter()
                .filter(|&&i| inside(i))
                .map(|&i| (i, rim)),
        );
    }
    extend_nearest_sources(
        mesh,
        first,
        &start,
        2.0,
        |rim| mesh.point(rim),
        |_, to| inside(to),
    );
}

/// For every sample of a gap the nearest rim of another plate than the nearest rim's: spread from
/// where the regions of two plates meet within the gap.
fn second_rims(
    mesh: &SphereMesh,
    gap: &[u32],
    first: &SourceField,
    surface: &Surface,
    second: &SourceField,
) {
    let plate = |i: u32| match first.source(i) {
        UNREACHED => None,
        rim => Some(surface.plate[rim as usize]),
    };
    let mut start = Vec::new();
    for &i in gap {
        for &j in mesh.ring(i) {
            // A covered neighbour is not in the field; only gap samples of another plate's region
            // count.
            if plate(i).is_some() && plate(j).is_some() && plate(i) != plate(j) {
                start.push((i, first.source(j)));
            }
        }
    }
    let same = |from: u32, to: u32| plate(to).is_some() && plate(from) == plate(to);
    extend_nearest_sources(mesh, second, &start, 2.0, |rim| mesh.point(rim), same);
}

/// Crust that fills sample `i` of a gap that is not opening.
fn filled_row(input: &GapInput, surface: &Surface, i: u32, near: u32, far: u32) -> Row {
    let own = Row::read(&surface.crust, near as usize);
    if far == UNREACHED || own.kind == CrustKind::Oceanic {
        return own;
    }
    let (p, mesh) = (input.mesh.point(i), input.mesh);
    let width =
        angle_of_chord(p.distance(mesh.point(near))) + angle_of_chord(p.distance(mesh.point(far)));
    let across = Row::read(&surface.crust, far as usize);
    if across.kind == CrustKind::Oceanic {
        Row {
            frame: own.frame,
            ..across
        }
    } else if width * input.radius < WIDEST_CRACK {
        own
    } else {
        ridge_row(input, surface, i, near, far, true).unwrap_or(own)
    }
}

/// New ocean crust at sample `i` between the rims `near` and `far`; none where the plates do not
/// diverge, unless it is `forced`.
fn ridge_row(
    input: &GapInput,
    surface: &Surface,
    i: u32,
    near: u32,
    far: u32,
    forced: bool,
) -> Option<Row> {
    let &GapInput {
        mesh,
        plates,
        params,
        radius,
        elapsed,
    } = input;
    let (p, a, b) = (mesh.point(i), mesh.point(near), mesh.point(far));
    let across = b - a;
    let across = (across - p * across.dot(p)).try_normalize()?;
    let relative = plates.angular_velocity(surface.plate[far as usize])
        - plates.angular_velocity(surface.plate[near as usize]);
    let opening = relative.cross(p).dot(across) * radius;
    if opening <= 0.0 && !forced {
        return None;
    }
    // A gap that closes was opened at some rate once; the reference stands for it.
    let opening = if forced {
        2.0 * REFERENCE_RATE
    } else {
        opening
    };
    let d1 = angle_of_chord(p.distance(a)) * radius;
    let d2 = angle_of_chord(p.distance(b)) * radius;
    let half = 0.5 * (d1 + d2);
    let to_ridge = (half - d1).max(0.0);
    let alpha = to_ridge / half;
    let za = f64::from(surface.crust.elevation[near as usize]);
    let zb = f64::from(surface.crust.elevation[far as usize]);
    let between = (za * d2 + zb * d1) / (d1 + d2);
    let z = alpha * between + (1.0 - alpha) * ridge_profile(params, to_ridge, 0.5 * opening);
    Some(Row {
        frame: surface.crust.frame[near as usize],
        kind: CrustKind::Oceanic,
        thickness: params.ocean_thickness as f32,
        elevation: z as f32,
        ocean_age: (alpha * elapsed.min(2.0 * half / opening)) as f32,
        ridge: across.cross(p).normalize_or(DVec3::ZERO).as_vec3(),
        orogeny_age: 0.0,
        orogeny: Orogeny::None,
        fold: Vec3::ZERO,
    })
}

/// Template z_G of the floor at `d` km from a ridge that spreads at `rate` km/My to either side.
pub fn ridge_profile(params: &TectonicParams, d: f64, rate: f64) -> f64 {
    let sigma = params.ridge_width * (rate / REFERENCE_RATE).max(0.1);
    params.abyss_elevation + (params.ridge_elevation - params.abyss_elevation) * exp2(-d / sigma)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_template_has_its_closed_form() {
        let params = TectonicParams::default();
        assert_eq!(
            ridge_profile(&params, 0.0, REFERENCE_RATE),
            params.ridge_elevation
        );
        let middle = 0.5 * (params.ridge_elevation + params.abyss_elevation);
        assert!(
            (ridge_profile(&params, params.ridge_width, REFERENCE_RATE) - middle).abs() < 1e-12
        );
        assert!(
            (ridge_profile(&params, 1e5, REFERENCE_RATE) - params.abyss_elevation).abs() < 1e-6
        );
    }

    #[test]
    fn the_template_agrees_with_subsidence() {
        let params = TectonicParams::default();
        for rate in [10.0, 25.0, 50.0] {
            for age in [5.0, 20.0, 60.0] {
                let depth = crate::math::exp(-age / params.subsidence_time);
                let sunk = params.abyss_elevation
                    + (params.ridge_elevation - params.abyss_elevation) * depth;
                assert!((ridge_profile(&params, rate * age, rate) - sunk).abs() < 0.05);
            }
        }
    }
}
