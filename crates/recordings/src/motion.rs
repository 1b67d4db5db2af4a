//! Channels of one quantity in SI units: of what the file says, or the user.

use crate::content::Told;
use crate::convert::derivative;
use crate::fault::Fault;
use crate::interpret::uneven_fault;
use crate::measured::Measured;
use crate::series::{Clock, Series};
use crate::unit::{self, Quantity, Unit};

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

/// The unit and quantity that the user says.
fn said(told: &Told, wanted: Quantity) -> Result<(Option<Unit>, Option<Quantity>), Fault> {
    let quantity = match &told.quantity {
        None => None,
        Some(word) => Some(Quantity::named(word).ok_or_else(|| {
            Fault::new(format!("\"{word}\" is no quantity"))
                .expected("expected acceleration, velocity, displacement, ...")
        })?),
    };
    let unit = match &told.unit {
        None => None,
        Some(word) => {
            let of = quantity.unwrap_or(wanted);
            let unit = unit::unit(word).filter(|u| u.quantity == of || (quantity.is_none() && is_motion(u.quantity)));
            Some(unit.ok_or_else(|| {
                let near = unit::nearest_name(word).map_or(String::new(), |n| format!("; did you mean {n}?"));
                Fault::new(format!("\"{word}\" is no unit of {}{near}", of.words()))
            })?)
        }
    };
    Ok((unit, quantity))
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
    pub fn accelerations(&self, told: &Told, differentiate: bool) -> Result<Channels, Fault> {
        let (unit, quantity) = said(told, Quantity::Acceleration)?;
        let all = self.series(told)?;
        let mut out = Channels::default();
        let mut chosen = choose(self, all, unit, quantity, differentiate)?;
        out.notes.append(&mut chosen.notes);
        let own = chosen.series.iter().filter_map(|(s, _)| Some((s, s.unit?)));
        if let Some(fault) = own.filter_map(|(s, own)| Fault::of_told_unit(own, unit?, &s.name)).next() {
            return Err(fault);
        }
        for (s, u) in chosen.series {
            let dt = match &s.clock {
                Clock::Steps { dt, .. } => *dt,
                Clock::Times(times) if times.len() > 1 => return Err(uneven_fault(self, times)),
                Clock::Times(_) => return Err(Fault::new("there are fewer than two rows")),
                Clock::Unknown => {
                    let message = format!("the file gives no step of time: add --dt; {}", self.shown_header());
                    return Err(Fault::new(message));
                }
            };
            let u = u.ok_or_else(|| self.no_unit(&s))?;
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

    fn no_unit(&self, s: &Series) -> Fault {
        let what = s.quantity.map_or("accelerations".to_owned(), Quantity::words);
        let examples = "(g, m/s2, cm/s2, in/s2)";
        if s.unit_name.is_empty() {
            return Fault::new(format!(
                "the file gives no unit of its {what}: add --unit {examples}; {}",
                self.shown_header()
            ));
        }
        Fault::new(format!(
            "the unit \"{}\" of the {what} is not known: add --unit {examples}; {}",
            s.unit_name,
            self.shown_header()
        ))
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

/// Channels with the unit that holds for them.
struct Chosen {
    series: Vec<(Series, Option<Unit>)>,
    notes: Vec<String>,
}

fn choose(
    m: &Measured,
    all: Vec<Series>,
    unit: Option<Unit>,
    quantity: Option<Quantity>,
    differentiate: bool,
) -> Result<Chosen, Fault> {
    let told_quantity = quantity.or(unit.map(|u| u.quantity));
    let of = |s: &Series| s.quantity;
    let is_acceleration = |s: &Series| of(s) == Some(Quantity::Acceleration);
    let mut notes = vec![];
    let names = |of: &[&Series]| {
        of.iter().map(|s| if s.name.is_empty() { "one" } else { &s.name }).collect::<Vec<_>>().join(", ")
    };
    let with_known_unit: Vec<bool> = all.iter().map(|s| is_acceleration(s) && s.unit.is_some()).collect();
    let accelerations: Vec<bool> =
        if with_known_unit.contains(&true) { with_known_unit } else { all.iter().map(is_acceleration).collect() };
    if accelerations.contains(&true) {
        if let Some(q) = told_quantity.filter(|q| *q != Quantity::Acceleration) {
            return Err(Fault::new(format!("the file says acceleration, and is told to be {}", q.word())));
        }
        let left: Vec<&Series> = all.iter().zip(&accelerations).filter(|(_, is)| !**is).map(|(s, _)| s).collect();
        if !left.is_empty() && m.sheet().is_some() {
            notes.push(format!("{} channels are no accelerations with a unit: {}", left.len(), names(&left)));
        }
        let series = all.into_iter().zip(accelerations).filter(|(_, is)| *is).map(|(s, _)| {
            let u = s.unit.or(unit);
            (s, u)
        });
        return Ok(Chosen { series: series.collect(), notes });
    }
    let open: Vec<bool> = all.iter().map(|s| of(s).is_none()).collect();
    if open.contains(&true) {
        let says = quantity_of_text(m);
        let wanted = told_quantity.unwrap_or(Quantity::Acceleration);
        if let Some(q) = says.filter(|q| *q != wanted && quantity.is_none()) {
            let message = format!("the header or the name of the file says {}; {}", q.word(), m.shown_header());
            return Err(Fault::new(message).help("say what it holds: --quantity, with --unit"));
        }
        if is_motion(wanted) && wanted != Quantity::Acceleration && !differentiate {
            return Err(not_accelerations(wanted, None));
        }
        let series = all.into_iter().zip(open).filter(|(_, is)| *is).map(|(s, _)| (s, unit));
        return Ok(Chosen { series: series.collect(), notes });
    }
    // Velocities before displacements: they are differentiated once.
    for q in [Quantity::Velocity, Quantity::Length] {
        let some: Vec<Series> = all.iter().filter(|s| of(s) == Some(q)).cloned().collect();
        let Some(first) = some.first() else { continue };
        if told_quantity.is_some_and(|t| t != q) {
            return Err(Fault::new(format!(
                "the file says {}, and is told to be {}; {}",
                q.word(),
                told_quantity.map_or("", Quantity::word),
                m.shown_header()
            )));
        }
        if !differentiate {
            return Err(not_accelerations(q, first.unit));
        }
        return Ok(Chosen { series: some.into_iter().map(|s| (s.clone(), s.unit.or(unit))).collect(), notes });
    }
    Err(Fault::new(format!("there is no channel of accelerations; {}", m.shown_header())))
}

fn not_accelerations(q: Quantity, unit: Option<Unit>) -> Fault {
    let unit = unit.map_or(String::new(), |u| format!(" in {}", u.name));
    Fault::new(format!("the file holds {}{unit}, and a motion needs accelerations", q.words()))
        .help("take the file of the accelerations, or differentiate with --differentiate")
}
