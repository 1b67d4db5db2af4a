//! Gates of a repair: what cannot be whatever it explains, and what nobody can be sure of.
//!
//! The map from evidence to probabilities is fitted to trials. Physics, bounds and channels judge a repair whether or not the
//! trials held such a case: each gate limits the probability of its cause, and says why.

use super::changed_parameter::ChangedParameter;
use super::like_motion::RunMotions;
use super::plausibility::{eccentricity, impossible_heat};
use crate::candidate::channel_fault::ChannelFault;
use crate::candidate::variant::Variant;
use crate::evidence::holdout::{self, worsened_channel};
use crate::evidence::verdict_evidence::ProbabilityLimit;
use crate::fit::fitted::FittedHypothesis;
use crate::fit::projection::Projection;
use crate::fit::search_settings::is_at_bound;
use crate::hypothesis::changed_condition;
use crate::hypothesis::isolation_layer::{self, LayerLimit};
use crate::inspect::response::{ResponseHistory, ResponseRanges};
use crate::prior::{
    BOUND_PROBABILITY, BOUND_STEP, FOLLOWED_HISTORY_SHARE, LIKE_ERROR_RATIO, MAX_NOISE_OF_CONDITION,
    MAX_STRUCTURE_OF_CONDITION, MIN_BOUND_EFFECT, MIN_TAKEN_ERROR, PARAMETERS_IN_ONE_RUN_RATIO,
    SINGLE_SENSOR_PROBABILITY, TABLE_PROBABILITY, WORSENED_RATIO,
};
use crate::series::centred;
use hysteron_identify::study::{ObservedChannel, Role, Run, Score, ScoredRun, Study, objective};
use nalgebra::DMatrix;
use std::sync::Arc;

/// A repair before its gates.
pub(super) struct GatedRepair<'a> {
    pub(super) study: &'a Study,
    pub(super) variant: &'a Arc<Variant>,
    /// Its optimum: values of all parameters, and their unit point.
    pub(super) values: &'a [f64],
    pub(super) point: &'a [f64],
    /// The user's model as fitted.
    pub(super) baseline: &'a FittedHypothesis,
    /// Channels before and after it.
    pub(super) judged: &'a holdout::Repair<'a>,
    pub(super) responses: &'a ResponseRanges,
    /// Motions of the fitted runs.
    pub(super) motions: &'a RunMotions,
    /// True if it takes most of what differs where a motion repeats, and no other cause does.
    pub(super) told_by_repetition: bool,
    /// Diagonal of the box around all nodes.
    pub(super) extent: f64,
    /// NMSE of the noise in the fitted recordings; none if they do not show it.
    pub(super) noise: Option<f64>,
    /// NMSE that the repair leaves in the fitted runs.
    pub(super) left: f64,
    /// Channels of a variant in a run, at values of all of its parameters.
    pub(super) simulate: &'a Simulate<'a>,
}

/// Simulation of a variant in a run, at values of all of its parameters.
type Simulate<'a> = dyn Fn(&Arc<Variant>, usize, &[f64]) -> Option<ScoredRun> + 'a;

impl GatedRepair<'_> {
    /// Limits of the probability of its cause; none if all gates are open.
    pub(super) fn limits(&self) -> Vec<ProbabilityLimit> {
        let Some(proposal) = &self.variant.proposal else { return vec![] };
        let faults = self.variant.channel_faults(self.values);
        let limit = |most: f64| move |reason| ProbabilityLimit::new(proposal.cause, most, reason);
        let mut out: Vec<ProbabilityLimit> = vec![];
        out.extend(impossible_heat(self.variant, self.values, self.responses.largest_work()).map(limit(0.0)));
        out.extend(eccentricity(self.variant, self.values, self.extent).map(limit(0.0)));
        // A condition of one fitted run is none of the others, whose error follows the user's own parameters alone.
        let ratio = if self.variant.is_condition_of_one_run() { WORSENED_RATIO } else { holdout::WORSE_CHANNEL_RATIO };
        out.extend(worsened_channel(self.study, self.judged, ratio).map(|w| w.description()).map(limit(0.0)));
        out.extend(self.nothing_taken().map(limit(0.0)));
        out.extend(self.fault_at_limit().map(limit(0.0)));
        out.extend(faults.iter().find_map(|f| self.run_that_does_not_improve(f)).map(limit(0.0)));
        out.extend(faults.iter().find_map(|f| self.change_of_parameters(f)).map(limit(0.0)));
        out.extend(self.zero_that_follows_history(&faults).map(limit(0.0)));
        out.extend(self.condition_above_noise().map(limit(0.0)));
        out.extend(self.condition_with_structure().map(limit(BOUND_PROBABILITY)));
        out.extend(self.parameters_at_bounds().map(limit(BOUND_PROBABILITY)));
        out.extend(self.layer_that_isolates_nothing().map(limit(BOUND_PROBABILITY)));
        out.extend(self.measures_of_loops().map(limit(TABLE_PROBABILITY)));
        out.extend(faults.iter().find_map(|f| self.single_sensor(f)).map(limit(SINGLE_SENSOR_PROBABILITY)));
        out
    }

    /// Measures of loops among the fitted channels: rows of a table, which the evidence takes for samples.
    fn measures_of_loops(&self) -> Option<String> {
        let fitted = self.study.runs.iter().filter(|r| r.role == Role::Fit);
        let has = fitted.flat_map(|r| &r.observe).any(|o| o.measure.is_some());
        has.then(|| "measures of loops are fitted, which do not tell how certain a cause is".to_owned())
    }

    /// A repair that leaves what the user's model leaves, whatever a recording shows by itself.
    fn nothing_taken(&self) -> Option<String> {
        let before = self.baseline.fitted.objective;
        (self.left > (1.0 - MIN_TAKEN_ERROR) * before).then(|| "it takes nothing of the error away".to_owned())
    }

    /// A fault of a channel that is as large as the search allows.
    fn fault_at_limit(&self) -> Option<String> {
        let proposal = self.variant.proposal.as_ref()?;
        let own = self.variant.own_coordinates(self.point).len();
        let added = proposal.parameters.iter().zip(&self.point[own..]);
        let (first, _) = added.filter(|(a, _)| a.of_channel_fault).find(|(_, x)| is_at_bound(**x))?;
        let name = first.name.trim_start_matches("hy2_").trim_start_matches("hy_");
        Some(format!("the {name} of the channel is at the limit of its range"))
    }

    /// An isolation layer that is as stiff as the structure, or stays below its yield force.
    fn layer_that_isolates_nothing(&self) -> Option<String> {
        let proposal = self.variant.proposal.as_ref()?;
        let own = self.variant.own_coordinates(self.point).len();
        let at_end = |end: &LayerLimit| {
            let place = proposal.parameters.iter().position(|a| a.name == format!("hy_{}", end.parameter));
            let x = place.and_then(|k| self.point.get(own + k)).copied();
            x.is_some_and(|x| is_at_bound(x) && (x > 0.5) == end.is_upper)
        };
        let end = isolation_layer::LIMITS.iter().find(|end| proposal.cause == isolation_layer::CAUSE && at_end(end))?;
        Some(format!("{}: the layer isolates nothing", end.finding))
    }

    /// The user's parameters that arrive at a bound by the repair, and without which it would explain less.
    fn parameters_at_bounds(&self) -> Option<String> {
        let own = self.variant.own_coordinates(self.point);
        let unread = self.variant.unread_coordinates();
        let arrived = |k: &usize| {
            let before = self.baseline.fitted.point.get(*k).is_some_and(|x| is_at_bound(*x));
            is_at_bound(own[*k]) && !before && !unread.contains(k) && self.bound_matters(*k)
        };
        let names: Vec<&str> = self.variant.study.space.free_names().collect();
        let found: Vec<&str> = (0..own.len()).filter(arrived).map(|k| names[k]).collect();
        let verb = if found.len() == 1 { "your parameter" } else { "your parameters" };
        (!found.is_empty()).then(|| format!("it drives {verb} {} to a bound", found.join(", ")))
    }

    /// Returns true if the fit gets worse where a parameter leaves its bound.
    fn bound_matters(&self, coordinate: usize) -> bool {
        let error = |point: &[f64]| {
            let values = self.variant.study.space.values_at(point).ok()?;
            let runs = self.study.runs_of(Role::Fit);
            let scored: Option<Vec<ScoredRun>> = runs.map(|(r, _)| (self.simulate)(self.variant, r, &values)).collect();
            let scored = scored?;
            Some(objective(self.study, &scored.iter().collect::<Vec<_>>()))
        };
        let mut inside = self.point.to_vec();
        inside[coordinate] = inside[coordinate].clamp(BOUND_STEP, 1.0 - BOUND_STEP);
        match (error(self.point), error(&inside)) {
            (Some(at), Some(inside)) => inside > (1.0 + MIN_BOUND_EFFECT) * at,
            _ => true,
        }
    }

    /// A run held out that a fault of all runs does not improve, unless it is noise already.
    fn run_that_does_not_improve(&self, fault: &ChannelFault) -> Option<String> {
        if fault.run.is_some() || self.judged.visible_in_recording {
            return None;
        }
        let noise = holdout::expected_noise(self.study, self.judged);
        let worse = |(i, run): (usize, &Run)| {
            let c = run.observe.iter().position(|o| fault.affects(&run.name, &o.channel))?;
            let nmse = |fits: &[Option<ScoredRun>]| Some(fits[i].as_ref()?.scores[c].nmse);
            let (before, after) = (nmse(self.judged.before)?, nmse(self.judged.after)?);
            (after >= before && before > holdout::NOISE_MARGIN * noise(&run.observe[c])).then(|| {
                format!("the fault of {} makes the run {}, which was held out, no better", fault.channel, run.name)
            })
        };
        self.study.runs_of(Role::Holdout).find_map(worse)
    }

    /// A fault in one run that a change of the user's own parameters in that run explains as well.
    fn change_of_parameters(&self, fault: &ChannelFault) -> Option<String> {
        let name = fault.run.as_deref().filter(|_| !self.judged.visible_in_recording)?;
        if self.study.runs_of(Role::Fit).count() < 2 {
            return None;
        }
        let (number, run) = self.study.runs_of(Role::Fit).find(|(_, r)| r.name == name)?;
        let variant = &self.baseline.variant;
        let residual = |number: usize, point: &[f64]| {
            let values = variant.study.space.values_at(point).ok()?;
            Some(scaled_residual(&self.study.runs[number], &(self.simulate)(variant, number, &values)?))
        };
        let at = |point: &[f64]| residual(number, point);
        let point = &self.baseline.fitted.point;
        let own = at(point)?;
        let columns: Vec<Vec<f64>> = (0..point.len())
            .map(|k| {
                let mut moved = point.clone();
                moved[k] += if point[k] > 0.5 { -BOUND_STEP } else { BOUND_STEP };
                let step = moved[k] - point[k];
                Some(at(&moved)?.iter().zip(&own).map(|(a, b)| (a - b) / step).collect())
            })
            .collect::<Option<_>>()?;
        let j = DMatrix::from_fn(own.len(), columns.len(), |i, k| columns[k][i]);
        let left: f64 = Projection::new(&own, j)?.remaining(&own)?.iter().map(|x| x * x).sum();
        let repaired = scaled_residual(run, self.judged.after[number].as_ref()?);
        let with_fault: f64 = repaired.iter().map(|x| x * x).sum();
        let enough = PARAMETERS_IN_ONE_RUN_RATIO * with_fault;
        let others: Vec<usize> = self.study.runs_of(Role::Fit).map(|(i, _)| i).filter(|i| *i != number).collect();
        let name_of = |i: usize| self.study.runs[i].name.clone();
        let space = &variant.study.space;
        if let Some(changed) = ChangedParameter::find(space, point, (number, &others), enough, residual, name_of) {
            return Some(changed.description());
        }
        (left <= enough).then(|| format!("other values of your own parameters in the run {name} explain as much"))
    }

    /// The run with other values, and one of like motion with the usual values and an error that is hardly less. All that differs
    /// between the two is the condition, whatever the model lacks in both.
    fn runs_of_like_motion(&self) -> Option<[&str; 2]> {
        let name = self.variant.proposal.as_ref()?.condition.as_ref()?.run.as_ref()?;
        let fitted: Vec<(usize, &Run)> = self.study.runs_of(Role::Fit).collect();
        let (changed, own) = fitted.iter().find(|(_, r)| r.name == *name)?;
        let is_like = |i: usize| self.motions.are_alike(*changed, i) && self.has_error_of(*changed, i);
        let (_, other) = fitted.iter().find(|(i, _)| i != changed && is_like(*i))?;
        Some([&own.name, &other.name])
    }

    /// The reason for a changed condition although the model lacks more, in words; empty for other causes, or without one.
    pub(super) fn like_motion_in_words(&self) -> String {
        if self.variant.cause() != changed_condition::CAUSE {
            return String::new();
        }
        if self.told_by_repetition {
            let is_in_time = !self.variant.change_point_coordinates().is_empty();
            let what = if is_in_time { "the cycles of a steady motion" } else { "runs of one motion" };
            return format!(" It takes most of what differs between {what}, and no other cause does.");
        }
        self.runs_of_like_motion().map_or_else(String::new, |[changed, other]| {
            format!(" The runs {changed} and {other} move alike, so that neither amplitude nor rate tells them apart.")
        })
    }

    /// Returns true if no channel of a run has a clearly larger error than in another run, as a share or in its unit.
    fn has_error_of(&self, run: usize, other: usize) -> bool {
        let [own, others] = [run, other].map(|i| &self.study.runs[i].observe);
        let Some((fit, fit_of_other)) = self.judged.after[run].as_ref().zip(self.judged.after[other].as_ref()) else {
            return false;
        };
        let is_alike = |(o, score): (&ObservedChannel, &Score)| {
            let place = others.iter().position(|x| x.channel == o.channel);
            place.is_none_or(|c| {
                let share = fit_of_other.scores[c].nmse;
                score.nmse <= LIKE_ERROR_RATIO * share.max(share * others[c].variance / o.variance)
            })
        };
        own.iter().zip(&fit.scores).all(is_alike)
    }

    /// Returns true for another value of a parameter that neither a run nor cycles of like motion tell.
    fn is_condition_alone(&self) -> bool {
        let is_told = self.told_by_repetition || self.runs_of_like_motion().is_some();
        self.variant.cause() == changed_condition::CAUSE && !is_told
    }

    /// Another value of a parameter that leaves many times the noise: the model lacks more than a value.
    fn condition_above_noise(&self) -> Option<String> {
        let times = self.left / self.noise?;
        (times > MAX_NOISE_OF_CONDITION && self.is_condition_alone())
            .then(|| format!("the other value leaves {times:.0} times the noise of the recordings"))
    }

    /// Another value of a parameter that leaves structure. A model that is whole but for the value would leave none, and a
    /// value of its own for a run takes much from any effect that differs by run.
    fn condition_with_structure(&self) -> Option<String> {
        let structured = self.judged.structured_share > MAX_STRUCTURE_OF_CONDITION;
        (structured && self.is_condition_alone()).then(|| "the other value leaves more than noise".to_owned())
    }

    /// A wandering zero that follows what the motion has left behind: no instrument does.
    fn zero_that_follows_history(&self, faults: &[ChannelFault]) -> Option<String> {
        let wandering: Vec<&ChannelFault> = faults.iter().filter(|f| f.drift.len() > 2).collect();
        let curves: Vec<(Vec<f64>, [Vec<f64>; 3])> = wandering
            .iter()
            .filter_map(|f| {
                let (number, _) =
                    self.study.runs_of(Role::Fit).find(|(_, r)| f.run.as_deref() == Some(r.name.as_str()))?;
                let history = self.most_deformed(number)?;
                let at_knots = |series: Vec<f64>| -> Vec<f64> {
                    let index = |t: f64| history.times.partition_point(|x| *x < t).min(series.len() - 1);
                    centred(f.drift.iter().map(|[t, _]| series[index(*t)]).collect())
                };
                let zeros = centred(f.drift.iter().map(|[_, y]| *y).collect());
                Some((zeros, left_behind(&history.deformation).map(at_knots)))
            })
            .collect();
        let follows = |k: usize| {
            let (mut product, mut of_zero, mut of_history) = (0.0, 0.0, 0.0);
            for (zero, history) in curves.iter().map(|(zero, all)| (zero, &all[k])) {
                for (z, h) in zero.iter().zip(history) {
                    product += z * h;
                    of_zero += z * z;
                    of_history += h * h;
                }
            }
            product * product > FOLLOWED_HISTORY_SHARE * of_zero * of_history && of_history > 0.0
        };
        let channel = &wandering.first()?.channel;
        (0..3).any(follows).then(|| format!("the zero of {channel} follows the history of the motion"))
    }

    /// History of the device that deforms most in a run.
    fn most_deformed(&self, run: usize) -> Option<&ResponseHistory> {
        let of_run =
            self.responses.histories.iter().filter(|((r, _, d), h)| *r == run && *d <= 3 && !h.times.is_empty());
        of_run.map(|(_, h)| h).max_by(|a, b| a.range().deformation.total_cmp(&b.range().deformation))
    }

    /// A fault of a sensor beside which no other channel shows the same quantity.
    fn single_sensor(&self, fault: &ChannelFault) -> Option<String> {
        if self.judged.visible_in_recording {
            return None;
        }
        let is_redundant = |(i, run): (usize, &Run)| {
            let fits = self.judged.before[i].as_ref();
            let Some(c) = run.observe.iter().position(|o| o.channel == fault.channel) else { return false };
            let channels = fits.map(|f| &f.channels[..]).unwrap_or_default();
            let others = channels.iter().enumerate().filter(|(k, _)| *k != c);
            channels.get(c).is_some_and(|own| others.into_iter().any(|(_, other)| are_same(own, other)))
        };
        let redundant = self.study.runs.iter().enumerate().any(is_redundant);
        (!redundant).then(|| format!("no second instrument shows what {} shows", fault.channel))
    }
}

/// Residuals of all channels of a run over their standard deviations; missing samples are 0.
fn scaled_residual(run: &Run, fit: &ScoredRun) -> Vec<f64> {
    let of = |(o, y): (&ObservedChannel, &Vec<f64>)| -> Vec<f64> {
        let scale = o.variance.sqrt();
        y.iter().zip(&o.values).map(|(y, v)| (y - v) / scale).map(|r| if r.is_finite() { r } else { 0.0 }).collect()
    };
    run.observe.iter().zip(&fit.channels).flat_map(of).collect()
}

/// Least squared correlation of two simulated channels that show one quantity.
const SAME_QUANTITY: f64 = 0.99;

/// Returns true if two simulated channels are proportional.
fn are_same(a: &[f64], b: &[f64]) -> bool {
    let finite: Vec<(f64, f64)> =
        a.iter().copied().zip(b.iter().copied()).filter(|(a, b)| a.is_finite() && b.is_finite()).collect();
    let (a, b): (Vec<f64>, Vec<f64>) = finite.into_iter().unzip();
    let (a, b) = (centred(a), centred(b));
    let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
    dot(&a, &b).powi(2) > SAME_QUANTITY * dot(&a, &a) * dot(&b, &b)
}

/// What a motion leaves behind at each sample: the middle of its extremes so far, their size, and its mean so far.
fn left_behind(deformation: &[f64]) -> [Vec<f64>; 3] {
    let (mut low, mut high, mut sum) = (0.0f64, 0.0f64, 0.0);
    let (mut middle, mut size, mut mean) = (vec![], vec![], vec![]);
    for (i, u) in deformation.iter().map(|u| if u.is_finite() { *u } else { 0.0 }).enumerate() {
        (low, high) = (low.min(u), high.max(u));
        sum += u;
        middle.push(0.5 * (low + high));
        size.push(high.max(-low));
        mean.push(sum / (i + 1) as f64);
    }
    [middle, size, mean]
}

#[cfg(test)]
mod tests {
    use super::{are_same, left_behind};

    #[test]
    fn a_motion_leaves_its_extremes_behind() {
        let [middle, size, mean] = left_behind(&[0.0, 2.0, -1.0, f64::NAN]);
        assert_eq!(middle, [0.0, 1.0, 0.5, 0.5]);
        assert_eq!(size, [0.0, 2.0, 2.0, 2.0]);
        assert_eq!(mean, [0.0, 1.0, 1.0 / 3.0, 0.25]);
    }

    #[test]
    fn proportional_channels_show_one_quantity() {
        let a: Vec<f64> = (0..100).map(|i| (0.1 * f64::from(i)).sin()).collect();
        let b: Vec<f64> = a.iter().map(|x| 3.0 - 2.0 * x).collect();
        let c: Vec<f64> = (0..100).map(|i| (0.1 * f64::from(i)).cos()).collect();
        assert!(are_same(&a, &b) && !are_same(&a, &c));
    }
}
