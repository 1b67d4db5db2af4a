//! What an isolation study decides: rules by hand beside its files, differences of results, drafts, draws of properties.

use super::Place;
use serde_json::Value;
use std::fs;

const INPUTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tcl-like-inputs");

/// The shipped study with paths that are found from any folder, and with some of its text replaced.
fn changed(changes: &[(&str, &str)]) -> String {
    let folder = format!("{INPUTS}/isolation_study");
    let mut text = fs::read_to_string(format!("{folder}/study.toml")).unwrap();
    text = text.replace("\"building.tcl\"", &format!("\"{folder}/building.tcl\""));
    text = text.replace("\"../ground_motions", &format!("\"{INPUTS}/ground_motions"));
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    text
}

/// One motion and no eccentricity: three analyses.
const SMALL: [(&str, &str); 2] = [
    ("eccentricities = [[0.0, 0.0], [0.05, 0.05]]\n", ""),
    (
        "[[motion]]\nname = \"Rio Dell 1992\"\nfiles = [\"FOLDER/riodell_1992_360_g.txt\"]\nunit = \"g\"\ndt = 0.02\n",
        "",
    ),
];

fn small(more: &[(&str, &str)]) -> String {
    let motion = SMALL[1].0.replace("FOLDER", &format!("{INPUTS}/ground_motions"));
    let mut all = vec![SMALL[0], (motion.as_str(), "")];
    all.extend(more);
    changed(&all)
}

fn result(place: &Place, folder: &str) -> Value {
    serde_json::from_str(&fs::read_to_string(place.0.join(folder).join("isolation.json")).unwrap()).unwrap()
}

/// Row of a table of a result by its first columns.
fn row<'a>(result: &'a Value, table: &str, keys: &[(&str, &str)]) -> &'a Value {
    let rows = result[table].as_array().unwrap();
    let found = rows.iter().find(|r| keys.iter().all(|(k, v)| r[*k] == *v));
    found.unwrap_or_else(|| panic!("{table} has no row {keys:?}: {rows:?}"))
}

fn near(got: f64, expected: f64) {
    assert!((got / expected - 1.0).abs() < 1e-6, "{got}, not {expected}");
}

/// Rules of ASCE 7-16 made again from the numbers of the result.
#[test]
fn rules_by_hand() {
    let place = Place::new();
    place.write(
        "study.toml",
        small(&[(
            "response_modification = 2.0",
            "response_modification = 4.0\nlive = { over_dead = 0.2, in_script = 0.5 }\nmembers = [100, 102]",
        )]),
    );
    let (status, printed, said) = place.run(&["isolate", "study.toml", "--out", "out"]);
    assert_eq!(status, Some(0), "{said}");
    let r = result(&place, "out");
    ends_with_a_summary(&printed, &r);
    let elf =
        |quantity: &str, bound: &str| row(&r, "lateral_force", &[("quantity", quantity)])[bound].as_f64().unwrap();
    let fixed = r["modes"].as_array().unwrap().iter().filter(|m| m["structure"] == "fixed base");
    let t_fb = fixed.map(|m| m["T"].as_f64().unwrap()).fold(0.0, f64::max);
    let share: f64 = 3.0 / 4.0;
    for bound in ["lower", "nominal", "upper"] {
        let beta = elf("beta_M", bound);
        near(elf("V_st", bound), elf("V_b", bound) * share.powf(1.0 - 2.5 * beta));
        near(elf("R_I", bound), 1.5);
        // Upper bound: Q_d by 1.15·1.3, K_d by (1 + 0.75·0.1)·1.15·1.05; or 1.5 times nominal, which is more here.
        let yields = |q: f64, k: f64| 9.0 * (26.0 * q + 440.0 * k * 0.0066);
        let most = yields(1.495, 1.075 * 1.15 * 1.05).max(1.5 * yields(1.0, 1.0));
        near(elf("V_s by activation", bound), most * share.powf(1.0 - 2.5 * beta));
        near(elf("V_s on a fixed base", bound), 2.0 / 3.0 * 0.6 / elf("T_M", "upper") / 4.0 * 3.0 * 1177.2);
        let v_s = elf("V_s", bound);
        near(
            v_s,
            (elf("V_st", bound) / 1.5).max(elf("V_s by activation", bound)).max(elf("V_s on a fixed base", bound)),
        );
        let k = elf("k of the heights", bound);
        near(k, 14.0 * beta * t_fb);
        let sum: f64 = (1..=3).map(|n| f64::powf(f64::from(n), k)).sum();
        for (n, node) in ["F at node 101", "F at node 102", "F at node 103"].iter().enumerate() {
            near(elf(node, bound), v_s * f64::powf((n + 1) as f64, k) / sum);
        }
        near(elf("F at node 100", bound), (elf("V_b", bound) - elf("V_st", bound)) / 1.5);
        let least = row(&r, "design_values", &[("quantity", "displacement of bearings"), ("bound", bound)]);
        // The plan formula gives 1.15 D_M for this plan: corners of a grid of 12 m on a plan of 12 m.
        let reduced = elf("D_M", bound) / (1.0 + (t_fb / elf("T_M", bound)).powi(2)).sqrt();
        near(least["least"].as_f64().unwrap(), 0.8 * 1.15 * reduced);
    }
    // Gravity holds D + 0.5 L with L = 0.2 D. S_MS is that of the target.
    let loads = row(&r, "loads", &[("type", "LRB")]);
    let n = |key: &str| loads[key].as_f64().unwrap();
    near(n("D"), 523.2 / 1.1);
    near(n("average"), 523.2);
    near(n("largest"), 1.4 * n("D") + n("L") + n("Q_E up"));
    near(n("least"), 0.7 * n("D") - n("Q_E down"));
    // Local end forces of two storeys by combination, and the weights that the lowest one carries.
    let members = fs::read_to_string(place.0.join("out/members.csv")).unwrap();
    let rows: Vec<Vec<&str>> = members.lines().skip(1).map(|l| l.split(',').collect()).collect();
    assert_eq!(rows.len(), 24, "{members}");
    let x = |i: usize, k: usize| rows[i][k].parse::<f64>().unwrap();
    near(x(0, 2), 3.0 * 1177.2);
    let (dead, live) = (x(0, 2) / 1.1, 0.2 * x(0, 2) / 1.1);
    near(x(0, 7), 1.4 * dead + live + x(0, 3));
    near(x(0, 10), 0.7 * dead + x(0, 5));
    assert!(x(1, 3) > 100.0 && x(1, 5) < -100.0, "{members}");
    floors_and_supports_by_hand(&place, &r);
    lateral_drift_by_hand(&place, &r);
    let size = fs::metadata(place.0.join("out/isolation.json")).unwrap().len();
    assert!(size < 100_000, "{size}");
    let page = fs::read_to_string(place.0.join("out/report.html")).unwrap();
    for part in
        ["Key plan", "Design values", "Bearing schedule", "Mean over target", "Not checked", "engineer of record"]
    {
        assert!(page.contains(part), "{part}");
    }
    let histories = r["analyses"][0]["histories"].as_str().unwrap();
    assert!(place.0.join("out").join(histories).is_file(), "{histories}");
}

/// The terminal's last lines: the design displacement of the worst bound, all checks that are not met, the report.
fn ends_with_a_summary(printed: &str, r: &Value) {
    let lines: Vec<&str> = printed.lines().collect();
    let parts = |heading: &'static str| {
        let found = lines.iter().filter_map(move |l| l.trim_start().strip_prefix(heading)?.strip_prefix("  "));
        found.map(str::trim).collect::<Vec<_>>()
    };
    let values = r["design_values"].as_array().unwrap().iter();
    let of_bearings = values.filter(|v| v["quantity"] == "displacement of bearings");
    let largest = of_bearings.max_by(|a, b| a["design"].as_f64().unwrap().total_cmp(&b["design"].as_f64().unwrap()));
    let (value, rest) = parts("design displacement")[0].split_once(' ').unwrap();
    assert!((value.parse::<f64>().unwrap() / largest.unwrap()["design"].as_f64().unwrap() - 1.0).abs() < 1e-4);
    assert_eq!(rest, format!("m, {} bound", largest.unwrap()["bound"].as_str().unwrap()));
    let missed = r["checks"].as_array().unwrap().iter().filter(|c| c["result"] == "NOT MET");
    // One bound of each kind of check is told.
    let kinds = missed.map(|c| c["check"].as_str().unwrap().split(": ").last().unwrap());
    let told = parts("not met");
    let is_told = |kind: &str| told.iter().any(|t| t.contains(kind));
    assert!(!told.is_empty() && kinds.clone().all(is_told), "{:?} {printed}", kinds.collect::<Vec<_>>());
    assert_eq!(lines.last().unwrap().split_whitespace().collect::<Vec<_>>(), ["report", "out/report.html"]);
}

/// Rows of a table of results by the names of their columns.
fn table(place: &Place, file: &str) -> Vec<std::collections::BTreeMap<String, String>> {
    let text = fs::read_to_string(place.0.join("out").join(file)).unwrap();
    // Names with commas are quoted.
    let split = |line: &str| {
        let mut quoted = false;
        line.split(|c| {
            quoted ^= c == '"';
            c == ',' && !quoted
        })
        .map(|w| w.trim_matches('"').to_owned())
        .collect::<Vec<_>>()
    };
    let heads: Vec<String> = split(text.lines().next().unwrap());
    text.lines().skip(1).map(|l| heads.iter().cloned().zip(split(l)).collect()).collect()
}

/// Vertical loads of floors and moments of bearings by load combination. Gravity holds D + 0.5 L with L = 0.2 D.
fn floors_and_supports_by_hand(place: &Place, r: &Value) {
    let floors = table(place, "diaphragms.csv");
    assert_eq!(floors.len(), 4);
    let of = |row: &std::collections::BTreeMap<String, String>, head: &str| -> f64 {
        let found = row.iter().find(|(k, _)| k.starts_with(head)).unwrap_or_else(|| panic!("{head}: {row:?}"));
        found.1.parse().unwrap()
    };
    let (dead, live) = (1177.2 / 1.1, 0.2 * 1177.2 / 1.1);
    for row in &floors {
        near(of(row, "most dead, vertical"), 1.4 * dead + live);
        near(of(row, "least dead, vertical"), 0.7 * dead);
        let most = ["lower", "nominal", "upper"]
            .map(|b| (of(row, &format!("{b} inertia")) / 1.5).max(of(row, &format!("{b} F_x"))));
        near(of(row, "horizontal"), most.into_iter().fold(0.0, f64::max));
    }
    // Bearings of 0.3 m: half of V h and of P D at either end.
    let bearing = &table(place, "below.csv")[0];
    let schedule = row(r, "schedule", &[("type", "LRB")]);
    let n = |key: &str| schedule[key].as_f64().unwrap();
    near(of(bearing, "V h/2"), 0.5 * n("V design") * 0.3);
    near(of(bearing, "most dead, P D/2"), 0.5 * n("P max") * n("D design"));
    near(of(bearing, "most dead, moment"), 0.5 * (n("V design") * 0.3 + n("P max") * n("D design")));
}

/// F_x on the script with bearings that do not move, in a static analysis of its own.
fn lateral_drift_by_hand(place: &Place, r: &Value) {
    let script = fs::read_to_string(format!("{INPUTS}/isolation_study/building.tcl")).unwrap();
    let (model, _) =
        script.split_once("# ---------------------------------------------------------------- earthquake\n").unwrap();
    let model = model.replace("[expr {10.0*$Kd}] $Qd", "1.0e9 1.0e9");
    for bound in ["lower", "upper"] {
        let force = |node: &str| row(r, "lateral_force", &[("quantity", node)])[bound].as_f64().unwrap();
        let loads: String = ["101", "102", "103"]
            .map(|n| format!("load {n} {} 0 0 0 0 0\n", force(&format!("F at node {n}"))))
            .concat();
        place.write(
            "static.tcl",
            format!(
                "{model}\ntimeSeries Linear 9\npattern Plain 9 9 {{ {loads} }}\nconstraints Transformation\nnumberer RCM\n\
                 system UmfPack\nalgorithm Linear\nintegrator LoadControl 1.0\nanalysis Static\nanalyze 1\n\
                 foreach n {{101 102 103}} {{ puts [expr {{[nodeDisp $n 1] - [nodeDisp [expr {{$n - 1}}] 1]}}] }}\n"
            ),
        );
        let (status, printed, said) = place.run(&["run", "static.tcl"]);
        assert_eq!(status, Some(0), "{said}");
        let most = printed.lines().filter_map(|l| l.parse::<f64>().ok()).fold(0.0, f64::max);
        let subject =
            format!("{bound}: storey drift ratio of F_x times R_I, equivalent lateral force as the only procedure");
        let check = row(r, "checks", &[("check", subject.as_str())]);
        let found = check["demand"].as_f64().unwrap();
        assert!((found / (1.5 * most / 3.5) - 1.0).abs() < 1e-3, "{bound}: {found}, {printed}");
        near(check["limit"].as_f64().unwrap(), 0.015);
    }
}

/// A least value of a dynamic procedure is no failure: the factor and the design value are given, and the capacity is checked
/// with it.
#[test]
fn results_below_a_least_value_are_scaled() {
    let place = Place::new();
    place.write("study.toml", small(&[("unit = \"g\"", "unit = \"g\"\nfactor = 0.3"), ("scale = [1.5, 3.5]\n", "")]));
    let (status, _, said) = place.run(&["isolate", "study.toml", "--out", "out"]);
    assert_eq!(status, Some(0), "{said}");
    let r = result(&place, "out");
    let value = row(&r, "design_values", &[("quantity", "displacement of bearings"), ("bound", "lower")]);
    let n = |key: &str| value[key].as_f64().unwrap();
    assert!(n("factor") > 1.5, "{value}");
    near(n("design"), n("least"));
    near(n("design"), n("factor") * n("suite"));
    let checks = r["checks"].as_array().unwrap();
    let scaled: Vec<&Value> = checks.iter().filter(|c| c["result"] == "scaled up").collect();
    assert!(scaled.iter().any(|c| c["check"].as_str().unwrap().contains("scaled by")), "{checks:?}");
    let capacity = checks.iter().find(|c| c["check"] == "LRB: design displacement against capacity").unwrap();
    near(capacity["demand"].as_f64().unwrap(), n("design"));
}

/// A third component is vertical: the script finds it in isolate(az), and it stands for the part of S_MS.
#[test]
fn a_vertical_component_is_applied() {
    let place = Place::new();
    let motion = format!("\"{INPUTS}/ground_motions/meloland_1979_360_g.txt\"]");
    let three = motion.replace(']', &format!(", {motion}"));
    let study = small(&[(motion.as_str(), three.as_str())]);
    place.write("study.toml", &study);
    let (status, _, said) = place.run(&["check", "study.toml"]);
    assert!(status == Some(2) && said.contains("in z (isolate(az)") && said.contains("ratio 0.0000"), "{said}");
    let script = fs::read_to_string(format!("{INPUTS}/isolation_study/building.tcl")).unwrap();
    let horizontal = "pattern UniformExcitation 3 2 -accel 3\n";
    let vertical = "timeSeries Path 4 -dt $isolate(dt) -values $isolate(az)\npattern UniformExcitation 4 3 -accel 4\n";
    place.write("building.tcl", script.replace(horizontal, &format!("{horizontal}{vertical}")));
    let folder = format!("{INPUTS}/isolation_study/building.tcl");
    place.write("study.toml", study.replace(&folder, "building.tcl"));
    let (status, _, said) = place.run(&["isolate", "study.toml", "--out", "out"]);
    assert!(status == Some(0) && !said.contains("isolate(az)"), "{said}");
    let r = result(&place, "out");
    let loads = row(&r, "loads", &[("type", "LRB")]);
    let n = |key: &str| loads[key].as_f64().unwrap();
    near(n("largest"), 1.2 * n("D") + n("Q_E up"));
    // The vertical motion alone moves the bearing in the middle, which overturning leaves at rest.
    let middle = &r["loads"][4];
    assert!(middle["Q_E up"].as_f64().unwrap() > 10.0, "{middle}");
}

/// Displacements of isolators are magnified by EN 1998: 1.2 in buildings, 1.5 in bridges.
#[test]
fn displacements_are_magnified_by_the_kind_of_structure() {
    let place = Place::new();
    for (structure, factor) in [("building", 1.2), ("bridge", 1.5)] {
        let code = format!("code = \"en1998\"\nstructure = \"{structure}\"");
        place.write("study.toml", small(&[("code = \"asce7-16\"", &code)]));
        let (status, _, said) = place.run(&["isolate", "study.toml", "--out", structure]);
        assert_eq!(status, Some(0), "{said}");
        let r = result(&place, structure);
        for b in r["schedule"].as_array().unwrap() {
            near(b["D design"].as_f64().unwrap(), factor * b["D"].as_f64().unwrap());
        }
    }
}

/// A change of the target and of a bearing is shown; equal results have no difference.
#[test]
fn two_results_are_compared() {
    let place = Place::new();
    place.write("a.toml", small(&[]));
    // Another path of the same text is the same script; a line more makes another one.
    let script = fs::read_to_string(format!("{INPUTS}/isolation_study/building.tcl")).unwrap();
    place.write("longer.tcl", script + "# One line more.\n");
    let own = format!("{INPUTS}/isolation_study/building.tcl");
    let b = small(&[("\"sm1=0.6\"", "\"sm1=0.75\""), ("displacement = 0.35", "displacement = 0.45")]);
    place.write("b.toml", b.replace(&own, "longer.tcl"));
    for name in ["a", "b"] {
        let (status, _, said) = place.run(&["isolate", &format!("{name}.toml"), "--out", name]);
        assert_eq!(status, Some(0), "{said}");
    }
    let (status, printed, said) = place.run(&["isolate", "a", "--compare", "b"]);
    assert_eq!(status, Some(0), "{said}");
    for part in ["study  script", "sm1=0.75", "LRB  displacement", "T_M", "design displacement against capacity"] {
        let words: Vec<&str> = part.split("  ").collect();
        assert!(printed.lines().any(|l| words.iter().all(|w| l.contains(w))), "{part}: {printed}");
    }
    let (_, printed, _) = place.run(&["isolate", "a", "--compare", "a/isolation.json"]);
    assert!(printed.contains("0 values differ"), "{printed}");
    let (status, _, said) = place.run(&["isolate", "a", "--compare", "nowhere"]);
    assert!(status == Some(2) && said.contains("nowhere"), "{said}");
}

/// A draft from the script, filled in, has the same bearings, floors and weight as the shipped study.
#[test]
fn a_study_is_drafted_from_the_script() {
    let place = Place::new();
    place.write("building.tcl", fs::read_to_string(format!("{INPUTS}/isolation_study/building.tcl")).unwrap());
    fs::create_dir_all(place.0.join("../ground_motions")).ok();
    let script = fs::read_to_string(place.0.join("building.tcl")).unwrap();
    place.write(
        "building.tcl",
        script.replace("[file join $here .. ground_motions]", &format!("{{{INPUTS}/ground_motions}}")),
    );
    let (status, _, said) = place.run(&["init", "--isolation", "building.tcl", "--out", "draft.toml"]);
    assert_eq!(status, Some(0), "{said}");
    let draft = fs::read_to_string(place.0.join("draft.toml")).unwrap();
    for part in ["gravity = 9.81", "tags = [1, 2, 3, 4, 5, 6, 7, 8, 9]", "node = 103", "plan = [12.0, 12.0]"] {
        assert!(draft.contains(part), "{part}: {draft}");
    }
    let (motions, files) =
        (format!("{INPUTS}/ground_motions/riodell_1992_360_g.txt"), "files = [\"TODO_x.at2\", \"TODO_y.at2\"]");
    let filled = draft
        .replace("name = \"B1\"", "name = \"LRB\"")
        .replace(files, &format!("files = [\"{motions}\"]\nunit = \"g\"\ndt = 0.02"));
    place.write("filled.toml", filled);
    let (status, printed, said) = place.run(&["check", "filled.toml"]);
    assert_eq!(status, Some(0), "{said}");
    assert!(printed.contains("4708.8") && printed.contains("from the script"), "{printed}");
    let (status, _, said) = place.run(&["init", "--isolation", "building.tcl", "--out", "draft.toml"]);
    assert!(status == Some(2) && said.contains("exists already"), "{said}");
    place.write("frame.tcl", "model basic -ndm 2 -ndf 3\nnode 1 0 0\nanalyze 1 0.1\n");
    let (status, _, said) = place.run(&["init", "--isolation", "frame.tcl", "--out", "other.toml"]);
    assert!(status == Some(2) && !place.0.join("other.toml").exists(), "{said}");
}

/// A spring beside the bearings that the study does not name changes the period of the model.
#[test]
fn a_spring_across_the_isolation_plane_is_found() {
    let place = Place::new();
    let script = fs::read_to_string(format!("{INPUTS}/isolation_study/building.tcl")).unwrap();
    let storeys = "# ---------------------------------------------------------------- storeys\n";
    assert!(script.contains(storeys));
    let spring = "node 999 0.0 0.0 0.3\nfix 999 1 1 1 1 1 1\nuniaxialMaterial Elastic 999 5000.0\n\
                  element zeroLength 999 999 25 -mat 999 999 -dir 1 2\n";
    place.write("building.tcl", script.replace(storeys, &format!("{spring}{storeys}")));
    let folder = format!("{INPUTS}/isolation_study/building.tcl");
    place.write("study.toml", small(&[]).replace(&folder, "building.tcl"));
    for command in ["check", "isolate"] {
        let (status, _, said) = place.run(&[command, "study.toml"]);
        assert_eq!(status, Some(2), "{said}");
        assert!(said.contains("the period of the model in x") && said.contains("bridge the isolation plane"), "{said}");
    }
}

/// The script's place in a contradiction is the line of the element.
#[test]
fn a_contradiction_names_the_line_of_the_element() {
    let place = Place::new();
    place.write("study.toml", small(&[("q_d = 26.0", "q_d = 52.0")]));
    let (_, _, said) = place.run(&["check", "study.toml"]);
    let script = fs::read_to_string(format!("{INPUTS}/isolation_study/building.tcl")).unwrap();
    let line = 1 + script.lines().position(|l| l.contains("element elastomericBearingBoucWen")).unwrap();
    assert!(said.contains(&format!("building.tcl:{line}, element")), "{said}");
}

/// Draws of the properties: the same for any number of threads, around the nominal result, and of a type that exists.
#[test]
fn draws_of_the_properties_give_percentiles() {
    let place = Place::new();
    place.write("study.toml", small(&[]));
    place
        .write("p.json", "{\"median\": [1.0, 1.0], \"dispersion\": [0.1, 0.05], \"correlation\": 0.5, \"cycles\": 12}");
    for threads in ["1", "2"] {
        let words = [
            "isolate",
            "study.toml",
            "--posterior",
            "LRB=p.json",
            "--draws",
            "5",
            "--threads",
            threads,
            "--out",
            threads,
        ];
        let (status, printed, said) = place.run(&words);
        assert_eq!(status, Some(0), "{said}");
        assert!(printed.contains("LRB: displacement") && printed.contains("5 draws, 0 without"), "{printed}");
    }
    for file in ["percentiles.csv", "draws.csv"] {
        let [one, two] = ["1", "2"].map(|t| fs::read_to_string(place.0.join(t).join(file)).unwrap());
        assert!(one == two && one.lines().count() > 4, "{file}: {one}");
    }
    percentiles_by_hand(&place.0.join("1"));
    place.write(
        "none.json",
        "{\"median\": [1.0, 1.0], \"dispersion\": [0.0, 0.0], \"correlation\": 0.0, \"cycles\": 3}",
    );
    let words = ["isolate", "study.toml", "--posterior", "LRB=none.json", "--draws", "1", "--out", "none", "--json"];
    let (status, printed, said) = place.run(&words);
    assert_eq!(status, Some(0), "{said}");
    let rows: Value = serde_json::from_str(&printed).unwrap();
    // Without scatter only the mean of the factors of aging is left: (1 + 1.075)/2 on K_d.
    assert!(rows[0]["50 %"].as_f64().unwrap() > 0.1, "{printed}");
    // Draws of a calibration: Q_d and K_d of one draw stay together.
    place.write(
        "calibration.json",
        "{\"parameters\": {\"Fy\": 26.0, \"k\": 4400.0, \"b\": 0.1}, \"posterior\": {\"quantiles\": [{\"name\": \"Fy\"}, {\"name\": \"k\"}], \
         \"draws\": [[20.8, 4400.0], [31.2, 4840.0]]}}",
    );
    let words = ["isolate", "study.toml", "--draws", "4", "--out", "calibrated", "--posterior"];
    let (status, _, said) = place.run(&[&words[..], &["LRB=calibration.json;q_d=Fy;k_d=b*k"]].concat());
    assert_eq!(status, Some(0), "{said}");
    let draws = fs::read_to_string(place.0.join("calibrated/draws.csv")).unwrap();
    for line in draws.lines().skip(1) {
        let x: Vec<f64> = line.split(',').filter_map(|w| w.parse().ok()).collect();
        let k = x[2] / (0.5 * (1.0 + 1.075));
        assert!(
            ((x[1] - 0.8).abs() < 1e-9 && (k - 1.0).abs() < 1e-9)
                || ((x[1] - 1.2).abs() < 1e-9 && (k - 1.1).abs() < 1e-9),
            "{line}"
        );
    }
    let (status, _, said) = place.run(&[&words[..], &["LRB=calibration.json;q_d=Fy;k_d=k"]].concat());
    assert!(status == Some(2) && said.contains("a ratio of 11"), "{said}");
    let (status, _, said) = place.run(&["isolate", "study.toml", "--posterior", "LRX=p.json"]);
    assert!(status == Some(2) && said.contains("did you mean LRB"), "{said}");
}

/// Percentiles of the five draws, linear between their ranks.
fn percentiles_by_hand(folder: &std::path::Path) {
    let cells = |file: &str| -> Vec<Vec<String>> {
        let text = fs::read_to_string(folder.join(file)).unwrap();
        text.lines().map(|l| l.split(',').map(str::to_owned).collect()).collect()
    };
    let draws = cells("draws.csv");
    // The head has Q,LRB and K,LRB in quotes, so that places are counted from the end.
    let from_end = draws[0].iter().rev().position(|h| h.starts_with("LRB: displacement")).unwrap();
    let mut values: Vec<f64> = draws[1..].iter().map(|row| row[row.len() - 1 - from_end].parse().unwrap()).collect();
    values.sort_by(f64::total_cmp);
    assert_eq!(values.len(), 5);
    let rows = cells("percentiles.csv");
    let row = rows.iter().find(|r| r[0] == "LRB: displacement").unwrap();
    for (place, share) in [0.05, 0.16, 0.5, 0.84, 0.95].into_iter().enumerate() {
        let (rank, part) = ((4.0_f64 * share).floor() as usize, (4.0_f64 * share).fract());
        let by_hand = values[rank] + part * (values[rank + 1] - values[rank]);
        near(row[2 + place].parse().unwrap(), by_hand);
    }
}

/// Piers that are softer across a bridge than along it: the direction with the larger displacement counts, and one number stands for
/// both directions.
#[test]
fn substructures_along_and_across() {
    let place = Place::new();
    let lower = "tension = 0.0\n";
    let displacement = |name: &str, stiffness: &str| -> f64 {
        let value = format!("substructure = {stiffness}\n{lower}");
        place.write("study.toml", changed(&[(lower, value.as_str()), ("code = \"asce7-16\"", "code = \"aashto\"")]));
        let (status, printed, said) = place.run(&["check", "study.toml"]);
        // The model has no such piers, which its period shows.
        assert!(status == Some(2) && said.contains("with the same mass"), "{name}: {printed} {said}");
        let text = said.split("procedure has ").nth(1).and_then(|t| t.split(' ').next()).unwrap();
        text.parse().unwrap()
    };
    let [same, both] = ["800.0", "[800.0, 800.0]"].map(|k| displacement("same", k));
    assert!((same / both - 1.0).abs() < 1e-12 && same > 2.0, "{same} {both}");
    let along = displacement("along", "[800.0, 1.0e9]");
    assert!((along / same - 1.0).abs() < 1e-12, "{along}");
}
