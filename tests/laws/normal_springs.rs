//! Normal-spring sections in uniaxial bending, where one spring represents a line of springs.

use hysteron::element::Histories;
use hysteron::element::bearing::{Distribution, Layout, Mean, NormalSprings, Section, Shape};
use hysteron::material::{AxialParameters, AxialSp, Material, Steel01, Viscous};

/// Length of a spring, m.
const LENGTH: f64 = 0.1;

/// Springs with their committed and trial states.
struct SectionState {
    springs: NormalSprings,
    committed: Vec<f64>,
    trial: Vec<f64>,
}

impl SectionState {
    fn new(springs: NormalSprings) -> Self {
        let mut committed = vec![f64::NAN; springs.state_len()];
        springs.init(&mut committed);
        Self { trial: committed.clone(), committed, springs }
    }
    fn evaluate(&mut self, e: [f64; 3]) -> Section {
        let h = &mut Histories { committed: &self.committed, trial: &mut self.trial };
        self.springs.respond(h, e, [0.0; 3], 0.0).unwrap()
    }
    fn advance(&mut self, e: [f64; 3]) -> Section {
        let s = self.evaluate(e);
        self.springs.commit(&self.trial, &mut self.committed);
        s
    }
}

fn materials(compat: bool) -> [Material; 2] {
    let cavitating =
        AxialParameters { sce: 1.2e9, fty: 1e6, fcy: -1e7, bte: 0.1, bty: 0.01, bcy: 0.5, fcr: 0.0, hardening: None };
    [
        if compat {
            Material::new(AxialSp::as_opensees(&cavitating))
        } else {
            Material::new(AxialSp::new(&cavitating))
        },
        Material::new(Steel01 { fy: 1e6, e0: 1e9, b: 0.05, a: Steel01::NO_ISOTROPIC }),
    ]
}

/// Bending about y or z with increasing amplitude, under compression.
fn bending(about: usize) -> Vec<[f64; 3]> {
    let step = |i: usize| {
        let t = i as f64 * 0.21;
        let mut e = [-3e-5 * (1.0 + (0.3 * t).sin()), 0.0, 0.0];
        e[about] = 2e-3 * (t / 40.0) * t.sin();
        e
    };
    (1..200).map(step).collect()
}

/// Largest difference of forces, and of moments divided by a lever arm, divided by the largest value.
fn max_difference(a: &Section, b: &Section, size: &mut [f64; 3]) -> f64 {
    size.iter_mut().zip(a.force).for_each(|(s, f)| *s = s.max(f.abs()));
    let bending = size[1].max(size[2]);
    let scale = [size[0], bending, bending];
    (0..3).map(|i| (a.force[i] - b.force[i]).abs() / scale[i].max(1.0)).fold(0.0, f64::max)
}

/// Sections with lines, and the same springs separated by a negligible rotation about the other axis at the start.
fn both(shape: Shape, n: usize, compat: bool, check: impl Fn(SectionState, SectionState, usize)) {
    for distribution in [Distribution::Uniform, Distribution::Pressure(12.0)] {
        let layout = Layout::new(shape, 0.6, n, distribution, Mean::Springs);
        for material in materials(compat) {
            let springs = NormalSprings::new(material, &layout, LENGTH, 0);
            let springs = if compat { springs.counting_calls() } else { springs };
            for about in [1, 2] {
                let (mut together, mut max_difference) =
                    (SectionState::new(springs.clone()), SectionState::new(springs.clone()));
                // The history is nonvirgin beyond the elastic range.
                let mut first = [0.0; 3];
                first[about] = 4e-4;
                together.advance(first);
                first[3 - about] = 1e-11;
                max_difference.advance(first);
                check(together, max_difference, about);
            }
        }
    }
}

#[test]
fn line_equals_individual_springs() {
    for (shape, n) in [(Shape::Square, 9), (Shape::Square, 30), (Shape::Round, 10)] {
        for compat in [false, true] {
            both(shape, n, compat, |mut together, mut alone, about| {
                let mut size = [0.0; 3];
                for e in bending(about) {
                    // Trials beyond the step, as in an iteration.
                    together.evaluate(e.map(|e| 1.3 * e));
                    alone.evaluate(e.map(|e| 1.3 * e));
                    let (a, b) = (together.advance(e), alone.advance(e));
                    assert!(max_difference(&a, &b, &mut size) < 1e-6, "{shape:?} {n} {compat} {e:?}: {a:?} {b:?}");
                }
                // Then bending about the other axis: each spring continues from the history of its line.
                for e in bending(3 - about) {
                    let other = e.map(|e| 0.5 * e);
                    together.evaluate(other);
                    alone.evaluate(other);
                    let (a, b) = (together.advance(e), alone.advance(e));
                    assert!(
                        max_difference(&a, &b, &mut size) < 1e-6,
                        "across: {shape:?} {n} {compat} {e:?}: {a:?} {b:?}"
                    );
                }
            });
        }
    }
}

#[test]
fn failed_out_of_plane_step_keeps_the_lines() {
    both(Shape::Square, 12, false, |mut together, _, about| {
        for e in bending(about).into_iter().take(60) {
            together.advance(e);
        }
        let at = bending(about)[60];
        let before = together.evaluate(at);
        let mut across = at;
        across[3 - about] = 1e-3;
        assert_ne!(together.evaluate(across), before);
        // The response depends on the committed state alone.
        assert_eq!(together.evaluate(at), before);
    });
}

#[test]
fn line_tangent_matches_finite_difference() {
    both(Shape::Square, 12, false, |mut together, _, about| {
        for (i, e) in bending(about).into_iter().enumerate() {
            let s = together.evaluate(e);
            if i % 7 == 0 {
                for k in 0..3 {
                    let moved = |d: f64| {
                        let mut e = e;
                        e[k] += d;
                        e
                    };
                    let h = 1e-12;
                    let (up, down) = (together.evaluate(moved(h)), together.evaluate(moved(-h)));
                    for j in 0..3 {
                        let difference = (up.force[j] - down.force[j]) / (2.0 * h);
                        let scale = s.stiffness[j][j].abs().max(s.stiffness[k][k].abs());
                        // A spring at a kink has its own tangent.
                        assert!(
                            (difference - s.stiffness[j][k]).abs() < 3e-2 * scale,
                            "{e:?} {j} {k}: {difference} {s:?}"
                        );
                    }
                }
            }
            together.advance(e);
        }
    });
}

#[test]
fn dampers_have_an_out_of_plane_moment() {
    let layout = Layout::new(Shape::Square, 0.6, 12, Distribution::Uniform, Mean::Springs);
    let damper: Material = Material::new(Viscous { c: 1e6, alpha: 1.0, min_rate: 1e-9 });
    let SectionState { springs, committed, mut trial } =
        SectionState::new(NormalSprings::new(damper, &layout, LENGTH, 0));
    // Bending about y at the start of a rotation about z.
    let s = springs
        .respond(&mut Histories { committed: &committed, trial: &mut trial }, [0.0, 1e-3, 0.0], [0.0, 0.0, 0.2], 0.0)
        .unwrap();
    let inertia: f64 = layout.area.iter().zip(&layout.y).map(|(a, y)| a * y * y).sum();
    assert!((s.force[2] / (1e6 * 0.2 * inertia / LENGTH) - 1.0).abs() < 1e-12, "{s:?}");
}
