//! Recorders of a study, kept in memory.

use hysteron_engine::record::{Memory, Output, RecordError};
use hysteron_opensees::{FileFormat, Outputs};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Arc, Mutex};

/// Folder of the names of the recorders that the study adds.
const FOLDER: &str = "hysteron_isolate";

/// Rows of a recorder with their times, the state at the start of the analysis first.
#[derive(Clone, Debug, Default)]
pub(super) struct Rows {
    pub(super) times: Vec<f64>,
    pub(super) rows: Vec<Vec<f64>>,
}

impl Rows {
    pub(super) fn column(&self, i: usize) -> Vec<f64> {
        self.rows.iter().map(|r| r.get(i).copied().unwrap_or(0.0)).collect()
    }

    pub(super) fn width(&self) -> usize {
        self.rows.first().map_or(0, Vec::len)
    }
}

#[derive(Debug)]
struct Capture {
    shared: Arc<Mutex<Rows>>,
    own: Rows,
    time: f64,
}

impl Output for Capture {
    fn row(&mut self, row: &[f64]) -> Result<(), RecordError> {
        self.own.times.push(self.time);
        self.own.rows.push(row.to_vec());
        Ok(())
    }
    fn wants_start(&self, _: f64) -> bool {
        self.own.rows.is_empty()
    }
    fn start(&mut self, time: f64, row: &[f64]) {
        if self.own.rows.is_empty() {
            self.own.times.push(time);
            self.own.rows.push(row.to_vec());
        }
    }
    fn at(&mut self, time: f64) {
        self.time = time;
    }
    fn finish(&mut self) -> Result<(), RecordError> {
        if let Ok(mut shared) = self.shared.lock() {
            *shared = std::mem::take(&mut self.own);
        }
        Ok(())
    }
}

pub(super) type Captured = Arc<Mutex<BTreeMap<String, Arc<Mutex<Rows>>>>>;

/// Keeps the recorders of the study; those of the script write nowhere.
pub(super) struct StudyOutputs(pub(super) Captured);

impl Outputs for StudyOutputs {
    fn create(&mut self, name: &str, _: &Path, _: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        let Some(key) = name.strip_prefix(FOLDER).map(|n| n.trim_start_matches('/').to_owned()) else {
            return Ok(Box::new(Memory::default()));
        };
        let shared = Arc::<Mutex<Rows>>::default();
        if let Ok(mut all) = self.0.lock() {
            all.insert(key, shared.clone());
        }
        Ok(Box::new(Capture { shared, own: Rows::default(), time: 0.0 }))
    }
}
