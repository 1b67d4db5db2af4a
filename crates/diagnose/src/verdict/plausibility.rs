//! Checks of a repair by balances and by published ranges.
//!
//! A fit may use an effect for something else that falls or grows in the same way. Heat, mass and geometry then contradict
//! it, or its sizes are none that such devices have.

use super::quantity::digits;
use super::summary::SummaryContext;
use crate::candidate::proposal::AddedParameter;
use crate::candidate::variant::Variant;
use crate::fit::search_settings::is_at_bound;
use crate::hypothesis;
use crate::hypothesis::ambient_temperature::STEEPEST_SOFTENING;
use crate::inspect::response::ResponseRange;
use hysteron_identify::study::{Role, Study};

/// Softening of the amendment, to which its heat capacity refers, 1/degree.
const ASSUMED_SOFTENING: f64 = 0.01;
/// Largest ratio of shear modulus and heat capacity of rubber, degrees: 1.5 MPa over 1.9 MJ/(m³ degree).
const MODULUS_OVER_HEAT_CAPACITY: f64 = 0.8;
/// Largest ratio of yield stress and heat capacity of lead, degrees: 20 MPa over 1.46 MJ/(m³ degree) (Kalpakidis and Constantinou
/// 2009).
const LEAD_STRESS_OVER_HEAT_CAPACITY: f64 = 13.7;
/// Largest shear strain of a bearing.
const LARGEST_SHEAR_STRAIN: f64 = 3.0;

/// Contradictions of a repair, each a sentence; none if nothing speaks against it.
pub(super) fn contradictions(c: &SummaryContext<'_>) -> Vec<String> {
    let mut out: Vec<String> = added(c.variant, c.values)
        .into_iter()
        .filter_map(|(cause, name, x)| outside_published(cause, name, x))
        .collect();
    out.extend(heat_balance(c));
    out.extend(eccentricity(c.variant, c.values, c.inventory.extent));
    out.extend(footing_mass(c));
    out
}

/// Amplitude of a run held out over the fitted ones from which a repair extrapolates. A choice.
const MIN_EXTRAPOLATION: f64 = 1.2;

/// The channel that goes furthest beyond its fitted amplitude in the runs held out, as a sentence.
pub(super) fn beyond_fitted_amplitude(study: &Study) -> Option<String> {
    let amplitude = |role: Role, channel: &str| {
        let channels = study.runs_of(role).flat_map(|(_, r)| &r.observe).filter(|o| o.channel == channel);
        channels.flat_map(|o| &o.values).filter(|v| v.is_finite()).fold(0.0f64, |most, v| most.max(v.abs()))
    };
    let mut names: Vec<&str> =
        study.runs_of(Role::Holdout).flat_map(|(_, r)| &r.observe).map(|o| &*o.channel).collect();
    names.sort_unstable();
    names.dedup();
    let ratio = |name: &&str| amplitude(Role::Holdout, name) / amplitude(Role::Fit, name);
    let ratios = names.into_iter().map(|name| (ratio(&name), name)).filter(|(ratio, _)| ratio.is_finite());
    let (ratio, name) = ratios.max_by(|a, b| a.0.total_cmp(&b.0))?;
    (ratio > MIN_EXTRAPOLATION).then(|| {
        format!(
            "the channel {name} goes to {} times its fitted amplitude in the runs held out: there the repair extrapolates",
            digits(ratio, 2)
        )
    })
}

/// Parameters of the user that leave their bounds by the repair, each a sentence.
///
/// A parameter at a bound makes up for what the model lacks.
pub(super) fn parameters_that_leave_bounds(c: &SummaryContext<'_>) -> Vec<String> {
    let space = &c.study.space;
    let moved = space.free().filter_map(|(i, range)| {
        let name = &space.parameters[i].name;
        let at_bound = |x: f64| is_at_bound(range.unit_coordinate(x));
        let (before, after) = (*c.baseline.parameters.get(name)?, *c.corrected.parameters.get(name)?);
        let is_used = !c.corrected.unused.contains(name);
        (is_used && at_bound(before) && !at_bound(after)).then(|| {
            let [before, after] = [before, after].map(|x| digits(x, 3));
            format!("your parameter {name} was at its bound {before} without the repair, and is {after} with it")
        })
    });
    moved.collect()
}

/// Added parameters with their cause, plain name and value.
fn added<'a>(variant: &'a Variant, values: &[f64]) -> Vec<(&'static str, &'a str, f64)> {
    let Some(p) = &variant.proposal else { return vec![] };
    let values = variant.split(values).1;
    let named = |(a, x): (&'a AddedParameter, &f64)| {
        let (prefix, name) = a.name.split_once('_')?;
        let cause = if prefix == "hy2" { p.second_cause.unwrap_or(p.cause) } else { p.cause };
        Some((cause, name, *x))
    };
    p.parameters.iter().zip(values).filter_map(named).collect()
}

fn value_of(variant: &Variant, values: &[f64], cause: &str, name: &str) -> Option<f64> {
    added(variant, values).into_iter().find(|(of, n, _)| (*of, *n) == (cause, name)).map(|(.., x)| x)
}

fn outside_published(cause: &str, name: &str, x: f64) -> Option<String> {
    let p = hypothesis::quantity(cause, name)?.published?;
    let outside = x < p.lower || x > p.upper;
    outside.then(|| format!("{}, {}, is none that such devices have: {}", p.subject, digits(x, 2), p.words))
}

/// Largest rise of temperature that the work of a device can cause in rubber, degrees.
///
/// The volume of rubber that shears by d at a force F is at least F d / (G γ²) for the largest modulus G and strain γ. The work
/// W heats it by at most W G γ² / (F d ρc). Steel and conduction take further heat.
fn largest_rise(r: &ResponseRange) -> f64 {
    MODULUS_OVER_HEAT_CAPACITY * LARGEST_SHEAR_STRAIN.powi(2) * r.work / (r.force * r.deformation)
}

/// Largest rise of temperature that the work of a device can cause in a lead core that carries the whole force, degrees.
///
/// The volume of lead of the yield stress s that shears by d at a force F is at least F d / (s γ).
fn largest_rise_of_lead(r: &ResponseRange) -> f64 {
    LEAD_STRESS_OVER_HEAT_CAPACITY * LARGEST_SHEAR_STRAIN * r.work / (r.force * r.deformation)
}

/// The least rise of temperature that a softening of the whole force needs, degrees; none for a repair without heat.
fn needed_rise(variant: &Variant, values: &[f64], range: &ResponseRange) -> Option<f64> {
    // Forms with conduction stand for sliding faces, which become much hotter.
    let of = |name| value_of(variant, values, "self_heating", name);
    let (capacity, _) = of("capacity").zip(of("cooling"))?;
    Some(ASSUMED_SOFTENING / STEEPEST_SOFTENING * range.work / capacity)
}

/// The rise of temperature of a repair, against the largest possible one of rubber.
fn heat_balance(c: &SummaryContext<'_>) -> Option<String> {
    let range = c.largest_work?;
    let (needed, possible) = (needed_rise(c.variant, c.values, &range)?, largest_rise(&range));
    (needed > possible).then(|| {
        format!(
            "the heating needs a rise of at least {needed:.0} degrees, and the work that is done can warm rubber by {possible:.0} degrees at most: \
             something else falls with the work"
        )
    })
}

/// The rise of temperature of a repair that no device can have: more than that of a lead core, which becomes hotter than
/// rubber.
pub(super) fn impossible_heat(variant: &Variant, values: &[f64], work: Option<ResponseRange>) -> Option<String> {
    let range = work?;
    let (needed, possible) = (needed_rise(variant, values, &range)?, largest_rise_of_lead(&range));
    (needed > possible).then(|| {
        format!(
            "the heating needs a rise of at least {needed:.0} degrees, and the work that is done can warm a lead core by {possible:.0} degrees at most"
        )
    })
}

/// An eccentricity beyond the half of the model's extent. A model in one point has none.
pub(super) fn eccentricity(variant: &Variant, values: &[f64], extent: f64) -> Option<String> {
    if extent <= 0.0 {
        return None;
    }
    let is_far = |n: &&str| value_of(variant, values, "torsion", n).is_some_and(|e| e.abs() > 0.5 * extent);
    let far = ["ex", "ey"].into_iter().find(is_far)?;
    Some(format!("the eccentricity {far} puts the mass outside the model"))
}

/// A footing that is heavier than everything above it.
fn footing_mass(c: &SummaryContext<'_>) -> Option<String> {
    let footing = value_of(c.variant, c.values, "foundation_flexibility", "footing")?;
    let above: f64 = c.inventory.masses.iter().filter_map(|m| m.mass.first()).sum();
    (footing > above).then(|| "the footing has more mass than everything above it".to_owned())
}

#[cfg(test)]
mod tests {
    use super::{beyond_fitted_amplitude, largest_rise, largest_rise_of_lead, outside_published};
    use crate::inspect::response::ResponseRange;
    use crate::test_support::pad_study;
    use hysteron_identify::study::Role;

    #[test]
    fn amplitudes_beyond_the_fitted_ones_are_called_out() {
        let mut study = pad_study();
        let scale = |study: &mut hysteron_identify::study::Study, factor: f64| {
            let held = study.runs.iter_mut().filter(|r| r.role == Role::Holdout).flat_map(|r| &mut r.observe);
            held.flat_map(|o| &mut o.values).for_each(|v| *v *= factor);
        };
        scale(&mut study, 0.01);
        assert_eq!(beyond_fitted_amplitude(&study), None);
        scale(&mut study, 1e4);
        assert!(beyond_fitted_amplitude(&study).is_some_and(|t| t.starts_with("the channel force goes to ")));
    }

    #[test]
    fn a_cooling_time_of_seconds_is_called_out() {
        assert!(
            outside_published("self_heating", "cooling", 5.0)
                .is_some_and(|t| t.contains("cooling time, s, 5, is none"))
        );
        assert!(outside_published("self_heating", "cooling", 600.0).is_none());
        assert!(outside_published("gap_impact", "gap", 5.0).is_none());
    }

    /// A full cycle at an equivalent damping ratio of 20 % does the work 2π 0.2 F d, and warms rubber at three times its
    /// thickness by less than ten degrees.
    #[test]
    fn a_cycle_warms_rubber_by_some_degrees() {
        let cycle = ResponseRange {
            force: 100.0,
            deformation: 0.2,
            work: 0.4 * std::f64::consts::PI * 20.0,
            ..ResponseRange::default()
        };
        assert!((8.0..10.0).contains(&largest_rise(&cycle)), "{}", largest_rise(&cycle));
        assert!(largest_rise_of_lead(&cycle) > 5.0 * largest_rise(&cycle));
    }
}
