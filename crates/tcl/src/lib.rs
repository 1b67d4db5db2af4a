#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]

mod ast;
mod builtin;
mod channel;
mod command;
mod console;
mod core;
pub mod diagnostic;
mod dict;
mod ensemble;
mod error;
mod escape;
mod eval;
mod expr;
mod files;
mod glob;
mod index;
mod interp;
mod lexer;
mod list;
mod lookup;
mod memory_files;
mod namespace;
mod number;
mod origin;
mod outline;
mod overlay_files;
mod paths;
mod proc;
mod regex;
mod stack;
mod table;
mod text;
mod value;
mod vars;

pub use self::command::{Call, CommandFn};
pub use self::console::{Console, Recorded};
pub use self::core::Core;
pub use self::error::{Exception, Returned, ScriptError};
pub use self::files::{FileInfo, FileKind, Files, OpenMode, OsFiles, Stream};
pub use self::interp::{Interp, OnError, Vocabulary};
pub use self::list::List;
pub use self::memory_files::MemoryFiles;
pub use self::outline::{TopLevel, top_level};
pub use self::overlay_files::OverlayFiles;
pub use self::value::Value;
