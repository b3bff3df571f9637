//! Long work of the explorer: growing, loading and saving planets.
//!
//! Each piece of work has a thread of its own, and [`Background::take`] asks every frame whether it
//! is done. As the plugin's, it does not run on Bevy's task pools: on two cores the pool for
//! computations has one thread, on which the renderer makes its pipelines, and they would wait for
//! a planet that grows in front of them.

use std::sync::Mutex;
use std::sync::mpsc::{Receiver, TryRecvError, channel};

/// Work under way, or its result that nobody has taken yet.
///
/// The mutex is never locked; it makes the receiver `Sync`, as resources must be.
pub struct Background<T>(Mutex<Receiver<Result<T, String>>>);

impl<T: Send + 'static> Background<T> {
    /// Starts the work on a new thread. If the thread cannot be started, that is the result.
    pub fn start(work: impl FnOnce() -> Result<T, String> + Send + 'static) -> Self {
        let (sender, receiver) = channel();
        let refusal = sender.clone();
        let thread = std::thread::Builder::new()
            .name("background".into())
            .spawn(move || {
                // The receiver is gone when the program is ending.
                let _ = sender.send(work());
            });
        if let Err(error) = thread {
            let _ = refusal.send(Err(format!("no thread can be started: {error}")));
        }
        Self(Mutex::new(receiver))
    }

    /// The result, once, as soon as it is there; an error if the work panicked.
    pub fn take(&mut self) -> Option<Result<T, String>> {
        let receiver = self
            .0
            .get_mut()
            .unwrap_or_else(|poisoned| poisoned.into_inner());
        match receiver.try_recv() {
            Ok(result) => Some(result),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Err("the work broke down".into())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wait<T: Send + 'static>(mut work: Background<T>) -> Result<T, String> {
        loop {
            if let Some(result) = work.take() {
                return result;
            }
            std::thread::yield_now();
        }
    }

    #[test]
    fn results_errors_and_panics_arrive() {
        assert_eq!(wait(Background::start(|| Ok(3))), Ok(3));
        assert_eq!(
            wait(Background::<()>::start(|| Err("no".into()))),
            Err("no".into())
        );
        assert!(wait(Background::<()>::start(|| panic!("for the test"))).is_err());
    }
}
