//! Reading `[[run.observe]]`: a recorded channel, brought to the unit and the clock of the model.

use super::load::StudyError;
use super::loop_measure::{LoopMeasure, LoopQuantity};
use super::run::ObservedChannel;
use super::study_file::{ObserveTable, SourceSpans};
use crate::checks;
use hysteron_recordings::unit::{self, Unit};
use hysteron_recordings::{Column, Recording};
use hysteron_tcl::diagnostic::{Diagnostic, nearest};
use toml::Spanned;

/// Conversion of a recorded sample to the unit of the model's output.
struct Conversion {
    factor: f64,
    offset: f64,
    /// Unit of the result; empty if it is not known.
    unit: String,
}

/// An observed channel with its samples.
pub(super) fn read_channel(
    spans: &SourceSpans,
    o: &ObserveTable,
    recording: &Recording,
    path: &str,
    warnings: &mut Vec<Diagnostic>,
) -> Result<ObservedChannel, StudyError> {
    let channel = o.channel.get_ref();
    let Some(column) = recording.column(channel) else {
        let known: Vec<&str> = recording.columns.iter().map(|c| c.name.as_str()).collect();
        let mut d = spans.error(&o.channel, format!("{path} has no column {channel}"), "expected a column of it");
        match nearest(channel, known.iter().copied()) {
            near @ Some(_) => d.add_suggestion(channel, near),
            None => d.help.push(format!("it has {}", known.join(", "))),
        }
        return Err(d);
    };
    let weight = match &o.weight {
        Some(w) => spans.number("the weight", w, |x| x >= 0.0, "expected a number not less than 0")?,
        None => 1.0,
    };
    let at = column_number(spans, &o.column)?;
    let shift = match &o.shift {
        Some(s) => spans.number("the shift", s, |_| true, "expected a number, in s")?,
        None => 0.0,
    };
    let Conversion { factor, offset, unit } = conversion(spans, o, column, path)?;
    // Samples that need no conversion keep their bits, the sign of a zero too.
    let values: Vec<f64> = match factor == 1.0 && offset == 0.0 {
        true => column.values.clone(),
        false => column.values.iter().map(|v| factor * v + offset).collect(),
    };
    let present: Vec<f64> = values.iter().copied().filter(|v| !v.is_nan()).collect();
    let measure = measure(spans, o)?;
    let variance = if measure.is_some() { mean_square(&present) } else { population_variance(&present) };
    if variance.is_nan() || variance <= 0.0 {
        let (message, expected) = match measure {
            Some(_) => (format!("{channel} of {path} is zero"), "expected measured cycles"),
            None => {
                let message = format!("{channel} of {path} never changes ({} samples)", present.len());
                (message, "expected a channel with a variance")
            }
        };
        return Err(spans.error(&o.channel, message, expected));
    }
    let missing = values.len() - present.len();
    if missing > 0 {
        let message = format!("{missing} of {} samples of {channel} in {path} are missing", values.len());
        warnings
            .push(Diagnostic::warning(&checks::MISSING_SAMPLES, message).at(Some(spans.span(&o.channel)), "left out"));
    }
    Ok(ObservedChannel {
        channel: column.name.clone(),
        unit,
        output: o.output.get_ref().clone(),
        column: at,
        measure,
        at: o.at.clone().unwrap_or_default(),
        weight,
        shift,
        values,
        variance,
    })
}

/// Variance about the mean; NaN without samples.
fn population_variance(x: &[f64]) -> f64 {
    let n = x.len() as f64;
    let mean = x.iter().sum::<f64>() / n;
    x.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / n
}

/// Mean square; NaN without samples.
fn mean_square(x: &[f64]) -> f64 {
    x.iter().map(|v| v * v).sum::<f64>() / x.len() as f64
}

fn column_number(spans: &SourceSpans, column: &Spanned<i64>) -> Result<usize, StudyError> {
    let number = *column.get_ref();
    usize::try_from(number).map_err(|_| spans.error(column, format!("the column is {number}"), "expected 0, 1, ..."))
}

/// The measure of loops that a channel asks for.
fn measure(spans: &SourceSpans, o: &ObserveTable) -> Result<Option<LoopMeasure>, StudyError> {
    let Some(word) = &o.measure else {
        let (message, label) = ("a deformation without a measure", "expected with measure");
        if let Some(d) = &o.deformation {
            return Err(spans.error(d, message, label));
        }
        return o.deformation_column.as_ref().map_or(Ok(None), |c| Err(spans.error(c, message, label)));
    };
    let known = spans.choice("measure", word, &LoopQuantity::words())?;
    let (Some(quantity), Some(output), Some(column)) =
        (LoopQuantity::from_word(known), &o.deformation, &o.deformation_column)
    else {
        let message = format!("{known} is a measure of loops over a deformation, which is not given");
        return Err(spans.error(word, message, "expected deformation and deformation_column with it"));
    };
    Ok(Some(LoopMeasure { quantity, output: output.get_ref().clone(), column: column_number(spans, column)? }))
}

/// The conversion that `factor`, `offset` and `unit` ask for: that of the unit first, then factor and offset.
fn conversion(spans: &SourceSpans, o: &ObserveTable, column: &Column, path: &str) -> Result<Conversion, StudyError> {
    let factor = match &o.factor {
        Some(f) => spans.number("the factor", f, |x| x != 0.0, "expected a number other than 0")?,
        None => 1.0,
    };
    let offset = match &o.offset {
        Some(s) => spans.number("the offset", s, |_| true, "expected a number, in the unit of the output")?,
        None => 0.0,
    };
    let Some(wanted) = &o.unit else {
        return Ok(Conversion { factor, offset, unit: unit_of_product(&column.unit, factor) });
    };
    let target = known_unit(spans, wanted)?;
    let name = wanted.get_ref().trim().to_owned();
    if column.unit.is_empty() {
        return Ok(Conversion { factor, offset, unit: name });
    }
    let Some(source) = unit::unit(&column.unit) else {
        let message = format!("the unit of {} in {path} is not known: \"{}\"", column.name, column.unit);
        let mut d = spans.error(wanted, message, "cannot be converted to this unit");
        if let Some(near) = unit::nearest_name(&column.unit) {
            d.help.push(format!("did you mean \"{near}\" in the header of {path}?"));
        }
        d.help.push("give a factor, and leave the unit out".into());
        return Err(d);
    };
    let Some((scale, zero)) = source.conversion(&target) else {
        let (recorded, model) = (source.quantity, target.quantity);
        let message = format!("{} of {path} is {recorded} in {}, and {name} is {model}", column.name, column.unit);
        let mut d = spans.error(wanted, message, format!("expected a unit of {}", noun(&recorded.to_string())));
        d.help.push("channel and output must be the same quantity: is this the right column?".into());
        return Err(d);
    };
    Ok(Conversion { factor: factor * scale, offset: factor * zero + offset, unit: name })
}

/// A quantity without its article.
fn noun(quantity: &str) -> &str {
    quantity.split_once(' ').map_or(quantity, |(_, noun)| noun)
}

/// The unit of `[[run.observe]]`, which must be known.
fn known_unit(spans: &SourceSpans, s: &Spanned<String>) -> Result<Unit, StudyError> {
    unit::unit(s.get_ref()).ok_or_else(|| {
        let mut d = spans.error(s, format!("unknown unit \"{}\"", s.get_ref()), "expected the unit of the output");
        match unit::nearest_name(s.get_ref()) {
            near @ Some(_) => d.add_suggestion(s.get_ref(), near),
            None => d.help.push("units are, for instance, m, mm, m/s2, g, kN, kip, MPa, kNm, rad, degC, s".into()),
        }
        d
    })
}

/// The unit of recorded values times a factor: of 1000 x kN it is N. A factor that is no ratio of units keeps the unit.
fn unit_of_product(recorded: &str, factor: f64) -> String {
    let ratio_of = |u: &Unit| {
        let same = unit::all().iter().filter(|v| v.quantity == u.quantity && v.offset == u.offset);
        same.map(|v| (v.name, u.factor / v.factor)).find(|(_, r)| (factor.abs() / r - 1.0).abs() < 1e-4)
    };
    let known = unit::unit(recorded).filter(|_| factor.abs() != 1.0);
    known.as_ref().and_then(ratio_of).map_or_else(|| recorded.to_owned(), |(name, _)| name.to_owned())
}
