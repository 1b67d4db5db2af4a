//! Columns watched by springs: after each step the springs learn the committed response of their column.

use super::State;
use crate::element::Snapshot;
use crate::material::{ColumnResponse, LimitCurve, LimitDeformation, ObservedColumns};
use crate::model::{ElementEntry, Model};

impl State {
    /// Shows the committed response of columns to the laws that watch them, which changes their histories.
    pub(super) fn watch(&mut self, model: &Model) {
        for e in model.elements.iter().filter(|e| !e.limit_curves.is_empty()) {
            let responses: Vec<_> = e.limit_curves.iter().map(|curve| self.seen(model, curve)).collect();
            let columns = ObservedColumns { curves: &e.limit_curves, responses: &responses };
            e.element.observe(&mut self.history[e.state.clone()], &columns);
        }
    }

    /// Response of the column of a limit curve. `None` if the model lacks its element or nodes.
    fn seen(&self, model: &Model, curve: &LimitCurve) -> Option<ColumnResponse> {
        let column = &model.elements[model.element(curve.element)?.0];
        let mut seen = ColumnResponse::default();
        let force = self.response(column, "localForce")?;
        seen.force.iter_mut().zip(force).for_each(|(own, f)| *own = f);
        let difference = |nodes: [i32; 2], dof: usize| {
            let mut u = [0.0; 2];
            for (u, tag) in u.iter_mut().zip(nodes) {
                let node = &model.nodes[model.node(tag)?.0];
                *u = *self.disp.get(node.offset + dof).filter(|_| dof < node.ndf)?;
            }
            Some((u[1] - u[0]).abs())
        };
        match curve.deformation {
            LimitDeformation::ChordRotation => {
                let basic = self.response(column, "basicDeformation")?;
                seen.deformation = basic.get(1)?.abs().max(basic.get(2)?.abs());
            }
            LimitDeformation::Drift { nodes, dof, along } => {
                let at = |tag| Some(*model.nodes[model.node(tag)?.0].coords.get(along)?);
                let height: f64 = (at(nodes[1])? - at(nodes[0])?).abs();
                seen.per_height = if height > 0.0 { 1.0 / height } else { 0.0 };
                seen.deformation = difference(nodes, dof)? * seen.per_height;
            }
            LimitDeformation::Rotation { nodes, dof } => seen.deformation = difference(nodes, dof)?,
        }
        Some(seen)
    }

    /// Committed response of an element by its name.
    fn response(&self, e: &ElementEntry, name: &str) -> Option<Vec<f64>> {
        let probe = e.element.probe(&[name])?;
        let disp: Vec<f64> = e.dofs.iter().map(|&d| self.disp[d as usize]).collect();
        let snapshot = Snapshot {
            disp: &disp,
            state: &self.history[e.state.clone()],
            force: &self.force[e.force.clone()],
            load: &self.element_load[e.load.clone()],
        };
        let mut out = vec![0.0; probe.len()];
        e.element.read(&probe.path, &snapshot, &mut out);
        Some(out)
    }
}

impl Model {
    /// The first limit curve without its column: tags of the spring and of the element that the model lacks, or that has
    /// not the responses or nodes that the curve names.
    pub fn unwatched(&self) -> Option<(i32, i32)> {
        let watched = |curve: &LimitCurve| {
            let mut state = State::default();
            state.grow(self);
            state.seen(self, curve).is_some()
        };
        let mut curves = self.elements.iter().flat_map(|e| e.limit_curves.iter().map(move |curve| (e.tag, curve)));
        curves.find(|(_, curve)| !watched(curve)).map(|(tag, curve)| (tag, curve.element))
    }
}
