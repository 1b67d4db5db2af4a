//! Points of integration that elements of elastic continua share.

use super::dot;
use crate::numeric::axpy;

/// Strains at a point, or stresses, from the displacements of an element. `rows` are the derivatives of the strains by the
/// displacements, in the unit 1/length; stresses have the unit of `elasticity`.
pub(super) fn strain_or_stress<R: AsRef<[f64]>, const S: usize>(
    rows: &[R; S],
    elasticity: &[[f64; S]; S],
    stress: bool,
    disp: &[f64],
) -> [f64; S] {
    let strain = rows.each_ref().map(|row| dot(row.as_ref(), disp));
    if stress { elasticity.each_ref().map(|row| dot(row, &strain)) } else { strain }
}

/// Adds the forces of the stresses at a point to `force`. They come from stresses: the round-off of stiffness times
/// displacements would not be in equilibrium.
pub(super) fn add_point_force<R: AsRef<[f64]>, const S: usize>(
    rows: &[R; S],
    elasticity: &[[f64; S]; S],
    volume: f64,
    disp: &[f64],
    force: &mut [f64],
) {
    for (row, stress) in rows.iter().zip(strain_or_stress(rows, elasticity, true, disp)) {
        axpy(volume * stress, row.as_ref(), force);
    }
}
