//! The command line: arguments, messages, progress. Only here is anything printed.

mod args;
mod bearing;
mod calibrate;
mod compare;
mod console;
mod diagnose;
mod files;
mod loops;
mod messages;
mod progress;
mod run;
mod study;

pub(crate) use run::main;
