//! Linear systems: dense and sparse, symmetric and not, factored again and again on the same pattern without
//! allocating.

mod dense;
pub mod eigen;
mod ldlt;
mod lu;
mod ordering;
mod pivoted;

use crate::assembly::{Pattern, Storage};
use dense::DenseLu;
use ldlt::Ldlt;
use lu::Lu;
use pivoted::PivotedLu;

/// A pivot of this fraction of the diagonal it came from means that the equations are singular to round-off.
pub const SINGULAR: f64 = 1e-14;
/// A pivot of this fraction means that few digits of the solution are left.
pub const NEARLY_SINGULAR: f64 = 1e-11;

/// What a factorisation found out about the matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pivots {
    /// Equation with the smallest pivot relative to its diagonal.
    pub equation: usize,
    /// That ratio.
    pub ratio: f64,
}

impl Pivots {
    const GOOD: Self = Self { equation: 0, ratio: f64::INFINITY };

    #[inline]
    fn see(&mut self, equation: usize, pivot: f64, diagonal: f64) {
        let ratio = if diagonal == 0.0 { if pivot == 0.0 { 0.0 } else { 1.0 } } else { (pivot / diagonal).abs() };
        // A pivot that is not a number is as bad as zero.
        let ratio = if ratio.is_nan() { 0.0 } else { ratio };
        if ratio < self.ratio {
            *self = Self { equation, ratio };
        }
    }
}

/// Why a matrix could not be factored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SolveError {
    /// An equation has no pivot.
    Singular {
        /// Equation.
        equation: usize,
    },
    /// The factors do not fit into memory.
    OutOfMemory,
}

/// A factorisation that is made again and again on one pattern.
#[derive(Debug)]
pub struct Solver {
    kind: Kind,
    factored: bool,
    /// Number of factorisations so far.
    pub factorizations: u64,
}

#[derive(Debug)]
enum Kind {
    Dense(DenseLu),
    Ldlt(Box<Ldlt>),
    Lu(Box<Lu>),
    Pivoted(Box<PivotedLu>),
}

impl Solver {
    /// For a pattern; `indefinite` asks for row exchanges, which systems with Lagrange multipliers need.
    ///
    /// # Errors
    /// Not enough memory.
    pub fn new(pattern: &Pattern, indefinite: bool) -> Result<Self, SolveError> {
        let kind = match pattern.storage {
            Storage::Dense => Kind::Dense(DenseLu::new(pattern.n)),
            Storage::Upper => Kind::Ldlt(Box::new(Ldlt::new(pattern)?)),
            Storage::Full if indefinite => Kind::Pivoted(Box::new(PivotedLu::new(pattern)?)),
            Storage::Full => Kind::Lu(Box::new(Lu::new(pattern)?)),
        };
        Ok(Self { kind, factored: false, factorizations: 0 })
    }

    /// Factor the matrix with these values.
    ///
    /// # Errors
    /// An equation without a pivot.
    pub fn factor(&mut self, pattern: &Pattern, values: &[f64]) -> Result<Pivots, SolveError> {
        self.factorizations += 1;
        self.factored = false;
        let pivots = match &mut self.kind {
            Kind::Dense(s) => s.factor(values),
            Kind::Ldlt(s) => s.factor(pattern, values),
            Kind::Lu(s) => s.factor(pattern, values),
            Kind::Pivoted(s) => s.factor(pattern, values),
        }?;
        if pivots.ratio == 0.0 {
            return Err(SolveError::Singular { equation: pivots.equation });
        }
        self.factored = true;
        Ok(pivots)
    }

    /// Whether there are factors to solve with.
    pub fn is_factored(&self) -> bool {
        self.factored
    }

    /// Do not solve with the last factors any more.
    pub fn forget(&mut self) {
        self.factored = false;
    }

    /// Solve with the last factors, in place; length n.
    pub fn solve(&mut self, x: &mut [f64]) {
        debug_assert!(self.factored);
        match &mut self.kind {
            Kind::Dense(s) => s.solve(x),
            Kind::Ldlt(s) => s.solve(x),
            Kind::Lu(s) => s.solve(x),
            Kind::Pivoted(s) => s.solve(x),
        }
    }
}
