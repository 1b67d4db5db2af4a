//! Everything about the equations that does not change from step to step.

use super::dofs::{DofError, DofMap, Handler, Link, MpScope};
use super::pattern::{Pattern, Storage};
use crate::model::Model;
use crate::numeric::real::Real;
use std::ops::Range;

/// Below this many equations a dense matrix is faster than a sparse one (see `benches/`).
const DENSE_LIMIT: usize = 36;

/// Places of the entries of one element's matrix.
#[derive(Clone, Debug, Default)]
struct Scatter {
    /// Its part of `from` and `to`.
    entries: Range<usize>,
    /// Start of its part of `coefs`, where they are not all one.
    coefs: Option<usize>,
    /// Its part of `forces`.
    forces: Range<usize>,
}

/// Equations of a force of an element: none for a degree of freedom that is held.
#[derive(Clone, Copy, Debug)]
struct ForceTerm {
    /// Place among the forces of all elements.
    from: u32,
    equation: u32,
    coef: f64,
}

/// Numbering, pattern and scatter maps of a model under a constraint handler.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Role of each degree of freedom.
    pub map: DofMap,
    /// Pattern of the matrix.
    pub pattern: Pattern,
    /// The handler it was made for.
    pub handler: Handler,
    scatters: Vec<Scatter>,
    from: Vec<u16>,
    to: Vec<u32>,
    coefs: Vec<f64>,
    forces: Vec<ForceTerm>,
    /// Equations of the multipliers that [`Handler::Lagrange`] adds.
    pub multipliers: usize,
}

impl Plan {
    /// Make the plan. `dense` forces a dense matrix or a sparse one.
    ///
    /// # Errors
    /// Multi-point constraints that contradict each other.
    pub fn new(
        model: &Model,
        handler: Handler,
        scope: MpScope,
        homogeneous: bool,
        dense: Option<bool>,
    ) -> Result<Self, DofError> {
        let map = DofMap::new(model, handler, scope, homogeneous)?;
        let multipliers = if matches!(handler, Handler::Lagrange { .. }) { map.links.len() } else { 0 };
        let n = map.equations + multipliers;
        let symmetric = model.elements.iter().all(|e| e.element.traits().symmetric);
        let storage = match (dense.unwrap_or(n <= DENSE_LIMIT), symmetric && multipliers == 0) {
            (true, _) => Storage::Dense,
            (false, true) => Storage::Upper,
            (false, false) => Storage::Full,
        };
        let mut groups: Vec<Vec<u32>> =
            model.elements.iter().map(|e| equations(&map, e.dofs.iter().map(|&d| d as usize))).collect();
        for (i, link) in map.links.iter().enumerate() {
            let mut g = equations(&map, link.terms.iter().map(|t| t.0));
            if multipliers > 0 {
                g.push((map.equations + i) as u32);
            }
            groups.push(g);
        }
        // Lumped masses of a node join the equations that its degrees of freedom are made of.
        for node in &model.nodes {
            groups.extend(
                node.dofs().map(|d| map.terms(d)).filter(|t| t.len() > 1).map(|t| t.iter().map(|t| t.0).collect()),
            );
        }
        let pattern = Pattern::new(n, storage, groups.iter().map(Vec::as_slice));
        let mut plan = Self {
            map,
            pattern,
            handler,
            scatters: vec![],
            from: vec![],
            to: vec![],
            coefs: vec![],
            forces: vec![],
            multipliers,
        };
        plan.scatters = model.elements.iter().map(|e| plan.scatter_of(&e.dofs, e.force.start)).collect();
        Ok(plan)
    }

    /// Number of equations, multipliers included.
    pub fn equations(&self) -> usize {
        self.pattern.n
    }

    fn scatter_of(&mut self, dofs: &[u32], force: usize) -> Scatter {
        let start = self.to.len();
        let n = dofs.len();
        let mut coefs = vec![];
        for (i, &di) in dofs.iter().enumerate() {
            for (j, &dj) in dofs.iter().enumerate() {
                for &(row, ci) in self.map.terms(di as usize) {
                    for &(col, cj) in self.map.terms(dj as usize) {
                        let upper_only = self.pattern.storage == Storage::Upper && row > col;
                        if let Some(to) = self.pattern.place(row as usize, col as usize).filter(|_| !upper_only) {
                            self.from.push((i * n + j) as u16);
                            self.to.push(to as u32);
                            coefs.push(ci * cj);
                        }
                    }
                }
            }
        }
        let entries = start..self.to.len();
        let first = self.forces.len();
        for (i, &d) in dofs.iter().enumerate() {
            let terms = self.map.terms(d as usize).iter();
            let from = (force + i) as u32;
            self.forces.extend(terms.map(|&(equation, coef)| ForceTerm { from, equation, coef }));
        }
        let forces = first..self.forces.len();
        if coefs.iter().all(|&c| c == 1.0) {
            return Scatter { entries, coefs: None, forces };
        }
        let at = self.coefs.len();
        self.coefs.append(&mut coefs);
        Scatter { entries, coefs: Some(at), forces }
    }

    /// Subtract the forces of all elements from the forces of the equations.
    #[inline]
    pub fn subtract_forces<T: Real>(&self, all: &[T], equations: &mut [T]) {
        for t in &self.forces {
            equations[t.equation as usize] -= all[t.from as usize] * t.coef;
        }
    }

    /// Subtract other forces of an element, whose own begin at `start` among those of all elements.
    #[inline]
    pub fn subtract_force<T: Real>(&self, element: usize, start: usize, force: &[T], equations: &mut [T]) {
        for t in &self.forces[self.scatters[element].forces.clone()] {
            equations[t.equation as usize] -= force[t.from as usize - start] * t.coef;
        }
    }

    /// Entries of an element's matrix (n x n by rows) in the system matrix: place in the one, place in the other, coefficient.
    pub fn entries(&self, element: usize) -> impl Iterator<Item = (u16, u32, f64)> + '_ {
        let s = &self.scatters[element];
        let coef = move |k: usize| s.coefs.map_or(1.0, |at| self.coefs[at + k]);
        let places = self.from[s.entries.clone()].iter().zip(&self.to[s.entries.clone()]);
        places.enumerate().map(move |(k, (&from, &to))| (from, to, coef(k)))
    }

    /// Add `factor` times an element's matrix (n x n by rows) to the values of the system matrix.
    #[inline]
    pub fn add_element<T: Real>(&self, element: usize, matrix: &[T], factor: f64, values: &mut [T]) {
        let s = &self.scatters[element];
        let from = &self.from[s.entries.clone()];
        let to = &self.to[s.entries.clone()];
        match s.coefs {
            None => {
                for (&f, &t) in from.iter().zip(to) {
                    values[t as usize] += matrix[f as usize] * factor;
                }
            }
            Some(at) => {
                for ((&f, &t), c) in from.iter().zip(to).zip(&self.coefs[at..at + from.len()]) {
                    values[t as usize] += matrix[f as usize] * (factor * c);
                }
            }
        }
    }

    /// Add a value on the diagonal at a degree of freedom (a lumped mass).
    pub fn add_diagonal(&self, dof: usize, value: f64, values: &mut [f64]) {
        self.add_outer(&[(dof, 1.0)], value, values);
    }

    /// Add `value` aᵀ a for a row vector `a` over degrees of freedom.
    pub fn add_outer(&self, a: &[(usize, f64)], value: f64, values: &mut [f64]) {
        for &(di, ai) in a {
            for &(dj, aj) in a {
                for &(row, ci) in self.map.terms(di) {
                    for &(col, cj) in self.map.terms(dj) {
                        if self.pattern.storage == Storage::Upper && row > col {
                            continue;
                        }
                        if let Some(to) = self.pattern.place(row as usize, col as usize) {
                            values[to] += value * ai * ci * aj * cj;
                        }
                    }
                }
            }
        }
    }

    /// Add the constraints that the handler keeps in the equations; `factor` multiplies their stiffness.
    pub fn add_links(&self, factor: f64, values: &mut [f64]) {
        match self.handler {
            Handler::Penalty { single, multi } => {
                for link in &self.map.links {
                    self.add_outer(&link.terms, factor * if link.multi { multi } else { single }, values);
                }
            }
            // The constraint equations themselves, whatever the coefficients of the motion; a mass matrix has none.
            Handler::Lagrange { single, multi } if factor != 0.0 => {
                for (i, link) in self.map.links.iter().enumerate() {
                    let row = self.map.equations + i;
                    let alpha = if link.multi { multi } else { single };
                    for &(dof, c) in &link.terms {
                        for &(e, k) in self.map.terms(dof) {
                            for (a, b) in [(row, e as usize), (e as usize, row)] {
                                if let Some(to) = self.pattern.place(a, b) {
                                    values[to] += alpha * c * k;
                                }
                            }
                        }
                    }
                }
            }
            Handler::Lagrange { .. } | Handler::Plain | Handler::Transformation => {}
        }
    }

    /// Add the forces of the constraints that the handler keeps to the unbalance: `value` gives the value of a
    /// constraint, `disp` has the displacements of all degrees of freedom, `multipliers` their forces.
    #[inline]
    pub fn add_link_forces(
        &self,
        value: impl Fn(&Link) -> f64,
        disp: &[f64],
        multipliers: &[f64],
        unbalance: &mut [f64],
    ) {
        for (i, link) in self.map.links.iter().enumerate() {
            let miss = value(link) - link.terms.iter().map(|&(d, c)| c * disp[d]).sum::<f64>();
            let force = match self.handler {
                Handler::Penalty { single, multi } => miss * if link.multi { multi } else { single },
                Handler::Lagrange { single, multi } => {
                    let alpha = if link.multi { multi } else { single };
                    unbalance[self.map.equations + i] += alpha * miss;
                    -alpha * multipliers[i]
                }
                Handler::Plain | Handler::Transformation => return,
            };
            for &(dof, c) in &link.terms {
                for &(e, k) in self.map.terms(dof) {
                    unbalance[e as usize] += force * c * k;
                }
            }
        }
    }

    /// The equation in words, for a message: the degree of freedom that it moves.
    pub fn equation_name(&self, model: &Model, equation: usize) -> String {
        match self.map.dof_of.get(equation) {
            Some(&dof) => model.dof_name(dof),
            None => match self.map.links.get(equation - self.map.equations) {
                Some(link) => format!("the constraint on {}", model.dof_name(link.terms[0].0)),
                None => format!("equation {}", equation + 1),
            },
        }
    }
}

/// The equations that some degrees of freedom are made of, each once.
fn equations(map: &DofMap, dofs: impl Iterator<Item = usize>) -> Vec<u32> {
    let mut e: Vec<u32> = dofs.flat_map(|d| map.terms(d).iter().map(|t| t.0)).collect();
    e.sort_unstable();
    e.dedup();
    e
}
