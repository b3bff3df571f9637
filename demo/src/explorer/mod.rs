//! The explorer: a window with a planet to watch, to take by the hand and to save.
//!
//! ```text
//! background  long work on threads of its own
//! camera      orbit camera, and the viewport between the panels
//! session     growing, loading and saving planets in the background
//! discard     the question before a planet that is not saved goes
//! state       actions, selection, look; what panels read
//! select      the ground under the pointer, and clicks on it
//! keys        the keyboard
//! marks       poles, rift line and brush on the globe
//! messages    the log
//! capture     pictures
//! layout      where the panels stand
//! panels/     the panels
//! style       colours and small widgets
//! text        numbers for people
//! ```

mod background;

mod camera;

mod capture;

mod discard;

mod keys;

mod layout;

mod marks;

mod messages;

mod panels;

mod select;

mod session;

mod state;

mod style;

mod text;

use bevy::app::PanicHandlerPlugin;
use bevy::asset::AssetPlugin;
use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::settings::RenderCreation;
use bevy::window::{PresentMode, WindowResizeConstraints, WindowResolution};
use bevy_egui::{EguiPlugin, EguiPrimaryContextPass};
use bevy_pangaea::PangaeaPlugins;
use bevy_pangaea::prelude::*;
use bevy_pangaea::render::PangaeaRenderPlugin;
use bevy_pangaea::render::adapter::open_adapter;
use bevy_pangaea::spawn::PlanetState;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::path::PathBuf;

/// How the explorer starts.
pub struct Options {
    /// The first planet.
    pub recipe: PlanetRecipe,
    /// A planet to begin with instead, and the save that it comes from.
    pub open: Option<(Box<PlanetState>, PathBuf)>,
    /// Ends after this many frames of the planet.
    pub frames: Option<u32>,
    /// Where a picture of the last of those frames goes.
    pub capture: Option<PathBuf>,
}

/// Whether the page of keys is open.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq)]
struct HelpPage(bool);

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
    build(&mut app, options);
    match app.run() {
        AppExit::Success => Ok(()),
        AppExit::Error(_) => Err("the explorer ended with an error".into()),
    }
}

/// An app with a window. Winit panics where the display cannot be reached; that becomes an error
/// here.
fn open_window(adapter: RenderCreation) -> Result<App, String> {
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
    opened.map_err(|panic| {
        let text = panic.downcast_ref::<String>().map(String::as_str);
        let text = text
            .or_else(|| panic.downcast_ref::<&str>().copied())
            .unwrap_or("no reason given");
        if text.contains("event loop") {
            let display = std::env::var("DISPLAY").unwrap_or_default();
            return format!("no window can be opened: the display {display} does not answer");
        }
        format!(
            "no window can be opened: {}",
            text.lines().next().unwrap_or(text)
        )
    })
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
    match options.open {
        Some((planet, path)) => session::begin_with(app, planet, path),
        None => {
            let grow = state::Action::Grow(Box::new(options.recipe.clone()));
            app.add_systems(Startup, move |mut actions: MessageWriter<state::Action>| {
                actions.write(grow.clone());
            });
        }
    }
    if let Some(frames) = options.frames {
        app.insert_resource(capture::FixedRun::new(frames, options.capture));
    }
    app.insert_resource(ClearColor(Color::srgb(0.016, 0.02, 0.031)))
        .insert_resource(panels::planet::PlanetForm::new(options.recipe))
        .init_resource::<session::Session>()
        .init_resource::<state::Selection>()
        .init_resource::<state::Tool>()
        .init_resource::<state::Look>()
        .init_resource::<state::Pointer>()
        .init_resource::<camera::FreeArea>()
        .init_resource::<capture::Pictures>()
        .init_resource::<panels::plate::PlateForm>()
        .init_resource::<panels::paint::PaintForm>()
        .init_resource::<panels::legend::LegendCache>()
        .init_resource::<panels::timings::FrameTimes>()
        .init_resource::<HelpPage>()
        .init_gizmo_group::<marks::MarkGizmos>()
        .add_message::<state::Action>()
        .add_plugins(messages::plugin)
        .add_systems(Startup, (camera::spawn_cameras, marks::configure))
        .add_systems(EguiPrimaryContextPass, layout::draw);
    add_update_systems(app);
}

fn add_update_systems(app: &mut App) {
    app.add_systems(
        PreUpdate,
        (select::find_ground, select::click, keys::read)
            .chain()
            .after(bevy_egui::EguiPreUpdateSet::BeginPass),
    )
    .add_systems(
        Update,
        (
            panels::timings::watch,
            state::apply_actions,
            state::share_frames,
            session::start_jobs,
            session::finish_jobs,
            session::save_at_boundary,
            session::finish_save,
            capture::count_frames,
            capture::take_pictures,
            capture::finish_pictures,
            state::forget_lost_plates,
            camera::steer,
            state::dress_globe,
            state::ask_for_bakes,
            marks::draw,
        )
            .chain(),
    )
    .add_systems(
        PostUpdate,
        camera::fit_viewport.before(bevy::camera::CameraUpdateSystems),
    );
}

/// A window needs a display server; winit panics where there is none.
fn has_display() -> Result<(), String> {
    let set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    if cfg!(target_os = "linux") && !set("DISPLAY") {
        return Err(
            "no display: DISPLAY is not set; the commands of pangaea --help need none".into(),
        );
    }
    Ok(())
}
