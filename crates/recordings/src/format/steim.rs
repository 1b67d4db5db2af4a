//! Samples of miniSEED records: plain numbers, and differences in the frames of Steim.

/// Encoding of samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Samples {
    Text,
    I2,
    I4,
    F4,
    F8,
    Steim1,
    Steim2,
}

impl Samples {
    /// The encoding of a number of blockette 1000.
    pub(super) fn of_encoding(number: u8) -> Option<Self> {
        Some(match number {
            0 => Self::Text,
            1 => Self::I2,
            3 => Self::I4,
            4 => Self::F4,
            5 => Self::F8,
            10 => Self::Steim1,
            11 => Self::Steim2,
            _ => return None,
        })
    }
}

/// Words of a frame.
const FRAME: usize = 16;

/// The samples of a record.
///
/// # Errors
/// There are fewer than `count`, or the last is not the one that the frames state.
pub(super) fn values(samples: Samples, data: &[u8], little: bool, count: usize) -> Result<Vec<f64>, String> {
    use super::array::Element;
    let plain = |e: Element| {
        let values: Vec<f64> = data.chunks_exact(e.size()).take(count).map(|b| e.value(b, little)).collect();
        if values.len() == count { Ok(values) } else { Err(format!("{} of {count} samples", values.len())) }
    };
    match samples {
        Samples::Text => Ok(vec![]),
        Samples::I2 => plain(Element::Signed(2)),
        Samples::I4 => plain(Element::Signed(4)),
        Samples::F4 => plain(Element::F4),
        Samples::F8 => plain(Element::F8),
        Samples::Steim1 => integrated(data, little, count, steim1),
        Samples::Steim2 => integrated(data, little, count, steim2),
    }
}

/// `n` differences of `bits` from the high end of the low `n * bits` bits of a word.
fn pieces(word: u32, n: u32, bits: u32, out: &mut Vec<i32>) {
    out.extend((0..n).map(|i| {
        let shifted = word << (32 - (n - i) * bits);
        (shifted as i32) >> (32 - bits)
    }));
}

/// Differences of a word of Steim 1 by its code.
fn steim1(code: u32, word: u32, out: &mut Vec<i32>) -> bool {
    match code {
        1 => pieces(word, 4, 8, out),
        2 => pieces(word, 2, 16, out),
        3 => pieces(word, 1, 32, out),
        _ => {}
    }
    true
}

/// Differences of a word of Steim 2 by its code, and the code in its two highest bits. False for a code without meaning.
fn steim2(code: u32, word: u32, out: &mut Vec<i32>) -> bool {
    match (code, word >> 30) {
        (0, _) => {}
        (1, _) => pieces(word, 4, 8, out),
        (2, 1) => pieces(word, 1, 30, out),
        (2, 2) => pieces(word, 2, 15, out),
        (2, 3) => pieces(word, 3, 10, out),
        (3, 0) => pieces(word, 5, 6, out),
        (3, 1) => pieces(word, 6, 5, out),
        (3, 2) => pieces(word, 7, 4, out),
        _ => return false,
    }
    true
}

/// Takes the differences of a word by its code.
type Unpack = fn(u32, u32, &mut Vec<i32>) -> bool;

/// Sums of the differences. Each record states its first and its last sample.
///
/// Source: SEED reference manual 2.4, appendix B.
fn integrated(data: &[u8], little: bool, count: usize, unpack: Unpack) -> Result<Vec<f64>, String> {
    let word = |b: &[u8]| {
        let four = [b[0], b[1], b[2], b[3]];
        if little { u32::from_le_bytes(four) } else { u32::from_be_bytes(four) }
    };
    let words: Vec<u32> = data.chunks_exact(4).map(word).collect();
    let [_, first, last, ..] = words[..] else { return Err("there is no frame".into()) };
    let mut differences: Vec<i32> = vec![];
    for (f, frame) in words.chunks_exact(FRAME).enumerate() {
        let skipped = if f == 0 { 3 } else { 1 };
        for (i, w) in frame.iter().enumerate().skip(skipped) {
            let code = frame[0] >> (30 - 2 * i as u32) & 3;
            if !unpack(code, *w, &mut differences) {
                return Err(format!("a word of frame {} has no meaning", f + 1));
            }
        }
        if differences.len() >= count {
            break;
        }
    }
    if differences.len() < count {
        return Err(format!("{} of {count} samples", differences.len()));
    }
    // The first difference leads from the record before.
    let mut x = first as i32;
    let mut values = vec![f64::from(x)];
    for d in &differences[1..count] {
        x = x.wrapping_add(*d);
        values.push(f64::from(x));
    }
    if x != last as i32 {
        return Err(format!("the last sample is {x}, and its frame states {}", last as i32));
    }
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::{Samples, pieces, values};

    #[test]
    fn differences_are_signed() {
        let mut out = vec![];
        pieces(0b01_111110_000001_000000_011111_100000, 5, 6, &mut out);
        assert_eq!(out, [-2, 1, 0, 31, -32]);
        out.clear();
        pieces(0xff01_7f80, 4, 8, &mut out);
        assert_eq!(out, [-1, 1, 127, -128]);
    }

    #[test]
    fn a_frame_is_summed_and_checked() {
        // One frame of Steim 1: samples 10, 9, 11, 11 as four differences of eight bits.
        let mut words = [0u32; 16];
        (words[0], words[1], words[2], words[3]) = (1 << 24, 10, 11, 0x00ff_0200);
        let bytes = |w: &[u32; 16]| w.iter().flat_map(|w| w.to_be_bytes()).collect::<Vec<u8>>();
        assert_eq!(values(Samples::Steim1, &bytes(&words), false, 4), Ok(vec![10.0, 9.0, 11.0, 11.0]));
        assert!(values(Samples::Steim1, &bytes(&words), false, 5).is_err());
        words[2] = 12;
        assert!(values(Samples::Steim1, &bytes(&words), false, 4).is_err());
    }
}
