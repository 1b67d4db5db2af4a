//! Laws of plastic hinges and connections whose strength or stiffness deteriorates.

mod bar_slip;
mod bilin;
mod gallardo_shear;
mod hinge;
mod hysteretic;
mod hysteretic_sm;
mod imk;
mod limit_state;
mod mod_imk;
mod pinching4;
mod saws;

pub use bar_slip::{BarPlace, BarSlip, Bond, BondDamage, StressUnit};
pub use bilin::{Bilin, BilinSide, Deterioration};
pub use gallardo_shear::{Decay, GallardoShear};
pub use hysteretic::{Envelope, Hysteretic};
pub use hysteretic_sm::{HystereticSm, SmEnvelope};
pub use imk::{ImkBilin, ImkDeterioration, ImkPeakOriented, ImkPinching, ImkSide, Pinching};
pub use limit_state::{
    Column, ColumnResponse, LimitCurve, LimitDeformation, LimitForce, LimitState, LimitSurface, RotationLimit,
    RotationShear,
};
pub use mod_imk::{ModImkPeakOriented, ModImkPinching, PinchingPoint};
pub use pinching4::{Damage, LinearDamage, Pinching4, Pinching4Parameters, Pinching4Side};
pub use saws::{Saws, SawsParameters};
