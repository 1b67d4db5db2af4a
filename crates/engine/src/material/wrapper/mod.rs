//! Laws around other laws.

mod fatigue;
mod parallel;
mod path_independent;
mod series;
pub(super) mod softening;
mod wrapped;
#[allow(clippy::module_inception)]
mod wrapper;

pub use fatigue::{Fatigue, FatigueCount, FatigueParameters};
pub use parallel::{Parallel, WeightedSum};
pub use path_independent::{PathIndependent, Virgin};
pub use series::{CommonStress, Iteration, Series};
pub use softening::{Mullins, Peak, Softening, SofteningFactor};
pub use wrapped::{InitialState, MinMax, StrainLimits};
pub use wrapper::{Wrapped, Wrapper};
