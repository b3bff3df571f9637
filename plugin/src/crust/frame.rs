//! Frames: rigid rotations shared by sets of samples. Frames turn, samples never move.
//!
//! A plate owns one frame after each resample; a terrane that changes plate brings its own along.

use crate::ids::{FrameId, PlateId};
use bevy::math::{DQuat, DVec3};
use bevy::prelude::*;

/// A rigid rotation shared by a set of samples and owned by a plate.
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
pub struct Frame {
    /// The plate that carries the frame.
    pub plate: PlateId,
    /// Rotation from the lattice's coordinates to where the crust is now; identity after a
    /// resample.
    pub rotation: DQuat,
    /// Whether the frame is a terrane that came from another plate since the last resample.
    pub terrane: bool,
}

impl Frame {
    /// The frame of a plate that has not moved since the last resample.
    pub fn at_rest(plate: PlateId) -> Self {
        Self {
            plate,
            rotation: DQuat::IDENTITY,
            terrane: false,
        }
    }

    /// Whether the frame stands where its samples are.
    pub fn is_at_rest(&self) -> bool {
        // To the last bit: rotations that come near it by chance are blended as all others.
        self.rotation == DQuat::IDENTITY
    }

    /// From lattice coordinates to where the crust is now.
    #[inline]
    pub fn to_world(&self, p: DVec3) -> DVec3 {
        self.rotation * p
    }

    /// From where the crust is now to lattice coordinates.
    #[inline]
    pub fn to_lattice(&self, p: DVec3) -> DVec3 {
        // The inverse of a unit quaternion.
        self.rotation.conjugate() * p
    }
}

/// All frames of a planet, in the order in which they were made.
///
/// ```
/// use bevy_pangaea::prelude::*;
///
/// let recipe = PlanetRecipe { samples: 500, ..Default::default() };
/// let state = PlanetState::new(&recipe)?;
/// // Where the crust of sample 7 is now, and which plate carries it.
/// let frame = state.crust.frame[7];
/// let place = state.frames[usize::from(frame)].to_world(state.lattice.point(7));
/// assert_eq!(place, state.lattice.point(7), "nothing has moved yet");
/// assert!(state.plates.iter().any(|plate| plate.0 == state.frames.plate(frame)));
/// # Ok::<(), PlanetError>(())
/// ```
#[derive(Component, Clone, Debug, Default, PartialEq, Deref, DerefMut, Reflect)]
#[reflect(Component, Default)]
pub struct Frames(pub Vec<Frame>);

impl Frames {
    /// The plate that carries each frame.
    pub fn plate(&self, frame: FrameId) -> PlateId {
        self.0[usize::from(frame)].plate
    }
}
