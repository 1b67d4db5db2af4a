//! Motion in time.

use super::close;
use super::script::{Script, run};

/// A mass on a spring and a dashpot, let go from a displacement of 1: m = 1, k = ω², damping ratio ζ.
pub(crate) fn free_vibration(integrator: &str, dt: f64, omega: f64, zeta: f64) -> f64 {
    with_algorithm(integrator, "Newton", dt, omega, zeta)
}

pub(crate) fn with_algorithm(integrator: &str, algorithm: &str, dt: f64, omega: f64, zeta: f64) -> f64 {
    with_test(integrator, algorithm, "NormUnbalance 1e-12 20", dt, omega, zeta)
}

pub(crate) fn with_test(integrator: &str, algorithm: &str, test: &str, dt: f64, omega: f64, zeta: f64) -> f64 {
    let text = format!(
        "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0 -mass 1.0 -disp 1.0
        fix 1 1
        uniaxialMaterial Elastic 1 {k}
        uniaxialMaterial Viscous 2 {c} 1.0
        element zeroLength 1 1 2 -mat 1 2 -dir 1 1
        setNodeAccel 2 1 {a0}
        constraints Plain; numberer Plain; system BandGeneral; test {test}; algorithm {algorithm}
        integrator {integrator}
        analysis Transient
        analyze {n} {dt}
        puts [nodeDisp 2 1]",
        k = omega * omega,
        c = 2.0 * zeta * omega,
        a0 = -omega * omega,
        n = (1.0 / dt).round(),
    );
    // The springs measure from the displacement that they are made at, so it is set after them.
    let text = text.replace(" -disp 1.0", "").replace("setNodeAccel", "setNodeDisp 2 1 1.0\nsetNodeAccel");
    run(&text).numbers()[0]
}

pub(crate) fn exact(t: f64, omega: f64, zeta: f64) -> f64 {
    let damped = omega * (1.0 - zeta * zeta).sqrt();
    (-zeta * omega * t).exp() * ((damped * t).cos() + zeta * omega / damped * (damped * t).sin())
}

#[test]
fn integrators_have_their_order() {
    for (integrator, order) in [
        ("Newmark 0.5 0.25", 2.0),
        ("Newmark 0.5 0.25 -form V", 2.0),
        ("Newmark 0.5 0.25 -form A", 2.0),
        ("Newmark 0.5 0.166666666666666", 2.0),
        ("Newmark 0.6 0.3025", 1.0),
        ("HHT 0.9", 2.0),
        ("HHT 1.0", 2.0),
        ("GeneralizedAlpha 1.1 0.8", 2.0),
        ("HHTGeneralized 0.6", 2.0),
        ("Collocation 1.1", 2.0),
        ("Collocation 1.2 0.2 0.5", 2.0),
        ("WilsonTheta 1.4", 2.0),
        ("TRBDF2", 2.0),
        ("TRBDF3", 1.0),
        ("Houbolt", 2.0),
        ("ParkLMS3", 2.0),
        ("BackwardEuler", 2.0),
    ] {
        for zeta in [0.0, 0.05] {
            let error = |dt: f64| (free_vibration(integrator, dt, 9.0, zeta) - exact(1.0, 9.0, zeta)).abs();
            let found = (error(0.005) / error(0.0025)).log2();
            assert!((found - order).abs() < 0.15, "{integrator}, damping {zeta}: order {found}");
        }
    }
}

#[test]
fn explicit_integrators_have_their_order() {
    for integrator in [
        "CentralDifference",
        "NewmarkExplicit 0.5",
        "HHTExplicit 0.9 0.6",
        "HHTGeneralizedExplicit 0.8 0.6",
        "AlphaOS 1.0",
        "AlphaOS 0.8",
        "AlphaOSGeneralized 0.5",
    ] {
        let error = |dt: f64| {
            let found = with_algorithm(integrator, "Linear", dt, 9.0, 0.0);
            (found - exact(1.0, 9.0, 0.0)).abs()
        };
        let order = (error(0.005) / error(0.0025)).log2();
        assert!((order - 2.0).abs() < 0.2, "{integrator}: order {order}");
    }
}

/// The velocity of this method lags by half a step. A motion that starts with an acceleration starts late by that:
/// the method is of first order for it, of second order from rest.
#[test]
fn explicit_method_of_kolay_and_ricles_has_its_order() {
    let from_displacement = |dt: f64| {
        let found = with_algorithm("KRAlphaExplicit 1.0", "Linear", dt, 9.0, 0.0);
        (found - exact(1.0, 9.0, 0.0)).abs()
    };
    // u'' + ω² u = t², from rest: u = (t² - 2 (1 - cos ωt)/ω²)/ω².
    let from_rest = |dt: f64| {
        let text = format!(
            "model basic -ndm 1 -ndf 1; node 1 0; node 2 0 -mass 1.0; fix 1 1
            uniaxialMaterial Elastic 1 81.0
            element zeroLength 1 1 2 -mat 1 -dir 1
            timeSeries Path 1 -dt 1e-3 -values {{{values}}}
            pattern Plain 1 1 {{ load 2 1.0 }}
            constraints Plain; numberer Plain; system FullGeneral; algorithm Linear
            integrator KRAlphaExplicit 1.0; analysis Transient
            analyze {n} {dt}
            puts [nodeDisp 2 1]",
            values = (0..1100).map(|i| (1e-3 * f64::from(i)).powi(2).to_string()).collect::<Vec<_>>().join(" "),
            n = (1.0 / dt).round(),
        );
        let exact = (1.0 - 2.0 * (1.0 - 9.0f64.cos()) / 81.0) / 81.0;
        (run(&text).numbers()[0] - exact).abs()
    };
    let (first, second) = (from_displacement(0.005) / from_displacement(0.0025), from_rest(0.02) / from_rest(0.01));
    assert!((first.log2() - 1.0).abs() < 0.2, "order {}", first.log2());
    assert!((second.log2() - 2.0).abs() < 0.25, "order {}", second.log2());
}

/// A fixed number of iterations, each a part of the way, ends at the same order; the place on the way is a polynomial's.
#[test]
fn fixed_iterations_have_their_order() {
    for integrator in [
        "NewmarkHSFixedNumIter 0.5 0.25",
        "NewmarkHSFixedNumIter 0.5 0.25 -polyOrder 1",
        "HHTHSFixedNumIter 0.6 -polyOrder 3",
        "CollocationHSFixedNumIter 1.1",
    ] {
        let error = |dt: f64| {
            let found = with_test(integrator, "Newton", "FixedNumIter 4", dt, 9.0, 0.05);
            (found - exact(1.0, 9.0, 0.05)).abs()
        };
        let order = (error(0.005) / error(0.0025)).log2();
        assert!((order - 2.0).abs() < 0.2, "{integrator}: order {order}");
    }
}

/// An algorithm that iterates makes no sense with an explicit method, and says so.
#[test]
fn explicit_integrators_want_one_correction() {
    let ran = Script::default().run(
        "model basic -ndm 1 -ndf 1; node 1 0; node 2 0 -mass 1.0; fix 1 1
        uniaxialMaterial ElasticPP 1 1000.0 0.01
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Constant 1; pattern Plain 1 1 { load 2 30.0 }
        constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-12 20; algorithm Newton
        integrator CentralDifference
        analysis Transient
        puts [analyze 1 0.001]",
    );
    assert_eq!(ran.numbers(), [-3.0]);
    assert!(ran.warnings()[0].message.contains("algorithm Linear"), "{:?}", ran.warnings());
}

#[test]
fn forms_of_newmark_are_the_same_method() {
    let d = free_vibration("Newmark 0.5 0.25", 0.02, 12.0, 0.02);
    for form in ["V", "A"] {
        let other = free_vibration(&format!("Newmark 0.5 0.25 -form {form}"), 0.02, 12.0, 0.02);
        assert!(close(d, other, 1e-9), "{form}: {other} and {d}");
    }
}

/// Constant acceleration keeps the energy of a linear oscillator to round-off over many periods.
#[test]
fn average_acceleration_keeps_the_energy() {
    let ran = run("model basic -ndm 1 -ndf 1
        node 1 0; node 2 0 -mass 2.0
        fix 1 1
        uniaxialMaterial Elastic 1 50.0
        element zeroLength 1 1 2 -mat 1 -dir 1
        setNodeDisp 2 1 0.3; setNodeAccel 2 1 -7.5
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-13 20; algorithm Newton
        integrator Newmark 0.5 0.25
        analysis Transient
        for {set i 0} {$i < 50} {incr i} {
            analyze 100 0.03
            puts [expr {25.0*[nodeDisp 2 1]**2 + [nodeVel 2 1]**2}]
        }");
    for energy in ran.numbers() {
        assert!(close(energy, 25.0 * 0.09, 1e-9), "{energy}");
    }
}

/// Resonance of a damped oscillator under a harmonic ground acceleration: amplitude a / (2 ζ ω²) (Chopra, eq. 3.2.15).
#[test]
fn ground_motion_at_resonance() {
    let ran = run("model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 0 0 -mass 4.0 4.0 0.0
        fix 1 1 1 1; fix 2 0 1 1
        set w 6.0
        uniaxialMaterial Elastic 1 [expr {4.0*$w**2}]
        element zeroLength 1 1 2 -mat 1 -dir 1 -doRayleigh 1
        rayleigh [expr {2*0.05*$w}] 0.0 0.0 0.0
        timeSeries Trig 1 0.0 1000.0 [expr {2*acos(-1)/$w}] -factor 1.5
        pattern UniformExcitation 1 1 -accel 1
        recorder EnvelopeNode -file d.out -node 2 -dof 1 disp
        recorder EnvelopeNode -file a.out -timeSeries 1 -node 2 -dof 1 accel
        constraints Transformation; numberer Plain; system BandGeneral; test NormUnbalance 1e-12 20; algorithm Newton
        integrator Newmark 0.5 0.25
        analysis Transient
        analyze 10000 0.005");
    let peak = ran.tables["d.out"][2][0];
    assert!(close(peak, 1.5 / (2.0 * 0.05 * 36.0), 2e-3), "{peak}");
    // Absolute acceleration: the spring's and, a quarter of a period later, the dashpot's share.
    let accel = ran.tables["a.out"][2][0];
    assert!(close(accel, 15.0 * (1.0f64 + 0.01).sqrt(), 3e-3), "{accel}");
}

/// The four parts of Rayleigh damping of an elastic spring are all the same; mass-proportional is the node's.
#[test]
fn parts_of_rayleigh_damping_agree_on_an_elastic_spring() {
    let decay = |rayleigh: &str| {
        run(&format!(
            "model basic -ndm 1 -ndf 1
            node 1 0; node 2 0 -mass 1.0
            fix 1 1
            uniaxialMaterial Steel01 1 1e9 100.0 0.1
            element zeroLength 1 1 2 -mat 1 -dir 1 -doRayleigh 1
            rayleigh {rayleigh}
            setNodeDisp 2 1 1.0; setNodeAccel 2 1 -100.0
            constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-12 20; algorithm Newton
            integrator Newmark 0.5 0.25
            analysis Transient
            analyze 400 0.005
            puts [nodeDisp 2 1]"
        ))
        .numbers()[0]
    };
    // ζ = 2 % at ω = 10: 2 ζ ω, or 2 ζ / ω.
    let reference = decay("0.0 0.004 0.0 0.0");
    for other in ["0.4 0.0 0.0 0.0", "0.0 0.0 0.004 0.0", "0.0 0.0 0.0 0.004", "0.1 0.001 0.001 0.001"] {
        assert!(close(reference, decay(other), 1e-3), "{other}: {} and {reference}", decay(other));
    }
    assert!(close(reference, exact(2.0, 10.0, 0.02), 2e-2));
}

/// A step that fails leaves the committed state, and returns OpenSees' code; a smaller step then goes through.
#[test]
fn a_failed_step_leaves_the_committed_state() {
    let ran = run("model basic -ndm 1 -ndf 1
        node 1 0; node 2 0 -mass 1.0
        fix 1 1
        uniaxialMaterial ElasticPP 1 1000.0 0.01
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Constant 1
        pattern Plain 1 1 { load 2 30.0 }
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-12 1; algorithm Newton
        integrator Newmark 0.5 0.25
        analysis Transient
        analyze 1 0.001
        set before [list [nodeDisp 2 1] [nodeVel 2 1] [getTime] [eleResponse 1 material 1 stress]]
        puts [analyze 1 10.0]
        set after [list [nodeDisp 2 1] [nodeVel 2 1] [getTime] [eleResponse 1 material 1 stress]]
        puts [expr {$before eq $after}]
        test NormUnbalance 1e-9 50
        puts [analyze 5 0.01]");
    assert_eq!(ran.numbers(), [-3.0, 1.0, 0.0]);
}

#[test]
fn recovery_solves_a_step_that_fails() {
    let text = "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0 -mass 1.0
        fix 1 1
        uniaxialMaterial ElasticPP 1 1000.0 0.01
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Constant 1
        pattern Plain 1 1 { load 2 30.0 }
        LADDER
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-10 2; algorithm ModifiedNewton -initial
        integrator Newmark 0.5 0.25
        analysis Transient
        puts [analyze 20 0.02]";
    let without = Script::default().run(&text.replace("LADDER", ""));
    assert_eq!(without.numbers(), [-3.0]);
    assert_eq!(without.end.status(), 1, "an analysis that nobody rescued has failed");
    assert_eq!(run(&text.replace("LADDER", "ladder on")).numbers(), [0.0]);
}

/// `-dT` records at the steps that are nearest after each multiple, whatever the round-off of the time.
#[test]
fn recorders_keep_their_step() {
    let ran = run("model basic -ndm 1 -ndf 1
        node 1 0; node 2 0 -mass 1.0
        fix 1 1
        uniaxialMaterial Elastic 1 10.0
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Trig 1 0 100 1.3
        pattern UniformExcitation 1 1 -accel 1
        recorder Node -file all.out -time -node 2 -dof 1 disp
        recorder Node -file some.out -time -dT 0.1 -node 2 -dof 1 disp
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-10 20; algorithm Linear
        integrator Newmark 0.5 0.25
        analysis Transient
        analyze 1000 0.01");
    let (all, some) = (&ran.tables["all.out"], &ran.tables["some.out"]);
    assert_eq!(all.len(), 1000);
    assert_eq!(some.len(), 100);
    for (i, row) in some.iter().enumerate() {
        assert_eq!(row, &all[10 * i], "row {i}");
    }
}

/// Tip displacement of a cantilever that carries its mass itself or at its tip, under a ground acceleration.
fn shaken_cantilever(script: Script, element: &str, tip: &str) -> f64 {
    let text = format!(
        "model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 0 2; fix 1 1 1 1; {tip}
        geomTransf Linear 1
        element elasticBeamColumn 1 1 2 0.01 2e8 1e-5 1 {element}
        timeSeries Path 1 -dt 0.1 -values {{0 1 -2 1 0}} -factor 3.0
        pattern UniformExcitation 1 1 -accel 1
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-10 20; algorithm Newton
        integrator Newmark 0.5 0.25
        analysis Transient
        analyze 40 0.01
        puts [nodeDisp 2 1]"
    );
    script.run(&text).done().numbers()[0]
}

#[test]
fn the_ground_moves_the_mass_of_elements_once() {
    let nodal = shaken_cantilever(Script::default(), "", "mass 2 3.0 3.0 0.0");
    assert!(nodal.abs() > 1e-6);
    assert!(close(shaken_cantilever(Script::default(), "-mass 3.0", ""), nodal, 1e-9));
    // OpenSees counts it twice in the plane.
    assert!(close(shaken_cantilever(Script::compat(), "-mass 3.0", ""), 2.0 * nodal, 1e-9));
}

#[test]
fn every_handler_imposes_the_same_motion() {
    let motion = |handler: &str| {
        let text = format!(
            "model basic -ndm 1 -ndf 1
            node 1 0; node 2 0; node 3 0 -mass 1.0; fix 1 1
            uniaxialMaterial Elastic 1 40.0
            element zeroLength 1 1 2 -mat 1 -dir 1
            element zeroLength 2 2 3 -mat 1 -dir 1
            timeSeries Path 1 -dt 0.02 -values {{0 1 -2 3 -1 2 0}} -factor 0.01
            pattern Plain 1 1 {{ sp 2 1 1.0 }}
            constraints {handler}; numberer Plain; system FullGeneral; test NormUnbalance 1e-8 20; algorithm Newton
            integrator Newmark 0.5 0.25
            analysis Transient
            analyze 9 0.01
            puts [nodeDisp 3 1]; puts [nodeVel 3 1]"
        );
        run(&text).numbers()
    };
    let reference = motion("Transformation");
    for handler in ["Lagrange", "Penalty 1e9 1e9"] {
        for (a, b) in motion(handler).iter().zip(&reference) {
            assert!(close(*a, *b, 1e-6));
        }
    }
}

#[test]
fn an_initial_velocity_leaves_supports_at_rest() {
    let ran = run("model basic -ndm 1 -ndf 1
        node 1 0; node 2 0 -mass 1.0; fix 1 1
        timeSeries Constant 1
        pattern UniformExcitation 1 1 -accel 1 -vel0 0.3
        puts [nodeVel 1 1]; puts [nodeVel 2 1]");
    assert_eq!(ran.numbers(), [0.0, 0.3]);
}

/// Modal damping gives each mode its own ratio: a building let go in one of its modes decays as a single mass does.
#[test]
fn modal_damping_damps_each_mode_by_its_ratio() {
    for (mode, sign) in [(1, 1.0), (2, -1.0)] {
        for command in ["modalDamping", "modalDampingQ"] {
            let ran = run(&format!(
                "model basic -ndm 1 -ndf 1
                foreach n {{1 2 3 4}} {{ node $n 0 }}
                mass 2 2.0; mass 3 2.0; fix 1 1; fix 4 1
                uniaxialMaterial Elastic 1 200.0
                foreach n {{1 2 3}} {{ element zeroLength $n $n [expr {{$n+1}}] -mat 1 -dir 1 }}
                constraints Plain; numberer Plain; system FullGeneral; test NormUnbalance 1e-12 20; algorithm Newton
                integrator Newmark 0.5 0.25
                set w2 [lindex [eigen -fullGenLapack 2] [expr {{{mode}-1}}]]
                {command} 0.02 0.05
                setNodeDisp 2 1 1.0; setNodeDisp 3 1 {sign}
                setNodeAccel 2 1 [expr {{-$w2}}]; setNodeAccel 3 1 [expr {{-({sign})*$w2}}]
                analysis Transient
                analyze 1000 0.001
                puts \"[nodeDisp 2 1] [expr {{sqrt($w2)}}]\""
            ));
            let [found, omega] = ran.numbers()[..] else { panic!("{}", ran.out) };
            let zeta = [0.02, 0.05][mode - 1];
            assert!((found - exact(1.0, omega, zeta)).abs() < 1e-3, "{command}, mode {mode}: {found}");
        }
    }
}

/// Steps of a variable analysis go on to the end of the time, within their limits.
#[test]
fn variable_steps_reach_the_end() {
    let ran = run("model basic -ndm 1 -ndf 1
        node 1 0; node 2 0 -mass 12.0; fix 1 1
        uniaxialMaterial Steel01 1 35.0 1500.0 0.05
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Trig 1 0.0 100.0 0.7 -factor 6.0
        pattern UniformExcitation 1 1 -accel 1
        recorder Node -file d.out -time -node 2 -dof 1 disp
        constraints Plain; numberer Plain; system FullGeneral; test NormDispIncr 1e-12 10; algorithm Newton
        integrator Newmark 0.5 0.25
        analysis VariableTransient
        puts [analyze 200 0.01 0.001 0.02 3]
        puts [nodeDisp 2 1]");
    assert_eq!(ran.numbers()[0], 0.0);
    // OpenSees 3.7.1.
    assert!(close(ran.numbers()[1], -0.030803212328472572, 1e-9), "{}", ran.out);
    let times: Vec<f64> = ran.tables["d.out"].iter().map(|r| r[0]).collect();
    assert!(times.windows(2).all(|t| (0.000999..0.020001).contains(&(t[1] - t[0]))));
    assert!(times.last().is_some_and(|t| (2.0..2.02).contains(t)));
}

/// The end of a motion depends on the rounding of the time: under `--compat` as in OpenSees, whose numbers these are.
#[test]
fn time_rounds_as_in_opensees() {
    for (integrator, algorithm, clock) in [
        ("Newmark 0.5 0.25", "Newton", 11.979999999999833),
        ("HHT 0.9", "Newton", 11.980000000000143),
        ("GeneralizedAlpha 1.0 0.9", "Newton", 11.980000000000143),
        ("Collocation 1.4", "Newton", 11.980000000000185),
        ("AlphaOS 0.9", "Linear", 11.980000000000143),
        ("KRAlphaExplicit 0.5", "Linear", 11.98000000000001),
    ] {
        let text = format!(
            "model basic -ndm 1 -ndf 1
            node 1 0; node 2 0 -mass 1.0; fix 1 1
            uniaxialMaterial Elastic 1 100.0
            element zeroLength 1 1 2 -mat 1 -dir 1
            constraints Plain; numberer Plain; system FullGeneral; test NormDispIncr 1e-10 10; algorithm {algorithm}
            integrator {integrator}
            analysis Transient
            analyze 599 0.02
            puts [getTime]"
        );
        assert_eq!(Script::compat().run(&text).done().numbers()[0], clock, "{integrator}");
        assert!(close(run(&text).numbers()[0], 11.98, 1e-12), "{integrator}");
    }
}

/// Rayleigh damping of single elements and nodes, with the displacements of openseespy 3.7.1: of an element its stiffness, of a
/// node its mass.
#[test]
fn rayleigh_damping_of_elements_and_nodes() {
    for (choice, expected) in
        [("", [0.017011, 0.032597]), ("-ele 1", [0.018739, 0.035999]), ("-node 2", [0.018984, 0.036683])]
    {
        let script = format!(
            "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; node 3 0; fix 1 1; mass 2 2.; mass 3 3.
            uniaxialMaterial Elastic 1 100.
            element zeroLength 1 1 2 -mat 1 -dir 1 -doRayleigh 1; element zeroLength 2 2 3 -mat 1 -dir 1 -doRayleigh 1
            rayleigh 0.5 0.02 0 0 {choice}
            timeSeries Constant 1; pattern Plain 1 1 {{ load 3 1. }}
            constraints Plain; numberer Plain; system FullGeneral; algorithm Linear
            integrator Newmark 0.5 0.25; analysis Transient; analyze 20 0.05; puts \"[nodeDisp 2 1] [nodeDisp 3 1]\""
        );
        let numbers = run(&script).numbers();
        assert!(numbers.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6), "{choice}: {numbers:?}");
    }
}

/// Force-based beams have lumped masses: `-cMass` is no option of theirs, in OpenSees neither.
#[test]
fn consistent_masses_are_those_of_beams_by_displacements() {
    let first = |kind: &str, options: &str| {
        let script = format!(
            "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 3; fix 1 1 1 1; geomTransf Linear 1
            section Elastic 1 2e8 0.04 1.3e-4; beamIntegration Lobatto 1 1 4
            element {kind} 1 1 2 1 1 -mass 0.3 {options}
            puts [eigen -fullGenLapack 1]"
        );
        run(&script).numbers()[0]
    };
    for kind in ["forceBeamColumn", "mixedBeamColumn"] {
        assert_eq!(first(kind, "-cMass"), first(kind, ""), "{kind}");
    }
    assert!(first("dispBeamColumn", "-cMass") > 1.5 * first("dispBeamColumn", ""));
}
