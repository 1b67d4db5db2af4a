//! Axial springs of laminated rubber bearings: cavitation in tension, yielding in compression.

mod bundle;

use super::Stress;
use crate::state_struct::Field;

/// Parameters of an axial spring in the commands `AxialSp` and `AxialSpHD`. Stiffnesses are stress over displacement,
/// since a spring of a bearing has an area but no length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxialParameters {
    /// Stiffness in compression, stress over displacement.
    pub sce: f64,
    /// Stress at cavitation, not negative.
    pub fty: f64,
    /// Stress at yield in compression, not positive.
    pub fcy: f64,
    /// Stiffness in tension divided by `sce`, 0 to 1.
    pub bte: f64,
    /// Stiffness after cavitation divided by `sce`, 0 to `bte`; equal to `bte` for a spring without cavitation.
    pub bty: f64,
    /// Stiffness after yield in compression divided by `sce`, 0 to 1.
    pub bcy: f64,
    /// Stress at which a cavitated spring has recovered, `fcy` to 0.
    pub fcr: f64,
    /// Hardening after cavitation (`AxialSpHD`): stiffness divided by `sce`, and its initial displacement divided by
    /// that at cavitation.
    pub hardening: Option<(f64, f64)>,
}

/// Axial spring of a multiple-shear-spring or multiple-normal-spring bearing model (Tanimoto, 2012, in OpenSees; Ishii
/// and Kikuchi, 2019, <https://doi.org/10.1002/eqe.3132>).
///
/// The skeleton is elastic with different stiffnesses in tension and compression, yields on both sides and, with
/// `HD`, hardens in tension. After cavitation the spring unloads towards the point (u_cr, f_cr) of the elastic
/// compression branch, where it has recovered. `AxialSp` unloads on the straight line to this point, `AxialSpHD`
/// elastically at first. Yield in compression shifts the elastic lines.
#[derive(Clone, Debug, PartialEq)]
pub struct AxialSpring<const HD: bool> {
    sce: f64,
    ste: f64,
    sty: f64,
    scy: f64,
    sth: f64,
    fty: f64,
    uty: f64,
    fcy: f64,
    ucy: f64,
    fcr: f64,
    ucr: f64,
    fth: f64,
    uth: f64,
    compat: bool,
}

/// `uniaxialMaterial AxialSp`.
pub type AxialSp = AxialSpring<false>;
/// `uniaxialMaterial AxialSpHD`.
pub type AxialSpHD = AxialSpring<true>;

/// Branch of a spring.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Branch {
    /// Elastic through the origin.
    #[default]
    Elastic,
    /// On the skeleton in tension after cavitation.
    Cavitated,
    /// On the skeleton in compression after yield.
    Yielded,
    /// Closing after cavitation on the line `slope` through (u_cr, f_cr).
    Closing,
    /// On the elastic line from the closing line at `from`.
    Reopening,
    /// On the elastic line from the skeleton in tension at `from`, above (u_cr, f_cr) along its length.
    Relieved,
    /// On the elastic lines through zero force at `from`, after yield in compression.
    Shifted,
    /// On the skeleton in tension before cavitation, after yield in compression.
    Flowing,
    /// On the extended hardening line, as OpenSees leaves a spring that reaches u_cr in one step.
    Overlooked,
}

impl Field for Branch {
    const LEN: usize = 1;
    #[inline]
    fn get(words: &[f64], at: &mut usize) -> Self {
        *at += 1;
        match words[*at - 1] as u8 {
            1 => Self::Cavitated,
            2 => Self::Yielded,
            3 => Self::Closing,
            4 => Self::Reopening,
            5 => Self::Relieved,
            6 => Self::Shifted,
            7 => Self::Flowing,
            8 => Self::Overlooked,
            _ => Self::Elastic,
        }
    }
    #[inline]
    fn put(&self, words: &mut [f64], at: &mut usize) {
        words[*at] = f64::from(*self as u8);
        *at += 1;
    }
}

crate::state_struct! {
    /// History of an [`AxialSpring`].
    struct History {
        /// Displacement.
        u: f64,
        /// Branch.
        branch: Branch,
        /// Slope of the closing line.
        slope: f64,
        /// Displacement of the first point of the branch's elastic line.
        from: f64,
    }
}

impl<const HD: bool> AxialSpring<HD> {
    /// From the parameters. With `compat` the spring deviates as in OpenSees. A step from cavitation to compression
    /// ends where it does there. A spring that has just begun to harden closes beyond (u_cr, f_cr) or misses this
    /// point. A spring without stiffness in tension does not leave compression after yield.
    pub fn new(p: &AxialParameters, compat: bool) -> Self {
        let (ste, sty) = (p.bte * p.sce, p.bty * p.sce);
        // A spring without cavitation has its yield point at infinity.
        let (fty, uty, sty) = if ste > sty { (p.fty, p.fty / ste, sty) } else { (f64::MAX, f64::MAX, 0.0) };
        let (sth, uth) = p.hardening.map_or((sty, f64::MAX), |(bth, ath)| (bth * p.sce, ath * uty));
        let fth = if uth < f64::MAX { sty * (uth - uty) + fty } else { f64::MAX };
        let (scy, ucy, ucr) = (p.bcy * p.sce, p.fcy / p.sce, p.fcr / p.sce);
        Self { sce: p.sce, ste, sty, scy, sth, fty, uty, fcy: p.fcy, ucy, fcr: p.fcr, ucr, fth, uth, compat }
    }

    /// Force and stiffness of the skeleton in tension, extended to smaller displacements.
    #[inline]
    fn tension(&self, u: f64) -> (f64, f64) {
        if u > self.uth {
            (self.sth * (u - self.uth) + self.fth, self.sth)
        } else {
            (self.sty * (u - self.uty) + self.fty, self.sty)
        }
    }

    /// Force of the skeleton in compression after yield.
    #[inline]
    fn compression(&self, u: f64) -> f64 {
        self.scy * (u - self.ucy) + self.fcy
    }

    /// Force on the closing line.
    #[inline]
    fn closing(&self, slope: f64, u: f64) -> f64 {
        self.fcr + slope * (u - self.ucr)
    }

    /// Branch of the virgin spring.
    #[inline]
    fn virgin(&self, u: f64) -> Branch {
        if u < self.ucy {
            Branch::Yielded
        } else if u <= self.uty {
            Branch::Elastic
        } else {
            Branch::Cavitated
        }
    }

    /// Branch of unloading from the skeleton in tension, with the force `f` at `c.u`.
    #[inline]
    fn unload(&self, c: &History, f: f64, u: f64, t: &mut History) -> Branch {
        if HD {
            if self.compat && c.u > self.uth && u == self.ucr {
                return Branch::Overlooked;
            }
            // The spring unloads elastically to the line from (u_cr, f_cr) to the intersection of elastic line and
            // origin slope of the skeleton. If the elastic line meets compression first, the spring follows it.
            let end = f + self.ste * (self.ucr - c.u);
            if end >= self.fcr && !(self.compat && c.u > self.uth) {
                t.from = c.u;
                return self.relieved(t.from, u);
            }
            t.from = (self.ste * c.u - f) / (self.ste - self.sty);
            t.slope = (self.fcr - self.sty * t.from) / (self.ucr - t.from);
            return if u >= t.from { Branch::Reopening } else { self.close(t.slope, u) };
        }
        if self.compat && u <= self.ucr {
            return if u > self.ucy { Branch::Yielded } else { Branch::Cavitated };
        }
        t.slope = (self.fcr - f) / (self.ucr - c.u);
        self.close(t.slope, u)
    }

    /// Branch on the closing line and beyond it.
    #[inline]
    fn close(&self, slope: f64, u: f64) -> Branch {
        let mut end = self.ucr;
        if self.compat && self.uth < f64::MAX {
            // OpenSees first tests the elastic line from the hardening point.
            let pass = (self.fth - self.fcr - self.ste * self.uth + slope * self.ucr) / (slope - self.ste);
            end = end.min(pass);
        }
        if u > end { Branch::Closing } else { self.virgin(u) }
    }

    /// Branch on the elastic line from the skeleton at `from`, above (u_cr, f_cr).
    #[inline]
    fn relieved(&self, from: f64, u: f64) -> Branch {
        if u > from {
            Branch::Cavitated
        } else if u <= 0.0 && self.tension(from).0 + self.ste * (u - from) >= self.sce * u {
            self.virgin(u)
        } else {
            Branch::Relieved
        }
    }

    /// Branch on the elastic line from the closing line at `from`, upwards or back.
    #[inline]
    fn reopen(&self, t: &History, u: f64) -> Branch {
        if u <= t.from {
            self.close(t.slope, u)
        } else if self.closing(t.slope, t.from) + self.ste * (u - t.from) > self.tension(u).0 {
            Branch::Cavitated
        } else {
            Branch::Reopening
        }
    }

    /// Branch on the elastic lines through zero force at `zero`, between the skeletons.
    #[inline]
    fn shifted(&self, c: &History, zero: f64, u: f64) -> Branch {
        if u <= zero {
            if self.sce * (u - zero) <= self.compression(u) { Branch::Yielded } else { Branch::Shifted }
        } else if self.compat && self.ste == 0.0 {
            c.branch
        } else if self.ste * (u - zero) > self.tension(u).0 {
            if u > self.uty { Branch::Cavitated } else { Branch::Flowing }
        } else {
            Branch::Shifted
        }
    }

    /// Force and stiffness on a branch.
    #[inline]
    fn answer(&self, t: &History) -> Stress {
        let u = t.u;
        let (value, tangent) = match t.branch {
            Branch::Elastic if u <= 0.0 => (self.sce * u, self.sce),
            Branch::Elastic => (self.ste * u, self.ste),
            Branch::Cavitated | Branch::Flowing => self.tension(u),
            Branch::Overlooked => (self.sth * (u - self.uth) + self.fth, self.sth),
            Branch::Yielded => (self.compression(u), self.scy),
            Branch::Closing => (self.closing(t.slope, u), t.slope),
            Branch::Reopening => (self.closing(t.slope, t.from) + self.ste * (u - t.from), self.ste),
            Branch::Relieved => (self.tension(t.from).0 + self.ste * (u - t.from), self.ste),
            // OpenSees' spring without stiffness in tension never reaches the tension side of the line.
            Branch::Shifted if u <= t.from || (self.compat && self.ste == 0.0) => (self.sce * (u - t.from), self.sce),
            Branch::Shifted => (self.ste * (u - t.from), self.ste),
        };
        Stress { value, tangent, damping: 0.0 }
    }

    /// Branch at `u` from the branch of `c` with the committed force `force`; sets the first points of its lines in
    /// `t`.
    #[inline]
    fn follow(&self, c: &History, force: impl Fn() -> f64, u: f64, t: &mut History) -> Branch {
        match c.branch {
            Branch::Overlooked if u >= c.u => Branch::Overlooked,
            Branch::Elastic | Branch::Overlooked => self.virgin(u),
            Branch::Cavitated if u >= c.u => Branch::Cavitated,
            Branch::Cavitated => self.unload(c, force(), u, t),
            Branch::Closing if u <= c.u => self.close(c.slope, u),
            Branch::Closing => {
                t.from = c.u;
                self.reopen(t, u)
            }
            Branch::Reopening => self.reopen(c, u),
            Branch::Relieved => self.relieved(c.from, u),
            Branch::Yielded if u <= c.u => Branch::Yielded,
            Branch::Yielded => {
                t.from = c.u - force() / self.sce;
                self.shifted(c, t.from, u)
            }
            Branch::Shifted => self.shifted(c, c.from, u),
            Branch::Flowing if u >= c.u => {
                if u <= self.uty {
                    Branch::Flowing
                } else {
                    Branch::Cavitated
                }
            }
            Branch::Flowing => {
                t.from = c.u - force() / self.ste;
                self.shifted(c, t.from, u)
            }
        }
    }

    /// Response and next history at `u`, from the committed history.
    #[inline]
    fn step(&self, c: &History, u: f64) -> (Stress, History) {
        let mut t = History { u, ..*c };
        t.branch = self.follow(c, || self.answer(c).value, u, &mut t);
        (self.answer(&t), t)
    }

    /// As `step`, but as in OpenSees, where the branch continues from the last call, committed or not. Only
    /// displacement and force come from the committed state. `slope` then holds the displacement at which a shifted
    /// spring yields again.
    #[inline]
    fn step_on(&self, c: &History, last: &History, u: f64) -> (Stress, History) {
        let from = History { u: c.u, ..*last };
        let mut t = History { u, ..from };
        let next = self.follow(&from, || self.answer(c).value, u, &mut t);
        t.branch = match (from.branch, next) {
            (Branch::Shifted, _) if u <= from.slope => Branch::Yielded,
            (Branch::Shifted, Branch::Yielded) => Branch::Shifted,
            _ => next,
        };
        match from.branch {
            Branch::Yielded if u > c.u => t.slope = c.u,
            Branch::Flowing if u < c.u => {
                t.slope = (self.sce * t.from - self.scy * self.ucy + self.fcy) / (self.sce - self.scy);
            }
            _ => {}
        }
        (self.answer(&t), t)
    }
}
