//! The record of a run: the model, its motion and its forces.

use crate::devices::Device;
use crate::fibers::FiberFrames;
use crate::field::Frames;
use crate::forces::MemberForces;
use crate::history::History;
use crate::numbers::narrow;
use crate::scene::{Family, Scene, translations};
use hysteron_engine::analysis::{Engine, Kind, ModeRequest, Modes};
use hysteron_opensees::MotionObserver;
use std::cell::RefCell;
use std::rc::Rc;

/// Names of the units of a model; empty where they are not known.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Units {
    /// Unit of force.
    pub force: String,
    /// Unit of length.
    pub length: String,
}

/// A part of a run: steps of one kind, between which the script does not set the time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stage {
    /// Kind of the analysis.
    pub kind: Kind,
    /// First step and the one after the last.
    pub steps: (usize, usize),
}

/// History of a node: displacements of its translations, then accelerations.
#[derive(Clone, Debug)]
pub(crate) struct NodeHistory {
    /// Place of the node.
    pub(crate) node: usize,
    pub(crate) history: History,
}

/// Largest absolute displacement and acceleration of a translation, with their steps.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct NodePeak {
    pub(crate) disp: (f32, u32),
    pub(crate) accel: (f32, u32),
}

/// Record of a model and its motion.
#[derive(Clone, Debug)]
pub struct Motion {
    /// The model at rest.
    pub scene: Scene,
    /// Time of each step; the first is the state in which the analyses begin.
    pub times: Vec<f64>,
    /// Parts of the run.
    pub stages: Vec<Stage>,
    /// Modes: eigenvalues, and the translations of all nodes.
    pub(crate) modes: Vec<(f64, Vec<f32>)>,
    pub(crate) frames: Frames,
    pub(crate) forces: MemberForces,
    pub(crate) devices: Vec<Device>,
    pub(crate) devices_left_out: usize,
    pub(crate) nodes: Vec<NodeHistory>,
    /// By node and direction.
    pub(crate) peaks: Vec<NodePeak>,
    pub(crate) fibers: FiberFrames,
    revision: u64,
    /// The script has set the time since the last step.
    time_was_set: bool,
    buffers: (Vec<f64>, Vec<f64>),
}

/// Largest number of devices with loops.
const DEVICES: usize = 300;
/// Largest number of nodes with histories of every step.
const NODES: usize = 150;

impl Motion {
    fn new(engine: &Engine) -> Self {
        let scene = Scene::new(engine);
        let width = scene.nodes.len() * scene.ndm;
        let devices = Device::all(engine, &scene, DEVICES);
        let all = scene.elements.iter().filter(|e| e.family.is_device()).count();
        let nodes = followed(&scene).into_iter().map(|node| {
            let columns = 2 * translations(scene.nodes[node].ndf, scene.ndm);
            NodeHistory { node, history: History::new(columns) }
        });
        Self {
            times: vec![],
            stages: vec![],
            modes: vec![],
            frames: Frames::new(width, 60, 1200, 12_000_000),
            forces: MemberForces::new(engine, &scene),
            devices_left_out: all.saturating_sub(devices.len()),
            devices,
            nodes: nodes.collect(),
            peaks: vec![NodePeak::default(); width],
            fibers: FiberFrames::new(engine, &scene),
            revision: engine.model().revision(),
            time_was_set: false,
            buffers: (vec![], vec![]),
            scene,
        }
    }

    /// Number of steps, the state at the beginning among them.
    pub fn steps(&self) -> usize {
        self.times.len()
    }

    /// Take the committed state; `always` makes a frame of it.
    fn take(&mut self, engine: &Engine, always: bool) {
        let step = self.times.len();
        self.times.push(engine.state().time);
        let kind = engine.setup().map_or(Kind::Static, |s| s.kind);
        let is_new = std::mem::take(&mut self.time_was_set);
        match self.stages.last_mut() {
            // The state at the beginning belongs to the first analysis.
            Some(s) if (s.kind == kind && !is_new) || s.steps.1 == 1 => (s.kind, s.steps.1) = (kind, step + 1),
            _ => self.stages.push(Stage { kind, steps: (step, step + 1) }),
        }
        if self.revision != engine.model().revision() {
            // Loads and constraints may be new; nodes and elements are the same.
            let before = std::mem::take(&mut self.scene);
            self.scene = Scene { elements: before.elements, ..Scene::new(engine) };
            self.revision = engine.model().revision();
        }
        self.take_nodes(engine, step, always);
        self.forces.step(engine, step, always);
        self.fibers.step(engine, step, always);
        self.devices.iter_mut().for_each(|d| d.step(engine, step, &mut self.buffers));
    }

    fn take_nodes(&mut self, engine: &Engine, step: usize, always: bool) {
        let (state, ndm) = (engine.state(), self.scene.ndm);
        for (node, peaks) in self.scene.nodes.iter().zip(self.peaks.chunks_exact_mut(ndm)) {
            for (k, peak) in peaks.iter_mut().enumerate().take(translations(node.ndf, ndm)) {
                let of = |values: &[f64], peak: &mut (f32, u32)| {
                    let x = narrow(values[node.offset + k]);
                    if x.abs() > peak.0.abs() {
                        *peak = (x, step as u32);
                    }
                };
                of(&state.disp, &mut peak.disp);
                of(&state.accel, &mut peak.accel);
            }
        }
        if always || self.frames.wants(step) {
            let of = |node: &crate::scene::SceneNode| {
                let (offset, known) = (node.offset, translations(node.ndf, ndm));
                (0..ndm).map(move |k| if k < known { state.disp[offset + k] } else { 0.0 })
            };
            self.frames.push(step, self.scene.nodes.iter().flat_map(of));
        }
        for n in &mut self.nodes {
            let at = self.scene.nodes[n.node].offset;
            let dofs = n.history.columns / 2;
            let row = state.disp[at..at + dofs].iter().chain(&state.accel[at..at + dofs]);
            n.history.push(step, row.copied());
        }
    }

    /// The last state: its frames, and the modes of the model.
    fn close(&mut self, engine: &mut Engine, modes: usize) {
        let last = self.times.len().saturating_sub(1);
        if self.frames.steps.last() != Some(&(last as u32)) && self.frames.width > 0 {
            // Peaks and histories have the step already.
            let (times, stages) = (self.times.clone(), self.stages.clone());
            let (peaks, nodes) = (self.peaks.clone(), std::mem::take(&mut self.nodes));
            self.take_nodes(engine, last, true);
            self.forces.step(engine, last, true);
            self.fibers.step(engine, last, true);
            (self.times, self.stages, self.peaks, self.nodes) = (times, stages, peaks, nodes);
        }
        let dofs = engine.model().dofs();
        let mut found = engine.modes().cloned().filter(|m| m.shapes.iter().all(|s| s.len() == dofs));
        if found.as_ref().map_or(0, |m| m.lambda.len()) < modes {
            found = engine.find_modes(ModeRequest::smallest(modes)).ok().cloned().or(found);
        }
        self.modes = found.map_or_else(Vec::new, |m| shapes(&m, &self.scene));
    }
}

/// Translations of all nodes in each mode; those that the mass does not move are left out.
fn shapes(modes: &Modes, scene: &Scene) -> Vec<(f64, Vec<f32>)> {
    let finite = modes.lambda.iter().zip(&modes.shapes).filter(|(lambda, _)| lambda.is_finite() && **lambda < 1e300);
    let shape = |(lambda, shape): (&f64, &Vec<f64>)| {
        let of = |n: &crate::scene::SceneNode| {
            let (offset, known) = (n.offset, translations(n.ndf, scene.ndm));
            (0..scene.ndm).map(move |k| if k < known { narrow(shape[offset + k]) } else { 0.0 })
        };
        (*lambda, scene.nodes.iter().flat_map(of).collect())
    };
    finite.map(shape).collect()
}

/// Nodes whose histories are kept: all of a small model; else those of devices, those with mass and supports first.
fn followed(scene: &Scene) -> Vec<usize> {
    let mut rank = vec![3u8; scene.nodes.len()];
    for (r, n) in rank.iter_mut().zip(&scene.nodes) {
        if n.fixed != 0 {
            *r = 2;
        }
        if n.mass > 0.0 {
            *r = 1;
        }
    }
    let devices = scene.elements.iter().filter(|e| matches!(e.family, Family::Bearing | Family::Link));
    devices.flat_map(|e| &e.nodes).for_each(|n| rank[*n] = 0);
    let mut order: Vec<usize> = (0..rank.len()).collect();
    order.sort_by_key(|i| (rank[*i], *i));
    order.truncate(NODES);
    order.sort_unstable();
    order
}

/// Keeps what is to be shown of the last model that a script has analysed.
#[derive(Clone, Debug, Default)]
pub struct Collector {
    modes: usize,
    current: Option<Motion>,
    /// The last model that was forgotten after an analysis.
    finished: Option<Motion>,
    /// Models that were analysed, the kept one among them.
    pub models: usize,
}

impl Collector {
    /// A collector that finds `modes` modes where the script does not.
    pub fn new(modes: usize) -> Self {
        Self { modes, ..Self::default() }
    }

    fn motion(&mut self, engine: &Engine) -> &mut Motion {
        if self.current.as_ref().is_some_and(|m| !m.scene.has_parts_of(engine.model())) {
            self.current = None;
        }
        let models = &mut self.models;
        self.current.get_or_insert_with(|| {
            *models += 1;
            Motion::new(engine)
        })
    }

    /// The same with another number of modes.
    #[must_use]
    pub fn with_modes(self, modes: usize) -> Self {
        Self { modes, ..self }
    }

    /// The motion of the last model, or the model at rest where the script analyses none; `None` without nodes.
    pub fn finish(mut self, engine: &mut Engine) -> Option<Motion> {
        let has_model = !engine.model().nodes.is_empty();
        let same = self.current.as_ref().is_some_and(|m| m.scene.has_parts_of(engine.model()));
        if same || (has_model && self.finished.is_none()) {
            let modes = self.modes;
            let motion = self.motion(engine);
            if motion.times.is_empty() {
                motion.take(engine, true);
            }
            motion.close(engine, modes);
            return self.current;
        }
        self.finished
    }
}

/// A collector that the session and its owner share.
#[derive(Clone, Debug, Default)]
pub struct Observer(Rc<RefCell<Collector>>);

impl Observer {
    /// An observer that finds `modes` modes where the script does not.
    pub fn new(modes: usize) -> Self {
        Self(Rc::new(RefCell::new(Collector::new(modes))))
    }

    /// A copy of the collector as it is: it goes on collecting.
    pub fn collected(&self) -> Collector {
        self.0.borrow().clone()
    }

    /// The collector, with all that it has seen.
    pub fn take(&self) -> Collector {
        self.0.take()
    }
}

impl MotionObserver for Observer {
    fn start(&mut self, engine: &Engine) {
        let mut collector = self.0.borrow_mut();
        let motion = collector.motion(engine);
        match motion.times.last() {
            None => motion.take(engine, true),
            Some(last) => motion.time_was_set |= *last != engine.state().time,
        }
    }

    fn step(&mut self, engine: &Engine) {
        self.0.borrow_mut().motion(engine).take(engine, false);
    }

    fn wipe(&mut self, engine: &mut Engine) {
        let mut collector = self.0.borrow_mut();
        let modes = collector.modes;
        if let Some(mut motion) = collector.current.take() {
            motion.close(engine, modes);
            collector.finished = Some(motion);
        }
    }
}
