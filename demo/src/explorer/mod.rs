//! The explorer: a window with a planet to watch, to act upon and to save.
//!
//! ```text
//! background  long work on threads of its own
//! text        numbers for people
//! style       colours, spacing and frames
//! widgets     the small widgets of all panels
//! state       shared types: actions, selection, tool, look, pointer
//! view        the planet on show, as panels and marks read it
//! messages    the log; event_log writes events of the planet into it
//! actions     the clock of the planet, its plates and the selection
//! discard     the question before a planet that is not saved goes
//! saving      files that are to be written of the planet
//! session     growing, loading and saving planets in the background
//! capture     pictures of the window
//! orbit       the geometry of a camera that circles the globe
//! flight      the geometry of one that flies over the ground
//! camera      the cameras, and the viewport between the panels
//! drag        plates dragged by the pointer
//! panels/     the panels
//! globe       the look of the globe, its share of a frame
//! land        the ground under a flight, drawn instead of the globe
//! select      the ground under the pointer, and clicks on it
//! keys        the keyboard
//! marks       poles, drags, rift line and brush on the globe
//! layout      where the panels stand
//! ```

mod background;

mod text;

mod style;

mod widgets;

mod state;

mod view;

mod messages;

mod actions;

mod event_log;

mod discard;

mod saving;

mod session;

mod capture;

mod orbit;

mod flight;

mod camera;

mod drag;

mod panels;

mod globe;

mod land;

mod select;

mod keys;

mod marks;

mod layout;

use bevy::app::PanicHandlerPlugin;
use bevy::asset::AssetPlugin;
use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::settings::RenderCreation;
use bevy::window::{PresentMode, WindowResizeConstraints, WindowResolution};
use bevy_egui::{EguiPlugin, EguiPrimaryContextPass};
use bevy_pangaea::PangaeaPlugins;
use bevy_pangaea::amplification::PangaeaGroundPlugin;
use bevy_pangaea::prelude::*;
use bevy_pangaea::render::PangaeaRenderPlugin;
use bevy_pangaea::render::adapter::open_adapter;
use bevy_pangaea::spawn::PlanetState;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::path::PathBuf;

/// How the explorer starts.
pub struct Options {
    /// The first planet.
    pub recipe: PlanetRecipe,
    /// A planet to open instead, and the save that it comes from.
    pub open: Option<(Box<PlanetState>, PathBuf)>,
    /// Ends after this many frames of the planet.
    pub frames: Option<u32>,
    /// Where a picture of the last of those frames goes.
    pub capture: Option<PathBuf>,
}

/// Opens the window and returns when it is closed.
///
/// # Errors
/// One line that says why no window can be opened, and what to do about it.
pub fn run(options: Options) -> Result<(), String> {
    has_display()?;
    let adapter = open_adapter().map_err(|error| error.to_string())?;
    let mut app = open_window(adapter)?;
    if !app.is_plugin_added::<PangaeaRenderPlugin>() {
        app.add_plugins(PangaeaRenderPlugin);
    }
    app.add_plugins(PangaeaGroundPlugin);
    build(&mut app, options);
    match app.run() {
        AppExit::Success => Ok(()),
        AppExit::Error(_) => Err("the explorer ended with an error".into()),
    }
}

/// An app with a window. Winit panics where the display cannot be reached; that becomes an error
/// here.
fn open_window(adapter: RenderCreation) -> Result<App, String> {
    // The panic is told by the error, not by a backtrace.
    let hook = take_hook();
    set_hook(Box::new(|_| {}));
    let opened = catch_unwind(AssertUnwindSafe(|| {
        let mut app = App::new();
        app.add_plugins((
            default_plugins(adapter),
            EguiPlugin::default(),
            PangaeaPlugins,
        ));
        app
    }));
    set_hook(hook);
    opened.map_err(|panic| refusal(&*panic))
}

/// Why no window can be opened, by the panic that said so.
fn refusal(panic: &(dyn Any + Send)) -> String {
    let text = panic
        .downcast_ref::<String>()
        .map(String::as_str)
        .or_else(|| panic.downcast_ref::<&str>().copied())
        .unwrap_or("no reason given");
    if text.contains("event loop") {
        let display = std::env::var("DISPLAY").unwrap_or_default();
        return format!("no window can be opened: the display {display} does not answer");
    }
    let first_line = text.lines().next().unwrap_or(text);
    format!("no window can be opened: {first_line}")
}

fn default_plugins(adapter: RenderCreation) -> impl PluginGroup {
    let window = Window {
        title: "Pangaea".into(),
        name: Some("pangaea".into()),
        resolution: WindowResolution::new(1280, 720),
        present_mode: PresentMode::AutoVsync,
        resize_constraints: WindowResizeConstraints {
            min_width: 800.0,
            min_height: 480.0,
            ..default()
        },
        ..default()
    };
    DefaultPlugins
        .set(WindowPlugin {
            primary_window: Some(window),
            ..default()
        })
        .set(RenderPlugin {
            render_creation: adapter,
            ..default()
        })
        .set(AssetPlugin {
            watch_for_changes_override: Some(false),
            ..default()
        })
        // It would print the panics that `open_window` turns into errors.
        .disable::<PanicHandlerPlugin>()
}

/// The explorer itself, on top of Bevy, egui and the planet.
fn build(app: &mut App, options: Options) {
    begin(app, &options.recipe, options.open);
    if let Some(frames) = options.frames {
        app.insert_resource(capture::FixedRun::new(frames, options.capture));
    }
    app.insert_resource(ClearColor(globe::sky(None)))
        .insert_resource(panels::planet::PlanetForm::new(options.recipe))
        .init_gizmo_group::<marks::MarkGizmos>()
        .add_message::<state::Action>()
        .add_message::<state::PresetRead>()
        .add_plugins(event_log::plugin);
    add_state(app);
    app.add_systems(Startup, (camera::spawn_cameras, marks::configure))
        .add_systems(
            PreUpdate,
            (
                select::find_ground,
                drag::drag_plates,
                select::click,
                keys::read,
            )
                .chain()
                .after(bevy_egui::EguiPreUpdateSet::BeginPass),
        )
        .add_systems(EguiPrimaryContextPass, layout::draw)
        .add_systems(
            PostUpdate,
            camera::fit_viewport.before(bevy::camera::CameraUpdateSystems),
        );
    add_update_systems(app);
}

/// Opens the planet of a save, or grows one.
fn begin(app: &mut App, recipe: &PlanetRecipe, open: Option<(Box<PlanetState>, PathBuf)>) {
    if let Some((planet, path)) = open {
        session::begin_with(app, planet, path);
        return;
    }
    let grow = state::Action::Grow(Box::new(recipe.clone()));
    app.add_systems(Startup, move |mut actions: MessageWriter<state::Action>| {
        actions.write(grow.clone());
    });
}

fn add_state(app: &mut App) {
    app.init_resource::<session::Session>()
        .init_resource::<state::ShownPlanet>()
        .init_resource::<state::Selection>()
        .init_resource::<state::Tool>()
        .init_resource::<state::PlateDrag>()
        .init_resource::<state::Look>()
        .init_resource::<state::Pointer>()
        .init_resource::<state::HelpPage>()
        .init_resource::<view::ShownPlates>()
        .init_resource::<land::LandBelow>()
        .init_resource::<camera::FreeArea>()
        .init_resource::<capture::Pictures>()
        .init_resource::<panels::plate::PlateForm>()
        .init_resource::<panels::paint::PaintForm>()
        .init_resource::<panels::legend::LegendCache>()
        .init_resource::<panels::timings::FrameTimes>();
}

/// Wishes are carried out first, then the plates of the planet are listed for all that read
/// them.
fn add_update_systems(app: &mut App) {
    let ask_and_do = (
        panels::timings::watch,
        actions::apply,
        globe::set_frame_budget,
        session::start_jobs,
        session::finish_jobs,
        session::save_at_boundary,
        session::finish_save,
        panels::planet::take_preset,
        capture::count_frames,
        capture::take_pictures,
        capture::finish_pictures,
    );
    let show = (
        view::list_plates,
        actions::forget_lost_plates,
        land::prepare,
        camera::steer,
        land::see,
        land::hide_globe,
        land::tell,
        globe::set_look,
        globe::request_bakes,
        marks::draw,
    );
    app.add_systems(Update, (ask_and_do.chain(), show.chain()).chain());
}

/// Refuses to go on without a display server: winit would panic.
fn has_display() -> Result<(), String> {
    let display = std::env::var_os("DISPLAY").unwrap_or_default();
    if cfg!(target_os = "linux") && display.is_empty() {
        return Err(
            "no display: DISPLAY is not set; the commands of pangaea --help need none".into(),
        );
    }
    Ok(())
}
