//! Constraint handlers: degrees of freedom that are unknowns, that are imposed, and that follow others.

use super::opensees::{self, Row, TransformedNode};
use crate::model::{Model, Tag};
use std::fmt;

/// Method by which constraints enter the equations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Handler {
    /// Constrained degrees of freedom are taken out of the equations. OpenSees' `Plain` is this for constraints that
    /// hold at zero or join two degrees of freedom one to one.
    Plain,
    /// Constrained degrees of freedom are taken out of the equations.
    Transformation,
    /// Stiff springs hold the constraints: factors for single-point and multi-point constraints.
    Penalty {
        /// Stiffness of single-point constraints.
        single: f64,
        /// Stiffness of multi-point constraints.
        multi: f64,
    },
    /// One more unknown for each constraint, its force; the constraint equations are multiplied by the factors.
    Lagrange {
        /// Factor of single-point constraints.
        single: f64,
        /// Factor of multi-point constraints.
        multi: f64,
    },
}

impl Handler {
    /// Returns true if constrained degrees of freedom leave the equations.
    pub fn eliminates(self) -> bool {
        matches!(self, Self::Plain | Self::Transformation)
    }
}

/// Multi-point constraints that count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MpScope {
    /// All of them.
    All,
    /// Only the first on each constrained node, as OpenSees' `Transformation` has it. A degree of freedom that is held as
    /// well stands still, but its forces and stiffness go to what it follows. Chains are not multiplied out.
    FirstOfNode,
    /// Only those that make displacements equal, as OpenSees' `Plain` has it.
    Identities,
}

/// A degree of freedom whose displacement a load pattern (or a ground motion) imposes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Imposed {
    /// Global degree of freedom.
    pub dof: usize,
    /// The pattern.
    pub pattern: Tag,
    /// Place among the motions of the pattern.
    pub index: usize,
}

/// A constraint that a handler keeps in the equations: Σ coefficient · u = value.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// Global degrees of freedom and coefficients; the first is the constrained one, with coefficient 1.
    pub terms: Vec<(usize, f64)>,
    /// Source of the value; `None` for zero.
    pub imposed: Option<Imposed>,
    /// It is a multi-point constraint.
    pub multi: bool,
}

/// Why the constraints make no sense.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DofError {
    /// Multi-point constraints lead in a circle through this degree of freedom.
    Circle(usize),
    /// A degree of freedom follows two others.
    Twice(usize),
}

impl DofError {
    /// In words.
    pub fn message(&self, model: &Model) -> String {
        match self {
            Self::Circle(dof) => format!("multi-point constraints lead in a circle through {}", model.dof_name(*dof)),
            Self::Twice(dof) => format!("{} follows two nodes by multi-point constraints", model.dof_name(*dof)),
        }
    }
}

impl fmt::Display for DofError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

/// A degree of freedom as a linear function of others.
#[derive(Clone, Debug, PartialEq)]
pub struct Dependent {
    /// Global degree of freedom that follows.
    pub dof: usize,
    /// Degrees of freedom that it follows, and coefficients; none of them is dependent after it in the list.
    pub terms: Vec<(usize, f64)>,
    /// It is held too: it hands its forces on and does not move ([`MpScope::FirstOfNode`]).
    pub held: bool,
}

/// Role of each degree of freedom.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DofMap {
    /// Number of equations that are motions of degrees of freedom.
    pub equations: usize,
    /// Degree of freedom of each of them.
    pub dof_of: Vec<usize>,
    /// For each degree of freedom the range of its terms.
    start: Vec<u32>,
    /// Terms: equation and coefficient.
    terms: Vec<(u32, f64)>,
    /// Imposed degrees of freedom that are out of the equations.
    pub imposed: Vec<Imposed>,
    /// Degrees of freedom that follow others, in an order in which they can be worked out.
    pub dependents: Vec<Dependent>,
    /// Constraints that stay in the equations.
    pub links: Vec<Link>,
    /// Degrees of freedom that are out of the equations because a single-point constraint holds them, homogeneous or
    /// not.
    pub held: Vec<bool>,
    /// Constrained nodes by rising tag, under [`MpScope::FirstOfNode`] only.
    pub transformed: Vec<TransformedNode>,
}

impl DofMap {
    /// Work out the map.
    ///
    /// `homogeneous` lets motions that patterns impose hold their degrees of freedom at the value they have, as
    /// OpenSees' `Plain` handler does.
    ///
    /// # Errors
    /// Multi-point constraints that contradict each other.
    pub fn new(model: &Model, handler: Handler, scope: MpScope, homogeneous: bool) -> Result<Self, DofError> {
        let n = model.dofs();
        let mut held = vec![false; n];
        let mut imposed: Vec<Option<Imposed>> = vec![None; n];
        for f in &model.fixes {
            held[model.nodes[f.node.0].offset + f.dof] = true;
        }
        for (&tag, p) in &model.patterns {
            for (index, m) in p.motions.iter().enumerate() {
                let dof = model.nodes[m.node.0].offset + m.dof;
                held[dof] = true;
                imposed[dof] = Some(Imposed { dof, pattern: tag, index });
            }
        }
        let (rows, transformed) = match scope {
            MpScope::FirstOfNode => {
                opensees::frozen(model, &held).into_iter().for_each(|dof| held[dof] = true);
                opensees::rows(model, &held, |dof| held[dof] && imposed[dof].is_none())
            }
            MpScope::All | MpScope::Identities => (multi_point_rows(model, scope), vec![]),
        };
        let mut map = Self { held, transformed, ..Self::default() };
        if handler.eliminates() {
            map.eliminate(rows, imposed, homogeneous, scope == MpScope::FirstOfNode)?;
        } else {
            let single = |dof: usize| Link { terms: vec![(dof, 1.0)], imposed: imposed[dof], multi: false };
            map.links = (0..n).filter(|&d| map.held[d]).map(single).collect();
            map.held.fill(false);
            map.links.extend(rows.into_iter().map(|(dof, terms)| {
                let all = std::iter::once((dof, 1.0)).chain(terms.into_iter().map(|(d, c)| (d, -c)));
                Link { terms: all.collect(), imposed: None, multi: true }
            }));
            map.dof_of = (0..n).collect();
            map.start = (0..=n as u32).collect();
            map.terms = (0..n as u32).map(|e| (e, 1.0)).collect();
        }
        map.equations = map.dof_of.len();
        Ok(map)
    }

    fn eliminate(
        &mut self,
        rows: Vec<Row>,
        imposed: Vec<Option<Imposed>>,
        homogeneous: bool,
        ties_of_held: bool,
    ) -> Result<(), DofError> {
        let n = self.held.len();
        let mut follows: Vec<Option<Vec<(usize, f64)>>> = vec![None; n];
        for (dof, terms) in rows {
            // A support on a constrained degree of freedom wins, as in OpenSees.
            if self.held[dof] && !ties_of_held {
                continue;
            }
            if follows[dof].is_some() {
                return Err(DofError::Twice(dof));
            }
            follows[dof] = Some(terms);
        }
        self.order_dependents(&mut follows)?;
        if !homogeneous {
            self.imposed = imposed.into_iter().flatten().collect();
        }
        let dependent = {
            let mut d = vec![false; n];
            self.dependents.iter().for_each(|x| d[x.dof] = true);
            d
        };
        let mut equation = vec![None; n];
        for dof in (0..n).filter(|&d| !self.held[d] && !dependent[d]) {
            equation[dof] = Some(self.dof_of.len() as u32);
            self.dof_of.push(dof);
        }
        // Terms of dependents are those of what they follow.
        let mut own: Vec<Vec<(u32, f64)>> = equation.iter().map(|e| e.iter().map(|&e| (e, 1.0)).collect()).collect();
        for d in &self.dependents {
            let mut sum: Vec<(u32, f64)> = vec![];
            for &(from, c) in &d.terms {
                for &(e, k) in &own[from] {
                    match sum.iter_mut().find(|(x, _)| *x == e) {
                        Some((_, v)) => *v += c * k,
                        None => sum.push((e, c * k)),
                    }
                }
            }
            own[d.dof] = sum;
        }
        self.start = std::iter::once(0)
            .chain(own.iter().scan(0, |at, t| {
                *at += t.len() as u32;
                Some(*at)
            }))
            .collect();
        self.terms = own.into_iter().flatten().collect();
        Ok(())
    }

    /// Depth-first, so that chains are worked out from their ends; the depth is the length of a chain of constraints.
    fn order_dependents(&mut self, follows: &mut [Option<Vec<(usize, f64)>>]) -> Result<(), DofError> {
        #[derive(Clone, Copy, PartialEq)]
        enum Mark {
            New,
            Open,
            Done,
        }
        let mut mark = vec![Mark::New; follows.len()];
        for root in 0..follows.len() {
            let mut stack = vec![(root, 0)];
            while let Some((dof, next)) = stack.pop() {
                let Some(terms) = &follows[dof] else { continue };
                if mark[dof] == Mark::Done {
                    continue;
                }
                mark[dof] = Mark::Open;
                if let Some(&(to, _)) = terms.get(next) {
                    stack.push((dof, next + 1));
                    if mark[to] == Mark::Open {
                        return Err(DofError::Circle(to));
                    }
                    stack.push((to, 0));
                } else {
                    mark[dof] = Mark::Done;
                    let held = self.held[dof];
                    self.dependents.push(Dependent { dof, terms: follows[dof].take().unwrap_or_default(), held });
                }
            }
        }
        Ok(())
    }

    /// Equations that a degree of freedom is made of, with coefficients; none for one that is held.
    #[inline]
    pub fn terms(&self, dof: usize) -> &[(u32, f64)] {
        &self.terms[self.start[dof] as usize..self.start[dof + 1] as usize]
    }

    /// Sum a vector over degrees of freedom into equations: out = Tᵀ full.
    #[inline]
    pub fn condense(&self, full: &[f64], out: &mut [f64]) {
        for (o, &dof) in out.iter_mut().zip(&self.dof_of) {
            *o = full[dof];
        }
        for d in &self.dependents {
            for &(e, c) in self.terms(d.dof) {
                out[e as usize] += c * full[d.dof];
            }
        }
    }

    /// Spread a vector over equations to the degrees of freedom: full = T x, zero where a degree of freedom is held.
    pub fn spread(&self, x: &[f64], full: &mut [f64]) {
        full.fill(0.0);
        for (x, &dof) in x.iter().zip(&self.dof_of) {
            full[dof] = *x;
        }
        self.follow(full);
    }

    /// Work out the degrees of freedom that follow others.
    pub fn follow(&self, full: &mut [f64]) {
        for d in self.dependents.iter().filter(|d| !d.held) {
            full[d.dof] = d.terms.iter().map(|&(from, c)| c * full[from]).sum();
        }
    }

    /// Values of the equations' own degrees of freedom.
    pub fn gather(&self, full: &[f64], out: &mut [f64]) {
        for (o, &dof) in out.iter_mut().zip(&self.dof_of) {
            *o = full[dof];
        }
    }
}

/// Rows of the multi-point constraints: the degree of freedom that follows, and what it follows.
fn multi_point_rows(model: &Model, scope: MpScope) -> Vec<Row> {
    let mut rows = vec![];
    for mp in model.multi_points.iter().filter(|mp| scope != MpScope::Identities || mp.is_identity()) {
        let (c, r) = (model.nodes[mp.constrained.0].offset, model.nodes[mp.retained.0].offset);
        for (i, &dof) in mp.constrained_dofs.iter().enumerate() {
            rows.push((c + dof, mp.row(i).filter(|(_, k)| *k != 0.0).map(|(d, k)| (r + d, k)).collect()));
        }
    }
    rows
}
