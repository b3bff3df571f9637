//! Whether there is a GPU to draw with.
//!
//! Bevy's renderer panics where it finds none. A program that would rather tell its user asks
//! here first, and hands what it gets to [`RenderPlugin`](bevy::render::RenderPlugin), so nothing
//! is opened twice.

use bevy::render::renderer::initialize_renderer;
use bevy::render::settings::{RenderCreation, WgpuSettings};
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use thiserror::Error;

/// No adapter was found, or it would not open.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("no GPU adapter: {reason}; {CURE}")]
pub struct NoAdapter {
    /// The renderer's own words.
    pub reason: String,
}

/// Advice to users of a machine without an adapter.
pub const CURE: &str = if cfg!(target_os = "linux") {
    "install a Vulkan driver; on Debian and Ubuntu: apt-get install mesa-vulkan-drivers libvulkan1 \
     (its lavapipe draws without a GPU)"
} else {
    "install the driver of the graphics card"
};

/// Opens the adapter that Bevy would open, without a window.
///
/// # Errors
/// As [`open_adapter_with`].
pub fn open_adapter() -> Result<RenderCreation, NoAdapter> {
    open_adapter_with(&WgpuSettings::default())
}

/// The same with features and limits of one's own.
///
/// Panics of the renderer are caught, and not printed while this runs: call it before other threads
/// are busy.
///
/// # Errors
/// [`NoAdapter`], which names the reason and the cure.
pub fn open_adapter_with(settings: &WgpuSettings) -> Result<RenderCreation, NoAdapter> {
    let Some(backends) = settings.backends else {
        return Err(NoAdapter {
            reason: "all backends are switched off".into(),
        });
    };
    let hook = take_hook();
    set_hook(Box::new(|_| {}));
    let opened = catch_unwind(AssertUnwindSafe(|| {
        bevy::tasks::block_on(initialize_renderer(backends, None, settings))
    }));
    set_hook(hook);
    match opened {
        Ok(resources) => Ok(RenderCreation::Manual(resources)),
        Err(panic) => Err(NoAdapter {
            reason: first_sentence(&*panic).into(),
        }),
    }
}

/// The first sentence of a panic's message.
fn first_sentence(panic: &(dyn Any + Send)) -> &str {
    let owned = panic.downcast_ref::<String>().map(String::as_str);
    let text = owned
        .or_else(|| panic.downcast_ref::<&str>().copied())
        .unwrap_or("it would not open");
    text.split(['!', '\n']).next().unwrap_or(text).trim()
}
