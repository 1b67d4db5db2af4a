//! The step of the hysteretic parameters, of one bearing or of several side by side.

// Loops over vectors: the compiler makes vector instructions of them, which it does not of some iterators.
#![allow(clippy::needless_range_loop)]

use crate::numeric::real::Real;

/// A yielding exponent η, with the root t next to 1 of t + a t^η = 1.
pub(super) trait Exponent<T>: Copy {
    /// η
    fn eta(self) -> f64;
    /// |w|^(η-2) from |w|², which is not zero.
    fn power(self, norm2: T) -> T;
    /// The root; no number where there is none.
    fn root(self, a: T) -> T;
    /// t^(η-1)
    fn slope(self, t: T) -> T;
}

/// η = 1.
#[derive(Clone, Copy)]
pub(super) struct One;

impl<T: Real> Exponent<T> for One {
    #[inline(always)]
    fn eta(self) -> f64 {
        1.0
    }
    #[inline(always)]
    fn power(self, norm2: T) -> T {
        T::ONE / norm2.sqrt()
    }
    #[inline(always)]
    fn root(self, a: T) -> T {
        let root = T::ONE / (T::ONE + a);
        root.where_greater(T::ZERO, root, T::of(f64::NAN))
    }
    #[inline(always)]
    fn slope(self, _: T) -> T {
        T::ONE
    }
}

/// η = 2.
#[derive(Clone, Copy)]
pub(super) struct Two;

impl<T: Real> Exponent<T> for Two {
    #[inline(always)]
    fn eta(self) -> f64 {
        2.0
    }
    #[inline(always)]
    fn power(self, _: T) -> T {
        T::ONE
    }
    #[inline(always)]
    fn root(self, a: T) -> T {
        let root = T::ONE + a * 4.0;
        T::ZERO.where_greater(root, T::of(f64::NAN), T::of(2.0) / (T::ONE + root.sqrt()))
    }
    #[inline(always)]
    fn slope(self, t: T) -> T {
        t
    }
}

/// Any η.
#[derive(Clone, Copy)]
pub(super) struct Any(pub f64);

impl Exponent<f64> for Any {
    fn eta(self) -> f64 {
        self.0
    }
    fn power(self, norm2: f64) -> f64 {
        norm2.powf(0.5 * self.0 - 1.0)
    }
    /// Newton's method from 1 converges from one side for η > 1, where the function is convex for a > 0 and concave for
    /// a < 0. For η < 1 the steps keep t positive.
    fn root(self, a: f64) -> f64 {
        let mut t = 1.0f64;
        for _ in 0..200 {
            let slope = a * self.slope(t);
            let step = (t + slope * t - 1.0) / (1.0 + self.0 * slope);
            let next = if t - step > 0.0 { t - step } else { 0.5 * t };
            if !next.is_finite() || next > 1e6 {
                return f64::NAN;
            }
            if (next - t).abs() <= 2e-16 * t {
                return next;
            }
            t = next;
        }
        if (t + a * t.powf(self.0) - 1.0).abs() < 1e-13 * t.max(1.0) { t } else { f64::NAN }
    }
    fn slope(self, t: f64) -> f64 {
        t.powf(self.0 - 1.0)
    }
}

/// |w|², or a little more than 0 where it is zero: z vanishes there.
#[inline(always)]
pub(super) fn not_zero<T: Real>(norm2: T) -> T {
    norm2.larger(T::of(f64::MIN_POSITIVE))
}

/// γ + β sign(work)
#[inline(always)]
pub(super) fn shape<T: Real>([beta, gamma]: [T; 2], work: T) -> T {
    let sign = work.where_greater(T::ZERO, T::ONE, T::ZERO.where_greater(work, T::of(-1.0), T::ZERO));
    gamma + beta * sign
}

/// Hysteretic parameters z at the end of a step (backward Euler), and ∂z/∂d by rows; no numbers where the step is too large.
/// `d` is the increment of displacement over the yield displacement q_d/k₀, in `S` directions; `loop_shape` is β and γ.
///
/// The equation is z = z_c + d - z |z|^(η-2) (z·d) (γ + β sign(z·d)), so z is parallel to w = z_c + d. With z = t w
/// it is scalar: t + a t^η = 1, with a = |w|^(η-2) (w·d) (γ + β sign(w·d)). The solution is the root next to t = 1,
/// which is continuous with the committed state.
#[inline(always)]
pub(super) fn hysteresis<T: Real, E: Exponent<T>, const S: usize>(
    exponent: E,
    loop_shape: [T; 2],
    zc: [T; S],
    d: [T; S],
) -> ([T; S], [[T; S]; S]) {
    let mut w = [T::ZERO; S];
    let (mut work, mut norm2) = (T::ZERO, T::ZERO);
    for i in 0..S {
        w[i] = zc[i] + d[i];
        work += w[i] * d[i];
        norm2 += w[i] * w[i];
    }
    let eta = exponent.eta();
    let shape = shape(loop_shape, work);
    let power = exponent.power(not_zero(norm2));
    let a = power * work * shape;
    let t = exponent.root(a);
    let slope = exponent.slope(t);
    // ∂t/∂d = -t^η / (1 + η a t^(η-1)) ∂a/∂d
    let factor = -t * slope / (T::ONE + a * eta * slope) * power * shape;
    let radial = norm2.where_greater(T::ZERO, work * (eta - 2.0) / norm2, T::ZERO);
    let (mut z, mut dz) = (w, [[T::ZERO; S]; S]);
    for i in 0..S {
        z[i] = t * w[i];
        for j in 0..S {
            let dt = factor * (radial * w[j] + d[j] + w[j]);
            dz[i][j] = w[i] * dt + if i == j { t } else { T::ZERO };
        }
    }
    (z, dz)
}
