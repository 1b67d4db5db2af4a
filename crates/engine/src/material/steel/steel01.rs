//! Bilinear steel with kinematic and optional isotropic hardening.

use crate::material::lanes::{BlockLaw, LaneInput, PointResponse, Response, updates_blocks, words_of};
use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};
use crate::numeric::lanes::select;
use crate::state_struct::StateStruct;

/// Uniaxial bilinear steel with kinematic hardening. Isotropic hardening shifts the yield envelopes with the strain
/// range: a1, a2 in compression, a3, a4 in tension (after Filippou, Popov and Bertero, 1983).
#[derive(Clone, Debug, PartialEq)]
pub struct Steel01 {
    /// Yield strength.
    pub fy: f64,
    /// Initial modulus.
    pub e0: f64,
    /// Hardening ratio.
    pub b: f64,
    /// Isotropic hardening a1 to a4; a1 = a3 = 0 for none.
    pub a: [f64; 4],
}

impl Steel01 {
    /// OpenSees' defaults of a1 to a4: no isotropic hardening.
    pub const NO_ISOTROPIC: [f64; 4] = [0.0, 55.0, 0.0, 55.0];
}

crate::state_struct! {
    /// History of [`Steel01`].
    pub struct History {
        /// Smallest strain at a reversal.
        min: f64,
        /// Largest strain at a reversal.
        max: f64,
        /// Shift of the tension envelope minus one, so that the virgin state is zero.
        shift_p: f64,
        /// Shift of the compression envelope minus one.
        shift_n: f64,
        /// 1 loading, -1 unloading, 0 virgin.
        loading: f64,
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Tangent; zero stands for the initial one.
        tangent: f64,
    }
}

impl BlockLaw<{ History::LEN }> for Steel01 {
    #[inline(always)]
    fn respond<const W: usize>(
        &self,
        given: &LaneInput<'_, { History::LEN }, W>,
        out: &mut Response<{ History::LEN }, W>,
    ) {
        let law = self.clone();
        let mut turned = [0.0; W];
        for (i, turned) in turned.iter_mut().enumerate() {
            let point;
            (point, *turned) = law.response(given.point(i), given.strain[i]);
            out.set(i, point);
        }
        if law.is_isotropic() {
            for (i, turns) in turned.into_iter().enumerate().filter(|(_, turns)| *turns != 0.0) {
                let mut next = History::read(&out.point(i));
                law.shift(turns, &mut next);
                out.set_point(i, words_of(&next));
            }
        }
    }
}

impl UniaxialLaw for Steel01 {
    type State = History;
    const NAME: &'static str = "Steel01";
    const BY_QUANTITY: bool = true;

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let (point, turns) = self.response(words_of(c), strain.value);
        let (stress, mut next) = point.read();
        if self.is_isotropic() && turns != 0.0 {
            self.shift(turns, &mut next);
        }
        Ok((stress, next))
    }

    updates_blocks!();

    fn initial_tangent(&self) -> f64 {
        self.e0
    }
}

impl Steel01 {
    /// Returns true if turns shift the envelopes. Without a yield strain above 0 the shift is not a number, as in OpenSees, so
    /// that there is no envelope after a turn.
    fn is_isotropic(&self) -> bool {
        self.a[0] != 0.0 || self.a[2] != 0.0 || self.fy / self.e0 <= 0.0
    }

    /// Response without a branch, and 1 for a turn towards tension, -1 for one towards compression. The shifts of a turn are
    /// not in the state.
    #[inline(always)]
    fn response(&self, c: [f64; History::LEN], eps: f64) -> (PointResponse<{ History::LEN }>, f64) {
        let [min, max, shift_p, shift_n, loading, strain, stress, tangent] = c;
        let d = eps - strain;
        let moved = d.abs() > f64::EPSILON;
        let fy_1b = self.fy * (1.0 - self.b);
        let esh = self.b * self.e0;
        let elastic = stress + self.e0 * d;
        let hardening = esh * eps;
        let upper = hardening + (1.0 + shift_p) * fy_1b;
        let lower = hardening - (1.0 + shift_n) * fy_1b;
        let capped = select(elastic > upper, upper, elastic);
        let new_stress = select(capped < lower, lower, capped);
        let new_tangent = select((new_stress - elastic).abs() < f64::EPSILON, self.e0, esh);
        let begun = select(loading == 0.0, select(d < 0.0, -1.0, 1.0), loading);
        let (falls, rises) = (moved & (begun == 1.0) & (d < 0.0), moved & (begun == -1.0) & (d > 0.0));
        let new_loading = select(falls, -1.0, select(rises, 1.0, begun));
        let keep = |old, new| select(moved, new, old);
        let words = [
            select(rises & (strain < min), strain, min),
            select(falls & (strain > max), strain, max),
            shift_p,
            shift_n,
            keep(loading, new_loading),
            keep(strain, eps),
            keep(stress, new_stress),
            keep(tangent, new_tangent),
        ];
        let virgin = (words[7] == 0.0) & (loading == 0.0) & (words[4] == 0.0);
        let point = PointResponse { words, value: words[6], tangent: select(virgin, self.e0, words[7]) };
        (point, select(falls, -1.0, select(rises, 1.0, 0.0)))
    }

    /// Shift of the envelope after a turn.
    fn shift(&self, turns: f64, t: &mut History) {
        let [a1, a2, a3, a4] = self.a;
        let eps_y = self.fy / self.e0;
        if turns < 0.0 {
            t.shift_n = a1 * ((t.max - t.min) / (2.0 * a2 * eps_y)).powf(0.8);
        } else {
            t.shift_p = a3 * ((t.max - t.min) / (2.0 * a4 * eps_y)).powf(0.8);
        }
    }
}
