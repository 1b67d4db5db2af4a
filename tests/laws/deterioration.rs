//! Deteriorating plastic hinges and walls.

use super::driver::MaterialPoint;
use super::materials::{check_purity, check_tangent};
use hysteron::material::{
    Bilin, BilinSide, BondSp01, Concrete04, Damage, Deterioration, HyperbolicGap, ImkBilin, ImkDeterioration,
    ImkPeakOriented, ImkPinching, ImkSide, Material, ModImkPeakOriented, ModImkPinching, Pinching, Pinching4,
    Pinching4Parameters, Pinching4Side, PinchingPoint, Saws, SawsParameters, UvcUniaxial,
};
use hysteron::rules::{Consistent, OpenSees};

const KE: f64 = 200.0;

/// My, αs, θp, θpc, κ, θu, D.
const SIDE: BilinSide = BilinSide {
    strength: 2.0,
    hardening: 0.03,
    plastic: 0.05,
    post_capping: 0.2,
    residual: 0.4,
    ultimate: 0.4,
    rate: 1.0,
};

fn hinge<R>(capacity: f64, n: f64, rules: R) -> Bilin<R> {
    let mode = Deterioration { capacity, exponent: 1.0 };
    Bilin { ke: KE, sides: [SIDE; 2], strength: mode, capping: mode, stiffness: mode, n, steady_cap: false, rules }
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-6 * (1.0 + b.abs()), "{a}, expected {b}");
}

/// Peaks of full cycles of one amplitude.
fn peaks(law: Bilin, amplitude: f64, cycles: usize) -> Vec<f64> {
    let mut p = MaterialPoint::new(Material::new(law));
    let mut at = |from: f64, to: f64| -> f64 {
        (1..=40).map(|i| p.advance(from + (to - from) * f64::from(i) / 40.0).value).last().unwrap()
    };
    let mut from = 0.0;
    (0..2 * cycles)
        .map(|i| {
            let to = if i % 2 == 0 { amplitude } else { -amplitude };
            let force = at(from, to).abs();
            from = to;
            force
        })
        .collect()
}

#[test]
fn tangent_is_consistent_and_trials_have_no_effect() {
    for (name, capacity, n) in [("no deterioration", 0.0, 0.0), ("little", 10.0, 0.0), ("much", 1.0, 3.0)] {
        check_tangent(name, Material::new(hinge(capacity, n, Consistent)), 0.1);
        check_purity(name, Material::new(hinge(capacity, n, Consistent)), 0.1);
        check_purity(name, Material::new(hinge(capacity, n, OpenSees)), 0.3);
    }
}

/// Yield, cap, residual strength and fracture, on both sides.
#[test]
fn monotonic_loading_follows_the_backbone() {
    let (yielded, peak) = (0.01, 2.0 + 0.03 * KE * 0.05);
    for s in [1.0, -1.0] {
        let mut p = MaterialPoint::new(Material::new(hinge(1.0, 0.0, Consistent)));
        for (x, force) in [
            (0.005, 1.0),
            (yielded, 2.0),
            (yielded + 0.05, peak),
            (yielded + 0.05 + 0.1, 0.5 * peak),
            (0.3, 0.8),
            (0.39, 0.8),
            (0.41, 0.0),
        ] {
            close(s * p.advance(s * x).value, force);
        }
        close(p.advance(0.0).value, 0.0);
    }
}

/// Hinge and elastic member in series follow the given backbone up to the cap.
#[test]
fn hinge_and_member_follow_the_given_backbone() {
    let n = 10.0;
    let member = KE * (1.0 + n) / n;
    let mut p = MaterialPoint::new(Material::new(hinge(0.0, n, Consistent)));
    let mut last = (0.0, 0.0);
    for i in 1..=50 {
        let x = 0.001 * f64::from(i);
        let force = p.advance(x).value;
        let now = (x + force / member, force);
        let slope = (now.1 - last.1) / (now.0 - last.0);
        if now.1 < 2.0 {
            close(slope, KE);
        } else if last.1 > 2.0 {
            close(slope, 0.03 * KE);
        }
        last = now;
    }
}

/// Cycles reduce the strength more for a smaller capacity, and not at all without a reference energy.
#[test]
fn cycles_reduce_the_hinge_strength() {
    let intact = peaks(hinge(0.0, 0.0, Consistent), 0.04, 8);
    intact[2..].iter().for_each(|&f| close(f, intact[2]));
    let [some, more] = [2.0, 1.0].map(|capacity| peaks(hinge(capacity, 0.0, Consistent), 0.04, 8));
    for (i, (a, b)) in some.iter().zip(&more).enumerate().skip(2) {
        assert!(b < a && *a < intact[i], "peak {i}: {a} and {b} of {}", intact[i]);
        assert!(*a < some[i - 1] && *b < more[i - 1], "peak {i}: {a} after {}", some[i - 1]);
    }
}

/// A step from one side beyond the cap of the other loses no additional strength.
#[test]
fn long_step_keeps_strength() {
    let drive = |compat: bool| {
        let side = BilinSide { plastic: 0.02, residual: 0.0, ..SIDE };
        let mut p = match compat {
            true => MaterialPoint::new(Material::new(Bilin { sides: [side; 2], ..hinge(1.0, 0.0, OpenSees) })),
            false => MaterialPoint::new(Material::new(Bilin { sides: [side; 2], ..hinge(1.0, 0.0, Consistent) })),
        };
        [0.03, -0.07, 0.03, -0.065].map(|x| p.advance(x).value)[3]
    };
    assert!(drive(false) < -0.5, "{}", drive(false));
    assert!(drive(true).abs() < 1e-6, "{}", drive(true));
}

const WALL: SawsParameters =
    SawsParameters { fo: 2.0, fi: 0.3, du: 0.07, so: 200.0, r: [0.06, -0.08, 1.1, 0.02], alpha: 0.8, beta: 1.1 };

/// Monotonic loading follows (F0 + R1 S0 u)(1 - exp(-S0 u / F0)) up to DU, then a line of slope R2 S0.
#[test]
fn monotonic_loading_of_a_wall_follows_its_envelope() {
    let envelope = |u: f64| (2.0 + 12.0 * u) * (1.0 - (-100.0 * u).exp());
    for s in [1.0, -1.0] {
        let mut p = MaterialPoint::new(Material::new(Saws::new(WALL).expect("a wall that pinches")));
        for u in [0.005, 0.02, 0.05, 0.07] {
            close(s * p.advance(s * u).value, envelope(u));
        }
        close(s * p.advance(s * 0.1).value, envelope(0.07) - 16.0 * 0.03);
    }
    assert!(Saws::new(SawsParameters { fi: 5.0, ..WALL }).is_none());
}

/// Cycles of one amplitude dissipate energy, later ones less.
#[test]
fn wall_cycles_dissipate_less_when_repeated() {
    let mut p = MaterialPoint::new(Material::new(Saws::new(WALL).expect("a wall that pinches")));
    let mut cycle = || {
        let mut work = 0.0;
        let (mut from, mut before) = (0.0, p.advance(0.0).value);
        for to in (1..=200).map(|i| 0.05 * (std::f64::consts::TAU * f64::from(i) / 200.0).sin()) {
            let force = p.advance(to).value;
            work += 0.5 * (force + before) * (to - from);
            (from, before) = (to, force);
        }
        work
    };
    let [first, second, third] = [cycle(), cycle(), cycle()];
    assert!(first > second && second >= third && third > 0.0, "{first} {second} {third}");
}

/// Envelope through (0.01, 2), (0.02, 3), (0.05, 3) and (0.09, 1).
fn pinching4(rate: f64) -> Pinching4Parameters {
    let side = Pinching4Side {
        stress: [2.0, 3.0, 3.0, 1.0],
        strain: [0.01, 0.02, 0.05, 0.09],
        reloading_strain: 0.5,
        reloading_stress: 0.3,
        unloading_stress: 0.05,
    };
    let damage = Damage { rate: [rate, rate], exponent: [1.0, 1.0], limit: 0.8 };
    let energy = 10.0;
    let [stiffness, reloading, strength] = [damage; 3];
    Pinching4Parameters {
        sides: [side; 2],
        stiffness,
        reloading,
        strength,
        linear_strength: None,
        energy,
        by_cycles: false,
    }
}

const IMK_SIDE: ImkSide =
    ImkSide { plastic: 0.05, post_capping: 0.2, ultimate: 0.4, strength: 2.0, peak: 1.15, residual: 0.4, rate: 1.0 };

fn imk_bilin(capacity: f64) -> ImkBilin {
    let mode = ImkDeterioration { capacity, exponent: 1.0 };
    let rules = Consistent;
    ImkBilin { ke: KE, sides: [IMK_SIDE; 2], strength: mode, capping: mode, stiffness: mode, rules }
}

fn imk_peak_oriented(capacity: f64) -> ImkPeakOriented {
    let mode = ImkDeterioration { capacity, exponent: 1.0 };
    let [strength, capping, reloading, stiffness] = [mode; 4];
    ImkPeakOriented { ke: KE, sides: [IMK_SIDE; 2], strength, capping, reloading, stiffness, rules: Consistent }
}

fn mod_imk(capacity: f64) -> ModImkPeakOriented {
    let mode = Deterioration { capacity, exponent: 1.0 };
    let [strength, capping, reloading, stiffness] = [mode; 4];
    ModImkPeakOriented { ke: KE, sides: [SIDE; 2], strength, capping, reloading, stiffness, n: 0.0, rules: Consistent }
}

/// Hinges of the Ibarra-Medina-Krawinkler family with a capacity Λ.
fn hinges(capacity: f64) -> [Material; 5] {
    let (pinching, end) =
        (Pinching { force: 0.4, deformation: 0.6 }, PinchingPoint { force: [0.4; 2], deformation: 0.3 });
    [
        Material::new(imk_bilin(capacity)),
        Material::new(imk_peak_oriented(capacity)),
        Material::new(ImkPinching { hinge: imk_peak_oriented(capacity), pinching }),
        Material::new(mod_imk(capacity)),
        Material::new(ModImkPinching { hinge: mod_imk(capacity), pinching: end }),
    ]
}

fn uvc() -> UvcUniaxial {
    let backstresses = vec![[20.0, 40.0], [4.0, 5.0]];
    UvcUniaxial { e: KE, fy: 2.0, q_inf: 0.5, b: 10.0, d_inf: 0.3, a: 100.0, backstresses, rules: Consistent }
}

#[test]
fn trials_have_no_effect() {
    let others: [Material; 5] = [
        Material::new(Pinching4::new(pinching4(0.3))),
        Material::new(Concrete04 { fc: -3.0, epsc0: -0.03, epscu: -0.08, ec0: KE, ft: 0.3, etu: 0.02, beta: 0.1 }),
        Material::new(BondSp01 { fy: 60.0, sy: 0.02, fu: 90.0, su: 0.6, b: 0.4, r: 0.7, rules: Consistent }),
        Material::new(HyperbolicGap { kmax: KE, kur: KE, rf: 0.7, fult: -3.0, gap: -0.02, rules: Consistent }),
        Material::new(uvc()),
    ];
    for law in hinges(5.0).into_iter().chain(others) {
        check_purity(law.name(), law, 0.1);
    }
}

/// Yield, cap, residual strength and fracture of the backbones, on both sides.
#[test]
fn monotonic_loading_of_the_family_follows_the_backbone() {
    for law in hinges(10.0) {
        let peak = 2.3;
        for s in [1.0, -1.0] {
            let mut p = MaterialPoint::new(law.clone());
            for (x, force) in
                [(0.005, 1.0), (0.01, 2.0), (0.06, peak), (0.06 + 0.1, 0.5 * peak), (0.3, 0.8), (0.39, 0.8)]
            {
                close(s * p.advance(s * x).value, force);
            }
            p.advance(s * 0.41);
            close(p.advance(s * 0.42).value, 0.0);
        }
    }
}

#[test]
fn monotonic_loading_follows_the_four_points() {
    for s in [1.0, -1.0] {
        let mut p = MaterialPoint::new(Material::new(Pinching4::new(pinching4(0.0))));
        for (x, stress) in [(0.01, 2.0), (0.02, 3.0), (0.035, 3.0), (0.05, 3.0), (0.07, 2.0), (0.09, 1.0)] {
            close(s * p.advance(s * x).value, stress);
        }
    }
}

/// Cycles of one amplitude lose strength with damage or a small capacity, and none without.
#[test]
fn cycles_lose_strength() {
    let last = |law: Material| {
        let mut p = MaterialPoint::new(law);
        let mut first = 0.0;
        let mut force = 0.0;
        for cycle in 0..6 {
            for i in 1..=80 {
                force = p.advance(0.04 * (std::f64::consts::TAU * f64::from(i) / 80.0).sin()).value;
                if i == 20 {
                    first = if cycle == 0 { force } else { first };
                    force = force.max(p.trial(0.04, 0.0, 0.0).value);
                    if cycle == 5 {
                        return force / first;
                    }
                }
            }
        }
        force
    };
    for (intact, worn) in hinges(1e6).into_iter().zip(hinges(2.0)) {
        let (name, kept, left) = (intact.name(), last(intact), last(worn));
        assert!(kept > 0.99 && left < 0.95 * kept, "{name}: {kept} and {left}");
    }
    let [kept, left] = [0.0, 0.3].map(|rate| last(Material::new(Pinching4::new(pinching4(rate)))));
    assert!(kept > 0.99 && left < 0.95, "{kept} and {left}");
}

/// The stress under monotonic loading is that of the integrated equations at the plastic strain of the point.
#[test]
fn structural_steel_follows_its_integrated_equations() {
    for s in [1.0, -1.0] {
        let mut p = MaterialPoint::new(Material::new(uvc()));
        for i in 1..=30 {
            let strain = 0.005 * f64::from(i);
            let stress = s * p.advance(s * strain).value;
            let plastic = strain - stress / KE;
            let grown = |size: f64, rate: f64| size * (1.0 - (-rate * plastic).exp());
            let expected =
                2.0 + grown(0.5, 10.0) - grown(0.3, 100.0) + grown(20.0 / 40.0, 40.0) + grown(4.0 / 5.0, 5.0);
            let yielded = strain > 0.01;
            close(stress, if yielded { expected } else { KE * strain });
        }
    }
}
