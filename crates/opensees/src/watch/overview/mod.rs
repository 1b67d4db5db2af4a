//! A block of plausibility about the model that a check has gone through, and what in it cannot be meant.
//!
//! The facts are those of the first model of the script that is analysed: its loads when the static analysis under load
//! control is over, its masses and its first period when the script ends or forgets it.

mod record;
mod rules;

use hysteron_engine::analysis::{Engine, Kind, LinearEstimate, ModeRequest};
use hysteron_engine::model::PatternKind;
use hysteron_engine::series::Series;
use hysteron_tcl::diagnostic::{Diagnostic, Span};
use record::Peak;
use rules::{Gravity, vertical_axis};

/// Degrees of freedom up to which a check looks for a period and a static displacement.
const MAX_DOFS: usize = 30_000;
/// Excitations that the block lists.
const MAX_EXCITATIONS: usize = 10;

/// A line of the block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fact {
    /// The quantity.
    pub name: &'static str,
    /// Its value in words, in the units of the script.
    pub value: String,
}

/// What a check finds out about the first model that is analysed.
#[derive(Debug, Default)]
pub struct Overview {
    /// The block; empty without an analysis.
    pub facts: Vec<Fact>,
    /// What cannot be meant, to be reported at the end.
    pub(crate) findings: Vec<Diagnostic>,
    /// Series of records whose file says that they are in g, with the name of the file.
    pub(crate) records_in_g: Vec<(Series, String)>,
    /// Place of the first analysis.
    span: Option<Span>,
    /// A static analysis under load control has come to the present time.
    is_loaded: bool,
    /// Loads of the static analysis.
    statics: Option<LinearEstimate>,
    is_analysed: bool,
    is_closed: bool,
}

/// A number with four digits.
pub(crate) fn short(x: f64) -> String {
    let size = x.abs();
    if size != 0.0 && !(1e-3..1e6).contains(&size) {
        return format!("{x:.3e}");
    }
    let digits = if size < 1.0 { 5 } else { 3 - size.log10().floor().min(3.0) as usize };
    let text = format!("{x:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

impl Overview {
    /// The loads may change from here on: keep those of the static analysis.
    pub(crate) fn keep_statics(&mut self, engine: &mut Engine) {
        if std::mem::take(&mut self.is_loaded) && self.statics.is_none() && engine.model().dofs() <= MAX_DOFS {
            self.statics = engine.linear_estimate();
        }
    }

    /// An analysis begins.
    pub(crate) fn before_analysis(&mut self, engine: &mut Engine) {
        let goes_on = engine.setup().is_some_and(|s| s.kind == Kind::Static && s.integrator.elapses());
        if !goes_on && !self.is_closed {
            self.keep_statics(engine);
        }
    }

    /// An analysis has been rehearsed.
    pub(crate) fn after_analysis(&mut self, engine: &Engine, span: Option<Span>) {
        if self.is_closed {
            return;
        }
        self.note_analysis(span);
        self.is_loaded = engine.setup().is_some_and(|s| s.kind == Kind::Static && s.integrator.elapses());
    }

    /// The script analyses the model, or asks for its modes.
    pub(crate) fn note_analysis(&mut self, span: Option<Span>) {
        self.is_analysed = true;
        self.span = self.span.or(span);
    }

    /// The script forgets the model, or ends.
    pub(crate) fn close(&mut self, engine: &mut Engine) {
        if !self.is_analysed || std::mem::replace(&mut self.is_closed, true) {
            return;
        }
        self.keep_statics(engine);
        let ndm = engine.model().nodes.iter().map(|n| n.ndm()).max().unwrap_or(0);
        let mass = engine.moving_mass();
        let axis = vertical_axis(ndm, &mass, self.statics.as_ref());
        let gravity = Gravity::of(axis, &mass, self.statics.as_ref());
        let is_small = engine.model().dofs() <= MAX_DOFS;
        let period = if is_small && mass.iter().any(|m| *m != 0.0) { first_period(engine) } else { None };
        self.list_masses(&mass, axis, gravity.as_ref());
        if let Some(t) = period {
            self.add("first period", format!("{}, with the first stiffness", short(t)));
        }
        if let Some((node, dof, u)) = self.statics.as_ref().and_then(|s| s.displacement) {
            self.add(
                "static displacement",
                format!("{} at node {node} along {dof}, with the first stiffness", short(u)),
            );
        }
        let peaks = self.excitations(engine, gravity.as_ref());
        let found = rules::findings(engine, &mass, axis, gravity.as_ref(), period, self.statics.as_ref());
        let records = peaks.iter().filter_map(|peak| record::finding(peak, gravity.as_ref(), &self.records_in_g));
        self.findings = found.into_iter().chain(records).map(|d| d.place(self.span)).collect();
    }

    fn add(&mut self, name: &'static str, value: String) {
        self.facts.push(Fact { name, value });
    }

    fn list_masses(&mut self, mass: &[f64; 3], axis: Option<usize>, gravity: Option<&Gravity>) {
        let along = mass.iter().enumerate().filter(|(_, m)| **m != 0.0);
        let along: Vec<String> = along.map(|(i, m)| format!("{} along {}", short(*m), i + 1)).collect();
        self.add("moving mass", if along.is_empty() { "none".into() } else { along.join(", ") });
        let Some((axis, load)) = axis.zip(self.statics.as_ref().map(|s| s.load)).filter(|(i, load)| load[*i] != 0.0)
        else {
            return;
        };
        let beside = match gravity {
            Some(g) if g.known.is_some() => {
                format!(", and m g = {} with g = {}", short(g.mass * g.size()), short(g.size()))
            }
            Some(g) => format!(", which is {} for each unit of mass", short(g.ratio)),
            None => String::new(),
        };
        self.add("vertical reaction", format!("{} along {}{beside}", short(-load[axis]), axis + 1));
    }

    /// The excitations by records with their peaks, listed as facts.
    fn excitations(&mut self, engine: &Engine, gravity: Option<&Gravity>) -> Vec<Peak> {
        let mut peaks = vec![];
        for (tag, pattern) in &engine.model().patterns {
            let PatternKind::Uniform(e) = &pattern.kind else { continue };
            let Some(peak) = Peak::of(*tag, e) else { continue };
            if peaks.len() < MAX_EXCITATIONS {
                let known = gravity.filter(|g| g.known.is_some());
                let in_g = known.map_or_else(String::new, |g| format!(" ({} g)", short(peak.value.abs() / g.size())));
                let lasts = peak.end - e.accel.start();
                self.add(
                    "excitation",
                    format!(
                        "pattern {tag} along {}: peak {}{in_g} at {}, lasts {}",
                        e.direction + 1,
                        short(peak.value),
                        short(peak.time),
                        short(lasts)
                    ),
                );
            }
            peaks.push(peak);
        }
        peaks
    }
}

/// The longest period of the model. `None` where a mode has none.
fn first_period(engine: &mut Engine) -> Option<f64> {
    let modes = engine.find_modes(ModeRequest::smallest(1)).ok()?;
    let lambda = *modes.lambda.first()?;
    (lambda > 0.0 && lambda < f64::MAX).then(|| std::f64::consts::TAU / lambda.sqrt())
}
