//! ASCII files of the Engineering Strong-Motion database (ESM) and of ITACA: the DYNA format.

use super::{Format, Input, azimuth, counted, value_after};
use crate::content::Content;
use crate::fault::Fault;
use crate::number::{NumberLines, shown};
use crate::series::Series;
use crate::unit::{self, Quantity};

pub(super) const ESM: Format = Format {
    name: "ESM",
    recognised_by: "lines \"SAMPLING_INTERVAL_S:\" and \"NDATA:\" in the header",
    states: "quantity, unit, step, number of values, direction, station, event",
    description: "ESM and ITACA, DYNA file format 1.2: lines KEY: value, then one value in a line",
    is: |input| {
        value_after(&input.head, "SAMPLING_INTERVAL_S").is_some() && value_after(&input.head, "NDATA").is_some()
    },
    read,
};

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    let head = &input.head;
    let value = |key: &str| value_after(head, key).unwrap_or_default();
    let line_of = |key: &str| head.iter().position(|l| value_after(&[l], key).is_some()).map_or(1, |i| i + 1);
    let wrong = |key: &str| Fault::in_line(line_of(key), format!("{key} is \"{}\"", shown(value(key))));
    let dt = value("SAMPLING_INTERVAL_S").parse::<f64>().ok().filter(|dt| *dt > 0.0 && dt.is_finite());
    let dt = dt.ok_or_else(|| wrong("SAMPLING_INTERVAL_S").expected("expected a step of time in s"))?;
    let count = value("NDATA").parse::<usize>().map_err(|_| wrong("NDATA").expected("expected a number of values"))?;
    let is_key = |l: &str| {
        l.split_once(':')
            .is_some_and(|(k, _)| !k.is_empty() && !k.starts_with(|c: char| c.is_ascii_digit() || c == '-'))
    };
    let first = head.iter().rposition(|l| is_key(l)).map_or(0, |i| i + 1);
    let unit_name = value("UNITS");
    let unit = unit::header_unit(unit_name);
    let quantity = match value("DATA_TYPE") {
        "" => unit.map(|u| u.quantity),
        word => Some(
            Quantity::named(word)
                .ok_or_else(|| wrong("DATA_TYPE").expected("expected ACCELERATION, VELOCITY or DISPLACEMENT"))?,
        ),
    };
    if let (Some(q), Some(u)) = (quantity, unit)
        && q != u.quantity
    {
        return Err(wrong("UNITS").expected(format!("expected a unit of {}, as DATA_TYPE says", q.word())));
    }
    let mut numbers = NumberLines::default();
    let mut last = first;
    for (n, line) in input.lines().skip(first) {
        numbers.push(n, line)?;
        last = n;
    }
    let mut values = numbers.values;
    let mut notes = vec![];
    counted(&mut values, count, &mut notes)?;
    let stream = [value("STREAM"), value("COMPONENT")].into_iter().find(|w| !w.is_empty()).unwrap_or_default();
    // The last letter of a stream such as HGE or HNN is its direction.
    let azimuth = azimuth(stream).or_else(|| azimuth(stream.get(stream.len().checked_sub(1)?..)?));
    let mut series = Series {
        title: format!(
            "{}, {}, {} {}",
            value("EVENT_NAME"),
            value("EVENT_DATE_YYYYMMDD"),
            value("NETWORK"),
            value("STATION_CODE")
        ),
        station: value("STATION_CODE").to_owned(),
        event: value("EVENT_NAME").to_owned(),
        direction: stream.to_owned(),
        azimuth,
        quantity,
        unit,
        unit_name: unit_name.to_owned(),
        ..Series::new(values)
    }
    .with_step(dt);
    series.origin.lines = first + 1..last + 1;
    Ok(Content::series(vec![series], head[..first].iter().map(|l| (*l).to_owned()).collect(), notes))
}
