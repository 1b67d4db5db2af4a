//! `ElastomericX` and `LeadRubberX` by OpenSees' rules.

use super::{LeadCore, RubberBoucWen, Rules, Shear, ShearInput, Trial, Warmth, length, share};
use crate::element::bearing::laws::axial::AxialStep;
use crate::rules::OpenSees;

impl Rules for OpenSees {
    /// Without a time step OpenSees counts from the last time, or from 0 after the domain time was set back.
    fn warm(core: &LeadCore, m: &Warmth, [z, _]: [[f64; 2]; 2], at: &ShearInput<'_>) -> f64 {
        let since = if at.time < m.time { 0.0 } else { m.time };
        let passed = if at.dt > 0.0 { at.dt } else { at.time - since };
        core.warm_as_opensees(m.rise, m.qy * length(z), length(at.rate), at.time, passed)
    }

    fn hysteretic_tangent(z: [f64; 2], d: [f64; 2], _: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
        rate_tangent(z, d)
    }

    /// Like its axial law, OpenSees uses the axial force of the last step.
    fn rubber(kept: f64, _: f64) -> f64 {
        kept
    }

    fn keep(law: &RubberBoucWen<Self>, axial: &AxialStep, _: f64) -> f64 {
        law.rubber * law.left(axial.next.force / axial.next.fcrn).0
    }

    /// OpenSees keeps force and tangent for a bitwise equal displacement; the stiffness includes the damping.
    fn complete(
        law: &RubberBoucWen<Self>,
        moved: bool,
        c: &Shear<2>,
        at: &ShearInput<'_>,
        _: (f64, f64),
        t: &mut Trial,
    ) {
        t.damping = 0.0;
        if !moved {
            (t.q, t.k) = (c.q, c.k);
        } else if law.cd > 0.0 && at.dt > 0.0 {
            (0..2).for_each(|i| t.k[i][i] += law.cd / at.dt);
        }
    }
}

/// ∂z/∂d along the increment, with a constant ratio of its components.
fn rate_tangent(z: [f64; 2], d: [f64; 2]) -> [[f64; 2]; 2] {
    let slope = [share(z[0] * d[0]).1, share(z[1] * d[1]).1];
    let (r12, r21) = if d[0] * d[1] == 0.0 { (0.0, 0.0) } else { (d[0] / d[1], d[1] / d[0]) };
    let first = z[0] * slope[0] + z[1] * slope[1] * r21;
    let second = z[0] * slope[0] * r12 + z[1] * slope[1];
    [[1.0 - z[0] * first, r12 - z[0] * second], [r21 - z[1] * first, 1.0 - z[1] * second]]
}
