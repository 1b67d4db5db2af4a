//! The verdict in words.

use crate::fit::fitted::FittedHypothesis;
use crate::hypothesis;
use hysteron_identify::calibrate::Judgement;

/// Explanation of a verdict.
///
/// `repair` is the hypothesis of the repaired model, and `second_causes` are those of further effects. `structure` describes the
/// remaining structure. `remaining_share` is the share of the squared error that the repaired model leaves. `judgement` is that
/// of the fit, if it is known.
pub(super) fn explanation(
    verdict: &str,
    repair: &FittedHypothesis,
    second_causes: &[&str],
    structure: &str,
    remaining_share: f64,
    judgement: Option<&Judgement>,
) -> String {
    match verdict {
        "none" => {
            let gains = "no effect of the library gains anything on samples that it was not fitted to";
            match judgement {
                Some(j) if j.explained => format!("{gains}: {}.", j.sentences.join("; ")),
                Some(j) => format!("{gains}, but {}.", j.reasons().join("; ")),
                None => format!("{gains}."),
            }
        }
        "unknown" => {
            let mut text = if structure.is_empty() {
                "nothing speaks clearly for an effect of the library, nor for noise".to_owned()
            } else {
                format!("there is structure that no effect of the library explains: {structure}")
            };
            if let Some(h) = hypothesis::of(repair.cause()) {
                text += &format!(
                    "; the repaired model has the nearest, {}, and leaves {:.1} % of the squared error",
                    h.cause,
                    100.0 * remaining_share
                );
            }
            text + "."
        }
        cause => {
            let h = hypothesis::of(cause);
            let proposal = repair.variant.proposal.as_ref();
            let location = proposal.map_or_else(String::new, |p| format!(" ({}, {})", p.location, p.form));
            let mut text = format!("{}{location}", h.map_or(cause, |h| h.statement));
            for second in second_causes {
                text += &format!("; and {}", hypothesis::of(second).map_or(*second, |h| h.statement));
            }
            text += &format!(
                "; the repaired model leaves {:.1} % of the squared error. It would be wrong if {}.",
                100.0 * remaining_share,
                h.map_or("", |h| h.refuted_by)
            );
            text
        }
    }
}

/// Remark on channels with unsteady noise.
pub(super) fn unsteady_in_words(channels: &[String]) -> String {
    format!(
        "The noise of {} is louder at some times than at others, as of a machine nearby: it neither follows the motion nor shows \
         in other channels.",
        channels.join(", ")
    )
}

/// Observation that separates the verdict from its strongest competitor.
pub(super) fn observation(verdict: &str, competitor: Option<&str>) -> String {
    match (hypothesis::of(verdict), competitor.and_then(hypothesis::of)) {
        (Some(h), Some(r)) => {
            format!("to tell {} from {}: see whether {}, and whether {}", h.cause, r.cause, h.refuted_by, r.refuted_by)
        }
        (Some(h), None) => format!("see whether {}", h.refuted_by),
        _ => "repeat a run unchanged: what repeats is the model, what does not is noise".into(),
    }
}
