//! Laws of steel, reinforcing bars and shape-memory alloys.

mod bond_sp01;
mod cast;
mod dodd_restrepo;
mod hardening;
mod reinforcing_steel;
mod self_centering;
mod sma;
mod sma_3k;
mod steel01;
mod steel02;
mod steel03;
mod steel4;
mod steel_brb;
mod steel_drc;
mod steel_fracture_di;
mod steel_mpf;
mod uvc_uniaxial;

pub use bond_sp01::BondSp01;
pub use cast::Cast;
pub use dodd_restrepo::DoddRestrepo;
pub use hardening::Hardening;
pub use reinforcing_steel::{BarFatigue, Buckling, ReinforcingSteel};
pub use self_centering::SelfCentering;
pub use sma::Sma;
pub use sma_3k::Sma3k;
pub use steel_brb::{BrbBranch, SteelBrb};
pub use steel_drc::{BauschingerKind, ReportedStiffness, SteelDrc};
pub use steel_fracture_di::SteelFractureDi;
pub use steel_mpf::SteelMpf;
pub use steel01::Steel01;
pub use steel02::Steel02;
pub use steel03::Steel03;
pub use steel4::{Steel4, Steel4Side};
pub use uvc_uniaxial::{MAX_BACKSTRESSES, UvcUniaxial};
