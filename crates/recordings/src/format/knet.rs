//! K-NET and KiK-net of the National Research Institute for Earth Science and Disaster Resilience, Japan.

use super::{Format, Input, azimuth, value_after};
use crate::content::Content;
use crate::fault::Fault;
use crate::number::{NumberLines, shown};
use crate::series::Series;
use crate::unit;

pub(super) const KNET: Format = Format {
    name: "K-NET",
    recognised_by: "lines \"Scale Factor\" and \"Sampling Freq(Hz)\" in the header",
    states: "accelerations in cm/s2 by the scale factor, step, duration, direction, station",
    description: "NIED, K-NET ASCII format: 17 lines of header, counts in rows of eight",
    is: |input| {
        value_after(&input.head, "Scale Factor").is_some() && value_after(&input.head, "Sampling Freq(Hz)").is_some()
    },
    read,
};

/// Directions of KiK-net by number: 1 to 3 in the borehole, 4 to 6 at the surface.
const DIRECTIONS: &[(&str, &str)] = &[
    ("1", "N-S, borehole"),
    ("2", "E-W, borehole"),
    ("3", "U-D, borehole"),
    ("4", "N-S, surface"),
    ("5", "E-W, surface"),
    ("6", "U-D, surface"),
];

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    let head = &input.head;
    let value = |key: &str| value_after(head, key).unwrap_or_default();
    let line_of = |key: &str| head.iter().position(|l| value_after(&[l], key).is_some()).map_or(1, |i| i + 1);
    let wrong = |key: &str| Fault::in_line(line_of(key), format!("\"{key}\" is \"{}\"", shown(value(key))));
    let rate = value("Sampling Freq(Hz)").trim_end_matches(|c: char| c.is_alphabetic()).trim().parse::<f64>();
    let rate = rate
        .ok()
        .filter(|r| *r > 0.0 && r.is_finite())
        .ok_or_else(|| wrong("Sampling Freq(Hz)").expected("expected a frequency in Hz"))?;
    // `3920(gal)/6182761`: so many gal are so many counts.
    let scale = || {
        let (full, counts) = value("Scale Factor").split_once('/')?;
        let (amount, unit) = full.trim().strip_suffix(')')?.split_once('(')?;
        unit::header_unit(unit).filter(|u| u.name == "gal")?;
        let scale = amount.trim().parse::<f64>().ok()? / counts.trim().parse::<f64>().ok()?;
        Some(scale).filter(|s| *s > 0.0 && s.is_finite())
    };
    let scale = scale().ok_or_else(|| wrong("Scale Factor").expected("expected, for instance, 3920(gal)/6182761"))?;
    let first = line_of("Memo.").max(line_of("Scale Factor")).max(line_of("Last Correction"));
    let mut counts = NumberLines::default();
    let mut last = first;
    for (n, line) in input.lines().skip(first) {
        counts.push(n, line)?;
        last = n;
    }
    let mut notes = vec![];
    let there = counts.values.len();
    let duration = value("Duration Time(s)").parse::<f64>().ok();
    if let Some(n) = duration.map(|d| d * rate).filter(|n| *n != there as f64) {
        notes.push(format!("the header says {n} values (duration times frequency), but there are {there}"));
    }
    let dir = value("Dir.");
    let direction = DIRECTIONS.iter().find(|(n, _)| *n == dir).map_or(dir, |(_, d)| *d);
    let unit = unit::unit("cm/s2").ok_or_else(|| Fault::new("no unit"))?;
    let values = counts.values.iter().map(|c| scale * c).collect();
    let mut series = Series {
        title: format!("{} {}", value("Station Code"), value("Origin Time")).trim().to_owned(),
        station: value("Station Code").to_owned(),
        event: value("Origin Time").to_owned(),
        direction: direction.to_owned(),
        azimuth: azimuth(direction.split(',').next().unwrap_or_default()),
        ..Series::new(values)
    }
    .with_unit(unit)
    .with_step(1.0 / rate);
    series.origin.lines = first + 1..last + 1;
    Ok(Content::series(vec![series], head[..first.min(head.len())].iter().map(|l| (*l).to_owned()).collect(), notes))
}
