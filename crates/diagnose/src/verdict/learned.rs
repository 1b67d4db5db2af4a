//! A learned law in the place of a device's own, where no effect of the library explains the recordings.

use super::all_runs::fits_of_all_runs;
use super::conclusion::ConclusionContext;
use super::result_file::Verdict;
use crate::candidate::proposal::Proposal;
use crate::candidate::variant::Variant;
use crate::evidence::holdout::holdout_nmse;
use crate::evidence::memory_evidence::DeviceRuns;
use crate::evidence::verdict_model::CauseProbabilities;
use crate::fit::fitted::FittedHypothesis;
use crate::fit::job::FittedModel;
use crate::hypothesis::is_sensor_fault;
use crate::memory::family::Family;
use crate::memory::learning::{Learned, learn};
use crate::prior::{MAX_LEARNED_SENSOR_PROBABILITY, MEMORY_TIE, MIN_LEARNED_GAIN, NOISE_RATIO};
use crate::series::averaged;
use hysteron_engine::element::amendment::learned::{Factor, LearnedLaw, Shape, Variable};
use hysteron_identify::study::{Role, Run, ScoredRun, Study};
use hysteron_opensees::{law_to_json, law_to_words};
use serde::Serialize;
use std::sync::Arc;

/// Content of `learned` in `diagnosis.json`.
#[derive(Clone, Debug, Serialize)]
pub struct LearnedModel {
    /// Kinds of memory of the law, the first that of most effect.
    pub families: Vec<String>,
    /// Words of the law after `amend element`.
    pub words: String,
    /// Parts and factors of the law in words, one a line.
    pub parts: Vec<String>,
    /// Mean NMSE of the runs held out: of the fitted user's model, and of the learned law in the model.
    pub held_out: [f64; 2],
    /// Noise of the runs held out, mean NMSE; none where it is unknown.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub noise: Option<f64>,
    /// True if the law leaves at most three times the noise.
    pub reaches_noise: bool,
    /// Share of the steps of the runs held out that lie outside the range of the law.
    pub outside_range: f64,
    /// The law as JSON, for the file beside the scripts.
    #[serde(skip)]
    pub json: String,
    /// Statement of the verdict.
    #[serde(skip)]
    statement: String,
}

/// A learned law in the user's model, with what it predicts.
pub(super) struct LearnedRepair {
    /// The model with the law.
    pub(super) hypothesis: FittedHypothesis,
    /// Channels of all runs.
    pub(super) fits: Vec<Option<ScoredRun>>,
    /// Content of the verdict about it.
    pub(super) told: LearnedModel,
}

/// Basis of a learned law: what the verdict says, and the user's fitted model.
pub(super) struct LearnedContext<'a> {
    pub(super) cause: &'static str,
    pub(super) probabilities: &'a CauseProbabilities,
    pub(super) baseline: &'a FittedHypothesis,
    pub(super) baseline_fits: &'a [Option<ScoredRun>],
}

/// The learned law of an unknown cause, if it predicts the runs held out clearly better than the user's model.
///
/// A sensor that may be at fault comes first, since a law absorbs its fault.
pub(super) fn learned_repair(c: &ConclusionContext<'_>, of: &LearnedContext<'_>) -> Option<LearnedRepair> {
    let device = c.device.as_ref().filter(|_| of.cause == "unknown")?;
    let of_sensors = of.probabilities.iter().filter(|(cause, _)| is_sensor_fault(cause));
    if of_sensors.map(|(_, p)| *p).sum::<f64>() > MAX_LEARNED_SENSOR_PROBABILITY {
        return None;
    }
    let before = holdout_nmse(c.study, of.baseline_fits)?;
    let learned = learn(device.runs.clone(), c.has_clock)?;
    let enough = |before: f64, after: f64| after <= (1.0 - MIN_LEARNED_GAIN) * before;
    if !enough(learned.user_held_out?, learned.held_out?) {
        return None;
    }
    let proposal = proposal(c.study, device, &learned)?;
    let baseline = Variant::baseline(c.study, c.text);
    let variant = Arc::new(baseline.with_proposal(c.point, &proposal)?);
    let values = of.baseline.fitted.values.clone();
    let fits = fits_of_all_runs(c, &variant, &values);
    // The law is judged by what the model with it predicts, not by its own fit.
    let after = holdout_nmse(c.study, &fits)?;
    if !enough(before, after) {
        return None;
    }
    let of_fitted: Vec<ScoredRun> = c.study.runs_of(Role::Fit).map(|(i, _)| fits[i].clone()).collect::<Option<_>>()?;
    let scores: Vec<f64> = of_fitted.iter().flat_map(|f| &f.scores).map(|s| s.nmse).collect();
    let objective = scores.iter().sum::<f64>() / scores.len().max(1) as f64;
    let point = variant.study.space.unit_point(&values);
    let fitted = FittedModel { point, values, objective, fits: of_fitted };
    let noise = c.recorded.noise_held_out;
    let told = LearnedModel {
        families: learned.families.iter().map(|(f, _)| f.name().to_owned()).collect(),
        words: proposal.commands.last().cloned().unwrap_or_default(),
        parts: parts(&learned.law),
        held_out: [before, after],
        noise,
        reaches_noise: noise.is_some_and(|n| after <= NOISE_RATIO * n),
        outside_range: learned.outside,
        json: law_to_json(&learned.law) + "\n",
        statement: statement(&learned),
    };
    Some(LearnedRepair { hypothesis: FittedHypothesis::new(variant, fitted), fits, told })
}

/// The edit that puts a law in the place of a device's own; `None` if it is not known which device that is, or if the script
/// cannot tell the runs of its channels.
pub(super) fn proposal(study: &Study, device: &DeviceRuns, learned: &Learned) -> Option<Proposal> {
    let place = device.device?;
    let law = learned.law.with_forces_times(1.0 / place.factor);
    let mut commands = vec![];
    let mut series = String::new();
    for (k, channel) in law.channels.iter().enumerate() {
        let name = format!("hy_learned{}", k + 1);
        commands.extend(history(study, &channel.name, &name)?);
        series += &format!(" ${name}");
    }
    let series = if series.is_empty() { series } else { format!(" -series{series}") };
    commands.push(format!(
        "amend element {} learned {}{series} -dir {}",
        place.tag,
        law_to_words(&law),
        place.direction
    ));
    let location = format!("element {}, direction {}", place.tag, place.direction);
    Some(Proposal::script_edit("learned", "a learned law in place of its own", location, commands, vec![]))
}

/// Points of a recorded channel in the script, at most.
const MAX_HISTORY_POINTS: usize = 2000;

/// Commands that set a variable to a recorded channel, by a variable that distinguishes the runs.
fn history(study: &Study, channel: &str, variable: &str) -> Option<Vec<String>> {
    let column = |r: &Run| {
        let of_name = |name: &str| name.split_whitespace().collect::<Vec<_>>().join("_") == channel;
        r.recording.columns.iter().find(|c| of_name(&c.name)).map(|c| c.values.clone())
    };
    let path = |r: &Run| -> Option<String> {
        let values = column(r)?;
        let there = r.recording.times.iter().zip(&values).filter(|(_, x)| x.is_finite());
        let (t, x): (Vec<f64>, Vec<f64>) = there.map(|(t, x)| (*t, *x)).unzip();
        let list = |v: &[f64]| {
            let short = averaged(v, MAX_HISTORY_POINTS).into_iter().map(|x| format!("{x:.6}"));
            short.collect::<Vec<_>>().join(" ")
        };
        Some(format!("set {variable} {{Path -time {{{}}} -values {{{}}} -useLast}}", list(&t), list(&x)))
    };
    if let [run] = &study.runs[..] {
        return Some(vec![path(run)?]);
    }
    let is_distinct = |name: &str| {
        let texts: Option<Vec<String>> = study.runs.iter().map(|r| r.text(name)).collect();
        texts.is_some_and(|t| (1..t.len()).all(|i| !t[..i].contains(&t[i])))
    };
    let (name, _) = study.runs[0].set.iter().find(|(name, _)| is_distinct(name))?;
    let mut out = vec![format!("switch -- ${name} {{")];
    for run in &study.runs {
        out.push(format!("    {{{}}} {{{}}}", run.text(name)?, path(run)?));
    }
    out.push("}".into());
    Some(out)
}

/// The kinds of memory of a law in words.
pub(super) fn statement(learned: &Learned) -> String {
    let named = |(f, channel): &(Family, String)| {
        if channel.is_empty() { f.statement().to_owned() } else { format!("{} ({channel})", f.statement()) }
    };
    let families: Vec<&str> = learned.families.iter().map(|(f, _)| f.name()).collect();
    let all: Vec<String> = learned.families.iter().map(named).collect();
    let tie = learned.rivals.iter().find(|(.., behind)| *behind < MEMORY_TIE);
    let tie = tie.map_or_else(String::new, |(f, ..)| format!("; a law of the family {} explains as much", f.name()));
    format!("of the family {}: {}{tie}", families.join(" and "), all.join(", and "))
}

impl LearnedModel {
    /// Writes the law into the verdict.
    pub(super) fn tell(&self, verdict: &mut Verdict) {
        let [before, after] = self.held_out;
        let noise = match self.noise {
            Some(noise) if self.reaches_noise => format!(", at most {NOISE_RATIO} times the noise of {noise:.1e}"),
            Some(noise) => format!(", not down to the noise of {noise:.1e}"),
            None => String::new(),
        };
        let what = format!("Not physics of the library (unknown), {}. A law is written.", self.statement);
        let gain = format!(
            "The runs held out have a mean NMSE of {after:.2e} with the learned law in place of {before:.2e}{noise}."
        );
        let caution = "It predicts within the range of its runs and explains nothing by itself.";
        verdict.explanation += &format!(" {what} {gain} {caution} Its parts: {}.", self.parts.join("; "));
        verdict.summary.what = what;
        verdict.summary.gain = format!("{gain} {caution}");
        if self.outside_range > 0.0 {
            let share = 100.0 * self.outside_range;
            let text = format!("{share:.1} % of the steps of the runs held out lie outside the range of the law");
            verdict.summary.checks.push(text);
        }
        verdict.summary.how_big = format!("{} The law: {}.", verdict.summary.how_big, self.parts.join("; "));
    }
}

/// Parts and factors of a law, one a line.
pub(crate) fn parts(law: &LearnedLaw) -> Vec<String> {
    let s = &law.scales;
    let mut out = vec![];
    let hysteretic = match &law.shape {
        Shape::Own => format!("{:.4} times the force of the user's law", law.strength),
        shape => {
            let form = match shape {
                Shape::Bilinear => "bilinear",
                Shape::BoucWen => "rounded (Bouc-Wen)",
                _ => "of learned slopes",
            };
            format!("hysteresis {form}, strength {:.4e} after {:.4e} of deformation", law.strength, s.level)
        }
    };
    out.push(hysteretic);
    if law.spring != 0.0 {
        out.push(format!("a spring of stiffness {:.4e}", law.spring));
    }
    let counted = [
        (law.pieces.len(), "pieces of the spring beyond a deformation"),
        (law.stops.len(), "further stops"),
        (law.maxwell.len(), "Maxwell elements"),
        (law.dashpots.len() + law.viscous.len(), "dashpots"),
        (law.forces.len(), "forces of a channel"),
    ];
    out.extend(counted.iter().filter(|(n, _)| *n > 0).map(|(n, what)| format!("{n} {what}")));
    if law.moving > 0.0 {
        out.push(format!("a spring of stiffness {:.4e} about the middle of the extremes", law.moving));
    }
    out.extend(law.factors.iter().map(|f| factor_in_words(law, f)));
    out.push(format!(
        "seen up to a deformation of {:.4e}, a speed of {:.4e} and {:.4e} s",
        s.deformation, s.speed, s.duration
    ));
    out
}

fn factor_in_words(law: &LearnedLaw, f: &Factor) -> String {
    use Variable as V;
    let part = f.target.in_words();
    let channel = |i: usize| law.channels.get(i).map_or("", |c| c.name.as_str());
    let variable = match f.variable {
        V::Deformation { power } => format!("with the deformation to the power {power}"),
        V::Side => "with the side of the deformation".into(),
        V::SideOver { constant } => format!("with the side of late, over {constant:.3} s"),
        V::Place { place, .. } => format!("about the deformation {:.3e}", place * law.scales.deformation),
        V::Time => "with elapsed time".into(),
        V::TimeSaturating { constant } => format!("with elapsed time, mostly within {constant:.3} s"),
        V::TimeStep { at } => format!("about the time {at:.3} s"),
        V::Work => "with the work done".into(),
        V::WorkSaturating { constant } => format!("with the work done, mostly in the first {:.1} %", 100.0 * constant),
        V::RecentWork { constant } | V::RecentWorkSoftening { constant } => {
            format!("with the work of the last {constant:.3} s")
        }
        V::Largest | V::LargestDecay { .. } => "with the largest deformation".into(),
        V::LargestOfSide | V::LargestDecayOfSide { .. } => "with the largest deformation of each side".into(),
        V::Virgin { .. } => "near the largest deformation".into(),
        V::Pinching { width } => format!("about zero, within {width:.2} of the largest deformation"),
        V::Rate { .. } => "with the logarithm of the speed".into(),
        V::RateOver { constant, .. } => format!("with the logarithm of the speed of the last {constant:.3} s"),
        V::Rest { length, .. } => format!("with the time without slip, worn off by {length:.3e} of slip"),
        V::Still { length, .. } => format!("with the time at rest, worn off by {length:.3e} of slip"),
        V::Channel { channel: i } | V::ChannelSquare { channel: i } => format!("with {}", channel(i)),
        V::ChannelLate { channel: i, constant } => format!("with {}, late by {constant:.3} s", channel(i)),
    };
    let [a, b] = f.range.map(|x| (1.0 + f.coefficient * x).clamp(0.05, 5.0));
    format!("{part} times {:.3} to {:.3} {variable}", a.min(b), a.max(b))
}

#[cfg(test)]
mod tests {
    use super::parts;
    use hysteron_opensees::law_of_json;

    #[test]
    fn each_factor_has_a_line_with_its_range() {
        let law = law_of_json(
            "{\"range\": [0.1, 0.5, 40], \"hysteresis\": [\"bilinear\", 0.004, 20], \"spring\": [300],
              \"factor\": [[\"strength\", \"rest\", 0.015, 0.4, 0.5, 0, 2]]}",
        );
        let lines = law.map(|l| parts(&l)).unwrap_or_default();
        assert_eq!(lines[0], "hysteresis bilinear, strength 2.0000e1 after 4.0000e-3 of deformation");
        assert_eq!(lines[2], "strength times 1.000 to 2.000 with the time without slip, worn off by 1.500e-2 of slip");
    }
}
