//! Another value of a user's parameter in words: its values, the run, and the times.

use super::quantity::digits;
use crate::candidate::proposal::{ChangedCondition, Course};
use crate::candidate::variant::Variant;
use serde::Serialize;

/// Time for which the user's parameters have other values.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TimeSpan {
    /// The run; empty if there is one alone.
    pub run: String,
    /// Its beginning, s; none for that of the run.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub from: Option<f64>,
    /// Its end, s; none for that of the run.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub to: Option<f64>,
    /// True if the values are reached on a ramp, and hold from its end on.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub ramp: bool,
    /// True if they are there at its beginning, and back at the usual ones on a ramp to its end.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub recovers: bool,
}

/// A changed condition with its fitted values.
pub(super) struct FittedCondition<'a> {
    condition: &'a ChangedCondition,
    variant: &'a Variant,
    values: &'a [f64],
}

/// Digits of the values in a sentence.
const DIGITS: i32 = 3;

impl<'a> FittedCondition<'a> {
    /// That of a variant at values of all its parameters; none for other effects.
    pub(super) fn of(variant: &'a Variant, values: &'a [f64]) -> Option<Self> {
        let condition = variant.proposal.as_ref()?.condition.as_ref()?;
        Some(Self { condition, variant, values })
    }

    fn value(&self, name: &str) -> Option<f64> {
        let index = self.variant.study.space.parameters.iter().position(|p| p.name == name)?;
        self.values.get(index).copied()
    }

    /// The parameters with their other values and the usual ones.
    fn changed(&self) -> Vec<(&'a str, f64, f64)> {
        let of = |(name, factor): &'a (String, String)| {
            let usual = self.value(name)?;
            Some((name.as_str(), usual * self.value(factor)?, usual))
        };
        self.condition.factors.iter().filter_map(of).collect()
    }

    /// The time of the other values; none for a whole run.
    pub(super) fn span(&self) -> Option<TimeSpan> {
        let time = |name: &Option<String>| name.as_deref().and_then(|n| self.value(n));
        let (from, to) = (time(&self.condition.from), time(&self.condition.to));
        let run = self.condition.run.clone().unwrap_or_default();
        let course = self.condition.course;
        let (ramp, recovers) = (course == Course::Ramp, course == Course::Recovery);
        (course != Course::Step || from.is_some() || to.is_some()).then_some(TimeSpan { run, from, to, ramp, recovers })
    }

    /// When the parameters have the other values, in words.
    fn when(&self) -> String {
        let seconds = |t: f64| digits(t, DIGITS);
        let time = self.span().map(|s| match (s.from, s.to) {
            (None, None) => "from the beginning to the end".to_owned(),
            (Some(from), None) if s.ramp || s.recovers => format!("from {} s to the end", seconds(from)),
            (None, Some(to)) if s.ramp => format!("from the beginning to {} s", seconds(to)),
            (Some(from), Some(to)) => format!("from {} to {} s", seconds(from), seconds(to)),
            (Some(from), None) => format!("from {} s on", seconds(from)),
            (_, to) => format!("up to {} s", seconds(to.unwrap_or(0.0))),
        });
        let also = self.condition.also_in.iter().map(|run| format!(" and in {run}, which was held out"));
        let run = self.condition.run.as_ref().map(|run| format!("in the run {run}{}", also.collect::<String>()));
        time.into_iter().chain(run).collect::<Vec<_>>().join(" ")
    }

    /// The values in words: `Fp is 13.9 from 3.6 to 9.7 s in the run A, and 10 otherwise`, or `k goes from 10 to 8 from 2 to 9 s`.
    pub(super) fn description(&self) -> String {
        let all = self.changed();
        if self.condition.course == Course::Recovery {
            let of = |(name, x, usual): &(&str, f64, f64)| {
                format!("{name} jumps to {} and goes back to {}", digits(*x, DIGITS), digits(*usual, DIGITS))
            };
            return format!("{} {}", all.iter().map(of).collect::<Vec<_>>().join(" and "), self.when());
        }
        if self.condition.course == Course::Ramp {
            let of = |(name, x, usual): &(&str, f64, f64)| {
                format!("{name} goes from {} to {}", digits(*usual, DIGITS), digits(*x, DIGITS))
            };
            return format!("{} {}", all.iter().map(of).collect::<Vec<_>>().join(" and "), self.when());
        }
        let other: Vec<String> = all.iter().map(|(name, x, _)| format!("{name} is {}", digits(*x, DIGITS))).collect();
        let usual: Vec<String> = all.iter().map(|(.., x)| digits(*x, DIGITS)).collect();
        format!("{} {}, and {} otherwise", other.join(" and "), self.when(), usual.join(" and "))
    }

    /// The value that has to be known of another run before it is predicted.
    pub(super) fn needed(&self) -> String {
        let all = self.changed();
        if self.condition.course == Course::Ramp && self.condition.run.is_none() {
            let names: Vec<&str> = all.iter().map(|(name, ..)| *name).collect();
            let names = names.join(" and ");
            return format!(
                "before another run is predicted, find out whether {names} changes in it too, as corrected.tcl takes it"
            );
        }
        let values = all.iter().map(|(name, x, usual)| {
            let (x, usual) = (digits(*x, DIGITS), digits(*usual, DIGITS));
            format!("{name} of it is {usual}, which corrected.tcl takes, or {x}")
        });
        format!(
            "before another run is predicted, find out whether {}",
            values.collect::<Vec<_>>().join(", and whether ")
        )
    }
}

#[cfg(test)]
mod tests {
    use super::FittedCondition;
    use crate::candidate::proposal::{ChangedCondition, Course, Proposal};
    use crate::candidate::variant::Variant;
    use crate::inspect::insertion::InsertionPoint;
    use crate::test_support::{baseline, script_edit};

    /// The pad of the repository with a factor of 1.5 on its first parameter, from 2 s or up to 4 s, or both. It holds in the run
    /// A, and a ramp without times in all runs.
    fn fitted(from: bool, to: bool, ramp: bool) -> (Variant, Vec<f64>, String) {
        let own = baseline();
        let name = own.variant.study.space.parameters[0].name.clone();
        let added = |n: &str| format!("hy_{n}");
        let condition = ChangedCondition {
            run: (!ramp || from || to).then(|| "A".into()),
            also_in: vec![],
            factors: vec![(name.clone(), added("factor"))],
            from: from.then(|| added("from")),
            to: to.then(|| added("to")),
            course: if ramp { Course::Ramp } else { Course::Step },
        };
        let proposal =
            Proposal { condition: Some(condition), ..script_edit("changed_condition", &["factor", "from", "to"]) };
        let variant = own.variant.with_proposal(&InsertionPoint::At(0), &proposal).expect("a variant");
        let mut values = own.fitted.values.clone();
        values[0] = 10.0;
        values.extend([1.5, 2.0, 4.0]);
        (variant, values, name)
    }

    #[test]
    fn the_sentence_has_values_run_and_times() {
        let told = |from, to| {
            let (variant, values, name) = fitted(from, to, false);
            let c = FittedCondition::of(&variant, &values).expect("a condition");
            (c.description().replace(&name, "x"), c.span().map(|s| (s.from, s.to)))
        };
        assert_eq!(told(false, false), ("x is 15 in the run A, and 10 otherwise".into(), None));
        let both = "x is 15 from 2 to 4 s in the run A, and 10 otherwise".to_owned();
        assert_eq!(told(true, true), (both, Some((Some(2.0), Some(4.0)))));
        assert_eq!(told(true, false).0, "x is 15 from 2 s on in the run A, and 10 otherwise");
        assert_eq!(told(false, true).0, "x is 15 up to 4 s in the run A, and 10 otherwise");
    }

    #[test]
    fn a_run_held_out_that_follows_the_other_values_is_said() {
        let (mut variant, values, name) = fitted(false, false, false);
        let condition = variant.proposal.as_mut().and_then(|p| p.condition.as_mut()).expect("a condition");
        condition.also_in = vec!["H".into()];
        let told = FittedCondition::of(&variant, &values).expect("a condition").description().replace(&name, "x");
        assert_eq!(told, "x is 15 in the run A and in H, which was held out, and 10 otherwise");
    }

    #[test]
    fn a_ramp_has_both_values_and_its_times() {
        let told = |from, to| {
            let (variant, values, name) = fitted(from, to, true);
            let c = FittedCondition::of(&variant, &values).expect("a condition");
            assert!(c.span().is_some_and(|s| s.ramp));
            c.description().replace(&name, "x")
        };
        assert_eq!(told(true, true), "x goes from 10 to 15 from 2 to 4 s in the run A");
        assert_eq!(told(true, false), "x goes from 10 to 15 from 2 s to the end in the run A");
        assert_eq!(told(false, true), "x goes from 10 to 15 from the beginning to 4 s in the run A");
        assert_eq!(told(false, false), "x goes from 10 to 15 from the beginning to the end");
        let (variant, values, name) = fitted(false, false, true);
        let needed = FittedCondition::of(&variant, &values).expect("a condition").needed().replace(&name, "x");
        assert!(needed.contains("whether x changes in it too"), "{needed}");
    }

    #[test]
    fn a_way_back_has_both_values() {
        let (mut variant, values, name) = fitted(true, true, false);
        variant.proposal.as_mut().and_then(|p| p.condition.as_mut()).expect("a condition").course = Course::Recovery;
        let c = FittedCondition::of(&variant, &values).expect("a condition");
        assert_eq!(c.description().replace(&name, "x"), "x jumps to 15 and goes back to 10 from 2 to 4 s in the run A");
        assert!(c.span().is_some_and(|s| s.recovers && !s.ramp));
    }

    #[test]
    fn a_prediction_asks_for_the_condition() {
        let (variant, values, name) = fitted(true, false, false);
        let needed = FittedCondition::of(&variant, &values).expect("a condition").needed().replace(&name, "x");
        let told = "before another run is predicted, find out whether x of it is 10, which corrected.tcl takes, or 15";
        assert_eq!(needed, told);
        assert!(FittedCondition::of(&baseline().variant, &values).is_none());
    }

    #[test]
    fn a_time_of_change_is_paid_for() {
        let parameters = |from, to| fitted(from, to, false).0.counted_parameters();
        assert_eq!(parameters(true, false), parameters(false, false) + 1);
        assert_eq!(parameters(true, true), parameters(false, false) + 2);
    }
}
