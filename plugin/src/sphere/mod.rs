//! The sample lattice of a planet: points on the unit sphere and everything that is fixed about
//! them.
//!
//! ```text
//! chord           chords and their angles
//! cube            the sphere as six squares: coarse bins, cells of a grid, order along a curve
//! sampling        Fibonacci points, ordered along a space-filling curve
//! poisson         Poisson-disk points, for the base mesh of the ground
//! triangulation   spherical Delaunay triangulation (planar Delaunay of a stereographic projection)
//! rows            lists of different lengths in one array
//! rings           neighbours of every sample, in order around it
//! area            spherical Voronoi cells
//! nearest         nearest sample of a direction: a cube-map grid, then a walk over neighbours
//! mesh            the SphereMesh that holds them all
//! relaxation      points moved to the centres of their cells, for the base mesh
//! locate          containing triangle and barycentric weights of a direction
//! components      connected components of samples
//! gradient        gradient and Laplacian of a column
//! nearest_source  distance to the nearest of many sources, along the mesh
//! ```
//!
//! A [`SphereMesh`] never changes: crust moves in rotating frames, samples stay where they are
//! (paper 000 §3 samples the sphere in the same way, and triangulates once).
//!
//! Policies:
//! - The nearest of several samples at the same distance is the one with the lowest index.
//!   So the answer depends on the point alone, not on where the search began.
//! - A direction exactly on a sample has weight 1 on that sample and 0 on the others.
//! - A direction on an edge belongs to either triangle of that edge; the weights are the same.

mod area;
mod chord;
pub mod components;
pub(crate) mod cube;
pub mod gradient;
mod locate;
mod mesh;
mod nearest;
pub mod nearest_source;
mod poisson;
mod relaxation;
mod rings;
pub(crate) mod rows;
mod sampling;
mod triangulation;

pub(crate) use chord::{angle_of_chord, angle_of_long_chord};
pub use locate::Location;
pub use mesh::SphereMesh;
pub use poisson::poisson_disk;
pub use relaxation::{relaxed, relaxed_points};

/// Why a [`SphereMesh`] could not be built.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bevy::reflect::Reflect, thiserror::Error)]
pub enum SphereError {
    /// The number of Fibonacci samples is out of range.
    #[error("{0} samples asked for; a planet has {min} to {max}",
        min = SphereMesh::MIN_SAMPLES, max = SphereMesh::MAX_SAMPLES)]
    SampleCount(u32),
    /// Too few or too many points were given.
    #[error("{0} points given; a mesh needs 4 to {max}", max = SphereMesh::MAX_SAMPLES)]
    PointCount(usize),
    /// The point with this index has no direction: it is zero, infinite or NaN.
    #[error("point {0} is zero or not finite")]
    NotADirection(usize),
    /// Two points are equal, or too close to be told apart.
    #[error("two points are equal or too close to be told apart")]
    Duplicate,
    /// The points do not surround the centre: some hemisphere is empty.
    #[error("the points leave a whole hemisphere empty")]
    EmptyHemisphere,
}
