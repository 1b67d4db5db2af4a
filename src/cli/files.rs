//! Files that the program writes: those of recorders, and results.

use hysteron::opensees::files::write_whole;
use hysteron::opensees::{DiskSeries, FileFormat, FileSeries, Outputs};
use hysteron::record::{Memory, Output, RecordError, RowFile};
use hysteron::report::html::without_numbers;
use hysteron::report::{NamedResponses, channel_files};
use hysteron::study::Study;
use hysteron::view::interactive;
use std::fs;
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

/// Recorder files in memory. A check must keep the results of an earlier run.
pub(super) struct NoFiles;

impl Outputs for NoFiles {
    fn create(&mut self, _: &str, _: &Path, _: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        Ok(Box::new(Memory::default()))
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
    fs::create_dir_all(&folder).map_err(|e| format!("cannot make {}: {e}", folder.display()))?;
    channel_files(study, models).iter().try_for_each(|(name, text)| write_atomically(&folder.join(name), text))
}

/// Write a file under another name and rename it, so that it is complete at any time.
pub(super) fn write_atomically(path: &Path, text: &str) -> Result<(), String> {
    write_whole(path, text.as_bytes()).map_err(|e| format!("cannot write {}: {e}", path.display()))
}

/// Print a note if a file of results in a folder is that of another study than `study`, or does not say of which.
pub(super) fn note_replaced(dir: &Path, file: &str, study: &str) {
    let Ok(text) = fs::read_to_string(dir.join(file)) else { return };
    let earlier = serde_json::from_str::<serde_json::Value>(&text).ok();
    let earlier = earlier.as_ref().and_then(|v| v.get("study")?.as_str());
    if earlier != Some(study) {
        eprintln!("note: replaces the result of {} in {}", earlier.unwrap_or("another study"), dir.display());
    }
}
