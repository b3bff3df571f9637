//! From terrain, climate and drainage to the packed control mesh.
//!
//! | vertex | height | bed | water |
//! |---|---|---|---|
//! | terrain | ground, as drainage left it | = height | = height |
//! | river | level of the water | level less depth | level |
//! | lake | = bed | floor | level, the same all over the lake |
//! | coast | 0 | = height | = height |
//! | mouth: a river on the coast | 0 | less the depth | 0 |
//! | sea | sea floor | = height | 0 |
//!
//! Rivers are those vertices on land that have enough water and are of an order that leaves room
//! for tributaries ([`RiverRule`]). A river edge runs from a river to the next river, into a lake,
//! or to its mouth, and from there to the deepest neighbour in the sea, which is lowered where
//! needed: an estuary. There are none within lakes; the river that leaves one begins at the lake's
//! level. Along river edges water never rises, and beds fall strictly.

use super::topology::Topology;
use crate::climate::Climate;
use crate::hydrology::profile::FALL;
use crate::hydrology::{Drainage, NONE, Site, Terrain};
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::math::Vec3;
use pangaea_shaders::amplify::control::{
    ControlEdge, ControlMesh, ControlVertex, ValleyShape, VertexKind,
};

/// Discharge in m³/s at which the flow φ is 1: that of the Amazon.
const FULL_FLOW: f64 = 200_000.0;

/// Which vertices are rivers; discharges are as on an Earth-sized planet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RiverRule {
    /// Least discharge in m³/s.
    pub discharge: f64,
    /// Least Horton–Strahler order.
    pub order: u8,
}

impl Default for RiverRule {
    fn default() -> Self {
        Self {
            discharge: 60.0,
            order: 2,
        }
    }
}

/// What a control mesh is made of.
#[derive(Clone, Copy)]
pub struct ControlInput<'a> {
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
    /// What counts as a river.
    pub rule: RiverRule,
}

/// Packs the control mesh.
pub fn control_mesh(input: &ControlInput) -> ControlMesh {
    let rivers = Rivers::new(input);
    let mut edges = input.topology.edges.clone();
    for (i, &to) in rivers.next.iter().enumerate() {
        if to != NONE
            && let Some(e) = input.topology.edge(input.mesh, i as u32, to)
        {
            let edge: &mut ControlEdge = &mut edges[e as usize];
            edge.river = 1;
            if edge.vertices[0] != i as u32 {
                edge.vertices.swap(0, 1);
                edge.faces.swap(0, 1);
            }
        }
    }
    ControlMesh {
        radius_m: (input.drainage.radius * 1000.0).round() as u32,
        vertices: parallel::map(input.mesh.len(), |i| vertex(input, &rivers, i as usize)),
        edges,
        faces: input.topology.faces.clone(),
    }
}

/// The network of river edges.
struct Rivers {
    /// Whether each vertex is on a river, mouths included.
    is_river: Vec<bool>,
    /// Where the river edge of each vertex leads; [`NONE`] for none.
    next: Vec<u32>,
    /// The lowest bed of the rivers that end at each vertex of the sea; `i32::MAX` for none.
    mouth_bed: Vec<i32>,
    /// Discharge of those rivers in m³/s.
    mouth_flow: Vec<f64>,
}

impl Rivers {
    fn new(input: &ControlInput) -> Self {
        let ControlInput {
            mesh,
            drainage,
            rule,
            ..
        } = *input;
        let n = mesh.len();
        let mut is_river = parallel::map(mesh.len(), |i| {
            let k = i as usize;
            drainage.sites[k] == Site::Land
                && !drainage.is_lake(k)
                && drainage.strahler[k] >= rule.order
                && drainage.earth_like_discharge(k) >= rule.discharge
        });
        let mut next = vec![NONE; n];
        let mut mouths = Vec::new();
        for i in 0..n {
            let to = drainage.routes.receiver[i];
            if !is_river[i] || to == NONE {
                continue;
            }
            next[i] = to;
            if drainage.sites[to as usize] == Site::Coast {
                mouths.push(to);
            }
        }
        let mut rivers = Self {
            is_river: Vec::new(),
            next,
            mouth_bed: vec![i32::MAX; n],
            mouth_flow: vec![0.0; n],
        };
        for i in mouths {
            is_river[i as usize] = true;
            rivers.reach_sea(input, i);
        }
        rivers.is_river = is_river;
        rivers
    }

    /// Leads the mouth `i` on to its deepest neighbour in the sea, if it has one.
    fn reach_sea(&mut self, input: &ControlInput, i: u32) {
        let drainage = input.drainage;
        let seaward = input
            .mesh
            .ring(i)
            .iter()
            .copied()
            .filter(|&j| drainage.sites[j as usize] == Site::Sea);
        if let Some(sea) = seaward.min_by_key(|&j| (drainage.ground[j as usize], j)) {
            self.next[i as usize] = sea;
            let s = sea as usize;
            self.mouth_bed[s] = self.mouth_bed[s].min(drainage.profile.bed[i as usize]);
            self.mouth_flow[s] = self.mouth_flow[s].max(drainage.earth_like_discharge(i as usize));
        }
    }
}

fn vertex(input: &ControlInput, rivers: &Rivers, i: usize) -> ControlVertex {
    let ControlInput {
        topology,
        terrain,
        climate,
        drainage,
        ..
    } = *input;
    let profile = &drainage.profile;
    let mut flow = if rivers.is_river[i] {
        drainage.earth_like_discharge(i)
    } else {
        0.0
    };
    let (kind, height, bed, water) = match drainage.sites[i] {
        Site::Sea => {
            flow = rivers.mouth_flow[i];
            let floor = drainage.ground[i].min(rivers.mouth_bed[i].saturating_sub(FALL));
            (VertexKind::Sea, floor, floor, 0)
        }
        Site::Coast if rivers.is_river[i] => (VertexKind::River, 0, profile.bed[i], 0),
        Site::Coast => (VertexKind::Coast, 0, 0, 0),
        Site::Land if drainage.is_lake(i) => {
            flow = drainage.earth_like_discharge(i);
            (
                VertexKind::Lake,
                profile.bed[i],
                profile.bed[i],
                profile.level[i],
            )
        }
        Site::Land if rivers.is_river[i] => (
            VertexKind::River,
            profile.level[i],
            profile.bed[i],
            profile.level[i],
        ),
        Site::Land => (
            VertexKind::Terrain,
            profile.level[i],
            profile.level[i],
            profile.level[i],
        ),
    };
    let crust = if kind == VertexKind::Sea {
        height
    } else {
        terrain.crust[i].max(height)
    };
    ControlVertex {
        direction: topology.directions[i],
        seed: topology.seeds[i],
        height,
        bed,
        water,
        flow: ((flow / FULL_FLOW).sqrt().min(1.0) * 65_536.0).round() as u32,
        crust,
        kind: kind as u8,
        valley: valley_shape(terrain, climate, i) as u8,
        age: age(terrain.age[i]),
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

/// What shapes the valleys of vertex `i`. Where it freezes and snows enough there is ice, whatever
/// the crust; then come canyons of plateaus, gorges of mountains younger than 60 My, and the wide
/// floors of all other land.
fn valley_shape(terrain: &Terrain, climate: &Climate, i: usize) -> ValleyShape {
    if climate.temperature[i] < 0.0 && climate.rain[i] > 300.0 {
        ValleyShape::IceTrough
    } else if terrain.plateau[i] > 0.5 {
        ValleyShape::Terraced
    } else if terrain.age[i] < 60.0 {
        ValleyShape::V
    } else {
        ValleyShape::FlatFloor
    }
}

/// A share in 65536ths, at most 65535 of them.
fn q16(share: f32) -> u16 {
    ((share.clamp(0.0, 1.0) * 65_536.0).round() as u32).min(65_535) as u16
}

/// An age in 64ths of a My; `u16::MAX` is kept for "never".
fn age(my: f32) -> u16 {
    if my.is_finite() {
        (my.max(0.0) * 64.0).round().min(65_534.0) as u16
    } else {
        u16::MAX
    }
}

fn unit(v: Vec3) -> [i16; 3] {
    v.to_array()
        .map(|x| (x.clamp(-1.0, 1.0) * 32_767.0).round() as i16)
}

/// Discharge in m³/s that a flow φ in Q16 stands for, on an Earth-sized planet.
pub fn discharge_of_flow(flow: u32) -> f64 {
    let phi = f64::from(flow) / 65_536.0;
    phi * phi * FULL_FLOW
}

#[cfg(test)]
#[path = "pack_tests.rs"]
mod tests;
