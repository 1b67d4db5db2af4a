//! Channels of one quantity in SI units: of what the file says, or the user.

use crate::convert::derivative;
use crate::fault::Fault;
use crate::interpret::uneven_fault;
use crate::measured::Measured;
use crate::series::{Clock, Series};
use crate::unit::{Quantity, Unit};
use crate::user_statements::{Key, Statement, UserStatements, Way};

/// A channel at equal steps in the SI unit of its quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// The channel as it was read: name, direction, station, origin.
    pub series: Series,
    /// Unit that the values were in.
    pub unit: Unit,
    /// Step in s.
    pub dt: f64,
    /// Values in SI units.
    pub values: Vec<f64>,
}

/// Channels of one quantity, and what was done to get them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Channels {
    /// The channels.
    pub channels: Vec<Channel>,
    /// Remarks: samples left out or converted.
    pub notes: Vec<String>,
}

fn is_motion(q: Quantity) -> bool {
    matches!(q, Quantity::Acceleration | Quantity::Velocity | Quantity::Length)
}

/// The quantity that the text of the header or the extension of the name says, where no column does.
fn quantity_of_text(m: &Measured) -> Option<Quantity> {
    let kinds = [("accel", Quantity::Acceleration), ("veloc", Quantity::Velocity), ("displ", Quantity::Length)];
    let text = m.header.join("\n").to_ascii_lowercase();
    let mut found = kinds.iter().filter(|(w, _)| text.contains(w)).map(|(_, q)| *q);
    let (first, second) = (found.next(), found.next());
    let extension = m.file.rsplit_once('.').map(|(_, e)| e.to_ascii_lowercase()).unwrap_or_default();
    let by_name = match extension.as_str() {
        "vt2" | "vel" => Some(Quantity::Velocity),
        "dt2" | "dis" | "disp" => Some(Quantity::Length),
        _ => None,
    };
    by_name.or(if second.is_none() { first } else { None })
}

impl Measured {
    /// The accelerations of the file in m/s². Channels of other quantities are left out. If there are velocities or
    /// displacements alone, they are differentiated if `differentiate` is true.
    ///
    /// # Errors
    /// A unit, a step or a quantity that neither the file nor the user says, or that they contradict each other about;
    /// a sample or a time that is missing.
    pub fn accelerations(&self, told: &UserStatements, differentiate: bool) -> Result<Channels, Fault> {
        let said = Statement::of(told)?;
        if let Some(u) = said.unit.filter(|u| !is_motion(u.quantity)) {
            return Err(Fault::new(format!("{} is {}, and a motion needs accelerations", u.name, u.quantity)));
        }
        let mut chosen = choose(self, self.series(told)?, told, said, differentiate)?;
        said.complete(&mut chosen.series)?;
        let mut out = Channels { notes: chosen.notes, ..Channels::default() };
        for s in chosen.series {
            let dt = match &s.clock {
                Clock::Steps { dt, .. } => *dt,
                Clock::Times(times) if times.len() > 1 => return Err(uneven_fault(self, times)),
                Clock::Times(_) => return Err(Fault::new("there are fewer than two rows")),
                Clock::Unknown => return Err(self.no_step(told.way)),
            };
            let u = s.unit.ok_or_else(|| {
                let of = Series { quantity: s.quantity.or(Some(Quantity::Acceleration)), ..s.clone() };
                let fault = of.no_unit("", told.way);
                let examples = format!("{} (g, m/s2, cm/s2, in/s2)", fault.expected);
                fault.expected(examples).help(self.shown_header())
            })?;
            self.check_samples(&s)?;
            let mut values: Vec<f64> = s.values.iter().map(|x| u.factor * x).collect();
            let times = match u.quantity {
                Quantity::Velocity => 1,
                Quantity::Length => 2,
                _ => 0,
            };
            for _ in 0..times {
                values = derivative(&values, dt);
            }
            if times > 0 {
                let what = if times == 1 { "differentiated once" } else { "differentiated twice" };
                out.notes.push(format!(
                    "{} in {} {what} by central differences, without correction of the baseline",
                    u.quantity.word(),
                    u.name
                ));
            }
            out.channels.push(Channel { unit: u, dt, values, series: s });
        }
        Ok(out)
    }

    /// All samples are there.
    fn check_samples(&self, s: &Series) -> Result<(), Fault> {
        let name = if s.name.is_empty() { &self.file } else { &s.name };
        match s.values.iter().position(|x| !x.is_finite()) {
            Some(i) => {
                let row = self.sheet().map_or_else(|| format!("value {}", i + 1), |t| t.row_name(i));
                let what = if s.values[i].is_nan() { "is missing or not finite" } else { "is not finite" };
                Err(Fault::new(format!("{row} of {name} {what}")))
            }
            None if s.values.len() < 2 => Err(Fault::new(format!("{name} has fewer than two values"))),
            None => Ok(()),
        }
    }
}

/// Channels that are taken, and what is said of the others.
struct Chosen {
    series: Vec<Series>,
    notes: Vec<String>,
}

fn choose(
    m: &Measured,
    all: Vec<Series>,
    told: &UserStatements,
    said: Statement,
    differentiate: bool,
) -> Result<Chosen, Fault> {
    let of = |s: &Series| s.quantity;
    let is_acceleration = |s: &Series| of(s) == Some(Quantity::Acceleration);
    let mut notes = vec![];
    let names = |of: &[&Series]| {
        of.iter().map(|s| if s.name.is_empty() { "one" } else { &s.name }).collect::<Vec<_>>().join(", ")
    };
    let with_known_unit: Vec<bool> = all.iter().map(|s| is_acceleration(s) && s.unit.is_some()).collect();
    let accelerations: Vec<bool> =
        if with_known_unit.contains(&true) { with_known_unit } else { all.iter().map(is_acceleration).collect() };
    let take = |all: Vec<Series>, which: &[bool]| {
        all.into_iter().zip(which).filter(|(_, taken)| **taken).map(|(s, _)| s).collect::<Vec<_>>()
    };
    if accelerations.contains(&true) {
        if said.quantity.is_some_and(|q| q != Quantity::Acceleration) {
            return Err(said.other_quantity(Quantity::Acceleration));
        }
        let left: Vec<&Series> = all.iter().zip(&accelerations).filter(|(_, is)| !**is).map(|(s, _)| s).collect();
        if !left.is_empty() && m.sheet().is_some() {
            notes.push(format!("{} channels are no accelerations with a unit: {}", left.len(), names(&left)));
        }
        return Ok(Chosen { series: take(all, &accelerations), notes });
    }
    let open: Vec<bool> = all.iter().map(|s| of(s).is_none()).collect();
    if open.contains(&true) {
        let says = quantity_of_text(m);
        let wanted = said.quantity.unwrap_or(Quantity::Acceleration);
        if let Some(q) = says.filter(|q| *q != wanted && told.quantity.is_none()) {
            let message = format!("the header or the name of the file says {}; {}", q.word(), m.shown_header());
            let [quantity, unit] = [Key::Quantity, Key::Unit].map(|key| told.way.spelled(key));
            return Err(Fault::new(message).help(format!("say what it holds: {quantity}, with {unit}")));
        }
        if wanted != Quantity::Acceleration && !differentiate {
            return Err(not_accelerations(wanted, None, told.way));
        }
        return Ok(Chosen { series: take(all, &open), notes });
    }
    // Velocities before displacements: they are differentiated once.
    for q in [Quantity::Velocity, Quantity::Length] {
        let some: Vec<bool> = all.iter().map(|s| of(s) == Some(q)).collect();
        let Some(first) = some.iter().position(|is| *is) else { continue };
        if said.quantity.is_some_and(|said| said != q) {
            return Err(said.other_quantity(q).help(m.shown_header()));
        }
        if !differentiate {
            return Err(not_accelerations(q, all[first].unit, told.way));
        }
        return Ok(Chosen { series: take(all, &some), notes });
    }
    Err(Fault::new(format!("there is no channel of accelerations; {}", m.shown_header())))
}

fn not_accelerations(q: Quantity, unit: Option<Unit>, way: Way) -> Fault {
    let unit = unit.map_or(String::new(), |u| format!(" in {}", u.name));
    let key = way.spelled(Key::Differentiate);
    Fault::new(format!("the file holds {}{unit}, and a motion needs accelerations", q.words()))
        .help(format!("take the file of the accelerations, or differentiate with {key}"))
}
