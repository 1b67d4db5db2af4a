//! Properties of every bearing element in scripts: one table of bearings, and one set of checks.

use super::driver::{SingleElement, path};
use super::script::run;
use hysteron::element::{Bearing, MatrixMask, Rows, Snapshot};
use nalgebra::{Matrix3, Rotation3, Vector3};

const HEIGHT: f64 = 0.25;
/// Materials and friction models of the bearings. Units: kN, m, s.
pub const PARTS: &str = "uniaxialMaterial Elastic 1 2e5\nuniaxialMaterial Elastic 2 300.\nuniaxialMaterial Elastic 3 500.
uniaxialMaterial Elastic 4 400.\nuniaxialMaterial ENT 5 2e5\nuniaxialMaterial Steel01 6 60. 4000. 0.1
uniaxialMaterial KikuchiAikenHDR 7 X0.6 4e-4 0.15 -coGHU 2. 0.8 1.12
uniaxialMaterial KikuchiAikenLRB 8 1 3e-4 0.15 0.392e6 1e-5 8.33e6 0.588e6 13.
uniaxialMaterial AxialSp 9 6e5 1e3 -1e5 0.1 0.01 0.5\nuniaxialMaterial ElasticPP 10 6e5 0.005
frictionModel VelDependent 1 0.03 0.08 25.\nfrictionModel Coulomb 2 0.02\nfrictionModel VelPressureDep 3 0.03 0.1 0.2 0.03 4e-4 20.\n";

/// A bearing: its name, and its command from the end nodes on, with @ for the axes x and y.
struct Kind {
    name: &'static str,
    command: &'static str,
    /// Plane element with three degrees of freedom per node.
    plane: bool,
    /// Element with the global axes.
    fixed: bool,
}

const fn space(name: &'static str, command: &'static str) -> Kind {
    Kind { name, command, plane: false, fixed: false }
}

const fn plane(name: &'static str, command: &'static str) -> Kind {
    Kind { name, command, plane: true, fixed: false }
}

static KINDS: [Kind; 25] = [
    space(
        "Bouc-Wen",
        "elastomericBearingBoucWen 1 1 2 2000. 40. 0.1 0.01 3. 2. 0.6 0.4 -P 1 -T 2 -My 3 -Mz 4 -orient @ -shearDist 0.3",
    ),
    space(
        "Bouc-Wen, thin",
        "elastomericBearingBoucWen 1 1 2 2000. 40. 0.1 0. 2. 1. 0.3 0.7 -P 5 -T 2 -My 3 -Mz 4 -orient @",
    ),
    space(
        "plasticity",
        "elastomericBearingPlasticity 1 1 2 2000. 40. 0.1 0.01 2.5 -P 1 -T 2 -My 3 -Mz 4 -orient @ -shearDist 0.3",
    ),
    space(
        "HDR",
        "HDR 1 1 2 700. 2e6 0. 0.6 0.003 0.008 20 1300. -1200. 4000. 25. 300. 30. 0.5 0.5 0.4 3. @ 10. 0.7 1. 0.4",
    ),
    space(
        "ElastomericX",
        "ElastomericX 1 1 2 90. 0.12 700. 2e6 0. 0.6 0.003 0.008 20 @ 10. 0.7 1. 0.4 0. 0. 0. 1 1 1 1",
    ),
    space(
        "LeadRubberX",
        "LeadRubberX 1 1 2 90. 0.12 700. 2e6 0.1 0.6 0.003 0.008 20 @ 10. 0.7 1. 0.4 0. 0. 0. 11.2 130. 0.05 1.41e-5 1 1 1 1 1",
    ),
    space(
        "rheology",
        "HDRRheologyBearing 1 1 2 800. 2e6 0. 0.6 0.003 0.008 20 700. 100. 20. 200. 3. 900. 100. 400. 300. 0.2 -orient @",
    ),
    space("flat slider", "flatSliderBearing 1 1 2 1 8000. -P 5 -T 2 -My 3 -Mz 4 -orient @ -shearDist 0.3"),
    space("pendulum", "singleFPBearing 1 1 2 1 2. 8000. -P 5 -T 2 -My 3 -Mz 4 -orient @ -shearDist 0.3"),
    space("pendulum, pressure", "singleFPBearing 1 1 2 3 2. 8000. -P 5 -T 2 -My 3 -Mz 4 -orient @ -inclVertDisp"),
    space(
        "pendulum, heated",
        "FPBearingPTV 1 1 2 0.06 1 9549. 1 4.44e-6 0.018 1 20. 2. 0.2 8000. 5 2 3 4 @ 0.3 0 0. 20 1e-8 2",
    ),
    space("RJ Watson", "RJWatsonEqsBearing 1 1 2 1 8000. -P 5 -Vy 2 -Vz 2 -T 2 -My 3 -Mz 4 -orient @"),
    space("shear springs", "multipleShearSpring 1 1 2 6 -mat 7 -orient @"),
    space("shear springs, limit", "multipleShearSpring 1 1 2 5 -nMat 6 8 6 6 8 -lim 0.02 -orient @"),
    space("normal springs", "multipleNormalSpring 1 1 2 7 -mat 9 -shape round -size 0.7 -orient @"),
    space(
        "Kikuchi",
        "KikuchiBearing 1 1 2 -shape round -size 0.7 0.15 -totalHeight 0.3 -nMSS 6 -matMSS 7 -limDisp 0.01 -nMNS 6 -matMNS 9 -orient @",
    ),
    space(
        "Kikuchi, square",
        "KikuchiBearing 1 1 2 -shape square -size 0.7 0.15 -nMSS 5 -matMSS 6 -nMNS 5 -matMNS 10 -lambda 20. -orient @ -adjustPDOutput 0.3 0.6",
    ),
    space("Yamamoto", "YamamotoBiaxialHDR 1 1 2 1 0.05 0. 0.15 -orient @"),
    Kind {
        name: "triple pendulum",
        command: "TripleFrictionPendulum 1 1 2 2 1 1 5 2 2 2 0.3 1. 1. 0.05 0.25 0.25 300. 0.002 1. 0.1 1e-8",
        plane: false,
        fixed: true,
    },
    Kind {
        name: "triple pendulum, heated",
        command: "TripleFrictionPendulumX 1 1 2 1 2 5 2 2 2 1 1 1 0.02 0.06 0.1 0.3 1. 1. 0.05 0.25 0.25 0.2 0.3 0.3 0.02 0.02 \
                  300. 0.002 1. 0.1 1e-8 9549. 4244. 4244. 4.44e-6 0.018 20. 20. 1 2",
        plane: false,
        fixed: true,
    },
    plane(
        "Bouc-Wen in the plane",
        "elastomericBearingBoucWen 1 1 2 2000. 40. 0.1 0.01 3. 2. 0.6 0.4 -P 1 -Mz 4 -shearDist 0.3",
    ),
    plane("flat slider in the plane", "flatSliderBearing 1 1 2 1 8000. -P 5 -Mz 4 -shearDist 0.3"),
    plane("pendulum in the plane", "singleFPBearing 1 1 2 1 2. 8000. -P 5 -Mz 4"),
    plane("RJ Watson in the plane", "RJWatsonEqsBearing 1 1 2 1 8000. -P 5 -Vy 2 -Mz 4"),
    plane("fibre-reinforced", "elastomericBearingUFRP 1 1 2 0.02 900. -100. 0. 0. 0. 20. 0. 2. 0.5 0.5 -P 1 -Mz 4"),
];

/// The scripts of all upright bearings.
pub fn scripts() -> impl Iterator<Item = String> {
    KINDS.iter().map(|k| k.script(&Matrix3::identity()))
}

/// The commands of all rows.
pub fn commands() -> impl Iterator<Item = &'static str> {
    KINDS.iter().map(|k| k.command)
}

/// Name, nodes and command of each bearing, turned about an oblique axis where it may be.
pub fn turned_words() -> impl Iterator<Item = (&'static str, String, String)> {
    let turn = Rotation3::from_euler_angles(0.3, -0.2, 0.5).into_inner();
    KINDS.iter().map(move |k| {
        let (nodes, command) = k.words(&if k.plane { Matrix3::identity() } else { turn });
        (k.name, nodes, command)
    })
}

impl Kind {
    fn dofs(&self) -> usize {
        if self.plane { 6 } else { 12 }
    }

    /// Nodes of the bearing, rotated by `turn`, and its command.
    fn words(&self, turn: &Matrix3<f64>) -> (String, String) {
        let words = |v: Vector3<f64>| format!("{} {} {}", v.x, v.y, v.z);
        let up = if self.plane { Vector3::y() } else { Vector3::z() };
        let head = turn * up * HEIGHT;
        let nodes = match self {
            Self { plane: true, .. } => format!("model basic -ndm 2 -ndf 3\nnode 1 0 0\nnode 2 {} {}", head.x, head.y),
            Self { fixed: true, .. } => "model basic -ndm 3 -ndf 6\nnode 1 0 0 0\nnode 2 0 0 0".to_owned(),
            _ => format!("model basic -ndm 3 -ndf 6\nnode 1 0 0 0\nnode 2 {}", words(head)),
        };
        let axes = format!("{} {}", words(turn * up), words(turn * Vector3::x()));
        (nodes, format!("element {}", self.command.replace('@', &axes)))
    }

    /// The script of the vertical bearing, rotated by `turn`.
    fn script(&self, turn: &Matrix3<f64>) -> String {
        let (nodes, command) = self.words(turn);
        format!("{nodes}\n{PARTS}{command}\n")
    }

    /// The vertical bearing, rotated by `turn`; `more` is the rest of the script.
    fn turned(&self, turn: &Matrix3<f64>, more: &str) -> SingleElement {
        let ran = run(&format!("{}{more}", self.script(turn))).done();
        SingleElement::of(ran.interp.host.engine.model().elements[0].element.clone())
    }

    fn upright(&self) -> SingleElement {
        self.turned(&Matrix3::identity(), "")
    }

    /// A pseudo-random motion of the upper end and a smaller one of the lower end, with shear up to the height and
    /// uplift.
    fn motion(&self, seed: u64, steps: usize) -> Vec<Vec<f64>> {
        let (n, per_node) = (self.dofs(), self.dofs() / 2);
        let up = if self.plane { 1 } else { 2 };
        let size = |i: usize| match i % per_node {
            k if k == up => 2.5e-3,
            k if k < up => 0.15,
            _ => 0.004,
        };
        let walks: Vec<Vec<f64>> =
            (0..n).map(|i| path(seed + i as u64, steps, size(i) * if i < per_node { 0.1 } else { 1.0 })).collect();
        (0..steps)
            .map(|k| {
                let mut u: Vec<f64> = walks.iter().map(|w| w[k]).collect();
                u[per_node + up] -= 1.5e-3;
                u
            })
            .collect()
    }
}

/// Largest difference of two matrices, scaled by the geometric mean of the virgin stiffnesses of row and column.
fn scaled_difference(a: &[f64], b: &[f64], scale: &[f64]) -> f64 {
    let n = scale.len();
    (0..n * n).fold(0.0, |m: f64, k| m.max((a[k] - b[k]).abs() / (scale[k / n] * scale[k % n])))
}

fn scale(e: &SingleElement) -> Vec<f64> {
    let n = e.element.dofs();
    let mut k = vec![0.0; n * n];
    e.element.initial_tangent(&mut k);
    let root: Vec<f64> = (0..n).map(|i| k[i * n + i].abs().sqrt()).collect();
    let largest = root.iter().fold(0.0f64, |m, x| m.max(*x));
    root.into_iter().map(|x| x.max(0.03 * largest)).collect()
}

/// Applies a check to every bearing and reports all failures.
fn each(kinds: impl Iterator<Item = &'static Kind>, check: impl Fn(&Kind) -> Result<(), String>) {
    let wrong: Vec<String> = kinds.filter_map(|k| check(k).err().map(|e| format!("{}: {e}", k.name))).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

fn ensure(holds: bool, otherwise: impl FnOnce() -> String) -> Result<(), String> {
    if holds { Ok(()) } else { Err(otherwise()) }
}

/// Largest difference divided by the largest force.
fn relative_difference(a: &[f64], b: &[f64]) -> f64 {
    let size = a.iter().fold(1.0f64, |m, x| m.max(x.abs()));
    a.iter().zip(b).fold(0.0f64, |m, (a, b)| m.max((a - b).abs())) / size
}

/// Compares tangents along a path; at least `wanted` states must lie away from kinks. A lifted slider is skipped,
/// because it keeps a share of its stiffness for the solver.
fn check_tangent(kind: &Kind, e: &mut SingleElement, steps: &[Vec<f64>], wanted: usize) -> Result<(), String> {
    let scale = scale(e);
    let n = scale.len();
    let up = n / 2 + if kind.plane { 1 } else { 2 };
    let mut virgin = vec![0.0; n * n];
    e.element.initial_tangent(&mut virgin);
    let mut tested = 0;
    for (k, u) in steps.iter().enumerate() {
        let (_, tangent) = e.trial(u, &vec![0.0; n]);
        let (near, far) = (e.difference(u, 1e-8), e.difference(u, 4e-8));
        let lifted = virgin[up * n + up] > 0.0 && near[up * n + up] == 0.0;
        if scaled_difference(&near, &far, &scale) < 1e-5 && !lifted {
            tested += 1;
            let error = scaled_difference(&tangent, &near, &scale);
            ensure(error < 5e-4, || format!("step {k}: {error:.1e}"))?;
        }
        e.force(u);
        e.commit();
    }
    ensure(tested >= wanted, || format!("only {tested} states to compare"))
}

#[test]
fn tangent_matches_finite_difference() {
    each(KINDS.iter(), |kind| check_tangent(kind, &mut kind.upright(), &kind.motion(3, 90), 40));
}

/// Every bearing accepts modifiers, and the modified bearing has a consistent tangent.
#[test]
fn every_bearing_accepts_modifiers() {
    each(KINDS.iter(), |kind| {
        let direction = if kind.name == "normal springs" { " -dir 1" } else { "" };
        for amendment in ["yielding -force 4. -hardening 0.1", "stiffening -factor 500."] {
            let mut e = kind.turned(&Matrix3::identity(), &format!("amend element 1 {amendment}{direction}"));
            let (mut plain, steps) = (kind.upright(), kind.motion(13, 40));
            let changes = steps.iter().any(|u| e.force(u) != plain.force(u));
            ensure(changes, || format!("{amendment} changes nothing"))?;
            check_tangent(kind, &mut e, &steps, 10)?;
        }
        Ok(())
    });
}

/// A partial tangent for some degrees of freedom equals the same entries of the full tangent.
#[test]
fn partial_tangent_equals_the_full_tangent() {
    each(KINDS.iter(), |kind| {
        let n = kind.dofs();
        let direction = if kind.name == "normal springs" { " -dir 1" } else { "" };
        let amend = format!("amend element 1 yielding -force 4. -hardening 0.1{direction}");
        for (mut e, every) in [(kind.upright(), 2), (kind.upright(), 5), (kind.turned(&Matrix3::identity(), &amend), 3)]
        {
            let size = scale(&e);
            let wanted = |i: usize| i % every == 1;
            let rows = Rows::of((0..n).map(wanted));
            let columns = Rows::of((0..n).map(|i| i % 2 == 1));
            for u in kind.motion(23, 30) {
                let whole = e.trial(&u, &vec![0.0; n]).1;
                let mut part = e.part_of_tangent(&u, MatrixMask { rows, columns });
                for (k, part) in part.iter_mut().enumerate().filter(|(k, _)| !wanted(k / n) || (k % n) % 2 == 0) {
                    *part = whole[k];
                }
                let error = scaled_difference(&part, &whole, &size);
                // Kikuchi's inner nodes are solved to a tolerance from the values of the last call.
                let enough = if kind.name.starts_with("Kikuchi") { 1e-5 } else { 1e-13 };
                ensure(error < enough, || format!("{error:.1e}"))?;
                e.commit();
            }
        }
        Ok(())
    });
}

#[test]
fn force_depends_on_the_committed_state_alone() {
    each(KINDS.iter(), |kind| {
        let (mut e, mut wild) = (kind.upright(), kind.upright());
        let steps = kind.motion(9, 60);
        for (k, u) in steps.iter().enumerate() {
            wild.force(&steps[(k + 20) % 60]);
            wild.force(&vec![0.0; kind.dofs()]);
            let (f, g) = (e.force(u), wild.force(u));
            ensure(f == g, || format!("step {k}: {f:?} {g:?}"))?;
            e.commit();
            wild.commit();
        }
        Ok(())
    });
}

#[test]
fn rotating_the_bearing_rotates_the_force() {
    let q = Rotation3::from_euler_angles(0.4, 0.9, -1.3).into_inner();
    let turn = |v: &[f64]| -> Vec<f64> {
        v.chunks(3).flat_map(|c| (q * Vector3::from_column_slice(c)).as_slice().to_vec()).collect()
    };
    each(KINDS.iter().filter(|k| !k.plane && !k.fixed), |kind| {
        let (mut straight, mut turned) = (kind.upright(), kind.turned(&q, ""));
        for (k, u) in kind.motion(77, 60).iter().enumerate() {
            let error = relative_difference(&turn(&straight.force(u)), &turned.force(&turn(u)));
            ensure(error < 1e-8, || format!("step {k}: {error:.1e}"))?;
            straight.commit();
            turned.commit();
        }
        Ok(())
    });
}

/// Mirror in the plane normal to x: displacements along x and rotations about the other axes change sign.
#[test]
fn mirrored_motion_gives_mirrored_force() {
    each(KINDS.iter(), |kind| {
        let flips = |i: usize| if kind.plane { matches!(i % 3, 0 | 2) } else { matches!(i % 6, 0 | 4 | 5) };
        let mirror =
            |v: &[f64]| -> Vec<f64> { v.iter().enumerate().map(|(i, x)| if flips(i) { -x } else { *x }).collect() };
        let (mut e, mut m) = (kind.upright(), kind.upright());
        for (k, u) in kind.motion(5, 60).iter().enumerate() {
            let error = relative_difference(&mirror(&e.force(u)), &m.force(&mirror(u)));
            ensure(error < 1e-8, || format!("step {k}: {error:.1e}"))?;
            e.commit();
            m.commit();
        }
        Ok(())
    });
}

/// The work of every shear path of a compressed bearing from rest is nonnegative.
#[test]
fn shear_creates_no_energy() {
    const STEPS: usize = 3000;
    let walks = [path(41, STEPS, 0.12), path(42, STEPS, 0.1)];
    each(KINDS.iter(), |kind| {
        let (per_node, up) = if kind.plane { (3, 1) } else { (6, 2) };
        let mut e = kind.upright();
        let (mut last, mut at) = (vec![0.0; kind.dofs()], vec![0.0; kind.dofs()]);
        let (mut work, mut least, mut most) = (0.0, 0.0f64, 0.0f64);
        for k in 0..STEPS {
            let mut u = vec![0.0; kind.dofs()];
            let share = (k as f64 / 50.0).min(1.0);
            u[per_node + up] = -1e-3 * share;
            for (d, walk) in walks[..up].iter().enumerate() {
                u[per_node + d] = walk[k] * share;
            }
            let f = e.force(&u);
            e.commit();
            work += (0..kind.dofs()).map(|i| 0.5 * (f[i] + last[i]) * (u[i] - at[i])).sum::<f64>();
            (last, at) = (f, u);
            (least, most) = (least.min(work), most.max(work));
        }
        ensure(least > -2e-3 * most, || format!("{least} of {most}"))
    });
}

/// Every named response can be read, with one number per column.
#[test]
fn responses_have_values() {
    each(KINDS.iter(), |kind| {
        let mut e = kind.upright();
        let u = kind.motion(15, 30).pop().unwrap();
        let force = e.force(&u);
        e.commit();
        for name in e.element.probe_names() {
            let words: &[&str] = match name {
                "material" if e.element.probe(&["material", "1", "stress"]).is_none() => continue,
                "material" => &["material", "1", "stress"],
                "frictionModel" if kind.fixed => &["frictionModel", "1", "COF"],
                "frictionModel" => &["frictionModel", "COF"],
                other => &[other],
            };
            let probe = e.element.probe(words).ok_or_else(|| format!("no {name}"))?;
            let mut out = vec![0.0; probe.labels.len()];
            let snapshot = Snapshot { disp: &u, state: &e.state, force: &force, load: &[] };
            e.element.read(&probe.path, &snapshot, &mut out);
            ensure(out.iter().all(|x| x.is_finite()), || format!("{name}: {out:?}"))?;
        }
        Ok(())
    });
}

/// Every bearing says that it is one, and which carry their shear by friction. Normal springs have no shear.
#[test]
fn bearings_say_how_they_carry_their_shear() {
    each(KINDS.iter().filter(|k| k.name != "normal springs"), |kind| {
        let slides = ["slider", "pendulum", "RJ Watson"].iter().any(|word| kind.name.contains(word));
        let said = kind.upright().element.bearing();
        let wanted = Some(if slides { Bearing::Sliding } else { Bearing::Rubber });
        ensure(said == wanted, || format!("{said:?}"))
    });
}
