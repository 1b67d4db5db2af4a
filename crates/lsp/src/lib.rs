//! A language server for scripts of OpenSees, and for studies: mistakes while they are written, hover, completion,
//! definitions, references and names.
//!
//! A thread checks what `hysteron check` checks, in this process, with the texts of the editor over the files of the disk. It
//! writes no file. The check makes an index of the script ([`hysteron_opensees::index`]), from which the loop of the server
//! answers; it never waits for a check.

#![forbid(unsafe_code)]

mod buffer;
mod check;
mod features;
mod finding;
mod line;
mod publish;
mod python;
pub mod reference;
mod roots;
mod script;
mod server;
mod settings;
mod text;
mod uri;
mod worker;

pub use server::{serve, serve_stdio};
pub use settings::Settings;
