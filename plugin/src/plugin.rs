//! The plugin group.

use crate::authoring::AuthoringPlugin;
use crate::control::BakePlugin;
use crate::io::PresetPlugin;
use crate::process::{
    collision::CollisionPlugin, commit::CommitPlugin, contact::ContactPlugin, drift::DriftPlugin,
    margin::MarginPlugin, rifting::RiftingPlugin, slab_pull::SlabPullPlugin,
    subduction::SubductionPlugin, surface_processes::SurfaceProcessesPlugin,
    terranes::TerranePlugin,
};
use crate::resample::ResamplePlugin;
use crate::schedule::TectonicSchedulePlugin;
use crate::spawn::SpawnPlugin;
use bevy::app::PluginGroupBuilder;
use bevy::prelude::*;

/// All of Pangaea but the globe, one plugin per process. Each can be set, disabled or replaced.
///
/// | plugin | what it does |
/// |---|---|
/// | [`TectonicSchedulePlugin`] | the step as a schedule, spread over frames |
/// | [`SpawnPlugin`] | planets grow on entities with a recipe |
/// | [`DriftPlugin`] | frames rotate with their plates |
/// | [`ContactPlugin`] | where plates meet, and which goes under |
/// | [`SubductionPlugin`] | overriding plates rise |
/// | [`SlabPullPlugin`] | subducting plates turn towards their fronts |
/// | [`CollisionPlugin`] | terranes break off and are sutured |
/// | [`RiftingPlugin`] | plates break |
/// | [`SurfaceProcessesPlugin`] | erosion, subsidence, sediment, isostasy, noise |
/// | [`MarginPlugin`] | sediment slopes beside continents |
/// | [`ResamplePlugin`] | even samples again, new ocean crust, the surface for pictures |
/// | [`TerranePlugin`] | terranes as entities, true after every step |
/// | [`CommitPlugin`] | clock, ledger |
/// | [`AuthoringPlugin`] | commands |
/// | [`BakePlugin`] | climate, rivers and control maps in the background, where asked for |
/// | [`PresetPlugin`] | `*.planet.ron` as assets, where there are assets |
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// use bevy_pangaea::process::rifting::RiftingPlugin;
///
/// let mut app = App::new();
/// app.add_plugins(
///     PangaeaPlugins
///         .set(TectonicSchedulePlugin::new(FixedUpdate))
///         .disable::<RiftingPlugin>(),
/// );
/// ```
pub struct PangaeaPlugins;

impl PluginGroup for PangaeaPlugins {
    fn build(self) -> PluginGroupBuilder {
        PluginGroupBuilder::start::<Self>()
            .add(TectonicSchedulePlugin::default())
            .add(SpawnPlugin)
            .add(DriftPlugin)
            .add(ContactPlugin)
            .add(SubductionPlugin)
            .add(SlabPullPlugin)
            .add(CollisionPlugin)
            .add(RiftingPlugin)
            .add(SurfaceProcessesPlugin)
            .add(MarginPlugin)
            .add(ResamplePlugin)
            .add(TerranePlugin)
            .add(CommitPlugin)
            .add(AuthoringPlugin)
            .add(BakePlugin)
            .add(PresetPlugin)
    }
}
