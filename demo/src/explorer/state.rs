//! What the parts of the explorer share: wishes of the user, what is selected, what is under the
//! cursor.
//!
//! Panels and keys only say what is wanted, as an [`Action`]; [`session`](super::session) and
//! [`apply_actions`] do it. So a key, a button and a test take the same way.

use super::session::Session;
use bevy::ecs::system::SystemParam;
use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::control::{Bake, BakeSettings, PlanetBake};
use bevy_pangaea::overlay::{Overlay, OverlayInput};
use bevy_pangaea::plate::{Plate, PlateRow, PlateStats, PlateTable};
use bevy_pangaea::prelude::*;
use bevy_pangaea::render::Globe;
use bevy_pangaea::schedule::StageTimings;
use bevy_pangaea::sphere::SphereMesh;
use std::path::PathBuf;
use std::time::Duration;

/// Slowest and fastest wanted speed in My per second.
pub const SPEED_LIMITS: (f64, f64) = (0.5, 200.0);
/// Least and most exaggeration of the relief.
pub const EXAGGERATION_LIMITS: (f32, f32) = (1.0, 100.0);

/// Something that the user asks for.
#[derive(Message, Clone, Debug)]
pub enum Action {
    /// Time runs or stands still.
    TogglePlay,
    /// One step, then time stands still.
    SingleStep,
    /// Wanted speed in My per second.
    SetSpeed(f64),
    /// Grow a new planet; the present one stays until that has succeeded.
    Grow(Box<PlanetRecipe>),
    /// Read a preset into the form.
    ReadPreset(PathBuf),
    /// Replace the planet by a saved one.
    Load(PathBuf),
    /// Save the planet at the next step boundary.
    Save(PathBuf),
    /// Save a picture of the window; without a path under the next free number.
    Screenshot(Option<PathBuf>),
    /// A command to the planet.
    Tectonic(TectonicCommand),
    /// Select a plate, or none.
    Select(Option<PlateId>),
}

/// The selected plate.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq)]
pub struct Selection(pub Option<PlateId>);

/// What a click on the globe does.
#[derive(Resource, Clone, Debug, Default, PartialEq)]
pub enum Tool {
    /// Selects a plate.
    #[default]
    Select,
    /// Adds a point to a rift line of this plate.
    RiftLine {
        /// The plate.
        plate: PlateId,
        /// Unit directions of the points so far.
        points: Vec<DVec3>,
    },
    /// Applies the brush.
    Paint,
}

/// How the globe is drawn.
#[derive(Resource, Clone, Debug, PartialEq)]
pub struct Look {
    /// What its colours mean.
    pub overlay: Overlay,
    /// Exaggeration of the relief.
    pub exaggeration: f32,
    /// Whether there is water.
    pub sea: bool,
    /// Whether plate boundaries are drawn.
    pub boundaries: bool,
    /// Whether the edges of the triangles are drawn.
    pub wireframe: bool,
    /// Whether there is air.
    pub air: bool,
    /// Whether the sun stays behind the viewer.
    pub sun_follows: bool,
}

impl Default for Look {
    fn default() -> Self {
        Self {
            overlay: Overlay::Elevation,
            exaggeration: 12.0,
            sea: true,
            boundaries: false,
            wireframe: false,
            air: true,
            sun_follows: true,
        }
    }
}

/// Where the pointer is.
#[derive(Resource, Clone, Copy, Debug, Default)]
pub struct Pointer {
    /// Whether it is over the free area between the panels, and not over anything that floats
    /// there.
    pub on_globe: bool,
    /// Unit direction of the ground under it, in the planet's coordinates.
    pub ground: Option<DVec3>,
}

/// Everything that panels read about the planet on show.
pub struct View<'a> {
    /// The planet's entity.
    pub entity: Entity,
    /// Radius and seed.
    pub planet: &'a Planet,
    /// Samples.
    pub mesh: &'a SphereMesh,
    /// The surface as it is now.
    pub surface: &'a Surface,
    /// The clock.
    pub clock: &'a GeologicClock,
    /// How time passes.
    pub controls: &'a ClockControls,
    /// Parameters.
    pub params: &'a TectonicParams,
    /// Milliseconds per stage.
    pub timings: &'a StageTimings,
    /// Plates in order of their numbers.
    pub plates: PlateTable,
    /// Climate and rivers, as they were when they were last made.
    pub bake: Option<&'a Bake>,
}

impl View<'_> {
    /// What overlays are computed from.
    pub fn overlay_input(&self) -> OverlayInput<'_> {
        OverlayInput {
            planet: self.planet,
            mesh: self.mesh,
            surface: self.surface,
            plates: &self.plates,
            params: self.params,
            bake: self.bake,
        }
    }
}

/// Reads the planet on show.
#[derive(SystemParam)]
pub struct PlanetReader<'w, 's> {
    session: Res<'w, Session>,
    planets: Query<
        'w,
        's,
        (
            &'static Planet,
            &'static Lattice,
            &'static PlanetSurface,
            (&'static GeologicClock, &'static ClockControls),
            &'static TectonicParams,
            &'static StageTimings,
            Option<&'static PlanetBake>,
        ),
    >,
    plates: Query<
        'w,
        's,
        (
            Entity,
            &'static PlateId,
            &'static PlateOf,
            &'static Plate,
            &'static PlateMotion,
            &'static PlateStats,
        ),
    >,
}

impl PlanetReader<'_, '_> {
    /// The planet on show; none before the first one has grown.
    pub fn view(&self) -> Option<View<'_>> {
        let entity = self.session.planet?;
        let (planet, lattice, surface, (clock, controls), params, timings, bake) =
            self.planets.get(entity).ok()?;
        if surface.is_empty() {
            return None;
        }
        let rows = self.plates.iter().filter(|(_, _, of, ..)| of.0 == entity);
        let plates = PlateTable::new(rows.map(|(entity, id, _, plate, motion, stats)| PlateRow {
            id: *id,
            entity,
            motion: *motion,
            stats: *stats,
            born: plate.born,
        }));
        let bake = bake.map(|bake| &*bake.0);
        Some(View {
            entity,
            planet,
            mesh: &lattice.0,
            surface,
            clock,
            controls,
            params,
            timings,
            plates,
            bake,
        })
    }
}

/// Does what concerns the planet's clock, commands and selection; the rest is the session's.
pub fn apply_actions(
    mut actions: MessageReader<Action>,
    mut commands: Commands,
    session: Res<Session>,
    mut controls: Query<&mut ClockControls>,
    mut selection: ResMut<Selection>,
) {
    for action in actions.read() {
        if let Action::Select(plate) = action {
            selection.0 = *plate;
            continue;
        }
        let Some(planet) = session.planet else {
            continue;
        };
        let Ok(mut controls) = controls.get_mut(planet) else {
            continue;
        };
        match action {
            Action::TogglePlay => {
                controls.paused = !controls.paused;
                controls.single_steps = 0;
            }
            Action::SingleStep => {
                controls.paused = true;
                controls.single_steps = (controls.single_steps + 1).min(20);
            }
            Action::SetSpeed(speed) => {
                controls.speed = speed.clamp(SPEED_LIMITS.0, SPEED_LIMITS.1);
            }
            Action::Tectonic(command) => {
                commands.entity(planet).tectonic(command.clone());
            }
            _ => {}
        }
    }
}

/// Gives the simulation its share of a frame: a few ms, or a quarter where drawing takes long
/// anyway.
pub fn share_frames(
    frames: Res<super::panels::timings::FrameTimes>,
    session: Res<Session>,
    mut controls: Query<&mut ClockControls>,
) {
    let Some(mut controls) = session
        .planet
        .and_then(|planet| controls.get_mut(planet).ok())
    else {
        return;
    };
    let ms = (0.25 * frames.mean()).clamp(8.0, 60.0);
    controls.frame_budget = Duration::from_secs_f64(ms * 1e-3);
}

/// Lets climate and rivers follow the planet while the globe shows them: they cost a core a quarter
/// of a second.
pub fn ask_for_bakes(
    look: Res<Look>,
    session: Res<Session>,
    planets: Query<Has<BakeSettings>>,
    mut commands: Commands,
) {
    let Some((planet, asked)) = session
        .planet
        .and_then(|planet| Some((planet, planets.get(planet).ok()?)))
    else {
        return;
    };
    match (look.overlay.needs_bake(), asked) {
        (true, false) => drop(commands.entity(planet).insert(BakeSettings::default())),
        (false, true) => drop(commands.entity(planet).remove::<BakeSettings>()),
        _ => {}
    }
}

/// Gives the globe the chosen look.
pub fn dress_globe(
    look: Res<Look>,
    selection: Res<Selection>,
    session: Res<Session>,
    camera: Query<&GlobalTransform, With<super::camera::OrbitCamera>>,
    mut globes: Query<&mut Globe>,
) {
    let Some(mut globe) = session
        .planet
        .and_then(|planet| globes.get_mut(planet).ok())
    else {
        return;
    };
    let mut wanted = globe.clone();
    wanted.overlay = look.overlay;
    wanted.exaggeration = look.exaggeration;
    wanted.sea = look.sea;
    wanted.boundaries = look.boundaries;
    wanted.wireframe = look.wireframe;
    wanted.selected = selection.0;
    wanted.air = if look.air { 1.0 } else { 0.0 };
    if let (true, Ok(camera)) = (look.sun_follows, camera.single()) {
        let sun = camera.back() * 0.75 + camera.up() * 0.45 - camera.right() * 0.55;
        wanted.sun = bevy_pangaea::render::from_bevy(sun).normalize();
    }
    globe.set_if_neq(wanted);
}

/// Drops the selection and the rift line of a plate that is gone.
pub fn forget_lost_plates(
    reader: PlanetReader,
    mut selection: ResMut<Selection>,
    mut tool: ResMut<Tool>,
) {
    let exists = |id: PlateId| {
        reader
            .view()
            .is_some_and(|view| view.plates.get(id).is_some())
    };
    if selection.0.is_some_and(|id| !exists(id)) {
        selection.0 = None;
    }
    if let Tool::RiftLine { plate, .. } = *tool
        && selection.0 != Some(plate)
    {
        *tool = Tool::Select;
    }
}
