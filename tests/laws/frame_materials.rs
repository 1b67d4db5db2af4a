//! Uniaxial laws of frames, and laws composed of others.

use super::driver::{MaterialPoint, path};
use super::materials::{check_purity, check_tangent};
use hysteron::material::{
    BrbBranch, Concrete01, Concrete02, Elastic, ElasticBilin, ElasticMultiLinear, ElasticPP, ElasticPPGap, Envelope,
    Fatigue, FatigueParameters, Hardening, Hysteretic, InitialState, IntegrationMethod, Iteration, Material, Maxwell,
    MinMax, MultiLinear, NoTension, Parallel, SelfCentering, Series, Steel01, Steel02, SteelBrb, SteelMpf,
    ViscousDamper,
};
use hysteron::rules::{Consistent, OpenSees};
use std::sync::Arc;

fn steel02(a: [f64; 4], sig_init: f64) -> Material {
    Material::new(Steel02 { fy: 2.0, e0: 200.0, b: 0.02, r0: 18.0, c_r: [0.925, 0.15], a, sig_init })
}

fn steel01() -> Material {
    Material::new(Steel01 { fy: 2.0, e0: 200.0, b: 0.02, a: Steel01::NO_ISOTROPIC })
}

fn steel_brb() -> Material {
    let branch = |yield_stress, alpha, beta| BrbBranch { yield_stress, alpha, beta, delta: 0.05 };
    let (tension, compression) = (branch(3.0, 1.2, 0.02), branch(3.5, 2.5, 0.03));
    Material::new(SteelBrb { e: 200.0, yield_stress: 2.0, tension, compression, compat: false })
}

fn fatigue() -> Material {
    let p = FatigueParameters { d_max: 1.0, e0: 0.5, m: -0.458, limits: (-1.0, 1.0) };
    Material::new(Fatigue::new((steel01(), 1), p))
}

fn hysteretic(pinch: [f64; 2], damage: [f64; 2], beta: f64) -> Material {
    let tension = Envelope::new([2.0, 3.0, 2.5], [0.01, 0.03, 0.08]);
    let compression = Envelope::bilinear([1.5, 2.5], [0.008, 0.05]);
    Material::new(Hysteretic::new(tension, compression, pinch, damage, beta))
}

fn multi_linear() -> Material {
    let points = vec![[0.005, 1.0], [0.02, 2.0], [0.06, 2.5]];
    Material::new(MultiLinear::new(points, false).unwrap())
}

fn self_centering(compat: bool) -> Material {
    if compat { Material::new(flag(OpenSees)) } else { Material::new(flag(Consistent)) }
}

fn flag<R>(rules: R) -> SelfCentering<R> {
    SelfCentering {
        k1: 200.0,
        k2: 10.0,
        activation: 2.0,
        beta: 0.7,
        slip: 0.06,
        bearing: 0.09,
        bearing_ratio: 0.4,
        rules,
    }
}

fn gap(fy: f64, gap: f64, damage: bool) -> Material {
    Material::new(ElasticPPGap { e: 200.0, fy, gap, eta: 0.05, damage })
}

fn series(iteration: Iteration) -> Series {
    Series::new(
        vec![(steel01(), 1), (steel02(Steel02::NO_ISOTROPIC, 0.0), 2), (Material::new(Elastic::new(150.0)), 3)],
        iteration,
    )
}

/// Every law with a strain amplitude in its nonlinear range.
fn all() -> Vec<(&'static str, Material, f64)> {
    let isotropic = [0.05, 5.0, 0.03, 4.0];
    let hardening = |h_iso, h_kin| Arc::new(Hardening { e: 200.0, sigma_y: 2.0, h_iso, h_kin, compat: false });
    let curve =
        ElasticMultiLinear::new(vec![-0.08, -0.03, 0.0, 0.02, 0.05], vec![-3.0, -2.5, 0.0, 1.0, 4.0], 0.0).unwrap();
    let concrete01 = Concrete01 { fpc: -30.0, epsc0: -0.002, fpcu: -6.0, epscu: -0.005 };
    let concrete02 =
        Concrete02 { fc: -30.0, epsc0: -0.002, fcu: -6.0, epscu: -0.005, ratio: 0.1, ft: 3.0, ets: 2000.0 };
    let both: Vec<(Material, i32)> = vec![(steel01(), 1), (gap(-2.0, -0.01, false), 2)];
    vec![
        ("curved steel", steel02(Steel02::NO_ISOTROPIC, 0.0), 0.1),
        ("curved steel, isotropic, with initial stress", steel02(isotropic, 0.8), 0.1),
        ("trilinear hysteresis", hysteretic([1.0, 1.0], [0.0, 0.0], 0.0), 0.1),
        ("trilinear hysteresis, pinched, with damage", hysteretic([0.6, 0.3], [0.01, 0.005], 0.4), 0.1),
        ("no tension", Material::new(NoTension { e: 200.0, a: 0.0, b: 1.0 }), 0.1),
        ("little tension", Material::new(NoTension { e: 200.0, a: 0.01, b: 30.0 }), 0.1),
        ("gap in tension", gap(2.0, 0.01, false), 0.1),
        ("gap in compression", gap(-2.0, -0.01, false), 0.1),
        ("gap with damage", gap(2.0, 0.01, true), 0.1),
        ("isotropic hardening", Material::from(hardening(10.0, 0.0)), 0.1),
        ("kinematic hardening", Material::from(hardening(0.0, 10.0)), 0.1),
        (
            "two slopes",
            Material::new(ElasticBilin { first: [200.0, 150.0], second: [50.0, 300.0], bend: [0.02, 0.03] }),
            0.1,
        ),
        ("elastic curve", Material::new(curve), 0.1),
        ("multilinear", multi_linear(), 0.1),
        ("flag", self_centering(false), 0.12),
        ("flag of OpenSees", self_centering(true), 0.12),
        ("side by side", Material::new(Parallel::new(both, vec![2.0, 0.5])), 0.1),
        ("one behind the other", Material::new(series(Iteration::Converged)), 0.1),
        ("braces of steel", steel_brb(), 0.1),
        ("fatigue", fatigue(), 0.1),
        ("strain limits", Material::new(MinMax::new((steel01(), 1), -0.09, 0.095, false)), 0.1),
        ("initial strain", Material::new(InitialState::strain((steel01(), 1), 0.013).unwrap()), 0.1),
        ("concrete without tension", Material::new(concrete01), 0.006),
        ("concrete with tension", Material::new(concrete02), 0.006),
        ("initial stress", Material::new(InitialState::stress((steel01(), 1), -1.7).unwrap()), 0.1),
    ]
}

#[test]
fn tangent_matches_finite_difference() {
    for (name, law, amplitude) in all().into_iter().filter(|m| m.0 != "flag of OpenSees") {
        check_tangent(name, law, amplitude);
    }
}

/// A yielding trial followed by an elastic one: OpenSees commits the plastic strain of the former.
#[test]
fn hardening_of_opensees_keeps_the_plastic_strain_of_a_trial() {
    let after = |compat| {
        let mut p =
            MaterialPoint::new(Material::new(Hardening { e: 200.0, sigma_y: 2.0, h_iso: 0.0, h_kin: 20.0, compat }));
        p.trial(0.021, 0.0, 0.0);
        p.advance(0.005);
        p.advance(0.005).value
    };
    // Δε_p = (E ε - σ_y) / (E + H) = 0.01 in the yielding trial.
    assert!((after(true) - 200.0 * (0.005 - 0.01)).abs() < 1e-12, "{}", after(true));
    assert!((after(false) - 200.0 * 0.005).abs() < 1e-12, "{}", after(false));
}

/// Stresses of openseespy 3.7.1 with and without a first strain of zero, which later versions take no notice of.
#[test]
fn a_first_strain_of_zero_is_no_curve_of_steel_mpf() {
    let stresses = |compat: bool, strains: &[f64]| -> Vec<f64> {
        let law = SteelMpf {
            fy: [2.0, 1.8],
            e: 200.0,
            b: [0.02, 0.03],
            r0: 18.0,
            cr1: 0.925,
            cr2: 0.15,
            shift: [(0.0, 1.0); 2],
            least_strain: if compat { 0.0 } else { SteelMpf::LEAST_STRAIN },
        };
        let mut p = MaterialPoint::new(Material::new(law));
        strains.iter().map(|e| p.advance(*e).value).collect()
    };
    let strains = [0.0, 0.005, 0.01, 0.02, 0.03, 0.01, -0.01, -0.03, -0.01, 0.02, 0.04];
    let counted = [1.0, 1.92596, 2.04, 2.08, -0.85198, -1.58168, -1.83521, 0.8946, 1.78379, 1.9796];
    let uncounted = [1.0, 1.92596, 2.04, 2.08, -1.62923, -1.806, -1.926, 1.05486, 1.90532, 2.05925];
    for (compat, from, expected) in [(true, 1, counted), (false, 1, counted), (false, 0, counted), (true, 0, uncounted)]
    {
        let all = stresses(compat, &strains[from..]);
        let got = &all[1 - from..];
        assert!(got.iter().zip(expected).all(|(s, e)| (s - e).abs() < 6e-6), "{compat} {from}: {got:?}");
    }
}

#[test]
fn stress_depends_on_the_committed_state_alone() {
    // OpenSees' flag depends on trial states (validation/opensees/traces_hht_trbdf2).
    for (name, law, amplitude) in all().into_iter().filter(|m| m.0 != "flag of OpenSees") {
        check_purity(name, law, amplitude);
    }
    check_purity("rounds of OpenSees", Material::new(series(Iteration::FixedIterations(3, 1e-12))), 0.1);
}

/// A repeated strain does not change the state.
#[test]
fn repeated_strain_keeps_the_state() {
    for (name, law, amplitude) in all() {
        let mut p = MaterialPoint::new(law);
        for strain in path(9, 300, amplitude) {
            let s = p.advance(strain);
            for _ in 0..2 {
                let again = p.advance(strain).value;
                assert!((again - s.value).abs() < 1e-12, "{name}: {again} after {} at {strain}", s.value);
            }
        }
    }
}

/// The components of a series have equal stresses, and their strains sum to the total.
#[test]
fn series_components_have_equal_stress() {
    let law = series(Iteration::Converged);
    let (mut whole, mut parts) = (
        MaterialPoint::new(Material::new(law)),
        [
            MaterialPoint::new(steel01()),
            MaterialPoint::new(steel02(Steel02::NO_ISOTROPIC, 0.0)),
            MaterialPoint::new(Material::new(Elastic::new(150.0))),
        ],
    );
    let probe = whole.law.probe(&["strains"]).unwrap();
    for strain in path(4, 500, 0.1) {
        let s = whole.advance(strain).value;
        let mut strains = [0.0; 3];
        whole.law.read(&probe.path, whole.state(), &mut strains);
        assert!((strains.iter().sum::<f64>() - strain).abs() < 1e-12);
        for (part, strain) in parts.iter_mut().zip(strains) {
            let own = part.advance(strain).value;
            assert!((own - s).abs() < 1e-10, "{own} and {s}");
        }
    }
}

/// A series returns to zero strain from every state, elastic or yielded, with one common stress.
#[test]
fn series_returns_to_zero_strain() {
    let elastic = || -> Material { Material::new(Elastic::new(150.0)) };
    let both: fn(&[Material]) -> Vec<(Material, i32)> = |laws| laws.iter().cloned().zip(1..).collect();
    let kinds = [
        [steel01(), elastic()],
        [steel02(Steel02::NO_ISOTROPIC, 0.0), elastic()],
        [steel01(), steel02(Steel02::NO_ISOTROPIC, 0.0)],
        [multi_linear(), elastic()],
    ];
    let mut failed = vec![];
    for (kind, laws) in kinds.iter().enumerate() {
        for seed in 1..=300 {
            // Amplitudes from a small fraction of the yield strain to a large multiple of it.
            let amplitude = 0.2 * 0.1f64.powi((seed % 7) as i32);
            let law: Material = Material::new(Series::new(both(laws), Iteration::Converged));
            let probe = law.probe(&["strains"]).unwrap();
            let (mut whole, mut parts) = (MaterialPoint::new(law), laws.clone().map(MaterialPoint::new));
            let mut stiffest = 0.0f64;
            'path: for (i, strain) in path(seed, 60, amplitude).into_iter().enumerate() {
                for strain in [strain, 0.0].into_iter().take(if i % 4 == 3 { 2 } else { 1 }) {
                    let Some(s) = whole.try_advance(strain) else {
                        failed.push((kind, seed, strain));
                        break 'path;
                    };
                    let mut strains = [0.0; 2];
                    whole.law.read(&probe.path, whole.state(), &mut strains);
                    // The round-off of forces scales with the largest stiffness times strain of the path.
                    stiffest = strains.iter().fold(stiffest, |most, e| most.max(200.0 * e.abs()));
                    assert!((strains.iter().sum::<f64>() - strain).abs() <= 1e-14 * stiffest);
                    for (part, strain) in parts.iter_mut().zip(strains) {
                        let own = part.advance(strain).value;
                        // The round-off of multilinear stresses scales with the points of the curve, up to 2.5.
                        let rounded = 1e-11 * stiffest + 2.5 * f64::EPSILON;
                        assert!((own - s).abs() <= rounded, "kind {kind}, path {seed}: {own} and {s}");
                    }
                }
            }
        }
    }
    assert!(failed.is_empty(), "{} paths: {:?}", failed.len(), &failed[..failed.len().min(5)]);
}

/// The elastic-plastic component takes all strain on its plateau, where its flexibility is infinite.
#[test]
fn series_component_takes_all_plateau_strain() {
    let parts: Vec<(Material, i32)> =
        vec![(Material::new(ElasticPP::new(200.0, 0.01, -0.01, 0.0)), 1), (Material::new(Elastic::new(100.0)), 2)];
    let mut p = MaterialPoint::new(Material::new(Series::new(parts, Iteration::Converged)));
    for (strain, stress) in [(0.015, 1.0), (0.05, 2.0), (0.2, 2.0), (0.185, 1.0), (-0.1, -2.0)] {
        let s = p.advance(strain).value;
        assert!((s - stress).abs() < 1e-9, "{s} for {stress} at {strain}");
    }
}

/// Masing's rule: the branch after a reversal is the envelope scaled by two.
#[test]
fn multilinear_branches_follow_masings_rule() {
    let (mut p, mut envelope) = (MaterialPoint::new(multi_linear()), MaterialPoint::new(multi_linear()));
    let top = p.advance(0.05).value;
    for strain in [0.001, 0.004, 0.01, 0.03, 0.05] {
        let first = envelope.trial(strain, 0.0, 0.0).value;
        let branch = p.trial(0.05 - 2.0 * strain, 0.0, 0.0).value;
        assert!((top - branch - 2.0 * first).abs() < 1e-12, "{branch} at {strain}");
    }
}

#[test]
fn failed_material_stays_failed() {
    let mut p = MaterialPoint::new(Material::new(MinMax::new((steel01(), 1), -0.05, 0.04, false)));
    assert!(p.trial(0.041, 0.0, 0.0).value == 0.0 && p.advance(0.03).value > 2.0, "a trial does not break it");
    assert_eq!((p.advance(0.04).value, p.advance(0.0).value, p.advance(0.03).value), (0.0, 0.0, 0.0));
}

#[test]
fn initial_stress_acts_at_zero_strain() {
    for stress in [-2.3, -0.4, 0.0, 1.1, 2.2] {
        let law = InitialState::stress((steel02(Steel02::NO_ISOTROPIC, 0.0), 1), stress).unwrap();
        let s = MaterialPoint::new(Material::new(law)).trial(0.0, 0.0, 0.0).value;
        assert!((s - stress).abs() < 1e-9, "{s} for {stress}");
    }
    let plastic: Material = Material::new(ElasticPP::new(200.0, 0.01, -0.01, 0.0));
    assert!(InitialState::stress((plastic, 1), 2.5).is_err(), "no strain has more than the yield stress");
    let s = MaterialPoint::new(steel02(Steel02::NO_ISOTROPIC, 0.7)).trial(0.0, 0.0, 0.0).value;
    assert!((s - 0.7).abs() < 1e-12);
}

fn damper(method: IntegrationMethod, alpha: f64) -> ViscousDamper {
    let (relative, absolute, max_halvings) = (1e-9, 1e-12, 20);
    ViscousDamper { k: 300.0, c: 14.0, alpha, gap: 0.0, method, relative, absolute, max_halvings, compat: false }
}

/// At a constant rate the spring force becomes constant, and the dashpot gives C vᵅ.
#[test]
fn damper_reaches_its_steady_force() {
    for method in
        [IntegrationMethod::DormandPrince, IntegrationMethod::AdamsBashforthMoulton, IntegrationMethod::Rosenbrock]
    {
        for alpha in [0.5, 1.0, 1.4] {
            let mut p = MaterialPoint::new(Material::new(damper(method, alpha)));
            let (rate, dt) = (-0.6f64, 0.02);
            let mut force = 0.0;
            for k in 1..400 {
                force = p.trial(rate * dt * f64::from(k), rate, dt).value;
                p.commit();
            }
            let steady = -14.0 * 0.6f64.powf(alpha);
            assert!((force - steady).abs() < 1e-6 * steady.abs(), "{method:?} {alpha}: {force} and {steady}");
        }
    }
}

#[test]
fn damping_tangent_matches_finite_difference() {
    for method in
        [IntegrationMethod::DormandPrince, IntegrationMethod::AdamsBashforthMoulton, IntegrationMethod::Rosenbrock]
    {
        for alpha in [0.5, 1.0, 1.4] {
            let mut p = MaterialPoint::new(Material::new(damper(method, alpha)));
            for (k, rate) in path(6, 200, 1.0).into_iter().enumerate() {
                let h = 1e-6;
                let (up, down) = (p.trial(0.0, rate + h, 0.01).value, p.trial(0.0, rate - h, 0.01).value);
                let s = p.trial(0.0, rate, 0.01);
                p.commit();
                let slope = (up - down) / (2.0 * h);
                let kink = (up - 2.0 * s.value + down).abs() > 1e-3 * h * slope.abs() || s.value.abs() < 1e-2;
                let error = (s.damping - slope).abs();
                assert!(kink || error < 1e-4 * slope.abs(), "{method:?} {alpha} step {k}: {} but {slope}", s.damping);
            }
        }
    }
}

#[test]
fn maxwell_relaxes() {
    let law = Maxwell { k: 200.0, c: 50.0, alpha: 1.0, length: 2.0, secant_damping: false, compat: false };
    let mut p = MaterialPoint::new(Material::new(law));
    let start = p.advance(0.1);
    assert!(
        (start.value - 20.0).abs() < 1e-12 && (start.tangent - 200.0).abs() < 1e-12,
        "elastic where no time passes"
    );
    // Time constant C / (L K) = 1/8.
    let later = p.trial(0.1, 0.0, 0.25);
    assert!((later.value - 20.0 * (-2.0f64).exp()).abs() < 1e-12);
    let h = 1e-6;
    let slope = (p.trial(0.1 + h, 0.0, 0.25).value - p.trial(0.1 - h, 0.0, 0.25).value) / (2.0 * h);
    assert!((later.tangent - slope).abs() < 1e-6);
}

/// Cycles of one range fail at damage 1; a half cycle adds 0.5 / (Δε/E0)^(1/m).
#[test]
fn fatigue_counts_half_cycles() {
    let p = FatigueParameters { d_max: 1.0, e0: 0.1, m: -0.5, limits: (-1.0, 1.0) };
    let mut point = MaterialPoint::new(Material::new(Fatigue::new((steel01(), 1), p)));
    // A range of 0.02 lasts (0.02 / 0.1)^-2 = 25 cycles; the damage of the first quarter cycle is negligible.
    let mut half_cycles = 0;
    let mut strain = 0.01;
    point.advance(strain);
    while half_cycles < 100 && point.advance(strain).value.abs() > 1e-6 {
        strain = -strain;
        point.advance(strain);
        half_cycles += 1;
    }
    assert!((48..=52).contains(&half_cycles), "{half_cycles}");
}

/// Numbers of openseespy 3.7.1 on the way to the break, in compression after it, and open: every fourth of eight steps to each strain.
#[test]
fn a_weld_breaks_and_carries_compression() {
    let script =
        "uniaxialMaterial SteelFractureDI 1 50. 55. 29000. 0.02 20. 0.925 0.15 0.05 1.0 0.05 1.0 150. 0.6 10. 1.0
        testUniaxialMaterial 1
        set from 0
        foreach to {0.001 -0.001 0.004 -0.003 0.006 -0.006 0.008 -0.012 0.012 -0.02 0.01 -0.015 0.005 -0.03 0.02} {
            for {set k 1} {$k <= 8} {incr k} {
                setStrain [expr {$from + ($to - $from) * $k / 8.}]
                if {$k % 4 == 0} { puts [getStress] }
            }
            set from $to
        }";
    let expected = [
        14.499999999987425,
        28.999973627596155,
        -2.629413025445615e-05,
        -28.99276477534142,
        42.79899905269253,
        53.86670332513413,
        -34.48511355503944,
        -56.59225496100688,
        37.59831746283249,
        53.83403158063897,
        -47.14910585268243,
        -60.177387999907374,
        42.692388288321546,
        56.56392695258494,
        -54.748082103059126,
        -66.37512916781259,
        50.171564896003616,
        63.21767886050665,
        -61.69993466739881,
        -75.33365099264239,
        0.0,
        0.0,
        0.0,
        -62.599945973418784,
        0.0,
        0.0,
        -0.5363652788316281,
        -71.29999999999892,
        0.0,
        0.0,
    ];
    let got = super::script::run(script).numbers();
    assert_eq!(got.len(), expected.len());
    for (i, (g, e)) in got.iter().zip(expected).enumerate() {
        assert!((g - e).abs() < 1e-9 * 50.0, "stress {i}: {g} {e}");
    }
}
