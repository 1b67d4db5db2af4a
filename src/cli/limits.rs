//! Limits of time and memory.
//!
//! A thread looks at the clock and at the memory of the process. It asks the script to stop as an interrupt does, and ends the
//! process where that takes too long: a single command may be at work.

use clap::Args;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

/// Limits of a command that runs scripts.
#[derive(Args, Clone, Debug, Default)]
pub(super) struct LimitArgs {
    /// Stop after this time, for instance 600, 600s, 10min or 2h
    #[arg(long, value_name = "TIME", value_parser = seconds)]
    time_limit: Option<Duration>,
    /// Stop when the program takes more memory, for instance 500M or 4G
    #[arg(long, value_name = "SIZE", value_parser = bytes)]
    max_memory: Option<u64>,
}

/// Exit status where a limit was exceeded.
pub(super) const LIMIT_STATUS: i32 = 1;
/// Time between two looks.
const INTERVAL: Duration = Duration::from_millis(20);
/// Time within which a script has to end. Results so far are written in it.
const GRACE: Duration = Duration::from_secs(10);
/// Memory over the limit at which the process ends at once.
const EXCESS: f64 = 1.25;

/// The limit that was exceeded, in words.
static EXCEEDED: OnceLock<String> = OnceLock::new();

/// The limit that was exceeded, in words; `None` if none was.
pub(super) fn exceeded() -> Option<&'static str> {
    EXCEEDED.get().map(String::as_str)
}

/// The exit status, given that of an interrupted command.
pub(super) fn interrupted_status(status: i32) -> i32 {
    if exceeded().is_some() { LIMIT_STATUS } else { status }
}

impl LimitArgs {
    /// Set `stop` when a limit is exceeded.
    pub(super) fn enforce(&self, stop: &Arc<AtomicBool>) {
        if self.time_limit.is_none() && self.max_memory.is_none() {
            return;
        }
        let (limits, stop, begun) = (self.clone(), stop.clone(), Instant::now());
        std::thread::spawn(move || limits.watch(&stop, begun));
    }

    fn watch(&self, stop: &AtomicBool, begun: Instant) {
        let mut since: Option<Instant> = None;
        loop {
            std::thread::sleep(INTERVAL);
            let memory = self.max_memory.map(|limit| memory() as f64 / limit as f64);
            if since.is_none() {
                let late = self.time_limit.filter(|limit| begun.elapsed() > *limit);
                let why = late.map(|t| format!("the time limit of {} s is over", t.as_secs_f64()));
                let large = memory.filter(|share| *share > 1.0);
                let large = large.and(self.max_memory).map(|m| format!("it takes more memory than {}", in_words(m)));
                if let Some(why) = why.or(large) {
                    let _ = EXCEEDED.set(why);
                    since = Some(Instant::now());
                    stop.store(true, Ordering::Relaxed);
                }
            }
            let at_once = since.is_some_and(|s| s.elapsed() > GRACE) || memory.is_some_and(|share| share > EXCESS);
            if let Some(why) = exceeded().filter(|_| at_once) {
                eprintln!("error: stopped at once: {why}");
                std::process::exit(LIMIT_STATUS);
            }
        }
    }
}

/// Memory of the process, in bytes; 0 where the system does not tell.
fn memory() -> usize {
    memory_stats::memory_stats().map_or(0, |m| m.physical_mem)
}

/// A time: a number of seconds, or one with a unit.
pub(super) fn seconds(text: &str) -> Result<Duration, String> {
    const UNITS: [(&str, f64); 4] = [("min", 60.0), ("s", 1.0), ("m", 60.0), ("h", 3600.0)];
    let wrong = || "expected a number of seconds greater than 0, or a time as 60s, 5min or 2h".to_owned();
    let unit = UNITS.iter().find_map(|(name, factor)| Some((text.strip_suffix(name)?, *factor)));
    let (number, factor) = unit.unwrap_or((text, 1.0));
    let number: f64 = number.trim().parse().map_err(|_| wrong())?;
    Duration::try_from_secs_f64(number * factor).ok().filter(|d| !d.is_zero()).ok_or_else(wrong)
}

/// Units of a size and their bytes.
const UNITS: [(&str, u64); 4] = [("K", 1 << 10), ("M", 1 << 20), ("G", 1 << 30), ("T", 1 << 40)];

fn bytes(text: &str) -> Result<u64, String> {
    let upper = text.to_uppercase();
    let plain = upper.trim_end_matches('B').trim_end_matches('I');
    let unit = UNITS.iter().find_map(|(name, bytes)| Some((plain.strip_suffix(name)?, *bytes)));
    let (number, unit) = unit.unwrap_or((plain, 1));
    match number.trim().parse::<f64>() {
        Ok(n) if n > 0.0 && n * (unit as f64) < 1e18 => Ok((n * unit as f64) as u64),
        _ => Err("expected a size greater than 0 such as 500M or 4G".into()),
    }
}

fn in_words(bytes: u64) -> String {
    let unit = UNITS.iter().rev().find(|(_, unit)| bytes >= *unit);
    unit.map_or_else(|| format!("{bytes} bytes"), |(name, unit)| format!("{}{name}", bytes as f64 / *unit as f64))
}

#[cfg(test)]
mod tests {
    use super::{bytes, in_words, seconds};

    #[test]
    fn sizes_and_times() {
        for (text, expected) in [("1", 1), ("2k", 2048), ("500M", 500 << 20), ("1.5GiB", 3 << 29), ("4 G", 4 << 30)] {
            assert_eq!(bytes(text), Ok(expected), "{text}");
        }
        assert!(["", "0", "-1", "G", "1X", "nan", "1e30"].iter().all(|t| bytes(t).is_err()));
        assert!(["", "0", "-1", "nan", "inf", "x"].iter().all(|t| seconds(t).is_err()));
        assert_eq!((in_words(500 << 20), in_words(12)), ("500M".into(), "12 bytes".into()));
    }
}
