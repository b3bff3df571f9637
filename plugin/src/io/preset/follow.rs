//! A planet that follows its preset while the file is edited.
//!
//! | the preset changes | the planet |
//! |---|---|
//! | in `params` alone | lives on: the changed parameters are sent as commands, recorded like all |
//! | in anything else | is grown anew |
//!
//! Only what has changed in the preset is sent, so parameters that were set by other commands stay.
//! A planet that is not built yet is built from the new preset in any case.

use crate::authoring::{Inbox, TectonicCommand};
use crate::planet::{Planet, PlanetRecipe};
use crate::spawn::PlanetTask;
use bevy::platform::collections::HashSet;
use bevy::prelude::*;

/// Grows the planet of a preset, and keeps it true to the preset when that changes.
///
/// With Bevy's feature `file_watcher` a saved file reaches the planet at its next step.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// fn setup(mut commands: Commands, assets: Res<AssetServer>) {
///     commands.spawn(PlanetPreset(assets.load("two_continents_colliding.planet.ron")));
/// }
/// # bevy::ecs::system::assert_is_system(setup);
/// ```
///
/// Where `params` alone have changed, the planet lives on and the changes are sent to it as
/// commands, so that its recording replays to the same bits; otherwise it is grown anew.
#[derive(Component, Clone, Debug, PartialEq, FromTemplate, Reflect)]
#[require(Inbox)]
#[reflect(Component)]
pub struct PlanetPreset(pub Handle<PlanetRecipe>);

/// The preset as the planet knows it.
#[derive(Component)]
pub(super) struct KnownPreset(PlanetRecipe);

/// A planet as a change of its preset finds it.
type Follower<'a> = (
    Entity,
    Ref<'a, PlanetPreset>,
    Option<&'a KnownPreset>,
    &'a mut Inbox,
    (Has<Planet>, Has<PlanetTask>),
);

/// Tells planets of presets that are loaded or have changed.
pub(super) fn follow(
    mut events: MessageReader<AssetEvent<PlanetRecipe>>,
    presets: Res<Assets<PlanetRecipe>>,
    mut planets: Query<Follower<'static>>,
    mut commands: Commands,
) {
    let changed: HashSet<_> = events.read().filter_map(changed_asset).collect();
    for (planet, preset, known, mut inbox, (is_planet, in_work)) in &mut planets {
        let is_new = known.is_none() || preset.is_changed() || changed.contains(&preset.0.id());
        let Some(wanted) = presets.get(&preset.0).filter(|_| is_new) else {
            continue;
        };
        let lives = is_planet && !in_work;
        match known.map(|known| &known.0) {
            Some(known) if known == wanted => continue,
            Some(known) if lives && differ_in_params_alone(known, wanted) => inbox
                .0
                .extend(TectonicCommand::between(&known.params, &wanted.params)),
            _ => {
                commands.entity(planet).insert(wanted.clone());
            }
        }
        commands.entity(planet).insert(KnownPreset(wanted.clone()));
    }
}

fn changed_asset(event: &AssetEvent<PlanetRecipe>) -> Option<AssetId<PlanetRecipe>> {
    match event {
        AssetEvent::Added { id } | AssetEvent::Modified { id } => Some(*id),
        _ => None,
    }
}

fn differ_in_params_alone(a: &PlanetRecipe, b: &PlanetRecipe) -> bool {
    let with_params_of_b = PlanetRecipe {
        params: b.params.clone(),
        ..a.clone()
    };
    with_params_of_b == *b
}

#[cfg(test)]
#[path = "follow_tests.rs"]
mod tests;
