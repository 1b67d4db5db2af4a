//! Steel of Giuffrè, Menegotto and Pinto with isotropic hardening.

use crate::material::lanes::{BlockLaw, LaneInput, PointResponse, Response, no_stress, updates_blocks, words_of};
use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};
use crate::numeric::elementary::{exp, ln, power};
use crate::numeric::lanes::{Lanes, any, flag, in_lanes, select};
use crate::numeric::sign;
use crate::state_struct::StateStruct;

/// Curved transitions between the elastic and the hardening asymptote (Menegotto and Pinto, 1973). Isotropic
/// hardening shifts the hardening asymptote (Filippou, Popov and Bertero, 1983).
#[derive(Clone, Debug, PartialEq)]
pub struct Steel02 {
    /// Yield strength.
    pub fy: f64,
    /// Initial modulus.
    pub e0: f64,
    /// Hardening ratio. The steel is elastic at 1.
    pub b: f64,
    /// Sharpness of the transition R₀.
    pub r0: f64,
    /// Loss of sharpness with the plastic strain: cR₁ and cR₂.
    pub c_r: [f64; 2],
    /// Isotropic hardening: a1, a2 in compression, a3, a4 in tension; a1 = a3 = 0 for none.
    pub a: [f64; 4],
    /// Stress at zero strain.
    pub sig_init: f64,
}

impl Steel02 {
    /// OpenSees' defaults of R₀, cR₁ and cR₂.
    pub const TRANSITION: [f64; 3] = [15.0, 0.925, 0.15];
    /// OpenSees' defaults of a1 to a4: no isotropic hardening.
    pub const NO_ISOTROPIC: [f64; 4] = [0.0, 1.0, 0.0, 1.0];
}

crate::state_struct! {
    /// History of [`Steel02`].
    pub struct History {
        /// 1 loading, -1 unloading, 0 virgin.
        loading: f64,
        /// Strain.
        strain: f64,
        /// Stress minus the initial stress.
        stress: f64,
        /// Largest strain at a reversal.
        max: f64,
        /// Smallest strain at a reversal.
        min: f64,
        /// Reference strain of the branch's curvature.
        plastic: f64,
        /// Strain at the intersection of the asymptotes.
        strain_0: f64,
        /// Stress at the intersection of the asymptotes.
        stress_0: f64,
        /// Strain at the last reversal.
        strain_r: f64,
        /// Stress at the last reversal.
        stress_r: f64,
    }
}

impl Steel02 {
    /// Begins a branch towards tension (`s` = 1) or compression (`s` = -1) at the committed point.
    fn reverse(&self, c: &History, eps: f64, t: &mut History, s: f64) {
        let eps_y = self.fy / self.e0;
        let esh = self.b * self.e0;
        (t.strain_r, t.stress_r) = (eps, c.stress + self.sig_init);
        if s > 0.0 {
            t.min = t.min.min(eps)
        } else {
            t.max = t.max.max(eps)
        }
        let [growth, scale] = if s > 0.0 { [self.a[2], self.a[3]] } else { [self.a[0], self.a[1]] };
        let shift = match growth {
            0.0 => 1.0,
            _ => 1.0 + growth * ((t.max - t.min) / (2.0 * scale * eps_y)).powf(0.8),
        };
        let intercept = s * (self.fy * shift - esh * eps_y * shift);
        if self.b == 1.0 {
            // One asymptote: any point on it will do.
            (t.strain_0, t.stress_0) = (t.strain_r + s * eps_y, t.stress_r + s * self.fy);
        } else {
            t.strain_0 = (intercept - t.stress_r + self.e0 * t.strain_r) / (self.e0 - esh);
            t.stress_0 = s * self.fy * shift + esh * (t.strain_0 - s * eps_y * shift);
        }
        t.plastic = if s > 0.0 { t.max } else { t.min };
        t.loading = s;
    }
}

impl Steel02 {
    /// History on the branch of a strain, with the committed stress. `None` for a virgin point at rest.
    #[inline]
    fn branch(&self, c: &History, strain: f64) -> Option<History> {
        let eps_y = self.fy / self.e0;
        let initial = self.sig_init / self.e0;
        let (eps, before) = (strain + initial, c.strain + initial);
        let d = eps - before;
        let mut t = *c;
        t.strain = strain;
        if c.loading == 0.0 {
            if d.abs() < 10.0 * f64::EPSILON {
                return None;
            }
            let s = sign(d);
            t = History { loading: s, strain, max: eps_y, min: -eps_y, ..*c };
            (t.strain_0, t.stress_0, t.plastic) = (s * eps_y, s * self.fy, s * eps_y);
        } else if c.loading * d < 0.0 {
            self.reverse(c, before, &mut t, sign(d));
        }
        Some(t)
    }
}

/// Branch of a point and its strain: all that the stress depends on.
#[derive(Clone, Copy)]
struct Curve {
    /// Strain with that of the initial stress.
    strain: f64,
    /// As in [`History`].
    plastic: f64,
    strain_0: f64,
    stress_0: f64,
    strain_r: f64,
    stress_r: f64,
}

impl Curve {
    /// Stress and tangent.
    #[inline(always)]
    fn response(&self, law: &Steel02) -> (f64, f64) {
        let xi = ((self.plastic - self.strain_0) / (law.fy / law.e0)).abs();
        let sharpness = law.r0 * (1.0 - law.c_r[0] * xi / (law.c_r[1] + xi));
        let (length, rise) = (self.strain_0 - self.strain_r, self.stress_0 - self.stress_r);
        let ratio = (self.strain - self.strain_r) / length;
        let sum = 1.0 + power(ratio.abs(), sharpness);
        let curved = (1.0 - law.b) * exp(-ln(sum) / sharpness);
        (self.stress_r + rise * ratio * (law.b + curved), rise / length * (law.b + curved / sum))
    }
}

/// Columns of a block: strain, stress and the others that the loop reads, as in [`History`].
const LOADING: usize = 0;
const STRAIN: usize = 1;
const STRESS: usize = 2;

impl Steel02 {
    /// Stress and tangent on a branch, or those of a virgin point at rest.
    #[inline(always)]
    fn on_branch(
        &self,
        [loading, .., plastic, strain_0, stress_0, strain_r, stress_r]: [f64; History::LEN],
        strain: f64,
    ) -> (f64, f64) {
        let curve = Curve { strain: strain + self.sig_init / self.e0, plastic, strain_0, stress_0, strain_r, stress_r };
        let (value, tangent) = curve.response(self);
        (select(loading == 0.0, self.sig_init, value), select(loading == 0.0, self.e0, tangent))
    }
}

/// A single point on its branch, evaluated by the instructions of the processor.
struct BranchPoint<'a> {
    law: &'a Steel02,
    words: [f64; History::LEN],
    strain: f64,
    /// Stress and tangent.
    stress: (f64, f64),
}

impl Lanes for BranchPoint<'_> {
    #[inline(always)]
    fn evaluate(&mut self) {
        self.stress = self.law.on_branch(self.words, self.strain);
    }
}

impl BlockLaw<{ History::LEN }> for Steel02 {
    #[inline(always)]
    fn respond<const W: usize>(
        &self,
        given: &LaneInput<'_, { History::LEN }, W>,
        out: &mut Response<{ History::LEN }, W>,
    ) {
        let law = self.clone();
        let initial = law.sig_init / law.e0;
        let mut turns = [0; W];
        for (i, turns) in turns.iter_mut().enumerate() {
            let (loading, before) = (given.words[LOADING][i], given.words[STRAIN][i]);
            let d = (given.strain[i] + initial) - (before + initial);
            *turns = flag((loading == 0.0) | (loading * d < 0.0));
        }
        let mut turned: [[f64; W]; History::LEN];
        let mut from = *given;
        if any(&turns) {
            // Few points turn in a step: they take their new branches one by one.
            turned = given.words.map(|column| *column);
            for i in (0..W).filter(|i| turns[*i] != 0) {
                let c = History::read(&given.point(i));
                let words: [f64; History::LEN] = words_of(&law.branch(&c, given.strain[i]).unwrap_or(c));
                turned.iter_mut().zip(words).for_each(|(column, word)| column[i] = word);
            }
            from.words.iter_mut().zip(&turned).for_each(|(column, own)| *column = own);
        }
        for i in 0..W {
            let (mut words, strain) = (from.point(i), given.strain[i]);
            let (value, tangent) = law.on_branch(words, strain);
            let at_rest = words[LOADING] == 0.0;
            words[STRAIN] = select(at_rest, words[STRAIN], strain);
            words[STRESS] = select(at_rest, words[STRESS], value - law.sig_init);
            out.set(i, PointResponse { words, value, tangent });
        }
    }
}

impl UniaxialLaw for Steel02 {
    type State = History;
    const NAME: &'static str = "Steel02";
    const BY_QUANTITY: bool = true;

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let Some(mut t) = self.branch(c, strain.value) else {
            return Ok((Stress { value: self.sig_init, tangent: self.e0, damping: 0.0 }, *c));
        };
        let mut point = BranchPoint { law: self, words: words_of(&t), strain: strain.value, stress: (0.0, 0.0) };
        in_lanes(&mut point);
        let (value, tangent) = point.stress;
        t.stress = value - self.sig_init;
        if !(value.is_finite() && tangent.is_finite()) {
            return Err(no_stress::<Self>(strain.value));
        }
        Ok((Stress { value, tangent, damping: 0.0 }, t))
    }

    updates_blocks!();

    fn initial_tangent(&self) -> f64 {
        self.e0
    }

    fn shown_strain(&self, strain: f64) -> f64 {
        strain + self.sig_init / self.e0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::roles::PointLayout;
    use crate::material::{Strains, Stresses, Uniaxial};

    #[test]
    fn many_points_have_the_bits_of_single_ones() {
        let law = Steel02 {
            fy: 420.0,
            e0: 2e5,
            b: 0.01,
            r0: 18.0,
            c_r: [0.925, 0.15],
            a: [0.02, 5.0, 0.03, 4.0],
            sig_init: 30.0,
        };
        const POINTS: usize = 37;
        const LEN: usize = History::LEN;
        let mut single = vec![0.0; POINTS * LEN];
        let mut many = single.clone();
        law.init_all(POINTS, &mut many);
        for step in 0..200 {
            let strains: Vec<f64> = (0..POINTS)
                .map(|i| if i == 5 { 0.0 } else { 0.012 * (0.11 * step as f64).sin() * (0.2 + i as f64 / 20.0) })
                .collect();
            let (mut value, mut tangent, mut damping) = (vec![0.0; POINTS], vec![0.0; POINTS], vec![1.0; POINTS]);
            let mut next = many.clone();
            let mut stresses = Stresses { value: &mut value, tangent: &mut tangent, damping: &mut damping };
            let trial = Strains { value: &strains, rate: &strains, dt: 0.0 };
            law.update_all(&many, &trial, &mut next, &mut stresses).expect("a finite stress");
            many = next;
            for i in 0..POINTS {
                let words = i * LEN..(i + 1) * LEN;
                let committed = single[words.clone()].to_vec();
                let strain = Strain { value: strains[i], rate: 0.0, dt: 0.0 };
                let s = Uniaxial::update(&law, &committed, strain, &mut single[words]).expect("a finite stress");
                assert_eq!((s.value, s.tangent, 0.0), (value[i], tangent[i], damping[i]), "step {step}, point {i}");
                let mut one = [0.0; LEN];
                law.copy_history((&many, i, POINTS), (&mut one, 0, 1));
                assert_eq!(one, single[i * LEN..(i + 1) * LEN]);
            }
        }
    }
}
