//! Damping by modes.

/// C = Σ 2 ζ ω (M φ)(M φ)ᵀ over modes of unit modal mass.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ModalDamping {
    /// 2 ζ ω and the shape over all degrees of freedom, by mode.
    pub modes: Vec<(f64, Vec<f64>)>,
    /// It counts in the tangent too, and not in the forces alone.
    pub in_tangent: bool,
}
