//! Derivatives with respect to parameters: `sensitivityAlgorithm sensNodeDisp ...`.

use super::close;
use super::script::{Ran, Script};

fn run(text: &str) -> Ran {
    Script::default().run(text)
}

/// Numbers that a script has put out.
fn numbers(text: &str) -> Vec<f64> {
    let ran = run(text);
    assert!(
        ran.warnings().is_empty() && matches!(ran.end, hysteron::run::End::Done),
        "{:?} {:?}",
        ran.warnings(),
        ran.end
    );
    ran.out.split_whitespace().map(|w| w.parse().unwrap_or_else(|_| panic!("{w}: {:?}", ran.end))).collect()
}

fn assert_close(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    let near = |(a, b): (&f64, &f64)| close(*a, *b, tolerance);
    assert!(found.iter().zip(expected).all(near), "{found:?}\n{expected:?}");
}

const SOLVER: &str =
    "constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-10 20; algorithm Newton";

/// A mass on a bar that yields, under a force that follows a sine.
fn shaken_bar(rest: &str) -> String {
    format!(
        "model basic -ndm 1 -ndf 1; node 1 0.0; node 2 1.0 -mass 2.0; fix 1 1
        uniaxialMaterial Steel01 1 10.0 1000.0 0.05; element truss 1 1 2 1.5 1
        timeSeries Sine 1 0.0 10.0 0.5; pattern Plain 1 1 {{ load 2 20.0 }}
        parameter 1 element 1 E; parameter 2 element 1 Fy; parameter 3 element 1 b; parameter 4 element 1 A
        parameter 5 loadPattern 1 loadAtNode 2 1; parameter 6 node 2 mass x
        {SOLVER}; integrator Newmark 0.5 0.25; analysis Transient
        {rest}"
    )
}

const SHOW: &str = "foreach p [getParamTags] {
    puts \"[sensNodeDisp 2 1 $p] [sensNodeVel 2 1 $p] [sensNodeAccel 2 1 $p]\" }";

/// A bar under a force: u = P L / (E A).
#[test]
fn a_bar_has_the_derivatives_of_its_formula() {
    let found = numbers(&format!(
        "model basic -ndm 1 -ndf 1; node 1 0.0; node 2 2.0; fix 1 1
        uniaxialMaterial Elastic 1 100.0; element truss 1 1 2 0.5 1
        timeSeries Linear 1; pattern Plain 1 1 {{ load 2 3.0 }}
        parameter 1 element 1 E; parameter 2 element 1 A; parameter 3 loadPattern 1 loadAtNode 2 1; parameter 4 7.0
        {SOLVER}; integrator LoadControl 0.5; analysis Static; sensitivityAlgorithm -computeAtEachStep
        analyze 2
        foreach p [getParamTags] {{ puts [sensNodeDisp 2 1 $p] }}
        computeGradients; puts [sensNodeDisp 1 1 1]"
    ));
    let u = 3.0 * 2.0 / (100.0 * 0.5);
    assert_close(&found, &[-u / 100.0, -u / 0.5, u / 3.0, 0.0, 0.0], 1e-7);
}

/// The numbers of openseespy 3.7.1, which differentiates its laws, after 61 steps.
#[test]
fn a_bar_that_yields_in_motion_has_the_derivatives_of_openseespy() {
    let found = numbers(&shaken_bar(&format!("sensitivityAlgorithm -computeAtEachStep; analyze 61 0.01; {SHOW}")));
    let expected = [
        [5.6391524380e-05, -1.1313543929e-04, -9.8098772154e-05],
        [1.9361040438e-02, -1.1861078570e-02, -1.4385390164e+00],
        [2.1855143859e-01, 4.0500444526e+00, 3.9635988895e+01],
        [1.6666795251e-01, -1.5449748333e-01, -9.6556592910e+00],
        [-1.2369298075e-02, 4.3838564928e-02, 9.5499230318e-01],
        [-1.3079836287e-03, -3.2251253678e-01, -2.3081785636e+00],
    ];
    // The last number of the first row is small beside its terms.
    assert_close(&found, &expected.concat(), 1e-5);
}

/// The names and rows of openseespy 3.7.1.
#[test]
fn recorders_write_derivatives() {
    let ran = run(&shaken_bar(
        "recorder Node -file u.out -time -node 2 -dof 1 \"sensitivity 1\"
        recorder Node -file v.out -node 2 -dof 1 \"velSensitivity 5\"
        recorder Node -file a.out -node 2 -dof 1 \"accSensitivity 6\"
        sensitivityAlgorithm -computeAtEachStep; analyze 4 0.01
        puts \"[sensNodeVel 2 1 5] [sensNodeAccel 2 1 6]\"",
    ));
    let rows = [[0.01, -5.66073e-10], [0.02, -5.56845e-09], [0.03, -2.77731e-08], [0.04, -9.52129e-08]];
    assert_close(&ran.tables["u.out"].concat(), &rows.concat(), 2e-6);
    let last = ["v.out", "a.out"].map(|file| ran.tables[file][3][0]);
    assert_close(&last, &ran.numbers(), 1e-15);
    assert_close(&last, &[4.3878397387e-03, -1.4980491660e+00], 1e-6);
}

/// The analysis itself has the same bits with derivatives and without, and a static one before it and changes between steps
/// leave them what they are.
#[test]
fn the_analysis_is_the_same_with_derivatives() {
    let motion = "analyze 30 0.01; loadConst; pattern Plain 2 1 { load 2 -5.0 }; for {set i 0} {$i < 30} {incr i} { analyze 1 0.01
        puts [format %.17g [nodeDisp 2 1]] }";
    let without = numbers(&shaken_bar(motion));
    let with = numbers(&shaken_bar(&format!("sensitivityAlgorithm -computeAtEachStep; {motion}; {SHOW}")));
    assert_eq!(with[..30], without[..]);
    // Against two whole analyses with other strengths.
    let end = |strength: f64| {
        let text = shaken_bar(&format!("updateParameter 2 {strength}; {motion}"));
        *numbers(&text.replace("1e-10", "1e-13")).last().unwrap()
    };
    let difference = (end(10.001) - end(9.999)) / 0.002;
    assert!(difference != 0.0 && close(with[30 + 3], difference, 1e-6), "{} {difference}", with[30 + 3]);
}

/// Two materials of a section have a modulus: the derivative is that of both together, which keep their own values. The number
/// is that of openseespy 3.7.1.
#[test]
fn numbers_under_one_name_keep_their_values() {
    let found = numbers(&format!(
        "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 3.0 0; node 3 6.0 1.0; fix 1 1 1 1
        uniaxialMaterial Steel01 1 300.0 2.0e5 0.02; uniaxialMaterial Elastic 2 3.0e4
        section Fiber 1 {{ patch rect 2 10 1 -0.2 -0.1 0.2 0.1; layer straight 1 2 1e-3 0.18 -0.08 0.18 0.08
            layer straight 1 2 1e-3 -0.18 -0.08 -0.18 0.08 }}
        geomTransf Linear 1; element forceBeamColumn 1 1 2 4 1 1; element dispBeamColumn 2 2 3 3 1 1
        timeSeries Linear 1; pattern Plain 1 1 {{ load 3 0.0 -1.0 0.0 }}
        parameter 1 element 1 fy; parameter 2 element 1 E; parameter 4 loadPattern 1 loadAtNode 3 2
        {SOLVER}; integrator LoadControl 0.01; analysis Static; sensitivityAlgorithm -computeAtEachStep
        analyze 20
        puts \"[sensNodeDisp 2 2 1] [sensNodeDisp 2 2 2] [sensNodeDisp 2 2 4]\"
        puts \"[sensSectionForce 1 1 2 1] [sensSectionForce 1 1 2 4] [nodeDisp 2 2]\""
    ));
    assert_close(&found[..2], &[9.86135957066197e-05, 3.6222221644409554e-06], 1e-6);
    // The beam is statically determinate: no strength changes the moment, 6 λ P.
    assert!(found[3].abs() < 1e-12 && close(found[4], 1.2, 1e-7), "{found:?}");
    assert_close(&found[2..3], &[0.6987924865831902 * 0.2], 1e-7);
}

/// A bearing whose law OpenSees does not differentiate, pushed by a displacement: the load factor follows the strength.
#[test]
fn a_bearing_under_a_controlled_displacement_has_them_too() {
    let bearing = |strength: f64, rest: &str| {
        numbers(&format!(
            "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 1; fix 1 1 1 1; fix 2 0 1 1
            uniaxialMaterial Elastic 1 1e6; uniaxialMaterial Elastic 2 1e6
            element elastomericBearingBoucWen 1 1 2 800.0 {strength} 0.1 0.0 2.0 1.0 0.5 0.5 -P 1 -Mz 2
            timeSeries Linear 1; pattern Plain 1 1 {{ load 2 1.0 0.0 0.0 }}
            parameter 1 element 1 qd
            constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-12 30; algorithm Newton
            integrator DisplacementControl 2 1 0.002; analysis Static; {rest}"
        ))
    };
    let (steps, factor) =
        ("analyze 30; integrator DisplacementControl 2 1 -0.002; analyze 20", "; puts [getLoadFactor 1]");
    let found = bearing(
        40.0,
        &format!("sensitivityAlgorithm -computeByCommand; {steps}; puts [sensLambda 1 1]; puts [sensNodeDisp 2 1 1]"),
    );
    let all = format!("{steps}{factor}");
    let difference = (bearing(40.001, &all)[0] - bearing(39.999, &all)[0]) / 0.002;
    assert!(difference.abs() > 0.1 && close(found[0], difference, 1e-6), "{found:?} {difference}");
    assert!(found[1].abs() < 1e-12, "{found:?}");
}

/// The virgin model has no derivatives, and none are made where the command is missing.
#[test]
fn a_reset_ends_them_and_without_the_command_there_are_none() {
    let found = numbers(&shaken_bar(
        "sensitivityAlgorithm -computeAtEachStep; analyze 5 0.01; reset; puts [sensNodeDisp 2 1 1]
        analyze 11 0.01; puts [sensNodeDisp 2 1 5]",
    ));
    let again =
        numbers(&shaken_bar("sensitivityAlgorithm -computeAtEachStep; analyze 11 0.01; puts [sensNodeDisp 2 1 5]"));
    assert_eq!(found, [0.0, again[0]]);
    let ran = run(&shaken_bar("analyze 5 0.01; puts [sensNodeDisp 2 1 1]"));
    assert_eq!(ran.out.trim(), "0.0");
    assert!(ran.warnings().iter().any(|w| w.message.contains("sensitivityAlgorithm")), "{:?}", ran.warnings());
}

/// A parameter that gets another place, and one that loses a place, between two analyses.
#[test]
fn places_of_a_parameter_may_come_and_go() {
    let bars = |rest: &str| {
        numbers(&format!(
            "model basic -ndm 1 -ndf 1; node 1 0.0; node 2 2.0; fix 1 1
            uniaxialMaterial Elastic 1 100.0; foreach e {{1 2}} {{ element truss $e 1 2 0.5 1 }}
            timeSeries Linear 1; pattern Plain 1 1 {{ load 2 3.0 }}
            parameter 1 element 1 A; parameter 2 7.0
            {SOLVER}; integrator LoadControl 0.5; analysis Static; sensitivityAlgorithm -computeAtEachStep
            analyze 1; puts [sensNodeDisp 2 1 1]; {rest}; analyze 1; puts \"[sensNodeDisp 2 1 1] [sensNodeDisp 2 1 2]\""
        ))
    };
    // u = λ P L / (E A) of both areas together.
    let slope = |factor: f64, area: f64| -factor * 3.0 * 2.0 / (100.0 * area * area);
    assert_close(&bars("addToParameter 1 element 2 A"), &[slope(0.5, 1.0), 2.0 * slope(1.0, 1.0), 0.0], 1e-7);
    let found = bars("addToParameter 1 element 2 A; remove element 2");
    assert_close(&found, &[slope(0.5, 1.0), slope(1.0, 0.5), 0.0], 1e-7);
}

/// A bar loaded to 0.99995 of its strength: with a strength less by 1e-4 it does not carry the load.
#[test]
fn a_failed_analysis_beside_leaves_no_derivative() {
    let bar = |show: &str| {
        run(&format!(
            "model basic -ndm 1 -ndf 1; node 1 0.0; node 2 2.0; fix 1 1
            uniaxialMaterial Steel01 1 10.0 1000.0 0.0; element truss 1 1 2 1.0 1
            timeSeries Linear 1; pattern Plain 1 1 {{ load 2 9.9995 }}
            parameter 1 element 1 Fy; parameter 2 element 1 E
            {SOLVER}; integrator LoadControl 0.5; analysis Static; sensitivityAlgorithm -computeAtEachStep
            puts [analyze 2]; puts [sensNodeDisp 2 1 2]; puts [{show}]"
        ))
    };
    let ran = bar("sensNodeDisp 2 1 1");
    assert!(ran.error().message.starts_with("there is no derivative with respect to parameter 1"), "{:?}", ran.end);
    let found = ran.numbers();
    assert_eq!(found[0], 0.0);
    assert_close(&found[1..], &[-9.9995 * 2.0 / 1e6], 1e-7);
    assert!(bar("sensNodeDisp 2 1 77").error().message.contains("77"));
}

/// More of a ratio just below 1 is refused, and less of a mass of 0: a parameter of both cannot be varied.
#[test]
fn a_parameter_that_takes_no_other_value_has_no_derivative() {
    let ran = run(&format!(
        "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 1; fix 1 1 1 1; fix 2 0 1 1
        uniaxialMaterial Elastic 1 1e6
        element elastomericBearingBoucWen 1 1 2 800.0 40.0 0.9999999 0.0 2.0 1.0 0.5 0.5 -P 1 -Mz 1
        timeSeries Linear 1; pattern Plain 1 1 {{ load 2 1.0 0.0 0.0 }}
        parameter 1 node 2 mass x; addToParameter 1 element 1 alpha1
        {SOLVER}; integrator LoadControl 1.0; analysis Static; sensitivityAlgorithm -computeAtEachStep
        puts [sensNodeDisp 2 1 1]; puts [analyze 3]; puts [sensNodeDisp 2 1 1]"
    ));
    assert_eq!(ran.numbers(), [0.0, 0.0]);
    let error = ran.error();
    assert!(error.message.ends_with("parameter 1") && error.label.contains("no other value"), "{error:?}");
}
