//! One pair of sliding surfaces of a triple friction pendulum.

use crate::element::friction::Coefficient;
use crate::numeric::bracketed_root;
use nalgebra::{Matrix2, Vector2};

/// A pair of sliding surfaces: friction with the pendulum stiffness as kinematic hardening, and a circular gap to the
/// rim. Forces are per weight. Source: Dao, Ryan, Sato and Sasaki (2013).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Stiffness E before sliding, 1/length.
    pub e: f64,
    /// Hardening H = E E'/(E - E') for the stiffness E' in sliding, 1/length.
    pub h: f64,
    /// Displacement at contact with the rim.
    pub gap: f64,
    /// Speed of the surface per speed of the segment.
    pub speed: f64,
}

/// Force of a segment with derivatives.
#[derive(Clone, Copy, Debug)]
pub struct SegmentForce {
    /// Force.
    pub f: Vector2<f64>,
    /// Stiffness.
    pub k: Matrix2<f64>,
    /// Derivative by the coefficient of friction.
    pub by_mu: Vector2<f64>,
    /// Plastic displacement.
    pub plastic: Vector2<f64>,
    /// Back force of the hardening.
    pub back: Vector2<f64>,
    /// Speed of the surface in sliding.
    pub speed: f64,
    /// Coefficient of friction at that speed.
    pub mu: Coefficient,
}

impl Segment {
    /// Force at a displacement `d`, from the plastic displacement and the back force, by radial return (Simo and
    /// Hughes, 1998, section 3.3). `friction` gives the coefficient at the sliding speed over the time `dt`; the speed
    /// is 0 if no time passes.
    pub fn pull(
        &self,
        (plastic, back): (Vector2<f64>, Vector2<f64>),
        d: Vector2<f64>,
        dt: f64,
        friction: impl Fn(f64) -> Coefficient,
    ) -> SegmentForce {
        let trial = self.e * (d - plastic);
        let xi = trial - back;
        let (size, zero) = (xi.norm(), Vector2::zeros());
        let (k, mu) = (Matrix2::from_diagonal_element(self.e), friction(0.0));
        let mut p = SegmentForce { f: trial, k, by_mu: zero, plastic, back, speed: 0.0, mu };
        if size > mu.mu {
            let n = xi / size;
            let hard = self.e + self.h;
            let mut slip = (size - mu.mu) / hard;
            let per_slip = if dt > 0.0 { self.speed / dt } else { 0.0 };
            if per_slip > 0.0 {
                // Friction may grow with the speed: one monotonic equation for the slip.
                let equation = |slip: f64| {
                    let mu = friction(per_slip * slip);
                    (hard * slip + mu.mu - size, hard + mu.by_speed * per_slip)
                };
                let max_slip = size / hard;
                slip = bracketed_root(equation, (0.0, max_slip), slip.min(max_slip), max_slip, 100).unwrap_or(slip);
                p.speed = per_slip * slip;
                p.mu = friction(p.speed);
            }
            let soft = 1.0 / (hard + p.mu.by_speed * per_slip);
            p.f -= self.e * slip * n;
            let rotation = self.e * self.e * slip / size;
            let along = rotation - self.e * self.e * soft;
            p.k = Matrix2::from_diagonal_element(self.e - rotation) + along * n * n.transpose();
            p.by_mu = self.e * soft * n;
            p.plastic += slip * n;
            p.back += slip * self.h * n;
        }
        let r = d.norm();
        if r > self.gap {
            let n = d / r;
            p.f += self.e * (r - self.gap) * n;
            let gap_ratio = self.gap / r;
            p.k += self.e * (Matrix2::from_diagonal_element(1.0 - gap_ratio) + gap_ratio * n * n.transpose());
        }
        p
    }
}
