//! Self-heating: temperature of the rubber under dissipated work.
//!
//! Heat conduction through the height of a bearing is a linear system: C θ' + G θ = s D'. The temperature above the
//! surroundings is θ, the dissipated power per volume of rubber D'. Its eigenvectors decouple the system into scalar
//! equations. Their solution is exact for constant power, so that every step size is stable. Lumped rubber that loses
//! heat is one such equation.

use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// One eigenvector of heat flow, scaled so that its amplitude is its contribution to the mean temperature of the
/// rubber.
#[derive(Clone, Debug, PartialEq)]
struct Mode {
    /// Decay rate λ, 1/time.
    rate: f64,
    /// Rise of the amplitude per dissipated work per volume of rubber.
    rise: f64,
    /// Heat content per amplitude and per volume of rubber.
    content: f64,
    /// Temperature of each cell of the mesh per amplitude.
    shape: Vec<f64>,
}

impl Mode {
    /// Amplitude after `time`, and its derivative with respect to the heat; arguments as in [`Thermal::after`].
    fn after(&self, amplitude: f64, heat: f64, centre: f64, time: f64) -> (f64, f64) {
        let half = centre.min(time - centre).max(0.0);
        let wait = self.rate * (time - centre - half).max(0.0);
        let share = self.rise * (-wait).exp() * average_decay(2.0 * half * self.rate);
        (amplitude * (-self.rate * time).exp() + share * heat, share)
    }
}

/// Heating of the rubber by dissipated work, and its cooling.
#[derive(Clone, Debug, PartialEq)]
pub struct Thermal {
    modes: Vec<Mode>,
    cells: usize,
}

/// Layers of a laminated bearing between its end plates; lengths, conductivities and heat capacities in consistent
/// units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stack {
    /// Number of layers of rubber.
    pub layers: usize,
    /// Thickness of a layer of rubber.
    pub rubber: f64,
    /// Thickness of a steel plate between two layers.
    pub steel: f64,
    /// Thickness of each end plate.
    pub plate: f64,
    /// Thermal conductivity and heat capacity per volume of rubber.
    pub rubber_properties: (f64, f64),
    /// Thermal conductivity and heat capacity per volume of steel.
    pub steel_properties: (f64, f64),
    /// Heat transfer coefficient of an end plate: heat per area, time and temperature difference.
    pub film: f64,
}

/// Number of cells of a rubber layer and of an end plate.
const CELLS: (usize, usize) = (4, 2);

/// Smallest share of a mode in the heating; smaller shares are round-off.
const MIN_MODE_SHARE: f64 = 1e-12;

impl Thermal {
    /// Uniform temperature of the rubber, from the heat capacity per volume of rubber and the time constant of
    /// cooling.
    pub fn lumped(capacity: f64, cooling_time: f64) -> Self {
        let mode = Mode { rate: 1.0 / cooling_time, rise: 1.0 / capacity, content: capacity, shape: vec![1.0] };
        Self { modes: vec![mode], cells: 1 }
    }

    /// One-dimensional conduction through the height of a bearing.
    pub fn stack(s: &Stack) -> Self {
        // Thickness, conductivity, heat capacity, and true for a heat source.
        let mut cells: Vec<(f64, f64, f64, bool)> = vec![];
        let ((rubber, plate), (k_r, c_r), (k_s, c_s)) = (CELLS, s.rubber_properties, s.steel_properties);
        let end =
            || std::iter::repeat_n((s.plate / plate as f64, k_s, c_s, false), if s.plate > 0.0 { plate } else { 0 });
        cells.extend(end());
        for layer in 0..s.layers {
            if layer > 0 && s.steel > 0.0 {
                cells.push((s.steel, k_s, c_s, false));
            }
            cells.extend(std::iter::repeat_n((s.rubber / rubber as f64, k_r, c_r, true), rubber));
        }
        cells.extend(end());
        let n = cells.len();
        let capacity: Vec<f64> = cells.iter().map(|(t, _, c, _)| t * c).collect();
        let source: Vec<f64> = cells.iter().map(|(t, _, _, hot)| if *hot { *t } else { 0.0 }).collect();
        let height: f64 = source.iter().sum();
        let half = |(t, k, _, _): (f64, f64, f64, bool)| 0.5 * t / k;
        let mut g = DMatrix::<f64>::zeros(n, n);
        for i in 1..n {
            let flow = 1.0 / (half(cells[i - 1]) + half(cells[i]));
            g[(i, i)] += flow;
            g[(i - 1, i - 1)] += flow;
            g[(i, i - 1)] -= flow;
            g[(i - 1, i)] -= flow;
        }
        if s.film > 0.0 {
            for i in [0, n - 1] {
                g[(i, i)] += 1.0 / (1.0 / s.film + half(cells[i]));
            }
        }
        let root = DVector::from_iterator(n, capacity.iter().map(|c| c.sqrt()));
        let scaled = DMatrix::from_fn(n, n, |i, j| g[(i, j)] / (root[i] * root[j]));
        let eigen = SymmetricEigen::new(scaled);
        let mut modes = vec![];
        for (k, &rate) in eigen.eigenvalues.iter().enumerate() {
            let rate: f64 = rate;
            let v = eigen.eigenvectors.column(k);
            let gain: f64 = (0..n).map(|i| v[i] / root[i] * source[i]).sum();
            let rise = gain * gain / height;
            // Half of the modes are antisymmetric about mid-height and are never heated.
            if rise * c_r > MIN_MODE_SHARE {
                let shape: Vec<f64> = (0..n).map(|i| v[i] / root[i] * height / gain).collect();
                let content = shape.iter().zip(&capacity).map(|(x, c)| x * c).sum::<f64>() / height;
                modes.push(Mode { rate: rate.max(0.0), rise, content, shape });
            }
        }
        Self { modes, cells: n }
    }

    /// Number of state variables: one amplitude per mode.
    pub(super) fn len(&self) -> usize {
        self.modes.len()
    }

    /// Number of cells of the mesh.
    pub(super) fn cells(&self) -> usize {
        self.cells
    }

    /// Mean temperature rise of the rubber after `time`, its derivative with respect to the heat, and the remaining
    /// fraction of the present rise. Heat is generated uniformly in the longest interval centred at `centre`.
    pub(super) fn after(&self, amplitudes: &[f64], heat: f64, centre: f64, time: f64) -> (f64, f64, f64) {
        let (mut mean, mut slope, mut left, mut whole) = (0.0, 0.0, 0.0, 0.0);
        for (a, m) in amplitudes.iter().zip(&self.modes) {
            let (end, share) = m.after(*a, heat, centre, time);
            mean += end;
            slope += share;
            left += m.rise * (-m.rate * time).exp();
            whole += m.rise;
        }
        (mean, slope, left / whole)
    }

    /// Advances the amplitudes by `time`; arguments as in [`Thermal::after`].
    pub(super) fn advance(&self, amplitudes: &mut [f64], heat: f64, centre: f64, time: f64) {
        amplitudes.iter_mut().zip(&self.modes).for_each(|(a, m)| *a = m.after(*a, heat, centre, time).0);
    }

    /// Heat in the bearing, steel included, per volume of rubber.
    pub(super) fn content(&self, amplitudes: &[f64]) -> f64 {
        amplitudes.iter().zip(&self.modes).map(|(a, m)| a * m.content).sum()
    }

    /// Temperature above the surroundings in a cell of the mesh.
    pub(super) fn layer(&self, amplitudes: &[f64], cell: usize) -> f64 {
        amplitudes.iter().zip(&self.modes).map(|(a, m)| a * m.shape[cell]).sum()
    }
}

/// (1 - exp(-z)) / z
fn average_decay(z: f64) -> f64 {
    if z < 1e-8 { 1.0 - 0.5 * z } else { -(-z).exp_m1() / z }
}
