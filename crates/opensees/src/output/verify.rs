//! `verify`: a script compares a result with a number.

use crate::args::Args;
use crate::checks;
use crate::text::Arg;
use crate::{Command, Outcome, Tcl, finish, warn};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};

const RESULT: Arg = Arg::number("result", "result");
const REFERENCE: Arg = Arg::number("reference", "reference");
const VALUE_TOLERANCE: Arg = Arg::number("tolerance", "tolerance");

const USAGE: &str = "verify value|error $result $reference <$tolerance> <$text>";

pub(crate) const COMMANDS: &[Command] = &[Command::new("verify", USAGE, verify)
    .about(
        "Compares a result with a number: `value` by the difference, `error` by its share of the reference. It \
         prints that they agree, or ends the script.",
    )
    .arguments(&[RESULT, REFERENCE, VALUE_TOLERANCE, Arg::new("text", "text that is printed")])];

/// Tolerance where none is given, as in the OpenSees that has the command.
const TOLERANCE: f64 = 1e-12;

/// `value` compares the difference, `error` the difference as a share of the reference; other words are a heading.
fn verify(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let kind = a.word("kind of comparison: value or error")?;
    if !["value", "error"].contains(&kind.as_ref()) {
        let text = if a.left() > 0 { a.word("text")?.into_owned() } else { String::new() };
        interp.console.out(&format!("  {text}\n"));
        return Ok(Value::EMPTY);
    }
    let result = a.number(&RESULT)?;
    let word = a.last_word();
    let reference = a.number(&REFERENCE)?;
    let given = a.optional_number(&VALUE_TOLERANCE)?;
    let text = if a.left() > 0 { a.word("text")?.into_owned() } else { String::new() };
    // In OpenSees the text stands in the place of the tolerance, and a number is less than a text.
    let tolerance = given.unwrap_or(if text.is_empty() { TOLERANCE } else { f64::INFINITY });
    if tolerance.is_infinite() {
        let d = Diagnostic::warning(
            &checks::output::NOTHING_COMPARED,
            "verify: the tolerance is missing, and nothing is compared",
        );
        warn(interp, d.at(a.last_span(), "expected a tolerance before this"))?;
    }
    finish(interp, &a)?;
    let scale = if kind == "error" && reference != 0.0 { reference } else { 1.0 };
    let apart = ((result - reference) / scale).abs();
    if apart > tolerance {
        let message = format!("verify: {result} is not {reference} {text}");
        let label = format!("they differ by {apart}, more than {tolerance}");
        return Err(Exception::diagnosed(Diagnostic::error(message.trim_end()).at(call.span(2), label)));
    }
    interp.console.out(&format!("    PASS  {word} {} {text}\n", Value::from(apart).as_str()));
    Ok(Value::EMPTY)
}
