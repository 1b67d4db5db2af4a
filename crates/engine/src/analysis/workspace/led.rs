//! Degrees of freedom whose velocity is imposed.

use super::Workspace;
use crate::model::Model;
use crate::numeric::all_zero;

impl Workspace {
    /// Find the degrees of freedom whose velocity is imposed, and those that follow them alone. OpenSees knows no followers.
    pub(super) fn find_led(&mut self) {
        if !self.loads.moves {
            return;
        }
        let map = &self.plan.map;
        // A support is known to stand still.
        let (mut led, mut known) = (vec![false; self.spread.len()], map.held.clone());
        let mut moves = led.clone();
        for i in self.loads.imposed.iter().chain(&self.loads.linked) {
            led[i.dof] = i.follows_series();
            moves[i.dof] = i.has_rates();
        }
        for link in map.links.iter().filter(|link| !link.multi) {
            known[link.terms[0].0] = true;
        }
        let rows = map.dependents.iter().filter(|d| !d.held).map(|d| (d.dof, d.terms.clone()));
        let links = map.links.iter().filter(|link| link.multi).map(|link| {
            let terms = link.terms[1..].iter().map(|&(d, c)| (d, -c));
            (link.terms[0].0, terms.collect())
        });
        let is_compat = self.opensees.is_some();
        for (dof, terms) in rows.chain(links).filter(|_| !is_compat) {
            let terms: Vec<(usize, f64)> = terms;
            if !terms.iter().all(|(d, _)| moves[*d] || known[*d]) {
                continue;
            }
            let any = |of: &[bool]| terms.iter().any(|(d, _)| of[*d]);
            (led[dof], moves[dof], known[dof]) = (any(&led), any(&moves), true);
            if moves[dof] {
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
