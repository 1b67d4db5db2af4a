//! A recorded run of a study.

use super::loop_measure::LoopMeasure;
use hysteron_recordings::Recording;

/// Use of a run in the study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The parameters are calibrated with it.
    Fit,
    /// It validates the result only.
    Holdout,
}

/// Value of a Tcl variable that is set before the script runs.
#[derive(Clone, Debug, PartialEq)]
pub enum Setting {
    /// Text.
    Text(String),
    /// Integer.
    Whole(i64),
    /// Real number.
    Number(f64),
    /// List of texts.
    List(Vec<String>),
}

/// A recorded run.
#[derive(Clone, Debug)]
pub struct Run {
    /// Name.
    pub name: String,
    /// Use of the run.
    pub role: Role,
    /// Variables that are set before the script runs.
    pub set: Vec<(String, Setting)>,
    /// All measured channels.
    pub recording: Recording,
    /// The channels that the model is compared with: `[[run.observe]]`.
    pub observe: Vec<ObservedChannel>,
}

impl Run {
    /// The value of a variable of [`Run::set`] as a text.
    pub fn text(&self, name: &str) -> Option<String> {
        let (_, value) = self.set.iter().find(|(n, _)| n == name)?;
        Some(match value {
            Setting::Text(s) => s.clone(),
            Setting::Whole(i) => i.to_string(),
            Setting::Number(x) => format!("{x:?}"),
            Setting::List(words) => words.join(" "),
        })
    }

    /// The value of a variable of [`Run::set`] as a number.
    pub fn number(&self, name: &str) -> Option<f64> {
        self.text(name)?.parse().ok()
    }
}

/// A recorded channel and the recorder column of the model that is compared with it.
#[derive(Clone, Debug)]
pub struct ObservedChannel {
    /// Name of the column of the recording.
    pub channel: String,
    /// Unit of the samples; empty if it is not known.
    pub unit: String,
    /// File of a recorder of the script.
    pub output: String,
    /// Column of that file, from 0.
    pub column: usize,
    /// The measure of the loops of the column over a deformation; `None` if the column itself is compared.
    pub measure: Option<LoopMeasure>,
    /// Location of the sensor, in words; empty for none.
    pub at: String,
    /// Weight of the NMSE of this channel in the objective.
    pub weight: f64,
    /// Shift in s: a sample at the recorded time t is compared with the model at t + shift.
    pub shift: f64,
    /// Samples as they are compared with the model: converted to the unit of its output, times the factor, plus the
    /// offset. One for each time of the recording; NaN where one is missing.
    pub values: Vec<f64>,
    /// Population variance of these samples; their mean square for measures of loops, whose error is relative.
    pub variance: f64,
}

/// Units of force.
const FORCE_UNITS: [&str; 6] = ["N", "kN", "MN", "lbf", "kip", "kips"];
/// Units of stress.
const STRESS_UNITS: [&str; 4] = ["Pa", "kPa", "MPa", "ksi"];

impl ObservedChannel {
    /// Returns true if the channel has forces, by their unit.
    pub fn is_force(&self) -> bool {
        self.measure.is_none() && FORCE_UNITS.contains(&self.unit.as_str())
    }

    /// Returns true if the channel is a resisting force or stress, by its unit or its name. Reports draw its loops.
    pub fn is_resistance(&self) -> bool {
        let by_name = STRESS_UNITS.contains(&self.unit.as_str()) || self.channel.contains("force");
        self.is_force() || self.measure.is_none() && by_name
    }
}
