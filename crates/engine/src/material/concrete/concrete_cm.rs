//! Concrete of Chang and Mander (1994, NCEER-94-0006): Tsai's envelopes in compression and tension, and curves of
//! unloading, reloading and transition between them. The rules of the cycles have the numbers of that report, with gaps
//! closed as by Kolozvari, Orakcal and Wallace (2015, PEER 2015/12).

use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw, finite};

/// An envelope of Tsai's curve, straight from a strain on to zero stress.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TsaiEnvelope {
    /// Strength.
    pub strength: f64,
    /// Strain at the strength, of the same sign.
    pub strain: f64,
    /// Shape parameter.
    pub r: f64,
    /// Strain at which the straight line begins, over that at the strength.
    pub critical: f64,
}

/// Concrete with a memory of cracks: tension and compression shift each other's curves.
#[derive(Clone, Debug, PartialEq)]
pub struct ConcreteCm {
    /// Initial modulus.
    pub ec: f64,
    /// Envelope in compression, with negative strength and strain.
    pub compression: TsaiEnvelope,
    /// Envelope in tension.
    pub tension: TsaiEnvelope,
    /// Cracks close with a stiffness of their own.
    pub stiff_closure: bool,
    /// The envelopes alone, without memory.
    pub monotonic: bool,
}

/// A place on a curve: strain, stress, slope.
type Place = [f64; 3];

/// Smallest and largest factor of the power of a curve.
const FACTORS: [f64; 2] = [1e-300, 1e300];
/// Exponent of the closing stiffness over the strain of the crack.
const CLOSURE: f64 = 1.1;

crate::state_struct! {
    /// History of [`ConcreteCm`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// 1 towards tension, -1 towards compression, 0 for a virgin point.
        direction: f64,
        /// Number of the rule.
        rule: f64,
        /// Strain and stress at which the envelope in compression was left.
        low: [f64; 2],
        /// Strain and stress at which that in tension was left.
        high: [f64; 2],
        /// Strain and stress of the last reversal within a transition.
        turn: [f64; 2],
        /// Strain and stress of a reversal on the way out of compression.
        low_partial: [f64; 2],
        /// Strain and stress of a reversal on the way out of tension.
        high_partial: [f64; 2],
        /// Shift of the envelope in tension.
        shift: f64,
        /// Strain at which a transition towards tension ends.
        upper: f64,
        /// Strain at which a transition towards compression ends.
        lower: f64,
        /// Strain from which a gap closes.
        gap: f64,
    }
}

/// Ends of the curves that follow from a history.
struct Ends {
    /// Zero stress after compression, and the slope there.
    zero_low: [f64; 2],
    /// Secant modulus of unloading from compression.
    secant_low: f64,
    /// Reloading arrives at the strain where compression was left, and at its envelope.
    low: [Place; 2],
    /// Zero stress after tension, and the slope there.
    zero_high: [f64; 2],
    /// Reloading arrives at the strain where tension was left, and at its envelope.
    high: [Place; 2],
    /// Loss of stress in a cycle of compression, and strain after which its envelope is reached again.
    loss_low: [f64; 2],
    /// The same in tension.
    loss_high: [f64; 2],
}

/// Sequence of curves that a strain follows in one direction.
#[derive(Clone, Copy, PartialEq)]
enum Path {
    /// The envelope.
    Envelope,
    /// Unloading, reloading and return to the envelope.
    Full,
    /// Return after a reversal on the unloading curve.
    Partial,
    /// A transition, then one of the two before.
    Transition,
    /// Closure of a gap, or unloading into one.
    Gap,
    /// A transition to the closure of a gap.
    GapTransition,
    /// An open crack.
    Open,
}

/// A curve between two places with their slopes: f = fi + x (Ei + A xᴿ); a chord where there is no such curve.
struct Curve {
    from: Place,
    to: Place,
    power: [f64; 2],
}

impl Curve {
    fn new(from: Place, to: Place) -> Self {
        let secant = (to[1] - from[1]) / (to[0] - from[0]);
        let r = (to[2] - secant) / (secant - from[2]);
        let scale = (to[0] - from[0]).abs().powf(r);
        let a = if scale == 0.0 || scale.is_infinite() || secant == from[2] {
            FACTORS[0]
        } else {
            let a = (secant - from[2]) / scale;
            if a.is_infinite() { FACTORS[1] } else { a }
        };
        Self { from, to, power: [a, r] }
    }

    /// Stress and slope, and whether the chord is taken.
    fn at(&self, e: f64) -> (f64, f64, bool) {
        let ([esi, fi, ei], [esf, ff, ef], [a, r]) = (self.from, self.to, self.power);
        if esf == esi {
            return (fi, ef, false);
        }
        let secant = (ff - fi) / (esf - esi);
        let x = e - esi;
        let inverse = x.abs().powf(-r);
        let one_sided = (ei >= secant && ef >= secant) || (ei <= secant && ef <= secant);
        if a != FACTORS[1] && a != 0.0 && inverse != 0.0 && !inverse.is_infinite() && !one_sided {
            let grown = x.abs().powf(r);
            let slope = ei + a * (r + 1.0) * grown;
            if slope.is_finite() {
                return (fi + x * (ei + a * grown), slope, false);
            }
        }
        (fi + secant * x, secant, true)
    }

    /// A curve to a place on another curve. Its end is computed again on the curve itself.
    fn onto(from: Place, to: Place) -> Self {
        let mut curve = Self::new(from, to);
        let (f, slope, _) = curve.at(to[0]);
        curve.to = [to[0], f, slope];
        curve
    }
}

impl TsaiEnvelope {
    /// Stress over strength, and slope over modulus, on the curve.
    fn curve(&self, x: f64, n: f64) -> (f64, f64) {
        let r = self.r;
        let d = if r == 1.0 {
            if x == 0.0 { 1.0 } else { 1.0 + (n - 1.0 + x.log10()) * x }
        } else {
            1.0 + (n - r / (r - 1.0)) * x + x.powf(r) / (r - 1.0)
        };
        (n * x / d, (1.0 - x.powf(r)) / (d * d))
    }

    /// Stress and slope at a strain, and whether there is a stress at all.
    fn at(&self, e: f64, ec: f64) -> (f64, f64, bool) {
        let x = (e / self.strain).abs();
        let n = (ec * self.strain / self.strength).abs();
        let (y, z) = self.curve(self.critical, n);
        if x > (self.critical - y / (n * z)).abs() {
            return (0.0, 0.0, false);
        }
        if x < self.critical {
            let (y, z) = self.curve(x, n);
            // The slope of the formula for r = 1 holds beyond the critical strain only.
            let d = if self.r == 1.0 && x > 0.0 { n * x / y } else { 0.0 };
            let z = if d == 0.0 { z } else { (1.0 - x * std::f64::consts::LOG10_E) / (d * d) };
            return (self.strength * y, ec * z, true);
        }
        (self.strength * (y + n * z * (x - self.critical)), ec * z, true)
    }
}

impl ConcreteCm {
    /// Envelope in compression: stress, slope, rule.
    fn compressed(&self, e: f64) -> (f64, f64, f64) {
        let (f, slope, whole) = self.compression.at(e, self.ec);
        (f, slope, if whole { 1.0 } else { 5.0 })
    }

    /// Envelope in tension, shifted: stress, slope, rule.
    fn tensioned(&self, e: f64, shift: f64) -> (f64, f64, f64) {
        let (f, slope, whole) = self.tension.at(e - shift, self.ec);
        (f, slope, if whole { 2.0 } else { 6.0 })
    }

    /// Secant modulus of unloading from tension.
    fn secant_high(&self, shift: f64, [e, f]: [f64; 2], zero_low: f64) -> f64 {
        let et = self.tension.strain;
        let secant = self.ec * (((f / (self.ec * et)).abs() + 0.67) / (((e - shift) / et).abs() + 0.67));
        let least = (f / (e - zero_low).abs()).abs();
        if secant < least { least } else { secant }
    }

    /// Secant modulus, zero stress and its slope after compression.
    fn unloading_low(&self, [e, f]: [f64; 2]) -> (f64, f64, f64) {
        let epcc = self.compression.strain;
        let secant = self.ec * (((f / (self.ec * epcc)).abs() + 0.57) / ((e / epcc).abs() + 0.57));
        (secant, e - f / secant, 0.1 * self.ec * (-2.0 * (e / epcc).abs()).exp())
    }

    fn ends(&self, t: &History) -> Ends {
        let (epcc, et, ec) = (self.compression.strain, self.tension.strain, self.ec);
        let [e, f] = t.low;
        let (secant_low, zero, zero_slope) = self.unloading_low(t.low);
        let beyond = e / (1.15 + 2.75 * (e / epcc).abs());
        let loss = if e <= epcc / 10.0 { 0.09 * f * (e / epcc).abs().powf(0.5) } else { 0.0 };
        let slope = if e == zero { ec } else { ec.min((f - loss) / (e - zero)) };
        let back = self.compressed(e + beyond);
        let low = [[e, f - loss, slope], [e + beyond, back.0, back.1]];
        let (zero_low, loss_low) = ([zero, zero_slope], [loss, beyond]);

        let [e, f] = t.high;
        let zero = e - f / self.secant_high(t.shift, t.high, zero_low[0]);
        let beyond = 0.22 * (e - t.shift).abs();
        let loss = if e >= t.shift + et / 2.0 { 0.15 * f } else { 0.0 };
        let slope = if e == zero { ec } else { ec.min((f - loss) / (e - zero)) };
        let back = self.tensioned(e + beyond, t.shift);
        let high = [[e, f - loss, slope], [e + beyond, back.0, back.1]];
        let closing = if self.stiff_closure { ec / (((e - t.shift) / et).abs().powf(CLOSURE) + 1.0) } else { 0.0 };
        Ends { zero_low, secant_low, low, zero_high: [zero, closing], high, loss_low, loss_high: [loss, beyond] }
    }

    /// Return to an envelope after a reversal on the unloading curve from there: the place where the envelope was
    /// left, and that on the envelope.
    fn partial(&self, t: &History, ends: &Ends, up: bool) -> [Place; 2] {
        let ([e, f], [e0, f0], [loss, beyond], zero) = if up {
            (t.high, t.high_partial, ends.loss_high, ends.zero_high[0])
        } else {
            (t.low, t.low_partial, ends.loss_low, ends.zero_low[0])
        };
        let share = (e - e0) / (e - zero);
        let reached = f - loss * share;
        let end = e + beyond * (e - e0) / (e - zero);
        let back = if up { self.tensioned(end, t.shift) } else { self.compressed(end) };
        [[e, reached, (reached - f0) / (e - e0)], [end, back.0, back.1]]
    }

    /// Closure of cracks and gaps, rules 10 and 13: without a curve the gap stays open to the end of compression.
    fn closing(&self, curve: &Curve, ends: &Ends, e: f64) -> (f64, f64) {
        match curve.at(e) {
            (_, _, true) if e >= ends.zero_low[0] => (0.0, 0.0),
            (_, _, true) => (ends.low[0][2] * (e - ends.zero_low[0]), ends.low[0][2]),
            (f, slope, false) => (f, slope),
        }
    }

    /// Stress, slope and rule at a strain on a path towards compression.
    fn down(&self, t: &History, ends: &Ends, path: Path, e: f64) -> (f64, f64, f64) {
        let with_rule = |curve: Curve, rule: f64| {
            let (f, slope, _) = curve.at(e);
            (f, slope, rule)
        };
        let start = [t.turn[0], t.turn[1], self.ec];
        match path {
            Path::Transition => {
                let rest = if t.upper == t.low_partial[0] { Path::Partial } else { Path::Full };
                if e < t.lower {
                    return self.down(t, ends, rest, e);
                }
                let (f, slope, _) = self.down(t, ends, rest, t.lower);
                with_rule(Curve::onto(start, [t.lower, f, slope]), 11.0)
            }
            Path::Partial => {
                let [left, back] = self.partial(t, ends, false);
                match e {
                    e if e <= back[0] => self.compressed(e),
                    e if e < left[0] => with_rule(Curve::new(left, back), 77.0),
                    _ => with_rule(Curve::new([t.low_partial[0], t.low_partial[1], self.ec], left), 77.0),
                }
            }
            Path::GapTransition => {
                if e < t.upper {
                    return self.down(t, ends, Path::Gap, e);
                }
                let curve = Curve::new([t.gap, 0.0, 0.0], ends.low[0]);
                let (f, slope) = match curve.at(t.upper) {
                    (_, _, true) if t.upper >= ends.zero_low[0] => (0.0, 0.0),
                    (_, secant, true) => (secant * (t.upper - ends.zero_low[0]), ends.low[0][2]),
                    (f, slope, false) => (f, slope),
                };
                with_rule(Curve::onto(start, [t.upper, f, slope]), 15.0)
            }
            Path::Full if e >= ends.zero_high[0] => {
                let zero = [ends.zero_high[0], 0.0, ends.zero_high[1]];
                with_rule(Curve::new([t.high[0], t.high[1], self.ec], zero), 4.0)
            }
            Path::Full | Path::Gap if e >= t.low[0] => {
                let (from, rule) = if path == Path::Full {
                    ([ends.zero_high[0], 0.0, ends.zero_high[1]], 10.0)
                } else {
                    ([t.gap, 0.0, 0.0], 13.0)
                };
                let (f, slope) = self.closing(&Curve::new(from, ends.low[0]), ends, e);
                (f, slope, rule)
            }
            Path::Full | Path::Gap if e >= ends.low[1][0] => with_rule(Curve::new(ends.low[0], ends.low[1]), 7.0),
            _ => self.compressed(e),
        }
    }

    /// Stress, slope and rule at a strain on a path towards tension.
    fn up(&self, t: &History, ends: &Ends, path: Path, e: f64) -> (f64, f64, f64) {
        let with_rule = |curve: Curve, rule: f64| {
            let (f, slope, _) = curve.at(e);
            (f, slope, rule)
        };
        let start = [t.turn[0], t.turn[1], self.ec];
        let zero = [ends.zero_low[0], 0.0, ends.zero_low[1]];
        match path {
            Path::Transition => {
                let rest = if t.lower == t.high_partial[0] { Path::Partial } else { Path::Full };
                if e > t.upper {
                    return self.up(t, ends, rest, e);
                }
                let (f, slope, _) = self.up(t, ends, rest, t.upper);
                with_rule(Curve::onto(start, [t.upper, f, slope]), 12.0)
            }
            Path::Partial => {
                let [left, back] = self.partial(t, ends, true);
                match e {
                    e if e >= back[0] => self.tensioned(e, t.shift),
                    e if e > left[0] => with_rule(Curve::new(left, back), 88.0),
                    _ => with_rule(Curve::new([t.high_partial[0], t.high_partial[1], self.ec], left), 88.0),
                }
            }
            Path::Gap if e <= t.lower => with_rule(Curve::new(start, [t.lower, 0.0, 0.0]), 14.0),
            Path::Gap if e < t.high[0] => (0.0, 0.0, 66.0),
            Path::Gap | Path::Open => (0.0, 0.0, 6.0),
            Path::Full if e <= zero[0] => with_rule(Curve::new([t.low[0], t.low[1], self.ec], zero), 3.0),
            Path::Full if e <= t.high[0] => with_rule(Curve::new(zero, ends.high[0]), 9.0),
            Path::Full if e <= ends.high[1][0] => with_rule(Curve::new(ends.high[0], ends.high[1]), 8.0),
            _ => self.tensioned(e, t.shift),
        }
    }

    /// Shifts the envelope in tension after compression has left its own at `t.low`.
    fn shift_tension(&self, t: &mut History) {
        let et = self.tension.strain;
        let compressed = (t.low[0] / self.compression.strain).abs();
        let mut x = ((t.high[0] - t.shift) / et).abs();
        let (mut shift, mut high) = (t.shift, t.high);
        if x < compressed {
            x = compressed;
            (shift, high) = (0.0, [x * et, self.tensioned(x * et, 0.0).0]);
        }
        let (_, zero, slope) = self.unloading_low(t.low);
        let secant = self.secant_high(shift, high, zero);
        t.shift = zero + 2.0 * high[1] / (secant + slope) - x * et;
        t.high[0] = x * et + t.shift;
        t.high[1] = self.tensioned(t.high[0], t.shift).0;
    }

    /// Begins a path towards tension at the committed state.
    fn turn_up(&self, c: &History, t: &mut History) -> Path {
        let here = [c.strain, c.stress];
        match c.rule as u32 {
            4 => {
                (t.high_partial, t.lower) = (here, c.strain);
                Path::Partial
            }
            10 => {
                let ends = self.ends(t);
                (t.turn, t.lower) = (here, c.strain);
                let (zero_low, zero_high) = (ends.zero_low[0], ends.zero_high[0]);
                t.upper = zero_low + ((t.low[0] - t.lower) / (t.low[0] - zero_high)) * (t.high[0] - zero_low);
                Path::Transition
            }
            11 => {
                t.turn = here;
                Path::Transition
            }
            77 if c.strain >= t.low[0] => {
                (t.turn, t.lower, t.upper) = (here, c.strain, t.low_partial[0]);
                Path::Transition
            }
            13 => {
                (t.turn, t.upper) = (here, c.strain);
                t.lower = c.strain - c.stress / self.ends(t).secant_low;
                Path::Gap
            }
            15 => {
                t.turn = here;
                Path::Gap
            }
            _ => {
                t.low = here;
                self.shift_tension(t);
                Path::Full
            }
        }
    }

    /// Begins a path towards compression at the committed state.
    fn turn_down(&self, c: &History, t: &mut History) -> Path {
        let here = [c.strain, c.stress];
        if c.stress == 0.0 {
            (t.high, t.turn, t.gap) = (here, here, c.strain);
            t.low[1] = self.compressed(t.low[0]).0;
            return Path::Gap;
        }
        match c.rule as u32 {
            3 => {
                (t.low_partial, t.upper) = (here, c.strain);
                Path::Partial
            }
            9 => {
                let ends = self.ends(t);
                (t.turn, t.upper) = (here, c.strain);
                let (zero_low, zero_high) = (ends.zero_low[0], ends.zero_high[0]);
                t.lower = t.low[0] - ((t.upper - zero_low) / (t.high[0] - zero_low)) * (t.low[0] - zero_high);
                Path::Transition
            }
            12 => {
                t.turn = here;
                Path::Transition
            }
            88 if c.strain <= t.high[0] => {
                (t.turn, t.upper, t.lower) = (here, c.strain, t.high_partial[0]);
                Path::Transition
            }
            14 => {
                t.turn = here;
                Path::GapTransition
            }
            _ => {
                t.high = [c.strain, self.tensioned(c.strain, t.shift).0];
                Path::Full
            }
        }
    }

    /// The path of a rule.
    fn path(rule: f64) -> Path {
        match rule as u32 {
            1 | 2 | 5 => Path::Envelope,
            6 => Path::Open,
            77 | 88 => Path::Partial,
            11 | 12 => Path::Transition,
            13 | 14 | 66 => Path::Gap,
            15 => Path::GapTransition,
            _ => Path::Full,
        }
    }
}

impl UniaxialLaw for ConcreteCm {
    type State = History;
    const NAME: &'static str = "ConcreteCM";

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        let e = strain.value;
        let mut t = History { strain: e, ..*c };
        let (stress, tangent, rule) = if self.monotonic || c.direction == 0.0 {
            t = History { strain: e, direction: if e == 0.0 { 0.0 } else { e.signum() }, ..History::default() };
            match e {
                0.0 => (0.0, self.ec, 0.0),
                e if e < 0.0 => self.compressed(e),
                e => self.tensioned(e, 0.0),
            }
        } else {
            if e != c.strain {
                t.direction = (e - c.strain).signum();
            }
            let path = match (t.direction == c.direction, t.direction > 0.0) {
                (true, _) => Self::path(c.rule),
                (false, true) => self.turn_up(c, &mut t),
                (false, false) => self.turn_down(c, &mut t),
            };
            let ends = self.ends(&t);
            if t.direction > 0.0 { self.up(&t, &ends, path, e) } else { self.down(&t, &ends, path, e) }
        };
        (t.stress, t.rule) = (stress, rule);
        finite(Self::NAME, e, stress, tangent, t)
    }

    fn initial_tangent(&self) -> f64 {
        self.ec
    }
}
