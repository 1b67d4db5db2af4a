//! Multilinear hysteresis with pinching, damage, degraded unloading and degrading envelopes (Mazzoni, 2023, after Scott
//! and Filippou, 2000).

use crate::material::deteriorating::hysteretic::cycle::{Cycle, Enveloped, FLAT_SLOPE_RATIO, MAX_STRAIN, Reloading};
use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};

/// Number of points of an envelope.
const POINTS: usize = 7;
/// Least factor of a degraded envelope.
const MIN_FACTOR: f64 = 1.0e-9;
/// Place of the points that an envelope of few points lacks, between its last two.
const FILL: [f64; POINTS] = [0.0, 0.2, 0.3, 0.4, 0.5, 0.6, 1.0];

/// The envelope on one side: stresses and strains of its points, positive on both sides.
#[derive(Clone, Debug, PartialEq)]
pub struct SmEnvelope {
    stress: [f64; POINTS],
    strain: [f64; POINTS],
}

impl SmEnvelope {
    /// An envelope through 2 to 7 points (stress, strain) with increasing strains. Others are put between the last two.
    pub fn new(points: &[(f64, f64)]) -> Self {
        let (first, last) = (points.len() - 2, points[points.len() - 1]);
        let start = points[first];
        let slope = (last.0 - start.0) / (last.1 - start.1);
        let (mut stress, mut strain) = ([0.0; POINTS], [0.0; POINTS]);
        for i in 0..POINTS {
            (stress[i], strain[i]) = match i {
                _ if i <= first => points[i],
                _ if i + 1 == POINTS => last,
                _ => {
                    let at = start.1 + FILL[i] * (last.1 - start.1);
                    (start.0 + (at - start.1) * slope, at)
                }
            };
        }
        Self { stress, strain }
    }

    /// The first two slopes.
    pub fn first_slopes(&self) -> [f64; 2] {
        let e = self.slopes();
        [e[0], e[1]]
    }

    fn slopes(&self) -> [f64; POINTS] {
        let (m, r) = (&self.stress, &self.strain);
        std::array::from_fn(|i| if i == 0 { m[0] / r[0] } else { (m[i] - m[i - 1]) / (r[i] - r[i - 1]) })
    }

    /// With stresses beyond the first point multiplied by a factor, and strains by another.
    fn scaled(&self, stress: f64, strain: f64) -> Self {
        let mut new = self.clone();
        new.stress[1..].iter_mut().for_each(|m| *m *= stress);
        new.strain[1..].iter_mut().for_each(|r| *r *= strain);
        new
    }

    /// Twice the areas under the envelope up to the third point, and behind it.
    fn areas(&self) -> (f64, f64) {
        let (m, r) = (&self.stress, &self.strain);
        let area = |i: usize| (r[i] - r[i - 1]) * (m[i] + m[i - 1]);
        (r[0] * m[0] + area(1) + area(2), (3..POINTS).map(area).sum())
    }
}

/// An envelope with its slopes.
struct Branch {
    points: SmEnvelope,
    slope: [f64; POINTS],
    /// Unloading slope, equal to the steepest slope of the envelope.
    unloading: f64,
}

impl Branch {
    fn new(points: SmEnvelope) -> Self {
        let slope = points.slopes();
        let unloading = slope.iter().fold(slope[0], |k, e| if *e > k { *e } else { k });
        Self { points, slope, unloading }
    }

    /// Segment that holds a strain; none behind the last point of an envelope that does not rise there.
    fn segment(&self, x: f64) -> Option<usize> {
        let last = POINTS - 1;
        let found = self.points.strain.iter().position(|r| x <= *r);
        found.or((self.slope[last] > 0.0).then_some(last))
    }

    /// Stress and slope at a strain.
    fn at(&self, x: f64) -> (f64, f64) {
        let (m, r, e) = (&self.points.stress, &self.points.strain, &self.slope);
        if x < 0.0 {
            return (0.0, FLAT_SLOPE_RATIO * e[0]);
        }
        match self.segment(x) {
            Some(0) => (e[0] * x, e[0]),
            Some(i) => (m[i - 1] + e[i] * (x - r[i - 1]), e[i]),
            None => (m[POINTS - 1], FLAT_SLOPE_RATIO * e[0]),
        }
    }

    /// End of the segment that contains the largest strain, if there is no stress left there.
    fn exhausted(&self, largest: f64) -> Option<f64> {
        let (m, r, e) = (&self.points.stress, &self.points.strain, &self.slope);
        if largest <= r[0] {
            return None;
        }
        let last = POINTS - 1;
        let i = (1..last).find(|i| largest <= r[*i]).unwrap_or(last);
        if i == last && (e[last] >= 0.0 || e[last].is_nan()) {
            return None;
        }
        let limit = r[i - 1] + (m[i] - m[i - 1]) / e[i];
        (limit.is_finite() && self.at(limit).0 <= 0.0).then_some(limit)
    }
}

/// Hysteresis between two envelopes.
#[derive(Clone, Debug, PartialEq)]
pub struct HystereticSm {
    sides: [SmEnvelope; 2],
    /// Pinching factors of strain and of stress.
    pinch: [f64; 2],
    /// Damage factors for ductility and for energy.
    damage: [f64; 2],
    /// Exponent of the degraded unloading stiffness.
    beta: f64,
    /// Loss of each envelope per unit of damage; positive values shrink its strains too.
    degrading: [f64; 2],
    energy: f64,
}

impl HystereticSm {
    /// From the envelopes in tension and compression, the pinching factors of strain and stress, the damage factors for
    /// ductility and energy, the exponent of the unloading stiffness, and the losses of both envelopes.
    pub fn new(sides: [SmEnvelope; 2], pinch: [f64; 2], damage: [f64; 2], beta: f64, degrading: [f64; 2]) -> Self {
        // As in OpenSees, the areas of the last four segments in compression count twice.
        let ((p, p_rest), (n, n_rest)) = (sides[0].areas(), sides[1].areas());
        Self { sides, pinch, damage, beta, degrading, energy: 0.5 * (p + p_rest + n) + n_rest }
    }

    fn branch(&self, side: usize, factor: f64) -> Branch {
        let points = &self.sides[side];
        if factor == 0.0 {
            return Branch::new(points.clone());
        }
        Branch::new(points.scaled(factor, if self.degrading[side] > 0.0 { factor } else { 1.0 }))
    }

    /// Degradation factor of the unloading slope of a side.
    fn softened(&self, side: usize, largest: f64) -> f64 {
        let k = (largest / self.sides[side].strain[0]).powf(self.beta);
        if k < 1.0 { 1.0 } else { 1.0 / k }
    }
}

crate::state_struct! {
    /// History of [`HystereticSm`].
    pub struct History {
        /// Part of every law of this kind.
        cycle: Cycle,
        /// Factor of each envelope; 0 before any loss.
        kept: [f64; 2],
    }
}

impl HystereticSm {
    /// Turn of the loading towards the side `ahead`: strain of zero stress, and damage to that side.
    fn turn(&self, c: &History, t: &mut History, (ahead, behind): (usize, usize), s: f64, k_rear: f64) {
        let (x, sig) = (s * c.cycle.strain, s * c.cycle.stress);
        t.cycle.unloaded[behind] = s * (x - sig / k_rear);
        let energy = c.cycle.energy - 0.5 * sig / k_rear * sig;
        let (reached, first) = (c.cycle.extreme[behind], self.sides[behind].strain[0]);
        if reached <= first {
            return;
        }
        let harm = self.damage[1] * energy / self.energy + self.damage[0] * (reached - first) / first;
        if self.degrading[ahead] != 0.0 {
            let factor = (1.0 - self.degrading[ahead].abs() * harm).max(MIN_FACTOR);
            let before = if c.kept[ahead] == 0.0 { 1.0 } else { c.kept[ahead] };
            t.kept[ahead] = before * factor;
        }
        t.cycle.extreme[ahead] = c.cycle.extreme[ahead] * (1.0 + harm);
    }
}

impl Enveloped for HystereticSm {
    type History = History;
    const NAME: &'static str = "HystereticSM";

    fn cycle(history: &History) -> &Cycle {
        &history.cycle
    }
    fn cycle_mut(history: &mut History) -> &mut Cycle {
        &mut history.cycle
    }
    fn initial(&self) -> f64 {
        self.sides[0].slopes()[0]
    }
    fn envelope(&self, c: &History, side: usize, x: f64) -> (f64, f64) {
        self.branch(side, c.kept[side]).at(x)
    }

    fn advance(&self, c: &History, d: f64, t: &mut History, s: f64) -> (f64, f64) {
        let (ahead, behind) = if s > 0.0 { (0, 1) } else { (1, 0) };
        let rear = self.branch(behind, c.kept[behind]);
        let extreme = c.cycle.extreme;
        let (soft_rear, soft_front) = (self.softened(behind, extreme[behind]), self.softened(ahead, extreme[ahead]));
        let k_rear = rear.unloading * soft_rear;
        if t.cycle.loading == -s && s * c.cycle.stress <= 0.0 {
            self.turn(c, t, (ahead, behind), s, k_rear);
        }
        let front = self.branch(ahead, t.kept[ahead]);
        let k_front = front.unloading * soft_front;
        let t = &mut t.cycle;
        t.loading = s;
        t.extreme[ahead] = t.extreme[ahead].min(MAX_STRAIN).max(front.points.strain[0]);
        let target = t.extreme[ahead];
        let (peak, _) = front.at(target);
        let zero = s * t.unloaded[behind];
        let release = rear.exhausted(extreme[behind]).map_or(zero, |limit| zero.max(-limit));
        let full = target - (1.0 - self.pinch[1]) * peak / k_front;
        let reloading = Reloading {
            zero,
            release,
            pinch: release + (full - release) * self.pinch[0],
            target: [target, peak],
            share: self.pinch[1],
            slopes: [k_rear, k_front],
            elastic: [rear.unloading, front.unloading],
        };
        reloading.at(s * t.strain, s * d, s * c.cycle.stress)
    }
}

impl UniaxialLaw for HystereticSm {
    type State = History;
    const NAME: &'static str = "HystereticSM";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        self.step(c, strain)
    }

    fn initial_tangent(&self) -> f64 {
        self.initial()
    }
}
