//! Commands of a user in few words.

use bevy_pangaea::plate::PlateId;
use bevy_pangaea::prelude::*;

/// A plate turns about a pole, in degrees, at a speed in km/My.
pub fn set_motion(plate: PlateId, pole: (f64, f64), speed: f64) -> TectonicCommand {
    TectonicCommand::SetPlateMotion { plate, pole, speed }
}

/// A plate breaks along a line of latitudes and longitudes in degrees, or anywhere if it is empty.
pub fn rift(plate: PlateId, line: &[(f64, f64)], fragments: u32) -> TectonicCommand {
    TectonicCommand::RiftPlate {
        plate,
        line: line.to_vec(),
        fragments,
    }
}

/// All crust of a plate becomes of one kind.
pub fn set_crust(plate: PlateId, kind: CrustKind) -> TectonicCommand {
    TectonicCommand::SetPlateCrust { plate, kind }
}

/// A brush is used on a part of the planet.
pub fn paint(target: PaintTarget, brush: Brush) -> TectonicCommand {
    TectonicCommand::PaintCrust { target, brush }
}

/// A brush is used everywhere.
pub fn paint_all(brush: Brush) -> TectonicCommand {
    paint(PaintTarget::Everywhere, brush)
}

/// A parameter has another value.
pub fn set_param(name: &str, value: f64) -> TectonicCommand {
    TectonicCommand::SetParam {
        name: name.into(),
        value,
    }
}

/// A process is switched on or off.
pub fn set_process(name: &str, on: bool) -> TectonicCommand {
    TectonicCommand::SetProcess {
        name: name.into(),
        on,
    }
}
