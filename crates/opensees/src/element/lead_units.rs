//! Thermal constants of a lead core beside the mechanical ones: in one system of units they have ratios that no unit changes.

use crate::checks;
use hysteron_tcl::diagnostic::{Diagnostic, Span};

/// Volumetric heat of lead, 1.46 MPa/K, over the shear modulus of rubber, 0.3 to 3 MPa: 0.5 to 5 per K, with a margin of 10.
const HEAT_RATIO: std::ops::Range<f64> = 0.05..50.0;
/// Conductivity of steel over its diffusivity, 3.5 MPa/K, over the volumetric heat of lead: 2.4, with a margin of 10.
const STEEL_RATIO: std::ops::Range<f64> = 0.24..24.0;
/// Diffusivity of steel, 1.4e-5 m²/s, over the square of a radius of 0.01 to 0.5 m: 6e-5 to 0.14 per s, with a margin of 10.
const DIFFUSION: std::ops::Range<f64> = 6e-6..1.4;

/// Constants of a lead core that heats, in the units of the script.
pub(super) struct ThermalUnits {
    pub(super) density: f64,
    pub(super) heat: f64,
    pub(super) conductivity: f64,
    pub(super) diffusivity: f64,
    /// Shear modulus of the rubber.
    pub(super) rubber: f64,
    /// Radius of the core.
    pub(super) radius: f64,
    /// The constants are the defaults, in SI.
    pub(super) is_default: bool,
}

impl ThermalUnits {
    /// The constant that is in other units than the geometry and the rubber.
    pub(super) fn finding(&self, span: Option<Span>) -> Option<Diagnostic> {
        let heat = self.density * self.heat;
        let checks = [
            ("qL cL of lead over Gr", heat / self.rubber, HEAT_RATIO, "2.4 for a rubber of 0.6 MPa"),
            ("kS/aS of steel over qL cL", self.conductivity / self.diffusivity / heat, STEEL_RATIO, "2.4"),
            (
                "aS of steel over the square of the radius",
                self.diffusivity / self.radius.powi(2),
                DIFFUSION,
                "1e-4 to 0.1",
            ),
        ];
        let (what, ratio, _, usual) = checks.into_iter().find(|(_, ratio, range, _)| !range.contains(ratio))?;
        let of = if self.is_default { "the default thermal constants are in SI" } else { "thermal constants" };
        let message =
            format!("LeadRubberX: {of}, and not in the units of the bearing: {what} is {ratio:.3e}, usually {usual}");
        let d =
            Diagnostic::warning(&checks::elements::THERMAL_UNITS, message).at(span, "the lead heats as no lead does");
        Some(d.help(
            "11200 kg/m³, 130 J/(kg K), 50 W/(m K) and 1.41e-5 m²/s are 1.12e-8 130e6 50 14.1 in N, mm, t and s, \
             and 11.2 130 0.05 1.41e-5 in kN, m, t and s",
        ))
    }
}
