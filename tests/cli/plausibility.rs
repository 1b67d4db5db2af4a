//! Analyses that run and mean nothing: one warning each, with a place, which `--strict` refuses.

use super::Place;

/// Two masses of 2 on springs of 100, in a row: ω² = 50 (3 ± √5)/2, at most 130.9.
const CHAIN: &str = "model basic -ndm 1 -ndf 1\nnode 1 0\nnode 2 0\nnode 3 0\nfix 1 1\nmass 2 2.\nmass 3 2.\n\
    uniaxialMaterial Elastic 1 100.\nelement zeroLength 1 1 2 -mat 1 -dir 1\nelement zeroLength 2 2 3 -mat 1 -dir 1\n";
/// A column of 3 m with EI = 90: its Euler load is 98.7.
const COLUMN: &str = "model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 3\nfix 1 1 1 1\ngeomTransf KIND 1\n\
    element elasticBeamColumn 1 1 2 1. 90. 1. 1\ntimeSeries Linear 1\nconstraints Transformation\n\
    integrator LoadControl 1\nalgorithm Newton\nanalysis Static\n";
/// Two nodes tied by a penalty, the first on a spring of 100.
const TIED: &str = "model basic -ndm 1 -ndf 1\nnode 1 0\nnode 2 0\nnode 3 0\nfix 1 1\nuniaxialMaterial Elastic 1 100.\n\
    element zeroLength 1 1 2 -mat 1 -dir 1\nequalDOF 2 3 1\ntimeSeries Linear 1\npattern Plain 1 1 { load 3 1000. }\n\
    constraints Penalty 1e8 FACTOR\nintegrator LoadControl 1\nalgorithm Linear\nanalysis Static\nanalyze 1\n";
/// An isolator between ground and a mass, shaken.
const ISOLATED: &str = "model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 0 -mass 10. 10. 0.1\nfix 1 1 1 1\nfix 2 0 0 1\n\
    uniaxialMaterial Elastic 1 1e5\nelement elastomericBearingPlasticity 1 1 2 1000. 20. 0.02 0. 1. -P 1 -Mz 1 -orient 0 1 0 -1 0 0\n\
    timeSeries Trig 1 0. 20. 2.\npattern UniformExcitation 1 1 -accel 1\n";

const NEWMARK: &str = "constraints Transformation\nintegrator Newmark 0.5 0.25\nalgorithm Newton\nanalysis Transient\n";

fn run(place: &Place, options: &[&str], script: &str) -> (Option<i32>, String) {
    place.write("m.tcl", script);
    let (status, out, err) = place.run(&[&["run"], options, &["m.tcl"]].concat());
    (status, out + &err)
}

/// The script is warned of once, in these words at a place; `--strict` refuses it. Returns what is said.
fn warned(script: &str, status: i32, words: &str) -> String {
    let place = Place::new();
    let (found, said) = run(&place, &[], script);
    assert!(found == Some(status) && said.contains(words), "{script}\n{words}: {found:?} {said}");
    assert!(said.contains("1 warning:\n  warning: m.tcl:"), "{script}\n{said}");
    let (found, said) = run(&place, &["--strict"], script);
    assert!(found == Some(2) && said.contains(words), "{script}\n--strict: {found:?} {said}");
    said
}

fn accepted(script: &str) {
    let (status, said) = run(&Place::new(), &["--strict"], script);
    assert!(status == Some(0) && !said.contains("warning"), "{script}\n{status:?} {said}");
}

/// The longest stable step of central differences is 2/ω = 0.17479 s; of Noh and Bathe with p = 0.54, 3.704/ω.
#[test]
fn explicit_steps_beyond_the_stable_one() {
    let omega = (50.0 * (3.0 + 5f64.sqrt()) / 2.0_f64).sqrt();
    for (integrator, limit) in [
        ("CentralDifference", 2.0),
        ("CentralDifferenceNoDamping", 2.0),
        ("ExplicitDifference", 2.0),
        ("NewmarkExplicit 0.5", 2.0),
        ("NewmarkExplicit 0.6", (2.0f64 / 0.6).sqrt()),
        ("ExplicitBathe 0.54", 2.0 / 0.54),
    ] {
        let script = |share: f64| {
            let dt = share * limit / omega;
            format!("{CHAIN}integrator {integrator}\nalgorithm Linear\nanalysis Transient\nanalyze 20 {dt}\n")
        };
        warned(&script(1.01), 0, "unstable with steps of");
        accepted(&script(0.99));
    }
}

#[test]
fn penalty_that_does_not_hold() {
    warned(&TIED.replace("FACTOR", "1000."), 0, "the penalty does not hold: node 3 moves by 1.1000e1");
    accepted(&TIED.replace("FACTOR", "1e8"));
}

#[test]
fn support_that_is_tied_too() {
    let script = |fixed: &str| {
        format!(
            "{CHAIN}node 4 0\nequalDOF 3 4 1\n{fixed}\ntimeSeries Linear 1\npattern Plain 1 1 {{ load 3 1. }}\n\
             constraints Transformation\nintegrator LoadControl 1\nalgorithm Linear\nanalysis Static\nanalyze 1\n"
        )
    };
    warned(&script("fix 4 1"), 0, "node 4 is held in degree of freedom 1, and a constraint ties it to node 3 too");
    accepted(&script(""));
}

#[test]
fn excitations_without_effect() {
    let record = "timeSeries Path 1 -dt 0.02 -values {0 1 0 -1 0 1 0 -1 0}\npattern UniformExcitation 1 1 -accel 1\n";
    let massless = CHAIN.replace("mass 2 2.\nmass 3 2.\n", "");
    warned(&format!("{massless}{record}{NEWMARK}analyze 5 0.01\n"), 0, "where the model has no mass");
    warned(&format!("{CHAIN}{record}{NEWMARK}analyze 5 0.2\n"), 0, "10.0 times those of the record");
    accepted(&format!("{CHAIN}{record}{NEWMARK}analyze 16 0.01\nanalyze 100 0.02\n"));
    let gravity = "timeSeries Linear 7\npattern Plain 7 7 { load 3 1. }\nintegrator LoadControl 0.1\nalgorithm Linear\n\
        analysis Static\nanalyze 10\n";
    let shaken = |between: &str| format!("{CHAIN}{gravity}{between}\nwipeAnalysis\n{record}{NEWMARK}analyze 16 0.01\n");
    warned(&shaken("loadConst"), 0, "ends at time 0.180000, and the analysis begins at 1.000000");
    accepted(&shaken("loadConst -time 0.0"));
}

#[test]
fn beam_beyond_its_euler_load() {
    let script = |kind: &str, load: f64| {
        format!("{}pattern Plain 1 1 {{ load 2 0 {} 0 }}\nanalyze 1\n", COLUMN.replace("KIND", kind), -load)
    };
    warned(&script("Linear", 100.0), 0, "above its Euler load of 9.8696e1");
    warned(&script("PDelta", 100.0), 0, "above its Euler load");
    accepted(&script("Linear", 98.0));
    accepted(&script("Linear", -100.0));
}

#[test]
fn hardening_ratios_outside_of_0_to_1() {
    for steel in ["Steel01 9 250. 2e5 BB", "Steel02 9 250. 2e5 BB 15 0.9 0.15"] {
        for b in ["-0.1", "1.5", "2e5"] {
            warned(&format!("{CHAIN}uniaxialMaterial {}\n", steel.replace("BB", b)), 0, "the hardening ratio b is");
        }
        accepted(&format!("{CHAIN}uniaxialMaterial {}\n", steel.replace("BB", "0.02")));
    }
}

/// A failure that the script does not look at makes the status, although later steps succeed.
#[test]
fn failed_analysis_that_the_script_ignores() {
    let script = |look: &str| {
        format!(
            "model basic -ndm 1 -ndf 1\nnode 1 0\nnode 2 0\nfix 1 1\nuniaxialMaterial Steel01 1 10. 100. 0.1\n\
             element zeroLength 1 1 2 -mat 1 -dir 1\ntimeSeries Linear 1\npattern Plain 1 1 {{ load 2 1. }}\n\
             constraints Plain\nalgorithm Newton\nintegrator LoadControl 4\nanalysis Static\n\
             test NormDispIncr 1e-10 2\n{look}\ntest NormDispIncr 1e-10 20\nanalyze 1\n"
        )
    };
    for ignoring in ["analyze 4", "for {set i 0} {$i < 3} {incr i} {analyze 1}", "if 1 {\n  analyze 4\n}"] {
        let said = warned(&script(ignoring), 1, "no convergence at time 12");
        assert!(said.contains("nothing looks at the result"), "{said}");
    }
    for looking in
        ["set ok [analyze 4]", "if {[analyze 4] != 0} {puts failed}", "proc step {} {analyze 4}\nset ok [step]"]
    {
        let (status, said) = run(&Place::new(), &["--strict"], &script(looking));
        assert!(status == Some(0) && !said.contains("nothing looks"), "{looking}: {status:?} {said}");
    }
}

#[test]
fn rigid_body_modes() {
    let script = |support: &str| {
        format!(
            "model basic -ndm 2 -ndf 3\nnode 1 0 0 -mass 1. 1. 0.1\nnode 2 3 0 -mass 1. 1. 0.1\n{support}\n\
             geomTransf Linear 1\nelement elasticBeamColumn 1 1 2 1. 2e5 1. 1\nputs [eigen 3]\n"
        )
    };
    warned(&script(""), 0, "3 modes move the model as a rigid body");
    let (_, said) = run(&Place::new(), &[], &script(""));
    assert!(said.starts_with("0.0 0.0 0.0\n"), "{said}");
    accepted(&script("fix 1 1 1 1"));
}

#[test]
fn rayleigh_damping_of_isolators() {
    let script = |rayleigh: &str, option: &str| {
        let isolated = ISOLATED.replace("-orient", &format!("{option} -orient"));
        format!("{isolated}rayleigh 0 0 {rayleigh} 0\ntest NormDispIncr 1e-9 50\n{NEWMARK}analyze 400 0.005\n")
    };
    warned(&script("0.05", "-doRayleigh"), 0, "% of the energy that goes into isolator 1");
    accepted(&script("0.05", ""));
    accepted(&script("0.0001", "-doRayleigh"));
}
