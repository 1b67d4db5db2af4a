//! Judgement of a repair by the runs held out.

use crate::prior::{MIN_HOLDOUT_SIGNAL_RATIO, PREDICTED_SHARE, WORSENED_RATIO};
use hysteron_identify::study::{ObservedChannel, Role, ScoredRun, Study};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Judgement of a repair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum HoldoutJudgement {
    /// Nothing speaks against it.
    Accepted,
    /// It removes this share of the reducible error, less than [`PREDICTED_SHARE`].
    PartlyPredicted(f64),
    /// The runs do not improve.
    Contradicted,
    /// The runs get much worse, or have no result.
    Worsened,
}

impl HoldoutJudgement {
    /// Returns true if the runs refute the repair.
    pub(crate) fn refutes(self) -> bool {
        matches!(self, Self::Contradicted | Self::Worsened)
    }

    /// The judgement in words; empty if the repair is accepted.
    pub(crate) fn description(self) -> String {
        match self {
            Self::Accepted => String::new(),
            Self::PartlyPredicted(share) => {
                format!(
                    " Of what is wrong in the runs held out the repair takes away no more than {:.0} %.",
                    100.0 * share
                )
            }
            Self::Contradicted => " The runs held out contradict the repair: they get no better by it.".into(),
            Self::Worsened => {
                " The runs held out contradict the repair: they get much worse by it, or have no answer.".into()
            }
        }
    }
}

/// A repair to be judged, with the model's channels in all runs before and after it.
pub(crate) struct Repair<'a> {
    /// Channels before; `None` for a run without a result.
    pub(crate) before: &'a [Option<ScoredRun>],
    /// Channels after.
    pub(crate) after: &'a [Option<ScoredRun>],
    /// Structured share of its residual in the fitted runs; the rest is noise.
    pub(crate) structured_share: f64,
    /// True if the repair affects runs held out. One that does not still moves the user's parameters.
    pub(crate) affects_holdout: bool,
    /// True if the recordings show its effect by themselves. The runs held out need not contain the effect.
    pub(crate) visible_in_recording: bool,
}

/// Errors of the runs held out, mean NMSE.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct HeldOutErrors {
    /// Error of the user's model; none without a result.
    pub before: Option<f64>,
    /// Error of the repaired model.
    pub after: Option<f64>,
    /// Error that the noise of the fitted runs would leave.
    pub noise: f64,
}

impl HeldOutErrors {
    /// Errors of a repair; `None` without runs held out.
    pub(crate) fn of(study: &Study, repair: &Repair<'_>) -> Option<Self> {
        let noise = (1.0 - repair.structured_share) * expected_holdout_nmse(study, repair.after);
        study.runs_of(Role::Holdout).next()?;
        Some(Self { before: holdout_nmse(study, repair.before), after: holdout_nmse(study, repair.after), noise })
    }
}

/// Judges a repair by the runs held out.
pub(crate) fn judge(study: &Study, repair: &Repair<'_>) -> HoldoutJudgement {
    let (before, after) = match (holdout_nmse(study, repair.before), holdout_nmse(study, repair.after)) {
        (Some(before), Some(after)) => (before, after),
        (Some(_), None) => return HoldoutJudgement::Worsened,
        (None, _) => return HoldoutJudgement::Accepted,
    };
    if after > WORSENED_RATIO * before {
        return HoldoutJudgement::Worsened;
    }
    let unchanged = !repair.visible_in_recording && after == before;
    if repair.affects_holdout && (after > before || unchanged) {
        return HoldoutJudgement::Contradicted;
    }
    let noise = (1.0 - repair.structured_share) * expected_holdout_nmse(study, repair.after);
    if !repair.affects_holdout || repair.visible_in_recording || before < MIN_HOLDOUT_SIGNAL_RATIO * noise {
        return HoldoutJudgement::Accepted;
    }
    match (before - after) / (before - noise) {
        share if share < PREDICTED_SHARE => HoldoutJudgement::PartlyPredicted(share),
        _ => HoldoutJudgement::Accepted,
    }
}

/// A channel that a repair makes worse in most of the runs held out.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct WorsenedChannel {
    /// Its name.
    pub(crate) channel: String,
    /// Number of the runs held out in which it gets worse, and of those with the channel.
    pub(crate) runs: (usize, usize),
}

impl WorsenedChannel {
    /// The finding in words.
    pub(crate) fn description(&self) -> String {
        let (worse, all) = self.runs;
        format!("{} gets worse in {worse} of {all} runs held out", self.channel)
    }
}

/// Error over the noise below which a channel is predicted.
pub(crate) const NOISE_MARGIN: f64 = 2.0;
/// Error after over that before from which a channel is worse. Smaller changes are those of the noise.
pub(crate) const WORSE_CHANNEL_RATIO: f64 = 1.1;
/// NMSE from which a model predicts nothing of a channel: the mean of the channel is a better prediction. The error is then that
/// of a chance phase, and only one that is `WORSENED_RATIO` times as large is worse.
const NOTHING_PREDICTED: f64 = 1.0;

/// The first channel whose error grows by a ratio in most of the runs held out, beyond the noise. The mean over channels must
/// not hide it.
pub(crate) fn worsened_channel(study: &Study, repair: &Repair<'_>, ratio: f64) -> Option<WorsenedChannel> {
    let noise = expected_noise(study, repair);
    let mut channels: Vec<(&str, usize, usize)> = vec![];
    for (i, run) in study.runs_of(Role::Holdout) {
        let (Some(before), Some(after)) = (&repair.before[i], &repair.after[i]) else { continue };
        for (o, (b, a)) in run.observe.iter().zip(before.scores.iter().zip(&after.scores)) {
            let ratio = if b.nmse < NOTHING_PREDICTED { ratio } else { WORSENED_RATIO };
            let is_worse = a.nmse > ratio * b.nmse && a.nmse > NOISE_MARGIN * noise(o);
            match channels.iter_mut().find(|(name, ..)| *name == o.channel) {
                Some((_, worse, all)) => (*worse, *all) = (*worse + usize::from(is_worse), *all + 1),
                None => channels.push((&o.channel, usize::from(is_worse), 1)),
            }
        }
    }
    let (channel, worse, all) = channels.into_iter().find(|(_, worse, all)| 2 * worse > *all)?;
    Some(WorsenedChannel { channel: channel.into(), runs: (worse, all) })
}

/// NMSE of a channel held out that the noise of the fitted runs would leave.
pub(crate) fn expected_noise<'a>(study: &'a Study, repair: &Repair<'a>) -> impl Fn(&ObservedChannel) -> f64 + use<'a> {
    let expected = expected_nmse(study, repair.after);
    let noise = 1.0 - repair.structured_share;
    move |o| noise * expected(o)
}

/// Mean NMSE of the runs held out; none if there are none, or if one has no result.
pub(crate) fn holdout_nmse(study: &Study, fits: &[Option<ScoredRun>]) -> Option<f64> {
    let held: Vec<f64> =
        study.runs_of(Role::Holdout).map(|(i, r)| Some(fits[i].as_ref()?.nmse(&r.observe))).collect::<Option<_>>()?;
    (!held.is_empty()).then(|| held.iter().sum::<f64>() / held.len() as f64)
}

/// Mean NMSE of a channel in the runs held out; none if no run has it, or if one has no result.
pub(crate) fn channel_nmse(study: &Study, fits: &[Option<ScoredRun>], channel: &str) -> Option<f64> {
    let mut all = vec![];
    for (i, run) in study.runs_of(Role::Holdout) {
        let Some(c) = run.observe.iter().position(|o| o.channel == channel) else { continue };
        all.push(fits[i].as_ref()?.scores[c].nmse);
    }
    (!all.is_empty()).then(|| all.iter().sum::<f64>() / all.len() as f64)
}

/// NMSE of a channel over fitted runs.
#[derive(Default)]
struct FittedError {
    /// Sum of NMSE.
    nmse: f64,
    /// Sum of mean squares, in the channel's unit.
    square: f64,
    /// Number of runs.
    runs: f64,
}

/// NMSE of the runs held out with the error of the fitted ones.
///
/// Each channel has the same share of its variance or the same error in its unit, whichever is larger. Sensors have noise of
/// one size; machines have more noise under more load.
fn expected_holdout_nmse(study: &Study, fits: &[Option<ScoredRun>]) -> f64 {
    let expected = expected_nmse(study, fits);
    let held: Vec<f64> = study
        .runs_of(Role::Holdout)
        .map(|(_, r)| r.observe.iter().map(|o| o.weight * expected(o)).sum::<f64>() / r.observe.len() as f64)
        .collect();
    held.iter().sum::<f64>() / held.len().max(1) as f64
}

/// NMSE of a channel held out with the error of the fitted runs.
fn expected_nmse<'a>(study: &'a Study, fits: &[Option<ScoredRun>]) -> impl Fn(&ObservedChannel) -> f64 + use<'a> {
    let mut of_channel: BTreeMap<&str, FittedError> = BTreeMap::new();
    for (i, run) in study.runs_of(Role::Fit) {
        let Some(fit) = &fits[i] else { continue };
        for (o, s) in run.observe.iter().zip(&fit.scores) {
            let error = of_channel.entry(&o.channel).or_default();
            error.nmse += s.nmse;
            error.square += s.nmse * o.variance;
            error.runs += 1.0;
        }
    }
    let (sum, runs) = of_channel.values().fold((0.0, 0.0), |(sum, runs), e| (sum + e.nmse, runs + e.runs));
    move |o: &ObservedChannel| {
        let fitted = of_channel.get(o.channel.as_str());
        let own = fitted.map(|e| (e.nmse / e.runs).max(e.square / e.runs / o.variance));
        own.unwrap_or(sum / f64::max(runs, 1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::{HoldoutJudgement, Repair, WORSE_CHANNEL_RATIO, judge, worsened_channel};
    use crate::test_support::pad_study;
    use hysteron_identify::study::{ObservedChannel, Role, Score, ScoredRun, Study};

    /// Fits with a NMSE of the fitted runs and of those held out; none without a result.
    fn with_nmse(study: &Study, fit: f64, held: Option<f64>) -> Vec<Option<ScoredRun>> {
        let of = |role| if role == Role::Fit { Some(fit) } else { held };
        let scores = |n: usize, nmse| vec![Score { nmse, samples: 100, dropped: 0 }; n];
        study
            .runs
            .iter()
            .map(|r| Some(ScoredRun { channels: vec![], scores: scores(r.observe.len(), of(r.role)?) }))
            .collect()
    }

    fn judged(before: f64, after: Option<f64>, affects_holdout: bool, visible_in_recording: bool) -> HoldoutJudgement {
        let s = pad_study();
        let (before, after) = (with_nmse(&s, 0.5, Some(before)), with_nmse(&s, 1e-3, after));
        let repair =
            Repair { before: &before, after: &after, structured_share: 0.0, affects_holdout, visible_in_recording };
        judge(&s, &repair)
    }

    #[test]
    fn runs_held_out_judge_a_repair() {
        assert_eq!(judged(0.5, Some(1e-3), true, false), HoldoutJudgement::Accepted);
        assert_eq!(judged(0.5, Some(0.6), true, false), HoldoutJudgement::Contradicted);
        assert_eq!(judged(0.5, Some(0.5), true, false), HoldoutJudgement::Contradicted);
        assert_eq!(judged(0.5, Some(0.8), true, false), HoldoutJudgement::Worsened);
        assert_eq!(judged(0.5, None, true, false), HoldoutJudgement::Worsened);
        let half = judged(0.5, Some(0.25), true, false);
        assert!(matches!(half, HoldoutJudgement::PartlyPredicted(share) if (share - 0.5).abs() < 0.01), "{half:?}");
        assert!(half.description().contains("50 %"), "{}", half.description());
    }

    /// A channel that gets worse refuses a repair although the mean falls; one within the noise does not.
    #[test]
    fn a_mean_does_not_hide_a_worse_channel() {
        let mut s = pad_study();
        let held = s.runs.iter().position(|r| r.role == Role::Holdout).expect("a run held out");
        let second = ObservedChannel { channel: "second".into(), ..s.runs[held].observe[0].clone() };
        s.runs.iter_mut().for_each(|r| r.observe.push(second.clone()));
        let worsened_from = |before: f64, after: f64| {
            let before = with_nmse(&s, 0.5, Some(before));
            let mut repaired = with_nmse(&s, 1e-3, Some(1e-3));
            repaired[held].as_mut().expect("a fit").scores[1].nmse = after;
            let repair = Repair {
                before: &before,
                after: &repaired,
                structured_share: 0.0,
                affects_holdout: true,
                visible_in_recording: false,
            };
            (worsened_channel(&s, &repair, WORSE_CHANNEL_RATIO), judge(&s, &repair))
        };
        let worsened = |after| worsened_from(0.5, after);
        let (worse, judgement) = worsened(0.6);
        assert_eq!(worse.map(|w| w.description()), Some("second gets worse in 1 of 1 runs held out".into()));
        assert_ne!(judgement, HoldoutJudgement::Worsened, "the mean alone hides it");
        assert_eq!(worsened(0.52).0, None, "within ten per cent");
        assert_eq!(worsened(1.5e-3).0, None, "better");
        assert_eq!(worsened_from(1.1, 1.3).0, None, "neither model predicts anything");
        assert!(worsened_from(1.1, 1.8).0.is_some());
    }

    /// A fault of one run may not worsen others. A visible effect need not improve them. The noise hides small effects.
    #[test]
    fn runs_without_the_effect_do_not_judge_it() {
        assert_eq!(judged(0.5, Some(0.55), false, false), HoldoutJudgement::Accepted);
        assert_eq!(judged(0.5, Some(0.8), false, false), HoldoutJudgement::Worsened);
        assert_eq!(judged(0.5, Some(0.4), true, true), HoldoutJudgement::Accepted);
        assert_eq!(judged(0.00115, Some(0.0011), true, false), HoldoutJudgement::Accepted);
    }
}
