//! Elastic and hysteretic parts of a force.

use super::{AmendedForce, DeformationState, Pair};

/// Split of a force into an elastic part k e and the rest, the hysteretic part. A factor s acts on each part with a
/// weight between 0 and 1: q' = (1 - hysteretic (1 - s)) (q - k e) + (1 - elastic (1 - s)) k e.
///
/// In rubber, lead and filler lose strength while the polymer network keeps its stiffness. One factor for the whole
/// force is often too coarse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// Stiffness k of the elastic part, force per deformation.
    pub stiffness: f64,
    /// Weight of the factor on the elastic part, 0 to 1.
    pub elastic: f64,
    /// Weight of the factor on the hysteretic part, 0 to 1.
    pub hysteretic: f64,
    /// The factor is one of strength: the hysteretic part keeps its initial stiffness, see [`Weakening`].
    pub of_strength: bool,
}

/// A hysteretic part z with a factor s on its strength and unchanged initial stiffness: s z(∫ de/s), with s at the
/// committed state. Deformation and force scale alike. The transformation is exact for elastic-plastic and Bouc-Wen
/// laws with a strength that is constant. Where it changes, the elastic deformation z/k stays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weakening {
    /// Factor s of the strength.
    pub strength: f64,
    /// Stiffness k of the elastic part, force per deformation.
    pub stiffness: f64,
}

impl Weakening {
    /// Part of an increment of deformation that is withheld from the element.
    pub(super) fn withheld_part(&self) -> f64 {
        1.0 - 1.0 / self.strength
    }
}

/// Lower bound of a factor of strength. The deformation of the element, ∫ de/s, stays finite.
const MIN_STRENGTH: f64 = 0.02;

impl Default for Share {
    fn default() -> Self {
        Self { stiffness: 0.0, elastic: 1.0, hysteretic: 1.0, of_strength: false }
    }
}

impl Share {
    /// A factor of strength on the hysteretic part beside an elastic part of the given stiffness.
    pub fn strength_beside(stiffness: f64) -> Self {
        Self { stiffness, elastic: 0.0, hysteretic: 1.0, of_strength: true }
    }

    /// Loss of strength for the factor `strength` at the committed state; `None` if the factor is not one of strength.
    pub fn weakening(&self, strength: f64) -> Option<Weakening> {
        self.of_strength.then(|| Weakening { strength: strength.max(MIN_STRENGTH), stiffness: self.stiffness })
    }

    /// The force under a factor `s`, with the derivatives `ds` by the deformation and `ds_axial` by the axial force.
    pub fn scale(&self, d: &DeformationState, s: f64, ds: Pair, ds_axial: f64) -> AmendedForce {
        let k = self.stiffness * (self.hysteretic - self.elastic) * (1.0 - s);
        let scale = 1.0 - self.hysteretic * (1.0 - s);
        let by_factor = self.by_factor(d);
        let mut v = AmendedForce::default();
        for (i, by_factor) in by_factor.into_iter().enumerate() {
            v.q[i] = scale * d.q[i] + k * d.e[i];
            v.by_force[i][i] = scale;
            v.by_deformation[i] = ds.map(|ds| by_factor * ds);
            v.by_deformation[i][i] += k;
            v.by_axial[i] = by_factor * ds_axial;
        }
        v
    }

    /// ∂q'/∂s.
    fn by_factor(&self, d: &DeformationState) -> Pair {
        let k = (self.hysteretic - self.elastic) * self.stiffness;
        std::array::from_fn(|i| self.hysteretic * d.q[i] - k * d.e[i])
    }

    /// Work of the hysteretic part over the step, with the trial force.
    pub fn work(&self, d: &DeformationState) -> f64 {
        let de = d.increment();
        (0..2).map(|i| (d.q[i] - self.stiffness * d.e[i]) * de[i]).sum()
    }

    /// ∂(work)/∂e at constant force.
    pub fn work_by_deformation(&self, d: &DeformationState) -> Pair {
        let de = d.increment();
        std::array::from_fn(|i| d.q[i] - self.stiffness * (d.e[i] + de[i]))
    }

    /// The force under a factor s(w, e) of the work w of the step, with `ds_work` = ∂s/∂w and `ds` = ∂s/∂e.
    pub fn scale_by_work(&self, d: &DeformationState, s: f64, ds_work: f64, ds: Pair) -> AmendedForce {
        let by_work = self.work_by_deformation(d);
        let by_e = std::array::from_fn(|i| ds_work * by_work[i] + ds[i]);
        let mut v = self.scale(d, s, by_e, 0.0);
        let (de, by_factor) = (d.increment(), self.by_factor(d));
        for (row, by_factor) in v.by_force.iter_mut().zip(by_factor) {
            for (by, de) in row.iter_mut().zip(de) {
                *by += by_factor * ds_work * de;
            }
        }
        v
    }
}
