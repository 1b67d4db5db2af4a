//! Response of an elastic-plastic system of one degree of freedom.

use crate::series::TimeSeries;

/// A mass on a damper and a bilinear spring with kinematic hardening, in one system of units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingleDegree {
    /// Mass m.
    pub mass: f64,
    /// Damping ratio of the elastic system.
    pub damping: f64,
    /// Elastic stiffness k, force over length.
    pub stiffness: f64,
    /// Yield force.
    pub yield_force: f64,
    /// Stiffness after yielding over the elastic one, less than 1.
    pub hardening: f64,
}

/// Start of the system and the time that it is followed for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Step of time, the unit of the series.
    pub dt: f64,
    /// Time of the end.
    pub end: f64,
    /// Residual displacement of an earlier excitation: there the system rests.
    pub residual: f64,
    /// Largest displacement of an earlier excitation.
    pub largest: f64,
}

/// Response of a [`SingleDegree`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Response {
    /// Largest displacement without sign.
    pub largest: f64,
    /// Displacement at the end.
    pub end: f64,
    /// Plastic displacement at the end.
    pub plastic: f64,
    /// Largest acceleration without sign.
    pub acceleration: f64,
    /// Its time from the start.
    pub time: f64,
}

/// Iterations of a step at most, and the part of the first unbalance at which they end.
const MAX_ITERATIONS: usize = 10;
const TOLERANCE: f64 = 1e-8;

impl SingleDegree {
    /// Follows the system under a force by the average acceleration (Newmark, 1959).
    pub fn response(&self, force: &dyn TimeSeries, span: &Span) -> Response {
        let (m, k, dt) = (self.mass, self.stiffness, span.dt);
        let c = 2.0 * self.damping * (k * m).sqrt();
        let kinematic = self.hardening / (1.0 - self.hardening) * k;
        let from_disp = 4.0 * m / (dt * dt) + 2.0 / dt * c;
        let (mut u, mut v, mut a) = (span.residual, 0.0, 0.0);
        let (mut spring, mut tangent, mut plastic) = (0.0, k, span.residual);
        let mut out = Response { largest: span.largest.abs(), ..Response::default() };
        let (mut time, mut steps) = (force.start(), 0);
        while time < span.end {
            steps += 1;
            let load = force.factor(time) + from_disp * u + (4.0 * m / dt + c) * v + m * a;
            let (start, yielded) = (u, plastic);
            let mut unbalance = load - spring - from_disp * u;
            let first = if unbalance == 0.0 { 1.0 } else { unbalance };
            for _ in 0..MAX_ITERATIONS {
                if (unbalance / first).abs() <= TOLERANCE {
                    break;
                }
                u += unbalance / (tangent + from_disp);
                spring = k * (u - yielded);
                plastic = yielded;
                tangent = k;
                let over = (spring - kinematic * yielded).abs() - self.yield_force;
                if over > 0.0 {
                    let flow = (over / (k + kinematic)).copysign(spring);
                    (spring, plastic) = (spring - flow * k, yielded + flow);
                    tangent = k * kinematic / (k + kinematic);
                }
                unbalance = load - spring - from_disp * u;
            }
            let step = u - start;
            (v, a) = (2.0 / dt * step - v, 4.0 / (dt * dt) * step - 4.0 / dt * v - a);
            out.largest = out.largest.max(u.abs());
            if a.abs() > out.acceleration {
                (out.acceleration, out.time) = (a.abs(), f64::from(steps) * dt);
            }
            time += dt;
        }
        Response { end: u, plastic, ..out }
    }
}
