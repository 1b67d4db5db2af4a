//! The files that the script of a study sees: those of the disk, with its own changes in memory.

use super::cached_files::CachedFiles;
use hysteron_tcl::{FileInfo, Files, OpenMode, OverlayFiles, Stream};
use std::io;
use std::time::Duration;

/// Files of a study, of which a run changes its own copies only.
pub(super) struct StudyFiles {
    files: OverlayFiles,
    disk: CachedFiles,
    /// Something may differ from the disk.
    changed: bool,
}

impl StudyFiles {
    /// Files that no run has changed yet.
    pub(super) fn new(disk: CachedFiles) -> Self {
        Self { files: OverlayFiles::new(Box::new(disk.clone())), disk, changed: false }
    }

    fn changed(&mut self) -> &mut OverlayFiles {
        self.changed = true;
        &mut self.files
    }
}

impl Files for StudyFiles {
    fn current_dir(&self) -> String {
        self.files.current_dir()
    }

    fn open(&mut self, path: &str, mode: OpenMode) -> io::Result<Box<dyn Stream>> {
        self.changed |= mode != OpenMode { read: true, ..OpenMode::default() };
        self.files.open(path, mode)
    }

    fn info(&self, path: &str, follow: bool) -> io::Result<FileInfo> {
        self.files.info(path, follow)
    }

    fn list(&self, path: &str) -> io::Result<Vec<String>> {
        self.files.list(path)
    }

    fn make_dir(&mut self, path: &str) -> io::Result<()> {
        self.changed().make_dir(path)
    }

    fn remove(&mut self, path: &str) -> io::Result<()> {
        self.changed().remove(path)
    }

    fn rename(&mut self, from: &str, to: &str) -> io::Result<()> {
        self.changed().rename(from, to)
    }

    fn set_modified(&mut self, path: &str, time: Duration) -> io::Result<()> {
        self.changed().set_modified(path, time)
    }

    /// Every run reads the motions: one copy of a text in memory, where a stream would read it piece by piece.
    fn read(&mut self, path: &str) -> io::Result<Vec<u8>> {
        if self.changed { self.files.read(path) } else { self.disk.read(path) }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::cached_files::{CachedFiles, FileContents};
    use super::StudyFiles;
    use hysteron_tcl::{Files as _, OpenMode};

    #[test]
    fn a_run_reads_what_it_has_written_and_no_other_does() {
        let contents = FileContents::default().with_text("/study/motion.dat", "1 2");
        let files = || StudyFiles::new(CachedFiles::new("/study", &contents));
        let mut own = files();
        assert_eq!(own.read("/study/motion.dat").unwrap(), b"1 2");
        let anew = OpenMode { write: true, create: true, truncate: true, ..OpenMode::default() };
        own.open("/study/motion.dat", anew).unwrap().write_all(b"3").unwrap();
        assert_eq!(own.read("/study/motion.dat").unwrap(), b"3");
        assert_eq!(files().read("/study/motion.dat").unwrap(), b"1 2");
        own.remove("/study/motion.dat").unwrap();
        assert!(own.read("/study/motion.dat").is_err());
    }
}
