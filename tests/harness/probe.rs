//! The effect of every stage of a step: the state is compared before and after.

use crate::measure::continents;
use bevy::prelude::*;
use bevy_pangaea::crust::ledger::Amount;
use bevy_pangaea::plate::PlateId;
use bevy_pangaea::plate::plate_table;
use bevy_pangaea::plate::polarity::PolarityMemory;
use bevy_pangaea::prelude::*;

/// The state of a planet between two stages.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// Columns.
    pub crust: Crust,
    /// Frames.
    pub frames: Frames,
    /// Motions and times of birth of the plates.
    pub plates: Vec<(PlateId, PlateMotion, f64)>,
    /// Memory of polarity.
    pub polarity: PolarityMemory,
    /// The account.
    pub ledger: Ledger,
    /// The clock.
    pub clock: GeologicClock,
    /// The numbers of plates that are used up.
    pub numbers: PlateNumbers,
    /// Continental area in km² and volume in km³, measured independently.
    pub continents: (f64, f64),
}

/// A stage with the state before and after it.
#[derive(Clone, Debug)]
pub struct Change {
    /// The stage.
    pub stage: Stage,
    /// The step, from 0.
    pub step: u64,
    /// Before.
    pub before: Snapshot,
    /// After.
    pub after: Snapshot,
}

/// The state after the last stage, and the function that looks at every change.
#[derive(Resource)]
struct Probe {
    last: Option<Snapshot>,
    look: Box<dyn FnMut(&Change) + Send + Sync>,
}

/// Calls `look` after every stage of every step from now on.
pub fn probe(app: &mut App, look: impl FnMut(&Change) + Send + Sync + 'static) {
    app.insert_resource(Probe {
        last: None,
        look: Box::new(look),
    });
    for stage in Stage::ALL {
        let after = move |world: &mut World| visit(world, stage);
        app.add_systems(TectonicStep, after.in_set(TectonicSystems::After(stage)));
    }
}

fn visit(world: &mut World, stage: Stage) {
    let planet = world.resource::<CurrentPlanet>().0;
    let after = snapshot(world, planet);
    world.resource_scope(|_, mut probe: Mut<Probe>| {
        if let Some(before) = probe.last.take() {
            let step = before.clock.step;
            (probe.look)(&Change {
                stage,
                step,
                before,
                after: after.clone(),
            });
        }
        probe.last = Some(after);
    });
}

/// The state of a planet now, between any two systems.
pub fn snapshot(world: &World, planet: Entity) -> Snapshot {
    let crust: Crust = part(world, planet);
    let mesh: Lattice = part(world, planet);
    let body: Planet = part(world, planet);
    let table = plate_table(world, planet);
    let plates = table.rows().iter();
    Snapshot {
        continents: continents(&crust, &mesh, body.radius),
        crust,
        frames: part(world, planet),
        plates: plates.map(|row| (row.id, row.motion, row.born)).collect(),
        polarity: part(world, planet),
        ledger: part(world, planet),
        clock: part(world, planet),
        numbers: part(world, planet),
    }
}

/// A copy of a component that every planet has.
fn part<C: Component + Clone>(world: &World, planet: Entity) -> C {
    let part = world.get::<C>(planet);
    part.expect("a component of every planet").clone()
}

impl Change {
    /// Amounts of the stage: booked, and measured.
    pub fn account(&self) -> (Amount, Amount) {
        let (old, new) = (self.before.ledger.expected(), self.after.ledger.expected());
        let (was, is) = (self.before.continents, self.after.continents);
        (
            Amount {
                area: new.area - old.area,
                volume: new.volume - old.volume,
            },
            Amount {
                area: is.0 - was.0,
                volume: is.1 - was.1,
            },
        )
    }

    /// Names of all that has changed.
    pub fn changed(&self) -> Vec<&'static str> {
        let mut names = changed_columns(&self.before.crust, &self.after.crust);
        let (a, b) = (&self.before, &self.after);
        let checks = [
            ("frames", a.frames != b.frames),
            ("plates", a.plates != b.plates),
            ("polarity", a.polarity != b.polarity),
            ("ledger", a.ledger != b.ledger),
            ("clock", a.clock != b.clock),
            ("numbers", a.numbers != b.numbers),
        ];
        names.extend(checks.iter().filter(|check| check.1).map(|check| check.0));
        names
    }
}

/// Names of the columns that differ.
fn changed_columns(a: &Crust, b: &Crust) -> Vec<&'static str> {
    let checks = [
        ("frame", a.frame != b.frame),
        ("kind", a.kind != b.kind),
        ("thickness", a.thickness != b.thickness),
        ("elevation", a.elevation != b.elevation),
        ("ocean_age", a.ocean_age != b.ocean_age),
        ("ridge", a.ridge != b.ridge),
        ("orogeny_age", a.orogeny_age != b.orogeny_age),
        ("orogeny", a.orogeny != b.orogeny),
        ("fold", a.fold != b.fold),
    ];
    let changed = checks.iter().filter(|check| check.1);
    changed.map(|check| check.0).collect()
}
