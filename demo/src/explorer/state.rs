//! The types that the parts of the explorer share: wishes of the user, the planet on show, what is
//! selected, what is under the pointer.
//!
//! Panels and keys only say what is wanted, as an [`Action`]; other systems do it. So a key, a
//! button and a test take the same way.

use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::overlay::Overlay;
use bevy_pangaea::prelude::*;
use std::path::PathBuf;

/// Slowest and fastest wanted speed in My per second.
pub const SPEED_LIMITS: (f64, f64) = (0.5, 200.0);
/// Least and most exaggeration of the relief.
pub const EXAGGERATION_LIMITS: (f32, f32) = (1.0, 100.0);

/// Something that the user asks for.
#[derive(Message, Clone, Debug)]
pub enum Action {
    /// Time runs or stands still.
    TogglePlay,
    /// One step, then time stands still.
    SingleStep,
    /// Wanted speed in My per second.
    SetSpeed(f64),
    /// Grow a new planet; the present one stays until that has succeeded.
    Grow(Box<PlanetRecipe>),
    /// Read a preset; it arrives as a [`PresetRead`].
    ReadPreset(PathBuf),
    /// Replace the planet by a saved one.
    Load(PathBuf),
    /// Save the planet at the next step boundary.
    Save(PathBuf),
    /// Save the commands so far, as a scenario, at the next step boundary.
    SaveScenario(PathBuf),
    /// Save a picture of the window; without a path under the next free number.
    Screenshot(Option<PathBuf>),
    /// A command to the planet.
    Tectonic(TectonicCommand),
    /// Select a plate, or deselect it.
    Select(Option<PlateId>),
}

/// A preset that was asked for has been read.
#[derive(Message, Clone, Debug)]
pub struct PresetRead {
    /// Its recipe.
    pub recipe: PlanetRecipe,
    /// Its file.
    pub path: PathBuf,
}

/// The planet on show, `None` before the first one is there.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq)]
pub struct ShownPlanet(pub Option<Entity>);

/// The selected plate.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq)]
pub struct Selection(pub Option<PlateId>);

/// The use of the left button on the globe.
#[derive(Resource, Clone, Debug, Default, PartialEq)]
pub enum Tool {
    /// A click selects a plate; a drag with Shift sets its motion.
    #[default]
    Select,
    /// A click adds a point to a rift line of this plate.
    RiftLine {
        /// The plate.
        plate: PlateId,
        /// Unit directions of the points so far.
        points: Vec<DVec3>,
    },
    /// A click applies the brush.
    Paint,
}

/// The plate that is being dragged over the globe.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq)]
pub struct PlateDrag(pub Option<DraggedPlate>);

/// A plate, and where it was taken hold of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DraggedPlate {
    /// The plate.
    pub plate: PlateId,
    /// Unit direction of the ground under the pointer when the button was pressed.
    pub from: DVec3,
}

/// How the globe is drawn.
#[derive(Resource, Clone, Debug, PartialEq)]
pub struct Look {
    /// The quantity that its colours show.
    pub overlay: Overlay,
    /// Exaggeration of the relief.
    pub exaggeration: f32,
    /// Whether there is water.
    pub sea: bool,
    /// Whether plate boundaries are drawn.
    pub boundaries: bool,
    /// Whether the edges of the triangles are drawn.
    pub wireframe: bool,
    /// Whether there is air.
    pub air: bool,
    /// Whether the sun stays behind the viewer.
    pub sun_follows: bool,
}

impl Default for Look {
    fn default() -> Self {
        Self {
            overlay: Overlay::Elevation,
            exaggeration: 12.0,
            sea: true,
            boundaries: false,
            wireframe: false,
            air: true,
            sun_follows: true,
        }
    }
}

/// Where the pointer is.
#[derive(Resource, Clone, Copy, Debug, Default)]
pub struct Pointer {
    /// Whether it is over the free area between the panels, and not over anything that floats
    /// there.
    pub on_globe: bool,
    /// Unit direction of the ground under it, in the planet's coordinates.
    pub ground: Option<DVec3>,
}

/// Whether the page of keys is open.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq)]
pub struct HelpPage(pub bool);
