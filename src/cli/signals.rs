//! Interrupts: Ctrl-C, and SIGTERM where the system has it.

use super::limits;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Exit status of whatever was interrupted, with a result so far or without one.
pub(super) const INTERRUPTED: i32 = 130;

/// Exit status of whatever was stopped, with the limit that stopped it printed; `None` if nothing was.
pub(super) fn stopped_status(stop: &AtomicBool) -> Option<i32> {
    if let Some(why) = limits::exceeded() {
        eprintln!("error: stopped: {why}");
        return Some(limits::LIMIT_STATUS);
    }
    stop.load(Ordering::Relaxed).then_some(INTERRUPTED)
}

/// Set a flag when the program is interrupted; a second interrupt ends it at once.
pub(super) fn on_interrupt(stop: &Arc<AtomicBool>) {
    for signal in [SIGINT, SIGTERM] {
        // In this order: the first signal finds the flag unset, and sets it.
        let caught = flag::register_conditional_shutdown(signal, INTERRUPTED, stop.clone())
            .and_then(|_| flag::register(signal, stop.clone()));
        if let Err(e) = caught {
            eprintln!("note: interrupts are not caught: {e}");
        }
    }
}
