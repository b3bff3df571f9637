//! What happened: events of the planet, refused commands and errors, as a log and as a strip over
//! the globe.

use super::session::Session;
use super::text;
use bevy::prelude::*;
use bevy_pangaea::prelude::*;
use std::collections::VecDeque;
use std::time::{Duration, Instant};

/// Entries that are kept.
const CAPACITY: usize = 200;
/// How long a message stands over the globe.
const SHOWN: Duration = Duration::from_secs(7);

/// How a message is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// The planet did something.
    Event,
    /// The explorer did what was asked.
    Note,
    /// Something could not be done.
    Error,
}

/// A line of the log.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Geological time in My, none for what does not concern the planet.
    pub time: Option<f64>,
    /// How it is meant.
    pub tone: Tone,
    /// One line.
    pub text: String,
    /// How often it came in a row.
    pub times: u32,
    at: Instant,
}

/// The log, newest first.
#[derive(Resource, Default)]
pub struct Messages(VecDeque<Entry>);

impl Messages {
    /// All entries, newest first.
    pub fn entries(&self) -> impl Iterator<Item = &Entry> {
        self.0.iter()
    }

    /// What stands over the globe now, newest first; events only go into the log.
    pub fn strip(&self) -> impl Iterator<Item = &Entry> {
        self.0
            .iter()
            .filter(|e| e.tone != Tone::Event && e.at.elapsed() < SHOWN)
            .take(3)
    }

    /// Says that something was done.
    pub fn note(&mut self, text: impl Into<String>) {
        self.push(None, Tone::Note, text.into());
    }

    /// Says that something could not be done; also on the terminal.
    pub fn error(&mut self, text: impl Into<String>) {
        let text = text.into();
        warn!("{text}");
        self.push(None, Tone::Error, text);
    }

    /// Forgets everything.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    fn push(&mut self, time: Option<f64>, tone: Tone, text: String) {
        if let Some(last) = self.0.front_mut()
            && last.text == text
            && last.tone == tone
        {
            last.times += 1;
            last.time = time;
            last.at = Instant::now();
            return;
        }
        self.0.push_front(Entry {
            time,
            tone,
            text,
            times: 1,
            at: Instant::now(),
        });
        self.0.truncate(CAPACITY);
    }
}

/// Listens to the planets.
pub fn plugin(app: &mut App) {
    app.init_resource::<Messages>()
        .add_observer(on_collision)
        .add_observer(on_rift)
        .add_observer(on_consumed)
        .add_observer(on_resample)
        .add_observer(on_applied)
        .add_observer(on_rejected);
}

type Clocks<'w, 's> = Query<'w, 's, &'static GeologicClock>;

/// Writes an event of the planet on show into the log.
fn log(
    (messages, session, clocks): (&mut Messages, &Session, &Clocks),
    planet: Entity,
    tone: Tone,
    text: String,
) {
    if session.planet == Some(planet) {
        messages.push(clocks.get(planet).ok().map(|clock| clock.time), tone, text);
    }
}

fn on_collision(
    event: On<TerraneCollided>,
    mut messages: ResMut<Messages>,
    session: Res<Session>,
    clocks: Clocks,
) {
    let what = format!(
        "{} of plate {} collided with plate {} at {}",
        text::area(event.area),
        event.from.0,
        event.to.0,
        text::place(event.at),
    );
    log(
        (&mut messages, &session, &clocks),
        event.planet,
        Tone::Event,
        what,
    );
}

fn on_rift(
    event: On<PlateRifted>,
    mut messages: ResMut<Messages>,
    session: Res<Session>,
    clocks: Clocks,
) {
    let names: Vec<_> = event.fragments.iter().map(|id| id.0.to_string()).collect();
    let what = format!("plate {} broke into {}", event.parent.0, names.join(", "));
    log(
        (&mut messages, &session, &clocks),
        event.planet,
        Tone::Event,
        what,
    );
}

fn on_consumed(
    event: On<PlateConsumed>,
    mut messages: ResMut<Messages>,
    session: Res<Session>,
    clocks: Clocks,
) {
    let what = format!("plate {} was consumed", event.plate.0);
    log(
        (&mut messages, &session, &clocks),
        event.planet,
        Tone::Event,
        what,
    );
}

fn on_resample(
    event: On<CrustResampled>,
    mut messages: ResMut<Messages>,
    session: Res<Session>,
    clocks: Clocks,
) {
    let what = format!("{} of new ocean floor", text::area(event.new_ocean));
    log(
        (&mut messages, &session, &clocks),
        event.planet,
        Tone::Event,
        what,
    );
}

fn on_applied(
    event: On<CommandApplied>,
    mut messages: ResMut<Messages>,
    session: Res<Session>,
    clocks: Clocks,
) {
    let what = describe(&event.command);
    log(
        (&mut messages, &session, &clocks),
        event.planet,
        Tone::Event,
        what,
    );
}

fn on_rejected(
    event: On<CommandRejected>,
    mut messages: ResMut<Messages>,
    session: Res<Session>,
    clocks: Clocks,
) {
    let what = event.error.to_string();
    log(
        (&mut messages, &session, &clocks),
        event.planet,
        Tone::Error,
        what,
    );
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
    fn repeated_messages_are_counted_and_the_log_is_bounded() {
        let mut messages = Messages::default();
        messages.note("saved");
        messages.note("saved");
        assert_eq!(messages.entries().map(|e| e.times).collect::<Vec<_>>(), [2]);
        for i in 0..500 {
            messages.note(format!("{i}"));
        }
        assert_eq!(messages.entries().count(), CAPACITY);
        assert_eq!(messages.strip().count(), 3);
    }
}
