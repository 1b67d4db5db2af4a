//! Mistakes in the words of layered rubber bearings.

use super::run;

const MODEL: &str = "model BasicBuilder -ndm 3 -ndf 6\nnode 1 0 0 0\nnode 2 0 0 0.25\nnode 3 0.3 0 0\nnode 4 0 0 0\n";
const LAYERS: &str = "0.45e6 2e9 0.15 0.6 0.003 0.006 28";
const GRANT: &str = "1.1e6 -6e6 9e7 1.8e4 4e5 60 4 1.5 0.75 3";
const AXES: &str = "0 0 1 1 0 0";

/// The command, and words of the message.
#[test]
fn message_names_the_wrong_word() {
    let hdr = |layers: &str, grant: &str, more: &str| format!("element HDR 1 1 2 {layers} {grant} {more}");
    let lead = |force: &str, more: &str| format!("element LeadRubberX 1 1 2 {force} {LAYERS} {more}");
    let elastomeric = |force: &str, more: &str| format!("element ElastomericX 1 1 2 {force} {LAYERS} {more}");
    let heat = "11200 130 50 1.41e-5";
    let cases: Vec<(String, &[&str])> = vec![
        (hdr("-1 2e9 0.15 0.6 0.003 0.006 28", GRANT, ""), &["shear modulus Gr is -1", "greater than 0"]),
        (hdr("0.45e6 0 0.15 0.6 0.003 0.006 28", GRANT, ""), &["bulk modulus Kbulk is 0", "greater than 0"]),
        (hdr("0.45e6 2e9 0.7 0.6 0.003 0.006 28", GRANT, ""), &["outer diameter D2 is 0.6", "greater than 0.7"]),
        (hdr("0.45e6 2e9 -0.1 0.6 0.003 0.006 28", GRANT, ""), &["inner diameter D1 is -0.1", "not less than 0"]),
        (hdr("0.45e6 2e9 0.1 0.6 -0.003 0.006 28", GRANT, ""), &["thickness of a shim ts is -0.003"]),
        (
            hdr("0.45e6 2e9 0.1 0.6 0.003 0.7 28", GRANT, ""),
            &["rubber layer tr is 0.7", "less than the outer diameter"],
        ),
        (hdr("0.45e6 2e9 0.1 0.6 0.003 0.006 0", GRANT, ""), &["number of layers n is 0", "at least 1"]),
        (hdr(LAYERS, "0 0 0 1 1 1 1 1 1 1", ""), &["a1 of the elastic shear force is 0"]),
        (hdr(LAYERS, "1e6 0 0 1 1 -1 1 1 1 1", ""), &["b3 of the hysteretic force is -1"]),
        (hdr(LAYERS, "1e6 0 0 1 1 1 1 1 1", ""), &["Mullins parameter c4 is missing"]),
        (hdr(LAYERS, GRANT, "0 0 1"), &["the x of the vector in the local x-y plane is missing"]),
        (hdr(LAYERS, GRANT, "0 0 1 0 0 2"), &["parallel"]),
        (hdr(LAYERS, GRANT, &format!("{AXES} -1")), &["cavitation parameter kc is -1"]),
        (hdr(LAYERS, GRANT, &format!("{AXES} 10 1.5")), &["PhiM is 1.5", "0 to 1"]),
        (hdr(LAYERS, GRANT, &format!("{AXES} 10 0.5 1 2")), &["sDratio is 2", "0 to 1"]),
        (hdr(LAYERS, GRANT, &format!("{AXES} 10 0.5 1 0.5 0 0 7 8")), &["2 arguments too many: 7 8"]),
        (format!("element HDR 1 1 4 {LAYERS} {GRANT}"), &["no length", "local x axis"]),
        (format!("element HDR 1 1 3 {LAYERS} {GRANT}"), &["parallel"]),
        (format!("element HDR 1 1 2 12000 0.007 {LAYERS} {GRANT}"), &["2 arguments too many", "12000 0.007"]),
        (elastomeric("0 0.1", ""), &["yield force Fy is 0"]),
        (elastomeric("9e4 1", ""), &["alpha is 1", "less than 1"]),
        (elastomeric("9e4 0.1", &format!("{AXES} 10 0.5 1 0.5 0 -1")), &["viscous damping cd is -1"]),
        (elastomeric("9e4 0.1", &format!("{AXES} 10 0.5 1 0.5 0 0 0 x")), &["tag1 (cavitation) is not a whole number"]),
        (lead("9e4 0.1", &format!("{AXES} 10 0.5 1")), &["place of the shear force sDratio is missing"]),
        (lead("9e4 0.1", &format!("{AXES} 10 0.5 1 0.5 0 0 0 11200")), &["specific heat of lead cL is missing"]),
        (lead("9e4 0.1", &format!("{AXES} 10 0.5 1 0.5 0 0 0 {heat} 1 1 1 1 1 1")), &["1 argument too many: 1"]),
        (
            format!(
                "element LeadRubberX 1 1 2 9e4 0.1 0.45e6 2e9 0 0.6 0.003 0.006 28 {AXES} 10 0.5 1 0.5 0 0 0 {heat} 0 0 0 0 1"
            ),
            &["tag5 (heating) is 1", "D1 is 0", "no lead core"],
        ),
    ];
    for (command, words) in cases {
        let (status, _, err) = run(&format!("{MODEL}{command}\n"));
        assert_eq!(status, Some(2), "{command}\n{err}");
        for word in words {
            assert!(err.contains(word), "{command}\n{err}");
        }
        assert!(err.contains("m.tcl:6:"), "{command}\n{err}");
    }
}

#[test]
fn bearings_in_space_are_refused_in_the_plane() {
    let (status, _, err) =
        run(&format!("model BasicBuilder -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 0 1\nelement HDR 1 1 2 {LAYERS} {GRANT}\n"));
    assert_eq!(status, Some(2));
    assert!(err.contains("6 degrees of freedom in 3 dimensions"), "{err}");
}

#[test]
fn switch_other_than_on_or_off_is_refused() {
    let command = format!("element ElastomericX 1 1 2 9e4 0.1 {LAYERS} {AXES} 10 0.5 1 0.5 0 0 0 2");
    let (status, _, err) = run(&format!("{MODEL}{command}\n"));
    assert_eq!(status, Some(0));
    assert!(err.contains("tag1 (cavitation) is 2 and counts as 0"), "{err}");
}

/// Under more than its critical load a bearing has almost no stiffness. It is reported once.
#[test]
fn overload_is_reported() {
    let pressed = |load: &str| {
        run(&format!(
            "{MODEL}element HDR 1 1 2 {LAYERS} {GRANT}\nfix 1 1 1 1 1 1 1\nfix 2 1 1 0 1 1 1\nforeach n {{3 4}} {{ fix $n 1 1 1 1 1 1 }}\ntimeSeries Linear 1\n\
             pattern Plain 1 1 {{ load 2 0 0 {load} 0 0 0 }}\nconstraints Transformation\nalgorithm Newton\n\
             integrator LoadControl 0.5\nanalysis Static\nanalyze 1\nanalyze 1\nputs [expr {{[nodeDisp 2 3] < 0}}]\n"
        ))
    };
    let (status, out, err) = pressed("-1e5");
    assert!((status, out.as_str()) == (Some(0), "1\n") && !err.contains("critical"), "{err}");
    let (status, out, err) = pressed("-1e9");
    assert_eq!((status, out.as_str()), (Some(0), "1\n"), "{err}");
    let told = "the axial load of HDR 1 is 5.0000e8, above its critical load of";
    assert!(err.contains(told) && !err.contains("1.0000e9"), "{err}");
}

/// A block on the paper's Bouc-Wen bearing, whose alpha2 is negative, under a sine of the ground: within the calibrated shear
/// nothing is said. Beyond 0.132 m the backbone pushes the block away, which is reported once.
#[test]
fn backbone_that_turns_negative_is_reported() {
    let shaken = |amplitude: &str| {
        run(&format!(
            "source {}/models/rr_frb_boucwen.tcl\nmodel basic -ndm 3 -ndf 6\nnode 1 0 0 0\nnode 2 0 0 0 -mass 17e3 17e3 17e3 0 0 0\n\
             fix 1 1 1 1 1 1 1\nfix 2 0 1 1 1 1 1\nrr_frb_boucwen 1 1 2\n\
             for {{set i 0}} {{$i < 400}} {{incr i}} {{ lappend g [expr {{{amplitude}*sin(0.03*$i)}}] }}\n\
             timeSeries Path 1 -dt 0.01 -values $g\npattern UniformExcitation 1 1 -accel 1\nconstraints Plain\n\
             numberer Plain\nsystem FullGeneral\ntest NormUnbalance 1e-3 50\nalgorithm Newton\nintegrator Newmark 0.5 0.25\n\
             analysis Transient\nset most 0.0\nfor {{set i 0}} {{$i < 400}} {{incr i}} {{\n    analyze 1 0.01\n\
             set most [expr {{max($most, abs([nodeDisp 2 1]))}}]\n}}\nputs [expr {{$most < 0.132}}]\n",
            env!("CARGO_MANIFEST_DIR")
        ))
    };
    let (status, out, err) = shaken("0.3");
    assert_eq!((status, out.as_str(), err.as_str()), (Some(0), "1\n", ""));
    let (status, out, err) = shaken("0.6");
    assert_eq!((status, out.as_str()), (Some(0), "0\n"), "{err}");
    let told = "warning: the backbone of ElastomericBearingBoucWen3d 1 is negative";
    assert_eq!(err.lines().filter(|l| l.starts_with(told)).count(), 1, "{err}");
    // (alpha1 / -alpha2)^(1/(mu - 1)) of Table 6, mm.
    let end = (0.28f64 / 0.0003).powf(1.0 / 1.4) / 1000.0;
    assert!(err.contains(&format!("beyond {end:.4e}")), "{err}");
}
