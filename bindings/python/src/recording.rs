//! Measured files of any format, as arrays.

use hysteron_recordings::unit::Quantity;
use hysteron_recordings::user_statements::unit_of;
use hysteron_recordings::{Clock, Layout, Measured, Series, UserStatements, Way};
use numpy::PyArray1;
use pyo3::exceptions::{PyOSError, PyValueError};
use pyo3::prelude::*;
use std::path::PathBuf;

/// A measured series with its meaning.
#[pyclass(frozen, module = "hysteron._hysteron")]
pub(crate) struct MeasuredSeries(Series);

#[pymethods]
impl MeasuredSeries {
    /// Name of the channel; empty where the file has one channel without a name.
    #[getter]
    fn name(&self) -> &str {
        &self.0.name
    }

    /// Station, where the file gives it.
    #[getter]
    fn station(&self) -> &str {
        &self.0.station
    }

    /// Event, where the file gives it.
    #[getter]
    fn event(&self) -> &str {
        &self.0.event
    }

    /// Direction in the words of the file.
    #[getter]
    fn direction(&self) -> &str {
        &self.0.direction
    }

    /// Direction of positive values in degrees clockwise from north, or None.
    #[getter]
    fn azimuth(&self) -> Option<f64> {
        self.0.azimuth
    }

    /// Quantity such as `acceleration`, or None where neither the file nor the call says it.
    #[getter]
    fn quantity(&self) -> Option<&'static str> {
        self.0.quantity.map(Quantity::word)
    }

    /// Unit of the values, or None where neither the file nor the call says it.
    #[getter]
    fn unit(&self) -> Option<&'static str> {
        self.0.unit.map(|u| u.name)
    }

    /// Step in s, or None where the steps differ or are not known.
    #[getter]
    fn dt(&self) -> Option<f64> {
        self.0.clock.dt()
    }

    /// Times in s, or None where they are not known.
    #[getter]
    fn times<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        let times = |i: usize| self.0.clock.time(i);
        let all: Option<Vec<f64>> = (0..self.0.values.len()).map(times).collect();
        all.filter(|_| self.0.clock != Clock::Unknown).map(|t| PyArray1::from_vec(py, t))
    }

    /// Samples in the unit; NaN where one is missing.
    #[getter]
    fn values<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.0.values)
    }

    /// Samples in another unit of the same quantity.
    fn to<'py>(&self, py: Python<'py>, unit: &str) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let values = unit_of(unit).and_then(|to| self.0.in_unit(to, Way::Python));
        values.map(|v| PyArray1::from_vec(py, v)).map_err(|e| PyValueError::new_err(e.to_string()))
    }

    fn __len__(&self) -> usize {
        self.0.values.len()
    }

    fn __repr__(&self) -> String {
        let quantity = self.0.quantity.map_or("unknown quantity", Quantity::word);
        let unit = self.0.unit.map_or("unknown unit", |u| u.name);
        format!("<series {:?}: {} values, {quantity} in {unit}>", self.0.name, self.0.values.len())
    }
}

/// The channels of a measured file of any format: ground motions, tests, sensors, tables.
///
/// `unit`, `dt` (in s), `quantity` and `layout` say what the file does not; what contradicts the file is refused. Remarks of
/// the reader are Python's warnings.
#[pyfunction]
#[pyo3(signature = (path, *, unit=None, dt=None, quantity=None, layout=None))]
pub(crate) fn read_recording(
    py: Python<'_>,
    path: PathBuf,
    unit: Option<String>,
    dt: Option<f64>,
    quantity: Option<String>,
    layout: Option<&str>,
) -> PyResult<Vec<MeasuredSeries>> {
    if dt.is_some_and(|dt| !(dt > 0.0 && dt.is_finite())) {
        return Err(PyValueError::new_err("dt: expected more than 0"));
    }
    let shown = path.display().to_string();
    let refused = |e: String| PyValueError::new_err(format!("{shown}: {e}"));
    let layout = layout.map(Layout::named).transpose().map_err(|e| refused(e.to_string()))?;
    let told = UserStatements { unit, dt, quantity, layout, way: Way::Python };
    let bytes =
        hysteron_files::read_input(&path).map_err(|e| PyOSError::new_err(format!("cannot read {shown}: {e}")))?;
    let beside = hysteron_files::read_beside(&path);
    let read = py.detach(|| {
        let measured = Measured::read_beside(&shown, &bytes, &beside)?;
        let series = measured.stated_series(&told)?;
        Ok((measured, series))
    });
    let (measured, series) = read.map_err(|e: hysteron_recordings::Fault| refused(e.to_string()))?;
    let warnings = py.import("warnings")?;
    for note in &measured.notes {
        warnings.call_method1("warn", (format!("{shown}: {note}"),))?;
    }
    Ok(series.into_iter().map(MeasuredSeries).collect())
}
