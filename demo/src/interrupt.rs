//! Ctrl-C: long commands look for it where they can stop, and leave nothing half done.

use crate::error::CliError;
use std::sync::atomic::{AtomicBool, Ordering};

static INTERRUPT_ASKED: AtomicBool = AtomicBool::new(false);

/// From now on an interrupt is only noted, for [`check`] to find; a second one ends the program at
/// once.
///
/// Where that cannot be arranged, an interrupt ends the program as it always did.
pub fn watch() {
    let _ = ctrlc::set_handler(|| {
        if INTERRUPT_ASKED.swap(true, Ordering::Relaxed) {
            std::process::exit(CliError::INTERRUPTED.into());
        }
    });
}

/// Whether the command may go on.
///
/// # Errors
/// [`CliError::Interrupted`] after an interrupt.
pub fn check() -> Result<(), CliError> {
    if INTERRUPT_ASKED.load(Ordering::Relaxed) {
        Err(CliError::Interrupted)
    } else {
        Ok(())
    }
}
