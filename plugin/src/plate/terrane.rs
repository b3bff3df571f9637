//! Terranes: connected regions of continental crust on one plate (paper 000 §3).

use crate::crust::{Crust, Frames};
use crate::ids::{FrameId, PlateId};
use crate::sphere::SphereMesh;
use crate::sphere::components::Components;
use bevy::math::DVec3;
use bevy::prelude::*;

/// A connected region of continental crust, from a small island to a whole continent.
///
/// Between two steps the terranes are those of the crust as it is. A step that changes which
/// samples a terrane has replaces the entities of all; drift only moves their centroids.
#[derive(Component, Clone, Debug, PartialEq, Reflect)]
#[reflect(Component)]
pub struct Terrane {
    /// The frame that carries it.
    pub frame: FrameId,
    /// Number of samples.
    pub samples: u32,
    /// Area in km².
    pub area: f64,
    /// Unit direction of the centroid in world coordinates.
    pub centroid: DVec3,
}

/// The plate that carries a terrane.
#[derive(Component, Clone, Copy, Debug, PartialEq, Eq, Reflect)]
#[relationship(relationship_target = Terranes)]
#[reflect(Component)]
pub struct TerraneOf(pub Entity);

/// The terranes of a plate.
#[derive(Component, Clone, Debug, Default, Reflect)]
#[relationship_target(relationship = TerraneOf, linked_spawn)]
#[reflect(Component)]
pub struct Terranes(Vec<Entity>);

/// Whether the terranes of a planet must be found anew before its step ends.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq, Eq, Reflect)]
#[reflect(Component)]
pub struct TerraneCensus {
    /// Set by whatever moves samples between frames or changes their kind.
    pub stale: bool,
}

/// Sums over the samples of a terrane, in steradians and lattice coordinates.
#[derive(Clone, Copy, Default)]
struct TerraneSums {
    frame: FrameId,
    samples: u32,
    area: f64,
    moment: DVec3,
}

/// The terranes of all plates: connected continental samples of one frame, in the order of their
/// first samples. `radius` is in km.
pub fn find_terranes(
    mesh: &SphereMesh,
    crust: &Crust,
    frames: &Frames,
    radius: f64,
) -> Vec<(PlateId, Terrane)> {
    let components = Components::new(
        mesh,
        |i| crust.is_continental(i as usize),
        |i, j| crust.frame[i as usize] == crust.frame[j as usize],
    );
    let mut sums = vec![TerraneSums::default(); components.count];
    for (i, &number) in components.of.iter().enumerate() {
        // Samples of no component have a number beyond the last.
        if let Some(sum) = sums.get_mut(number as usize) {
            // The same for all samples of a component.
            sum.frame = crust.frame[i];
            sum.samples += 1;
            sum.area += mesh.areas()[i];
            sum.moment += mesh.points()[i] * mesh.areas()[i];
        }
    }
    sums.iter()
        .map(|sum| terrane(sum, frames, radius))
        .collect()
}

fn terrane(sum: &TerraneSums, frames: &Frames, radius: f64) -> (PlateId, Terrane) {
    let frame = &frames[usize::from(sum.frame)];
    let terrane = Terrane {
        frame: sum.frame,
        samples: sum.samples,
        area: sum.area * radius * radius,
        // A terrane all round the sphere has no centroid: any direction serves.
        centroid: frame
            .to_world(sum.moment)
            .try_normalize()
            .unwrap_or(DVec3::Z),
    };
    (frame.plate, terrane)
}
