//! Settings of a search: the method with its constants, the number of repeats, and the seed.

use super::method::{
    CmaEs, Crossover, DifferentialEvolution, EvolutionSettings, LevenbergMarquardt, MethodState, Shade, ShadeVariant,
    StepSearch,
};
use super::search::Stage;
use crate::study::{Study, StudyError};
use hysteron_tcl::diagnostic::{Diagnostic, Span, nearest};
use serde::{Deserialize, Serialize};

/// Method of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum SearchMethod {
    /// Differential evolution with [`Crossover::Forced`].
    DifferentialEvolution,
    /// Differential evolution with [`Crossover::AsPrinted`].
    DifferentialEvolutionAsPrinted,
    /// L-SHADE.
    LShade,
    /// jSO.
    Jso,
    /// CMA-ES.
    CmaEs,
    /// Least squares from several starting points.
    LeastSquares,
    /// Step search along the parameters.
    StepSearch,
}

impl SearchMethod {
    /// All methods with their names in a study.
    pub const ALL: [(&'static str, Self); 7] = [
        ("de/rand/1/bin", Self::DifferentialEvolution),
        ("de/rand/1/bin/printed", Self::DifferentialEvolutionAsPrinted),
        ("l-shade", Self::LShade),
        ("jso", Self::Jso),
        ("cma-es", Self::CmaEs),
        ("least-squares", Self::LeastSquares),
        ("step-search", Self::StepSearch),
    ];

    /// The default: the quickest of the methods that search the whole ranges, on the problems of `benches/README.md`.
    pub const DEFAULT: Self = Self::CmaEs;

    /// Name of the method in a study.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, s)| *s == self).map_or("", |(n, _)| n)
    }

    /// The method of a name, which has a location in a file or none.
    fn from_name(name: &str, span: Option<Span>) -> Result<Self, StudyError> {
        if let Some((_, s)) = Self::ALL.iter().find(|(n, _)| *n == name) {
            return Ok(*s);
        }
        let known = Self::ALL.map(|(n, _)| n);
        let d = Diagnostic::error(format!("unknown method \"{name}\""));
        let d = d.at(span, format!("expected one of {}", known.join(", ")));
        Err(Box::new(d.suggest(name, nearest(name, known))))
    }

    /// Default of [`SearchSettings::polish`]. Differential evolution and the step search are left as their sources have them.
    fn is_polished(self) -> bool {
        !matches!(self, Self::DifferentialEvolution | Self::DifferentialEvolutionAsPrinted | Self::StepSearch)
    }
}

/// Settings of a search.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SearchSettings {
    /// The method.
    pub method: SearchMethod,
    /// Population size, or number of starting points of least squares; `None` for the default of the method.
    pub population: Option<usize>,
    /// Number of generations of differential evolution.
    pub generations: usize,
    /// Mutation constant F.
    pub f: f64,
    /// Crossover constant CR.
    pub cr: f64,
    /// Seed of the random numbers. A repeat adds its index.
    pub seed: u64,
    /// Number of searches.
    pub repeats: usize,
    /// Evaluations of all methods but differential evolution; `None` for a default by the number of parameters.
    pub evaluations: Option<usize>,
    /// Least squares start from the best point at the end.
    pub polish: bool,
}

impl Default for SearchSettings {
    fn default() -> Self {
        Self {
            method: SearchMethod::DEFAULT,
            population: None,
            generations: 150,
            f: 0.8,
            cr: 0.5,
            seed: 1,
            repeats: 1,
            evaluations: None,
            polish: true,
        }
    }
}

impl SearchSettings {
    /// The settings of a study, with defaults for all that it leaves open.
    ///
    /// # Errors
    /// The method is unknown.
    pub fn of(study: &Study) -> Result<Self, StudyError> {
        let c = &study.calibration;
        let default = Self::default();
        let method = match &c.method {
            None => default.method,
            Some((name, span)) => SearchMethod::from_name(name, Some(*span))?,
        };
        Ok(Self {
            method,
            population: c.population,
            generations: c.generations.unwrap_or(default.generations),
            f: c.f.unwrap_or(default.f),
            cr: c.cr.unwrap_or(default.cr),
            seed: c.seed.unwrap_or(default.seed),
            repeats: c.repeats.unwrap_or(default.repeats),
            evaluations: c.evaluations,
            polish: c.polish.unwrap_or(method.is_polished()),
        })
    }

    /// Set the method by its name, with its default of [`SearchSettings::polish`].
    ///
    /// # Errors
    /// The method is unknown.
    pub fn set_method(&mut self, name: &str) -> Result<(), StudyError> {
        self.method = SearchMethod::from_name(name, None)?;
        self.polish = self.method.is_polished();
        Ok(())
    }

    /// Evaluations of a search without least squares at its end.
    pub fn budget(&self, dimension: usize) -> usize {
        match self.method {
            SearchMethod::DifferentialEvolution | SearchMethod::DifferentialEvolutionAsPrinted => {
                self.evolution_population() * (self.generations + 1)
            }
            _ => self.evaluations.unwrap_or(300 * dimension + 300),
        }
    }

    fn evolution_population(&self) -> usize {
        self.population.unwrap_or(50)
    }

    /// Number of starting points of least squares.
    pub(super) fn starting_points(&self) -> usize {
        self.population.unwrap_or(10)
    }

    /// Stage in which a repeat begins.
    pub(super) fn first_stage(&self) -> Stage {
        if self.method == SearchMethod::LeastSquares { Stage::Start(0) } else { Stage::Search }
    }

    /// The method of a stage of a repeat. `initial` is the unit point of the script's own values; `best` is the best unit
    /// point of the repeat so far, and `used` the number of its evaluations.
    pub(super) fn method_state(
        &self,
        repeat: usize,
        stage: Stage,
        initial: &[f64],
        (best, used): (&[f64], usize),
    ) -> MethodState {
        let n = initial.len();
        let seed = self.seed.wrapping_add(repeat as u64);
        let budget = self.budget(n);
        let shade = |variant| MethodState::Shade(Shade::new(variant, n, budget, self.population, seed));
        let evolution = |crossover| {
            let (population, generations) = (self.evolution_population(), self.generations);
            let settings = EvolutionSettings { population, generations, f: self.f, cr: self.cr, crossover };
            MethodState::DifferentialEvolution(DifferentialEvolution::new(settings, n, seed))
        };
        let least_squares = |from: &[f64], budget: usize, min_relative_gain: f64| {
            let search = LevenbergMarquardt::new(from, budget).with_single_steps(min_relative_gain);
            MethodState::LevenbergMarquardt(search.with_promised_gain())
        };
        let start_budget = (budget / self.starting_points()).max(8 * n);
        match (stage, self.method) {
            (Stage::Start(0), _) if repeat == 0 => least_squares(initial, start_budget, START_GAIN),
            (Stage::Start(k), _) => least_squares(&random_start(n, seed, k), start_budget, START_GAIN),
            (Stage::Polish | Stage::LastPolish, _) => least_squares(best, Self::polish_budget(n), POLISH_GAIN),
            // Other random starts than those of the method `least-squares`.
            (Stage::Confirmation(k), _) => {
                least_squares(&random_start(n, seed, usize::MAX - k), (10 * (n + 2)).max(budget / 10), START_GAIN)
            }
            (Stage::Restarts, _) => {
                let population = 2 * CmaEs::population(n, self.population);
                let left = budget.saturating_sub(used);
                MethodState::CmaEs(CmaEs::new(n, left, Some(population), seed.wrapping_add(RESTART_SEED)))
            }
            (Stage::Search, SearchMethod::DifferentialEvolution) => evolution(Crossover::Forced),
            (Stage::Search, SearchMethod::DifferentialEvolutionAsPrinted) => evolution(Crossover::AsPrinted),
            (Stage::Search, SearchMethod::StepSearch) if repeat == 0 => {
                MethodState::StepSearch(StepSearch::new(initial, budget))
            }
            (Stage::Search, SearchMethod::StepSearch) => {
                MethodState::StepSearch(StepSearch::new(&random_start(n, seed, 0), budget))
            }
            (Stage::Search, SearchMethod::LShade) => shade(ShadeVariant::LShade),
            (Stage::Search, SearchMethod::Jso) => shade(ShadeVariant::Jso),
            (Stage::Search, SearchMethod::CmaEs | SearchMethod::LeastSquares) => {
                let search = CmaEs::new(n, budget, self.population, seed);
                // Without least squares nothing confirms what a single descent has found.
                MethodState::CmaEs(if self.polish { search.with_single_descent() } else { search })
            }
        }
    }

    /// Evaluations of least squares at the end of a search.
    pub(super) fn polish_budget(dimension: usize) -> usize {
        40 * (dimension + 4)
    }
}

/// Relative improvement of the objective below which least squares from a starting point end: the best of them is polished.
const START_GAIN: f64 = 1e-6;
/// The same of the polish.
const POLISH_GAIN: f64 = 1e-9;
/// Added to the seed where an evolution strategy restarts after a confirmation that failed.
const RESTART_SEED: u64 = 0x9E37_79B9;

/// A random unit point for a stage of a repeat.
fn random_start(dimension: usize, seed: u64, stage: usize) -> Vec<f64> {
    use rand::{RngExt as _, SeedableRng as _};
    let mut rng = rand_pcg::Pcg32::seed_from_u64(seed.wrapping_mul(1_000_003).wrapping_add(stage as u64));
    (0..dimension).map(|_| rng.random::<f64>()).collect()
}
