//! Velocities and accelerations of motions that are imposed.

use super::close;
use super::script::{Script, run};
use hysteron::opensees::Mode;
use std::f64::consts::TAU;

const HANDLERS: [&str; 4] = ["Plain", "Transformation", "Penalty 1e10 1e10", "Lagrange"];
const TRANSIENT: &str = "integrator Newmark 0.5 0.25; analysis Transient; analyze 1000 0.001";
const STATIC: &str = "integrator LoadControl 0.001; analysis Static; analyze 1000";

/// Node 2 moves by u = 0.1 sin 2πt and takes node 3 with it; a dashpot, or another device, resists it.
fn moved(device: &str, handler: &str, analysis: &str) -> String {
    format!(
        "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; node 3 0; fix 1 1; mass 2 1e-3; mass 3 1e-3
        equalDOF 2 3 1
        uniaxialMaterial {device}
        element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 1 3 -mat 1 -dir 1
        timeSeries Trig 1 0 100 1.0 -factor 0.1
        pattern Plain 1 1 {{ sp 2 1 1.0 }}
        constraints {handler}; numberer Plain; system FullGeneral; test NormDispIncr 1e-10 20; algorithm Newton
        {analysis}
        puts \"[nodeVel 2 1] [nodeVel 3 1] [nodeAccel 2 1] [lindex [eleResponse 1 force] end] [lindex [eleResponse 2 force] end]\""
    )
}

#[test]
fn an_sp_node_has_the_velocity_of_its_series() {
    for handler in HANDLERS {
        for analysis in [TRANSIENT, STATIC] {
            for device in ["Viscous 1 2.0 1.0", "Elastic 1 1e-9 2.0", "ViscousDamper 1 1e6 2.0 1.0"] {
                let script = moved(device, handler, analysis);
                let numbers = run(&script).numbers();
                let [v2, v3, a2, f1, f2] = numbers[..] else { panic!("{numbers:?}") };
                let speed = 0.1 * TAU;
                assert!(close(v2, speed, 1e-6) && close(v3, speed, 1e-6), "{handler} {analysis} {device}: {v2} {v3}");
                assert!(a2.abs() < 1e-5, "{handler} {analysis}: {a2}");
                assert!(
                    close(f1, 2.0 * speed, 5e-3) && close(f2, f1, 1e-6),
                    "{handler} {analysis} {device}: {f1} {f2}"
                );
            }
        }
    }
    let numbers = Script::compat().run(&moved("Viscous 1 2.0 1.0", "Transformation", TRANSIENT)).done().numbers();
    assert_eq!(numbers, [0.0; 5]);
}

/// A quarter of a period later the node is at its largest displacement: the acceleration is -ω² u.
#[test]
fn an_sp_node_has_the_acceleration_of_its_series() {
    for handler in HANDLERS {
        let numbers = run(&moved("Viscous 1 2.0 1.0", handler, &TRANSIENT.replace("1000", "1250"))).numbers();
        assert!(numbers[0].abs() < 1e-5 && close(numbers[2], -0.1 * TAU * TAU, 1e-6), "{handler}: {numbers:?}");
    }
}

/// Friction that rises from 0.03 to 0.10 with the speed, by `sp` and by `imposedMotion`.
#[test]
fn friction_sees_the_speed() {
    for element in ["flatSliderBearing 1 1 2 1 1e6", "singleFPBearing 1 1 2 1 1e6 1e6"] {
        for (how, analysis) in [
            ("pattern Plain 2 2 { sp 2 1 1.0 }", TRANSIENT),
            ("pattern Plain 2 2 { sp 2 1 1.0 }", STATIC),
            ("pattern MultipleSupport 2 { groundMotion 1 Plain -disp 2; imposedMotion 2 1 1 }", TRANSIENT),
        ] {
            let numbers = run(&format!(
                "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 0; fix 1 1 1 1; fix 2 0 0 1; mass 2 1. 1. 1.
                uniaxialMaterial Elastic 1 1e7; uniaxialMaterial Elastic 2 1.
                frictionModel VelDependent 1 0.03 0.10 25.
                element {element} -P 1 -Mz 2 -orient 0 1 0 -1 0 0
                timeSeries Constant 1; pattern Plain 1 1 {{ load 2 0 -1000 0 }}
                constraints Transformation; numberer Plain; system FullGeneral; test NormDispIncr 1e-9 50; algorithm Newton
                integrator LoadControl 1.; analysis Static; analyze 1; loadConst -time 0; wipeAnalysis
                timeSeries Trig 2 0 100 1.0 -factor 0.05
                {how}
                constraints Transformation; numberer Plain; system FullGeneral; test NormDispIncr 1e-9 50; algorithm Newton
                {analysis}
                puts [lindex [eleResponse 1 force] 3]"
            ))
            .numbers();
            assert!(close(numbers[0].abs(), 100.0, 2e-3), "{element} {how} {analysis}: {numbers:?}");
        }
    }
}

/// The velocity of points: the slope of a piece, and the mean of both slopes at a point between.
#[test]
fn velocity_of_a_path() {
    let numbers = run("model basic -ndm 1 -ndf 1; node 1 0; node 2 0; node 3 0; fix 1 1
        uniaxialMaterial Elastic 1 1.0
        element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 1 3 -mat 1 -dir 1
        timeSeries Path 1 -dt 1 -values {0 2 -1 -1}
        timeSeries Path 2 -time {0 1 3} -values {0 2 -1} -useLast
        pattern Plain 1 1 { sp 2 1 0.5 }; pattern Plain 2 2 { sp 3 1 1.0 }
        constraints Transformation; numberer Plain; system FullGeneral; test NormDispIncr 1e-9 9; algorithm Newton
        integrator LoadControl 0.25; analysis Static
        foreach n {2 2 2 7} { analyze $n; puts \"[nodeVel 2 1] [nodeVel 3 1]\" }")
    .numbers();
    let expected = [1.0, 2.0, -0.25, 0.25, -1.5, -1.5, 0.0, 0.0];
    assert!(numbers.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{numbers:?}");
}

/// A structure that is pulled and let go starts at rest, however fast the pull was.
#[test]
fn a_release_starts_at_rest() {
    for between in ["", "wipeAnalysis;", "setTime 0;"] {
        let numbers = run(&format!(
            "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1; mass 2 1
            uniaxialMaterial Elastic 1 100.0; element zeroLength 1 1 2 -mat 1 -dir 1
            timeSeries Linear 1; pattern Plain 1 1 {{ sp 2 1 5.0 }}
            constraints Transformation; numberer Plain; system FullGeneral; algorithm Linear
            integrator LoadControl 0.01; analysis Static; analyze 10; puts [nodeVel 2 1]
            {between} remove loadPattern 1; wipeAnalysis
            constraints Transformation; numberer Plain; system FullGeneral; algorithm Linear
            integrator Newmark 0.5 0.25; analysis Transient; analyze 1 0.001; puts \"[nodeDisp 2 1] [nodeVel 2 1]\""
        ))
        .numbers();
        assert!(close(numbers[0], 5.0, 1e-12), "{numbers:?}");
        // One step of the average acceleration, from rest and without acceleration.
        let (dt, before) = (0.001, 0.5);
        let after = before / (1.0 + 0.25 * 100.0 * dt * dt);
        assert!(close(numbers[1], after, 1e-9) && close(numbers[2], 2.0 * (after - before) / dt, 1e-6), "{numbers:?}");
    }
}

fn ground(series: &str, how: &str) -> String {
    format!(
        "model basic -ndm 1 -ndf 1; node 1 0; node 2 1; mass 2 1; fix 1 1
        uniaxialMaterial Elastic 1 400.0; element truss 1 1 2 1 1
        timeSeries {series}
        pattern MultipleSupport 1 {{ groundMotion 1 Plain {how} 1; imposedMotion 1 1 1 }}
        constraints Transformation; numberer Plain; system BandGeneral; algorithm Linear
        integrator Newmark 0.5 0.25; analysis Transient
        analyze 150 0.01; puts \"[nodeDisp 1 1] [nodeVel 1 1] [nodeAccel 1 1]\""
    )
}

/// Displacement, velocity and acceleration of a support at 1.5 s.
#[test]
fn series_without_an_end() {
    for (series, how, expected) in [
        ("Constant 1 -factor 0.2", "-vel", [0.3, 0.2, 0.0]),
        ("Constant 1 -factor 0.2", "-accel", [0.225, 0.3, 0.2]),
        ("Constant 1 -factor 0.2", "-disp", [0.2, 0.0, 0.0]),
        ("Linear 1 -factor 0.2", "-disp", [0.3, 0.2, 0.0]),
        ("Linear 1 -factor 0.2", "-vel", [0.225, 0.3, 0.2]),
        ("Linear 1 -factor 0.2", "-accel", [0.1125, 0.225, 0.3]),
        // Those that do not start at zero, and that go on with their last value.
        ("Path 1 -dt 0.5 -values {0.2 0.2 0.2 0.2 0.2}", "-accel", [0.225, 0.3, 0.2]),
        ("Path 1 -dt 0.005 -values {0.2 0.2} -useLast", "-vel", [0.3, 0.2, 0.0]),
        ("Path 1 -dt 0.5 -values {0.2 0.2} -useLast", "-accel", [0.225, 0.3, 0.2]),
    ] {
        let numbers = run(&ground(series, how)).numbers();
        let near = numbers.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-4);
        assert!(near, "{series} {how}: {numbers:?}, expected {expected:?}");
    }
}

/// As openseespy 3.7.1 has it.
#[test]
fn integrals_of_opensees() {
    for (series, how, expected) in
        [("Constant 1 -factor 0.2", "-vel", [0.0, 0.2, 0.0]), ("Linear 1 -factor 0.2", "-accel", [0.0, 0.0, 0.3])]
    {
        let numbers = Script::compat().run(&ground(series, how)).done().numbers();
        assert!(numbers.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{series} {how}: {numbers:?}");
    }
}

fn shaken(series: &str, how: &str) -> String {
    format!(
        "model basic -ndm 1 -ndf 1; node 1 0; node 2 1; mass 2 1; fix 1 1
        uniaxialMaterial Elastic 1 400.0; element truss 1 1 2 1 1
        timeSeries {series}; pattern UniformExcitation 1 1 {how} 1
        constraints Transformation; numberer Plain; system BandGeneral; algorithm Linear
        integrator Newmark 0.5 0.25; analysis Transient; analyze 150 0.01; puts \"[nodeDisp 2 1] [nodeVel 2 1]\""
    )
}

/// The velocity sin 2πt is the acceleration 2π cos 2πt.
#[test]
fn a_uniform_excitation_by_velocity() {
    let cosine = |factor: f64| format!("Trig 1 0 100 1.0 -shift 1.5707963267948966 -factor {factor}");
    let sine = |factor: f64| format!("Trig 1 0 100 1.0 -factor {factor}");
    let points: Vec<String> = (0..=200).map(|i| (0.01 * TAU * f64::from(i)).sin().to_string()).collect();
    let points = format!("Path 1 -dt 0.01 -values {{{}}}", points.join(" "));
    for (series, how, acceleration, tolerance) in [
        (sine(1.0), "-vel", cosine(TAU), 1e-9),
        (points, "-vel", cosine(TAU), 3e-2),
        (sine(1.0), "-disp", sine(-TAU * TAU), 1e-9),
    ] {
        let numbers = run(&shaken(&series, how)).numbers();
        let expected = run(&shaken(&acceleration, "-accel")).numbers();
        for (a, b) in numbers.iter().zip(&expected) {
            assert!((a - b).abs() <= tolerance * expected[1].abs(), "{how}: {numbers:?}, expected {expected:?}");
        }
    }
    let compat = Script::compat().run(&shaken(&sine(1.0), "-vel")).done().numbers();
    assert_eq!(compat, [0.0, 0.0]);
}

/// A check says that a dashpot never sees a speed, where none is given, and only there.
#[test]
fn a_law_without_a_speed_is_named() {
    let script = |load: &str, analysis: &str| {
        format!(
            "model basic -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1; mass 2 1
            uniaxialMaterial Elastic 1 100.0 2.0; element zeroLength 7 1 2 -mat 1 -dir 1
            timeSeries Linear 1; pattern Plain 1 1 {{ {load} }}
            constraints Transformation; numberer Plain; system FullGeneral; algorithm Linear
            {analysis}"
        )
    };
    let load_control = "integrator LoadControl 0.1; analysis Static; analyze 10";
    let transient = "integrator Newmark 0.5 0.25; analysis Transient; analyze 10 0.1";
    for (load, analysis, named) in [
        ("load 2 1.0", load_control, true),
        ("load 2 1.0", "integrator DisplacementControl 2 1 0.1; analysis Static; analyze 1", true),
        ("load 2 1.0", transient, false),
        ("sp 2 1 1.0", load_control, false),
        ("sp 2 1 1.0", transient, false),
    ] {
        let mut checked = Script::default();
        checked.mode = Mode::Check;
        let ran = checked.run(&script(load, analysis));
        let words = "ZeroLength 7 depends on velocity";
        let found = ran.warnings().iter().any(|w| w.message.contains(words));
        assert_eq!(found, named, "{load} {analysis}: {:?}", ran.warnings());
    }
}
