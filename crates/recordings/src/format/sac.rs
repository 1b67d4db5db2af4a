//! SAC: evenly spaced series of the Seismic Analysis Code.

use super::array::Element;
use super::{Format, Input};
use crate::content::Content;
use crate::fault::Fault;
use crate::series::{Clock, Series};
use crate::unit::Quantity;

pub(super) const SAC: Format = Format {
    name: "SAC",
    recognised_by: "version 6 or 7 in word 77 of a header of 632 bytes",
    states: "step, start, number of values, azimuth, station, and often the quantity; no unit",
    description: "IRIS, SAC data file format",
    is: |input| is_little(input.bytes).is_some(),
    read,
};

const HEADER: usize = 632;
const VERSION: usize = 76;
const COUNT: usize = 79;
const TYPE: usize = 85;
const QUANTITY: usize = 86;
const EVEN: usize = 105;
/// Entry of an evenly spaced series, and the value of an entry that is not known.
const TIME_SERIES: f64 = 1.0;
const UNKNOWN: f64 = -12345.0;
const STATION: std::ops::Range<usize> = 440..448;
const COMPONENT: std::ops::Range<usize> = 600..608;

fn word(bytes: &[u8], index: usize, element: Element, little: bool) -> Option<f64> {
    bytes.get(4 * index..4 * index + 4).map(|b| element.value(b, little))
}

/// The order of the bytes, if they are a SAC file.
fn is_little(bytes: &[u8]) -> Option<bool> {
    if bytes.len() < HEADER {
        return None;
    }
    [true, false].into_iter().find(|little| {
        word(bytes, VERSION, Element::Signed(4), *little).is_some_and(|v| v == 6.0 || v == 7.0)
            && word(bytes, COUNT, Element::Signed(4), *little).is_some_and(|n| n >= 0.0)
    })
}

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    let little = is_little(input.bytes).ok_or_else(|| Fault::new("is no SAC file"))?;
    let real = |i: usize| word(input.bytes, i, Element::F4, little).unwrap_or(UNKNOWN);
    let whole = |i: usize| word(input.bytes, i, Element::Signed(4), little).unwrap_or(UNKNOWN);
    if whole(TYPE) != TIME_SERIES || whole(EVEN) != 1.0 {
        return Err(Fault::new("the SAC file is no evenly spaced time series"));
    }
    let count = whole(COUNT) as usize;
    // Version 7 repeats the step in double precision behind the data.
    let data = &input.bytes[HEADER..];
    let footer = whole(VERSION) == 7.0 && data.len() == 4 * count + 176;
    if data.len() != 4 * count && !footer {
        return Err(Fault::new(format!("the header says {count} values, the file has {} bytes of them", data.len())));
    }
    let dt = if footer {
        Element::F8.value(&data[4 * count..4 * count + 8], little)
    } else {
        // The step was a decimal number before it was a single one.
        format!("{}", real(0) as f32).parse().unwrap_or(f64::NAN)
    };
    if !(dt > 0.0 && dt.is_finite()) {
        return Err(Fault::new("the header gives no step of time"));
    }
    let values: Vec<f64> = data[..4 * count].chunks_exact(4).map(|b| Element::F4.value(b, little)).collect();
    if let Some(i) = values.iter().position(|x| !x.is_finite()) {
        return Err(Fault::new(format!("value {} is {}", i + 1, values[i])));
    }
    let text = |range: std::ops::Range<usize>| {
        let text = String::from_utf8_lossy(&input.bytes[range]).trim_end_matches(['\0', ' ']).to_owned();
        if text.starts_with("-12345") { String::new() } else { text }
    };
    let quantity = match whole(QUANTITY) as i64 {
        6 => Some(Quantity::Length),
        7 => Some(Quantity::Velocity),
        8 => Some(Quantity::Acceleration),
        _ => None,
    };
    let start = Some(real(5)).filter(|b| *b != UNKNOWN && b.is_finite()).unwrap_or(0.0);
    let mut series = Series {
        station: text(STATION),
        direction: text(COMPONENT),
        azimuth: Some(real(57)).filter(|a| (0.0..=360.0).contains(a)),
        quantity,
        clock: Clock::Steps { start, dt },
        ..Series::new(values)
    };
    series.title.clone_from(&series.station);
    series.origin.bytes = HEADER..HEADER + 4 * count;
    Ok(Content::series(vec![series], vec![format!("SAC, {count} values, DELTA {dt}")], vec![]))
}
