//! Commands of our own to look at results: `columns` reads a table, `figure` draws it.

use crate::args::Args;
use crate::chart::{Curve, Figure, MAX_DRAWN, Mark};
use crate::effect::Effect;
use crate::load::motion_file::measured;
use crate::text::{Arg, Domain};
use crate::{Command, Outcome, Tcl, ignore_unknown};
use hysteron_recordings::Table;
use hysteron_tcl::{Call, Exception, Value};
use std::io::Write as _;

const RANGE_LOW: Arg = Arg::of("-xrange", "low", "low end of the axis").within(Domain::Number);
const RANGE_HIGH: Arg = Arg::of("-xrange", "high", "high end of the axis").within(Domain::Number);

const FILE: Arg = Arg::new("file", "name of the file");
const FILE_SVG: Arg = Arg::new("file.svg", "name of the file");
const TITLE_TEXT: Arg = Arg::of("-title", "text", "title");
const X_LABEL: Arg = Arg::of("-x", "label", "label of the horizontal axis");
const Y_LABEL: Arg = Arg::of("-y", "label", "label of the vertical axis");

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("columns", COLUMNS, columns)
        .arguments(&[FILE])
        .about("Returns the columns of a table of numbers as a list of lists.")
        .own()
        .leaving(Effect::Nothing),
    Command::new("figure", FIGURE, figure)
        .arguments(&[
            FILE_SVG,
            TITLE_TEXT,
            X_LABEL,
            Y_LABEL,
            RANGE_LOW,
            RANGE_HIGH,
            Arg::of("-yrange", "low", "low end of the axis").within(Domain::Number),
            Arg::of("-yrange", "high", "high end of the axis").within(Domain::Number),
            Arg::of("-line", "name", "name of the curve"),
            Arg::of("-line", "xs", "horizontal values"),
            Arg::of("-line", "ys", "vertical values"),
            Arg::of("-dots", "name", "name of the curve"),
            Arg::of("-dots", "xs", "horizontal values"),
            Arg::of("-dots", "ys", "vertical values"),
        ])
        .about("Draws curves into an SVG file.")
        .own()
        .leaving(Effect::Nothing),
];

const COLUMNS: &str = "columns $file: the columns of a table of numbers, a list of lists";
const FIGURE: &str = "figure $file.svg -title $text -x $label -y $label <-xrange $low $high> <-yrange $low $high> <-equal> \
                      -line $name $xs $ys ... <-dots $name $xs $ys ...>";

fn columns(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, COLUMNS);
    let name = a.word(FILE.meaning)?.into_owned();
    let read = measured(interp, &name, |bytes, beside| Table::read_beside(&name, bytes, beside));
    let read = read.map_err(|e| a.unreadable(a.last_span(), &name, &e))?;
    let table = read.map_err(|e| a.refuse(format!("\"{name}\": {e}"), "expected a table of numbers"))?;
    let column = |c: Vec<f64>| Value::list(c.into_iter().map(Value::from));
    Ok(Value::list(table.columns.into_iter().map(column)))
}

fn numbers(a: &mut Args<'_>, what: &str) -> Result<Vec<f64>, Exception> {
    let value = a.value(what)?;
    let wrong = || a.refuse(format!("the {what} are not a list of numbers"), "expected a list of numbers");
    let list = value.to_list().map_err(|_| wrong())?;
    let too_large =
        |x: f64| a.refuse(format!("{x:e} cannot be drawn"), format!("expected numbers up to {MAX_DRAWN:e}"));
    let number = |v: &Value| match v.to_f64() {
        Ok(x) if x.is_finite() && x.abs() > MAX_DRAWN => Err(too_large(x)),
        Ok(x) => Ok(x),
        Err(_) => Err(wrong()),
    };
    list.iter().map(number).collect()
}

fn range(a: &mut Args<'_>) -> Result<(f64, f64), Exception> {
    let (low, high) = (a.number(&RANGE_LOW)?, a.number(&RANGE_HIGH)?);
    if low < high && low.abs().max(high.abs()) <= MAX_DRAWN {
        Ok((low, high))
    } else {
        Err(a.refuse(format!("the axis goes from {low} to {high}"), format!("expected more, up to {MAX_DRAWN:e}")))
    }
}

fn figure(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, FIGURE);
    let name = a.word(FILE.meaning)?.into_owned();
    let span = a.last_span();
    let mut f = Figure::default();
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-title" => f.title = a.word(TITLE_TEXT.meaning)?.into_owned(),
            "-x" => f.x_label = a.word(X_LABEL.meaning)?.into_owned(),
            "-y" => f.y_label = a.word(Y_LABEL.meaning)?.into_owned(),
            "-equal" => f.equal = true,
            "-xrange" => f.x_range = Some(range(&mut a)?),
            "-yrange" => f.y_range = Some(range(&mut a)?),
            "-line" | "-dots" => {
                let mark = if option == "-line" { Mark::Line } else { Mark::Dots };
                let name = a.word("name of the curve")?.into_owned();
                let xs = numbers(&mut a, "horizontal values")?;
                let ys = numbers(&mut a, "vertical values")?;
                if xs.len() != ys.len() {
                    let message = format!("{} horizontal values but {} vertical ones", xs.len(), ys.len());
                    return Err(a.refuse(message, "expected as many"));
                }
                f.curves.push(Curve { name, points: xs.into_iter().zip(ys).collect(), mark });
            }
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    let svg = f.svg().map_err(|e| a.refuse_at(span, format!("figure: {e}"), ""))?;
    let path = interp.absolute(&name);
    let mode = hysteron_tcl::OpenMode { write: true, create: true, truncate: true, ..Default::default() };
    let written = interp.files.open(&path, mode).and_then(|mut file| file.write_all(svg.as_bytes()));
    written.map_err(|e| a.refuse_at(span, format!("cannot write \"{name}\": {e}"), "expected a file"))?;
    Ok(Value::EMPTY)
}
