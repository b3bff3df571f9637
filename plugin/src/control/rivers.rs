//! The network of river edges.
//!
//! Rivers are those vertices on land that have enough water and are of an order that leaves room
//! for tributaries ([`RiverRule`]). A river edge runs from a river to the next river, into a lake,
//! or to its mouth, and from there to the deepest neighbour in the sea, which is lowered where
//! needed: an estuary. There are none within lakes; the river that leaves one begins at the lake's
//! level.
//!
//! At a delta several edges leave the old mouth, to arms on the new coast, and each leads on into
//! the sea.

use crate::hydrology::{Delta, Drainage, MIN_FALL, NO_VERTEX, ShoreClass, deltas};
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::reflect::Reflect;
use std::collections::BTreeMap;

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

/// A vertex of a delta.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum DeltaVertex {
    /// Where the arms part: land, a little above the sea.
    Apex,
    /// On the new coast, without a river.
    Shore,
    /// Where an arm ends, with its bed in grains and its discharge in m³/s as on an Earth-sized
    /// planet.
    Arm { bed: i32, discharge: f64 },
}

/// Rivers and their mouths, per vertex.
pub(super) struct RiverEdges {
    /// Whether each vertex is on a river, mouths included.
    pub(super) is_river: Vec<bool>,
    /// Where the river edge of each vertex leads, or [`NO_VERTEX`].
    pub(super) next: Vec<u32>,
    /// The river edges that leave the apex of a delta beside its [`next`](Self::next).
    pub(super) branches: Vec<[u32; 2]>,
    /// Vertices of deltas.
    pub(super) delta: BTreeMap<u32, DeltaVertex>,
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
            branches: Vec::new(),
            delta: BTreeMap::new(),
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
        let deltas = deltas(mesh, drainage, &mouths);
        // All of them first: no river may end in what another's delta fills.
        for delta in &deltas {
            rivers.delta.insert(delta.apex, DeltaVertex::Apex);
            let shore = delta.shore.iter();
            rivers.delta.extend(shore.map(|&s| (s, DeltaVertex::Shore)));
        }
        for delta in &deltas {
            rivers.lay_arms(mesh, drainage, delta);
        }
        // Mouths become rivers last: a coast is no river by the rule, however much reaches it.
        for mouth in mouths {
            rivers.is_river[mouth as usize] = true;
            if !rivers.delta.contains_key(&mouth) {
                let discharge = drainage.earth_like_discharge(mouth as usize);
                let bed = drainage.profile.bed[mouth as usize];
                rivers.reach_sea(mesh, drainage, mouth, bed, discharge);
            }
        }
        rivers
    }

    /// Lays the arms of a delta, from its apex over the new coast into the sea.
    fn lay_arms(&mut self, mesh: &SphereMesh, drainage: &Drainage, delta: &Delta) {
        let apex = delta.apex as usize;
        // Beds fall on, though an arm is a smaller river than the one that it leaves.
        let bed = drainage.profile.bed[apex] - MIN_FALL;
        for (i, &(arm, share)) in delta.arms.iter().enumerate() {
            if i == 0 {
                self.next[apex] = arm;
            } else {
                self.branches.push([delta.apex, arm]);
            }
            let discharge = share * drainage.earth_like_discharge(apex);
            self.is_river[arm as usize] = true;
            self.delta.insert(arm, DeltaVertex::Arm { bed, discharge });
            self.reach_sea(mesh, drainage, arm, bed, discharge);
        }
    }

    /// Leads a mouth with its bed in grains and its discharge on to its deepest neighbour in the
    /// sea, if it has one.
    fn reach_sea(
        &mut self,
        mesh: &SphereMesh,
        drainage: &Drainage,
        mouth: u32,
        bed: i32,
        discharge: f64,
    ) {
        let ring = mesh.ring(mouth).iter().copied();
        let is_sea = |j: &u32| drainage.shore[*j as usize] == ShoreClass::Sea;
        let sea = ring.filter(|j| is_sea(j) && !self.delta.contains_key(j));
        let Some(deepest) = sea.min_by_key(|&j| (drainage.ground[j as usize], j)) else {
            return;
        };
        let s = deepest as usize;
        self.next[mouth as usize] = deepest;
        // Several rivers may end at one vertex: its floor lies under the deepest of them.
        self.mouth_bed[s] = self.mouth_bed[s].min(bed);
        self.mouth_discharge[s] = self.mouth_discharge[s].max(discharge);
    }
}
