//! Damping and inertia that never change, as matrices of the equations.

use super::{MassPlace, Workspace};
use crate::analysis::state::State;
use crate::assembly::{Pattern, Plan};
use crate::element::MAX_DOFS;
use crate::model::Model;
use crate::numeric::real::Real;

/// Fewer elements are not worth a matrix.
const FEW: usize = 8;

/// Velocities and accelerations of constrained degrees of freedom may be off by this part of the largest.
const ROUND_OFF: f64 = 1e-9;

/// Damping matrix and mass of the elements whose own never change: elastic ones, and those that are damped by the stiffness
/// of the virgin state.
#[derive(Debug)]
pub(in crate::analysis) struct SteadyMatrices {
    pub(in crate::analysis) damping: MatrixRows<f64>,
    pub(in crate::analysis) mass: MatrixRows<f64>,
    /// Elements with other damping.
    others: Vec<usize>,
    /// Time of the motion that was last looked at, and whether it follows that of the equations.
    follows: Option<(f64, bool)>,
    motion: Vec<f64>,
}

/// Entries of a matrix that are not zero, by rows.
#[derive(Debug)]
pub(in crate::analysis) struct MatrixRows<T> {
    start: Vec<usize>,
    columns: Vec<u32>,
    values: Vec<T>,
}

impl MatrixRows<f64> {
    /// Rows of a matrix with a pattern.
    fn new(pattern: &Pattern, values: &[f64]) -> Self {
        let mut rows = vec![vec![]; pattern.n];
        pattern.for_each(values, |row, column, value| {
            if value != 0.0 {
                rows[row].push((column as u32, value));
            }
        });
        let mut matrix = Self { start: vec![0], columns: vec![], values: vec![] };
        for row in rows {
            matrix.columns.extend(row.iter().map(|(column, _)| column));
            matrix.values.extend(row.iter().map(|(_, value)| value));
            matrix.start.push(matrix.values.len());
        }
        matrix
    }

    /// The matrices of several models as one; `None` where their entries are at different places.
    pub(in crate::analysis) fn joined<T>(all: &[&Self], join: impl Fn(usize) -> T) -> Option<MatrixRows<T>> {
        let first = all.first()?;
        let alike = |m: &&Self| m.start == first.start && m.columns == first.columns;
        let values = || (0..first.values.len()).map(join).collect();
        all.iter().all(alike).then(|| MatrixRows {
            start: first.start.clone(),
            columns: first.columns.clone(),
            values: values(),
        })
    }

    /// Value of an entry.
    pub(in crate::analysis) fn value(&self, i: usize) -> f64 {
        self.values[i]
    }
}

impl<T: Real> MatrixRows<T> {
    /// y -= factor A x. The sums are made of four side by side.
    #[inline(always)]
    pub(in crate::analysis) fn subtract_product(&self, factor: f64, x: &[T], y: &mut [T]) {
        for (y, row) in y.iter_mut().zip(self.start.windows(2)) {
            let (columns, rest_of_columns) = self.columns[row[0]..row[1]].as_chunks::<4>();
            let (values, rest_of_values) = self.values[row[0]..row[1]].as_chunks::<4>();
            let mut sums = [T::ZERO; 4];
            for (columns, values) in columns.iter().zip(values) {
                for i in 0..4 {
                    sums[i] += values[i] * x[columns[i] as usize];
                }
            }
            let mut rest = T::ZERO;
            for (&c, v) in rest_of_columns.iter().zip(rest_of_values) {
                rest += *v * x[c as usize];
            }
            *y -= ((sums[0] + sums[1]) + (sums[2] + sums[3]) + rest) * factor;
        }
    }
}

impl SteadyMatrices {
    /// The matrices of a model; `None` if few elements have them.
    fn new(work: &Workspace, model: &Model) -> Option<Self> {
        let plan = &work.plan;
        let zeros = || vec![0.0; plan.pattern.len()];
        let (mut damping, mut mass, mut others, mut count) = (zeros(), zeros(), vec![], 0);
        let mut full = [0.0; MAX_DOFS * MAX_DOFS];
        for (i, (e, m)) in
            model.elements.iter().zip(&work.elements.entries).enumerate().filter(|(_, (_, m))| m.is_dynamic)
        {
            let (r, n) = (&m.rayleigh.forces, e.dofs.len());
            if !m.linear && (r.beta_k != 0.0 || r.beta_kc != 0.0) {
                others.push(i);
                continue;
            }
            count += 1;
            let (stiffness, factor) = if m.linear {
                (&work.elements.tangent, r.beta_k + r.beta_k0 + r.beta_kc)
            } else {
                (&work.elements.initial, r.beta_k0)
            };
            if factor != 0.0 {
                plan.add_element(i, &stiffness[m.at..m.at + n * n], factor, &mut damping);
            }
            let own = match m.mass {
                MassPlace::None => continue,
                MassPlace::Consistent(at) => &work.elements.mass[at..at + n * n],
                MassPlace::Lumped(at) => {
                    full[..n * n].fill(0.0);
                    let diagonal = full.iter_mut().step_by(n + 1);
                    diagonal.zip(&work.elements.mass[at..at + n]).for_each(|(d, m)| *d = *m);
                    &full[..n * n]
                }
            };
            plan.add_element(i, own, 1.0, &mut mass);
            plan.add_element(i, own, r.alpha_m, &mut damping);
        }
        (count >= FEW).then(|| Self {
            damping: MatrixRows::new(&plan.pattern, &damping),
            mass: MatrixRows::new(&plan.pattern, &mass),
            others,
            follows: None,
            motion: vec![0.0; plan.equations()],
        })
    }

    /// Returns true if the motion of all degrees of freedom is that of the equations: it is not on moving supports, and may
    /// not be after a script has set velocities. It stays so within a step.
    fn motion_follows(&mut self, plan: &Plan, state: &State) -> bool {
        if let Some((_, follows)) = self.follows.filter(|(time, _)| *time == state.time) {
            return follows;
        }
        let follows = [&state.vel, &state.accel].into_iter().all(|field| {
            let slack = ROUND_OFF * field.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            (0..field.len()).all(|dof| {
                let own = |&(equation, c): &(u32, f64)| c * field[plan.map.dof_of[equation as usize]];
                (field[dof] - plan.map.terms(dof).iter().map(own).sum::<f64>()).abs() <= slack
            })
        });
        self.follows = Some((state.time, follows));
        follows
    }

    /// Subtracts the forces of a motion from those of the equations.
    fn subtract(&mut self, plan: &Plan, state: &State, inertia: f64, b: &mut [f64]) {
        for (matrix, field, factor) in [(&self.damping, &state.vel, 1.0), (&self.mass, &state.accel, inertia)] {
            if !matrix.values.is_empty() && factor != 0.0 {
                self.motion.iter_mut().zip(&plan.map.dof_of).for_each(|(m, &dof)| *m = field[dof]);
                matrix.subtract_product(factor, &self.motion, b);
            }
        }
    }
}

impl Workspace {
    /// Look at the motion again: a script has changed it.
    pub(in crate::analysis) fn motion_changed(&mut self) {
        self.elements.has_stepped = false;
        self.steady.iter_mut().for_each(|s| s.follows = None);
    }

    /// Find damping and inertia that never change, once for a plan.
    pub(super) fn find_steady(&mut self, model: &Model) {
        if !self.looked_for_steady {
            self.looked_for_steady = true;
            self.steady = SteadyMatrices::new(self, model).map(Box::new);
        }
    }

    /// Subtract damping and a share of the inertia of the elements from the unbalance of the equations.
    pub(super) fn subtract_dynamic(&mut self, model: &Model, state: &State, inertia: f64) {
        self.find_steady(model);
        let Some(mut steady) = self.steady.take() else {
            return (0..model.elements.len()).for_each(|i| self.subtract_dynamic_of(i, model, state, inertia));
        };
        if steady.motion_follows(&self.plan, state) {
            steady.subtract(&self.plan, state, inertia, &mut self.b);
            steady.others.iter().for_each(|&i| self.subtract_dynamic_of(i, model, state, inertia));
        } else {
            (0..model.elements.len()).for_each(|i| self.subtract_dynamic_of(i, model, state, inertia));
        }
        self.steady = Some(steady);
    }
}
