//! Damping and inertia of single elements, and a system of one degree of freedom by itself.

use super::close;
use super::script::{Script, run};
use hysteron_engine::element::damping::Filters;
use nalgebra::Complex;

/// Damping ratio of a free vibration of a damped element, from its peaks; `law` is the damping, after its tag.
fn ratio_of(kind: &str, law: &str, frequency: f64) -> f64 {
    let omega = 2.0 * std::f64::consts::PI * frequency;
    let dt = 1.0 / frequency / 400.0;
    let text = format!(
        "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0 -mass 1.0
        fix 1 1
        uniaxialMaterial Elastic 1 {k}
        damping {kind} 1 {law}
        element zeroLength 1 1 2 -mat 1 -dir 1 -damp 1
        timeSeries Linear 1; pattern Plain 1 1 {{load 2 {k}}}
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 20; algorithm Newton
        integrator LoadControl 1.0; analysis Static; analyze 1
        loadConst -time 0; remove loadPattern 1; wipeAnalysis
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-9 20; algorithm Newton
        integrator Newmark 0.5 0.25; analysis Transient
        analyze 1 {dt}
        for {{set i 0}} {{$i < 4000}} {{incr i}} {{analyze 1 {dt}; puts [nodeDisp 2 1]}}",
        k = omega * omega,
    );
    let u = run(&text).numbers();
    let turns: Vec<f64> = u.windows(3).filter(|w| (w[1] - w[0]) * (w[2] - w[1]) <= 0.0).map(|w| w[1]).collect();
    // The mean line relaxes with the filters; this takes it away. So does the start, whose first turns are left out.
    let sizes: Vec<f64> = turns.windows(3).map(|w| (w[1] - 0.5 * (w[0] + w[2])).abs()).skip(6).collect();
    let half_cycles = (sizes.len() - 1) as f64;
    (sizes[0] / sizes[sizes.len() - 1]).ln() / half_cycles / std::f64::consts::PI
}

/// The same from the filters: the root s of s² + ω² (1 + Σ 2 α η s / (s + ω_c)).
fn ratio_of_filters(filters: &Filters, loss: f64, frequency: f64) -> f64 {
    let omega = 2.0 * std::f64::consts::PI * frequency;
    let mut s = Complex::new(0.0, omega);
    for _ in 0..100 {
        let each = filters.coefficient.iter().zip(&filters.cutoff);
        let sum: Complex<f64> = each.map(|(a, c)| s * (2.0 * a * loss) / (s + *c)).sum();
        s = Complex::new(0.0, omega) * (sum + 1.0).sqrt();
    }
    -s.re / s.im
}

/// Filters damp the frequencies of their range almost alike; the secant stiffness in proportion to the frequency.
#[test]
fn dampings_of_elements_have_their_ratios() {
    let filters = Filters::uniform(0.2, 30.0).expect("they exist");
    for frequency in [0.5, 2.0, 10.0] {
        let uniform = ratio_of("Uniform", "0.03 0.2 30", frequency);
        let expected = ratio_of_filters(&filters, 0.06, frequency);
        assert!(close(uniform, expected, 1e-3), "{frequency} Hz: {uniform}, {expected}");
        // The filters stiffen the element too, so that the ratio is the lower, the higher the frequency.
        assert!(close(uniform, 0.03, 0.16), "{frequency} Hz: {uniform}");
    }
    let secant = ratio_of("SecStif", "0.004", 2.0);
    // ζ = β ω / 2 less the error of the backward difference, which is of the order of β Δt ω² / 4.
    assert!(close(secant, 0.5 * 0.004 * 2.0 * std::f64::consts::PI * 2.0, 0.01), "{secant}");
    let error = Script::default().run("damping Uniform 1 0.05 10. 1.");
    assert!(error.error().message.contains("the frequencies are 10 and 1"));
}

/// A cantilever with its mass at the tip and along it under a shaking ground: its forces with damping and inertia are those of
/// openseespy, digit for digit but for round-off.
#[test]
fn forces_with_inertia_are_those_of_opensees() {
    for (mass, compat, expected) in [
        ("", false, [-3.7924824428855057, 11.377447328656517]),
        ("-mass 0.5", true, [-15.378160783343382, 34.73605535575294]),
    ] {
        let script = format!(
            "model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 3.; fix 1 1 1 1; mass 2 2. 2. 0.; geomTransf PDelta 1
            element elasticBeamColumn 1 1 2 0.01 2e8 1e-4 1 {mass}; rayleigh 0.3 0.001 0. 0.
            timeSeries Trig 2 0 10 0.5 -factor 3.; pattern UniformExcitation 1 1 -accel 2
            constraints Plain; numberer Plain; system FullGeneral; test NormDispIncr 1e-12 20; algorithm Newton
            integrator Newmark 0.5 0.25; analysis Transient; analyze 33 0.01
            puts \"[eleDynamicalForce 1 1] [eleDynamicalForce 1 3]\""
        );
        let ran = if compat { Script::compat().run(&script) } else { run(&script) };
        let found = ran.done().numbers();
        assert!(found.iter().zip(&expected).all(|(f, e)| close(*f, *e, 1e-12)), "{mass}: {found:?} for {expected:?}");
    }
}

/// An elastic-plastic mass under forces of a file and of a series, against openseespy.
#[test]
fn a_system_of_one_degree_responds_as_in_opensees() {
    let found = run("
        set values {}
        for {set i 0} {$i < 400} {incr i} { lappend values [expr {5*sin(0.02*$i*3)*(1+0.3*sin($i))}] }
        timeSeries Path 1 -dt 0.02 -values $values
        puts [sdfResponse 1.0 0.05 39.5 2.0 0.05 1 0.01]
        puts [sdfResponse 1.0 0.05 39.5 2.0 0.05 1 0.01 -uresid 0.02 -umaxprev 2. -tend 5.]")
    .done()
    .numbers();
    let expected = [0.8195099938687573, 0.2217478987242423, 0.258761769610815, 8.294714428682425, 2.43];
    assert!(found.iter().zip(&expected).all(|(f, e)| close(*f, *e, 1e-12)), "{found:?}");
    // The largest displacement of before stays, and the residual one changes the rest.
    assert!(found[5] == 2.0 && found[6] != found[1] && found.len() == 10, "{found:?}");
}

/// A series without an end and a response that overflows are errors.
#[test]
fn a_system_of_one_degree_wants_an_end() {
    let endless = Script::default().run("timeSeries Linear 1; sdfResponse 1. 0.05 40. 2. 0.05 1 0.01");
    assert!(endless.error().message.contains("has no end"), "{:?}", endless.error());
    let overflows =
        Script::default().run("timeSeries Constant 1 -factor 1e308; sdfResponse 1e-9 0.05 40. 2. 0.05 1 0.01 -tend 1.");
    assert!(overflows.error().message.contains("not finite"), "{:?}", overflows.error());
}
