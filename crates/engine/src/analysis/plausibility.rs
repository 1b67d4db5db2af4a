//! Checks of an analysis against what it can mean.
//!
//! Each finds a result that follows from the input and is still not what any structure does. None changes a result.

use super::engine::Engine;
use super::system::Coefficients;
use super::workspace::TangentMix;
use crate::assembly::Handler;
use crate::element::{Mass, Overload};
use crate::model::{ElementEntry, ElementId, NodeId, Tag};
use crate::numeric::dot;

/// Rounds of the power iteration for the largest eigenvalue.
const MAX_ROUNDS: usize = 300;
/// Relative change of the eigenvalue at which the iteration ends.
const ACCURACY: f64 = 1e-7;

/// A gap of a constraint over the size of the model that is round-off: a displacement that no result shows.
const MIN_GAP: f64 = 1e-9;

/// A constraint that does not hold, by the displacements of the committed state.
#[derive(Clone, Debug, PartialEq)]
pub struct LooseConstraint {
    /// The node that should follow, and its degree of freedom from 1.
    pub node: (Tag, usize),
    /// The node that it should follow; `None` for a support.
    pub retained: Option<Tag>,
    /// Its displacement.
    pub found: f64,
    /// The displacement that the constraint wants.
    pub wanted: f64,
}

/// Power of an element in the committed state: force times length per time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ElementPower {
    /// Taken by its Rayleigh damping.
    pub damping: f64,
    /// Taken by its resisting force.
    pub force: f64,
}

impl Engine {
    /// The largest eigenvalue λ = ω² of K x = λ M x in the committed state, by power iteration. `None` where the mass cannot be
    /// inverted or the model cannot be analysed.
    ///
    /// The Rayleigh quotient never exceeds the eigenvalue.
    pub fn largest_eigenvalue(&mut self) -> Option<f64> {
        let handler = self.handler();
        self.prepare(handler).ok()?;
        self.respond_as_committed().ok()?;
        let (model, _, work) = self.parts();
        let work = work?;
        work.assemble(model, Coefficients { k: 1.0, c: 0.0, m: 0.0 }, TangentMix::CURRENT);
        let stiffness = work.matrix.values.clone();
        work.assemble(model, Coefficients { k: 0.0, c: 0.0, m: 1.0 }, TangentMix::CURRENT);
        let mass = work.matrix.values.clone();
        let n = work.plan.equations();
        if n == 0 || work.solver.factor(&work.plan.pattern, &mass).is_err() {
            work.solver.forget();
            return None;
        }
        // A start without symmetry has a share of every mode.
        let mut x: Vec<f64> = (0..n).map(|i| ((i * i + 1) as f64).sin()).collect();
        let (mut k_x, mut m_x) = (vec![0.0; n], vec![0.0; n]);
        let mut lambda = 0.0;
        for _ in 0..MAX_ROUNDS {
            work.plan.pattern.multiply(&stiffness, &x, &mut k_x);
            work.plan.pattern.multiply(&mass, &x, &mut m_x);
            let next = dot(&x, &k_x) / dot(&x, &m_x);
            let is_settled = (next - lambda).abs() <= ACCURACY * next.abs();
            lambda = next;
            if is_settled || !lambda.is_finite() {
                break;
            }
            x.copy_from_slice(&k_x);
            work.solver.back_substitute(&mut x);
            let size = x.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            x.iter_mut().for_each(|x| *x /= size);
        }
        // The factors are not those of a step.
        work.solver.forget();
        (lambda.is_finite() && lambda > 0.0).then_some(lambda)
    }

    /// The constraint that is furthest from being held, where penalties hold them: by more than `limit` of the largest
    /// displacement, of `earlier` displacements too, and by more than round-off of the size of the model.
    pub fn loose_constraint(&self, limit: f64, earlier: f64) -> Option<LooseConstraint> {
        let Some(Handler::Penalty { .. }) = self.setup().map(|s| s.handler) else { return None };
        let (model, disp) = (self.model(), &self.state().disp);
        let at = |node: NodeId, dof: usize| model.nodes[node.0].dofs().nth(dof).map_or(0.0, |d| disp[d]);
        let name = |node: NodeId| model.nodes[node.0].tag;
        let held = model.fixes.iter().map(|f| LooseConstraint {
            node: (name(f.node), f.dof + 1),
            retained: None,
            found: at(f.node, f.dof),
            wanted: 0.0,
        });
        let tied = model.multi_points.iter().flat_map(|m| {
            m.constrained_dofs.iter().enumerate().map(move |(i, &dof)| LooseConstraint {
                node: (name(m.constrained), dof + 1),
                retained: Some(name(m.retained)),
                found: at(m.constrained, dof),
                wanted: m.row(i).map(|(dof, c)| c * at(m.retained, dof)).sum(),
            })
        });
        let all: Vec<LooseConstraint> = held.chain(tied).collect();
        let largest = earlier.max(self.largest_displacement());
        let gap = |l: &LooseConstraint| (l.found - l.wanted).abs();
        let worst = all.into_iter().max_by(|a, b| gap(a).total_cmp(&gap(b)))?;
        (gap(&worst) > (limit * largest).max(MIN_GAP * self.size())).then_some(worst)
    }

    /// The largest displacement of the committed state, without sign.
    pub fn largest_displacement(&self) -> f64 {
        self.state().disp.iter().fold(0.0f64, |m, d| m.max(d.abs()))
    }

    /// The longest side of the box around the nodes.
    fn size(&self) -> f64 {
        let side = |axis: usize| {
            let at = self.model().nodes.iter().map(|n| n.place()[axis]);
            at.clone().fold(f64::NEG_INFINITY, f64::max) - at.fold(f64::INFINITY, f64::min)
        };
        (0..3).map(side).fold(0.0, f64::max)
    }

    /// The Euler loads of the beams that have one.
    pub fn euler_loads(&self) -> Vec<(ElementId, f64)> {
        let all = self.model().elements.iter().enumerate();
        all.filter_map(|(i, e)| Some((ElementId(i), e.element.euler_load()?))).collect()
    }

    /// The first beam whose compression in the committed state exceeds its Euler load, with both loads.
    pub fn buckled_beam(&self, euler_loads: &[(ElementId, f64)]) -> Option<(&ElementEntry, Overload)> {
        let model = self.model();
        let overload = |e: &ElementEntry, critical: f64| {
            let [i, j] = e.nodes[..] else { return None };
            let (i, j) = (&model.nodes[i.0].coords, &model.nodes[j.0].coords);
            let force = self.state().force.get(e.force.clone())?;
            let axis = || i.iter().zip(j).map(|(i, j)| j - i);
            // The node pushes the end i towards the end j.
            let along: f64 = axis().zip(force).map(|(x, f)| x * f).sum();
            if along <= 0.0 {
                return None;
            }
            let load = along / axis().map(|x| x * x).sum::<f64>().sqrt();
            (load > critical).then_some(Overload { load, critical })
        };
        euler_loads
            .iter()
            .map(|(id, load)| (&model.elements[id.0], load))
            .find_map(|(e, load)| Some((e, overload(e, *load)?)))
    }

    /// Returns true if something moves with a mass in a direction from 0: translations, then rotations. A mass at a degree of
    /// freedom that is held does not move.
    pub fn has_mass_along(&self, direction: usize) -> bool {
        let model = self.model();
        let is_held = |i: usize| model.fixes.iter().any(|f| f.node.0 == i && f.dof == direction);
        let has = |mass: Mass| match mass {
            Mass::None => false,
            Mass::Lumped(m) | Mass::Consistent(m) => m.iter().any(|m| *m != 0.0),
        };
        let mut with_mass =
            model.nodes.iter().enumerate().filter(|(_, n)| n.mass.get(direction).is_some_and(|m| *m != 0.0));
        with_mass.any(|(i, _)| !is_held(i)) || model.elements.iter().any(|e| has(e.element.mass()))
    }

    /// Power of an element in the committed state; none before the first step.
    pub fn element_power(&self, id: ElementId) -> ElementPower {
        let Some(work) = self.workspace() else { return ElementPower::default() };
        let e = &self.model().elements[id.0];
        let velocity = |d: &u32| self.state().vel[*d as usize];
        let power = |force: &[f64]| e.dofs.iter().zip(force).map(|(d, f)| velocity(d) * f).sum();
        ElementPower {
            damping: power(&work.rayleigh_force(self.model(), id, self.state())),
            force: power(&self.state().force[e.force.clone()]),
        }
    }
}
