//! Where plates meet: every sample of a rim looks just beyond it (paper 000 §6, plate boundary
//! tracking).
//!
//! A sample of the rim probes the point three quarters of a sample's spacing outside. The crust
//! found there, and the relative velocity, make the meeting: the plates converge (and one of them
//! goes under), diverge, or slide. Moving triangles need not be intersected: a rim sample over another
//! plate's crust, or about to be, is the intersection at the resolution of the lattice.
//!
//! Policies. *Several plates at the probe*: the one on top of the others is met. *Triple junction*:
//! each rim sample meets one plate, so each part of the junction has one polarity.

use super::boundary::Rim;
use super::overlap::{FrameHit, OverlapIndex};
use super::polarity::{Evidence, FrontKey, PolarityMemory, bin, pair};
use super::{PlateId, PlateTable};
use crate::crust::{Crust, Frame, Frames};
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use bevy::prelude::*;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Speed along the normal in km/My below which plates neither converge nor diverge: a tenth of the
/// speed of a slow ridge.
pub const SLIDING_SPEED: f64 = 2.0;

/// Length of a probe in spacings: beyond half way to the next sample, short of that sample.
const PROBE_LENGTH: f64 = 0.75;

/// Rim samples per unit of parallel work.
const SAMPLES_PER_TASK: usize = 256;

/// Weight in My with which an ocean that goes under a continent speaks for the polarity of its
/// segment: an island that arrives there goes the same way.
const OCEAN_UNDER_CONTINENT: f64 = 200.0;

/// The part that a rim sample plays.
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
#[derive(Clone, Copy, Debug, Default, PartialEq, Reflect)]
pub struct Contact {
    /// The part that the sample plays.
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

impl Contact {
    /// Whether ocean floor of the other plate sinks here: it makes a trench, and pulls its plate.
    pub fn is_over_sinking_floor(&self) -> bool {
        self.role == Role::Overriding && !self.other_continental
    }
}

/// All meetings of one step, parallel to [`Rim::samples`].
#[derive(Component, Clone, Debug, Default, Reflect)]
#[reflect(Component)]
pub struct Contacts(pub Vec<Contact>);

/// The state that contacts are found from.
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

/// Finds all contacts and takes new evidence into the memory of polarity. `hysteresis` is in My,
/// see [`PolarityMemory::update`].
pub fn find_contacts(
    input: &ContactInput,
    rim: &Rim,
    polarity: &mut PolarityMemory,
    hysteresis: f64,
) -> Contacts {
    let frames = input.frames.iter();
    let spins: Vec<DVec3> = frames
        .map(|frame| input.plates.angular_velocity(frame.plate))
        .collect();
    // Evidence of the whole step comes before any decision, so the order of the rim decides
    // nothing.
    let mut contacts: Vec<Contact> = (0..rim.len())
        .into_par_iter()
        .with_min_len(SAMPLES_PER_TASK)
        .map(|k| input.meet(rim, &spins, polarity, k))
        .collect();
    polarity.update(&input.evidence(rim, &contacts), hysteresis);
    contacts
        .par_iter_mut()
        .enumerate()
        .with_min_len(SAMPLES_PER_TASK)
        .filter(|(_, contact)| contact.role == Role::Overriding)
        .for_each(|(k, contact)| {
            if input.goes_under(polarity, rim.samples[k], contact) {
                contact.role = Role::Subducting;
            }
        });
    Contacts(contacts)
}

impl Role {
    /// The role at a speed of approach in km/My. Of converging plates it is still open which goes
    /// under: [`Role::Overriding`] stands for both.
    fn of_approach(approach: f64) -> Self {
        if approach > SLIDING_SPEED {
            Self::Overriding
        } else if approach < -SLIDING_SPEED {
            Self::Diverging
        } else {
            Self::Sliding
        }
    }
}

impl ContactInput<'_> {
    /// The frame of a sample.
    fn frame_of(&self, i: u32) -> &Frame {
        &self.frames[usize::from(self.crust.frame[i as usize])]
    }

    /// The contact of rim sample `k`, with an open role where plates converge. `spins` are the
    /// frames' angular velocities in the world.
    fn meet(&self, rim: &Rim, spins: &[DVec3], polarity: &PolarityMemory, k: usize) -> Contact {
        let sample = rim.samples[k];
        let normal = rim.normal[k];
        let frame = self.frame_of(sample);
        let local = self.mesh.point(sample);
        let p = frame.to_world(self.probe(local, normal));
        let Some(hit) = self.top_foreign(polarity, frame.plate, p) else {
            return Contact::default();
        };
        let id = self.crust.frame[sample as usize];
        let spin = spins[usize::from(id)] - spins[usize::from(hit.frame)];
        // The motion of the own plate as seen from the other one, in the frame of the own lattice.
        let relative = self.overlap.to_lattice(id, spin);
        // ω × p along the outward normal: positive where the own plate advances on the other.
        let approach = relative.cross(local).dot(normal) * self.radius;
        let met = hit.sample as usize;
        Contact {
            role: Role::of_approach(approach),
            other: self.frames.plate(hit.frame),
            frame: hit.frame,
            sample: hit.sample,
            other_continental: self.crust.is_continental(met),
            other_elevation: self.crust.elevation[met],
            approach: approach as f32,
            relative,
        }
    }

    /// The crust on top at `p` of all plates but `own`.
    fn top_foreign(&self, polarity: &PolarityMemory, own: PlateId, p: DVec3) -> Option<FrameHit> {
        let foreign = |frame: &Frame| frame.plate != own;
        self.overlap
            .top_if(self.mesh, self.crust, self.frames, polarity, p, foreign)
    }

    /// The unit direction that a rim sample probes, in lattice coordinates.
    fn probe(&self, local: DVec3, normal: DVec3) -> DVec3 {
        let reach = PROBE_LENGTH * self.mesh.spacing();
        // The normal is a unit tangent: every probe has the same length before it is put on the
        // sphere.
        (local + normal * reach) * (1.0 / (1.0 + reach * reach).sqrt())
    }

    /// Evidence of this step for the polarity of every segment, summed in the order of the rim.
    fn evidence(&self, rim: &Rim, contacts: &[Contact]) -> Vec<(FrontKey, Evidence)> {
        let seen = parallel::map_chunks(contacts.len(), |range| {
            range
                .filter(|&k| contacts[k].role == Role::Overriding)
                .map(|k| self.meeting_ages(rim.samples[k], &contacts[k]))
                .collect::<Vec<_>>()
        });
        let mut found: BTreeMap<FrontKey, Evidence> = BTreeMap::new();
        // Neighbours on the rim mostly belong to one segment: one search serves them all.
        for run in seen.concat().chunk_by(|a, b| a.0 == b.0) {
            let sum = found.entry(run[0].0).or_default();
            run.iter().for_each(|&(_, ages)| sum.add(ages));
        }
        found.into_iter().collect()
    }

    /// The segment of a meeting, and the ages in My that speak for the polarity, in the order of
    /// the pair.
    fn meeting_ages(&self, sample: u32, contact: &Contact) -> (FrontKey, [f64; 2]) {
        let i = sample as usize;
        let frame = self.frame_of(sample);
        let (pair, swapped) = pair(frame.plate, contact.other);
        let mut ages = match (self.crust.is_continental(i), contact.other_continental) {
            // Continents speak for neither: the segment keeps its decision.
            (true, true) => [0.0; 2],
            (true, false) => [0.0, OCEAN_UNDER_CONTINENT],
            (false, true) => [OCEAN_UNDER_CONTINENT, 0.0],
            (false, false) => [i, contact.sample as usize].map(|i| self.crust.ocean_age[i].into()),
        };
        if swapped {
            ages.swap(0, 1);
        }
        let bin = bin(frame.to_world(self.mesh.point(sample)));
        ((pair, bin), ages)
    }

    /// Whether the plate of a rim sample goes under the plate that it converges with.
    fn goes_under(&self, polarity: &PolarityMemory, sample: u32, contact: &Contact) -> bool {
        let own_continental = self.crust.is_continental(sample as usize);
        // An ocean goes under a continent, whatever the segment remembers.
        if own_continental != contact.other_continental {
            return contact.other_continental;
        }
        let frame = self.frame_of(sample);
        let p = frame.to_world(self.mesh.point(sample));
        polarity.under(frame.plate, contact.other, p) == Some(frame.plate)
    }
}
