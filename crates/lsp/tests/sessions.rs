//! Sessions of an editor: what it is told while a script or a study is written.

#![allow(clippy::unwrap_used, clippy::panic, clippy::print_stdout, unreachable_pub)]

#[path = "editor/mod.rs"]
mod editor;

use editor::{Editor, places, short};
use serde_json::{Value as Json, json};

/// A portal in the plane.
const PORTAL: &str = "\
model basic -ndm 2 -ndf 3
set h 3.0
for {set i 1} {$i <= 4} {incr i} { node $i [expr {6*(($i-1)%2)}] [expr {$h*(($i-1)/2)}] }
fix 1 1 1 1
fix 2 1 1 1
mass 3 10 10 0
uniaxialMaterial Steel01 7 250e3 200e6 0.02
geomTransf Linear 1
element elasticBeamColumn 11 1 3 0.1 2e8 1e-3 1
element elasticBeamColumn 12 2 4 0.1 2e8 1e-3 1
element elasticBeamColumn 13 3 4 0.1 2e8 1e-3 1
proc push {node force} { load $node $force 0 0 }
timeSeries Linear 5
pattern Plain 6 5 {
    push 3 1.0
}
recorder Element -file f.out -ele 11 force
";

#[test]
fn mistakes_are_told_and_go_away() {
    let mut e = Editor::new();
    assert_eq!(short(&e.open("m.tcl", PORTAL)), [] as [&str; 0]);
    // "elasticBeamColumn" of line 9 loses its last letter.
    e.edit("m.tcl", 2, [8, 24, 8, 25], "");
    let told = e.diagnostics("m.tcl", 2);
    assert_eq!(short(&told), ["9:9-25 unknown-kind unknown element \"elasticBeamColum\""]);
    assert!(told[0]["message"].as_str().unwrap().contains("did you mean \"elasticBeamColumn\"?"));
    let range = told[0]["range"].clone();
    let params = json!({ "textDocument": { "uri": e.uri("m.tcl") }, "range": range, "context": { "diagnostics": [] } });
    let actions = e.request("textDocument/codeAction", params);
    assert_eq!(actions[0]["title"], "Replace by elasticBeamColumn");
    let edit = &actions[0]["edit"]["changes"][e.uri("m.tcl")][0];
    assert_eq!((edit["newText"].as_str(), &edit["range"]), (Some("elasticBeamColumn"), &range));
    e.edit("m.tcl", 3, [8, 8, 8, 24], "elasticBeamColumn");
    assert_eq!(short(&e.diagnostics("m.tcl", 3)), [] as [&str; 0]);
    assert_eq!(e.end(), Ok(()));
}

#[test]
fn every_place_is_that_of_the_word() {
    let mut e = Editor::new();
    let text =
        "# Brücke 𝛼\nmodel basic -ndm 2 -ndf 3\r\nnode 1 0 0; node 2 x 0\r\nset ä 1; fix 9 1 1 1\nputs $lenght\n";
    let told = short(&e.open("m.tcl", text));
    assert_eq!(
        told,
        [
            "3:20-21 not-a-number x coordinate is not a number: \"x\"",
            "4:14-15 not-defined there is no node 9",
            "5:6-13 unknown-variable can't read \"lenght\": no such variable",
        ]
    );
}

#[test]
fn calls_of_procedures_and_loops_are_followed() {
    let mut e = Editor::new();
    let text = "model basic -ndm 1 -ndf 1\nproc bay {n} {\n  node $n $n\n  fix 77 1\n}\nforeach i {1 2} { bay $i }\n";
    let told = e.open("m.tcl", text);
    assert_eq!(short(&told), ["4:7-9 not-defined there is no node 77 (2 times)"]);
    let related = &told[0]["relatedInformation"][0];
    assert_eq!(related["message"], "proc \"bay\" is called here");
    assert_eq!(related["location"]["range"]["start"]["line"], 5);
}

#[test]
fn a_sourced_file_is_checked_as_a_part() {
    let mut e = Editor::new();
    e.write("main.tcl", "model basic -ndm 1 -ndf 1\nset a 2.0\nsource part.tcl\nfix 5 1\n");
    // Alone, it would have no model and no variable.
    assert_eq!(short(&e.open("part.tcl", "node 5 $a\n")), [] as [&str; 0]);
    e.replace("part.tcl", 2, "node 6 $a\n");
    assert_eq!(short(&e.diagnostics("part.tcl", 2)), [] as [&str; 0]);
    let main = e.diagnostics_that("main.tcl", -1, |all| !all.is_empty());
    assert_eq!(short(&main), ["4:5-6 not-defined there is no node 5"]);
    // What is not saved counts for the script that sources it.
    let main = e.open("main.tcl", "model basic -ndm 1 -ndf 1\nset a 2.0\nsource part.tcl\nfix 6 1\n");
    assert_eq!(short(&main), [] as [&str; 0]);
    let at = e.at("textDocument/definition", "main.tcl", 3, 4, json!({}));
    assert_eq!((at[0]["uri"].as_str().unwrap(), places(&at)), (e.uri("part.tcl").as_str(), vec!["1:6-7".to_owned()]));
    let file = e.at("textDocument/definition", "main.tcl", 2, 9, json!({}));
    assert_eq!(file[0]["uri"], e.uri("part.tcl"));
}

#[test]
fn a_file_that_its_script_never_comes_to_stands_for_itself() {
    let mut e = Editor::new();
    e.write("main.tcl", "if {0} { source part.tcl }\n");
    let told = e.open("part.tcl", "model basic -ndm 1\nnode 1 x\n");
    let told = if told.is_empty() { e.diagnostics_that("part.tcl", 1, |all| !all.is_empty()) } else { told };
    assert_eq!(short(&told), ["2:8-9 not-a-number x coordinate is not a number: \"x\""]);
}

#[test]
fn a_hover_says_what_a_word_is() {
    let mut e = Editor::new();
    e.open("m.tcl", PORTAL);
    let command = e.hover("m.tcl", 3, 1);
    assert!(command.contains("fix $node"), "{command}");
    let kind = e.hover("m.tcl", 8, 12);
    assert!(kind.contains("Elastic beam, Euler-Bernoulli"), "{kind}");
    let node = e.hover("m.tcl", 5, 5);
    assert!(node.contains("**node 3** at (0, 3), mass 10, 10, 0"), "{node}");
    assert!(e.hover("m.tcl", 3, 4).contains("**node 1** at (0, 0), fixed in 1 2 3"));
    let area = e.hover("m.tcl", 8, 36);
    assert!(area.contains("cross-sectional area"), "{area}");
    let element = e.hover("m.tcl", 16, 35);
    assert!(element.contains("from node 1 (0, 0) to node 3 (0, 3), length 3"), "{element}");
    assert!(element.contains("`basicForce`"), "{element}");
    let coordinate = e.hover("m.tcl", 2, 45);
    assert!(coordinate.contains("x coordinate, a number"), "{coordinate}");
    assert!(e.hover("m.tcl", 2, 73).contains("`$h` = 3.0"));
    let force = e.hover("m.tcl", 11, 36);
    assert!(force.contains("= 1.0"), "{force}");
    let law = e.hover("m.tcl", 6, 25);
    assert!(
        law.contains("**uniaxial material 7**") && law.contains('*') && law.contains("uniaxialMaterial Steel01 7"),
        "{law}"
    );
    let call = e.hover("m.tcl", 14, 5);
    assert!(call.contains("proc push {node force}"), "{call}");
}

fn labels(items: &[Json]) -> Vec<&str> {
    items.iter().map(|i| i["label"].as_str().unwrap()).collect()
}

#[test]
fn completion_knows_commands_kinds_options_tags_and_responses() {
    let mut e = Editor::new();
    e.open("m.tcl", PORTAL);
    let last = 17;
    let mut version = 1;
    let mut offered = |e: &mut Editor, text: &str| {
        version += 1;
        e.replace("m.tcl", version, &format!("{PORTAL}{text}"));
        e.complete("m.tcl", last, text.len() as u32)
    };
    let commands = offered(&mut e, "elem");
    let element = commands.iter().find(|i| i["label"] == "element").unwrap();
    assert!(element["detail"].as_str().unwrap().starts_with("element $kind $tag"));
    assert!(labels(&commands).contains(&"foreach") && labels(&commands).contains(&"push"));
    let node = commands.iter().find(|i| i["label"] == "node").unwrap();
    assert_eq!(node["textEdit"]["newText"], "node ${1:tag} ${2:x} ${3:y}");
    assert_eq!(node["textEdit"]["range"]["start"], json!({ "line": last, "character": 0 }));
    let kinds = offered(&mut e, "uniaxialMaterial Ste");
    assert!(labels(&kinds).contains(&"Steel02") && !labels(&kinds).contains(&"node"));
    let steel = kinds.iter().find(|i| i["label"] == "Steel01").unwrap();
    assert!(steel["textEdit"]["newText"].as_str().unwrap().starts_with("Steel01 ${1:"));
    let options = offered(&mut e, "element elasticBeamColumn 14 1 2 0.1 2e8 1e-3 1 -");
    assert!(labels(&options).contains(&"-mass") && labels(&options).contains(&"-release"), "{options:?}");
    let nodes = offered(&mut e, "element elasticBeamColumn 14 ");
    assert_eq!(labels(&nodes)[..4], ["1", "2", "3", "4"]);
    let transforms = offered(&mut e, "element elasticBeamColumn 14 1 2 0.1 2e8 1e-3 ");
    assert_eq!(labels(&transforms)[..1], ["1"]);
    assert!(transforms[0]["detail"].as_str().unwrap().contains("geomTransf Linear 1"), "{:?}", transforms[0]);
    let responses = offered(&mut e, "recorder Element -file g.out -ele 11 bas");
    assert!(labels(&responses).contains(&"basicForce"));
    let variables = offered(&mut e, "node 9 $");
    let height = variables.iter().find(|i| i["label"] == "$h").unwrap();
    assert_eq!(height["detail"], "3.0");
    e.write("other.tcl", "");
    assert!(labels(&offered(&mut e, "source ")).contains(&"other.tcl"));
}

#[test]
fn definitions_and_references_of_tags_procedures_and_variables() {
    let mut e = Editor::new();
    e.open("m.tcl", PORTAL);
    let mut ask = |method: &str, line, character| {
        places(&e.at(
            &format!("textDocument/{method}"),
            "m.tcl",
            line,
            character,
            json!({ "context": { "includeDeclaration": true } }),
        ))
    };
    // Node 3 is made in a loop, whose word is the definition.
    assert_eq!(ask("definition", 8, 31), ["3:41-43"]);
    assert_eq!(ask("references", 8, 31), ["3:41-43", "6:6-7", "9:32-33", "11:30-31", "12:31-36"]);
    assert_eq!(ask("definition", 8, 47), ["8:19-20"]);
    assert_eq!(ask("references", 12, 18), ["13:19-20", "14:17-18"]);
    assert_eq!(ask("definition", 14, 6), ["12:6-10"]);
    assert_eq!(ask("references", 11, 6), ["12:6-10", "15:5-9"]);
    assert_eq!(ask("definition", 2, 73), ["2:5-6"]);
    assert_eq!(ask("definition", 16, 35), ["9:27-29"]);
    assert_eq!(ask("documentHighlight", 16, 35), ["9:27-29", "17:35-37"]);
}

#[test]
fn a_tag_or_a_procedure_gets_another_name_everywhere() {
    let mut e = Editor::new();
    e.open("m.tcl", PORTAL);
    let rename = |e: &mut Editor, line, character, new: &str| {
        let answer = e.at("textDocument/rename", "m.tcl", line, character, json!({ "newName": new }));
        let changes = answer["changes"][e.uri("m.tcl")].clone();
        if changes.is_null() { Err(answer["error"].as_str().unwrap().to_owned()) } else { Ok(places(&changes)) }
    };
    assert_eq!(rename(&mut e, 8, 26, "21").unwrap(), ["9:27-29", "17:35-37"]);
    assert_eq!(rename(&mut e, 14, 5, "push_over").unwrap(), ["12:6-10", "15:5-9"]);
    assert!(rename(&mut e, 8, 26, "12").unwrap_err().contains("the tag 12 is taken by another element"));
    assert!(rename(&mut e, 8, 26, "x").unwrap_err().contains("expected a whole number"));
    assert!(rename(&mut e, 8, 29, "40").unwrap_err().contains("the tag 1 is given by $i"));
    assert!(rename(&mut e, 14, 5, "node").unwrap_err().contains("there is a command"));
    assert!(rename(&mut e, 1, 0, "set2").is_err());
}

#[test]
fn the_outline_and_what_can_be_folded() {
    let mut e = Editor::new();
    e.open("m.tcl", PORTAL);
    let document = json!({ "textDocument": { "uri": e.uri("m.tcl") } });
    let symbols = e.request("textDocument/documentSymbol", document.clone());
    let children = |s: &Json| {
        s["children"].as_array().unwrap().iter().map(|c| c["name"].as_str().unwrap().to_owned()).collect::<Vec<_>>()
    };
    let of = |name: &str| children(symbols.as_array().unwrap().iter().find(|s| s["name"] == name).unwrap());
    assert_eq!(of("node"), ["node 1 2 3 4"]);
    assert_eq!(of("element"), ["element 11", "element 12", "element 13"]);
    assert_eq!(of("procedure"), ["push"]);
    assert_eq!(of("load pattern"), ["load pattern 6"]);
    let folded = e.request("textDocument/foldingRange", document);
    assert_eq!(
        folded
            .as_array()
            .unwrap()
            .iter()
            .map(|f| (f["startLine"].as_u64().unwrap(), f["endLine"].as_u64().unwrap()))
            .collect::<Vec<_>>(),
        [(13, 14)]
    );
}

#[test]
fn the_usage_shows_the_argument_at_the_cursor() {
    let mut e = Editor::new();
    e.open("m.tcl", &format!("{PORTAL}fix 3 \n"));
    let help = e.at("textDocument/signatureHelp", "m.tcl", 17, 6, json!({}));
    assert!(help["signatures"][0]["label"].as_str().unwrap().starts_with("fix $node"), "{help}");
    assert_eq!(help["activeParameter"], 2);
    assert_eq!(e.at("textDocument/signatureHelp", "m.tcl", 1, 4, json!({})), Json::Null);
}

#[test]
fn formatting_changes_blanks_alone() {
    let mut e = Editor::new();
    let text = "proc a {x} {\nset b $x   \n# c\n if {$b} {\n      puts \"1  \n   2\"\n}\n}\n";
    e.open("m.tcl", text);
    let options = json!({ "tabSize": 4, "insertSpaces": true });
    let edits =
        e.request("textDocument/formatting", json!({ "textDocument": { "uri": e.uri("m.tcl") }, "options": options }));
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let n = |v: &Json| v.as_u64().unwrap() as usize;
    for edit in edits.as_array().unwrap().iter().rev() {
        let (start, end) = (&edit["range"]["start"], &edit["range"]["end"]);
        lines[n(&start["line"])]
            .replace_range(n(&start["character"])..n(&end["character"]), edit["newText"].as_str().unwrap());
    }
    assert_eq!(
        lines.join("\n"),
        "proc a {x} {\n    set b $x\n    # c\n    if {$b} {\n        puts \"1  \n   2\"\n    }\n}"
    );
}

#[test]
fn lenses_stand_over_a_script_and_its_bearings() {
    let mut e = Editor::with(json!({ "lenses": true }));
    let beam = "geomTransf Linear 1\nelement elasticBeamColumn 3 1 2 0.1 2e8 1e-3 1\n";
    let bearing = "uniaxialMaterial Steel01 1 10 1000 0.1\nelement zeroLength 7 1 2 -mat 1 -dir 1\n";
    e.open(
        "m.tcl",
        &format!("model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 0\n{bearing}{}", beam.replace("1 2 0.1", "1 4 0.1")),
    );
    let lenses = e.request("textDocument/codeLens", json!({ "textDocument": { "uri": e.uri("m.tcl") } }));
    let titles: Vec<&str> =
        lenses.as_array().unwrap().iter().map(|l| l["command"]["title"].as_str().unwrap()).collect();
    assert_eq!(titles, ["Run", "View", "Check", "Plot the loop of bearing 7"]);
    assert_eq!(lenses[3]["range"]["start"], json!({ "line": 4, "character": 0 }));
    assert_eq!(lenses[3]["command"]["arguments"][2], 7);
}

#[test]
fn tokens_have_their_kinds() {
    let mut e = Editor::new();
    e.open("m.tcl", "# a\nfix 1 $b\n");
    let tokens = e.request("textDocument/semanticTokens/full", json!({ "textDocument": { "uri": e.uri("m.tcl") } }));
    assert_eq!(tokens["data"], json!([0, 0, 3, 6, 0, 1, 0, 3, 0, 0, 0, 4, 1, 5, 0, 0, 2, 2, 4, 0]));
}

#[test]
fn an_endless_script_and_a_missing_file_end() {
    let mut e = Editor::with(json!({ "timeLimit": 0.5 }));
    let told = short(&e.open("m.tcl", "model basic -ndm 1\nnode 1 x\nwhile 1 { set a 1 }\n"));
    assert!(told.iter().any(|t| t.starts_with("2:8-9 not-a-number")), "{told:?}");
    // By the clock, or by the number of commands on a fast machine.
    assert!(told.iter().any(|t| t.contains("the check was stopped here, after")), "{told:?}");
    // The thread goes on with the next text.
    e.replace("m.tcl", 2, "source nowhere.tcl\nexec rm -rf /\nset f [open out.txt w]; puts $f 1; close $f\n");
    let told = short(&e.diagnostics("m.tcl", 2));
    assert!(told.iter().any(|t| t.starts_with("1:8-19") && t.contains("no such file")), "{told:?}");
    assert!(!e.folder.join("out.txt").exists());
    assert_eq!(e.end(), Ok(()));
}

#[test]
fn what_is_half_typed_keeps_what_was_known() {
    let mut e = Editor::new();
    e.open("m.tcl", PORTAL);
    e.edit("m.tcl", 2, [6, 0, 6, 0], "pattern Plain 9 5 {\n");
    let told = short(&e.diagnostics("m.tcl", 2));
    assert!(told.iter().any(|t| t.contains("never-closed")), "{told:?}");
    assert!(e.hover("m.tcl", 17, 35).contains("from node 1 (0, 0) to node 3 (0, 3)"));
    let close = json!({ "textDocument": { "uri": e.uri("m.tcl") } });
    e.notify("textDocument/didClose", close.clone());
    assert_eq!(
        e.request(
            "textDocument/hover",
            json!({ "textDocument": close["textDocument"], "position": { "line": 0, "character": 0 } })
        ),
        Json::Null
    );
    assert_eq!(e.request("no/such", json!({}))["error"], "no/such is not known");
}

#[test]
fn a_study_is_checked_with_its_keys() {
    let mut e = Editor::new();
    e.write("m.tcl", "pset k 1.0\n");
    let study = "model = \"m.tcl\"\n[[parameter]]\nname = \"k\"\nlower = 0.5\nuper = 2\n[[run]]\nname = \"a\"\nrecording = \"a.csv\"\n";
    let told = short(&e.open("study.toml", study));
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(told[0].starts_with("5:1-5 - unknown key \"uper\""), "{told:?}");
    assert!(e.hover("study.toml", 3, 1).contains("Least value."));
    let keys = e.complete("study.toml", 4, 0);
    assert!(labels(&keys).contains(&"upper") && !labels(&keys).contains(&"recording"), "{keys:?}");
    assert_eq!(short(&e.open("Cargo.toml", "[package]\nname = 1\n")), [] as [&str; 0]);
}

/// An isolated building with forty mistakes: each is told once, at the word that stands behind its number.
#[test]
fn forty_mistakes_are_told() {
    let text = include_str!("inputs/forty_mistakes.tcl");
    let mut e = Editor::new();
    let mut wrong: Vec<String> = vec![];
    let told = e.open("m.tcl", text);
    let mut left: Vec<(u64, &str)> = vec![];
    for d in &told {
        let (start, end) = (&d["range"]["start"], &d["range"]["end"]);
        let line = start["line"].as_u64().unwrap();
        let place = start["character"].as_u64().unwrap() as usize..end["character"].as_u64().unwrap() as usize;
        left.push((line, &text.lines().nth(line as usize).unwrap()[place]));
    }
    let mut marked = 0;
    for (n, line) in text.lines().enumerate() {
        let Some((_, mark)) = line.split_once(";# ").filter(|(_, m)| m.ends_with('`')) else { continue };
        marked += 1;
        let word = mark.trim_end_matches('`').rsplit('`').next().unwrap();
        // A command that lacks a word is told of as a whole.
        let found = left.iter().position(|(l, at)| *l == n as u64 && at.split(' ').next() == Some(word));
        match found {
            Some(i) => drop(left.remove(i)),
            None => wrong.push(format!("{line}: not told")),
        }
    }
    wrong.extend(left.iter().map(|(n, at)| format!("line {}: {at} is no mistake", n + 1)));
    assert_eq!((marked, wrong), (40, vec![]), "{}", short(&told).join("\n"));
    // Each has a page of its own: "hysteron explain CODE".
    let without: Vec<_> = told.iter().filter(|d| !d["code"].is_string()).collect();
    assert!(without.is_empty(), "without a code: {without:?}");
}

#[test]
fn keys_of_an_isolation_study_are_told() {
    let mut e = Editor::new();
    let study = "script = \"m.tcl\"\ngravity = 9.81\ntarget = [\"asce7\"]\n[[bearing]]\nname = \"A\"\ntgas = [1]\n";
    let told = short(&e.open("study.toml", study));
    assert!(told[0].starts_with("6:1-5 - unknown key \"tgas\""), "{told:?}");
    assert!(e.hover("study.toml", 1, 2).contains("Acceleration of gravity"));
    assert!(e.hover("study.toml", 4, 2).contains("Name, which the script finds"));
    assert!(labels(&e.complete("study.toml", 5, 0)).contains(&"k_d"));
    let plan = "scripts = [\"m.tcl\"]\nresults = 3\n";
    let told = short(&e.open("plan.toml", plan));
    assert!(told[0].starts_with("2:11-12 - invalid type"), "{told:?}");
}

/// A file of Python with a mistake in a call.
const PYTHON: &str = "\
import openseespy.opensees as ops
L = 6.0
ops.model('basic', '-ndm', 2, '-ndf', 3)
ops.node(1, 0.0, 0.0)
ops.node(2, L, 'x')
ops.node(3, L, 0.0)
ops.geomTransf('Linear', 7)
ops.element('elasticBeamColumn', 11, 1, 3, 0.1, 2e8, 1e-3, 7)
";

#[test]
fn calls_in_files_of_python_are_commands() {
    let mut e = Editor::new();
    let told = e.open("m.py", PYTHON);
    assert_eq!(short(&told), ["5:16-19 not-a-number y coordinate is not a number: \"x\""]);
    e.edit("m.py", 2, [4, 15, 4, 18], "3.0");
    assert_eq!(short(&e.diagnostics("m.py", 2)), [] as [&str; 0]);
    assert!(e.hover("m.py", 3, 5).contains("node $tag"));
    assert!(e.hover("m.py", 7, 20).contains("Elastic beam, Euler-Bernoulli"));
    assert!(
        e.hover("m.py", 7, 34).contains("**element 11**") && e.hover("m.py", 7, 37).contains("**node 1** at (0, 0)")
    );
    let mut ask = |method: &str, line, character| {
        let more = json!({ "context": { "includeDeclaration": true } });
        places(&e.at(&format!("textDocument/{method}"), "m.py", line, character, more))
    };
    assert_eq!(ask("definition", 7, 40), ["6:10-11"]);
    assert_eq!(ask("references", 5, 10), ["6:10-11", "8:41-42"]);
    assert_eq!(ask("references", 6, 26), ["7:26-27", "8:60-61"]);
    let answer = e.at("textDocument/rename", "m.py", 6, 26, json!({ "newName": "9" }));
    assert_eq!(places(&answer["changes"][e.uri("m.py")]), ["7:26-27", "8:60-61"]);
    assert_eq!(e.end(), Ok(()));
}

#[test]
fn commands_and_kinds_are_offered_in_files_of_python() {
    let mut e = Editor::new();
    e.open("m.py", PYTHON);
    let mut version = 1;
    let mut offered = |e: &mut Editor, text: &str| {
        version += 1;
        e.replace("m.py", version, &format!("{PYTHON}{text}"));
        e.complete("m.py", 8, text.len() as u32)
    };
    let commands = offered(&mut e, "ops.ele");
    let element = commands.iter().find(|i| i["label"] == "element").unwrap();
    assert_eq!(element["textEdit"]["newText"], "element");
    assert!(!labels(&commands).contains(&"foreach"));
    let kinds = offered(&mut e, "ops.uniaxialMaterial('Ste");
    let steel = kinds.iter().find(|i| i["label"] == "Steel01").unwrap();
    assert_eq!(steel["textEdit"]["newText"], "Steel01");
    let kinds = offered(&mut e, "ops.uniaxialMaterial(");
    assert_eq!(kinds.iter().find(|i| i["label"] == "Steel01").unwrap()["textEdit"]["newText"], "'Steel01'");
    let nodes = offered(&mut e, "ops.element('elasticBeamColumn', 12, ");
    assert!(labels(&nodes).contains(&"3") && labels(&nodes).contains(&"-mass"), "{nodes:?}");
    assert_eq!(offered(&mut e, "print(").len(), 0);
    let call = "ops.node(";
    offered(&mut e, call);
    let help = e.at("textDocument/signatureHelp", "m.py", 8, call.len() as u32, json!({}));
    assert!(help["signatures"][0]["label"].as_str().unwrap().starts_with("node $tag"), "{help}");
}

/// Numbers of an isolation study have places before anything is saved.
#[test]
fn values_of_an_isolation_study_are_told_at_the_value() {
    let mut e = Editor::new();
    let study = |gravity: &str, tags: &str, factor: &str| {
        format!(
            "script = \"m.tcl\"\ngravity = {gravity}\ntarget = [\"asce7\"]\n[[bearing]]\nname = \"A\"\ntags = {tags}\n\
             [bearing.upper]\naging = [1.0, {factor}]\n[[motion]]\nfiles = [\"a.txt\"]\n"
        )
    };
    let mut told = |n: i64, text: &str| {
        if n == 1 {
            return short(&e.open("study.toml", text));
        }
        e.replace("study.toml", n, text);
        short(&e.diagnostics("study.toml", n))
    };
    assert_eq!(told(1, &study("-9.81", "[1]", "1.2")), ["2:11-16 - gravity is -9.81: expected more than 0"]);
    assert_eq!(told(2, &study("9.81", "[1, 2, 1]", "1.2")), ["6:15-16 - the bearing 1 is listed twice"]);
    assert_eq!(told(3, &study("9.81", "[1]", "-1.2")), ["8:9-20 - a factor of A is -1.2: expected more than 0"]);
    assert_eq!(told(4, &study("9.81", "[1]", "1.2")), [] as [&str; 0]);
}
