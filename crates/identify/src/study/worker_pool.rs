//! A pool of threads for simulations.

use rayon::iter::{IndexedParallelIterator as _, IntoParallelIterator as _, ParallelIterator as _};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Stack of a worker thread in bytes: the same as on the main thread, for deeply nested scripts.
const STACK_SIZE: usize = 8 << 20;

/// A pool of worker threads of its own, apart from rayon's global one.
pub struct WorkerPool {
    threads: ThreadPool,
}

impl WorkerPool {
    /// A pool of `threads` threads, at least one.
    ///
    /// # Errors
    /// A thread could not be started.
    pub fn new(threads: usize) -> io::Result<Self> {
        let builder = ThreadPoolBuilder::new().num_threads(threads.max(1)).stack_size(STACK_SIZE);
        Ok(Self { threads: builder.build().map_err(io::Error::other)? })
    }

    /// Do all jobs and return their results in the order of the jobs. The result of a job that panicked is `None`.
    pub fn run<J: Send, R: Send>(
        &self,
        jobs: impl IntoIterator<Item = J>,
        work: impl Fn(J) -> R + Sync,
    ) -> Vec<Option<R>> {
        let jobs: Vec<J> = jobs.into_iter().collect();
        // A panic costs one result, not the pool.
        let guarded = |job| catch_unwind(AssertUnwindSafe(|| work(job))).ok();
        // Jobs differ much in length, so each is a task by itself.
        self.threads.install(|| jobs.into_par_iter().with_max_len(1).map(guarded).collect())
    }

    /// Run `f` once in each thread, and wait for all of them.
    pub fn run_in_each_thread(&self, f: impl Fn() + Sync) {
        self.threads.broadcast(|_| f());
    }
}

#[cfg(test)]
mod tests {
    use super::WorkerPool;
    use std::sync::atomic::{AtomicUsize, Ordering};

    #[test]
    fn results_keep_the_order_of_jobs() {
        for threads in [0, 1, 3] {
            let pool = WorkerPool::new(threads).expect("threads");
            let results = pool.run(0..100usize, |i| i * i);
            assert!(results.into_iter().enumerate().all(|(i, r)| r == Some(i * i)), "{threads} threads");
        }
    }

    #[test]
    fn panicking_job_costs_only_its_own_result() {
        let pool = WorkerPool::new(2).expect("threads");
        let jobs = || pool.run(0..6, |i| if i == 3 { std::panic::resume_unwind(Box::new(())) } else { i });
        let expected = [Some(0), Some(1), Some(2), None, Some(4), Some(5)];
        assert_eq!(jobs(), expected);
        assert_eq!(jobs(), expected);
    }

    #[test]
    fn each_thread_is_reached_once() {
        let pool = WorkerPool::new(3).expect("threads");
        let count = AtomicUsize::new(0);
        pool.run_in_each_thread(|| {
            count.fetch_add(1, Ordering::Relaxed);
        });
        assert_eq!(count.into_inner(), 3);
    }
}
