//! Learned laws: from a study, and evaluated along any motion.

use crate::study::Study;
use hysteron_diagnose::{Settings, learn_law};
use hysteron_engine::element::amendment::learned::LearnedLaw as Law;
use hysteron_opensees::{law_of_json, law_to_json, law_to_words};
use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::collections::BTreeMap;

/// A learned law with memory of one direction.
#[pyclass(frozen, subclass, module = "hysteron._hysteron", name = "LearnedLaw")]
pub(crate) struct LearnedLaw {
    law: Law,
}

#[pymethods]
impl LearnedLaw {
    /// The law of a JSON text, as `hysteron learn` writes it.
    #[new]
    fn new(json: &str) -> PyResult<Self> {
        Ok(Self { law: law_of_json(json).map_err(PyValueError::new_err)? })
    }

    /// Force along the deformations `u` at the times `t`, from rest. `channels` has a series for each channel of the law, `own`
    /// the force of the element's own law for a law of that form.
    #[pyo3(signature = (u, t, channels = None, own = None))]
    fn force<'py>(
        &self,
        py: Python<'py>,
        u: Vec<f64>,
        t: Vec<f64>,
        channels: Option<BTreeMap<String, Vec<f64>>>,
        own: Option<Vec<f64>>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let given = channels.unwrap_or_default();
        let mut series = vec![];
        for c in &self.law.channels {
            let values = given.get(&c.name);
            let values =
                values.ok_or_else(|| PyValueError::new_err(format!("the law needs the channel {}", c.name)))?;
            series.push(values.as_slice());
        }
        let own = own.unwrap_or_default();
        let is_long = |x: &[f64]| x.len() == u.len();
        if !is_long(&t) || !series.iter().all(|x| is_long(x)) || !(own.is_empty() || is_long(&own)) {
            return Err(PyValueError::new_err("u, t, channels and own differ in their lengths"));
        }
        Ok(PyArray1::from_vec(py, self.law.along(&u, &t, &own, &series).0))
    }

    /// Names of the channels that the law follows.
    #[getter]
    fn channels(&self) -> Vec<String> {
        self.law.channels.iter().map(|c| c.name.clone()).collect()
    }

    /// The law as JSON, for a file that `amend element $tag learned -file` reads.
    fn json(&self) -> String {
        law_to_json(&self.law)
    }

    /// The law as words after `amend element $tag learned`.
    fn words(&self) -> String {
        law_to_words(&self.law)
    }

    fn __repr__(&self) -> String {
        format!("<LearnedLaw {}>", law_to_words(&self.law))
    }
}

#[pymethods]
impl Study {
    /// The law as JSON, its parts in words, remarks, errors by name, and the script with the law.
    #[pyo3(signature = (*, threads))]
    fn _learn(
        &self,
        py: Python<'_>,
        threads: usize,
    ) -> PyResult<(String, Vec<String>, Vec<String>, BTreeMap<&'static str, Option<f64>>, Option<String>)> {
        let learned = self.watched(py, |study, watch| {
            let text = study.text()?;
            let settings = Settings { threads: threads.max(1), ..Settings::default() };
            learn_law(&study.simulator(), study.initial_run(), &text, &settings, watch)
        });
        let learned = learned?;
        let l = &learned.learned;
        let errors = BTreeMap::from([
            ("fitted", Some(l.fitted)),
            ("blocks", Some(l.blocks)),
            ("held_out", l.held_out),
            ("user_fitted", Some(l.user_fitted)),
            ("user_held_out", l.user_held_out),
            ("outside_range", Some(l.outside)),
        ]);
        let remarks = learned.remarks();
        Ok((learned.json, learned.parts, remarks, errors, learned.script))
    }
}
