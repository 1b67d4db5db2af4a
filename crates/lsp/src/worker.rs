//! The thread that checks. The newest texts count: a check of older ones is ended, unless it is nearly through.

use crate::check::{Buffers, Checked, Job};
use crate::finding::Finding;
use crate::roots::Roots;
use crossbeam_channel::Sender;
use hysteron_opensees::NumberFiles;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// A check that runs longer is ended when its text changes.
const YOUNG: Duration = Duration::from_millis(150);
/// Pause of the writing after which a study is checked.
const STUDY_PAUSE: Duration = Duration::from_millis(300);
/// Stack of the thread.
const STACK: usize = 16 << 20;

/// Limits of a check.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// Time of a script or a study.
    pub(crate) time: Duration,
    /// Reproduce errors of OpenSees.
    pub(crate) compat: bool,
}

/// A check under way.
struct Running {
    root: String,
    /// Files that the root has read in its last check.
    files: BTreeSet<String>,
    stop: Arc<AtomicBool>,
    begun: Instant,
    /// Its texts have changed: the result is not wanted.
    is_superseded: bool,
}

#[derive(Default)]
struct State {
    buffers: Arc<Buffers>,
    /// Files that have changed since they were looked at.
    changed: BTreeSet<String>,
    /// Roots to be checked, and when.
    pending: BTreeMap<String, Instant>,
    /// Files have been opened, closed or written.
    is_renewed: bool,
    running: Option<Running>,
    is_closed: bool,
}

#[derive(Default)]
struct Mailbox {
    state: Mutex<State>,
    wake: Condvar,
}

impl Mailbox {
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The thread, and what is to be checked next.
pub(crate) struct Worker {
    mailbox: Arc<Mailbox>,
    limits: Limits,
}

impl Worker {
    /// Start the thread. Results go to `results`.
    pub(crate) fn new(limits: Limits, results: Sender<Checked>) -> std::io::Result<Self> {
        let mailbox = Arc::new(Mailbox::default());
        let shared = mailbox.clone();
        thread::Builder::new().spawn(move || supervise(&shared, limits, &results))?;
        Ok(Self { mailbox, limits })
    }

    /// Give the texts of the open files, and the files that have changed. `is_renewed` after opening, closing and writing.
    pub(crate) fn submit(&self, buffers: Arc<Buffers>, changed: impl IntoIterator<Item = String>, is_renewed: bool) {
        let mut state = self.mailbox.lock();
        state.buffers = buffers;
        state.is_renewed |= is_renewed;
        let changed: Vec<String> = changed.into_iter().collect();
        if let Some(running) = &mut state.running {
            let concerns = changed.iter().any(|c| *c == running.root || running.files.contains(c));
            if concerns && running.begun.elapsed() > YOUNG {
                running.is_superseded = true;
                running.stop.store(true, Ordering::Relaxed);
            }
        }
        state.changed.extend(changed);
        drop(state);
        self.mailbox.wake.notify_all();
    }

    /// Look at the limits of the check under way; `is_full` if the program takes too much memory.
    pub(crate) fn look(&self, is_full: bool) {
        let state = self.mailbox.lock();
        if let Some(running) = state.running.as_ref().filter(|r| is_full || r.begun.elapsed() > self.limits.time) {
            running.stop.store(true, Ordering::Relaxed);
        }
    }

    /// Returns true if nothing is left to be checked.
    pub(crate) fn is_idle(&self) -> bool {
        let state = self.mailbox.lock();
        state.running.is_none() && state.pending.is_empty() && state.changed.is_empty()
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        let mut state = self.mailbox.lock();
        state.is_closed = true;
        if let Some(running) = &state.running {
            running.stop.store(true, Ordering::Relaxed);
        }
        drop(state);
        // A command of a script that does not end must not hold up the end of the server: nobody waits for the thread.
        self.mailbox.wake.notify_all();
    }
}

/// Run the thread that checks, and another one after a fault of a check.
fn supervise(mailbox: &Arc<Mailbox>, limits: Limits, results: &Sender<Checked>) {
    loop {
        let (shared, sender) = (mailbox.clone(), results.clone());
        let thread = thread::Builder::new().stack_size(STACK).spawn(move || work(&shared, limits, &sender));
        if thread.is_ok_and(|t| t.join().is_ok()) {
            return;
        }
        let failed = mailbox.lock().running.take();
        if let Some(Running { root, .. }) = failed {
            let message = "the check of this text failed by a fault of hysteron: please report the text";
            let findings = vec![Finding::error(&root, message)];
            let _ = results.send(Checked { root, findings, ..Checked::default() });
        }
    }
}

/// What the thread remembers between checks.
#[derive(Default)]
struct Memory {
    roots: Roots,
    numbers: NumberFiles,
    /// Files that each root has read.
    read: BTreeMap<String, BTreeSet<String>>,
}

/// Check until the mailbox is closed.
fn work(mailbox: &Mailbox, limits: Limits, results: &Sender<Checked>) {
    let mut memory = Memory::default();
    while let Some((root, buffers, stop)) = next(mailbox, &mut memory) {
        let job = Job {
            root: &root,
            buffers: &buffers,
            stop: &stop,
            limit: limits.time,
            compat: limits.compat,
            numbers: &memory.numbers,
        };
        let checked = job.run(&|first| drop(results.send(first)));
        let files: BTreeSet<String> = checked.texts.keys().cloned().collect();
        let mut state = mailbox.lock();
        let is_superseded = state.running.take().is_some_and(|r| r.is_superseded);
        let mut again: Vec<String> = vec![];
        if is_superseded {
            again.push(root);
        } else {
            // A file that its root does not come to stands for itself.
            let lost = |p: &&String| !files.contains(*p) && memory.roots.root_of(p, &buffers) == root;
            again = buffers.keys().filter(lost).cloned().collect();
            again.iter().for_each(|p| memory.roots.stands_alone(p));
            memory.read.insert(root, files);
        }
        again.into_iter().for_each(|root| _ = state.pending.entry(root).or_insert_with(Instant::now));
        drop(state);
        if !is_superseded && results.send(checked).is_err() {
            return;
        }
    }
}

/// The next root to be checked, with the texts and the flag that ends the check; `None` at the end.
fn next(mailbox: &Mailbox, memory: &mut Memory) -> Option<(String, Arc<Buffers>, Arc<AtomicBool>)> {
    let mut state = mailbox.lock();
    loop {
        if state.is_closed {
            return None;
        }
        if std::mem::take(&mut state.is_renewed) {
            memory.roots.forget();
        }
        let (changed, buffers) = (std::mem::take(&mut state.changed), state.buffers.clone());
        for path in changed {
            let own = buffers.contains_key(&path).then(|| memory.roots.root_of(&path, &buffers));
            // Scripts that have read the file, as far as one of their files is open.
            let is_open = |files: &BTreeSet<String>| buffers.keys().any(|p| files.contains(p));
            let readers = memory.read.iter().filter(|(_, files)| files.contains(&path) && is_open(files));
            let readers = readers.map(|(root, _)| root.clone());
            for root in own.into_iter().chain(readers) {
                let is_script = !root.ends_with(".toml");
                let due = Instant::now() + if is_script { Duration::ZERO } else { STUDY_PAUSE };
                state.pending.insert(root, due);
            }
        }
        let first = state.pending.iter().min_by_key(|(_, due)| **due).map(|(root, due)| (root.clone(), *due));
        state = match first {
            None => mailbox.wake.wait(state).unwrap_or_else(PoisonError::into_inner),
            Some((_, due)) if due > Instant::now() => {
                let pause = due - Instant::now();
                mailbox.wake.wait_timeout(state, pause).unwrap_or_else(PoisonError::into_inner).0
            }
            Some((root, _)) => {
                state.pending.remove(&root);
                let stop = Arc::new(AtomicBool::new(false));
                let files = memory.read.get(&root).cloned().unwrap_or_default();
                let begun = Instant::now();
                let running = Running { root: root.clone(), files, stop: stop.clone(), begun, is_superseded: false };
                state.running = Some(running);
                return Some((root, buffers, stop));
            }
        };
    }
}
