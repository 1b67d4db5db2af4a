//! `hysteron prototype`: measures, acceptance and bounds of prototype tests.

use super::files::{make_folder, write_atomically};
use clap::Args;
use hysteron::design::check::check_table;
use hysteron::design::codes::Code;
use hysteron::design::prototype::{
    BoundFactors, Bounds, Factors, Nominal, Posterior, PrototypeTest, Rubber, TestDesign, TestRecord, acceptance,
    cycle_table, report, script_lines, trends,
};
use hysteron::measure::CycleDetection;
use hysteron::recordings::Table as Columns;
use hysteron::recordings::unit::unit;
use std::path::PathBuf;

/// Tests, nominal values and factors.
#[derive(Args, Debug)]
pub(super) struct PrototypeArgs {
    /// Files of tests in the order in which they were made: of any format that `recording` shows
    #[arg(required = true)]
    files: Vec<String>,
    /// Column of the displacement, by name or number from 1
    #[arg(long, short = 'u', value_name = "COLUMN")]
    displacement: String,
    /// Column of the force
    #[arg(long, short = 'f', value_name = "COLUMN")]
    force: String,
    /// Multiplies the force; -1 turns a reaction into the force of the device
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, allow_negative_numbers = true)]
    force_factor: f64,
    /// Column of the time in s
    #[arg(long, short = 't', value_name = "COLUMN")]
    time: Option<String>,
    /// Names of the units of force and length, for headings (for instance: kN m); columns with other units are converted
    #[arg(long, num_args = 2, value_names = ["FORCE", "LENGTH"])]
    units: Vec<String>,
    /// Code whose limits hold: asce7-16, asce7-22, aashto or en1998
    #[arg(long, value_name = "NAME", default_value = "asce7-16")]
    code: String,
    /// Displacement of the nominal properties; the largest of the tests if it is not given
    #[arg(long, value_name = "D")]
    design: Option<f64>,
    /// Nominal Q_d and K_d of the design; the means of the first three cycles at the design displacement if not given
    #[arg(long, num_args = 2, value_names = ["Q_D", "K_D"])]
    nominal: Vec<f64>,
    /// Elastic stiffness over K_d
    #[arg(long, value_name = "RATIO", default_value_t = 10.0)]
    elastic_ratio: f64,
    /// Factors of aging and environment of the lower bound, on Q_d and K_d
    #[arg(long, num_args = 2, value_names = ["Q_D", "K_D"], default_values_t = [1.0, 1.0])]
    aging_min: Vec<f64>,
    /// Factors of aging and environment of the upper bound, on Q_d and K_d
    #[arg(long, num_args = 2, value_names = ["Q_D", "K_D"], default_values_t = [1.0, 1.0])]
    aging_max: Vec<f64>,
    /// Factors of the specification of the lower bound, on Q_d and K_d
    #[arg(long, num_args = 2, value_names = ["Q_D", "K_D"], default_values_t = [1.0, 1.0])]
    spec_min: Vec<f64>,
    /// Factors of the specification of the upper bound, on Q_d and K_d
    #[arg(long, num_args = 2, value_names = ["Q_D", "K_D"], default_values_t = [1.0, 1.0])]
    spec_max: Vec<f64>,
    /// Least λ_test of the design, on Q_d and K_d, within which each cycle has to stay
    #[arg(long, num_args = 2, value_names = ["Q_D", "K_D"], requires = "test_max")]
    test_min: Vec<f64>,
    /// Largest λ_test of the design, on Q_d and K_d
    #[arg(long, num_args = 2, value_names = ["Q_D", "K_D"], requires = "test_min")]
    test_max: Vec<f64>,
    /// Load on the bearing, for the lines of friction pendulums
    #[arg(long, value_name = "W")]
    weight: Option<f64>,
    /// Layers of the bearing, for the line of LeadRubberX: inner and outer diameter, shim, layer, layers, bulk modulus
    #[arg(long, num_args = 6, value_names = ["D1", "D2", "TS", "TR", "N", "KBULK"])]
    rubber: Vec<f64>,
    /// Write cycles.csv, checks.csv, prototype.json, posterior.json, bounds.tcl and report.html into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print the results as JSON
    #[arg(long)]
    json: bool,
}

fn factors(name: &str, values: &[f64]) -> Result<Factors, String> {
    match values {
        [q_d, k_d] if values.iter().all(|x| *x > 0.0 && x.is_finite()) => Ok(Factors { q_d: *q_d, k_d: *k_d }),
        _ => Err(format!("{name}: expected two factors above 0")),
    }
}

/// Columns of a file.
struct Columnar {
    time: Option<Vec<f64>>,
    u: Vec<f64>,
    f: Vec<f64>,
}

fn columns(a: &PrototypeArgs, file: &str) -> Result<Columnar, String> {
    let bytes = hysteron_files::read_input(file).map_err(|e| format!("cannot read \"{file}\": {e}"))?;
    let of_file = |e: String| format!("\"{file}\": {e}");
    let (table, missing) =
        Columns::read_beside(file, &bytes, &hysteron_files::read_beside(file)).map_err(of_file)?.without_missing();
    if missing > 0 {
        eprintln!("warning: \"{file}\": {missing} rows with missing samples are left out");
    }
    let column =
        |which: &str, at: usize| table.column_in(which, a.units.get(at).and_then(|word| unit(word))).map_err(of_file);
    let time = a.time.as_deref().map(|which| table.seconds(which).map_err(of_file)).transpose()?;
    let f = column(&a.force, 0)?.into_iter().map(|f| f * a.force_factor).collect();
    Ok(Columnar { time, u: column(&a.displacement, 1)?, f })
}

/// Run the command; the text for standard output.
pub(super) fn prototype(a: &PrototypeArgs) -> Result<String, String> {
    let code = Code::named(&a.code)?;
    if !(a.elastic_ratio > 1.0 && a.elastic_ratio.is_finite()) {
        return Err(format!("--elastic-ratio is {}: expected more than 1", a.elastic_ratio));
    }
    let records = a.files.iter().map(|f| columns(a, f)).collect::<Result<Vec<_>, _>>()?;
    let mut tests = vec![];
    for (file, r) in a.files.iter().zip(&records) {
        let record = TestRecord { time: r.time.as_deref(), u: &r.u, f: &r.f };
        let name = file.rsplit('/').next().unwrap_or(file);
        tests.push(PrototypeTest::measure(name, &record, &CycleDetection::default(), a.elastic_ratio)?);
    }
    let mut nominal = Nominal::of(&tests, a.design)?;
    if let [q_d, k_d] = a.nominal[..] {
        if !(q_d > 0.0 && k_d > 0.0) {
            return Err("--nominal: expected Q_d and K_d above 0".into());
        }
        nominal = Nominal { q_d, k_d, k_eff: k_d + q_d / nominal.amplitude, amplitude: nominal.amplitude, tests: 0 };
    }
    let lower = BoundFactors {
        aging: factors("--aging-min", &a.aging_min)?,
        specification: factors("--spec-min", &a.spec_min)?,
    };
    let upper = BoundFactors {
        aging: factors("--aging-max", &a.aging_max)?,
        specification: factors("--spec-max", &a.spec_max)?,
    };
    let bounds = Bounds::new(&tests, &nominal, lower, upper, &code);
    let specification = a.spec_min.iter().chain(&a.spec_max).map(|f| (f - 1.0).abs()).fold(0.0, f64::max);
    let stated = match (&a.test_min[..], &a.test_max[..]) {
        ([], []) => None,
        (low, high) => Some([factors("--test-min", low)?, factors("--test-max", high)?]),
    };
    let design = TestDesign { specification, factors: stated, ratio: a.elastic_ratio };
    let checks = acceptance(&tests, &nominal, &design, &code);
    let posterior = Posterior::of(&tests, &nominal);
    let units = match &a.units[..] {
        [force, length] => [force.as_str(), length.as_str()],
        _ => ["", ""],
    };
    let rubber = match a.rubber[..] {
        [inner, outer, shim, layer, layers, bulk] => Some(Rubber { inner, outer, shim, layer, layers, bulk }),
        _ => None,
    };
    let lines = script_lines(&bounds, a.elastic_ratio, a.weight, rubber.as_ref());
    let table = cycle_table(&tests, &nominal, units);
    let seen = trends(&tests);
    let json = report::json(&tests, &nominal, &seen, &bounds, posterior.as_ref().ok(), &checks, &code);
    let trend_lines = report::trend_lines(&seen) + &report::posterior_lines(&posterior);
    if let Some(folder) = &a.out {
        make_folder(folder)?;
        let loops: Vec<_> =
            tests.iter().zip(&records).map(|(t, r)| (t.name.as_str(), r.u.as_slice(), r.f.as_slice())).collect();
        let page = report::html(&loops, &table, &trend_lines, &bounds, &checks, &code, units);
        for (name, text) in [
            ("cycles.csv", table.csv()),
            ("checks.csv", check_table(&checks).csv()),
            ("prototype.json", json.clone()),
            ("bounds.tcl", lines),
            ("report.html", page),
        ] {
            write_atomically(&folder.join(name), &text)?;
        }
        if let Ok(p) = &posterior {
            let text = serde_json::to_string_pretty(p).map_err(|e| e.to_string())?;
            write_atomically(&folder.join("posterior.json"), &(text + "\n"))?;
        }
    }
    if a.json {
        return Ok(json);
    }
    let bounds_table = report::bounds_table(&bounds, units).text();
    let checks = check_table(&checks).text();
    let rule = code.statement("system_adjustment").map_or_else(String::new, |text| text + "\n");
    Ok(format!("{}\n{bounds_table}{rule}\n{trend_lines}\n{checks}{}\n", table.text(), code.remark()))
}
