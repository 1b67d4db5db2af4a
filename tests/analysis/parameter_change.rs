//! Parameters of `pset` with another value for a time: `amend parameter`.

use super::close;
use super::script::{Ran, Script};

/// A spring that yields beside one that does not, pulled and pushed by 20 steps of 0.1 s. `changes` stand before the analysis.
fn pulled(model: &str, changes: &str) -> Ran {
    // Sums of 0.1 pass the end of the analysis by round-off.
    let motion: String = (0..=21).map(|i| format!("{} ", displacement(i))).collect();
    Script::default().run(&format!(
        "wipe; model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1
        {model}
        timeSeries Path 1 -dt 0.1 -values {{ {motion} }}; pattern Plain 1 1 {{ sp 2 1 1.0 }}
        {changes}
        recorder Element -file force.out -time -ele 1 force
        constraints Transformation; numberer Plain; system FullGeneral; test NormDispIncr 1e-12 20; algorithm Newton
        integrator LoadControl 0.1; analysis Static
        puts [analyze 12]; puts [analyze 8]"
    ))
}

const MODEL: &str = "pset Fy 3.0; pset k 10.0
    uniaxialMaterial ElasticPP 1 100. [expr {$Fy/100.}]; uniaxialMaterial Elastic 2 $k
    uniaxialMaterial Parallel 3 1 2; element zeroLength 1 1 2 -mat 3 -dir 1";

fn displacement(i: usize) -> f64 {
    0.1 * (0.9 * i as f64).sin()
}

/// Forces of the last column of the recorder.
fn forces(ran: &Ran) -> Vec<f64> {
    assert!(ran.warnings().is_empty() && ran.out == "0\n0\n", "{} {:?}", ran.out, ran.end);
    ran.tables["force.out"].iter().map(|row| row[2]).collect()
}

/// The same by a return to the strength of each step, which has the part `tight(i)` of step i twice as large.
fn expected(tight: impl Fn(usize) -> f64) -> Vec<f64> {
    let mut plastic = 0.0;
    let step = |i: usize| {
        let (u, strength) = (displacement(i), 3.0 * (1.0 + tight(i)));
        let q = (100.0 * (u - plastic)).clamp(-strength, strength);
        plastic = u - q / 100.0;
        q + 10.0 * u
    };
    (1..=20).map(step).collect()
}

fn assert_same(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    let same = |(a, b): (&f64, &f64)| close(*a, *b, 1e-9);
    assert!(found.iter().zip(expected).all(same), "{found:?}\n{expected:?}");
}

fn within(range: std::ops::RangeInclusive<usize>) -> impl Fn(usize) -> f64 {
    move |i| f64::from(u8::from(range.contains(&i)))
}

#[test]
fn an_element_keeps_its_state_under_another_value() {
    let found = forces(&pulled(MODEL, "amend parameter Fy -factor 2 -from 0.5 -to 1.4"));
    assert_same(&found, &expected(within(6..=14)));
    let found = forces(&pulled(MODEL, "amend parameter Fy -factor 2 -to 0.9"));
    assert_same(&found, &expected(within(1..=9)));
}

/// The response is continuous in the times: a step that the change begins in has a part of it.
#[test]
fn a_step_has_the_part_of_the_change_that_it_shares() {
    let found = forces(&pulled(MODEL, "amend parameter Fy -factor 2 -from 0.53"));
    assert_same(&found, &expected(|i| if i == 6 { 0.7 } else { within(7..=20)(i) }));
}

/// A ramp of sixteen steps is linear in the mean of the steps of the analysis; 0.1 s of it are four of its own.
#[test]
fn a_value_is_reached_on_a_ramp() {
    let found = forces(&pulled(MODEL, "amend parameter Fy -factor 2 -from 0.5 -reached 0.9"));
    let part = |i: usize| ((i as f64 - 5.5) / 4.0).clamp(0.0, 1.0);
    assert_same(&found, &expected(part));
}

/// A change outside of the analysis changes no bit; nor does one that ends before it begins.
#[test]
fn a_change_at_no_time_changes_nothing() {
    let plain = forces(&pulled(MODEL, ""));
    for never in ["-from 9.", "-to -1.", "-from 1.5 -to 0.5"] {
        assert_eq!(forces(&pulled(MODEL, &format!("amend parameter Fy -factor 2 {never}"))), plain, "{never}");
    }
}

/// Other amendments stay around the element, wherever they stand, and procedures make it as well.
#[test]
fn the_script_makes_the_element_again_with_all_that_it_does_to_it() {
    let friction = "amend element 1 stiffening -factor 50. -power 1.";
    let change = "amend parameter Fy -factor 2 -from 0.5 -to 1.4";
    let mut both = expected(within(6..=14));
    both.iter_mut().zip(1..).for_each(|(f, i)| *f += 50.0 * displacement(i));
    for order in [format!("{friction}; {change}"), format!("{change}; {friction}")] {
        assert_same(&forces(&pulled(MODEL, &order)), &both);
    }
    let inside = format!("proc build {{}} {{ {MODEL} }}\nbuild");
    assert_same(&forces(&pulled(&inside, change)), &expected(within(6..=14)));
}

/// A frame whose spring changes is the same as one that `updateParameter` changes between two analyses.
#[test]
fn a_shaken_model_goes_on_from_its_motion() {
    let shaken = |change: &str, between: &str| {
        let text = format!(
            "wipe; model basic -ndm 1 -ndf 1; node 1 0; node 2 0 -mass 2.0; fix 1 1; pset k 80.
            uniaxialMaterial Elastic 1 $k; element zeroLength 1 1 2 -mat 1 -dir 1
            timeSeries Sine 1 0. 9. 1.3; pattern UniformExcitation 1 1 -accel 1; {change}
            recorder Node -file disp.out -time -node 2 -dof 1 disp
            constraints Plain; numberer Plain; system FullGeneral; test NormDispIncr 1e-12 20; algorithm Newton
            integrator Newmark 0.5 0.25; analysis Transient
            puts [analyze 40 0.05]; {between}; puts [analyze 40 0.05]"
        );
        let ran = Script::default().run(&text);
        assert_eq!(ran.out, "0\n0\n", "{:?}", ran.end);
        ran.tables["disp.out"].iter().map(|row| row[1]).collect::<Vec<f64>>()
    };
    let updated = shaken("", "parameter 1 element 1 material 1 E; updateParameter 1 48.");
    assert_same(&shaken("amend parameter k -factor 0.6 -from 2.0", ""), &updated);
    assert!(!close(updated[79], shaken("", "")[79], 1e-3));
}

/// The variables of a large frame are placed once for each change, and not once for each of its elements.
#[test]
fn elements_of_a_large_frame_are_replaced_together() {
    const SPRINGS: usize = 2000;
    let frame =
        format!("{MODEL}; for {{set i 2}} {{$i <= {SPRINGS}}} {{incr i}} {{element zeroLength $i 1 2 -mat 3 -dir 1}}");
    let plain = pulled(&frame, "");
    let changed = pulled(&frame, "amend parameter Fy -factor 2 -from 0.53 -to 1.4");
    assert_same(&forces(&changed), &expected(|i| if i == 6 { 0.7 } else { within(7..=14)(i) }));
    let revisions = |ran: &Ran| ran.interp.host.engine.model().revision();
    // The frame gets other elements in steps 6, 7 and 15.
    let added = revisions(&changed) - revisions(&plain);
    assert!((3..=6).contains(&added), "{added} changes of the model");
}

/// The second run of the script knows nothing of what stands after the first analysis.
#[test]
fn elements_that_are_not_those_of_the_first_analysis_are_refused() {
    let between = |between: &str| {
        let ran = Script::default().run(&format!(
            "wipe; model basic -ndm 1 -ndf 1; node 1 0; node 2 0 -mass 2.0; fix 1 1; pset k 80.
            uniaxialMaterial Elastic 1 $k; element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 1 2 -mat 1 -dir 1
            timeSeries Sine 1 0. 9. 1.3; pattern UniformExcitation 1 1 -accel 1
            amend parameter k -factor 0.6 -from 2.0
            constraints Plain; numberer Plain; system FullGeneral; test NormDispIncr 1e-12 20; algorithm Newton
            integrator Newmark 0.5 0.25; analysis Transient
            analyze 10 0.05; {between}; puts [analyze 40 0.05]"
        ));
        let done = ran.out.ends_with("0\n");
        if done { ran.out } else { ran.error().message.clone() }
    };
    assert_eq!(between(""), "0\n");
    assert_eq!(between("remove element 2"), "0\n");
    for (command, tag) in [
        ("parameter 1 element 2 material 1 E; updateParameter 1 48.", 2),
        ("element zeroLength 3 1 2 -mat 1 -dir 1", 3),
    ] {
        assert_eq!(between(command), format!("element {tag} was made or changed after the first analysis began"));
    }
}

#[test]
fn mistakes_are_refused() {
    for (change, message) in [
        ("amend parameter Fx -factor 2 -from 1", "no number \"Fx\" is declared by pset"),
        ("amend parameter Fy -factor 0 -from 1", "factor on the parameter is 0"),
        ("amend parameter Fy -from 1", "the factor, or both times are missing"),
        ("amend parameter Fy -factor 2", "the factor, or both times are missing"),
        ("amend parameter Fy -factor 2 -form 1", "option \"-form\""),
        ("amend parameter Fy -factor 2 -reached 1 -to 2", "-reached ends a ramp, which needs a beginning"),
    ] {
        let ran = pulled(MODEL, change);
        assert!(ran.error().message.contains(message), "{change}: {}", ran.error().message);
    }
    // With twice the value the element has another law.
    let other =
        "pset Fy 3.0; if {$Fy > 5} { uniaxialMaterial Elastic 3 100. } else { uniaxialMaterial Steel01 3 $Fy 100. 0.1 }
        element zeroLength 1 1 2 -mat 3 -dir 1";
    let ran = pulled(other, "amend parameter Fy -factor 2 -from 0.5");
    assert!(ran.error().message.contains("element 1 has other parts"), "{}", ran.error().message);
    let failing = "pset Fy 3.0; if {$Fy > 5} { error \"too strong\" }
        uniaxialMaterial Elastic 3 100.; element zeroLength 1 1 2 -mat 3 -dir 1";
    let ran = pulled(failing, "amend parameter Fy -factor 2 -from 0.5");
    assert!(
        ran.error().message.contains("with the other value of the parameter: too strong"),
        "{}",
        ran.error().message
    );
    let ran = pulled(
        MODEL,
        "constraints Plain; integrator LoadControl 0.; analysis Static; analyze 1; amend parameter Fy -factor 2 -to 9",
    );
    assert!(ran.error().message.contains("the analysis has begun"), "{}", ran.error().message);
}
