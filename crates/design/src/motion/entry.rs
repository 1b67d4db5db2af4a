//! Tables `[[motion]]` of studies and plans.

use super::read::ReadOptions;
use hysteron_recordings::{Layout, Told};
use serde::Deserialize;

/// The files of a motion, and what they do not say themselves.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct MotionEntry {
    pub(crate) name: Option<String>,
    pub(crate) files: Vec<String>,
    #[serde(default = "one")]
    pub(crate) factor: f64,
    unit: Option<String>,
    dt: Option<f64>,
    quantity: Option<String>,
    layout: Option<String>,
    #[serde(default)]
    channels: Vec<String>,
    #[serde(default)]
    differentiate: bool,
}

fn one() -> f64 {
    1.0
}

impl MotionEntry {
    /// Options of the reader that the entry states.
    ///
    /// # Errors
    /// The layout or the step has no meaning.
    pub(crate) fn options(&self) -> Result<ReadOptions, String> {
        if let Some(dt) = self.dt.filter(|dt| !(*dt > 0.0 && dt.is_finite())) {
            return Err(format!("dt = {dt}: expected more than 0"));
        }
        let layout = self.layout.as_deref().map(Layout::named).transpose()?;
        let told = Told { unit: self.unit.clone(), dt: self.dt, quantity: self.quantity.clone(), layout };
        Ok(ReadOptions { told, channels: self.channels.clone(), differentiate: self.differentiate })
    }

    /// The entry as text that identifies it. Keys with their defaults are left out.
    pub(crate) fn identity(&self) -> String {
        let Self { name, files, factor, unit, dt, quantity, layout, channels, differentiate } = self;
        let mut text = format!(
            "MotionEntry {{ name: {name:?}, files: {files:?}, factor: {factor:?}, unit: {unit:?}, dt: {dt:?} }}"
        );
        if quantity.is_some() || layout.is_some() || !channels.is_empty() || *differentiate {
            text += &format!("{quantity:?} {layout:?} {channels:?} {differentiate}");
        }
        text
    }
}
