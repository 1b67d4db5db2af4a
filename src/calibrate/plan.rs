//! What is to be done: the method with its constants, how often, from which seed.

use super::method::{CmaEs, Crossover, Differential, Evolution, LevenbergMarquardt, Search, Shade, Variant};
use crate::diagnostic::{Diagnostic, Span, nearest};
use crate::study::{Rejected, Study};
use serde::{Deserialize, Serialize};

/// How the best point is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Strategy {
    /// Differential evolution with one coordinate forced.
    De,
    /// Differential evolution as the paper prints it.
    DePrinted,
    /// L-SHADE.
    LShade,
    /// jSO.
    Jso,
    /// CMA-ES.
    CmaEs,
    /// Least squares from several points.
    LeastSquares,
}

impl Strategy {
    /// All of them, with the names that a study gives them.
    pub const ALL: [(&'static str, Self); 6] = [
        ("de/rand/1/bin", Self::De),
        ("de/rand/1/bin/printed", Self::DePrinted),
        ("l-shade", Self::LShade),
        ("jso", Self::Jso),
        ("cma-es", Self::CmaEs),
        ("least-squares", Self::LeastSquares),
    ];

    /// The best measured on the project's own problems (`docs/explanation/calibration.md`).
    pub const DEFAULT: Self = Self::CmaEs;

    /// Its name.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, s)| *s == self).map_or("", |(n, _)| n)
    }

    /// By its name, which stands somewhere.
    fn named(name: &str, span: Option<Span>) -> Result<Self, Rejected> {
        if let Some((_, s)) = Self::ALL.iter().find(|(n, _)| *n == name) {
            return Ok(*s);
        }
        let known = Self::ALL.map(|(n, _)| n);
        let d = Diagnostic::error(format!("unknown method \"{name}\""));
        let d = d.at(span, format!("expected one of {}", known.join(", ")));
        Err(Box::new(match nearest(name, known) {
            Some(near) => d.help(format!("did you mean \"{near}\"?")),
            None => d,
        }))
    }

    /// Whether the best is improved by least squares unless the study says otherwise: the paper's evolution is left as it is.
    fn is_polished(self) -> bool {
        !matches!(self, Self::De | Self::DePrinted)
    }
}

/// What is to be done.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plan {
    /// The method.
    pub strategy: Strategy,
    /// Members of the population; the method's own number for none. Starting points of least squares.
    pub population: Option<usize>,
    /// Generations of differential evolution.
    pub generations: usize,
    /// Mutation constant F.
    pub f: f64,
    /// Crossover constant CR.
    pub cr: f64,
    /// Seed; a repeat adds its number.
    pub seed: u64,
    /// How often it is done.
    pub repeats: usize,
    /// Evaluations of the methods that are not told their generations; by the number of parameters for none.
    pub evaluations: Option<usize>,
    /// Improve the best by least squares at the end.
    pub polish: bool,
}

impl Default for Plan {
    fn default() -> Self {
        Self {
            strategy: Strategy::DEFAULT,
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

impl Plan {
    /// What a study says, and the usual where it says nothing.
    ///
    /// # Errors
    /// It names a method that there is not.
    pub fn of(study: &Study) -> Result<Self, Rejected> {
        let c = &study.calibration;
        let usual = Self::default();
        let strategy = match &c.method {
            None => usual.strategy,
            Some((name, span)) => Strategy::named(name, Some(*span))?,
        };
        Ok(Self {
            strategy,
            population: c.population,
            generations: c.generations.unwrap_or(usual.generations),
            f: c.f.unwrap_or(usual.f),
            cr: c.cr.unwrap_or(usual.cr),
            seed: c.seed.unwrap_or(usual.seed),
            repeats: c.repeats.unwrap_or(usual.repeats),
            evaluations: c.evaluations,
            polish: c.polish.unwrap_or(strategy.is_polished()),
        })
    }

    /// Take another method.
    ///
    /// # Errors
    /// There is none of that name.
    pub fn choose(&mut self, name: &str) -> Result<(), Rejected> {
        self.strategy = Strategy::named(name, None)?;
        self.polish = self.strategy.is_polished();
        Ok(())
    }

    /// Evaluations of a search in some dimensions, without the polish at its end.
    pub fn budget(&self, dimension: usize) -> usize {
        match self.strategy {
            Strategy::De | Strategy::DePrinted => self.members() * (self.generations + 1),
            _ => self.evaluations.unwrap_or(300 * dimension + 300),
        }
    }

    fn members(&self) -> usize {
        self.population.unwrap_or(50)
    }

    /// How many searches follow each other in a repeat.
    pub(super) fn stages(&self) -> usize {
        self.starts() + usize::from(self.polish && self.strategy != Strategy::LeastSquares)
    }

    /// Points that least squares start from; other methods start once.
    fn starts(&self) -> usize {
        if self.strategy == Strategy::LeastSquares { self.population.unwrap_or(10) } else { 1 }
    }

    /// A search of a repeat. `start` is where the user would start, `best` the best point so far.
    pub(super) fn search(&self, repeat: usize, stage: usize, start: &[f64], best: &[f64]) -> Search {
        let n = start.len();
        let seed = self.seed.wrapping_add(repeat as u64);
        let budget = self.budget(n);
        let shade = |variant| Search::Shade(Shade::new(variant, n, budget, self.population, seed));
        if stage >= self.starts() {
            return Search::LevenbergMarquardt(LevenbergMarquardt::new(best, Self::polish_budget(n)));
        }
        match self.strategy {
            Strategy::De | Strategy::DePrinted => {
                let crossover = if self.strategy == Strategy::De { Crossover::Forced } else { Crossover::Printed };
                let (population, generations) = (self.members(), self.generations);
                let constants = Differential { population, generations, f: self.f, cr: self.cr, crossover };
                Search::Evolution(Evolution::new(constants, n, seed))
            }
            Strategy::LShade => shade(Variant::LShade),
            Strategy::Jso => shade(Variant::Jso),
            Strategy::CmaEs => Search::CmaEs(CmaEs::new(n, budget, self.population, seed)),
            Strategy::LeastSquares => {
                let from = if stage == 0 && repeat == 0 { start.to_vec() } else { spread_point(n, seed, stage) };
                Search::LevenbergMarquardt(LevenbergMarquardt::new(&from, (budget / self.starts()).max(8 * n)))
            }
        }
    }

    /// Evaluations of the polish.
    fn polish_budget(dimension: usize) -> usize {
        40 * (dimension + 4)
    }
}

/// A point of the cube for a stage of a repeat.
fn spread_point(dimension: usize, seed: u64, stage: usize) -> Vec<f64> {
    use rand::{RngExt as _, SeedableRng as _};
    let mut rng = rand_pcg::Pcg32::seed_from_u64(seed.wrapping_mul(1_000_003).wrapping_add(stage as u64));
    (0..dimension).map(|_| rng.random::<f64>()).collect()
}
