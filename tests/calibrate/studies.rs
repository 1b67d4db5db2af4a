//! Tests of reading studies and recordings, and of the locations of their errors.

use super::StudyFolder;
use hysteron::diagnostic::SourceMap;
use hysteron::study::{Role, Setting, Study};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// The error of a study: its location, and its message with help.
fn load_error(folder: &StudyFolder) -> (String, String) {
    let mut sources = SourceMap::default();
    let d = Study::load(&folder.study(), &mut sources).unwrap_err();
    let at = d.span.map(|s| sources.location(s)).map(|l| {
        let file = l.name.rsplit('/').next().unwrap_or_default().to_owned();
        format!("{file}:{}:{}", l.line, l.column)
    });
    (at.unwrap_or_default(), format!("{}; {}; {}", d.message, d.label, d.help.join("; ")))
}

#[test]
fn study_errors_have_their_location() {
    for (old, new, at, said) in [
        ("lower = 1.0", "lover = 1.0", "study.toml:7:1", "did you mean \"lower\""),
        ("lower = 1.0", "lower = one", "study.toml:7:9", ""),
        ("lower = 1.0", "lower = \"1\"", "study.toml:7:9", "invalid type"),
        (
            "upper = 5.0",
            "upper = 0.5",
            "study.toml:8:9",
            "the upper bound of k0 is 0.5; expected more than the lower bound",
        ),
        ("upper = 5.0\n", "", "study.toml:6:9", "parameter k0 has no upper bound"),
        ("lower = 5.0", "lower = -5.0", "study.toml:12:9", "the lower bound of Qd is -5"),
        ("scale = \"log\"", "scale = \"lag\"", "study.toml:14:9", "did you mean \"log\""),
        ("name  = \"Qd\"", "name  = \"k0\"", "study.toml:11:9", "two parameters \"k0\""),
        (
            "role      = \"fit\"",
            "role = \"train\"",
            "study.toml:23:8",
            "unknown role \"train\"; expected fit or holdout",
        ),
        ("role      = \"fit\"", "role = \"holdout\"", "study.toml:3:9", "no run has the role \"fit\""),
        ("growing.csv", "growin.csv", "study.toml:24:13", "cannot read growin.csv"),
        ("pad.tcl", "bad.tcl", "study.toml:3:9", "there is no script bad.tcl"),
        ("channel = \"force\"", "channel = \"forces\"", "study.toml:28:11", "did you mean \"force\""),
        ("\"pad.tcl\"", "\"pad.tcl\"\nmaterial = \"concret\"", "study.toml:4:12", "did you mean \"concrete\""),
        ("column  = 2", "column  = -2", "study.toml:30:11", "the column is -2"),
        ("column  = 2", "column  = 2\nweight = -1.0", "study.toml:31:10", "the weight is -1"),
        ("{ motion", "{ k0 = 1.0, motion", "study.toml:25:15", "k0 is set in run \"growing\" and is a parameter"),
        ("name      = \"random\"", "name = \"growing\"", "study.toml:34:8", "two runs named \"growing\""),
        ("lower = 1.0\nupper = 5.0", "expr = \"Qd/alfa\"", "study.toml:7:8", "there is no parameter alfa"),
        ("lower = 1.0\nupper = 5.0", "expr = \"2*k0\"", "study.toml:6:9", "depends on itself"),
        ("lower = 1.0\nupper = 5.0", "expr = \"2*(Qd\"", "study.toml:7:8", "is no formula"),
        ("lower = 1.0\nupper = 5.0", "expr = \"Qd\"\nvalue = 2.0", "study.toml:6:9", "both a value and a formula"),
        (
            "column  = 2",
            "column  = 2\nfactor = 0.0",
            "study.toml:31:10",
            "the factor is 0; expected a number other than 0",
        ),
        ("column  = 2", "column  = 2\nfactor = inf", "study.toml:31:10", "the factor is inf"),
        ("column  = 2", "column  = 2\nshift = nan", "study.toml:31:9", "the shift is NaN"),
        (
            "column  = 2",
            "column  = 2\nunit = \"kNn\"",
            "study.toml:31:8",
            "unknown unit \"kNn\"; expected the unit of the output; did you mean \"kN\"?",
        ),
        (
            "column  = 2",
            "column  = 2\nunit = \"mm\"",
            "study.toml:31:8",
            "force of growing.csv is a force in kN, and mm is a length; expected a unit of force",
        ),
    ] {
        let (location, message) = load_error(&StudyFolder::edited("study.toml", old, new));
        assert_eq!(location, at, "{new}: {message}");
        assert!(message.contains(said), "{new}: {message}");
    }
    let folder = StudyFolder::new();
    fs::write(folder.study(), "model = \"pad.tcl\"\n[calibration]\nF = 3\n").unwrap();
    assert!(load_error(&folder).1.contains("no parameter is to be found"));
}

#[test]
fn recording_errors_have_their_location() {
    for (old, new, at, said) in [
        ("time[s]", "x[s]", "growing.csv:1:1", "expected time[s]"),
        ("time[s]", "time[kN]", "growing.csv:1:1", "expected time[s]"),
        ("disp[mm]", "force[N]", "growing.csv:1:19", "has no name of its own"),
        ("0.0260,", "O.0260,", "growing.csv:2:1", "the time is not a number"),
        ("0.0460,", "0.0260,", "growing.csv:3:1", "the time goes from 0.026 to 0.026"),
        ("0.0460,", "0.0460,1.2.3", "growing.csv:3:8", "force is not a number"),
        ("0.0460,", "0.0460,7,", "growing.csv:3:1", "has 5 cells, its header 4"),
    ] {
        let (location, message) = load_error(&StudyFolder::edited("growing.csv", old, new));
        assert_eq!(location, at, "{new}: {message}");
        assert!(message.contains(said), "{new}: {message}");
    }
}

#[test]
fn study_is_read_with_its_parameters_and_runs() {
    let folder = StudyFolder::new();
    folder.edit("study.toml", "upper = 0.4", "upper = 0.4\n[[parameter]]\nname = \"uy\"\nexpr = \"Qd/((1-alpha)*k0)\"");
    let study = Study::load(&folder.study(), &mut SourceMap::default()).unwrap();
    assert_eq!(study.space.dimension(), 3);
    let values = study.space.values_at(&[0.25, 0.5, 1.0]).unwrap();
    let qd = 250f64.sqrt();
    for (v, expected) in values.iter().zip([2.0, qd, 0.4, qd / 0.6 / 2.0]) {
        assert!((v - expected).abs() < 1e-12 * expected, "{values:?}");
    }
    let back = study.space.unit_point(&values);
    assert!(back.iter().zip([0.25, 0.5, 1.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{back:?}");
    let run = &study.runs[0];
    assert_eq!((run.role, study.runs[1].role), (Role::Fit, Role::Holdout));
    assert!(run.set.contains(&("npts".into(), Setting::Whole(501))));
    assert!(run.set.contains(&("dt".into(), Setting::Number(0.02))));
    let o = &run.observe[0];
    assert_eq!((o.unit.as_str(), o.values.iter().filter(|v| v.is_nan()).count()), ("kN", 3));
    assert_eq!(study.warnings.len(), 1);
    assert_eq!(run.recording.column("temperature").unwrap().unit, "degC");
}

/// Samples, variance and unit of the first channel of the first run.
fn first_channel(folder: &StudyFolder) -> (Vec<f64>, f64, String) {
    let study = Study::load(&folder.study(), &mut SourceMap::default()).unwrap();
    let o = &study.runs[0].observe[0];
    (o.values.iter().copied().filter(|v| !v.is_nan()).collect(), o.variance, o.unit.clone())
}

#[test]
fn channels_are_converted_by_unit_factor_and_offset() {
    let (recorded, variance, unit) = first_channel(&StudyFolder::new());
    assert_eq!(unit, "kN");
    for (keys, factor, offset, unit) in [
        ("unit = \"kN\"", 1.0, 0.0, "kN"),
        ("unit = \"N\"", 1e3, 0.0, "N"),
        ("unit = \"kip\"\nfactor = -1.0", -1.0 / 4.4482216152605, 0.0, "kip"),
        ("factor = -1\noffset = 2.5", -1.0, 2.5, "kN"),
        ("factor = 1000.0", 1e3, 0.0, "N"),
        ("factor = 1.07", 1.07, 0.0, "kN"),
        ("factor = 1.0\noffset = 0\nshift = 0.0", 1.0, 0.0, "kN"),
    ] {
        let folder = StudyFolder::edited("study.toml", "column  = 2", &format!("column  = 2\n{keys}"));
        let (values, v, u) = first_channel(&folder);
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs().max(1e-3);
        assert!(values.iter().zip(&recorded).all(|(a, x)| close(*a, factor * x + offset)), "{keys}");
        assert!((v / (factor * factor * variance) - 1.0).abs() < 1e-9, "{keys}: {v}");
        assert_eq!(u, unit, "{keys}");
        if factor == 1.0 {
            assert_eq!((&values, v), (&recorded, variance), "{keys}: the same bits");
        }
    }
    // The unit of the header is stated alone: nothing is converted.
    let folder = StudyFolder::edited("study.toml", "column  = 2", "column  = 2\nunit = \"N\"");
    folder.edit("growing.csv", "force[kN]", "force");
    assert_eq!(first_channel(&folder), (recorded, variance, "N".into()));
    // A unit of the header that is not known cannot be converted.
    folder.edit("growing.csv", "force", "force[V]");
    let (at, message) = load_error(&folder);
    assert_eq!(at, "study.toml:31:8");
    assert!(message.contains("the unit of force in growing.csv is not known: \"V\""), "{message}");
}

/// A recording without times, units and names is read with what its run says.
#[test]
fn runs_say_what_their_recordings_do_not() {
    let folder = StudyFolder::new();
    let study = fs::read_to_string(folder.study()).unwrap();
    let known = Study::load(&folder.study(), &mut SourceMap::default()).unwrap();
    let recording = &known.runs[0].recording;
    let dt = recording.times[1] - recording.times[0];
    let row = |i: usize| recording.columns.iter().map(|c| c.values[i].to_string()).collect::<Vec<_>>().join(" ") + "\n";
    let bare: String = (0..recording.times.len()).map(row).collect();
    fs::write(folder.study().with_file_name("bare.txt"), bare).unwrap();
    let column = recording.columns.iter().position(|c| c.name == "force").unwrap() + 1;
    let with = |keys: &str| {
        let text = study.replacen("growing.csv\"", &format!("bare.txt\"\n{keys}"), 1);
        assert_ne!(text, study);
        let text = text.replacen("channel = \"force\"", &format!("channel = \"{column}\""), 1);
        fs::write(folder.study(), text).unwrap();
    };
    with(&format!("dt = {dt}\nlayout = \"columns\"\nunit = \"kN\""));
    let read = Study::load(&folder.study(), &mut SourceMap::default()).unwrap();
    let bits = |of: &[f64]| of.iter().map(|x| x.to_bits()).collect::<Vec<u64>>();
    let (bare, named) = (&read.runs[0].recording.columns[column - 1], &recording.columns[column - 1]);
    assert_eq!(bits(&bare.values), bits(&named.values));
    assert_eq!(bare.unit, "kN");
    for (a, b) in read.runs[0].recording.times.iter().zip(&recording.times) {
        assert!((a - (b - recording.times[0])).abs() < 1e-9 * b.abs().max(1.0));
    }
    for (keys, said) in [
        ("", "the first column"),
        ("dt = -1.0", "the step is -1"),
        ("dt = 0.1\nlayout = \"rows\"", "is no layout"),
        ("dt = 0.1\nlayout = \"columns\"\nunit = \"kNn\"", "is no unit; did you mean kN?"),
        (
            "dt = 0.1\nlayout = \"columns\"\nunit = \"kN\"\nquantity = \"velocity\"",
            "kN is the unit of a force, and velocity is told",
        ),
    ] {
        with(keys);
        let (_, message) = load_error(&folder);
        assert!(message.contains(said), "{keys}: {message}");
    }
    fs::write(folder.study(), study.replacen("growing.csv\"", "growing.csv\"\nunit = \"N\"", 1)).unwrap();
    let (_, message) = load_error(&folder);
    assert!(message.contains("the file says kN for force"), "{message}");
}

/// Tables of a study: header in the file, and definition in the schema; empty for the top level.
const TABLES: [(&str, &str); 6] = [
    ("", ""),
    ("[[parameter]]", "parameter"),
    ("[[run]]", "run"),
    ("[[run.observe]]", "observe"),
    ("[calibration]", "calibration"),
    ("[rig]", "rig"),
];

/// Keys of a table in the schema for editors.
fn schema_keys(definition: &str) -> BTreeSet<String> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/reference/study.schema.json");
    let schema: serde_json::Value = serde_json::from_str(&fs::read_to_string(file).unwrap()).unwrap();
    let table = if definition.is_empty() { &schema } else { &schema["definitions"][definition] };
    table["properties"].as_object().unwrap().keys().cloned().collect()
}

#[test]
fn schema_for_editors_has_the_keys_of_the_reader() {
    for (header, definition) in TABLES {
        let folder = StudyFolder::new();
        let text = fs::read_to_string(folder.study()).unwrap() + "\n[calibration]\n[rig]\n";
        let at = if header.is_empty() { 0 } else { text.find(&format!("{header}\n")).unwrap() + header.len() + 1 };
        fs::write(folder.study(), format!("{}zzzzzz = 1\n{}", &text[..at], &text[at..])).unwrap();
        let (_, message) = load_error(&folder);
        let (_, known) = message.split_once("expected one of ").unwrap();
        let known: BTreeSet<String> = known.split(';').next().unwrap().split(", ").map(str::to_owned).collect();
        assert_eq!(known, schema_keys(definition), "{header}");
    }
}

/// Studies of the repository below a folder.
fn studies_below(folder: PathBuf, found: &mut Vec<PathBuf>) {
    for path in fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
        if path.is_dir() {
            studies_below(path, found);
        } else if path.extension().is_some_and(|e| e == "toml") {
            found.push(path);
        }
    }
}

#[test]
fn studies_of_the_repository_have_keys_of_the_schema() {
    let mut files = vec![];
    for folder in ["tcl-like-inputs", "validation", "benches"] {
        studies_below(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder), &mut files);
    }
    let mut studies = 0;
    for file in files {
        let text = fs::read_to_string(&file).unwrap();
        if !text.lines().any(|l| l.starts_with("model ")) {
            continue;
        }
        studies += 1;
        let mut known = schema_keys("");
        for line in text.lines() {
            if let Some((_, definition)) = TABLES.iter().skip(1).find(|(header, _)| line.trim() == *header) {
                known = schema_keys(definition);
            } else if let Some((key, _)) = line.split_once('=').filter(|_| line.starts_with(char::is_alphabetic)) {
                assert!(known.contains(key.trim()), "{}: {line}", file.display());
            }
        }
    }
    assert!(studies >= 20, "only {studies} found");
}
