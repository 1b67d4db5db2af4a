//! Another value of a parameter for a part of a run.

use super::change_points::{ChangePoints, Span};
use super::{CAUSE, Declared, declared, factor_name, only_in_run};
use crate::candidate::proposal::ChangedCondition;
use crate::hypothesis::context::{ProposalContext, distinguishing_variable};
use crate::hypothesis::{AddedParameter, Proposal};
use crate::inspect::response::ResponseHistory;
use crate::prior::{CHANGE_POINT_PARAMETERS, CONDITION_FACTORS, EFFECTIVE_SAMPLES, MAX_CONDITION_SPANS};
use hysteron_identify::study::{ParameterKind, Role, Run, Scale};

/// Names of the added times.
pub(super) const FROM: &str = "from";
pub(super) const TO: &str = "to";

/// Forms of a parameter that changes once or twice in a run, the likeliest first.
pub(super) fn proposals(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let Some(sensitivities) = &s.sensitivities else { return vec![] };
    let variable = distinguishing_variable(s.study);
    if variable.is_none() && s.study.runs.len() > 1 {
        return vec![];
    }
    let runs: Vec<(usize, &Run)> = s.study.runs_of(Role::Fit).collect();
    let channels: Vec<usize> = runs.iter().map(|(_, run)| run.observe.len()).collect();
    let Some(points) = ChangePoints::new(sensitivities, &channels) else { return vec![] };
    let declared = declared(s);
    let places = runs.iter().enumerate().flat_map(|(run, _)| declared.iter().map(move |p| (run, p)));
    let found = places.flat_map(|(run, p)| points.spans(run, p.coordinate).into_iter().map(move |span| (span, p)));
    let mut found: Vec<(Span, &Declared<'_>)> = found.filter(|(span, _)| expected_gain(span) > 0.0).collect();
    if found.is_empty() {
        return vec![];
    }
    // A change that follows time, work or the largest deformation is a law, and no change at a time.
    let history = points.share_of_histories(&histories(s, &runs));
    found.retain(|(span, _)| span.share > history);
    found.sort_by(|a, b| expected_gain(&b.0).total_cmp(&expected_gain(&a.0)));
    found.truncate(MAX_CONDITION_SPANS);
    let of = |(span, p): (Span, &Declared<'_>)| proposal(s, variable.as_deref(), runs[span.run].1, &span, p);
    found.into_iter().filter_map(of).collect()
}

/// Expected log evidence over the baseline, nats: Schwarz' criterion with the price of the times.
fn expected_gain(span: &Span) -> f64 {
    let parameters = 1 + CHANGE_POINT_PARAMETERS * span.change_points();
    -0.5 * EFFECTIVE_SAMPLES * (1.0 - span.share).ln() - 0.5 * parameters as f64 * EFFECTIVE_SAMPLES.ln()
}

/// Histories that a law may follow, by run and part of it: elapsed time, work, and the largest deformation so far.
fn histories<'a>(s: &'a ProposalContext<'_>, runs: &'a [(usize, &'a Run)]) -> Vec<Box<dyn Fn(usize, f64) -> f64 + 'a>> {
    let duration = |run: &Run| match run.recording.times[..] {
        [first, .., last] => last - first,
        _ => 0.0,
    };
    let longest = runs.iter().map(|(_, run)| duration(run)).fold(f64::MIN_POSITIVE, f64::max);
    let mut out: Vec<Box<dyn Fn(usize, f64) -> f64 + 'a>> =
        vec![Box::new(move |run, part| part * duration(runs[run].1) / longest)];
    let devices: Option<Vec<&ResponseHistory>> = runs.iter().map(|(number, _)| most_deformed(s, *number)).collect();
    for of in [work_so_far as fn(&ResponseHistory) -> Vec<f64>, largest_so_far] {
        let Some(devices) = &devices else { continue };
        let series: Vec<Vec<f64>> = devices.iter().map(|h| of(h)).collect();
        let most = series.iter().flatten().copied().fold(f64::MIN_POSITIVE, f64::max);
        let at = move |run: usize, part: f64| {
            let x = &series[run];
            x.get((part * x.len() as f64) as usize).or(x.last()).map_or(0.0, |x| x / most)
        };
        out.push(Box::new(at));
    }
    out
}

/// History of the device that deforms most in a run.
fn most_deformed<'a>(s: &'a ProposalContext<'_>, run: usize) -> Option<&'a ResponseHistory> {
    let of_run = s.responses.histories.iter().filter(|((r, ..), h)| *r == run && !h.times.is_empty());
    of_run.map(|(_, h)| h).max_by(|a, b| a.range().deformation.total_cmp(&b.range().deformation))
}

fn work_so_far(h: &ResponseHistory) -> Vec<f64> {
    let mut sum = 0.0;
    let step = |i: usize| {
        let of = |k: usize| 0.5 * (h.force[i] + h.force[k]) * (h.deformation[i] - h.deformation[k]);
        let work = i.checked_sub(1).map_or(0.0, of);
        sum += if work.is_finite() { work.abs() } else { 0.0 };
        sum
    };
    (0..h.times.len()).map(step).collect()
}

fn largest_so_far(h: &ResponseHistory) -> Vec<f64> {
    let mut most = 0.0f64;
    let step = |u: &f64| {
        most = most.max(u.abs());
        most
    };
    h.deformation.iter().map(step).collect()
}

fn proposal(
    s: &ProposalContext<'_>,
    variable: Option<&str>,
    run: &Run,
    span: &Span,
    p: &Declared<'_>,
) -> Option<Proposal> {
    let [first, .., last] = run.recording.times[..] else { return None };
    let mut factor = AddedParameter::log(&factor_name(p.name), CONDITION_FACTORS[0], CONDITION_FACTORS[1], 1.3);
    factor.start = start_factor(s, p, span.change).clamp(CONDITION_FACTORS[0], CONDITION_FACTORS[1]);
    let time = |name: &str, part: f64| AddedParameter::linear(name, first, last, first + part * (last - first));
    let times = [(FROM, span.from), (TO, span.to)];
    let times: Vec<(&str, AddedParameter)> =
        times.into_iter().filter_map(|(name, part)| Some((name, time(name, part?)))).collect();
    let options: String = times.iter().map(|(name, _)| format!(" -{name} $::hy_{name}")).collect();
    let command = format!("amend parameter {} -factor $::hy_{}{options}", p.name, factor_name(p.name));
    let command = match variable.filter(|_| s.study.runs.len() > 1) {
        Some(variable) => only_in_run(run, variable, &command)?,
        None => command,
    };
    let form = match (span.from, span.to) {
        (Some(_), Some(_)) => "another value of a parameter between two times",
        (Some(_), None) => "another value of a parameter from a time on",
        _ => "another value of a parameter up to a time",
    };
    let name = |of: &str| times.iter().find(|(n, _)| *n == of).map(|(_, a)| a.name.clone());
    let condition = ChangedCondition {
        run: Some(run.name.clone()).filter(|_| s.study.runs.len() > 1),
        factors: vec![(p.name.to_owned(), factor.name.clone())],
        from: name(FROM),
        to: name(TO),
    };
    let parameters = std::iter::once(factor).chain(times.into_iter().map(|(_, a)| a)).collect();
    let location = format!("{} in a part of the run {}", p.name, run.name);
    Some(Proposal {
        condition: Some(condition),
        ..Proposal::script_edit(CAUSE, form, location, vec![command], parameters)
    })
}

/// Factor on a parameter that moves its coordinate by a change.
fn start_factor(s: &ProposalContext<'_>, p: &Declared<'_>, change: f64) -> f64 {
    let ParameterKind::Free(range) = &s.study.space.parameters[p.index].kind else { return 1.0 };
    match range.scale {
        Scale::Log => (range.upper / range.lower).powf(change),
        _ => 1.0 + change * (range.upper - range.lower) / s.values.get(p.index).copied().unwrap_or(range.upper),
    }
}
