//! The script that a file belongs to: one that is sourced by another is checked as a part of it.

use crate::check::Buffers;
use crate::uri::{file_name, folder};
use std::collections::{BTreeMap, BTreeSet};

/// Files of a folder that are looked through.
const MAX_FILES: usize = 300;
/// Bytes of a file that is looked through.
const MAX_SIZE: u64 = 1 << 20;
/// Levels of scripts that source one another.
const MAX_LEVELS: usize = 8;

/// Scripts that source others, as far as they have been looked for.
#[derive(Default)]
pub(crate) struct Roots {
    /// By the sourced file: the script that names it.
    parents: BTreeMap<String, Option<String>>,
}

impl Roots {
    /// Look again: files have been opened or written.
    pub(crate) fn forget(&mut self) {
        self.parents.clear();
    }

    /// The script that sources a file does not come to it: it stands for itself.
    pub(crate) fn stands_alone(&mut self, path: &str) {
        self.parents.insert(path.to_owned(), None);
    }

    /// The script that is to be checked for a file.
    pub(crate) fn root_of(&mut self, path: &str, buffers: &Buffers) -> String {
        let mut root = path.to_owned();
        let mut seen = BTreeSet::from([root.clone()]);
        for _ in 0..MAX_LEVELS {
            let parent = self.parents.entry(root.clone()).or_insert_with_key(|path| sourcing(path, buffers)).clone();
            match parent.filter(|p| seen.insert(p.clone())) {
                Some(parent) => root = parent,
                None => break,
            }
        }
        root
    }
}

/// A script in the folder of a file, or in the one above, that has its name in a command `source`.
fn sourcing(path: &str, buffers: &Buffers) -> Option<String> {
    if !path.ends_with(".tcl") {
        return None;
    }
    let own = folder(path);
    [own, folder(own)].into_iter().find_map(|dir| {
        let mut names = hysteron_files::list(dir).unwrap_or_default();
        names.sort();
        let scripts = names.into_iter().filter(|n| n.ends_with(".tcl")).take(MAX_FILES);
        let paths = scripts.map(|n| format!("{}/{n}", dir.trim_end_matches('/')));
        paths.filter(|p| p != path).find(|p| names_in_source(p, file_name(path), buffers))
    })
}

/// Returns true if a script has a line with `source` and the name.
fn names_in_source(script: &str, name: &str, buffers: &Buffers) -> bool {
    let has = |text: &str| {
        text.lines().map(str::trim_start).any(|line| {
            let at = line.find("source ").filter(|_| !line.starts_with('#'));
            at.is_some_and(|at| line[at..].split(|c: char| "/\\\"{}[] ;".contains(c)).any(|word| word == name))
        })
    };
    match buffers.get(script) {
        Some(text) => has(text),
        None => {
            let is_small = hysteron_files::info(script).is_ok_and(|i| i.is_file() && i.len() <= MAX_SIZE);
            is_small && hysteron_files::read_lossy(script).is_ok_and(|text| has(&text))
        }
    }
}
