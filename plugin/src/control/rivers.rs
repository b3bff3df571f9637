//! The network of river edges.
//!
//! Rivers are those vertices on land that have enough water and are of an order that leaves room
//! for tributaries ([`RiverRule`]). A river edge runs from a river to the next river, into a lake,
//! or to its mouth, and from there to the deepest neighbour in the sea, which is lowered where
//! needed: an estuary. There are none within lakes; the river that leaves one begins at the lake's
//! level.

use crate::hydrology::{Drainage, NO_VERTEX, ShoreClass};
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::reflect::Reflect;

/// Which vertices are rivers; discharges are as on an Earth-sized planet.
#[derive(Clone, Copy, Debug, PartialEq, Reflect, serde::Serialize, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
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

impl RiverRule {
    /// Whether vertex `i` is a river.
    fn holds(&self, drainage: &Drainage, i: usize) -> bool {
        drainage.shore[i] == ShoreClass::Land
            && !drainage.is_lake(i)
            && drainage.strahler[i] >= self.order
            && drainage.earth_like_discharge(i) >= self.discharge
    }
}

/// Rivers and their mouths, per vertex.
pub(super) struct RiverEdges {
    /// Whether each vertex is on a river, mouths included.
    pub(super) is_river: Vec<bool>,
    /// Where the river edge of each vertex leads, or [`NO_VERTEX`].
    pub(super) next: Vec<u32>,
    /// The lowest bed of the rivers that end at each vertex of the sea; `i32::MAX` if none does.
    pub(super) mouth_bed: Vec<i32>,
    /// Greatest discharge of those rivers in m³/s, as on an Earth-sized planet.
    pub(super) mouth_discharge: Vec<f64>,
}

impl RiverEdges {
    /// The rivers of a drainage.
    pub(super) fn new(mesh: &SphereMesh, drainage: &Drainage, rule: RiverRule) -> Self {
        let n = mesh.len();
        let mut rivers = Self {
            is_river: parallel::map(n, |i| rule.holds(drainage, i as usize)),
            next: vec![NO_VERTEX; n],
            mouth_bed: vec![i32::MAX; n],
            mouth_discharge: vec![0.0; n],
        };
        let mut mouths = Vec::new();
        for i in (0..n).filter(|&i| rivers.is_river[i]) {
            let to = drainage.routes.receiver[i];
            rivers.next[i] = to;
            if to != NO_VERTEX && drainage.shore[to as usize] == ShoreClass::Coast {
                mouths.push(to);
            }
        }
        // Mouths become rivers last: a coast is no river by the rule, however much reaches it.
        for mouth in mouths {
            rivers.is_river[mouth as usize] = true;
            rivers.reach_sea(mesh, drainage, mouth);
        }
        rivers
    }

    /// Leads a mouth on to its deepest neighbour in the sea, if it has one.
    fn reach_sea(&mut self, mesh: &SphereMesh, drainage: &Drainage, mouth: u32) {
        let ring = mesh.ring(mouth).iter().copied();
        let sea = ring.filter(|&j| drainage.shore[j as usize] == ShoreClass::Sea);
        let Some(deepest) = sea.min_by_key(|&j| (drainage.ground[j as usize], j)) else {
            return;
        };
        let m = mouth as usize;
        let s = deepest as usize;
        self.next[m] = deepest;
        // Several rivers may end at one vertex: its floor lies under the deepest of them.
        self.mouth_bed[s] = self.mouth_bed[s].min(drainage.profile.bed[m]);
        self.mouth_discharge[s] = self.mouth_discharge[s].max(drainage.earth_like_discharge(m));
    }
}
