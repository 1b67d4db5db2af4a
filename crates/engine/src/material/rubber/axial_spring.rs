//! Axial springs of laminated rubber bearings: cavitation in tension, yielding in compression.

mod bundle;
mod opensees;

use crate::material::Stress;
use crate::rules::{Consistent, OpenSees};
use crate::state_struct::Field;
use std::fmt;

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
pub struct AxialSpring<const HD: bool, R = Consistent> {
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
    rules: R,
}

/// Rules of [`AxialSpring`] that differ in OpenSees.
pub trait Rules: Clone + fmt::Debug + Send + Sync + 'static {
    /// The spring goes on from the branch of its last trial state.
    const FOLLOWS_TRIALS: bool = false;

    /// A spring that unloads from `u` has hardened beyond `uth` and keeps no elastic line above (u_cr, f_cr).
    fn hardened(_u: f64, _uth: f64) -> bool {
        false
    }

    /// Branch of a spring that comes from cavitation to `u` in one step, where it is not found by the lines on the way.
    fn jump(_u: f64, _ucr: f64, _ucy: f64) -> Option<Branch> {
        None
    }

    /// Displacement at which the line of closing ends; `passes` is where it meets the elastic line from the hardening point at `uth`.
    fn end_of_closing(ucr: f64, _uth: f64, _passes: impl FnOnce() -> f64) -> f64 {
        ucr
    }

    /// A spring with the stiffness `ste` in tension never comes off compression after it has yielded.
    fn stays_compressed(_ste: f64) -> bool {
        false
    }
}

impl Rules for Consistent {}

/// `uniaxialMaterial AxialSp`.
pub type AxialSp<R = Consistent> = AxialSpring<false, R>;
/// `uniaxialMaterial AxialSpHD`.
pub type AxialSpHD<R = Consistent> = AxialSpring<true, R>;

/// Branch of a spring.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Branch {
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
    /// From the parameters.
    pub fn new(p: &AxialParameters) -> Self {
        Self::of(p, Consistent)
    }
}

impl<const HD: bool> AxialSpring<HD, OpenSees> {
    /// As `new`, by the rules of OpenSees.
    pub fn as_opensees(p: &AxialParameters) -> Self {
        Self::of(p, OpenSees)
    }
}

impl<const HD: bool, R: Rules> AxialSpring<HD, R> {
    fn of(p: &AxialParameters, rules: R) -> Self {
        let (ste, sty) = (p.bte * p.sce, p.bty * p.sce);
        // A spring without cavitation has its yield point at infinity.
        let (fty, uty, sty) = if ste > sty { (p.fty, p.fty / ste, sty) } else { (f64::MAX, f64::MAX, 0.0) };
        let (sth, uth) = p.hardening.map_or((sty, f64::MAX), |(bth, ath)| (bth * p.sce, ath * uty));
        let fth = if uth < f64::MAX { sty * (uth - uty) + fty } else { f64::MAX };
        let (scy, ucy, ucr) = (p.bcy * p.sce, p.fcy / p.sce, p.fcr / p.sce);
        Self { sce: p.sce, ste, sty, scy, sth, fty, uty, fcy: p.fcy, ucy, fcr: p.fcr, ucr, fth, uth, rules }
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
            if R::hardened(c.u, self.uth) && u == self.ucr {
                return Branch::Overlooked;
            }
            // The spring unloads elastically to the line from (u_cr, f_cr) to the intersection of elastic line and
            // origin slope of the skeleton. If the elastic line meets compression first, the spring follows it.
            let end = f + self.ste * (self.ucr - c.u);
            if end >= self.fcr && !R::hardened(c.u, self.uth) {
                t.from = c.u;
                return self.relieved(t.from, u);
            }
            t.from = (self.ste * c.u - f) / (self.ste - self.sty);
            t.slope = (self.fcr - self.sty * t.from) / (self.ucr - t.from);
            return if u >= t.from { Branch::Reopening } else { self.close(t.slope, u) };
        }
        if let Some(branch) = R::jump(u, self.ucr, self.ucy) {
            return branch;
        }
        t.slope = (self.fcr - f) / (self.ucr - c.u);
        self.close(t.slope, u)
    }

    /// Branch on the closing line and beyond it.
    #[inline]
    fn close(&self, slope: f64, u: f64) -> Branch {
        let passes = || (self.fth - self.fcr - self.ste * self.uth + slope * self.ucr) / (slope - self.ste);
        let end = R::end_of_closing(self.ucr, self.uth, passes);
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
        } else if R::stays_compressed(self.ste) {
            c.branch
        } else if self.ste * (u - zero) > self.tension(u).0 {
            if u > self.uty { Branch::Cavitated } else { Branch::Flowing }
        } else {
            Branch::Shifted
        }
    }

    /// Force and stiffness on a branch.
    #[inline]
    fn response(&self, t: &History) -> Stress {
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
            Branch::Shifted if u <= t.from || R::stays_compressed(self.ste) => (self.sce * (u - t.from), self.sce),
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
        t.branch = self.follow(c, || self.response(c).value, u, &mut t);
        (self.response(&t), t)
    }
}
