//! Kikuchi bearings and normal springs.

use super::driver::{SingleElement, difference, path};
use hysteron::element::Histories;
use hysteron::element::axes::Orientation;
use hysteron::element::bearing::{
    Balance, Distribution, KikuchiBearing, KikuchiParameters, Layout, Link, Mean, MultipleNormalSpring, NormalSprings,
    Scheme, Shape,
};
use hysteron::material::{
    AxialParameters, AxialSp, COMPOUNDS, Elastic, ElasticPP, HighDampingRubber, KikuchiAiken, Material, NoTension,
    Steel01, Steel02,
};
use nalgebra::{Matrix3, Rotation3, Vector3};

const SIZE: f64 = 0.8;
const RUBBER: f64 = 0.16;
const HEIGHT: f64 = 0.4;
const SHEAR: f64 = 1.6e6;
const MODULUS: f64 = 6.0e8;
const AXIAL: f64 = -2.0e6;

fn elastic(k: f64) -> Material {
    Material::new(Elastic::new(k))
}

fn steel(fy: f64, e0: f64, b: f64) -> Material {
    Material::new(Steel01 { fy, e0, b, a: Steel01::NO_ISOTROPIC })
}

fn parameters(shear: Material, normal: Material) -> KikuchiParameters {
    KikuchiParameters {
        shape: Shape::Round,
        size: SIZE,
        rubber: RUBBER,
        height: HEIGHT,
        shear,
        shear_springs: 8,
        limit: Some(0.02),
        normal,
        layout: Layout::new(Shape::Round, SIZE, 10, Distribution::Pressure(15.0), Mean::Springs),
        tilt: true,
        p_delta: true,
        shares: [0.5; 2],
        mass: 0.0,
    }
}

fn upright() -> Matrix3<f64> {
    let upwards = Orientation { x: Some(Vector3::z()), y: Some(Vector3::x()) };
    upwards.of_link(Vector3::zeros(), Vector3::z() * HEIGHT, false).unwrap().0
}

fn bearing(p: KikuchiParameters) -> SingleElement {
    SingleElement::new(KikuchiBearing::new(p, &upright(), &[0.0; 12], Scheme::Converged).unwrap())
}

/// Bearings with every kind of spring and option.
fn kinds() -> Vec<(&'static str, KikuchiParameters)> {
    let linear = || parameters(elastic(SHEAR), elastic(MODULUS));
    let yielding = || parameters(steel(6.0e4, 1.2e7, 0.1), Material::new(ElasticPP::new(MODULUS, 1e9, -1.2e7, 0.0)));
    let uplifting = || parameters(steel(6.0e4, 1.2e7, 0.1), Material::new(NoTension { e: MODULUS, a: 0.0, b: 0.0 }));
    let square = Layout::new(Shape::Square, SIZE, 7, Distribution::Pressure(10.0), Mean::Springs);
    vec![
        ("linear", linear()),
        ("yielding", yielding()),
        ("uplifting", uplifting()),
        ("without scaling", KikuchiParameters { limit: None, ..yielding() }),
        ("without tilt", KikuchiParameters { tilt: false, ..yielding() }),
        ("without P-Delta", KikuchiParameters { p_delta: false, ..yielding() }),
        ("without both", KikuchiParameters { tilt: false, p_delta: false, ..yielding() }),
        ("uneven shares", KikuchiParameters { shares: [0.2, 0.9], ..linear() }),
        ("square", KikuchiParameters { shape: Shape::Square, layout: square, ..yielding() }),
    ]
}

/// A pseudo-random motion of all degrees of freedom of a bearing under compression.
fn motion(seed: u64, steps: usize) -> Vec<[f64; 12]> {
    let size = |i: usize| [0.12, 0.12, 4e-4, 4e-3, 4e-3, 4e-3][i % 6];
    let walks: Vec<Vec<f64>> = (0..12).map(|i| path(seed + i as u64, steps, size(i))).collect();
    let down = |i: usize| if i == 8 { AXIAL * RUBBER / (MODULUS * SIZE * SIZE) } else { 0.0 };
    (0..steps).map(|k| std::array::from_fn(|i| walks[i][k] + down(i))).collect()
}

#[test]
fn tangent_matches_finite_difference() {
    for (name, p) in kinds() {
        let mut e = bearing(p);
        for (k, u) in motion(7, 24).iter().enumerate() {
            let (_, tangent) = e.trial(u, &[0.0; 12]);
            if k % 4 == 3 {
                let numeric = e.difference(u, 1e-7);
                let d = difference(&tangent, &numeric);
                assert!(d < 2e-5, "{name}, step {k}: {d:.1e}");
            }
            e.force(u);
            e.commit();
        }
    }
}

#[test]
fn virgin_tangent_matches_tangent_at_rest() {
    for (name, p) in kinds() {
        let mut e = bearing(p);
        let mut initial = vec![0.0; 144];
        e.element.initial_tangent(&mut initial);
        let (force, tangent) = e.trial(&[0.0; 12], &[0.0; 12]);
        assert!(force.iter().all(|f| f.abs() < 1e-6), "{name}: {force:?}");
        assert!(difference(&initial, &tangent) < 1e-9 || name == "uplifting", "{name}");
    }
}

#[test]
fn trials_do_not_change_the_response() {
    for (name, p) in kinds() {
        let mut e = bearing(p);
        let way = motion(3, 30);
        for pair in way.windows(2) {
            let first = e.trial(&pair[1], &[0.0; 12]);
            e.trial(&pair[0].map(|u| 1.3 * u), &[0.0; 12]);
            assert_eq!(first, e.trial(&pair[1], &[0.0; 12]), "{name}");
            e.commit();
        }
    }
}

#[test]
fn rotated_axes_rotate_the_forces() {
    let turn = Rotation3::from_euler_angles(0.4, -0.7, 1.1);
    for (name, p) in kinds() {
        let axes = upright() * turn.matrix().transpose();
        let mut plain = bearing(p.clone());
        let mut turned = SingleElement::new(KikuchiBearing::new(p, &axes, &[0.0; 12], Scheme::Converged).unwrap());
        let rotate = |x: &[f64]| -> Vec<f64> {
            x.chunks_exact(3)
                .flat_map(|v| (turn * Vector3::new(v[0], v[1], v[2])).iter().copied().collect::<Vec<_>>())
                .collect()
        };
        for u in motion(11, 12) {
            let (f, g) = (plain.force(&u), turned.force(&rotate(&u)));
            assert!(difference(&rotate(&f), &g) < 1e-8, "{name}");
            plain.commit();
            turned.commit();
        }
    }
}

#[test]
fn mirrored_motion_gives_mirrored_forces() {
    // The mirror is the plane x = 0: rotations and moments about y and z change their sign.
    let mirror = |u: &[f64]| -> Vec<f64> {
        u.iter().enumerate().map(|(i, u)| if matches!(i % 6, 0 | 4 | 5) { -u } else { *u }).collect()
    };
    for (name, p) in kinds() {
        let (mut e, mut m) = (bearing(p.clone()), bearing(p));
        for u in motion(5, 20) {
            let (f, g) = (e.force(&u), m.force(&mirror(&u)));
            assert!(difference(&mirror(&f), &g) < 1e-8, "{name}");
            e.commit();
            m.commit();
        }
    }
}

#[test]
fn end_forces_are_in_equilibrium() {
    for (name, p) in kinds().into_iter().filter(|(_, p)| p.tilt && p.p_delta) {
        let mut e = bearing(KikuchiParameters { shares: [0.0; 2], ..p });
        for u in motion(23, 12) {
            let f = e.force(&u);
            let size = f.iter().fold(0.0f64, |m, f| m.max(f.abs()));
            for i in [0, 1, 2, 5] {
                assert!((f[i] + f[i + 6]).abs() < 1e-9 * size, "{name}: direction {i}");
            }
            // Moments about i: the end moments, the shear times the height, the axial force times the offset.
            let about_y = f[4] + f[10] + HEIGHT * f[6] - f[8] * (u[6] - u[0]);
            let about_x = f[3] + f[9] - HEIGHT * f[7] + f[8] * (u[7] - u[1]);
            assert!(about_x.abs().max(about_y.abs()) < 1e-8 * size, "{name}: {about_x} {about_y}");
            e.commit();
        }
    }
}

#[test]
fn response_is_independent_of_step_size() {
    // A straight path on which no spring reverses.
    let end: [f64; 12] = [0.0, 0.0, 0.0, 1e-3, 0.0, 0.0, 0.22, 0.1, -1.5e-3, 0.0, 2e-3, 1e-3];
    for (name, p) in kinds() {
        // The displacements are summed over the steps if the axial force does not follow the tilt or has no moment.
        let tolerance = if p.tilt == p.p_delta { 1e-7 } else { 1e-3 };
        let run = |steps: usize| {
            let mut e = bearing(p.clone());
            let mut f = vec![];
            for k in 1..=steps {
                f = e.force(&end.map(|u| u * k as f64 / steps as f64));
                e.commit();
            }
            f
        };
        let d = difference(&run(5), &run(200));
        assert!(d < tolerance, "{name}: {d:.1e}");
    }
}

/// Work done in a closed cycle.
fn work(e: &mut SingleElement, cycle: &[[f64; 12]]) -> f64 {
    let mut sum = 0.0;
    let (mut u, mut f) = (cycle[0].to_vec(), e.force(&cycle[0]));
    e.commit();
    for next in &cycle[1..] {
        let g = e.force(next);
        e.commit();
        sum += u.iter().zip(next).zip(f.iter().zip(&g)).map(|((u, v), (f, g))| 0.5 * (f + g) * (v - u)).sum::<f64>();
        (u, f) = (next.to_vec(), g);
    }
    sum
}

#[test]
fn cycles_dissipate_energy_and_create_none() {
    let cycle = |n: usize| -> Vec<[f64; 12]> {
        let at = |k: usize| {
            let a = std::f64::consts::TAU * k as f64 / n as f64;
            let mut u = [0.0; 12];
            (u[6], u[7], u[8]) = (0.15 * a.cos(), 0.1 * (2.0 * a).sin(), -1e-3 + 4e-4 * a.sin());
            (u[4], u[9], u[10]) = (2e-3 * (3.0 * a).sin(), 2e-3 * a.sin(), 1e-3 * (2.0 * a).cos());
            u
        };
        (0..=n).map(at).collect()
    };
    for (name, p) in kinds().into_iter().filter(|(_, p)| p.tilt && p.p_delta) {
        let (limit, linear) =
            (if name == "linear" { None } else { p.limit }, name == "linear" || name == "uneven shares");
        let mut e = bearing(KikuchiParameters { shares: [0.0; 2], limit: limit.or(p.limit).filter(|_| !linear), ..p });
        work(&mut e, &cycle(400));
        let w = work(&mut e, &cycle(400));
        if linear {
            assert!(w.abs() < 20.0, "{name}: {w}");
        } else {
            assert!(w > 1e3, "{name}: {w}");
        }
    }
}

/// Brings the bearing to an axial force with the other displacements fixed, by Newton's method on the vertical
/// motion. Returns the residuals.
fn compress(e: &mut SingleElement, u: &mut [f64; 12], axial: f64) -> Vec<f64> {
    let mut residuals = vec![];
    for _ in 0..30 {
        let (f, k) = e.trial(u, &[0.0; 12]);
        residuals.push((f[8] - axial).abs());
        if residuals.last().unwrap() <= &(1e-9 * axial.abs()) {
            return residuals;
        }
        u[8] -= (f[8] - axial) / k[8 * 12 + 8];
    }
    panic!("{residuals:?}")
}

/// Shear stiffness at constant axial force.
fn shear_stiffness(e: &mut SingleElement, u: &[f64; 12]) -> f64 {
    let k = e.trial(u, &[0.0; 12]).1;
    k[6 * 12 + 6] - k[6 * 12 + 8] * k[8 * 12 + 6] / k[8 * 12 + 8]
}

/// Shear stiffness K and rotational stiffness of a section of the linear bearing.
fn springs_alone() -> (f64, f64) {
    let layout = parameters(elastic(1.0), elastic(1.0)).layout;
    let section = NormalSprings::new(elastic(MODULUS), &layout, 0.5 * RUBBER, 0).initial_stiffness();
    (SHEAR, section[1][1])
}

/// Critical load of two links on springs (Koh and Kelly, 1988): P² + P P_s - P_s P_e = 0, P_s = K H, P_e = 2 K_θ/H.
fn critical_load() -> f64 {
    let (k, bending) = springs_alone();
    let (shear, euler) = (k * HEIGHT, 2.0 * bending / HEIGHT);
    0.5 * (-shear + (shear * shear + 4.0 * shear * euler).sqrt())
}

#[test]
fn critical_load_is_that_of_its_springs() {
    let stiffness = |load: f64| {
        let mut e = bearing(parameters(elastic(SHEAR), elastic(MODULUS)));
        let mut u = [0.0; 12];
        compress(&mut e, &mut u, -load);
        shear_stiffness(&mut e, &u)
    };
    let (mut below, mut above) = (0.0, 2.0 * critical_load());
    assert!(stiffness(below) > 0.0 && stiffness(above) < 0.0);
    while above - below > 1e-4 * above {
        let middle = 0.5 * (below + above);
        if stiffness(middle) > 0.0 { below = middle } else { above = middle }
    }
    assert!((below / critical_load() - 1.0).abs() < 0.01, "{below} {}", critical_load());
    let told = |load: f64| {
        let mut e = bearing(parameters(elastic(SHEAR), elastic(MODULUS)));
        compress(&mut e, &mut [0.0; 12], -load);
        e.commit();
        e.element.overload(&e.state).map(|o| o.critical)
    };
    assert_eq!(told(0.98 * below), None);
    assert!((told(1.02 * below).unwrap() / below - 1.0).abs() < 0.01);
    // Comparison with Haringx' column of equal rigidities, P_e = π² (E I H/t)/H². For thin rubber layers its load is
    // about π/2 times as large, since two springs are softer than a continuous column.
    let (k, bending) = springs_alone();
    let (shear, euler) = (k * HEIGHT, std::f64::consts::PI.powi(2) * 0.5 * bending / HEIGHT);
    let haringx = 0.5 * (-shear + (shear * shear + 4.0 * shear * euler).sqrt());
    assert!((0.6..0.7).contains(&(below / haringx)), "{below} {haringx}");
}

#[test]
fn shear_stiffness_under_load_matches_koh_and_kelly() {
    let (k, bending) = springs_alone();
    for part in [0.2, 0.5, 0.8] {
        let load = part * critical_load();
        let mut e = bearing(parameters(elastic(SHEAR), elastic(MODULUS)));
        let mut u = [0.0; 12];
        compress(&mut e, &mut u, -load);
        // Rigid links on springs: M = P (s + H θ)/2 + V H/2 at the sections, V = K s - P θ.
        let tilt = (0.5 * load + 0.5 * HEIGHT * k) / bending;
        let expected = (k - load * tilt) / (1.0 + HEIGHT * tilt);
        let found = shear_stiffness(&mut e, &u);
        assert!((found / expected - 1.0).abs() < 0.01, "{part}: {found} {expected}");
    }
}

#[test]
fn tangent_becomes_negative_where_koh_and_kelly_predict() {
    // No-tension normal springs: the sections soften in uplift.
    let normal: Material = Material::new(NoTension { e: MODULUS, a: 0.0, b: 0.0 });
    let load = 0.25 * critical_load();
    let layout = parameters(elastic(1.0), elastic(1.0)).layout;
    let section = NormalSprings::new(normal.clone(), &layout, 0.5 * RUBBER, 0);
    let mut virgin = vec![0.0; section.state_len()];
    section.init(&mut virgin);
    let respond = |x: f64, tilt: f64| {
        let h = &mut Histories { committed: &virgin, trial: &mut virgin.clone() };
        section.respond(h, [x, tilt, 0.0], [0.0; 3], 0.0).unwrap()
    };
    let moment = |tilt: f64| {
        let mut x = -load * 0.5 * RUBBER / (MODULUS * SIZE * SIZE);
        for _ in 0..60 {
            let s = respond(x, tilt);
            x -= (s.force[0] + load) / s.stiffness[0][0];
        }
        respond(x, tilt).force[1]
    };
    // Rigid links on springs, in increments of tilt.
    let at = |tilt: f64| {
        let s = moment(tilt) / (0.5 * load + 0.5 * HEIGHT * SHEAR);
        (s + HEIGHT * tilt, SHEAR * s - load * tilt)
    };
    let curve: Vec<(f64, f64)> = (0..2000).map(|k| at(2e-5 * f64::from(k))).collect();
    let predicted = curve.iter().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap().0;

    let mut e = bearing(KikuchiParameters { limit: Some(1.0), ..parameters(elastic(SHEAR), normal) });
    let mut u = [0.0; 12];
    let mut found = None;
    while found.is_none() && u[6] < 2.0 * predicted {
        u[6] += predicted / 200.0;
        compress(&mut e, &mut u, -load);
        e.commit();
        found = (shear_stiffness(&mut e, &u) < 0.0).then_some(u[6]);
    }
    let found = found.unwrap();
    assert!((found / predicted - 1.0).abs() < 0.03, "{found} {predicted}");
}

/// A small square bearing whose loops decay slowly, in cycles under constant load. Every state is in inner
/// equilibrium, at reversals and returns to the skeleton too, for few and many steps.
#[test]
fn cycles_of_a_lightly_damped_bearing_are_independent_of_step_size() {
    let device =
        HighDampingRubber { compound: COMPOUNDS[0].clone(), area: 0.21 * 0.21, height: 0.2, factors: [2.0, 0.8, 1.12] };
    let axial =
        AxialParameters { sce: 4e8, fty: 2.2e6, fcy: -1e8, bte: 0.01, bty: 0.001, bcy: 0.5, fcr: 0.0, hardening: None };
    let parameters = KikuchiParameters {
        shape: Shape::Square,
        size: 0.21,
        rubber: 0.2,
        height: 0.21,
        layout: Layout::new(Shape::Square, 0.21, 8, Distribution::Uniform, Mean::Springs),
        ..parameters(Material::new(KikuchiAiken::new(device, [1.0; 2])), Material::new(AxialSp::new(&axial)))
    };
    let run = |steps: u32| {
        let (mut e, mut u, mut from, mut forces) = (bearing(parameters.clone()), [0.0; 12], 0.0, vec![]);
        for to in [0.03, -0.03, 0.03, -0.03, 0.04, -0.04, 0.04, -0.04, 0.04, 0.1, -0.1, 0.1] {
            for k in 1..=steps {
                u[6] = from + (to - from) * f64::from(k) / f64::from(steps);
                let residuals = compress(&mut e, &mut u, -170e3);
                assert!(residuals.len() < 12, "at {}: {residuals:?}", u[6]);
                forces.extend((k == steps).then(|| e.force(&u)[6]));
                e.commit();
            }
            from = to;
        }
        forces
    };
    let d = difference(&run(7), &run(50));
    assert!(d < 1e-7, "{d:.1e}");
}

#[test]
fn outer_iterations_converge_quadratically() {
    let smooth: Material = Material::new(Steel02 {
        fy: 6.0e4,
        e0: 1.2e7,
        b: 0.1,
        r0: 15.0,
        c_r: [0.925, 0.15],
        a: Steel02::NO_ISOTROPIC,
        sig_init: 0.0,
    });
    let mut e = bearing(KikuchiParameters { limit: Some(0.3), ..parameters(smooth, elastic(MODULUS)) });
    let mut u = [0.0; 12];
    compress(&mut e, &mut u, AXIAL);
    e.commit();
    u[6] = 0.2;
    let r = compress(&mut e, &mut u, AXIAL);
    let quadratic = r.windows(3).filter(|w| w[2] > 1e-2).all(|w| w[2] / w[1] < 0.3 * (w[1] / w[0]).max(0.05));
    assert!(r.len() <= 7 && quadratic, "{r:?}");
}

#[test]
fn opensees_scheme_converges_for_small_steps() {
    let run = |scheme: Scheme, steps: usize| {
        let p = parameters(elastic(SHEAR), elastic(MODULUS));
        let mut e = SingleElement::new(
            KikuchiBearing::new(KikuchiParameters { shares: [0.0; 2], ..p }, &upright(), &[0.0; 12], scheme).unwrap(),
        );
        let mut f = vec![];
        for k in 1..=steps {
            let part = k as f64 / steps as f64;
            let mut u = [0.0; 12];
            (u[6], u[7], u[8]) = (0.15 * part, 0.05 * part, -1e-3 * (4.0 * part).min(1.0));
            // OpenSees evaluates a step more than once.
            e.force(&u);
            f = e.force(&u);
            e.commit();
        }
        f
    };
    let exact = run(Scheme::Converged, 10);
    let scheme = || Scheme::OpenSees(Balance { tolerance: 1.0, rounds: 3 });
    let (coarse, fine) = (difference(&run(scheme(), 20), &exact), difference(&run(scheme(), 400), &exact));
    assert!(fine < 2e-3 && fine < coarse, "{coarse:.1e} {fine:.1e}");
}

#[test]
fn layouts_have_the_area_and_inertia_of_the_section() {
    let pi = std::f64::consts::PI;
    for (shape, area, inertia) in [(Shape::Round, 0.25 * pi, pi / 64.0), (Shape::Square, 1.0, 1.0 / 12.0)] {
        for n in [20, 21] {
            let l = Layout::new(shape, 1.0, n, Distribution::Uniform, Mean::Springs);
            assert_eq!(l.y.len(), n * n);
            let sum = |f: &dyn Fn(usize) -> f64| (0..n * n).map(|i| l.area[i] * f(i)).sum::<f64>();
            assert!((sum(&|_| 1.0) / area - 1.0).abs() < 1e-12);
            assert!((sum(&|i| l.y[i] * l.y[i]) / inertia - 1.0).abs() < 5e-3);
            assert!((sum(&|i| l.z[i] * l.z[i]) / inertia - 1.0).abs() < 5e-3);
            assert!(sum(&|i| l.y[i]).abs().max(sum(&|i| l.y[i] * l.z[i]).abs()) < 1e-12);
        }
        // The pressure decreases towards the edge and vanishes there for every λ.
        for lambda in [0.0, 5.0, 60.0, 700.0] {
            let l = Layout::new(shape, 1.0, 40, Distribution::Pressure(lambda), Mean::Springs);
            assert!(l.area.iter().all(|a| a.is_finite() && *a > -1e-9), "{shape:?} {lambda}");
            assert!((l.area.iter().sum::<f64>() / area - 1.0).abs() < 1e-12);
        }
    }
    // Both averages agree for many springs.
    let total =
        |mean| -> f64 { Layout::new(Shape::Round, 1.0, 100, Distribution::Pressure(12.0), mean).area.iter().sum() };
    assert!((total(Mean::Springs) / total(Mean::Section) - 1.0).abs() < 1e-3);
}

#[test]
fn normal_springs_match_section_bending() {
    let layout = Layout::new(Shape::Round, 0.6, 12, Distribution::Uniform, Mean::Section);
    let link = || Link::new(&upright(), HEIGHT, 0.5);
    let make = |m: Material| {
        let springs = NormalSprings::new(m, &layout, HEIGHT, MultipleNormalSpring::HEADER);
        SingleElement::new(MultipleNormalSpring::new(springs, link(), 0.0, false))
    };
    let mut e = make(elastic(1e6));
    let mut u = [0.0; 12];
    (u[8], u[9]) = (1e-3, 2e-3);
    let f = e.force(&u);
    let (area, inertia) =
        (layout.area.iter().sum::<f64>(), layout.area.iter().zip(&layout.y).map(|(a, y)| a * y * y).sum::<f64>());
    assert!((f[8] - 1e6 * area / HEIGHT * 1e-3).abs() < 1e-9 && (f[2] + f[8]).abs() < 1e-9);
    assert!((f[9] - 1e6 * inertia / HEIGHT * 2e-3).abs() < 1e-9 && (f[3] + f[9]).abs() < 1e-9);
    let mut e = make(steel(1e3, 1e6, 0.02));
    for u in motion(2, 40) {
        let (_, tangent) = e.trial(&u, &[0.0; 12]);
        assert!(difference(&tangent, &e.difference(&u, 1e-9)) < 1e-4);
        e.force(&u);
        e.commit();
    }
}
