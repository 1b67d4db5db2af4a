//! Files that the program writes: those of recorders, and results.

use hysteron::bytes::checksum;
use hysteron::opensees::{DiskSeries, FileFormat, FileSeries, Outputs};
use hysteron::record::{Output, RecordError, RowFile};
use hysteron::report::html::without_numbers;
use hysteron::report::{NamedResponses, channel_files};
use hysteron::study::Study;
use hysteron::view::interactive;
use hysteron_files::FolderLock;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::io::ErrorKind;
use std::path::Path;
use std::time::Duration;

/// Time between checkpoints.
pub(super) const CHECKPOINT_INTERVAL: Duration = Duration::from_secs(5);

/// Recorder files on the disk.
pub(super) struct SystemFiles;

impl Outputs for SystemFiles {
    fn create(&mut self, _: &str, path: &Path, f: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        Ok(Box::new(RowFile::create(path, f.layout, f.style, f.close_on_write)?))
    }

    fn series(&mut self, _: &str, path: &Path) -> Result<Box<dyn FileSeries>, RecordError> {
        Ok(Box::new(DiskSeries::new(path)?))
    }
}

/// Write the report of a calibration or a diagnosis into a folder; with `view` another one for the screen too.
pub(super) fn write_report(dir: &Path, report: &str, view: bool) -> Result<(), String> {
    write_atomically(&dir.join("report.html"), &without_numbers(report))?;
    if view { write_atomically(&dir.join("report_interactive.html"), &interactive(report)) } else { Ok(()) }
}

/// Write the files of the channels into a folder of their own.
pub(super) fn write_channels(dir: &Path, study: &Study, models: &[NamedResponses<'_>]) -> Result<(), String> {
    let folder = dir.join("channels");
    make_inner_folder(&folder)?;
    channel_files(study, models).iter().try_for_each(|(name, text)| write_atomically(&folder.join(name), text))
}

/// Write a file under another name and rename it, so that it is complete at any time.
pub(super) fn write_atomically(path: &Path, text: &str) -> Result<(), String> {
    hysteron_files::write_durably(path, text).map_err(|e| format!("cannot write {}: {e}", path.display()))
}

/// Make a folder of results with its parents.
pub(super) fn make_folder(folder: &Path) -> Result<(), String> {
    hysteron_files::make_folders(folder).map_err(|e| e.to_string())
}

/// Make a folder within a folder of results. A link in its place is refused.
pub(super) fn make_inner_folder(folder: &Path) -> Result<(), String> {
    hysteron_files::make_inner_folder(folder).map_err(|e| e.to_string())
}

/// Make a folder of results, and lock it for this run.
pub(super) fn lock_folder(folder: &Path) -> Result<FolderLock, String> {
    FolderLock::take(folder).map_err(|e| e.to_string())
}

/// A checkpoint of a search in a file: its content with a checksum.
#[derive(Serialize, Deserialize)]
struct SavedCheckpoint {
    checksum: u64,
    content: String,
}

/// Write a checkpoint.
pub(super) fn write_checkpoint(path: &Path, checkpoint: &impl Serialize) -> Result<(), String> {
    let content = serde_json::to_string(checkpoint).map_err(|e| e.to_string())?;
    let saved = SavedCheckpoint { checksum: checksum(content.as_bytes()), content };
    write_atomically(path, &serde_json::to_string(&saved).map_err(|e| e.to_string())?)
}

/// Read a checkpoint; `None` if there is none, with a note.
pub(super) fn read_checkpoint<T: DeserializeOwned>(path: &Path) -> Result<Option<T>, String> {
    let cannot = |why: &str| format!("cannot go on from {}: {why}", path.display());
    let text = match hysteron_files::read_text(path) {
        Err(e) if e.kind() == ErrorKind::NotFound => {
            eprintln!("note: there is no {}: the search begins at its beginning", path.display());
            return Ok(None);
        }
        text => text.map_err(|e| cannot(&e.to_string()))?,
    };
    let damaged = || cannot("it is damaged, or of another version");
    let SavedCheckpoint { checksum: sum, content } = serde_json::from_str(&text).map_err(|_| damaged())?;
    if checksum(content.as_bytes()) != sum {
        return Err(damaged());
    }
    serde_json::from_str(&content).map(Some).map_err(|_| damaged())
}

/// Print a note if a file of results in a folder is that of another study than `study`, or does not say of which.
pub(super) fn note_replaced(dir: &Path, file: &str, study: &str) {
    let Ok(text) = hysteron_files::read_text(dir.join(file)) else { return };
    let earlier = serde_json::from_str::<serde_json::Value>(&text).ok();
    let earlier = earlier.as_ref().and_then(|v| v.get("study")?.as_str());
    if earlier != Some(study) {
        eprintln!("note: replaces the result of {} in {}", earlier.unwrap_or("another study"), dir.display());
    }
}
