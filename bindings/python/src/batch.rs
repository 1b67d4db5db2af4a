//! Batches: the cases of a plan, run here or by other processes.

use crate::errors::OpenSeesError;
use crate::outputs::{Shared, hold};
use hysteron_design::batch::{Plan as LoadedPlan, is_complete, load, run_case, table};
use hysteron_identify::study::WorkerPool;
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Time between looks at Python's signals, and at the end of the work, while cases run.
const SIGNAL_INTERVAL: Duration = Duration::from_millis(2);

/// A plan of a batch that has been read with all its inputs.
#[pyclass(frozen, module = "hysteron._hysteron")]
pub(crate) struct Plan {
    plan: LoadedPlan,
}

#[pymethods]
impl Plan {
    #[new]
    fn new(py: Python<'_>, file: PathBuf) -> PyResult<Self> {
        let plan = py.detach(|| load(&file)).map_err(OpenSeesError::new_err)?;
        Ok(Self { plan })
    }

    /// Names of the cases: hashes of their inputs.
    #[getter]
    fn hashes(&self) -> Vec<String> {
        self.plan.cases.iter().map(|c| c.hash.clone()).collect()
    }

    /// Number of cases that were left out because another has the same inputs.
    #[getter]
    fn repeated(&self) -> usize {
        self.plan.repeated
    }

    /// Names of the parameters.
    #[getter]
    fn parameters(&self) -> Vec<String> {
        self.plan.parameters.clone()
    }

    /// Names of the results.
    #[getter]
    fn results(&self) -> Vec<String> {
        self.plan.results.clone()
    }

    /// Run cases by their numbers, each in a folder of its own below `folder`.
    #[pyo3(signature = (cases, folder, *, resume = false, threads = 1))]
    fn run(&self, py: Python<'_>, cases: Vec<usize>, folder: PathBuf, resume: bool, threads: usize) -> PyResult<()> {
        if let Some(wrong) = cases.iter().find(|i| **i >= self.plan.cases.len()) {
            return Err(PyIndexError::new_err(format!("case {wrong} of {}", self.plan.cases.len())));
        }
        let stop: Arc<AtomicBool> = Arc::default();
        let raised: Shared<Option<PyErr>> = Shared::default();
        let outcome = py.detach(|| -> Result<(), String> {
            hysteron_files::make_folders(&folder).map_err(|e| e.to_string())?;
            let pool = WorkerPool::new(threads.max(1)).map_err(|e| e.to_string())?;
            let one = |i: &usize| run_case(&self.plan, &self.plan.cases[*i], &folder, resume, &stop);
            std::thread::scope(|scope| {
                let work = scope.spawn(|| pool.run(cases.iter(), one));
                while !work.is_finished() {
                    std::thread::sleep(SIGNAL_INTERVAL);
                    if let Err(e) = Python::attach(|py| py.check_signals()) {
                        *hold(&raised) = Some(e);
                        stop.store(true, Ordering::Relaxed);
                    }
                }
                let defect = || "a defect of this program".to_owned();
                let all = work.join().map_err(|_| defect())?;
                all.into_iter().try_for_each(|r| r.unwrap_or_else(|| Err(defect())))
            })
        });
        match hold(&raised).take() {
            Some(e) => Err(e),
            None => outcome.map_err(OpenSeesError::new_err),
        }
    }

    /// Returns true if an earlier run has completed a case below `folder`, and no file that it read has changed.
    fn is_complete(&self, case: usize, folder: PathBuf) -> bool {
        self.plan.cases.get(case).is_some_and(|c| is_complete(c, &folder))
    }

    /// The table of results as CSV, and the number of cases that failed.
    fn table(&self, folder: PathBuf) -> PyResult<(String, usize)> {
        let incomplete = |n| format!("{n} of {} cases are not complete in {}", self.plan.cases.len(), folder.display());
        let table = table(&self.plan, &folder).map_err(|n| OpenSeesError::new_err(incomplete(n)))?;
        Ok((table.csv, table.failed))
    }
}
