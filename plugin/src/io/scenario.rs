//! Scenarios `*.scenario.ron`: commands to come, in any order.
//!
//! ```ron
//! [
//!     (step: 10, command: SetPlateMotion(plate: 3, pole: (60, -30), speed: 80)),
//!     (step: 20, command: RiftPlate(plate: 5, line: [(0, 10), (20, 14)])),
//!     (step: 30, command: PaintCrust(target: Disc(center: (10, 20), radius: 800), brush: Raise(2))),
//!     (step: 40, command: SetParam(name: "erosion", value: 0.1)),
//! ]
//! ```

use super::preset::{TextError, parse};
use super::{IoError, read_text};
use crate::authoring::{Brush, PaintTarget, Scenario, TectonicCommand, TimedCommand};
use crate::params::{ProcessSwitches, TectonicParams};
use std::path::Path;

/// Reads a scenario and checks what can be known without a planet: names, limits and coordinates.
///
/// # Errors
/// [`TextError`] for the first command that is refused.
pub fn parse_scenario(text: &str) -> Result<Scenario, TextError> {
    let commands: Vec<TimedCommand> = parse(text)?;
    for (i, timed) in commands.iter().enumerate() {
        check(&timed.command).map_err(|problem| TextError {
            line: 0,
            problem: format!("command {} (step {}): {problem}", i + 1, timed.step),
        })?;
    }
    Ok(Scenario(commands))
}

/// Loads a scenario from a file.
///
/// # Errors
/// [`IoError`] names the file and, where there is one, the line.
pub fn load_scenario(path: &Path) -> Result<Scenario, IoError> {
    parse_scenario(&read_text(path)?).map_err(|error| error.in_file(path))
}

/// Checks the numbers and names of a command, as far as they do not depend on a planet. What a planet
/// accepts passes, so recordings are checked by it, too.
///
/// # Errors
/// What is wrong, in words.
pub fn check(command: &TectonicCommand) -> Result<(), String> {
    match command {
        TectonicCommand::SetPlateMotion { pole, speed, .. } => {
            coordinates(*pole)?;
            within("speed", *speed, -300.0, 300.0)
        }
        TectonicCommand::RiftPlate { line, fragments, .. } => {
            if line.len() == 1 || line.len() > 1000 {
                return Err("a line has 2 to 1000 points".into());
            }
            line.iter().try_for_each(|&point| coordinates(point))?;
            within("fragments", f64::from(*fragments), 2.0, 4.0)
        }
        TectonicCommand::PaintCrust { target, brush } => {
            if let PaintTarget::Disc { center, radius } = target {
                coordinates(*center)?;
                within("radius", *radius, 0.0, 100_000.0)?;
            }
            match brush {
                Brush::Raise(km) => within("height", *km, -20.0, 20.0),
                Brush::Elevation(km) => within("elevation", *km, -15.0, 20.0),
                Brush::Kind(_) => Ok(()),
            }
        }
        TectonicCommand::SetParam { name, value } => {
            let info = TectonicParams::info(name).ok_or_else(|| format!("unknown parameter `{name}`"))?;
            info.check(*value).map_err(|error| error.to_string())
        }
        TectonicCommand::SetProcess { name, .. } => ProcessSwitches::default()
            .get_mut(name)
            .map(|_| ())
            .map_err(|_| format!("unknown process `{name}`")),
        TectonicCommand::SetPlateCrust { .. } | TectonicCommand::Resample => Ok(()),
    }
}

fn coordinates((latitude, longitude): (f64, f64)) -> Result<(), String> {
    within("latitude", latitude, -90.0, 90.0)?;
    within("longitude", longitude, -360.0, 360.0)
}

fn within(what: &str, value: f64, low: f64, high: f64) -> Result<(), String> {
    if (low..=high).contains(&value) {
        Ok(())
    } else {
        Err(format!("{what} = {} is outside of {low}..={high}", crate::params::shown(value)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plate::PlateId;

    #[test]
    fn commands_are_read() {
        let scenario = parse_scenario(
            "[(step: 10, command: SetPlateMotion(plate: 3, pole: (60, -30), speed: 80)),
              (step: 20, command: RiftPlate(plate: 5)),
              (step: 30, command: PaintCrust(target: Everywhere, brush: Raise(-0.5))),
              (step: 40, command: SetParam(name: \"erosion\", value: 0.1)),
              (step: 50, command: Resample)]",
        )
        .unwrap();
        let steps: Vec<u64> = scenario.0.iter().map(|timed| timed.step).collect();
        assert_eq!(steps, [10, 20, 30, 40, 50]);
        let rift = TectonicCommand::RiftPlate { plate: PlateId(5), line: vec![], fragments: 2 };
        assert_eq!(scenario.0[1].command, rift);
    }

    #[test]
    fn a_written_recording_is_a_scenario() {
        let commands = vec![TimedCommand { step: 3, command: TectonicCommand::Resample }];
        let text = ron::to_string(&commands).unwrap();
        assert_eq!(parse_scenario(&text).unwrap().0, commands);
    }

    #[test]
    fn what_no_planet_could_do_is_refused() {
        for command in [
            "SetPlateMotion(plate: 1, pole: (91, 0), speed: 10)",
            "SetPlateMotion(plate: 1, pole: (0, 0), speed: NaN)",
            "SetPlateMotion(plate: 1, pole: (0, 0), speed: 1e9)",
            "RiftPlate(plate: 1, line: [(0, 0)])",
            "RiftPlate(plate: 1, fragments: 5)",
            "PaintCrust(target: Disc(center: (0, 0), radius: -1), brush: Raise(1))",
            "PaintCrust(target: Everywhere, brush: Raise(inf))",
            "SetParam(name: \"upift\", value: 1)",
            "SetParam(name: \"uplift\", value: -1)",
            "SetProcess(name: \"magic\", on: true)",
        ] {
            let error = parse_scenario(&format!("[(step: 1, command: {command})]")).unwrap_err();
            assert!(error.problem.contains("command 1 (step 1)"), "{command}: {error}");
        }
        let error = parse_scenario("[\n(step: 1, command: Explode)\n]").unwrap_err();
        assert_eq!(error.line, 2, "{error}");
        assert!(parse_scenario("[(step: -1, command: Resample)]").is_err());
    }
}
