//! Records of miniSEED 3.

use super::miniseed::{Record, half, word};
use super::steim::Samples;
use crate::fault::Fault;
use crate::sheet::clock::days;

/// Length of the fixed part of the header.
const HEADER: usize = 40;
/// Place of the checksum in the header.
const CHECKSUM: std::ops::Range<usize> = 28..32;

/// A record of version 3 begins here.
pub(super) fn begins(bytes: &[u8]) -> bool {
    bytes.len() >= HEADER && bytes.starts_with(b"MS\x03")
}

/// The checksum of a record, its own place taken as zero: CRC-32C.
fn checksum(record: &[u8]) -> u32 {
    let bit = |c: u32| if c & 1 != 0 { 0x82f6_3b78 ^ (c >> 1) } else { c >> 1 };
    let byte = |(i, b): (usize, &u8)| if CHECKSUM.contains(&i) { 0 } else { u32::from(*b) };
    !record.iter().enumerate().map(byte).fold(!0u32, |c, b| (0..8).fold(c ^ b, |c, _| bit(c)))
}

/// Network, station, location and channel of a source identifier `FDSN:NET_STA_LOC_B_S_C`; another one as it is.
fn identity(text: &str) -> String {
    let of_fdsn = text.strip_prefix("FDSN:").map(|rest| rest.split('_').collect::<Vec<_>>());
    match of_fdsn.as_deref() {
        Some([network, station, location, band, source, direction]) => {
            format!("{network}.{station}.{location}.{band}{source}{direction}")
        }
        _ => text.to_owned(),
    }
}

/// The record at a byte.
pub(super) fn record(bytes: &[u8], at: usize) -> Result<Record<'_>, Fault> {
    let wrong = |what: &str| Fault::new(format!("the record at byte {at} {what}"));
    let rest = &bytes[at..];
    let short = |place: usize| half(rest, place, true).map_or(0, usize::from);
    let long = |place: usize| word(rest, place, true).unwrap_or(0);
    let data = HEADER + usize::from(rest[33]) + short(34);
    let length = data.checked_add(long(36) as usize).filter(|n| *n <= rest.len()).ok_or_else(|| wrong("ends early"))?;
    let whole = &rest[..length];
    if checksum(whole) != long(CHECKSUM.start) {
        return Err(wrong("is damaged: its checksum is another").help("fetch the file again"));
    }
    let day = days(short(8) as i64, 1, 1).ok_or_else(|| wrong("has no date"))? + short(10) as i64 - 1;
    let seconds = day * 86_400 + i64::from(rest[12]) * 3600 + i64::from(rest[13]) * 60 + i64::from(rest[14]);
    let encoding = rest[15];
    let samples = Samples::of_encoding(encoding).ok_or_else(|| {
        wrong(&format!("has samples of encoding {encoding}")).help("convert it to Steim 2 or float32")
    })?;
    let stated = f64::from_bits(u64::from(long(16)) | u64::from(long(20)) << 32);
    Ok(Record {
        id: identity(&String::from_utf8_lossy(&whole[HEADER..HEADER + usize::from(rest[33])])),
        start: seconds * 1_000_000_000 + i64::from(long(4)),
        // A negative number is the step in s.
        rate: if stated < 0.0 { -1.0 / stated } else { stated },
        count: long(24) as usize,
        // Numbers have the little end first, and compressed samples the big one.
        little: !matches!(samples, Samples::Steim1 | Samples::Steim2),
        samples,
        data: &whole[data..],
        length,
    })
}

#[cfg(test)]
mod tests {
    use super::{checksum, identity};

    #[test]
    fn checksum_is_that_of_castagnoli() {
        // RFC 3720, B.4: 32 bytes of zeros; the place of the checksum counts as zero.
        let mut zeros = [0u8; 32];
        assert_eq!(checksum(&zeros), 0x8a91_36aa);
        zeros[29] = 7;
        assert_eq!(checksum(&zeros), 0x8a91_36aa);
    }

    #[test]
    fn identifiers() {
        assert_eq!(identity("FDSN:IU_COLA_00_L_H_Z"), "IU.COLA.00.LHZ");
        assert_eq!(identity("XFDSN:A"), "XFDSN:A");
    }
}
