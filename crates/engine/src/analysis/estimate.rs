//! Estimates of a model before it is analysed: what a check compares with what is plausible.

use super::engine::Engine;
use super::reactions::ReactionKind;
use super::system::Coefficients;
use super::workspace::TangentMix;
use crate::element::Mass;
use crate::model::Tag;
use crate::solve::SINGULAR;

/// Loads at the committed time, and the displacements that they cause with the tangent of the committed state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LinearEstimate {
    /// Sum of the loads along each axis, those on elements included.
    pub load: [f64; 3],
    /// The largest translation: node, degree of freedom from 1, and value. `None` where the equations are singular.
    pub displacement: Option<(Tag, usize, f64)>,
}

impl Engine {
    /// Estimate the static response of the model as it is. `None` where it cannot be evaluated.
    pub fn linear_estimate(&mut self) -> Option<LinearEstimate> {
        let mut reactions = vec![];
        self.reactions(ReactionKind::Static, &mut reactions).ok()?;
        let mut load = [0.0; 3];
        for node in &self.model().nodes {
            let translations = node.dofs().zip(&mut load).take(node.ndm().min(node.ndf));
            translations.for_each(|(dof, sum)| *sum -= reactions[dof]);
        }
        Some(LinearEstimate { load, displacement: self.linear_displacement() })
    }

    /// The largest translation under the loads of the committed time.
    fn linear_displacement(&mut self) -> Option<(Tag, usize, f64)> {
        let time = self.state().time;
        let unbalanced = self.with_system(|system| {
            system.apply_loads(time)?;
            system.form_unbalance(true)?;
            Ok(system.work.b.clone())
        });
        let mut x = unbalanced.ok()?;
        let (model, _, work) = self.parts();
        let work = work?;
        work.assemble(model, Coefficients { k: 1.0, c: 0.0, m: 0.0 }, TangentMix::CURRENT);
        let stiffness = work.matrix.values.clone();
        let pivots = work.solver.factor(&work.plan.pattern, &stiffness);
        let is_regular = pivots.is_ok_and(|p| p.ratio > SINGULAR);
        let mut disp = vec![0.0; model.dofs()];
        if is_regular {
            work.solver.back_substitute(&mut x);
            work.plan.map.spread(&x[..work.plan.map.equations], &mut disp);
        }
        // The factors are not those of a step.
        work.solver.forget();
        let translations = model.nodes.iter().flat_map(|n| {
            let dofs = n.dofs().take(n.ndm().min(n.ndf)).enumerate();
            dofs.map(|(i, dof)| (n.tag, i + 1, disp[dof]))
        });
        let largest = translations.max_by(|a, b| a.2.abs().total_cmp(&b.2.abs()))?;
        (is_regular && largest.2.is_finite()).then_some(largest)
    }

    /// Mass that moves along each axis: of nodes, and of elements as they move as rigid bodies. Degrees of freedom that are
    /// held by a `fix` have none.
    pub fn moving_mass(&self) -> [f64; 3] {
        let model = self.model();
        let mut is_held = vec![false; model.dofs()];
        for fix in &model.fixes {
            if let Some(dof) = model.nodes[fix.node.0].dofs().nth(fix.dof) {
                is_held[dof] = true;
            }
        }
        let mut sum = [0.0; 3];
        for node in &model.nodes {
            for (i, _) in node.dofs().take(node.ndm().min(3)).enumerate().filter(|(_, dof)| !is_held[*dof]) {
                sum[i] += node.mass.get(i).copied().unwrap_or(0.0);
            }
        }
        for e in &model.elements {
            let mass = e.element.mass();
            let at = |i: usize, j: usize| match &mass {
                Mass::None => 0.0,
                Mass::Lumped(m) if i == j => m[i],
                Mass::Lumped(_) => 0.0,
                Mass::Consistent(m) => m[i * e.dofs.len() + j],
            };
            if matches!(mass, Mass::None) {
                continue;
            }
            // Places of the translations of the nodes among the degrees of freedom of the element.
            let mut first = 0;
            let mut places: [Vec<usize>; 3] = Default::default();
            for node in e.nodes.iter().map(|n| &model.nodes[n.0]) {
                let own = e.dofs[first..].iter().take_while(|d| node.dofs().contains(&(**d as usize))).count();
                for (i, dof) in node.dofs().take(node.ndm().min(3)).enumerate() {
                    let place = e.dofs[first..first + own].iter().position(|d| *d as usize == dof);
                    places[i].extend(place.filter(|_| !is_held[dof]).map(|p| first + p));
                }
                first += own;
            }
            for (sum, places) in sum.iter_mut().zip(&places) {
                *sum += places
                    .iter()
                    .flat_map(|i| places.iter().map(move |j| (*i, *j)))
                    .map(|(i, j)| at(i, j))
                    .sum::<f64>();
            }
        }
        sum
    }

    /// Stiffness of an element with two nodes along each axis, from the tangent of the virgin element. `None` for others.
    pub fn axis_stiffness(&self, tag: Tag) -> Option<[f64; 3]> {
        let model = self.model();
        let e = &model.elements[model.element(tag)?.0];
        let [_, j] = e.nodes[..] else { return None };
        let n = e.element.dofs();
        let mut tangent = vec![0.0; n * n];
        e.element.initial_tangent(&mut tangent);
        let mut along = [0.0; 3];
        for (i, k) in along.iter_mut().enumerate().take(model.nodes[j.0].ndm()) {
            let at = n / 2 + i;
            *k = tangent.get(at * n + at).copied()?;
        }
        Some(along)
    }
}
