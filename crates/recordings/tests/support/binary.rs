//! Binary formats and archives.

use super::zip::zip;
use super::{File, Known, Random};

fn file(name: &str, bytes: Vec<u8>, data: usize) -> Option<File> {
    Some(File { name: name.to_owned(), bytes, data, beside: None })
}

/// An array has no unit and no step: the test says them.
pub fn npy(k: &Known, r: &mut Random) -> Option<File> {
    let single = r.below(2) == 0;
    let big = r.below(2) == 0;
    let descr = format!("{}{}", if big { '>' } else { '<' }, if single { "f4" } else { "f8" });
    let head = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': ({},), }}", k.values.len());
    let length = (10 + head.len() + 1).div_ceil(64) * 64 - 10;
    let mut out = b"\x93NUMPY\x01\x00".to_vec();
    out.extend_from_slice(&(length as u16).to_le_bytes());
    out.extend_from_slice(format!("{head:<width$}\n", width = length - 1).as_bytes());
    let data = out.len();
    for x in &k.values {
        let mut bytes = if single { (*x as f32).to_le_bytes().to_vec() } else { x.to_le_bytes().to_vec() };
        if big {
            bytes.reverse();
        }
        out.extend(bytes);
    }
    file("a.npy", out, data)
}

fn mat_element(kind: u32, data: &[u8]) -> Vec<u8> {
    let mut out = kind.to_le_bytes().to_vec();
    out.extend_from_slice(&(data.len() as u32).to_le_bytes());
    out.extend_from_slice(data);
    out.resize(out.len().div_ceil(8) * 8, 0);
    out
}

fn mat_matrix(name: &str, values: &[f64]) -> Vec<u8> {
    let mut inner = mat_element(6, &[6, 0, 0, 0, 0, 0, 0, 0]);
    let dims: Vec<u8> = [values.len() as i32, 1].iter().flat_map(|n| n.to_le_bytes()).collect();
    inner.extend(mat_element(5, &dims));
    inner.extend(mat_element(1, name.as_bytes()));
    inner.extend(mat_element(9, &values.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>()));
    mat_element(14, &inner)
}

pub fn mat(k: &Known, r: &mut Random) -> Option<File> {
    let mut out = format!("{:<124}", "MATLAB 5.0 MAT-file, Platform: GLNXA64").into_bytes();
    out.extend_from_slice(&[0, 1, b'I', b'M']);
    let name = match k.word() {
        "velocity" => "vel",
        "displacement" => "disp",
        _ => "acc",
    };
    for matrix in [mat_matrix("dt", &[k.dt]), mat_matrix(name, &k.values)] {
        if r.below(2) == 0 {
            let packed = miniz_oxide::deflate::compress_to_vec_zlib(&matrix, 6);
            out.extend_from_slice(&15u32.to_le_bytes());
            out.extend_from_slice(&(packed.len() as u32).to_le_bytes());
            out.extend(packed);
        } else {
            out.extend(matrix);
        }
    }
    file("a.mat", out, 128)
}

pub fn sac(k: &Known, r: &mut Random) -> Option<File> {
    let little = r.below(2) == 0;
    let mut real = [-12345.0f32; 70];
    (real[0], real[5], real[57]) = (k.dt as f32, 0.0, 90.0);
    let mut whole = [-12345i32; 40];
    (whole[6], whole[9], whole[15], whole[35]) = (6, k.values.len() as i32, 1, 1);
    whole[16] = match k.word() {
        "velocity" => 7,
        "displacement" => 6,
        _ => 8,
    };
    let words = real.iter().map(|x| x.to_bits()).chain(whole.iter().map(|i| *i as u32));
    let ordered = |w: u32| if little { w.to_le_bytes() } else { w.to_be_bytes() };
    let mut out: Vec<u8> = words.flat_map(ordered).collect();
    out.extend_from_slice(format!("{:<8}{:<16}", "ABC", "-12345").as_bytes());
    (0..21).for_each(|_| out.extend_from_slice(b"-12345  "));
    let data = out.len();
    out.extend(k.values.iter().flat_map(|x| ordered((*x as f32).to_bits())));
    file("a.sac", out, data)
}

/// Records of 512 bytes of plain numbers, of either order of bytes. (Steim's frames have tests of their own.)
pub fn miniseed(k: &Known, r: &mut Random) -> Option<File> {
    let (little, single) = (r.below(2) == 0, r.below(2) == 0);
    let channel = match k.word() {
        "velocity" => "HHE",
        "displacement" => "HXE",
        _ => "HNE",
    };
    if r.below(3) == 0 {
        return miniseed3(k, channel);
    }
    let (size, encoding) = if single { (4, 4u8) } else { (8, 5) };
    let two = |x: u16| if little { x.to_le_bytes() } else { x.to_be_bytes() };
    let mut out = vec![];
    for (i, part) in k.values.chunks((512 - 64) / size).enumerate() {
        let mut record = format!("{:06}D ABC    {channel}XX", i + 1).into_bytes();
        // The time in units of 0.1 ms after 12:00:00 of day 60 of 2024.
        let ticks = (i * ((512 - 64) / size)) as u64 * (k.dt * 1e4).round() as u64;
        record.extend(two(2024));
        record.extend(two(60));
        record.extend([12, 0, (ticks / 10_000) as u8, 0]);
        record.extend(two((ticks % 10_000) as u16));
        record.extend(two(part.len() as u16));
        record.extend(two((1.0 / k.dt).round() as u16));
        record.extend(two(1));
        record.extend([0, 0, 0, 1, 0, 0, 0, 0]);
        record.extend(two(64));
        record.extend(two(48));
        record.extend(two(1000));
        record.extend(two(0));
        record.extend([encoding, u8::from(!little), 9, 0]);
        record.resize(64, 0);
        for x in part {
            let mut bytes = if single { (*x as f32).to_le_bytes().to_vec() } else { x.to_le_bytes().to_vec() };
            if !little {
                bytes.reverse();
            }
            record.extend(bytes);
        }
        record.resize(512, 0);
        out.extend(record);
    }
    file("a.mseed", out, 64)
}

/// Records of version 3 with their checksums.
fn miniseed3(k: &Known, channel: &str) -> Option<File> {
    let letters: Vec<String> = channel.chars().map(String::from).collect();
    let id = format!("FDSN:XX_ABC__{}", letters.join("_"));
    let mut out = vec![];
    for (i, part) in k.values.chunks(50).enumerate() {
        let nanoseconds = ((i * 50) as f64 * k.dt * 1e9).round() as u64;
        let mut record = b"MS\x03\0".to_vec();
        record.extend(((nanoseconds % 1_000_000_000) as u32).to_le_bytes());
        record.extend(2024u16.to_le_bytes());
        record.extend(60u16.to_le_bytes());
        record.extend([12, 0, (nanoseconds / 1_000_000_000) as u8, 5]);
        // A negative rate is the step.
        record.extend(if i % 2 == 0 { -k.dt } else { 1.0 / k.dt }.to_le_bytes());
        record.extend((part.len() as u32).to_le_bytes());
        record.extend([0; 4]);
        record.extend([1, id.len() as u8, 2, 0]);
        record.extend((8 * part.len() as u32).to_le_bytes());
        record.extend(id.as_bytes());
        record.extend(b"{}");
        record.extend(part.iter().flat_map(|x| x.to_le_bytes()));
        let mut sum = !0u32;
        for byte in &record {
            sum ^= u32::from(*byte);
            for _ in 0..8 {
                sum = if sum & 1 == 1 { sum >> 1 ^ 0x82f6_3b78 } else { sum >> 1 };
            }
        }
        record[28..32].copy_from_slice(&(!sum).to_le_bytes());
        out.extend(record);
    }
    file("a.mseed", out, 40 + id.len() + 2)
}

/// A header and the file of its values: one channel after another, side by side, or as text.
pub fn diadem(k: &Known, r: &mut Random) -> Option<File> {
    let name = column_name(k);
    let name = name.split('[').next()?;
    let n = k.values.len();
    let form = r.below(3);
    let (kind, method, data) = match form {
        0 => {
            let zeros = std::iter::repeat_n(0.0f64, 3).chain(k.values.iter().copied());
            ("REAL64", "CHANNEL", zeros.flat_map(f64::to_le_bytes).collect())
        }
        1 => {
            let pairs = k.values.iter().flat_map(|x| [0.0f32, *x as f32]);
            ("REAL32", "BLOCK", pairs.flat_map(f32::to_le_bytes).collect::<Vec<u8>>())
        }
        _ => ("ASCII", "BLOCK", k.values.iter().map(|x| format!("0;{x:.10}\n")).collect::<String>().into_bytes()),
    };
    let first = [4, 2, 1][form];
    let times = format!(
        "#BEGINCHANNELHEADER\n200,t\n202,{}\n210,IMPLICIT\n220,{n}\n240,0\n241,{}\n#ENDCHANNELHEADER\n",
        if r.below(2) == 0 { "s" } else { "ms" },
        "STEP"
    );
    let times = times.replace("STEP", &if times.contains(",ms") { k.dt * 1000.0 } else { k.dt }.to_string());
    let header = format!(
        "DIAEXTENDED  {{@:ENGLISH\n#BEGINGLOBALHEADER\n1,WINDOWS 32Bit\n#ENDGLOBALHEADER\n{times}#BEGINCHANNELHEADER\n\
         200,{name}\n202,{}\n210,EXPLICIT\n211,C:\\data\\a.bin\n213,{method}\n214,{kind}\n220,{n}\n221,{first}\n223,2\n\
         230,;\n231,.\n240,0\n241,1\n#ENDCHANNELHEADER\n",
        k.unit
    );
    let beside = Some(("a.bin".to_owned(), data));
    Some(File { beside, ..File::new("a.DAT", header, String::new()) })
}

fn column_name(k: &Known) -> String {
    let name = match k.word() {
        "velocity" => "vel",
        "displacement" => "disp",
        _ => "acc",
    };
    format!("{name}[{}]", k.unit)
}

pub fn xlsx(k: &Known, r: &mut Random) -> Option<File> {
    let shared = r.below(2) == 0;
    let stamps = r.below(2) == 0;
    let title = r.below(2) == 0;
    let cell = |place: &str, text: &str, index: usize| {
        if shared {
            format!("<c r=\"{place}\" t=\"s\"><v>{index}</v></c>")
        } else {
            format!("<c r=\"{place}\" t=\"inlineStr\"><is><t>{text}</t></is></c>")
        }
    };
    let head = column_name(k);
    let first = if title { 3 } else { 1 };
    let mut rows = String::new();
    if title {
        rows += &format!("<row r=\"1\">{}</row>", cell("A1", "A &amp; B", 2));
    }
    let names = cell(&format!("A{first}"), "time[s]", 0) + &cell(&format!("B{first}"), &head, 1);
    rows += &format!("<row r=\"{first}\">{names}</row>");
    for (i, x) in k.values.iter().enumerate() {
        let (row, t) = (first + i + 1, i as f64 * k.dt);
        // A time of day of a date: days since 30 December 1899, in the style of a date.
        let time = if stamps {
            format!("<c r=\"A{row}\" s=\"1\"><v>{:.13}</v></c>", 45292.5 + t / 86400.0)
        } else {
            format!("<c r=\"A{row}\"><v>{t:.4}</v></c>")
        };
        rows += &format!("<row r=\"{row}\">{time}<c r=\"B{row}\"><v>{x:.10}</v></c></row>");
    }
    let sheet = format!("<?xml version=\"1.0\"?><worksheet><sheetData>{rows}</sheetData></worksheet>");
    let strings = format!(
        "<sst><si><t>time[s]</t></si><si><r><t>{}</t></r><r><t>{}</t></r></si><si><t>A &amp; B</t></si></sst>",
        &head[..2],
        &head[2..]
    );
    let styles = "<styleSheet><numFmts><numFmt numFmtId=\"164\" formatCode=\"yyyy\\-mm\\-dd\\ hh:mm:ss.000\"/></numFmts>\
                  <cellXfs count=\"2\"><xf numFmtId=\"0\"/><xf numFmtId=\"164\"/></cellXfs></styleSheet>";
    let mut files = vec![
        ("[Content_Types].xml", b"<Types/>".to_vec(), false),
        ("xl/workbook.xml", b"<workbook/>".to_vec(), true),
        ("xl/styles.xml", styles.as_bytes().to_vec(), true),
        ("xl/worksheets/sheet1.xml", sheet.into_bytes(), true),
    ];
    if shared {
        files.push(("xl/sharedStrings.xml", strings.into_bytes(), true));
    }
    file("a.xlsx", zip(&files), 0)
}

pub fn ods(k: &Known, _: &mut Random) -> Option<File> {
    let text =
        |t: &str| format!("<table:table-cell office:value-type=\"string\"><text:p>{t}</text:p></table:table-cell>");
    let number = |x: String| {
        format!(
            "<table:table-cell office:value-type=\"float\" office:value=\"{x}\"><text:p>{x}</text:p></table:table-cell>"
        )
    };
    let mut rows = format!(
        "<table:table-row>{}{}<table:table-cell table:number-columns-repeated=\"1000\"/></table:table-row>",
        text("time[s]"),
        text(&column_name(k))
    );
    for (i, x) in k.values.iter().enumerate() {
        let cells = number(format!("{:.4}", i as f64 * k.dt)) + &number(format!("{x:.10}"));
        rows += &format!("<table:table-row>{cells}</table:table-row>");
    }
    rows += "<table:table-row table:number-rows-repeated=\"1048000\"><table:table-cell/></table:table-row>";
    let content = format!(
        "<office:document-content><table:table table:name=\"a\">{rows}</table:table></office:document-content>"
    );
    let kind = b"application/vnd.oasis.opendocument.spreadsheet".to_vec();
    file("a.ods", zip(&[("mimetype", kind, false), ("content.xml", content.into_bytes(), true)]), 0)
}
