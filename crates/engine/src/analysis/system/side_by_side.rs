//! Evaluation of the elements of a large model on several threads.
//!
//! Each element writes to places of its own, so that the results are the same for any number of threads.

use super::element_call::{Call, Nodes, Places};
use super::evaluation::{Lack, Request};
use super::{Failure, System};
use crate::analysis::workspace::{ElementMatrices, ElementWorkspace};
use crate::element::{ElementError, ElementResult, Histories, MatrixMask};
use crate::model::{ElementEntry, Model};

/// State variables from which on several threads are quicker than one: the work of elements grows with their number.
const MANY: usize = 20_000;
/// State variables of the elements that one thread takes at once.
const AT_ONCE: usize = 4_000;

/// Returns true if the elements of a model are worth several threads.
pub(in crate::analysis) fn are_worth_threads(model: &Model, elements: &[usize]) -> bool {
    elements.iter().map(|i| model.elements[*i].state.len()).sum::<usize>() >= MANY
}

/// A part of an array, from a place on.
struct Part<'a> {
    values: &'a mut [f64],
    start: usize,
}

impl<'a> Part<'a> {
    fn new(values: &'a mut [f64]) -> Self {
        Self { values, start: 0 }
    }

    /// The parts before a place and from there on.
    fn split(self, at: usize) -> (Self, Self) {
        let (before, after) = self.values.split_at_mut(at - self.start);
        (Self { values: before, start: self.start }, Self { values: after, start: at })
    }

    fn range(&mut self, at: usize, len: usize) -> &mut [f64] {
        &mut self.values[at - self.start..][..len]
    }
}

/// Places of elements that follow each other.
struct Span<'a> {
    motion: Part<'a>,
    force: Part<'a>,
    tangent: Part<'a>,
    damping: Part<'a>,
    trial: Part<'a>,
}

/// Arguments of the calls of all elements.
struct Calls<'a> {
    model: &'a Model,
    entries: &'a [ElementWorkspace],
    committed: &'a [f64],
    nodes: Nodes<'a>,
    load: &'a [f64],
    asked: Request,
    /// All columns of the matrices are read.
    multiplies: bool,
    settled: bool,
    dt: f64,
    time: f64,
    dynamic: bool,
}

/// Number of calls, and the first element without an answer. Elements behind it count for nothing.
#[derive(Default)]
struct Done {
    calls: u64,
    failed: Option<(usize, ElementError)>,
}

impl System<'_> {
    /// Evaluate the elements on several threads; `true` if there was one to be evaluated.
    pub(super) fn respond_side_by_side(&mut self, asked: Request, dt: f64) -> Result<bool, Failure> {
        let (work, new) = (&mut *self.work, &mut *self.new);
        let ElementMatrices { entries, tangent, damping, multiplies, .. } = &mut work.elements;
        let calls = Calls {
            model: self.model,
            entries,
            committed: &self.old.history,
            nodes: Nodes { disp: &new.disp, vel: &new.vel, accel: &new.accel, still: self.still },
            load: &new.element_load,
            asked,
            multiplies: *multiplies,
            settled: self.settled,
            dt,
            time: self.passed.map_or(new.time, |passed| self.old.time + passed),
            dynamic: self.dynamic,
        };
        let span = Span {
            motion: Part::new(&mut work.evaluated.elements),
            force: Part::new(&mut new.force),
            tangent: Part::new(tangent),
            damping: Part::new(damping),
            trial: Part::new(&mut new.history),
        };
        let elements = &work.small_beams.others;
        let done = work.threads.run(|parallel| calls.make(parallel, elements, span));
        work.evaluated.calls += done.calls;
        match done.failed {
            Some((i, error)) => Err(self.element_failed(i, error)),
            None => Ok(done.calls > 0),
        }
    }
}

impl Calls<'_> {
    /// Call elements that follow each other, half of them on another thread.
    fn make(&self, parallel: bool, elements: &[usize], span: Span<'_>) -> Done {
        let state = |i: &usize| &self.model.elements[*i].state;
        let (Some(first), Some(last)) = (elements.first(), elements.last()) else { return Done::default() };
        let (start, end) = (state(first).start, state(last).end);
        let half = elements.partition_point(|i| state(i).end <= (start + end) / 2);
        if !parallel || end - start <= AT_ONCE || half == 0 || half == elements.len() {
            return self.make_in_turn(elements, span);
        }
        let (one, other) = elements.split_at(half);
        let (before, after) = self.split(other, span);
        let (one, other) = rayon::join(|| self.make(true, one, before), || self.make(true, other, after));
        match one.failed {
            Some(_) => one,
            None => Done { calls: one.calls + other.calls, failed: other.failed },
        }
    }

    /// Places before some elements, and from the first of them on.
    fn split<'s>(&self, elements: &[usize], span: Span<'s>) -> (Span<'s>, Span<'s>) {
        let first = elements[0];
        let (e, m) = (&self.model.elements[first], &self.entries[first]);
        let damping = elements.iter().find_map(|i| self.entries[*i].damping);
        let end = span.damping.start + span.damping.values.len();
        let motion = span.motion.split(m.motion);
        let force = span.force.split(e.force.start);
        let tangent = span.tangent.split(m.at);
        let damping = span.damping.split(damping.unwrap_or(end));
        let trial = span.trial.split(e.state.start);
        (
            Span { motion: motion.0, force: force.0, tangent: tangent.0, damping: damping.0, trial: trial.0 },
            Span { motion: motion.1, force: force.1, tangent: tangent.1, damping: damping.1, trial: trial.1 },
        )
    }

    fn make_in_turn(&self, elements: &[usize], mut span: Span<'_>) -> Done {
        let mut calls = 0;
        for &i in elements {
            let (e, m) = (&self.model.elements[i], &self.entries[i]);
            let motion = span.motion.range(m.motion, 2 * e.dofs.len());
            match self.asked.lack(self.nodes, e, m, motion, self.settled) {
                Lack::Nothing => {}
                Lack::KeptTangent => {
                    let history = span.trial.range(e.state.start, e.state.len());
                    let tangent = span.tangent.range(m.at, e.dofs.len().pow(2));
                    self.nodes.take_kept_tangent(e, history, motion, tangent);
                }
                Lack::Everything => {
                    calls += 1;
                    if let Err(error) = self.call(e, m, &mut span) {
                        return Done { calls, failed: Some((i, error)) };
                    }
                }
            }
        }
        Done { calls, failed: None }
    }

    fn call(&self, e: &ElementEntry, m: &ElementWorkspace, span: &mut Span<'_>) -> ElementResult {
        let n = e.dofs.len();
        let call = Call {
            nodes: self.nodes,
            load: &self.load[e.load.clone()],
            dt: self.dt,
            time: self.time,
            dynamic: self.dynamic,
            part: MatrixMask::read_of(m.rows, self.multiplies),
        };
        let places = Places {
            motion: span.motion.range(m.motion, 2 * n),
            force: span.force.range(e.force.start, e.force.len()),
            tangent: (self.asked.tangent && !m.linear).then(|| span.tangent.range(m.at, n * n)),
            damping: m.damping.map(|at| span.damping.range(at, n * n)),
            histories: Histories {
                committed: &self.committed[e.state.clone()],
                trial: span.trial.range(e.state.start, e.state.len()),
            },
        };
        call.make(e, m, None, places)
    }
}
