//! Progress of long analyses, on a terminal only.

use hysteron::opensees::Progress;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::time::{Duration, Instant};

/// A line at the bottom of the terminal; clones share it.
#[derive(Clone)]
pub(super) struct Bar {
    bar: ProgressBar,
}

/// An analysis shorter than this shows nothing.
const PATIENCE: Duration = Duration::from_millis(700);

impl Bar {
    pub(super) fn new() -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        Self { bar }
    }

    /// Write something without tearing the line.
    pub(super) fn aside(&self, write: impl FnOnce()) {
        self.bar.suspend(write);
    }

    /// Take the line away.
    pub(super) fn clear(&self) {
        self.bar.finish_and_clear();
    }

    /// Steps of an analysis.
    pub(super) fn steps(&self) -> Steps {
        Steps { bar: self.bar.clone(), begun: Instant::now(), shown: false, count: 0, last: Instant::now() }
    }
}

/// Shows time, steps and rate of an analysis.
pub(super) struct Steps {
    bar: ProgressBar,
    begun: Instant,
    last: Instant,
    shown: bool,
    count: u64,
}

impl Steps {
    fn show(&mut self, end: Option<f64>) {
        self.shown = true;
        let known = "{elapsed_precise} [{bar:30}] {msg} left {eta}";
        let style = ProgressStyle::with_template(if end.is_some() { known } else { "{elapsed_precise} {msg}" });
        if let Ok(style) = style {
            self.bar.set_style(style.progress_chars("=> "));
        }
        self.bar.set_draw_target(ProgressDrawTarget::stderr());
    }
}

impl Progress for Steps {
    fn step(&mut self, time: f64, end: Option<f64>) {
        self.count += 1;
        // A look at the clock takes longer than a small step: only at every 64th.
        if !self.count.is_multiple_of(64) || !std::io::stderr().is_terminal() {
            return;
        }
        let now = Instant::now();
        if now - self.last < Duration::from_millis(100) || now - self.begun < PATIENCE {
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
