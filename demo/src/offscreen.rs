//! Pictures without a window: one app, one camera, one image in memory.
//!
//! The app is updated frame by frame until the globe shows the planet as it is; then the image is
//! read back.

use crate::interrupt;
use bevy::app::{PluginsState, TerminalCtrlCHandlerPlugin};
use bevy::camera::RenderTarget;
use bevy::core_pipeline::tonemapping::Tonemapping;
use bevy::image::Image;
use bevy::log::{Level, LogPlugin};
use bevy::prelude::*;
use bevy::render::pipelined_rendering::PipelinedRenderingPlugin;
use bevy::render::render_resource::{PollType, TextureFormat, TextureUsages};
use bevy::render::renderer::RenderDevice;
use bevy::render::settings::RenderCreation;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured};
use bevy::render::{RenderApp, RenderPlugin};
use bevy::window::ExitCondition;
use bevy::winit::WinitPlugin;
use bevy_pangaea::amplification::PangaeaGroundPlugin;
use bevy_pangaea::control::bake_now;
use bevy_pangaea::crust::PlanetSurface;
use bevy_pangaea::overlay::{Overlay, Raster};
use bevy_pangaea::render::adapter::{NoAdapter, open_adapter};
use bevy_pangaea::render::{Globe, GlobeDrawn, PangaeaRenderPlugin};
use bevy_pangaea::resample::project_now;
use bevy_pangaea::spawn::PlanetState;
use std::time::{Duration, Instant};
use thiserror::Error;

/// Vertical field of view in radians.
pub const FIELD_OF_VIEW: f32 = 0.7;

/// Frames that run before the image is read: meshes and pipelines are made in the first ones.
const WARM_UP_FRAMES: usize = 4;

/// Longest wait for a picture; two million samples on one core of a slow machine need a fraction of
/// it.
const LONGEST_WAIT: Duration = Duration::from_secs(240);

/// Why there is no picture.
#[derive(Debug, Error)]
pub enum OffscreenError {
    /// There is nothing to draw with.
    #[error(transparent)]
    NoAdapter(#[from] NoAdapter),
    /// The size is refused.
    #[error("a picture of {0}x{1} pixels is outside of 16x16..=8192x8192")]
    Size(u32, u32),
    /// The planet cannot have the climate and rivers that the overlay shows.
    #[error("the planet cannot be shown so: {0}")]
    Planet(String),
    /// The renderer stopped.
    #[error("the renderer stopped: {0}")]
    Renderer(String),
    /// The user interrupted it.
    #[error("interrupted")]
    Interrupted,
}

/// An app that draws one planet into an image.
pub struct Offscreen {
    app: App,
    camera: Entity,
    target: Handle<Image>,
    planet: Option<Entity>,
}

/// The image that was read back.
#[derive(Resource, Default)]
struct Captured(Option<Image>);

impl Offscreen {
    /// An app with an image of `width` by `height` pixels.
    ///
    /// # Errors
    /// [`OffscreenError::NoAdapter`] names the reason and the cure; [`OffscreenError::Size`].
    pub fn new((width, height): (u32, u32)) -> Result<Self, OffscreenError> {
        let fits = 16..=8192;
        if !(fits.contains(&width) && fits.contains(&height)) {
            return Err(OffscreenError::Size(width, height));
        }
        let mut app = windowless_app(open_adapter()?);
        let mut images = app.world_mut().resource_mut::<Assets<Image>>();
        let target = images.add(target_image(width, height));
        let camera = (
            Camera3d::default(),
            Tonemapping::None,
            RenderTarget::Image(target.clone().into()),
        );
        let camera = app.world_mut().spawn(camera).id();
        Ok(Self {
            app,
            camera,
            target,
            planet: None,
        })
    }

    /// Draws this planet from now on.
    pub fn show(&mut self, state: PlanetState) {
        let world = self.app.world_mut();
        if let Some(old) = self.planet.take() {
            world.despawn(old);
        }
        self.planet = Some(state.spawn(world));
    }

    /// The planet as the camera at `view` sees it.
    ///
    /// # Errors
    /// [`OffscreenError::Renderer`] if the renderer stopped, or did not answer in minutes;
    /// [`OffscreenError::Interrupted`]; [`OffscreenError::Planet`] if the overlay needs what the
    /// planet does not have.
    pub fn picture(&mut self, view: Transform, globe: Globe) -> Result<Raster, OffscreenError> {
        let planet = self.planet()?;
        let overlay = globe.overlay;
        let world = self.app.world_mut();
        world
            .entity_mut(self.camera)
            .insert((view, projection_from(&view)));
        world.entity_mut(planet).insert(globe);
        if overlay.needs_bake() {
            self.bake(planet)?;
        }
        self.run(|world| Ok(is_drawn(world, planet, overlay)))?;
        self.read_back()
    }

    /// The planet that is on show.
    ///
    /// # Errors
    /// [`OffscreenError::Renderer`] if there is none.
    pub fn planet(&self) -> Result<Entity, OffscreenError> {
        let none = || OffscreenError::Renderer("there is no planet".into());
        self.planet.ok_or_else(none)
    }

    /// The app's world.
    pub fn world(&mut self) -> &mut World {
        self.app.world_mut()
    }

    /// Gives a planet its climate and its rivers.
    ///
    /// # Errors
    /// [`OffscreenError::Planet`] if it cannot have them.
    pub fn bake(&mut self, planet: Entity) -> Result<(), OffscreenError> {
        let world = self.app.world_mut();
        project_now(world, planet);
        bake_now(world, planet).map_err(|error| OffscreenError::Planet(error.to_string()))
    }

    /// Puts the camera at `view`, with a component of its own; returns it.
    pub fn look(&mut self, view: Transform, with: impl Bundle) -> Entity {
        let parts = (view, projection_from(&view), with);
        self.app.world_mut().entity_mut(self.camera).insert(parts);
        self.camera
    }

    /// Runs frames until something holds, and a few more.
    ///
    /// # Errors
    /// Those of `done`; [`OffscreenError::Renderer`], [`OffscreenError::Interrupted`].
    pub fn run(
        &mut self,
        done: impl Fn(&World) -> Result<bool, OffscreenError>,
    ) -> Result<(), OffscreenError> {
        self.run_until(Instant::now() + LONGEST_WAIT, done)?;
        for _ in 0..WARM_UP_FRAMES {
            self.frame()?;
        }
        Ok(())
    }

    /// The image as it is after the next frames.
    ///
    /// # Errors
    /// [`OffscreenError::Renderer`], [`OffscreenError::Interrupted`].
    pub fn read_back(&mut self) -> Result<Raster, OffscreenError> {
        let deadline = Instant::now() + LONGEST_WAIT;
        self.app
            .world_mut()
            .spawn(Screenshot::image(self.target.clone()))
            .observe(keep_image);
        let captured = |world: &World| Ok(world.resource::<Captured>().0.is_some());
        self.run_until(deadline, captured)?;
        let image = self.app.world_mut().resource_mut::<Captured>().0.take();
        image
            .and_then(raster)
            .ok_or_else(|| OffscreenError::Renderer("the image is empty".into()))
    }

    fn run_until(
        &mut self,
        deadline: Instant,
        done: impl Fn(&World) -> Result<bool, OffscreenError>,
    ) -> Result<(), OffscreenError> {
        while !done(self.app.world())? {
            if interrupt::check().is_err() {
                return Err(OffscreenError::Interrupted);
            }
            if Instant::now() > deadline {
                return Err(OffscreenError::Renderer("it did not answer".into()));
            }
            self.frame()?;
        }
        Ok(())
    }

    fn frame(&mut self) -> Result<(), OffscreenError> {
        self.app.update();
        if let Some(exit) = self.app.should_exit() {
            return Err(OffscreenError::Renderer(format!("{exit:?}")));
        }
        // Screenshots arrive when the device has been polled.
        if let Some(render) = self.app.get_sub_app(RenderApp)
            && let Some(device) = render.world().get_resource::<RenderDevice>()
        {
            device
                .poll(PollType::wait_indefinitely())
                .map_err(|error| OffscreenError::Renderer(error.to_string()))?;
        }
        Ok(())
    }
}

/// Bevy with a renderer and no window, and the globe.
fn windowless_app(adapter: RenderCreation) -> App {
    let renderer = RenderPlugin {
        render_creation: adapter,
        synchronous_pipeline_compilation: true,
        ..default()
    };
    let window = WindowPlugin {
        primary_window: None,
        exit_condition: ExitCondition::DontExit,
        ..default()
    };
    let log = LogPlugin {
        level: Level::ERROR,
        filter: "error".into(),
        ..default()
    };
    // Signals are noted by `interrupt`.
    // One frame is rendered per update, so that `run_until` sees what it waits for.
    let plugins = DefaultPlugins
        .set(window)
        .set(renderer)
        .set(log)
        .disable::<TerminalCtrlCHandlerPlugin>()
        .disable::<WinitPlugin>()
        .disable::<PipelinedRenderingPlugin>();
    let mut app = App::new();
    app.add_plugins((plugins, PangaeaRenderPlugin, PangaeaGroundPlugin))
        .init_resource::<Captured>()
        .insert_resource(ClearColor(Color::srgb_u8(3, 4, 8)));
    // The renderer opens its device on a task, which nobody else runs before the app does.
    while app.plugins_state() == PluginsState::Adding {
        bevy::tasks::tick_global_task_pools_on_main_thread();
    }
    app.finish();
    app.cleanup();
    app
}

/// An image that a camera can draw into and that can be read back.
fn target_image(width: u32, height: u32) -> Image {
    let mut image = Image::new_target_texture(width, height, TextureFormat::Rgba8UnormSrgb, None);
    image.texture_descriptor.usage |= TextureUsages::COPY_SRC;
    image
}

/// The perspective of a camera at `view`. Its near plane comes nearer where the ground does.
fn projection_from(view: &Transform) -> Projection {
    let near = 0.05 * (view.translation.length() - 1.0).max(1e-5);
    Projection::Perspective(PerspectiveProjection {
        fov: FIELD_OF_VIEW,
        near: near.min(0.1),
        ..default()
    })
}

/// Whether the globe shows the present surface of the planet in this overlay.
fn is_drawn(world: &World, planet: Entity, overlay: Overlay) -> bool {
    let surface = world.get::<PlanetSurface>(planet);
    let version = surface.map(|surface| surface.version);
    let drawn = world.get::<GlobeDrawn>(planet);
    drawn.is_some_and(|drawn| Some(drawn.version) == version && drawn.overlay == overlay)
}

fn keep_image(shot: On<ScreenshotCaptured>, mut captured: ResMut<Captured>) {
    captured.0 = Some(shot.image.clone());
}

/// The colours of an image without its opacity.
fn raster(image: Image) -> Option<Raster> {
    let (width, height) = (image.width(), image.height());
    let rgba = image.data?;
    let rgb: Vec<u8> = rgba
        .as_chunks::<4>()
        .0
        .iter()
        .flat_map(|&[r, g, b, _]| [r, g, b])
        .collect();
    (rgb.len() == 3 * width as usize * height as usize).then_some(Raster { width, height, rgb })
}
