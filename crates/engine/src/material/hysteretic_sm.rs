//! Multilinear hysteresis with pinching, damage, degraded unloading and degrading envelopes (Mazzoni, 2023, after Scott
//! and Filippou, 2000).

use super::{MaterialError, Strain, Stress, UniaxialLaw};

/// Number of points of an envelope.
const POINTS: usize = 7;
/// Largest strain of an envelope, which no analysis reaches.
const MAX_STRAIN: f64 = 1.0e16;
/// Slope of a horizontal branch divided by the elastic slope.
const FLAT_SLOPE_RATIO: f64 = 1.0e-9;
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
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Tangent minus the initial tangent.
        softening: f64,
        /// Largest strain in tension and in compression, both positive, enlarged by damage.
        extreme: [f64; 2],
        /// Strain of zero stress after the last unloading from tension and from compression.
        unloaded: [f64; 2],
        /// Dissipated and stored energy per volume.
        energy: f64,
        /// 1 loading, -1 unloading, 0 virgin.
        loading: f64,
        /// Factor of each envelope; 0 before any loss.
        kept: [f64; 2],
    }
}

/// The response with the lower stress of an unloading and a reloading line.
fn lower(unloading: (f64, f64), reloading: (f64, f64)) -> (f64, f64) {
    if unloading.0 < reloading.0 { unloading } else { reloading }
}

impl HystereticSm {
    /// Turn of the loading towards the side `ahead`: strain of zero stress, and damage to that side.
    fn turn(&self, c: &History, t: &mut History, (ahead, behind): (usize, usize), s: f64, k_rear: f64) {
        let (x, sig) = (s * c.strain, s * c.stress);
        t.unloaded[behind] = s * (x - sig / k_rear);
        let energy = c.energy - 0.5 * sig / k_rear * sig;
        let (reached, first) = (c.extreme[behind], self.sides[behind].strain[0]);
        if reached <= first {
            return;
        }
        let harm = self.damage[1] * energy / self.energy + self.damage[0] * (reached - first) / first;
        if self.degrading[ahead] != 0.0 {
            let factor = (1.0 - self.degrading[ahead].abs() * harm).max(MIN_FACTOR);
            let before = if c.kept[ahead] == 0.0 { 1.0 } else { c.kept[ahead] };
            t.kept[ahead] = before * factor;
        }
        t.extreme[ahead] = c.extreme[ahead] * (1.0 + harm);
    }

    /// Response between the largest strains towards tension (`s` = 1) or, mirrored, towards compression (`s` = -1).
    fn advance(&self, c: &History, d: f64, t: &mut History, s: f64) -> (f64, f64) {
        let (ahead, behind) = if s > 0.0 { (0, 1) } else { (1, 0) };
        let rear = self.branch(behind, c.kept[behind]);
        let (soft_rear, soft_front) =
            (self.softened(behind, c.extreme[behind]), self.softened(ahead, c.extreme[ahead]));
        let k_rear = rear.unloading * soft_rear;
        if t.loading == -s && s * c.stress <= 0.0 {
            self.turn(c, t, (ahead, behind), s, k_rear);
        }
        t.loading = s;
        let front = self.branch(ahead, t.kept[ahead]);
        let k_front = front.unloading * soft_front;
        let (x, sig_c, d) = (s * t.strain, s * c.stress, s * d);
        t.extreme[ahead] = t.extreme[ahead].min(MAX_STRAIN).max(front.points.strain[0]);
        let target = t.extreme[ahead];
        let (peak, _) = front.at(target);
        let zero = s * t.unloaded[behind];
        let release = rear.exhausted(c.extreme[behind]).map_or(zero, |limit| zero.max(-limit));
        let full = target - (1.0 - self.pinch[1]) * peak / k_front;
        let pinch = release + (full - release) * self.pinch[0];
        let elastic = (sig_c + k_front * d, k_front);
        if x < zero {
            let sig = sig_c + k_rear * d;
            if sig >= 0.0 { (0.0, FLAT_SLOPE_RATIO * rear.unloading) } else { (sig, k_rear) }
        } else if x < pinch {
            if x <= release {
                (0.0, FLAT_SLOPE_RATIO * front.unloading)
            } else {
                let k = peak * self.pinch[1] / (pinch - release);
                lower(elastic, ((x - release) * k, k))
            }
        } else {
            let k = (1.0 - self.pinch[1]) * peak / (target - pinch);
            lower(elastic, (self.pinch[1] * peak + (x - pinch) * k, k))
        }
    }
}

impl UniaxialLaw for HystereticSm {
    type State = History;
    const NAME: &'static str = "HystereticSM";

    fn update(&self, c: &History, strain: Strain) -> Result<(Stress, History), MaterialError> {
        let initial = UniaxialLaw::initial_tangent(self);
        let d = strain.value - c.strain;
        if d.abs() < f64::EPSILON {
            return Ok((Stress { value: c.stress, tangent: initial + c.softening, damping: 0.0 }, *c));
        }
        let mut t = History { strain: strain.value, ..*c };
        if t.loading == 0.0 {
            t.loading = d.signum();
        }
        let beyond = [(1.0, t.strain >= c.extreme[0]), (-1.0, t.strain <= -c.extreme[1])];
        let (value, tangent) = match beyond.into_iter().position(|b| b.1) {
            Some(side) => {
                let s = beyond[side].0;
                t.extreme[side] = s * t.strain;
                t.loading = s;
                let (stress, slope) = self.branch(side, c.kept[side]).at(s * t.strain);
                (s * stress, slope)
            }
            None => {
                let s = d.signum();
                let (stress, slope) = self.advance(c, d, &mut t, s);
                (s * stress, slope)
            }
        };
        if !(value.is_finite() && tangent.is_finite()) {
            let message = format!("HystereticSM has no stress at a strain of {:.6e}: too much damage", strain.value);
            return Err(MaterialError(message));
        }
        t.energy = c.energy + 0.5 * (c.stress + value) * d;
        (t.stress, t.softening) = (value, tangent - initial);
        Ok((Stress { value, tangent, damping: 0.0 }, t))
    }

    fn initial_tangent(&self) -> f64 {
        self.sides[0].slopes()[0]
    }
}
