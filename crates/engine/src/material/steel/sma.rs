//! Superelastic shape-memory alloy with linear transformations (Auricchio, Taylor and Lubliner, 1997).

use crate::material::lanes::{PointLaw, PointResponse, updates_blocks};
use crate::material::{MaterialResult, Strain, Stress, UniaxialLaw};
use crate::numeric::lanes::select;
use crate::state_struct::StateStruct as _;

/// σ = E (ε - ξ ε_L) with the martensite fraction ξ, alike in tension and compression. Each transformation ends at its
/// finish stress, on a straight line from the stress at which it starts or at which it is resumed.
#[derive(Clone, Debug, PartialEq)]
pub struct Sma {
    /// Elastic modulus E.
    pub e: f64,
    /// Largest strain of transformation ε_L.
    pub eps_l: f64,
    /// Stresses at the start and finish of austenite to martensite.
    pub forward: [f64; 2],
    /// Stresses at the start and finish of martensite to austenite.
    pub reverse: [f64; 2],
}

crate::state_struct! {
    /// History of [`Sma`].
    pub struct History {
        /// Strain.
        strain: f64,
        /// Stress.
        stress: f64,
        /// Martensite fraction ξ.
        martensite: f64,
        /// Tangent minus the elastic modulus.
        softening: f64,
    }
}

impl Sma {
    /// Fraction and its slope at a strain on one side (both positive there), while it grows.
    #[inline(always)]
    fn load(&self, x: f64, stress: f64, m: f64) -> (f64, f64) {
        let ([start, finish], full) = (self.forward, self.e * self.eps_l);
        let from = select(stress > start, stress, start);
        let over = (1.0 - m) * full + finish - from;
        let (rising, slope) = (((1.0 - m) * self.e * x + m * finish - from) / over, (1.0 - m) * self.e / over);
        let (waits, transforms) = (x <= start / self.e + m * self.eps_l, x < finish / self.e + self.eps_l);
        (select(waits, m, select(transforms, rising, 1.0)), select(!waits & transforms, slope, 0.0))
    }

    /// The same while the strain decreases.
    #[inline(always)]
    fn unload(&self, x: f64, stress: f64, m: f64) -> (f64, f64) {
        let ([start, finish], full) = (self.reverse, self.e * self.eps_l);
        let over = m * full + select(stress < start, stress, start) - finish;
        let (falling, slope) = (m * (self.e * x - finish) / over, m * self.e / over);
        let (waits, transforms) = (x >= start / self.e + m * self.eps_l, x >= finish / self.e);
        (select(waits, m, select(transforms, falling, 0.0)), select(!waits & transforms, slope, 0.0))
    }
}

impl PointLaw<{ History::LEN }> for Sma {
    #[inline(always)]
    fn response(&self, c: [f64; History::LEN], x: f64) -> PointResponse<{ History::LEN }> {
        let [strain, stress, martensite, softening] = c;
        let side = select(x < 0.0, -1.0, 1.0);
        let (size, along) = (x.abs(), side * stress);
        let (more, less) = (self.load(size, along, martensite), self.unload(size, along, martensite));
        let grows = side * (x - strain) > 0.0;
        let (m, slope) = (select(grows, more.0, less.0), select(grows, more.1, less.1));
        let tangent = self.e * (1.0 - self.eps_l * slope);
        let value = side * self.e * (size - m * self.eps_l);
        // The direction of the next step is unknown at rest, so the tangent of the last step is kept.
        let same = x == strain;
        let keep = |old, new| select(same, old, new);
        let words = [x, keep(stress, value), keep(martensite, m), keep(softening, tangent - self.e)];
        PointResponse { words, value: words[1], tangent: keep(self.e + softening, tangent) }
    }
}

impl UniaxialLaw for Sma {
    type State = History;
    const NAME: &'static str = "SMA";
    const BY_QUANTITY: bool = true;

    fn update(&self, c: &History, strain: Strain) -> MaterialResult<(Stress, History)> {
        Ok(self.respond_to(c, strain.value))
    }

    updates_blocks!();

    fn initial_tangent(&self) -> f64 {
        self.e
    }
}
