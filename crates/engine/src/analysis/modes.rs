//! Natural modes of the model in its committed state.

use super::engine::Engine;
use super::failure::{Cause, Failure};
use super::state::State;
use super::system::{Coefficients, System};
use super::workspace::{TangentMix, Workspace};
use crate::solve::eigen::{self, Pair, Pencil};
use crate::solve::{Pivots, SINGULAR, SolveError};

/// Natural modes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Modes {
    /// Eigenvalues λ = ω², rising.
    pub lambda: Vec<f64>,
    /// Mode shapes over all degrees of freedom, of unit modal mass.
    pub shapes: Vec<Vec<f64>>,
    /// Modes among them that move the model as a rigid body or a mechanism: their eigenvalue is 0.
    pub rigid: usize,
}

/// Eigenvalue problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Problem {
    /// K x = λ M x.
    Generalized,
    /// K x = λ x.
    Standard,
}

/// Choice of modes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ModeRequest {
    /// Their number.
    pub count: usize,
    /// Eigenvalue problem.
    pub problem: Problem,
    /// Modes with the largest eigenvalues instead of the smallest.
    pub largest: bool,
    /// As OpenSees' solver `-fullGenLapack` gives them: always the smallest, with infinite values (the largest number)
    /// where the mass moves no more modes, and shapes of unit length in a mass matrix whose rows are summed up on its
    /// diagonal.
    pub lapack: bool,
}

impl ModeRequest {
    /// The `count` smallest.
    pub fn smallest(count: usize) -> Self {
        Self { count, problem: Problem::Generalized, largest: false, lapack: false }
    }
}

/// Why there are no modes.
#[derive(Clone, Debug, PartialEq)]
pub enum ModesError {
    /// The equations cannot be made or solved.
    Failure(Failure),
    /// The tangent has no eigenvalues that could be found.
    NotFound,
    /// There are fewer modes than required: the mass moves only so many.
    TooFew {
        /// Number of modes that there are.
        available: usize,
    },
}

impl From<Failure> for ModesError {
    fn from(f: Failure) -> Self {
        Self::Failure(f)
    }
}

impl std::fmt::Display for ModesError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Failure(e) => write!(f, "{e}"),
            Self::NotFound => write!(
                f,
                "no eigenvalues were found: stiffness or mass hold a number that is not finite, or the iterations for the \
                 eigenvalues of an unsymmetric stiffness did not end"
            ),
            Self::TooFew { available } => {
                write!(f, "the model has only {available} modes: as many as independent motions that have a mass")
            }
        }
    }
}

impl std::error::Error for ModesError {}

/// The factored stiffness and the mass matrix.
struct ElementWorkspace<'a> {
    work: &'a mut Workspace,
    /// Mass; `None` for the unit matrix.
    mass: Option<Vec<f64>>,
}

impl Pencil for ElementWorkspace<'_> {
    fn len(&self) -> usize {
        self.work.plan.equations()
    }
    fn solve(&mut self, x: &mut [f64]) {
        self.work.solver.back_substitute_all(self.work.plan.equations(), x);
    }
    fn mass(&self, x: &[f64], y: &mut [f64]) {
        match &self.mass {
            Some(m) => self.work.plan.pattern.multiply(m, x, y),
            None => {
                let n = self.work.plan.map.equations;
                y[..n].copy_from_slice(&x[..n]);
                y[n..].fill(0.0);
            }
        }
    }
}

/// Scale the vectors to unit length in the mass matrix with its rows summed up on the diagonal, and fill up with
/// infinite eigenvalues.
fn as_lapack(matrices: &ElementWorkspace<'_>, pairs: &mut Vec<Pair>, count: usize) {
    let n = matrices.len();
    let mut sums = vec![0.0; n];
    matrices.mass(&vec![1.0; n], &mut sums);
    for p in pairs.iter_mut() {
        let square: f64 = p.vector.iter().zip(&sums).map(|(x, m)| m * x * x).sum();
        // If the sums are no length, LAPACK's scale: the largest entry is one.
        let size = if square > 0.0 { square.sqrt() } else { p.vector.iter().fold(0.0f64, |m, x| m.max(x.abs())) };
        p.vector.iter_mut().for_each(|x| *x /= size);
    }
    pairs.resize(pairs.len().max(count), Pair { lambda: f64::MAX, vector: vec![0.0; n] });
}

/// Stiffen an equation that has no mass. Returns false if it has.
fn hold(work: &mut Workspace, equation: usize, mass: Option<&[f64]>) -> bool {
    let Some(place) = work.plan.pattern.place(equation, equation) else { return false };
    if mass.is_none_or(|m| m[place] != 0.0) {
        return false;
    }
    work.matrix.values[place] += work.matrix.values.iter().fold(0.0f64, |most, k| most.max(k.abs()));
    work.note_pivot(Pivots { equation, ratio: 0.0 });
    true
}

/// Eigenvalue over the shift of the stiffness below which it is round-off.
const RIGID: f64 = 1e-5;

impl Engine {
    /// Modes by rising eigenvalue, under the constraints as the analysis handles them; they stay with the engine.
    ///
    /// # Errors
    /// A model that cannot be analysed, or that has fewer modes.
    pub fn find_modes(&mut self, wanted: ModeRequest) -> Result<&Modes, ModesError> {
        let ModeRequest { count, problem, largest, lapack } = wanted;
        let largest = largest && !lapack;
        let handler = self.handler();
        self.prepare(handler)?;
        self.respond_as_committed()?;
        let (model, state, work) = self.parts();
        let Some(work) = work else { return Err(ModesError::TooFew { available: 0 }) };
        let time = state.time;
        work.assemble(model, Coefficients { k: 0.0, c: 0.0, m: 1.0 }, TangentMix::CURRENT);
        let mass = match problem {
            Problem::Generalized => Some(work.matrix.values.clone()),
            Problem::Standard => None,
        };
        work.assemble(model, Coefficients { k: 1.0, c: 0.0, m: 0.0 }, TangentMix::CURRENT);
        let sum = |v: &[f64]| v.iter().map(|x| x.abs()).sum::<f64>();
        let masses = mass.as_deref().map_or(work.plan.equations() as f64, sum);
        let failure = |cause| Failure::new(cause, time, -3);
        if masses == 0.0 {
            return Err(ModesError::TooFew { available: 0 });
        }
        // A body that floats is held by a very soft spring, which the eigenvalues are freed of again.
        let mut shift = 0.0;
        for attempt in 0..work.plan.equations() + 2 {
            let pivots = work.solver.factor(&work.plan.pattern, &work.matrix.values);
            let singular = match pivots {
                Ok(p) if p.ratio > SINGULAR || !work.plan.handler.eliminates() => break,
                Err(SolveError::OutOfMemory) => return Err(failure(Cause::OutOfMemory).into()),
                Ok(p) => p.equation,
                Err(SolveError::Singular { equation }) => equation,
            };
            match attempt {
                0 => {
                    shift = -1e-7 * sum(&work.matrix.values) / masses;
                    match &mass {
                        Some(m) => work.matrix.values.iter_mut().zip(m).for_each(|(k, m)| *k -= shift * m),
                        None => (0..work.plan.map.equations).for_each(|e| {
                            if let Some(at) = work.plan.pattern.place(e, e) {
                                work.matrix.values[at] -= shift;
                            }
                        }),
                    }
                }
                // As in OpenSees a mechanism without mass has no mode, and stops no other.
                _ if work.opensees.is_some() && hold(work, singular, mass.as_deref()) => {}
                _ => {
                    let place = Some(work.plan.equation_name(model, singular));
                    return Err(failure(Cause::Singular).at(place).into());
                }
            }
        }
        let available = work.plan.map.equations;
        let wanted = if largest { available } else { count };
        let mut matrices = ElementWorkspace { work: &mut *work, mass };
        let found = eigen::nearest(&mut matrices, wanted);
        let Ok(mut pairs) = found else {
            work.solver.forget();
            return Err(ModesError::NotFound);
        };
        if largest {
            pairs.drain(..pairs.len().saturating_sub(count));
        }
        if lapack {
            as_lapack(&matrices, &mut pairs, count.min(available));
        }
        // The factors are not those of a step.
        work.solver.forget();
        if pairs.len() < count {
            return Err(ModesError::TooFew { available: pairs.len() });
        }
        let n = work.plan.map.equations;
        let shapes = pairs.iter().map(|p| {
            let mut full = vec![0.0; model.dofs()];
            work.plan.map.spread(&p.vector[..n], &mut full);
            full
        });
        let shapes = shapes.collect();
        let mut lambda: Vec<f64> = pairs.iter().map(|p| p.lambda + shift).collect();
        let is_rigid = |l: &&mut f64| l.abs() < RIGID * shift.abs();
        let rigid = lambda.iter_mut().filter(is_rigid).map(|l| *l = 0.0).count();
        let modes = Modes { lambda, shapes, rigid };
        Ok(self.results.modes.insert(modes))
    }

    /// The modes found last.
    pub fn modes(&self) -> Option<&Modes> {
        // After the removal of nodes the shapes are those of another model.
        self.results.modes.as_ref().filter(|m| m.shapes.iter().all(|s| s.len() == self.model().dofs()))
    }

    /// Tangents of all elements in the committed state: those of the step that has come to it.
    pub(super) fn respond_as_committed(&mut self) -> Result<(), Failure> {
        let step_start = self.step_start.state(self.state());
        let time = self.state().time;
        self.with_system_from(step_start.as_ref(), |system| {
            system.apply_loads(time)?;
            system.respond(true)
        })
    }

    /// Do something with the equations at the committed state; nothing is committed.
    pub(super) fn with_system<T>(
        &mut self,
        act: impl FnOnce(&mut System<'_>) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        self.with_system_from(None, act)
    }

    /// The same as at the end of a step from another state, of which the time is that of a step.
    fn with_system_from<T>(
        &mut self,
        step_start: Option<&State>,
        act: impl FnOnce(&mut System<'_>) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let Some(system) = self.system() else { unreachable!("called after prepare") };
        let committed = system.old;
        let (old, elapses) = (step_start.unwrap_or(committed), step_start.is_some());
        let mut system = System { old, elapses, ..system };
        let result = act(&mut system);
        system.work.loads.invalidate();
        system.new.copy_from(committed);
        result
    }
}
