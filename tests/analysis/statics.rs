//! Equilibrium.

use super::close;
use super::script::{Script, run};

/// Tip of an elastic cantilever, plane and space, through every system name and both kinds of matrix.
#[test]
fn cantilever_through_every_system() {
    for system in
        ["BandGeneral", "BandSPD", "ProfileSPD", "SparseGeneral", "UmfPack", "FullGeneral", "SparseSYM", "Mumps"]
    {
        for dense in [true, false] {
            let mut script = Script::default();
            script.options.dense = Some(dense);
            let text = format!(
                "model basic -ndm 2 -ndf 3
                for {{set i 0}} {{$i <= 10}} {{incr i}} {{ node $i [expr {{0.4*$i}}] 0.0 }}
                fix 0 1 1 1
                geomTransf Linear 1
                for {{set i 1}} {{$i <= 10}} {{incr i}} {{ element elasticBeamColumn $i [expr {{$i-1}}] $i 0.02 2e8 1e-4 1 }}
                timeSeries Linear 1
                pattern Plain 1 1 {{ load 10 5.0 -12.0 3.0 }}
                system {system}; numberer RCM; constraints Plain; test NormDispIncr 1e-12 5; algorithm Newton
                integrator LoadControl 1.0; analysis Static
                analyze 1
                puts [nodeDisp 10]"
            );
            let u = script.run(&text).done().numbers();
            let (l, ei) = (4.0f64, 2e8 * 1e-4);
            assert!(close(u[0], 5.0 * l / (2e8 * 0.02), 1e-9), "{system}");
            assert!(close(u[1], -12.0 * l.powi(3) / (3.0 * ei) + 3.0 * l * l / (2.0 * ei), 1e-9), "{system}");
            assert!(close(u[2], -12.0 * l * l / (2.0 * ei) + 3.0 * l / ei, 1e-9), "{system}");
        }
    }
}

/// A column under its axial load: P-Delta stiffness, and buckling of the corotational one at Euler's load.
#[test]
fn columns_lose_stiffness_under_axial_load() {
    let push = |transf: &str, p: f64| {
        let ran = run(&format!(
            "model basic -ndm 2 -ndf 3
            for {{set i 0}} {{$i <= 16}} {{incr i}} {{ node $i 0.0 [expr {{0.25*$i}}] }}
            fix 0 1 1 1
            geomTransf {transf} 1
            for {{set i 1}} {{$i <= 16}} {{incr i}} {{ element elasticBeamColumn $i [expr {{$i-1}}] $i 0.1 2e8 1e-5 1 }}
            timeSeries Linear 1
            pattern Plain 1 1 {{ load 16 0.0 [expr -{p}] 0.0 }}
            system BandGeneral; numberer RCM; constraints Plain; test NormUnbalance 1e-6 30; algorithm Newton
            integrator LoadControl 0.1; analysis Static
            analyze 10
            loadConst -time 0.0
            pattern Plain 2 1 {{ load 16 1e-3 0.0 0.0 }}
            integrator LoadControl 1.0
            analyze 1
            puts [nodeDisp 16 1]"
        ));
        1e-3 / ran.numbers()[0]
    };
    let (l, ei) = (4.0f64, 2e8 * 1e-5);
    let p = 0.6 * (std::f64::consts::PI / (2.0 * l)).powi(2) * ei;
    // Beam-column theory: u = H (tan kL - kL) / (P k).
    let k = (p / ei).sqrt();
    let exact = p * k / ((k * l).tan() - k * l);
    for transf in ["PDelta", "Corotational"] {
        let found = push(transf, p);
        assert!(close(found, exact, 4e-3), "{transf}: {found} and {exact}");
    }
    assert!(close(push("Linear", p), 3.0 * ei / l.powi(3), 1e-6));
}

/// A softening spring is followed past its peak by displacement control, and the load factor falls.
#[test]
fn displacement_control_follows_softening() {
    let ran = run("model basic -ndm 1 -ndf 1
        node 1 0; node 2 0
        fix 1 1
        uniaxialMaterial Steel01 1 10.0 1000.0 -0.05
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Linear 1
        pattern Plain 1 1 { load 2 2.0 }
        system BandGeneral; numberer Plain; constraints Plain; test NormUnbalance 1e-10 20; algorithm Newton
        integrator DisplacementControl 2 1 0.002
        analysis Static
        puts [analyze 30]
        puts [nodeDisp 2 1]
        puts [getTime]
        puts [eleResponse 1 material 1 stress]");
    let v = ran.numbers();
    assert_eq!(v[0], 0.0);
    assert!(close(v[1], 0.06, 1e-12));
    assert!(close(v[3], 10.0 - 50.0 * 0.05, 1e-9), "stress {}", v[3]);
    assert!(close(v[2], 0.5 * v[3], 1e-9), "load factor {}", v[2]);
}

/// All algorithms come to the same equilibrium of a yielding frame of springs.
#[test]
fn algorithms_come_to_the_same_answer() {
    let answer = |algorithm: &str| {
        run(&format!(
            "model basic -ndm 2 -ndf 2
            node 1 0 0; node 2 3 0; node 3 1.5 2; node 4 1.5 4
            fix 1 1 1; fix 2 1 1
            uniaxialMaterial Steel01 1 250.0 2e5 0.02
            uniaxialMaterial BoucWen 2 0.05 1e5 2.0 3e4 3e4 1.0 0.0 0.0 0.0
            element truss 1 1 3 0.01 1; element truss 2 2 3 0.012 1; element truss 3 3 4 0.01 2
            element truss 4 1 4 0.005 1; element truss 5 2 4 0.006 2
            timeSeries Linear 1
            pattern Plain 1 1 {{ load 4 0.9 -0.6 }}
            system BandGeneral; numberer Plain; constraints Plain; test NormUnbalance 1e-11 2000
            algorithm {algorithm}
            integrator LoadControl 0.1; analysis Static
            puts [analyze 14]
            puts [nodeDisp 4]"
        ))
        .numbers()
    };
    let reference = answer("Newton");
    assert_eq!(reference[0], 0.0);
    for algorithm in [
        "Newton -initial",
        "Newton -initialThenCurrent",
        "Newton -Hall 0.3 0.7",
        "ModifiedNewton",
        "ModifiedNewton -initial",
        "KrylovNewton",
        "KrylovNewton -maxDim 6 -iterate initial -increment initial",
        "MillerNewton -maxDim 4",
        "SecantNewton",
        "PeriodicNewton -maxDim 2",
        "NewtonLineSearch",
        "NewtonLineSearch -type Bisection",
        "NewtonLineSearch -type Secant",
        "NewtonLineSearch -type RegulaFalsi -tol 0.5",
    ] {
        let other = answer(algorithm);
        assert_eq!(other[0], 0.0, "{algorithm}");
        assert!(close(other[1], reference[1], 1e-8) && close(other[2], reference[2], 1e-8), "{algorithm}: {other:?}");
    }
}

/// Every test stops the iterations; those that measure something leave the same answer.
#[test]
fn tests_stop_the_iterations() {
    let mut reference = None;
    for test in [
        "NormDispIncr 1e-12 30",
        "NormUnbalance 1e-9 30",
        "EnergyIncr 1e-20 30",
        "RelativeNormDispIncr 1e-12 30",
        "RelativeNormUnbalance 1e-10 30",
        "RelativeEnergyIncr 1e-20 30",
        "RelativeTotalNormDispIncr 1e-12 30",
        "FixedNumIter 12",
        "NormDispAndUnbalance 1e-12 1e-9 30",
        "NormDispOrUnbalance 1e-12 1e-9 30",
        "NormDispIncr 1e-12 30 0 0",
        "NormDispIncr 1e-12 30 0 1",
    ] {
        let ran = run(&format!(
            "model basic -ndm 1 -ndf 1
            node 1 0; node 2 0; fix 1 1
            uniaxialMaterial BoucWen 1 0.1 100.0 2.0 50.0 50.0 1.0 0 0 0
            element zeroLength 1 1 2 -mat 1 -dir 1
            timeSeries Linear 1
            pattern Plain 1 1 {{ load 2 3.0 }}
            system BandGeneral; numberer Plain; constraints Plain; test {test}; algorithm Newton
            integrator LoadControl 0.25; analysis Static
            puts [analyze 8]; puts [nodeDisp 2 1]; puts [testIter]"
        ));
        let v = ran.numbers();
        assert_eq!(v[0], 0.0, "{test}");
        let u = *reference.get_or_insert(v[1]);
        assert!(close(v[1], u, 1e-8), "{test}: {} and {u}", v[1]);
        assert!(v[2] >= 1.0 && v[2] <= 30.0, "{test}");
    }
}

/// A laboratory test: every degree of freedom is imposed, no equation is left.
#[test]
fn a_model_without_equations_runs() {
    let ran = run("model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; fix 1 1
        uniaxialMaterial ElasticPP 1 100.0 0.01
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Path 1 -dt 1.0 -values {0.0 0.005 0.02 0.01 -0.02 0.0 0.0}
        pattern Plain 1 1 { sp 2 1 1.0 }
        recorder Element -file f.out -time -ele 1 material 1 stressStrain
        constraints Transformation; numberer Plain; system BandGeneral; test NormDispIncr 1e-9 20; algorithm Newton
        integrator LoadControl 1.0; analysis Static
        puts [analyze 5]");
    assert_eq!(ran.numbers(), [0.0]);
    let stress: Vec<f64> = ran.tables["f.out"].iter().map(|r| r[1]).collect();
    for (found, expected) in stress.iter().zip([0.5, 1.0, 0.0, -1.0, 1.0]) {
        assert!((found - expected).abs() < 1e-12, "{stress:?}");
    }
}

/// A device on an imposed path is in balance as each step begins, until a load comes: then it is solved for again.
#[test]
fn load_after_steps_without_one_is_carried() {
    let drive = |algorithm: &str| {
        run(&format!(
            "model basic -ndm 2 -ndf 3
            node 1 0 0; node 2 0 0.2
            fix 1 1 1 1; fix 2 0 0 1
            uniaxialMaterial Elastic 1 4e5
            uniaxialMaterial Elastic 2 1e5
            element elastomericBearingBoucWen 1 1 2 1820 13 0.28 0 2 1 0.5 0.5 -P 1 -Mz 2 -orient 0 1 0 -1 0 0
            timeSeries Trig 1 0 10 1
            timeSeries Path 2 -dt 0.25 -values {{0 0 1 0}} -useLast
            pattern Plain 1 1 {{ sp 2 1 0.05 }}
            pattern Plain 2 2 {{ load 2 0 -800 0 }}
            constraints Transformation; numberer Plain; system BandGeneral
            test NormDispIncr 1e-12 20; algorithm {algorithm}; integrator LoadControl 0.01; analysis Static
            set out {{}}
            for {{set i 0}} {{$i < 100}} {{incr i}} {{ analyze 1; lappend out {{*}}[nodeDisp 2] {{*}}[eleResponse 1 force] }}
            puts $out"
        ))
        .done()
        .numbers()
    };
    let (newton, modified) = (drive("Newton"), drive("ModifiedNewton"));
    assert_eq!(newton.len(), 900);
    for (k, (a, b)) in newton.iter().zip(&modified).enumerate() {
        assert!((a - b).abs() <= 1e-9 * (1.0 + b.abs()), "{k}: {a} {b}");
    }
    // At 0.5 s the whole load, at 1 s none.
    assert!(close(newton[49 * 9 + 1], -800.0 / 4e5, 1e-12));
    assert!(newton[99 * 9 + 1].abs() < 1e-15);
}

#[test]
fn adaptive_steps_stay_within_their_limits() {
    let ran = run("model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; fix 1 1
        uniaxialMaterial Elastic 1 100.0
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Linear 1
        pattern Plain 1 1 { load 2 1.0 }
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 20; algorithm Newton
        integrator LoadControl 0.1 4 0.05 1.0; analysis Static
        foreach i {1 2 3 4} { analyze 1; puts [getTime] }");
    // One iteration a step: the step is multiplied by four until the limit.
    let expected = [0.1, 0.5, 1.5, 2.5];
    for (t, e) in ran.numbers().iter().zip(expected) {
        assert!(close(*t, e, 1e-12), "{:?}", ran.numbers());
    }
}

#[test]
fn reactions_balance_the_loads() {
    let ran = run("model basic -ndm 3 -ndf 6
        node 1 0 0 0; node 2 4 0 0; node 3 4 3 0; node 4 0 0 5; node 5 4 0 5; node 6 4 3 5
        foreach n {1 2 3} { fix $n 1 1 1 1 1 1 }
        geomTransf Linear 1 1 0 0; geomTransf Linear 2 0 0 1
        foreach {e i j} {1 1 4 2 2 5 3 3 6} { element elasticBeamColumn $e $i $j 0.1 3e7 1.2e7 0.002 0.001 0.0015 1 }
        foreach {e i j} {4 4 5 5 5 6} { element elasticBeamColumn $e $i $j 0.08 3e7 1.2e7 0.002 0.001 0.0015 2 }
        timeSeries Constant 1
        pattern Plain 1 1 {
            load 4 10 -5 -20 1 2 3
            eleLoad -ele 4 -type -beamUniform -3.0 2.0 0.5
            eleLoad -ele 5 -type -beamPoint -7.0 1.0 0.4 2.0
        }
        system SparseGeneral; numberer RCM; constraints Transformation; test NormUnbalance 1e-9 5; algorithm Newton
        integrator LoadControl 1.0; analysis Static
        analyze 1
        foreach n {1 2 3} { puts [nodeReaction $n] }");
    let r = ran.numbers();
    let sum = |k: usize| r[k] + r[6 + k] + r[12 + k];
    // Beam 4 runs along x with local z up and local y along y; beam 5 runs along y, local y is against x.
    let applied = [10.0 + 0.5 * 4.0 + 7.0, -5.0 - 3.0 * 4.0 + 2.0, -20.0 + 2.0 * 4.0 + 1.0];
    for (k, applied) in applied.iter().enumerate() {
        assert!((sum(k) + applied).abs() < 1e-8, "direction {}: {} and {applied}", k + 1, sum(k));
    }
}

/// A section by its tag equals the section by its numbers. Factors 4, 4 and 2 give the unmodified beam. A column bent
/// into a circle by a moment ends at the end of the circle.
#[test]
fn forms_of_elastic_beams() {
    let cantilever = |element: &str, transform: &str, load: &str, parts: usize| {
        let ran = run(&format!(
            "model basic -ndm 3 -ndf 6
            for {{set i 0}} {{$i <= {parts}}} {{incr i}} {{ node $i [expr {{4.0*$i/{parts}}}] 0 0 }}
            fix 0 1 1 1 1 1 1
            geomTransf {transform} 1 0 0 1
            section Elastic 7 2e5 0.02 1e-3 6e-4 8e4 1e-3
            section Elastic 8 2e5 0.02 1e-3 6e-4 8e4 1e-3 0.8 0.7
            for {{set i 1}} {{$i <= {parts}}} {{incr i}} {{ element elasticBeamColumn $i [expr {{$i-1}}] $i {element} }}
            timeSeries Linear 1
            pattern Plain 1 1 {{ load {parts} {load} }}
            constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-9 50; algorithm Newton
            integrator LoadControl 0.05; analysis Static
            analyze 20
            puts [nodeDisp {parts}]"
        ));
        ran.numbers()
    };
    let load = "1 2 3 0 0 0";
    let numbers = cantilever("0.02 2e5 8e4 1e-3 6e-4 1e-3 1", "Linear", load, 1);
    assert_eq!(numbers, cantilever("7 1", "Linear", load, 1));
    let shear = cantilever("8 1", "Linear", load, 1);
    let sheared = 2.0 * 64.0 / (3.0 * 200.0) + 2.0 * 4.0 / (8e4 * 0.02 * 0.8);
    assert!(close(shear[1], sheared, 1e-9), "{} and {sheared}", shear[1]);

    // A quarter of a circle about the global z axis.
    let angle = 0.5 * std::f64::consts::PI;
    let moment = angle * 200.0 / 4.0;
    let v = cantilever("7 1", "Corotational", &format!("0 0 0 0 0 {moment}"), 16);
    let radius = 4.0 / angle;
    assert!(close(v[5], angle, 1e-6), "{v:?}");
    assert!(close(v[0], radius - 4.0, 5e-3) && close(v[1], radius, 5e-3), "{v:?}");
    assert!(v[2].abs() < 1e-9);
}

#[test]
fn factors_of_a_modified_beam() {
    let tip = |element: &str| {
        let ran = run(&format!(
            "model basic -ndm 2 -ndf 3
            node 1 0 0; node 2 0 3; fix 1 1 1 1
            geomTransf Linear 1
            element {element}
            timeSeries Linear 1
            pattern Plain 1 1 {{ load 2 1 0 0; eleLoad -ele 1 -type -beamUniform 0.5 }}
            constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 5; algorithm Newton
            integrator LoadControl 1.0; analysis Static
            analyze 1
            puts [nodeDisp 2]"
        ));
        ran.numbers()
    };
    let plain = tip("elasticBeamColumn 1 1 2 0.02 2e5 1e-3 1");
    assert_eq!(plain, tip("ModElasticBeam2d 1 1 2 0.02 2e5 1e-3 4 4 2 1"));
    assert!(tip("ModElasticBeam2d 1 1 2 0.02 2e5 1e-3 6 6 3 1")[0].abs() < plain[0].abs());
}

/// Degree of freedom 0 asks for all of them.
#[test]
fn no_degree_of_freedom_is_all_of_them() {
    let ran = run("model basic -ndm 2 -ndf 2
        node 1 0 0
        setNodeDisp 1 2 3.5
        puts [nodeDisp 1 0]");
    assert_eq!(ran.numbers(), [0.0, 3.5]);
}

/// A released end carries no moment, whatever the load: it is as if a hinge joined the beam to a node of its own.
#[test]
fn a_release_is_a_hinge() {
    let loads =
        ["-beamUniform -5 3 0.2 0.7", "-beamUniform -5 3 0.2 0.7 -9 4", "-beamPoint -7 0.3 2", "-beamUniform -5 3 0.4"];
    for load in loads {
        for (release, hinged) in [(1, 1), (2, 2)] {
            let frame = |hinge: bool| {
                let (i, j) = match (hinge, hinged) {
                    (true, 1) => (4, 2),
                    (true, _) => (1, 4),
                    _ => (1, 2),
                };
                let (extra, option) = if hinge {
                    let x = if hinged == 1 { 0 } else { 4 };
                    (format!("node 4 {x} 0; equalDOF {hinged} 4 1 2"), String::new())
                } else {
                    (String::new(), format!("-release {release}"))
                };
                let text = format!(
                    "model basic -ndm 2 -ndf 3
                    node 1 0 0; node 2 4 0; node 3 4 3
                    fix 1 1 1 1; fix 3 1 1 1
                    {extra}
                    geomTransf Linear 1
                    element elasticBeamColumn 1 {i} {j} 0.05 2e7 0.0004 1 {option}
                    element elasticBeamColumn 2 2 3 0.05 2e7 0.0004 1
                    timeSeries Linear 1
                    pattern Plain 1 1 {{ eleLoad -ele 1 -type {load} }}
                    system FullGeneral; numberer Plain; constraints Transformation
                    test NormDispIncr 1e-12 5; algorithm Newton
                    integrator LoadControl 1.0; analysis Static
                    analyze 1
                    puts [concat [nodeDisp 2] [eleForce 1] [eleForce 2]]"
                );
                run(&text).numbers()
            };
            let (with, without) = (frame(false), frame(true));
            assert_eq!(with.len(), 15);
            for (a, b) in with.iter().zip(&without) {
                assert!((a - b).abs() < 1e-9 * (1.0 + b.abs()), "{load} release {release}: {with:?} {without:?}");
            }
        }
    }
}

/// A stick of ten storeys with stiff arms, in space or in the plane. Rigid motion of an arm causes forces of round-off
/// only, which are in equilibrium. The correction therefore falls to the round-off of the displacements.
fn stick(ndm: usize, transf: &str, ratio: &str, compat: bool) -> Vec<f64> {
    let model = match ndm {
        3 => {
            "proc at {i x y z} { node $i $x $y $z }
            proc beam {i a b r t} { element elasticBeamColumn $i $a $b [expr {0.5*$r}] 3e7 1.2e7 [expr {0.03*$r}] \
                [expr {0.02*$r}] [expr {0.025*$r}] $t }
            proc loads {i x y z} { load $i $x $y $z 0 0 0 }
            fix 0 1 1 1 1 1 1"
        }
        _ => {
            "proc at {i x y z} { node $i $x $z }
            proc beam {i a b r t} { element elasticBeamColumn $i $a $b [expr {0.5*$r}] 3e7 [expr {0.02*$r}] $t }
            proc loads {i x y z} { load $i $x $z 0 }
            fix 0 1 1 1"
        }
    };
    let (model, fix) = model.rsplit_once('\n').unwrap();
    let (ndf, up, across) = if ndm == 3 { (6, "0 1 0", "0 0 1") } else { (3, "", "") };
    let mut script = if compat { Script::compat() } else { Script::default() };
    script.options.dense = Some(false);
    let text = format!(
        "model basic -ndm {ndm} -ndf {ndf}
        {model}
        geomTransf {transf} 1 {up}; geomTransf {transf} 2 {across}
        at 0 0.0 0.0 0.0; {fix}
        timeSeries Linear 1; pattern Plain 1 1 {{ }}
        for {{set i 1}} {{$i <= 10}} {{incr i}} {{
            at $i 0.0 0.0 [expr {{3.1*$i}}]
            beam $i [expr {{$i-1}}] $i 1.0 1
            foreach {{k dx dy}} {{100 4.3 2.1 200 -3.7 1.3}} {{
                at [expr {{$k+$i}}] $dx $dy [expr {{3.1*$i}}]
                beam [expr {{$k+$i}}] $i [expr {{$k+$i}}] {ratio} 2
            }}
        }}
        pattern Plain 2 1 {{
            for {{set i 1}} {{$i <= 10}} {{incr i}} {{
                loads $i [expr {{0.2*$i}}] [expr {{0.07*$i}}] -9.0
                loads [expr {{100+$i}}] 0.03 -0.02 -1.5
                loads [expr {{200+$i}}] 0.0 0.01 -1.7
            }}
        }}
        constraints Transformation; numberer RCM; system UmfPack; algorithm Newton; integrator LoadControl 1.0
        test NormDispIncr 1e-30 12; analysis Static
        analyze 1
        puts [testNorms]"
    );
    script.run(&text).numbers()
}

#[test]
fn stiff_arms_do_not_load_the_structure_by_round_off() {
    for (ndm, compat) in [(3, false), (3, true), (2, false), (2, true)] {
        for (ratio, pdelta) in [("1e3", 1e-10), ("1e5", 1e-8), ("1e7", 1e-6)] {
            // With P-Delta the round-off of the axial forces of the arms is not in equilibrium where they have turned.
            for (transf, limit) in [("Linear", 1e-13), ("PDelta", pdelta)] {
                let norms = stick(ndm, transf, ratio, compat);
                let least = norms.iter().copied().fold(f64::INFINITY, f64::min);
                assert!(norms.len() > 3 && least < limit, "{ndm}D {transf} {ratio} {compat}: {norms:?}");
            }
        }
    }
}

/// Loads stay as an analysis has applied them, although the time is set back before they are made constant.
#[test]
fn loads_are_held_as_they_were_applied() {
    let push = |hold: &str| {
        run(&format!(
            "model basic -ndm 1 -ndf 1
            node 1 0; node 2 1; fix 1 1
            uniaxialMaterial Elastic 1 100.
            element truss 1 1 2 1. 1
            timeSeries Linear 1
            pattern Plain 1 1 {{ load 2 5. }}
            constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 5; algorithm Newton
            integrator LoadControl 0.5; analysis Static
            analyze 2
            {hold}
            pattern Plain 2 1 {{ load 2 2. }}
            analyze 1
            puts [nodeDisp 2 1]; puts [getTime]"
        ))
        .numbers()
    };
    for hold in ["loadConst -time 0.0", "setTime 0.0; loadConst", "setTime 2.0; setTime 0.0; loadConst"] {
        let n = push(hold);
        assert!(close(n[0], 0.06, 1e-12) && n[1] == 0.5, "{hold}: {n:?}");
    }
}
