//! Types that editors, scenes and scripts find in the type registry.

use crate::PangaeaPlugins;
use bevy::prelude::*;
use bevy::reflect::TypeRegistry;

/// Components, resources and settings, by the path of their types within the crate.
const COMPONENTS: &[&str] = &[
    "authoring::inbox::Inbox",
    "authoring::scenario::Recording",
    "authoring::scenario::Scenario",
    "climate::fields::ClimateMaps",
    "crust::ledger::Ledger",
    "hydrology::terrain_maps::TerrainMaps",
    "ids::PlateId",
    "io::preset::follow::PlanetPreset",
    "params::TectonicParams",
    "planet::Planet",
    "planet::clock::ClockControls",
    "planet::clock::GeologicClock",
    "planet::clock::PlateNumbers",
    "planet::recipe::PlanetRecipe",
    "plate::Plate",
    "plate::PlateOf",
    "plate::PlateStats",
    "plate::Plates",
    "plate::motion::PlateMotion",
    "plate::terrane::Terrane",
    "schedule::cursor::StepCursor",
    "schedule::runner::TimeDebt",
    "schedule::timings::StageTimings",
];

const EVENTS: &[&str] = &[
    "authoring::events::CommandApplied",
    "events::CrustResampled",
    "events::PlateConsumed",
    "events::PlateRifted",
    "events::StepCompleted",
    "events::TerraneCollided",
    "spawn::events::PlanetReady",
];

const SETTINGS: &[&str] = &[
    "params::TectonicParams",
    "params::switches::ProcessSwitches",
    "planet::clock::ClockControls",
    "planet::recipe::PlanetRecipe",
];

/// The types without that data, or without a registration.
fn without<D: bevy::reflect::TypeData>(registry: &TypeRegistry, paths: &[&str]) -> Vec<String> {
    paths
        .iter()
        .map(|path| format!("bevy_pangaea::{path}"))
        .filter(|path| {
            let registration = registry.get_with_type_path(path);
            registration.is_none_or(|registration| registration.data::<D>().is_none())
        })
        .collect()
}

#[test]
fn components_events_and_settings_are_registered() {
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins);
    let registry = app.world().resource::<AppTypeRegistry>().read();
    let none: [String; 0] = [];
    assert_eq!(without::<ReflectComponent>(&registry, COMPONENTS), none);
    assert_eq!(without::<ReflectEvent>(&registry, EVENTS), none);
    assert_eq!(without::<ReflectDefault>(&registry, SETTINGS), none);
    assert_eq!(without::<ReflectSerialize>(&registry, SETTINGS), none);
    assert_eq!(without::<ReflectDeserialize>(&registry, SETTINGS), none);
}
