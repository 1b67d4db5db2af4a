//! Destination of what commands write: text for `sys.stderr`, recorders' files, and rows for numpy.

use crate::errors::{OpenSeesWarning, caller};
use hysteron_engine::record::{Memory, Output, RecordError, RowFile};
use hysteron_opensees::{DiskSeries, FileFormat, FileSeries, Outputs, Progress};
use hysteron_tcl::Console;
use pyo3::prelude::*;
use std::collections::HashMap;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Time between looks at Python's signals during an analysis.
const SIGNAL_INTERVAL: Duration = Duration::from_millis(50);

/// Start of the names of recorders' files that are kept in memory.
pub(crate) const MEMORY: &str = "\u{1}memory ";

/// Something shared by a model and what it writes to.
pub(crate) type Shared<T> = Arc<Mutex<T>>;

/// Hold something shared. A panic while it was held leaves text or rows, which are as good as before.
pub(crate) fn hold<T>(shared: &Shared<T>) -> MutexGuard<'_, T> {
    shared.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Collects text until Python's interpreter can take it.
#[derive(Clone, Default)]
pub(crate) struct Text {
    /// Text for `sys.stdout`, and text for `sys.stderr`.
    written: Shared<(String, String)>,
}

impl Console for Text {
    fn out(&mut self, text: &str) {
        hold(&self.written).0.push_str(text);
    }

    fn err(&mut self, text: &str) {
        hold(&self.written).1.push_str(text);
    }
}

impl Text {
    /// Text that was written since the last call.
    pub(crate) fn take(&self) -> (String, String) {
        std::mem::take(&mut *hold(&self.written))
    }

    /// Write to `sys.stdout` and `sys.stderr`.
    pub(crate) fn flush(&self, py: Python<'_>) -> PyResult<()> {
        let (out, err) = {
            let mut written = hold(&self.written);
            // Most commands write nothing.
            if written.0.is_empty() && written.1.is_empty() {
                return Ok(());
            }
            std::mem::take(&mut *written)
        };
        for (stream, text) in [("stdout", out), ("stderr", err)] {
            if !text.is_empty() {
                py.import("sys")?.getattr(stream)?.call_method1("write", (text,))?;
            }
        }
        Ok(())
    }
}

/// Recorders' files on the disk, or rows in memory.
#[derive(Clone, Default)]
pub(crate) struct Files {
    /// Each row goes to its file at once: Python's programs read files of recorders that are still at work.
    at_once: bool,
    rows: Shared<HashMap<String, Memory>>,
}

impl Files {
    /// Files that have all rows at any time.
    pub(crate) fn at_once() -> Self {
        Self { at_once: true, ..Self::default() }
    }

    /// The rows of a recorder in memory, taken out.
    pub(crate) fn take(&self, name: &str) -> Vec<Vec<f64>> {
        hold(&self.rows).remove(name).map(|m| m.take()).unwrap_or_default()
    }
}

impl Outputs for Files {
    fn create(&mut self, name: &str, path: &Path, f: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        if name.starts_with(MEMORY) {
            let memory = Memory::default();
            hold(&self.rows).insert(name.to_owned(), memory.clone());
            return Ok(Box::new(memory));
        }
        Ok(Box::new(RowFile::create(path, f.layout, f.style, f.close_on_write || self.at_once)?))
    }

    fn series(&mut self, _: &str, path: &Path) -> Result<Box<dyn FileSeries>, RecordError> {
        Ok(Box::new(DiskSeries::new(path)?))
    }
}

/// Looks at Python's signals between the steps of an analysis, and tells a function of Python how many have been made.
pub(crate) struct Signals {
    raised: Shared<Option<PyErr>>,
    interrupt: Arc<AtomicBool>,
    last: Instant,
    /// Takes the number of steps since its last call.
    told: Shared<Option<Py<PyAny>>>,
    /// Steps that it was not told of.
    steps: usize,
}

impl Signals {
    pub(crate) fn new(
        raised: Shared<Option<PyErr>>,
        interrupt: Arc<AtomicBool>,
        told: Shared<Option<Py<PyAny>>>,
    ) -> Self {
        Self { raised, interrupt, last: Instant::now(), told, steps: 0 }
    }

    fn look(&mut self, py: Python<'_>) -> PyResult<()> {
        // Ctrl-C sets a flag that Python's main thread looks at; its handler raises `KeyboardInterrupt`.
        py.check_signals()?;
        let told = hold(&self.told).as_ref().map(|told| told.clone_ref(py));
        let steps = std::mem::take(&mut self.steps);
        told.map_or(Ok(()), |told| told.call1(py, (steps,)).map(drop))
    }
}

impl Progress for Signals {
    fn step(&mut self, _: f64, _: Option<f64>) {
        self.steps += 1;
        if self.last.elapsed() < SIGNAL_INTERVAL {
            return;
        }
        self.last = Instant::now();
        if let Err(e) = Python::attach(|py| self.look(py)) {
            *hold(&self.raised) = Some(e);
            self.interrupt.store(true, Ordering::Relaxed);
        }
    }
}

/// Give a warning at the line outside of this package that has led to it.
pub(crate) fn warn(py: Python<'_>, text: &str) -> PyResult<()> {
    let category = py.get_type::<OpenSeesWarning>();
    let depth = caller(py).map_or(1, |(_, _, depth)| depth);
    py.import("warnings")?.call_method1("warn", (text, category, depth))?;
    Ok(())
}
