//! Ground motions: files, integration, intensity.
//!
//! Accelerations are in m/s², times in s, directions in degrees clockwise from north.

mod entry;
mod intensity;
mod read;

pub(crate) use entry::MotionEntry;
pub use intensity::{Baseline, Intensity};
pub use read::{ReadMotions, ReadOptions, read};

/// Standard acceleration of gravity in m/s².
pub const G: f64 = 9.80665;

/// A horizontal or vertical component at equal steps of time.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// Name: that of the file, with the channel if the file has several.
    pub name: String,
    /// Text of the header, empty without one.
    pub title: String,
    /// Direction of positive accelerations in degrees clockwise from north, where the file gives it.
    pub azimuth: Option<f64>,
    /// Step of time in s.
    pub dt: f64,
    /// Accelerations in m/s².
    pub acceleration: Vec<f64>,
}

impl Motion {
    /// Largest absolute acceleration in m/s².
    pub fn peak(&self) -> f64 {
        largest(&self.acceleration)
    }

    /// Velocities in m/s and displacements in m, from rest. The acceleration is linear between samples.
    pub fn integrated(&self) -> (Vec<f64>, Vec<f64>) {
        let h = self.dt;
        let (mut v, mut u) = (0.0, 0.0);
        let (mut velocities, mut displacements) = (vec![0.0], vec![0.0]);
        for a in self.acceleration.windows(2) {
            u += h * v + h * h * (2.0 * a[0] + a[1]) / 6.0;
            v += 0.5 * h * (a[0] + a[1]);
            velocities.push(v);
            displacements.push(u);
        }
        (velocities, displacements)
    }

    /// The motion with accelerations multiplied by a factor.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self { acceleration: self.acceleration.iter().map(|a| factor * a).collect(), ..self.clone() }
    }
}

/// Two perpendicular horizontal components of the same length.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// The components.
    pub components: [Motion; 2],
    /// The vertical component, with the same step; none if there is none.
    pub vertical: Option<Motion>,
}

impl Pair {
    /// A pair of components with the same step. The shorter one is continued with zeros.
    ///
    /// # Errors
    /// The steps of time differ, or the azimuths are known and not perpendicular.
    pub fn new(mut first: Motion, mut second: Motion) -> Result<Self, String> {
        if (first.dt - second.dt).abs() > 1e-9 * first.dt {
            let (a, b) = (first.dt, second.dt);
            return Err(format!("{} has steps of {a} s, {} of {b} s: expected the same", first.name, second.name));
        }
        if let (Some(a), Some(b)) = (first.azimuth, second.azimuth) {
            let between = (a - b).rem_euclid(180.0);
            if (between - 90.0).abs() > 1.0 {
                let message = format!("{} is at {a}°, {} at {b}°", first.name, second.name);
                return Err(format!("{message}: expected perpendicular components"));
            }
        }
        let n = first.acceleration.len().max(second.acceleration.len());
        first.acceleration.resize(n, 0.0);
        second.acceleration.resize(n, 0.0);
        Ok(Self { components: [first, second], vertical: None })
    }

    /// The pair with a vertical component, which is cut or continued with zeros.
    ///
    /// # Errors
    /// Its step of time differs.
    pub fn with_vertical(mut self, mut vertical: Motion) -> Result<Self, String> {
        let (a, b) = (self.components[0].dt, vertical.dt);
        if (a - b).abs() > 1e-9 * a {
            return Err(format!("{} has steps of {b} s: expected {a} s as of its pair", vertical.name));
        }
        vertical.acceleration.resize(self.components[0].acceleration.len(), 0.0);
        self.vertical = Some(vertical);
        Ok(self)
    }

    /// Name of the pair: its first component, and its second.
    pub fn name(&self) -> String {
        format!("{} + {}", self.components[0].name, self.components[1].name)
    }

    /// The motion along a direction at an angle in degrees from the first component towards the second.
    pub fn at_angle(&self, angle: f64) -> Motion {
        let (s, c) = angle.to_radians().sin_cos();
        let [x, y] = &self.components;
        let both = x.acceleration.iter().zip(&y.acceleration);
        Motion { acceleration: both.map(|(x, y)| c * x + s * y).collect(), ..x.clone() }
    }

    /// The pair turned to an azimuth in degrees and the direction 90 degrees clockwise from it.
    ///
    /// # Errors
    /// The azimuth of a component is not known.
    pub fn turned_to(&self, azimuth: f64) -> Result<Self, String> {
        let [x, y] = &self.components;
        let (Some(a), Some(b)) = (x.azimuth, y.azimuth) else {
            return Err(format!("the azimuths of {} are not known", self.name()));
        };
        // Towards the second component angles are counted clockwise or not.
        let clockwise = if (b - a).rem_euclid(360.0) < 180.0 { 1.0 } else { -1.0 };
        let along = |azimuth: f64| {
            let m = self.at_angle(clockwise * (azimuth - a));
            Motion { azimuth: Some(azimuth.rem_euclid(360.0)), ..m }
        };
        let [mut first, mut second] = [along(azimuth), along(azimuth + 90.0)];
        first.name = format!("{} at {}°", x.name, azimuth.rem_euclid(360.0));
        second.name = format!("{} at {}°", x.name, (azimuth + 90.0).rem_euclid(360.0));
        Ok(Self { components: [first, second], vertical: self.vertical.clone() })
    }

    /// Fault-normal and fault-parallel components for a strike in degrees clockwise from north.
    ///
    /// # Errors
    /// The azimuth of a component is not known.
    pub fn fault_components(&self, strike: f64) -> Result<Self, String> {
        let mut pair = self.turned_to(strike - 90.0)?;
        let name = self.components[0].name.clone();
        pair.components[0].name = format!("{name} fault-normal");
        pair.components[1].name = format!("{name} fault-parallel");
        Ok(pair)
    }
}

/// Largest absolute value.
pub(crate) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m, x| m.max(x.abs()))
}

#[cfg(test)]
mod tests {
    use super::{Motion, Pair};

    fn motion(azimuth: f64, acceleration: Vec<f64>) -> Motion {
        Motion { name: "m".into(), title: String::new(), azimuth: Some(azimuth), dt: 0.1, acceleration }
    }

    #[test]
    fn turned_components_keep_the_vector() {
        // 1 to the north and 2 to the east, in both orders and with a reversed component.
        let north_east = [
            (motion(0.0, vec![1.0]), motion(90.0, vec![2.0])),
            (motion(90.0, vec![2.0]), motion(0.0, vec![1.0])),
            (motion(180.0, vec![-1.0]), motion(90.0, vec![2.0])),
            (motion(270.0, vec![-2.0]), motion(180.0, vec![-1.0])),
        ];
        for (a, b) in north_east {
            let turned = Pair::new(a, b).expect("a pair").turned_to(30.0).expect("azimuths").components;
            let (s, c) = 30.0f64.to_radians().sin_cos();
            assert!((turned[0].acceleration[0] - (c + 2.0 * s)).abs() < 1e-12);
            assert!((turned[1].acceleration[0] - (2.0 * c - s)).abs() < 1e-12);
        }
        assert!(Pair::new(motion(0.0, vec![1.0]), motion(40.0, vec![1.0])).is_err());
    }

    #[test]
    fn a_constant_acceleration_is_integrated_exactly() {
        let (v, u) = motion(0.0, vec![2.0; 11]).integrated();
        assert!((v[10] - 2.0).abs() < 1e-12 && (u[10] - 1.0).abs() < 1e-12);
    }
}
