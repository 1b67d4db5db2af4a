//! The acceleration at which an explicit method starts.

use crate::analysis::failure::Failure;
use crate::analysis::system::{Coefficients, System};
use crate::analysis::workspace::TangentMix;
use crate::solve::Use;

/// Accelerations of all degrees of freedom that keep the committed state in balance, M a = P - R - C v; where degrees of freedom
/// are held they are those that they have.
///
/// # Errors
/// The mass matrix has no inverse, or an element finds no force.
pub(super) fn balanced_acceleration(s: &mut System<'_>, accel: &mut [f64]) -> Result<(), Failure> {
    s.coefficients = Coefficients { k: 0.0, c: 0.0, m: 1.0 };
    s.apply_loads(s.old.time)?;
    let (new, held) = (&mut *s.new, &s.work.plan.map.held);
    (0..held.len()).filter(|&i| !held[i]).for_each(|i| new.accel[i] = 0.0);
    s.form_unbalance(false)?;
    s.form_tangent(TangentMix { current: 0.0, initial: 0.0 }, Use::Once)?;
    s.solve()?;
    let x = std::mem::take(&mut s.work.x);
    s.spread(&x);
    s.work.x = x;
    accel.copy_from_slice(&s.old.accel);
    let held = &s.work.plan.map.held;
    (0..held.len()).filter(|&i| !held[i]).for_each(|i| accel[i] = s.work.spread[i]);
    s.work.spread.fill(0.0);
    Ok(())
}
