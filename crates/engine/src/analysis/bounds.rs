//! Responses beyond what a model can mean.
//!
//! Equations have solutions far outside of the range in which laws and small rotations hold. Two lengths of a model say where
//! that is: the size that a law was made for, and the extent of the model itself.

use super::failure::{Cause, Failure};
use super::state::State;
use super::workspace::Workspace;
use crate::model::Model;

/// Displacements in a transient analysis beyond this part of the extent of the model, or of the largest imposed displacement,
/// are pointed out. A structure that has collapsed lies within its extent.
const SUSPECT_EXTENTS: f64 = 10.0;
/// The same, refused.
const REFUSED_EXTENTS: f64 = 100.0;

/// A response beyond what the model can mean.
#[derive(Clone, Debug, PartialEq)]
pub struct Excess {
    /// Class and tag of the element.
    pub element: String,
    /// Domain time.
    pub time: f64,
    /// What exceeds what, with both numbers.
    pub message: String,
    /// The step fails, unless OpenSees' numbers are wanted.
    pub is_refused: bool,
}

impl Excess {
    /// The failure of its step.
    pub(super) fn failure(self, time: f64) -> Failure {
        Failure::new(Cause::Element { element: self.element, message: self.message }, time, -3)
    }
}

/// Lengths against which responses are held.
#[derive(Clone, Debug)]
pub(super) struct Bounds {
    /// Elements with a law that was made for some size.
    stretched: Vec<usize>,
    /// Length of the diagonal of the box around the nodes.
    extent: f64,
    /// The largest displacement imposed so far.
    imposed: f64,
}

impl Bounds {
    pub(super) fn new(model: &Model) -> Self {
        let rest = vec![0.0; model.dofs()];
        let stretched = model.elements.iter().enumerate().filter(|(_, e)| {
            let disp = &rest[..e.dofs.len()];
            e.element.stretch(disp).is_some()
        });
        let mut sides = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        for node in &model.nodes {
            for (side, &x) in sides.iter_mut().zip(&node.coords) {
                *side = [side[0].min(x), side[1].max(x)];
            }
        }
        let squares = sides.iter().map(|[low, high]| if high > low { (high - low).powi(2) } else { 0.0 });
        let extent = squares.sum::<f64>().sqrt();
        Self { stretched: stretched.map(|(i, _)| i).collect(), extent, imposed: 0.0 }
    }

    /// Displacement of a degree of freedom below which no law is refused for its stretch, and in a transient analysis no node
    /// is far outside of the model.
    pub(super) fn safe_displacement(&self, model: &Model, dynamic: bool) -> f64 {
        let within = if dynamic && self.extent > 0.0 { SUSPECT_EXTENTS * self.extent } else { f64::INFINITY };
        let limits = model.elements.iter().filter_map(|e| {
            let rest = vec![0.0; e.dofs.len()];
            e.element.stretch(&rest).map(|s| s.refused * s.size)
        });
        // Both nodes, in two directions.
        within.min(limits.fold(f64::INFINITY, f64::min) / (2.0 * 2.0f64.sqrt()))
    }
}

impl Workspace {
    /// What exceeds the bounds in a trial state, if anything does.
    #[inline]
    pub(super) fn excess(&mut self, model: &Model, state: &State, dynamic: bool) -> Option<Excess> {
        let imposed = self.loads.largest_imposed();
        let bounds = &mut self.bounds;
        bounds.imposed = bounds.imposed.max(imposed);
        let bounds = &self.bounds;
        let of_law = bounds.stretched.iter().find_map(|&i| stretched(model, state, i));
        if of_law.is_some() || !dynamic || bounds.extent == 0.0 {
            return of_law;
        }
        let size = bounds.extent.max(bounds.imposed);
        let limit = SUSPECT_EXTENTS * size;
        if state.disp.iter().all(|u| u.abs() <= limit) { None } else { displaced(model, state, size) }
    }
}

/// A law beyond its size.
fn stretched(model: &Model, state: &State, i: usize) -> Option<Excess> {
    let e = &model.elements[i];
    let mut disp = [0.0; crate::element::MAX_DOFS];
    e.dofs.iter().zip(&mut disp).for_each(|(&d, u)| *u = state.disp[d as usize]);
    let s = e.element.stretch(&disp[..e.dofs.len()])?;
    let ratio = s.deformation / s.size;
    if ratio <= s.suspect {
        return None;
    }
    let message = format!(
        "the deformation {:.4} is {ratio:.1} times {} of {:.4}: the law holds up to {} times",
        s.deformation, s.what, s.size, s.suspect
    );
    let element = format!("{} {}", e.element.class().name, e.tag);
    Some(Excess { element, time: state.time, message, is_refused: ratio > s.refused })
}

/// The element at the translation that is furthest beyond the size of the model.
#[cold]
fn displaced(model: &Model, state: &State, size: f64) -> Option<Excess> {
    let translation = |i: usize| {
        let node = &model.nodes[i];
        let all = &state.disp[node.dofs()];
        all.iter().take(node.ndm()).map(|u| u * u).sum::<f64>().sqrt()
    };
    let (furthest, moved) = (0..model.nodes.len()).map(|i| (i, translation(i))).max_by(|a, b| a.1.total_cmp(&b.1))?;
    if moved <= SUSPECT_EXTENTS * size {
        return None;
    }
    let tag = model.nodes[furthest].tag;
    let at = |e: &&crate::model::ElementEntry| e.nodes.iter().any(|n| n.0 == furthest);
    let element = model.elements.iter().find(at);
    let element = element.map_or_else(|| "the model".into(), |e| format!("{} {}", e.element.class().name, e.tag));
    let message =
        format!("node {tag} has moved by {moved:.4}, {:.0} times the size of the model, {size:.4}", moved / size);
    Some(Excess { element, time: state.time, message, is_refused: moved > REFUSED_EXTENTS * size })
}
