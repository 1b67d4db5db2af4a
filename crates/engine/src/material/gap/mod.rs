//! Laws of gaps, of impact across them and of ratchets.

mod elastic_pp_gap;
mod gng;
mod hertz_damp;
mod hook_gap;
mod hyperbolic_gap;
mod impact;
mod jankowski_impact;
mod ratchet;
mod viscoelastic_gap;

pub use elastic_pp_gap::ElasticPPGap;
pub use gng::Gng;
pub use hertz_damp::HertzDamp;
pub use hook_gap::HookGap;
pub use hyperbolic_gap::HyperbolicGap;
pub use impact::Impact;
pub use jankowski_impact::JankowskiImpact;
pub use ratchet::{Ratchet, Teeth};
pub use viscoelastic_gap::ViscoelasticGap;
