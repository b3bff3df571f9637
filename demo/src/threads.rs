//! The threads of all parallel loops, started before anything runs in parallel: whether there are
//! enough is found out while there is something to say about it.

use crate::error::CliError;
use bevy::app::TaskPoolOptions;
use std::panic;

/// Starts so many threads, or one per core.
///
/// # Errors
/// If the system does not give as many.
pub fn start(threads: Option<usize>) -> Result<(), CliError> {
    let builder = rayon::ThreadPoolBuilder::new().num_threads(threads.unwrap_or(0));
    builder.build_global().map_err(|error| {
        let count = threads.map_or("one per core".into(), |count| count.to_string());
        CliError::Failed(format!("cannot start threads ({count}): {error}"))
    })?;
    start_task_pools()
}

/// Starts the pools of Bevy, which panics where it cannot.
fn start_task_pools() -> Result<(), CliError> {
    let usual = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    let started = panic::catch_unwind(|| TaskPoolOptions::default().create_default_pools());
    panic::set_hook(usual);
    started.map_err(|_| CliError::Failed("cannot start the threads of tasks".into()))
}
