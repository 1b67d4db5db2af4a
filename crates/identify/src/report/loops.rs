//! Reports of hysteresis loops: a table of the measures of each cycle, and charts.

use super::table::{Cell, Table};
use crate::measure::{Cycle, CycleDetection, Loop, Sides, Specimen, orbits, work};
use hysteron_opensees::chart::{Curve, Figure, Mark};

/// Names of units for headings; empty for none.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Units {
    /// Unit of force.
    pub force: String,
    /// Unit of length.
    pub length: String,
}

impl Units {
    fn stiffness(&self) -> String {
        self.joined("/")
    }
    fn energy(&self) -> String {
        self.joined(" ")
    }
    fn joined(&self, by: &str) -> String {
        if self.force.is_empty() { String::new() } else { format!("{}{by}{}", self.force, self.length) }
    }
    fn axis(what: &str, unit: &str) -> String {
        if unit.is_empty() { what.to_owned() } else { format!("{what} [{unit}]") }
    }
}

/// A record of one direction of motion.
#[derive(Clone, Copy, Debug)]
pub struct Record<'a> {
    /// Times; `None` if only the order of the samples is known.
    pub time: Option<&'a [f64]>,
    /// Displacements.
    pub u: &'a [f64],
    /// Forces.
    pub f: &'a [f64],
}

impl Record<'_> {
    /// Time of a sample, or its index without times.
    fn at(&self, sample: usize) -> f64 {
        self.time.and_then(|t| t.get(sample)).copied().unwrap_or(sample as f64)
    }

    fn points(&self) -> Vec<(f64, f64)> {
        self.u.iter().copied().zip(self.f.iter().copied()).collect()
    }
}

/// Remark on a cycle that is incomplete or one-sided.
fn remark(c: &Cycle) -> Cell {
    Cell::Word(match (c.complete, c.sides) {
        (false, _) => "incomplete",
        (true, Sides::Both) => "",
        (true, Sides::Above) => "above",
        (true, Sides::Below) => "below",
    })
}

/// Measures of each cycle of a record: amplitude, extreme forces, secant stiffness K, dissipated energy E and equivalent
/// damping ξ. `E_total` is the work of the force from the beginning to the end of the cycle. A specimen adds shear strain
/// γ, modulus G_eq, loss D and damping h_eq.
pub fn cycle_table(r: &Record<'_>, detection: &CycleDetection, specimen: Option<&Specimen>, units: &Units) -> Table {
    let (stiffness, energy) = (units.stiffness(), units.energy());
    let time = if r.time.is_some() { "" } else { "sample" };
    let mut table = Table::new([
        ("cycle", ""),
        ("begin", time),
        ("end", time),
        ("amplitude", &units.length),
        ("F_max", &units.force),
        ("F_min", &units.force),
        ("K", &stiffness),
        ("E", &energy),
        ("xi", ""),
        ("E_total", &energy),
        ("part", ""),
    ]);
    if specimen.is_some() {
        table.columns.extend(Table::new([("gamma", ""), ("G_eq", ""), ("D", ""), ("h_eq", "")]).columns);
    }
    let total = work(r.u, r.f);
    for (i, c) in detection.cycles(r.u).iter().enumerate() {
        let l = Loop::of(&r.u[c.samples.clone()], &r.f[c.samples.clone()]);
        let last = c.samples.end - 1;
        let mut row: Vec<Cell> =
            [(i + 1) as f64, r.at(c.samples.start), r.at(last), l.amplitude(), l.f_max, l.f_min, l.stiffness()]
                .into_iter()
                .chain([l.energy, l.damping(), total[last]])
                .map(Cell::from)
                .collect();
        row.push(remark(c));
        if let Some(s) = specimen.map(|s| s.shear(&l)) {
            row.extend([s.strain, s.modulus, s.loss, s.damping].map(Cell::from));
        }
        table.rows.push(row);
    }
    table
}

/// Measures of each round of an orbit in two directions.
pub fn orbit_table(directions: &[Record<'_>; 2], detection: [&CycleDetection; 2], units: &Units) -> Table {
    let (stiffness, energy) = (units.stiffness(), units.energy());
    let time = if directions[0].time.is_some() { "" } else { "sample" };
    let mut table = Table::new([
        ("round", ""),
        ("begin", time),
        ("end", time),
        ("radius", &units.length),
        ("F", &units.force),
        ("u_x", &units.length),
        ("u_y", &units.length),
        ("K_x", &stiffness),
        ("K_y", &stiffness),
        ("E", &energy),
        ("xi", ""),
        ("part", ""),
    ]);
    let rounds = orbits(directions.map(|r| r.u), directions.map(|r| r.f), detection);
    for (i, o) in rounds.iter().enumerate() {
        let [x, y] = &o.directions;
        let span = [o.cycle.samples.start, o.cycle.samples.end - 1].map(|s| directions[0].at(s));
        let mut row: Vec<Cell> = [(i + 1) as f64, span[0], span[1], o.radius, o.force, x.amplitude(), y.amplitude()]
            .into_iter()
            .chain([x.stiffness(), y.stiffness(), o.energy(), o.damping()])
            .map(Cell::from)
            .collect();
        row.push(remark(&o.cycle));
        table.rows.push(row);
    }
    table
}

fn chart(title: &str, x: (&str, &str), y: (&str, &str), points: Vec<(f64, f64)>, mark: Mark) -> Figure {
    Figure {
        title: title.to_owned(),
        x_label: Units::axis(x.0, x.1),
        y_label: Units::axis(y.0, y.1),
        curves: vec![Curve { name: String::new(), points, mark }],
        ..Figure::default()
    }
}

/// Charts of the loops, and of energy, stiffness and damping over the amplitude of complete cycles (Fig 8 of the paper).
pub fn cycle_charts(r: &Record<'_>, detection: &CycleDetection, units: &Units) -> Vec<Figure> {
    let displacement = ("Displacement u", units.length.as_str());
    let amplitude = ("Amplitude of u", units.length.as_str());
    let loops: Vec<Loop> = detection
        .cycles(r.u)
        .iter()
        .filter(|c| c.complete)
        .map(|c| Loop::of(&r.u[c.samples.clone()], &r.f[c.samples.clone()]))
        .collect();
    let over = |of: &dyn Fn(&Loop) -> f64| loops.iter().map(|l| (l.amplitude(), of(l))).collect::<Vec<_>>();
    let (stiffness, energy) = (units.stiffness(), units.energy());
    let mut charts = vec![chart("Loops", displacement, ("Force F", &units.force), r.points(), Mark::Line)];
    if !loops.is_empty() {
        charts.extend([
            chart("Dissipated energy", amplitude, ("E per cycle", &energy), over(&|l| l.energy), Mark::Dots),
            chart("Secant stiffness", amplitude, ("K", &stiffness), over(&Loop::stiffness), Mark::Dots),
            chart("Equivalent damping", amplitude, ("ξ", "%"), over(&|l| 100.0 * l.damping()), Mark::Dots),
        ]);
    }
    charts
}

/// Charts of the orbits of displacement and force, and of the loops of both directions.
pub fn orbit_charts(directions: &[Record<'_>; 2], units: &Units) -> Vec<Figure> {
    let [x, y] = directions;
    let pairs = |a: &[f64], b: &[f64]| a.iter().copied().zip(b.iter().copied()).collect::<Vec<_>>();
    let (length, force) = (units.length.as_str(), units.force.as_str());
    let plan = chart("Orbit", ("u_x", length), ("u_y", length), pairs(x.u, y.u), Mark::Line);
    let forces = chart("Orbit of the force", ("F_x", force), ("F_y", force), pairs(x.f, y.f), Mark::Line);
    vec![
        Figure { equal: true, ..plan },
        Figure { equal: true, ..forces },
        chart("Loops in x", ("u_x", length), ("F_x", force), x.points(), Mark::Line),
        chart("Loops in y", ("u_y", length), ("F_y", force), y.points(), Mark::Line),
    ]
}
