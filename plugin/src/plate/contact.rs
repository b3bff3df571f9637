//! Where plates meet: every sample of a rim looks just beyond it (paper 000 §6, plate boundary
//! tracking).
//!
//! A sample of the rim probes the point three quarters of a sample's spacing outside. What it finds
//! there, and the relative velocity, make the meeting: the plates converge (and one of them goes
//! under), diverge, or slide. Moving triangles need not be intersected: a rim sample over another
//! plate's crust, or about to be, is the intersection at the resolution of the lattice.
//!
//! Policies. *Several plates at the probe*: the one on top of the others is met. *Triple junction*:
//! each rim sample meets one plate, so each part of the junction has one polarity.

use super::boundary::Rim;
use super::polarity::{Evidence, Pair, PolarityMemory, bin, pair};
use super::{PlateId, PlateTable};
use crate::crust::{Crust, CrustKind, Frame, Frames};
use crate::parallel;
use crate::plate::overlap::OverlapIndex;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use bevy::prelude::*;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Slower than this in km/My plates neither converge nor diverge.
pub const SLIDING: f64 = 2.0;

/// Weight in My with which an ocean that goes under a continent speaks for the polarity of its
/// segment: an island that arrives there goes the same way.
const OCEAN_UNDER_CONTINENT: f64 = 200.0;

/// What a rim sample does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Reflect)]
#[repr(u8)]
pub enum Role {
    /// It meets nothing: a gap has opened before it.
    #[default]
    Free,
    /// The other plate goes under its own.
    Overriding,
    /// Its own plate goes under the other.
    Subducting,
    /// The plates part.
    Diverging,
    /// The plates slide along each other.
    Sliding,
}

/// The meeting of one rim sample with another plate.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Contact {
    /// What the sample does.
    pub role: Role,
    /// The plate that it meets.
    pub other: PlateId,
    /// The other plate's frame.
    pub frame: u16,
    /// The other plate's sample at the probe.
    pub sample: u32,
    /// Whether the other plate's crust there is continental.
    pub other_continental: bool,
    /// Elevation z_i of the other plate's crust at the probe in km, not bent.
    pub other_elevation: f32,
    /// Speed of approach along the rim's normal in km/My; negative where the plates part.
    pub approach: f32,
    /// Angular velocity of the own plate relative to the other, in lattice coordinates of the own
    /// frame, in rad/My.
    pub relative: DVec3,
}

/// All meetings of one step, parallel to [`Rim::samples`].
#[derive(Component, Clone, Debug, Default)]
pub struct Contacts(pub Vec<Contact>);

/// What finding contacts reads.
pub struct ContactInput<'a> {
    /// Samples and triangles.
    pub mesh: &'a SphereMesh,
    /// Crust columns.
    pub crust: &'a Crust,
    /// Frames, already moved.
    pub frames: &'a Frames,
    /// Which frames cover a point.
    pub overlap: &'a OverlapIndex,
    /// The plates.
    pub plates: &'a PlateTable,
    /// Planet radius in km.
    pub radius: f64,
}

/// Finds all contacts and takes new evidence into the memory of polarity.
pub fn find_contacts(
    input: &ContactInput,
    rim: &Rim,
    polarity: &mut PolarityMemory,
    hysteresis: f64,
) -> Contacts {
    let spins: Vec<DVec3> = input
        .frames
        .iter()
        .map(|frame| input.plates.angular_velocity(frame.plate))
        .collect();
    let meet = |k| meet(input, rim, &spins, polarity, k);
    let mut contacts: Vec<Contact> = (0..rim.len())
        .into_par_iter()
        .with_min_len(256)
        .map(meet)
        .collect();
    polarity.update(&evidence(input, rim, &contacts), hysteresis);
    contacts
        .par_iter_mut()
        .enumerate()
        .with_min_len(256)
        .for_each(|(k, contact)| decide(input, rim, polarity, k, contact));
    Contacts(contacts)
}

/// What rim sample `k` meets; the role of converging plates is still open ([`Role::Overriding`]
/// stands for both). `spins` are the frames' angular velocities in the world.
fn meet(
    input: &ContactInput,
    rim: &Rim,
    spins: &[DVec3],
    polarity: &PolarityMemory,
    k: usize,
) -> Contact {
    let &ContactInput {
        mesh,
        crust,
        frames,
        overlap,
        radius,
        ..
    } = input;
    let sample = rim.samples[k];
    let id = crust.frame[sample as usize];
    let frame = &frames[usize::from(id)];
    let local = mesh.point(sample);
    // The normal is a unit tangent: every probe has the same length before it is put on the sphere.
    let reach = 0.75 * mesh.spacing();
    let probe = (local + rim.normal[k] * reach) * (1.0 / (1.0 + reach * reach).sqrt());
    let p = frame.to_world(probe);
    let foreign = |other: &Frame| other.plate != frame.plate;
    let Some(hit) = overlap.top_if(mesh, crust, frames, polarity, p, foreign) else {
        return Contact::default();
    };
    let other = frames.plate(hit.frame);
    let relative = overlap.to_lattice(id, spins[usize::from(id)] - spins[usize::from(hit.frame)]);
    let approach = relative.cross(local).dot(rim.normal[k]) * radius;
    let met = hit.sample as usize;
    let role = if approach > SLIDING {
        Role::Overriding
    } else if approach < -SLIDING {
        Role::Diverging
    } else {
        Role::Sliding
    };
    Contact {
        role,
        other,
        frame: hit.frame,
        sample: hit.sample,
        other_continental: crust.is_continental(met),
        other_elevation: crust.elevation[met],
        approach: approach as f32,
        relative,
    }
}

/// Ages of ocean floors that meet, by pair and segment, summed in the order of the rim.
fn evidence(input: &ContactInput, rim: &Rim, contacts: &[Contact]) -> Vec<((Pair, u16), Evidence)> {
    let &ContactInput {
        mesh,
        crust,
        frames,
        ..
    } = input;
    let seen = parallel::map_chunks(contacts.len(), |range| {
        let meeting = |k: usize| {
            let (i, contact) = (rim.samples[k] as usize, &contacts[k]);
            let frame = &frames[usize::from(crust.frame[i])];
            let (pair, swapped) = pair(frame.plate, contact.other);
            let age = match (crust.is_continental(i), contact.other_continental) {
                (true, true) => [0.0; 2],
                (true, false) => [0.0, OCEAN_UNDER_CONTINENT],
                (false, true) => [OCEAN_UNDER_CONTINENT, 0.0],
                (false, false) => [
                    f64::from(crust.ocean_age[i]),
                    f64::from(crust.ocean_age[contact.sample as usize]),
                ],
            };
            let age = if swapped { [age[1], age[0]] } else { age };
            ((pair, bin(frame.to_world(mesh.points()[i]))), age)
        };
        range
            .filter(|&k| contacts[k].role == Role::Overriding)
            .map(meeting)
            .collect::<Vec<_>>()
    });
    let mut found: BTreeMap<(Pair, u16), Evidence> = BTreeMap::new();
    let seen: Vec<_> = seen.concat();
    // Neighbours on the rim mostly belong to one segment: one search serves them all.
    for run in seen.chunk_by(|a, b| a.0 == b.0) {
        let sum = found.entry(run[0].0).or_default();
        for (_, age) in run {
            sum.age[0] += age[0];
            sum.age[1] += age[1];
            sum.count += 1;
        }
    }
    found.into_iter().collect()
}

/// Decides which of two converging plates goes under.
fn decide(
    input: &ContactInput,
    rim: &Rim,
    polarity: &PolarityMemory,
    k: usize,
    contact: &mut Contact,
) {
    if contact.role != Role::Overriding {
        return;
    }
    let &ContactInput {
        mesh,
        crust,
        frames,
        ..
    } = input;
    let i = rim.samples[k] as usize;
    let own = if crust.is_continental(i) {
        CrustKind::Continental
    } else {
        CrustKind::Oceanic
    };
    let frame = &frames[usize::from(crust.frame[i])];
    let goes_under = match (own, contact.other_continental) {
        (CrustKind::Continental, false) => false,
        (CrustKind::Oceanic, true) => true,
        _ => {
            let p = frame.to_world(mesh.points()[i]);
            polarity.under(frame.plate, contact.other, p) == Some(frame.plate)
        }
    };
    if goes_under {
        contact.role = Role::Subducting;
    }
}
