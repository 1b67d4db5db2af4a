//! Taking the inner nodes out of the equations of a Kikuchi bearing.

use super::kinematics::{DOFS, INNER, Matrix, Motion, OUTER};
use crate::words;

/// Displacements or forces of the inner nodes.
pub(super) type Inner = [f64; INNER];
/// What the inner nodes do for each displacement of the outer ones.
pub(super) type Follow = [[f64; INNER]; OUTER];

/// Inner displacements from those of the outer nodes: where the inner nodes follow to.
pub(super) fn followed(follow: &Follow, inner: &Inner, way: &[f64; OUTER]) -> Inner {
    follow.iter().zip(way).fold(*inner, |at, (column, d)| std::array::from_fn(|i| at[i] + column[i] * d))
}

/// Share of the virgin stiffness that holds inner nodes which no spring holds any more.
const HOLD: f64 = 1e-10;

words! {
    /// What the inner nodes do by their own equations.
    pub(super) struct Yielding {
        /// How they follow the outer ones.
        follow: [[f64; 6]; 12],
        /// How they yield to the force that is left at them.
        correction: [f64; 6],
    }
}

/// The equations with the inner nodes taken out.
pub(super) struct Condensed {
    /// What the inner nodes do.
    pub yielding: Yielding,
    /// Forces at the outer nodes once they have yielded.
    pub force: [f64; OUTER],
    /// Their stiffness.
    pub stiffness: [[f64; OUTER]; OUTER],
}

/// Columns of the equations of the inner nodes: their own displacements, those of the outer nodes, the forces.
const COLUMNS: usize = DOFS + 1;

/// The equations of the inner nodes for forces `f` and stiffness `k`, solved: with the columns behind their own that
/// `right` gives by row; `hold` is the virgin stiffness at these nodes.
fn solved<const C: usize>(k: &Matrix, hold: &Inner, right: impl Fn(usize, usize) -> f64) -> Option<[[f64; C]; INNER]> {
    let mut inner: [[f64; C]; INNER] = std::array::from_fn(|i| {
        std::array::from_fn(|j| if j < INNER { k[(OUTER + i, OUTER + j)] } else { right(i, j - INNER) })
    });
    (0..INNER).for_each(|i| inner[i][i] += HOLD * hold[i]);
    solve(&mut inner)?;
    Some(inner)
}

/// The same for displacements of the outer nodes and the forces.
fn followers(f: &Motion, k: &Matrix, hold: &Inner) -> Option<[[f64; COLUMNS]; INNER]> {
    solved(k, hold, |i, j| if j < OUTER { -k[(OUTER + i, j)] } else { -f[OUTER + i] })
}

/// How the inner nodes yield to the force that is left at them, where nothing else is asked.
pub(super) fn correction(f: &Motion, k: &Matrix, hold: &Inner) -> Option<Inner> {
    let inner = solved::<{ INNER + 1 }>(k, hold, |i, _| -f[OUTER + i])?;
    Some(inner.map(|row| row[INNER]))
}

fn yielding_of(inner: &[[f64; COLUMNS]; INNER]) -> Yielding {
    Yielding {
        follow: std::array::from_fn(|j| std::array::from_fn(|i| inner[i][INNER + j])),
        correction: std::array::from_fn(|i| inner[i][DOFS]),
    }
}

/// What the inner nodes do, where nothing else is asked.
pub(super) fn yielding(f: &Motion, k: &Matrix, hold: &Inner) -> Option<Yielding> {
    followers(f, k, hold).map(|inner| yielding_of(&inner))
}

/// Condense forces `f` and stiffness `k`; `hold` is the virgin stiffness at the inner nodes.
pub(super) fn condense(f: &Motion, k: &Matrix, hold: &Inner) -> Option<Condensed> {
    let inner = followers(f, k, hold)?;
    let mut outer: [[f64; OUTER + 1]; OUTER] =
        std::array::from_fn(|i| std::array::from_fn(|j| if j < OUTER { k[(i, j)] } else { f[i] }));
    for (i, row) in outer.iter_mut().enumerate() {
        for (m, solved) in inner.iter().enumerate() {
            let share = k[(i, OUTER + m)];
            row.iter_mut().zip(&solved[INNER..]).for_each(|(to, x)| *to += share * x);
        }
    }
    Some(Condensed {
        yielding: yielding_of(&inner),
        force: outer.map(|row| row[OUTER]),
        stiffness: outer.map(|row| std::array::from_fn(|j| row[j])),
    })
}

/// Solve equations with several right-hand sides behind their matrix, in place, by elimination with row exchange; `None`
/// where they have no finite answer.
fn solve<const C: usize>(rows: &mut [[f64; C]; INNER]) -> Option<()> {
    for p in 0..INNER {
        let largest = (p..INNER).max_by(|&i, &j| rows[i][p].abs().total_cmp(&rows[j][p].abs()))?;
        rows.swap(p, largest);
        let by = 1.0 / rows[p][p];
        rows[p].iter_mut().for_each(|x| *x *= by);
        let pivot = rows[p];
        for row in rows.iter_mut().enumerate().filter(|(i, _)| *i != p).map(|(_, row)| row) {
            let share = row[p];
            row.iter_mut().zip(&pivot).for_each(|(x, y)| *x -= share * y);
        }
    }
    rows.iter().flatten().all(|x| x.is_finite()).then_some(())
}

/// All displacements from those of the ends and of the inner nodes.
pub(super) fn join(outer: &[f64; OUTER], inner: &[f64; INNER]) -> Motion {
    Motion::from_fn(|i, _| if i < OUTER { outer[i] } else { inner[i - OUTER] })
}

const _: () = assert!(DOFS == OUTER + INNER);
