//! Buckling of bars in compression.

use super::History;
use super::curve::Backbone;

/// A model of buckling.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Buckling {
    /// None.
    None,
    /// Gomes and Appleton (1997, Engineering Structures 19(10), 822-826).
    Gomes {
        /// Unsupported length divided by the diameter.
        slenderness: f64,
        /// Share of the buckled stress that the bar keeps at least.
        reduction: f64,
        /// Stress in tension, as a share of the ultimate one, from which the reduced stress is counted.
        pivot: f64,
    },
    /// Dhakal and Maekawa (2002, Journal of Structural Engineering 128(9), 1139-1147).
    Dhakal {
        /// Unsupported length divided by the diameter.
        slenderness: f64,
        /// Adjustment, 0.75 to 1.
        alpha: f64,
    },
}

/// Half of the strain over which the slope of the buckled stress is taken.
const STEP: f64 = 1e-7;

impl Buckling {
    /// Natural stress and tangent of the bar from those without buckling.
    pub(super) fn apply(self, b: &Backbone, t: &mut History, tangent: f64) -> (f64, f64) {
        let slenderness = match self {
            Self::None => return (t.stress, tangent),
            Self::Gomes { slenderness, .. } | Self::Dhakal { slenderness, .. } => slenderness,
        };
        if slenderness <= 0.0 {
            return (t.stress, tangent);
        }
        let (e, f) = (t.strain, t.stress);
        let mut at = |e: f64| match self {
            Self::Gomes { reduction, pivot, .. } => gomes(b, t, (e, f), slenderness, (reduction, pivot)),
            Self::Dhakal { alpha, .. } => dhakal(b, t, (e, f), slenderness, alpha),
            Self::None => (f, 1.0),
        };
        let (stress, share) = at(e);
        let change = (at(e + STEP).0 - at(e - STEP).0) / (2.0 * STEP);
        (stress, share * tangent + change)
    }
}

/// Strain at which the bar is straight again after its largest strain.
fn straight(b: &Backbone, t: &History) -> f64 {
    t.largest[0] - b.fu / b.modulus
}

/// Buckled stress, and its derivative by the unbuckled one.
fn gomes(
    b: &Backbone,
    t: &History,
    (e, f): (f64, f64),
    slenderness: f64,
    (reduction, pivot): (f64, f64),
) -> (f64, f64) {
    let crossing = straight(b, t);
    if e >= crossing {
        return (f, 1.0);
    }
    // Stress of a bar with plastic hinges at its ends and middle; a round transition from the unbuckled stress.
    let (depth, width) = (0.1, 0.25);
    let buckled = (32.0 / (crossing - e)).sqrt() / (3.0 * std::f64::consts::PI * slenderness);
    let gap = (buckled - 1.0).abs();
    let round = if gap <= width { 1.0 - depth * (width - gap) / width } else { 1.0 };
    let factor = buckled.min(1.0) * round * (1.0 - reduction) + reduction;
    let top = b.fu * pivot;
    let share = (factor + pivot) / (1.0 + pivot);
    (top - share * (top - f), share)
}

/// Buckled stress, and its derivative by the unbuckled one.
fn dhakal(b: &Backbone, t: &mut History, (strain, f): (f64, f64), slenderness: f64, alpha: f64) -> (f64, f64) {
    let crossing = straight(b, t);
    let e = strain - crossing;
    if e >= -b.ey {
        return (f, 1.0);
    }
    let lambda = (b.fy / b.modulus * 2000.0).sqrt() * slenderness;
    let star = -(55.0 - 2.3 * lambda).max(7.0) * b.ey;
    let unbuckled = b.stress(star);
    let buckled = (unbuckled * alpha * (1.1 - 0.016 * lambda)).min(-0.2 * b.fy);
    let average = |f: f64| {
        let share = if e >= star {
            1.0 - (1.0 - buckled / unbuckled) * (e + b.ey) / (star + b.ey)
        } else {
            (buckled - 0.02 * b.modulus * (e - star)) / unbuckled
        };
        if e < star && f * share > -0.2 * b.fy { (-0.2 * b.fy, 0.0) } else { (f * share, share) }
    };
    if t.branch % 4.0 > 1.0 {
        return average(f);
    }
    let curve = t.curves[((t.branch + 1.0) / 2.0) as usize];
    if t.branch == 4.0 || t.branch == 5.0 {
        t.back_stress = curve.stress(crossing - b.ey);
    }
    let back = t.back_stress;
    let share = (back - average(curve.fa).0) / (back - curve.fa);
    (back - (back - f) * share, share)
}
