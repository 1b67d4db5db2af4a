//! Which part of a force a factor concerns.

use super::{AmendedForce, DeformationState, Pair};

/// Parts of a force: an elastic part, `stiffness` times the deformation, and the rest, the hysteretic part. A factor
/// s acts on each in its measure (0 not at all, 1 fully):
/// q' = (1 - hysteretic (1 - s)) (q - k e) + (1 - elastic (1 - s)) k e.
///
/// Lead and filler lose strength while the network of the rubber keeps its stiffness, so one factor for all is often
/// too coarse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// Stiffness k of the elastic part, force per deformation.
    pub stiffness: f64,
    /// Measure in which the factor acts on the elastic part.
    pub elastic: f64,
    /// Measure in which it acts on the hysteretic part.
    pub hysteretic: f64,
    /// The factor is one of the strength: the hysteretic part keeps its elastic stiffness, as [`Weakening`] says.
    pub of_strength: bool,
}

/// A hysteretic part z that has a part s of its strength and all of its elastic stiffness: its deformations shrink with its force,
/// s z(∫ de/s). That is exact for an elastic-plastic part or one of Bouc and Wen whose strength changes between steps, and needs to
/// know nothing of them; s is that of the committed state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weakening {
    /// Part s that is left of the strength.
    pub left: f64,
    /// Stiffness k of the elastic part, force per deformation.
    pub stiffness: f64,
}

impl Weakening {
    /// Part of an increment of deformation that the element gets less of than there is.
    pub(super) fn withheld(&self) -> f64 {
        1.0 - 1.0 / self.left
    }
}

/// No strength falls below this part: its deformations would have no end.
const LEAST: f64 = 0.02;

impl Default for Share {
    fn default() -> Self {
        Self { stiffness: 0.0, elastic: 1.0, hysteretic: 1.0, of_strength: false }
    }
}

impl Share {
    /// A factor on the strength of what stands beside an elastic part.
    pub fn strength_beside(stiffness: f64) -> Self {
        Self { stiffness, elastic: 0.0, hysteretic: 1.0, of_strength: true }
    }

    /// How the element is asked where the factor is one of its strength and is `left` in the committed state.
    pub fn weakening(&self, left: f64) -> Option<Weakening> {
        self.of_strength.then(|| Weakening { left: left.max(LEAST), stiffness: self.stiffness })
    }

    /// The force under a factor `s` with the derivative `ds` by the deformation and `ds_axial` by the axial force.
    pub fn scale(&self, d: &DeformationState, s: f64, ds: Pair, ds_axial: f64) -> AmendedForce {
        let k = self.stiffness * (self.hysteretic - self.elastic) * (1.0 - s);
        let scale = 1.0 - self.hysteretic * (1.0 - s);
        let concerned = self.concerned(d);
        let mut v = AmendedForce::default();
        for (i, concerned) in concerned.into_iter().enumerate() {
            v.q[i] = scale * d.q[i] + k * d.e[i];
            v.by_force[i][i] = scale;
            v.by_deformation[i] = ds.map(|ds| concerned * ds);
            v.by_deformation[i][i] += k;
            v.by_axial[i] = concerned * ds_axial;
        }
        v
    }

    /// d q'/d s: what the factor acts on.
    fn concerned(&self, d: &DeformationState) -> Pair {
        let k = (self.hysteretic - self.elastic) * self.stiffness;
        std::array::from_fn(|i| self.hysteretic * d.q[i] - k * d.e[i])
    }

    /// Work of the hysteretic part over the step, by the trial force: what heats and damages.
    pub fn work(&self, d: &DeformationState) -> f64 {
        let de = d.increment();
        (0..2).map(|i| (d.q[i] - self.stiffness * d.e[i]) * de[i]).sum()
    }

    /// d(work)/de at constant force.
    pub fn work_by_deformation(&self, d: &DeformationState) -> Pair {
        let de = d.increment();
        std::array::from_fn(|i| d.q[i] - self.stiffness * (d.e[i] + de[i]))
    }

    /// The force under a factor that depends on the work of the step: s = s(w), with s'(w) = `ds_work`.
    pub fn scale_by_work(&self, d: &DeformationState, s: f64, ds_work: f64) -> AmendedForce {
        let by_e = self.work_by_deformation(d).map(|w| ds_work * w);
        let mut v = self.scale(d, s, by_e, 0.0);
        let (de, concerned) = (d.increment(), self.concerned(d));
        for (row, concerned) in v.by_force.iter_mut().zip(concerned) {
            for (by, de) in row.iter_mut().zip(de) {
                *by += concerned * ds_work * de;
            }
        }
        v
    }
}
