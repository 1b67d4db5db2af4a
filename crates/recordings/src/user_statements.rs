//! Statements of the user beside a file, and how messages ask for them.

use crate::fault::Fault;
use crate::series::Series;
use crate::unit::{self, Quantity, Unit};
pub use crate::way::{Key, Way};

/// Statements of the user about a file that does not make them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct UserStatements {
    /// Unit of the values.
    pub unit: Option<String>,
    /// Step of time in s.
    pub dt: Option<f64>,
    /// Quantity: acceleration, velocity, displacement, force, ...
    pub quantity: Option<String>,
    /// Meaning of the numbers of a row, in a table without names.
    pub layout: Option<Layout>,
    /// Place of the statement. Messages ask for what is missing in the words of this place.
    pub way: Way,
}

/// Meaning of the numbers of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// Samples of several channels at one time.
    Columns,
    /// Samples of one channel one after another.
    Wrapped,
}

impl Layout {
    /// The layout of a word.
    ///
    /// # Errors
    /// The word is none.
    pub fn named(word: &str) -> Result<Self, Fault> {
        match word {
            "columns" => Ok(Self::Columns),
            "wrapped" => Ok(Self::Wrapped),
            _ => Err(Fault::new(format!("\"{word}\" is no layout")).expected("expected columns or wrapped")),
        }
    }
}

/// A unit by its name.
///
/// # Errors
/// It is not known; the nearest name is given.
pub fn unit_of(word: &str) -> Result<Unit, Fault> {
    unit::unit(word).ok_or_else(|| {
        let near = unit::nearest_name(word).map_or(String::new(), |n| format!("; did you mean {n}?"));
        Fault::new(format!("\"{word}\" is no unit{near}")).expected("expected a unit such as g, m/s2, in/s2, kN, mm")
    })
}

/// A quantity by its name.
///
/// # Errors
/// It is none.
pub fn quantity_of(word: &str) -> Result<Quantity, Fault> {
    Quantity::named(word).ok_or_else(|| {
        Fault::new(format!("\"{word}\" is no quantity")).expected("expected acceleration, velocity, displacement, ...")
    })
}

/// Unit and quantity that the user says, understood.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statement {
    /// Unit.
    pub unit: Option<Unit>,
    /// Quantity; that of the unit where none is said.
    pub quantity: Option<Quantity>,
}

impl Statement {
    /// The statement of a unit and a quantity.
    ///
    /// # Errors
    /// The unit is one of another quantity.
    pub fn new(unit: Option<Unit>, quantity: Option<Quantity>) -> Result<Self, Fault> {
        match (unit, quantity) {
            (Some(u), Some(q)) if u.quantity != q => {
                Err(Fault::new(format!("{} is the unit of {}, and {} is told", u.name, u.quantity, q.word())))
            }
            _ => Ok(Self { unit, quantity: quantity.or(unit.map(|u| u.quantity)) }),
        }
    }

    /// The statement in words of the user.
    ///
    /// # Errors
    /// A word is not known, or the unit is one of another quantity.
    pub fn of(told: &UserStatements) -> Result<Self, Fault> {
        let unit = told.unit.as_deref().map(unit_of).transpose()?;
        Self::new(unit, told.quantity.as_deref().map(quantity_of).transpose()?)
    }

    /// Returns true if it holds for a channel of which the file gives this quantity and this unit; false if the channel
    /// is of another quantity.
    ///
    /// # Errors
    /// The file gives another unit of the same quantity.
    pub fn holds(&self, channel: &str, quantity: Option<Quantity>, unit: Option<Unit>) -> Result<bool, Fault> {
        if self.quantity.zip(quantity).is_some_and(|(said, own)| said != own) {
            return Ok(false);
        }
        match self.unit.zip(unit) {
            Some((said, own)) if (own.factor, own.offset) != (said.factor, said.offset) => {
                let channel = if channel.is_empty() { "the channel" } else { channel };
                let message = format!("the file says {} for {channel}, and is told to be in {}", own.name, said.name);
                Err(Fault::new(message))
            }
            _ => Ok(true),
        }
    }

    /// The fault of a file without a channel for which it holds.
    pub fn other_quantity(&self, own: Quantity) -> Fault {
        let said = self.quantity.map_or("", Quantity::word);
        let told = match self.unit {
            Some(u) => format!("and {} is {}", u.name, u.quantity),
            None => format!("and is told to be {said}"),
        };
        Fault::new(format!("the file says {}, {told}", own.word()))
    }

    /// Give channels the unit and the quantity that the file does not give them. Channels of another quantity stay.
    ///
    /// # Errors
    /// It contradicts the file, or holds for no channel.
    pub fn complete(&self, all: &mut [Series]) -> Result<(), Fault> {
        self.complete_each(
            all,
            |s| (&s.name, s.quantity, s.unit),
            |s| {
                s.quantity = s.quantity.or(self.quantity);
                if let Some(unit) = self.unit.filter(|_| s.unit.is_none()) {
                    s.set_unit(unit);
                }
            },
        )
    }

    /// As [`Statement::complete`], for channels whose name, quantity and unit `known` gives.
    pub(crate) fn complete_each<T>(
        &self,
        all: &mut [T],
        known: impl Fn(&T) -> (&str, Option<Quantity>, Option<Unit>),
        complete: impl Fn(&mut T),
    ) -> Result<(), Fault> {
        let (mut of_other, mut holds) = (None, false);
        for channel in all {
            let (name, quantity, unit) = known(channel);
            if self.holds(name, quantity, unit)? {
                holds = true;
                complete(channel);
            } else {
                of_other = of_other.or(quantity);
            }
        }
        of_other.filter(|_| !holds).map_or(Ok(()), |own| Err(self.other_quantity(own)))
    }
}

#[cfg(test)]
mod tests {
    use super::{Key, Statement, UserStatements, Way};
    use crate::series::Series;
    use crate::unit::{Quantity, unit};

    fn told(unit: Option<&str>, quantity: Option<&str>) -> UserStatements {
        UserStatements {
            unit: unit.map(str::to_owned),
            quantity: quantity.map(str::to_owned),
            ..UserStatements::default()
        }
    }

    fn channels() -> Vec<Series> {
        let with = |name: &str, quantity| Series { name: name.into(), quantity, ..Series::new(vec![1.0]) };
        let mut all = vec![with("a", Some(Quantity::Length)), with("b", Some(Quantity::Force)), with("c", None)];
        all[0].set_unit(unit("mm").expect("mm"));
        all
    }

    #[test]
    fn a_statement_completes_the_channels_of_its_quantity_alone() {
        let of = |u: Option<&str>, q: Option<&str>| {
            let mut all = channels();
            let said = Statement::of(&told(u, q)).and_then(|s| s.complete(&mut all));
            said.map(|()| all.iter().map(|s| s.unit.map_or("", |u| u.name)).collect::<Vec<_>>().join(" "))
                .map_err(|e| e.to_string())
        };
        assert_eq!(of(Some("kN"), None), Ok("mm kN kN".into()));
        assert_eq!(of(Some("mm"), None), Ok("mm  mm".into()));
        assert_eq!(of(None, Some("force")), Ok("mm  ".into()));
        assert_eq!(of(Some("cm"), None), Err("the file says mm for a, and is told to be in cm".into()));
        assert!(of(Some("kN"), Some("velocity")).is_err_and(|e| e.contains("unit of a force")));
        assert!(of(Some("gg"), None).is_err_and(|e| e.contains("did you mean g?")));
        let mut one = channels()[..1].to_vec();
        let fault = Statement::of(&told(Some("g"), None)).and_then(|s| s.complete(&mut one)).expect_err("a fault");
        assert_eq!(fault.message, "the file says displacement, and g is an acceleration");
    }

    #[test]
    fn each_place_has_its_spelling() {
        let spelled = [Way::CommandLine, Way::Study, Way::Script, Way::Python].map(|w| w.spelled(Key::Step));
        assert_eq!(spelled, ["--dt", "dt = ...", "-dt", "dt="]);
    }
}
