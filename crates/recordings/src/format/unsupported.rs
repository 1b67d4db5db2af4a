//! Files of known kinds that are not read: they are refused by their names.

use super::{Input, has};
use crate::fault::Fault;

/// A kind of file that is not read.
struct Kind {
    /// Kind of file, with its article.
    name: &'static str,
    is: fn(&Input<'_>) -> bool,
    /// Remedy.
    remedy: &'static str,
}

const UNPACK: &str = "unpack it, and give the file in it";
const AS_CSV: &str = "export it as CSV";
const CONVERT: &str = "convert it to miniSEED or SAC, or export it as CSV";

const KINDS: &[Kind] = &[
    Kind { name: "a TDMS file of LabVIEW", is: |i| i.bytes.starts_with(b"TDSm"), remedy: "export it as LVM or CSV" },
    Kind {
        name: "a measurement file MDF of ASAM",
        is: |i| i.bytes.starts_with(b"MDF     ") || i.bytes.starts_with(b"UnFinMF "),
        remedy: AS_CSV,
    },
    Kind {
        name: "an HDF5 file (MATLAB 7.3, ASDF)",
        is: |i| i.bytes.starts_with(b"\x89HDF\r\n\x1a\n") || i.bytes.get(512..520) == Some(b"\x89HDF\r\n\x1a\n"),
        remedy: "save it with -v7 in MATLAB, or export it as CSV",
    },
    Kind { name: "a Parquet table", is: |i| i.bytes.starts_with(b"PAR1"), remedy: AS_CSV },
    Kind { name: "a table of Arrow or Feather", is: |i| i.bytes.starts_with(b"ARROW1"), remedy: AS_CSV },
    Kind { name: "a SEG-Y file", is: |i| i.bytes.starts_with(b"\xc3\x40\xf1"), remedy: CONVERT },
    Kind { name: "a PDF document", is: |i| i.bytes.starts_with(b"%PDF"), remedy: "take the data and not the report" },
    Kind { name: "an archive (bzip2)", is: |i| i.bytes.starts_with(b"BZh"), remedy: UNPACK },
    Kind { name: "an archive (xz)", is: |i| i.bytes.starts_with(b"\xfd7zXZ"), remedy: UNPACK },
    Kind { name: "an archive (7z)", is: |i| i.bytes.starts_with(b"7z\xbc\xaf"), remedy: UNPACK },
    Kind { name: "an archive (zstd)", is: |i| i.bytes.starts_with(b"\x28\xb5\x2f\xfd"), remedy: UNPACK },
    Kind { name: "an archive (rar)", is: |i| i.bytes.starts_with(b"Rar!"), remedy: UNPACK },
    Kind {
        name: "a page of the web",
        is: |i| i.head.iter().take(3).any(|l| has(l, &["<!doctype html"]) || has(l, &["<html"])),
        remedy: "the download may have asked for a login: fetch the file itself",
    },
    Kind { name: "a file of GSE2 or IMS", is: |i| i.head.iter().any(|l| l.starts_with("WID2 ")), remedy: CONVERT },
    Kind {
        name: "a universal file (UFF, dataset 58)",
        is: |i| i.head.first().is_some_and(|l| l.trim() == "-1") && i.head.get(1).is_some_and(|l| l.trim() == "58"),
        remedy: AS_CSV,
    },
    Kind {
        name: "a corrected accelerogram of Volume II without the lines \"DATA EQUALLY SPACED AT\"",
        is: |i| {
            i.head
                .first()
                .is_some_and(|l| has(l, &["corrected accelerogram"]) && !has(l, &["uncorrected"]) || has(l, &["vol2"]))
        },
        remedy: "take the record from CESMD (.v2) or as SMC, or export its accelerations as CSV",
    },
];

/// The fault of a file of a kind that is not read.
pub(crate) fn refusal(input: &Input<'_>) -> Option<Fault> {
    let kind = KINDS.iter().find(|k| (k.is)(input))?;
    Some(Fault::new(format!("is {}, which is not read", kind.name)).help(kind.remedy))
}

#[cfg(test)]
mod tests {
    use super::KINDS;
    use crate::Measured;

    #[test]
    fn kinds_that_are_not_read_are_named() {
        for (bytes, said) in [
            (&b"TDSm\x0e\0\0\0"[..], "TDMS"),
            (b"\x89HDF\r\n\x1a\n\0", "HDF5"),
            (b"\xfd7zXZ\0\0", "xz"),
            (b"<!DOCTYPE html>\n<html>", "page of the web"),
            (b"WID2 2020/01/01 00:00:00.000 ABC BHZ\n", "GSE2"),
            (b"    -1\n    58\nx\n", "universal"),
            (b"CORRECTED ACCELEROGRAM IIA001 40.001.0 COMP S00E\n1 2 3\n4 5\n", "Volume II"),
        ] {
            let fault = Measured::read("f.dat", bytes).expect_err("a refusal");
            assert!(fault.message.contains(said) && fault.help.len() == 1, "{fault}");
        }
        assert!(KINDS.iter().all(|k| !k.remedy.is_empty()));
        assert!(Measured::read("f.csv", b"corrected,acc[g]\n0,1\n1,2\n").is_ok());
    }
}
