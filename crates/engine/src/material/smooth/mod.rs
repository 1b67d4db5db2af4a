//! Laws with smooth hysteresis.

mod bouc_wen;
mod bouc_wen_original;
mod bwbn;
mod hysteretic_asym;
mod hysteretic_poly;
mod hysteretic_smooth;

pub use bouc_wen::BoucWen;
pub use bouc_wen_original::BoucWenOriginal;
pub use bwbn::Bwbn;
pub use hysteretic_asym::HystereticAsym;
pub use hysteretic_poly::HystereticPoly;
pub use hysteretic_smooth::HystereticSmooth;
