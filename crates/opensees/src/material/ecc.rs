//! `uniaxialMaterial ECC01`.

use super::Kind;
use super::concrete::compressive;
use crate::Tcl;
use crate::args::Args;
use crate::text::{Arg, Text};
use hysteron_engine::material::{Ecc01, Material};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;

const EXPONENTS: [Arg; 4] = [
    Arg::positive("alphaT1", "exponent of unloading alphaT1"),
    Arg::positive("alphaT2", "exponent of unloading alphaT2"),
    Arg::positive("alphaC", "exponent of unloading alphaC"),
    Arg::positive("alphaCU", "exponent of softening alphaCU"),
];
const PERMANENT: [Arg; 2] = [
    Arg::not_negative("betaT", "permanent part betaT of the tensile strain"),
    Arg::not_negative("betaC", "permanent part betaC of the compressive strain"),
];

const TENSION: [Arg; 5] = [
    Arg::positive("sigt0", "tensile stress at cracking sigt0"),
    Arg::positive("epst0", "tensile strain at cracking epst0"),
    Arg::positive("sigt1", "peak tensile stress sigt1"),
    Arg::positive("epst1", "strain at the peak epst1"),
    Arg::positive("epst2", "ultimate tensile strain epst2"),
];

pub(super) const KINDS: &[Kind] = &[Kind {
    names: &["ECC01"],
    usage: "uniaxialMaterial ECC01 $tag $sigt0 $epst0 $sigt1 $epst1 $epst2 $sigc0 $epsc0 $epsc1 $alphaT1 $alphaT2 \
                $alphaC $alphaCU $betaT $betaC",
    text: Text::new("Engineered cementitious composite, ductile in tension.")
        .example("uniaxialMaterial ECC01 77 3. 0.0002 4. 0.01 0.03 -40. -0.003 -0.01 3. 4. 2. 1.5 0.4 0.3")
        .arguments(&[
            Arg::new("sigc0", "compressive strength"),
            Arg::new("epsc0", "strain at the strength"),
            Arg::new("epsc1", "ultimate compressive strain"),
        ])
        .groups(&[&TENSION, &EXPONENTS, &PERMANENT]),
    make: ecc01,
}];

fn ecc01(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [first_stress, first_strain, peak_stress, peak_strain, ultimate] = a.read_all(interp, &TENSION)?;
    let (first, peak) = ([first_stress, first_strain], [peak_stress, peak_strain]);
    if peak[1] <= first[1] || ultimate <= peak[1] {
        let message = format!("the tensile strains are {}, {} and {ultimate}", first[1], peak[1]);
        return Err(a.refuse(message, "expected epst0 < epst1 < epst2"));
    }
    let bottom = [-compressive(a, "compressive strength sigc0")?, -compressive(a, "strain at the strength epsc0")?];
    let crushed = -compressive(a, "ultimate compressive strain epsc1")?;
    if crushed >= bottom[1] {
        return Err(a.refuse(format!("the ultimate compressive strain epsc1 is {crushed}"), "expected it beyond epsc0"));
    }
    let [unloading @ .., softening] = a.numbers(&EXPONENTS)?;
    let permanent = a.numbers(&PERMANENT)?;
    Ok(Ecc01 { tension: [first, peak], ultimate, peak: bottom, crushed, unloading, softening, permanent }.shared())
}
