//! Degrees of freedom whose velocity is imposed.

use super::Workspace;
use crate::model::Model;
use crate::numeric::all_zero;

impl Workspace {
    /// Find the degrees of freedom whose velocity is imposed, and those that follow them alone.
    pub(super) fn find_led(&mut self) {
        if !self.loads.moves {
            return;
        }
        let map = &self.plan.map;
        // A support is known to stand still.
        let (mut led, mut known) = (vec![false; self.spread.len()], map.held.clone());
        for i in self.loads.imposed.iter().chain(&self.loads.linked).filter(|i| i.follows_series()) {
            led[i.dof] = true;
        }
        for link in map.links.iter().filter(|link| !link.multi) {
            known[link.terms[0].0] = true;
        }
        let rows = map.dependents.iter().filter(|d| !d.held).map(|d| (d.dof, d.terms.clone()));
        let links = map.links.iter().filter(|link| link.multi).map(|link| {
            let terms = link.terms[1..].iter().map(|&(d, c)| (d, -c));
            (link.terms[0].0, terms.collect())
        });
        for (dof, terms) in rows.chain(links) {
            let terms: Vec<(usize, f64)> = terms;
            if !terms.iter().all(|(d, _)| led[*d] || known[*d]) {
                continue;
            }
            (led[dof], known[dof]) = (terms.iter().any(|(d, _)| led[*d]), true);
            if led[dof] && !self.plan.handler.eliminates() {
                self.followers.push((dof, terms));
            }
        }
        self.led = led;
    }

    /// Returns true if nothing has a velocity that elements depend on, in a static step from these velocities.
    pub(in crate::analysis) fn stands_still(&self, vel: &[f64]) -> bool {
        if self.loads.ground_moves {
            return false;
        }
        match self.loads.moves {
            true if self.elements.sees_velocity => false,
            true => vel.iter().zip(&self.led).all(|(v, led)| *led || *v == 0.0),
            false => all_zero(vel),
        }
    }

    /// Returns true if the nodes of an element may have a velocity in a step of an analysis: free ones of a transient analysis,
    /// and those whose motion is imposed in time.
    pub(in crate::analysis) fn may_move(&self, model: &Model, element: usize, transient: bool, elapses: bool) -> bool {
        let led = elapses && self.loads.is_driven();
        model.elements[element].dofs.iter().any(|&d| {
            let d = d as usize;
            self.loads.ground_moves
                || transient && !self.plan.map.terms(d).is_empty()
                || led && self.led.get(d).is_some_and(|led| *led)
        })
    }
}
