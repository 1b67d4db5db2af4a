//! Settings of the server.

use serde_json::Value as Json;
use std::time::Duration;

/// Settings of the server: what an editor gives as `initializationOptions`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Time that a check may take.
    pub time_limit: Duration,
    /// Memory of the program at which a check ends, in bytes.
    pub max_memory: usize,
    /// Reproduce errors of OpenSees.
    pub compat: bool,
    /// Offer lenses, whose commands the editor has to know.
    pub lenses: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self { time_limit: Duration::from_secs(10), max_memory: 4 << 30, compat: false, lenses: false }
    }
}

impl Settings {
    /// The settings with those that an editor gives.
    pub(crate) fn with(self, options: &Json) -> Self {
        let flag = |name: &str, own: bool| options.get(name).and_then(Json::as_bool).unwrap_or(own);
        let seconds = options.get("timeLimit").and_then(Json::as_f64).filter(|s| *s > 0.0 && *s < 1e6);
        Self {
            time_limit: seconds.map_or(self.time_limit, Duration::from_secs_f64),
            compat: flag("compat", self.compat),
            lenses: flag("lenses", self.lenses),
            ..self
        }
    }
}
