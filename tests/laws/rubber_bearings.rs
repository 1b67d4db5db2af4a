//! Laminated rubber bearings: `HDR`, `ElastomericX`, `LeadRubberX`.

use super::driver::{SingleElement, difference, path};
use hysteron::element::axes::Orientation;
use hysteron::element::bearing::{
    AxialLaw, GrantShear, Layers, LeadCore, Link, PI, Rubber, RubberBearing, RubberBoucWen, RubberShear,
};
use hysteron::element::{ElementInput, ElementOutput, Histories};
use hysteron::rules::Consistent;
use nalgebra::{Rotation3, Vector3};

const HEIGHT: f64 = 0.25;

fn rubber(plugged: bool) -> Rubber {
    let layers = Layers {
        g: 0.45e6,
        bulk: 2e9,
        inner: 0.12,
        outer: 0.6,
        shim: 0.003,
        layer: 0.006,
        count: 28.0,
        cover: 0.005,
        plugged,
    };
    layers.bearing()
}

fn axial(rubber: Rubber) -> AxialLaw {
    AxialLaw { rubber, kc: 20.0, phi: 0.75, ac: 1.0, cavitates: true, buckles: true, softens: true, compat: false }
}

fn grant() -> GrantShear {
    GrantShear { a: [1.1e6, -6e6, 9e7], b: [1.8e4, 4e5, 60.0], c: [4.0, 1.5, 0.75, 3.0], rules: Consistent }
}

fn bouc_wen(varies: bool, leaded: bool) -> RubberBoucWen {
    let rubber = rubber(leaded);
    let core = leaded.then_some(LeadCore {
        radius: 0.06,
        area: PI * 0.06 * 0.06,
        height: rubber.height,
        shims: 27.0 * 0.003,
        density: 11200.0,
        heat: 130.0,
        conductivity: 50.0,
        diffusivity: 1.41e-5,
    });
    let (qy, k0) = (9e4, 9.0 * rubber.shear);
    RubberBoucWen { qy, k0, rubber: rubber.shear, cd: 0.0, varies, leaded, core, heats: leaded, rules: Consistent }
}

fn along<L: RubberShear + 'static>(law: L, orientation: Orientation, line: Vector3<f64>) -> SingleElement {
    let (axes, length) = orientation.of_link(Vector3::zeros(), line, false).unwrap();
    SingleElement::new(RubberBearing::new(axial(rubber(false)), law, Link::new(&axes, length, 0.4), 0.0))
}

fn upright() -> (Orientation, Vector3<f64>) {
    (Orientation { x: Some(Vector3::z()), y: Some(Vector3::x()) }, Vector3::new(0.0, 0.0, HEIGHT))
}

/// All laws, with the bearing axis along the global Z.
fn bearings() -> Vec<(&'static str, SingleElement)> {
    turned(upright().0, upright().1)
}

fn turned(o: Orientation, line: Vector3<f64>) -> Vec<(&'static str, SingleElement)> {
    vec![
        ("HDR", along(grant(), o, line)),
        ("ElastomericX", along(bouc_wen(true, false), o, line)),
        ("LeadRubberX", along(bouc_wen(true, true), o, line)),
    ]
}

/// A pseudo-random motion of the upper end, sheared up to the diameter; `lift` is the amplitude of the vertical
/// motion.
fn random_motion(seed: u64, steps: usize, lift: f64) -> Vec<[f64; 12]> {
    let walk = |i: u64, size: f64| path(seed + i, steps, size);
    let walks = [walk(0, 0.35), walk(1, 0.3), walk(2, lift), walk(3, 0.02), walk(4, 0.02), walk(5, 0.02)];
    (0..steps)
        .map(|k| {
            let mut u = [0.0; 12];
            walks.iter().zip(&mut u[6..]).for_each(|(w, u)| *u = w[k]);
            u
        })
        .collect()
}

/// Displacement at which the bearing cavitates, and at which it buckles, both without shear.
fn limits() -> (f64, f64) {
    let r = rubber(false);
    (r.cavitation / r.axial, -r.critical / r.axial)
}

#[test]
fn tangent_matches_finite_difference() {
    let (uc, ucr) = limits();
    for (reach, pressed) in [(4.0 * uc, false), (2.0 * ucr.abs(), true)] {
        for (name, mut e) in bearings() {
            let (mut tested, mut cavitated, mut buckled) = (0, 0, 0);
            for (k, mut u) in random_motion(31, 250, reach).into_iter().enumerate() {
                if pressed {
                    u[8] = -u[8].abs();
                }
                let u = &u;
                let (force, tangent) = e.trial(u, &[0.0; 12]);
                let (near, far) = (e.difference(u, 1e-7), e.difference(u, 3e-7));
                if difference(&near, &far) < 1e-6 {
                    tested += 1;
                    cavitated += usize::from(u[8] > 1.5 * uc);
                    buckled += usize::from(u[8] < 0.0 && tangent[8 * 12 + 8] < 0.01 * rubber(false).axial);
                    let error = difference(&tangent, &near);
                    assert!(error < 1e-5, "{name}, step {k}: {error:.1e}, force {force:?}");
                    // The shear part alone, because the axial stiffness dominates the whole tangent.
                    let shear = |k: &[f64]| [k[6 * 12 + 6], k[6 * 12 + 7], k[7 * 12 + 6], k[7 * 12 + 7]];
                    let error = difference(&shear(&tangent), &shear(&near));
                    assert!(error < 1e-4, "{name}, step {k}: shear {error:.1e}");
                }
                e.trial(u, &[0.0; 12]);
                e.commit();
            }
            assert!(tested > 120, "{name}: only {tested} states away from kinks");
            let enough = if pressed { buckled > 20 } else { cavitated > 20 };
            assert!(enough, "{name}: {cavitated} cavitated, {buckled} buckled");
        }
    }
}

#[test]
fn initial_tangent_matches_small_motion() {
    for (name, mut e) in bearings() {
        let mut k = vec![0.0; 144];
        e.element.initial_tangent(&mut k);
        let error = difference(&k, &e.difference(&[0.0; 12], 1e-9));
        assert!(error < 1e-4, "{name}: {error:.1e}");
    }
}

#[test]
fn force_depends_on_the_committed_state_alone() {
    for ((name, mut e), (_, mut w)) in bearings().into_iter().zip(bearings()) {
        let steps = random_motion(9, 120, 0.004);
        for (k, u) in steps.iter().enumerate() {
            w.force(&steps[(k + 40) % 120]);
            w.force(&[0.0; 12]);
            assert_eq!(e.force(u), w.force(u), "{name}, step {k}");
            e.commit();
            w.commit();
            assert_eq!(e.state, w.state, "{name}, step {k}");
        }
    }
}

#[test]
fn rotating_the_bearing_rotates_the_force() {
    let q = Rotation3::from_euler_angles(0.4, 0.9, -1.3).into_inner();
    let o = Orientation { x: Some(q * Vector3::z()), y: Some(q * Vector3::x()) };
    let turn = |v: &[f64]| -> Vec<f64> {
        v.chunks(3).flat_map(|c| (q * Vector3::from_column_slice(c)).as_slice().to_vec()).collect()
    };
    for ((name, mut straight), (_, mut turned)) in bearings().into_iter().zip(turned(o, q * upright().1)) {
        for (k, u) in random_motion(77, 150, 0.004).iter().enumerate() {
            let (a, b) = (turn(&straight.force(u)), turned.force(&turn(u)));
            assert!(difference(&a, &b) < 1e-8, "{name}, step {k}");
            straight.commit();
            turned.commit();
        }
    }
}

/// Mirrored in the vertical plane y-z: horizontal x and the rotations about y and z change sign.
#[test]
fn mirrored_motion_gives_mirrored_force() {
    let mirror = |v: &[f64]| -> Vec<f64> {
        v.iter().enumerate().map(|(i, x)| if matches!(i % 6, 0 | 4 | 5) { -x } else { *x }).collect()
    };
    for ((name, mut e), (_, mut m)) in bearings().into_iter().zip(bearings()) {
        for u in random_motion(5, 150, 0.004) {
            let (f, g) = (e.force(&u), m.force(&mirror(&u)));
            assert!(difference(&mirror(&f), &g) < 1e-13, "{name}");
            e.commit();
            m.commit();
        }
    }
}

/// Smallest work done on the upper end along a path.
fn min_work(e: &mut SingleElement, path: impl IntoIterator<Item = [f64; 3]>) -> (f64, f64) {
    let (mut last, mut at): ([f64; 3], Option<[f64; 3]>) = ([0.0; 3], None);
    let (mut work, mut least) = (0.0, 0.0f64);
    for p in path {
        let mut u = [0.0; 12];
        u[6..9].copy_from_slice(&p);
        let f = e.force(&u);
        e.commit();
        if let Some(at) = at {
            work += (0..3).map(|i| 0.5 * (f[6 + i] + last[i]) * (p[i] - at[i])).sum::<f64>();
            least = least.min(work);
        }
        at = Some(p);
        last.copy_from_slice(&f[6..9]);
    }
    (least, work)
}

#[test]
fn shear_at_constant_height_creates_no_energy() {
    for seed in 0..4 {
        for (name, mut e) in bearings() {
            let xy = path(41 + seed, 4000, 0.25).into_iter().zip(path(51 + seed, 4000, 0.2));
            let (least, work) = min_work(&mut e, xy.map(|(x, y)| [x, y, 0.0]));
            assert!(least > -1e-3 * work && work > 0.0, "{name}: {least} of {work}");
        }
    }
}

#[test]
fn axial_motion_of_a_sheared_bearing_creates_no_energy() {
    let (uc, ucr) = limits();
    for shear in [0.0, 0.2, 0.45] {
        for (name, mut e) in bearings() {
            e.force(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, shear, 0.0, 0.0, 0.0, 0.0, 0.0]);
            e.commit();
            let heights = path(7, 6000, 6.0 * uc).into_iter().chain(path(8, 6000, 1.2 * ucr.abs()));
            let start = std::iter::once([shear, 0.0, 0.0]);
            let (least, work) = min_work(&mut e, start.chain(heights.map(|z| [shear, 0.0, z])));
            assert!(least > -1e-6 * work && work > 0.0, "{name}: {least} of {work}");
        }
    }
}

/// The tensile force of a second pull is less than that of the first, up to the largest displacement, where both
/// agree.
#[test]
fn cavitation_strength_degrades_with_repetition() {
    let r = rubber(false);
    let (uc, _) = limits();
    let law = axial(r);
    let pull = |state: &mut _, to: f64| -> Vec<f64> {
        (0..=200)
            .map(|k| {
                let s = law.step(state, to * f64::from(k) / 200.0, 0.0);
                *state = s.next;
                s.next.force
            })
            .collect()
    };
    let mut state = law.virgin();
    let first = pull(&mut state, 5.0 * uc);
    let second = pull(&mut state, 5.0 * uc);
    let third = pull(&mut state, 10.0 * uc);
    let left = |strength: f64| strength / r.cavitation;
    assert!(first.iter().zip(&second).all(|(a, b)| b <= &(a * (1.0 + 1e-12))));
    assert!((first[200] - second[200]).abs() < 1e-9 * r.cavitation);
    assert!(second[60] < 0.6 * first[60] && third[60] > 0.0);
    // F_c (1 - Φ (1 - e^(-a (u_max - u_c) / u_c))), evaluated by hand for u_max = 10 u_c.
    assert!((left(state.fcn) - (1.0 - 0.75 * (1.0 - (-9.0f64).exp()))).abs() < 1e-12);
    let fourth = pull(&mut state, 10.0 * uc);
    assert!(fourth[60] < second[60] * 2.0 && left(state.fcn) < 0.2505);
}

/// Bounds for every displacement, and the critical load without displacement.
#[test]
fn critical_load_and_stiffness_fall_with_shear() {
    let r = rubber(false);
    let law = axial(r);
    let at = |uh: f64, u: f64| law.step(&law.virgin(), u, uh);
    let (_, ucr) = limits();
    assert!((at(0.0, 0.9999999 * ucr).next.force + r.critical).abs() < 1e-6 * r.critical);
    // The overlap at half the diameter is 2/3 - √3/(2π).
    let share = 2.0 / 3.0 - 3.0f64.sqrt() / (2.0 * std::f64::consts::PI);
    assert!((at(0.3, 0.0).next.fcrn + share * r.critical).abs() < 1e-12 * r.critical);
    assert_eq!(at(0.59, 0.0).next.fcrn, -0.2 * r.critical);
    assert_eq!(at(0.9, 0.0).next.fcrn, -0.2 * r.critical);
    let gyration = r.gyration;
    let soft = 1.0 / (1.0 + 3.0 * (0.2 / gyration).powi(2) / (PI * PI));
    assert!((at(0.2, 0.0).next.kv - soft * r.axial).abs() < 1e-12 * r.axial);
    // Beyond the critical load the stiffness is small and the force continuous.
    let beyond = at(0.3, 1.01 * ucr);
    assert!(beyond.k < 1e-3 * r.axial);
    let step = at(0.3, -share * r.critical / at(0.3, 0.0).next.kv);
    assert!((step.next.force + share * r.critical).abs() < 1e-9 * r.critical);
}

/// The response depends on the path and not on the number of steps.
#[test]
fn axial_force_is_independent_of_step_size() {
    let law = axial(rubber(false));
    let (uc, ucr) = limits();
    let advance = |n: u32| {
        let mut state = law.virgin();
        let corners = [(0.0, 0.0), (0.1, 0.5 * ucr), (0.0, 3.0 * uc), (0.2, 0.0), (0.1, 2.0 * uc), (0.3, 0.9 * ucr)];
        let mut forces = vec![];
        for leg in corners.windows(2) {
            for k in 1..=n {
                let t = f64::from(k) / f64::from(n);
                let mix = |a: f64, b: f64| a + t * (b - a);
                state = law.step(&state, mix(leg[0].1, leg[1].1), mix(leg[0].0, leg[1].0)).next;
            }
            forces.push(state.force);
        }
        forces
    };
    assert!(difference(&advance(1), &advance(1000)) < 1e-12);
}

/// A circular orbit shows that both directions share one strength, and that the force lags behind the displacement.
#[test]
fn circular_orbits_show_bidirectional_coupling() {
    for (name, mut e) in bearings() {
        let radius = 0.12;
        let (mut straight, mut along, mut around) = (0.0f64, 0.0, 0.0);
        let mut u = [0.0; 12];
        for k in 0..=100 {
            u[6] = radius * f64::from(k) / 100.0;
            straight = e.force(&u)[6];
            e.commit();
        }
        for k in 0..400 {
            let (sin, cos) = (f64::from(k) * 0.02).sin_cos();
            (u[6], u[7]) = (radius * cos, radius * sin);
            let f = e.force(&u);
            e.commit();
            (along, around) = (f[6] * cos + f[7] * sin, -f[6] * sin + f[7] * cos);
        }
        assert!(around > 0.05 * straight, "{name}: friction acts along the orbit: {around}");
        assert!(along < 0.95 * straight, "{name}: and is missing across it: {along} of {straight}");
    }
}

/// The damping matrix is the derivative of the force with respect to the velocity.
#[test]
fn viscous_part_is_in_the_damping_matrix() {
    let law = RubberBoucWen { cd: 3e4, ..bouc_wen(true, false) };
    let e = along(law, upright().0, upright().1);
    assert!(e.element.traits().viscous);
    let mut next = e.state.clone();
    let mut respond = |vel: &[f64]| {
        let (mut force, mut damping) = (vec![0.0; 12], vec![0.0; 144]);
        let mut disp = [0.0; 12];
        (disp[6], disp[8]) = (0.05, -0.001);
        let motion = ElementInput {
            disp: &disp,
            vel,
            accel: &[],
            load: &[],
            still: false,
            opensees: None,
            dt: 0.01,
            time: 0.01,
            dynamic: true,
        };
        let response = ElementOutput {
            force: &mut force,
            tangent: None,
            damping: Some(&mut damping),
            part: hysteron::element::MatrixMask::ALL,
        };
        e.element.respond(&motion, &mut Histories { committed: &e.state, trial: &mut next }, response).unwrap();
        (force, damping)
    };
    let (still, damping) = respond(&[0.0; 12]);
    for j in 0..12 {
        let mut vel = [0.0; 12];
        vel[j] = 0.3;
        let (moving, _) = respond(&vel);
        for i in 0..12 {
            assert!((moving[i] - still[i] - damping[i * 12 + j] * 0.3).abs() < 1e-6, "{i} {j}");
        }
    }
}

/// Lead heats by the dissipated work without heat flow, and cools at rest.
#[test]
fn lead_heats_and_cools() {
    let core = bouc_wen(true, true).core.unwrap();
    let shut = LeadCore { conductivity: 0.0, ..core };
    let (force, speed, dt) = (9e4, 0.5, 0.01);
    let (mut rise, mut lost) = (0.0, 0.0);
    for k in 1..=300 {
        let time = f64::from(k) * dt;
        rise = shut.warm(rise, force, speed, time, dt);
        lost = core.warm(lost, force, speed, time, dt);
    }
    let mass = core.density * core.area * core.height;
    assert!((rise - force * speed * 3.0 / (mass * core.heat)).abs() < 1e-9 * rise);
    assert!(lost < rise && lost > 0.5 * rise, "{lost} of {rise}");
    let fine = (1..=30_000).fold(0.0, |r, k| core.warm(r, force, speed, f64::from(k) * 1e-4, 1e-4));
    assert!((lost - fine).abs() < 2e-3 * fine, "{lost} and {fine}");
    // A long rest cools the lead without overshoot.
    let rest = core.warm(lost, force, 0.0, 1e4, 1e4);
    assert!((0.0..0.1 * lost).contains(&rest));
    assert!((LeadCore::strength(100.0) - (-0.69f64).exp()).abs() < 1e-15);
}
