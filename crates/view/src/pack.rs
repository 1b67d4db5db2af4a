//! Arrays in a page: one binary block, compressed and in base64, with a description in JSON.

use crate::numbers::range;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

/// Level of compression: beyond it the time grows and the size does not shrink by much.
const LEVEL: u8 = 7;

/// Largest code of a number in 16 bits.
const CODES: f32 = 65_534.0;

/// Arrays that are written behind each other.
#[derive(Debug, Default)]
pub(crate) struct Pack {
    bytes: Vec<u8>,
}

impl Pack {
    /// Place of an array and its description.
    fn place(&mut self, kind: &str, length: usize, bytes: impl IntoIterator<Item = u8>) -> Value {
        // Typed arrays of a browser begin at multiples of their size.
        while !self.bytes.len().is_multiple_of(4) {
            self.bytes.push(0);
        }
        let at = self.bytes.len();
        self.bytes.extend(bytes);
        json!({ "k": kind, "at": at, "n": length })
    }

    /// Integers.
    pub(crate) fn integers(&mut self, values: impl ExactSizeIterator<Item = i32>) -> Value {
        let n = values.len();
        self.place("i", n, values.flat_map(i32::to_le_bytes))
    }

    /// Numbers of single precision.
    pub(crate) fn floats(&mut self, values: impl ExactSizeIterator<Item = f32>) -> Value {
        let n = values.len();
        self.place("f", n, values.flat_map(f32::to_le_bytes))
    }

    /// Numbers in 16 bits: 65,535 codes between the smallest and the largest.
    pub(crate) fn shorts(&mut self, values: &[f32]) -> Value {
        let (low, high) = range(values.iter().copied());
        let step = if high > low { (high - low) / CODES } else { 1.0 };
        let codes = values.iter().flat_map(|x| (((x - low) / step).round() as u16).to_le_bytes());
        let mut place = self.place("s", values.len(), codes);
        place["low"] = json!(low);
        place["step"] = json!(step);
        place
    }

    /// Rows of numbers in 16 bits, in groups of columns that have a scale of their own: `group` has that of each column.
    pub(crate) fn grouped_shorts(&mut self, values: &[f32], group: &[usize]) -> Value {
        let groups = group.iter().max().map_or(0, |g| g + 1);
        let of_group =
            |g: usize| values.iter().zip(group.iter().cycle()).filter(move |(_, k)| **k == g).map(|(x, _)| *x);
        let scales: Vec<(f32, f32)> = (0..groups)
            .map(|g| {
                let (low, high) = range(of_group(g));
                (low, if high > low { (high - low) / CODES } else { 1.0 })
            })
            .collect();
        let code = |(x, g): (&f32, &usize)| ((x - scales[*g].0) / scales[*g].1).round() as u16;
        let codes = values.iter().zip(group.iter().cycle()).flat_map(|pair| code(pair).to_le_bytes());
        let mut place = self.place("s", values.len(), codes);
        place["lows"] = scales.iter().map(|s| json!(s.0)).collect();
        place["steps"] = scales.iter().map(|s| json!(s.1)).collect();
        place
    }

    /// Numbers of an array, as the page decodes them.
    #[cfg(test)]
    pub(crate) fn read(&self, place: &Value) -> Vec<f64> {
        let number = |key: &str| place[key].as_f64().unwrap_or(f64::NAN);
        let (at, n) = (number("at") as usize, number("n") as usize);
        let word = |i: usize| [0, 1, 2, 3].map(|k| self.bytes[at + 4 * i + k]);
        let code = |i: usize| f64::from(u16::from_le_bytes([self.bytes[at + 2 * i], self.bytes[at + 2 * i + 1]]));
        let value = |i: usize| match place["k"].as_str() {
            Some("i") => f64::from(i32::from_le_bytes(word(i))),
            Some("f") => f64::from(f32::from_le_bytes(word(i))),
            _ => number("low") + number("step") * code(i),
        };
        (0..n).map(value).collect()
    }

    /// The block as a page carries it.
    pub(crate) fn finish(&self) -> String {
        packed(&self.bytes)
    }
}

/// Bytes compressed (zlib) and in base64.
pub(crate) fn packed(bytes: &[u8]) -> String {
    STANDARD.encode(miniz_oxide::deflate::compress_to_vec_zlib(bytes, LEVEL))
}

/// Compressed bytes in base64.
pub(crate) fn encoded(bytes: &[u8]) -> String {
    STANDARD.encode(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_16_bits_keep_their_extremes() {
        let values: Vec<f32> = (0..1000).map(|i| (i as f32 * 0.1).sin() * 3.0 - 1.0).collect();
        let mut pack = Pack::default();
        pack.integers([7].into_iter());
        let place = pack.shorts(&values);
        let (at, low) = (place["at"].as_u64().unwrap_or(0) as usize, place["low"].as_f64().unwrap_or(0.0));
        let step = place["step"].as_f64().unwrap_or(0.0);
        assert_eq!(at % 4, 0);
        for (i, x) in values.iter().enumerate() {
            let code = u16::from_le_bytes([pack.bytes[at + 2 * i], pack.bytes[at + 2 * i + 1]]);
            assert!((low + step * f64::from(code) - f64::from(*x)).abs() <= 0.51 * step);
        }
    }
}
