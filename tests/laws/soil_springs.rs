//! Soil springs of piles.

use super::driver::MaterialPoint;
use super::materials::{check_purity, check_tangent};
use hysteron::material::{
    Material, PyBackbone, PySimple1, QzBackbone, QzSimple1, Soil, SoilSpring, TzBackbone, TzSimple1,
};

const ULTIMATE: f64 = 50.0;
const Y50: f64 = 0.01;

fn spring<S: Soil>(soil: S, dashpot: f64, compat: bool) -> Material {
    Material::new(SoilSpring { soil, dashpot, compat })
}

fn py(backbone: PyBackbone, drag: f64) -> PySimple1 {
    PySimple1::new(backbone, ULTIMATE, Y50, drag)
}

fn all(dashpot: f64, compat: bool) -> Vec<(&'static str, Material)> {
    let tz = |backbone| TzSimple1::new(backbone, ULTIMATE, Y50);
    let qz = |backbone, suction| QzSimple1::new(backbone, ULTIMATE, Y50, suction);
    vec![
        ("p-y, clay", spring(py(PyBackbone::Clay, 0.3), dashpot, compat)),
        ("p-y, sand", spring(py(PyBackbone::Sand, 0.1), dashpot, compat)),
        ("t-z, Reese and O'Neill", spring(tz(TzBackbone::ReeseONeill), dashpot, compat)),
        ("t-z, Mosher", spring(tz(TzBackbone::Mosher), dashpot, compat)),
        ("q-z, clay", spring(qz(QzBackbone::Clay, 0.05), dashpot, compat)),
        ("q-z, sand", spring(qz(QzBackbone::Sand, 0.0), dashpot, compat)),
    ]
}

/// Forces from one displacement to another in steps.
fn walk(p: &mut MaterialPoint, from: f64, to: f64, n: u32) -> Vec<f64> {
    (1..=n).map(|i| p.advance(from + (to - from) * f64::from(i) / f64::from(n)).value).collect()
}

/// Forces at reversals, with `n` steps between two of them.
fn at_turns(law: &Material, n: u32) -> Vec<f64> {
    let mut p = MaterialPoint::new(law.clone());
    let turns = [0.0, 0.3, -0.5, 1.5, 0.2, 1.1, -4.0, 3.0, 6.0, 0.0, -1.0].map(|y| y * Y50);
    turns.windows(2).map(|w| walk(&mut p, w[0], w[1], n)[n as usize - 1]).collect()
}

#[test]
fn tangent_is_consistent_and_trials_have_no_effect() {
    for dashpot in [0.0, 40.0] {
        for (name, law) in all(dashpot, false) {
            check_tangent(name, law.clone(), 4.0 * Y50);
            check_purity(name, law, 4.0 * Y50);
        }
    }
}

/// The distribution among the springs does not depend on the size of the steps, except for the gap of a p-y spring.
/// The gap widens with the pile's displacement in each step.
#[test]
fn force_is_independent_of_step_size() {
    for (name, law) in all(0.0, false) {
        let (coarse, fine) = (at_turns(&law, 1), at_turns(&law, 100));
        for (a, b) in coarse.iter().zip(&fine) {
            let within = if name.starts_with("p-y") { 1e-4 } else { 1e-9 };
            assert!((a - b).abs() < within * ULTIMATE, "{name}: {coarse:?} and {fine:?}");
        }
    }
}

/// OpenSees' iterations give the same force, except for the gap within a step.
#[test]
fn opensees_iterations_give_the_same_force() {
    for ((name, exact), (_, rounds)) in all(0.0, false).iter().zip(&all(0.0, true)) {
        let (exact, rounds) = (at_turns(exact, 200), at_turns(rounds, 200));
        let within = if name.starts_with("p-y") { 1e-5 } else { 1e-8 };
        let same = exact.iter().zip(&rounds).all(|(a, b)| (a - b).abs() < within * ULTIMATE);
        assert!(same, "{name}: {exact:?} {rounds:?}");
    }
}

/// Half of the ultimate force at y50, and the ultimate force at large displacement (Boulanger, 2003, within 5 %).
#[test]
fn backbone_has_half_the_ultimate_force_at_y50() {
    for (name, law) in all(0.0, false) {
        // A q-z spring carries compression.
        let s = if name.starts_with("q-z") { -1.0 } else { 1.0 };
        let mut p = MaterialPoint::new(law);
        let half = s * p.advance(s * Y50).value / ULTIMATE;
        assert!((half - 0.5).abs() < 0.05, "{name}: {half}");
        let far = s * p.advance(s * 3000.0 * Y50).value / ULTIMATE;
        assert!(far > 0.99 && far < 1.0, "{name}: {far}");
    }
}

/// In the gap only the drag resists the pile; the soil resists it again at its previous position.
#[test]
fn gap_forms_behind_a_pile() {
    for drag in [0.02, 0.1, 0.4] {
        let mut p = MaterialPoint::new(spring(py(PyBackbone::Clay, drag), 0.0, false));
        let there = walk(&mut p, 0.0, 8.0 * Y50, 50)[49];
        let within = walk(&mut p, 8.0 * Y50, 3.0 * Y50, 50)[49] / ULTIMATE;
        assert!(within < -0.5 * drag && within > -drag - 0.015, "{drag}: {within}");
        let again = walk(&mut p, 3.0 * Y50, 8.2 * Y50, 50)[49];
        // A large drag moves the sides of the gap.
        assert!(drag > 0.1 || again > 0.98 * there, "{again} after {there}");
    }
}

/// The uplift resistance of a pile tip is the suction.
#[test]
fn tip_uplift_resistance_is_the_suction() {
    for suction in [0.0, 0.05] {
        let law = spring(QzSimple1::new(QzBackbone::Sand, ULTIMATE, Y50, suction), 0.0, false);
        let mut p = MaterialPoint::new(law);
        walk(&mut p, 0.0, -3.0 * Y50, 20);
        let up = walk(&mut p, -3.0 * Y50, 20.0 * Y50, 60)[59] / ULTIMATE;
        assert!(up > 0.9 * suction && up < suction + 1e-4, "{suction}: {up}");
    }
}

/// The dashpot follows the displacement of the far field: all of it before yield, none at the ultimate force.
#[test]
fn dashpot_acts_on_the_far_field() {
    let law = spring(TzSimple1::new(TzBackbone::ReeseONeill, ULTIMATE, Y50), 100.0, false);
    let mut p = MaterialPoint::new(law);
    let (slow, fast) = (p.trial(0.1 * Y50, 0.0, 0.0).value, p.trial(0.1 * Y50, 0.2, 0.0).value);
    let part = (fast - slow) / 20.0;
    assert!(part > 0.7 && part < 0.9, "{part}");
    p.advance(20.0 * Y50);
    let (slow, fast) = (p.trial(21.0 * Y50, 0.0, 0.0).value, p.trial(21.0 * Y50, 0.2, 0.0).value);
    assert!((fast - slow) / 20.0 < 0.01, "{}", fast - slow);
}
