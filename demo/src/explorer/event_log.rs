//! Events of the planet on show, as lines of the log.

use super::messages::{MessageLog, Tone};
use super::state::ShownPlanet;
use super::text;
use bevy::prelude::*;
use bevy_pangaea::prelude::*;

/// Listens to the planets.
pub fn plugin(app: &mut App) {
    app.init_resource::<MessageLog>()
        .add_observer(log::<TerraneCollided>)
        .add_observer(log::<PlateRifted>)
        .add_observer(log::<PlateConsumed>)
        .add_observer(log::<CrustResampled>)
        .add_observer(log::<CommandApplied>)
        .add_observer(log::<CommandRejected>);
}

/// An event that has a line in the log.
trait LoggedEvent: EntityEvent {
    /// How the line is meant.
    const TONE: Tone = Tone::Event;

    /// The line.
    fn line(&self) -> String;
}

/// Writes an event of the planet on show into the log.
fn log<E: LoggedEvent>(
    event: On<E>,
    mut messages: ResMut<MessageLog>,
    shown: Res<ShownPlanet>,
    clocks: Query<&GeologicClock>,
) {
    let planet = event.event_target();
    // A planet that has just been replaced may still have something to say.
    if shown.0 == Some(planet) {
        let time = clocks.get(planet).ok().map(|clock| clock.time);
        messages.push(time, E::TONE, event.line());
    }
}

impl LoggedEvent for TerraneCollided {
    fn line(&self) -> String {
        format!(
            "{} of plate {} collided with plate {} at {}",
            text::area(self.area),
            self.from.0,
            self.to.0,
            text::place(self.at),
        )
    }
}

impl LoggedEvent for PlateRifted {
    fn line(&self) -> String {
        let names: Vec<_> = self.fragments.iter().map(|id| id.0.to_string()).collect();
        format!("plate {} broke into {}", self.parent.0, names.join(", "))
    }
}

impl LoggedEvent for PlateConsumed {
    fn line(&self) -> String {
        format!("plate {} was consumed", self.plate.0)
    }
}

impl LoggedEvent for CrustResampled {
    fn line(&self) -> String {
        format!("{} of new ocean floor", text::area(self.new_ocean))
    }
}

impl LoggedEvent for CommandApplied {
    fn line(&self) -> String {
        describe(&self.command)
    }
}

impl LoggedEvent for CommandRejected {
    const TONE: Tone = Tone::Error;

    fn line(&self) -> String {
        self.error.to_string()
    }
}

/// A command in words.
fn describe(command: &TectonicCommand) -> String {
    match command {
        TectonicCommand::SetPlateMotion { plate, speed, .. } => {
            format!(
                "plate {} now moves at {} km/My",
                plate.0,
                text::number(*speed)
            )
        }
        TectonicCommand::RiftPlate { plate, .. } => format!("plate {} is torn apart", plate.0),
        TectonicCommand::SetPlateCrust { plate, kind } => {
            format!("plate {} is now {kind:?}", plate.0).to_lowercase()
        }
        TectonicCommand::PaintCrust {
            target: PaintTarget::Everywhere,
            ..
        } => "the whole crust was painted".into(),
        TectonicCommand::PaintCrust {
            target: PaintTarget::Disc { radius, .. },
            ..
        } => {
            format!("crust was painted within {} km", text::number(*radius))
        }
        TectonicCommand::SetParam { name, value } => {
            format!("{} = {}", text::words(name), text::number(*value))
        }
        TectonicCommand::SetProcess { name, on } => {
            format!("{} {}", text::words(name), if *on { "on" } else { "off" })
        }
        TectonicCommand::SetOceanFloor {
            law: OceanFloor::Relaxing,
        } => "ocean floor relaxes".into(),
        TectonicCommand::SetOceanFloor {
            law: OceanFloor::Paper,
        } => "ocean floor sinks as printed".into(),
        TectonicCommand::Resample => "a resample was asked for".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_planet_on_show_is_heard() {
        let mut app = App::new();
        app.add_plugins(plugin);
        let [shown, other] = [(); 2].map(|()| app.world_mut().spawn_empty().id());
        app.insert_resource(ShownPlanet(Some(shown)));
        for (planet, plate) in [(shown, PlateId(3)), (other, PlateId(4))] {
            app.world_mut().trigger(PlateConsumed { planet, plate });
        }
        let messages = app.world().resource::<MessageLog>();
        let lines: Vec<&str> = messages.entries().map(|entry| &*entry.text).collect();
        assert_eq!(lines, ["plate 3 was consumed"]);
    }

    #[test]
    fn commands_are_named() {
        let motion = TectonicCommand::SetPlateMotion {
            plate: PlateId(7),
            pole: (10.0, 20.0),
            speed: 62.5,
        };
        assert_eq!(describe(&motion), "plate 7 now moves at 62.5 km/My");
        let name = "slab_pull".into();
        let switch = TectonicCommand::SetProcess { name, on: false };
        assert_eq!(describe(&switch), "Slab pull off");
    }
}
