//! The same data in other forms of files: each command gives the same result, or refuses the file and says what to do.

use super::Place;
use known::{Known, Random, WRITERS, zip::zip};
use std::fmt::Write as _;

#[path = "../../crates/recordings/tests/support/mod.rs"]
#[allow(dead_code, reason = "the tests of the reader use the rest")]
mod known;

/// A file, and another one that its header names.
type Files = Vec<(String, Vec<u8>)>;

/// Statements that a format lacks about a motion in a unit.
fn missing(format: &str) -> [bool; 2] {
    let unit = matches!(format, "NumPy" | "MATLAB" | "SAC" | "miniSEED" | "Tcl list" | "counted list");
    [unit, format == "NumPy"]
}

/// Peak acceleration in g of `hysteron motions`.
fn peak(place: &Place, args: &[&str]) -> Result<f64, String> {
    let (status, out, err) = place.run(&[&["motions"], args, &["--json"]].concat());
    if status != Some(0) {
        return Err(err);
    }
    let json: serde_json::Value = serde_json::from_str(&out).unwrap();
    json["motions"][0]["PGA"].as_f64().ok_or(out)
}

#[test]
fn a_motion_is_the_same_in_every_format() {
    let mut random = Random(3);
    for (format, write) in WRITERS {
        let k = Known::of("g", 0.3, 0.01, 200);
        let Some(file) = write(&k, &mut random) else { continue };
        let place = Place::new();
        place.write(&file.name, &file.bytes);
        if let Some((name, bytes)) = &file.beside {
            place.write(name, bytes);
        }
        let [no_unit, no_step] = missing(format);
        let mut args = vec![file.name.as_str()];
        for (is_missing, option, value) in [(no_step, "--dt", "0.01"), (no_unit, "--unit", "g")] {
            if is_missing {
                let asked = peak(&place, &args).expect_err("a question");
                assert!(asked.contains(&format!("add {option}")), "{format}: {asked}");
                args.extend([option, value]);
            }
        }
        let expected = k.values.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let got = peak(&place, &args).unwrap_or_else(|e| panic!("{format}: {e}"));
        assert!((got / expected - 1.0).abs() < 2e-5, "{format}: {got} for {expected}");
    }
}

#[test]
fn a_velocity_is_refused_or_differentiated_in_every_format() {
    let mut random = Random(5);
    for (format, write) in WRITERS {
        let k = Known::of("cm/s", 31.0, 0.01, 200);
        let Some(file) = write(&k, &mut random) else { continue };
        let place = Place::new();
        place.write(&file.name, &file.bytes);
        if let Some((name, bytes)) = &file.beside {
            place.write(name, bytes);
        }
        let [no_unit, no_step] = missing(format);
        let mut args = vec![file.name.as_str()];
        args.extend(no_step.then_some(["--dt", "0.01"]).into_iter().flatten());
        args.extend(no_unit.then_some(["--unit", "cm/s"]).into_iter().flatten());
        // A file with accelerations beside the velocities is a motion.
        match peak(&place, &args) {
            Err(refused) => assert!(refused.contains("needs accelerations"), "{format}: {refused}"),
            Ok(_) => assert!(matches!(*format, "CSMIP" | "COSMOS"), "{format}"),
        }
        args.push("--differentiate");
        let derived = hysteron::recordings::convert::derivative(&k.values, 0.01);
        let expected = derived.iter().fold(0.0f64, |m, x| m.max(x.abs())) / 980.665;
        let got = peak(&place, &args).unwrap_or_else(|e| panic!("{format}: {e}"));
        assert!((got / expected - 1.0).abs() < 1e-4, "{format}: {got} for {expected}");
    }
}

/// Columns of a test: name, unit, values.
type Test<'a> = [(&'a str, &'a str, Vec<f64>)];

/// A sine of displacement in mm and the force of a pad in kN.
fn sheared() -> Vec<(&'static str, &'static str, Vec<f64>)> {
    let at = |i: i32| std::f64::consts::TAU * f64::from(i) / 100.0;
    let of = |f: &dyn Fn(i32) -> f64| (0..=300).map(|i| (1e6 * f(i)).round() / 1e6).collect::<Vec<f64>>();
    vec![
        ("time", "s", of(&|i| f64::from(i) / 50.0)),
        ("disp", "mm", of(&|i| 120.0 * at(i).sin())),
        ("force", "kN", of(&|i| 60.0 * at(i).sin() + 20.0 * at(i).cos())),
    ]
}

/// Rows of cells, the heads first.
fn rows(test: &Test<'_>, separator: &str, decimal: &str, head: impl Fn(&str, &str) -> String) -> String {
    let heads: Vec<String> = test.iter().map(|(name, unit, _)| head(name, unit)).collect();
    let mut out = heads.join(separator) + "\n";
    for i in 0..test[0].2.len() {
        let cells: Vec<String> = test.iter().map(|(_, _, v)| v[i].to_string().replace('.', decimal)).collect();
        let _ = writeln!(out, "{}", cells.join(separator));
    }
    out
}

fn workbook(test: &Test<'_>) -> Vec<u8> {
    let column = |i: usize| char::from(b'A' + i as u8);
    let mut sheet = String::from("<worksheet><sheetData><row r=\"1\">");
    for (i, (name, unit, _)) in test.iter().enumerate() {
        let _ = write!(sheet, "<c r=\"{}1\" t=\"inlineStr\"><is><t>{name} [{unit}]</t></is></c>", column(i));
    }
    sheet += "</row>";
    for row in 0..test[0].2.len() {
        let _ = write!(sheet, "<row r=\"{}\">", row + 2);
        for (i, (_, _, values)) in test.iter().enumerate() {
            let _ = write!(sheet, "<c r=\"{}{}\"><v>{}</v></c>", column(i), row + 2, values[row]);
        }
        sheet += "</row>";
    }
    sheet += "</sheetData></worksheet>";
    let book = "<workbook xmlns:r=\"r\"><sheets><sheet name=\"S\" sheetId=\"1\" r:id=\"rId1\"/></sheets></workbook>";
    let links = "<Relationships><Relationship Id=\"rId1\" Target=\"worksheets/sheet1.xml\"/></Relationships>";
    zip(&[
        ("xl/workbook.xml", book.into(), false),
        ("xl/_rels/workbook.xml.rels", links.into(), false),
        ("xl/worksheets/sheet1.xml", sheet.into_bytes(), true),
    ])
}

fn diadem(test: &Test<'_>) -> Files {
    let n = test[0].2.len();
    let header = test.iter().enumerate().fold(String::new(), |out, (i, (name, unit, _))| {
        out + &format!(
            "#BEGINCHANNELHEADER\n200,{name}\n202,{unit}\n210,EXPLICIT\n211,t.R64\n213,CHANNEL\n214,REAL64\n220,{n}\n\
             221,{}\n240,0\n241,1\n#ENDCHANNELHEADER\n",
            1 + i * n
        )
    });
    let values = test.iter().flat_map(|(_, _, v)| v).flat_map(|x| x.to_le_bytes()).collect();
    vec![("t.DAT".into(), header.into_bytes()), ("t.R64".into(), values)]
}

/// A test in the forms that laboratories have. The first file of a form is the one to read.
fn forms(test: &Test<'_>) -> Vec<Files> {
    let bracketed = |name: &str, unit: &str| format!("{name} [{unit}]");
    let german = rows(test, ";", ",", bracketed);
    let utf16 = |text: &str| {
        let units = text.encode_utf16().flat_map(u16::to_le_bytes);
        [0xff, 0xfe].into_iter().chain(units).collect::<Vec<u8>>()
    };
    let below = rows(test, "\t", ".", |name, _| name.to_owned());
    let units = test.iter().map(|t| t.1).collect::<Vec<_>>().join("\t");
    let below = below.replacen('\n', &format!("\n{units}\n"), 1);
    let milliseconds: Vec<_> = test
        .iter()
        .map(|(name, unit, v)| match *unit {
            "s" => (*name, "ms", v.iter().map(|t| 1000.0 * t).collect()),
            _ => (*name, *unit, v.clone()),
        })
        .collect();
    let json = test.iter().map(|(name, unit, v)| format!("\"{name}[{unit}]\": {v:?}")).collect::<Vec<_>>().join(",\n");
    let one = |name: &str, bytes: Vec<u8>| vec![(name.to_owned(), bytes)];
    vec![
        one("plain.csv", rows(test, ",", ".", bracketed).into_bytes()),
        one("german.csv", utf16(&german)),
        one("latin.csv", german.into_bytes()),
        one("below.txt", below.clone().into_bytes()),
        one("mts.txt", format!("MTS793|MPT|ENU|1|2|.|/|:|1|0|0|A\n\nData: Timed\t\tTime: 8.0 Sec\n\n{below}").into()),
        one("ms.csv", rows(&milliseconds, ",", ".", |name, unit| format!("{name}[{unit}]")).into_bytes()),
        one("t.json", format!("{{{json}}}").into_bytes()),
        one("t.xlsx", workbook(test)),
        diadem(test),
    ]
}

/// Run a command on each form of a test; its outputs are those of the first.
fn same_in_each_form(test: &Test<'_>, command: impl Fn(&Place, &str) -> String) {
    let mut plain: Option<String> = None;
    for form in forms(test) {
        let place = Place::new();
        form.iter().for_each(|(name, bytes)| place.write(name, bytes));
        let name = &form[0].0;
        // Tables are as wide as the name of the file.
        let said = command(&place, name).replace(name, "FILE");
        let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
        let plain = plain.get_or_insert_with(|| said.clone());
        assert_eq!(&said, plain, "{name}");
    }
}

fn done(place: &Place, args: &[&str]) -> String {
    let (status, out, err) = place.run(args);
    assert_eq!(status, Some(0), "{args:?}: {err}");
    // A command that is done may warn, but of the same.
    out + &err
}

#[test]
fn loops_and_prototypes_are_the_same_in_each_form() {
    same_in_each_form(&sheared(), |place, file| {
        done(place, &["loops", file, "-u", "disp", "-f", "force", "-t", "time", "--units", "kN", "mm"])
    });
    same_in_each_form(&sheared(), |place, file| {
        let columns = ["-u", "disp", "-f", "force", "-t", "time"];
        done(place, &[&["prototype", file], &columns[..], &["--units", "kN", "mm"]].concat())
    });
}

/// `--units` names the units of the results: columns in others are converted, and another quantity is refused.
#[test]
fn units_of_results_convert_columns() {
    let place = Place::new();
    place.write("t.csv", rows(&sheared(), ",", ".", |name, unit| format!("{name}[{unit}]")));
    let amplitude = |unit: &str, factor: &[&str]| {
        let args = ["loops", "t.csv", "-u", "disp", "-f", "force", "--table", "json", "--units", "kN", unit];
        let out = done(&place, &[&args[..], factor].concat());
        let json: serde_json::Value = serde_json::from_str(&out).unwrap();
        json[0]["amplitude"].as_f64().unwrap()
    };
    for (unit, factor, expected) in
        [("mm", &[][..], 120.0), ("m", &[], 0.12), ("m", &["--displacement-factor", "0.001"], 0.12), ("x", &[], 120.0)]
    {
        assert!((amplitude(unit, factor) / expected - 1.0).abs() < 1e-6, "{unit} {factor:?}");
    }
    let (status, _, err) = place.run(&["loops", "t.csv", "-u", "time", "-f", "force", "--units", "kN", "mm"]);
    assert!(status == Some(2) && err.contains("\"time\" is a time in s, and is wanted in mm"), "{err}");
}

#[test]
fn a_bearing_follows_a_recording_in_each_form() {
    let device = "model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 0\nuniaxialMaterial Elastic 1 500\n\
                  uniaxialMaterial Elastic 2 1e6\nelement zeroLength 1 1 2 -mat 1 2 2 -dir 1 2 6\n";
    let force = |place: &Place, file: &str, units: &[&str]| {
        place.write("b.tcl", device);
        done(place, &[&["bearing", "b.tcl", "--recording", file, "-o", "out", "--table", "json"], units].concat())
    };
    same_in_each_form(&sheared(), |place, file| {
        let out = force(place, file, &["--units", "kN", "m"]);
        let json: serde_json::Value = serde_json::from_str(&out).unwrap();
        // 120 mm and 500 kN/m.
        assert!((json[0]["F_max"].as_f64().unwrap() / 60.0 - 1.0).abs() < 1e-6, "{out}");
        out
    });
    let place = Place::new();
    place.write("b.tcl", device);
    place.write("t.csv", rows(&sheared(), ",", ".", |name, unit| format!("{name}[{unit}]")));
    for (args, said) in [
        (&["--channel", "force"][..], "force is force, and a path needs displacements"),
        (&["--channel", "weg"], "there is no channel \"weg\": they are disp, force"),
        (&["--dt", "0.1"], "told"),
        (&["-a", "1"], "cannot be used with"),
    ] {
        let (status, _, err) = place.run(&[&["bearing", "b.tcl", "--recording", "t.csv"], args].concat());
        let agrees = err.contains(said) || said == "told" && err.contains("is told 0.1 s");
        assert!(status == Some(2) && agrees, "{args:?}: {err}");
    }
}

const SCRIPT: &str = "model basic -ndm 1 -ndf 1\nnode 1 0.0\nnode 2 0.0\nfix 1 1\npset k 0.4\nuniaxialMaterial Elastic 1 $k\n\
    element zeroLength 1 1 2 -mat 1 -dir 1\ntimeSeries Path 1 -dt 0.02 -values {";

const STUDY: &str = "model = \"model.tcl\"\n\n[[parameter]]\nname = \"k\"\nlower = 0.2\nupper = 2.0\n\n[[run]]\n\
    name = \"test\"\nrecording = \"FILE\"\n\n[[run.observe]]\nchannel = \"force\"\noutput = \"force.out\"\ncolumn = 2\n";

#[test]
fn studies_read_each_form_alike() {
    let test = sheared();
    let path = test[1].2.iter().map(f64::to_string).collect::<Vec<_>>().join(" ");
    let model = format!(
        "{SCRIPT}{path}}}\npattern Plain 1 1 {{sp 2 1 1.0}}\n\
         recorder Element -file force.out -time -ele 1 force\nconstraints Transformation\nnumberer Plain\n\
         system ProfileSPD\ntest NormDispIncr 1.0e-9 50\nalgorithm Linear\nintegrator LoadControl 0.02\n\
         analysis Static\nanalyze 300\n"
    );
    same_in_each_form(&test, |place, file| {
        place.write("model.tcl", &model);
        place.write("study.toml", STUDY.replace("FILE", file));
        let checked = done(place, &["check", "study.toml"]);
        let fitted = done(place, &["calibrate", "study.toml", "--json", "--threads", "1"]);
        let json: serde_json::Value =
            serde_json::from_str(fitted.split("\n}").next().unwrap_or("").trim()).unwrap_or_default();
        checked + &json["parameters"].to_string()
    });
}

#[test]
fn isolation_studies_read_each_form_alike() {
    let inputs = concat!(env!("CARGO_MANIFEST_DIR"), "/tcl-like-inputs/isolation_study");
    let text = |file: &str| std::fs::read_to_string(format!("{inputs}/{file}")).unwrap();
    let study =
        text("study.toml").replace("[[0.0, 0.0], [0.05, 0.05]]", "[[0.0, 0.0]]").replace("runs = 10", "runs = 2");
    let (before, rest) = study.split_once("[[motion]]").unwrap();
    let after = rest.split_once("[intensity]").map_or("", |(_, rest)| rest);
    let mut random = Random(9);
    let k = Known::of("g", 0.3, 0.01, 200);
    let mut displacements: Vec<(String, f64)> = vec![];
    for (format, write) in
        WRITERS.iter().filter(|w| matches!(w.0, "PEER" | "K-NET" | "table" | "xlsx" | "NumPy" | "DIAdem"))
    {
        let place = Place::new();
        place.write("building.tcl", text("building.tcl"));
        let file = write(&k, &mut random).unwrap();
        place.write(&file.name, &file.bytes);
        if let Some((name, bytes)) = &file.beside {
            place.write(name, bytes);
        }
        let keys = if *format == "NumPy" { "unit = \"g\"\ndt = 0.01\n" } else { "" };
        let motion = format!("[[motion]]\nfiles = [\"{}\"]\n{keys}", file.name);
        place.write("study.toml", format!("{before}{motion}\n[intensity]{after}"));
        let json = |command: &str| -> serde_json::Value {
            let (status, out, err) = place.run(&[command, "study.toml", "--out", command, "--json", "--threads", "1"]);
            assert_eq!(status, Some(0), "{format}: {err}");
            serde_json::from_str(&out).unwrap()
        };
        let analyses = json("isolate")["analyses"].clone();
        let displacement = analyses[0]["bearings"][0]["displacement"].as_f64();
        displacements.push(((*format).to_owned(), displacement.unwrap_or_else(|| panic!("{analyses}"))));
        let _ = json("ida");
    }
    let first = displacements[0].1;
    assert!(displacements.iter().all(|(_, d)| (d / first - 1.0).abs() < 1e-4), "{displacements:?}");
}
