//! The command line: arguments, messages, progress. No other module prints.

mod args;
mod bearing;
mod calibrate;
mod commands;
mod compare;
mod console;
mod diagnose;
mod files;
mod help;
mod loops;
mod messages;
mod preflight;
mod progress;
mod run;
mod study;

pub(crate) use run::main;
