//! Stresses and strains of the fibers of sections.

use crate::field::Frames;
use crate::scene::Scene;
use hysteron_engine::analysis::Engine;
use hysteron_engine::model::ElementId;
use hysteron_engine::probe::Probe;

/// Numbers of a fiber in OpenSees' response `fiberData`: y, z, area, stress, strain.
const FIBER: usize = 5;

/// A section with fibers.
#[derive(Clone, Debug)]
pub(crate) struct FiberedSection {
    /// Place of the element.
    pub(crate) element: usize,
    /// Number of the section in the element, from 1.
    pub(crate) number: usize,
    /// y, z and area of each fiber.
    pub(crate) fibers: Vec<[f64; 3]>,
    probe: Probe,
}

/// Stresses and strains of the fibers of some sections.
#[derive(Clone, Debug)]
pub(crate) struct FiberFrames {
    pub(crate) sections: Vec<FiberedSection>,
    /// Sections that were left out, since there are too many fibers.
    pub(crate) left_out: usize,
    /// Stress and strain of each fiber.
    pub(crate) frames: Frames,
    row: Vec<f64>,
    disp: Vec<f64>,
}

impl FiberFrames {
    /// Fibers of all sections.
    const FIBERS: usize = 6000;
    /// Numbers of all frames.
    const KEPT: usize = 1_200_000;

    pub(crate) fn new(engine: &Engine, scene: &Scene) -> Self {
        let (mut sections, mut left_out, mut fibers) = (vec![], 0, 0);
        for (at, ends) in (0..scene.elements.len()).map(|e| (e, sections_of(engine, e))) {
            // The ends of a beam yield first.
            let last = ends.len().saturating_sub(1);
            for (number, probe) in ends.into_iter().enumerate().filter(|(i, _)| *i == 0 || *i == last) {
                let count = probe.len() / FIBER;
                if fibers + count > Self::FIBERS {
                    left_out += 1;
                    continue;
                }
                fibers += count;
                let mut section = FiberedSection { element: at, number: number + 1, fibers: vec![], probe };
                let (mut row, mut disp) = (vec![], vec![]);
                section.read(engine, &mut row, &mut disp);
                section.fibers = row.chunks_exact(FIBER).map(|f| [f[0], f[1], f[2]]).collect();
                sections.push(section);
            }
        }
        let frames = Frames::new(2 * fibers, 20, 400, Self::KEPT);
        Self { sections, left_out, frames, row: vec![], disp: vec![] }
    }

    pub(crate) fn step(&mut self, engine: &Engine, step: usize, always: bool) {
        if self.sections.is_empty() || !(always || self.frames.wants(step)) {
            return;
        }
        self.row.clear();
        for s in &self.sections {
            s.read(engine, &mut self.row, &mut self.disp);
        }
        self.frames.push(step, self.row.chunks_exact(FIBER).flat_map(|f| [f[3], f[4]]));
    }
}

impl FiberedSection {
    /// Append the response `fiberData`.
    fn read(&self, engine: &Engine, row: &mut Vec<f64>, disp: &mut Vec<f64>) {
        let start = row.len();
        row.resize(start + self.probe.len(), 0.0);
        let snapshot = engine.snapshot(ElementId(self.element), disp);
        engine.model().elements[self.element].element.read(&self.probe.path, &snapshot, &mut row[start..]);
    }
}

/// The responses `fiberData` of the sections of an element; empty where they have no fibers.
fn sections_of(engine: &Engine, element: usize) -> Vec<Probe> {
    let element = &engine.model().elements[element].element;
    let mut all = vec![];
    while let Some(probe) = element.probe(&["section", &(all.len() + 1).to_string(), "fiberData"]) {
        if probe.is_empty() || !probe.len().is_multiple_of(FIBER) || all.len() >= 20 {
            break;
        }
        all.push(probe);
        // A section without a number is the only one, and answers to every number.
        if element.class().name == "ZeroLengthSection" {
            break;
        }
    }
    all
}
