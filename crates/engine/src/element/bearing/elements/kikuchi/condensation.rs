//! Static condensation of the inner nodes of a Kikuchi bearing.

use super::kinematics::{DOFS, INNER, InnerMatrix, Matrix, Motion, OUTER};
use crate::element::{ElementError, Rows};
use crate::state_struct;

/// The error of inner nodes without stiffness.
pub(super) fn no_inner_stiffness() -> ElementError {
    ElementError("the inner nodes of the bearing are held by nothing".into())
}

/// Displacements or forces of the inner nodes.
pub(super) type Inner = [f64; INNER];

/// Linear extrapolation of the inner displacements, `inner + follow step`. `follow` has a column for each outer displacement,
/// one after the other.
pub(super) fn extrapolated(follow: &[f64], inner: &Inner, step: &[f64; OUTER]) -> Inner {
    let mut at = *inner;
    for (column, d) in follow.as_chunks::<INNER>().0.iter().zip(step).filter(|(_, d)| **d != 0.0) {
        at.iter_mut().zip(column).for_each(|(at, c)| *at += c * d);
    }
    at
}

/// Share of the virgin stiffness that is added where no spring holds the inner nodes any more.
const HOLD: f64 = 1e-10;

state_struct! {
    /// Solution of the equations of the inner nodes.
    pub(super) struct InnerSolution {
        /// Derivatives of the inner displacements by the outer ones, by columns.
        follow: [[f64; 6]; 12],
        /// Newton correction for the residual at the inner nodes.
        correction: [f64; 6],
    }
}

/// The equations with the inner nodes taken out.
#[derive(Default)]
pub(super) struct Condensed {
    /// Solution for the inner nodes.
    pub solution: InnerSolution,
    /// Forces at the outer nodes after the correction of the inner ones.
    pub force: [f64; OUTER],
    /// Wanted rows of their stiffness.
    pub stiffness: [[f64; OUTER]; OUTER],
}

/// Right-hand sides of the equations of the inner nodes: displacements of the outer nodes, the forces.
const COLUMNS: usize = OUTER + 1;

/// Factors L and U of the equations of the inner nodes, for rows in another order. L has ones in its diagonal, and the
/// pivots are kept as their inverses.
struct Factors {
    factors: InnerMatrix,
    order: [usize; INNER],
}

impl Factors {
    /// Factor a stiffness, with a hold on what no spring holds; `hold` is the virgin stiffness at these nodes.
    #[inline]
    fn of(mut k: InnerMatrix, hold: &Inner) -> Self {
        (0..INNER).for_each(|i| k[i][i] += HOLD * hold[i]);
        let mut order = [0, 1, 2, 3, 4, 5];
        for p in 0..INNER {
            let mut largest = p;
            for i in p + 1..INNER {
                if k[i][p].abs() > k[largest][p].abs() {
                    largest = i;
                }
            }
            if largest != p {
                k.swap(p, largest);
                order.swap(p, largest);
            }
            let inverse = 1.0 / k[p][p];
            k[p][p] = inverse;
            // The compiler makes vector operations of whole rows. The part left of the pivot stays.
            let mut pivot = k[p];
            pivot[..=p].fill(0.0);
            for row in &mut k[p + 1..] {
                row[p] *= inverse;
                subtract_scaled(row, row[p], &pivot);
            }
        }
        Self { factors: k, order }
    }

    /// Solve for right-hand sides, given by row; `None` where the solution is not finite.
    #[inline]
    fn solve<const C: usize>(&self, right: impl Fn(usize, &mut [f64; C])) -> Option<[[f64; C]; INNER]> {
        let mut x = [[0.0; C]; INNER];
        for i in 0..INNER {
            let (done, rest) = x.split_at_mut(i);
            right(self.order[i], &mut rest[0]);
            done.iter().zip(&self.factors[i]).for_each(|(done, share)| subtract_scaled(&mut rest[0], *share, done));
        }
        for i in (0..INNER).rev() {
            let (rest, done) = x.split_at_mut(i + 1);
            let to = &mut rest[i];
            done.iter().zip(&self.factors[i][i + 1..]).for_each(|(done, share)| subtract_scaled(to, *share, done));
            to.iter_mut().for_each(|x| *x *= self.factors[i][i]);
        }
        x.as_flattened().iter().all(|x| x.is_finite()).then_some(x)
    }
}

#[inline]
fn subtract_scaled<const C: usize>(row: &mut [f64; C], share: f64, other: &[f64; C]) {
    row.iter_mut().zip(other).for_each(|(x, y)| *x -= share * y);
}

/// Inner displacements per unit of the outer displacements, and for the forces, by rows.
#[inline]
fn solve_inner(f: &Motion, k: &Matrix, hold: &Inner) -> Option<[[f64; COLUMNS]; INNER]> {
    let mut own = [[0.0; INNER]; INNER];
    own.iter_mut().zip(&k[OUTER..]).for_each(|(own, k)| own.copy_from_slice(&k[OUTER..]));
    Factors::of(own, hold).solve(|i, right: &mut [f64; COLUMNS]| {
        right.iter_mut().zip(&k[OUTER + i][..OUTER]).for_each(|(x, k)| *x = -k);
        right[OUTER] = -f[OUTER + i];
    })
}

/// Newton correction of the inner nodes for the residual at them.
pub(super) fn correction(f: &Motion, k: InnerMatrix, hold: &Inner) -> Option<Inner> {
    let inner = Factors::of(k, hold).solve(|i, right| *right = [-f[OUTER + i]])?;
    Some(inner.map(|[x]| x))
}

#[inline]
fn write_solution(inner: &[[f64; COLUMNS]; INNER], solution: &mut InnerSolution) {
    for (i, row) in inner.iter().enumerate() {
        solution.follow.iter_mut().zip(row).for_each(|(column, x)| column[i] = *x);
        solution.correction[i] = row[OUTER];
    }
}

/// Solution for the inner nodes without the condensed forces and stiffness.
pub(super) fn solution(f: &Motion, k: &Matrix, hold: &Inner) -> Option<InnerSolution> {
    let mut solution = InnerSolution::default();
    write_solution(&solve_inner(f, k, hold)?, &mut solution);
    Some(solution)
}

/// Condense forces `f` and stiffness `k`; `hold` is the virgin stiffness at the inner nodes.
pub(super) fn condense(f: &Motion, k: &Matrix, hold: &Inner) -> Option<Condensed> {
    let mut condensed = Condensed::default();
    condense_into(f, k, hold, Rows::ALL, &mut condensed)?;
    Some(condensed)
}

/// The same into a place of zeros; only `rows` of the stiffness are made.
pub(super) fn condense_into(f: &Motion, k: &Matrix, hold: &Inner, rows: Rows, into: &mut Condensed) -> Option<()> {
    let inner = solve_inner(f, k, hold)?;
    for (i, force) in into.force.iter_mut().enumerate() {
        let shares = &k[i][OUTER..];
        *force = f[i] + shares.iter().zip(&inner).map(|(share, solved)| share * solved[OUTER]).sum::<f64>();
    }
    for i in rows.among(OUTER) {
        let row = &mut into.stiffness[i];
        row.copy_from_slice(&k[i][..OUTER]);
        for (share, solved) in k[i][OUTER..].iter().zip(&inner).filter(|(share, _)| **share != 0.0) {
            row.iter_mut().zip(&solved[..OUTER]).for_each(|(to, x)| *to += share * x);
        }
    }
    write_solution(&inner, &mut into.solution);
    Some(())
}

/// All displacements from those of the ends and of the inner nodes.
pub(super) fn join(outer: &[f64; OUTER], inner: &[f64; INNER]) -> Motion {
    Motion::from_fn(|i, _| if i < OUTER { outer[i] } else { inner[i - OUTER] })
}

const _: () = assert!(DOFS == OUTER + INNER);
