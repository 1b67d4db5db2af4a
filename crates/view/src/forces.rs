//! End forces of members: their frames, and the extremes of each.

use crate::field::Frames;
use crate::numbers::narrow;
use crate::scene::{Family, Scene};
use hysteron_engine::analysis::Engine;
use hysteron_engine::model::ElementId;
use hysteron_engine::probe::Probe;

/// A member whose end forces are kept.
#[derive(Clone, Debug)]
pub(crate) struct Member {
    /// Place of the element.
    pub(crate) element: usize,
    probe: Probe,
}

impl Member {
    /// Number of columns: 6 in the plane (N, V, M at both ends), 12 in space, 1 for a truss.
    pub(crate) fn columns(&self) -> usize {
        self.probe.len()
    }
}

/// End forces of beams in local axes, and axial forces of trusses.
#[derive(Clone, Debug)]
pub(crate) struct MemberForces {
    pub(crate) members: Vec<Member>,
    pub(crate) frames: Frames,
    /// Smallest and largest of each column, with their steps.
    pub(crate) low: Vec<(f32, u32)>,
    pub(crate) high: Vec<(f32, u32)>,
    row: Vec<f64>,
    disp: Vec<f64>,
}

impl MemberForces {
    /// Numbers of all frames.
    const KEPT: usize = 1_500_000;

    pub(crate) fn new(engine: &Engine, scene: &Scene) -> Self {
        let member = |(i, e): (usize, &crate::scene::SceneElement)| {
            let element = &engine.model().elements[i].element;
            let probe = match e.family {
                Family::Beam => element.probe(&["localForce"]).filter(|p| matches!(p.len(), 6 | 12)),
                Family::Truss => element.probe(&["axialForce"]).filter(|p| p.len() == 1),
                _ => None,
            };
            probe.map(|probe| Member { element: i, probe })
        };
        let members: Vec<Member> = scene.elements.iter().enumerate().filter_map(member).collect();
        let width = members.iter().map(Member::columns).sum();
        Self {
            members,
            frames: Frames::new(width, 4, 400, Self::KEPT),
            low: vec![(f32::INFINITY, 0); width],
            high: vec![(f32::NEG_INFINITY, 0); width],
            row: vec![],
            disp: vec![],
        }
    }

    pub(crate) fn step(&mut self, engine: &Engine, step: usize, always: bool) {
        self.row.clear();
        for m in &self.members {
            let start = self.row.len();
            self.row.resize(start + m.columns(), 0.0);
            let snapshot = engine.snapshot(ElementId(m.element), &mut self.disp);
            engine.model().elements[m.element].element.read(&m.probe.path, &snapshot, &mut self.row[start..]);
        }
        for ((x, low), high) in self.row.iter().zip(&mut self.low).zip(&mut self.high) {
            let x = narrow(*x);
            if x < low.0 {
                *low = (x, step as u32);
            }
            if x > high.0 {
                *high = (x, step as u32);
            }
        }
        if always || self.frames.wants(step) {
            self.frames.push(step, self.row.iter().copied());
        }
    }
}
