//! High damping rubber: Table 4.1 of the thesis, relaxation, tangents, energy, heat, softening.

use super::driver::{MaterialPoint, path};
use hysteron::material::hdr::{Compound, Parameters, Stack, Thermal};
use hysteron::material::{HdrRheology, Material, Mullins, Softening, Steel01};
use std::f64::consts::PI;

pub(super) fn compound(name: &str) -> Compound {
    Compound::parse(Compound::built_in(name).unwrap()).unwrap()
}

fn law(name: &str, temperature: f64) -> HdrRheology {
    HdrRheology::new(compound(name), temperature)
}

/// Strain and stress at every step of a path through corners at a constant rate, with `per` steps per unit strain.
fn drive(law: HdrRheology, corners: &[f64], rate: f64, per: f64) -> Vec<(f64, f64)> {
    let mut p = MaterialPoint::new(Material::new(law));
    let mut out = vec![(0.0, 0.0)];
    let mut at = 0.0f64;
    for &to in corners {
        let n = ((to - at).abs() * per).round().max(1.0);
        for k in 1..=n as usize {
            let strain = at + (to - at) * k as f64 / n;
            let s = p.trial(strain, 0.0, (to - at).abs() / n / rate).value;
            p.commit();
            out.push((strain, s));
        }
        at = to;
    }
    out
}

/// Dissipated work D, equivalent damping h_eq and modulus G_eq of Table 4.1, on the open path from the virgin state.
fn loop_measures(path: &[(f64, f64)]) -> [f64; 3] {
    let d: f64 = path.windows(2).map(|w| 0.5 * (w[0].1 + w[1].1) * (w[1].0 - w[0].0)).sum();
    let most = |sign: f64| path.iter().copied().max_by(|a, b| (sign * a.1).total_cmp(&(sign * b.1))).unwrap();
    let (hi, lo) = (most(1.0), most(-1.0));
    let g = (hi.1 - lo.1) / (hi.0 - lo.0);
    let amplitude = path.iter().fold(0.0f64, |m, p| m.max(p.0.abs()));
    [d, d / (2.0 * PI * g * amplitude * amplitude), g]
}

const LOOP: [f64; 3] = [1.75, -1.75, 0.0];

/// The nine rows of Table 4.1 with converged integration.
const CONVERGED: [(f64, f64, [f64; 3]); 9] = [
    (-30.0, 1.5, [13.79, 0.253, 2.84]),
    (-30.0, 5.5, [13.19, 0.235, 2.91]),
    (-30.0, 8.75, [13.10, 0.233, 2.92]),
    (-10.0, 1.5, [9.28, 0.249, 1.94]),
    (-10.0, 5.5, [9.01, 0.238, 1.97]),
    (-10.0, 8.75, [8.97, 0.236, 1.97]),
    (23.0, 1.5, [8.35, 0.267, 1.63]),
    (23.0, 5.5, [7.64, 0.225, 1.76]),
    (23.0, 8.75, [7.48, 0.218, 1.79]),
];

#[test]
fn table_4_1_is_that_of_converged_integration() {
    for (t, rate, expected) in CONVERGED {
        let got = loop_measures(&drive(law("HDR3", t), &LOOP, rate, 200.0));
        for ((g, e), digit) in got.iter().zip(expected).zip([0.005, 0.0005, 0.005]) {
            assert!((g - e).abs() <= 0.005 * e + digit, "{t} degC, {rate}/s: {got:?}, expected {expected:?}");
        }
    }
}

#[test]
fn stress_is_independent_of_step_size() {
    for (t, rate, _) in CONVERGED {
        let d = |per: f64| loop_measures(&drive(law("HDR3", t), &LOOP, rate, per))[0];
        let (coarse, fine) = (d(200.0), d(400.0));
        assert!((coarse - fine).abs() < 1e-3 * fine, "{t} degC, {rate}/s: {coarse} and {fine}");
        // The stress at the end of a ramp equals that of one step, to the tolerance of the integration.
        let end = |per: f64| drive(law("HDR3", t), &[1.75, -0.4], rate, per).last().unwrap().1;
        assert!((end(1e-9) - end(500.0)).abs() < 1e-6, "{t} degC, {rate}/s: {} and {}", end(1e-9), end(500.0));
    }
}

/// Overstress of HDR3 at -30 degC after a ramp at 5.5/s to a strain, and after holds of the given steps.
fn held(strain: f64, steps: &[f64]) -> f64 {
    let mut p = MaterialPoint::new(Material::new(law("HDR3", -30.0)));
    p.trial(strain, 0.0, strain / 5.5);
    p.commit();
    for &dt in steps {
        p.trial(strain, 0.0, dt);
        p.commit();
    }
    response(&p, "overstress")
}

fn response(p: &MaterialPoint, name: &str) -> f64 {
    let probe = p.law.probe(&[name]).unwrap();
    let mut out = [0.0];
    p.law.read(&probe.path, p.state(), &mut out);
    out[0]
}

#[test]
fn relaxation_is_independent_of_step_count() {
    for (strain, expected) in [(1.75, 0.3168), (1.0, 0.1336)] {
        let one = held(strain, &[1800.0]);
        assert!((one - expected).abs() < 6e-5, "{one} after the hold at {strain}");
        let few = held(strain, &[0.1, 1.0, 20.0, 1778.9]);
        let many = held(strain, &[0.6; 3000]);
        assert!((one - few).abs() < 1e-7 && (one - many).abs() < 1e-6, "{one}, {few}, {many}");
    }
    // The slider of the overstress reverses at 22.17 s.
    let slip = |t: f64| {
        let mut p = MaterialPoint::new(Material::new(law("HDR3", -30.0)));
        p.trial(1.75, 0.0, 1.75 / 5.5);
        p.commit();
        let before = p.state()[3];
        p.trial(1.75, 0.0, t);
        p.commit();
        before - p.state()[3]
    };
    assert!(slip(22.16).abs() < 1e-12 && slip(22.18) > 1e-7, "{} and {}", slip(22.16), slip(22.18));
}

#[test]
fn overstress_after_a_fast_ramp_relaxes() {
    for (t, expected) in [(-30.0, 3.48), (-10.0, 2.09), (23.0, 1.70)] {
        let mut p = MaterialPoint::new(Material::new(law("HDR3", t)));
        p.trial(1.75, 0.0, 1.75 / 5.5);
        p.commit();
        let peak = response(&p, "overstress");
        assert!((peak - expected).abs() < 0.006, "{t} degC: {peak}");
        p.trial(1.75, 0.0, 180.0);
        p.commit();
        let early = 1.0 - response(&p, "overstress") / peak;
        p.trial(1.75, 0.0, 1620.0);
        p.commit();
        let left = response(&p, "overstress") / peak;
        assert!((0.845..0.915).contains(&early), "{t} degC: {early} has relaxed after 180 s");
        assert!((0.045..0.095).contains(&left), "{t} degC: {left} is left after 1800 s");
    }
}

/// Laws with all options.
fn all() -> Vec<(&'static str, Material)> {
    let softening = Softening { excess: 0.4, strain: 0.5, power: None, healed: 0.0, time: 1.0, preload: 0.0 };
    let gradual = Softening { power: Some(2.5), ..softening };
    let hot = |name: &str, t: f64| HdrRheology {
        thermal: Some(Thermal::lumped(3.3, 900.0)),
        hold_ends: true,
        ..law(name, t)
    };
    let stack = Thermal::stack(&bearing());
    let linear = compound("HDR3").map(|p| Parameters { c1_oe: 0.0, tau_cr_oe: 0.0, c2_oe: 3.0, ..*p });
    let p = [3.0, 0.4, 0.02, 0.3, 1.0, 8.0, 0.0, 0.6, 1.5, 1.0];
    let newtonian = Compound::constant(Parameters::new(p).unwrap());
    let p = [3.0, 0.4, 0.02, 0.3, 3.0, 8.0, 0.5, 0.6, 1.5, 0.6];
    let thick = Compound::constant(Parameters::new(p).unwrap());
    vec![
        ("HDR3, cold", Material::new(law("HDR3", -30.0))),
        ("HDR2, in between", Material::new(law("HDR2", 3.7))),
        ("heated", Material::new(hot("HDR3", -22.0))),
        ("heated in layers", Material::new(HdrRheology { thermal: Some(stack), ..hot("HDR2", -5.0) })),
        ("heated and softened", Material::new(HdrRheology { softening: Some(softening), ..hot("HDR2", -30.0) })),
        ("linear overstress", Material::new(HdrRheology::new(linear, 10.0))),
        ("linear dashpot, no second spring", Material::new(HdrRheology::new(newtonian, 0.0))),
        ("weakly nonlinear dashpot", Material::new(HdrRheology::new(thick, 0.0))),
        ("force", Material::new(HdrRheology { area: 57600.0, height: 1.3, ..law("HDR2", 23.0) })),
        ("softened steel", Material::new(Mullins::new((Material::new(steel()), 1), softening))),
        ("gradually softened steel", Material::new(Mullins::new((Material::new(steel()), 1), gradual))),
    ]
}

fn steel() -> Steel01 {
    Steel01 { fy: 0.5, e0: 20.0, b: 0.02, a: Steel01::NO_ISOTROPIC }
}

/// A bearing of six layers of 5 mm; N, mm, s, K.
pub fn bearing() -> Stack {
    Stack {
        layers: 6,
        rubber: 5.0,
        steel: 2.3,
        plate: 20.0,
        rubber_properties: (0.25, 1.99),
        steel_properties: (50.0, 3.39),
        film: 0.01,
    }
}

/// Pseudo-random time steps from a microsecond to half an hour.
fn pace(k: usize) -> f64 {
    10f64.powf(-6.0 + 9.25 * ((k as f64 * 0.754_877_666).fract()))
}

#[test]
fn tangent_matches_finite_difference() {
    for (name, law) in all() {
        let mut p = MaterialPoint::new(law);
        let (mut tested, mut worst) = (0, 0.0f64);
        for (k, strain) in path(17, 500, 2.0).into_iter().enumerate() {
            let dt = if k % 3 == 0 { pace(k) } else { 0.01 };
            let h = 2e-6;
            let value = |p: &mut MaterialPoint, x: f64| p.trial(x, 0.0, dt).value;
            let (up, down) = (value(&mut p, strain + h), value(&mut p, strain - h));
            let (more, less) = (value(&mut p, strain + 2.0 * h), value(&mut p, strain - 2.0 * h));
            let s = p.trial(strain, 0.0, dt);
            let (near, far) = ((up - down) / (2.0 * h), (more - less) / (4.0 * h));
            if (near - far).abs() < 2e-4 * near.abs() {
                tested += 1;
                worst = worst.max((s.tangent - near).abs() / near.abs());
            }
            p.commit();
        }
        assert!(tested > 350, "{name}: only {tested} points away from kinks");
        assert!(worst < 1e-3, "{name}: tangent off by {worst}");
    }
}

#[test]
fn any_history_dissipates_and_stays_finite() {
    for (name, law) in all() {
        for seed in 1..6 {
            let mut p = MaterialPoint::new(law.clone());
            let mut heat = 0.0;
            for (k, strain) in path(seed, 400, 2.5).into_iter().enumerate() {
                let dt = pace(k * seed as usize);
                let s = p.trial(if k % 7 == 0 { 0.9 * strain } else { strain }, 0.0, dt);
                p.commit();
                assert!(s.value.is_finite() && s.tangent.is_finite(), "{name}, step {k}");
                if name.contains("steel") {
                    continue;
                }
                let now = response(&p, "heat");
                // Cooling springs become stiffer and absorb heat, which is not dissipation.
                if !name.contains("heated") {
                    assert!(now >= heat - 1e-12 * now, "{name}, step {k}: {} is dissipated", now - heat);
                }
                heat = now;
            }
        }
    }
}

#[test]
fn every_branch_dissipates_energy() {
    let p = |x: [f64; 10]| Compound::constant(Parameters::new(x).unwrap());
    for (name, compound) in [
        ("slider of the equilibrium", p([7.0, 0.0, 0.0, 0.4, 3.0, 0.0, 0.0, 0.0, 1.0, 0.2])),
        ("dashpot", p([0.0, 0.0, 0.0, 0.0, 3.0, 0.0, 2.0, 0.0, 1.5, 0.25])),
        ("dashpot and slider", p([0.0, 0.0, 0.0, 0.0, 3.0, 9.0, 0.5, 0.7, 1.5, 0.25])),
    ] {
        let mut p = MaterialPoint::new(Material::new(HdrRheology::new(compound, 0.0)));
        let (mut heat, mut least) = (0.0, f64::INFINITY);
        for (k, strain) in path(23, 1500, 2.0).into_iter().enumerate() {
            p.trial(strain, 0.0, if k % 5 == 0 { pace(k) } else { 0.02 });
            p.commit();
            let now = response(&p, "heat");
            least = least.min(now - heat);
            heat = now;
        }
        assert!(least >= -1e-12 * heat, "{name}: {least}");
    }
}

/// Work of a fine path by Simpson's rule with the midpoint of each step.
fn work(p: &mut MaterialPoint, strains: &[f64], dt: f64) -> f64 {
    let (mut at, mut stress, mut work) = (0.0, 0.0, 0.0);
    for &strain in strains {
        // Two half steps equal one step, so the midpoint has a stress of the same path.
        let middle = p.trial(0.5 * (at + strain), 0.0, 0.5 * dt).value;
        let end = p.trial(strain, 0.0, dt).value;
        p.commit();
        work += (stress + 4.0 * middle + end) * (strain - at) / 6.0;
        (at, stress) = (strain, end);
    }
    work
}

#[test]
fn work_equals_stored_and_lost_heat() {
    for (name, law) in all().into_iter().filter(|(name, _)| !name.contains("soft")) {
        // A step uses the temperature of its middle, so the accuracy of a path depends on the step size.
        let n = if name.contains("heated") { 16_000 } else { 4_000 };
        let strains: Vec<f64> = (1..=n).map(|k| 1.5 * (6.0 * f64::from(k) / f64::from(n)).sin()).collect();
        let height = if name == "force" { 1.3 } else { 1.0 };
        let strains: Vec<f64> = strains.iter().map(|s| s * height).collect();
        let mut p = MaterialPoint::new(law);
        let work = work(&mut p, &strains, 1.5 / f64::from(n));
        let [heat, elastic] = ["heat", "stored"].map(|name| response(&p, name));
        let [stored, lost] = ["heatStored", "heatLost"].map(|name| response(&p, name));
        assert!((work - heat - elastic).abs() < 1e-6 * work, "{name}: work {work}, heat {heat}, elastic {elastic}");
        assert!((heat - stored - lost).abs() < 1e-12 * work, "{name}");
        if name.contains("heated") {
            assert!(stored > 0.5 * heat && lost > 0.0, "{name}: {stored} and {lost} of {heat}");
        }
    }
}

#[test]
fn conduction_matches_slab_and_composite_solutions() {
    // Without plates and with ambient ends, a slab with a constant source has the parabola q h^2/(8 k).
    let slab = Stack { layers: 12, steel: 0.0, plate: 0.0, film: 1e9, rubber: 2.5, ..bearing() };
    let law = |thermal| HdrRheology { thermal: Some(thermal), hold_ends: true, ..law("HDR3", 23.0) };
    let mut p = MaterialPoint::new(Material::new(law(Thermal::stack(&slab))));
    let (mut last, mut power) = (0.0, 0.0);
    for k in 1..=20_000 {
        p.trial(0.5 * (0.25 * f64::from(k)).sin(), 0.0, 0.5);
        p.commit();
        let heat = response(&p, "heat");
        power = if k > 10_000 { power + heat - last } else { 0.0 };
        last = heat;
    }
    let q = power / 5000.0;
    let probe = p.law.probe(&["temperatures"]).unwrap();
    let mut profile = vec![0.0; probe.len()];
    p.law.read(&probe.path, p.state(), &mut profile);
    let top = profile.iter().fold(0.0f64, |m, x| m.max(*x)) - 23.0;
    let expected = q * 30.0 * 30.0 / (8.0 * 0.25);
    assert!((top - expected).abs() < 0.01 * expected, "{top} K, expected {expected}");
    let mean = response(&p, "temperature") - 23.0;
    assert!((mean - 2.0 / 3.0 * expected).abs() < 0.01 * expected, "mean {mean} K");
    // After a fast test the heat is in the rubber; conduction then heats the steel towards the composite's
    // temperature.
    let insulated = Stack { film: 0.0, ..bearing() };
    let mut p = MaterialPoint::new(Material::new(law(Thermal::stack(&insulated))));
    for k in 1..=200 {
        p.trial(1.75 * (0.02 * PI * f64::from(k)).sin(), 0.0, 0.02);
        p.commit();
    }
    p.trial(0.0, 0.0, 1e7);
    p.commit();
    let composite = (6.0 * 5.0 * 1.99 + (5.0 * 2.3 + 40.0) * 3.39) / 30.0;
    let rise = response(&p, "temperature") - 23.0;
    assert!((rise - response(&p, "heat") / composite).abs() < 1e-6, "{rise}");
}

#[test]
fn virgin_rubber_is_stiffer_once() {
    let softening = Softening { excess: 0.5, strain: 0.4, power: None, healed: 0.6, time: 3600.0, preload: 0.0 };
    let law = HdrRheology { softening: Some(softening), ..law("HDR3", 23.0) };
    let wrapped = Mullins::new((Material::new(self::law("HDR3", 23.0)), 1), softening);
    let mut p = MaterialPoint::new(Material::new(law.clone()));
    let mut q = MaterialPoint::new(Material::new(wrapped));
    let mut plain = MaterialPoint::new(Material::new(self::law("HDR3", 23.0)));
    let mut ratios = vec![];
    for k in 1..=600 {
        let strain = 1.75 * (PI * f64::from(k) / 100.0).sin();
        let (a, b) = (p.trial(strain, 0.0, 0.01), q.trial(strain, 0.0, 0.01));
        p.commit();
        q.commit();
        assert!((a.value - b.value).abs() < 1e-12 && (a.tangent - b.tangent).abs() < 1e-9, "wrapped or inside");
        let soft = plain.trial(strain, 0.0, 0.01).value;
        plain.commit();
        if k % 200 == 20 {
            ratios.push(a.value / soft);
        }
    }
    let virgin = 1.0 + 0.5 * (-1.75 * (0.2 * PI).sin() / 0.4f64).exp();
    assert!((ratios[0] - virgin).abs() < 1e-9 && ratios[1] < 1.0064 && ratios[2] < 1.0064, "{ratios:?}");
    // A day of rest recovers most of the excess; preloaded rubber has none.
    let factor = |p: &MaterialPoint| response(p, "factor");
    let soft = factor(&p);
    p.trial(0.0, 0.0, 86400.0);
    p.commit();
    let expected = 1.0 + 0.5 * (-0.4 * 1.75f64 / 0.4).exp();
    assert!(soft < 1.007 && (factor(&p) - expected).abs() < 1e-6, "{soft}, then {}", factor(&p));
    let preloaded = HdrRheology { softening: Some(Softening { preload: 2.5, ..softening }), ..law };
    assert!(factor(&MaterialPoint::new(Material::new(preloaded))) < 1.001);
}

#[test]
fn compounds_have_the_range_of_their_tables() {
    let c = compound("HDR3");
    let p = c.at(-20.0).unwrap();
    assert!((p.c1_eq - 11.12).abs() < 1e-12 && (p.n - 0.2495).abs() < 1e-12);
    assert_eq!(c.at(23.0).unwrap().a, 1.45);
    assert!(c.at(23.1).is_err() && c.at(-30.5).is_err() && c.at(f64::NAN).is_err());
    for text in ["", "1 2 3", "0 1 1 1 1 3 1 1 1 1 1.2", "0 1 1 1 1 3 1 1 1 1 .2\n0 1 1 1 1 3 1 1 1 1 .2"] {
        assert!(Compound::parse(text).is_err(), "{text}");
    }
}

#[test]
fn temperature_beyond_the_table_is_held_or_an_error() {
    let hot = |hold_ends| HdrRheology { thermal: Some(Thermal::lumped(0.01, 1e9)), hold_ends, ..law("HDR3", 23.0) };
    let mut p = MaterialPoint::new(Material::new(hot(true)));
    p.trial(1.5, 0.0, 0.3);
    p.commit();
    assert!(response(&p, "temperature") > 40.0);
    let law: Material = Material::new(hot(false));
    let mut state = vec![0.0; law.state_len()];
    law.init(&mut state);
    let mut next = state.clone();
    let strain = hysteron::material::Strain { value: 1.5, rate: 0.0, dt: 0.3 };
    let error = law.update(&state, strain, &mut next).unwrap_err();
    assert!(error.0.contains("known from -30 to 23"), "{}", error.0);
}
