//! Kinds of edges, the discharge that arrives along them, and where no river or gully ever comes.

use super::{EdgeOrigin, LazyEdge, LazyGround};
use crate::amplify::base::Base;
use crate::amplify::face_split::{HalfKind, arriving_at, half_kind, tributary};
use crate::amplify::rules::{EdgeKind, STRAIGHT_LEVEL};
use core::ops::Deref;

impl<B: Deref<Target = Base>> LazyGround<B> {
    /// Settles what an edge is, and with it its direction.
    pub(super) fn settle_kind(&mut self, level: usize, edge: u32) -> EdgeKind {
        let known = *self.edge(level, edge);
        if known.has_kind {
            return known.edge.kind;
        }
        let (along, birth) = match known.origin {
            EdgeOrigin::Base(_) => return known.edge.kind,
            EdgeOrigin::Half(parent, slot) => {
                let along = self.half_kind(level - 1, parent, slot);
                (along, self.edge(level - 1, parent).edge.birth)
            }
            EdgeOrigin::Inner(face, corner) => {
                let inner = self.decide(level - 1, face)[usize::from(corner)];
                let (kind, is_reversed) = inner.edge();
                let along = HalfKind {
                    kind,
                    is_reversed,
                    is_descent: false,
                };
                (along, level as u8)
            }
        };
        let kind = along.kind;
        // Gullies run down from a new vertex, so a half may run against its edge.
        let known = self.edge_mut(level, edge);
        known.has_kind = true;
        known.reversed = along.is_reversed;
        known.edge.kind = kind;
        known.edge.is_descent = along.is_descent;
        // A half above a spring inherits its birth from a river, but is ground.
        known.edge.birth = if kind == EdgeKind::River { birth } else { 0 };
        if along.is_reversed {
            known.edge.reverse();
        }
        kind
    }

    /// Kind and direction of a half of an edge.
    fn half_kind(&mut self, level: usize, edge: u32, slot: u8) -> HalfKind {
        let LazyEdge {
            edge: parent, mid, ..
        } = *self.edge(level, edge);
        let [up, down] = parent.vertices;
        let along = [up, mid, down];
        // Only here does the kind of a half depend on vertices.
        if parent.kind == EdgeKind::River || (level as u32) < self.rules.gully_levels {
            for v in along {
                self.ensure(v);
            }
        }
        half_kind(
            &self.rules,
            level as u32,
            &parent,
            usize::from(slot),
            along.map(|v| self.vertex(v)),
        )
    }

    /// Settles the discharge that arrives along a river edge.
    pub(super) fn settle_arriving(&mut self, level: usize, edge: u32) {
        let known = *self.edge(level, edge);
        if known.has_arriving {
            return;
        }
        let arriving = match known.origin {
            EdgeOrigin::Base(_) => known.edge.arriving,
            EdgeOrigin::Half(parent, 0) => self.arriving_at_middle(level - 1, parent),
            // The second half ends where the whole edge ends.
            EdgeOrigin::Half(parent, _) => {
                self.settle_arriving(level - 1, parent);
                self.edge(level - 1, parent).edge.arriving
            }
            EdgeOrigin::Inner(..) => {
                // A tributary: its second vertex is the junction, on an edge of the face.
                self.tributary_at(known.edge.vertices[1])
            }
        };
        let known = self.edge_mut(level, edge);
        known.edge.arriving = arriving;
        known.has_arriving = true;
    }

    /// Discharge that arrives at the middle of a river edge, where a tributary may join.
    fn arriving_at_middle(&mut self, level: usize, edge: u32) -> u32 {
        let LazyEdge { edge, mid, .. } = *self.edge(level, edge);
        self.ensure(mid);
        arriving_at(self.vertex(mid), self.vertex(edge.vertices[0]))
    }

    /// Discharge that a tributary brings to a junction.
    fn tributary_at(&mut self, junction: u32) -> u32 {
        let (level, river) = self.origins[junction as usize];
        // A vertex that is split has its discharge; the faces do not change it.
        self.split(usize::from(level), river);
        let LazyEdge { edge, mid, .. } = *self.edge(usize::from(level), river);
        tributary(self.vertex(mid), self.vertex(edge.vertices[0]))
    }

    /// Whether no river or gully runs beside an edge of a straight level, nor ever will.
    pub(super) fn is_dry_edge(&mut self, level: usize, edge: u32) -> bool {
        let known = *self.edge(level, edge);
        if let Some(dry) = known.dry {
            return dry;
        }
        let dry = match known.origin {
            EdgeOrigin::Half(parent, _) if level as u32 > STRAIGHT_LEVEL => {
                // Straight levels add no drainage: a child is as dry as its parent.
                self.is_dry_edge(level - 1, parent)
            }
            EdgeOrigin::Inner(face, _) if level as u32 > STRAIGHT_LEVEL => {
                self.is_dry_face(level - 1, face)
            }
            _ => {
                // At the first of them both faces are asked.
                let [f, g] = self.faces(level, edge);
                self.is_dry_face(level, f) && self.is_dry_face(level, g)
            }
        };
        self.edge_mut(level, edge).dry = Some(dry);
        dry
    }

    /// Whether none of a face's edges is a river or gully; in the straight levels that holds for
    /// its children too.
    fn is_dry_face(&mut self, level: usize, face: u32) -> bool {
        let known = self.levels[level].faces[face as usize];
        if let Some(dry) = known.dry {
            return dry;
        }
        let dry = if level as u32 == STRAIGHT_LEVEL {
            known
                .face
                .edges
                .into_iter()
                .all(|e| self.settle_kind(level, e) == EdgeKind::Terrain)
        } else {
            self.is_dry_face(level - 1, known.parent)
        };
        self.levels[level].faces[face as usize].dry = Some(dry);
        dry
    }
}
