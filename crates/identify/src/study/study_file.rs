//! The tables of `study.toml` as they are written. [`super::load`] checks them.

use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct StudyFile {
    pub(super) title: Option<String>,
    pub(super) model: Spanned<String>,
    #[serde(default)]
    pub(super) parameter: Vec<Spanned<ParameterTable>>,
    #[serde(default)]
    pub(super) run: Vec<Spanned<RunTable>>,
    #[serde(default)]
    pub(super) calibration: CalibrationTable,
    pub(super) rig: Option<RigTable>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ParameterTable {
    pub(super) name: Spanned<String>,
    pub(super) lower: Option<Spanned<f64>>,
    pub(super) upper: Option<Spanned<f64>>,
    pub(super) scale: Option<Spanned<String>>,
    pub(super) value: Option<Spanned<f64>>,
    pub(super) expr: Option<Spanned<String>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RunTable {
    pub(super) name: Spanned<String>,
    pub(super) role: Option<Spanned<String>>,
    pub(super) recording: Spanned<String>,
    #[serde(default)]
    pub(super) set: BTreeMap<Spanned<String>, Spanned<toml::Value>>,
    #[serde(default)]
    pub(super) observe: Vec<Spanned<ObserveTable>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ObserveTable {
    pub(super) channel: Spanned<String>,
    pub(super) output: Spanned<String>,
    pub(super) column: Spanned<i64>,
    pub(super) at: Option<String>,
    pub(super) weight: Option<Spanned<f64>>,
    pub(super) factor: Option<Spanned<f64>>,
    pub(super) offset: Option<Spanned<f64>>,
    pub(super) shift: Option<Spanned<f64>>,
    pub(super) unit: Option<Spanned<String>>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CalibrationTable {
    pub(super) method: Option<Spanned<String>>,
    pub(super) population: Option<Spanned<i64>>,
    pub(super) generations: Option<Spanned<i64>>,
    #[serde(rename = "F")]
    pub(super) f: Option<Spanned<f64>>,
    #[serde(rename = "CR")]
    pub(super) cr: Option<Spanned<f64>>,
    pub(super) seed: Option<Spanned<i64>>,
    pub(super) repeats: Option<Spanned<i64>>,
    pub(super) evaluations: Option<Spanned<i64>>,
    pub(super) polish: Option<bool>,
    pub(super) time_limit: Option<Spanned<f64>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RigTable {
    pub(super) stroke: Option<Spanned<f64>>,
    pub(super) speed: Option<Spanned<f64>>,
    pub(super) force: Option<Spanned<f64>>,
    pub(super) temperature: Option<Spanned<[f64; 2]>>,
}
