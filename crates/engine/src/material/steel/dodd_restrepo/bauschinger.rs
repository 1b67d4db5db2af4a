//! Bauschinger curve: a power of the normalised strain, turned between two slopes.

/// Iterations of the root, of which halving needs 60 at most.
const MAX_ITERATIONS: usize = 100;
/// Normalised strain above which the strain is the unknown, and not its power.
const SMALL_STRAIN: f64 = 0.02;
/// Final slope divided by the mean slope of the curve, at most.
const MAX_SLOPE_RATIO: f64 = 0.8;

/// A curve between two points (natural strain, true stress).
pub(in crate::material) struct Bauschinger {
    pub(in crate::material) from: [f64; 2],
    pub(in crate::material) to: [f64; 2],
    /// Slopes at its ends.
    pub(in crate::material) slopes: [f64; 2],
    /// Exponent.
    pub(in crate::material) power: f64,
}

/// Coefficients of the equation of the normalised strain `x`: (1 - (1 - x)²)^P = c1 x + c2.
struct Equation {
    c1: f64,
    c2: f64,
    power: f64,
}

impl Equation {
    fn residual(&self, x: f64) -> f64 {
        (x * (2.0 - x)).powf(self.power) - self.c1 * x - self.c2
    }

    fn slope(&self, x: f64) -> f64 {
        if x > 1.0 {
            return -self.c1;
        }
        2.0 * self.power * (x * (2.0 - x)).powf(self.power - 1.0) * (1.0 - x) - self.c1
    }

    /// The root. From 0 to 1 the unknown is the power at first, in which the equation is nearly straight at its start.
    fn root(&self) -> f64 {
        if self.c1 + self.c2 > 1.0 {
            // Beyond its end a curve is straight.
            return (1.0 - self.c2) / self.c1;
        }
        let strain = |w: f64| {
            let y = w.powf(1.0 / self.power);
            y / (1.0 + (1.0 - y).max(0.0).sqrt())
        };
        let (mut low, mut high, mut w) = (0.0, 1.0, self.c2.clamp(0.0, 1.0));
        for _ in 0..MAX_ITERATIONS {
            let x = strain(w);
            let f = w - self.c1 * x - self.c2;
            if f > 0.0 {
                high = w
            } else {
                low = w
            }
            let rate = w.powf(1.0 / self.power - 1.0) / (2.0 * self.power * (1.0 - x));
            let mut next = w - f / (1.0 - self.c1 * rate);
            if !(next > low && next < high) {
                next = 0.5 * (low + high);
            }
            let done = (next - w).abs() <= f64::EPSILON * w || high - low <= f64::EPSILON * high;
            w = next;
            if done {
                break;
            }
        }
        let mut x = strain(w);
        if x > SMALL_STRAIN {
            for _ in 0..3 {
                x = (x - self.residual(x) / self.slope(x)).clamp(0.0, 1.0);
            }
        }
        x
    }

    /// The root after the few rounds of OpenSees, which end at a residual of 0.001.
    fn opensees_root(&self, first: f64) -> f64 {
        let mut x = first;
        for _ in 0..10 {
            let f = self.residual(x);
            let next = x - f / self.slope(x);
            if next.is_nan() || next <= SMALL_STRAIN {
                return self.secants(x);
            }
            x = next;
            if f.abs() <= 0.001 {
                break;
            }
        }
        x
    }

    /// Ten rounds of the false position between zero and a strain.
    fn secants(&self, x: f64) -> f64 {
        let (mut low, mut high) = ([0.0, -self.c2], [x, self.residual(x)]);
        let mut x = x;
        for _ in 0..10 {
            x = (low[0] - low[1] * (high[0] - low[0]) / (high[1] - low[1])).max(0.0);
            let f = self.residual(x);
            if f > 0.0 { high = [x, f] } else { low = [x, f] }
        }
        x
    }
}

impl Bauschinger {
    /// Slope at the end, bounded by the mean slope.
    pub(super) fn final_slope(&self) -> f64 {
        let mean = (self.to[1] - self.from[1]) / (self.to[0] - self.from[0]);
        self.slopes[1].min(MAX_SLOPE_RATIO * mean)
    }

    /// Stress and slope, with a final slope.
    pub(in crate::material) fn between(&self, e: f64, last: f64) -> (f64, f64) {
        let first = self.slopes[0];
        let (epu, fpu, along) = (self.to[0] - self.from[0], self.to[1] - self.from[1], e - self.from[0]);
        let (n, d) = (fpu - epu * first, fpu - epu * last);
        let equation = Equation { c1: n / d, c2: along * (first - last) / d, power: self.power };
        let x = equation.root();
        (x * n + along * first + self.from[1], first + n * (first - last) / d / equation.slope(x))
    }

    /// Stress and slope with the bounded final slope; `moving` is the rate of the end's stress with the strain.
    pub(super) fn at(&self, e: f64, moving: f64) -> (f64, f64) {
        let (first, last) = (self.slopes[0], self.final_slope());
        let (stress, mut slope) = self.between(e, last);
        if moving != 0.0 {
            let (epu, fpu, along) = (self.to[0] - self.from[0], self.to[1] - self.from[1], e - self.from[0]);
            let (n, d) = (fpu - epu * first, fpu - epu * last);
            let equation = Equation { c1: n / d, c2: along * (first - last) / d, power: self.power };
            let x = equation.root();
            let steeper = if last < self.slopes[1] { MAX_SLOPE_RATIO / epu } else { 0.0 };
            let wider = 1.0 - epu * steeper;
            let c1 = (d - n * wider) / (d * d);
            let c2 = along * (-steeper * d - (first - last) * wider) / (d * d);
            slope += moving * (x + n / equation.slope(x) * (c1 * x + c2));
        }
        (stress, slope)
    }

    /// Stress and slope of OpenSees.
    pub(super) fn opensees(&self, e: f64) -> (f64, f64) {
        let (first, last) = (self.slopes[0], self.final_slope());
        let (epu, fpu, along) = (self.to[0] - self.from[0], self.to[1] - self.from[1], e - self.from[0]);
        let (n, d) = (fpu - epu * first, fpu - epu * last);
        let equation = Equation { c1: n / d, c2: along * (first - last) / d, power: self.power };
        let x = equation.opensees_root(along / epu);
        let stress = x * n + along * first + self.from[1];
        if x < 0.0001 || (first - last) / first < 0.01 {
            return (stress, first);
        }
        let bend = 2.0 * self.power * (x * (2.0 - x)).powf(self.power - 1.0) * (1.0 - x);
        let turned = bend * d / (-n / (first - last));
        (stress, turned * first / (turned + first) + last)
    }
}
