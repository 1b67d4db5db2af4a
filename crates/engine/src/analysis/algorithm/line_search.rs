//! Newton's method with a search for the best length of each correction.

use super::{Algorithm, Iteration, TangentChoice};
use crate::analysis::convergence::TestOutcome;
use crate::analysis::failure::Failure;
use crate::numeric::dot;
use crate::solve::Use;

/// Method of the search for the length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SearchKind {
    /// Interpolation from the first two lengths (Crisfield, 1991, section 9.2).
    InitialInterpolated,
    /// Halving of a bracket.
    Bisection,
    /// Secants.
    Secant,
    /// False position in a bracket.
    RegulaFalsi,
}

/// Parameters of a search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineSearch {
    /// Method.
    pub kind: SearchKind,
    /// Wanted ratio of the work of the unbalance on the correction, after to before.
    pub tolerance: f64,
    /// Steps of the search.
    pub max_iterations: usize,
    /// Shortest length.
    pub min_eta: f64,
    /// Longest length.
    pub max_eta: f64,
}

impl LineSearch {
    /// OpenSees' defaults.
    pub fn new(kind: SearchKind) -> Self {
        Self { kind, tolerance: 0.8, max_iterations: 10, min_eta: 0.1, max_eta: 10.0 }
    }
}

/// `algorithm NewtonLineSearch`.
#[derive(Clone, Debug)]
pub struct NewtonLineSearch {
    search: LineSearch,
    tangent: TangentChoice,
    /// The whole correction.
    direction: Vec<f64>,
    /// The correction that an integrator was given.
    asked: Vec<f64>,
}

impl NewtonLineSearch {
    /// With a search.
    pub fn new(search: LineSearch, tangent: TangentChoice) -> Self {
        Self { search, tangent, direction: vec![], asked: vec![] }
    }

    /// Move from length `from` to length `to` of the correction; the work of the unbalance on it there.
    fn go(&mut self, it: &mut Iteration<'_, '_>, from: f64, to: f64) -> Result<f64, Failure> {
        let x = &mut it.system.work.x;
        x.iter_mut().zip(&self.direction).for_each(|(x, d)| *x = (to - from) * d);
        self.update(it)?;
        // OpenSees has here the other sign than at lengths 0 and 1.
        let sign = if it.system.work.opensees.is_some() { -1.0 } else { 1.0 };
        Ok(sign * self.work(it))
    }

    /// Move, and evaluate the unbalance there. Where the integrator adds to the correction, as those that find the load factor do,
    /// OpenSees goes on along what it has moved by.
    fn update(&mut self, it: &mut Iteration<'_, '_>) -> Result<(), Failure> {
        let follows = it.system.work.opensees.is_some();
        if follows {
            self.asked.clear();
            self.asked.extend_from_slice(&it.system.work.x);
        }
        it.update()?;
        if follows && self.asked != it.system.work.x {
            self.direction.clear();
            self.direction.extend_from_slice(&it.system.work.x);
        }
        it.system.form_unbalance(true)
    }

    fn work(&self, it: &Iteration<'_, '_>) -> f64 {
        dot(&self.direction, &it.system.work.b)
    }

    /// Search from length 1; `s0` and `s1` are the work of the unbalance on the correction at lengths 0 and 1. The
    /// length found.
    fn search(&mut self, it: &mut Iteration<'_, '_>, s0: f64, s1: f64) -> Result<f64, Failure> {
        let p = self.search;
        if s0 == 0.0 || (s1 / s0).abs() <= p.tolerance {
            return Ok(1.0);
        }
        match p.kind {
            SearchKind::InitialInterpolated => self.interpolate(it, s0, s1),
            SearchKind::Secant => self.secant(it, s0, s1),
            SearchKind::Bisection | SearchKind::RegulaFalsi => self.bracket(it, s0, s1),
        }
    }

    fn limit(&self, eta: f64) -> f64 {
        eta.min(self.search.max_eta).max(self.search.min_eta)
    }

    fn interpolate(&mut self, it: &mut Iteration<'_, '_>, s0: f64, s1: f64) -> Result<f64, Failure> {
        let first = (s1 / s0).abs();
        let (mut eta, mut s, mut ratio) = (1.0, s1, first);
        for _ in 0..self.search.max_iterations {
            // The whole correction is taken where the search makes it worse.
            let next = if ratio > first { 1.0 } else { self.limit(eta * s0 / (s0 - s)) };
            if next == eta {
                break;
            }
            s = self.go(it, eta, next)?;
            (eta, ratio) = (next, (s / s0).abs());
            if ratio <= self.search.tolerance {
                break;
            }
        }
        Ok(eta)
    }

    fn secant(&mut self, it: &mut Iteration<'_, '_>, s0: f64, s1: f64) -> Result<f64, Failure> {
        let (mut previous, mut s_previous, mut eta, mut s) = (0.0, s0, 1.0, s1);
        for _ in 0..self.search.max_iterations {
            let next = self.limit(eta - s * (previous - eta) / (s_previous - s));
            if next == eta || !next.is_finite() {
                break;
            }
            (previous, s_previous) = (eta, s);
            s = self.go(it, eta, next)?;
            eta = next;
            if (s / s0).abs() <= self.search.tolerance {
                break;
            }
        }
        Ok(eta)
    }

    /// Find a bracket by longer and longer corrections, then narrow it.
    fn bracket(&mut self, it: &mut Iteration<'_, '_>, s0: f64, s1: f64) -> Result<f64, Failure> {
        let p = self.search;
        let (mut lower, mut s_lower, mut upper, mut s_upper) = (0.0, s0, 1.0, s1);
        while s_upper * s_lower > 0.0 && upper < p.max_eta {
            let next = 4.0 * upper;
            s_upper = self.go(it, upper, next)?;
            upper = next;
            if (s_upper / s0).abs() < p.tolerance {
                return Ok(upper);
            }
        }
        let mut eta = upper;
        if s_upper * s_lower > 0.0 {
            self.go(it, eta, 1.0)?;
            return Ok(1.0);
        }
        for _ in 0..p.max_iterations {
            let next = match p.kind {
                SearchKind::Bisection => 0.5 * (lower + upper),
                _ => upper - s_upper * (lower - upper) / (s_lower - s_upper),
            };
            if next == eta {
                break;
            }
            let s = self.go(it, eta, next)?;
            eta = next;
            if (s / s0).abs() <= p.tolerance || s == 0.0 {
                break;
            }
            if s * s_upper < 0.0 {
                (lower, s_lower) = (eta, s);
            } else {
                (upper, s_upper) = (eta, s);
            }
        }
        Ok(eta)
    }
}

impl Algorithm for NewtonLineSearch {
    fn name(&self) -> &'static str {
        "NewtonLineSearch"
    }

    fn solve(&mut self, it: &mut Iteration<'_, '_>) -> Result<usize, Failure> {
        it.system.form_unbalance(true)?;
        it.start_test();
        for iteration in 0.. {
            it.system.form_tangent(self.tangent.at(iteration), Use::Once)?;
            it.system.solve()?;
            self.direction.clear();
            self.direction.extend_from_slice(&it.system.work.x);
            let s0 = self.work(it);
            self.update(it)?;
            // A search only where the whole correction does not do.
            let n = it.system.work.plan.map.equations;
            let mut probe = it.test.probe();
            let done = probe.judge(&it.system.work.x[..n], &it.system.work.b[..n]) == TestOutcome::Converged;
            if !done {
                let s1 = self.work(it);
                let eta = self.search(it, s0, s1)?;
                it.system.work.x.iter_mut().zip(&self.direction).for_each(|(x, d)| *x = eta * d);
            }
            if let Some(n) = it.judge()? {
                return Ok(n);
            }
        }
        unreachable!("the test ends the iterations")
    }
}
