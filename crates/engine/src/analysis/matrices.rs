//! Matrix and right-hand side of the equations, for those who want to look at them.

use super::engine::{Engine, Kind, MatrixTerms};
use super::failure::Failure;
use super::system::{Coefficients, System};
use super::workspace::{TangentMix, Workspace};

/// Equations of a model, by rising tag of the nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Equations {
    /// Matrix, n x n by rows, or its diagonal, n.
    pub matrix: Vec<f64>,
    /// Unbalance, length n.
    pub unbalance: Vec<f64>,
}

impl Engine {
    /// Tangent and unbalance at the committed state, with the shares of stiffness, damping and mass of the last step;
    /// before the first step, those of a static one. Multipliers come last. Of [`MatrixTerms::Diagonal`] the matrix is the
    /// diagonal alone, for which no full matrix is made.
    ///
    /// # Errors
    /// The model makes no equations.
    pub fn equations(&mut self, terms: MatrixTerms) -> Result<Equations, Failure> {
        self.prepare(self.handler())?;
        let dynamic = self.setup().is_some_and(|s| s.kind == Kind::Transient);
        let only_diagonal = terms == MatrixTerms::Diagonal;
        let values = self.with_system(|s| {
            s.dynamic = dynamic;
            s.coefficients = s.work.matrix.coefficients.unwrap_or(Coefficients { k: 1.0, c: 0.0, m: 0.0 });
            s.apply_loads(s.old.time)?;
            s.form_unbalance(true)?;
            let take = if only_diagonal { diagonal_of } else { rows_of };
            Ok(with_tangent(s, TangentMix::CURRENT, take))
        })?;
        let order = self.equations_by_tag();
        let Some(work) = self.prepared() else { return Ok(Equations::default()) };
        let n = order.len();
        let matrix = if only_diagonal {
            order.iter().map(|i| values[*i]).collect()
        } else {
            order.iter().flat_map(|i| order.iter().map(move |j| i * n + j)).map(|at| values[at]).collect()
        };
        Ok(Equations { matrix, unbalance: order.iter().map(|i| work.b[*i]).collect() })
    }

    /// Correction that the equations were last solved for, by rising tag of the nodes; empty before the first analysis.
    pub fn last_correction(&self) -> Vec<f64> {
        let Some(work) = self.prepared() else { return vec![] };
        self.equations_by_tag().into_iter().filter_map(|i| work.x.get(i).copied()).collect()
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
    with_tangent(s, mix, rows_of)
}

/// A part of the tangent, by `take`. The solver's own matrix is left as it was.
fn with_tangent(s: &mut System<'_>, mix: TangentMix, take: fn(&Workspace) -> Vec<f64>) -> Vec<f64> {
    let work = &mut *s.work;
    let solved_with = work.matrix.values.clone();
    work.assemble(s.model, s.coefficients, mix);
    work.add_modal_damping(s.coefficients.c);
    let out = take(work);
    work.matrix.values = solved_with;
    out
}

/// The matrix with all its zeros, n x n by rows.
fn rows_of(work: &Workspace) -> Vec<f64> {
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
    out
}

/// The diagonal of the matrix, length n.
fn diagonal_of(work: &Workspace) -> Vec<f64> {
    let (pattern, values) = (&work.plan.pattern, &work.matrix.values);
    (0..work.plan.equations()).map(|i| pattern.place(i, i).map_or(0.0, |at| values[at])).collect()
}
