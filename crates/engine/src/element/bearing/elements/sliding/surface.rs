//! A sliding surface: friction with a circular yield surface, pendulum stiffness of a spherical dish, and the normal
//! force of both.

use crate::element::friction::{Coefficient, Contact, Friction};
use crate::element::{ElementError, ElementResult};
use crate::numeric::{dot, norm};

/// Shape of a spherical sliding surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dish {
    /// Effective radius R_eff.
    pub radius: f64,
    /// The slider rises as it moves away from the centre (`-inclVertDisp`).
    pub rises: bool,
}

impl Dish {
    /// Rise of the slider R - (R² - |u|²)^½, and its derivatives by the displacement.
    ///
    /// # Errors
    /// The displacement is not less than the radius.
    pub fn rise<const S: usize>(&self, u: [f64; S]) -> ElementResult<(f64, [f64; S])> {
        let depth = self.depth(norm(&u))?;
        Ok((self.radius - depth, u.map(|u| u / depth)))
    }

    /// (R² - u²)^½
    fn depth(&self, u: f64) -> ElementResult<f64> {
        let square = (self.radius - u) * (self.radius + u);
        if square > 0.0 {
            return Ok(square.sqrt());
        }
        let r = self.radius;
        Err(ElementError(
            format!("the displacement {u:.4} is not less than the radius of the sliding surface, {r}").into(),
        ))
    }
}

/// A sliding surface with `S` directions. The plastic displacement u_p, with the normal force N, gives the force at a
/// displacement:
///
/// q = F n + (N/R) u - N θ, |(k_init - N/R)(u - u_p)| ≤ F = μ(N, v) N, N = P + q·(u/R - θ),
///
/// with the axial force P, the rotation θ of the surface and its radius R. The law is that of Schellenberg, Yang and
/// Mahin (2007), as in OpenSees. It is solved by return mapping.
#[derive(Clone, Debug)]
pub struct Surface {
    /// Friction model.
    pub friction: Friction,
    /// Stiffness before sliding k_init.
    pub k_init: f64,
    /// Shape of the dish; `None` for a flat surface.
    pub dish: Option<Dish>,
}

/// Trial state of the slider.
#[derive(Clone, Copy, Debug)]
pub struct Pose<const S: usize> {
    /// Displacement.
    pub u: [f64; S],
    /// Velocity.
    pub rate: [f64; S],
    /// Rotation of the surface that inclines the normal force to each direction.
    pub tilt: [f64; S],
    /// Axial force, positive in compression.
    pub pressure: f64,
    /// Committed plastic displacement.
    pub plastic: [f64; S],
    /// Temperature factor of the friction, 1 without heating.
    pub warmth: f64,
}

/// Force of a surface with derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Slide<const S: usize> {
    /// Force.
    pub q: [f64; S],
    /// Plastic displacement in sliding; `None` in sticking.
    pub plastic: Option<[f64; S]>,
    /// Normal force, speed and coefficient.
    pub contact: Contact,
    /// Stiffness at constant normal force and shape, OpenSees' tangent.
    pub stiffness: [[f64; S]; S],
    /// Derivatives of the force by the displacement.
    pub by_u: [[f64; S]; S],
    /// Derivatives of the force by the velocity.
    pub by_rate: [[f64; S]; S],
    /// Derivatives of the force by the rotation of the surface.
    pub by_tilt: [[f64; S]; S],
    /// Derivative of the force by the axial force.
    pub by_pressure: [f64; S],
}

/// Geometry of a trial state.
struct Shape<const S: usize> {
    /// Curvature 1/R in each direction.
    c: [f64; S],
    /// Its derivative by the displacement in the other direction.
    dc: [f64; S],
    /// Speed along the surface.
    speed: f64,
    speed_by_u: [f64; S],
    speed_by_rate: [f64; S],
    /// N = P + q·g.
    g: [f64; S],
}

/// Force at a given normal force.
struct AtNormal<const S: usize> {
    q: [f64; S],
    by_normal: [f64; S],
    /// Trial force of the hysteretic part.
    trial: [f64; S],
    size: f64,
    friction: Coefficient,
    /// Friction force F.
    limit: f64,
}

impl<const S: usize> AtNormal<S> {
    fn slides(&self) -> bool {
        self.size > self.limit
    }
}

/// Largest number of iterations for the normal force; two or three are usual.
const MAX_ITERATIONS: usize = 100;

impl Surface {
    /// Response at a trial state.
    ///
    /// # Errors
    /// A displacement beyond the edge of the dish, or no convergence of the normal force.
    pub fn slide<const S: usize>(&self, pose: &Pose<S>) -> ElementResult<Slide<S>> {
        let shape = self.shape(pose)?;
        // Newton's method for N = max(0, P + q(N)·g), which is nearly linear.
        let mut normal = pose.pressure;
        for _ in 0..MAX_ITERATIONS {
            let at = self.at_normal(pose, &shape, normal);
            let equilibrium = pose.pressure + dot(&at.q, &shape.g);
            let step =
                if equilibrium > 0.0 { (equilibrium - normal) / (1.0 - dot(&at.by_normal, &shape.g)) } else { -normal };
            let next = (normal + step).max(0.0);
            if (next - normal).abs() <= 1e-14 * pose.pressure {
                return self.checked(pose, self.response_at(pose, &shape, &at, normal));
            }
            normal = next;
        }
        Err(ElementError("no normal force of the sliding surface belongs to this motion".into()))
    }

    /// Rejects an initial stiffness that is not greater than the pendulum stiffness, which leaves no friction.
    fn checked<const S: usize>(&self, pose: &Pose<S>, s: Slide<S>) -> ElementResult<Slide<S>> {
        let pendulum = self.dish.map_or(0.0, |d| s.contact.normal / d.radius);
        if pendulum < self.k_init && s.q.iter().all(|q| q.is_finite()) {
            return Ok(s);
        }
        Err(ElementError(
            format!(
                "the initial stiffness {} is not greater than the pendulum's, N/R = {pendulum}, under a pressure of {}",
                self.k_init, pose.pressure
            )
            .into(),
        ))
    }

    /// Response by OpenSees' substitution: iterations from a force `start` until it changes by less than the tolerance.
    ///
    /// # Errors
    /// As [`Surface::slide`].
    pub fn slide_by_substitution<const S: usize>(
        &self,
        pose: &Pose<S>,
        start: [f64; S],
        rounds: usize,
        tolerance: f64,
    ) -> ElementResult<Slide<S>> {
        let shape = self.shape(pose)?;
        let mut q = start;
        for _ in 0..=rounds {
            let normal = (pose.pressure + dot(&q, &shape.g)).max(0.0);
            let at = self.at_normal(pose, &shape, normal);
            let change: [f64; S] = std::array::from_fn(|i| at.q[i] - q[i]);
            // The round-off of a large force may exceed the tolerance.
            if norm(&change) < tolerance.max(1e-15 * norm(&at.q)) {
                return Ok(self.response_at(pose, &shape, &at, normal));
            }
            q = at.q;
        }
        Err(ElementError(
            format!("no shear force was found in {rounds} iterations to a tolerance of {tolerance}").into(),
        ))
    }

    fn shape<const S: usize>(&self, pose: &Pose<S>) -> ElementResult<Shape<S>> {
        let (mut c, mut dc) = ([0.0; S], [0.0; S]);
        if let Some(dish) = &self.dish {
            dish.depth(norm(&pose.u))?;
            for i in 0..S {
                // The section of the sphere in one direction is a circle with a radius from the displacement in the
                // other.
                let across = if S == 1 { 0.0 } else { pose.u[1 - i] };
                c[i] = 1.0 / dish.depth(across)?;
                dc[i] = across * c[i].powi(3);
            }
        }
        let w = &pose.rate;
        let rise: f64 = (0..S).map(|i| w[i] * pose.u[i] * c[i]).sum();
        let speed = w.iter().fold(rise, |sum, w| sum.hypot(*w));
        let over = if speed > 0.0 { 1.0 / speed } else { 0.0 };
        let across = |i: usize| if S == 1 { 0.0 } else { w[1 - i] * pose.u[1 - i] * dc[1 - i] };
        Ok(Shape {
            speed,
            speed_by_u: std::array::from_fn(|i| over * rise * (w[i] * c[i] + across(i))),
            speed_by_rate: std::array::from_fn(|i| over * (rise * pose.u[i] * c[i] + w[i])),
            g: std::array::from_fn(|i| pose.u[i] * c[i] - pose.tilt[i]),
            c,
            dc,
        })
    }

    fn at_normal<const S: usize>(&self, pose: &Pose<S>, shape: &Shape<S>, normal: f64) -> AtNormal<S> {
        let unheated = self.coefficient(normal, shape.speed);
        let friction = Coefficient {
            mu: pose.warmth * unheated.mu,
            by_normal: pose.warmth * unheated.by_normal,
            by_speed: pose.warmth * unheated.by_speed,
        };
        let limit = friction.mu * normal.max(0.0);
        let elastic: [f64; S] = std::array::from_fn(|i| pose.u[i] - pose.plastic[i]);
        let trial: [f64; S] = std::array::from_fn(|i| (self.k_init - normal * shape.c[i]) * elastic[i]);
        let size = norm(&trial);
        let mut at = AtNormal { q: trial, by_normal: [0.0; S], trial, size, friction, limit };
        let trial_by_normal: [f64; S] = std::array::from_fn(|i| -shape.c[i] * elastic[i]);
        if at.slides() {
            let along = dot(&trial, &trial_by_normal) / (size * size);
            let by_normal_force = if normal > 0.0 { friction.mu + normal * friction.by_normal } else { 0.0 };
            for i in 0..S {
                at.q[i] = limit * trial[i] / size;
                at.by_normal[i] =
                    by_normal_force * trial[i] / size + limit / size * (trial_by_normal[i] - along * trial[i]);
            }
        } else {
            at.by_normal = trial_by_normal;
        }
        for i in 0..S {
            at.q[i] += normal * (shape.c[i] * pose.u[i] - pose.tilt[i]);
            at.by_normal[i] += shape.g[i];
        }
        at
    }

    /// Coefficient of friction; for N ≤ 0 that at N = 0, for recorders.
    pub fn coefficient(&self, normal: f64, speed: f64) -> Coefficient {
        if normal > 0.0 {
            return self.friction.coefficient(normal, speed);
        }
        let mu = self.friction.coefficient(0.0, speed).mu;
        Coefficient { mu: if mu.is_finite() { mu } else { 0.0 }, ..Coefficient::default() }
    }

    fn response_at<const S: usize>(&self, pose: &Pose<S>, shape: &Shape<S>, at: &AtNormal<S>, normal: f64) -> Slide<S> {
        let slides = at.slides();
        let n = if slides { at.trial.map(|t| t / at.size) } else { [0.0; S] };
        let k0 = shape.c.map(|c| self.k_init - normal * c);
        let contact = Contact { normal, speed: shape.speed, mu: at.friction.mu };
        let plastic = slides.then(|| std::array::from_fn(|i| pose.plastic[i] + (at.size - at.limit) / k0[i] * n[i]));
        let zero = [[0.0; S]; S];
        let mut s = Slide {
            q: at.q,
            plastic,
            contact,
            stiffness: zero,
            by_u: zero,
            by_rate: zero,
            by_tilt: zero,
            by_pressure: [0.0; S],
        };
        for i in 0..S {
            for j in 0..S {
                let same = f64::from(u8::from(i == j));
                // Across the direction of sliding the friction force rotates.
                let rotation = if slides { at.limit / at.size * (same - n[i] * n[j]) } else { same };
                s.stiffness[i][j] = rotation * k0[j] + same * normal * shape.c[i];
                s.by_u[i][j] = s.stiffness[i][j];
                if S == 2 {
                    // The displacement changes the radius in the other direction.
                    let (k, elastic) = (1 - j, pose.u[1 - j] - pose.plastic[1 - j]);
                    let rotation = if slides {
                        at.limit / at.size * (f64::from(u8::from(i == k)) - n[i] * n[k])
                    } else {
                        f64::from(u8::from(i == k))
                    };
                    let lifts = if i == k { pose.u[i] } else { 0.0 };
                    s.by_u[i][j] += normal * shape.dc[k] * (lifts - rotation * elastic);
                }
                s.by_tilt[i][j] = -same * normal;
                let by_speed_direction = if slides { normal * at.friction.by_speed * n[i] } else { 0.0 };
                s.by_u[i][j] += by_speed_direction * shape.speed_by_u[j];
                s.by_rate[i][j] = by_speed_direction * shape.speed_by_rate[j];
            }
        }
        s.follow_normal(pose, shape, at);
        s
    }
}

impl<const S: usize> Slide<S> {
    /// Adds the derivatives of the normal force, dN = (dP + dq·g + q·dg) / (1 - ∂q/∂N·g).
    fn follow_normal(&mut self, pose: &Pose<S>, shape: &Shape<S>, at: &AtNormal<S>) {
        if self.contact.normal <= 0.0 {
            return;
        }
        let share = 1.0 / (1.0 - dot(&at.by_normal, &shape.g));
        let column = |m: &[[f64; S]; S], j: usize| -> f64 { (0..S).map(|i| shape.g[i] * m[i][j]).sum() };
        for j in 0..S {
            let curvature_term = if S == 2 { at.q[1 - j] * pose.u[1 - j] * shape.dc[1 - j] } else { 0.0 };
            let by_u = share * (column(&self.by_u, j) + at.q[j] * shape.c[j] + curvature_term);
            let by_rate = share * column(&self.by_rate, j);
            let by_tilt = share * (column(&self.by_tilt, j) - at.q[j]);
            for i in 0..S {
                self.by_u[i][j] += at.by_normal[i] * by_u;
                self.by_rate[i][j] += at.by_normal[i] * by_rate;
                self.by_tilt[i][j] += at.by_normal[i] * by_tilt;
            }
        }
        self.by_pressure = at.by_normal.map(|q| q * share);
    }
}
