//! Terranes: connected regions of continental crust on one plate (paper 000 §3).

use super::FrameId;
use crate::sphere::components::Components;
use bevy::math::DVec3;
use bevy::prelude::*;

/// A connected region of continental crust, from a small island to a whole continent.
#[derive(Component, Clone, Debug, PartialEq, Reflect)]
#[reflect(Component)]
pub struct Terrane {
    /// Area in km².
    pub area: f64,
    /// Unit direction of the centroid, in world coordinates at the time of the last census.
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

/// Finds the terranes of all plates: connected continental samples of one frame, in the order of
/// their first samples.
pub fn census(
    mesh: &crate::sphere::SphereMesh,
    crust: &super::Crust,
    frames: &super::Frames,
    radius: f64,
) -> Vec<(crate::plate::PlateId, Terrane)> {
    let member = |i: u32| crust.is_continental(i as usize);
    let together = |i: u32, j: u32| crust.frame[i as usize] == crust.frame[j as usize];
    let components = Components::new(mesh, member, together);
    let mut sums = vec![(0, 0.0, DVec3::ZERO); components.count];
    for (i, &number) in components.of.iter().enumerate() {
        if let Some((id, area, moment)) = sums.get_mut(number as usize) {
            *id = crust.frame[i];
            *area += mesh.areas()[i];
            *moment += mesh.points()[i] * mesh.areas()[i];
        }
    }
    let terrane = |(id, area, moment): (FrameId, f64, DVec3)| {
        let frame = frames[usize::from(id)];
        let centroid = frame.to_world(moment).try_normalize().unwrap_or(DVec3::Z);
        (
            frame.plate,
            Terrane {
                area: area * radius * radius,
                centroid,
            },
        )
    };
    sums.into_iter().map(terrane).collect()
}
