//! Tables, lists, and exports of programs.

use super::{File, Known, Random};

fn quantity_head(k: &Known, r: &mut Random) -> String {
    let name = match k.word() {
        "velocity" => r.of(&["vel", "Velocity", "VEL X"]),
        "displacement" => r.of(&["disp", "Displacement", "Weg"]),
        _ => r.of(&["acc", "Acceleration", "Acc Y"]),
    };
    match r.below(3) {
        0 => format!("{name}[{}]", k.unit),
        1 => format!("{name} ({})", k.unit),
        _ => format!("{name}_{}", k.unit),
    }
}

/// Name of the time, factor of its unit, and digits.
const TIMES: &[(&str, f64, usize)] = &[
    ("time[s]", 1.0, 4),
    ("Time (ms)", 1000.0, 1),
    ("time_ms", 1000.0, 2),
    ("t", 1.0, 5),
    ("time_min", 1.0 / 60.0, 12),
    ("Zeit [s]", 1.0, 3),
];

pub fn csv(k: &Known, r: &mut Random) -> Option<File> {
    let separator = r.of(&[",", ";", "\t", " "]);
    let comma = (separator == ";" || separator == "\t") && r.below(2) == 0;
    let number = |x: f64, digits: usize| {
        let text = if digits == 99 { format!("{x:.9e}") } else { format!("{x:.digits$}") };
        if comma { text.replace('.', ",") } else { text }
    };
    let (time, factor, digits) = r.of(TIMES);
    let trailing = if separator == " " { String::new() } else { separator.repeat(r.below(3)) };
    let end = r.of(&["\n", "\r\n"]);
    let (head, exponents) = (quantity_head(k, r), r.below(2) == 0);
    let units_below = r.below(4) == 0;
    let quoted = |s: &str| if separator == " " || s.contains(separator) { format!("\"{s}\"") } else { s.to_owned() };
    let mut header =
        r.of(&["", "# a comment\n", "sep=;\n"]).replace("sep=;", if separator == ";" { "sep=;" } else { "#" });
    if units_below {
        let (name, unit) = match k.word() {
            "velocity" => ("vel", k.unit),
            "displacement" => ("disp", k.unit),
            _ => ("acc", k.unit),
        };
        header += &format!("time{separator}{name}{trailing}{end}s{separator}{unit}{trailing}{end}");
    } else if separator == " " {
        // Blanks within names need two blanks or brackets between columns.
        header += &format!("time[s] {}{end}", head.replace(' ', ""));
    } else {
        header += &format!("{}{separator}{}{trailing}{end}", quoted(time), quoted(&head));
    }
    let plain = units_below || separator == " ";
    let row = |(i, x): (usize, &f64)| {
        let t = i as f64 * k.dt;
        let t = if plain { number(t, 4) } else { number(t * factor, digits) };
        format!("{t}{separator}{}{trailing}{end}", number(*x, if exponents { 99 } else { 10 }))
    };
    let data: String = k.values.iter().enumerate().map(row).collect();
    let mut file = File::new("table.csv", header, data);
    match r.below(4) {
        0 => {
            file.bytes.splice(0..0, [0xef, 0xbb, 0xbf]);
            file.data += 3;
        }
        1 => {
            let text = String::from_utf8_lossy(&file.bytes).into_owned();
            let wide = std::iter::once('\u{feff}').chain(text.chars()).collect::<String>();
            file.bytes = wide.encode_utf16().flat_map(u16::to_le_bytes).collect();
            file.data = 2 * file.data + 2;
        }
        _ => {}
    }
    Some(file)
}

fn rows(k: &Known, separator: &str) -> String {
    k.values.iter().enumerate().map(|(i, x)| format!("{:.4}{separator}{x:.10}\n", i as f64 * k.dt)).collect()
}

fn column_name(k: &Known) -> &'static str {
    match k.word() {
        "velocity" => "Velocity",
        "displacement" => "Disp",
        _ => "Acceleration",
    }
}

pub fn mts(k: &Known, _: &mut Random) -> Option<File> {
    let name = column_name(k);
    let header = format!(
        "MTS793|MPT|ENU|1|2|.|/|:|1|0|0|A\n\nData Acquisition: Timed\t\t\tTime: 8.0 Sec 3/4/2024 10:00:00 AM\n\n\
         Time\t{name}\nSec\t{}\n",
        k.unit
    );
    Some(File::new("specimen.dat", header, rows(k, "\t")))
}

pub fn seismosignal(k: &Known, r: &mut Random) -> Option<File> {
    let gap = r.of(&["\t", "    "]);
    let header = format!("SeismoSignal v5.1 - Output\n\nTime [sec]{gap}{} [{}]\n", column_name(k), k.unit);
    Some(File::new("out.txt", header, rows(k, gap)))
}

pub fn labview(k: &Known, r: &mut Random) -> Option<File> {
    let comma = r.below(2) == 0;
    let times = r.below(2) == 0;
    let name = column_name(k);
    let header = format!(
        "LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\nDecimal_Separator\t{}\n\
         Multi_Headings\tNo\nX_Columns\t{}\n***End_of_Header***\t\n\nChannels\t1\nSamples\t{}\nY_Unit_Label\t{}\n\
         X_Dimension\tTime\nX0\t0.0\nDelta_X\t{}\n***End_of_Header***\nX_Value\t{name}\tComment\n",
        if comma { ',' } else { '.' },
        if times { "One" } else { "No" },
        k.values.len(),
        k.unit,
        k.dt,
    );
    let data = if times { rows(k, "\t") } else { k.values.iter().map(|x| format!("\t{x:.10}\n")).collect() };
    Some(File::new("a.lvm", header, if comma { data.replace('.', ",") } else { data }))
}

pub fn tcl(k: &Known, r: &mut Random) -> Option<File> {
    let list: String =
        k.values.chunks(8).map(|c| c.iter().map(|x| format!("{x:.10} ")).collect::<String>() + "\\\n").collect();
    let (header, data) = match r.below(3) {
        0 => (format!("# a record\nset dt {}\nset acc {{\\\n", k.dt), format!("{list}}}\n")),
        1 => (format!("timeSeries Path 1 -dt {} -values {{\\\n", k.dt), format!("{list}}} -factor 1.0\n")),
        _ => (format!("set dt {}; # step\nset values [list \\\n", k.dt), format!("{}]\n", list)),
    };
    Some(File::new("record.tcl", header, data))
}

pub fn counted(k: &Known, r: &mut Random) -> Option<File> {
    let per_line = r.of(&[1, 5, 8]);
    let data = k.values.chunks(per_line).map(|c| c.iter().map(|x| format!(" {x:.10}")).collect::<String>() + "\n");
    Some(File::new("record.txt", format!("{} {}\n", k.values.len(), k.dt), data.collect()))
}

pub fn json(k: &Known, r: &mut Random) -> Option<File> {
    let values = k.values.iter().map(|x| format!("{x:.10}")).collect::<Vec<_>>().join(", ");
    let times = (0..k.values.len()).map(|i| format!("{:.4}", i as f64 * k.dt)).collect::<Vec<_>>().join(", ");
    let name = column_name(k).to_lowercase();
    let text = match r.below(4) {
        0 => format!("{{\"time\": [{times}], \"{name}[{}]\": [{values}]}}", k.unit),
        1 => format!("{{\"dt\": {}, \"unit\": \"{}\", \"values\": [{values}]}}", k.dt, k.unit),
        2 => format!(
            "{{\"dt\": {}, \"channels\": [{{\"name\": \"a\", \"unit\": \"{}\", \"values\": [{values}]}}]}}",
            k.dt, k.unit
        ),
        _ => {
            let row =
                |(i, x): (usize, &f64)| format!("{{\"time\": {:.4}, \"{name}_{}\": {x:.10}}}", i as f64 * k.dt, k.unit);
            format!("[{}]", k.values.iter().enumerate().map(row).collect::<Vec<_>>().join(","))
        }
    };
    Some(File::new("a.json", String::new(), text))
}
