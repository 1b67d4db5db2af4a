//! Loads on elements (`eleLoad`).

use super::{ElementError, ElementResult};

/// A load on an element in its local axes, constant in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ElementLoad {
    /// A load per length over a part of a beam, linear from start to end.
    Distributed {
        /// Start and end as fractions of the length, 0 to 1.
        span: (f64, f64),
        /// Force per length along local y at start and end.
        y: (f64, f64),
        /// Force per length along local z at start and end.
        z: (f64, f64),
        /// Force per length along local x at start and end.
        x: (f64, f64),
    },
    /// A point force on a beam.
    Point {
        /// Position as a fraction of the length, 0 to 1.
        at: f64,
        /// Force along local y.
        y: f64,
        /// Force along local z.
        z: f64,
        /// Force along local x.
        x: f64,
    },
    /// A uniform moment per length about local z of a beam in the plane.
    Moment {
        /// Moment per length, force.
        z: f64,
    },
}

/// End actions of one transverse load component on a beam of length L: shears of the simple beam, moments of the
/// clamped beam.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EndActions {
    /// Shear reactions at i and j, positive against the load.
    pub shear: (f64, f64),
    /// Moments of the clamped beam at i and j: ∫ w x (1-x/L)² dx and ∫ w x² (1-x/L)/L dx.
    pub moment: (f64, f64),
}

/// Abscissae and weights of Gauss' rule with three points on [0, 1]. It is exact for a cubic times a linear load.
const GAUSS: [(f64, f64); 3] =
    [(0.112_701_665_379_258_3, 5.0 / 18.0), (0.5, 8.0 / 18.0), (0.887_298_334_620_741_7, 5.0 / 18.0)];

impl EndActions {
    /// End actions of a force `p` at the fraction `at` of the length.
    pub fn point(p: f64, at: f64, length: f64) -> Self {
        let rest = 1.0 - at;
        Self { shear: (p * rest, p * at), moment: (p * length * at * rest * rest, p * length * at * at * rest) }
    }

    /// End actions of a load per length that is linear from `w.0` to `w.1` over `span` (fractions of the length).
    pub fn distributed(w: (f64, f64), span: (f64, f64), length: f64) -> Self {
        let mut sum = Self::default();
        if w == (0.0, 0.0) {
            return sum;
        }
        let width = span.1 - span.0;
        for (g, weight) in GAUSS {
            let force = (w.0 + (w.1 - w.0) * g) * weight * width * length;
            let p = Self::point(force, span.0 + g * width, length);
            sum.shear.0 += p.shear.0;
            sum.shear.1 += p.shear.1;
            sum.moment.0 += p.moment.0;
            sum.moment.1 += p.moment.1;
        }
        sum
    }
}

/// Internal forces of a simple beam under a point force. `x` and `at` are fractions of the length. Order: axial force,
/// moment about z, shear along y, moment about y, shear along z.
fn internal_of_point((y, z, axial): (f64, f64, f64), at: f64, x: f64, length: f64) -> [f64; 5] {
    // Share of the force carried by the end beyond the section, and the distance to the other end.
    let (share, lever, n) = if x <= at { (at - 1.0, x, axial) } else { (at, x - 1.0, 0.0) };
    [n, share * lever * y * length, share * y, -share * lever * z * length, -share * z]
}

impl ElementLoad {
    /// Rejects moments along the beam for elements of this class.
    ///
    /// # Errors
    /// The load is a moment along the beam.
    pub(crate) fn refuse_moment(&self, class: &str) -> ElementResult {
        match self {
            Self::Moment { .. } => Err(ElementError(format!("{class} takes no moments along its length").into())),
            _ => Ok(()),
        }
    }

    /// Internal forces of a simple beam at `x` (fraction of the length), with the signs of a section. Order: axial
    /// force, moment about z, shear along y, moment about y, shear along z.
    pub fn internal_forces(&self, x: f64, length: f64) -> [f64; 5] {
        match *self {
            Self::Point { at, y, z, x: axial } => internal_of_point((y, z, axial), at, x, length),
            Self::Moment { z } => [0.0, 0.0, z, 0.0, 0.0],
            Self::Distributed { span, y, z, x: axial } => {
                let mut sum = [0.0; 5];
                let cut = x.clamp(span.0, span.1);
                for (from, to) in [(span.0, cut), (cut, span.1)].into_iter().filter(|(from, to)| to > from) {
                    for (g, weight) in GAUSS {
                        let at = from + g * (to - from);
                        let along = (at - span.0) / (span.1 - span.0);
                        let force = |w: (f64, f64)| (w.0 + (w.1 - w.0) * along) * weight * (to - from) * length;
                        let part = internal_of_point((force(y), force(z), force(axial)), at, x, length);
                        sum.iter_mut().zip(part).for_each(|(s, p)| *s += p);
                    }
                }
                sum
            }
        }
    }
}

impl ElementLoad {
    /// End actions along local y and z, then the total axial force and its share at j.
    pub fn end_actions(&self, length: f64) -> (EndActions, EndActions, (f64, f64)) {
        match *self {
            Self::Point { at, y, z, x } => {
                (EndActions::point(y, at, length), EndActions::point(z, at, length), (x, x * at))
            }
            // A uniform moment is in equilibrium with end shears; the clamped beam has no curvature.
            Self::Moment { z } => {
                (EndActions { shear: (-z, z), ..EndActions::default() }, EndActions::default(), (0.0, 0.0))
            }
            Self::Distributed { span, y, z, x } => {
                let axial = EndActions::distributed(x, span, length);
                (
                    EndActions::distributed(y, span, length),
                    EndActions::distributed(z, span, length),
                    (axial.shear.0 + axial.shear.1, axial.shear.1),
                )
            }
        }
    }
}
