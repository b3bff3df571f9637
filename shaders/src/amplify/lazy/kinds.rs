//! What edges are, what arrives along them, and where no river or gully ever comes.

use super::LazyGround;
use crate::amplify::base::Base;
use crate::amplify::edge_split::STRAIGHT_LEVEL;
use crate::amplify::face_split::{arriving_at, half_kind};
use crate::amplify::rules::EdgeKind;
use crate::amplify::vertex_resolve::tributary;
use core::ops::Deref;

impl<B: Deref<Target = Base>> LazyGround<B> {
    /// Settles what an edge is, and with it its direction.
    pub(super) fn settle_kind(&mut self, level: usize, edge: u32) -> EdgeKind {
        let known = *self.edge(level, edge);
        if known.has_kind {
            return known.edge.kind;
        }
        let (kind, birth, reversed);
        if known.slot < 2 {
            let parent = self.edge(level - 1, known.parent).edge;
            let [up, down] = parent.vertices;
            let above = level as u32 - 1;
            // Only here does the kind of a half depend on vertices.
            if parent.kind == EdgeKind::River
                || (parent.kind == EdgeKind::Terrain && above < self.rules.gully_levels)
            {
                for v in [up, parent.mid, down] {
                    self.ensure(v);
                }
            }
            let along = [up, parent.mid, down].map(|v| self.vertex(v));
            (kind, reversed) = half_kind(
                &self.rules,
                above,
                parent.kind,
                usize::from(known.slot),
                along,
            );
            birth = parent.birth;
        } else {
            (kind, reversed) = self.decide(level - 1, known.parent)[known.slot as usize - 2].edge();
            birth = level as u8;
        }
        let birth = if kind == EdgeKind::River { birth } else { 0 };
        let known = self.edge_mut(level, edge);
        (
            known.edge.kind,
            known.edge.birth,
            known.has_kind,
            known.reversed,
        ) = (kind, birth, true, reversed);
        if reversed {
            known.edge.vertices.swap(0, 1);
            known.edge.faces.swap(0, 1);
        }
        kind
    }

    /// Settles the discharge that arrives along a river edge.
    pub(super) fn settle_arriving(&mut self, level: usize, edge: u32) {
        let known = *self.edge(level, edge);
        if known.has_arriving {
            return;
        }
        let arriving = match known.slot {
            0 => {
                let parent = self.edge(level - 1, known.parent).edge;
                self.ensure(parent.mid);
                arriving_at(self.vertex(parent.mid), self.vertex(parent.vertices[0]))
            }
            1 => {
                self.settle_arriving(level - 1, known.parent);
                self.edge(level - 1, known.parent).edge.arriving
            }
            _ => {
                // A tributary: its second vertex is the junction, on an edge of the face.
                let (at, river) = self.origins[known.edge.vertices[1] as usize];
                self.split(usize::from(at), river);
                let river = self.edge(usize::from(at), river).edge;
                tributary(self.vertex(river.mid), self.vertex(river.vertices[0]))
            }
        };
        let known = self.edge_mut(level, edge);
        (known.edge.arriving, known.has_arriving) = (arriving, true);
    }

    /// Whether no river or gully runs beside an edge of a straight level, nor ever will.
    pub(super) fn is_dry_edge(&mut self, level: usize, edge: u32) -> bool {
        let known = *self.edge(level, edge);
        if let Some(dry) = known.dry {
            return dry;
        }
        let dry = if level as u32 == STRAIGHT_LEVEL {
            let [f, g] = self.faces(level, edge);
            self.is_dry_face(level, f) && self.is_dry_face(level, g)
        } else if known.slot < 2 {
            self.is_dry_edge(level - 1, known.parent)
        } else {
            self.is_dry_face(level - 1, known.parent)
        };
        self.edge_mut(level, edge).dry = Some(dry);
        dry
    }

    /// Whether none of a face's edges is a river or gully; in the straight levels that holds for
    /// its children too.
    fn is_dry_face(&mut self, level: usize, face: u32) -> bool {
        let known = self.layers[level].faces[face as usize];
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
            self.is_dry_face(level - 1, known.face.parent)
        };
        self.layers[level].faces[face as usize].dry = Some(dry);
        dry
    }
}
