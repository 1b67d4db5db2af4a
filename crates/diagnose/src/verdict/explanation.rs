//! The verdict in words.

use crate::fit::fitted::FittedHypothesis;
use crate::hypothesis;

/// Explanation of a verdict.
///
/// `repair` is the hypothesis of the repaired model, and `second_causes` are those of further effects. `structure` describes the
/// remaining structure. `remaining_share` is the share of the squared error that the repaired model leaves.
pub(super) fn explanation(
    verdict: &str,
    repair: &FittedHypothesis,
    second_causes: &[&str],
    structure: &str,
    remaining_share: f64,
) -> String {
    match verdict {
        "none" => {
            "what the model leaves of the recordings is noise: no effect of the library gains anything on samples \
                   that it was not fitted to."
                .into()
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
