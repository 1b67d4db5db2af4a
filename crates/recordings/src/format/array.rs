//! NumPy's arrays: `.npy` of one or two dimensions.

use super::{Format, Input};
use crate::content::Content;
use crate::fault::Fault;
use crate::sheet::{Column, Sheet};

pub(super) const NPY: Format = Format {
    name: "NumPy",
    recognised_by: "the bytes \\x93NUMPY",
    states: "nothing but the numbers: columns of an array of two dimensions",
    description: "NumPy Enhancement Proposal 1, a simple file format for NumPy arrays, versions 1 to 3",
    is: |input| input.bytes.starts_with(b"\x93NUMPY"),
    read,
};

/// Kind of the elements.
#[derive(Clone, Copy)]
pub(super) enum Element {
    F8,
    F4,
    Signed(usize),
    Unsigned(usize),
}

impl Element {
    pub(super) fn size(self) -> usize {
        match self {
            Self::F8 => 8,
            Self::F4 => 4,
            Self::Signed(n) | Self::Unsigned(n) => n,
        }
    }

    /// The number in the bytes of an element.
    pub(super) fn value(self, bytes: &[u8], little: bool) -> f64 {
        let mut all = [0u8; 8];
        let n = bytes.len().min(8);
        all[..n].copy_from_slice(&bytes[..n]);
        if !little {
            all[..n].reverse();
        }
        let whole = u64::from_le_bytes(all);
        match self {
            Self::F8 => f64::from_bits(whole),
            Self::F4 => f64::from(f32::from_bits(whole as u32)),
            Self::Unsigned(_) => whole as f64,
            Self::Signed(n) => {
                let shift = 64 - 8 * n as u32;
                ((whole << shift) as i64 >> shift) as f64
            }
        }
    }
}

fn read(input: &Input<'_>) -> Result<Content, Fault> {
    let short = || Fault::new("the file ends in its header");
    let bytes = input.bytes;
    let (length, start) = match bytes.get(6).ok_or_else(short)? {
        1 => {
            (usize::from(u16::from_le_bytes([*bytes.get(8).ok_or_else(short)?, *bytes.get(9).ok_or_else(short)?])), 10)
        }
        _ => {
            let four: [u8; 4] = bytes.get(8..12).and_then(|b| b.try_into().ok()).ok_or_else(short)?;
            (u32::from_le_bytes(four) as usize, 12)
        }
    };
    let header = bytes.get(start..start + length).ok_or_else(short)?;
    let header = String::from_utf8_lossy(header);
    let after = |key: &str| header.split_once(&format!("'{key}':")).map(|(_, rest)| rest.trim_start());
    let descr = after("descr").and_then(|d| d.strip_prefix('\'')?.split('\'').next());
    let descr = descr.ok_or_else(|| Fault::new("the array has fields").help("save a plain array of numbers"))?;
    let (order, kind) = descr.split_at_checked(1).ok_or_else(short)?;
    let element = match kind {
        "f8" => Element::F8,
        "f4" => Element::F4,
        "i1" | "i2" | "i4" | "i8" => Element::Signed(usize::from(kind.as_bytes()[1] - b'0')),
        "u1" | "u2" | "u4" | "u8" => Element::Unsigned(usize::from(kind.as_bytes()[1] - b'0')),
        _ => return Err(Fault::new(format!("the elements of the array are \"{descr}\"")).expected("expected numbers")),
    };
    let fortran = after("fortran_order").is_some_and(|f| f.starts_with("True"));
    let shape = after("shape").and_then(|s| s.strip_prefix('(')?.split(')').next()).ok_or_else(short)?;
    let shape: Option<Vec<usize>> =
        shape.split(',').map(str::trim).filter(|w| !w.is_empty()).map(|w| w.parse().ok()).collect();
    let (rows, columns) = match shape.as_deref() {
        Some([n]) => (*n, 1),
        Some([n, m]) => (*n, *m),
        _ => return Err(Fault::new("the array has not one or two dimensions")),
    };
    let data = &bytes[start + length..];
    let size = rows.checked_mul(columns).and_then(|n| n.checked_mul(element.size()));
    if size != Some(data.len()) {
        return Err(Fault::new(format!(
            "the header says {rows} by {columns} numbers, the file has {} bytes of them",
            data.len()
        )));
    }
    let cells: Vec<f64> = data.chunks_exact(element.size()).map(|b| element.value(b, order != ">")).collect();
    Ok(Content::Table(sheet(&cells, rows, columns, fortran)))
}

/// Columns of numbers in the order of rows, or of columns. The longer side is time.
pub(super) fn sheet(cells: &[f64], rows: usize, columns: usize, by_columns: bool) -> Sheet {
    let at = |i: usize, j: usize| if by_columns { cells[j * rows + i] } else { cells[i * columns + j] };
    let columns = if columns > rows {
        (0..rows).map(|i| (0..columns).map(|j| at(i, j)).collect()).collect::<Vec<Vec<f64>>>()
    } else {
        (0..columns).map(|j| (0..rows).map(|i| at(i, j)).collect()).collect()
    };
    let columns = columns.into_iter().map(|values| Column { values, ..Column::default() }).collect();
    Sheet { columns, ..Sheet::default() }
}
