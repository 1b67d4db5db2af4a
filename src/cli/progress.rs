//! Progress of long analyses. It is shown on terminals only.

use hysteron::opensees::Progress;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::time::{Duration, Instant};

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

    /// A progress of the steps of an analysis that is shown in this line.
    pub(super) fn steps(&self) -> StepProgress {
        StepProgress { bar: self.bar.clone(), begun: Instant::now(), shown: false, count: 0, last: Instant::now() }
    }
}

/// Shows time, number of steps and steps per second of an analysis.
pub(super) struct StepProgress {
    bar: ProgressBar,
    begun: Instant,
    last: Instant,
    shown: bool,
    count: u64,
}

impl StepProgress {
    fn show(&mut self, end: Option<f64>) {
        self.shown = true;
        let with_end = "{elapsed_precise} [{bar:30}] {msg} left {eta}";
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
        self.bar.set_message(format!("time {time:.4}, {} steps, {rate:.0} steps/s", self.count));
    }
}
