//! Pictures of the window, written in the background; and the run of a fixed number of frames that
//! tests use.

use super::messages::Messages;
use super::session::Session;
use super::state::Action;
use bevy::prelude::*;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured};
use bevy::tasks::futures::check_ready;
use bevy::tasks::{IoTaskPool, Task};
use bevy_pangaea::io;
use std::path::{Path, PathBuf};

/// Pictures that are being written.
#[derive(Resource, Default)]
pub struct Pictures {
    pending: usize,
    tasks: Vec<Task<Result<PathBuf, String>>>,
    failed: bool,
}

/// Shows a number of frames of the planet, takes a picture, and ends the program.
#[derive(Resource, Clone, Debug)]
pub struct FixedRun {
    /// Frames left until the picture.
    pub frames: u32,
    /// Where the picture goes, if one is wanted.
    pub capture: Option<PathBuf>,
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
                let (image, path) = (event.image.clone(), path.clone());
                let task = IoTaskPool::get().spawn(async move {
                    write_png(image, &path)?;
                    Ok(path)
                });
                pictures.pending = pictures.pending.saturating_sub(1);
                pictures.tasks.push(task);
            },
        );
    }
}

/// Says how the pictures went.
pub fn finish_pictures(mut pictures: ResMut<Pictures>, mut messages: ResMut<Messages>) {
    let mut failed = false;
    pictures.tasks.retain_mut(|task| match check_ready(task) {
        None => true,
        Some(Ok(path)) => {
            messages.note(format!("picture saved as {}", path.display()));
            false
        }
        Some(Err(error)) => {
            messages.error(error);
            failed = true;
            false
        }
    });
    pictures.failed |= failed;
}

/// Counts the frames of a fixed run.
pub fn count_frames(
    run: Option<ResMut<FixedRun>>,
    session: Res<Session>,
    pictures: Res<Pictures>,
    mut actions: MessageWriter<Action>,
    mut exit: MessageWriter<AppExit>,
) {
    let Some(mut run) = run else { return };
    if session.planet.is_none() && session.is_growing() {
        return;
    }
    if session.planet.is_none() {
        exit.write(AppExit::error());
    } else if run.frames > 0 {
        run.frames -= 1;
    } else if !run.asked && run.capture.is_some() {
        run.asked = true;
        actions.write(Action::Screenshot(run.capture.clone()));
    } else if run.capture.is_none() || idle_after(&run, &pictures) {
        exit.write(if pictures.failed {
            AppExit::error()
        } else {
            AppExit::Success
        });
    }
}

fn idle_after(run: &FixedRun, pictures: &Pictures) -> bool {
    run.asked && pictures.pending == 0 && pictures.tasks.is_empty() && run.frames == 0
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
