//! The columns of the crust (paper 000, Table 1), one entry per sample of the lattice.

use crate::ids::FrameId;
use bevy::prelude::*;

/// Type of the crust, x_C in the paper. It says what is continental; the sign of the elevation
/// does not: a shelf is continental crust under water.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Hash,
    Reflect,
    serde::Serialize,
    serde::Deserialize,
)]
#[repr(u8)]
pub enum CrustKind {
    /// Dense, thin, young crust; it subducts.
    #[default]
    Oceanic = 0,
    /// Light, thick crust; it resists subduction.
    Continental = 1,
}

impl CrustKind {
    /// The kind with this number, as files store it.
    pub fn from_u8(value: u8) -> Option<Self> {
        [Self::Oceanic, Self::Continental]
            .get(usize::from(value))
            .copied()
    }
}

/// Type of the last mountain building, o in the paper.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Hash,
    Reflect,
    serde::Serialize,
    serde::Deserialize,
)]
#[repr(u8)]
pub enum Orogeny {
    /// Never folded.
    #[default]
    None = 0,
    /// Folded above a subduction zone.
    Andean = 1,
    /// Folded by a continental collision.
    Himalayan = 2,
}

impl Orogeny {
    /// The type with this number, as files store it.
    pub fn from_u8(value: u8) -> Option<Self> {
        [Self::None, Self::Andean, Self::Himalayan]
            .get(usize::from(value))
            .copied()
    }
}

/// The state of the crust: a column per quantity, an entry per sample, 47 bytes a sample.
///
/// Samples never move. A sample's direction and its two vectors are given in the coordinates of
/// its [`Frame`](super::Frame); the frame's rotation takes them to where the crust is now.
#[derive(Component, Clone, Debug, Default, PartialEq)]
pub struct Crust {
    /// The frame that carries the sample.
    pub frame: Vec<FrameId>,
    /// Type of the crust x_C.
    pub kind: Vec<CrustKind>,
    /// Thickness e in km.
    pub thickness: Vec<f32>,
    /// Elevation z of the unbent crust above sea level in km; trenches are a derived offset.
    pub elevation: Vec<f32>,
    /// Age a_o of oceanic crust since it left its ridge in My.
    pub ocean_age: Vec<f32>,
    /// Unit vector r parallel to the ridge that made the crust; zero where unknown.
    pub ridge: Vec<Vec3>,
    /// Time a_c since the last folding in My.
    pub orogeny_age: Vec<f32>,
    /// Type o of the last folding.
    pub orogeny: Vec<Orogeny>,
    /// Fold direction f: a tangent vector, unit length once folded, zero before.
    pub fold: Vec<Vec3>,
}

impl Crust {
    /// `n` samples of old abyssal ocean floor on frame 0.
    pub fn ocean(n: usize, params: &crate::params::TectonicParams) -> Self {
        Self {
            frame: vec![0; n],
            kind: vec![CrustKind::Oceanic; n],
            thickness: vec![params.ocean_thickness as f32; n],
            elevation: vec![params.abyss_elevation as f32; n],
            ocean_age: vec![0.0; n],
            ridge: vec![Vec3::ZERO; n],
            orogeny_age: vec![0.0; n],
            orogeny: vec![Orogeny::None; n],
            fold: vec![Vec3::ZERO; n],
        }
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.frame.len()
    }

    /// Whether there are no samples.
    pub fn is_empty(&self) -> bool {
        self.frame.is_empty()
    }

    /// Whether sample `i` is continental.
    #[inline]
    pub fn is_continental(&self, i: usize) -> bool {
        self.kind[i] == CrustKind::Continental
    }
}
