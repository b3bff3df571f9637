//! Actions that concern the clock of the planet, its plates and the selection.

use super::messages::MessageLog;
use super::state::{Action, PlateDrag, SPEED_LIMITS, Selection, ShownPlanet, Tool};
use super::view::ShownPlates;
use bevy::prelude::*;
use bevy_pangaea::hydrology::TerrainMaps;
use bevy_pangaea::prelude::*;

/// Single steps that may wait at most, so that a key held down does not run on for seconds.
const MAX_WAITING_STEPS: u32 = 20;

/// Why nothing can be done to a planet of maps.
const NO_PLATES: &str = "this planet is made of maps: no plate of it moves, and time stands still";

/// Does what is asked of the clock and the plates, and selects.
pub fn apply(
    mut actions: MessageReader<Action>,
    mut commands: Commands,
    shown: Res<ShownPlanet>,
    mut controls: Query<&mut ClockControls>,
    mut selection: ResMut<Selection>,
    mut messages: ResMut<MessageLog>,
    mapped: Query<(), With<TerrainMaps>>,
) {
    for action in actions.read() {
        if let Action::Select(plate) = action {
            selection.0 = *plate;
        }
        let Some(planet) = shown.0 else { continue };
        if needs_plates(action) && mapped.contains(planet) {
            messages.error(NO_PLATES);
            continue;
        }
        if let Action::Tectonic(command) = action {
            commands.entity(planet).tectonic(command.clone());
        }
        if let Ok(mut controls) = controls.get_mut(planet) {
            set_controls(&mut controls, action);
        }
    }
}

/// Whether an action lets time pass, or is a command to the plates.
fn needs_plates(action: &Action) -> bool {
    matches!(
        action,
        Action::TogglePlay | Action::SingleStep | Action::Tectonic(_)
    )
}

fn set_controls(controls: &mut ClockControls, action: &Action) {
    match action {
        Action::TogglePlay => {
            controls.paused = !controls.paused;
            controls.single_steps = 0;
        }
        Action::SingleStep => {
            controls.paused = true;
            controls.single_steps = (controls.single_steps + 1).min(MAX_WAITING_STEPS);
        }
        Action::SetSpeed(speed) => controls.speed = speed.clamp(SPEED_LIMITS.0, SPEED_LIMITS.1),
        _ => {}
    }
}

/// Drops the selection of a plate that is gone, and the rift line and the drag of a plate that is
/// not selected any more.
pub fn forget_lost_plates(
    plates: Res<ShownPlates>,
    mut selection: ResMut<Selection>,
    mut tool: ResMut<Tool>,
    mut drag: ResMut<PlateDrag>,
) {
    if selection.0.is_some_and(|id| plates.0.get(id).is_none()) {
        selection.0 = None;
    }
    if let Tool::RiftLine { plate, .. } = *tool
        && selection.0 != Some(plate)
    {
        *tool = Tool::Select;
    }
    if drag
        .0
        .is_some_and(|dragged| selection.0 != Some(dragged.plate))
    {
        drag.0 = None;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bevy_pangaea::climate::EquirectMap;

    /// Whether time stands still after it was asked to pass, and how many messages that gave.
    fn after_play(is_mapped: bool) -> (bool, usize) {
        let mut app = App::new();
        app.add_message::<Action>()
            .init_resource::<Selection>()
            .init_resource::<MessageLog>()
            .add_systems(Update, apply);
        let paused = ClockControls {
            paused: true,
            ..default()
        };
        let planet = app.world_mut().spawn(paused).id();
        if is_mapped {
            app.world_mut().entity_mut(planet).insert(TerrainMaps {
                crust: EquirectMap::from_fn(2, |_, _| 1.0).unwrap(),
                age: None,
                plateau: None,
                hills: None,
            });
        }
        app.insert_resource(ShownPlanet(Some(planet)));
        app.world_mut().write_message(Action::TogglePlay);
        app.update();
        let world = app.world();
        let controls = world.get::<ClockControls>(planet).unwrap();
        let said = world.resource::<MessageLog>().entries().count();
        (controls.paused, said)
    }

    #[test]
    fn time_does_not_pass_on_a_planet_of_maps_and_that_is_said() {
        assert_eq!(after_play(false), (false, 0));
        assert_eq!(after_play(true), (true, 1));
    }
}
