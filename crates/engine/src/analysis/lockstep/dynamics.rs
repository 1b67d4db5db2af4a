//! Inertia and damping of models side by side, and the steps of Newmark's method.

use super::{Models, Motion, Work};
use crate::analysis::ground_inertia::GroundInertia;
use crate::analysis::integrator::Newmark;
use crate::analysis::system::Coefficients;
use crate::analysis::workspace::{ConstantParts, MatrixRows};
use crate::assembly::Plan;
use crate::element::MAX_DOFS;
use crate::numeric::dot;
use crate::numeric::wide::{WIDTH, Wide};

/// Inertia and damping of all models, with their integrator.
#[derive(Debug)]
pub(super) struct Dynamics {
    newmark: Newmark,
    pub(super) coefficients: Coefficients,
    /// Degrees of freedom that are not held.
    free: Vec<usize>,
    /// Lumped masses of the nodes: degree of freedom, mass, mass-proportional damping.
    nodal: Vec<(usize, Wide, Wide)>,
    ground: Vec<GroundForce>,
    forces: ElementForces,
}

/// Forces of a uniform ground motion.
#[derive(Debug)]
struct GroundForce {
    /// Pattern that gives the acceleration.
    pattern: usize,
    /// Degree of freedom, and forces per unit of acceleration from the masses of nodes and of elements.
    forces: Vec<(usize, [Wide; 2])>,
}

/// Damping and inertia of the elements.
#[derive(Debug)]
enum ElementForces {
    /// Element by element.
    Each(Vec<DynamicElement>),
    /// Damping and mass as matrices of the equations, and the motion of these.
    Matrices { damping: MatrixRows<Wide>, mass: MatrixRows<Wide>, motion: Vec<Wide> },
}

/// Rayleigh damping and mass of an element.
#[derive(Debug)]
struct DynamicElement {
    index: usize,
    dofs: Vec<u32>,
    /// Place of its forces among those of all elements.
    start: usize,
    alpha_m: Wide,
    /// Stiffness that damps, n x n by rows; empty where there is none.
    stiffness: Vec<Wide>,
    factor: Wide,
    /// Mass: nothing, lumped by degrees of freedom, or n x n by rows.
    mass: Vec<Wide>,
}

/// Numbers of all models at one place of their lists, where an empty list stands for zeros.
pub(super) fn wide_of(all: &[&[f64]; WIDTH], i: usize) -> Wide {
    Wide(all.map(|own| own.get(i).copied().unwrap_or(0.0)))
}

/// Lists of all models, number by number. The longest says how many.
pub(super) fn wides_of(all: &[&[f64]; WIDTH]) -> Vec<Wide> {
    let len = all.iter().map(|own| own.len()).max().unwrap_or(0);
    (0..len).map(|i| wide_of(all, i)).collect()
}

/// Place of an element in the equations.
#[derive(Clone, Copy, Debug)]
pub(super) struct ElementPlace<'a> {
    pub(super) dofs: &'a [u32],
    /// Place of its forces among those of all elements.
    pub(super) start: usize,
}

impl Dynamics {
    /// Of models with the same nodes and elements; `None` where damping or mass take different forms in them.
    pub(super) fn new(
        newmark: &Newmark,
        dt: f64,
        plan: &Plan,
        all: &[&ConstantParts<'_>; WIDTH],
        ground: &[&[GroundInertia]; WIDTH],
        places: &[ElementPlace<'_>],
    ) -> Option<Self> {
        let dofs = |p: &ConstantParts<'_>| p.nodal.iter().map(|n| n.0).collect::<Vec<_>>();
        let own_dofs = dofs(all[0]);
        if all.iter().any(|p| dofs(p) != own_dofs) {
            return None;
        }
        let nodal = own_dofs
            .iter()
            .enumerate()
            .map(|(i, &dof)| (dof, Wide(all.map(|p| p.nodal[i].1)), Wide(all.map(|p| p.nodal[i].2))));
        let ground: Option<Vec<_>> =
            (0..ground[0].len()).map(|i| GroundForce::new(&ground.map(|g| g.get(i)))).collect();
        Some(Self {
            newmark: newmark.clone(),
            coefficients: newmark.coefficients_of_step(dt),
            free: (0..plan.map.held.len()).filter(|&i| !plan.map.held[i]).collect(),
            nodal: nodal.collect(),
            ground: ground?,
            forces: ElementForces::new(plan, all, places)?,
        })
    }

    /// Set velocities and accelerations at the end of a step of length `dt` in which nothing is displaced.
    #[inline(always)]
    pub(super) fn predict(&self, dt: f64, committed: &Motion, trial: &mut Motion) {
        for &dof in &self.free {
            let (vel, accel) = self.newmark.predict(dt, committed.vel[dof], committed.accel[dof]);
            (trial.vel[dof], trial.accel[dof]) = (vel, accel);
        }
    }

    /// Add the forces of the ground motions.
    #[inline(always)]
    pub(super) fn add_ground(&self, factors: &[f64], nodal: &mut [Wide]) {
        for g in &self.ground {
            for part in [0, 1] {
                for (dof, forces) in &g.forces {
                    nodal[*dof] -= forces[part] * factors[g.pattern];
                }
            }
        }
    }

    /// Subtract inertia and damping of the nodes from forces on all degrees of freedom.
    #[inline(always)]
    pub(super) fn subtract_nodal(&self, motion: &Motion, full: &mut [Wide]) {
        for &(dof, mass, alpha_m) in &self.nodal {
            full[dof] -= mass * (motion.accel[dof] + alpha_m * motion.vel[dof]);
        }
    }

    /// Subtract damping and inertia of the elements from the unbalance of the equations.
    #[inline(always)]
    pub(super) fn subtract_elements(&mut self, plan: &Plan, motion: &Motion, b: &mut [Wide]) {
        match &mut self.forces {
            ElementForces::Each(elements) => {
                for e in elements {
                    e.subtract(plan, motion, b);
                }
            }
            ElementForces::Matrices { damping, mass, motion: own } => {
                for (matrix, field) in [(damping, &motion.vel), (mass, &motion.accel)] {
                    for (m, &dof) in own.iter_mut().zip(&plan.map.dof_of) {
                        *m = field[dof];
                    }
                    matrix.subtract_product(1.0, own, b);
                }
            }
        }
    }
}

impl GroundForce {
    fn new(all: &[Option<&GroundInertia>; WIDTH]) -> Option<Self> {
        let mut terms = [(0, [&[][..]; 2]); WIDTH];
        for (terms, own) in terms.iter_mut().zip(all) {
            *terms = (*own)?.terms()?;
        }
        let pattern = terms[0].0;
        let parts = [0, 1].map(|part| wides_of(&terms.map(|(_, parts)| parts[part])));
        let forces = (0..parts[0].len()).map(|dof| (dof, [parts[0][dof], parts[1][dof]]));
        let acts = |(_, forces): &(usize, [Wide; 2])| forces.iter().any(|f| f.0.iter().any(|x| *x != 0.0));
        terms.iter().all(|t| t.0 == pattern).then(|| Self { pattern, forces: forces.filter(acts).collect() })
    }
}

impl ElementForces {
    fn new(plan: &Plan, all: &[&ConstantParts<'_>; WIDTH], places: &[ElementPlace<'_>]) -> Option<Self> {
        if all.iter().any(|p| p.steady.is_some() != all[0].steady.is_some()) {
            return None;
        }
        if all[0].steady.is_none() {
            let own = (0..places.len()).filter(|&i| all.iter().any(|p| p.elements[i].is_dynamic));
            return own.map(|i| DynamicElement::new(i, all, places[i])).collect::<Option<_>>().map(Self::Each);
        }
        let [damping, mass] = [false, true].map(|mass| {
            let own: Vec<&MatrixRows<f64>> =
                all.iter().filter_map(|p| p.steady).map(|s| if mass { &s.mass } else { &s.damping }).collect();
            MatrixRows::joined(&own, |i| Wide(std::array::from_fn(|lane| own[lane].value(i))))
        });
        Some(Self::Matrices { damping: damping?, mass: mass?, motion: vec![Wide::all(0.0); plan.equations()] })
    }
}

impl DynamicElement {
    fn new(index: usize, all: &[&ConstantParts<'_>; WIDTH], place: ElementPlace<'_>) -> Option<Self> {
        let own = all.map(|p| &p.elements[index]);
        if own.iter().any(|e| e.mass.len() != own[0].mass.len()) {
            return None;
        }
        Some(Self {
            index,
            dofs: place.dofs.to_vec(),
            start: place.start,
            alpha_m: Wide(own.map(|e| e.alpha_m)),
            stiffness: wides_of(&own.map(|e| e.damping.0)),
            factor: Wide(own.map(|e| e.damping.1)),
            mass: wides_of(&own.map(|e| e.mass)),
        })
    }

    #[inline(always)]
    fn subtract(&self, plan: &Plan, motion: &Motion, b: &mut [Wide]) {
        // Short arrays take no time to clear.
        match self.dofs.len() {
            0..=6 => self.subtract_of::<6>(plan, motion, b),
            7..=12 => self.subtract_of::<12>(plan, motion, b),
            _ => self.subtract_of::<MAX_DOFS>(plan, motion, b),
        }
    }

    /// The same with at most `N` degrees of freedom.
    #[inline(always)]
    fn subtract_of<const N: usize>(&self, plan: &Plan, motion: &Motion, b: &mut [Wide]) {
        let n = self.dofs.len();
        let zero = Wide::all(0.0);
        let (mut v, mut out) = ([zero; N], [zero; N]);
        for (v, &dof) in v.iter_mut().zip(&self.dofs) {
            *v = motion.vel[dof as usize];
        }
        for (o, row) in out.iter_mut().zip(self.stiffness.chunks_exact(n)) {
            *o += self.factor * dot(row, &v[..n]);
        }
        if !self.mass.is_empty() {
            for (v, &dof) in v.iter_mut().zip(&self.dofs) {
                *v = self.alpha_m * *v + motion.accel[dof as usize];
            }
        }
        if self.mass.len() == n {
            for ((o, m), a) in out.iter_mut().zip(&self.mass).zip(&v) {
                *o += *m * *a;
            }
        } else {
            for (o, row) in out.iter_mut().zip(self.mass.chunks_exact(n)) {
                *o += dot(row, &v[..n]);
            }
        }
        plan.subtract_force(self.index, self.start, &out, b);
    }
}

impl Models {
    /// Begin a step: the predicted motion of a transient analysis.
    #[inline(always)]
    pub(super) fn begin(&mut self) {
        if let Some(dynamics) = &self.dynamics {
            dynamics.predict(self.increment, &self.committed, &mut self.trial);
        }
    }

    /// Sum loads, resisting forces, inertia and damping to the unbalance.
    #[inline(always)]
    pub(super) fn sum_forces(&mut self) {
        let (map, Work { full, nodal, b, .. }) = (&self.plan.map, &mut self.work);
        let forces = match &self.dynamics {
            None => &*nodal,
            Some(dynamics) => {
                full.copy_from_slice(nodal);
                dynamics.subtract_nodal(&self.trial, full);
                &*full
            }
        };
        for (b, &dof) in b.iter_mut().zip(&map.dof_of) {
            *b = forces[dof];
        }
        self.plan.subtract_forces(&self.trial.force, b);
        if let Some(dynamics) = &mut self.dynamics {
            dynamics.subtract_elements(&self.plan, &self.trial, b);
        }
    }
}
