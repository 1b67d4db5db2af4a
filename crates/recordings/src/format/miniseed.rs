//! miniSEED 2 and 3: records of one channel each, which are joined to series.

use super::steim::{self, Samples};
use super::{Format, Input, miniseed3};
use crate::content::Content;
use crate::fault::Fault;
use crate::series::{Clock, Series};
use crate::sheet::clock::{civil, days};
use crate::unit::Quantity;

pub(super) const MINISEED: Format = Format {
    name: "miniSEED",
    recognised_by: "records with a number of six digits, a quality D, R, Q or M, and a date, or with MS and version 3",
    states: "times, number of values, network, station and channel; acceleration or velocity by the letter of the instrument; no unit",
    description: "FDSN, SEED reference manual 2.4: fixed header of 48 bytes, blockettes 100, 1000, 1001; samples of int16, int32, float32, float64, Steim 1 and 2; FDSN, miniSEED 3: record definition, with its checksum",
    is: |input| miniseed3::begins(input.bytes) || first_record(input.bytes).is_some(),
    read,
};

const HEADER: usize = 48;
/// Shortest record: control headers and empty blocks have a multiple of it.
const SHORTEST: usize = 256;
const NANOSECONDS: f64 = 1e9;

/// What the header of a record says.
pub(super) struct Record<'a> {
    /// Network, station, location and channel.
    pub(super) id: String,
    /// Time of the first sample in ns since 1970.
    pub(super) start: i64,
    /// Samples a second.
    pub(super) rate: f64,
    pub(super) count: usize,
    pub(super) samples: Samples,
    /// The little end of the samples is first.
    pub(super) little: bool,
    pub(super) data: &'a [u8],
    /// Bytes of the whole record.
    pub(super) length: usize,
}

pub(super) fn half(bytes: &[u8], at: usize, little: bool) -> Option<u16> {
    let two: [u8; 2] = bytes.get(at..at + 2)?.try_into().ok()?;
    Some(if little { u16::from_le_bytes(two) } else { u16::from_be_bytes(two) })
}

pub(super) fn word(bytes: &[u8], at: usize, little: bool) -> Option<u32> {
    let four: [u8; 4] = bytes.get(at..at + 4)?.try_into().ok()?;
    Some(if little { u32::from_le_bytes(four) } else { u32::from_be_bytes(four) })
}

/// A block begins with a number of six digits and one of these letters.
fn begins(bytes: &[u8], letters: &[u8]) -> bool {
    let digit = |b: &u8| b.is_ascii_digit() || matches!(b, b' ' | 0);
    bytes.len() >= HEADER && bytes[..6].iter().all(digit) && letters.contains(&bytes[6])
}

/// The order of the bytes of a header of a data record, by its date.
fn order(bytes: &[u8]) -> Option<bool> {
    let is_data = begins(bytes, b"DRQM") && matches!(bytes[7], b' ' | 0);
    let date = |little: &bool| {
        let year = half(bytes, 20, *little).is_some_and(|y| (1900..=2200).contains(&y));
        year && half(bytes, 22, *little).is_some_and(|d| (1..=366).contains(&d))
    };
    [false, true].into_iter().find(date).filter(|_| is_data)
}

/// A control header of a SEED volume, or a block of blanks.
fn is_no_data(bytes: &[u8]) -> bool {
    begins(bytes, b"VAST") || bytes[..bytes.len().min(SHORTEST)].iter().all(|b| *b == b' ')
}

/// The place of the first record.
fn first_record(bytes: &[u8]) -> Option<usize> {
    let mut at = 0;
    while at < bytes.len() && begins(&bytes[at..], b"VAST") {
        at += SHORTEST;
        while bytes.get(at..).is_some_and(|b| order(b).is_none() && !b.is_empty()) {
            at += SHORTEST;
        }
    }
    bytes.get(at..).and_then(order).map(|_| at)
}

/// Sampling rate in Hz of a factor and a multiplier, which divide if they are negative.
fn rate(factor: i16, multiplier: i16) -> f64 {
    let part = |x: f64| if x < 0.0 { -1.0 / x } else { x };
    part(f64::from(factor)) * part(f64::from(multiplier))
}

fn record(bytes: &[u8], at: usize) -> Result<Record<'_>, Fault> {
    let wrong = |what: &str| Fault::new(format!("the record at byte {at} {what}"));
    let rest = &bytes[at..];
    let little = order(rest).ok_or_else(|| wrong("has no header of a data record"))?;
    let h = |place: usize| half(rest, place, little).unwrap_or(0);
    let day = days(i64::from(h(20)), 1, 1).ok_or_else(|| wrong("has no date"))? + i64::from(h(22)) - 1;
    let seconds = day * 86_400 + i64::from(rest[24]) * 3600 + i64::from(rest[25]) * 60 + i64::from(rest[26]);
    let mut ticks = i64::from(h(28));
    // A correction of the clock that is not yet in the time.
    if rest[36] & 2 == 0 {
        ticks += i64::from(word(rest, 40, little).unwrap_or(0) as i32);
    }
    let mut rate = rate(h(32) as i16, h(34) as i16);
    let (mut kind, mut microseconds) = (None, 0i64);
    let mut next = usize::from(h(46));
    for _ in 0..rest[39] {
        let blockette =
            rest.get(next..next + 8).filter(|_| next >= HEADER).ok_or_else(|| wrong("ends in its header"))?;
        match half(blockette, 0, little) {
            Some(1000) => kind = Some((blockette[4], blockette[5] == 0, blockette[6])),
            Some(1001) => microseconds = i64::from(blockette[5] as i8),
            Some(100) => {
                rate = word(rest, next + 4, little).map_or(rate, |w| f64::from(f32::from_bits(w)));
            }
            _ => {}
        }
        let after = usize::from(half(blockette, 2, little).unwrap_or(0));
        if after <= next {
            break;
        }
        next = after;
    }
    let (encoding, data_little, exponent) =
        kind.ok_or_else(|| wrong("does not state its encoding (blockette 1000)"))?;
    let length = 1usize << exponent.min(30);
    if !(7..=20).contains(&exponent) || rest.len() < length {
        return Err(wrong("ends early"));
    }
    let text = |range: std::ops::Range<usize>| String::from_utf8_lossy(&rest[range]).trim().to_owned();
    let samples = Samples::of_encoding(encoding).ok_or_else(|| {
        wrong(&format!("has samples of encoding {encoding}")).help("convert it to Steim 2 or float32")
    })?;
    Ok(Record {
        id: [text(18..20), text(8..13), text(13..15), text(15..18)].join("."),
        start: seconds * 1_000_000_000 + ticks * 100_000 + microseconds * 1000,
        rate,
        count: usize::from(h(30)),
        samples,
        little: data_little,
        data: rest.get(usize::from(h(44)).min(length)..length).unwrap_or_default(),
        length,
    })
}

/// A channel that grows by records.
struct Channel {
    id: String,
    rate: f64,
    /// Times in ns and numbers of the first samples of parts that follow each other without a gap.
    parts: Vec<(i64, usize)>,
    values: Vec<f64>,
    counts: bool,
}

impl Channel {
    fn add(&mut self, record: &Record<'_>, values: &[f64]) -> Result<(), Fault> {
        if record.rate != self.rate {
            let message = format!("{} has {} samples a second, and then {}", self.id, self.rate, record.rate);
            return Err(Fault::new(message));
        }
        let (start, first) = self.parts.last().copied().unwrap_or((record.start, 0));
        let due = start as f64 + (self.values.len() - first) as f64 * NANOSECONDS / self.rate;
        if (record.start as f64 - due).abs() > 0.5 * NANOSECONDS / self.rate {
            self.parts.push((record.start, self.values.len()));
        }
        self.values.extend_from_slice(values);
        Ok(())
    }

    /// The series, with times from `zero` in ns.
    fn series(self, zero: i64, notes: &mut Vec<String>) -> Result<Series, Fault> {
        let dt = 1.0 / self.rate;
        let seconds = |start: i64| (start - zero) as f64 / NANOSECONDS;
        let clock = match self.parts[..] {
            [(start, _)] => Clock::Steps { start: seconds(start), dt },
            _ => {
                let mut times = Vec::with_capacity(self.values.len());
                for (i, (start, first)) in self.parts.iter().enumerate() {
                    let end = self.parts.get(i + 1).map_or(self.values.len(), |p| p.1);
                    if let Some(last) = times.last().filter(|last| **last >= seconds(*start)) {
                        let message = format!("{} goes back from {last} s to {} s", self.id, seconds(*start));
                        return Err(Fault::new(message).help("sort the records, and remove those that overlap"));
                    }
                    if i > 0 {
                        notes.push(format!("{} has a gap before sample {}", self.id, first + 1));
                    }
                    times.extend((0..end - first).map(|k| seconds(*start) + k as f64 * dt));
                }
                Clock::Times(times.into())
            }
        };
        let direction = self.id.rsplit('.').next().unwrap_or_default().to_owned();
        let quantity = match direction.chars().nth(1) {
            Some('N') => Some(Quantity::Acceleration),
            Some('H') => Some(Quantity::Velocity),
            _ => None,
        };
        let azimuth = match direction.chars().last() {
            Some('N') => Some(0.0),
            Some('E') => Some(90.0),
            _ => None,
        };
        let start = self.parts.first().map_or(0, |p| p.0);
        let (year, month, day) = civil(start.div_euclid(86_400_000_000_000));
        let of_day = start.rem_euclid(86_400_000_000_000) / 1_000_000_000;
        let (h, m, s) = (of_day / 3600, of_day / 60 % 60, of_day % 60);
        Ok(Series {
            title: format!("{} {year:04}-{month:02}-{day:02}T{h:02}:{m:02}:{s:02}", self.id),
            station: self.id.split('.').nth(1).unwrap_or_default().to_owned(),
            name: self.id,
            direction,
            azimuth,
            quantity,
            unit_name: if self.counts { "counts".to_owned() } else { String::new() },
            clock,
            ..Series::new(self.values)
        })
    }
}

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    let bytes = input.bytes;
    let is_third = miniseed3::begins(bytes);
    let first = if is_third { Some(0) } else { first_record(bytes) };
    let mut at = first.ok_or_else(|| Fault::new("has no record of data"))?;
    let (mut channels, mut notes): (Vec<Channel>, Vec<String>) = (vec![], vec![]);
    let mut texts = 0;
    while at < bytes.len() {
        if !is_third && order(&bytes[at..]).is_none() && is_no_data(&bytes[at..]) {
            at += SHORTEST;
            continue;
        }
        let r = match is_third {
            true if !miniseed3::begins(&bytes[at..]) => {
                return Err(Fault::new(format!("there is no record of miniSEED 3 at byte {at}")));
            }
            true => miniseed3::record(bytes, at)?,
            false => record(bytes, at)?,
        };
        at += r.length;
        if r.samples == Samples::Text {
            texts += 1;
            continue;
        }
        if r.count == 0 {
            continue;
        }
        if !(r.rate > 0.0 && r.rate.is_finite()) {
            return Err(Fault::new(format!("{} has no sampling rate", r.id)));
        }
        let values = steim::values(r.samples, r.data, r.little, r.count)
            .map_err(|e| Fault::new(format!("the record before byte {at} of {}: {e}", r.id)))?;
        let place = channels.iter().position(|c| c.id == r.id);
        let place = place.unwrap_or_else(|| {
            let counts = !matches!(r.samples, Samples::F4 | Samples::F8);
            let parts = vec![(r.start, 0)];
            channels.push(Channel { id: r.id.clone(), rate: r.rate, parts, values: vec![], counts });
            channels.len() - 1
        });
        channels[place].add(&r, &values)?;
    }
    if texts > 0 {
        notes.push(format!("{texts} records are text and no samples"));
    }
    let zero = channels.iter().filter_map(|c| c.parts.first()).map(|p| p.0).min();
    let zero = zero.ok_or_else(|| Fault::new("has no samples"))?;
    let series = channels.into_iter().map(|c| c.series(zero, &mut notes)).collect::<Result<Vec<_>, _>>()?;
    let header = series.iter().map(|s| s.title.clone()).collect();
    Ok(Content::series(series, header, notes))
}
