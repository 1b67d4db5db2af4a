//! The command line: arguments, messages, progress. No other module prints.

mod args;
mod bearing;
mod calibrate;
mod calibration_summary;
mod commands;
mod compare;
mod console;
mod diagnose;
mod files;
mod help;
mod init;
mod isolate;
mod loops;
mod messages;
mod motions;
mod output_folder;
mod preflight;
mod progress;
mod prototype;
mod run;
mod script_check;
mod signals;
mod study;

pub(crate) use run::main;
