//! Another value of a parameter for a part of a run, or on a ramp.

use super::change_points::{ChangePoints, Span};
use super::{CAUSE, Declared, declared, factor_name, only_in_run};
use crate::candidate::proposal::{ChangedCondition, Course};
use crate::hypothesis::context::{ProposalContext, distinguishing_variable};
use crate::hypothesis::{AddedParameter, Proposal};
use crate::inspect::response::ResponseHistory;
use crate::prior::{
    CHANGE_POINT_PARAMETERS, CONDITION_FACTORS, EFFECTIVE_SAMPLES, MAX_CONDITION_SPANS, RAMP_HEAT_TIMES,
};
use hysteron_identify::study::{ParameterKind, Role, Run, Scale};

/// Names of the added times.
pub(super) const FROM: &str = "from";
pub(super) const TO: &str = "to";

/// A span of time with the parameter that changes.
type Found<'a> = (Span, &'a Declared<'a>);

/// Forms of a parameter that changes once or twice in a run, or on a ramp, the likeliest first.
pub(super) fn proposals(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let Some(sensitivities) = &s.sensitivities else { return vec![] };
    let variable = distinguishing_variable(s.study);
    let runs: Vec<(usize, &Run)> = s.study.runs_of(Role::Fit).collect();
    let channels: Vec<usize> = runs.iter().map(|(_, run)| run.observe.len()).collect();
    let Some(points) = ChangePoints::new(sensitivities, &channels) else { return vec![] };
    let declared = declared(s);
    let clock = clock(&runs);
    let (mut steps, mut ramps): (Vec<Found<'_>>, Vec<Found<'_>>) = (vec![], vec![]);
    for p in &declared {
        let single_runs = if variable.is_some() || s.study.runs.len() == 1 { runs.len() } else { 0 };
        for run in 0..single_runs {
            // Another value in the whole run has a form of its own, with fewer parameters.
            let whole = points.whole_run(run, p.coordinate).map_or(0.0, |span| expected_gain(&span).max(0.0));
            let more = |(span, _): &Found<'_>| expected_gain(span) > whole;
            steps.extend(points.spans(run, p.coordinate).into_iter().map(|span| (span, p)).filter(more));
            ramps.extend(points.ramps(run, p.coordinate).into_iter().map(|span| (span, p)).filter(more));
        }
        if s.study.runs.len() > 1 {
            let by_clock = points.ramps_by_clock(p.coordinate, &clock).into_iter();
            ramps.extend(by_clock.filter(|span| expected_gain(span) > 0.0).map(|span| (span, p)));
        }
    }
    if steps.is_empty() && ramps.is_empty() {
        return vec![];
    }
    // A change that follows work, heat or the largest deformation is a law, and neither a step nor a ramp. One that follows
    // time is no step.
    let law = points.share_of_histories(&histories(s, &runs));
    let history = points.share_of_histories(&[Box::new(&clock)]).max(law);
    steps.retain(|(span, _)| span.share > history);
    ramps.retain(|(span, _)| span.share > law);
    let mut found = [steps, ramps].concat();
    found.sort_by(|a, b| expected_gain(&b.0).total_cmp(&expected_gain(&a.0)));
    found.truncate(MAX_CONDITION_SPANS);
    found.into_iter().filter_map(|(span, p)| proposal(s, variable.as_deref(), &runs, &span, p)).collect()
}

/// Expected log evidence over the baseline, nats: Schwarz' criterion with the price of the times.
fn expected_gain(span: &Span) -> f64 {
    let parameters = 1 + CHANGE_POINT_PARAMETERS * span.change_points();
    -0.5 * EFFECTIVE_SAMPLES * (1.0 - span.share).ln() - 0.5 * parameters as f64 * EFFECTIVE_SAMPLES.ln()
}

fn duration(run: &Run) -> f64 {
    match run.recording.times[..] {
        [first, .., last] => last - first,
        _ => 0.0,
    }
}

fn longest(runs: &[(usize, &Run)]) -> f64 {
    runs.iter().map(|(_, run)| duration(run)).fold(f64::MIN_POSITIVE, f64::max)
}

/// Time by run and part of it, in parts of the longest run.
fn clock<'a>(runs: &'a [(usize, &'a Run)]) -> impl Fn(usize, f64) -> f64 + 'a {
    let longest = longest(runs);
    move |run, part| part * duration(runs[run].1) / longest
}

/// A history by run and part of it, from 0 to 1.
type History<'a> = Box<dyn Fn(usize, f64) -> f64 + 'a>;

/// Histories that a law may follow: work, heat that is lost slowly or fast, and the largest deformation so far.
fn histories<'a>(s: &ProposalContext<'_>, runs: &[(usize, &Run)]) -> Vec<History<'a>> {
    let devices: Option<Vec<&ResponseHistory>> = runs.iter().map(|(number, _)| most_deformed(s, *number)).collect();
    let longest = longest(runs);
    let series = |h: &&ResponseHistory| {
        let work = [f64::INFINITY, RAMP_HEAT_TIMES[0], RAMP_HEAT_TIMES[1]].map(|part| work_so_far(h, part * longest));
        [&work[..], &[largest_so_far(h)]].concat()
    };
    let by_device: Vec<Vec<Vec<f64>>> = devices.unwrap_or_default().iter().map(series).collect();
    let laws = by_device.first().map_or(0, Vec::len);
    let history = |law: usize| -> History<'a> {
        let series: Vec<Vec<f64>> = by_device.iter().map(|of| of[law].clone()).collect();
        let most = series.iter().flatten().copied().fold(f64::MIN_POSITIVE, f64::max);
        Box::new(move |run: usize, part: f64| {
            let x = &series[run];
            x.get((part * x.len() as f64) as usize).or(x.last()).map_or(0.0, |x| x / most)
        })
    };
    (0..laws).map(history).collect()
}

/// History of the device that deforms most in a run.
fn most_deformed<'a>(s: &'a ProposalContext<'_>, run: usize) -> Option<&'a ResponseHistory> {
    let of_run = s.responses.histories.iter().filter(|((r, ..), h)| *r == run && !h.times.is_empty());
    of_run.map(|(_, h)| h).max_by(|a, b| a.range().deformation.total_cmp(&b.range().deformation))
}

/// Work so far, of which a time constant in s keeps what is not lost as heat.
fn work_so_far(h: &ResponseHistory, time_constant: f64) -> Vec<f64> {
    let mut sum = 0.0;
    let step = |i: usize| {
        let Some(k) = i.checked_sub(1) else { return sum };
        let work = 0.5 * (h.force[i] + h.force[k]) * (h.deformation[i] - h.deformation[k]);
        sum *= ((h.times[k] - h.times[i]) / time_constant).exp();
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

/// Beginning and end of a run; without one, of the longest run.
fn bounds(run: Option<&Run>, runs: &[(usize, &Run)]) -> Option<[f64; 2]> {
    let longest = || runs.iter().map(|(_, run)| *run).max_by(|a, b| duration(a).total_cmp(&duration(b)));
    match run.or_else(longest)?.recording.times[..] {
        [first, .., last] => Some([first, last]),
        _ => None,
    }
}

fn proposal(
    s: &ProposalContext<'_>,
    variable: Option<&str>,
    runs: &[(usize, &Run)],
    span: &Span,
    p: &Declared<'_>,
) -> Option<Proposal> {
    let run = span.run.map(|run| runs[run].1);
    let [first, last] = bounds(run, runs)?;
    let mut factor = AddedParameter::log(&factor_name(p.name), CONDITION_FACTORS[0], CONDITION_FACTORS[1], 1.3);
    factor.start = start_factor(s, p, span.change).clamp(CONDITION_FACTORS[0], CONDITION_FACTORS[1]);
    // The beginning of a way back is that of the other value.
    let [begins, ends] = match span.course {
        Course::Step => [&["from"][..], &["to"]],
        Course::Ramp => [&["from"][..], &["reached"]],
        Course::Recovery => [&["from", "to"][..], &["recovered"]],
    };
    let times = [(FROM, begins, span.from, first), (TO, ends, span.to, last)];
    let mut options = String::new();
    let mut added = vec![];
    for (name, own, part, bound) in times {
        if let Some(part) = part {
            added.push(AddedParameter::linear(name, first, last, first + part * (last - first)));
            own.iter().for_each(|option| options += &format!(" -{option} $::hy_{name}"));
        } else if span.course != Course::Step {
            own.iter().for_each(|option| options += &format!(" -{option} {bound}"));
        }
    }
    let command = format!("amend parameter {} -factor $::hy_{}{options}", p.name, factor_name(p.name));
    let command = match run.zip(variable).filter(|_| s.study.runs.len() > 1) {
        Some((run, variable)) => only_in_run(run, variable, &command)?,
        None => command,
    };
    let form = match (span.course, span.from, span.to) {
        (Course::Ramp, None, None) => "a parameter that goes steadily to another value",
        (Course::Ramp, ..) => "a parameter that goes to another value on a ramp",
        (Course::Recovery, ..) => "another value of a parameter that goes back to the usual one",
        (_, Some(_), Some(_)) => "another value of a parameter between two times",
        (_, Some(_), None) => "another value of a parameter from a time on",
        _ => "another value of a parameter up to a time",
    };
    let name = |of: &str| added.iter().find(|a| a.name == format!("hy_{of}")).map(|a| a.name.clone());
    let condition = ChangedCondition {
        run: run.map(|run| run.name.clone()).filter(|_| s.study.runs.len() > 1),
        also_in: vec![],
        factors: vec![(p.name.to_owned(), factor.name.clone())],
        from: name(FROM),
        to: name(TO),
        course: span.course,
    };
    let parameters = std::iter::once(factor).chain(added).collect();
    let location = match run {
        Some(run) if span.course == Course::Ramp => format!("parameter {} on a ramp in the run {}", p.name, run.name),
        Some(run) => format!("parameter {} in a part of the run {}", p.name, run.name),
        None => format!("parameter {} with the time of each run", p.name),
    };
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
