//! One collision: which terrane breaks off, where it is sutured, and its new frame.

use super::surge::Surge;
use crate::crust::{Crust, Frame, FrameId, Frames};
use crate::events::TerraneCollided;
use crate::plate::PlateTable;
use crate::plate::boundary::Rim;
use crate::plate::contact::Contacts;
use crate::plate::overlap::OverlapIndex;
use crate::sphere::SphereMesh;
use crate::sphere::nearest_source::{ReachedSamples, SourceScratch, nearest_sources};
use crate::view::PlanetView;
use bevy::math::DVec3;
use bevy::prelude::*;
use rayon::prelude::*;

/// The state that all parts of a collision read.
pub(super) struct CollisionInput<'a> {
    pub planet: PlanetView<'a>,
    pub rim: &'a Rim,
    pub contacts: &'a Contacts,
    pub overlap: &'a OverlapIndex,
    pub plates: PlateTable,
}

/// A collision that is going to happen.
pub(super) struct Collision {
    /// The frame that loses the terrane.
    pub from: FrameId,
    /// The samples of the terrane, in order.
    pub terrane: Vec<u32>,
    /// The frame that it is sutured to.
    to: FrameId,
    /// Samples of both frames that met first: the terrane's, and the other's.
    start: [u32; 2],
    /// Unit direction of the place of contact.
    at: DVec3,
    /// Unit direction of the terrane's centroid.
    centroid: DVec3,
    /// Area of the terrane in km².
    area: f64,
    /// Relative speed at the centroid in km/My.
    speed: f64,
}

impl Collision {
    /// The collision at the rim's position `k`, if both sides still stand where they were found and
    /// the smaller terrane is large enough.
    pub(super) fn find(
        continents: &CollisionInput,
        k: usize,
        crust: &Crust,
        frames: &Frames,
    ) -> Option<Self> {
        if !continents.still_meet(k, crust, frames) {
            return None;
        }
        let mesh = continents.planet.mesh;
        let above = continents.rim.samples[k];
        let sides = [above, continents.contacts.0[k].sample];
        let (mover, terrane) = smaller_terrane(mesh, crust, sides);
        let area = continents.area(&terrane);
        if area < continents.planet.params.terrane_min_area {
            return None;
        }
        let start = [sides[mover], sides[1 - mover]];
        let [from, to] = start.map(|i| crust.frame[i as usize]);
        let place = &frames[usize::from(crust.frame[above as usize])];
        let centroid = continents.centroid(&terrane, &frames[usize::from(from)]);
        let spin = |id: FrameId| continents.plates.angular_velocity(frames.plate(id));
        let relative = spin(from) - spin(to);
        Some(Self {
            from,
            terrane,
            to,
            start,
            at: place.to_world(mesh.point(above)),
            centroid,
            area,
            speed: relative.cross(centroid).length() * continents.planet.radius,
        })
    }

    /// The event of the collision; its planet is still to be filled in.
    pub(super) fn event(&self, frames: &Frames) -> TerraneCollided {
        TerraneCollided {
            planet: Entity::PLACEHOLDER,
            from: frames.plate(self.from),
            to: frames.plate(self.to),
            area: self.area,
            at: self.at,
            speed: self.speed,
        }
    }

    /// Raises the crust on both sides of the suture. Returns the volumes in km³ that the terrane's
    /// frame and the other gained.
    pub(super) fn surge(
        &self,
        continents: &CollisionInput,
        crust: &mut Crust,
        frames: &Frames,
        scratch: &mut SourceScratch,
    ) -> [f64; 2] {
        let planet = &continents.planet;
        let surge = Surge::new(planet.params, planet.radius, self.area, self.speed);
        let [own, other] = self.suture(continents, crust, frames);
        // Side by side in the world, apart on the lattice: each frame is searched by itself.
        [(self.from, own), (self.to, other)].map(|(id, seeds)| {
            let centroid = frames[usize::from(id)].to_lattice(self.centroid);
            let reached = continents.reach(crust, id, &seeds, surge.radius, scratch);
            let volume = surge.raise(planet.mesh, crust, &reached, centroid);
            volume * planet.radius * planet.radius
        })
    }

    /// The samples of both sides that lie in the overlap: of the terrane, and of the other frame.
    fn suture(&self, continents: &CollisionInput, crust: &Crust, frames: &Frames) -> [Vec<u32>; 2] {
        let mesh = continents.planet.mesh;
        let frame = frames[usize::from(self.from)];
        let under = |i: u32| continents.continent_at(crust, self.to, frame.to_world(mesh.point(i)));
        let pairs: Vec<(u32, u32)> = self
            .terrane
            .par_iter()
            .with_min_len(512)
            .filter_map(|&i| Some((i, under(i)?)))
            .collect();
        let (mut own, mut other): (Vec<u32>, Vec<u32>) = pairs.into_iter().unzip();
        // Where only the rim overlaps, the two that met are the suture.
        own.push(self.start[0]);
        other.push(self.start[1]);
        for side in [&mut own, &mut other] {
            side.sort_unstable();
            side.dedup();
        }
        [own, other]
    }

    /// Gives the terrane a new frame with the rotation of its old one, owned by the other plate.
    /// Returns its number.
    pub(super) fn reframe(&self, crust: &mut Crust, frames: &mut Frames) -> FrameId {
        let id = frames.len() as FrameId;
        let frame = Frame {
            plate: frames.plate(self.to),
            rotation: frames[usize::from(self.from)].rotation,
            terrane: true,
        };
        frames.push(frame);
        for &i in &self.terrane {
            crust.frame[i as usize] = id;
        }
        id
    }
}

impl CollisionInput<'_> {
    /// Whether both sides of the contact at the rim's position `k` are still carried by the plates
    /// that met: an earlier collision of the step may have moved them.
    fn still_meet(&self, k: usize, crust: &Crust, frames: &Frames) -> bool {
        let contact = self.contacts.0[k];
        let above = self.rim.samples[k];
        crust.frame[contact.sample as usize] == contact.frame
            && frames.plate(contact.frame) == contact.other
            && frames.plate(crust.frame[above as usize]) != contact.other
    }

    /// Area of samples in km².
    fn area(&self, samples: &[u32]) -> f64 {
        let sum: f64 = samples.iter().map(|&i| self.planet.mesh.area(i)).sum();
        sum * self.planet.radius * self.planet.radius
    }

    /// Centroid of samples of a frame, as a unit direction in world coordinates.
    fn centroid(&self, samples: &[u32], frame: &Frame) -> DVec3 {
        let mesh = self.planet.mesh;
        let moments = samples.iter().map(|&i| mesh.point(i) * mesh.area(i));
        let sum: DVec3 = moments.sum();
        frame.to_world(sum.try_normalize().unwrap_or(DVec3::Z))
    }

    /// The continental sample of a frame that covers a direction of the world, if there is one.
    fn continent_at(&self, crust: &Crust, id: FrameId, p: DVec3) -> Option<u32> {
        let hit = self.overlap.hit(self.planet.mesh, crust, id, p)?;
        crust
            .is_continental(hit.sample as usize)
            .then_some(hit.sample)
    }

    /// Distances from `seeds` over the continental crust of one frame, as far as `reach` radians.
    fn reach(
        &self,
        crust: &Crust,
        id: FrameId,
        seeds: &[u32],
        reach: f64,
        scratch: &mut SourceScratch,
    ) -> ReachedSamples {
        let mesh = self.planet.mesh;
        let seeds: Vec<_> = seeds.iter().map(|&i| (i, mesh.point(i))).collect();
        nearest_sources(mesh, scratch, &seeds, reach, |_, to| {
            crust.frame[to as usize] == id && crust.is_continental(to as usize)
        })
    }
}

/// Samples that are flooded before it is the other side's turn.
const SAMPLES_PER_TURN: usize = 256;

/// The smaller of two terranes, each the connected continental samples of one frame around its
/// start: which of the two, and its samples in order. Both are flooded in turns of equal size until
/// one is complete.
pub fn smaller_terrane(mesh: &SphereMesh, crust: &Crust, start: [u32; 2]) -> (usize, Vec<u32>) {
    let mut seen = vec![false; mesh.len()];
    for i in start {
        seen[i as usize] = true;
    }
    let mut floods = start.map(|i| TerraneFlood {
        frame: crust.frame[i as usize],
        samples: vec![i],
        next: 0,
    });
    loop {
        // The smaller is complete first, and a continent is not flooded for an island.
        for (side, flood) in floods.iter_mut().enumerate() {
            if flood.advance(mesh, crust, &mut seen) {
                let mut samples = core::mem::take(&mut flood.samples);
                samples.sort_unstable();
                return (side, samples);
            }
        }
    }
}

/// The continental samples of a frame that were found from a start.
struct TerraneFlood {
    frame: FrameId,
    samples: Vec<u32>,
    /// Position of the sample whose neighbours come next.
    next: usize,
}

impl TerraneFlood {
    /// Floods as many samples as a turn has. Returns whether the terrane is complete.
    fn advance(&mut self, mesh: &SphereMesh, crust: &Crust, seen: &mut [bool]) -> bool {
        for _ in 0..SAMPLES_PER_TURN {
            let Some(&i) = self.samples.get(self.next) else {
                return true;
            };
            self.next += 1;
            for &j in mesh.ring(i) {
                let k = j as usize;
                if !seen[k] && crust.frame[k] == self.frame && crust.is_continental(k) {
                    seen[k] = true;
                    self.samples.push(j);
                }
            }
        }
        false
    }
}
