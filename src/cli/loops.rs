//! `hysteron loops`: measures of the cycles in any two columns of a file.

use clap::{Args, ValueEnum};
use hysteron::measure::{CycleDetection, Specimen};
use hysteron::opensees::chart::{Figure, sheet};
use hysteron::recordings::Table as Columns;
use hysteron::recordings::unit::{Unit, unit};
use hysteron::report::{Record, Table, Units, cycle_charts, cycle_table, orbit_charts, orbit_table};

/// Columns of the loops, and options of the report.
#[derive(Args, Debug)]
pub(super) struct LoopsArgs {
    /// Files of recorders, CSV with or without names, or any others that `recording` shows
    #[arg(required = true)]
    files: Vec<String>,
    /// Column of the displacement (or strain), by name or number from 1; two for an orbit
    #[arg(long, short = 'u', value_name = "COLUMN", required = true, num_args = 1..=2)]
    displacement: Vec<String>,
    /// Column of the force (or stress); two for an orbit
    #[arg(long, short = 'f', value_name = "COLUMN", required = true, num_args = 1..=2)]
    force: Vec<String>,
    /// Column of the time
    #[arg(long, short = 't', value_name = "COLUMN")]
    time: Option<String>,
    /// Multiply displacements by this
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, allow_negative_numbers = true)]
    displacement_factor: f64,
    /// Multiply forces by this (-1 turns a reaction into the force of the device)
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, allow_negative_numbers = true)]
    force_factor: f64,
    /// Displacement about which the cycles go
    #[arg(long, value_name = "U", default_value_t = 0.0, allow_negative_numbers = true)]
    centre: f64,
    /// Cycles smaller than this part of the largest one are noise
    #[arg(long, value_name = "PART", default_value_t = CycleDetection::default().threshold)]
    threshold: f64,
    /// Draw loops, energy, stiffness and damping of one file into this one
    #[arg(long, value_name = "FILE")]
    svg: Option<String>,
    #[command(flatten)]
    report: ReportArgs,
}

/// Options of a report of loops.
#[derive(Args, Debug)]
pub(super) struct ReportArgs {
    /// Names of the units, for headings (for instance: kN mm); columns of a file with other units are converted
    #[arg(long, num_args = 2, value_names = ["FORCE", "LENGTH"])]
    units: Option<Vec<String>>,
    /// Area of the rubber: with the thickness, shear strain, modulus and loss are told too
    #[arg(long, requires = "thickness")]
    area: Option<f64>,
    /// Thickness of all rubber layers together
    #[arg(long)]
    thickness: Option<f64>,
    /// Form of the table on standard output
    #[arg(long, value_enum, default_value_t = TableFormat::Text)]
    table: TableFormat,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum TableFormat {
    /// Aligned columns
    Text,
    /// Comma-separated values
    Csv,
    /// An array of objects
    Json,
}

impl ReportArgs {
    /// Thickness of the rubber, if it is given.
    pub(super) fn thickness(&self) -> Option<f64> {
        self.thickness
    }

    /// Unit of length, if it is said and known.
    pub(super) fn length_unit(&self) -> Option<Unit> {
        self.units.as_ref().and_then(|words| unit(words.get(1)?))
    }

    /// Unit of force, if it is said and known.
    fn force_unit(&self) -> Option<Unit> {
        self.units.as_ref().and_then(|words| unit(words.first()?))
    }

    fn units(&self) -> Units {
        match self.units.as_deref() {
            Some([force, length]) => Units { force: force.clone(), length: length.clone() },
            _ => Units::default(),
        }
    }

    fn specimen(&self) -> Result<Option<Specimen>, String> {
        let positive = |what: &str, x: f64| {
            if x > 0.0 && x.is_finite() { Ok(x) } else { Err(format!("the {what} is {x}: expected more than 0")) }
        };
        match (self.area, self.thickness) {
            (Some(area), Some(thickness)) => {
                Ok(Some(Specimen { area: positive("area", area)?, thickness: positive("thickness", thickness)? }))
            }
            _ => Ok(None),
        }
    }

    /// The table of measures of one or two directions of motion. Charts go to the file `svg`.
    pub(super) fn measure(
        &self,
        records: &[Record<'_>],
        detection: &CycleDetection,
        svg: Option<&str>,
    ) -> Result<Table, String> {
        let (units, specimen) = (self.units(), self.specimen()?);
        let (table, charts): (Table, Vec<Figure>) = match records {
            [x, y] => {
                let both = [*x, *y];
                (orbit_table(&both, [detection; 2], &units), orbit_charts(&both, &units))
            }
            [one, ..] => (cycle_table(one, detection, specimen.as_ref(), &units), cycle_charts(one, detection, &units)),
            [] => return Err("there is nothing to measure".into()),
        };
        if let Some(file) = svg {
            let svg = sheet(&charts, 2).map_err(|e| e.to_string())?;
            hysteron_files::write(file, svg).map_err(|e| format!("cannot write \"{file}\": {e}"))?;
        }
        Ok(table)
    }

    /// Returns true if the table is for a reader and not for a program.
    pub(super) fn is_text(&self) -> bool {
        matches!(self.table, TableFormat::Text)
    }

    /// A table in the chosen format.
    pub(super) fn format(&self, table: &Table) -> String {
        match self.table {
            TableFormat::Text => table.text(),
            TableFormat::Csv => table.csv(),
            TableFormat::Json => table.json(),
        }
    }
}

/// Run the command; the text of the table. With several files its first column names the file.
pub(super) fn loops(a: &LoopsArgs) -> Result<String, String> {
    if a.displacement.len() != a.force.len() {
        let (u, f) = (a.displacement.len(), a.force.len());
        return Err(format!("there are {u} columns of displacements, but {f} of forces"));
    }
    if let [file] = &a.files[..] {
        return Ok(a.report.format(&measured(a, file)?));
    }
    if a.svg.is_some() {
        return Err(format!("--svg draws the loops of one file, and there are {}", a.files.len()));
    }
    let mut all = Table::new([("file", "")]);
    for file in &a.files {
        let table = measured(a, file)?;
        // The arguments make the columns, so that all files have the same.
        if all.columns.len() == 1 {
            all.columns.extend(table.columns);
        }
        all.rows.extend(table.rows.into_iter().map(|row| [file.clone().into()].into_iter().chain(row).collect()));
    }
    Ok(a.report.format(&all))
}

/// Measures of the cycles of a file.
fn measured(a: &LoopsArgs, file: &str) -> Result<Table, String> {
    let bytes = hysteron_files::read_input(file).map_err(|e| format!("cannot read \"{file}\": {e}"))?;
    let of_file = |e: String| format!("\"{file}\": {e}");
    let columns = Columns::read_beside(file, &bytes, &hysteron_files::read_beside(file)).map_err(of_file)?;
    let column = |which: &String, factor: f64, unit: Option<Unit>| {
        // A factor that is no sign is the conversion itself.
        let values = columns.column_in(which, unit.filter(|_| factor.abs() == 1.0)).map_err(of_file)?;
        Ok::<Vec<f64>, String>(values.iter().map(|x| factor * x).collect())
    };
    let all = |which: &[String], factor: f64, unit: Option<Unit>| {
        which.iter().map(|w| column(w, factor, unit)).collect::<Result<Vec<_>, _>>()
    };
    let u = all(&a.displacement, a.displacement_factor, a.report.length_unit())?;
    let f = all(&a.force, a.force_factor, a.report.force_unit())?;
    let time = a.time.as_ref().map(|t| columns.seconds(t).map_err(of_file)).transpose()?;
    let record = |i: usize| Record { time: time.as_deref(), u: &u[i], f: &f[i] };
    let records: Vec<Record<'_>> = (0..u.len()).map(record).collect();
    let detection = CycleDetection { centre: a.centre, threshold: a.threshold };
    a.report.measure(&records, &detection, a.svg.as_deref())
}
