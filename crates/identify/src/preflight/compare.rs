//! Statistics of a recorded and a simulated channel.

use super::lag::LagScan;
use super::{ChannelCheck, Finding, FindingKind};
use crate::study::{ObservedChannel, Run, Study, score};

/// Share of samples after the analysis that is worth a word.
const MIN_DROPPED: f64 = 0.02;
/// Share of samples after the analysis with which a comparison means little.
const MAX_DROPPED: f64 = 0.5;
/// Work of a force, over that of its range through the range of the displacement, that is no noise.
const MIN_WORK: f64 = 0.3;

/// Sums of a recorded and a simulated series over the samples that both have.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Moments {
    n: f64,
    recorded: f64,
    simulated: f64,
    recorded_squares: f64,
    simulated_squares: f64,
    products: f64,
}

impl Moments {
    pub(super) fn new(recorded: &[f64], simulated: &[f64]) -> Self {
        let mut m = Self::default();
        for (v, y) in recorded.iter().zip(simulated).filter(|(v, y)| v.is_finite() && y.is_finite()) {
            m.n += 1.0;
            m.recorded += v;
            m.simulated += y;
            m.recorded_squares += v * v;
            m.simulated_squares += y * y;
            m.products += v * y;
        }
        m
    }

    fn covariance(&self) -> f64 {
        self.products / self.n - self.recorded / self.n * (self.simulated / self.n)
    }

    fn recorded_variance(&self) -> f64 {
        (self.recorded_squares / self.n - (self.recorded / self.n).powi(2)).max(0.0)
    }

    fn simulated_variance(&self) -> f64 {
        (self.simulated_squares / self.n - (self.simulated / self.n).powi(2)).max(0.0)
    }

    /// Correlation coefficient; 0 if a series is constant.
    pub(super) fn correlation(&self) -> f64 {
        let product = (self.recorded_variance() * self.simulated_variance()).sqrt();
        if product > 0.0 { (self.covariance() / product).clamp(-1.0, 1.0) } else { 0.0 }
    }

    /// Least-squares factor and offset of recorded ≈ factor × simulated + offset; a factor of 0 if the simulation is constant.
    pub(super) fn line(&self) -> [f64; 2] {
        let variance = self.simulated_variance();
        let factor = if variance > 0.0 { self.covariance() / variance } else { 0.0 };
        [factor, (self.recorded - factor * self.simulated) / self.n]
    }

    /// Mean of (factor × simulated - recorded)² over the variance of the recorded samples.
    pub(super) fn nmse(&self, factor: f64) -> f64 {
        let sum = factor * factor * self.simulated_squares - 2.0 * factor * self.products + self.recorded_squares;
        sum.max(0.0) / self.n / self.recorded_variance()
    }
}

/// Comparison of a channel, over the displacement `u` of its run.
pub(super) fn channel(run: &Run, o: &ObservedChannel, simulated: &[f64], u: Option<&[f64]>) -> ChannelCheck {
    let score = score(simulated, o);
    let moments = Moments::new(&o.values, simulated);
    let [factor, offset] = moments.line();
    let work = u.filter(|_| o.is_resistance()).and_then(|u| Some([work(u, &o.values)?, work(u, simulated)?]));
    ChannelCheck {
        run: run.name.clone(),
        channel: o.channel.clone(),
        samples: score.samples,
        missing: o.values.iter().filter(|v| v.is_nan()).count(),
        dropped: score.dropped,
        nmse: score.nmse,
        correlation: moments.correlation(),
        factor,
        offset,
        lag_s: LagScan::new(&run.recording.times, &o.values, simulated).map_or(0.0, |s| s.most_correlated()),
        work,
    }
}

/// Work of a force over a displacement, divided by the product of their ranges; `None` if one of them is constant.
fn work(u: &[f64], force: &[f64]) -> Option<f64> {
    let pairs: Vec<(f64, f64)> =
        u.iter().copied().zip(force.iter().copied()).filter(|(u, f)| u.is_finite() && f.is_finite()).collect();
    let range = |of: fn(&(f64, f64)) -> f64| {
        let [low, high] =
            pairs.iter().map(of).fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
        high - low
    };
    let size = range(|p| p.0) * range(|p| p.1);
    // The mean of the force does no work over closed cycles, and much over one that is cut short.
    let mean = pairs.iter().map(|p| p.1).sum::<f64>() / pairs.len() as f64;
    let sum: f64 = pairs.windows(2).map(|w| (0.5 * (w[0].1 + w[1].1) - mean) * (w[1].0 - w[0].0)).sum();
    Some(sum / size).filter(|w| w.is_finite())
}

/// Findings that the comparisons alone show. Channels with a hard finding need no second one.
pub(super) fn findings(study: &Study, channels: &[ChannelCheck], known: &[Finding]) -> Vec<Finding> {
    let mut out = vec![];
    for c in channels {
        let is_known = || known.iter().any(|f| f.channel == c.channel && f.runs.contains(&c.run));
        let finding = |kind, is_hard, message: String, help: &str| Finding {
            kind,
            is_hard,
            channel: c.channel.clone(),
            runs: vec![c.run.clone()],
            factor: None,
            lag_s: None,
            message,
            help: help.into(),
        };
        let share = c.dropped as f64 / (c.dropped + c.samples) as f64;
        if share > MIN_DROPPED {
            let message = format!("{:.0} % of the samples lie after the end of the analysis", 100.0 * share);
            let help = "let the script analyse the whole recording, or check its time step and number of steps";
            out.push(finding(FindingKind::AfterAnalysis, share > MAX_DROPPED, message, help));
        }
        if let Some([recorded, simulated]) = c.work
            && recorded * simulated < 0.0
            && recorded.abs().min(simulated.abs()) > MIN_WORK
            && !is_known()
        {
            let message =
                "the recorded loops turn the other way: they supply energy where the simulated ones dissipate it";
            out.push(finding(FindingKind::Energy, false, message.into(), "check the signs of force and displacement"));
        }
    }
    out.extend(study.runs.iter().flat_map(duplicates));
    out
}

/// Pairs of channels of a run with the same samples.
fn duplicates(run: &Run) -> Vec<Finding> {
    let mut out = vec![];
    for (i, a) in run.observe.iter().enumerate() {
        for b in run.observe[..i].iter().filter(|b| b.channel != a.channel) {
            let same = a.values.iter().zip(&b.values).all(|(x, y)| x == y || x.is_nan() && y.is_nan());
            if same {
                out.push(Finding {
                    kind: FindingKind::Duplicate,
                    is_hard: false,
                    channel: a.channel.clone(),
                    runs: vec![run.name.clone()],
                    factor: None,
                    lag_s: None,
                    message: format!("it has the same samples as {}", b.channel),
                    help: "leave one of them out, or check how the recording was made".into(),
                });
            }
        }
    }
    out
}
