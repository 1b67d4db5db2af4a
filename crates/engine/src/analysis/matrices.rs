//! Matrix and right-hand side of the equations, for those who want to look at them.

use super::engine::{Engine, Kind};
use super::failure::Failure;
use super::system::{Coefficients, System};
use super::workspace::TangentMix;

/// Equations of a model, by rising tag of the nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Equations {
    /// Matrix, n x n by rows.
    pub matrix: Vec<f64>,
    /// Unbalance, length n.
    pub unbalance: Vec<f64>,
}

impl Engine {
    /// Tangent and unbalance at the committed state, with the shares of stiffness, damping and mass of the last step;
    /// before the first step, those of a static one. Multipliers come last.
    ///
    /// # Errors
    /// The model makes no equations.
    pub fn equations(&mut self) -> Result<Equations, Failure> {
        self.prepare(self.handler())?;
        let dynamic = self.setup().is_some_and(|s| s.kind == Kind::Transient);
        let values = self.with_system(|s| {
            s.dynamic = dynamic;
            s.coefficients = s.work.matrix.coefficients.unwrap_or(Coefficients { k: 1.0, c: 0.0, m: 0.0 });
            s.apply_loads(s.old.time)?;
            s.form_unbalance(true)?;
            Ok(dense_tangent(s, TangentMix::CURRENT))
        })?;
        let order = self.equations_by_tag();
        let Some(work) = self.prepared() else { return Ok(Equations::default()) };
        let n = order.len();
        Ok(Equations {
            matrix: order
                .iter()
                .flat_map(|i| order.iter().map(move |j| (i, j)))
                .map(|(i, j)| values[i * n + j])
                .collect(),
            unbalance: order.iter().map(|i| work.b[*i]).collect(),
        })
    }

    /// Numbers of the equations by rising tag of their nodes.
    fn equations_by_tag(&self) -> Vec<usize> {
        let Some(work) = self.prepared() else { return vec![] };
        let map = &work.plan.map;
        let mut equation_of = vec![None; self.model().dofs()];
        map.dof_of.iter().enumerate().for_each(|(equation, dof)| equation_of[*dof] = Some(equation));
        let model = self.model();
        let motions = model.nodes_by_tag().flat_map(|n| model.nodes[n.0].dofs()).filter_map(|d| equation_of[d]);
        motions.chain(map.equations..work.plan.equations()).collect()
    }
}

/// The tangent with all its zeros, by rows; the solver's own is left as it was.
pub(super) fn dense_tangent(s: &mut System<'_>, mix: TangentMix) -> Vec<f64> {
    let work = &mut *s.work;
    let solved_with = work.matrix.values.clone();
    work.assemble(s.model, s.coefficients, mix);
    work.add_modal_damping(s.coefficients.c);
    let n = work.plan.equations();
    let (mut unit, mut column) = (vec![0.0; n], vec![0.0; n]);
    let mut out = vec![0.0; n * n];
    for j in 0..n {
        unit[j] = 1.0;
        work.plan.pattern.multiply(&work.matrix.values, &unit, &mut column);
        unit[j] = 0.0;
        for (i, x) in column.iter().enumerate() {
            out[i * n + j] = *x;
        }
    }
    work.matrix.values = solved_with;
    out
}
