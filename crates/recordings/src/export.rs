//! Series as files of other programs.

use crate::archive::crc32;
use std::fmt::Write as _;

/// A named column of numbers with its unit.
#[derive(Clone, Copy, Debug)]
pub struct NamedColumn<'a> {
    /// Name.
    pub name: &'a str,
    /// Unit; may be empty.
    pub unit: &'a str,
    /// Numbers.
    pub values: &'a [f64],
}

/// A CSV that studies read: `name[unit]` in the first line; missing samples are empty cells.
pub fn csv(columns: &[NamedColumn<'_>]) -> String {
    let head = |c: &NamedColumn<'_>| {
        let name = if c.unit.is_empty() { c.name.to_owned() } else { format!("{}[{}]", c.name, c.unit) };
        if name.contains([',', '"']) { format!("\"{}\"", name.replace('"', "")) } else { name }
    };
    let mut out = columns.iter().map(head).collect::<Vec<_>>().join(",") + "\n";
    for row in 0..columns.iter().map(|c| c.values.len()).max().unwrap_or(0) {
        for (i, c) in columns.iter().enumerate() {
            out.push_str(if i > 0 { "," } else { "" });
            if let Some(x) = c.values.get(row).filter(|x| x.is_finite()) {
                let _ = write!(out, "{x}");
            }
        }
        out.push('\n');
    }
    out
}

/// One value in a line, as `timeSeries Path -filePath` reads them.
pub fn path_file(values: &[f64]) -> String {
    values.iter().fold(String::new(), |mut out, x| {
        let _ = writeln!(out, "{x}");
        out
    })
}

/// An array of NumPy's format 1.0.
fn npy(values: &[f64]) -> Vec<u8> {
    let head = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({},), }}", values.len());
    // The data begin at a multiple of 64 bytes.
    let length = (10 + head.len() + 1).div_ceil(64) * 64 - 10;
    let mut out = b"\x93NUMPY\x01\x00".to_vec();
    out.extend_from_slice(&(length as u16).to_le_bytes());
    out.extend_from_slice(format!("{head:<width$}\n", width = length - 1).as_bytes());
    values.iter().for_each(|x| out.extend_from_slice(&x.to_le_bytes()));
    out
}

/// NumPy's archive of arrays, not compressed.
pub fn npz(columns: &[NamedColumn<'_>]) -> Vec<u8> {
    let (mut out, mut directory) = (vec![], vec![]);
    for c in columns {
        let (name, data) = (format!("{}.npy", c.name), npy(c.values));
        let offset = out.len() as u32;
        let mut fields = vec![];
        // Version 2.0, no flags, stored, 1 January 1980.
        for half in [20u16, 0, 0, 0, 0x21] {
            fields.extend_from_slice(&half.to_le_bytes());
        }
        for word in [crc32(&data), data.len() as u32, data.len() as u32] {
            fields.extend_from_slice(&word.to_le_bytes());
        }
        fields.extend_from_slice(&(name.len() as u16).to_le_bytes());
        fields.extend_from_slice(&0u16.to_le_bytes());
        out.extend_from_slice(b"PK\x03\x04");
        out.extend_from_slice(&fields);
        out.extend_from_slice(name.as_bytes());
        out.extend_from_slice(&data);
        directory.extend_from_slice(b"PK\x01\x02\x14\x00");
        directory.extend_from_slice(&fields);
        // No comment, disk 0, no attributes.
        directory.extend_from_slice(&[0; 10]);
        directory.extend_from_slice(&offset.to_le_bytes());
        directory.extend_from_slice(name.as_bytes());
    }
    let (start, n) = (out.len() as u32, columns.len() as u16);
    out.extend_from_slice(&directory);
    out.extend_from_slice(b"PK\x05\x06\0\0\0\0");
    out.extend_from_slice(&n.to_le_bytes());
    out.extend_from_slice(&n.to_le_bytes());
    out.extend_from_slice(&(directory.len() as u32).to_le_bytes());
    out.extend_from_slice(&start.to_le_bytes());
    out.extend_from_slice(&[0, 0]);
    out
}

#[cfg(test)]
mod tests {
    use super::{NamedColumn, csv, npz, path_file};
    use crate::archive::Zip;
    use crate::{Recording, Table};
    use hysteron_tcl::diagnostic::SourceMap;

    #[test]
    fn files_are_read_back() {
        let (t, x) = ([0.0, 0.01, 0.02], [1.5, f64::NAN, -2e-7]);
        let columns =
            [NamedColumn { name: "time", unit: "s", values: &t }, NamedColumn { name: "acc", unit: "g", values: &x }];
        let text = csv(&columns);
        let back = Recording::parse("f.csv", &text, &mut SourceMap::default()).expect("a recording");
        assert_eq!((back.times.as_slice(), back.columns[0].unit.as_str()), (&t[..], "g"));
        assert!(back.columns[0].values[1].is_nan() && back.columns[0].values[2] == -2e-7);
        assert_eq!(path_file(&t), "0\n0.01\n0.02\n");
        let archive = npz(&columns);
        let array = Zip::new(&archive).and_then(|z| z.read("time.npy")).expect("an array");
        assert_eq!(Table::read("time.npy", &array).expect("a table").columns, [t.to_vec()]);
    }
}
