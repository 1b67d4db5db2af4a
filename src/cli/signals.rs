//! Interrupts: Ctrl-C, and SIGTERM where the system has it.

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Exit status of whatever was interrupted, with a result so far or without one.
pub(super) const INTERRUPTED: i32 = 130;

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
