//! The oscillator of inelastic spectra beside a model of one node.

use super::script::run;
use hysteron::analysis::InelasticOscillator;
use hysteron::material::Slot;
use std::f64::consts::TAU;

/// A law, an oscillator of 1.5 s with it, and a motion of steps that need no division.
const LAW: &str = "Steel02 1 1.2 17.545963379714587 0.05 18.0 0.925 0.15";
const PERIOD: f64 = 1.5;
const DT: f64 = 0.01;
const DAMPING: f64 = 0.03;

fn ground(i: usize) -> f64 {
    let t = DT * i as f64;
    3.0 * (-((t - 4.0) / 2.0).powi(2)).exp() * (TAU * 0.6 * t).sin()
}

#[test]
fn the_oscillator_moves_as_a_model_of_one_node() {
    let motion: Vec<f64> = (0..=1000).map(ground).collect();
    let values: String = motion.iter().map(|a| format!(" {a:.17e}")).collect();
    let ran = run(&format!(
        "model BasicBuilder -ndm 1 -ndf 1; node 1 0; node 2 0; fix 1 1; mass 2 1.0\n\
         uniaxialMaterial {LAW}; element zeroLength 1 1 2 -mat 1 -dir 1\n\
         timeSeries Path 1 -dt {DT} -values {{{values}}}; pattern UniformExcitation 1 1 -accel 1\n\
         rayleigh {} 0 0 0\n\
         test NormUnbalance 1e-12 50; algorithm Newton; integrator Newmark 0.5 0.25; analysis Transient\n\
         set largest 0\n\
         for {{set i 0}} {{$i < 1000}} {{incr i}} {{ analyze 1 {DT}; set largest [expr {{max($largest, abs([nodeDisp 2 1]))}}] }}\n\
         puts $largest",
        2.0 * DAMPING * TAU / PERIOD
    ));
    let material = ran.interp.host.builder.definitions.materials.get(1).expect("the law").clone();
    let oscillator = InelasticOscillator { period: PERIOD, damping: DAMPING, law: Slot::new(material, 1, 0) };
    let found = oscillator.largest_displacement(DT, &motion).expect("a response");
    let of_model = ran.numbers()[0];
    assert!(of_model > 0.2, "it yields: {of_model}");
    assert!((found / of_model - 1.0).abs() < 1e-8, "{found}, not {of_model}");
}
