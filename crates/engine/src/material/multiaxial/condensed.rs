//! Laws of which some strains are zero, and some follow from stresses that are zero.

use super::plain_methods::inner_methods;
use super::{
    BEAM_FIBRE, Elastic, LAYER, Multiaxial, PLANE, PLANE_BEAM_FIBRE, SOLID, STRIP, SharedMultiaxial, THICK_PLANE,
    Tangent,
};
use crate::material::{MaterialError, MaterialResult, MultiaxialResult};
use crate::numeric::{axpy, invert};
use crate::probe::Probe;
use std::sync::Arc;

/// Largest number of Newton's iterations.
const MAX_ITERATIONS: usize = 200;
/// First change of the strain where the law has no slope.
const FIRST_STEP: f64 = 1e-6;
/// Residual stress over the largest stress.
const TOLERANCE: f64 = 1e-12;
/// A residual that no longer falls is round-off below this share of the largest stress.
const ROUND_OFF: f64 = 1e-7;

/// Largest number of strains without stress.
const MAX_FREE: usize = 4;

/// A law of M stresses whose strains are of three kinds: given ones, ones at which the stress is zero, and zero.
///
/// The state begins with the strains of the second kind.
#[derive(Clone, Debug)]
pub struct Condensed<const M: usize, const N: usize> {
    law: SharedMultiaxial<M>,
    /// Components of the given strains.
    given: [usize; N],
    /// Components without stress.
    free: Vec<usize>,
}

/// Search for the strain at which one stress is zero: Newton's method, and halves of the interval between a negative and a
/// positive stress where it does not help.
struct Root {
    /// Strains with a negative and with a positive stress.
    bracket: [f64; 2],
    /// Last stress, and last step.
    last: [f64; 2],
}

impl Default for Root {
    fn default() -> Self {
        Self { bracket: [f64::NAN; 2], last: [f64::INFINITY, 0.0] }
    }
}

impl Root {
    /// Returns true if the stress jumps over zero: there is no strain left between the two.
    fn is_jump(&self) -> bool {
        let [low, high] = self.bracket;
        (high - low).abs() <= 4.0 * f64::EPSILON * low.abs().max(high.abs())
    }

    fn next(&mut self, strain: f64, stress: f64, slope: f64) -> f64 {
        self.bracket[usize::from(stress > 0.0)] = strain;
        let [low, high] = self.bracket;
        let newton = strain - stress / slope;
        let [before, step] = self.last;
        let next = if low.is_nan() || high.is_nan() {
            // The stress rises with the strain, although its slope may fall for a while.
            let reach = if newton.is_finite() { (newton - strain).abs() } else { FIRST_STEP };
            let helped = stress.abs() < 0.5 * before;
            strain - if helped { reach } else { reach.max(2.0 * step.abs()) } * stress.signum()
        } else if stress.abs() < 0.5 * before && newton > low.min(high) && newton < low.max(high) {
            newton
        } else {
            0.5 * (low + high)
        };
        self.last = [stress.abs(), next - strain];
        next
    }
}

/// Components of a plane: 11, 22, 12.
const IN_PLANE: [usize; PLANE] = [0, 1, 3];
/// Components of a layer: 11, 22, 12, 23, 31.
const IN_LAYER: [usize; LAYER] = [0, 1, 3, 4, 5];

impl<const M: usize, const N: usize> Condensed<M, N> {
    fn shared(law: &SharedMultiaxial<M>, given: [usize; N], free: &[usize]) -> SharedMultiaxial<N> {
        let made = Self { law: Arc::clone(law), given, free: free.to_vec() };
        if law.is_linear() && law.state_len() == 0 {
            return Arc::new(Elastic { stiffness: made.initial_tangent(), rho: law.density() });
        }
        Arc::new(made)
    }

    /// Solves for the strains without stress, from those of the committed state.
    fn solve(&self, committed: &[f64], e: &[f64; N], dt: f64, next: &mut [f64]) -> MultiaxialResult<M> {
        let n = self.free.len();
        let (own, history) = committed.split_at(n);
        let (found, after) = next.split_at_mut(n);
        let mut strain = [0.0; M];
        self.given.iter().zip(e).for_each(|(i, e)| strain[*i] = *e);
        self.free.iter().zip(own).for_each(|(i, e)| strain[*i] = *e);
        let (mut before, mut root) = (f64::INFINITY, Root::default());
        for _ in 0..MAX_ITERATIONS {
            let (stress, tangent) = self.law.update(history, &strain, dt, after)?;
            let largest = stress.iter().fold(0.0f64, |m, s| m.max(s.abs()));
            let residual = self.free.iter().fold(0.0f64, |m, i| m.max(stress[*i].abs()));
            let stagnant = residual >= 0.5 * before;
            // Of a law without stress at a strain, the residual is round-off of the elastic stress.
            let settled =
                stagnant && (residual <= ROUND_OFF * largest || residual <= TOLERANCE * self.elastic(&strain));
            if residual <= TOLERANCE * largest || settled || root.is_jump() {
                found.iter_mut().zip(&self.free).for_each(|(e, i)| *e = strain[*i]);
                return Ok((stress, tangent));
            }
            before = residual;
            if let [i] = self.free[..] {
                strain[i] = root.next(strain[i], stress[i], tangent[i][i]);
                continue;
            }
            let inverse = self.flexibility(&tangent)?;
            for (row, i) in inverse.chunks_exact(n).zip(&self.free) {
                strain[*i] -= row.iter().zip(&self.free).map(|(f, j)| f * stress[*j]).sum::<f64>();
            }
        }
        Err(MaterialError("the strains without stress do not converge".into()))
    }

    /// Largest elastic stress of a strain, in order of magnitude.
    fn elastic(&self, strain: &[f64; M]) -> f64 {
        let largest = |m: f64, x: f64| m.max(x.abs());
        let stiffness = self.law.initial_tangent().as_flattened().iter().copied().fold(0.0, largest);
        stiffness * strain.iter().copied().fold(0.0, largest)
    }

    /// Inverse of the tangent among the strains without stress.
    fn flexibility(&self, tangent: &Tangent<M>) -> MaterialResult<[f64; MAX_FREE * MAX_FREE]> {
        let n = self.free.len();
        let mut k = [0.0; MAX_FREE * MAX_FREE];
        for (row, i) in k.chunks_exact_mut(n.max(1)).zip(&self.free) {
            row.iter_mut().zip(&self.free).for_each(|(k, j)| *k = tangent[*i][*j]);
        }
        if n > 0 && !invert(&mut k[..n * n], n) {
            return Err(MaterialError("the strains without stress have no stiffness".into()));
        }
        Ok(k)
    }

    /// Tangent by the given strains alone.
    fn condense(&self, tangent: &Tangent<M>) -> MaterialResult<Tangent<N>> {
        let n = self.free.len();
        let inverse = self.flexibility(tangent)?;
        let mut out = self.given.map(|i| self.given.map(|j| tangent[i][j]));
        for (row, i) in inverse.chunks_exact(n.max(1)).zip(&self.free) {
            // Change of the free strain for each given one.
            let change = self.given.map(|c| row.iter().zip(&self.free).map(|(f, j)| f * tangent[*j][c]).sum::<f64>());
            for (out, r) in out.iter_mut().zip(self.given) {
                axpy(-tangent[r][*i], &change, out);
            }
        }
        Ok(out)
    }
}

impl Condensed<SOLID, PLANE> {
    /// The law in plane strain.
    pub fn plane_strain(law: &SharedMultiaxial<SOLID>) -> SharedMultiaxial<PLANE> {
        Self::shared(law, IN_PLANE, &[])
    }
    /// The law in plane stress.
    pub fn plane_stress(law: &SharedMultiaxial<SOLID>) -> SharedMultiaxial<PLANE> {
        Self::shared(law, IN_PLANE, &[2, 4, 5])
    }
}

impl Condensed<SOLID, LAYER> {
    /// The law of a layer without stress across it.
    pub fn layer(law: &SharedMultiaxial<SOLID>) -> SharedMultiaxial<LAYER> {
        Self::shared(law, IN_LAYER, &[2])
    }
}

impl Condensed<SOLID, THICK_PLANE> {
    /// The law in plane strain with the strain across the plane as a given one.
    pub fn thick_plane(law: &SharedMultiaxial<SOLID>) -> SharedMultiaxial<THICK_PLANE> {
        Self::shared(law, [0, 1, 2, 3], &[])
    }
}

impl Condensed<SOLID, BEAM_FIBRE> {
    /// The law of a fibre of a beam in space.
    pub fn beam(law: &SharedMultiaxial<SOLID>) -> SharedMultiaxial<BEAM_FIBRE> {
        Self::shared(law, [0, 3, 5], &[1, 2, 4])
    }
}

impl Condensed<SOLID, PLANE_BEAM_FIBRE> {
    /// The law of a fibre of a beam in a plane.
    pub fn plane_beam(law: &SharedMultiaxial<SOLID>) -> SharedMultiaxial<PLANE_BEAM_FIBRE> {
        Self::shared(law, [0, 3], &[1, 2, 4, 5])
    }
}

impl Condensed<PLANE, PLANE_BEAM_FIBRE> {
    /// The law in plane stress without stress across the beam.
    pub fn beam_of_plane(law: &SharedMultiaxial<PLANE>) -> SharedMultiaxial<PLANE_BEAM_FIBRE> {
        Self::shared(law, [0, 2], &[1])
    }
}

impl Condensed<PLANE, STRIP> {
    /// The law in plane stress without horizontal stress.
    pub fn strip(law: &SharedMultiaxial<PLANE>) -> SharedMultiaxial<STRIP> {
        Self::shared(law, [1, 2], &[0])
    }
}

crate::watches_columns!([const M: usize, const N: usize] Condensed<M, N> => |s| at [(s.free.len()..s.free.len() + s.law.state_len(), &s.law)]);

#[deny(clippy::missing_trait_methods)]
impl<const M: usize, const N: usize> Multiaxial<N> for Condensed<M, N> {
    fn state_len(&self) -> usize {
        self.free.len() + self.law.state_len()
    }
    fn init(&self, state: &mut [f64]) {
        let (own, history) = state.split_at_mut(self.free.len());
        own.fill(0.0);
        self.law.init(history);
    }
    inner_methods! { law: is_linear is_symmetric properties }

    fn update(&self, committed: &[f64], e: &[f64; N], dt: f64, next: &mut [f64]) -> MultiaxialResult<N> {
        let (stress, tangent) = self.solve(committed, e, dt, next)?;
        Ok((self.given.map(|i| stress[i]), self.condense(&tangent)?))
    }

    fn initial_tangent(&self) -> Tangent<N> {
        self.condense(&self.law.initial_tangent()).unwrap_or([[0.0; N]; N])
    }

    fn shown_stress(&self, next: &[f64], stress: [f64; N]) -> [f64; N] {
        let mut whole = [0.0; M];
        self.given.iter().zip(stress).for_each(|(i, s)| whole[*i] = s);
        let shown = self.law.shown_stress(&next[self.free.len()..], whole);
        self.given.map(|i| shown[i])
    }
    fn of_length(&self, length: f64) -> Option<SharedMultiaxial<N>> {
        Some(Self::shared(&self.law.of_length(length)?, self.given, &self.free))
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        self.law.probe(words)
    }
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        self.law.read(path, &state[self.free.len()..], out);
    }
}
