//! Inelastic response spectra: an oscillator with any law of a `uniaxialMaterial` command, of constant strength, constant
//! reduction or constant ductility (Chopra, Dynamics of Structures, chapter 7).

mod law;
mod spectrum;

pub use law::LawText;
pub use spectrum::{InelasticPoint, InelasticSpectra, Level};
