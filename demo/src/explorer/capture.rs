//! Pictures of the window, written in the background; and the run of a fixed number of frames that
//! tests use.

use super::messages::MessageLog;
use super::session::Session;
use super::state::{Action, ShownPlanet};
use bevy::prelude::*;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured};
use bevy::tasks::futures::check_ready;
use bevy::tasks::{IoTaskPool, Task};
use bevy_pangaea::io;
use std::path::{Path, PathBuf};

/// Pictures that are being taken and written.
#[derive(Resource, Default)]
pub struct Pictures {
    /// Pictures that the renderer has not delivered yet.
    pending: usize,
    /// Pictures that are being written; each becomes its path.
    tasks: Vec<Task<Result<PathBuf, String>>>,
    /// Whether one could not be written.
    failed: bool,
}

impl Pictures {
    /// Writes a picture that was taken.
    fn write(&mut self, image: Image, path: PathBuf) {
        self.pending = self.pending.saturating_sub(1);
        self.tasks.push(IoTaskPool::get().spawn(async move {
            write_png(image, &path)?;
            Ok(path)
        }));
    }

    fn is_idle(&self) -> bool {
        self.pending == 0 && self.tasks.is_empty()
    }
}

/// Shows a number of frames of the planet, takes a picture, and ends the program.
#[derive(Resource, Clone, Debug)]
pub struct FixedRun {
    /// Frames left until the picture.
    frames: u32,
    /// Where the picture goes, until it is asked for.
    capture: Option<PathBuf>,
    /// Whether a picture was asked for.
    asked: bool,
}

impl FixedRun {
    /// A run of `frames` frames.
    pub fn new(frames: u32, capture: Option<PathBuf>) -> Self {
        Self {
            frames,
            capture,
            asked: false,
        }
    }
}

/// Takes pictures that were asked for.
pub fn take_pictures(
    mut actions: MessageReader<Action>,
    mut commands: Commands,
    mut pictures: ResMut<Pictures>,
) {
    for action in actions.read() {
        let Action::Screenshot(path) = action else {
            continue;
        };
        let path = path.clone().unwrap_or_else(free_name);
        pictures.pending += 1;
        commands.spawn(Screenshot::primary_window()).observe(
            move |event: On<ScreenshotCaptured>, mut pictures: ResMut<Pictures>| {
                pictures.write(event.image.clone(), path.clone());
            },
        );
    }
}

/// Says how the pictures went.
pub fn finish_pictures(mut pictures: ResMut<Pictures>, mut messages: ResMut<MessageLog>) {
    let Pictures { tasks, failed, .. } = &mut *pictures;
    tasks.retain_mut(|task| match check_ready(task) {
        None => true,
        Some(Ok(path)) => {
            messages.note(format!("picture saved as {}", path.display()));
            false
        }
        Some(Err(error)) => {
            messages.error(error);
            *failed = true;
            false
        }
    });
}

/// Counts the frames of a fixed run.
pub fn count_frames(
    run: Option<ResMut<FixedRun>>,
    shown: Res<ShownPlanet>,
    session: Res<Session>,
    pictures: Res<Pictures>,
    mut actions: MessageWriter<Action>,
    mut exit: MessageWriter<AppExit>,
) {
    let Some(mut run) = run else { return };
    // The frames of a run count from the first one with a planet.
    if shown.0.is_none() {
        if !session.is_growing() {
            exit.write(AppExit::error());
        }
    } else if run.frames > 0 {
        run.frames -= 1;
    } else if let Some(path) = run.capture.take() {
        actions.write(Action::Screenshot(Some(path)));
        run.asked = true;
    } else if !run.asked || pictures.is_idle() {
        exit.write(if pictures.failed {
            AppExit::error()
        } else {
            AppExit::Success
        });
    }
}

/// `pangaea-001.png`, or the next number that is free in the working directory.
fn free_name() -> PathBuf {
    (1..10_000)
        .map(|i| PathBuf::from(format!("pangaea-{i:03}.png")))
        .find(|path| !path.exists())
        .unwrap_or_else(|| "pangaea.png".into())
}

fn write_png(image: Image, path: &Path) -> Result<(), String> {
    let rgb = image
        .try_into_dynamic()
        .map_err(|error| error.to_string())?
        .to_rgb8();
    let (width, height) = rgb.dimensions();
    io::write_atomically(path, |out| {
        let mut encoder = png::Encoder::new(out, width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(rgb.as_raw())?;
        Ok(writer.finish()?)
    })
    .map_err(|error| error.to_string())
}
