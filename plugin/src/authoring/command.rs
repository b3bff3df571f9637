//! The commands.

use crate::crust::CrustKind;
use crate::params::OceanFloor;
use crate::plate::PlateId;
use bevy::prelude::*;

/// Something that a user of the tectonic model may do at any moment (paper 000 §7.1).
///
/// They are text, too, as in scenarios:
///
/// ```
/// use bevy_pangaea::prelude::*;
///
/// let text = "SetParam(name: \"erosion\", value: 0.05)";
/// let command: TectonicCommand = ron::from_str(text)?;
/// let same = TectonicCommand::SetParam { name: "erosion".into(), value: 0.05 };
/// assert_eq!(command, same);
/// # Ok::<(), ron::error::SpannedError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Reflect, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
#[reflect(Serialize, Deserialize)]
pub enum TectonicCommand {
    /// Gives a plate a motion.
    SetPlateMotion {
        /// The plate.
        plate: PlateId,
        /// Latitude and longitude of the pole of rotation in degrees.
        pole: (f64, f64),
        /// Speed at 90 degrees from the pole in km/My (mm/y); negative turns the other way.
        speed: f64,
    },
    /// Breaks a plate.
    RiftPlate {
        /// The plate.
        plate: PlateId,
        /// Latitudes and longitudes in degrees of points along the fracture, at least two; empty
        /// for a random fracture.
        #[serde(default)]
        line: Vec<(f64, f64)>,
        /// Number of fragments of a random fracture, 2..=4.
        #[serde(default = "two")]
        fragments: u32,
    },
    /// Switches the crust type of a whole plate.
    SetPlateCrust {
        /// The plate.
        plate: PlateId,
        /// The new type.
        kind: CrustKind,
    },
    /// Changes crust.
    PaintCrust {
        /// The place.
        target: PaintTarget,
        /// The change.
        brush: Brush,
    },
    /// Changes a parameter.
    SetParam {
        /// Name, as in [`TectonicParams::TABLE`](crate::params::TectonicParams::TABLE).
        name: String,
        /// New value.
        value: f64,
    },
    /// Switches a process on or off.
    SetProcess {
        /// Name, as in [`ProcessSwitches::NAMES`](crate::params::ProcessSwitches::NAMES).
        name: String,
        /// Whether it runs.
        on: bool,
    },
    /// Chooses the law by which ocean floor sinks with age.
    SetOceanFloor {
        /// The law.
        law: OceanFloor,
    },
    /// Resamples at the next step.
    Resample,
}

fn two() -> u32 {
    2
}

/// The place where a brush works.
#[derive(Clone, Copy, Debug, PartialEq, Reflect, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub enum PaintTarget {
    /// On the whole planet.
    Everywhere,
    /// In a disc; raising and lowering fade towards its edge.
    Disc {
        /// Latitude and longitude of the centre in degrees.
        center: (f64, f64),
        /// Radius in km.
        radius: f64,
    },
}

/// The change that a brush makes.
///
/// ```
/// use bevy_pangaea::prelude::*;
///
/// // An island of 200 m, on continental crust.
/// let island = PaintTarget::Disc { center: (10.0, -150.0), radius: 400.0 };
/// let paint = |brush| TectonicCommand::PaintCrust { target: island, brush };
/// let strokes = [Brush::Kind(CrustKind::Continental), Brush::Elevation(0.2)].map(paint);
/// assert_eq!(strokes.len(), 2);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Reflect, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Brush {
    /// Raises (or, negative, lowers) the crust by km; its thickness follows.
    Raise(f64),
    /// Sets the elevation in km; the thickness follows.
    Elevation(f64),
    /// Sets the crust type; thickness and elevation become those of young ocean floor or low land.
    Kind(CrustKind),
}
