//! `database`, `save` and `restore`.

use super::Place;

/// A mass on a yielding spring and a column of fibers, shaken.
const MODEL: &str = "model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 3 -mass 2. 2. 0.1\nnode 3 0 3 -mass 1. 1. 0.1\nfix 1 1 1 1\n\
    uniaxialMaterial Steel02 1 250. 2e5 0.02 18 0.925 0.15\nuniaxialMaterial Steel01 2 5. 400. 0.1\n\
    section Fiber 1 { patch rect 1 8 1 -0.1 -0.1 0.1 0.1 }\ngeomTransf PDelta 1\n\
    element forceBeamColumn 1 1 2 4 1 1\nelement zeroLength 2 2 3 -mat 2 2 2 -dir 1 2 6\n\
    rayleigh 0.1 0 0.001 0\ntimeSeries Linear 1\npattern Plain 1 1 { load 2 0 -3. 0 }\n\
    constraints Transformation\ntest NormDispIncr 1e-10 50\nalgorithm Newton\nintegrator LoadControl 0.5\nanalysis Static\n\
    set ok [analyze 2]\nloadConst -time 0.0\nwipeAnalysis\ntimeSeries Trig 2 0. 10. 0.7 -factor 30.\n\
    pattern UniformExcitation 2 1 -accel 2\nconstraints Transformation\ntest NormDispIncr 1e-10 50\nalgorithm Newton\n\
    integrator Newmark 0.5 0.25\nanalysis Transient\ndatabase File states\n";
/// The state in all digits.
const SHOW: &str =
    "puts \"[getTime] [nodeDisp 2] [nodeVel 3] [nodeAccel 2] [eleResponse 1 force] [eleResponse 2 force] [eigen 2]\"\n";

fn run(place: &Place, script: &str) -> String {
    place.write("m.tcl", script);
    let (status, out, err) = place.run(&["run", "m.tcl"]);
    assert!(status == Some(0) && err.is_empty(), "{err}");
    out
}

/// The same bits where the run that saved goes on, after a restore in the same process, and in another process.
#[test]
fn restored_states_go_on_to_the_same_bits() {
    let place = Place::new();
    let steps = "set ok [analyze 60 0.01]\n";
    let at_save = run(&place, &format!("{MODEL}{steps}save 7\n{SHOW}"));
    // The state itself has the same bits.
    assert_eq!(run(&place, &format!("{MODEL}restore 7\n{SHOW}")), at_save);
    let within = format!("{MODEL}{steps}save 7\n{steps}{SHOW}restore 7\n{steps}{SHOW}");
    let both = run(&place, &within);
    let (saved, restored) = both.split_once('\n').unwrap();
    assert_eq!(saved, restored.trim_end());
    assert_eq!(run(&place, &format!("{MODEL}restore 7\n{steps}{SHOW}")).trim_end(), saved);
    assert_eq!(place.names(), ["m.tcl", "states.7.state"]);
}

#[test]
fn states_that_do_not_fit_are_refused() {
    let place = Place::new();
    run(&place, &format!("{MODEL}save 7\n"));
    let refused = |script: &str, words: &str| {
        place.write("m.tcl", script);
        let (status, _, err) = place.run(&["run", "m.tcl"]);
        assert!(status == Some(2) && err.contains(words) && err.contains("m.tcl:"), "{words}: {err}");
    };
    refused(&format!("{MODEL}restore 8\n"), "cannot read states.8.state");
    refused(&format!("{MODEL}node 4 1 1\nrestore 7\n"), "other nodes or elements");
    refused("save 1\n", "there is no database yet");
    refused("database MySQL x\n", "kind of database");
    let mut bytes = std::fs::read(place.0.join("states.7.state")).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    place.write("states.7.state", &bytes);
    refused(&format!("{MODEL}restore 7\n"), "no saved state, or damaged");
    place.write("m.tcl", format!("{MODEL}restore 8\n"));
    assert_eq!(place.run(&["check", "m.tcl"]).0, Some(0));
}

/// A run of steps with questions between, a step that fails, gravity and a second run after `wipe`.
const LOOP: &str = "proc shake {steps} {\n global most\n set n 0\n while {$n < $steps} {\n  incr n\n  incr ::at\n\
    if {$::at == 83} { test NormDispIncr 1e-30 1 }\n  set ok [analyze 1 0.01]\n\
    if {$ok != 0} {\n   puts \"step $::at failed\"\n   test NormDispIncr 1e-10 50\n   algorithm ModifiedNewton\n   set ok [analyze 1 0.01]\n\
      puts \"[testIter] iterations\"\n   algorithm Newton\n  }\n\
    set d [nodeDisp 2 1]\n  if {abs($d) > $most} { set most [expr {abs($d)}]; puts \"$::at [getTime] $d [nodeDisp 3]\" }\n\
    if {$::at == $::env(STOP)} { exit 3 }\n }\n}\nset at 0\nset most 0.\n";

/// Recorder files of a run, by their names.
fn written(place: &Place) -> Vec<(String, Vec<u8>)> {
    let names = place.names().into_iter().filter(|n| n.ends_with(".out"));
    names.map(|n| (n.clone(), std::fs::read(place.0.join(n)).unwrap())).collect()
}

/// A run that is stopped at any step goes on to the same files and texts.
#[test]
fn a_stopped_run_goes_on_to_the_same_bits() {
    let place = Place::new();
    let recorders = |k: i32| {
        format!(
            "recorder Node -file d{k}.out -time -node 2 3 -dof 1 2 disp\nrecorder Element -file f{k}.out -dT 0.03 -ele 1 2 force\n\
             recorder EnvelopeNode -file e{k}.out -node 3 -dof 1 accel\n"
        )
    };
    let model = MODEL.replace("database File states\n", "");
    let again = "loadConst -time 1.5\nset ok [analyze 77 0.01]\nputs [testNorm]\nset ok [analyze 60 0.005]\n";
    let parts = [
        format!("{LOOP}{model}{}shake 120\nputs [eigen 2]\nshake 60\n{again}{SHOW}wipe\n", recorders(1)),
        format!("{model}{}set ok [analyze 30 0.01]\nshake 90\n{SHOW}", recorders(2)),
    ];
    place.write("m.tcl", parts.concat());
    let run_every = |interval: &str, stop: i32, resume: bool| {
        let words = ["run", "--checkpoint", interval, "m.tcl", "--resume"];
        place.run_with(&[("STOP", &stop.to_string())], &words[..4 + usize::from(resume)])
    };
    let run = |stop: i32, resume: bool| run_every("0.000001s", stop, resume);
    // A run without a checkpoint makes the same steps.
    let (status, whole, err) = run_every("2h", -1, false);
    assert_eq!(status, Some(0), "{err}");
    let expected = written(&place);
    assert!(whole.contains("step 83 failed") && expected.len() == 6, "{whole}");
    assert!(place.names().iter().all(|n| !n.contains("checkpoint") && !n.contains("journal")));
    for stop in [1, 49, 50, 51, 83, 84, 101, 119, 121, 150, 180, 181, 200, 269] {
        assert_eq!(run(stop, false).0, Some(3));
        // A kill may leave half a block behind the last checkpoint.
        let journal = place.0.join("m.journal");
        let bytes = [std::fs::read(&journal).unwrap(), b"half a block".to_vec()].concat();
        std::fs::write(&journal, bytes).unwrap();
        // Stopped once more, and then to its end.
        if stop < 200 {
            assert_eq!(run(stop + 60, true).0, Some(3), "{stop}");
        }
        let (status, out, err) = run(-1, true);
        assert_eq!((status, &out), (Some(0), &whole), "{stop}: {err}");
        assert!(written(&place) == expected, "{stop}: other files");
    }
}

#[test]
fn checkpoints_that_do_not_fit_are_refused() {
    let place = Place::new();
    let script = format!("{MODEL}set ok [analyze 130 0.01]\n{SHOW}exit 3\n");
    place.write("m.tcl", &script);
    let keep: &[&str] = &["run", "--checkpoint", "0.000001", "m.tcl"];
    let (status, _, err) = place.run(&[keep, &["--resume"]].concat());
    assert!(status == Some(3) && err.contains("begins at its beginning"), "{err}");
    let (checkpoint, journal) = (place.0.join("m.checkpoint"), place.0.join("m.journal"));
    let kept = [&checkpoint, &journal].map(|f| std::fs::read(f).unwrap());
    let refused = |words: &str, more: &[&str]| {
        let (status, _, err) = place.run(&[keep, &["--resume"], more].concat());
        assert!(status == Some(2) && err.contains(words), "{words}: {err}");
    };
    place.write("m.tcl", script.replace("Steel01 2 5.", "Steel01 2 6."));
    refused("has changed since", &[]);
    place.write("m.tcl", &script);
    refused("other arguments", &["--strict"]);
    for (file, bytes) in [(&checkpoint, &kept[0]), (&journal, &kept[1])] {
        std::fs::write(file, b"nonsense").unwrap();
        refused("no file of checkpoints", &[]);
        let mut damaged = bytes.clone();
        damaged[bytes.len() / 2] ^= 1;
        std::fs::write(file, &damaged).unwrap();
        refused("damaged", &[]);
        std::fs::write(file, &bytes[..bytes.len() - 1]).unwrap();
        refused("damaged", &[]);
        std::fs::write(file, bytes).unwrap();
    }
    assert_eq!(place.run(&[keep, &["--resume"]].concat()).0, Some(3));
    place.write("m.tcl", format!("{MODEL}recorder PVD p disp\nset ok [analyze 3 0.01]\n"));
    let (status, _, err) = place.run(keep);
    assert!(status == Some(2) && err.contains("writes more than rows") && err.contains("m.tcl:"), "{err}");
}
