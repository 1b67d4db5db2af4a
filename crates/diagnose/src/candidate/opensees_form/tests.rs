//! Translated repairs respond like the repaired models, or are refused.

use super::{RepairedModelScript, TRANSLATIONS, UNTRANSLATED, opensees_script};
use crate::inspect::insertion::{InsertionPoint, insert};
use crate::inspect::inventory::ModelInventory;
use crate::inspect::probe::record_responses;
use hysteron_engine::analysis::Options;
use hysteron_identify::study::{Role, Score, ScoredRun, ScriptSimulator, Simulator, Study};
use hysteron_tcl::diagnostic::SourceMap;
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use std::sync::Arc;

/// A pad under an imposed displacement of 60 mm: an elastic-plastic spring and an elastic one.
const PAD: &str = "wipe\nmodel basic -ndm 1 -ndf 1\npset k 300.0\nnode 1 0.\nnode 2 0.\nfix 1 1\n\
    uniaxialMaterial Steel01 1 11.0 2000.0 0.0\nuniaxialMaterial Elastic 2 $k\nuniaxialMaterial Parallel 3 1 2\n\
    element zeroLength 1 1 2 -mat 3 -dir 1\ntimeSeries Path 1 -dt $dt -filePath $motion\n\
    pattern Plain 1 1 { sp 2 1 0.02 }\nrecorder Element -file out.out -time -ele 1 force\n";
const PAD_ANALYSIS: &str = "constraints Transformation\ntest NormDispIncr 1e-10 30\nalgorithm Newton\n\
    integrator LoadControl $dt\nanalysis Static\nanalyze [expr {$npts-1}]\n";

/// Two storeys on an isolator, shaken.
const SHAKEN: &str = "wipe\nmodel basic -ndm 1 -ndf 1\npset k 400.0\nforeach n {1 2 3} {node $n 0.}\nmass 2 1.0\nmass 3 1.0\n\
    fix 1 1\nuniaxialMaterial Steel01 1 2.0 200.0 0.2\nuniaxialMaterial Elastic 2 $k\n\
    element zeroLength 1 1 2 -mat 1 -dir 1\nelement zeroLength 2 2 3 -mat 2 -dir 1\n\
    timeSeries Path 1 -dt $dt -filePath $motion\npattern UniformExcitation 1 1 -accel 1\n\
    recorder Node -file out.out -time -node 3 -dof 1 disp\n";
const SHAKEN_ANALYSIS: &str = "constraints Plain\nsystem FullGeneral\ntest NormDispIncr 1e-10 30\nalgorithm Newton\n\
    integrator Newmark 0.5 0.25\nanalysis Transient\n\
    for {set i 1} {$i < 20*$npts} {incr i} { if {[analyze 1 [expr {$dt/20}]] != 0} { error \"no convergence\" } }\n";

/// Error that the repaired models leave.
const NMSE: f64 = 1e-3;
/// Sampling interval, s, and number of samples.
const DT: f64 = 0.02;
const SAMPLES: usize = 400;

/// A study of a model in a folder of its own, and its simulator.
fn simulator(name: &str, text: &str) -> (PathBuf, ScriptSimulator) {
    let dir = std::env::temp_dir().join(format!("hysteron-form-{name}-{}", std::process::id()));
    fs::create_dir_all(&dir).expect("a folder");
    let (mut recording, mut motion) = ("time[s],out[m]\n".to_owned(), String::new());
    for i in 0..SAMPLES {
        let t = DT * i as f64;
        let x = t * (0.7 * t).sin() * (5.0 * t).sin();
        writeln!(recording, "{t},{x}").expect("a line");
        writeln!(motion, "{x}").expect("a line");
    }
    let study = format!(
        "model = \"model.tcl\"\n[[parameter]]\nname = \"k\"\nlower = 100.0\nupper = 600.0\n[[run]]\nname = \"run\"\n\
         role = \"fit\"\nrecording = \"run.csv\"\nset = {{ motion = \"run.dat\", dt = {DT}, npts = {SAMPLES} }}\n\
         [[run.observe]]\nchannel = \"out\"\noutput = \"out.out\"\ncolumn = 1\n"
    );
    for (file, content) in [("model.tcl", text), ("run.csv", &recording), ("run.dat", &motion), ("study.toml", &study)]
    {
        fs::write(dir.join(file), content).expect("a file");
    }
    let mut sources = SourceMap::default();
    let mut study = Study::load(&dir.join("study.toml"), &mut sources).expect("a study");
    let mut simulator = ScriptSimulator::new(Arc::new(study.clone()), Options::default(), Arc::default());
    let initial_run = simulator.run_initially(&mut sources).expect("a script");
    // The model as it was stands for the recording, whose variance is the scale of differences.
    let channels = simulator.simulate(0, &initial_run.values).expect("a response");
    let (mean, n) = (channels[0].iter().sum::<f64>() / SAMPLES as f64, SAMPLES as f64);
    let observed = &mut study.runs[0].observe[0];
    observed.variance = channels[0].iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / n;
    let mut simulator = ScriptSimulator::new(Arc::new(study), Options::default(), Arc::default());
    simulator.run_initially(&mut sources).expect("a script");
    (dir, simulator)
}

/// The translated script of a model with commands, or the reason why there is none.
fn attempt(name: &str, [model, analysis]: [&str; 2], commands: &str) -> Result<String, String> {
    let text = [model, analysis].concat();
    let (dir, simulator) = simulator(name, &text);
    let point = InsertionPoint::At(model.len());
    let study = simulator.study().clone();
    let values = [if model == PAD { 300.0 } else { 400.0 }];
    let before = simulator.factory().simulator_of_script(study.clone(), model);
    let inventory = before.inspect_model(0, &values, ModelInventory::from_engine);
    let responses = record_responses(&simulator.factory(), &study, &text, &values, &point, &inventory, Role::Fit);
    let lines: Vec<String> = commands.lines().map(|l| l.trim().to_owned()).collect();
    let repaired = insert(&text, &point, &lines);
    let score = Score { nmse: NMSE, samples: SAMPLES, dropped: 0 };
    let fit = ScoredRun { channels: vec![], scores: vec![score] };
    let result = opensees_script(&RepairedModelScript {
        simulator: &simulator,
        text: &text,
        point: &point,
        repaired: &repaired,
        values: &values,
        responses: &responses,
        fits: &[Some(fit)],
    });
    fs::remove_dir_all(dir).expect("the folder");
    result
}

const PADS: [&str; 2] = [PAD, PAD_ANALYSIS];
const BUILDINGS: [&str; 2] = [SHAKEN, SHAKEN_ANALYSIS];

#[test]
fn standard_forms_respond_like_the_amendments() {
    let (gap, slip) = ("pset hy_gap 0.04\npset hy_wall 3000.0\n", "-force $hy_f -stiffness [expr $hy_f/$hy_w]");
    let wall = "-at $hy_gap -stiffness $hy_wall -power 1";
    let cases: [(&str, [&str; 2], String); 13] = [
        ("friction", PADS, format!("pset hy_f 3.0\npset hy_w 0.001\namend element 1 friction {slip}")),
        ("bristles", PADS, format!("pset hy_f 3.0\npset hy_w 0.02\namend element 1 bristles {slip}")),
        ("walls", PADS, format!("{gap}amend element 1 gap {wall} -side 0")),
        ("negative", PADS, format!("{gap}amend element 1 gap {wall} -side -1")),
        ("quadratic", PADS, "pset hy_x 9000.0\namend element 1 stiffening -factor $hy_x -from 0.01".into()),
        ("cubic", PADS, "pset hy_x 8e4\namend element 1 stiffening -factor $hy_x -power 3.0".into()),
        (
            "temperature",
            PADS,
            "pset hy_b 0.008\namend element 1 temperature -softening $hy_b -at -20.0 -reference 23.0 -share 280.0 0.4"
                .into(),
        ),
        ("axial", PADS, "pset hy_c 900.0\namend element 1 axial -critical $hy_c -load [expr {abs(-500.0)}]".into()),
        ("yielding", BUILDINGS, "pset hy_y 2.5\namend element 2 yielding -force $hy_y -hardening 0.1".into()),
        ("dashpot", BUILDINGS, "pset hy_c 6.0\namend element 2 damping -coefficient $hy_c -power 1.0".into()),
        (
            "maxwell",
            BUILDINGS,
            "pset hy_f 2.0\namend element 1 overstress -force $hy_f -speed 0.2 -power 1.0 -stiffness 300.0".into(),
        ),
        ("wall", BUILDINGS, format!("{gap}amend element 1 gap {wall} -side 1")),
        (
            "hertz",
            BUILDINGS,
            format!("{gap}amend element 1 gap -at $hy_gap -stiffness [expr 5*$hy_wall] -power 1.5 -side 0"),
        ),
    ];
    let mut wrong = vec![];
    for (name, model, commands) in cases {
        if let Err(reason) = attempt(name, model, &(commands + " -dir 1")) {
            wrong.push(format!("{name}: {reason}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn repairs_that_standard_commands_cannot_say_are_refused() {
    for (name, model, commands, reason) in [
        (
            "heating",
            PADS,
            "amend element 1 heating -softening 0.01 -capacity 10.0 -dir 1",
            "self-heating has no standard",
        ),
        // OpenSees' dampers follow nodal velocities, which a static analysis does not have.
        ("static", PADS, "amend element 1 damping -coefficient 20.0 -dir 1", "out of the run run differs"),
        ("hard", BUILDINGS, "amend element 1 gap -at 0.02 -stiffness 3000.0 -damping 5.0 -side 1 -dir 1", "differs"),
    ] {
        let found = attempt(name, model, commands);
        assert!(found.as_ref().is_err_and(|e| e.contains(reason)), "{name}: {found:?}");
    }
}

/// `amend` has each kind of the manual, and the manual says what becomes of each.
#[test]
fn the_manual_has_each_kind() {
    let page = include_str!("../../../../../docs/reference/amendments.md");
    let rows = page.split("## In OpenSees' commands").nth(1).expect("a table").lines();
    let rows: Vec<&str> = rows.filter(|l| l.starts_with("| `")).collect();
    let expected = TRANSLATIONS.iter().map(|t| format!("| `{}` | {} |", t.kind, t.form));
    let expected = expected.chain(UNTRANSLATED.iter().map(|(kind, _)| format!("| `{kind}` | none |")));
    let missing: Vec<String> = expected.filter(|row| !rows.contains(&row.as_str())).collect();
    assert!(missing.is_empty(), "the manual lacks\n{}", missing.join("\n"));
    // The words of learned laws stand in tables of their own, after those of the kinds.
    let kinds = page.split("## Learned laws").next().unwrap_or_default();
    let kinds = kinds.lines().filter_map(|l| l.strip_prefix("| `")?.split('`').next());
    for kind in kinds.filter(|k| !k.starts_with('-')) {
        let known = TRANSLATIONS.iter().any(|t| t.kind == kind) || UNTRANSLATED.iter().any(|(k, _)| *k == kind);
        assert!(known, "{kind} is neither translated nor refused");
    }
}
