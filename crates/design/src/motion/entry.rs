//! Tables `[[motion]]` of studies and plans.

use super::read::ReadOptions;
use hysteron_recordings::{Layout, UserStatements, Way};
use serde::Deserialize;

/// The files of a motion, and what they do not say themselves.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct MotionEntry {
    /// Name; that of the first component without it.
    pub(crate) name: Option<String>,
    /// Files of the components: one or two horizontal ones, and a third that is vertical.
    pub(crate) files: Vec<String>,
    /// Factor on the motion.
    #[serde(default = "one")]
    pub(crate) factor: f64,
    /// Unit, where the files do not say it.
    unit: Option<String>,
    /// Step of time in s, where the files do not say it.
    dt: Option<f64>,
    /// Quantity, where the files do not say it: `acceleration`, `velocity` or `displacement`.
    quantity: Option<String>,
    /// Layout of the numbers, where it is not recognised.
    layout: Option<String>,
    /// Channels of the files, by name or number from 1; all without them.
    #[serde(default)]
    channels: Vec<String>,
    /// True if velocities or displacements are to be differentiated.
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
        let (unit, quantity) = (self.unit.clone(), self.quantity.clone());
        let told = UserStatements { unit, dt: self.dt, quantity, layout, way: Way::Study };
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
