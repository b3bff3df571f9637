//! From terrain, climate and drainage to the packed control mesh.
//!
//! | vertex | height | bed | water |
//! |---|---|---|---|
//! | terrain | ground, as drainage left it | = height | = height |
//! | river | level of the water | level less depth | level |
//! | lake | = bed | floor | level, the same all over the lake |
//! | coast | ground, on either side of 0 | = height | = height, at least 0 |
//! | mouth: a river on the coast | 0 | less the depth, or the ground if the sea covers it | 0 |
//! | sea | sea floor | = height | 0 |
//! | apex of a delta | ½ m | less the depth | = height |
//! | arm of a delta: a river on its coast | 0 | under that of the apex | 0 |
//!
//! Along river edges water never rises, and beds fall strictly.

use super::rivers::{DeltaVertex, RiverEdges, RiverRule};
use super::topology::Topology;
use crate::climate::Climate;
use crate::hydrology::{Drainage, MIN_FALL, NO_VERTEX, ShoreClass, Terrain, ground_of_coast, worn};
use crate::sphere::SphereMesh;
use crate::{math, parallel};
use bevy::math::Vec3;
use pangaea_shaders::amplify::control::{
    ControlEdge, ControlMesh, ControlVertex, ValleyShape, VertexKind,
};
use pangaea_shaders::amplify::fixed::Q16;

/// Discharge in m³/s at which the flow φ is 1: that of the Amazon (209,000 m³/s, rounded).
const FULL_FLOW_M3S: f64 = 200_000.0;

/// Least snow in mm per year that feeds a glacier: less melts or sublimates even in cold summers
/// (glaciers of the dry Arctic begin at 200 to 300 mm).
const GLACIER_SNOW_MM: f32 = 300.0;

/// Presence of plateaus from which on valleys are canyons.
const CANYON_PLATEAU: f32 = 0.5;

/// Age in My of orogeny up to which rivers still cut gorges.
const GORGE_AGE_MY: f32 = 60.0;

/// Units of an age in a My.
const AGE_UNITS_PER_MY: f32 = 64.0;

/// The input of a control mesh.
#[derive(Clone, Copy)]
pub(super) struct ControlInput<'a> {
    /// The base mesh.
    pub mesh: &'a SphereMesh,
    /// Its edges and faces.
    pub topology: &'a Topology,
    /// Its ground and landforms.
    pub terrain: &'a Terrain,
    /// Its climate.
    pub climate: &'a Climate,
    /// Its rivers and lakes.
    pub drainage: &'a Drainage,
    /// Which vertices count as rivers.
    pub rule: RiverRule,
}

/// Packs the control mesh.
pub(super) fn control_mesh(input: &ControlInput) -> ControlMesh {
    let rivers = RiverEdges::new(input.mesh, input.drainage, input.rule);
    let vertex = |i: u32| vertex(input, &rivers, i as usize);
    let (vertices, (edges, faces)) = rayon::join(
        || parallel::map(input.mesh.len(), vertex),
        || rayon::join(|| edges(input, &rivers), || input.topology.faces.clone()),
    );
    ControlMesh {
        radius_m: (input.drainage.radius * 1000.0).round() as u32,
        vertices,
        edges,
        faces,
    }
}

/// The edges of the base mesh, those of rivers turned downstream.
fn edges(input: &ControlInput, rivers: &RiverEdges) -> Vec<ControlEdge> {
    let mut edges = input.topology.edges.clone();
    let main = (0..).zip(rivers.next.iter().copied());
    let branches = rivers.branches.iter().map(|&[from, to]| (from, to));
    for (i, to) in main.chain(branches) {
        if to == NO_VERTEX {
            continue;
        }
        if let Some(e) = input.topology.edge(input.mesh, i, to) {
            let edge = &mut edges[e as usize];
            // Water runs from the first vertex of a river's edge to the second; its faces turn
            // with it.
            edge.river = 1;
            if edge.vertices[0] != i {
                edge.vertices.swap(0, 1);
                edge.faces.swap(0, 1);
            }
        }
    }
    edges
}

/// Ground and water of a vertex; see the table of the file.
struct Levels {
    kind: VertexKind,
    /// Grains.
    height: i32,
    /// Grains.
    bed: i32,
    /// Grains.
    water: i32,
    /// m³/s as on an Earth-sized planet; 0 at dry vertices.
    discharge: f64,
}

impl Levels {
    fn new(input: &ControlInput, rivers: &RiverEdges, i: usize) -> Self {
        let drainage = input.drainage;
        let bed = drainage.profile.bed[i];
        let level = drainage.profile.level[i];
        let discharge = drainage.earth_like_discharge(i);
        if let Some(delta) = rivers.delta.get(&(i as u32)) {
            return Self::of_delta(delta, bed, discharge);
        }
        match drainage.shore[i] {
            ShoreClass::Sea => Self::sea_floor(drainage, rivers, i),
            ShoreClass::Coast if rivers.is_river[i] => {
                let drowned = Self::drowned_bed(input, rivers, i);
                Self::river(0, bed.min(drowned), discharge)
            }
            ShoreClass::Coast => Self::coast(coast_ground(input, i)),
            ShoreClass::Land if drainage.is_lake(i) => Self {
                kind: VertexKind::Lake,
                height: bed,
                bed,
                water: level,
                discharge,
            },
            ShoreClass::Land if rivers.is_river[i] => Self::river(level, bed, discharge),
            ShoreClass::Land => Self::dry(VertexKind::Terrain, level),
        }
    }

    /// A vertex of a delta; the bed and the discharge are those of a mouth there.
    fn of_delta(delta: &DeltaVertex, bed: i32, discharge: f64) -> Self {
        match *delta {
            // Lower than any river that runs in.
            DeltaVertex::Apex => Self::river(MIN_FALL / 2, bed, discharge),
            DeltaVertex::Arm { bed, discharge } => Self::river(0, bed, discharge),
            DeltaVertex::Shore => Self::dry(VertexKind::Coast, 0),
        }
    }

    /// A river, whose ground stands as high as its water.
    fn river(water: i32, bed: i32, discharge: f64) -> Self {
        Self {
            kind: VertexKind::River,
            height: water,
            bed,
            water,
            discharge,
        }
    }

    fn dry(kind: VertexKind, height: i32) -> Self {
        Self {
            kind,
            height,
            bed: height,
            water: height,
            discharge: 0.0,
        }
    }

    /// Ground at the shore, which the sea covers where it lies below 0.
    fn coast(height: i32) -> Self {
        Self {
            water: height.max(0),
            ..Self::dry(VertexKind::Coast, height)
        }
    }

    /// The ground of a mouth as the bed of its river, which falls on into the sea: where it lies
    /// below 0 the valley is drowned as far inland as the bed does.
    fn drowned_bed(input: &ControlInput, rivers: &RiverEdges, i: usize) -> i32 {
        let next = rivers.next[i];
        if next == NO_VERTEX {
            return 0;
        }
        let floor = Self::sea_floor(input.drainage, rivers, next as usize).bed;
        coast_ground(input, i).max(floor + MIN_FALL)
    }

    /// The floor of the sea, under the beds of the rivers that end there.
    fn sea_floor(drainage: &Drainage, rivers: &RiverEdges, i: usize) -> Self {
        // Beds fall on into the sea; where no river ends this is far above any floor.
        let estuary = rivers.mouth_bed[i].saturating_sub(MIN_FALL);
        let floor = drainage.ground[i].min(estuary);
        Self {
            kind: VertexKind::Sea,
            height: floor,
            bed: floor,
            water: 0,
            discharge: rivers.mouth_discharge[i],
        }
    }
}

fn coast_ground(input: &ControlInput, i: usize) -> i32 {
    ground_of_coast(input.mesh, &input.drainage.shore, &input.terrain.ground, i)
}

fn vertex(input: &ControlInput, rivers: &RiverEdges, i: usize) -> ControlVertex {
    let ControlInput {
        topology,
        terrain,
        climate,
        ..
    } = *input;
    let levels = Levels::new(input, rivers, i);
    // Summits stand over the ground; under the sea there are none.
    let crust = if levels.kind == VertexKind::Sea {
        levels.height
    } else {
        terrain.crust[i].max(levels.height)
    };
    ControlVertex {
        direction: topology.directions[i],
        seed: topology.seeds[i],
        height: levels.height,
        bed: levels.bed,
        water: levels.water,
        flow: flow(levels.discharge),
        crust,
        kind: levels.kind as u8,
        valley: valley_shape(terrain, climate, i) as u8,
        worn: q16(worn(terrain.age[i])),
        collision: q16(terrain.collision[i]),
        wetness: q16(climate.wetness[i]),
        plateau: q16(terrain.plateau[i]),
        hills: q16(terrain.hills[i]),
        oceanic: q16(terrain.oceanic[i]),
        ocean_age: age(terrain.ocean_age[i]),
        fold: unit(terrain.fold[i]),
        ridge: unit(terrain.ridge[i]),
    }
}

/// The shape of the valleys of vertex `i`. Where it freezes and snows enough there is ice, whatever
/// the crust; then come canyons of plateaus, gorges of young mountains, and the wide floors of all
/// other land.
fn valley_shape(terrain: &Terrain, climate: &Climate, i: usize) -> ValleyShape {
    if climate.temperature[i] < 0.0 && climate.rain[i] > GLACIER_SNOW_MM {
        ValleyShape::IceTrough
    } else if terrain.plateau[i] > CANYON_PLATEAU {
        ValleyShape::Terraced
    } else if terrain.age[i] < GORGE_AGE_MY {
        ValleyShape::V
    } else {
        ValleyShape::FlatFloor
    }
}

/// Flow φ in Q16 of a discharge in m³/s, at most 1: widths and depths go by roots of the discharge.
fn flow(discharge: f64) -> u32 {
    let phi = (discharge / FULL_FLOW_M3S).sqrt().min(1.0);
    math::nearest(phi * f64::from(Q16)) as u32
}

/// A share in 65536ths, at most 65535 of them.
fn q16(share: f32) -> u16 {
    let units = nearest(share.clamp(0.0, 1.0) * Q16 as f32);
    units.min(i64::from(u16::MAX)) as u16
}

/// An age in 64ths of a My; the oldest that 16 bits tell, 1024 My, stands for all that is older.
fn age(my: f32) -> u16 {
    let units = (my.max(0.0) * AGE_UNITS_PER_MY).min(f32::from(u16::MAX));
    nearest(units) as u16
}

/// A unit vector in 32767ths.
fn unit(v: Vec3) -> [i16; 3] {
    let one = f32::from(i16::MAX);
    v.to_array()
        .map(|x| nearest(x.clamp(-1.0, 1.0) * one) as i16)
}

/// The whole number nearest to a small one.
fn nearest(x: f32) -> i64 {
    math::nearest(f64::from(x))
}

#[cfg(test)]
#[path = "pack_tests.rs"]
mod tests;
