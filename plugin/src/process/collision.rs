//! Continental collision: a terrane breaks off its slab and is sutured (paper 000 §4.2, §6).
//!
//! ```text
//! r = r_c sqrt(v/v_0 A/A_0), at most r_c            (root over both, as in paper 004)
//! dz(p) = D f(d(p)),  f(x) = (1 - (x/r)²)²          D = Delta_c A, saturating at the highest surge
//! f' = (n x (p - q)/|p - q|) x n
//! ```
//!
//! *Trigger*: continents of two plates overlap by 300 km, measured along their relative motion from
//! the rim of either plate backwards; half of that in a step that ends with a resample, which would
//! resolve the overlap. *Who moves*: the smaller of the two terranes takes a new frame owned by the
//! other's plate, with the rotation that it has; no resample is forced. *Distance*: d is measured
//! from the overlap, on both sides of the suture; measured from the whole terrane, as printed, a
//! continent that collides would become one plateau. *Small islands*, below
//! [`TectonicParams::terrane_min_area`], do not break off: they are forced down, and booked as such
//! when the crust is resampled. Only continental crust surges.
//!
//! Reads: contacts, crust. Writes: frames, elevation, thickness, fold, orogeny.

use crate::crust::isostasy::Isostasy;
use crate::crust::{Cause, Crust, Frame, FrameId, Frames, Ledger, Orogeny};
use crate::events::TerraneCollided;
use crate::params::TectonicParams;
use crate::planet::{GeologicClock, Lattice, Planet};
use crate::plate::PlateAccess;
use crate::plate::boundary::Rim;
use crate::plate::caches::{MovedSamples, recompute_moved};
use crate::plate::contact::{Contacts, Role};
use crate::plate::overlap::OverlapIndex;
use crate::plate::{PlateId, PlateTable};
use crate::process::saturating_rise;
use crate::schedule::{Stage, TectonicStep, TectonicSystems};
use crate::sphere::SphereMesh;
use crate::sphere::nearest_source::{ReachedSamples, SourceScratch, nearest_sources};
use bevy::math::DVec3;
use bevy::prelude::*;
use rayon::prelude::*;

/// Adds [`collision`] to the step.
pub struct CollisionPlugin;

impl Plugin for CollisionPlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(
            TectonicStep,
            collision.in_set(TectonicSystems::Process(Stage::Collision)),
        );
    }
}

/// What all parts of a collision read.
struct Scene<'a> {
    planet: &'a Planet,
    mesh: &'a SphereMesh,
    params: &'a TectonicParams,
    rim: &'a Rim,
    contacts: &'a Contacts,
    overlap: &'a OverlapIndex,
    plates: PlateTable,
    /// Overlap in radians from which on a terrane breaks off.
    trigger: f64,
}

/// Sutures terranes of the current planet.
pub fn collision(
    plates: PlateAccess,
    mut planets: Query<(
        (
            &Planet,
            &Lattice,
            &TectonicParams,
            &GeologicClock,
            &Rim,
            &Contacts,
            &OverlapIndex,
        ),
        (&mut Crust, &mut Frames, &mut Ledger),
    )>,
    mut commands: Commands,
) {
    let Ok((input, (mut crust, mut frames, mut ledger))) = planets.get_mut(plates.planet()) else {
        return;
    };
    let (planet, lattice, params, clock, rim, contacts, overlap) = input;
    if !params.processes.collision {
        return;
    }
    let mesh: &SphereMesh = lattice;
    let meeting = meeting_continents(rim, contacts, &crust);
    if meeting.is_empty() {
        return;
    }
    let table = plates.table();
    // A resample resolves overlaps: what is half way to a collision would never become one.
    let last_chance = crate::resample::due(params, clock, &table, planet.radius, frames.len());
    let trigger = params.collision_trigger / planet.radius * if last_chance { 0.5 } else { 1.0 };
    let scene = Scene {
        planet,
        mesh,
        params,
        rim,
        contacts,
        overlap,
        plates: table,
        trigger,
    };
    let mut moved = MovedSamples::default();
    let mut scratch = SourceScratch::default();
    for at in scene.overlaps(&meeting, &crust, &frames) {
        let found = scene.collide(at, &mut crust, &mut frames, &mut ledger, &mut scratch);
        if let Some((mut event, frame, terrane)) = found {
            event.planet = plates.planet();
            moved
                .frames
                .extend([crust.frame[terrane[0] as usize], frame]);
            moved.samples.extend(terrane);
            commands.trigger(event);
        }
    }
    if !moved.samples.is_empty() {
        let planet = plates.planet();
        moved.samples.sort_unstable();
        moved.samples.dedup();
        commands.queue(move |world: &mut World| recompute_moved(world, planet, &moved));
    }
}

/// Positions on the rim where continents of two plates converge, in order.
fn meeting_continents(rim: &Rim, contacts: &Contacts, crust: &Crust) -> Vec<usize> {
    let meet = |&k: &usize| {
        let contact = &contacts.0[k];
        matches!(contact.role, Role::Overriding | Role::Subducting)
            && contact.other_continental
            && crust.is_continental(rim.samples[k] as usize)
    };
    (0..contacts.0.len()).filter(meet).collect()
}

impl Scene<'_> {
    /// The first place of every pair of frames where continents overlap by the trigger, in the
    /// order of the rim.
    fn overlaps(&self, meeting: &[usize], crust: &Crust, frames: &Frames) -> Vec<usize> {
        let deep = |k: usize| {
            self.overlaps_by(k, self.trigger, crust, frames)
                .then_some(k)
        };
        let found: Vec<usize> = meeting
            .par_iter()
            .with_min_len(64)
            .filter_map(|&k| deep(k))
            .collect();
        let mut pairs: Vec<(FrameId, FrameId)> = Vec::new();
        let first = |&k: &usize| {
            let pair = (
                crust.frame[self.rim.samples[k] as usize],
                self.contacts.0[k].frame,
            );
            let new = !pairs.contains(&pair);
            if new {
                pairs.push(pair);
            }
            new
        };
        found.into_iter().filter(first).collect()
    }

    /// Whether the other plate's continent lies under rim sample `k` and for `length` radians
    /// behind it, against the relative motion; seen in steps of half a sample.
    fn overlaps_by(&self, k: usize, length: f64, crust: &Crust, frames: &Frames) -> bool {
        let contact = &self.contacts.0[k];
        let sample = self.rim.samples[k];
        let frame = &frames[usize::from(crust.frame[sample as usize])];
        let p = self.mesh.point(sample);
        let Some(forward) = contact.relative.cross(p).try_normalize() else {
            return false;
        };
        let stride = 0.5 * self.mesh.spacing();
        // The far end first: most overlaps are short.
        (0..=(length / stride) as usize).rev().all(|step| {
            let (s, c) = crate::math::sin_cos(stride * step as f64);
            let back = frame.to_world(p * c - forward * s);
            let hit = self.overlap.hit(self.mesh, crust, contact.frame, back);
            hit.is_some_and(|hit| crust.is_continental(hit.sample as usize))
        })
    }

    /// Carries out one collision at the rim's sample number `at`, if both terranes still stand
    /// where they were found and are large enough. Returns also the frame that the terrane left,
    /// and its samples.
    fn collide(
        &self,
        at: usize,
        crust: &mut Crust,
        frames: &mut Frames,
        ledger: &mut Ledger,
        scratch: &mut SourceScratch,
    ) -> Option<(TerraneCollided, FrameId, Vec<u32>)> {
        let contact = self.contacts.0[at];
        let above = self.rim.samples[at];
        let still_there = crust.frame[contact.sample as usize] == contact.frame
            && frames.plate(contact.frame) == contact.other
            && frames.plate(crust.frame[above as usize]) != contact.other;
        if !still_there {
            return None;
        }
        let start = [above, contact.sample];
        let (mover, terrane) = smaller_terrane(self.mesh, crust, start);
        let area = self.area(&terrane);
        if area < self.params.terrane_min_area {
            return None;
        }
        let ids = start.map(|i| crust.frame[i as usize]);
        let (from, to) = (ids[mover], ids[1 - mover]);
        let at = frames[usize::from(ids[0])].to_world(self.mesh.point(above));
        let centroid = self.centroid(&terrane, &frames[usize::from(from)]);
        let relative = self.plates.angular_velocity(frames.plate(from))
            - self.plates.angular_velocity(frames.plate(to));
        let speed = relative.cross(centroid).length() * self.planet.radius;
        let surge = Surge::new(self.params, self.planet.radius, area, speed);
        let seeds = self.suture(&terrane, crust, frames, from, to, start, mover);
        for (side, id) in [(0, from), (1, to)] {
            let q = frames[usize::from(id)].to_lattice(centroid);
            let reached = self.spread_on(crust, id, &seeds[side], surge.radius, scratch);
            let volume = surge.raise(self.mesh, crust, &reached, q);
            ledger.book(
                Cause::CollisionUplift,
                0.0,
                volume * self.planet.radius * self.planet.radius,
            );
        }
        let event = TerraneCollided {
            planet: Entity::PLACEHOLDER,
            from: frames.plate(from),
            to: frames.plate(to),
            area,
            at,
            speed,
        };
        reframe(crust, frames, &terrane, from, event.to);
        Some((event, from, terrane))
    }

    fn area(&self, samples: &[u32]) -> f64 {
        let sum: f64 = samples.iter().map(|&i| self.mesh.area(i)).sum();
        sum * self.planet.radius * self.planet.radius
    }

    fn centroid(&self, samples: &[u32], frame: &Frame) -> DVec3 {
        let sum: DVec3 = samples
            .iter()
            .map(|&i| self.mesh.point(i) * self.mesh.area(i))
            .sum();
        frame.to_world(sum.try_normalize().unwrap_or(DVec3::Z))
    }

    /// The samples of both sides that lie in the overlap: of the mover's frame, and of the other.
    fn suture(
        &self,
        terrane: &[u32],
        crust: &Crust,
        frames: &Frames,
        from: FrameId,
        to: FrameId,
        start: [u32; 2],
        mover: usize,
    ) -> [Vec<u32>; 2] {
        let frame = frames[usize::from(from)];
        let pairs: Vec<(u32, u32)> = terrane
            .par_iter()
            .with_min_len(512)
            .filter_map(|&i| {
                let p = frame.to_world(self.mesh.point(i));
                let hit = self.overlap.hit(self.mesh, crust, to, p)?;
                crust
                    .is_continental(hit.sample as usize)
                    .then_some((i, hit.sample))
            })
            .collect();
        let mut own: Vec<u32> = pairs.iter().map(|pair| pair.0).collect();
        let mut other: Vec<u32> = pairs.iter().map(|pair| pair.1).collect();
        own.push(start[mover]);
        other.push(start[1 - mover]);
        for side in [&mut own, &mut other] {
            side.sort_unstable();
            side.dedup();
        }
        [own, other]
    }

    /// Distances from the suture over the continental crust of one frame.
    fn spread_on(
        &self,
        crust: &Crust,
        id: FrameId,
        seeds: &[u32],
        reach: f64,
        scratch: &mut SourceScratch,
    ) -> ReachedSamples {
        let seeds: Vec<_> = seeds.iter().map(|&i| (i, self.mesh.point(i))).collect();
        nearest_sources(self.mesh, scratch, &seeds, reach, |_, to| {
            crust.frame[to as usize] == id && crust.is_continental(to as usize)
        })
    }
}

/// The surge of one collision.
struct Surge {
    /// Radius of influence in radians.
    radius: f64,
    /// Surge at the suture in km.
    height: f64,
    ceiling: f32,
    isostasy: Isostasy,
}

impl Surge {
    /// The surge of a terrane of `area` km² that arrives at `speed` km/My.
    fn new(params: &TectonicParams, planet_radius: f64, area: f64, speed: f64) -> Self {
        let average = params.plate_share * 4.0 * crate::math::PI * planet_radius * planet_radius;
        let share = (speed / params.max_speed * area / average).min(1.0).sqrt();
        let printed = params.collision_coefficient * area;
        let highest = params.collision_surge_max;
        Self {
            radius: params.collision_distance * params.collision_reach * share / planet_radius,
            height: if printed > 0.0 {
                printed * highest / (printed + highest)
            } else {
                0.0
            },
            ceiling: params.summit_elevation as f32,
            isostasy: Isostasy::new(params),
        }
    }

    /// The profile f at `d` radians from the suture.
    fn profile(&self, d: f64) -> f64 {
        let x = d / self.radius.max(1e-9);
        let y = (1.0 - x * x).max(0.0);
        y * y
    }

    /// Raises what was reached, around the centroid `q`. Returns the gain of volume in km per
    /// steradian.
    fn raise(
        &self,
        mesh: &SphereMesh,
        crust: &mut Crust,
        reached: &ReachedSamples,
        q: DVec3,
    ) -> f64 {
        let mut volume = 0.0;
        for (&i, &d) in reached.samples.iter().zip(&reached.distance) {
            let (n, i) = (mesh.point(i), i as usize);
            let dz = (self.height * self.profile(f64::from(d))) as f32;
            let z = crust.elevation[i];
            let raised = saturating_rise(z, dz, self.ceiling);
            let gain = self.isostasy.thickening(z, raised - z);
            let before = crust.thickness[i];
            crust.elevation[i] = raised;
            crust.thickness[i] = before + gain;
            volume += f64::from(crust.thickness[i] - before) * mesh.areas()[i];
            // A belt is where the surge is felt, not the whole radius of influence.
            if dz > 0.1 * self.height as f32 {
                crust.orogeny[i] = Orogeny::Himalayan;
                crust.orogeny_age[i] = 0.0;
                let away = (n - q).normalize_or_zero();
                crust.fold[i] = n.cross(away).cross(n).normalize_or_zero().as_vec3();
            }
        }
        volume
    }
}

/// The smaller of two terranes, each the connected continental samples of one frame around its
/// start: which of the two, and its samples in order. Both are flooded in turns of equal size until
/// one is complete.
pub fn smaller_terrane(mesh: &SphereMesh, crust: &Crust, start: [u32; 2]) -> (usize, Vec<u32>) {
    const TURN: usize = 256;
    let mut seen = vec![false; mesh.len()];
    let mut found = start.map(|i| vec![i]);
    let mut next = [0; 2];
    start.iter().for_each(|&i| seen[i as usize] = true);
    loop {
        for side in 0..2 {
            let id = crust.frame[start[side] as usize];
            for _ in 0..TURN {
                let Some(&i) = found[side].get(next[side]) else {
                    let mut samples = core::mem::take(&mut found[side]);
                    samples.sort_unstable();
                    return (side, samples);
                };
                next[side] += 1;
                for &j in mesh.ring(i) {
                    let k = j as usize;
                    if !seen[k] && crust.frame[k] == id && crust.is_continental(k) {
                        seen[k] = true;
                        found[side].push(j);
                    }
                }
            }
        }
    }
}

/// Gives samples a new frame with the rotation of `from`, owned by the plate `to`.
fn reframe(crust: &mut Crust, frames: &mut Frames, samples: &[u32], from: FrameId, to: PlateId) {
    let id = frames.len() as FrameId;
    let rotation = frames[usize::from(from)].rotation;
    frames.push(Frame {
        plate: to,
        rotation,
        terrane: true,
    });
    for &i in samples {
        crust.frame[i as usize] = id;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn radius_and_surge_follow_the_paper() {
        let params = TectonicParams::default();
        let average = params.plate_share * 4.0 * crate::math::PI * 6370.0 * 6370.0;
        let full = Surge::new(&params, 6370.0, average, params.max_speed);
        assert!(
            (full.radius * 6370.0 - params.collision_distance * params.collision_reach).abs()
                < 1e-6
        );
        let quarter = Surge::new(&params, 6370.0, 0.25 * average, params.max_speed);
        assert!((quarter.radius / full.radius - 0.5).abs() < 1e-12);
        let beyond = Surge::new(&params, 6370.0, 100.0 * average, params.max_speed);
        assert_eq!(beyond.radius, full.radius);
        assert!(
            beyond.height < params.collision_surge_max
                && beyond.height > 0.9 * params.collision_surge_max
        );
        let island = Surge::new(&params, 6370.0, 1e4, params.max_speed);
        assert!(
            (island.height / 0.13 - 1.0).abs() < 0.05,
            "small terranes surge by the printed coefficient"
        );
        assert_eq!(full.profile(0.0), 1.0);
        assert_eq!(full.profile(full.radius), 0.0);
        assert!((full.profile(0.5 * full.radius) - 0.5625).abs() < 1e-12);
    }
}
