//! Modifiers of a bearing: consistent tangents, and the effect of each.

use super::driver::{SingleElement, difference, path};
use super::learned::{AGING, CURVE, SOFTENING, law};
use hysteron::element::amendment::{
    Amended, Amendment, Axial, Bristles, Cavitation, Coupling, Creep, Damping, Degradation, Friction, Gap, Heating,
    Learned, Mullins, Overstress, PeakOriented, Pinching, Pressure, Relaxation, Share, Sides, Sliding, Slip,
    Stiffening, Temperature, Yielding,
};
use hysteron::element::axes::Orientation;
use hysteron::element::bearing::{BoucWenShear, Link, PlaneBearing, SpaceBearing};
use hysteron::element::{BarOptions, Element, ElementError, ElementInput, ElementOutput, Histories, MatrixMask, Truss};
use hysteron::material::{Elastic, Material, Softening, Steel01};
use nalgebra::Vector3;
use std::sync::Arc;

fn shear() -> BoucWenShear {
    let k = 8000.0;
    BoucWenShear {
        k0: 0.88 * k,
        qd: 40.0,
        k2: 0.12 * k,
        k3: 0.0,
        mu: 3.0,
        eta: 2.0,
        beta: 0.5,
        gamma: 0.5,
        compat: false,
    }
}

fn elastic(e: f64) -> (Material, i32) {
    (Material::new(Elastic::new(e)), 1)
}

fn plane() -> impl Element + 'static {
    let (axes, length) = Orientation::default().of_link(Vector3::zeros(), Vector3::new(0.05, 0.3, 0.0), true).unwrap();
    PlaneBearing::new(shear(), Link::new(&axes, length, 0.3), [elastic(1e5), elastic(6000.0)], 0.0, false)
}

fn space() -> impl Element + 'static {
    let line = Vector3::new(0.02, -0.05, 0.3);
    let (axes, length) = Orientation::default().of_link(Vector3::zeros(), line, false).unwrap();
    let materials = [elastic(1e5), elastic(900.0), elastic(6000.0), elastic(5000.0)];
    SpaceBearing::new(shear(), Link::new(&axes, length, 0.3), materials, 0.0, false)
}

const PART: Share = Share { stiffness: 960.0, elastic: 0.3, hysteretic: 0.8, of_strength: false };

const HEATING: Heating =
    Heating { softening: 0.01, capacity: 0.05, cooling: 30.0, conduction: 0.2, half_width: f64::INFINITY, share: PART };

/// Softening without healing.
fn softening(excess: f64, strain: f64) -> Softening {
    Softening { excess, strain, power: Some(2.0), healed: 0.0, time: f64::INFINITY, preload: 0.0 }
}

fn laws() -> Vec<Arc<dyn Amendment>> {
    let share = PART;
    vec![
        Arc::new(Temperature { softening: 0.01, at: -10.0, reference: 20.0, share }),
        Arc::new(Heating { capacity: 0.2, cooling: 3.0, conduction: f64::INFINITY, ..HEATING }),
        Arc::new(HEATING),
        Arc::new(Heating { half_width: 0.03, ..HEATING }),
        Arc::new(Degradation { loss: 0.5, energy: 2.0, share }),
        Arc::new(Degradation { loss: 0.5, energy: 2.0, share: Share::strength_beside(960.0) }),
        Arc::new(Temperature { softening: 0.01, at: -30.0, reference: 20.0, share: Share::strength_beside(900.0) }),
        Arc::new(Mullins { softening: Softening { healed: 1.0, time: 50.0, ..softening(0.4, 0.01) }, share }),
        Arc::new(Stiffening { factor: 2e4, from: 0.01, power: 2.0 }),
        Arc::new(Overstress { force: 30.0, speed: 0.5, power: 0.3, stiffness: 5000.0 }),
        Arc::new(Axial { critical: 400.0, power: 2.0, width: 0.2, load: None, reference: 0.0, share }),
        Arc::new(Coupling { law: shear() }),
        Arc::new(Pinching { depth: 0.6, width: 0.4, onset: 0.0, share }),
        Arc::new(Slip { size: 0.01, growth: 0.1, width: 10.0, share }),
        Arc::new(Yielding { force: 30.0, stiffness: 8000.0, hardening: 0.05 }),
        Arc::new(PeakOriented { force: 30.0, stiffness: 8000.0, hardening: 0.05, unloading: 0.4 }),
        Arc::new(Pressure { reference: 150.0, power: 0.8, lever: 900.0, load: None, share }),
        Arc::new(Friction { force: 15.0, stiffness: 4e4 }),
        Arc::new(Bristles { force: 15.0, stiffness: 4e3, breakaway: 10.0, speed: 0.8, slip: 0.02, rest: 0.03 }),
        Arc::new(Sliding { force: 15.0, speed: 0.3 }),
        Arc::new(Relaxation { strength: 0.6, time: 0.02, decades: 2.4 }),
        Arc::new(Creep { compliance: 1e-4, time: 0.02, decades: 2.4 }),
        Arc::new(Gap { at: 0.03, stiffness: 5e5, power: 1.5, damping: 0.1, sides: Sides::Both }),
        Arc::new(Damping { coefficient: 10.0, power: 0.5 }),
        Arc::new(Learned::new(law(AGING).unwrap(), vec![]).unwrap()),
        Arc::new(Learned::new(law(SOFTENING).unwrap(), vec![]).unwrap()),
        Arc::new(Learned::new(law(CURVE).unwrap(), vec![]).unwrap()),
    ]
}

fn motion(n: usize, seed: u64, steps: usize) -> Vec<Vec<f64>> {
    let per_node = n / 2;
    let size = |i: usize| match (n, i % per_node) {
        (6, 0) | (12, 0 | 1) => 0.06,
        (_, k) if k + 1 == per_node || (n == 12 && k >= 3) => 0.01,
        _ => 0.002,
    };
    let walks: Vec<Vec<f64>> = (0..n).map(|i| path(seed + i as u64, steps, size(i))).collect();
    (0..steps).map(|k| walks.iter().map(|w| w[k]).collect()).collect()
}

#[test]
fn tangent_matches_finite_difference() {
    for law in laws() {
        let around = |inner: Arc<dyn Element>| SingleElement::new(Amended::new(inner, law.clone(), &[]).unwrap());
        for mut e in [around(Arc::new(plane())), around(Arc::new(space()))] {
            let n = e.element.dofs();
            let (mut tested, steps) = (0, motion(n, 31, 120));
            for (k, u) in steps.iter().enumerate() {
                let (_, tangent) = e.trial(u, &vec![0.0; n]);
                let (near, far) = (e.difference(u, 1e-8), e.difference(u, 4e-8));
                if difference(&near, &far) < 1e-5 {
                    tested += 1;
                    let error = difference(&tangent, &near);
                    assert!(error < 2e-5, "{}, {n} degrees of freedom, step {k}: {error:.1e}", law.name());
                }
                e.trial(u, &vec![0.0; n]);
                e.commit();
            }
            assert!(tested > 80, "{}: only {tested} states away from kinks", law.name());
        }
    }
}

/// Shear force of a bearing in the plane along a history of its upper node.
fn force(law: Arc<dyn Amendment>, history: impl Iterator<Item = f64>) -> Vec<f64> {
    force_of(shear(), law, history)
}

fn force_of(shear: BoucWenShear, law: Arc<dyn Amendment>, history: impl Iterator<Item = f64>) -> Vec<f64> {
    let (axes, length) = Orientation::default().of_link(Vector3::zeros(), Vector3::new(0.0, 0.3, 0.0), true).unwrap();
    let inner = PlaneBearing::new(shear, Link::new(&axes, length, 0.5), [elastic(1e5), elastic(6e3)], 0.0, false);
    let mut e = SingleElement::new(Amended::new(Arc::new(inner), law, &[]).unwrap());
    history
        .map(|u| {
            let f = e.force(&[0.0, 0.0, 0.0, u, 0.0, 0.0]);
            e.commit();
            f[3]
        })
        .collect()
}

fn cycles(amplitude: f64, n: usize) -> impl Iterator<Item = f64> {
    (0..100 * n).map(move |i| amplitude * (std::f64::consts::TAU * i as f64 / 100.0).sin())
}

fn peak(f: &[f64], cycle: usize) -> f64 {
    f[100 * cycle..100 * (cycle + 1)].iter().fold(0.0, |m: f64, x| m.max(*x))
}

#[test]
fn each_modifier_has_its_effect() {
    let all = Share::default();
    let plain = force(Arc::new(Temperature { softening: 0.01, at: 0.0, reference: 0.0, share: all }), cycles(0.05, 3));

    let cold = force(Arc::new(Temperature { softening: 0.01, at: -30.0, reference: 0.0, share: all }), cycles(0.05, 3));
    assert!(cold.iter().zip(&plain).all(|(c, p)| (c - 0.3f64.exp() * p).abs() < 1e-9));

    let warm = force(
        Arc::new(Heating { capacity: 0.5, cooling: f64::INFINITY, conduction: f64::INFINITY, share: all, ..HEATING }),
        cycles(0.05, 3),
    );
    assert!(peak(&warm, 0) > peak(&warm, 1) && peak(&warm, 1) > peak(&warm, 2));

    // At the end of the slack the device has moved less by the slack; the elastic part has the full displacement.
    let elastic = Share { stiffness: 960.0, ..all };
    for (size, growth) in [(0.02, 0.0), (0.0, 0.4)] {
        let slips = force(Arc::new(Slip { size, growth, width: 1.0, share: elastic }), cycles(0.05, 3));
        let shorter = force(Arc::new(Slip { size: 0.0, growth: 0.0, width: 1.0, share: elastic }), cycles(0.04, 3));
        for i in [225, 275] {
            let expected = shorter[i] + 960.0 * 0.01f64.copysign(shorter[i]);
            assert!((slips[i] - expected).abs() < 1e-2 * expected.abs(), "{size}: {} {expected}", slips[i]);
        }
        // The hysteretic part stays near zero over the length of the slack.
        let z = |i: usize| slips[i] - 960.0 * 0.05 * (std::f64::consts::TAU * i as f64 / 100.0).sin();
        let slipping = (225..275).filter(|i| z(*i).abs() < 2.0).count();
        assert!(slipping >= 8, "{slipping}");
    }
    let none = force(Arc::new(Slip { size: 0.0, growth: 0.0, width: 1.0, share: elastic }), cycles(0.05, 3));
    assert!(none.iter().zip(&plain).all(|(a, b)| (a - b).abs() < 1e-9));

    let virgin = force(
        Arc::new(Mullins { softening: softening(0.3, 1e-6), share: all }),
        cycles(0.05, 2).map(|u| u.abs().max(0.0)),
    );
    // At half the amplitude the first loading is stiffer than the second.
    assert!((virgin[8] / plain[8] - 1.3).abs() < 1e-9);
    assert!(virgin[108] < 1.15 * plain[108]);

    let fast = force(
        Arc::new(Overstress { force: 10.0, speed: 1.0, power: 0.25, stiffness: 1e5 }),
        (0..200).map(|i| 0.01 * 0.1 * i as f64),
    );
    let slow = force(
        Arc::new(Overstress { force: 10.0, speed: 1.0, power: 0.25, stiffness: 1e5 }),
        (0..2000).map(|i| 0.01 * 0.01 * i as f64),
    );
    // A constant speed v gives the overstress F (v / v0)^n.
    let steady = 10.0 * (0.1f64.powf(0.25) - 0.01f64.powf(0.25));
    assert!((fast[199] - slow[1990] - steady).abs() < 1e-6, "{} {steady}", fast[199] - slow[1990]);

    let yields = force(Arc::new(Yielding { force: 20.0, stiffness: 8000.0, hardening: 0.0 }), cycles(0.05, 1));
    assert!((peak(&yields, 0) - 20.0).abs() < 1e-9);
}

/// A factor on the strength changes the strength and not the stiffness.
#[test]
fn strength_factor_keeps_stiffness() {
    let untouched = || Arc::new(Temperature { softening: 0.0, at: 0.0, reference: 0.0, share: Share::default() });
    let share = Share::strength_beside(shear().k2);
    let history = || path(11, 400, 0.03).into_iter();
    for factor in [0.5, 1.4f64] {
        let law = Temperature { softening: -factor.ln(), at: 1.0, reference: 0.0, share };
        let weaker = force(Arc::new(law), history());
        let right = force_of(BoucWenShear { qd: factor * shear().qd, ..shear() }, untouched(), history());
        let whole = right.iter().fold(0.0f64, |m, f| m.max(f.abs()));
        assert!(whole > factor * shear().qd);
        for (k, (a, b)) in weaker.iter().zip(&right).enumerate() {
            assert!((a - b).abs() < 1e-6 * whole, "{factor} {k}: {a} {b}");
        }
    }
}

/// A brace whose strength follows its temperature, beside an elastic-plastic spring of that strength: the force stays at rest
/// while the strength comes back.
#[test]
fn force_stays_at_rest_while_strength_comes_back() {
    let (stiffness, strength, capacity, cooling) = (1000.0, 10.0, 0.03, 2.0);
    let steel = Material::new(Steel01 { fy: strength, e0: stiffness, b: 0.0, a: Steel01::NO_ISOTROPIC });
    let options = BarOptions { area: 1.0, rho: 0.0, consistent: false, rayleigh: false };
    let brace = Truss::new(steel, 1, &[1.0, 0.0], 2, &[0.0, 0.0], options).unwrap();
    let share = Share::strength_beside(0.0);
    let law = Heating { capacity, cooling, conduction: f64::INFINITY, share, ..HEATING };
    let mut e = SingleElement::new(Amended::new(Arc::new(brace), Arc::new(law), &[1]).unwrap());
    let moved = (0..200).map(|i| 0.05 * (f64::from(i) / 20.0).sin());
    let rest = std::iter::repeat_n(0.05 * (199.0f64 / 20.0).sin(), 300);
    let (mut plastic, mut rise, mut before) = (0.0f64, 0.0f64, 0.0f64);
    let (mut coldest, mut warmest) = (f64::INFINITY, 0.0f64);
    for u in moved.chain(rest).chain((0..200).map(|i| 0.05 * (10.0 + f64::from(i) / 20.0).sin())) {
        let limit = strength * (-0.01 * rise).exp();
        let f = (stiffness * (u - plastic)).clamp(-limit, limit);
        plastic = u - f / stiffness;
        rise = (rise + f * (u - before) / capacity) / (1.0 + 0.01 / cooling);
        before = u;
        (coldest, warmest) = (coldest.min(rise), warmest.max(rise));
        let amended = e.force(&[0.0, 0.0, u, 0.0])[2];
        e.commit();
        assert!((amended - f).abs() < 0.02 * strength, "{u}: {amended} {f}");
    }
    assert!(warmest > 30.0, "{warmest}");
}

/// A brace with the modifier yields like one with a yielding material.
#[test]
fn brace_modifier_yields_like_a_yielding_material() {
    let (modulus, area, strength, hardening) = (2.0e5, 0.3, 250.0, 0.05);
    let brace = |law: Material| {
        let options = BarOptions { area, rho: 0.0, consistent: false, rayleigh: false };
        Truss::new(law, 1, &[3.0, 4.0], 3, &[0.0, 0.0], options).unwrap()
    };
    let stiffness = modulus * area / 5.0;
    let steel = Steel01 { fy: strength, e0: modulus, b: hardening, a: Steel01::NO_ISOTROPIC };
    let law = Arc::new(Yielding { force: strength * area, stiffness, hardening });
    let amended = Amended::new(Arc::new(brace(Material::new(Elastic::new(modulus)))), law, &[]).unwrap();
    assert!((amended.initial_stiffness()[0] - stiffness).abs() < 1e-9 * stiffness);
    let (mut amended, mut yields) = (SingleElement::new(amended), SingleElement::new(brace(Material::new(steel))));
    let mut largest = 0.0f64;
    for (k, u) in path(5, 60, 0.05).into_iter().enumerate() {
        let disp = [0.0, 0.0, 0.0, u, 0.3 * u, 0.1];
        let (a, b) = (amended.force(&disp), yields.force(&disp));
        assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-9 * strength * area), "{k}: {a:?} {b:?}");
        largest = a.iter().fold(largest, |most, f| most.max(f.abs()));
        amended.commit();
        yields.commit();
    }
    assert!(largest > 0.6 * strength * area);
}

const BRISTLES: Bristles = Bristles {
    force: 20.0,
    stiffness: 2e4,
    breakaway: 0.0,
    speed: f64::INFINITY,
    slip: f64::INFINITY,
    rest: f64::INFINITY,
};

/// Force of bristles along a path in steps of 0.01 s.
fn added_by_bristles(law: Bristles, path: &dyn Fn(usize) -> f64) -> Vec<f64> {
    let plain = Temperature { softening: 0.0, at: 0.0, reference: 0.0, share: Share::default() };
    let plain = force(Arc::new(plain), (0..400).map(path));
    force(Arc::new(law), (0..400).map(path)).into_iter().zip(plain).map(|(a, p)| a - p).collect()
}

/// At a steady speed v the breakaway force is F_b / (1 + v τ/L). After a rest of time T from there its lost part is e^(-T/τ) of
/// what it was.
#[test]
fn bristles_stick_at_rest() {
    let (slip, rest) = (0.05, 0.4);
    let law = Bristles { stiffness: 1e7, breakaway: 8.0, slip, rest, ..BRISTLES };
    for speed in [0.02, 0.4] {
        let moved = |i: usize| 0.01 * speed * if i <= 300 { i as f64 } else { (i as f64 - 70.0).max(300.0) };
        let f = added_by_bristles(law, &moved);
        let steady = 8.0 / (1.0 + speed * rest / slip);
        // The distance to 99 % of the steady state is some slips long.
        assert!((f[300] - 20.0 - steady).abs() < 0.02 * steady, "{speed}: {} {steady}", f[300]);
        let stuck = 8.0 - (8.0 - (f[300] - 20.0)) * (-0.7f64 / rest).exp();
        // One increment from rest wears a part of it off.
        let worn = 8.0 * 0.01 * speed / slip;
        assert!((f[371] - 20.0 - stuck).abs() < worn, "{speed}: {} {stuck}", f[371]);
        assert!(f[371] > f[300] + 1.0 || speed < 0.1);
    }
    // Without a time to come back the force breaks away once.
    let once = Bristles { rest: f64::INFINITY, ..law };
    let f = added_by_bristles(once, &|i| 0.004 * if i <= 200 { i as f64 } else { (i as f64 - 100.0).max(200.0) });
    assert!((f[1] - 28.0).abs() < 0.7 && (f[200] - 20.0).abs() < 1e-4 && (f[320] - 20.0).abs() < 1e-4);
}

/// The time step is 0.01 s.
#[test]
fn bristles_bend_and_slip() {
    let bristles = |breakaway, speed| Bristles { breakaway, speed, ..BRISTLES };
    let amended = added_by_bristles;
    // Constant speed, then reversal: the force is -F + 2 F exp(-k w / F) after the distance w.
    let there_and_back = |i: usize| 1e-3 * if i <= 200 { i as f64 } else { 400.0 - i as f64 };
    let f = amended(bristles(0.0, 1.0), &there_and_back);
    assert!((f[200] - 20.0).abs() < 1e-9);
    for (i, way) in [(201, 1e-3), (205, 5e-3), (230, 3e-2)] {
        let expected = -20.0 + 40.0 * (-2e4 * way / 20.0f64).exp();
        assert!((f[i] - expected).abs() < 1e-6, "{i}: {} {expected}", f[i]);
    }
    // Lower speed, Stribeck's peak: 0.1 m/s and 0.01 m/s against a speed of 0.1 m/s.
    for slower in [1.0, 10.0] {
        let f = amended(bristles(8.0, 0.1), &|i| 1e-3 / slower * i as f64);
        let expected = 20.0 + 8.0 * (-(1.0 / slower).powi(2)).exp();
        assert!((f[399] - expected).abs() < 1e-6, "{} {expected}", f[399]);
    }
}

/// The time step is 0.01 s.
#[test]
fn smoothed_friction_matches_friction_at_constant_speed() {
    let ramp = |speed: f64| {
        let path = || (0..100).map(move |i| 0.01 * speed * f64::from(i));
        let plain = Temperature { softening: 0.0, at: 0.0, reference: 0.0, share: Share::default() };
        let sliding = Sliding { force: 20.0, speed: 0.03 };
        force(Arc::new(sliding), path())[99] - force(Arc::new(plain), path())[99]
    };
    for (speed, expected) in [(0.04, 16.0), (-0.04, -16.0), (3.0, 20.0 / (1.0 + 1e-4f64).sqrt())] {
        assert!((ramp(speed) - expected).abs() < 1e-9, "{speed}: {}", ramp(speed));
    }
}

/// The force relaxes after a deformation step with its time constants; a slow motion causes no overstress.
#[test]
fn overstress_relaxes_with_its_time_constants() {
    let plain = || Temperature { softening: 0.0, at: 0.0, reference: 0.0, share: Share::default() };
    let step = || (0..300).map(|i| if i > 0 { 0.04 } else { 0.0 });
    let more = |law: Relaxation| {
        let [relaxing, plain] = [force(Arc::new(law), step()), force(Arc::new(plain()), step())];
        relaxing.iter().zip(&plain).map(|(r, p)| r / p - 1.0).collect::<Vec<f64>>()
    };
    let one = more(Relaxation { strength: 0.5, time: 0.4, decades: 0.0 });
    for i in [2, 50, 299] {
        let expected = one[1] * (-0.01 * (i - 1) as f64 / 0.4).exp();
        assert!((one[i] - expected).abs() < 1e-12 && (0.45..0.5).contains(&one[1]), "{i}: {} {expected}", one[i]);
    }
    let many = more(Relaxation { strength: 0.5, time: 0.1, decades: 3.0 });
    let expected = |t: f64| [0.1, 1.0, 10.0, 100.0].map(|tau| 0.125 * (-t / tau).exp()).iter().sum::<f64>();
    assert!((many[299] - expected(2.985)).abs() < 1e-3, "{} {}", many[299], expected(2.985));
    let slow = |law: Arc<dyn Amendment>| force(law, (0..3000).map(|i| 1e-5 * i as f64));
    let relaxing = slow(Arc::new(Relaxation { strength: 0.5, time: 0.02, decades: 0.0 }));
    let still = slow(Arc::new(plain()));
    assert!((relaxing[2999] - still[2999]).abs() < 1e-2 * still[2999]);
}

/// A spring with a Kelvin element in series under a deformation that is held: the standard linear solid.
#[test]
fn creep_in_series_relaxes_the_force_of_a_spring() {
    let (modulus, compliance, time) = (50.0, 0.03, 0.4);
    let spring = BarOptions { area: 1.0, rho: 0.0, consistent: false, rayleigh: false };
    let spring = Truss::new(Material::new(Elastic::new(modulus)), 1, &[1.0], 1, &[0.0, 0.0], spring).unwrap();
    let of = |compliance: f64| {
        let law = Arc::new(Creep { compliance, time, decades: 0.0 });
        let mut e = SingleElement::new(Amended::new(Arc::new(spring.clone()), law, &[]).unwrap());
        let mut held = |_: usize| {
            let force = e.force(&[0.0, 0.02])[1];
            e.commit();
            force
        };
        (0..200).map(&mut held).collect::<Vec<f64>>()
    };
    let more = modulus * compliance;
    let forces = of(compliance);
    // The driver's step of 0.01 s takes the deformation on linearly: half a step later it would be there at once.
    for i in [5, 20, 60, 199] {
        let t = 0.01 * (i as f64 + 0.5);
        let expected = modulus * 0.02 * (1.0 + more * (-t * (1.0 + more) / time).exp()) / (1.0 + more);
        assert!((forces[i] - expected).abs() < 1e-3 * expected, "{i}: {} {expected}", forces[i]);
    }
    assert!(of(0.0).iter().all(|f| (f - modulus * 0.02).abs() < 1e-12));
}

#[test]
fn peak_oriented_law_reloads_towards_largest_deformation() {
    let (k, fy, b, a) = (8000.0, 30.0, 0.05, 0.4);
    let law = PeakOriented { force: fy, stiffness: k, hardening: b, unloading: a };
    // A path with corners, in steps that cross those of the law.
    let corners = [0.0, 0.03, -0.03, 0.03, 0.02, 0.031];
    let path = || corners.windows(2).flat_map(|w| (1..=7).map(move |i| w[0] + (w[1] - w[0]) * f64::from(i) / 7.0));
    let plain = Temperature { softening: 0.0, at: 0.0, reference: 0.0, share: Share::default() };
    let (plain, amended) = (force(Arc::new(plain), path()), force(Arc::new(law), path()));
    let ey = fy / k;
    let envelope = |e: f64| fy + b * k * (e - ey);
    let (peak, unloading) = (envelope(0.03), k * (ey / 0.03).powf(a));
    // Displacement of zero force after a half cycle, and the lines from it.
    let zero = 0.03 - peak / unloading;
    let line = |e: f64, from: [f64; 2], to: [f64; 2]| from[1] + (to[1] - from[1]) * (e - from[0]) / (to[0] - from[0]);
    for (i, ((e, p), q)) in path().zip(&plain).zip(&amended).enumerate() {
        let expected = match i {
            0..7 => envelope(e),
            7..14 if e > zero => peak - unloading * (0.03 - e),
            7..14 if e > -ey => line(e, [zero, 0.0], [-ey, -fy]),
            7..14 => -envelope(-e),
            14..21 if e < -zero => unloading * (e + 0.03) - peak,
            14..21 => line(e, [-zero, 0.0], [0.03, peak]),
            21..35 if e <= 0.03 => peak - unloading * (0.03 - e),
            _ => envelope(e),
        };
        assert!((q - p + k * e - expected).abs() < 1e-9, "{i}: {} {expected}", q - p + k * e);
    }
}

#[test]
fn cavitation_reduces_the_next_tension_peak() {
    let (strength, extension, damage) = (50.0, 0.0005, 0.7);
    let law = Cavitation {
        strength,
        extension,
        damage,
        rate: 1.0,
        rise: 0.4,
        reach: 0.001,
        sign: 1.0,
        share: Share::default(),
    };
    let mut e = SingleElement::new(Amended::new(Arc::new(plane()), Arc::new(law), &[1]).unwrap());
    let (axes, _) = Orientation::default().of_link(Vector3::zeros(), Vector3::new(0.05, 0.3, 0.0), true).unwrap();
    let mut pull = |u: f64| {
        let f = e.force(&[0.0, 0.0, 0.0, u * axes[(0, 0)], u * axes[(0, 1)], 0.0]);
        e.commit();
        f[3] * axes[(0, 0)] + f[4] * axes[(0, 1)]
    };
    let way = |i: i32| 1e-4 * f64::from(i);
    let first: Vec<f64> = (1..=30).map(|i| pull(way(i))).collect();
    let envelope = |u: f64| strength * (1.0 + 0.4 * (1.0 - (-(u - extension) / 0.001).exp()));
    assert!((first[29] - envelope(0.003)).abs() < 1e-9, "{}", first[29]);
    assert!(pull(-1e-4) < 0.0);
    // A line from the residual strength to the end of the last pull.
    let second: Vec<f64> = (1..=32).map(|i| pull(way(i))).collect();
    let kept = 1.0 - damage * (1.0 - (-5.0f64).exp());
    let line =
        kept * strength + (first[29] - kept * strength) * (0.001 - kept * extension) / (0.003 - kept * extension);
    assert!((second[9] - line).abs() < 1e-9 && line < 0.6 * first[9], "{} {line}", second[9]);
    assert!((second[31] - envelope(0.0032)).abs() < 1e-9);
}

#[test]
fn missing_direction_is_an_error() {
    let law = Stiffening { factor: 1.0, from: 0.0, power: 2.0 };
    let refused = Amended::new(Arc::new(plane()), Arc::new(law), &[3]).err();
    let ElementError(message) = refused.expect("the plane has no third direction");
    assert!(message.contains("no direction 3"), "{message}");
}

#[test]
fn zero_time_causes_no_relaxation() {
    let law = Overstress { force: 10.0, speed: 1.0, power: 0.25, stiffness: 1e3 };
    let element = Amended::new(Arc::new(plane()), Arc::new(law), &[]).unwrap();
    let mut state = vec![0.0; element.state_len()];
    element.init(&mut state);
    let mut next = state.clone();
    let (mut force, disp) = (vec![0.0; 6], [0.0, 0.0, 0.0, 0.02, 0.0, 0.0]);
    let motion = ElementInput {
        disp: &disp,
        vel: &[0.0; 6],
        accel: &[],
        load: &[],
        still: false,
        opensees: None,
        dt: 0.0,
        time: 0.0,
        dynamic: false,
    };
    let mut histories = Histories { committed: &state, trial: &mut next };
    let output = ElementOutput { force: &mut force, tangent: None, damping: None, part: MatrixMask::ALL };
    element.respond(&motion, &mut histories, output).unwrap();
    assert!(force.iter().all(|f| f.is_finite()));
}
