//! Peaks of what recorders record.

use super::inputs::Inputs;
use hysteron::opensees::{FileFormat, FileSeries, Outputs};
use hysteron::record::{Group, LiveFile, Output, RecordError};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// Largest absolute value of a column, with its name.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Peak {
    pub(super) column: String,
    pub(super) value: f64,
}

/// Peaks of all columns, by the file that the script names.
#[derive(Clone, Debug, Default)]
pub(super) struct Peaks(Arc<Mutex<BTreeMap<String, Vec<Peak>>>>);

impl Peaks {
    /// The peaks so far.
    pub(super) fn take(&self) -> BTreeMap<String, Vec<Peak>> {
        std::mem::take(&mut *self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

/// Outputs whose peaks are noted.
pub(super) struct WithPeaks {
    outputs: Box<dyn Outputs>,
    peaks: Peaks,
    inputs: Inputs,
}

impl WithPeaks {
    /// Around other outputs. Their files are no inputs.
    pub(super) fn new(outputs: Box<dyn Outputs>, peaks: Peaks, inputs: Inputs) -> Self {
        Self { outputs, peaks, inputs }
    }
}

#[deny(clippy::missing_trait_methods)]
impl Outputs for WithPeaks {
    fn create(&mut self, name: &str, path: &Path, format: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        let output = self.outputs.create(name, path, format)?;
        self.inputs.written(&path.to_string_lossy());
        Ok(Box::new(PeakOutput { output, name: name.to_owned(), peaks: self.peaks.clone() }))
    }

    fn series(&mut self, name: &str, path: &Path) -> Result<Box<dyn FileSeries>, RecordError> {
        self.outputs.series(name, path)
    }
}

/// An output that notes peaks, and passes everything on.
#[derive(Debug)]
struct PeakOutput {
    output: Box<dyn Output>,
    name: String,
    peaks: Peaks,
}

#[deny(clippy::missing_trait_methods)]
impl Output for PeakOutput {
    fn begin(&mut self, labels: &[String]) -> Result<(), RecordError> {
        let columns = labels.iter().map(|l| Peak { column: l.clone(), value: 0.0 }).collect();
        self.peaks.0.lock().unwrap_or_else(PoisonError::into_inner).insert(self.name.clone(), columns);
        self.output.begin(labels)
    }

    fn describe(&mut self, groups: &[Group]) -> Result<(), RecordError> {
        self.output.describe(groups)
    }

    fn row(&mut self, row: &[f64]) -> Result<(), RecordError> {
        if let Some(peaks) = self.peaks.0.lock().unwrap_or_else(PoisonError::into_inner).get_mut(&self.name) {
            peaks.iter_mut().zip(row).for_each(|(peak, x)| peak.value = peak.value.max(x.abs()));
        }
        self.output.row(row)
    }

    fn columns(&self) -> Option<&[usize]> {
        None
    }

    fn rows(&mut self, times: &[f64], rows: &[f64]) -> Result<(), RecordError> {
        let width = rows.len() / times.len().max(1);
        times.iter().zip(rows.chunks(width.max(1))).try_for_each(|(time, row)| {
            self.at(*time);
            self.row(row)
        })
    }

    fn wants_start(&self, time: f64) -> bool {
        self.output.wants_start(time)
    }

    fn start(&mut self, time: f64, row: &[f64]) {
        self.output.start(time, row);
    }

    fn at(&mut self, time: f64) {
        self.output.at(time);
    }

    fn restart(&mut self) -> Result<(), RecordError> {
        // What an envelope had before is written anew.
        if let Some(peaks) = self.peaks.0.lock().unwrap_or_else(PoisonError::into_inner).get_mut(&self.name) {
            peaks.iter_mut().for_each(|peak| peak.value = 0.0);
        }
        self.output.restart()
    }

    fn live(&self) -> Option<Arc<dyn LiveFile>> {
        self.output.live()
    }

    fn wants_every_row(&self) -> bool {
        self.output.wants_every_row()
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        self.output.flush()
    }

    fn finish(&mut self) -> Result<(), RecordError> {
        self.output.finish()
    }
}
