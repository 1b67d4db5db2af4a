//! Steel after Menegotto and Pinto (1973) with the curves of Filippou, Popov and Bertero (1983, EERC 83-19), and with bounds
//! by Kolozvari, Orakcal and Wallace (2015, PEER 2015/12): a short reloading does not overshoot the curve that it left.

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// Steel with its own yield strength and hardening on either side: tension, compression.
#[derive(Clone, Debug, PartialEq)]
pub struct SteelMpf {
    /// Yield strengths, positive.
    pub fy: [f64; 2],
    /// Elastic modulus.
    pub e: f64,
    /// Hardening ratios.
    pub b: [f64; 2],
    /// Exponent of the first loading.
    pub r0: f64,
    /// Loss of the exponent over large plastic strains, as a share of `r0`.
    pub cr1: f64,
    /// Plastic strain over yield strain at which half of that is lost.
    pub cr2: f64,
    /// Shift of the asymptote by strains on the other side: share of the yield strength per yield strain, and the first
    /// strain that counts, in yield strains of the other side.
    pub shift: [(f64, f64); 2],
    /// Smallest strain that loads a virgin bar. By OpenSees 3.7.1 it is 0, and the first curve of a bar loaded so is not counted.
    pub least_strain: f64,
}

/// A curve towards a side, with strains and stresses positive there: strain and stress where it begins, those where its
/// asymptotes meet, and its exponent.
type Curve = [f64; 5];

crate::state_struct! {
    /// History of [`SteelMpf`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// 1 towards tension, -1 towards compression, 0 for a virgin bar.
        direction: f64,
        /// Number of curves.
        count: f64,
        /// The curve towards either side.
        curve: [[f64; 5]; 2],
        /// The curves before them.
        before: [[f64; 5]; 2],
        /// 1 where the curve before bounds the present one.
        bounded: [f64; 2],
        /// Largest strain away from the side at which a curve has begun.
        farthest: [f64; 2],
    }
}

/// Sign of a side by its index.
fn sign(side: usize) -> f64 {
    if side == 0 { 1.0 } else { -1.0 }
}

impl SteelMpf {
    /// Usual smallest strain that loads a virgin bar: round-off.
    pub const LEAST_STRAIN: f64 = 1e-14;

    /// Stress and slope on a curve towards a side at a strain that is positive there.
    fn on(&self, side: usize, &[x0, y0, x1, y1, r]: &Curve, x: f64) -> (f64, f64) {
        let (b, part) = (self.b[side], (x - x0) / (x1 - x0));
        let power = part.abs().powf(r);
        let bend = (1.0 - b) / (1.0 + power).powf(1.0 / r);
        (y0 + (y1 - y0) * (b * part + bend * part), (y1 - y0) / (x1 - x0) * (b + bend / (1.0 + power)))
    }

    /// Begins a curve towards a side at the committed state.
    fn turn(&self, side: usize, c: &History, t: &mut History) {
        let (s, other, b) = (sign(side), 1 - side, self.b[side]);
        let (x0, y0) = (s * c.strain, s * c.stress);
        t.before[side] = c.curve[side];
        t.count += 1.0;
        t.farthest[side] = t.farthest[side].max(-x0);
        let (share, first) = self.shift[side];
        let yields = self.fy.map(|fy| fy / self.e);
        let shift = if t.farthest[side] < yields[other] {
            0.0
        } else {
            (self.fy[side] * share * (t.farthest[side] / yields[other] - first)).max(0.0)
        };
        let x1 = ((self.fy[side] + shift) * (1.0 - b) + self.e * x0 - y0) / (self.e * (1.0 - b));
        // Strain from which the plastic strain of the last curve towards the other side is counted.
        let reached = match t.count {
            n if n < 1.5 => x1,
            n if n < 2.5 => yields[side],
            _ => s * sign(other) * c.curve[other][0],
        };
        let plastic = ((reached - x1) / yields[side]).abs();
        let r = (self.r0 - self.cr1 * self.r0 * plastic / (self.cr2 + plastic)).min(c.curve[side][4]);
        t.curve[side] = [x0, y0, x1, y0 + self.e * (x1 - x0), r];
        let control = self.on(side, &t.before[side], x0).0;
        t.bounded[side] = f64::from(y0 <= control);
    }
}

impl UniaxialLaw for SteelMpf {
    type State = History;
    const NAME: &'static str = "SteelMPF";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let e = strain.value;
        let mut t = *c;
        let d = e - c.strain;
        if c.direction == 0.0 {
            if e.abs() < self.least_strain {
                return Ok((Stress { value: 0.0, tangent: self.e, damping: 0.0 }, t));
            }
            (t.direction, t.count) = (if e < 0.0 { -1.0 } else { 1.0 }, f64::from(e != 0.0));
            t.curve = [0, 1].map(|side| [0.0, 0.0, self.fy[side] / self.e, self.fy[side], self.r0]);
            t.before = t.curve;
        } else if d * c.direction < 0.0 {
            t.direction = -c.direction;
            self.turn(usize::from(t.direction < 0.0), c, &mut t);
        }
        let side = usize::from(t.direction < 0.0);
        let s = sign(side);
        let (mut y, mut tangent) = self.on(side, &t.curve[side], s * e);
        if t.bounded[side] != 0.0 && t.curve[side][0] > t.before[side][0] {
            let bound = self.on(side, &t.before[side], s * e);
            if y > bound.0 {
                (y, tangent) = bound;
                t.curve[side] = t.before[side];
            }
        }
        (t.strain, t.stress) = (e, s * y);
        Ok((Stress { value: t.stress, tangent, damping: 0.0 }, t))
    }

    fn initial_tangent(&self) -> f64 {
        self.e
    }
}
