//! Terranes: connected regions of continental crust on one plate (paper 000 §3).

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

/// Finds the terranes of all plates: connected continental samples of one frame, in the order of their first samples.
pub fn census(
    mesh: &crate::sphere::SphereMesh,
    crust: &super::Crust,
    frames: &super::Frames,
    radius: f64,
) -> Vec<(crate::plate::PlateId, Terrane)> {
    let mut seen = vec![false; crust.len()];
    let mut found = Vec::new();
    let mut queue = Vec::new();
    for start in 0..crust.len() {
        if seen[start] || !crust.is_continental(start) {
            continue;
        }
        let id = crust.frame[start];
        let (mut area, mut moment) = (0.0, DVec3::ZERO);
        seen[start] = true;
        queue.push(start as u32);
        while let Some(i) = queue.pop() {
            area += mesh.area(i);
            moment += mesh.point(i) * mesh.area(i);
            for &j in mesh.ring(i) {
                let k = j as usize;
                if !seen[k] && crust.frame[k] == id && crust.is_continental(k) {
                    seen[k] = true;
                    queue.push(j);
                }
            }
        }
        let frame = frames[usize::from(id)];
        let centroid = frame.to_world(moment).try_normalize().unwrap_or(DVec3::Z);
        found.push((frame.plate, Terrane { area: area * radius * radius, centroid }));
    }
    found
}
