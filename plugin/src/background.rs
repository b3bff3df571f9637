//! Work that no frame waits for: planets that grow, bakes, meshes of globes.
//!
//! Each kind has threads of its own. On Bevy's pool for such work, which has one thread on up to
//! five cores, the renderer makes its pipelines: a planet that grows before them would hold them
//! up for seconds. The threads of parallel loops are those that a step of the simulation waits for.

use rayon::ThreadPool;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::{Arc, Mutex, OnceLock, Weak};
use std::thread;

/// The threads of one kind of work, started with the first piece of it.
pub(crate) struct BackgroundPool {
    name: &'static str,
    threads: fn(usize) -> usize,
    pool: OnceLock<Option<ThreadPool>>,
}

impl BackgroundPool {
    /// A pool whose threads are called `name`; `threads` tells their number from that of the cores.
    pub(crate) const fn new(name: &'static str, threads: fn(usize) -> usize) -> Self {
        Self {
            name,
            threads,
            pool: OnceLock::new(),
        }
    }

    /// Starts a piece of work, whose parallel loops run on the pool, too. Where no threads can be
    /// started it is done at once.
    pub(crate) fn start<T: Send + 'static>(
        &self,
        work: impl FnOnce() -> T + Send + 'static,
    ) -> BackgroundJob<T> {
        let outcome = Arc::default();
        let place = Arc::downgrade(&outcome);
        match self.pool.get_or_init(|| self.build()) {
            Some(pool) => pool.spawn(move || run(&place, work)),
            None => run(&place, work),
        }
        BackgroundJob(outcome)
    }

    fn build(&self) -> Option<ThreadPool> {
        let cores = thread::available_parallelism().map_or(1, core::num::NonZero::get);
        let name = self.name;
        rayon::ThreadPoolBuilder::new()
            .num_threads((self.threads)(cores))
            .thread_name(move |k| format!("{name} {k}"))
            .build()
            .ok()
    }
}

/// Where a piece of work leaves its result, or its panic.
type Outcome<T> = Mutex<Option<thread::Result<T>>>;

/// A piece of work under way. Dropped, it is not begun, or its result is lost.
pub(crate) struct BackgroundJob<T>(Arc<Outcome<T>>);

impl<T> BackgroundJob<T> {
    /// The result, once, as soon as it is there.
    ///
    /// # Panics
    /// If the work did.
    pub(crate) fn take(&self) -> Option<T> {
        // A job that just leaves its result is asked again in the next frame.
        let outcome = self.0.try_lock().ok()?.take()?;
        Some(outcome.unwrap_or_else(|panic| resume_unwind(panic)))
    }
}

fn run<T>(place: &Weak<Outcome<T>>, work: impl FnOnce() -> T) {
    if place.strong_count() == 0 {
        return;
    }
    // A panic that leaves a thread of a pool ends the program.
    let result = catch_unwind(AssertUnwindSafe(work));
    if let Some(outcome) = place.upgrade()
        && let Ok(mut outcome) = outcome.lock()
    {
        *outcome = Some(result);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicBool, Ordering};
    use std::sync::mpsc::channel;

    fn wait<T>(job: &BackgroundJob<T>) -> T {
        loop {
            if let Some(result) = job.take() {
                return result;
            }
            thread::yield_now();
        }
    }

    #[test]
    fn results_and_panics_arrive_once() {
        static POOL: BackgroundPool = BackgroundPool::new("result", |cores| cores);
        let job = POOL.start(|| 3);
        assert_eq!(wait(&job), 3);
        assert!(job.take().is_none());
        let job = POOL.start(|| panic!("for the test"));
        assert!(catch_unwind(AssertUnwindSafe(|| wait::<()>(&job))).is_err());
        assert_eq!(wait(&POOL.start(|| 4)), 4);
    }

    #[test]
    fn a_job_that_is_dropped_before_its_turn_is_not_begun() {
        static POOL: BackgroundPool = BackgroundPool::new("cancel", |_| 1);
        let (open, gate) = channel::<()>();
        let first = POOL.start(move || gate.recv().is_ok());
        let begun = Arc::new(AtomicBool::new(false));
        let seen = begun.clone();
        drop(POOL.start(move || seen.store(true, Ordering::Relaxed)));
        open.send(()).unwrap();
        assert!(wait(&first));
        wait(&POOL.start(|| ()));
        assert!(!begun.load(Ordering::Relaxed));
    }
}
