//! Workers that keep what they work with, each in a thread of its own.
//!
//! A script's values are not shared between threads, so a worker is made in its thread and stays there: this is why the
//! work is not handed to a pool that knows nothing of workers.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex};
use std::thread::JoinHandle;

/// Workers that wait for jobs `J` and answer with `R`.
pub struct Crew<J, R> {
    jobs: Option<Sender<(usize, J)>>,
    results: Receiver<(usize, Option<R>)>,
    threads: Vec<JoinHandle<()>>,
}

impl<J: Send + 'static, R: Send + 'static> Crew<J, R> {
    /// As many workers as `threads`, each made by `make` in its thread, doing each job with `work`.
    ///
    /// # Errors
    /// A thread could not be started.
    pub fn new<W: 'static>(
        threads: usize,
        make: impl Fn() -> W + Clone + Send + 'static,
        work: impl Fn(&mut W, J) -> R + Clone + Send + 'static,
    ) -> std::io::Result<Self> {
        let (jobs, waiting) = channel::<(usize, J)>();
        let (done, results) = channel();
        let waiting = Arc::new(Mutex::new(waiting));
        let mut handles = vec![];
        for _ in 0..threads.max(1) {
            let (waiting, done, make, work) = (waiting.clone(), done.clone(), make.clone(), work.clone());
            // Deep scripts need room, as on the main thread.
            let builder = std::thread::Builder::new().stack_size(8 << 20);
            handles.push(builder.spawn(move || {
                let mut worker = None;
                loop {
                    let job = waiting.lock().map(|w| w.recv());
                    let Ok(Ok((number, job))) = job else { break };
                    // A defect costs one answer, not the crew; its worker is made anew.
                    let answer = catch_unwind(AssertUnwindSafe(|| work(worker.get_or_insert_with(&make), job)));
                    if answer.is_err() {
                        worker = None;
                    }
                    if done.send((number, answer.ok())).is_err() {
                        break;
                    }
                }
            })?);
        }
        Ok(Self { jobs: Some(jobs), results, threads: handles })
    }

    /// Do all jobs; answers in their order, `None` where a worker broke down.
    pub fn run(&self, jobs: impl IntoIterator<Item = J>) -> Vec<Option<R>> {
        let mut count = 0;
        if let Some(sender) = &self.jobs {
            for job in jobs.into_iter().enumerate() {
                count += usize::from(sender.send(job).is_ok());
            }
        }
        let mut answers: Vec<Option<R>> = (0..count).map(|_| None).collect();
        for _ in 0..count {
            let Ok((number, answer)) = self.results.recv() else { break };
            answers[number] = answer;
        }
        answers
    }

    /// Number of workers.
    pub fn threads(&self) -> usize {
        self.threads.len()
    }
}

impl<J, R> Drop for Crew<J, R> {
    fn drop(&mut self) {
        self.jobs = None;
        for t in self.threads.drain(..) {
            let _ = t.join();
        }
    }
}
