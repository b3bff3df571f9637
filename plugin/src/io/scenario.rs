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

use super::text::{TextError, parse, read_text};
use super::{IoError, map_digest, write_atomically};
use crate::authoring::{Scenario, TimedCommand};
use crate::spawn::PlanetState;
use ron::ser::PrettyConfig;
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

/// All commands of a planet as the text of a scenario: those that were carried out, then those that
/// are still to come.
///
/// Played on the recipe of the planet for as many steps, it gives the same planet to the last bit.
/// Commands of a planet that rests at its last step are due after that step.
///
/// ```
/// use bevy_pangaea::io::scenario::{parse_scenario, scenario_of};
/// use bevy_pangaea::prelude::*;
///
/// let recipe = PlanetRecipe { samples: 500, plate_count: 8, ..PlanetRecipe::default() };
/// let mut planet = PlanetState::new(&recipe)?;
/// let timed = TimedCommand { step: 0, command: TectonicCommand::Resample };
/// planet.recording.0.push(timed.clone());
///
/// let text = scenario_of(&planet);
/// assert!(text.contains("(step: 0, command: Resample),"));
/// assert_eq!(parse_scenario(&text)?.0, [timed]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn scenario_of(state: &PlanetState) -> String {
    let commands: Vec<&TimedCommand> = (state.recording.0.iter()).chain(&state.pending.0).collect();
    // A command is a line.
    let style = PrettyConfig::new().depth_limit(1);
    // Plain lists of numbers and names always have a text.
    let list = ron::ser::to_string_pretty(&commands, style).unwrap_or_default();
    format!("{}{list}\n", head(state))
}

/// The planet that the commands belong to, as a comment, with the maps that its climate needs.
fn head(state: &PlanetState) -> String {
    let (clock, seed) = (&state.clock, state.planet.seed);
    let samples = state.lattice.0.len();
    let maps = state.climate.iter().map(|(field, map)| {
        let name = field.name();
        let hash = map_digest(map);
        format!("// Its climate is that of a map: give --{name} again, BLAKE3 {hash:.16}.\n")
    });
    let maps: String = maps.collect();
    format!(
        "// The commands of a planet of seed {seed} and {samples} samples after {} My, {} steps.\n\
         // Played on the same recipe for as long, they give the same planet.\n{maps}",
        clock.time, clock.step
    )
}

/// Writes all commands of a planet as a scenario, whole or not at all; see [`scenario_of`].
///
/// # Errors
/// [`IoError::Write`]; an older file of that name is untouched then.
pub fn save_scenario(state: &PlanetState, path: &Path) -> Result<(), IoError> {
    let text = scenario_of(state);
    write_atomically(path, |out| out.write_all(text.as_bytes()))
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
    fn the_head_names_the_maps_that_the_planet_needs() {
        use crate::climate::{ClimateField, EquirectMap};
        use crate::planet::PlanetRecipe;

        let recipe = PlanetRecipe {
            samples: 500,
            plate_count: 8,
            ..PlanetRecipe::default()
        };
        let mut state = PlanetState::new(&recipe).unwrap();
        assert!(!scenario_of(&state).contains("--rain"));
        let map = EquirectMap::from_fn(4, |_, _| 900.0).unwrap();
        state.climate.set(ClimateField::Rain, map);
        let text = scenario_of(&state);
        let line = text.lines().find(|line| line.contains("--rain")).unwrap();
        assert!(line.starts_with("// ") && line.contains("BLAKE3"), "{line}");
        assert!(parse_scenario(&text).is_ok());
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
