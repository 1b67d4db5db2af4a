//! Hysteresis that fails when a column reaches a limit surface (Elwood, 2004).

mod curve;
mod rotation_shear;

use crate::material::deteriorating::hysteretic::cycle::{Cycle, Enveloped, FLAT_SLOPE_RATIO, MAX_STRAIN, Reloading};
use crate::material::{Envelope, MaterialResult, Strain, Stress, UniaxialLaw, finite};
use crate::probe::Probe;
pub use curve::{ColumnResponse, LimitCurve, LimitDeformation, LimitForce, LimitSurface};
pub use rotation_shear::{Column, RotationLimit, RotationShear};

/// A spring of a column. After a step in which the column has reached the surface, the spring follows a new envelope.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitState {
    /// Envelopes in tension and in compression.
    pub sides: [Envelope; 2],
    /// Pinching factors of strain and of stress.
    pub pinch: [f64; 2],
    /// Damage factors for ductility and for energy.
    pub damage: [f64; 2],
    /// Exponent of the degraded unloading stiffness.
    pub beta: f64,
    /// The largest strain of one side counts for the other one too.
    pub symmetric: bool,
    /// Surface of failure, and true for a spring that loses axial load.
    pub curve: Option<(LimitCurve, bool)>,
    /// Steps that turn and end beyond the largest strain take their own direction of loading; in OpenSees the one before.
    pub turns_beyond: bool,
    /// The last two parts of the energy in compression are multiplied, as in OpenSees.
    pub odd_energy: bool,
}

crate::state_struct! {
    /// History of [`LimitState`].
    pub struct History {
        /// Part of every law of this kind.
        cycle: Cycle,
        /// Stresses and strains of the envelopes after failure; zero before.
        points: [[f64; 6]; 2],
        /// State of the column: 0 before failure, 1 failing, 2 on the surface, 3 inside, 4 at the residual force.
        flag: f64,
        /// Force that has been lost.
        loss: f64,
        /// Energy of OpenSees that damage is divided by, set at failure; zero before.
        energy: f64,
        /// Degrading slope and residual force, set at failure; zero before.
        failure: [f64; 2],
    }
}

/// Slope of an axial spring that is below its surface again, divided by the elastic slope.
const RELOADING_SLOPE_RATIO: f64 = 0.01;
/// Stress at the end of that branch divided by that at its beginning.
const RELOADING_END: f64 = 10.0;

impl LimitState {
    fn side(&self, h: &History, side: usize) -> Envelope {
        let p = h.points[side];
        if p[3] == 0.0 {
            return self.sides[side].clone();
        }
        Envelope::new([p[0], p[1], p[2]], [p[3], p[4], p[5]])
    }

    /// Energy that damage is divided by.
    fn energy(&self, h: &History) -> f64 {
        let sides = [self.side(h, 0), self.side(h, 1)];
        if !self.odd_energy {
            return sides[0].energy() + sides[1].energy();
        }
        if h.energy != 0.0 {
            return h.energy;
        }
        let (m, r) = (&sides[1].stress, &sides[1].strain);
        let parts = (r[1] - r[0]) * (m[1] + m[0]) * ((r[2] - r[1]) * (m[2] + m[1]));
        sides[0].energy() + 0.5 * (r[0] * m[0] + parts)
    }

    fn is_axial(&self) -> bool {
        self.curve.as_ref().is_some_and(|c| c.1)
    }

    /// Damage of the side ahead at a turn.
    fn harm(&self, c: &History, (ahead, behind): (usize, usize), energy: f64) -> f64 {
        let (was, fronts) = (&c.cycle, [self.side(c, ahead), self.side(c, behind)]);
        let [front, rear] = [fronts[0].strain[0], fronts[1].strain[0]];
        if was.extreme[behind] <= rear {
            return 0.0;
        }
        let mut harm = self.damage[1] * energy / self.energy(c);
        if was.strain.abs() == was.extreme[behind] {
            harm += self.damage[0] * (was.extreme[ahead] / front - 1.0);
        }
        harm
    }

    /// The envelope that begins at the committed state of a side.
    fn failed_envelope(&self, h: &History, side: usize, flag: f64) -> [f64; 6] {
        let s = if side == 0 { 1.0 } else { -1.0 };
        let (stress, strain) = (s * h.cycle.stress, s * h.cycle.strain);
        let old = self.side(h, side);
        let (elastic, mut m1, mut r1) = (self.sides[side].slope[0], old.stress[0], old.strain[0]);
        if flag == 4.0 {
            let r2 = 0.5 * (strain + r1);
            return [m1, stress - (strain - r2) * (old.slope[0] * FLAT_SLOPE_RATIO), stress, r1, r2, strain];
        }
        let other = self.side(h, 1 - side).strain[0];
        if strain <= r1 && strain >= -other {
            m1 = 0.5 * stress;
            r1 = m1 / elastic;
        }
        let (m3, slope) = if flag == 3.0 && self.is_axial() {
            (RELOADING_END * stress, elastic * RELOADING_SLOPE_RATIO)
        } else {
            (h.failure[1], h.failure[0])
        };
        [m1, stress, m3, r1, strain, strain + (m3 - stress) / slope]
    }
}

impl LimitState {
    fn fail(&self, h: &mut History, side: usize, flag: f64) {
        h.points[side] = self.failed_envelope(h, side, flag);
        h.energy = 0.0;
        if self.odd_energy {
            h.energy = self.energy(h);
        }
    }
}

impl Enveloped for LimitState {
    type History = History;
    const NAME: &'static str = "LimitState";

    fn cycle(history: &History) -> &Cycle {
        &history.cycle
    }
    fn cycle_mut(history: &mut History) -> &mut Cycle {
        &mut history.cycle
    }
    fn initial(&self) -> f64 {
        self.sides[0].slope[0]
    }
    fn envelope(&self, c: &History, side: usize, x: f64) -> (f64, f64) {
        self.side(c, side).at(x)
    }
    fn turns_beyond(&self) -> bool {
        self.turns_beyond
    }

    fn advance(&self, c: &History, d: f64, t: &mut History, s: f64) -> (f64, f64) {
        let (ahead, behind) = if s > 0.0 { (0, 1) } else { (1, 0) };
        let (front, rear) = (self.side(c, ahead), self.side(c, behind));
        let was = &c.cycle;
        let k_rear = rear.slope[0] * rear.degraded(was.extreme[behind], self.beta);
        let k_front = front.slope[0] * front.degraded(was.extreme[ahead], self.beta);
        let (x, x_c, sig_c) = (s * t.cycle.strain, s * was.strain, s * was.stress);
        let t = &mut t.cycle;
        if t.loading == -s && sig_c <= 0.0 {
            t.unloaded[behind] = s * (x_c - sig_c / k_rear);
            let energy = was.energy - 0.5 * sig_c / k_rear * sig_c;
            t.extreme[ahead] = was.extreme[ahead] * (1.0 + self.harm(c, (ahead, behind), energy));
        }
        t.loading = s;
        t.extreme[ahead] = t.extreme[ahead].min(MAX_STRAIN).max(front.strain[0]);
        if self.symmetric {
            t.extreme[ahead] = t.extreme[ahead].max(was.extreme[behind]);
        }
        let target = t.extreme[ahead];
        let (peak, _) = front.at(target);
        let zero = s * t.unloaded[behind];
        // A rear envelope without stress left lets go where that stress ends.
        let release = match rear.exhausted(was.extreme[behind]) {
            Some(limit) if rear.at(was.extreme[behind]).0 <= 0.0 => -limit,
            _ => zero,
        };
        let near = release + self.pinch[1] * (target - release);
        let full = target - (1.0 - self.pinch[1]) * peak / k_front;
        let reloading = Reloading {
            zero,
            release,
            pinch: near + (full - near) * self.pinch[0],
            target: [target, peak],
            share: self.pinch[1],
            slopes: [k_rear, k_front],
            elastic: [rear.slope[0], front.slope[0]],
        };
        reloading.at(x, s * d, sig_c)
    }
}

impl UniaxialLaw for LimitState {
    type State = History;
    const NAME: &'static str = "LimitState";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let (mut stress, t) = self.step(c, strain)?;
        if self.is_axial() && (c.flag == 1.0 || c.flag == 2.0) {
            let side = usize::from(t.cycle.strain <= 0.0);
            let envelope = self.side(c, side);
            let beyond = t.cycle.strain.abs() > envelope.strain[2];
            stress.tangent = if beyond { self.side(c, 0).slope[0] * FLAT_SLOPE_RATIO } else { envelope.slope[2] };
        }
        finite(<Self as UniaxialLaw>::NAME, strain.value, stress.value + c.loss, stress.tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.initial()
    }

    /// The committed state changes without a motion.
    fn depends_on_time(&self) -> bool {
        self.curve.is_some()
    }

    fn limit_curve(&self) -> Option<&LimitCurve> {
        self.curve.as_ref().map(|c| &c.0)
    }

    fn observe(&self, h: &mut History, seen: &ColumnResponse) {
        let Some((curve, axial)) = &self.curve else { return };
        if h.flag == 4.0 {
            return;
        }
        let before = h.flag;
        let (flag, lost) = curve.check(h.cycle.stress, seen, before, &mut h.failure);
        let side = usize::from(h.cycle.stress <= 0.0);
        if flag == 1.0 {
            self.fail(h, side, flag);
            if !axial {
                h.points[1 - side] = h.points[side];
            }
        }
        if *axial {
            if flag == 1.0 || flag == 2.0 || flag == 4.0 {
                h.loss += lost;
            }
            let inside = (before == 1.0 || before == 2.0) && flag == 3.0;
            if inside || before == 3.0 && flag == 2.0 || flag == 4.0 {
                self.fail(h, side, flag);
            }
        }
        h.flag = flag;
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        (*words.first()? == "stateFlag").then(|| Probe::new(0, ["stateFlag"]))
    }

    fn read(&self, _: &[u32], h: &History, out: &mut [f64]) {
        out[0] = h.flag;
    }
}
