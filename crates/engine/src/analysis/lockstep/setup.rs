//! Models and analyses that can go side by side, and what becomes of their engines.

use super::{Course, Entry, ImposedTerm, LoadTerm, Models, Motion, Work};
use crate::analysis::algorithm::Newton;
use crate::analysis::convergence::{Measure, Norm, Test};
use crate::analysis::engine::{Engine, Kind};
use crate::analysis::loads::Loads;
use crate::analysis::state::State;
use crate::assembly::{Handler, Plan, Storage};
use crate::element::{Element, MatrixMask, Rows};
use crate::model::{Drive, Model};
use crate::numeric::all_zero;
use crate::numeric::wide::{WIDTH, Wide};
use crate::solve::DenseLu;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Parts of an engine that go side by side with those of others.
#[derive(Clone, Copy)]
struct Parts<'a> {
    model: &'a Model,
    state: &'a State,
    plan: &'a Plan,
    loads: &'a Loads,
    test: &'a Test,
    newton: &'a Newton,
    handler: Handler,
    increment: f64,
    interrupt: Option<&'a Arc<AtomicBool>>,
}

impl<'a> Parts<'a> {
    /// Of an engine whose analysis is made for it. Its plan has been made.
    fn new(engine: &'a Engine) -> Option<Self> {
        let options = &engine.options;
        let setup = engine.setup()?;
        let plain = !options.compat && options.ladder.is_none() && options.refine < 2;
        let newton = setup.algorithm.newton()?;
        let made_for = setup.kind == Kind::Static && is_simple(&setup.test);
        let increment = setup.integrator.fixed_increment().filter(|_| plain && made_for)?;
        // Tangents and factors of earlier steps are not known here.
        let work = engine.prepared().filter(|work| engine.is_fresh() && !work.solver.is_factored())?;
        let (plan, loads, state) = (&work.plan, &work.loads, engine.state());
        let map = &plan.map;
        let one_to_one = map.dependents.is_empty() && map.links.is_empty() && plan.pattern.storage == Storage::Dense;
        let still = !loads.moves && all_zero(&state.vel) && loads.acts_on_nodes_only();
        let parts = Self {
            model: engine.model(),
            state,
            plan,
            loads,
            test: &setup.test,
            newton,
            handler: setup.handler,
            increment,
            interrupt: engine.interrupt.as_ref(),
        };
        (one_to_one && still && plan.multipliers == 0).then_some(parts)
    }

    /// Returns true if another model has the same nodes, elements, constraints and loads, but for their numbers, and the same
    /// analysis.
    fn matches(&self, other: &Self) -> bool {
        let analysis = |p: &Self| (p.handler, p.increment, p.state.time, p.test.measure, p.test.norm);
        let limits = |p: &Self| (p.test.tolerance, p.test.max_iterations);
        let elements = |p: &Self| p.model.elements.len();
        analysis(self) == analysis(other)
            && limits(self) == limits(other)
            && self.plan.map == other.plan.map
            && elements(self) == elements(other)
            && self.model.elements.iter().zip(&other.model.elements).all(|(a, b)| {
                (&a.dofs, &a.state, &a.force, &a.load) == (&b.dofs, &b.state, &b.force, &b.load) && a.tag == b.tag
            })
            && self.loads.matches(other.loads)
    }
}

/// Returns true for tests that judge a correction, an unbalance or their work by itself.
fn is_simple(test: &Test) -> bool {
    matches!(test.measure, Measure::DispIncr | Measure::Unbalance | Measure::Energy)
        && matches!(test.norm, Norm::P(2) | Norm::Max)
        && !test.accept_unconverged
        && test.max_increases.is_none()
        && test.max_norm == f64::MAX
}

impl Models {
    /// Of the engines' models and analyses; `None` where they are not made for it.
    pub(super) fn new(engines: &mut [&mut Engine]) -> Option<Self> {
        if engines.is_empty() || engines.len() > WIDTH {
            return None;
        }
        for engine in engines.iter_mut() {
            let handler = engine.handler();
            engine.prepare(handler).ok()?;
        }
        let own: Option<Vec<Parts<'_>>> = engines.iter().map(|e| Parts::new(e)).collect();
        let own = own?;
        // Places without a model repeat the first one.
        let all: [Parts<'_>; WIDTH] = std::array::from_fn(|lane| *own.get(lane).unwrap_or(&own[0]));
        let first = all[0];
        let watches = |p: &Parts<'_>| p.model.elements.iter().any(|e| !e.limit_curves.is_empty());
        if !own.iter().all(|p| first.matches(p) && !watches(p)) {
            return None;
        }
        let wide = |number: &dyn Fn(&Parts<'_>) -> f64| Wide(std::array::from_fn(|lane| number(&all[lane])));
        let wides = |numbers: &dyn for<'p> Fn(&Parts<'p>) -> &'p [f64]| -> Vec<Wide> {
            (0..numbers(&first).len()).map(|i| wide(&|p| numbers(p)[i])).collect()
        };
        let elements: Option<Vec<Entry>> = (0..first.model.elements.len()).map(|i| entry(&all, i)).collect();
        let elements = elements?;
        let tangents = elements.iter().map(|e| e.dofs.len().pow(2)).sum();
        let most = elements.iter().map(|e| e.dofs.len()).max().unwrap_or(0);
        let load = |i: usize, (dof, pattern, constant): (usize, usize, bool)| LoadTerm {
            dof,
            pattern,
            value: wide(&|p| p.loads.value(i)),
            constant,
        };
        let loads = first.loads.places().enumerate().map(|(i, place)| load(i, place)).collect();
        let imposed = |i: usize, (dof, pattern, constant): (usize, usize, bool)| ImposedTerm {
            dof,
            pattern,
            initial: wide(&|p| p.loads.imposed_numbers(i)[0]),
            value: wide(&|p| p.loads.imposed_numbers(i)[1]),
            constant,
        };
        let imposed = first.loads.imposed_places().enumerate().map(|(i, place)| imposed(i, place)).collect();
        let committed = Motion {
            disp: wides(&|p| &p.state.disp),
            history: wides(&|p| &p.state.history),
            force: wides(&|p| &p.state.force),
        };
        let n = first.plan.equations();
        let zeros = |n: usize| vec![Wide::all(0.0); n];
        let drives: Vec<Drive> = first.loads.drives().to_vec();
        Some(Self {
            plan: first.plan.clone(),
            elements,
            factors: vec![f64::NAN; drives.len()],
            drives,
            loaded: first.loads.loaded().to_vec(),
            loads,
            imposed,
            measure: first.test.measure,
            norm: first.test.norm,
            tolerance: first.test.tolerance,
            max_iterations: first.test.max_iterations,
            increment: first.increment,
            time: first.state.time,
            start: first.state.time,
            trial: committed.clone(),
            work: Work {
                nodal: zeros(committed.disp.len()),
                b: zeros(n),
                x: zeros(n),
                matrix: zeros(n * n),
                factors: DenseLu::new(n),
                values: vec![0.0; n * n],
                solution: vec![0.0; n],
                disp: zeros(most),
                tangents: zeros(tangents),
                evaluated: committed.force.clone(),
                slack: Wide::all(0.0),
                saved: vec![],
            },
            committed,
            flags: Course {
                is_current: 0,
                evaluated: 0,
                is_factored: 0,
                // So far no step of the plan has been in balance.
                balanced: 0,
                expected: all.map(|p| p.newton.expected),
            },
            interrupt: first.interrupt.cloned(),
            failed: 0,
        })
    }

    /// Give an engine the state of its model at the end.
    pub(super) fn finish(&self, lane: usize, engine: &mut Engine, steps: usize) {
        engine.change_state(|state, _| {
            state.time = self.time;
            for (own, all) in [
                (&mut state.disp, &self.committed.disp),
                (&mut state.history, &self.committed.history),
                (&mut state.force, &self.trial.force),
            ] {
                own.iter_mut().zip(all).for_each(|(own, all)| *own = all.0[lane]);
            }
        });
        engine.forget_work();
        engine.steps += steps as u64;
    }
}

/// An element of all models.
fn entry(all: &[Parts<'_>; WIDTH], i: usize) -> Option<Entry> {
    let elements: [&Arc<dyn Element>; WIDTH] = all.map(|p| &p.model.elements[i].element);
    let e = &all[0].model.elements[i];
    let traits = e.element.traits();
    let free = |d: &u32| !all[0].plan.map.terms(*d as usize).is_empty();
    let rows = Rows::of(e.dofs.iter().map(free));
    Some(Entry {
        element: elements[0].lockstep(&elements)?,
        dofs: e.dofs.to_vec(),
        state: e.state.clone(),
        force: e.force.clone(),
        part: MatrixMask { rows, columns: rows },
        rates: traits.viscous || traits.elapses,
    })
}
