//! Models and analyses that can go side by side, and what becomes of their engines.

use super::dynamics::{Dynamics, ElementPlace, wides_of};
use super::{Course, Entry, ImposedTerm, LoadTerm, Models, Motion, Work};
use crate::analysis::algorithm::Newton;
use crate::analysis::convergence::{Measure, Norm, Test};
use crate::analysis::engine::{Engine, Kind};
use crate::analysis::integrator::{Form, Newmark};
use crate::analysis::loads::Loads;
use crate::analysis::state::State;
use crate::analysis::system::Coefficients;
use crate::analysis::workspace::{ConstantParts, Workspace};
use crate::assembly::{Handler, Plan, Storage};
use crate::element::{Element, MatrixMask, Rows};
use crate::model::{Drive, Model};
use crate::numeric::wide::{WIDTH, Wide};
use crate::solve::{DenseLu, WideLu};
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
    advance: Advance<'a>,
    constant: &'a ConstantParts<'a>,
    safe_displacement: f64,
    interrupt: Option<&'a Arc<AtomicBool>>,
}

/// Steps of an analysis.
#[derive(Clone, Copy, Debug)]
enum Advance<'a> {
    /// Of a load factor.
    Load(f64),
    /// Of time, by Newmark's method for displacements.
    Time(f64, &'a Newmark),
}

impl<'a> Advance<'a> {
    /// Of an engine's analysis, with `dt` as the length of a step in time; `None` for others.
    fn new(engine: &'a Engine, dt: f64) -> Option<Self> {
        let setup = engine.setup()?;
        match setup.kind {
            Kind::Static => setup.integrator.fixed_increment().map(Self::Load),
            Kind::Transient => {
                let newmark = setup.integrator.newmark().filter(|n| n.form() == Form::Displacement)?;
                Some(Self::Time(dt, newmark))
            }
        }
    }

    /// Length of a step.
    fn increment(self) -> f64 {
        match self {
            Self::Load(step) | Self::Time(step, _) => step,
        }
    }

    fn newmark(self) -> Option<&'a Newmark> {
        match self {
            Self::Load(_) => None,
            Self::Time(_, newmark) => Some(newmark),
        }
    }

    /// Shares of stiffness, damping and mass in the tangent.
    fn coefficients(self) -> Coefficients {
        match self {
            Self::Load(_) => Coefficients { k: 1.0, c: 0.0, m: 0.0 },
            Self::Time(dt, newmark) => newmark.coefficients_of_step(dt),
        }
    }

    /// Returns true if both are the same steps.
    fn matches(self, other: Self) -> bool {
        self.newmark().is_some() == other.newmark().is_some()
            && self.increment() == other.increment()
            && self.coefficients() == other.coefficients()
    }
}

impl<'a> Parts<'a> {
    /// Of an engine whose analysis is made for it. Its plan has been made, and its constant entries assembled.
    fn new(engine: &'a Engine, constant: &'a ConstantParts<'a>, dt: f64) -> Option<Self> {
        let options = &engine.options;
        let setup = engine.setup()?;
        let plain = !options.compat && options.ladder.is_none() && options.refine < 2;
        let newton = setup.algorithm.newton()?;
        let advance = Advance::new(engine, dt).filter(|_| plain && is_simple(&setup.test))?;
        // Tangents and factors of earlier steps are not known here.
        let work = engine.prepared().filter(|work| engine.is_fresh() && !work.solver.is_factored())?;
        let (plan, loads, state) = (&work.plan, &work.loads, engine.state());
        let map = &plan.map;
        let one_to_one = map.dependents.is_empty() && map.links.is_empty() && plan.pattern.storage == Storage::Dense;
        let moves = match advance {
            Advance::Load(_) => work.stands_still(&state.vel) && loads.ground_inertia().is_empty(),
            Advance::Time(..) => constant.steady.is_none() || rests_at_supports(work, state),
        };
        let parts = Self {
            model: engine.model(),
            state,
            plan,
            loads,
            test: &setup.test,
            newton,
            handler: setup.handler,
            advance,
            constant,
            safe_displacement: work.bounds.safe_displacement(engine.model(), setup.kind == Kind::Transient),
            interrupt: engine.interrupt.as_ref(),
        };
        (one_to_one && moves && loads.acts_on_nodes_only() && plan.multipliers == 0).then_some(parts)
    }

    /// Returns true if another model has the same nodes, elements, constraints and loads, but for their numbers, and the same
    /// analysis.
    fn matches(&self, other: &Self) -> bool {
        let analysis = |p: &Self| (p.handler, p.state.time, p.test.measure, p.test.norm);
        let limits = |p: &Self| (p.test.tolerance, p.test.max_iterations);
        let elements = |p: &Self| p.model.elements.len();
        analysis(self) == analysis(other)
            && self.advance.matches(other.advance)
            && limits(self) == limits(other)
            && self.plan.map == other.plan.map
            && elements(self) == elements(other)
            && self.model.elements.iter().zip(&other.model.elements).all(|(a, b)| {
                (&a.dofs, &a.state, &a.force, &a.load) == (&b.dofs, &b.state, &b.force, &b.load) && a.tag == b.tag
            })
            && self.loads.matches(other.loads)
    }
}

/// Returns true if nothing that is held has a velocity or an acceleration, or ever gets one.
fn rests_at_supports(work: &Workspace, state: &State) -> bool {
    let held = |field: &[f64]| work.plan.map.held.iter().zip(field).all(|(held, x)| !held || *x == 0.0);
    work.loads.imposed.is_empty() && held(&state.vel) && held(&state.accel)
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
    /// Of the engines' models and analyses, with `dt` as the length of a step in time; `None` where they are not made for it.
    pub(super) fn new(engines: &mut [&mut Engine], dt: f64) -> Option<Self> {
        if engines.is_empty() || engines.len() > WIDTH {
            return None;
        }
        for engine in engines.iter_mut() {
            let handler = engine.handler();
            engine.prepare(handler).ok()?;
            let coefficients = Advance::new(engine, dt)?.coefficients();
            let (model, _, work) = engine.parts();
            work?.assemble_constant(model, coefficients);
        }
        let dynamic = |e: &Engine| e.setup().is_some_and(|s| s.kind == Kind::Transient);
        let constants: Option<Vec<ConstantParts<'_>>> =
            engines.iter().map(|e| e.prepared()?.constant_parts(e.model(), dynamic(e))).collect();
        let constants = constants?;
        let own = engines.iter().zip(&constants).map(|(e, constant)| Parts::new(e, constant, dt));
        let own = own.collect::<Option<Vec<Parts<'_>>>>()?;
        // Places without a model repeat the first one.
        let all: [Parts<'_>; WIDTH] = std::array::from_fn(|lane| *own.get(lane).unwrap_or(&own[0]));
        let first = all[0];
        let watches = |p: &Parts<'_>| p.model.elements.iter().any(|e| !e.limit_curves.is_empty());
        if !own.iter().all(|p| first.matches(p) && !watches(p)) {
            return None;
        }
        Self::of_parts(&all)
    }

    /// Of the parts of engines that go side by side.
    fn of_parts(all: &[Parts<'_>; WIDTH]) -> Option<Self> {
        let first = all[0];
        let mut damping = 0;
        let places = 0..first.model.elements.len();
        let elements: Vec<Entry> = places.map(|i| entry(all, i, &mut damping)).collect::<Option<_>>()?;
        let committed = Motion {
            disp: wides_of(&all.map(|p| &p.state.disp[..])),
            vel: wides_of(&all.map(|p| &p.state.vel[..])),
            accel: wides_of(&all.map(|p| &p.state.accel[..])),
            history: wides_of(&all.map(|p| &p.state.history[..])),
            force: wides_of(&all.map(|p| &p.state.force[..])),
        };
        let (loads, imposed) = terms(all);
        let drives: Vec<Drive> = first.loads.drives().to_vec();
        Some(Self {
            plan: first.plan.clone(),
            dynamics: match first.advance.newmark() {
                None => None,
                Some(newmark) => Some(dynamics(all, newmark)?),
            },
            work: Work::new(all, &elements, damping, &committed),
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
            increment: first.advance.increment(),
            time: first.state.time,
            start: first.state.time,
            trial: committed.clone(),
            committed,
            flags: Course {
                is_current: 0,
                evaluated: 0,
                is_factored: 0,
                // So far no step of the plan has been in balance.
                balanced: 0,
                expected: all.map(|p| p.newton.expected),
            },
            safe_displacement: all.iter().map(|p| p.safe_displacement).fold(f64::INFINITY, f64::min),
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
            if self.dynamics.is_some() {
                for (own, all) in [(&mut state.vel, &self.committed.vel), (&mut state.accel, &self.committed.accel)] {
                    own.iter_mut().zip(all).for_each(|(own, all)| *own = all.0[lane]);
                }
                return;
            }
            for i in self.imposed.iter().filter(|i| !i.constant) {
                let [vel, accel] = self.drives[i.pattern].derivatives(self.time);
                (state.vel[i.dof], state.accel[i.dof]) = (i.value.0[lane] * vel, i.value.0[lane] * accel);
            }
        });
        engine.forget_work();
        engine.note_led();
        engine.steps += steps as u64;
    }
}

impl Work {
    /// For elements, with so many numbers in their damping matrices.
    fn new(all: &[Parts<'_>; WIDTH], elements: &[Entry], damping: usize, committed: &Motion) -> Self {
        let n = all[0].plan.equations();
        let zeros = |n: usize| vec![Wide::all(0.0); n];
        let most = elements.iter().map(|e| e.dofs.len()).max().unwrap_or(0);
        Self {
            nodal: zeros(committed.disp.len()),
            full: zeros(committed.disp.len()),
            b: zeros(n),
            x: zeros(n),
            matrix: zeros(n * n),
            base: wides_of(&all.map(|p| p.constant.base)),
            wide_factors: WideLu::new(n),
            factors: DenseLu::new(n),
            values: vec![0.0; n * n],
            solution: vec![0.0; n],
            disp: zeros(most),
            vel: zeros(most),
            tangents: zeros(elements.iter().map(|e| e.dofs.len().pow(2)).sum()),
            damping: zeros(damping),
            evaluated: [committed.force.clone(), committed.force.clone()],
            slack: Wide::all(0.0),
            saved: vec![],
        }
    }
}

/// Forces and imposed displacements of all models.
fn terms(all: &[Parts<'_>; WIDTH]) -> (Vec<LoadTerm>, Vec<ImposedTerm>) {
    let first = &all[0];
    let load = |(i, (dof, pattern, constant)): (usize, (usize, usize, bool))| LoadTerm {
        dof,
        pattern,
        value: Wide(all.map(|p| p.loads.value(i))),
        constant,
    };
    let imposed = |(i, (dof, pattern, constant)): (usize, (usize, usize, bool))| ImposedTerm {
        dof,
        pattern,
        initial: Wide(all.map(|p| p.loads.imposed_numbers(i)[0])),
        value: Wide(all.map(|p| p.loads.imposed_numbers(i)[1])),
        constant,
        rates: first.loads.imposed[i].has_rates(),
    };
    let loads = first.loads.places().enumerate().map(load).collect();
    (loads, first.loads.imposed_places().enumerate().map(imposed).collect())
}

/// Inertia and damping of all models.
fn dynamics(all: &[Parts<'_>; WIDTH], newmark: &Newmark) -> Option<Dynamics> {
    let first = &all[0];
    let elements = first.model.elements.iter();
    let places: Vec<_> = elements.map(|e| ElementPlace { dofs: &e.dofs, start: e.force.start }).collect();
    let ground = all.map(|p| p.loads.ground_inertia());
    Dynamics::new(newmark, first.advance.increment(), first.plan, &all.map(|p| p.constant), &ground, &places)
}

/// An element of all models; `damping` counts the numbers of damping matrices.
fn entry(all: &[Parts<'_>; WIDTH], i: usize, damping: &mut usize) -> Option<Entry> {
    let elements: [&Arc<dyn Element>; WIDTH] = all.map(|p| &p.model.elements[i].element);
    let e = &all[0].model.elements[i];
    let own = all.map(|p| &p.constant.elements[i]);
    if own.iter().any(|e| (e.linear, e.viscous) != (own[0].linear, own[0].viscous)) {
        return None;
    }
    let traits = e.element.traits();
    let free = |d: &u32| !all[0].plan.map.terms(*d as usize).is_empty();
    let rows = Rows::of(e.dofs.iter().map(free));
    let start = *damping;
    *damping += if own[0].viscous { e.dofs.len().pow(2) } else { 0 };
    let c = all[0].advance.coefficients().c;
    let mut damping_in_tangent = wides_of(&own.map(|e| if e.linear { &[] } else { e.damping.0 }));
    let factor = Wide(own.map(|e| c * e.damping_in_tangent));
    damping_in_tangent.iter_mut().for_each(|x| *x = *x * factor);
    Some(Entry {
        element: elements[0].lockstep(&elements)?,
        dofs: e.dofs.to_vec(),
        state: e.state.clone(),
        force: e.force.clone(),
        part: MatrixMask { rows, columns: rows },
        rates: traits.viscous || traits.elapses,
        linear: own[0].linear,
        damping: own[0].viscous.then_some(start..*damping),
        damping_in_tangent: if c == 0.0 { vec![] } else { damping_in_tangent },
    })
}
