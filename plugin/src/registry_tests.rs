//! Types that editors, scenes and scripts find in the type registry.

use crate::PangaeaPlugins;
use bevy::prelude::*;
use bevy::reflect::{TypeData, TypeRegistry};

/// Components and resources, by the path of their types within the crate.
const COMPONENTS: &[&str] = &[
    "authoring::inbox::Inbox",
    "authoring::scenario::Recording",
    "authoring::scenario::Scenario",
    "climate::fields::ClimateMaps",
    "control::plugin::PlanetBake",
    "control::settings::BakeSettings",
    "crust::columns::Crust",
    "crust::frame::Frames",
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
    "plate::boundary::Rim",
    "plate::census::TerraneCensus",
    "plate::contact::Contacts",
    "plate::motion::PlateMotion",
    "plate::polarity::PolarityMemory",
    "plate::terrane::Terrane",
    "plate::terrane::TerraneOf",
    "plate::terrane::Terranes",
    "resample::stage::SurfaceProjection",
    "schedule::cursor::StepCursor",
    "schedule::runner::TimeDebt",
    "schedule::stage::CurrentPlanet",
    "schedule::timings::StageTimings",
];

/// Those that only the renderer has.
const OF_THE_RENDERER: &[&str] = &[
    "amplification::view::GroundStatus",
    "amplification::view::GroundView",
    "render::globe::Globe",
    "render::globe::GlobeDrawn",
];

const EVENTS: &[&str] = &[
    "authoring::events::CommandApplied",
    "control::plugin::BakeFinished",
    "events::CrustResampled",
    "events::PlateConsumed",
    "events::PlateRifted",
    "events::StepCompleted",
    "events::TerraneCollided",
    "spawn::events::PlanetReady",
];

/// Values that a user sets: editors make them, files hold them.
const SETTINGS: &[&str] = &[
    "climate::fields::ClimateMaps",
    "control::settings::BakeSettings",
    "params::TectonicParams",
    "params::switches::ProcessSwitches",
    "planet::clock::ClockControls",
    "planet::recipe::PlanetRecipe",
];

/// Types of the crate that have that data, in the order of their paths, those of tests aside.
fn with<D: TypeData>(registry: &TypeRegistry) -> Vec<&str> {
    let all = registry.iter_with_data::<D>();
    let paths = all.map(|(registration, _)| registration.type_info().type_path());
    let ours = paths.filter_map(|path| path.strip_prefix("bevy_pangaea::"));
    let mut paths: Vec<&str> = ours.filter(|path| !path.contains("tests::")).collect();
    paths.sort_unstable();
    paths
}

/// The types without that data, or without a registration.
fn without<D: TypeData>(registry: &TypeRegistry, paths: &[&'static str]) -> Vec<&'static str> {
    let found = with::<D>(registry);
    let missing = paths.iter().filter(|path| !found.contains(path));
    missing.copied().collect()
}

#[test]
fn components_events_and_settings_are_registered() {
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins);
    let registry = app.world().resource::<AppTypeRegistry>().read();
    let mut components = COMPONENTS.to_vec();
    if cfg!(feature = "render") {
        components.extend(OF_THE_RENDERER);
        components.sort_unstable();
    }
    assert_eq!(with::<ReflectComponent>(&registry), components);
    assert_eq!(with::<ReflectEvent>(&registry), EVENTS);
    let none: [&str; 0] = [];
    assert_eq!(without::<ReflectDefault>(&registry, SETTINGS), none);
    assert_eq!(without::<ReflectSerialize>(&registry, SETTINGS), none);
    assert_eq!(without::<ReflectDeserialize>(&registry, SETTINGS), none);
}
