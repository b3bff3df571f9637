//! The state that the parts of a resample read.

use crate::crust::{Crust, Frames};
use crate::plate::PlateTable;
use crate::plate::overlap::OverlapIndex;
use crate::plate::polarity::PolarityMemory;
use crate::sphere::SphereMesh;
use crate::view::PlanetView;

/// The state that a projection reads.
#[derive(Clone, Copy)]
pub(crate) struct ProjectInput<'a> {
    /// Samples and triangles.
    pub mesh: &'a SphereMesh,
    /// The crust in its frames.
    pub crust: &'a Crust,
    /// Frames.
    pub frames: &'a Frames,
    /// Which frames cover a point; must fit the frames' rotations.
    pub overlap: &'a OverlapIndex,
    /// Who goes under whom.
    pub polarity: &'a PolarityMemory,
}

/// The state that the filling of gaps reads.
pub(super) struct GapInput<'a> {
    /// Samples, parameters, size.
    pub planet: PlanetView<'a>,
    /// The plates.
    pub plates: &'a PlateTable,
    /// Time since the last resample in My.
    pub elapsed: f64,
}
