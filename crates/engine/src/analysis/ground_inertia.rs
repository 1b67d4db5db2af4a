//! Inertia forces of a uniform ground motion: M R times the acceleration of the ground.

use crate::element::Mass;
use crate::model::{ElementEntry, ElementId, Excitation, Model};
use std::collections::BTreeMap;

/// Forces on all degrees of freedom per unit of ground acceleration.
#[derive(Clone, Debug)]
pub(super) struct GroundInertia {
    /// Index of the pattern that gives the acceleration.
    pattern: usize,
    /// From the masses of the nodes.
    nodes: Vec<f64>,
    /// From the masses of the elements.
    elements: Vec<f64>,
    /// Forces that OpenSees counts once more; empty without `--compat opensees`.
    again: Vec<f64>,
    /// Forces that OpenSees leaves out of the reactions: of the masses of elements whose reported forces leave them out. Empty
    /// without `--compat opensees`.
    left_out: Vec<f64>,
    /// Forces that OpenSees takes off the reported force, by element; empty without `--compat opensees`.
    reported: BTreeMap<usize, Vec<f64>>,
}

/// M r of an element for a motion of all degrees of freedom.
fn element_mass_times(e: &ElementEntry, r: &[f64]) -> Vec<f64> {
    let of = |d: &u32| r[*d as usize];
    match e.element.mass() {
        Mass::None => vec![0.0; e.dofs.len()],
        Mass::Lumped(m) => e.dofs.iter().zip(&m).map(|(d, m)| m * of(d)).collect(),
        Mass::Consistent(m) => {
            m.chunks_exact(e.dofs.len()).map(|row| e.dofs.iter().zip(row).map(|(d, m)| m * of(d)).sum()).collect()
        }
    }
}

/// M r for a motion of all degrees of freedom: the masses of nodes and, unless `nodes_only`, of elements.
pub(super) fn mass_times(model: &Model, r: &[f64], nodes_only: bool) -> Vec<f64> {
    let mut force = vec![0.0; model.dofs()];
    for node in &model.nodes {
        for (dof, m) in node.dofs().zip(&node.mass) {
            force[dof] = m * r[dof];
        }
    }
    for e in model.elements.iter().filter(|_| !nodes_only) {
        for (&d, f) in e.dofs.iter().zip(element_mass_times(e, r)) {
            force[d as usize] += f;
        }
    }
    force
}

impl GroundInertia {
    /// For an excitation; with `compat` as OpenSees counts it.
    pub(super) fn new(model: &Model, pattern: usize, excitation: &Excitation, compat: bool) -> Self {
        let mut r = vec![0.0; model.dofs()];
        for node in &model.nodes {
            let influence = node.influence(excitation.direction);
            r[node.dofs()].iter_mut().zip(&influence).for_each(|(r, i)| *r = excitation.influence * i);
        }
        let nodes = mass_times(model, &r, true);
        let mut inertia = Self {
            pattern,
            nodes,
            elements: vec![0.0; model.dofs()],
            again: vec![],
            left_out: vec![],
            reported: BTreeMap::new(),
        };
        for (i, e) in model.elements.iter().enumerate() {
            let force = element_mass_times(e, &r);
            for (&d, f) in e.dofs.iter().zip(&force) {
                inertia.elements[d as usize] += f;
            }
            let slip = e.element.opensees().ground_inertia.filter(|_| compat);
            if compat && slip.is_none() && force.iter().any(|f| *f != 0.0) {
                inertia.left_out.resize(model.dofs(), 0.0);
                for (&d, f) in e.dofs.iter().zip(&force) {
                    inertia.left_out[d as usize] += f;
                }
            }
            if let Some(times) = slip {
                inertia.again.resize(model.dofs(), 0.0);
                for (&d, f) in e.dofs.iter().zip(&force) {
                    inertia.again[d as usize] += (times - 1.0) * f;
                }
                inertia.reported.insert(i, force);
            }
        }
        inertia
    }

    /// Add the forces, all of them, to `out`.
    pub(super) fn add(&self, factors: &[f64], out: &mut [f64]) {
        let a = factors[self.pattern];
        for part in [&self.nodes, &self.elements, &self.again] {
            out.iter_mut().zip(part).for_each(|(p, f)| *p -= a * f);
        }
    }

    /// Index of the pattern that gives the acceleration, and the forces on all degrees of freedom per unit of it: of the masses
    /// of nodes, and of elements. `None` where OpenSees counts some once more.
    pub(super) fn terms(&self) -> Option<(usize, [&[f64]; 2])> {
        self.again.is_empty().then_some((self.pattern, [&self.nodes, &self.elements]))
    }

    /// Take those that OpenSees counts once more off `out`; with `elements` all those of the elements.
    pub(super) fn take_off(&self, factors: &[f64], elements: bool, out: &mut [f64]) {
        let a = factors[self.pattern];
        let own: &[f64] = if elements { &self.elements } else { &self.left_out };
        for part in [own, &self.again] {
            out.iter_mut().zip(part).for_each(|(p, f)| *p += a * f);
        }
    }

    /// Add to the force of an element what OpenSees reports beside it.
    pub(super) fn report(&self, factors: &[f64], element: ElementId, force: &mut [f64]) {
        if let Some(f) = self.reported.get(&element.0) {
            force.iter_mut().zip(f).for_each(|(p, f)| *p += factors[self.pattern] * f);
        }
    }
}
