//! A check of a rule: demand against limit.

use crate::codes::{Code, Reading};
use hysteron_identify::report::{Cell, Table};

/// Result of a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// The demand is within the limit.
    Met,
    /// It is not.
    NotMet,
    /// There is no limit or no demand: the reason is in the subject.
    NotChecked,
    /// A least value of a dynamic procedure is not reached: results are multiplied by the ratio, and checked with it.
    Scaled,
    /// A limit of a simpler procedure is passed: the design rests on the response history analysis.
    NeedsHistory,
    /// Second-order effects are to be in the model.
    NeedsSecondOrder,
}

impl Status {
    /// Words for tables.
    pub fn word(self) -> &'static str {
        match self {
            Self::Met => "met",
            Self::NotMet => "NOT MET",
            Self::NotChecked => "not checked",
            Self::Scaled => "scaled up",
            Self::NeedsHistory => "history needed",
            Self::NeedsSecondOrder => "P-Delta needed",
        }
    }
}

/// Side of a limit on which a demand is met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// The demand may not exceed the limit.
    AtMost,
    /// The value may not fall below the limit.
    AtLeast,
}

impl Sense {
    /// Words before a limit in a sentence.
    pub fn words(self) -> &'static str {
        match self {
            Self::AtMost => "at most",
            Self::AtLeast => "at least",
        }
    }

    /// Sign between demand and limit for tables.
    pub fn sign(self) -> &'static str {
        match self {
            Self::AtMost => "<=",
            Self::AtLeast => ">=",
        }
    }
}

/// Clause of a rule and where its wording comes from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Citation {
    /// Edition and clause; empty for a rule of this program.
    pub clause: String,
    /// Source of the wording.
    pub reading: Option<Reading>,
}

impl Citation {
    /// Of a rule of a code.
    pub fn of(code: &Code, rule: &str) -> Self {
        Self { clause: code.clause(rule), reading: code.reading(rule) }
    }
}

/// A demand beside the limit of a rule.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Subject: quantity and place.
    pub subject: String,
    /// Clause of the code.
    pub citation: Citation,
    /// Demand.
    pub demand: f64,
    /// Side of the limit on which the demand is met.
    pub sense: Sense,
    /// Limit.
    pub limit: f64,
    /// Demand over limit, or limit over demand for a lower limit: met up to 1.
    pub ratio: f64,
    /// Result.
    pub status: Status,
    /// It is about the suite of motions, and not about the structure.
    pub is_of_suite: bool,
}

impl Check {
    fn new(subject: String, citation: Citation, [demand, limit]: [f64; 2], sense: Sense) -> Self {
        let (least, most) = match sense {
            Sense::AtMost => (demand, limit),
            Sense::AtLeast => (limit, demand),
        };
        let status = match demand.is_finite() && limit.is_finite() {
            false => Status::NotChecked,
            true if least <= most => Status::Met,
            true => Status::NotMet,
        };
        let ratio = match most == 0.0 {
            false => least / most,
            true if least > 0.0 => f64::INFINITY,
            true => 0.0,
        };
        Self { subject, citation, demand, sense, limit, ratio, status, is_of_suite: false }
    }

    /// A demand that may not exceed a limit.
    pub fn at_most(subject: impl Into<String>, citation: Citation, demand: f64, limit: f64) -> Self {
        Self::new(subject.into(), citation, [demand, limit], Sense::AtMost)
    }

    /// A value that may not fall below a limit.
    pub fn at_least(subject: impl Into<String>, citation: Citation, value: f64, limit: f64) -> Self {
        Self::new(subject.into(), citation, [value, limit], Sense::AtLeast)
    }

    /// A demand that may not exceed a number of a rule; not checked if the code has none.
    pub fn most_of(code: &Code, rule: &str, subject: impl Into<String>, demand: f64) -> Self {
        Self::at_most(subject, Citation::of(code, rule), demand, code.value(rule, "most").unwrap_or(f64::NAN))
    }

    /// A value that may not fall below a number of a rule; not checked if the code has none.
    pub fn least_of(code: &Code, rule: &str, subject: impl Into<String>, value: f64) -> Self {
        Self::at_least(subject, Citation::of(code, rule), value, code.value(rule, "least").unwrap_or(f64::NAN))
    }

    /// The same check as one about the suite of motions.
    #[must_use]
    pub fn of_suite(self) -> Self {
        Self { is_of_suite: true, ..self }
    }

    /// The same check with another result where it is not met.
    #[must_use]
    pub fn or_else(mut self, status: Status) -> Self {
        if self.status == Status::NotMet {
            self.status = status;
        }
        self
    }
}

/// Checks as a table.
pub fn check_table(checks: &[Check]) -> Table {
    let mut table = Table::new([
        ("check", ""),
        ("clause", ""),
        ("demand", ""),
        ("sense", ""),
        ("limit", ""),
        ("ratio", ""),
        ("result", ""),
        ("wording", ""),
    ]);
    let number = |x: f64| if x.is_finite() { Cell::Number(x) } else { Cell::Word("-") };
    for c in checks {
        table.rows.push(vec![
            c.subject.clone().into(),
            c.citation.clause.clone().into(),
            number(c.demand),
            Cell::Word(c.sense.sign()),
            number(c.limit),
            number(c.ratio),
            Cell::Word(c.status.word()),
            Cell::Word(c.citation.reading.map_or("", Reading::word)),
        ]);
    }
    table
}

#[cfg(test)]
mod tests {
    use super::{Check, Citation, Status, check_table};

    #[test]
    fn ratios_and_results_at_both_kinds_of_limits() {
        let c = Check::at_most("a", Citation::default(), 3.0, 2.0);
        assert!(c.status == Status::NotMet && c.ratio == 1.5);
        assert_eq!(c.or_else(Status::Scaled).status, Status::Scaled);
        let c = Check::at_least("a", Citation::default(), 3.0, 2.0);
        assert!(c.status == Status::Met && (c.ratio - 2.0 / 3.0).abs() < 1e-12);
        assert_eq!(c.or_else(Status::Scaled).status, Status::Met);
        assert_eq!(Check::at_most("a", Citation::default(), 3.0, f64::NAN).status, Status::NotChecked);
    }

    #[test]
    fn limits_without_demand_and_demands_without_limit() {
        let most = |demand, limit| Check::at_most("a", Citation::default(), demand, limit).ratio;
        let least = |value, limit| Check::at_least("a", Citation::default(), value, limit).ratio;
        assert_eq!(
            [most(1.0, 0.0), most(0.0, 0.0), least(0.0, 1.0), least(0.0, 0.0)],
            [f64::INFINITY, 0.0, f64::INFINITY, 0.0]
        );
    }

    #[test]
    fn the_table_says_which_way_a_limit_goes() {
        let checks =
            [Check::at_most("a", Citation::default(), 1.0, 2.0), Check::at_least("b", Citation::default(), 3.0, 2.0)];
        let text = check_table(&checks).text();
        let lines: Vec<Vec<&str>> = text.lines().map(|l| l.split_whitespace().collect()).collect();
        assert!(lines[0].starts_with(&["check", "clause", "demand", "sense", "limit"]), "{text}");
        assert!(text.contains("<=") && text.contains(">="), "{text}");
    }
}
