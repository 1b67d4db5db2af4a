//! Progress of long analyses, and of the phases of a diagnosis.

use hysteron::analysis::Engine;
use hysteron::opensees::{MotionObserver, Progress};
use hysteron::view::Glance;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::cell::RefCell;
use std::io::IsTerminal;
use std::rc::Rc;
use std::time::{Duration, Instant};

/// A bar that counts `what` on a terminal; `None` where nobody looks.
pub(super) fn count_bar(what: &str) -> Option<ProgressBar> {
    std::io::stderr().is_terminal().then(|| {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
        let template = format!("{{elapsed_precise}} [{{bar:30}}] {{pos}} of {{len}} {what}, left {{eta}}");
        let style = ProgressStyle::with_template(&template);
        style.map_or(bar.clone(), |s| bar.with_style(s.progress_chars("=> ")))
    })
}

/// The progress line at the bottom of the terminal. Clones share it.
#[derive(Clone)]
pub(super) struct ProgressLine {
    bar: ProgressBar,
}

/// A shorter analysis shows no progress.
const MIN_DURATION: Duration = Duration::from_millis(700);

impl ProgressLine {
    pub(super) fn new() -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        Self { bar }
    }

    /// Hide the line while `write` prints.
    pub(super) fn suspend(&self, write: impl FnOnce()) {
        self.bar.suspend(write);
    }

    /// Remove the line.
    pub(super) fn clear(&self) {
        self.bar.finish_and_clear();
    }

    /// A progress of the steps of an analysis that is shown in this line, with what `glance` sees below.
    pub(super) fn steps(&self, glance: Option<SharedGlance>) -> StepProgress {
        let now = Instant::now();
        StepProgress { bar: self.bar.clone(), begun: now, shown: false, count: 0, last: now, glance }
    }
}

/// A glance at a run that its progress shares.
#[derive(Clone, Default)]
pub(super) struct SharedGlance(Rc<RefCell<Glance>>);

impl MotionObserver for SharedGlance {
    fn start(&mut self, _: &Engine) {}

    fn step(&mut self, engine: &Engine) {
        self.0.borrow_mut().step(engine);
    }

    fn wipe(&mut self, _: &mut Engine) {}
}

/// Shows time, number of steps and steps per second of an analysis.
pub(super) struct StepProgress {
    bar: ProgressBar,
    begun: Instant,
    last: Instant,
    shown: bool,
    count: u64,
    glance: Option<SharedGlance>,
}

impl StepProgress {
    fn show(&mut self, end: Option<f64>) {
        self.shown = true;
        let with_end = "{elapsed_precise} [{bar:30}] left {eta} {msg}";
        let style = ProgressStyle::with_template(if end.is_some() { with_end } else { "{elapsed_precise} {msg}" });
        if let Ok(style) = style {
            self.bar.set_style(style.progress_chars("=> "));
        }
        self.bar.set_draw_target(ProgressDrawTarget::stderr());
    }
}

impl Progress for StepProgress {
    fn step(&mut self, time: f64, end: Option<f64>) {
        self.count += 1;
        // Reading the clock takes longer than a small step.
        if !self.count.is_multiple_of(64) || !std::io::stderr().is_terminal() {
            return;
        }
        let now = Instant::now();
        if now - self.last < Duration::from_millis(100) || now - self.begun < MIN_DURATION {
            return;
        }
        self.last = now;
        if !self.shown {
            self.show(end);
        }
        if let Some(end) = end.filter(|e| *e > 0.0) {
            self.bar.set_length(1000);
            self.bar.set_position((1000.0 * (time / end).clamp(0.0, 1.0)) as u64);
        }
        let rate = self.count as f64 / (now - self.begun).as_secs_f64();
        let below = self.glance.as_ref().map_or_else(String::new, |g| g.0.borrow().text());
        let message = format!("time {time:.4}, {} steps, {rate:.0} steps/s\n{below}", self.count);
        self.bar.set_message(message.trim_end().to_owned());
    }
}

/// Phases of a diagnosis in their order: words, and the stages of the library that belong to each.
const PHASES: [(&str, &[&str]); 7] = [
    ("fitting your model", &["the model as it is"]),
    ("trying what may be missing", &["what may have been left out"]),
    ("comparing look-alikes", &["what looks like the best of them"]),
    ("checking the time step", &["the error of the steps"]),
    ("fitting the likeliest", &["the likeliest of them", "what it predicts"]),
    ("looking for a second effect", &["a second effect"]),
    ("testing the verdict", &["recordings as they might have been", "the repaired model"]),
];

/// Letters of the bar.
const BAR_WIDTH: usize = 16;
/// A batch of fewer jobs does not move the bar.
const MIN_BATCH: usize = 3;
/// Time between two lines where standard error is no terminal.
const LINE_INTERVAL: Duration = Duration::from_secs(60);
/// Time after which the rest of a batch is estimated.
const MIN_ESTIMATE: Duration = Duration::from_secs(3);

/// Shows the phases of a diagnosis: in one line of a terminal, else a plain line at the start of each phase and each minute.
pub(super) struct PhaseProgress {
    /// The line of the terminal; `None` elsewhere.
    bar: Option<ProgressBar>,
    state: PhaseState,
    last_line: Instant,
}

/// State of the phases, which never goes back.
struct PhaseState {
    /// Number of the phase, from 1; 0 before the first.
    phase: usize,
    /// Batches of the phase before the present one.
    batches: i32,
    /// Jobs of the present batch: complete, and all.
    jobs: (usize, usize),
    /// Filled part of the bar.
    filled: f64,
    batch_begun: Instant,
}

impl PhaseState {
    /// Takes `done` of `total` jobs of a stage; true if a phase begins.
    fn update(&mut self, stage: &str, done: usize, total: usize) -> bool {
        let number = PHASES.iter().position(|(_, stages)| stages.contains(&stage)).map_or(self.phase, |n| n + 1);
        let begins = number > self.phase;
        if begins {
            (self.phase, self.batches, self.filled) = (number, 0, 0.0);
        }
        if done == 0 || begins || total != self.jobs.1 {
            if !begins && self.jobs.1 >= MIN_BATCH {
                self.batches += 1;
            }
            self.batch_begun = Instant::now();
        }
        self.jobs = (done, total);
        if total >= MIN_BATCH {
            // How many batches follow is not known: each fills half of what is left.
            let left = 0.5f64.powi(self.batches);
            self.filled = self.filled.max(1.0 - left + 0.5 * left * done as f64 / total as f64);
        }
        begins
    }

    fn title(&self) -> String {
        let words = self.phase.checked_sub(1).and_then(|n| PHASES.get(n)).map_or("", |(words, _)| *words);
        format!("{} of {}: {words}", self.phase, PHASES.len())
    }

    /// The line of a terminal, of at most 80 letters.
    fn line(&self) -> String {
        let (done, total) = self.jobs;
        if total < MIN_BATCH {
            return self.title();
        }
        let filled = (self.filled * BAR_WIDTH as f64) as usize;
        format!("{} [{:<BAR_WIDTH$}] {done}/{total}{}", self.title(), "=".repeat(filled), self.left())
    }

    /// The rest of the present batch in words; empty where it cannot be estimated.
    fn left(&self) -> String {
        let ((done, total), elapsed) = (self.jobs, self.batch_begun.elapsed());
        if done == 0 || done >= total || elapsed <= MIN_ESTIMATE {
            return String::new();
        }
        let seconds = elapsed.as_secs_f64() * (total - done) as f64 / done as f64;
        if seconds < 60.0 { format!(", {seconds:.0} s left") } else { format!(", {:.0} min left", seconds / 60.0) }
    }
}

impl PhaseProgress {
    pub(super) fn new() -> Self {
        let style = ProgressStyle::with_template("{msg}").unwrap_or_else(|_| ProgressStyle::default_bar());
        let bar = std::io::stderr().is_terminal().then(|| ProgressBar::no_length().with_style(style));
        let now = Instant::now();
        let state = PhaseState { phase: 0, batches: 0, jobs: (0, 0), filled: 0.0, batch_begun: now };
        Self { bar, state, last_line: now }
    }

    /// Shows that `done` of `total` jobs of a stage are complete.
    pub(super) fn stage(&mut self, stage: &str, done: usize, total: usize) {
        let begins = self.state.update(stage, done, total);
        if let Some(bar) = &self.bar {
            bar.set_message(self.state.line());
            bar.tick();
        } else if begins || self.last_line.elapsed() > LINE_INTERVAL {
            self.last_line = Instant::now();
            let count = if begins { String::new() } else { format!(", {done} of {total}{}", self.state.left()) };
            eprintln!("{}{count}", self.state.title());
        }
    }

    /// Hides the line while `write` prints.
    pub(super) fn suspend(&self, write: impl FnOnce()) {
        match &self.bar {
            Some(bar) => bar.suspend(write),
            None => write(),
        }
    }

    /// Removes the line.
    pub(super) fn clear(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{BAR_WIDTH, PhaseState};
    use std::time::{Duration, Instant};

    #[test]
    fn the_bar_never_goes_back_and_its_line_is_short() {
        let begun = Instant::now() - Duration::from_secs(4000);
        let mut s = PhaseState { phase: 0, batches: 0, jobs: (0, 0), filled: 0.0, batch_begun: begun };
        let (mut phase, mut filled) = (0, 0.0);
        let stages = [
            ("the model as it is", 60),
            ("what may have been left out", 1),
            ("what may have been left out", 2064),
            ("what may have been left out", 64),
            ("the error of the steps", 1),
            ("the model as it is", 5),
            ("a second effect", 1041),
        ];
        for (stage, total) in stages {
            for done in 0..=total {
                if s.update(stage, done, total) {
                    filled = 0.0;
                }
                s.batch_begun = begun;
                let line = s.line();
                assert!(line.chars().count() <= 80, "{line}");
                assert!(s.phase >= phase && s.filled >= filled && s.filled <= 1.0, "{line}");
                (phase, filled) = (s.phase, s.filled);
            }
        }
        assert_eq!(phase, 6);
        let line = s.line();
        assert_eq!(line, format!("6 of 7: looking for a second effect [{:<BAR_WIDTH$}] 1041/1041", "========"));
    }
}
