//! The command line: arguments, messages, progress. No other module prints.

#[macro_use]
mod print;

mod args;
mod balance;
mod batch;
mod bearing;
mod calibrate;
mod calibration_summary;
mod checkpoint;
mod commands;
mod compare;
mod console;
mod diagnose;
mod element_alone;
mod examples;
mod explain;
mod files;
mod fragility;
mod help;
mod init;
mod isolate;
mod learn;
mod limits;
mod loops;
mod lsp;
mod messages;
mod motions;
mod pace;
mod preflight;
mod progress;
mod prototype;
mod python_check;
mod recording;
mod response_spectrum;
mod review;
mod run;
mod script_check;
mod signals;
mod study;
mod study_jobs;
mod view;

pub(crate) use run::main;
