//! Candidates whose last analyses are made side by side.

use super::script_simulator::{BegunRun, RunMode, ScriptSimulator};
use super::simulator::{Channels, SimulationError, Simulator as _};
use hysteron_opensees::lockstep::{self, Course, Execution};
use std::sync::atomic::Ordering;

/// Fewest candidates that are quicker side by side than one after the other.
const FEWEST: usize = 3;

impl ScriptSimulator {
    /// Channels of a run for several candidates. The script of each comes to its last analysis, and these are made side by
    /// side; where that is not possible, each by itself.
    pub(super) fn simulate_side_by_side(&mut self, run: usize, values: &[&[f64]]) -> Vec<Channels> {
        let Some(analysis) = self.limits[run].last_analysis.filter(|_| values.len() >= FEWEST) else {
            return values.iter().map(|v| self.simulate(run, v)).collect();
        };
        if self.stop.load(Ordering::Relaxed) {
            return vec![Err(SimulationError::Interrupted); values.len()];
        }
        while self.beside.len() < values.len() {
            let another = self.factory().simulator().keeping_observed();
            self.beside.push(another);
        }
        let mode = || RunMode { course: Some(Course::until(analysis)), ..RunMode::default() };
        let mut begun: Vec<BegunRun> =
            self.beside.iter().zip(values).map(|(s, v)| s.begin(run, Some(v), mode())).collect();
        let mut scripts: Vec<_> = begun.iter_mut().map(|b| &mut b.script).collect();
        let made = lockstep::analyze(&mut scripts);
        let channels = |(i, (begun, made)): (usize, (BegunRun, Execution))| {
            let simulator = &mut self.beside[i];
            let ended = begun.conclude();
            if made == Execution::No {
                return simulator.simulate(run, values[i]);
            }
            match simulator.error(&ended, run) {
                Some(error) => Err(error),
                None => simulator.channels(run),
            }
        };
        begun.into_iter().zip(made).enumerate().map(channels).collect()
    }
}
