//! Capacities of records, and fragility functions of limit states.

use super::{Ending, Point};
use crate::fragility::{Fit, Observation};
use crate::isolate::Study;
use hysteron_identify::report::{Cell, Table};

/// Analyses of one motion at one bound, by rising level.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// Bound.
    pub bound: &'static str,
    /// Index of the motion.
    pub motion: usize,
    /// The analyses.
    pub points: Vec<Point>,
}

impl Trace {
    /// Capacity of a limit state: interpolated between complete analyses, else the gap that it lies in. None if no analysis
    /// tells anything.
    pub fn capacity(&self, state: usize, limit: f64) -> Option<Observation> {
        let first = self.points.iter().position(|p| p.reached[state] == Some(true));
        let below = &self.points[..first.unwrap_or(self.points.len())];
        let low = below.iter().rev().find(|p| p.reached[state] == Some(false));
        let (low, high) = match (low, first.map(|i| &self.points[i])) {
            (None, None) => return None,
            (Some(low), None) => return Some(Observation::Above(low.level)),
            (None, Some(high)) => return Some(Observation::Below(high.level)),
            (Some(low), Some(high)) => (low, high),
        };
        let (d0, d1) = (low.demands[state], high.demands[state]);
        let complete = low.ending == Ending::Complete && high.ending == Ending::Complete;
        // A limit of zero is left at an unknown place of the gap: the demand is zero before.
        if complete && limit > 0.0 && d1 > d0 {
            let share = (limit - d0) / (d1 - d0);
            return Some(Observation::Exact(low.level + share * (high.level - low.level)));
        }
        Some(Observation::Between(low.level, high.level))
    }
}

/// Fragility function of a limit state at a bound.
#[derive(Clone, Debug)]
pub struct StateFit {
    /// Bound.
    pub bound: &'static str,
    /// Index of the limit state.
    pub state: usize,
    /// The function, or the reason why there is none.
    pub fit: Result<Fit, String>,
    /// Points beside the curve: of stripes the share that reached the limit state, of records their capacities with
    /// plotting positions (i - 1/2)/n.
    pub observed: Vec<(f64, f64)>,
    /// Capacities by motion, where records were hunted.
    pub capacities: Vec<(usize, Option<Observation>)>,
    /// Analyses or records that reached it, did not, and are unknown.
    pub counts: [usize; 3],
}

/// Results of incremental analyses or stripes.
#[derive(Clone, Debug)]
pub struct Summary {
    /// True for stripes.
    pub stripes: bool,
    /// Intensities of the motions as the study scales them.
    pub intensities: Vec<f64>,
    /// The analyses.
    pub traces: Vec<Trace>,
    /// Fragility functions by bound and limit state.
    pub fits: Vec<StateFit>,
}

/// Fits of all limit states.
pub fn summary(study: &Study, traces: Vec<Trace>, intensities: Vec<f64>, stripes: bool) -> Summary {
    let mut fits = vec![];
    for bound in super::bounds(study) {
        let of: Vec<&Trace> = traces.iter().filter(|t| t.bound == bound).collect();
        for (state, s) in study.performance.limit_states.iter().enumerate() {
            fits.push(if stripes { by_stripes(bound, state, &of) } else { by_capacities(bound, state, s.limit, &of) });
        }
    }
    Summary { stripes, intensities, traces, fits }
}

fn by_stripes(bound: &'static str, state: usize, traces: &[&Trace]) -> StateFit {
    let mut levels: Vec<f64> = traces.iter().flat_map(|t| t.points.iter().map(|p| p.level)).collect();
    levels.sort_by(f64::total_cmp);
    levels.dedup();
    let (mut data, mut observed, mut counts) = (vec![], vec![], [0; 3]);
    for level in levels {
        let at = traces.iter().flat_map(|t| &t.points).filter(|p| p.level == level);
        let answers: Vec<Option<bool>> = at.map(|p| p.reached[state]).collect();
        let count = |of: Option<bool>| answers.iter().filter(|a| **a == of).count();
        let (yes, no) = (count(Some(true)), count(Some(false)));
        counts = [counts[0] + yes, counts[1] + no, counts[2] + count(None)];
        data.extend([(yes as f64, Observation::Below(level)), (no as f64, Observation::Above(level))]);
        if yes + no > 0 {
            observed.push((level, yes as f64 / (yes + no) as f64));
        }
    }
    StateFit { bound, state, fit: Fit::new(&data), observed, capacities: vec![], counts }
}

fn by_capacities(bound: &'static str, state: usize, limit: f64, traces: &[&Trace]) -> StateFit {
    let capacities: Vec<(usize, Option<Observation>)> =
        traces.iter().map(|t| (t.motion, t.capacity(state, limit))).collect();
    let known: Vec<Observation> = capacities.iter().filter_map(|c| c.1).collect();
    let data: Vec<(f64, Observation)> = known.iter().map(|o| (1.0, *o)).collect();
    let censored = known.iter().filter(|o| matches!(o, Observation::Above(_))).count();
    let counts = [known.len() - censored, censored, capacities.len() - known.len()];
    let mut at: Vec<f64> = known.iter().filter_map(place).collect();
    at.sort_by(f64::total_cmp);
    let n = known.len() as f64;
    let observed = at.iter().enumerate().map(|(i, x)| (*x, (i as f64 + 0.5) / n)).collect();
    StateFit { bound, state, fit: Fit::new(&data), observed, capacities, counts }
}

/// Place of a capacity in a picture; none if it was not reached.
fn place(o: &Observation) -> Option<f64> {
    match *o {
        Observation::Exact(x) | Observation::Below(x) => Some(x),
        Observation::Between(x, y) => Some((x * y).sqrt()),
        Observation::Above(_) => None,
    }
}

fn cell(x: f64) -> Cell {
    if x.is_finite() { Cell::Number(x) } else { Cell::Word("-") }
}

impl Summary {
    /// Medians and dispersions with their intervals.
    pub fn fit_table(&self, study: &Study) -> Table {
        let counted = if self.stripes { "analyses" } else { "records" };
        let mut table = Table::new([
            ("bound", ""),
            ("limit state", ""),
            ("median", ""),
            ("from", ""),
            ("to", ""),
            ("beta", ""),
            ("beta from", ""),
            ("beta to", ""),
            ("reached", counted),
            ("not", counted),
            ("unknown", counted),
            ("remark", ""),
        ]);
        for f in &self.fits {
            let fit = f.fit.clone().unwrap_or(Fit {
                median: f64::NAN,
                dispersion: f64::NAN,
                median_interval: [f64::NAN; 2],
                dispersion_interval: [f64::NAN; 2],
                ..Fit::default()
            });
            let mut row = vec![Cell::Word(f.bound), study.performance.limit_states[f.state].name.clone().into()];
            row.extend([fit.median, fit.median_interval[0], fit.median_interval[1]].map(cell));
            row.extend([fit.dispersion, fit.dispersion_interval[0], fit.dispersion_interval[1]].map(cell));
            row.extend(f.counts.map(|n| Cell::Number(n as f64)));
            row.push(f.fit.as_ref().err().cloned().unwrap_or_default().into());
            table.rows.push(row);
        }
        table
    }

    /// Capacities of records by limit state, where records were hunted.
    pub fn capacity_table(&self, study: &Study) -> Table {
        let mut table = Table::new([
            ("bound", ""),
            ("limit state", ""),
            ("motion", ""),
            ("capacity", ""),
            ("from", ""),
            ("to", ""),
        ]);
        for f in &self.fits {
            for (motion, o) in &f.capacities {
                let [x, low, high] = match *o {
                    None => [f64::NAN; 3],
                    Some(Observation::Exact(x)) => [x, x, x],
                    Some(Observation::Between(x, y)) => [f64::NAN, x, y],
                    Some(Observation::Above(x)) => [f64::NAN, x, f64::INFINITY],
                    Some(Observation::Below(x)) => [f64::NAN, 0.0, x],
                };
                table.rows.push(vec![
                    Cell::Word(f.bound),
                    study.performance.limit_states[f.state].name.clone().into(),
                    study.motions[*motion].components[0].name.clone().into(),
                    cell(x),
                    cell(low),
                    cell(high),
                ]);
            }
        }
        table
    }

    /// All analyses with their demands.
    pub fn point_table(&self, study: &Study) -> Table {
        let mut table = Table::new([("bound", ""), ("motion", ""), ("intensity", ""), ("end", "")]);
        let [force, length] = &study.units;
        for s in study.performance.limit_states.iter().filter(|s| s.quantity != "collapse") {
            let kind = crate::performance::QUANTITIES.iter().find(|q| q.0 == s.quantity).map_or("", |q| q.1);
            let unit = match kind {
                "length" => length.as_str(),
                "force" => force.as_str(),
                other => other,
            };
            let column = hysteron_identify::report::Column { name: s.name.clone().into(), unit: unit.to_owned() };
            table.columns.push(column);
        }
        for t in &self.traces {
            for p in &t.points {
                let name = study.motions[t.motion].components[0].name.clone();
                let mut row = vec![Cell::Word(t.bound), name.into(), p.level.into(), Cell::Word(p.ending.word())];
                let states = study.performance.limit_states.iter().zip(&p.demands);
                row.extend(states.filter(|(s, _)| s.quantity != "collapse").map(|(_, d)| cell(*d)));
                table.rows.push(row);
            }
        }
        table
    }
}

#[cfg(test)]
mod tests {
    use super::{Observation, Trace, by_stripes};
    use crate::incremental::{Ending, Point};

    fn point(level: f64, demand: f64, limit: f64, ending: Ending) -> Point {
        let reached = match ending {
            Ending::Collapsed => Some(true),
            Ending::Complete => Some(demand > limit),
            Ending::Unresolved => (demand > limit).then_some(true),
        };
        Point { level, ending, failure: String::new(), demands: vec![demand], reached: vec![reached] }
    }

    #[test]
    fn capacities_are_interpolated_bracketed_or_censored() {
        use Ending::{Collapsed, Complete, Unresolved};
        let capacity = |points: &[(f64, f64, Ending)]| {
            let points = points.iter().map(|(l, d, e)| point(*l, *d, 0.3, *e)).collect();
            Trace { bound: "nominal", motion: 0, points }.capacity(0, 0.3)
        };
        let exact = capacity(&[(1.0, 0.2, Complete), (2.0, 0.4, Complete), (3.0, 0.2, Complete)]);
        assert!(matches!(exact, Some(Observation::Exact(x)) if (x - 1.5).abs() < 1e-12));
        let gap = capacity(&[(1.0, 0.2, Complete), (2.0, 9.0, Collapsed)]);
        assert_eq!(gap, Some(Observation::Between(1.0, 2.0)));
        // An analysis that did not converge below the limit says nothing.
        let open = capacity(&[(1.0, 0.2, Complete), (2.0, 0.25, Unresolved)]);
        assert_eq!(open, Some(Observation::Above(1.0)));
        assert_eq!(capacity(&[(2.0, 0.25, Unresolved)]), None);
        assert_eq!(capacity(&[(2.0, 0.35, Unresolved)]), Some(Observation::Below(2.0)));
    }

    #[test]
    fn stripes_leave_unresolved_analyses_out() {
        use Ending::{Complete, Unresolved};
        let trace = |motion: usize, d: [f64; 3], last: Ending| Trace {
            bound: "nominal",
            motion,
            points: vec![point(1.0, d[0], 0.3, Complete), point(2.0, d[1], 0.3, Complete), point(3.0, d[2], 0.3, last)],
        };
        let traces = [
            trace(0, [0.1, 0.2, 0.4], Complete),
            trace(1, [0.1, 0.4, 0.2], Unresolved),
            trace(2, [0.35, 0.2, 0.5], Complete),
            trace(3, [0.1, 0.4, 0.2], Complete),
        ];
        let f = by_stripes("nominal", 0, &traces.iter().collect::<Vec<_>>());
        assert_eq!(f.counts, [5, 6, 1]);
        assert_eq!(f.observed, [(1.0, 0.25), (2.0, 0.5), (3.0, 2.0 / 3.0)]);
        assert!(f.fit.is_ok());
    }
}
