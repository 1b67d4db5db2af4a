//! The channels of a table: which column is the time, what the others are.

use crate::content::Content;
use crate::fault::Fault;
use crate::measured::Measured;
use crate::series::{Clock, Origin, Series, uneven};
use crate::sheet::{Column, Sheet, head};
use crate::stated::Stated;
use crate::unit::{self, Quantity, Unit};
use crate::user_statements::{Key, Layout, Statement, UserStatements, Way};

impl Measured {
    /// The channels, with what the file and the user say about them.
    ///
    /// # Errors
    /// The times are none, or do not increase, or rows of numbers may be one channel or several.
    pub fn series(&self, told: &UserStatements) -> Result<Vec<Series>, Fault> {
        match &self.content {
            Content::Series { series, .. } => {
                let with_step = |s: &Series| {
                    let clock = stated_clock(s.clock.clone(), told, &|i| format!("sample {}", i + 1))?;
                    Ok(Series { clock, ..s.clone() })
                };
                series.iter().map(with_step).collect()
            }
            Content::Table(sheet) => of_sheet(self, sheet, told),
        }
    }

    /// The channels; those without a unit or a quantity have what the user says.
    ///
    /// # Errors
    /// As [`Measured::series`]; and what the user says has no meaning or contradicts the file.
    pub fn stated_series(&self, told: &UserStatements) -> Result<Vec<Series>, Fault> {
        let mut all = self.series(told)?;
        Statement::of(told)?.complete(&mut all)?;
        Ok(all)
    }
}

fn of_sheet(m: &Measured, sheet: &Sheet, told: &UserStatements) -> Result<Vec<Series>, Fault> {
    let time = TimeColumn::find(sheet);
    let stated = Stated::of(&sheet.header);
    let clock = match &time {
        Some(t) => t.clock(sheet, told)?,
        None => stated.dt.map_or(Clock::Unknown, |dt| Clock::Steps { start: 0.0, dt }),
    };
    let clock = stated_clock(clock, told, &|i| sheet.row_name(i))?;
    let is_time = |i: usize| time.as_ref().is_some_and(|t| t.columns.contains(&i));
    let lines = sheet.lines.first().map_or(0, |l| *l as usize)..sheet.lines.last().map_or(0, |l| *l as usize + 1);
    let origin = |column| Origin { file: m.file.clone(), lines: lines.clone(), bytes: 0..m.size, column };
    if time.is_none() && !sheet.named && sheet.columns.len() > 1 {
        match told.layout.map_or_else(|| side_by_side(sheet, told.way), Ok)? {
            Layout::Columns => {}
            Layout::Wrapped => {
                let values = (0..sheet.rows()).flat_map(|i| sheet.columns.iter().map(move |c| c.values[i])).collect();
                let mut series = Series { clock, origin: origin(None), ..Series::new(values) };
                stated.unit.into_iter().for_each(|u| series.set_unit(u));
                return Ok(vec![series]);
            }
        }
    }
    let channel = |(i, c): (usize, &Column)| {
        let (name, unit, unit_name) = meaning(c);
        let quantity = unit.map(|u| u.quantity).or_else(|| Quantity::of_head(&name));
        // A unit above the table is that of the columns without one of their own.
        let of_all = stated.unit.filter(|u| unit_name.is_empty() && quantity.is_none_or(|q| q == u.quantity));
        let (unit, quantity) = (unit.or(of_all), quantity.or(of_all.map(|u| u.quantity)));
        let unit_name = of_all.map_or(unit_name, |u| u.name.to_owned());
        let direction = name.clone();
        let clock = clock.clone();
        Series {
            name,
            direction,
            unit,
            unit_name,
            quantity,
            clock,
            origin: origin(Some(i + 1)),
            ..Series::new(c.values.clone())
        }
    };
    Ok(sheet.columns.iter().enumerate().filter(|(i, _)| !is_time(*i)).map(channel).collect())
}

/// Name, unit and unit as written of a column.
pub(crate) fn meaning(c: &Column) -> (String, Option<Unit>, String) {
    let (name, unit) = head::known_unit(&c.cell);
    let written = head::name_and_unit(&c.cell).1;
    if unit.is_some() || c.unit.is_empty() {
        let unit_name = if written.is_empty() { unit.map_or("", |u| u.name).to_owned() } else { written };
        return (name, unit, unit_name);
    }
    (name, unit::header_unit(&c.unit), c.unit.clone())
}

/// The numbers in the rows of a table without names are one channel, or several channels side by side.
///
/// One channel varies less in the order of reading than down the columns, since samples are near those before them.
fn side_by_side(sheet: &Sheet, way: Way) -> Result<Layout, Fault> {
    let n = sheet.columns.len();
    let at = |k: usize| sheet.columns[k % n].values[k / n];
    let total = n * sheet.rows();
    if sheet.rows() < 2 {
        return Ok(Layout::Wrapped);
    }
    let variation =
        |apart: usize| (apart..total).map(|k| (at(k) - at(k - apart)).abs()).filter(|x| x.is_finite()).sum::<f64>();
    if variation(1) <= variation(n) {
        return Ok(Layout::Wrapped);
    }
    let message = format!("the rows of {n} numbers have no names and look like {n} channels side by side");
    let key = way.spelled(Key::Layout);
    Err(Fault::new(message).help(format!("add {key}: columns, or wrapped for one channel in the order of reading")))
}

/// The column of the time, or those of the date and of the time of day.
struct TimeColumn {
    columns: Vec<usize>,
    unit: Option<Unit>,
}

impl TimeColumn {
    fn find(sheet: &Sheet) -> Option<Self> {
        let clocks: Vec<usize> = (0..sheet.columns.len()).filter(|i| sheet.columns[*i].is_clock).collect();
        if !clocks.is_empty() {
            return Some(Self { columns: clocks, unit: None });
        }
        let all = || sheet.columns.iter().enumerate();
        // A column that is named time before one such as `Cycle Elapsed Time (s)`.
        let exact = all().find(|(_, c)| head::time_head(&c.cell).is_some() && time_unit_of(c).is_some());
        let named = exact.and_then(|(i, c)| Some((i, time_unit_of(c)?)));
        let named = named.or_else(|| all().find_map(|(i, c)| Some((i, time_unit_of(c)?))));
        if let Some((i, unit)) = named {
            return Some(Self { columns: vec![i], unit: Some(unit) });
        }
        let increasing = |v: &[f64]| v.len() > 1 && v.windows(2).all(|w| w[1] > w[0]);
        let first = sheet.columns.first().filter(|_| !sheet.named && sheet.columns.len() > 1)?;
        // Of two columns without names the first is the time; of more, if its steps are equal.
        let is_time = increasing(&first.values) && (sheet.columns.len() == 2 || uneven(&first.values).is_none());
        is_time.then(|| Self { columns: vec![0], unit: head::time_unit("") })
    }

    /// Times in s.
    fn times(&self, sheet: &Sheet) -> Vec<f64> {
        let seconds = |i: usize, k: usize| {
            let x = sheet.columns[i].values[k];
            self.unit.as_ref().map_or(x, |u| head::seconds(x, u))
        };
        (0..sheet.rows()).map(|k| self.columns.iter().map(|i| seconds(*i, k)).sum()).collect()
    }

    fn clock(&self, sheet: &Sheet, told: &UserStatements) -> Result<Clock, Fault> {
        let times = self.times(sheet);
        if let Some(i) = times.iter().position(|t| !t.is_finite()) {
            return Err(Fault::new(format!("{} has no time", sheet.row_name(i))));
        }
        if times.len() < 2 {
            return Ok(Clock::Times(times.into()));
        }
        // Rounded times may repeat: a step that the user says explains them.
        let increasing = times.windows(2).all(|w| w[1] > w[0]);
        if let Some(dt) = told.dt.filter(|_| !increasing) {
            return agreeing(&times, dt, &|i| sheet.row_name(i));
        }
        if let Some(i) = times.windows(2).position(|w| w[1] <= w[0]) {
            let (a, b) = (times[i], times[i + 1]);
            let message = match b == a {
                true => format!("{} repeats the time {b} s of the row before", sheet.row_name(i + 1)),
                false => format!("the time goes back from {a} s to {b} s in {}", sheet.row_name(i + 1)),
            };
            let key = told.way.spelled(Key::Step);
            return Err(Fault::new(message).help(format!("if the times are rounded or out of order, add {key}")));
        }
        Ok(Clock::of_times(times))
    }
}

impl Measured {
    /// The fault of a file without a step of time.
    pub fn no_step(&self, way: Way) -> Fault {
        let add = format!("add {}", way.spelled(Key::Step));
        Fault::new("the file gives no step of time").expected(add).help(self.shown_header())
    }
}

/// The unit of a column of times.
pub(crate) fn time_unit_of(c: &Column) -> Option<Unit> {
    head::time_column(&c.cell, &c.unit)
}

/// Largest share by which a step that the user says may differ from that of the file.
const TOLD_TOLERANCE: f64 = 1e-3;

/// The clock of the file, or of the step that the user says where the file gives none. One that contradicts is an error.
pub(crate) fn stated_clock(clock: Clock, told: &UserStatements, row: &dyn Fn(usize) -> String) -> Result<Clock, Fault> {
    let Some(said) = told.dt else { return Ok(clock) };
    match clock {
        Clock::Unknown => Ok(Clock::Steps { start: 0.0, dt: said }),
        Clock::Steps { dt, .. } if (said / dt - 1.0).abs() > TOLD_TOLERANCE => {
            let message = format!("the file gives the step {dt} s, and is told {said} s");
            Err(Fault::new(message).expected("expected the step of the file, or none: hysteron recording FILE --dt STEP --out FILE.csv gives a step to a file without one"))
        }
        Clock::Times(times) if times.len() > 1 => agreeing(&times, said, row),
        of_file => Ok(of_file),
    }
}

/// Times that are rounded, or start later, fit a step that the user says.
fn agreeing(times: &[f64], dt: f64, row: &dyn Fn(usize) -> String) -> Result<Clock, Fault> {
    let rounding = times.windows(2).map(|w| w[1] - w[0]).filter(|d| *d > 0.0).fold(f64::INFINITY, f64::min);
    let allowed = 0.51 * rounding.max(dt);
    let error = |(i, t): (usize, &f64)| (t - times[0] - i as f64 * dt).abs() > allowed;
    match times.iter().enumerate().position(error) {
        Some(i) => {
            let at = row(i);
            let message = format!(
                "the step {dt} s gives {at} the time {} s, the file says {} s",
                times[0] + i as f64 * dt,
                times[i]
            );
            Err(Fault::new(message).expected("expected the step of the file"))
        }
        None => Ok(Clock::Steps { start: times[0], dt }),
    }
}

/// The fault of times that are not at equal steps: the row that differs most from the usual step.
pub(crate) fn uneven_fault(m: &Measured, times: &[f64]) -> Fault {
    let mut steps: Vec<f64> = times.windows(2).map(|w| w[1] - w[0]).collect();
    let of_row = steps.clone();
    steps.sort_by(f64::total_cmp);
    let usual = steps[steps.len() / 2];
    let farthest = (0..of_row.len()).max_by(|a, b| (of_row[*a] - usual).abs().total_cmp(&(of_row[*b] - usual).abs()));
    let i = farthest.unwrap_or(0);
    let row = m.sheet().map_or_else(|| format!("sample {}", i + 2), |s| s.row_name(i + 1));
    let shown = |x: f64| format!("{x:.6}").trim_end_matches('0').trim_end_matches('.').to_owned();
    Fault::new(format!(
        "the times of the first column are not at equal steps: {row} follows after {} s, the step is {} s",
        shown(of_row[i]),
        shown(usual)
    ))
}
