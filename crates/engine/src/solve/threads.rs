//! Threads that work on one model.

use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::{Arc, OnceLock};

/// Threads that work on one model; by default one. Results are the same for any number of them, to the last bit.
#[derive(Clone, Debug, Default)]
pub struct Threads {
    /// Number; 0 is 1.
    number: usize,
    /// They start with the first work that is worth it.
    pool: Arc<OnceLock<Option<ThreadPool>>>,
}

impl Threads {
    /// A number of threads.
    pub fn new(number: usize) -> Self {
        Self { number, pool: Arc::default() }
    }

    /// As many as the machine has processors.
    pub fn of_machine() -> Self {
        Self::new(std::thread::available_parallelism().map_or(1, usize::from))
    }

    /// Returns true if there are several.
    pub(crate) fn are_several(&self) -> bool {
        self.number > 1
    }

    /// Do something that is worth several threads: it is told whether there are any.
    pub(crate) fn run<R: Send>(&self, work: impl FnOnce(bool) -> R + Send) -> R {
        if !self.are_several() {
            return work(false);
        }
        let make = || ThreadPoolBuilder::new().num_threads(self.number).build().ok();
        match self.pool.get_or_init(make) {
            Some(pool) => pool.install(|| work(true)),
            None => work(false),
        }
    }
}
