//! The pace of runs of many analyses.

use std::time::Instant;

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
    let threads = if threads == 1 { "1 thread".to_owned() } else { format!("{threads} threads") };
    Some(format!("{made} {what} in {seconds:.2} s: {rate} a second on {threads}{kept}"))
}

#[cfg(test)]
mod tests {
    use super::in_words;

    #[test]
    fn a_pace_in_words() {
        let of = |made, kept, seconds, threads| in_words(made, kept, "analyses", seconds, threads);
        assert_eq!(of(27, 0, 3.2, 2).as_deref(), Some("27 analyses in 3.20 s: 8.44 a second on 2 threads"));
        assert_eq!(of(500, 3, 2.0, 1).as_deref(), Some("500 analyses in 2.00 s: 250 a second on 1 thread, 3 kept"));
        assert_eq!(of(0, 27, 3.2, 2), None);
    }
}
