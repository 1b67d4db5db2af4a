//! Faults of a channel that explain it where the model as it is does not.

use super::compare::Moments;
use super::lag::LagScan;
use super::motions::ImposedMotions;
use super::unit_ratio::{UnitRatio, may_be_acceleration, ratios};
use super::{Finding, FindingKind};
use crate::report::significant;
use crate::study::{ObservedChannel, Run};

/// Largest error with a fault, over the error without one.
const MAX_ERROR_RATIO: f64 = 0.25;
/// The same for a factor, if the simulation has another size than the recording at all points.
const MAX_SCALED_ERROR_RATIO: f64 = 0.6;
/// Factor between sizes that the ranges of the parameters do not explain.
const MIN_SIZE_RATIO: f64 = 2.2;
/// A gain of a sensor is smaller.
const MIN_HARD_GAIN: f64 = 5.0;
/// The same for a fault that does not stop a diagnosis.
const MAX_SOFT_ERROR_RATIO: f64 = 0.15;
/// Largest NMSE with a fault.
const MAX_NMSE: f64 = 0.5;
/// A simpler fault is preferred to one whose error is not smaller than this part of its own.
const PREFERENCE: f64 = 0.6;
/// A ratio with the unit of the header is preferred to another one whose error is not smaller than this part of its own.
const UNIT_PREFERENCE: f64 = 0.8;
/// Shortest delay that is no property of a sensor, in sampling intervals.
const MIN_HARD_LAG: f64 = 32.0;
/// Shortest delay that is worth a word, in sampling intervals.
const MIN_LAG: f64 = 3.0;

/// Digits of a ratio of units in a study.
const FACTOR_DIGITS: usize = 8;

/// A fault of a channel.
#[derive(Clone, Copy, Debug)]
enum Fault {
    Sign,
    /// Ratio of units, and 1 or -1.
    Unit(UnitRatio, f64),
    /// Any other factor.
    Gain,
    /// Index of the other channel.
    Swapped(usize),
    /// Sign of the ground acceleration that is added to the simulated one.
    Ground(f64),
    /// Delay of the recorded channel, s.
    Lag(f64),
}

/// A fault with the least error over all points.
#[derive(Clone, Copy, Debug)]
struct Explanation {
    fault: Fault,
    nmse: f64,
    /// Least-squares factor about the means, and correlation, at the point of that error.
    factor: f64,
    correlation: f64,
}

/// Faults of the channels of a run.
pub(super) struct ChannelFaults<'a> {
    run: &'a Run,
    /// Simulated channels by point.
    responses: &'a [&'a [Vec<f64>]],
    /// Least and largest size of each channel that the parameters can make, over that at the first point; empty if unknown.
    sizes: &'a [[f64; 2]],
    motions: &'a ImposedMotions,
}

impl<'a> ChannelFaults<'a> {
    pub(super) fn new(
        run: &'a Run,
        responses: &'a [&'a [Vec<f64>]],
        sizes: &'a [[f64; 2]],
        motions: &'a ImposedMotions,
    ) -> Self {
        Self { run, responses, sizes, motions }
    }

    /// Returns true if the parameters can make the size of a channel within their ranges.
    fn can_make_size(&self, k: usize) -> bool {
        let (Some([low, high]), Some(own)) = (self.sizes.get(k), self.responses.first()) else { return false };
        let factor = Moments::new(&self.run.observe[k].values, &own[k]).line()[0].abs();
        (*low..=*high).contains(&factor)
    }

    /// One finding at most for each channel. A measure of loops is no series of one instrument: it has none.
    pub(super) fn findings(&self) -> Vec<Finding> {
        let finding = |(k, o): (usize, &ObservedChannel)| {
            let without = self.least(k, |m| m.nmse(1.0));
            let explained = self.explanation(k, without).map(|e| self.finding(k, o, &e));
            explained.or_else(|| (without > 1.0).then(|| self.unexplained(o, without)))
        };
        let series = self.run.observe.iter().enumerate().filter(|(_, o)| o.measure.is_none());
        series.filter_map(finding).collect()
    }

    /// The simplest fault among those that explain a channel.
    fn explanation(&self, k: usize, without: f64) -> Option<Explanation> {
        let all = self.explanations(k);
        // A simulation that is much too small has an NMSE of 1, whatever its shape. Its factor shows the unit.
        let is_another_size = self.least(k, |m| m.line()[0].abs().ln().abs()) > MIN_SIZE_RATIO.ln();
        let can_make_size = self.can_make_size(k);
        let explains = |e: &Explanation| {
            // A small ratio is also one of a response to other parameters.
            let is_small = e.factor.abs().ln().abs() < MIN_HARD_GAIN.ln();
            let limit = match e.fault {
                Fault::Unit(..) | Fault::Gain if can_make_size => 0.0,
                Fault::Unit(..) | Fault::Gain if is_another_size && is_small => MAX_ERROR_RATIO * without.min(1.0),
                Fault::Unit(..) | Fault::Gain if is_another_size => MAX_SCALED_ERROR_RATIO * without,
                Fault::Gain => 0.0,
                _ => MAX_ERROR_RATIO * without,
            };
            e.nmse <= limit.min(MAX_NMSE)
        };
        let (gains, named): (Vec<_>, Vec<_>) =
            all.into_iter().filter(explains).partition(|e| matches!(e.fault, Fault::Gain));
        let least = named.iter().map(|e| e.nmse).fold(f64::INFINITY, f64::min);
        let simplest = named.into_iter().find(|e| PREFERENCE * e.nmse <= least).or(gains.first().copied())?;
        let is_hard = self.is_hard(k, &simplest);
        (is_hard || simplest.nmse <= MAX_SOFT_ERROR_RATIO * without).then_some(simplest)
    }

    /// Returns false for the delays and gains of sensors, which a diagnosis finds by itself.
    ///
    /// A viscous force is early by up to a quarter of a cycle, so that such a lead may be physics.
    fn is_hard(&self, k: usize, e: &Explanation) -> bool {
        match e.fault {
            Fault::Lag(seconds) if seconds < 0.0 && -seconds <= 0.25 * self.mean_period(k) => false,
            Fault::Lag(seconds) => seconds.abs() >= MIN_HARD_LAG * self.interval(),
            Fault::Gain => e.factor.abs().ln().abs() >= MIN_HARD_GAIN.ln(),
            _ => true,
        }
    }

    /// Mean period of the recorded channel about its mean, s; infinite if it does not come back.
    fn mean_period(&self, k: usize) -> f64 {
        let values: Vec<f64> = self.run.observe[k].values.iter().copied().filter(|v| v.is_finite()).collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let crossings = values.windows(2).filter(|w| (w[0] - mean) * (w[1] - mean) < 0.0).count();
        let times = &self.run.recording.times;
        2.0 * (times[times.len() - 1] - times[0]) / crossings as f64
    }

    /// Least value over all points.
    fn least(&self, k: usize, of: impl Fn(&Moments) -> f64) -> f64 {
        let values = &self.run.observe[k].values;
        self.responses.iter().map(|y| of(&Moments::new(values, &y[k]))).fold(f64::INFINITY, f64::min)
    }

    /// The best explanation of each kind, the simplest kind first.
    fn explanations(&self, k: usize) -> Vec<Explanation> {
        let o = &self.run.observe[k];
        let moments: Vec<Moments> = self.responses.iter().map(|y| Moments::new(&o.values, &y[k])).collect();
        let scaled = |fault: Fault, factor: f64| best(fault, moments.iter().map(|m| (m.nmse(factor), *m)));
        let mut out = vec![scaled(Fault::Sign, -1.0)];
        let units = ratios(&o.unit, &o.channel);
        let units = units.iter().flat_map(|r| [1.0, -1.0].map(|sign| scaled(Fault::Unit(*r, sign), sign * r.factor)));
        // Nearly equal ratios, such as 1000 and 980.7, are told apart by the header alone.
        let units: Vec<Explanation> = units.flatten().collect();
        let least = units.iter().map(|e| e.nmse).fold(f64::INFINITY, f64::min);
        out.push(units.into_iter().find(|e| UNIT_PREFERENCE * e.nmse <= least));
        let with_factor = moments.iter().map(|m| (m.nmse(m.line()[0]), *m));
        out.push(best(Fault::Gain, with_factor));
        out.extend((0..self.run.observe.len()).filter(|j| *j != k).map(|j| self.swapped(k, j)));
        if may_be_acceleration(&o.unit, &o.channel) {
            for ground in self.motions.accelerations() {
                for sign in [1.0, -1.0] {
                    let sums = self.responses.iter().map(|y| {
                        let sum: Vec<f64> = y[k].iter().zip(ground).map(|(y, g)| y + sign * g).collect();
                        let m = Moments::new(&o.values, &sum);
                        (m.nmse(1.0), m)
                    });
                    out.push(best(Fault::Ground(sign), sums));
                }
            }
        }
        out.push(self.late(k));
        out.into_iter().flatten().collect()
    }

    /// The exchange of two channels, with the larger of their errors.
    fn swapped(&self, k: usize, j: usize) -> Option<Explanation> {
        let [a, b] = [k, j].map(|i| &self.run.observe[i].values);
        let errors = self.responses.iter().map(|y| {
            let (here, there) = (Moments::new(a, &y[j]), Moments::new(b, &y[k]));
            (here.nmse(1.0).max(there.nmse(1.0)), here)
        });
        let other = self.least(j, |m| m.nmse(1.0));
        best(Fault::Swapped(j), errors).filter(|e| e.nmse <= MAX_ERROR_RATIO * other)
    }

    /// A delay of the channel.
    fn late(&self, k: usize) -> Option<Explanation> {
        let o = &self.run.observe[k];
        let times = &self.run.recording.times;
        let scans = self.responses.iter().filter_map(|y| {
            let scan = LagScan::new(times, &o.values, &y[k])?;
            let lag = scan.best();
            scan.identifies(lag.seconds).then(|| (lag, Moments::new(&o.values, &y[k])))
        });
        let (lag, m) = scans.min_by(|a, b| a.0.nmse.total_cmp(&b.0.nmse))?;
        let [factor, _] = m.line();
        let fault = Fault::Lag(lag.seconds);
        let is_visible = lag.seconds.abs() >= MIN_LAG * self.interval();
        is_visible.then(|| Explanation { fault, nmse: lag.nmse, factor, correlation: m.correlation() })
    }

    /// Mean sampling interval, s.
    fn interval(&self) -> f64 {
        let t = &self.run.recording.times;
        (t[t.len() - 1] - t[0]) / (t.len() - 1) as f64
    }

    /// The finding that no point of the ranges explains a channel.
    fn unexplained(&self, o: &ObservedChannel, nmse: f64) -> Finding {
        Finding {
            kind: FindingKind::Unexplained,
            is_hard: false,
            channel: o.channel.clone(),
            runs: vec![self.run.name.clone()],
            factor: None,
            lag_s: None,
            message: format!("NMSE {nmse:.2} or more within the ranges: the mean of the channel explains it better"),
            help: "check output, column and ranges".into(),
        }
    }

    fn finding(&self, k: usize, o: &ObservedChannel, e: &Explanation) -> Finding {
        let observed = "in its [[run.observe]]";
        let mut finding = Finding {
            kind: FindingKind::Sign,
            is_hard: self.is_hard(k, e),
            channel: o.channel.clone(),
            runs: vec![self.run.name.clone()],
            factor: None,
            lag_s: None,
            message: String::new(),
            help: String::new(),
        };
        match e.fault {
            Fault::Sign => {
                finding.factor = Some(e.factor);
                finding.message = format!(
                    "recorded = {:.3} x simulated, correlation {:.2}: is the sign turned?",
                    e.factor, e.correlation
                );
                finding.help = format!("factor = -1 {observed} turns it");
            }
            Fault::Unit(ratio, sign) => {
                finding.kind = FindingKind::Unit;
                finding.factor = Some(sign * ratio.factor);
                let turned = if sign < 0.0 { ", and the sign turned" } else { "" };
                finding.message = format!(
                    "recorded = {} x simulated, correlation {:.2}: {} for {}{turned}?",
                    significant(e.factor, 3),
                    e.correlation,
                    ratio.recorded,
                    ratio.model
                );
                finding.help =
                    format!("factor = {} {observed} converts it", significant(sign / ratio.factor, FACTOR_DIGITS));
            }
            Fault::Gain => {
                finding.kind = FindingKind::Unit;
                finding.factor = Some(e.factor);
                finding.message = format!(
                    "recorded = {} x simulated, correlation {:.2}: another unit or another gain?",
                    significant(e.factor, 3),
                    e.correlation
                );
                finding.help = format!("factor = {} {observed} removes it", significant(1.0 / e.factor, 3));
            }
            Fault::Swapped(j) => {
                let other = &self.run.observe[j].channel;
                finding.kind = FindingKind::Swapped;
                finding.message =
                    format!("recorded is what the model has for {other}, and the reverse: are they exchanged?");
                finding.help = "exchange the names of the two channels in the study".into();
            }
            Fault::Ground(sign) => {
                finding.kind = FindingKind::Acceleration;
                let [recorded, model] = if sign > 0.0 { ["absolute", "relative"] } else { ["relative", "absolute"] };
                let operator = if sign > 0.0 { "+" } else { "-" };
                finding.message = format!(
                    "recorded = simulated {operator} ground acceleration: the recorded acceleration is {recorded}, \
                     that of the recorder {model}"
                );
                finding.help = "recorder Node with -timeSeries TAG records absolute accelerations".into();
            }
            Fault::Lag(seconds) => {
                finding.kind = FindingKind::Lag;
                finding.lag_s = Some(seconds);
                let late = if seconds > 0.0 { "late" } else { "early" };
                finding.message = format!("recorded is {} s {late}: a trigger offset?", significant(seconds.abs(), 3));
                finding.help = format!("shift = {} {observed} moves it", significant(-seconds, 3));
            }
        }
        finding
    }
}

/// The explanation by a fault at the point with the least error.
fn best(fault: Fault, errors: impl Iterator<Item = (f64, Moments)>) -> Option<Explanation> {
    let (nmse, m) = errors.filter(|e| e.0.is_finite()).min_by(|a, b| a.0.total_cmp(&b.0))?;
    let [factor, _] = m.line();
    Some(Explanation { fault, nmse, factor, correlation: m.correlation() })
}
