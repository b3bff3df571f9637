//! Water at a direction.
//!
//! Lakes and the sea end where the ground of the leaf rises over them. A river ends half its width
//! from its course, whatever the leaf: corners of coarse leaves are farther apart than its banks,
//! and one of them in the river would flood all its leaf. So a river has the same share of the land
//! at all levels.

use super::{Leaf, LocalGround};
use crate::amplify::base::Base;
use crate::amplify::carve::{Carved, sheet};
use crate::amplify::control::VertexKind;
use crate::amplify::rules::valley::RiverPlace;
use crate::amplify::vertex::{FAR, RiverSegment, Vertex};
use crate::amplify::vertex_resolve::most_move;
use core::ops::Deref;

impl<B: Deref<Target = Base>> LocalGround<B> {
    /// The leaf of a level at a direction, and the level of the water over it in metres; `None`
    /// where it is dry. `hint` as in [`leaf`](Self::leaf).
    ///
    /// ```
    /// use pangaea_shaders::amplify::base::Base;
    /// use pangaea_shaders::amplify::control::VertexKind;
    /// use pangaea_shaders::amplify::local::LocalGround;
    /// use pangaea_shaders::amplify::rules::Rules;
    /// use pangaea_shaders::amplify::synthetic::control_mesh;
    ///
    /// let base = Base::new(&control_mesh(6_371_000, 5, 1))?;
    /// let mut vertices = base.vertices.iter();
    /// let river = vertices.find(|v| v.kind == VertexKind::River).expect("a river").direction;
    /// let mut ground = LocalGround::new(&base, &Rules::default());
    /// let (leaf, water) = ground.leaf_with_water(river, 17, None);
    /// assert!(water.is_some_and(|level| level > leaf.height_m(river)));
    /// # Ok::<(), pangaea_shaders::amplify::base::BadMesh>(())
    /// ```
    pub fn leaf_with_water(
        &mut self,
        direction: [i32; 3],
        level: u32,
        hint: Option<u32>,
    ) -> (Leaf, Option<f64>) {
        let leaf = self.leaf(direction, level, hint);
        let ground = leaf.height_m(direction) * 1024.0;
        let river = self.river(&leaf, direction, ground);
        let standing = standing(&leaf, direction).filter(|&level| level > ground);
        let level = match (river, standing) {
            (Some(river), Some(standing)) => Some(river.max(standing)),
            (river, standing) => river.or(standing),
        };
        (leaf, level.map(|grains| grains / 1024.0))
    }

    /// Level of the river over a direction in the leaf of the last answer, grains.
    fn river(&mut self, leaf: &Leaf, direction: [i32; 3], ground: f64) -> Option<f64> {
        let face = *self.path.last()?;
        let at = leaf.level as usize;
        let edges = self.lazy.face(at, face).edges;
        let along = edges.map(|edge| self.lazy.river_of(at, edge));
        // What the leaf's edges are is the newest; corners may know a river as it was.
        let newest = along.iter().flatten().map(|segment| (segment, 0));
        let known = leaf.vertices.iter().filter(|v| v.river_distance < FAR);
        let (scale, rules) = (self.base().scale, *self.lazy.rules());
        let older = known.map(|v| (&v.river, most_move(&scale, &rules, &v.river)));
        let RiverPlace {
            reach, distance, ..
        } = newest
            .chain(older)
            .filter_map(|(segment, moved)| self.in_bed(segment, moved, direction))
            .min_by_key(|place| place.distance - place.reach.half_bed)?;
        let bed = f64::from(reach.bed(distance));
        let water = f64::from(reach.water);
        // The ground of a coarse leaf knows no bed: there the river stands on it.
        Some(if water > ground {
            water
        } else {
            ground + water - bed
        })
    }

    /// The river of a segment over a direction in its bed, and how far that is from its middle,
    /// grains; `moved` is how far the river may have moved since.
    fn in_bed(
        &self,
        segment: &RiverSegment,
        moved: i32,
        direction: [i32; 3],
    ) -> Option<RiverPlace> {
        let (scale, rules) = (&self.base().scale, self.lazy.rules());
        let place = RiverPlace::nearest(scale, rules, segment, direction);
        let is_in = place.distance.saturating_add(moved) < place.reach.half_bed;
        is_in.then_some(place)
    }
}

/// Level of the lake or sea over a direction in a leaf, grains, wherever the ground is.
fn standing(leaf: &Leaf, direction: [i32; 3]) -> Option<f64> {
    let is_standing = |v: &Vertex| matches!(v.kind, VertexKind::Lake | VertexKind::Sea);
    let corners = [0, 1, 2].map(|k| {
        if is_standing(&leaf.vertices[k]) {
            leaf.carved[k]
        } else {
            Carved::dry(leaf.carved[k].ground)
        }
    });
    let surface = sheet(corners)?;
    let weights = leaf.weights(direction);
    Some((0..3).map(|k| weights[k] * f64::from(surface[k])).sum())
}
