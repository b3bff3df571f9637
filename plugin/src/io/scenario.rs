//! Scenarios `*.scenario.ron`: commands to come, in any order.
//!
//! ```ron
//! [
//!     (step: 10, command: SetPlateMotion(plate: 3, pole: (60, -30), speed: 80)),
//!     (step: 20, command: RiftPlate(plate: 5, line: [(0, 10), (20, 14)])),
//!     (step: 30, command: PaintCrust(target: Everywhere, brush: Raise(-0.5))),
//!     (step: 40, command: SetParam(name: "erosion", value: 0.1)),
//! ]
//! ```

use super::IoError;
use super::text::{TextError, parse, read_text};
use crate::authoring::{Scenario, TimedCommand};
use std::path::Path;

/// Reads a scenario and checks all that needs no planet: names, limits and coordinates.
///
/// ```
/// use bevy_pangaea::io::scenario::parse_scenario;
///
/// let scenario = parse_scenario("[(step: 10, command: RiftPlate(plate: 5))]")?;
/// assert_eq!(scenario.0[0].step, 10);
///
/// let unknown = parse_scenario("[(step: 10, command: Explode)]");
/// assert!(unknown.is_err());
/// # Ok::<(), bevy_pangaea::io::TextError>(())
/// ```
///
/// # Errors
/// [`TextError`] for the first command that is refused.
pub fn parse_scenario(text: &str) -> Result<Scenario, TextError> {
    let commands: Vec<TimedCommand> = parse(text)?;
    for (i, timed) in commands.iter().enumerate() {
        timed.command.check().map_err(|problem| TextError {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::authoring::TectonicCommand;
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
        let rift = TectonicCommand::RiftPlate {
            plate: PlateId(5),
            line: vec![],
            fragments: 2,
        };
        assert_eq!(scenario.0[1].command, rift);
    }

    #[test]
    fn a_byte_order_mark_is_passed_over() {
        let scenario = parse_scenario("\u{feff}[\r\n  (step: 3, command: Resample),\r\n]\r\n");
        assert_eq!(scenario.unwrap().0[0].step, 3);
    }

    #[test]
    fn a_written_recording_is_a_scenario() {
        let commands = vec![TimedCommand {
            step: 3,
            command: TectonicCommand::Resample,
        }];
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
            assert!(
                error.problem.contains("command 1 (step 1)"),
                "{command}: {error}"
            );
        }
        let error = parse_scenario("[\n(step: 1, command: Explode)\n]").unwrap_err();
        assert_eq!(error.line, 2, "{error}");
        assert!(parse_scenario("[(step: -1, command: Resample)]").is_err());
    }
}
