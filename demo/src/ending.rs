//! The end of a program that cannot go on: where memory is full, and where a signal finds it in work
//! that does not look for signals.
//!
//! Destructors do not run then. A thread that waits for this from the beginning removes what is
//! unfinished, and ends the program.

use crate::error::CliError;
use std::io::{self, PipeReader, PipeWriter, Read, Write};
use std::os::fd::AsRawFd;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, AtomicI32, Ordering};
use std::thread;
use std::time::Duration;

/// How long a command may take to end by itself after a signal.
const GRACE: Duration = Duration::from_millis(600);

/// The exit code of a program that lacks memory.
pub const NO_MEMORY: i32 = 1;

/// The exit code that was asked for, 0 before.
static CODE: AtomicI32 = AtomicI32::new(0);

/// Whether the thread is at its work.
static IS_ENDING: AtomicBool = AtomicBool::new(false);

/// The end of the pipe that wakes the thread.
static WAKER: OnceLock<PipeWriter> = OnceLock::new();

/// Starts the thread. `clean` removes what is unfinished, and says whether nothing was written.
///
/// # Errors
/// If no thread can be started.
pub fn start(clean: fn() -> bool) -> Result<(), CliError> {
    let problem = |error| CliError::Failed(format!("no thread can be started: {error}"));
    let (reader, writer) = io::pipe().map_err(problem)?;
    let thread = thread::Builder::new()
        .name("ending".into())
        .stack_size(1 << 18);
    thread.spawn(move || wait(reader, clean)).map_err(problem)?;
    let _ = WAKER.set(writer);
    Ok(())
}

/// Asks for the end of the program with an exit code. It may be called by handlers of signals: it
/// takes neither locks nor memory.
pub fn ask(code: i32) {
    if code == NO_MEMORY && IS_ENDING.load(Ordering::SeqCst) {
        exit(code);
    }
    CODE.store(code, Ordering::SeqCst);
    match WAKER.get() {
        Some(writer) => {
            // SAFETY: the descriptor is open as long as the program is, and one byte is read.
            unsafe { libc::write(writer.as_raw_fd(), b"x".as_ptr().cast(), 1) };
        }
        // The thread has not begun.
        None => exit(code),
    }
}

/// Ends the program at once.
pub fn exit(code: i32) -> ! {
    // SAFETY: it has no conditions.
    unsafe { libc::_exit(code) }
}

/// Waits until it is asked to end the program.
fn wait(mut reader: PipeReader, clean: fn() -> bool) {
    // Given back where there is no other memory, so that there is some to clean up with.
    let mut reserve = vec![1_u8; 1 << 20];
    while reader.read_exact(&mut [0]).is_ok() {
        let code = CODE.load(Ordering::SeqCst);
        if code != NO_MEMORY {
            thread::sleep(GRACE);
        }
        reserve = Vec::new();
        IS_ENDING.store(true, Ordering::SeqCst);
        let is_nothing_written = clean();
        if code == NO_MEMORY {
            exit(code);
        }
        // A command whose files have their names ends by itself.
        if is_nothing_written {
            let _ = writeln!(io::stderr(), "error: interrupted; nothing is written");
            exit(code);
        }
    }
    drop(reserve);
}
