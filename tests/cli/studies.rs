//! Broken studies and recordings, and what is said of each; drafts of studies.

use super::Place;
use std::fmt::Write as _;

const SCRIPT: &str = "model basic -ndm 1 -ndf 1\nnode 1 0.0\nnode 2 0.0\nfix 1 1\npset k 2.0\npset Fy 2.5\n\
    if {![info exists motion]} {set motion own.dat}\nuniaxialMaterial ElasticPP 1 $k [expr {$Fy/$k}]\n\
    element zeroLength 1 1 2 -mat 1 -dir 1\ntimeSeries Path 1 -dt 1.0 -filePath $motion -useLast\n\
    pattern Plain 1 1 {sp 2 1 1.0}\nrecorder Element -file force.out -time -ele 1 force\n\
    recorder Node -file disp.out -time -node 2 -dof 1 disp\nconstraints Transformation\nnumberer Plain\n\
    system ProfileSPD\ntest NormDispIncr 1.0e-9 50\nalgorithm Newton\nintegrator LoadControl 1.0\n\
    analysis Static\nif {[analyze 20] != 0} {error stopped}\n";

const STUDY: &str = "model = \"model.tcl\"\n\n[[parameter]]\nname = \"k\"\nlower = 1.0\nupper = 4.0\n\n[[parameter]]\n\
    name = \"Fy\"\nlower = 1.0\nupper = 4.0\n\n[[run]]\nname = \"test\"\nrecording = \"test.csv\"\n\
    set = { motion = \"test.dat\" }\n\n[[run.observe]]\nchannel = \"force\"\noutput = \"force.out\"\ncolumn = 2\n\n[[run]]\n\
    name = \"held\"\nrole = \"holdout\"\nrecording = \"test.csv\"\nset = { motion = \"test.dat\" }\n\n[[run.observe]]\n\
    channel = \"force\"\noutput = \"force.out\"\ncolumn = 2\n";

/// Displacement, and force of the pad with 5 % noise of a kind.
fn sample(i: u32) -> (f64, f64) {
    let t = f64::from(i);
    let u = 3.0 * (0.6 * t).sin();
    (u, (1.9 * u).clamp(-2.4, 2.4) + 0.1 * (7.0 * t).cos())
}

/// Rows of the recording: time, force, displacement.
fn rows() -> Vec<[String; 3]> {
    let row = |i| {
        let (u, f) = sample(i);
        [format!("{i}.0"), format!("{f:.4}"), format!("{u:.6}")]
    };
    (1..=20).map(row).collect()
}

fn table(header: &str, separator: &str, decimal: &str) -> String {
    let row = |r: [String; 3]| r.map(|c| c.replace('.', decimal)).join(separator) + "\n";
    rows().into_iter().map(row).fold(format!("{header}\n"), |text, r| text + &r)
}

/// A folder with a sound study.
fn place() -> Place {
    let place = Place::new();
    let motion = (0..=20).fold(String::new(), |mut text, i| {
        let _ = writeln!(text, "{:.6}", sample(i).0);
        text
    });
    place.write("model.tcl", SCRIPT);
    place.write("study.toml", STUDY);
    place.write("test.csv", table("time[s],force[kN],disp[mm]", ",", "."));
    place.write("test.dat", &motion);
    place.write("own.dat", motion.replace('3', "1"));
    place
}

fn check(place: &Place) -> (Option<i32>, String) {
    let (status, table, said) = place.run(&["check", "study.toml"]);
    (status, table + &said)
}

/// Edit a file, check the study, and look at status, place and words.
fn case(status: i32, file: &str, old: &str, new: &str, at: &str, words: &[&str]) {
    let place = place();
    edit(&place, file, old, new);
    expect(&place, status, &format!("{new}\n"), at, words);
}

fn edit(place: &Place, file: &str, old: &str, new: &str) {
    let text = std::fs::read_to_string(place.0.join(file)).unwrap();
    assert!(text.contains(old), "{file} has no {old}");
    place.write(file, text.replacen(old, new, 1));
}

fn expect(place: &Place, status: i32, of: &str, at: &str, words: &[&str]) {
    let (got, said) = check(place);
    assert_eq!(got, Some(status), "{of}{said}");
    assert!(at.is_empty() || said.contains(&format!("{at}\n")), "{of}no {at} in\n{said}");
    for word in words {
        assert!(said.contains(word), "{of}no {word} in\n{said}");
    }
}

#[test]
fn sound_study_has_no_complaint() {
    let place = place();
    let (status, said) = check(&place);
    assert_eq!(status, Some(0), "{said}");
    assert!(!said.contains("warning") && !said.contains("note"), "{said}");
    // A parameter may be read and then converted.
    edit(&place, "model.tcl", "pset Fy 2.5", "pset Fy 2.5\nset Fy [expr {1.0*$Fy}]");
    expect(&place, 0, "", "", &["2 of 2 parameters"]);
}

#[test]
fn mistakes_in_the_study_have_their_place() {
    let case = |old, new, at: &str, words: &[&str]| case(2, "study.toml", old, new, &format!("study.toml:{at}"), words);
    case("lower = 1.0", "lover = 1.0", "5:1", &["unknown key \"lover\"", "did you mean \"lower\""]);
    case("lower = 1.0", "lower = \"1\"", "5:9", &["invalid type"]);
    case("upper = 4.0", "upper = 0.5", "6:9", &["the upper bound of k is 0.5"]);
    case("upper = 4.0\n", "", "4:8", &["no upper bound"]);
    case("\"Fy\"", "\"k\"", "9:8", &["two parameters \"k\""]);
    case("\"Fy\"", "\"fy\"", "9:8", &["never declares the parameter fy", "did you mean \"Fy\""]);
    case("name = \"test\"", "name = \"test\"\nrole = \"train\"", "15:8", &["expected fit or holdout"]);
    case("name = \"test\"", "name = \"test\"\nrole = \"holdout\"", "1:9", &["no run has the role \"fit\""]);
    case("\"test.csv\"", "\"tests.csv\"", "15:13", &["cannot read tests.csv"]);
    case("model.tcl", "modell.tcl", "1:9", &["there is no script modell.tcl"]);
    case("channel = \"force\"", "channel = \"forces\"", "19:11", &["did you mean \"force\""]);
    case("column = 2", "column = -2", "21:10", &["the column is -2"]);
    case("column = 2", "column = 2\nweight = -1.0", "22:10", &["the weight is -1"]);
    case("column = 2", "column = 2\nfactor = 0", "22:10", &["the factor is 0"]);
    case("column = 2", "column = 2\nshift = inf", "22:9", &["the shift is inf"]);
    case("column = 2", "column = 2\nunit = \"kM\"", "22:8", &["unknown unit \"kM\"", "did you mean"]);
    case("column = 2", "column = 2\nunit = \"mm\"", "22:8", &["a force in kN, and mm is a length", "right column"]);
    case("{ motion", "{ k = 1.0, motion", "16:9", &["k is set in run \"test\" and is a parameter"]);
    case("{ motion", "{ moton", "16:9", &["never reads the variable moton", "did you mean \"motion\""]);
    // A condition of the test that the script does not need.
    let other = place();
    edit(&other, "study.toml", "{ motion", "{ T = 38.0, motion");
    expect(&other, 0, "", "study.toml:16:9", &["warning: model.tcl never reads the variable T"]);
    case("\"held\"", "\"test\"", "24:8", &["two runs named \"test\""]);
    case(
        "output = \"force.out\"",
        "output = \"forces.out\"",
        "20:10",
        &["did you mean \"force.out\"", "recorders write force.out, disp.out"],
    );
    case(
        "column = 2",
        "column = 3",
        "21:10",
        &["columns count from 0; the file has columns 0 to 2", "in run \"test\""],
    );
    case("model =", "rig = { stroke = 0.0 }\nmodel =", "1:18", &["the stroke is 0"]);
    case("model =", "rig = { temperature = [40.0, 0.0] }\nmodel =", "1:23", &["the lowest and the highest"]);
    case("model =", "calibration = { F = 3.0 }\nmodel =", "1:21", &["F is 3"]);
    case("model =", "calibration = { method = \"cmaes\" }\nmodel =", "1:26", &["cma-es"]);
}

#[test]
fn mistakes_between_study_and_script_have_both_places() {
    let case = |old, new, at: &str, words: &[&str]| case(2, "model.tcl", old, new, at, words);
    let optional = "if {![info exists motion]} {set motion own.dat}";
    case(
        optional,
        "set motion own.dat",
        "model.tcl:7:5",
        &["sets motion again", "study.toml:16:9: the study sets motion"],
    );
    case(
        "pset Fy 2.5",
        "pset Fy 2.5\nset Fy 3.0",
        "model.tcl:7:5",
        &["sets Fy again", "model.tcl:6:9: pset declares Fy"],
    );
    case("pset Fy", "set Fy", "study.toml:9:8", &["never declares the parameter Fy"]);
    case("-time -ele", "-ele", "study.toml:21:10", &["has 2 columns", "-time is missing in that recorder"]);
    case(
        "-file force.out",
        "-file f.out",
        "study.toml:20:10",
        &["force.out has no rows", "recorders write f.out, disp.out"],
    );
    case("if {[analyze 20] != 0} {error stopped}\n", "", "study.toml:20:10", &["is it made after the analysis"]);
    case("element zeroLength", "element zeroLenght", "model.tcl:9:9", &["did you mean"]);
    case("LoadControl 1.0", "LoadControl -1.0", "study.toml:20:10", &["times that do not increase"]);
    let place = place();
    edit(&place, "model.tcl", optional, "");
    edit(&place, "study.toml", "{ motion", "{ moton");
    expect(&place, 2, "", "", &["study.toml:16:9: the study sets moton: did you mean \"motion\""]);
}

#[test]
fn doubts_are_warnings_before_the_search() {
    let idle = "\n[[parameter]]\nname = \"idle\"\nlower = 0.0\nupper = 1.0\n";
    case(
        0,
        "study.toml",
        "upper = 4.0",
        "upper = 1.5",
        "study.toml:4:8",
        &["k is 2 in the script, outside of its bounds 1 to 1.5"],
    );
    case(0, "study.toml", "column = 2", "column = 0", "study.toml:21:10", &["column 0 of force.out is the time"]);
    case(
        0,
        "model.tcl",
        "pset Fy 2.5",
        "pset Fy 2.5\npset Fy 3.0",
        "model.tcl:7:9",
        &["declared as 3, and as 2.5 before", "model.tcl:6:9"],
    );
    let place = place();
    edit(&place, "model.tcl", "pset k 2.0", "pset k 2.0\npset idle 0.5");
    edit(&place, "study.toml", "upper = 4.0\n", &format!("upper = 4.0\n{idle}"));
    expect(&place, 0, "", "study.toml:9:8", &["no observed channel depends on idle from 0 to 1"]);
    // Two samples, for three parameters and for two.
    let short = table("time[s],force[kN],disp[mm]", ",", ".").lines().take(3).fold(String::new(), |t, l| t + l + "\n");
    place.write("test.csv", &short);
    expect(&place, 2, "", "study.toml:1:9", &["2 samples are fitted by 3 parameters"]);
    edit(&place, "study.toml", idle, "");
    expect(&place, 0, "", "study.toml:1:9", &["warning: 2 samples are fitted by 2 parameters"]);
    case(0, "study.toml", "role = \"holdout\"", "", "study.toml:1:9", &["note: no run is held out"]);
}

#[test]
fn mistakes_in_recordings_have_their_place() {
    let case = |old, new, at: &str, words: &[&str]| case(2, "test.csv", old, new, at, words);
    case("time[s],", "x[s],", "test.csv:1:1", &["expected time[s]"]);
    case("time[s],force[kN]", "force[kN],time[s]", "test.csv:1:1", &["the time is column 2"]);
    case("disp[mm]", "force[N]", "test.csv:1:19", &["no name of its own"]);
    case("\n1.0,", "\nl.0,", "test.csv:2:1", &["the time is not a number"]);
    case("\n3.0,", "\n1.5,", "test.csv:4:1", &["the time goes from 2 to 1.5"]);
    case("\n2.0,", "\n2.0,7,", "test.csv:3:1", &["has 4 cells, its header 3"]);
    case("\n2.0,", "\n2.0,#N/A", "test.csv:3:5", &["leave missing samples empty"]);
    case(
        "time[s],force[kN],disp[mm]\n",
        "time[s],force[kN],disp[mm]\ns,N,mm\n",
        "test.csv:2:3",
        &["unit kN in the header and N below"],
    );
    let whole = |content: &[u8], at: &str, words: &[&str]| {
        let place = place();
        place.write("test.csv", content);
        expect(&place, 2, "", at, words);
    };
    let commas = table("time[s],force[kN],disp[mm]", ",", ",");
    whole(commas.as_bytes(), "test.csv:2:1", &["are the commas decimal signs too", "semicolons"]);
    whole(b"time[s],force[kN]\n1,\"1,5\"\n2,\"2,5\"\n", "test.csv:2:3", &["a comma separates the cells"]);
    whole(b"time[s];force[kN]\n1,0;1.234,5\n", "test.csv:2:5", &["without separators of thousands"]);
    whole(b"time[s];force[kN]\n1,0;1.5\n", "test.csv:2:5", &["one decimal sign"]);
    whole(b"PK\x03\x04rest", "study.toml:15:13", &["the xlsx workbook is damaged"]);
    whole(b"\xd0\xcf\x11\xe0\xa1\xb1", "study.toml:15:13", &["is an Excel workbook (xls)"]);
    whole(b"\x00\x01\x02\x00\x00", "study.toml:15:13", &["is a binary file"]);
}

/// All ways of writing one table give the same numbers.
#[test]
fn recordings_are_read_as_spreadsheets_write_them() {
    let place = place();
    let (_, plain) = check(&place);
    assert!(plain.contains("NMSE"), "{plain}");
    let utf16 = |text: &str, mark: [u8; 2], to: fn(u16) -> [u8; 2]| {
        [mark.to_vec(), text.encode_utf16().flat_map(to).collect()].concat()
    };
    let european = table("Time (s);force [kN];disp (mm)", ";", ",");
    let milliseconds =
        rows().into_iter().map(|[t, f, u]| format!("{}\t{f}\t{u}\n", 1000.0 * t.parse::<f64>().unwrap()));
    for (name, bytes) in [
        ("semicolons and decimal commas", european.clone().into_bytes()),
        ("tabs", table("t[s]\tforce[kN]\tdisp[mm]", "\t", ",").into_bytes()),
        ("tabs and points", table("TIME\tforce[kN]\tdisp[mm]", "\t", ".").into_bytes()),
        (
            "milliseconds",
            ("Time [ms]\tforce[kN]\tdisp[mm]\n".to_owned() + &milliseconds.collect::<String>()).into_bytes(),
        ),
        ("a row of units", table("time,force,disp\ns,kN,mm", ",", ".").into_bytes()),
        ("a mark of UTF-8", [&[0xef, 0xbb, 0xbf], european.as_bytes()].concat()),
        ("UTF-16, little end first", utf16(&european, [0xff, 0xfe], u16::to_le_bytes)),
        ("UTF-16, big end first", utf16(&european, [0xfe, 0xff], u16::to_be_bytes)),
        (
            "Latin-1",
            table("time[s],force[kN],temp[\u{1}C]", ",", ".").bytes().map(|b| if b == 1 { 0xb0 } else { b }).collect(),
        ),
        ("line ends of Windows", european.replace('\n', "\r\n").into_bytes()),
        ("a stated separator", format!("sep=;\n{european}").into_bytes()),
        ("empty cells at the ends", european.replace('\n', ";;\n").into_bytes()),
        ("empty rows at the end", format!("{european};;\n;;\n").into_bytes()),
    ] {
        place.write("test.csv", bytes);
        let (status, said) = check(&place);
        assert_eq!((status, &said), (Some(0), &plain), "{name}");
    }
}

#[test]
fn draft_of_a_study_passes_the_check() {
    let place = place();
    std::fs::rename(place.0.join("study.toml"), place.0.join("mine.toml")).unwrap();
    place.write("second.csv", table("time[s],force[kN],disp[mm]", ",", "."));
    let (status, _, said) = place.run(&["init", "model.tcl", "test.csv", "second.csv"]);
    assert_eq!(status, Some(0), "{said}");
    let text = std::fs::read_to_string(place.0.join("study.toml")).unwrap();
    for piece in [
        "name  = \"k\"\nlower = 1.0      # 2.0 in the script\nupper = 4.0",
        "name  = \"Fy\"\nlower = 1.25",
        "set       = { motion = \"test.dat\" }\n# The file has the name of the recording.",
        "# The script takes motion too: own.dat in it.",
        "output  = \"force.out\"",
        "at      = \"element 1 force\"",
        "column  = 2      # the names agree, correlation 0.7",
        "disp of the recording is not observed: is the motion that the script imposes (disp.out column 1)",
        "role      = \"holdout\"",
    ] {
        assert!(text.contains(piece), "no {piece} in\n{text}");
    }
    // Remarks on what is doubtful have no place here.
    for doubt in ["CHECK:", "A GUESS", "did not end with its own values", "no range of its own", "has no value of it"] {
        assert!(!text.contains(doubt), "{doubt} in\n{text}");
    }
    expect(&place, 0, &text, "", &["2 of 2 parameters", "fit      test    force"]);
    let (status, _, said) = place.run(&["init", "model.tcl", "test.csv"]);
    assert!(status == Some(2) && said.contains("study.toml exists already"), "{said}");
    assert_eq!(std::fs::read_to_string(place.0.join("study.toml")).unwrap(), text);
}

#[test]
fn draft_without_parameters_lists_candidates() {
    let place = place();
    edit(&place, "model.tcl", "pset k", "set k");
    edit(&place, "model.tcl", "pset Fy", "set Fy");
    let (status, _, said) = place.run(&["init", "model.tcl", "test.csv", "--out", "drafts.toml"]);
    assert_eq!(status, Some(0), "{said}");
    let text = std::fs::read_to_string(place.0.join("drafts.toml")).unwrap();
    for piece in ["#   pset k 2.0      in the script", "#   name  = \"Fy\"\n#   lower = 1.25\n#   upper = 5.0"] {
        assert!(text.contains(piece), "no {piece} in\n{text}");
    }
    // Values that the script has not are guessed from the recording and the file with its name.
    edit(&place, "model.tcl", "if {![info exists motion]} {set motion own.dat}", "");
    edit(&place, "model.tcl", "-dt 1.0", "-dt $dt");
    edit(&place, "model.tcl", "analyze 20", "analyze [expr {$npts-1}]");
    let (status, _, said) = place.run(&["init", "model.tcl", "test.csv", "--out", "guessed.toml"]);
    assert_eq!(status, Some(0), "{said}");
    let text = std::fs::read_to_string(place.0.join("guessed.toml")).unwrap();
    let set = "set       = { dt = 1.0, motion = \"test.dat\", npts = 21 }";
    for piece in [set, "# A GUESS, since", "output  = \"force.out\""] {
        assert!(text.contains(piece), "no {piece} in\n{text}");
    }
    let (status, _, said) = place.run(&["init", "model.tcl", "missing.csv", "--out", "other.toml"]);
    assert!(status == Some(2) && said.contains("cannot read missing.csv"), "{said}");
    assert!(!place.names().contains(&"other.toml".to_owned()));
}

/// A script that did not run has no outputs: the draft says so once, and how a channel becomes its motion.
#[test]
fn draft_of_a_script_that_lacks_its_motion() {
    let place = place();
    edit(&place, "model.tcl", "if {![info exists motion]} {set motion own.dat}", "");
    std::fs::remove_file(place.0.join("test.dat")).unwrap();
    let (status, _, said) = place.run(&["init", "model.tcl", "test.csv", "--out", "draft.toml"]);
    assert_eq!(status, Some(0), "{said}");
    let text = std::fs::read_to_string(place.0.join("draft.toml")).unwrap();
    let command = "hysteron recording \"test.csv\" --channel \"disp\" --out \"test.txt\"";
    for piece in ["set = { motion = ... }", "no channel could be matched", command] {
        assert!(text.contains(piece), "no {piece} in\n{text}");
    }
    assert!(!text.contains("the script records none"), "{text}");
    // The command of the draft makes what the next draft needs.
    let (status, _, said) = place.run(&["recording", "test.csv", "--channel", "disp", "--out", "test.txt"]);
    assert_eq!(status, Some(0), "{said}");
    let (status, _, said) = place.run(&["init", "model.tcl", "test.csv", "--out", "second.toml"]);
    assert_eq!(status, Some(0), "{said}");
    let text = std::fs::read_to_string(place.0.join("second.toml")).unwrap();
    assert!(text.contains("motion = \"test.txt\"") && text.contains("output  = \"force.out\""), "{text}");
}

/// A device without an end is no recording.
#[test]
fn endless_recording() {
    let place = place();
    edit(&place, "study.toml", "recording = \"test.csv\"", "recording = \"/dev/zero\"");
    expect(&place, 2, "", "", &["study.toml:15:", "cannot read /dev/zero"]);
}

/// A script that loops for ever is stopped at the limit of a run, with its place.
#[test]
fn endless_script() {
    let place = place();
    edit(&place, "model.tcl", "if {[analyze 20]", "while 1 {set x 1}\nif {[analyze 20]");
    edit(&place, "study.toml", "[[parameter]]", "[calibration]\ntime_limit = 0.3\n\n[[parameter]]");
    let begun = std::time::Instant::now();
    expect(&place, 2, "", "", &["exceeds the time that it may take", "model.tcl:21:1", "time_limit of [calibration]"]);
    assert!(begun.elapsed().as_secs() < 20);
}

/// A finding of the channels points at the channel.
#[test]
fn finding_has_a_place() {
    let place = place();
    let turned = table("time[s],force[kN],disp[mm]", ",", ".");
    let turned: Vec<String> = turned
        .lines()
        .map(|l| {
            let cells: Vec<&str> = l.split(',').collect();
            let force = cells[1].strip_prefix('-').map_or_else(|| format!("-{}", cells[1]), str::to_owned);
            if cells[0].starts_with("time") { l.to_owned() } else { [cells[0], &force, cells[2]].join(",") }
        })
        .collect();
    place.write("test.csv", turned.join("\n") + "\n");
    expect(&place, 0, "", "", &["study.toml:19:11", "force in all runs"]);
}

/// A calibration does not go on where the script, its files or the recording have changed.
#[test]
fn calibration_of_changed_files_is_not_resumed() {
    let place = place();
    // Slow enough to be killed before it ends.
    edit(&place, "model.tcl", "if {[analyze 20]", "for {set i 0} {$i < 2000000} {incr i} {}\nif {[analyze 20]");
    edit(&place, "study.toml", "[[parameter]]", "[calibration]\nmethod = \"l-shade\"\n\n[[parameter]]");
    let checkpoint = place.0.join("results/checkpoint.json");
    // There is nothing to go on from yet.
    let mut killed = place.spawn(&["calibrate", "--resume", "study.toml"]);
    while !checkpoint.exists() {
        assert_eq!(killed.try_wait().unwrap(), None, "it ended before its first checkpoint");
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    killed.kill().unwrap();
    killed.wait().unwrap();
    // Whether the limit ends the initial run or the search, the end is that of the limit.
    let (status, _, said) = place.run(&["calibrate", "--resume", "--time-limit", "1", "study.toml"]);
    assert!(status == Some(1) && said.contains("the time limit of 1 s is over"), "{status:?} {said}");
    assert!(!said.contains("cannot go on") && checkpoint.exists(), "{said}");
    // A checkpoint whose numbers were edited is not believed.
    let before = std::fs::read_to_string(&checkpoint).unwrap();
    let at = before.rfind(|c: char| ('1'..='8').contains(&c)).unwrap();
    let other = char::from(before.as_bytes()[at] + 1);
    place.write("results/checkpoint.json", format!("{}{other}{}", &before[..at], &before[at + 1..]));
    let (status, _, said) = place.run(&["calibrate", "--resume", "--time-limit", "1", "study.toml"]);
    assert!(status == Some(2) && said.contains("it is damaged"), "{status:?} {said}");
    place.write("results/checkpoint.json", before);
    for (file, old, new) in [("model.tcl", "analyze 20", "analyze 19"), ("test.dat", "5", "6"), ("test.csv", "5", "6")]
    {
        let before = std::fs::read(place.0.join(file)).unwrap();
        edit(&place, file, old, new);
        let (status, _, said) = place.run(&["calibrate", "--resume", "study.toml"]);
        assert!(status == Some(2) && said.contains("has changed since"), "{file}: {status:?} {said}");
        place.write(file, before);
    }
}

/// The table with its forces multiplied.
fn with_force_times(factor: f64) -> String {
    let scaled = rows().into_iter().map(|[t, f, u]| format!("{t},{:.4},{u}\n", factor * f.parse::<f64>().unwrap()));
    scaled.fold("time[s],force[kN],disp[mm]\n".to_owned(), |text, row| text + &row)
}

/// A factor is that of a unit unless the parameters of the study can make it.
#[test]
fn a_factor_that_the_parameters_can_make_is_no_unit() {
    let place = place();
    place.write("test.csv", with_force_times(9.80665));
    expect(&place, 2, "", "", &["force in all runs", "kN for tonf?"]);
    edit(&place, "study.toml", "upper = 4.0", "upper = 60.0");
    let wide = std::fs::read_to_string(place.0.join("study.toml")).unwrap().replace("upper = 4.0", "upper = 60.0");
    place.write("study.toml", wide);
    let (_, said) = check(&place);
    assert!(!said.contains("for tonf") && !said.contains("another unit"), "{said}");
}

/// Two runs with one motion by mistake: their sign is no fault of the sensor.
#[test]
fn opposite_recordings_of_one_motion_are_a_mistake_of_the_motion() {
    let place = place();
    place.write("turned.csv", with_force_times(-1.0));
    let text = std::fs::read_to_string(place.0.join("study.toml")).unwrap();
    let held =
        text.replace("role = \"holdout\"\nrecording = \"test.csv\"", "role = \"holdout\"\nrecording = \"turned.csv\"");
    assert_ne!(held, text);
    place.write("study.toml", held);
    let (status, said) = check(&place);
    assert!(status == Some(2) && said.contains("have both runs one motion by mistake?"), "{status:?} {said}");
    assert!(!said.contains("is the sign turned?"), "{said}");
    // With a sign that is turned everywhere the runs agree.
    place.write("study.toml", text);
    place.write("test.csv", with_force_times(-1.0));
    let (_, said) = check(&place);
    assert!(said.contains("force in all runs") && !said.contains("one motion by mistake"), "{said}");
}

/// The examples of all jobs are written, and the commands that are told next run.
#[test]
fn examples_to_begin_with_run() {
    for job in ["building", "bearing", "study", "isolation"] {
        let place = Place::new();
        let (status, _, err) = place.run(&["init", "--new", job]);
        assert_eq!(status, Some(0), "{job}: {err}");
        let next: Vec<Vec<String>> = err
            .lines()
            .filter_map(|line| line.trim().strip_prefix("hysteron "))
            .map(|command| command.split(' ').map(str::to_owned).collect())
            .collect();
        assert!(!next.is_empty(), "{job}: {err}");
        // The first command alone: the analyses themselves are run by the tests of what is shipped.
        let words: Vec<&str> = next[0].iter().map(String::as_str).collect();
        let (status, out, err) = place.run(&words);
        assert_eq!(status, Some(0), "{job}: {words:?}: {out}{err}");
        for command in &next {
            let file = command.iter().skip(1).find(|w| w.contains('.') && !w.starts_with('0')).unwrap();
            assert!(place.0.join(file).exists(), "{job}: {command:?}");
        }
        // The same again changes nothing; a file of the user's own stays.
        assert_eq!(place.run(&["init", "--new", job]).0, Some(0), "{job}");
        let own = next[0].iter().find(|w| place.0.join(w).is_file()).unwrap();
        place.write(own, "own");
        let (status, _, err) = place.run(&["init", "--new", job]);
        assert!(status == Some(2) && err.contains("exists already"), "{job}: {err}");
    }
    let (status, out, err) = Place::new().run(&[]);
    assert!(status == Some(2) && (out + &err).contains("hysteron init --new building"));
}
