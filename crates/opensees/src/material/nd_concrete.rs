//! `nDMaterial ASDConcrete3D` and `uniaxialMaterial ASDConcrete1D`.

use super::Kind;
use crate::args::Args;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown};
use hysteron_engine::material::{AsdConcrete, AsdConcrete1d, Extrapolation, HardeningCurve, Material, NdMaterial};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;

const FC: Arg = Arg::of("-fc", "fc", "compressive strength fc in MPa").within(Domain::Positive);
const FT: Arg = Arg::of("-ft", "ft", "tensile strength ft in MPa").within(Domain::Positive);

pub(super) const MODULUS: Arg = Arg::positive("E", "modulus of elasticity E");
pub(super) const NU: Arg = Arg::number("nu", "Poisson's ratio nu");

pub(super) const USAGE: &str = "nDMaterial ASDConcrete3D $tag $E $nu -Te $strains -Ts $stresses <-Td $damages> -Ce $strains \
    -Cs $stresses <-Cd $damages> <-rho $rho> <-Kc $Kc> <-eta $eta> <-cdf $share> <-implex> <-implexControl $tolerance $limit> \
    <-implexAlpha $alpha> <-tangent> <-autoRegularization $length>";

/// Shape of the surface of failure that OpenSees assumes.
const KC: f64 = 2.0 / 3.0;

/// Strains, stresses and damages of a curve.
#[derive(Default)]
struct Lists([Vec<f64>; 3]);

impl Lists {
    fn curve(mut self, a: &Args<'_>, e: f64, sign: &str) -> Result<HardeningCurve, Exception> {
        let [strains, stresses, damages] = &mut self.0;
        if strains.len() < 2 || strains.len() != stresses.len() {
            let message = format!("-{sign}e has {} strains, -{sign}s has {} stresses", strains.len(), stresses.len());
            return Err(a.refuse(message, "expected 2 or more, as many of each"));
        }
        if damages.is_empty() {
            damages.resize(strains.len(), 0.0);
        }
        if damages.len() != strains.len() {
            let message = format!("-{sign}d has {} damages", damages.len());
            return Err(a.refuse(message, format!("expected {}, as many as strains", strains.len())));
        }
        let made = HardeningCurve::new(e, strains, stresses, damages);
        made.ok_or_else(|| a.refuse(format!("the curve of -{sign}e and -{sign}s is zero"), "expected stresses"))
    }
}

/// Options of either law.
#[derive(Default)]
struct Common {
    tension: Lists,
    compression: Lists,
    eta: f64,
    implex: bool,
    factor: Option<f64>,
    control: Option<[f64; 2]>,
    tangent: bool,
    reference_length: Option<f64>,
}

impl Common {
    /// Reads the words of an option. Returns false if it is none of these.
    fn read(&mut self, option: &str, a: &mut Args<'_>) -> Result<bool, Exception> {
        match option {
            "-Te" => self.tension.0[0] = a.floats("strain in tension")?,
            "-Ts" => self.tension.0[1] = a.floats("stress in tension")?,
            "-Td" => self.tension.0[2] = a.floats("damage in tension")?,
            "-Ce" => self.compression.0[0] = a.floats("strain in compression")?,
            "-Cs" => self.compression.0[1] = a.floats("stress in compression")?,
            "-Cd" => self.compression.0[2] = a.floats("damage in compression")?,
            "-eta" => self.eta = a.number(&VISCOSITY)?,
            "-implex" => self.implex = true,
            "-implexControl" => self.control = Some(a.numbers(&EXTRAPOLATION_CONTROL)?),
            "-implexAlpha" => self.factor = Some(a.number(&EXTRAPOLATION_FACTOR)?),
            "-tangent" => self.tangent = true,
            "-autoRegularization" => self.reference_length = Some(a.number(&LENGTH)?),
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn extrapolation(&self) -> Option<Extrapolation> {
        self.implex.then_some(Extrapolation { factor: self.factor.unwrap_or(1.0), control: self.control })
    }
}

pub(super) fn make(interp: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let e = a.number(&MODULUS)?;
    let nu = a.number(&NU)?;
    if !(nu > -1.0 && nu < 0.5) {
        return Err(a.refuse(format!("Poisson's ratio is {nu}"), "expected more than -1, less than 0.5"));
    }
    let (mut rho, mut kc, mut cross_damage, mut common) = (0.0, KC, 0.0, Common::default());
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-rho" => rho = a.number(&RHO)?,
            "-Kc" => kc = shape(a)?,
            "-cdf" => cross_damage = a.number(&CROSS_DAMAGE)?,
            option if common.read(option, a)? => {}
            _ => ignore_unknown(interp, a)?,
        }
    }
    let extrapolation = common.extrapolation();
    let Common { tension, compression, eta, tangent, reference_length, .. } = common;
    let law = AsdConcrete {
        e,
        nu,
        rho,
        eta,
        kc,
        cross_damage,
        tension: tension.curve(a, e, "T")?,
        compression: compression.curve(a, e, "C")?,
        extrapolation,
        tangent,
        reference_length,
    };
    let made = NdMaterial::of_solid("ASDConcrete3DMaterial", law.shared());
    // Layers do not know the size of their element.
    Ok(NdMaterial { layer: made.layer.filter(|_| reference_length.is_none()), ..made })
}

fn shape(a: &mut Args<'_>) -> Result<f64, Exception> {
    let kc = a.float("shape Kc of the surface of failure")?;
    if !(KC..=1.0).contains(&kc) {
        return Err(a.refuse(format!("Kc is {kc}"), "expected from 2/3 to 1"));
    }
    Ok(kc)
}

/// Arguments of the concretes with damage by curves, for a bar and in space.
pub(super) const CURVES: [Arg; 12] = [
    Arg::of("-Te", "strains", "total strains in tension, as a list or as words"),
    Arg::of("-Ts", "stresses", "stresses in tension, as many"),
    Arg::of("-Td", "damages", "damage in tension from 0 to 1, as many; 0 without"),
    Arg::of("-Ce", "strains", "total strains in compression, without sign"),
    Arg::of("-Cs", "stresses", "stresses in compression, as many"),
    Arg::of("-Cd", "damages", "damage in compression from 0 to 1, as many; 0 without"),
    Arg::flag("-implex", "the equivalent strains are extrapolated from the last two steps"),
    EXTRAPOLATION_CONTROL[0],
    EXTRAPOLATION_CONTROL[1],
    EXTRAPOLATION_FACTOR,
    VISCOSITY,
    LENGTH,
];
const VISCOSITY: Arg = Arg::of("-eta", "eta", "viscosity eta").within(Domain::NotNegative);
const EXTRAPOLATION_CONTROL: [Arg; 2] = [
    Arg::of("-implexControl", "tolerance", "largest error of the extrapolated damage").within(Domain::Positive),
    Arg::of("-implexControl", "limit", "least step over the first one for which the error counts")
        .within(Domain::NotNegative),
];
const LENGTH: Arg =
    Arg::of("-autoRegularization", "length", "length for which the curves hold").within(Domain::Positive);
pub(super) const RHO: Arg = Arg::of("-rho", "rho", "mass per volume rho").within(Domain::NotNegative);
pub(super) const CROSS_DAMAGE: Arg =
    Arg::of("-cdf", "share", "share of damage in tension that counts in compression").within(Domain::NotNegative);
const EXTRAPOLATION_FACTOR: Arg =
    Arg::of("-implexAlpha", "alpha", "factor of the extrapolation").within(Domain::NotNegative);

pub(super) const KINDS: &[Kind] = &[Kind {
    names: &["ASDConcrete1D"],
    usage: "uniaxialMaterial ASDConcrete1D $tag $E <-fc $fc <-ft $ft>> <-Te $strains -Ts $stresses <-Td $damages>> \
            <-Ce $strains -Cs $stresses <-Cd $damages>> <-implex> <-implexControl $tolerance $limit> <-implexAlpha $alpha> \
            <-eta $eta> <-tangent> <-autoRegularization $length>",
    text: Text::new("Concrete with plasticity and damage by curves in tension and compression, or by its strengths.")
        .example("uniaxialMaterial ASDConcrete1D 77 30000. -fc 30.")
        .arguments(&[MODULUS, FC, FT, Arg::flag("-tangent", "the tangent is the consistent one, not the secant")])
        .groups(&[&CURVES]),
    make: asd_concrete_1d,
}];

fn asd_concrete_1d(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = a.number(&MODULUS)?;
    let (mut fc, mut ft, mut common) = (None, None, Common::default());
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-fc" => fc = Some(a.number(&FC)?),
            "-ft" => ft = Some(a.number(&FT)?),
            option if common.read(option, a)? => {}
            _ => ignore_unknown(interp, a)?,
        }
    }
    let extrapolation = common.extrapolation();
    let Common { tension, compression, eta, tangent, reference_length, .. } = common;
    let curves = match fc {
        Some(fc) => AsdConcrete1d::curves_of_strength(e, fc, ft.unwrap_or(0.1 * fc), reference_length)
            .ok_or_else(|| a.refuse("the strengths make no curve", "expected MPa and mm"))?,
        None => [tension.curve(a, e, "T")?, compression.curve(a, e, "C")?],
    };
    Ok(AsdConcrete1d { e, eta, curves, extrapolation, tangent, reference_length }.shared())
}
