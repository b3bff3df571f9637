//! Signals that end a program: long commands look for them where they can stop, and leave nothing
//! half done; where they do not look in time, they are ended.
//!
//! Ctrl-C is SIGINT; terminals that are closed send SIGHUP; `docker stop`, systemd, batch systems and
//! `timeout` send SIGTERM. Batch systems warn by SIGUSR1, SIGUSR2 or SIGXCPU before they kill. Timers,
//! failing power and real-time signals end a program that does not know them, too; those of faults
//! (SIGSEGV, SIGABRT) remain what they are.

#[cfg(unix)]
use crate::ending;
use crate::error::CliError;
#[cfg(unix)]
use libc::{SIGALRM, SIGPROF, SIGUSR1, SIGUSR2, SIGVTALRM, SIGXCPU};
#[cfg(target_os = "linux")]
use libc::{SIGIO, SIGPWR, SIGRTMAX, SIGRTMIN, SIGSTKFLT};
#[cfg(unix)]
use signal_hook::consts::{SIGHUP, SIGQUIT};
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::io;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, LazyLock, Once};

/// The signals that end a program.
#[cfg(unix)]
const SIGNALS: [i32; 10] = [
    SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGXCPU, SIGALRM, SIGVTALRM, SIGPROF,
];
/// The signals that end a program.
#[cfg(not(unix))]
const SIGNALS: [i32; 2] = [SIGINT, SIGTERM];

/// Signals that end a program on Linux alone; SIGPOLL is another name of SIGIO.
#[cfg(target_os = "linux")]
fn more_signals() -> impl Iterator<Item = i32> {
    let real_time = SIGRTMIN()..=SIGRTMAX();
    [SIGIO, SIGPWR, SIGSTKFLT].into_iter().chain(real_time)
}

/// Signals that end a program on Linux alone.
#[cfg(not(target_os = "linux"))]
fn more_signals() -> impl Iterator<Item = i32> {
    core::iter::empty()
}

/// The number of the last signal, 0 before the first.
static SIGNAL: LazyLock<Arc<AtomicUsize>> = LazyLock::new(Arc::default);

/// From now on a signal is only noted, for [`check`] to find; a second one ends the program at once.
///
/// Where that cannot be arranged, a signal ends the program as it always did.
pub fn watch() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let is_asked = Arc::default();
        let all = SIGNALS.into_iter().chain(more_signals());
        for signal in all.filter(|&signal| !is_ignored(signal)) {
            let _ = note(signal, &is_asked);
        }
        #[cfg(unix)]
        // SAFETY: no handler is run. A file that grows beyond the limit is an error of its write.
        unsafe {
            libc::signal(libc::SIGXFSZ, libc::SIG_IGN);
        }
    });
}

/// Notes a signal. The order matters: the first one must not find itself noted already.
fn note(signal: i32, is_asked: &Arc<AtomicBool>) -> io::Result<()> {
    flag::register_conditional_shutdown(signal, 128 + signal, is_asked.clone())?;
    flag::register(signal, is_asked.clone())?;
    flag::register_usize(signal, SIGNAL.clone(), signal as usize)?;
    #[cfg(unix)]
    // SAFETY: the handler takes neither locks nor memory.
    unsafe {
        signal_hook::low_level::register(signal, move || ending::ask(128 + signal))?;
    }
    Ok(())
}

/// Whether the program was started so that this signal does not end it: `nohup` does so with SIGHUP.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    // Shells start what runs in the background so, and it is to end all the same.
    if matches!(signal, SIGINT | SIGTERM | SIGQUIT) {
        return false;
    }
    let mut now = core::mem::MaybeUninit::<libc::sigaction>::zeroed();
    // SAFETY: without a new action the call changes nothing, and writes the present one to `now`,
    // for which zeros are a value, too.
    unsafe {
        libc::sigaction(signal, core::ptr::null(), now.as_mut_ptr()) == 0
            && now.assume_init().sa_sigaction == libc::SIG_IGN
    }
}

#[cfg(not(unix))]
fn is_ignored(_signal: i32) -> bool {
    false
}

/// Whether the command may go on.
///
/// # Errors
/// [`CliError::Interrupted`] after a signal.
pub fn check() -> Result<(), CliError> {
    match SIGNAL.load(Ordering::Relaxed) {
        0 => Ok(()),
        signal => Err(CliError::Interrupted(signal as u8)),
    }
}
