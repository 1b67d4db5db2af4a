//! Drivers for single materials and elements.

use hysteron::element::{Element, ElementInput, ElementOutput, Histories, MatrixMask};
use hysteron::material::{Material, Strain, Stress};
use std::sync::Arc;

/// A material with the state of one point.
pub struct MaterialPoint {
    pub law: Material,
    state: Vec<f64>,
    next: Vec<f64>,
}

impl MaterialPoint {
    pub fn new(law: Material) -> Self {
        let mut state = vec![0.0; law.state_len()];
        law.init(&mut state);
        Self { next: state.clone(), law, state }
    }

    /// Response at a trial strain; the committed state does not change.
    pub fn trial(&mut self, strain: f64, rate: f64, dt: f64) -> Stress {
        self.law.update(&self.state, Strain { value: strain, rate, dt }, &mut self.next).unwrap()
    }

    pub fn state(&self) -> &[f64] {
        &self.state
    }

    /// Commit the last trial.
    pub fn commit(&mut self) {
        self.state.copy_from_slice(&self.next);
    }

    /// Stress at a strain that is committed; `None` if the law has none.
    pub fn try_advance(&mut self, strain: f64) -> Option<f64> {
        let s = self.law.update(&self.state, Strain { value: strain, rate: 0.0, dt: 0.0 }, &mut self.next).ok()?;
        self.commit();
        Some(s.value)
    }

    pub fn advance(&mut self, strain: f64) -> Stress {
        let s = self.trial(strain, 0.0, 0.0);
        self.commit();
        s
    }
}

/// An element without a model.
pub struct SingleElement {
    pub element: Arc<dyn Element>,
    pub state: Vec<f64>,
    next: Vec<f64>,
    pub load: Vec<f64>,
}

impl SingleElement {
    pub fn new(element: impl Element + 'static) -> Self {
        Self::of(Arc::new(element))
    }

    /// An element from a script.
    pub fn of(element: Arc<dyn Element>) -> Self {
        let mut state = vec![0.0; element.state_len()];
        element.init(&mut state);
        let load = vec![0.0; element.load_len()];
        Self { next: state.clone(), state, load, element }
    }

    /// Force and tangent (by rows) at trial displacements; the committed state does not change.
    pub fn trial(&mut self, disp: &[f64], vel: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let n = self.element.dofs();
        let (mut force, mut tangent) = (vec![0.0; n], vec![0.0; n * n]);
        let motion = ElementInput {
            disp,
            vel,
            accel: &[],
            load: &self.load,
            still: false,
            opensees: None,
            dt: 0.01,
            time: 1.0,
            dynamic: true,
        };
        let response =
            ElementOutput { force: &mut force, tangent: Some(&mut tangent), damping: None, part: MatrixMask::ALL };
        self.element
            .respond(&motion, &mut Histories { committed: &self.state, trial: &mut self.next }, response)
            .unwrap();
        (force, tangent)
    }

    /// A part of the tangent at trial displacements, in a matrix with previous content.
    pub fn part_of_tangent(&mut self, disp: &[f64], part: MatrixMask) -> Vec<f64> {
        let n = self.element.dofs();
        let (mut force, mut tangent) = (vec![0.0; n], vec![7.0; n * n]);
        part.clear(&mut tangent, n);
        let vel = vec![0.0; n];
        let motion = ElementInput {
            disp,
            vel: &vel,
            accel: &[],
            load: &self.load,
            still: true,
            opensees: None,
            dt: 0.01,
            time: 1.0,
            dynamic: true,
        };
        let response = ElementOutput { force: &mut force, tangent: Some(&mut tangent), damping: None, part };
        self.element
            .respond(&motion, &mut Histories { committed: &self.state, trial: &mut self.next }, response)
            .unwrap();
        tangent
    }

    pub fn force(&mut self, disp: &[f64]) -> Vec<f64> {
        let rest = vec![0.0; disp.len()];
        self.trial(disp, &rest).0
    }

    pub fn commit(&mut self) {
        self.state.copy_from_slice(&self.next);
    }

    /// Tangent by central differences of the force, by rows.
    pub fn difference(&mut self, disp: &[f64], h: f64) -> Vec<f64> {
        let n = disp.len();
        let mut out = vec![0.0; n * n];
        for j in 0..n {
            let mut u = disp.to_vec();
            u[j] += h;
            let up = self.force(&u);
            u[j] = disp[j] - h;
            let down = self.force(&u);
            for i in 0..n {
                out[i * n + j] = (up[i] - down[i]) / (2.0 * h);
            }
        }
        out
    }
}

/// Largest difference divided by the largest absolute entry.
pub fn difference(a: &[f64], b: &[f64]) -> f64 {
    let scale = a.iter().chain(b).fold(1e-300, |m: f64, x| m.max(x.abs()));
    a.iter().zip(b).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max) / scale
}

/// A pseudo-random path with steps of different size: cycles, partial reversals, rests.
pub fn path(seed: u64, n: usize, amplitude: f64) -> Vec<f64> {
    let mut x = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    let mut next = || {
        x ^= x << 13;
        x ^= x >> 7;
        x ^= x << 17;
        (x >> 11) as f64 / (1u64 << 53) as f64
    };
    let (mut at, mut to, mut step, mut out) = (0.0f64, amplitude * (next() - 0.5), amplitude * 0.02, vec![]);
    while out.len() < n {
        if (at - to).abs() <= step {
            to = 2.0 * amplitude * (next() - 0.5);
            step = amplitude * (0.002 + 0.1 * next());
        }
        at += step.min((to - at).abs()) * (to - at).signum();
        out.push(at);
    }
    out
}
