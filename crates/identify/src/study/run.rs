//! A recorded run of a study: what is set before the script, what was measured, what is compared.

use super::recording::Recording;

/// What a run is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The parameters are fitted to it.
    Fit,
    /// Only to judge the result.
    Holdout,
}

/// A variable that is set before the script.
#[derive(Clone, Debug, PartialEq)]
pub enum Setting {
    /// A text.
    Text(String),
    /// A whole number.
    Whole(i64),
    /// A number.
    Number(f64),
    /// A list of texts.
    List(Vec<String>),
}

/// A recorded run.
#[derive(Clone, Debug)]
pub struct Run {
    /// Name.
    pub name: String,
    /// What it is for.
    pub role: Role,
    /// Variables that are set before the script.
    pub set: Vec<(String, Setting)>,
    /// What was measured, all columns.
    pub recording: Recording,
    /// The channels that the model is compared with.
    pub observe: Vec<Observe>,
}

impl Run {
    /// A variable that is set before the script, as a text.
    pub fn text(&self, name: &str) -> Option<String> {
        let (_, value) = self.set.iter().find(|(n, _)| n == name)?;
        Some(match value {
            Setting::Text(s) => s.clone(),
            Setting::Whole(i) => i.to_string(),
            Setting::Number(x) => format!("{x:?}"),
            Setting::List(words) => words.join(" "),
        })
    }

    /// The same, as a number.
    pub fn number(&self, name: &str) -> Option<f64> {
        self.text(name)?.parse().ok()
    }
}

/// A recorded channel and where the model has it.
#[derive(Clone, Debug)]
pub struct Observe {
    /// Column of the recording.
    pub channel: String,
    /// Its unit.
    pub unit: String,
    /// A recorder's file.
    pub output: String,
    /// Column of that file, from 0.
    pub column: usize,
    /// What the channel hangs on, in words; empty for none.
    pub at: String,
    /// Multiplies the NMSE in the objective.
    pub weight: f64,
    /// The samples, as many as times of the recording; NaN where one is missing.
    pub values: Vec<f64>,
    /// Their variance, about their mean and over their number.
    pub variance: f64,
}

/// Units of forces, and of stresses.
const FORCES: [&str; 6] = ["N", "kN", "MN", "lbf", "kip", "kips"];
const STRESSES: [&str; 4] = ["Pa", "kPa", "MPa", "ksi"];

impl Observe {
    /// Whether it is a force, by its unit.
    pub fn is_force(&self) -> bool {
        FORCES.contains(&self.unit.as_str())
    }

    /// Whether it is what a displacement is resisted with, by its unit or its name: loops are drawn of it.
    pub fn is_resistance(&self) -> bool {
        self.is_force() || STRESSES.contains(&self.unit.as_str()) || self.channel.contains("force")
    }
}
