//! A check of a rule: demand against limit.

use crate::codes::Code;
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
}

impl Status {
    /// A word for tables.
    pub fn word(self) -> &'static str {
        match self {
            Self::Met => "met",
            Self::NotMet => "NOT MET",
            Self::NotChecked => "not checked",
        }
    }
}

/// A demand beside the limit of a rule.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Subject: quantity and place.
    pub subject: String,
    /// Clause of the code.
    pub clause: String,
    /// Demand.
    pub demand: f64,
    /// Limit.
    pub limit: f64,
    /// Demand over limit, or limit over demand for a lower limit: met up to 1.
    pub ratio: f64,
    /// Result.
    pub status: Status,
}

impl Check {
    fn new(subject: String, clause: &str, demand: f64, limit: f64, is_met: bool, ratio: f64) -> Self {
        let known = demand.is_finite() && limit.is_finite();
        let status = match (known, is_met) {
            (false, _) => Status::NotChecked,
            (_, true) => Status::Met,
            (_, false) => Status::NotMet,
        };
        Self { subject, clause: clause.to_owned(), demand, limit, ratio, status }
    }

    /// A demand that may not exceed a limit.
    pub fn at_most(subject: impl Into<String>, clause: &str, demand: f64, limit: f64) -> Self {
        let ratio = if limit == 0.0 { if demand > 0.0 { f64::INFINITY } else { 0.0 } } else { demand / limit };
        Self::new(subject.into(), clause, demand, limit, demand <= limit, ratio)
    }

    /// A value that may not fall below a limit.
    pub fn at_least(subject: impl Into<String>, clause: &str, value: f64, limit: f64) -> Self {
        let ratio = if value == 0.0 { if limit > 0.0 { f64::INFINITY } else { 0.0 } } else { limit / value };
        Self::new(subject.into(), clause, value, limit, value >= limit, ratio)
    }

    /// A demand that may not exceed a number of a rule; not checked if the code has none.
    pub fn most_of(code: &Code, rule: &str, subject: impl Into<String>, demand: f64) -> Self {
        Self::at_most(subject, code.clause(rule), demand, code.value(rule, "most").unwrap_or(f64::NAN))
    }

    /// A value that may not fall below a number of a rule; not checked if the code has none.
    pub fn least_of(code: &Code, rule: &str, subject: impl Into<String>, value: f64) -> Self {
        Self::at_least(subject, code.clause(rule), value, code.value(rule, "least").unwrap_or(f64::NAN))
    }
}

/// Checks as a table.
pub fn check_table(checks: &[Check]) -> Table {
    let mut table =
        Table::new([("check", ""), ("clause", ""), ("demand", ""), ("limit", ""), ("ratio", ""), ("result", "")]);
    let number = |x: f64| if x.is_finite() { Cell::Number(x) } else { Cell::Word("-") };
    for c in checks {
        table.rows.push(vec![
            c.subject.clone().into(),
            c.clause.clone().into(),
            number(c.demand),
            number(c.limit),
            number(c.ratio),
            Cell::Word(c.status.word()),
        ]);
    }
    table
}

#[cfg(test)]
mod tests {
    use super::{Check, Status};

    #[test]
    fn ratios_and_results_at_both_kinds_of_limits() {
        let c = Check::at_most("a", "1", 3.0, 2.0);
        assert!(c.status == Status::NotMet && c.ratio == 1.5);
        let c = Check::at_least("a", "1", 3.0, 2.0);
        assert!(c.status == Status::Met && (c.ratio - 2.0 / 3.0).abs() < 1e-12);
        assert_eq!(Check::at_most("a", "1", 3.0, f64::NAN).status, Status::NotChecked);
    }
}
