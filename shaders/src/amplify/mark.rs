//! Passes: a face decides whether it is split for a view, then whether it lies beside a split one.
//!
//! A face of level L is split where its centre is nearer than c·ℓ_L to the camera or the disc, ℓ_L
//! the theoretical edge; what a camera does not see counts as farther ([`sight`](super::sight)).
//! The bound halves with the level while neighbours are about ℓ_L apart, so where c is large enough
//! every face within three rings of a split one exists at its level: neighbours differ by one level
//! at most, and no pass has to spread splits. A split face's neighbours are its halo: see
//! [`SplitMark::Halo`].

use super::arith::ratio;
use super::fixed::{Q16, mul_shift};
use super::scale::PlanetScale;
use super::sight::{Sight, horizon};
use super::topology::{FaceSplit, LevelMesh, SplitMark};
use super::vertex::Vertex;
use super::vertices::VertexView;
pub use super::view::{SHARPNESS, View};

impl View {
    /// A camera that looks all round, `altitude` in metres above sea level, as far as the highest
    /// mountains show over the horizon; edges of 8 pixels at 1080p.
    pub fn camera(scale: &PlanetScale, direction: [i32; 3], altitude: u32, level: u32) -> Self {
        let altitude = altitude.min(1 << 26) as i32 * 16;
        Self {
            direction,
            altitude: Some(altitude),
            radius: 0,
            sharpness: 117 << 8,
            horizon: horizon(scale, altitude),
            ..Self::whole(level)
        }
    }

    /// Distance from the camera or the disc to a face's centre, sixteenths of a metre.
    #[inline]
    pub fn distance(&self, scale: &PlanetScale, corners: [&Vertex; 3]) -> i32 {
        Sight::new(scale, self).distance(corners)
    }

    /// Level that the view shows at a vertex, Q16: that of the leaves at its distance, evenly from
    /// one to the next.
    pub fn shown_level(&self, scale: &PlanetScale, vertex: &Vertex) -> i32 {
        let finest = self.level as i32 * Q16;
        let distance = self.distance(scale, [vertex; 3]).max(1) as u32;
        let sharpness = self.clamped_sharpness();
        // Half a level finer than the split: leaves of two levels meet there.
        let farthest = mul_shift(scale.edge, sharpness + sharpness / 2, 8) as u32;
        if distance >= farthest {
            return 0;
        }
        // Levels go by the logarithm of the distance, linear between powers of two.
        let halvings = (farthest / distance).ilog2();
        let nearest = (farthest >> halvings) as i32;
        let share = ratio(2 * (nearest - distance as i32), nearest);
        (halvings as i32 * Q16 + share).min(finest)
    }

    /// Whether a face of a level is split.
    #[inline]
    pub fn splits(&self, scale: &PlanetScale, level: u32, corners: [&Vertex; 3]) -> bool {
        Sight::new(scale, self).splits(level, corners)
    }
}

/// Marks the faces of a level that are split; all others become leaves.
pub fn mark_split(
    sight: &Sight,
    level: u32,
    mesh: &LevelMesh,
    vertices: VertexView,
    items: &[u32],
    faces: &mut [FaceSplit],
) {
    for &f in items {
        let corners = vertices.gather(mesh.faces[f as usize].vertices);
        faces[f as usize].mark = if sight.splits(level, corners) {
            SplitMark::Split
        } else {
            SplitMark::Leaf
        };
    }
}

/// Marks the faces beside a split one as halo. It reads which faces are split and writes the others,
/// so no item sees what another writes.
pub fn mark_halo(mesh: &LevelMesh, items: &[u32], faces: &mut [FaceSplit]) {
    for &f in items {
        if faces[f as usize].mark != SplitMark::Split && is_beside_split(mesh, f, faces) {
            faces[f as usize].mark = SplitMark::Halo;
        }
    }
}

/// Whether one of a face's neighbours is split.
fn is_beside_split(mesh: &LevelMesh, face: u32, faces: &[FaceSplit]) -> bool {
    let neighbours = mesh.faces[face as usize]
        .edges
        .map(|e| faces.get(mesh.edges[e as usize].beyond(face) as usize));
    neighbours
        .into_iter()
        .flatten()
        .any(|face| face.mark == SplitMark::Split)
}
