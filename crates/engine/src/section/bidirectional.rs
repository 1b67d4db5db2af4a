//! Coupled plasticity of two resultants: a circular yield surface with isotropic and kinematic hardening (Simo and Hughes,
//! 1998, section 3.3).

use super::plain_methods::plain_methods;
use super::{Resultant, Section, SectionStep};
use crate::material::MaterialResult;

/// Two resultants that yield together.
#[derive(Clone, Debug, PartialEq)]
pub struct Bidirectional {
    /// Elastic stiffness.
    pub e: f64,
    /// Radius of the yield surface.
    pub yield_force: f64,
    /// Isotropic hardening modulus.
    pub isotropic: f64,
    /// Kinematic hardening modulus.
    pub kinematic: f64,
    /// The resultants.
    pub resultants: [Resultant; 2],
}

crate::state_struct! {
    /// History of [`Bidirectional`].
    struct History {
        /// Plastic deformations.
        plastic: [f64; 2],
        /// Centre of the yield surface.
        back: [f64; 2],
        /// Accumulated plastic deformation.
        accumulated: f64,
    }
}

crate::watches_columns!(Bidirectional => nothing);

impl Section for Bidirectional {
    plain_methods! { init is_linear depends_on_time elastic joined with_parameter probe }
    fn class(&self) -> &'static str {
        "Bidirectional"
    }
    fn resultants(&self) -> &[Resultant] {
        &self.resultants
    }
    fn state_len(&self) -> usize {
        <History as crate::state_struct::StateStruct>::LEN
    }

    fn update(&self, step: SectionStep<'_>) -> MaterialResult {
        let SectionStep { committed, e, next, s, k, .. } = step;
        use crate::state_struct::StateStruct;
        let mut h = History::read(committed);
        let stiffness = self.e;
        let trial = [0, 1].map(|i| stiffness * (e[i] - h.plastic[i]));
        let xi = [0, 1].map(|i| trial[i] - h.back[i]);
        let size = xi[0].hypot(xi[1]);
        let excess = size - (self.yield_force + h.accumulated * self.isotropic);
        s.copy_from_slice(&trial);
        if excess < 0.0 {
            k.copy_from_slice(&[stiffness, 0.0, 0.0, stiffness]);
        } else {
            let modulus = stiffness + self.kinematic + self.isotropic;
            let flow = excess / modulus;
            let n = xi.map(|x| x / size);
            let (a, b) = (stiffness * (stiffness / modulus), stiffness * (stiffness * flow / size));
            let along = |i: usize, j: usize| (b - a) * n[i] * n[j];
            k.copy_from_slice(&[stiffness - b + along(0, 0), along(0, 1), along(1, 0), stiffness - b + along(1, 1)]);
            for i in 0..2 {
                s[i] -= stiffness * n[i] * flow;
                h.plastic[i] += n[i] * flow;
                h.back[i] += self.kinematic * n[i] * flow;
            }
            h.accumulated += flow;
        }
        h.write(next);
        Ok(())
    }

    fn initial_stiffness(&self, k: &mut [f64]) {
        k.copy_from_slice(&[self.e, 0.0, 0.0, self.e]);
    }
}
