//! The pace of runs of many analyses.

use hysteron::study::{InitialRun, Role, Study};
use std::time::{Duration, Instant};

/// Clock of analyses on a number of threads.
pub(super) struct Pace {
    begun: Instant,
    threads: usize,
}

impl Pace {
    /// Begin to count.
    pub(super) fn begin(threads: usize) -> Self {
        Self { begun: Instant::now(), threads }
    }

    /// Say on the terminal how many analyses a second were made, and how many were kept. Nothing is said of none.
    pub(super) fn report(&self, made: usize, kept: usize, what: &str) {
        if let Some(line) = in_words(made, kept, what, self.begun.elapsed().as_secs_f64(), self.threads) {
            eprintln!("{line}");
        }
    }
}

/// `27 analyses in 3.2 s: 8.4 a second on 2 threads`.
fn in_words(made: usize, kept: usize, what: &str, seconds: f64, threads: usize) -> Option<String> {
    if made == 0 {
        return None;
    }
    let rate = made as f64 / seconds.max(1.0e-9);
    let rate = if rate < 10.0 { format!("{rate:.2}") } else { format!("{rate:.0}") };
    let kept = if kept > 0 { format!(", {kept} kept") } else { String::new() };
    Some(format!("{made} {what} in {seconds:.2} s: {rate} a second on {}{kept}", threads_in_words(threads)))
}

/// `1 thread` or `2 threads`.
fn threads_in_words(threads: usize) -> String {
    if threads == 1 { "1 thread".to_owned() } else { format!("{threads} threads") }
}

/// Sets of values for which a diagnosis evaluates the fitted runs, fewest and most. `diagnose --verbose` tells 3,043 of them for
/// `tcl-like-inputs/pad_study`; eight of ten pads of `validation/diagnosis/trials.csv` take 0.4 to 2.7 times the median
/// of all.
const EVALUATIONS: [u32; 2] = [1_200, 8_000];
/// A diagnosis that takes no longer needs no estimate.
const MIN_ESTIMATE: Duration = Duration::from_secs(600);

/// Says on the terminal how long a diagnosis of a study will take about; nothing of a short one.
pub(super) fn tell_diagnosis(study: &Study, initial: &InitialRun, threads: usize) {
    let fitted = study.runs.iter().zip(&initial.durations).filter(|(run, _)| run.role == Role::Fit);
    if let Some(line) = diagnosis_in_words(fitted.map(|(_, time)| *time).sum(), threads) {
        eprintln!("{line}");
    }
}

/// `the fitted runs take 0.50 s: a diagnosis takes about 5 to 34 min on 2 threads`.
fn diagnosis_in_words(fitted: Duration, threads: usize) -> Option<String> {
    let [least, most] = EVALUATIONS.map(|n| fitted * n / threads.max(1) as u32);
    if most < MIN_ESTIMATE {
        return None;
    }
    let minutes = |d: Duration| (d.as_secs_f64() / 60.0).ceil();
    let (from, to) = (minutes(least), minutes(most));
    Some(format!(
        "the fitted runs take {:.2} s: a diagnosis takes about {from} to {to} min on {}",
        fitted.as_secs_f64(),
        threads_in_words(threads)
    ))
}

#[cfg(test)]
mod tests {
    use super::{diagnosis_in_words, in_words};
    use std::time::Duration;

    #[test]
    fn the_duration_of_a_diagnosis_in_words() {
        let of = |seconds, threads| diagnosis_in_words(Duration::from_secs_f64(seconds), threads);
        assert_eq!(of(0.001, 1), None);
        let told = "the fitted runs take 0.50 s: a diagnosis takes about 5 to 34 min on 2 threads";
        assert_eq!(of(0.5, 2).as_deref(), Some(told));
    }

    #[test]
    fn a_pace_in_words() {
        let of = |made, kept, seconds, threads| in_words(made, kept, "analyses", seconds, threads);
        assert_eq!(of(27, 0, 3.2, 2).as_deref(), Some("27 analyses in 3.20 s: 8.44 a second on 2 threads"));
        assert_eq!(of(500, 3, 2.0, 1).as_deref(), Some("500 analyses in 2.00 s: 250 a second on 1 thread, 3 kept"));
        assert_eq!(of(0, 27, 3.2, 2), None);
    }
}
