//! The balance of energy against closed forms, and its error as a measure of the steps.

use super::close;
use super::script::Script;
use hysteron::analysis::Energies;

/// Energies at the end, and the largest relative error of the balance.
fn balance(text: &str) -> (Energies, f64) {
    let ran = Script::default().run_with(text, |run| run.interp.host.balance_energy(false)).done();
    let models = ran.interp.host.balances().unwrap().models();
    let last = models.last().unwrap();
    (last.energies.clone(), last.error)
}

fn class(e: &Energies, name: &str) -> (f64, f64) {
    let (_, c) = e.classes.iter().find(|(class, _)| *class == name).unwrap();
    (c.work, c.damping)
}

const FRAME: &str = "model basic -ndm 2 -ndf 3
    node 1 0 0; node 2 0 3; node 3 0 6; fix 1 1 1 1; mass 2 10 10 0; mass 3 8 8 0
    geomTransf Linear 1
    element elasticBeamColumn 1 1 2 0.1 3e7 0.0005 1
    element elasticBeamColumn 2 2 3 0.1 3e7 0.0005 1 -mass 0.3
    rayleigh 0.2 0.001 0 0
    timeSeries Trig 1 0 3 0.7 -factor 2
    constraints Plain; numberer RCM; system BandGeneral; test NormUnbalance 1e-10 20; algorithm Newton
    analysis Transient
    pattern UniformExcitation 1 1 -accel 1\n";

#[test]
fn a_linear_frame_balances_to_round_off() {
    let (e, error) = balance(&format!("{FRAME} integrator Newmark 0.5 0.25; analyze 400 0.01"));
    assert!(error < 1e-12, "{error}");
    let (work, damping) = class(&e, "ElasticBeam2d");
    assert!(work > 0.0 && damping > 0.0 && e.nodal_damping > damping && e.kinetic > 0.0);
}

/// The energy that an integrator takes beside the dampers is the error of the balance, never negative at its end.
#[test]
fn numerical_dissipation_is_seen() {
    let (e, error) = balance(&format!("{FRAME} integrator HHT 0.7; analyze 400 0.05"));
    assert!(error > 1e-3 && e.error() > 0.0, "{error}");
}

#[test]
fn modes_that_damp_are_a_source_of_their_own() {
    let text = FRAME.replace("rayleigh 0.2 0.001 0 0", "");
    let (e, error) =
        balance(&format!("{text} eigen 2; modalDamping 0.05; integrator Newmark 0.5 0.25; analyze 400 0.01"));
    assert!(error < 1e-9, "{error}");
    assert_eq!(e.nodal_damping, 0.0);
    assert!(e.modal_damping > 0.1 * e.input);
}

/// A spring of 100 pulled by 0.1: half of k u², whoever moves its end.
#[test]
fn imposed_motion_is_input_by_every_handler() {
    for handler in ["Transformation", "Penalty 1e10 1e10", "Lagrange"] {
        let (e, _) = balance(&format!(
            "model basic -ndm 1 -ndf 1
            node 1 0; node 2 0; fix 1 1
            uniaxialMaterial Elastic 1 100.0; element zeroLength 1 1 2 -mat 1 -dir 1
            timeSeries Linear 1; pattern Plain 1 1 {{ sp 2 1 0.1 }}
            constraints {handler}; numberer Plain; system BandGeneral; test NormDispIncr 1e-12 20; algorithm Newton
            integrator LoadControl 0.1; analysis Static; analyze 10"
        ));
        assert!(close(e.input, 0.5, 1e-6) && close(e.work(), 0.5, 1e-6), "{handler}: {e:?}");
    }
}

/// A mass that is released with a speed: its kinetic energy is the input, and goes into the dashpot.
#[test]
fn initial_velocity_is_input() {
    let (e, error) = balance(
        "model basic -ndm 1 -ndf 1
        node 1 0; node 2 0 -mass 2; fix 1 1
        uniaxialMaterial Elastic 1 100.0; uniaxialMaterial Viscous 2 1.5 1.0
        element zeroLength 1 1 2 -mat 1 2 -dir 1 1
        setNodeVel 2 1 3.0 -commit
        constraints Plain; numberer Plain; system BandGeneral; test NormUnbalance 1e-10 20; algorithm Newton
        integrator Newmark 0.5 0.25; analysis Transient; analyze 4000 0.005",
    );
    assert!(close(e.input, 9.0, 1e-12), "{e:?}");
    // The script gives no acceleration, so that the start is out of balance.
    assert!(error < 0.02 && close(class(&e, "ZeroLength").0, 9.0, 0.02), "{error} {e:?}");
}

/// The average acceleration keeps the balance of a yielding isolator too. What is missing is what its iterations leave.
#[test]
fn the_error_of_a_yielding_isolator_is_its_imbalance() {
    let error = |tolerance: f64| {
        balance(&format!(
            "model basic -ndm 1 -ndf 1
            node 1 0; node 2 0 -mass 1; fix 1 1
            uniaxialMaterial BoucWen 1 0.1 100.0 2 10.0 10.0 1.0 0.0 0.0 0.0
            element zeroLength 1 1 2 -mat 1 -dir 1
            timeSeries Trig 1 0 10 1.1 -factor 6; pattern UniformExcitation 1 1 -accel 1
            constraints Plain; numberer Plain; system BandGeneral; test NormDispIncr {tolerance} 50; algorithm Newton
            integrator Newmark 0.5 0.25; analysis Transient; analyze 500 0.02"
        ))
        .1
    };
    let (tight, loose) = (error(1e-12), error(0.1));
    assert!(tight < 1e-10 && loose > 1e-5, "{tight} {loose}");
}

/// Each model of a script has a balance of its own.
#[test]
fn models_are_told_apart() {
    let text = format!(
        "{FRAME} integrator Newmark 0.5 0.25; analyze 10 0.01\nwipe\n{FRAME} integrator Newmark 0.5 0.25; analyze 10 0.01"
    );
    let ran = Script::default().run_with(&text, |run| run.interp.host.balance_energy(true)).done();
    let balances = ran.interp.host.balances().unwrap();
    let models = balances.models();
    assert_eq!(models.len(), 2);
    assert_eq!(models[0], models[1]);
    assert_eq!((models[0].size.nodes, models[0].size.elements["ElasticBeam2d"]), (3, 2));
    let csv = balances.csv();
    assert_eq!(csv.lines().count(), 21);
    assert!(csv.starts_with("model,time,input,kinetic,damping_of_nodal_masses,damping_of_modes,work_ElasticBeam2d,"));
}
