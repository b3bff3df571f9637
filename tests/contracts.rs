//! Contracts: a stage writes what it declares and nothing else, a process that is off writes
//! nothing, and every plugin can be left out.

use bevy::app::PluginGroup;
use bevy::prelude::*;
use bevy_pangaea::crust::Cause;
use bevy_pangaea::crust::isostasy::Isostasy;
use bevy_pangaea::prelude::*;
use bevy_pangaea::process::{
    collision::CollisionPlugin, commit::CommitPlugin, contact::ContactPlugin, drift::DriftPlugin,
    margin::MarginPlugin, rifting::RiftingPlugin, slab_pull::SlabPullPlugin,
    subduction::SubductionPlugin, surface_processes::SurfaceProcessesPlugin, writes,
};
use bevy_pangaea::resample::ResamplePlugin;
use bevy_pangaea::schedule::TectonicSchedulePlugin;
use bevy_pangaea::spawn::PlanetState;
use pangaea_tests::probe::{Change, probe};
use pangaea_tests::shape::small;
use pangaea_tests::world::{get, params, planet_app, state, steps};
use std::collections::BTreeSet;
use std::sync::{Arc, Mutex};

fn lively(seed: u64) -> PlanetRecipe {
    let mut recipe = small(seed, 5000);
    recipe.params.rift_rate = 0.02;
    recipe
}

#[test]
fn every_stage_writes_what_it_declares() {
    let (mut app, planet) = planet_app(&lively(1));
    let seen = Arc::new(Mutex::new(BTreeSet::new()));
    let log = Arc::clone(&seen);
    probe(&mut app, move |change: &Change| {
        for column in change.changed() {
            assert!(
                writes(change.stage).contains(&column),
                "{} writes {column}",
                change.stage.name()
            );
            log.lock().unwrap().insert((change.stage, column));
        }
    });
    steps(&mut app, planet, 50);
    let seen = seen.lock().unwrap();
    for (stage, column) in WRITTEN {
        let name = stage.name();
        assert!(
            seen.contains(&(stage, column)),
            "{name} never wrote {column}"
        );
    }
}

/// Something that each stage has written by the end of a lively history.
const WRITTEN: [(Stage, &str); 9] = [
    (Stage::Drift, "frames"),
    (Stage::Contact, "polarity"),
    (Stage::Subduction, "elevation"),
    (Stage::SlabPull, "plates"),
    (Stage::Collision, "frame"),
    (Stage::Rifting, "plates"),
    (Stage::SurfaceProcesses, "ocean_age"),
    (Stage::Resample, "ridge"),
    (Stage::Commit, "clock"),
];

#[test]
fn a_process_that_is_off_writes_nothing() {
    for (name, stage) in [
        ("drift", Stage::Drift),
        ("subduction", Stage::Subduction),
        ("slab_pull", Stage::SlabPull),
        ("collision", Stage::Collision),
        ("resample", Stage::Resample),
        ("rifting", Stage::Rifting),
    ] {
        let (mut app, planet) = planet_app(&lively(1));
        *params(&mut app, planet).processes.get_mut(name).unwrap() = false;
        probe(&mut app, move |change| {
            let changed = if change.stage == stage {
                change.changed()
            } else {
                Vec::new()
            };
            assert!(
                changed.is_empty(),
                "{name} is off, but {changed:?} changed in step {}",
                change.step
            );
        });
        steps(&mut app, planet, 30);
    }
}

/// Lets a planet grow without one process and shows each of its relief stages to `look`.
fn without_process(name: &str, look: impl Fn(&Change) + Send + Sync + 'static) -> Ledger {
    let (mut app, planet) = planet_app(&lively(2));
    *params(&mut app, planet).processes.get_mut(name).unwrap() = false;
    probe(&mut app, move |change| {
        if change.stage == Stage::SurfaceProcesses {
            look(change);
        }
    });
    steps(&mut app, planet, 30);
    get::<Ledger>(&app, planet).clone()
}

/// Elevations in km of ocean floor before and after a stage, with the one at which it floats.
fn ocean_floor(change: &Change) -> impl Iterator<Item = [f32; 3]> {
    let (before, after) = (&change.before.crust, &change.after.crust);
    let law = Isostasy::new(&lively(2).params);
    let floor = (0..before.len()).filter(|&i| !before.is_continental(i));
    floor.map(move |i| {
        let rest = law.elevation(before.thickness[i]);
        [before.elevation[i], after.elevation[i], rest]
    })
}

#[test]
fn erosion_and_noise_that_are_off_book_nothing() {
    let ledger = without_process("erosion", |_| {});
    assert_eq!(ledger.of(Cause::Erosion).volume, 0.0);
    let ledger = without_process("noise", |_| {});
    assert_eq!(ledger.of(Cause::Noise).volume, 0.0);
    assert!(ledger.of(Cause::Erosion).volume < 0.0);
}

#[test]
fn without_subsidence_no_floor_sinks_and_without_sediment_none_is_filled() {
    without_process("subsidence", |change| {
        let mut high = ocean_floor(change).filter(|[was, _, rest]| was >= rest);
        assert!(high.all(|[was, is, _]| was == is), "floor sank");
    });
    without_process("sediment", |change| {
        let mut low = ocean_floor(change).filter(|[was, _, rest]| was < rest);
        assert!(low.all(|[was, is, _]| was == is), "floor was filled");
    });
}

#[test]
fn with_all_processes_off_only_time_passes() {
    let mut recipe = small(3, 3000);
    recipe.params.processes = ProcessSwitches::all(false);
    let (mut app, planet) = planet_app(&recipe);
    let before = state(&app, planet);
    steps(&mut app, planet, 70);
    let after = state(&app, planet);
    assert_eq!((before.frames, before.plates), (after.frames, after.plates));
    assert_eq!(
        (&before.crust.kind, &before.crust.thickness),
        (&after.crust.kind, &after.crust.thickness)
    );
    for i in 0..before.crust.len() {
        assert!((before.crust.elevation[i] - after.crust.elevation[i]).abs() < 1e-3);
    }
    assert_eq!(after.clock.time, 140.0);
}

/// The group without one plugin.
macro_rules! without {
    ($($plugin:ident),+) => { [$((
        stringify!($plugin),
        (|app: &mut App| { app.add_plugins(PangaeaPlugins.build().disable::<$plugin>()); }) as fn(&mut App),
    )),+] };
}

#[test]
fn every_process_can_be_left_out() {
    for (name, add) in without!(
        DriftPlugin,
        ContactPlugin,
        SubductionPlugin,
        SlabPullPlugin,
        CollisionPlugin,
        RiftingPlugin,
        SurfaceProcessesPlugin,
        MarginPlugin,
        ResamplePlugin,
        CommitPlugin
    ) {
        let mut app = App::new();
        add(&mut app);
        let planet = PlanetState::new(&lively(4)).unwrap().spawn(app.world_mut());
        steps(&mut app, planet, 25);
        let clock = get::<GeologicClock>(&app, planet);
        assert_eq!(
            clock.step,
            if name == "CommitPlugin" { 0 } else { 25 },
            "without {name}"
        );
        let crust = get::<Crust>(&app, planet);
        assert!(
            crust.elevation.iter().all(|z| z.is_finite()),
            "without {name}"
        );
        app.update();
    }
}

#[test]
fn presets_and_the_schedule_can_be_left_out() {
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins.build().disable::<TectonicSchedulePlugin>());
    PlanetState::new(&small(1, 500))
        .unwrap()
        .spawn(app.world_mut());
    app.update();
    let mut app = App::new();
    app.add_plugins(
        PangaeaPlugins
            .build()
            .disable::<bevy_pangaea::io::PresetPlugin>(),
    );
    let planet = PlanetState::new(&small(1, 500))
        .unwrap()
        .spawn(app.world_mut());
    steps(&mut app, planet, 3);
}

#[test]
fn a_process_can_be_replaced() {
    #[derive(Resource, Default)]
    struct Called(u32);
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins.build().disable::<DriftPlugin>())
        .init_resource::<Called>();
    app.add_systems(
        TectonicStep,
        (|mut called: ResMut<Called>| called.0 += 1).in_set(TectonicSystems::Process(Stage::Drift)),
    );
    let planet = PlanetState::new(&small(1, 1000))
        .unwrap()
        .spawn(app.world_mut());
    steps(&mut app, planet, 5);
    assert_eq!(app.world().resource::<Called>().0, 5);
    assert!(
        get::<Frames>(&app, planet)
            .iter()
            .all(|frame| frame.is_at_rest())
    );
}

#[test]
fn an_ambiguous_system_is_an_error() {
    let result = std::panic::catch_unwind(clash);
    assert!(
        result.is_err(),
        "two systems that write the crust in no order were accepted"
    );
}

/// A step with two systems that write the crust in no order.
fn clash() {
    let (mut app, planet) = planet_app(&small(1, 500));
    let set = TectonicSystems::After(Stage::SurfaceProcesses);
    app.add_systems(TectonicStep, (|_: Query<&mut Crust>| {}).in_set(set));
    app.add_systems(TectonicStep, (|_: Query<&mut Crust>| {}).in_set(set));
    steps(&mut app, planet, 1);
}

/// The rows of ARCHITECTURE.md's table of processes: stage and state that it writes.
fn documented() -> Vec<(String, BTreeSet<String>)> {
    let text = include_str!("../ARCHITECTURE.md");
    let (_, table) = text.split_once("\n## Processes\n").expect("the table");
    let rows = table.lines().skip_while(|line| !line.starts_with("|---"));
    rows.skip(1)
        .take_while(|line| line.starts_with('|'))
        .map(|line| {
            let cells: Vec<&str> = line.split('|').map(str::trim).collect();
            let written = cells[5].split(',').map(|name| name.trim().to_string());
            (
                cells[1].to_lowercase(),
                written.filter(|name| !name.is_empty()).collect(),
            )
        })
        .collect()
}

#[test]
fn the_map_of_the_code_lists_what_stages_write() {
    let documented = documented();
    for stage in Stage::ALL {
        let written: BTreeSet<String> = writes(stage).iter().map(|&name| name.into()).collect();
        let row = documented.iter().find(|(name, _)| name == stage.name());
        let (_, listed) = row.expect("a row of the table");
        assert_eq!(*listed, written, "{}", stage.name());
    }
}
