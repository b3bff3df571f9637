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
    let planet_ref = world.entity(planet);
    let get = "a component of every planet";
    let crust = planet_ref.get::<Crust>().expect(get).clone();
    let mesh = planet_ref.get::<Lattice>().expect(get);
    let radius = planet_ref.get::<Planet>().expect(get).radius;
    let table = plate_table(world, planet);
    Snapshot {
        continents: continents(&crust, mesh, radius),
        crust,
        frames: planet_ref.get::<Frames>().expect(get).clone(),
        plates: table
            .rows()
            .iter()
            .map(|row| (row.id, row.motion, row.born))
            .collect(),
        polarity: planet_ref.get::<PolarityMemory>().expect(get).clone(),
        ledger: planet_ref.get::<Ledger>().expect(get).clone(),
        clock: planet_ref.get::<GeologicClock>().expect(get).clone(),
        numbers: *planet_ref.get::<PlateNumbers>().expect(get),
    }
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
        let (a, b) = (&self.before, &self.after);
        let (c, d) = (&a.crust, &b.crust);
        let checks = [
            ("frame", c.frame != d.frame),
            ("kind", c.kind != d.kind),
            ("thickness", c.thickness != d.thickness),
            ("elevation", c.elevation != d.elevation),
            ("ocean_age", c.ocean_age != d.ocean_age),
            ("ridge", c.ridge != d.ridge),
            ("orogeny_age", c.orogeny_age != d.orogeny_age),
            ("orogeny", c.orogeny != d.orogeny),
            ("fold", c.fold != d.fold),
            ("frames", a.frames != b.frames),
            ("plates", a.plates != b.plates),
            ("polarity", a.polarity != b.polarity),
            ("ledger", a.ledger != b.ledger),
            ("clock", a.clock != b.clock),
            ("numbers", a.numbers != b.numbers),
        ];
        checks
            .iter()
            .filter(|(_, changed)| *changed)
            .map(|(name, _)| *name)
            .collect()
    }
}
