//! The one door to the file system: no other crate uses `std::fs`, which `tests/architecture.rs` holds.
//!
//! - Reading is bounded ([`read`], [`read_text`]): a device without an end takes no memory.
//! - A file is written anew and renamed ([`write()`], [`write_durably`]): a link under its name is replaced and not followed, and
//!   nobody sees half a file.
//! - The file of a recorder has whole rows at any time, and one writer ([`ResultFile`]).
//! - A folder of results has one run at a time ([`FolderLock`]). A [`Scratch`] folder has a name that nobody can guess.

#![forbid(unsafe_code)]

mod folder;
mod lock;
mod read;
mod result_file;
mod scratch;
mod system;
mod write;

pub use folder::{list, make_folder, make_folders, make_inner_folder, make_own_folder, remove_folder};
pub use lock::{FolderLock, open_alone};
pub use read::{
    MAX_FILE_SIZE, MAX_INPUT_SIZE, read, read_beside, read_input, read_lossy, read_text, read_up_to, read_whole,
};
pub use result_file::ResultFile;
pub use scratch::Scratch;
pub use std::fs::{File, Metadata};
pub use system::{
    Access, info, is_link, link_info, open, path_from, permissions, portable, remove, rename, set_modified,
};
pub use write::{copy, write, write_durably};
