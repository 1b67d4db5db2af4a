//! A bearing with an effective stiffness in shear.

use hysteron_engine::element::roles::{Inertia, Roles};
use hysteron_engine::element::{
    Class, Element, ElementInput, ElementOutput, ElementResult, ElementTraits, Histories, Mass, Snapshot,
};
use hysteron_engine::probe::Probe;

/// The initial stiffness of an element with another shear stiffness in horizontal directions.
///
/// A unit displacement of the upper end in a direction h gives the nodal forces K b, where b is the row of the shear
/// deformation over the displacements, so that K_eff = K + Σ (k_eff - k) b bᵀ with b = K e_h/k and k = e_hᵀ K e_h. The rest of
/// the stiffness is kept: axial, bending and torsion.
#[derive(Debug)]
pub(super) struct Linearized {
    class: Class,
    state_len: usize,
    mass: Mass,
    matrix: Vec<f64>,
    n: usize,
}

impl Linearized {
    /// From an element of two nodes whose upper end has the horizontal directions `0..horizontal`.
    ///
    /// # Errors
    /// The element has no shear stiffness in one of them.
    pub(super) fn new(of: &dyn Element, horizontal: usize, stiffness: f64) -> Result<Self, String> {
        let n = of.dofs();
        let mut matrix = vec![0.0; n * n];
        of.initial_tangent(&mut matrix);
        for d in 0..horizontal {
            let at = n / 2 + d;
            let k = matrix[at * n + at];
            if !(k > 0.0 && k.is_finite()) {
                return Err("has no initial stiffness in a horizontal direction".into());
            }
            let b: Vec<f64> = (0..n).map(|i| 0.5 * (matrix[i * n + at] + matrix[at * n + i]) / k).collect();
            for i in 0..n {
                for j in 0..n {
                    matrix[i * n + j] += (stiffness - k) * b[i] * b[j];
                }
            }
        }
        Ok(Self { class: of.class(), state_len: of.state_len(), mass: of.mass(), matrix, n })
    }
}

hysteron_engine::watches_columns!(Linearized => nothing);

impl Element for Linearized {
    fn class(&self) -> Class {
        self.class
    }
    fn dofs(&self) -> usize {
        self.n
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        state.fill(0.0);
    }
    fn traits(&self) -> ElementTraits {
        ElementTraits { linear: true, symmetric: true, viscous: false, elapses: false, rayleigh: false }
    }
    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        h.trial.copy_from_slice(h.committed);
        for (f, row) in output.force.iter_mut().zip(self.matrix.chunks(self.n)) {
            *f += row.iter().zip(motion.disp).map(|(k, u)| k * u).sum::<f64>();
        }
        if let Some(k) = output.tangent {
            k.iter_mut().zip(&self.matrix).for_each(|(k, m)| *k += m);
        }
        Ok(())
    }
    fn initial_tangent(&self, tangent: &mut [f64]) {
        tangent.iter_mut().zip(&self.matrix).for_each(|(k, m)| *k += m);
    }
    fn roles(&self) -> Roles<'_> {
        Roles { mass: Some(self), ..Roles::default() }
    }

    fn probe(&self, _: &[&str]) -> Option<Probe> {
        None
    }
    fn probe_names(&self) -> Vec<&'static str> {
        vec![]
    }
    fn read(&self, _: &[u32], _: &Snapshot<'_>, _: &mut [f64]) {}
}

impl Inertia for Linearized {
    fn mass(&self) -> Mass {
        self.mass.clone()
    }
}
