//! `YamamotoBiaxialHDR`.

use super::driver::{SingleElement, difference, path};
use hysteron::element::Mass;
use hysteron::element::axes::Orientation;
use hysteron::element::bearing::{Link, ShearBearing, YamamotoShear};
use nalgebra::Vector3;

const HEIGHT: f64 = 0.16;

fn bearing_along(x: Vector3<f64>, y: Vector3<f64>, compat: bool) -> SingleElement {
    let line = x.normalize() * 0.3;
    let (axes, length) = Orientation { x: Some(x), y: Some(y) }.of_link(Vector3::zeros(), line, false).unwrap();
    let link = Link::new(&axes, length, 0.5);
    let (diameters, factors) = ([0.7, 0.02], [0.9, 1.1]);
    if compat {
        let law = YamamotoShear::as_opensees(diameters, HEIGHT, factors);
        return SingleElement::new(ShearBearing::<_, 12, 6, 0, 2>::new(law, link, [], 3.0, true));
    }
    let law = YamamotoShear::new(diameters, HEIGHT, factors);
    SingleElement::new(ShearBearing::<_, 12, 6, 0, 2>::new(law, link, [], 3.0, true))
}

fn bearing() -> SingleElement {
    bearing_along(Vector3::z(), Vector3::x(), false)
}

/// Forces of node j for a displacement of it along global X and Y.
fn push(e: &mut SingleElement, u: [f64; 2]) -> [f64; 2] {
    let mut all = [0.0; 12];
    all[6..8].copy_from_slice(&u);
    let f = e.force(&all);
    [f[6], f[7]]
}

/// A pseudo-random orbit to about 250 % shear strain.
fn orbit(seed: u64, n: usize) -> Vec<[f64; 2]> {
    let amplitude = 2.5 * HEIGHT;
    path(seed, n, amplitude).into_iter().zip(path(seed + 1, n, amplitude)).map(|(x, y)| [x, y]).collect()
}

#[test]
fn tangent_matches_finite_difference() {
    let mut e = bearing();
    let walks: Vec<Vec<f64>> = (0..12).map(|i| path(40 + i, 200, if i % 6 < 3 { 0.3 } else { 0.1 })).collect();
    let mut tested = 0;
    for k in 0..200 {
        let u: Vec<f64> = walks.iter().map(|w| w[k]).collect();
        let (_, tangent) = e.trial(&u, &[0.0; 12]);
        let (near, far) = (e.difference(&u, 1e-8), e.difference(&u, 4e-8));
        // The number of substeps increases with the step.
        if difference(&near, &far) < 1e-5 {
            tested += 1;
            assert!(difference(&tangent, &near) < 1e-5, "step {k}");
        }
        e.force(&u);
        e.commit();
    }
    assert!(tested > 150, "only {tested} states");
}

#[test]
fn initial_tangent_matches_small_motion() {
    let mut e = bearing();
    let mut k = vec![0.0; 144];
    e.element.initial_tangent(&mut k);
    assert!(difference(&k, &e.difference(&[0.0; 12], 1e-9)) < 1e-4);
}

#[test]
fn force_is_independent_of_step_size() {
    let (mut coarse, mut fine) = (bearing(), bearing());
    let mut from = [0.0; 2];
    for to in orbit(3, 1200).into_iter().step_by(12) {
        for k in 1..=20 {
            let part = f64::from(k) / 20.0;
            push(&mut fine, [0, 1].map(|i| from[i] + part * (to[i] - from[i])));
            fine.commit();
        }
        let (a, b) = (push(&mut coarse, to), push(&mut fine, to));
        coarse.commit();
        let scale = b[0].hypot(b[1]).max(1e5);
        assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 2e-3 * scale, "{from:?} to {to:?}: {a:?} and {b:?}");
        from = to;
    }
}

#[test]
fn force_depends_on_the_committed_state_alone() {
    let (mut e, mut w) = (bearing(), bearing());
    let steps = orbit(9, 300);
    for (k, &u) in steps.iter().enumerate() {
        push(&mut w, steps[(k + 100) % 300]);
        push(&mut w, [0.0; 2]);
        assert_eq!(push(&mut e, u), push(&mut w, u), "step {k}");
        e.commit();
        w.commit();
    }
}

/// The law is isotropic: rotated axes and a mirrored motion.
#[test]
fn law_is_isotropic() {
    for compat in [false, true] {
        let mut e = bearing_along(Vector3::z(), Vector3::x(), compat);
        let mut turned = bearing_along(Vector3::z(), Vector3::new(0.6, 0.8, 0.0), compat);
        let mut mirror = bearing_along(-Vector3::z(), Vector3::x(), compat);
        for u in orbit(5, 300) {
            let f = push(&mut e, u);
            let g = push(&mut turned, u);
            let m = push(&mut mirror, [-u[0], u[1]]);
            let scale = f[0].hypot(f[1]).max(1e4);
            assert!((f[0] - g[0]).hypot(f[1] - g[1]) < 1e-9 * scale, "{f:?} and {g:?}");
            assert!((f[0] + m[0]).hypot(f[1] - m[1]) < 1e-9 * scale, "{f:?} and {m:?}");
            [&mut e, &mut turned, &mut mirror].into_iter().for_each(SingleElement::commit);
        }
    }
}

#[test]
fn orbits_dissipate_energy() {
    let mut e = bearing();
    for radius in [0.1, 0.3, 0.6, 1.2, 2.2].map(|gamma| gamma * HEIGHT) {
        for shape in [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, -0.4]] {
            let (mut work, mut last, mut at) = (0.0, [0.0; 2], [radius, 0.0]);
            for k in 0..=400 {
                let angle = 0.01 * std::f64::consts::PI * f64::from(k);
                let u = [radius * angle.cos(), radius * (shape[0] * angle.sin() + shape[1] * (2.0 * angle).sin())];
                let f = push(&mut e, u);
                e.commit();
                if k > 200 {
                    work += (0..2).map(|i| 0.5 * (f[i] + last[i]) * (u[i] - at[i])).sum::<f64>();
                }
                (last, at) = (f, u);
            }
            assert!(work > 0.0, "radius {radius}, {shape:?}: {work}");
        }
    }
}

#[test]
fn mass_is_at_both_ends() {
    let half = |at: [usize; 2]| {
        let mut m = vec![0.0; 12];
        at.iter().for_each(|&i| m[i..i + 3].fill(1.5));
        Mass::Lumped(m)
    };
    assert_eq!(bearing().element.mass(), half([0, 6]));
    assert_eq!(bearing_along(Vector3::z(), Vector3::x(), true).element.mass(), half([0, 3]));
}
