//! Natural modes.

use super::close;
use super::script::{Script, run};

/// A shear building of equal storeys: ω_i = 2 sqrt(k/m) sin((2i-1) π / (2 (2n+1))).
fn shear_building(n: usize, solver: &str, dense: bool) -> Vec<f64> {
    let mut script = Script::default();
    script.options.dense = Some(dense);
    let text = format!(
        "model basic -ndm 1 -ndf 1
        node 0 0; fix 0 1
        uniaxialMaterial Elastic 1 900.0
        for {{set i 1}} {{$i <= {n}}} {{incr i}} {{
            node $i 0 -mass 4.0
            element zeroLength $i [expr {{$i-1}}] $i -mat 1 -dir 1
        }}
        puts [eigen {solver} {count}]",
        count = n.min(6),
    );
    script.run(&text).done().numbers()
}

#[test]
fn shear_buildings_have_their_frequencies() {
    for n in [1, 2, 5, 40, 300] {
        for solver in ["", "-genBandArpack", "-fullGenLapack", "-symmBandLapack"] {
            for dense in [true, false] {
                for (i, lambda) in shear_building(n, solver, dense).iter().enumerate() {
                    let angle = (2 * i + 1) as f64 * std::f64::consts::PI / (2 * (2 * n + 1)) as f64;
                    let exact = 4.0 * 900.0 / 4.0 * angle.sin().powi(2);
                    assert!(close(*lambda, exact, 1e-9), "{n} storeys, mode {}: {lambda} and {exact}", i + 1);
                }
            }
        }
    }
}

/// Two equal oscillators have the same frequency twice; shapes are of unit modal mass and do not mix masses up.
#[test]
fn equal_frequencies_are_all_found() {
    let ran = run("model basic -ndm 3 -ndf 3
        set tag 0
        uniaxialMaterial Elastic 1 100.0
        foreach x {0 1 2} {
            node 1$x $x 0 0; node 2$x $x 0 0 -mass 1.0 1.0 1.0
            fix 1$x 1 1 1
            element zeroLength [incr tag] 1$x 2$x -mat 1 1 1 -dir 1 2 3
        }
        puts [eigen 9]
        for {set m 1} {$m <= 9} {incr m} {
            set sum 0.0
            foreach x {0 1 2} { foreach u [nodeEigenvector 2$x $m] { set sum [expr {$sum + $u**2}] } }
            puts $sum
        }");
    for (i, v) in ran.numbers().iter().enumerate() {
        assert!(close(*v, if i < 9 { 100.0 } else { 1.0 }, 1e-9), "{i}: {v}");
    }
}

/// Mode shapes satisfy K φ = λ M φ with massless degrees of freedom and a rigid diaphragm between.
#[test]
fn massless_degrees_of_freedom_follow() {
    let ran = run("model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 0 2; node 3 0 4
        fix 1 1 1 1
        mass 2 3.0 0 0; mass 3 3.0 0 0
        geomTransf Linear 1
        element elasticBeamColumn 1 1 2 1e6 2e8 1e-6 1
        element elasticBeamColumn 2 2 3 1e6 2e8 1e-6 1
        puts [eigen 2]
        puts [expr {[nodeEigenvector 3 1 1]/[nodeEigenvector 2 1 1]}]");
    // Flexibility of a cantilever with two masses (Clough and Penzien, chapter 11): L = 2, EI = 200.
    let (f11, f12, f22) = (8.0f64 / 600.0, 20.0 / 600.0, 64.0 / 600.0);
    let m = 3.0;
    let (trace, det) = (m * (f11 + f22), m * m * (f11 * f22 - f12 * f12));
    let largest = 0.5 * (trace + (trace * trace - 4.0 * det).sqrt());
    let v = ran.numbers();
    assert!(close(v[0], 1.0 / largest, 1e-8), "{v:?}");
    assert!(close(v[1], largest / det, 1e-8), "{v:?}");
    let shape = (largest / m - f11) / f12;
    assert!(close(v[2], shape, 1e-8), "{v:?} and {shape}");
}

/// Modes of a mass of 10 on a bearing that a load beyond its strength has moved. Also the displacement along x, and the
/// first mode along x and z.
fn modes_of_a_yielded(bearing: &str, load: [f64; 2]) -> Vec<f64> {
    let [x, y] = load;
    run(&format!(
        "model basic -ndm 3 -ndf 6
        node 1 0 0 0; node 2 0 0 0.3 -mass 10 10 10 0 0 0
        fix 1 1 1 1 1 1 1; fix 2 0 0 0 1 1 1
        uniaxialMaterial Elastic 1 1e6; uniaxialMaterial Elastic 2 1e4
        frictionModel Coulomb 1 0.05
        element {bearing} -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0
        timeSeries Linear 1
        pattern Plain 1 1 {{ load 2 0 0 -1000 0 0 0 }}
        constraints Plain; numberer Plain; system FullGeneral
        test NormDispIncr 1e-12 100; algorithm Newton
        integrator LoadControl 1.0; analysis Static
        analyze 1
        loadConst -time 0
        pattern Plain 2 1 {{ load 2 {x} {y} 0 0 0 0 }}
        integrator LoadControl 0.01
        if {{[analyze 100] != 0}} {{ error failed }}
        puts [concat [eigen 3] [nodeDisp 2 1] [nodeEigenvector 2 1 1] [nodeEigenvector 2 1 3]]"
    ))
    .done()
    .numbers()
}

/// The tangent of a bearing that yields or slides is that of loading, not of unloading. Along the force it is the
/// stiffness after yield; across it, the strength over the displacement.
#[test]
fn modes_after_yielding_are_those_of_the_last_step() {
    let v = modes_of_a_yielded("elastomericBearingPlasticity 1 1 2 5000 80 0.1 0 3", [100.0, 0.0]);
    assert!(close(v[0], 0.1 * 5000.0 / 10.0, 1e-9), "{v:?}");
    assert!(v[1] > v[0] && v[1] < 500.0 && close(v[2], 1e5, 1e-9), "{v:?}");
    // The friction of a pendulum follows the axial force: a tangent that is not symmetric, whose vertical mode stands by itself.
    let v = modes_of_a_yielded("singleFPBearing 1 1 2 1 2.0 8000", [70.0, 0.0]);
    let radius = (4.0f64 - v[3] * v[3]).sqrt();
    // N = 1000 along the axis: F = N tan + mu N / cos(a), with a the slope of the dish.
    let along = 1000.0 * (4.0 / radius.powi(3) + 0.05 * 2.0 * v[3] / radius.powi(3)) / 10.0;
    assert!(close(v[0], along, 2e-2), "{v:?} {along}");
    assert!(v[1] > 300.0 && v[1] < 900.0 && close(v[2], 1e5, 1e-2), "{v:?}");
    // The shape of the first, of unit length in the mass, is along the force.
    assert!(close(v[4].abs(), 0.1f64.sqrt(), 1e-6) && v[5].abs() < 1e-3, "{v:?}");
}

/// A free body: its rigid motions have the frequency zero.
#[test]
fn a_floating_body_has_modes_of_zero() {
    let ran = run("model basic -ndm 1 -ndf 1
        node 1 0 -mass 2.0; node 2 0 -mass 3.0
        uniaxialMaterial Elastic 1 60.0
        element zeroLength 1 1 2 -mat 1 -dir 1
        puts [eigen 2]");
    let v = ran.numbers();
    assert!(v[0].abs() < 1e-6 && close(v[1], 60.0 * (0.5 + 1.0 / 3.0), 1e-6), "{v:?}");
}

#[test]
fn standard_and_largest() {
    let text = "model basic -ndm 1 -ndf 1
        node 0 0; fix 0 1
        uniaxialMaterial Elastic 1 1.0
        foreach i {1 2 3} { node $i 0 -mass 2.0; element zeroLength $i [expr {$i-1}] $i -mat 1 -dir 1 }\n";
    let all = run(&format!("{text}puts [eigen 3]")).numbers();
    let standard = run(&format!("{text}puts [eigen -standard 3]")).numbers();
    let largest = run(&format!("{text}puts [eigen -findLargest 1]")).numbers();
    for (g, s) in all.iter().zip(&standard) {
        assert!(close(2.0 * g, *s, 1e-9));
    }
    assert!(close(largest[0], all[2], 1e-9));
}

#[test]
fn more_modes_than_there_are_is_an_error() {
    let ran = Script::default().run(
        "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0 -mass 1.0; node 3 0; fix 1 1
        uniaxialMaterial Elastic 1 1.0
        element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 2 3 -mat 1 -dir 1
        eigen 2",
    );
    assert!(ran.error().message.contains("only 1 modes"), "{}", ran.error().message);
}

/// OpenSees makes a transient analysis for the modes of a Tcl script, with Newmark's method, which a later command may replace.
#[test]
fn modes_without_an_analysis_make_a_transient_one() {
    let model = |eigen: &str, analysis: &str| {
        format!(
            "model basic -ndm 1 -ndf 1; node 1 0; node 2 0 -mass 2.; fix 1 1
            uniaxialMaterial Elastic 1 50.; element zeroLength 1 1 2 -mat 1 -dir 1
            timeSeries Trig 1 0 10 1.; pattern Plain 1 1 {{ load 2 3. }}
            {eigen}; {analysis}
            puts [analyze 20 0.02]; puts [nodeDisp 2 1]"
        )
    };
    let given = "constraints Transformation; algorithm Newton; integrator Newmark 0.5 0.25; analysis Transient";
    let made = run(&model("eigen -fullGenLapack 1", "")).numbers();
    assert_eq!(made, run(&model("", given)).numbers());
    assert_eq!(made[0], 0.0);
    // Without modes there is no analysis; one that is given takes the place of the one that was made.
    assert_eq!(run(&model("", "")).numbers(), [-1.0, 0.0]);
    let fixed = "integrator LoadControl 0.02; analysis Static";
    assert_eq!(run(&model("eigen -fullGenLapack 1", fixed)).numbers(), run(&model("", fixed)).numbers());
}
