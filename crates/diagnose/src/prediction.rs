//! What runs that were held out say of a repair: they can only take confidence away.

use hysteron_identify::study::{ObservedChannel, Role, ScoredRun, Study};
use std::collections::BTreeMap;

/// What is left of the confidence in a repair when runs that were held out get no better by it.
const CONTRADICTED: f64 = 0.6;
/// And when they get so much worse: of eight effects named in trials of validation/diagnosis three were right then.
const HARMED: f64 = 0.4;
const HARM: f64 = 1.5;
/// A repair that takes this part of what can be taken of the runs held out predicts them, one that takes no more than the other part is
/// worth as little as one that they contradict. Of names that take less than the first, but some, thirteen of sixteen are right in trials
/// of validation/diagnosis; of eight that are given there with the truth taken out of the library none is.
const PREDICTS: f64 = 0.8;
const FAILS: f64 = 0.4;
/// Runs held out in which there is no more than this over the noise cannot judge (a choice).
const SEEN: f64 = 1.25;

/// How the runs that were held out judge a repair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Judgement {
    /// They do not speak against it.
    Keeps,
    /// They get better, by this part of what can be taken.
    Partly(f64),
    /// They get no better.
    Contradicted,
    /// They get much worse, or have no answer.
    Harmed,
}

impl Judgement {
    /// What is kept of the confidence.
    pub(super) fn keeps(self) -> f64 {
        match self {
            Self::Keeps => 1.0,
            Self::Partly(taken) => {
                let part = ((taken - FAILS) / (PREDICTS - FAILS)).clamp(0.0, 1.0);
                CONTRADICTED + (1.0 - CONTRADICTED) * part
            }
            Self::Contradicted => CONTRADICTED,
            Self::Harmed => HARMED,
        }
    }

    /// Whether they speak against it altogether.
    pub(super) fn refutes(self) -> bool {
        matches!(self, Self::Contradicted | Self::Harmed)
    }

    /// In words, where they speak against it.
    pub(super) fn says(self) -> String {
        match self {
            Self::Keeps => String::new(),
            Self::Partly(taken) => {
                format!(
                    " Of what is wrong in the runs held out the repair takes away no more than {:.0} %.",
                    100.0 * taken
                )
            }
            Self::Contradicted => " The runs held out contradict the repair: they get no better by it.".into(),
            Self::Harmed => {
                " The runs held out contradict the repair: they get much worse by it, or have no answer.".into()
            }
        }
    }
}

/// What the runs that are held out say of a repair, from what the model says of all runs `before` it and `after`. So much
/// of what it leaves of the fitted ones is `structured`, and no noise. The repair changes what it says of those held out if it `acts`
/// there; what the recordings show by themselves (`seen`) need not be seen there. What does not concern them moves the model's own
/// parameters all the same, and may do no harm.
pub(super) fn judge(
    study: &Study,
    before: &[Option<ScoredRun>],
    (after, structured): (&[Option<ScoredRun>], f64),
    acts: bool,
    seen: bool,
) -> Judgement {
    let (held, left) = match (holdout(study, before), holdout(study, after)) {
        (Some(held), Some(left)) => (held, left),
        (Some(_), None) => return Judgement::Harmed,
        (None, _) => return Judgement::Keeps,
    };
    if left > HARM * held {
        return Judgement::Harmed;
    }
    if acts && (left > held || !seen && left == held) {
        return Judgement::Contradicted;
    }
    let floor = (1.0 - structured) * floor(study, after);
    if !acts || seen || held < SEEN * floor {
        return Judgement::Keeps;
    }
    match (held - left) / (held - floor) {
        taken if taken < PREDICTS => Judgement::Partly(taken),
        _ => Judgement::Keeps,
    }
}

/// Mean NMSE of the runs that are held out, where there are any and all have an answer.
pub(super) fn holdout(study: &Study, fits: &[Option<ScoredRun>]) -> Option<f64> {
    let held: Vec<f64> =
        study.runs_of(Role::Holdout).map(|(i, r)| Some(fits[i].as_ref()?.nmse(&r.observe))).collect::<Option<_>>()?;
    (!held.is_empty()).then(|| held.iter().sum::<f64>() / held.len() as f64)
}

/// What a repair may leave of the runs held out: in each channel as much as it leaves of the fitted ones, as a part of the variance
/// or in the channel's unit, whatever is more. (Sensors have noise of one size, machines make more of it where they work harder.)
fn floor(study: &Study, fits: &[Option<ScoredRun>]) -> f64 {
    let mut left: BTreeMap<&str, (f64, f64, f64)> = BTreeMap::new();
    for (i, run) in study.runs_of(Role::Fit) {
        let Some(fit) = &fits[i] else { continue };
        for (o, s) in run.observe.iter().zip(&fit.scores) {
            let (part, square, count) = left.entry(&o.channel).or_default();
            *part += s.nmse;
            *square += s.nmse * o.variance;
            *count += 1.0;
        }
    }
    let (all, count) = left.values().fold((0.0, 0.0), |(a, n), (part, _, count)| (a + part, n + count));
    let of = |o: &ObservedChannel| {
        let own = left.get(o.channel.as_str()).map(|(part, square, n)| (part / n).max(square / n / o.variance));
        o.weight * own.unwrap_or(all / f64::max(count, 1.0))
    };
    let held: Vec<f64> = study
        .runs_of(Role::Holdout)
        .map(|(_, r)| r.observe.iter().map(of).sum::<f64>() / r.observe.len() as f64)
        .collect();
    held.iter().sum::<f64>() / held.len().max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::{Judgement, judge};
    use hysteron_identify::study::{Role, Score, ScoredRun, Study};
    use hysteron_tcl::diagnostic::SourceMap;
    use std::path::Path;

    fn study() -> Study {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tcl-like-inputs/pad_study/study.toml");
        Study::load(&file, &mut SourceMap::default()).expect("a study")
    }

    /// Fits that leave so much of the fitted runs, and so much of those held out; nothing where they have no answer.
    fn leaves(study: &Study, fit: f64, held: Option<f64>) -> Vec<Option<ScoredRun>> {
        let of = |role| if role == Role::Fit { Some(fit) } else { held };
        let scores = |n: usize, nmse| vec![Score { nmse, samples: 100, dropped: 0 }; n];
        study
            .runs
            .iter()
            .map(|r| Some(ScoredRun { channels: vec![], scores: scores(r.observe.len(), of(r.role)?) }))
            .collect()
    }

    fn judged(before: f64, after: Option<f64>, acts: bool, seen: bool) -> Judgement {
        let s = study();
        judge(&s, &leaves(&s, 0.5, Some(before)), (&leaves(&s, 1e-3, after), 0.0), acts, seen)
    }

    #[test]
    fn what_predicts_is_believed_and_what_does_not_is_doubted_by_degrees() {
        assert_eq!(judged(0.5, Some(1e-3), true, false), Judgement::Keeps);
        assert_eq!(judged(0.5, Some(0.6), true, false), Judgement::Contradicted);
        assert_eq!(judged(0.5, Some(0.5), true, false), Judgement::Contradicted);
        assert_eq!(judged(0.5, Some(0.8), true, false), Judgement::Harmed);
        assert_eq!(judged(0.5, None, true, false), Judgement::Harmed);
        let keeps: Vec<f64> = (0..10).map(|i| judged(0.5, Some(0.055 * f64::from(i)), true, false).keeps()).collect();
        assert!(keeps.windows(2).all(|w| w[1] <= w[0]) && keeps[0] == 1.0 && keeps[9] == 0.6, "{keeps:?}");
        let half = judged(0.5, Some(0.25), true, false);
        assert!(matches!(half, Judgement::Partly(_)) && (0.65..0.75).contains(&half.keeps()), "{half:?}");
        assert!(half.says().contains("50 %"), "{}", half.says());
    }

    /// A fault of one run says nothing of others but may not harm them; what is seen need not help; an effect as small as the noise
    /// cannot be judged.
    #[test]
    fn what_does_not_concern_the_runs_held_out_is_not_judged_by_them() {
        assert_eq!(judged(0.5, Some(0.55), false, false), Judgement::Keeps);
        assert_eq!(judged(0.5, Some(0.8), false, false), Judgement::Harmed);
        assert_eq!(judged(0.5, Some(0.4), true, true), Judgement::Keeps);
        assert_eq!(judged(0.00115, Some(0.0011), true, false), Judgement::Keeps);
    }
}
