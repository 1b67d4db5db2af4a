//! Studies: calibration and diagnosis, and the objective for any optimiser.

use crate::errors::{OpenSeesError, Place};
use crate::outputs::{Shared, hold, warn};
use hysteron_diagnose::{CheckpointEntry, ProgressMonitor, Settings, diagnose};
use hysteron_engine::analysis::Options;
use hysteron_identify::calibrate::{
    CalibrationResult, Checkpoint, Evaluation, Problem as _, SearchObserver, SearchSettings, StudyProblem, search,
    uncertainty,
};
use hysteron_identify::study::{InitialRun, Role, ScoredRun, ScriptSimulator, SimulatorFactory, Study as LoadedStudy};
use hysteron_tcl::diagnostic::{Diagnostic, Severity, SourceMap};
use numpy::{PyArray1, PyArray2, PyArrayMethods as _, PyReadonlyArrayDyn};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};

/// Points that a thread evaluates between two looks at Python's signals.
const POINTS_BETWEEN_SIGNALS: usize = 8;

/// Threads and the problem that they work on.
type Pool = Mutex<Option<(usize, Arc<StudyProblem>)>>;

/// Recorded or simulated histories: name of the run, name of the channel, samples.
type Channels<'py> = Vec<(String, String, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>)>;

/// A study: a script, its parameters, and the recordings that it is compared with.
#[pyclass(frozen, subclass, module = "hysteron._hysteron", name = "Study")]
pub(crate) struct Study {
    study: Arc<LoadedStudy>,
    factory: SimulatorFactory,
    initial_run: InitialRun,
    compat: bool,
    stop: Arc<AtomicBool>,
    pool: Pool,
    /// Number of independent samples, once it is known.
    effective_samples: Mutex<Option<f64>>,
}

fn place(d: &Diagnostic, sources: &SourceMap) -> String {
    let at = d.span.map(|s| format!("{}: ", sources.location(s))).unwrap_or_default();
    let mut text = format!("{at}{}", d.message);
    for line in [&d.label].into_iter().chain(&d.help).filter(|l| !l.is_empty()) {
        text.push_str("\n  ");
        text.push_str(line);
    }
    text
}

/// Stops a search or a diagnosis when Python has a signal.
struct Watch {
    raised: Shared<Option<PyErr>>,
    stop: Arc<AtomicBool>,
}

impl Watch {
    fn is_stopped(&self) -> bool {
        if let Err(e) = Python::attach(|py| py.check_signals()) {
            *hold(&self.raised) = Some(e);
            self.stop.store(true, Ordering::Relaxed);
        }
        self.stop.load(Ordering::Relaxed)
    }
}

impl SearchObserver for Watch {
    fn stopped(&self) -> bool {
        self.is_stopped()
    }
}

impl ProgressMonitor for Watch {
    fn stage(&mut self, _: &str, _: usize, _: usize) {}

    fn is_cancelled(&self) -> bool {
        self.is_stopped()
    }

    fn checkpoint(&mut self, _: &[CheckpointEntry]) {}
}

impl Study {
    fn problem(&self, threads: usize) -> PyResult<Arc<StudyProblem>> {
        let mut pool = self.pool.lock().map_err(|_| PyRuntimeError::new_err("the study is not usable any more"))?;
        match &*pool {
            Some((t, problem)) if *t == threads => Ok(problem.clone()),
            _ => {
                let factory = self.factory.clone();
                let problem = StudyProblem::new(self.study.clone(), threads, move || factory.simulator());
                let problem = Arc::new(problem.map_err(|e| PyRuntimeError::new_err(e.to_string()))?);
                *pool = Some((threads, problem.clone()));
                Ok(problem)
            }
        }
    }

    /// Unit point of values of the free parameters; `None` for values outside of their bounds.
    fn unit_point(&self, x: &[f64]) -> PyResult<Option<Vec<f64>>> {
        let n = self.study.space.dimension();
        if x.len() != n {
            return Err(PyValueError::new_err(format!("x has {} values; expected {n}: {}", x.len(), self.listed())));
        }
        let inside = self.study.space.free().zip(x).all(|((_, r), v)| (r.lower..=r.upper).contains(v));
        let point = self.study.space.free().zip(x).map(|((_, r), v)| r.unit_coordinate(*v).clamp(0.0, 1.0)).collect();
        Ok(inside.then_some(point))
    }

    fn listed(&self) -> String {
        self.study.space.free_names().collect::<Vec<_>>().join(", ")
    }

    fn evaluate(
        &self,
        py: Python<'_>,
        points: &[Option<Vec<f64>>],
        residuals: bool,
        threads: usize,
    ) -> PyResult<Vec<Option<Evaluation>>> {
        let problem = self.problem(threads.max(1))?;
        let inside: Vec<Vec<f64>> = points.iter().flatten().cloned().collect();
        let mut found = Vec::with_capacity(inside.len());
        for part in inside.chunks(POINTS_BETWEEN_SIGNALS * threads.max(1)) {
            found.extend(py.detach(|| problem.evaluate(part, residuals)));
            py.check_signals()?;
        }
        let mut found = found.into_iter();
        Ok(points.iter().map(|p| p.as_ref().and_then(|_| found.next())).collect())
    }

    /// Objectives at points; infinite outside of the bounds and where the model has no response.
    fn objectives(&self, py: Python<'_>, points: &[Option<Vec<f64>>], threads: usize) -> PyResult<Vec<f64>> {
        let found = self.evaluate(py, points, false, threads)?.into_iter();
        let value = |e: Evaluation| if e.error.is_none() { e.trial.objective } else { f64::INFINITY };
        Ok(found.map(|e| e.map_or(f64::INFINITY, value)).collect())
    }

    /// Residuals at points, each of which `place` names.
    fn all_residuals(
        &self,
        py: Python<'_>,
        points: Vec<Option<Vec<f64>>>,
        threads: usize,
        place: fn(usize) -> String,
    ) -> PyResult<Vec<Vec<f64>>> {
        let outside = |i| OpenSeesError::new_err(format!("{} is outside of the bounds of {}", place(i), self.listed()));
        if let Some(i) = points.iter().position(Option::is_none) {
            return Err(outside(i));
        }
        let found = self.evaluate(py, &points, true, threads)?;
        let take = |(i, e): (usize, Option<Evaluation>)| match e {
            Some(Evaluation { error: Some(e), .. }) => {
                Err(OpenSeesError::new_err(format!("no response at {}: {e}", place(i))))
            }
            Some(e) => Ok(e.trial.residuals),
            None => Err(outside(i)),
        };
        found.into_iter().enumerate().map(take).collect()
    }

    /// Text of the script.
    pub(crate) fn text(&self) -> Result<String, String> {
        let path = self.study.folder.join(&self.study.model);
        hysteron_files::read_text(&path).map_err(|e| format!("{}: {e}", path.display()))
    }

    /// A simulator of the study.
    pub(crate) fn simulator(&self) -> ScriptSimulator {
        self.factory.simulator()
    }

    /// The run that opened the study.
    pub(crate) fn initial_run(&self) -> &InitialRun {
        &self.initial_run
    }

    /// Work without Python's lock that stops when Python has a signal.
    pub(crate) fn watched<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&Self, &mut dyn ProgressMonitor) -> Result<T, String> + Send,
    ) -> PyResult<T> {
        self.stop.store(false, Ordering::Relaxed);
        let raised: Shared<Option<PyErr>> = Shared::default();
        let mut watch = Watch { raised: raised.clone(), stop: self.stop.clone() };
        let result = py.detach(|| work(self, &mut watch));
        Self::finished(&raised, result)
    }

    /// Number of samples of the fitted channels.
    fn fitted_samples(&self) -> usize {
        let runs = self.study.runs_of(Role::Fit).flat_map(|(_, r)| &r.observe);
        runs.map(|o| o.values.iter().filter(|v| !v.is_nan()).count()).sum()
    }

    /// A calibration with its uncertainty.
    fn calibrated(&self, py: Python<'_>, settings: &SearchSettings, threads: usize) -> PyResult<CalibrationResult> {
        let problem = self.problem(threads.max(1))?;
        self.stop.store(false, Ordering::Relaxed);
        let raised: Shared<Option<PyErr>> = Shared::default();
        let mut watch = Watch { raised: raised.clone(), stop: self.stop.clone() };
        let start = Checkpoint::new(settings.clone(), self.study.space.unit_point(&self.initial_run.values));
        let result = py.detach(|| {
            let began = std::time::Instant::now();
            let found = search(&*problem, start, &mut watch);
            let mut result = CalibrationResult::new(&problem, settings, found, began.elapsed().as_secs_f64())?;
            result.uncertainty = uncertainty(&problem, &result.unit_point).ok();
            Ok(result)
        });
        Self::finished(&raised, result)
    }

    /// `n` where it is given, else the number of independent samples.
    fn independent_samples(&self, py: Python<'_>, n: Option<f64>, threads: usize) -> PyResult<f64> {
        n.map_or_else(|| self.effective_samples(py, threads), Ok)
    }

    fn finished<T>(raised: &Shared<Option<PyErr>>, result: Result<T, String>) -> PyResult<T> {
        match hold(raised).take() {
            Some(e) => Err(e),
            None => result.map_err(OpenSeesError::new_err),
        }
    }

    fn channels<'py>(&self, py: Python<'py>, scored: &[Option<&ScoredRun>]) -> Channels<'py> {
        let mut out = vec![];
        for (run, scored) in self.study.runs.iter().zip(scored) {
            let Some(scored) = scored else { continue };
            for (observed, simulated) in run.observe.iter().zip(&scored.channels) {
                let recorded = PyArray1::from_slice(py, &observed.values);
                out.push((run.name.clone(), observed.channel.clone(), recorded, PyArray1::from_slice(py, simulated)));
            }
        }
        out
    }
}

/// The rows of an array of one or two dimensions.
fn rows(x: &PyReadonlyArrayDyn<'_, f64>) -> PyResult<Vec<Vec<f64>>> {
    // An array that came over a network need not be aligned; its copy is.
    if !x.data().is_aligned() {
        return rows(&x.call_method0("copy")?.extract()?);
    }
    let x = x.as_array();
    match x.ndim() {
        1 => Ok(vec![x.iter().copied().collect()]),
        2 => Ok(x.outer_iter().map(|r| r.iter().copied().collect()).collect()),
        n => Err(PyValueError::new_err(format!("an array of {n} dimensions; expected points in its rows"))),
    }
}

#[pymethods]
impl Study {
    #[new]
    #[pyo3(signature = (file, *, compat = false))]
    fn new(py: Python<'_>, file: PathBuf, compat: bool) -> PyResult<Self> {
        let stop: Arc<AtomicBool> = Arc::default();
        let flag = stop.clone();
        let loaded = py.detach(|| {
            let mut sources = SourceMap::default();
            let load = |sources: &mut SourceMap| {
                let study = Arc::new(LoadedStudy::load(&file, sources)?);
                let options = Options { compat, ..Options::default() };
                let mut simulator = ScriptSimulator::new(study.clone(), options, flag);
                let initial_run = simulator.run_initially(sources)?;
                Ok((study, simulator.factory(), initial_run))
            };
            let loaded = load(&mut sources);
            let wrong = |d: Box<Diagnostic>| (place(&d, &sources), Place::in_file(&d, &sources));
            loaded.map_err(wrong).map(|(study, factory, initial)| {
                let all = study.warnings.iter().chain(&initial.warnings).filter(|w| w.severity != Severity::Note);
                let warnings: Vec<String> = all.map(|w| place(w, &sources)).collect();
                (study, factory, initial, warnings)
            })
        });
        let (study, factory, initial_run, warnings) = loaded.map_err(|(text, at)| at.error(py, text))?;
        warnings.iter().try_for_each(|w| warn(py, w))?;
        Ok(Self {
            study,
            factory,
            initial_run,
            compat,
            stop,
            pool: Mutex::default(),
            effective_samples: Mutex::default(),
        })
    }

    /// Names of the free parameters, in the order of `x`.
    #[getter]
    fn names(&self) -> Vec<String> {
        self.study.space.free_names().map(str::to_owned).collect()
    }

    /// Bounds of the free parameters: an array of shape (parameters, 2).
    #[getter]
    fn bounds<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let rows: Vec<Vec<f64>> = self.study.space.free().map(|(_, r)| vec![r.lower, r.upper]).collect();
        PyArray2::from_vec2(py, &rows).map_err(|e| PyRuntimeError::new_err(e.to_string()))
    }

    /// Values of the script itself for the free parameters; NaN where it gives none.
    #[getter]
    fn initial<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_iter(py, self.study.space.free().map(|(i, _)| self.initial_run.values[i]))
    }

    /// Title of the study.
    #[getter]
    fn title(&self) -> &str {
        &self.study.title
    }

    /// File of the study.
    #[getter]
    fn file(&self) -> PathBuf {
        std::path::absolute(&self.study.file).unwrap_or_else(|_| self.study.file.clone())
    }

    /// Path of the script, from the folder of the study.
    #[getter]
    fn _model(&self) -> &str {
        &self.study.model
    }

    /// OpenSees' numbers are followed also where they depend on a slip.
    #[getter]
    fn compat(&self) -> bool {
        self.compat
    }

    /// Number of recorded samples that a fit compares.
    #[getter]
    fn samples(&self) -> usize {
        self.fitted_samples()
    }

    /// Objective of a calibration at `x`: mean NMSE of the fitted channels; infinite where the model has no response.
    #[pyo3(signature = (x, *, threads = 1))]
    fn objective(&self, py: Python<'_>, x: Vec<f64>, threads: usize) -> PyResult<f64> {
        Ok(self.objectives(py, &[self.unit_point(&x)?], threads)?[0])
    }

    /// `objective` at the rows of `x`, on several threads. Any number of threads gives the same bits.
    #[pyo3(signature = (x, *, threads = 1))]
    fn objective_many<'py>(
        &self,
        py: Python<'py>,
        x: PyReadonlyArrayDyn<'py, f64>,
        threads: usize,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let points = rows(&x)?.iter().map(|r| self.unit_point(r)).collect::<PyResult<Vec<_>>>()?;
        Ok(PyArray1::from_vec(py, self.objectives(py, &points, threads)?))
    }

    /// Scaled differences between model and recordings at `x`, whose sum of squares is the objective.
    ///
    /// Raises OpenSeesError where the model has no response.
    #[pyo3(signature = (x, *, threads = 1))]
    fn residuals<'py>(&self, py: Python<'py>, x: Vec<f64>, threads: usize) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let found = self.all_residuals(py, vec![self.unit_point(&x)?], threads, |_| "x".to_owned())?;
        Ok(PyArray1::from_vec(py, found.into_iter().next().unwrap_or_default()))
    }

    /// `residuals` at the rows of `x`, on several threads: an array of shape (points, samples). Any number of threads gives the
    /// same bits.
    ///
    /// Raises OpenSeesError where the model has no response at one of them.
    #[pyo3(signature = (x, *, threads = 1))]
    fn residuals_many<'py>(
        &self,
        py: Python<'py>,
        x: PyReadonlyArrayDyn<'py, f64>,
        threads: usize,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let points = rows(&x)?.iter().map(|r| self.unit_point(r)).collect::<PyResult<Vec<_>>>()?;
        let found = self.all_residuals(py, points, threads, |row| format!("row {row} of x"))?;
        PyArray2::from_vec2(py, &found).map_err(|e| PyRuntimeError::new_err(e.to_string()))
    }

    /// Number of independent samples of the fitted runs, by which the intervals of a calibration are made: the differences of
    /// neighbouring samples are alike, so that it is smaller than `samples`.
    ///
    /// The first call calibrates the study with its own settings. Raises OpenSeesError if that has no uncertainty.
    #[pyo3(signature = (*, threads = 1))]
    fn effective_samples(&self, py: Python<'_>, threads: usize) -> PyResult<f64> {
        let unusable = || PyRuntimeError::new_err("the study is not usable any more");
        if let Some(n) = *self.effective_samples.lock().map_err(|_| unusable())? {
            return Ok(n);
        }
        let settings =
            SearchSettings::of(&self.study).map_err(|d| OpenSeesError::new_err(place(&d, &SourceMap::default())))?;
        let found = self.calibrated(py, &settings, threads)?.uncertainty.map(|u| u.effective_samples);
        let n = found.ok_or_else(|| {
            OpenSeesError::new_err(
                "the calibration has no uncertainty, so that the independent samples are not known: give n",
            )
        })?;
        *self.effective_samples.lock().map_err(|_| unusable())? = Some(n);
        Ok(n)
    }

    /// Logarithm of the likelihood at `x` but for a constant: -n/2 ln(objective), the likelihood of Gaussian errors whose
    /// variance is the one of largest likelihood. `n` is the number of independent samples, by default `effective_samples`,
    /// which calibrates the study once. It is -inf outside of the bounds and where the model has no response.
    #[pyo3(signature = (x, *, n = None, threads = 1))]
    fn loglike(&self, py: Python<'_>, x: Vec<f64>, n: Option<f64>, threads: usize) -> PyResult<f64> {
        let objective = self.objective(py, x, threads)?;
        Ok(log_likelihood(objective, self.independent_samples(py, n, threads)?))
    }

    /// `loglike` at the rows of `x`, on several threads. Any number of threads gives the same bits.
    #[pyo3(signature = (x, *, n = None, threads = 1))]
    fn loglike_many<'py>(
        &self,
        py: Python<'py>,
        x: PyReadonlyArrayDyn<'py, f64>,
        n: Option<f64>,
        threads: usize,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let points = rows(&x)?.iter().map(|r| self.unit_point(r)).collect::<PyResult<Vec<_>>>()?;
        let n = self.independent_samples(py, n, threads)?;
        let found = self.objectives(py, &points, threads)?;
        Ok(PyArray1::from_iter(py, found.into_iter().map(|objective| log_likelihood(objective, n))))
    }

    /// Result of a calibration as JSON, and the channels: run, channel, recorded and simulated samples.
    #[pyo3(signature = (*, method = None, seed = None, evaluations = None, threads = 1))]
    fn _calibrate<'py>(
        &self,
        py: Python<'py>,
        method: Option<&str>,
        seed: Option<u64>,
        evaluations: Option<usize>,
        threads: usize,
    ) -> PyResult<(String, Channels<'py>)> {
        let wrong = |d: Box<Diagnostic>| OpenSeesError::new_err(place(&d, &SourceMap::default()));
        let mut settings = SearchSettings::of(&self.study).map_err(wrong)?;
        if let Some(method) = method {
            settings.set_method(method).map_err(wrong)?;
        }
        settings.seed = seed.unwrap_or(settings.seed);
        settings.evaluations = evaluations.or(settings.evaluations);
        let result = self.calibrated(py, &settings, threads)?;
        let json = result.json().map_err(|e| PyRuntimeError::new_err(e.to_string()))?;
        let scored: Vec<Option<&ScoredRun>> = result.scored_runs.iter().map(|r| r.as_ref().ok()).collect();
        Ok((json, self.channels(py, &scored)))
    }

    /// Result of a diagnosis as JSON, the repaired script, and the channels of the repaired model.
    #[pyo3(signature = (*, without = vec![], threads = 1))]
    fn _diagnose<'py>(
        &self,
        py: Python<'py>,
        without: Vec<String>,
        threads: usize,
    ) -> PyResult<(String, String, Channels<'py>)> {
        self.stop.store(false, Ordering::Relaxed);
        let raised: Shared<Option<PyErr>> = Shared::default();
        let mut watch = Watch { raised: raised.clone(), stop: self.stop.clone() };
        let diagnosis = py.detach(|| {
            let text = self.text()?;
            let settings = Settings { threads: threads.max(1), excluded_causes: without, ..Settings::default() };
            diagnose(&self.factory.simulator(), &self.initial_run, &text, &settings, &mut watch)
        });
        let diagnosis = Self::finished(&raised, diagnosis)?;
        let json = serde_json::to_string(&diagnosis.outcome).map_err(|e| PyRuntimeError::new_err(e.to_string()))?;
        let scored: Vec<Option<&ScoredRun>> = diagnosis.repaired_fits.iter().map(Option::as_ref).collect();
        Ok((json, diagnosis.repaired_script, self.channels(py, &scored)))
    }

    fn __repr__(&self) -> String {
        format!("<Study '{}' of {}>", self.study.file.display(), self.listed())
    }
}

fn log_likelihood(objective: f64, n: f64) -> f64 {
    if objective.is_finite() { -0.5 * n * objective.ln() } else { f64::NEG_INFINITY }
}
