//! Limits of `none`: a model that leaves many times the noise is not shown to be complete, whether or not the library has
//! something better.

use crate::evidence::verdict_evidence::ProbabilityLimit;
use crate::prior::{INCOMPLETE_PROBABILITY, MAX_NOISE_OF_COMPLETE_MODEL};
use hysteron_identify::calibrate::Judgement;

/// Limit by the judgement of the fit, which `calibrate` gives as well: the error is many times the noise of the recordings,
/// and a part of it follows the motion. Noise that is slower than its estimate follows nothing.
pub(super) fn limit_by_judgement(judgement: &Judgement) -> Option<ProbabilityLimit> {
    let noise = judgement.noise?;
    let times = noise.nmse / noise.noise;
    (times > MAX_NOISE_OF_COMPLETE_MODEL && !judgement.structured.is_empty()).then(|| {
        let reason = format!(
            "your model leaves {times:.0} times the noise of the recordings, and a part of it follows the motion"
        );
        ProbabilityLimit::new("none", INCOMPLETE_PROBABILITY, reason)
    })
}

#[cfg(test)]
mod tests {
    use super::limit_by_judgement;
    use hysteron_identify::calibrate::{Judgement, NoiseComparison, StructuredChannel};
    use hysteron_identify::noise::NoiseEvidence;

    fn judgement(nmse: f64, structured: bool) -> Judgement {
        let evidence = NoiseEvidence::Innovations;
        let channel = StructuredChannel { run: "r".into(), channel: "c".into(), share: 0.1 };
        Judgement {
            explained: false,
            noise: Some(NoiseComparison { nmse, noise: 0.01, holdout_noise: None, evidence }),
            at_bounds: vec![],
            structured: if structured { vec![channel] } else { vec![] },
            structured_share: 0.1,
            holdout: None,
            widening: 1.0,
            sentences: vec![],
        }
    }

    /// Neither an error near the noise nor noise slower than its estimate speaks against a complete model.
    #[test]
    fn many_times_the_noise_that_follows_the_motion_is_no_complete_model() {
        let most = |nmse, structured| limit_by_judgement(&judgement(nmse, structured)).map(|l| l.most);
        assert_eq!([most(0.08, true), most(0.02, true), most(0.08, false)], [Some(0.5), None, None]);
    }
}
