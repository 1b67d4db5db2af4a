//! `printA`, `printB` and `printX`: matrix, right-hand side and solution of the equations.

use crate::args::Args;
use crate::effect::Effect;
use crate::text::Arg;
use crate::{Command, Outcome, Tcl, ignore_unknown, print_error};
use hysteron_engine::analysis::{Equations, Failure};
use hysteron_engine::number_format::Style;
use hysteron_tcl::{Call, OpenMode, Value};
use std::io::Write as _;

const FILE: Arg = Arg::of("-file", "file", "name of the file");

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("printA", PRINT_A, print_a)
        .arguments(&[FILE])
        .about("Prints the matrix of the equations, under `system Diagonal` its diagonal.")
        .leaving(Effect::Nothing),
    Command::new("printB", PRINT_B, print_b)
        .arguments(&[FILE])
        .about("Prints the right-hand side of the equations.")
        .leaving(Effect::Nothing),
    Command::new("printX", PRINT_X, print_x)
        .arguments(&[FILE])
        .about("Prints the solution of the equations that the last iteration has found.")
        .leaving(Effect::Nothing),
];

const PRINT_A: &str = "printA <-file $file> <-ret>";
const PRINT_B: &str = "printB <-file $file> <-ret>";
const PRINT_X: &str = "printX <-file $file> <-ret>";

/// Numbers to print, and how many of them stand in a row.
type Rows = (Vec<f64>, usize);

/// Matrix of the equations, or its diagonal as a column where the system holds no more.
fn print_a(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    print(interp, call, PRINT_A, |i| {
        let e = equations(i)?;
        let n = e.unbalance.len();
        let columns = if e.matrix.len() == n { 1 } else { n };
        Ok((e.matrix, columns))
    })
}

fn print_b(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    print(interp, call, PRINT_B, |i| Ok(one_row(equations(i)?.unbalance)))
}

fn print_x(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    print(interp, call, PRINT_X, |i| Ok(one_row(i.host.engine.last_correction())))
}

fn one_row(numbers: Vec<f64>) -> Rows {
    let columns = numbers.len();
    (numbers, columns)
}

fn equations(interp: &mut Tcl) -> Result<Equations, Failure> {
    let terms = interp.host.parts.matrix_terms.unwrap_or_default();
    interp.host.engine.equations(terms)
}

/// Write numbers in rows, or give them back.
fn print(
    interp: &mut Tcl,
    call: &Call<'_>,
    usage: &'static str,
    what: fn(&mut Tcl) -> Result<Rows, Failure>,
) -> Outcome {
    let mut a = Args::new(call, usage);
    let (mut file, mut give_back) = (None, false);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-file" | "file" => file = Some(a.word(FILE.meaning)?.into_owned()),
            "-ret" | "ret" => give_back = true,
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    let rows = what(interp);
    let (numbers, columns) = rows.map_err(|failure| a.refuse_at(call.whole_span(), failure.to_string(), ""))?;
    if give_back {
        return Ok(Value::list(numbers.into_iter().map(Value::from)));
    }
    let mut text = String::new();
    for row in numbers.chunks(columns.max(1)) {
        for x in row {
            Style::default().push(*x, &mut text);
            text.push(' ');
        }
        text.push('\n');
    }
    let Some(name) = file else {
        print_error(interp, &text);
        return Ok(Value::EMPTY);
    };
    let path = interp.absolute(&name);
    let mode = OpenMode { write: true, create: true, truncate: true, ..OpenMode::default() };
    let written = interp.files.open(&path, mode).and_then(|mut f| f.write_all(text.as_bytes()));
    written.map_err(|e| a.refuse_at(call.whole_span(), format!("the file \"{name}\" cannot be written: {e}"), ""))?;
    Ok(Value::EMPTY)
}
