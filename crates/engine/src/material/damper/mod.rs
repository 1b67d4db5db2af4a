//! Laws of dampers.

mod bilinear_oil_damper;
mod coulomb_damper;
mod maxwell;
mod viscous;
mod viscous_damper;

pub use bilinear_oil_damper::BilinearOilDamper;
pub use coulomb_damper::CoulombDamper;
pub use maxwell::Maxwell;
pub use viscous::Viscous;
pub use viscous_damper::{IntegrationMethod, ViscousDamper};
