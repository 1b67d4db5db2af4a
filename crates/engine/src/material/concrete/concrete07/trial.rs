//! Branches of unloading and reloading, with the numbers of Chang and Mander.

use super::{Concrete07, Curve, History};
use rule::*;

/// Branches, with the numbers of Chang and Mander.
mod rule {
    pub(super) const COMPRESSION: f64 = 1.0;
    pub(super) const TENSION: f64 = 2.0;
    pub(super) const UNLOADS_COMPRESSION: f64 = 3.0;
    pub(super) const UNLOADS_TENSION: f64 = 4.0;
    pub(super) const SPALLED: f64 = 5.0;
    pub(super) const OPEN: f64 = 6.0;
    pub(super) const TO_TENSION: f64 = 9.0;
    pub(super) const TO_COMPRESSION: f64 = 10.0;
    pub(super) const PARTLY_TO_COMPRESSION: f64 = 11.0;
    pub(super) const PARTLY_TO_TENSION: f64 = 12.0;
    pub(super) const CLOSES: f64 = 13.0;
    pub(super) const OPENS: f64 = 14.0;
    pub(super) const RETURNS_TO_CLOSING: f64 = 15.0;
    pub(super) const RELOADS_COMPRESSION: f64 = 71.0;
    pub(super) const LEAVES_RELOADING_COMPRESSION: f64 = 711.0;
    pub(super) const RELOADS_TENSION: f64 = 81.0;
    pub(super) const LEAVES_RELOADING_TENSION: f64 = 811.0;
}
/// Least strain of concrete that was never compressed.
const FIRST_STRAIN: f64 = -0.00002;
/// The same when a crack closes, divided by the strain of the strength.
const FIRST_CLOSING: f64 = 0.05;
/// Largest exponent of the closing curve; beyond it three lines stand for it.
const MAX_EXPONENT: f64 = 100.0;
/// Largest factor of the closing curve.
const MAX_FACTOR: f64 = 1e300;

/// Three lines from `from` to `to` (strain, stress, slope) at a strain.
fn transition(from: [f64; 3], to: [f64; 3], x: f64) -> Curve {
    let ([ei, fi, ki], [ef, ff, kf]) = (from, to);
    let meeting = (ki * ei - kf * ef - fi + ff) / (ki - kf);
    let forward = ei < ef;
    if if forward { meeting >= ef } else { ef >= meeting } {
        let slope = ((ff - fi) / (ef - ei)).abs();
        return (slope * (x - ei) + fi, slope);
    }
    let (a, b) = (0.5 * (meeting + ei), 0.5 * (ef + meeting));
    let (fa, fb) = (ki * (a - ei) + fi, kf * (b - ef) + ff);
    let before = |end: f64| if forward { x <= end } else { x >= end };
    if before(a) {
        (ki * (x - ei) + fi, ki)
    } else if before(b) {
        let slope = (fb - fa) / (b - a);
        (slope * (x - a) + fa, slope)
    } else {
        (kf * (x - ef) + ff, kf)
    }
}

/// The line between two points (strain, stress) at a strain.
fn line(from: [f64; 2], to: [f64; 2], x: f64) -> Curve {
    let slope = (to[1] - from[1]) / (to[0] - from[0]);
    (slope * (x - from[0]) + from[1], slope)
}

/// A trial state on its way.
pub(super) struct Trial<'a> {
    pub(super) law: &'a Concrete07,
    pub(super) committed: &'a History,
    pub(super) next: History,
    /// Trial strain.
    pub(super) e: f64,
    /// Points of unloading in compression and in tension.
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
    /// Strains of zero stress after unloading from compression and from tension.
    pub(super) plastic: [f64; 2],
    /// Secant modulus of unloading from compression.
    pub(super) secant: f64,
}

impl Trial<'_> {
    fn set(&mut self, rule: f64, curve: Curve) -> Curve {
        self.next.rule = rule;
        curve
    }

    fn cracked(&self) -> bool {
        self.next.cracked != 0.0
    }

    fn here(&self) -> [f64; 2] {
        [self.committed.strain, self.committed.stress]
    }

    fn open(&mut self) -> Curve {
        self.set(OPEN, (0.0, 0.0))
    }

    fn spalled(&mut self) -> Curve {
        self.next.cracked = 1.0;
        self.set(SPALLED, (0.0, 0.0))
    }

    pub(super) fn on_compression(&mut self) -> Curve {
        let (law, e) = (self.law, self.e);
        let x = if e >= 0.0 { (e / law.tension[1]).abs() } else { e / law.compression[1] };
        let (curve, beyond) = law.envelope(law.compression, law.critical_compression, x);
        self.next.least = [e, curve.0];
        self.set(if beyond { SPALLED } else { COMPRESSION }, curve)
    }

    pub(super) fn on_tension(&mut self) -> Curve {
        let (law, e) = (self.law, self.e);
        let x = if e >= 0.0 { (e / law.tension[1]).abs() } else { e / law.compression[1] };
        let (curve, beyond) = law.envelope(law.tension, law.critical_tension, x);
        self.next.largest = [e, curve.0];
        self.set(if beyond { OPEN } else { TENSION }, curve)
    }

    /// Gives concrete that was never compressed a point of unloading there.
    fn compress_first(&mut self, strain: f64) {
        if self.low != [0.0, 0.0] {
            return;
        }
        let law = self.law;
        let (curve, _) = law.envelope(law.compression, law.critical_compression, strain / law.compression[1]);
        self.low = [strain, curve.0];
        self.next.least = self.low;
        self.secant = law.compressive_secant(self.low);
        self.plastic[0] = strain - curve.0 / self.secant;
    }

    /// Slopes at the points of unloading in compression and in tension, on the way back to them.
    fn new_moduli(&self) -> [f64; 2] {
        [self.low[1] / (self.low[0] - self.plastic[0]), self.high[1] / (self.high[0] - self.plastic[1])]
    }

    /// Slopes at zero stress after unloading from compression and from tension.
    fn plastic_moduli(&self) -> [f64; 2] {
        let law = self.law;
        let compression = 0.1 * law.ec * (-2.0 * (self.low[0] / law.compression[1])).exp();
        [compression, law.ec / ((self.high[0] / law.tension[1]).abs().powf(1.1) + 1.0)]
    }

    fn unloads_compression(&mut self) -> Curve {
        let to = [self.plastic[0], 0.0, self.plastic_moduli()[0]];
        let curve = transition([self.low[0], self.low[1], self.law.ec], to, self.e);
        self.set(UNLOADS_COMPRESSION, curve)
    }

    fn unloads_tension(&mut self) -> Curve {
        let to = [self.plastic[1], 0.0, self.plastic_moduli()[1]];
        let curve = transition([self.high[0], self.high[1], self.law.ec], to, self.e);
        self.set(UNLOADS_TENSION, curve)
    }

    /// The curve from zero stress to the point of unloading in tension.
    fn to_tension_at(&self, x: f64) -> Curve {
        let from = [self.plastic[0], 0.0, self.plastic_moduli()[0]];
        transition(from, [self.high[0], self.high[1], self.new_moduli()[1]], x)
    }

    fn go_to_tension(&mut self) -> Curve {
        let curve = self.to_tension_at(self.e);
        self.set(TO_TENSION, curve)
    }

    fn to_compression_at(&self, x: f64) -> Curve {
        let from = [self.plastic[1], 0.0, self.plastic_moduli()[1]];
        transition(from, [self.low[0], self.low[1], self.new_moduli()[0]], x)
    }

    fn go_to_compression(&mut self) -> Curve {
        let curve = self.to_compression_at(self.e);
        self.set(TO_COMPRESSION, curve)
    }

    /// Strain where the way from a reversal meets the curve to tension.
    fn meets_tension(&self, from: f64) -> f64 {
        (self.low[0] - from) / (self.low[0] - self.plastic[1]) * (self.high[0] - self.plastic[0]) + self.plastic[0]
    }

    fn partly_to_tension(&mut self) -> Option<Curve> {
        let end = self.meets_tension(self.next.unload[0]);
        let inside = self.e < end;
        inside.then(|| {
            let curve = line(self.next.unload, [end, self.to_tension_at(end).0], self.e);
            self.set(PARTLY_TO_TENSION, curve)
        })
    }

    fn partly_to_compression(&mut self) -> Option<Curve> {
        let from = self.next.reload;
        let share = (from[0] - self.plastic[0]) / (self.high[0] - self.plastic[0]);
        let end = self.low[0] - share * (self.low[0] - self.plastic[1]);
        let inside = self.e > end;
        inside.then(|| {
            let curve = line(from, [end, self.to_compression_at(end).0], self.e);
            self.set(PARTLY_TO_COMPRESSION, curve)
        })
    }

    /// A crack closes along a power of the strain.
    fn closes(&mut self) -> Curve {
        let (start, modulus) = (self.next.closing, self.new_moduli()[0]);
        let length = self.low[0] - start;
        let secant = self.low[1] / length;
        let mut exponent = ((modulus - secant) / secant).abs();
        let lines = || transition([start, 0.0, 0.25 * secant], [self.low[0], self.low[1], modulus], self.e);
        let curve = if exponent > MAX_EXPONENT {
            lines()
        } else {
            if (self.low[0] / start - 1.0).abs() < 1e-4 {
                exponent = 0.0;
            }
            let factor = secant / length.abs().powf(exponent);
            if factor > MAX_FACTOR {
                lines()
            } else {
                let slope = factor * (self.e - start).abs().powf(exponent);
                ((self.e - start) * slope, slope * (exponent + 1.0))
            }
        };
        self.set(CLOSES, curve)
    }

    /// A crack opens from a partly closed state.
    fn opens(&mut self) -> Curve {
        let from = self.next.unload;
        let end = from[0] - from[1] / self.secant;
        if self.e < end {
            let curve = line(from, [end, 0.0], self.e);
            return self.set(OPENS, curve);
        }
        self.open()
    }

    /// Unloading from compression and on towards tension.
    fn leaves_compression(&mut self) -> Curve {
        if self.e <= self.plastic[0] {
            self.unloads_compression()
        } else if self.e < self.high[0] && !self.cracked() {
            self.go_to_tension()
        } else if !self.cracked() {
            self.on_tension()
        } else {
            self.next.strain *= self.law.kept_strain;
            self.open()
        }
    }

    /// Unloading from tension and on towards compression.
    fn leaves_tension(&mut self) -> Curve {
        if self.e >= self.plastic[1] {
            self.unloads_tension()
        } else if self.e >= self.low[0] {
            self.go_to_compression()
        } else {
            self.on_compression()
        }
    }

    /// Goes on towards compression.
    pub(super) fn continues_to_compression(&mut self) -> Curve {
        let (e, was) = (self.e, self.next.rule);
        if e <= self.low[0] {
            return self.on_compression();
        }
        if was == RELOADS_COMPRESSION && (self.cracked() || e < self.plastic[1]) {
            let curve = line(self.next.reload, self.low, e);
            return self.set(was, curve);
        }
        if !self.cracked() {
            if was == PARTLY_TO_COMPRESSION {
                return match self.partly_to_compression() {
                    Some(curve) => curve,
                    None => self.go_to_compression(),
                };
            }
            if e < self.plastic[1] {
                self.compress_first(FIRST_STRAIN);
                return self.go_to_compression();
            }
            if was == LEAVES_RELOADING_TENSION && e > self.next.unload[0] {
                let curve = line(self.next.unload, self.high, e);
                return self.set(was, curve);
            }
            return self.unloads_tension();
        }
        if was == RETURNS_TO_CLOSING {
            if e > self.next.left[0] {
                let curve = line(self.next.reload, self.next.left, e);
                return self.set(was, curve);
            }
            return self.closes();
        }
        if self.is_spalled() { self.spalled() } else { self.closes() }
    }

    fn is_spalled(&self) -> bool {
        let law = self.law;
        self.low[0] / law.compression[1] >= law.end(law.compression, law.critical_compression)
    }

    /// Turns towards tension.
    pub(super) fn turns_to_tension(&mut self) -> Curve {
        let (e, here) = (self.e, self.here());
        self.next.loading = -1.0;
        match self.next.rule {
            COMPRESSION => {
                self.next.least = here;
                self.low = here;
                self.leaves_compression()
            }
            was @ (UNLOADS_TENSION | LEAVES_RELOADING_TENSION) => {
                if was == UNLOADS_TENSION {
                    self.next.unload = here;
                }
                if e < self.high[0] {
                    let curve = line(self.next.unload, self.high, e);
                    return self.set(RELOADS_TENSION, curve);
                }
                self.on_tension()
            }
            RELOADS_COMPRESSION => {
                if e < self.next.reload[0] {
                    let curve = line(self.next.reload, self.low, e);
                    return self.set(LEAVES_RELOADING_COMPRESSION, curve);
                }
                self.leaves_compression()
            }
            TO_COMPRESSION | PARTLY_TO_COMPRESSION => {
                self.next.unload = here;
                match self.partly_to_tension() {
                    Some(curve) => curve,
                    None if e < self.high[0] => self.go_to_tension(),
                    None => self.on_tension(),
                }
            }
            SPALLED => {
                self.next.cracked = 1.0;
                self.open()
            }
            was => {
                self.next.unload = here;
                let curve = self.opens();
                if was == CLOSES && self.next.rule == OPENS {
                    self.next.left = here;
                }
                curve
            }
        }
    }

    /// Goes on towards tension.
    pub(super) fn continues_to_tension(&mut self) -> Curve {
        let (e, was) = (self.e, self.next.rule);
        if e > self.high[0] && !self.cracked() {
            return self.on_tension();
        }
        let inside = e > self.plastic[0] && !self.cracked();
        if inside && was == RELOADS_TENSION {
            let curve = line(self.next.unload, self.high, e);
            return self.set(was, curve);
        }
        if was == PARTLY_TO_TENSION && (inside || e < self.plastic[0]) {
            return match self.partly_to_tension() {
                Some(curve) => curve,
                None => self.go_to_tension(),
            };
        }
        if inside {
            return self.go_to_tension();
        }
        if was == OPENS {
            return self.opens();
        }
        if e < self.plastic[0] {
            if was == LEAVES_RELOADING_COMPRESSION && e < self.next.reload[0] {
                let curve = line(self.next.reload, self.low, e);
                return self.set(was, curve);
            }
            return self.unloads_compression();
        }
        self.open()
    }

    /// Turns towards compression.
    pub(super) fn turns_to_compression(&mut self) -> Curve {
        let (e, here) = (self.e, self.here());
        self.next.loading = 1.0;
        match self.next.rule {
            TENSION => {
                self.next.largest = here;
                self.high = here;
                self.compress_first(FIRST_STRAIN);
                self.leaves_tension()
            }
            was @ (UNLOADS_COMPRESSION | LEAVES_RELOADING_COMPRESSION) => {
                if was == UNLOADS_COMPRESSION {
                    self.next.reload = here;
                }
                if e > self.low[0] {
                    let curve = line(self.next.reload, self.low, e);
                    return self.set(RELOADS_COMPRESSION, curve);
                }
                self.on_compression()
            }
            RELOADS_TENSION => {
                self.compress_first(FIRST_STRAIN);
                if e > self.next.unload[0] {
                    let curve = line(self.next.unload, self.high, e);
                    return self.set(LEAVES_RELOADING_TENSION, curve);
                }
                self.leaves_tension()
            }
            TO_TENSION | PARTLY_TO_TENSION => {
                self.next.reload = here;
                match self.partly_to_compression() {
                    Some(curve) => curve,
                    None if e > self.low[0] => self.go_to_compression(),
                    None => self.on_compression(),
                }
            }
            OPENS => {
                self.next.reload = here;
                if e > self.next.left[0] {
                    let curve = line(here, self.next.left, e);
                    return self.set(RETURNS_TO_CLOSING, curve);
                }
                if e > self.low[0] { self.closes() } else { self.on_compression() }
            }
            _ => {
                self.compress_first(FIRST_CLOSING * self.law.compression[1]);
                self.next.reload = here;
                if self.is_spalled() {
                    return self.spalled();
                }
                if e > self.low[0] {
                    self.next.closing = here[0];
                    return self.closes();
                }
                self.on_compression()
            }
        }
    }
}
