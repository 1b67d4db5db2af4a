//! Triple friction pendulum with heating surfaces: conduction, and the bounded history of the heat flux.

use super::driver::SingleElement;
use super::script::run;
use hysteron::element::Snapshot;
use hysteron::element::bearing::triple::{Body, Conduction, history};
use std::f64::consts::PI;

const DIFFUSIVITY: f64 = 4.44e-6;
const CONDUCTIVITY: f64 = 18.0;
const THICKNESS: f64 = 0.02;

fn steel(body: Body, compat: bool) -> Conduction {
    Conduction { body, diffusivity: DIFFUSIVITY, conductivity: CONDUCTIVITY, compat }
}

/// Intermittent heat flux with rests: the bounded history gives the direct convolution to 1e-6.
#[test]
fn bounded_history_matches_the_convolution() {
    const DT: f64 = 0.01;
    let phase = |i: usize| 1.3 * DT * i as f64;
    let flux = |i: usize| if i < 40 || phase(i).sin().abs() > 0.9 { 0.0 } else { phase(i).cos().abs() };
    for body in [Body::HalfSpace, Body::Plate] {
        let conduction = steel(body, false);
        let mut words = vec![0.0; history::LEN];
        for i in 0..9000 {
            let now = DT * i as f64;
            history::push(&mut words, [now, DT * flux(i), now, 0.0]);
            if i % 499 != 0 || i < 499 {
                continue;
            }
            let (mut sum, mut direct) = ([0.0; 2], [0.0; 2]);
            let add = |sum: &mut [f64; 2], age: f64, q: f64| {
                let k = conduction.rise(THICKNESS, age);
                (sum[0], sum[1]) = (sum[0] + q * k[0], sum[1] + q * k[1]);
            };
            history::heat(&words).for_each(|(t, q)| add(&mut sum, now - t + DT, q));
            (0..=i).for_each(|j| add(&mut direct, DT * (i - j + 1) as f64, DT * flux(j)));
            for k in 0..2 {
                let error = (sum[k] - direct[k]).abs() / direct[0];
                assert!(error < 1e-6, "{body:?}, step {i}, {k}: {error:.1e}");
            }
        }
        assert!(history::heat(&words).count() < 200);
    }
}

/// The history conserves the heat and its order in time over a long analysis.
#[test]
fn history_conserves_heat() {
    let mut words = vec![0.0; history::LEN];
    let steps = 2 * history::STEPS;
    for i in 0..steps {
        history::push(&mut words, [i as f64, 1.0, i as f64, 0.0]);
    }
    let total: f64 = history::heat(&words).map(|p| p.1).sum();
    assert!((total / steps as f64 - 1.0).abs() < 1e-9, "{total}");
    let mean: f64 = history::heat(&words).map(|p| p.0 * p.1).sum::<f64>() / total;
    assert!((mean / (0.5 * (steps - 1) as f64) - 1.0).abs() < 1e-9, "{mean}");
    assert!(history::heat(&words).all(|(t, _)| t >= 0.0 && t < steps as f64));
}

/// A plate behaves as a half space at first and warms uniformly at last. Its two series agree, and OpenSees' is
/// close.
#[test]
fn conduction_has_half_space_and_uniform_limits() {
    let (plate, half) = (steel(Body::Plate, false), steel(Body::HalfSpace, false));
    let at = |c: &Conduction, age: f64| c.rise(THICKNESS, age * THICKNESS * THICKNESS / DIFFUSIVITY);
    let near = |a: f64, b: f64, to: f64| assert!((a - b).abs() <= to * b.abs(), "{a} {b}");
    near(at(&plate, 0.01)[0], at(&half, 0.01)[0], 1e-12);
    // The image source at the back doubles the heat that passes the same depth of a half space.
    near(at(&plate, 0.01)[1], 2.0 * at(&half, 0.01)[1], 1e-12);
    for k in 0..2 {
        near(at(&plate, 5.0)[k], DIFFUSIVITY / (CONDUCTIVITY * THICKNESS), 1e-12);
        near(at(&plate, 0.3 - 1e-12)[k], at(&plate, 0.3)[k], 1e-10);
        for age in [0.05, 0.2, 0.5] {
            near(at(&steel(Body::Plate, true), age)[k], at(&plate, age)[k], 1e-5);
        }
    }
    near(
        at(&half, 1.0)[0],
        (DIFFUSIVITY / PI).sqrt() / CONDUCTIVITY / (THICKNESS * THICKNESS / DIFFUSIVITY).sqrt(),
        1e-12,
    );
}

/// Two cycles of 0.2 m, 5 s each, with `tags` for pressure, temperature and speed. Returns the ratio of the largest
/// shears, second over first, and the last temperatures.
fn cycles(tags: &str) -> (f64, Vec<f64>) {
    let ran = run(&format!(
        "model basic -ndm 3 -ndf 6\nnode 1 0 0 0\nnode 2 0 0 0\nuniaxialMaterial Elastic 5 2e5\nuniaxialMaterial Elastic 2 300.
        element TripleFrictionPendulumX 1 1 2 1 2 5 2 2 2 {tags} 0.02 0.06 0.1 0.3 1. 1. 0.05 0.25 0.25 0.2 0.3 0.3 0.02 0.02 \
        300. 0.002 1. 0.1 1e-8 9549. 4244. 4244. 4.44e-6 0.018 20. 20. 1 2"
    ))
    .done();
    let mut e = SingleElement::of(ran.interp.host.engine.model().elements[0].element.clone());
    let mut peaks = [0.0f64; 2];
    let mut u = [0.0; 12];
    u[8] = -300.0 / 2e5;
    let mut force = vec![];
    for i in 0..1000 {
        u[6] = 0.2 * (2.0 * PI * i as f64 / 500.0).sin();
        force = e.force(&u);
        e.commit();
        peaks[i / 500] = peaks[i / 500].max(force[6].abs());
    }
    let probe = e.element.probe(&["Parameters"]).unwrap();
    let mut out = vec![0.0; probe.labels.len()];
    e.element.read(&probe.path, &Snapshot { disp: &u, state: &e.state, force: &force, load: &[] }, &mut out);
    (peaks[1] / peaks[0], out)
}

#[test]
fn sliding_heats_and_heat_reduces_friction() {
    let (steady, cold) = cycles("0 0 1");
    let (falls, warm) = cycles("0 1 1");
    assert!((steady - 1.0).abs() < 1e-3, "{steady}");
    assert!(falls < 0.995, "{falls}");
    let rise = |t: &[f64]| t[..3].iter().map(|t| t - 20.0).sum::<f64>();
    assert!(warm[..3].iter().all(|t| *t > 20.5) && rise(&warm) < rise(&cold), "{warm:?} {cold:?}");
    // The back of the plates is colder than the surface.
    assert!(warm[3] < warm[1] && warm[4] < warm[2], "{warm:?}");
}

/// A nearly flat pendulum that slides at 0.15 m/s for a second: temperature, factors of its friction, and final
/// shear.
fn slide(flags: [u8; 3]) -> (f64, Vec<f64>, f64) {
    let [pressure, temperature, speed] = flags;
    let ran = run(&format!(
        "model basic -ndm 3 -ndf 6\nnode 1 0 0 0\nnode 2 0 0 0\nuniaxialMaterial Elastic 5 2e5\nuniaxialMaterial Elastic 2 300.
        element FPBearingPTV 1 1 2 0.06 {pressure} 9549. {temperature} 4.44e-6 0.018 {speed} 20. 1e4 0.2 8000. 5 2 2 2 \
        0 0 1 1 0 0 0. 0 0. 20 1e-8 2"
    ))
    .done();
    let mut e = SingleElement::of(ran.interp.host.engine.model().elements[0].element.clone());
    let mut u = [0.0; 12];
    u[8] = -300.0 / 2e5;
    let mut force = vec![];
    for i in 0..=100 {
        u[6] = 0.0015 * f64::from(i);
        force = e.force(&u);
        e.commit();
    }
    let read = |word: &str| {
        let probe = e.element.probe(&[word]).unwrap();
        let mut out = vec![0.0; probe.labels.len()];
        e.element.read(&probe.path, &Snapshot { disp: &u, state: &e.state, force: &force, load: &[] }, &mut out);
        out
    };
    (read("temperature")[0], read("MuFactors"), force[6])
}

/// A constant flux q warms a half space by 2 q (α t/π)^½/k; the factors follow their formulas.
#[test]
fn pendulum_heats_by_its_friction() {
    let pressure = 300.0 / (PI * 0.04);
    let flux = 0.06 * pressure * 0.15;
    let (warm, factors, force) = slide([0, 0, 0]);
    let rise = 2.0 * flux * (4.44e-6 / PI).sqrt() / 0.018;
    assert!((warm - 20.0 - rise).abs() < 2e-3 * rise, "{warm} for {rise}");
    assert!((force - 0.06 * 300.0).abs() < 0.01 && factors == [1.0; 3], "{force} {factors:?}");
    let (warm, factors, force) = slide([1, 1, 0]);
    let by_pressure = 0.7f64.powf(0.02e-3 * (pressure - 9549.0));
    assert!((factors[0] - by_pressure).abs() < 1e-6, "{factors:?} {by_pressure}");
    assert!(warm > 22.0 && factors[1] < 0.99 && factors[1] > 0.97, "{warm} {factors:?}");
    assert!((force - 18.0 * factors[0] * factors[1]).abs() < 0.01, "{force}");
    // The nodal velocities are zero.
    let (_, factors, force) = slide([0, 0, 1]);
    assert!((force - 9.0).abs() < 0.01 && factors[2] == 0.5, "{force} {factors:?}");
}
