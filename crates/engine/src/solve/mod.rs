//! Linear systems: dense and sparse, symmetric and not, factored again and again on the same pattern without
//! allocating.

mod dense;
pub mod eigen;
mod exchanges;
mod fronts;
mod lu;
mod ordering;
mod pivoted;
mod refine;
mod threads;
mod wide_lu;

use crate::assembly::{Pattern, Storage};
pub(crate) use dense::DenseLu;
use exchanges::Exchanges;
use fronts::Fronts;
use lu::Lu;
use pivoted::PivotedLu;
use refine::Gmres;
pub use threads::Threads;
pub(crate) use wide_lu::WideLu;

/// A pivot of this fraction of the diagonal it came from means that the equations are singular to round-off.
pub const SINGULAR: f64 = 1e-14;
/// A pivot of this fraction means that few digits of the solution are left.
pub const NEARLY_SINGULAR: f64 = 1e-11;

/// Multiplications of a factorisation from which on fronts are quicker than panels of columns.
const LARGE: f64 = 1e7;
/// So many equations and fewer take fewer multiplications, whatever their pattern.
const FEW: usize = 300;

/// Result of a factorisation.
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

/// Number of solutions with a matrix that are expected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Use {
    /// Once: old factors may do, if the matrix has changed little.
    Once,
    /// Several times: it is worth factors of its own.
    Often,
}

/// Factors of the last matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Factors {
    None,
    /// Of the matrix itself.
    Own,
    /// Of a matrix before it.
    Old,
}

/// Solves systems with one pattern, again and again.
#[derive(Debug)]
pub struct Solver {
    kind: Kind,
    factors: Factors,
    gmres: Gmres,
    /// Steps of GMRES that cost less than factors.
    patience: usize,
    /// Number of factorisations so far.
    pub factorizations: u64,
}

#[derive(Debug)]
enum Kind {
    Dense(DenseLu),
    Fronts(Box<Fronts>, Exchanges),
    Lu(Box<Lu>, Exchanges),
    Pivoted(Box<PivotedLu>),
}

impl Solver {
    /// For a pattern; `indefinite` allows row exchanges, which systems with Lagrange multipliers need.
    ///
    /// # Errors
    /// Not enough memory.
    pub fn new(pattern: &Pattern, indefinite: bool, threads: &Threads) -> Result<Self, SolveError> {
        let kind = match pattern.storage {
            Storage::Dense => Kind::Dense(DenseLu::new(pattern.n)),
            Storage::Full if indefinite => Kind::Pivoted(Box::new(PivotedLu::new(pattern)?)),
            Storage::Upper | Storage::Full => {
                let large = if pattern.n > FEW { Fronts::new(pattern, LARGE, threads)? } else { None };
                match large {
                    Some(fronts) => Kind::Fronts(Box::new(fronts), Exchanges::default()),
                    None => Kind::Lu(Box::new(Lu::new(pattern)?), Exchanges::default()),
                }
            }
        };
        // Half of the work of factors at most, since they may be needed after all.
        let step = |solve: f64| solve + 2.0 * pattern.len() as f64;
        let patience = match &kind {
            Kind::Dense(_) | Kind::Pivoted(_) => 0,
            Kind::Fronts(s, _) => (0.5 * s.work().0 / step(s.work().1)) as usize,
            Kind::Lu(s, _) => (0.5 * s.work().0 / step(s.work().1)) as usize,
        };
        let patience = patience.min(8);
        let mut gmres = Gmres::default();
        gmres.reserve(pattern.n, patience);
        Ok(Self { kind, factors: Factors::None, gmres, patience, factorizations: 0 })
    }

    /// Take a new matrix to solve with. Its factors are made at once where there are none that may do.
    ///
    /// # Errors
    /// An equation without a pivot.
    pub fn prepare(&mut self, pattern: &Pattern, values: &[f64], how: Use) -> Result<Option<Pivots>, SolveError> {
        if how == Use::Once && self.factors != Factors::None && self.patience > 1 {
            self.factors = Factors::Old;
            return Ok(None);
        }
        self.factor(pattern, values).map(Some)
    }

    /// Factor the matrix with these values.
    ///
    /// # Errors
    /// An equation without a pivot.
    pub fn factor(&mut self, pattern: &Pattern, values: &[f64]) -> Result<Pivots, SolveError> {
        self.factorizations += 1;
        self.factors = Factors::None;
        let pivots = match &mut self.kind {
            Kind::Dense(s) => s.factor(values),
            Kind::Fronts(s, exchanges) => exchanges.where_lost(s.factor(values), pattern, values),
            Kind::Lu(s, exchanges) => exchanges.where_lost(s.factor(values), pattern, values),
            Kind::Pivoted(s) => s.factor(pattern, values),
        }?;
        if pivots.ratio == 0.0 {
            return Err(SolveError::Singular { equation: pivots.equation });
        }
        self.factors = Factors::Own;
        Ok(pivots)
    }

    /// Returns true if there are factors.
    pub fn is_factored(&self) -> bool {
        self.factors != Factors::None
    }

    /// Returns true if the factors are those of a matrix before the last.
    pub fn is_outdated(&self) -> bool {
        self.factors == Factors::Old
    }

    /// Forget the factors.
    pub fn forget(&mut self) {
        self.factors = Factors::None;
    }

    /// Solve with the matrix of the last [`Solver::prepare`], in place; length n. Tells of factors made on the way.
    ///
    /// # Errors
    /// An equation without a pivot.
    pub fn solve(&mut self, pattern: &Pattern, values: &[f64], x: &mut [f64]) -> Result<Option<Pivots>, SolveError> {
        let mut made = None;
        if self.factors != Factors::Own {
            let kind = &mut self.kind;
            let done = self.factors == Factors::Old
                && self.gmres.solve(
                    self.patience,
                    x,
                    |v, w| pattern.multiply(values, v, w),
                    |v| back_substitute(kind, v),
                );
            if done {
                return Ok(None);
            }
            made = Some(self.factor(pattern, values)?);
        }
        back_substitute(&mut self.kind, x);
        Ok(made)
    }

    /// Solve with the factors as they are, in place.
    pub fn back_substitute(&mut self, x: &mut [f64]) {
        back_substitute(&mut self.kind, x);
    }

    /// The same for right-hand sides of length n that follow each other: large factors are read once for all of them.
    pub fn back_substitute_all(&mut self, n: usize, x: &mut [f64]) {
        match &mut self.kind {
            Kind::Fronts(s, exchanges) if !exchanges.are_in_use() => s.solve(x),
            kind => x.chunks_exact_mut(n.max(1)).for_each(|x| back_substitute(kind, x)),
        }
    }
}

fn back_substitute(kind: &mut Kind, x: &mut [f64]) {
    match kind {
        Kind::Dense(s) => s.solve(x),
        Kind::Fronts(s, exchanges) => exchanges.solve_or(x, |x| s.solve(x)),
        Kind::Lu(s, exchanges) => exchanges.solve_or(x, |x| s.solve(x)),
        Kind::Pivoted(s) => s.solve(x),
    }
}

/// X of A X = B for small dense matrices, all of them square of the same size and by rows.
///
/// # Errors
/// A has no inverse.
pub fn solve_dense(a: &[f64], b: &[f64]) -> Result<Vec<f64>, SolveError> {
    let n = a.len().isqrt();
    let mut factors = DenseLu::new(n);
    factors.factor(a)?;
    let (mut x, mut column) = (vec![0.0; n * n], vec![0.0; n]);
    for j in 0..n {
        column.iter_mut().enumerate().for_each(|(i, c)| *c = b[i * n + j]);
        factors.solve(&mut column);
        column.iter().enumerate().for_each(|(i, c)| x[i * n + j] = *c);
    }
    Ok(x)
}
