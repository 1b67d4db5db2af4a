//! Stresses of laws beside those of openseespy 3.7.1, and beside their equations.

use super::script::{Script, run};

/// Stresses of a law at strains, one after the other.
fn stresses(script: Script, law: &str, strains: &str) -> Vec<f64> {
    script
        .run(&format!(
            "model basic -ndm 1 -ndf 1\n{law}\ntestUniaxialMaterial 1
            foreach e {{{strains}}} {{ setStrain $e; puts [getStress] }}"
        ))
        .done()
        .numbers()
}

fn agree(got: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(got.len(), expected.len());
    assert!(got.iter().zip(expected).all(|(g, e)| (g - e).abs() <= tolerance), "{got:?}\n{expected:?}");
}

/// Backward Euler in both programs, so that the sizes of the steps count.
#[test]
fn bouc_wen_by_its_yield_strength() {
    let strains = "0.002 0.005 0.01 0.02 0.03 0.02 0.0 -0.02 -0.04 0. 0.03";
    let of = |law: &str| stresses(Script::default(), &format!("uniaxialMaterial BoucWenOriginal 1 {law}"), strains);
    let plain = [
        0.33666666666666667,
        0.7320512820512821,
        1.188034188034188,
        1.6940170940170938,
        1.9970085470085468,
        0.09850427350427368,
        -1.3004985754985754,
        -1.9001661918328585,
        -2.2333887306109528,
        1.1533222538778092,
        2.0133305634694523,
    ];
    agree(&of("200. 2. 0.05"), &plain, 1e-8);
    let hardening = [
        0.3859058284481646,
        0.8777264170562238,
        1.419529930821145,
        1.899482053930564,
        2.132452413271209,
        0.13463158352380958,
        -1.499270260984567,
        -2.0184829339230883,
        -2.2838866021932027,
        1.427333272414419,
        2.1315197433921633,
    ];
    agree(&of("200. 2. 0.05 0.02 3. 2. 0.6 0.4"), &hardening, 1e-8);
}

/// The strain of a stress by the equation of the law: (s - P)(1 + c/s)/E + c (1/P^2 - 1/s^2), and without its last term in OpenSees.
#[test]
fn a_cable_sags_by_its_weight() {
    let (p, e, c) = (200.0, 2e5, (0.08f64 * 5000.0).powi(2) / 24.0);
    let strains = [0.0, 1e-4, 1e-3, 5e-3, -1e-4, -5e-4, -2e-3, -2e-2];
    let words = strains.map(|e: f64| e.to_string()).join(" ");
    let law = "uniaxialMaterial Cable 1 200. 2e5 0.08 5000.";
    let elastic = |s: f64| (s - p) * (1.0 + c / s) / e;
    for (s, strain) in stresses(Script::default(), law, &words).iter().zip(strains) {
        let sag = c * (1.0 / (p * p) - 1.0 / (s * s));
        assert!((elastic(*s) + sag - strain).abs() < 1e-12, "{strain}: {s}");
    }
    let opensees = [
        199.99999850988388,
        200.5841763317585,
        205.99461048841476,
        233.8950790464878,
        199.41911846399307,
        197.12800234556198,
        188.97409588098526,
        125.87473466992378,
    ];
    // OpenSees bisects to 1e-8 of the stress.
    agree(&stresses(Script::compat(), law, &words), &opensees, 5e-6);
    // Without weight it is a bar that does not push.
    let bar = stresses(Script::default(), "uniaxialMaterial Cable 1 200. 2e5 0. 5000.", "0. 1e-3 -2e-3");
    agree(&bar, &[200.0, 400.0, 0.0], 1e-9);
}

#[test]
fn a_law_without_its_history_follows_its_backbone() {
    let law = "uniaxialMaterial Steel01 2 2. 200. 0.05\nuniaxialMaterial PathIndependent 1 2";
    let found = stresses(Script::default(), law, "0.005 0.02 0.01 -0.02 0.03 0.0");
    agree(&found, &[1.0, 2.1, 2.0, -2.1, 2.2, 0.0], 1e-14);
}

/// A hardening part with an infinite stiffness at rest, and a cable without prestress.
#[test]
fn numbers_without_a_stiffness_are_refused() {
    for law in ["BoucWenOriginal 1 200. 2. 0.05 0.02 0.5", "Cable 1 0. 2e5 0.08 5000."] {
        Script::default().run(&format!("model basic -ndm 1 -ndf 1\nuniaxialMaterial {law}")).error();
    }
    run("model basic -ndm 1 -ndf 1\nuniaxialMaterial BoucWenOriginal 1 200. 2. 0.05 0. 0.5");
}
