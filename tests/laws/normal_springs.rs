//! Sections of normal springs that bend in one plane, where one spring tells of a line of them.

use hysteron::element::bearing::{Distribution, Layout, Mean, NormalSprings, Section, Shape};
use hysteron::material::{AxialParameters, AxialSp, Material, Steel01, Viscous};
use std::sync::Arc;

/// Of a spring, m.
const LENGTH: f64 = 0.1;

/// Springs with their committed and trial states.
struct Alone {
    springs: NormalSprings,
    committed: Vec<f64>,
    trial: Vec<f64>,
}

impl Alone {
    fn new(springs: NormalSprings) -> Self {
        let mut committed = vec![f64::NAN; springs.state_len()];
        springs.init(&mut committed);
        Self { trial: committed.clone(), committed, springs }
    }
    fn ask(&mut self, e: [f64; 3]) -> Section {
        self.springs.respond(&self.committed, e, [0.0; 3], 0.0, &mut self.trial).unwrap()
    }
    fn go(&mut self, e: [f64; 3]) -> Section {
        let s = self.ask(e);
        self.springs.commit(&self.trial, &mut self.committed);
        s
    }
}

fn materials(compat: bool) -> [Material; 2] {
    let cavitating =
        AxialParameters { sce: 1.2e9, fty: 1e6, fcy: -1e7, bte: 0.1, bty: 0.01, bcy: 0.5, fcr: 0.0, hardening: None };
    [
        if compat { Arc::new(AxialSp::as_opensees(&cavitating)) } else { Arc::new(AxialSp::new(&cavitating)) },
        Arc::new(Steel01 { fy: 1e6, e0: 1e9, b: 0.05, a: Steel01::NO_ISOTROPIC }),
    ]
}

/// Bending about y or z, growing from cycle to cycle, under compression.
fn bending(about: usize) -> Vec<[f64; 3]> {
    let step = |i: usize| {
        let t = i as f64 * 0.21;
        let mut e = [-3e-5 * (1.0 + (0.3 * t).sin()), 0.0, 0.0];
        e[about] = 2e-3 * (t / 40.0) * t.sin();
        e
    };
    (1..200).map(step).collect()
}

/// Largest difference of forces, and of moments over a lever, over the largest of all.
fn apart(a: &Section, b: &Section, size: &mut [f64; 3]) -> f64 {
    size.iter_mut().zip(a.force).for_each(|(s, f)| *s = s.max(f.abs()));
    let bending = size[1].max(size[2]);
    let scale = [size[0], bending, bending];
    (0..3).map(|i| (a.force[i] - b.force[i]).abs() / scale[i].max(1.0)).fold(0.0, f64::max)
}

/// Sections with lines as they are found, and the same springs that a turn across the plane, far below what can be felt, has
/// set apart at the start.
fn both(shape: Shape, n: usize, compat: bool, check: impl Fn(Alone, Alone, usize)) {
    for distribution in [Distribution::Uniform, Distribution::Pressure(12.0)] {
        let layout = Layout::new(shape, 0.6, n, distribution, Mean::Springs);
        for material in materials(compat) {
            let springs = NormalSprings::new(material, &layout, LENGTH, 0);
            let springs = if compat { springs.counting_calls() } else { springs };
            for about in [1, 2] {
                let (mut together, mut apart) = (Alone::new(springs.clone()), Alone::new(springs.clone()));
                // Beyond the elastic range, so that there is a history to keep.
                let mut first = [0.0; 3];
                first[about] = 4e-4;
                together.go(first);
                first[3 - about] = 1e-11;
                apart.go(first);
                check(together, apart, about);
            }
        }
    }
}

#[test]
fn a_line_of_springs_is_as_good_as_each_of_them() {
    for (shape, n) in [(Shape::Square, 9), (Shape::Square, 30), (Shape::Round, 10)] {
        for compat in [false, true] {
            both(shape, n, compat, |mut together, mut alone, about| {
                let mut size = [0.0; 3];
                for e in bending(about) {
                    // Trials that go further than the step, as an iteration may.
                    together.ask(e.map(|e| 1.3 * e));
                    alone.ask(e.map(|e| 1.3 * e));
                    let (a, b) = (together.go(e), alone.go(e));
                    assert!(apart(&a, &b, &mut size) < 1e-6, "{shape:?} {n} {compat} {e:?}: {a:?} {b:?}");
                }
                // Then across the plane: each spring goes on from what its line has been through.
                for e in bending(3 - about) {
                    let other = e.map(|e| 0.5 * e);
                    together.ask(other);
                    alone.ask(other);
                    let (a, b) = (together.go(e), alone.go(e));
                    assert!(apart(&a, &b, &mut size) < 1e-6, "across: {shape:?} {n} {compat} {e:?}: {a:?} {b:?}");
                }
            });
        }
    }
}

#[test]
fn a_failed_step_across_the_plane_leaves_the_lines() {
    both(Shape::Square, 12, false, |mut together, _, about| {
        for e in bending(about).into_iter().take(60) {
            together.go(e);
        }
        let at = bending(about)[60];
        let before = together.ask(at);
        let mut across = at;
        across[3 - about] = 1e-3;
        assert_ne!(together.ask(across), before);
        // The answer is one of the committed state, whatever was tried.
        assert_eq!(together.ask(at), before);
    });
}

#[test]
fn the_tangent_of_lines_is_their_derivative_in_all_directions() {
    both(Shape::Square, 12, false, |mut together, _, about| {
        for (i, e) in bending(about).into_iter().enumerate() {
            let s = together.ask(e);
            if i % 7 == 0 {
                for k in 0..3 {
                    let moved = |d: f64| {
                        let mut e = e;
                        e[k] += d;
                        e
                    };
                    let h = 1e-12;
                    let (up, down) = (together.ask(moved(h)), together.ask(moved(-h)));
                    for j in 0..3 {
                        let difference = (up.force[j] - down.force[j]) / (2.0 * h);
                        let scale = s.stiffness[j][j].abs().max(s.stiffness[k][k].abs());
                        // A spring at a kink answers for itself.
                        assert!(
                            (difference - s.stiffness[j][k]).abs() < 3e-2 * scale,
                            "{e:?} {j} {k}: {difference} {s:?}"
                        );
                    }
                }
            }
            together.go(e);
        }
    });
}

#[test]
fn dampers_across_the_plane_have_their_moment() {
    let layout = Layout::new(Shape::Square, 0.6, 12, Distribution::Uniform, Mean::Springs);
    let damper: Material = Arc::new(Viscous { c: 1e6, alpha: 1.0, min_rate: 1e-9 });
    let Alone { springs, committed, mut trial } = Alone::new(NormalSprings::new(damper, &layout, LENGTH, 0));
    // Bent about y, and just beginning to turn about z.
    let s = springs.respond(&committed, [0.0, 1e-3, 0.0], [0.0, 0.0, 0.2], 0.0, &mut trial).unwrap();
    let inertia: f64 = layout.area.iter().zip(&layout.y).map(|(a, y)| a * y * y).sum();
    assert!((s.force[2] / (1e6 * 0.2 * inertia / LENGTH) - 1.0).abs() < 1e-12, "{s:?}");
}
