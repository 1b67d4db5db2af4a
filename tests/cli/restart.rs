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

/// A run goes on to the same files and texts from any prefix of its checkpoints, as a kill leaves them.
#[test]
fn a_killed_run_goes_on_to_the_same_bits() {
    let place = Place::new();
    let recorders = "recorder Node -file d.out -time -node 2 3 -dof 1 2 disp\nrecorder Element -file f.out -dT 0.03 -ele 1 2 force\n\
        recorder EnvelopeNode -file e.out -node 3 -dof 1 accel\n";
    // The exit status keeps the file of checkpoints.
    let script = format!("{MODEL}{recorders}puts [analyze 130 0.01]\n{SHOW}set ok [analyze 170 0.01]\n{SHOW}exit 3\n");
    place.write("m.tcl", &script);
    let files = || ["d.out", "f.out", "e.out"].map(|f| std::fs::read(place.0.join(f)).unwrap());
    let (status, out, err) = place.run(&["run", "--checkpoint", "0.000001", "m.tcl"]);
    assert_eq!(status, Some(3), "{err}");
    let (expected, whole) = (files(), std::fs::read(place.0.join("m.checkpoint")).unwrap());
    for part in [16, whole.len() / 7, whole.len() / 3, whole.len() / 2, whole.len() - 1, whole.len()] {
        place.write("m.checkpoint", &whole[..part]);
        let (status, again, err) = place.run(&["run", "--checkpoint", "0.000001", "--resume", "m.tcl"]);
        assert_eq!((status, &again), (Some(3), &out), "{part}: {err}");
        assert_eq!(files(), expected, "{part}");
    }
    place.write("m.checkpoint", &whole);
    place.write("m.tcl", script.replace("Steel01 2 5.", "Steel01 2 6."));
    let (status, _, err) = place.run(&["run", "--checkpoint", "1", "--resume", "m.tcl"]);
    assert!(status == Some(2) && err.contains("has changed since"), "{err}");
    place.write("m.checkpoint", b"nonsense");
    let (status, _, err) = place.run(&["run", "--checkpoint", "1", "--resume", "m.tcl"]);
    assert!(status == Some(2) && err.contains("no file of checkpoints"), "{err}");
}
