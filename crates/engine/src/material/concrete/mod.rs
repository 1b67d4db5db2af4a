//! Laws of concrete and masonry.

mod asd_concrete_1d;
mod concrete01;
mod concrete01_sitc;
mod concrete02;
mod concrete02_is;
mod concrete04;
mod concrete06;
mod concrete07;
mod concrete_cm;
mod concrete_d;
mod concrete_w_beta;
mod confined_concrete01;
mod ecc01;
mod frp_confined_concrete02;
mod karsan_jirsa;
mod masonry;
mod popovics;

pub use asd_concrete_1d::AsdConcrete1d;
pub use concrete_cm::{ConcreteCm, History as ConcreteHistory, TsaiEnvelope};
pub use concrete_d::ConcreteD;
pub use concrete_w_beta::ConcreteWBeta;
pub use concrete01::Concrete01;
pub use concrete01_sitc::Concrete01Sitc;
pub use concrete02::Concrete02;
pub use concrete02_is::Concrete02Is;
pub use concrete04::Concrete04;
pub use concrete06::Concrete06;
pub use concrete07::Concrete07;
pub use confined_concrete01::{ConfinedConcrete01, Confinement, ConfinementSection, Dilation, Hoop, UltimateStrain};
pub use ecc01::Ecc01;
pub use frp_confined_concrete02::{FrpConfinedConcrete02, Jacket};
pub use masonry::Masonry;
