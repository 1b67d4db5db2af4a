//! Materials made from other materials.

use super::Kind;
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::any_command::ITERATIONS;
use crate::text::{Arg, Domain, Text};
use crate::things;
use crate::{Tcl, ignore_unknown, warn};
use hysteron_engine::material::{
    Fatigue, FatigueParameters, InitialState, Iteration, Material, MaterialResult, MinMax, Parallel, PathIndependent,
    Series,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

const ITER_TOL: Arg = Arg::of("-iter", "tol", "tolerance").within(Domain::NotNegative);

const MIN_MIN_STRAIN: Arg = Arg::of("-min", "minStrain", "smallest strain").within(Domain::Number);
const MAX_MAX_STRAIN: Arg = Arg::of("-max", "maxStrain", "largest strain").within(Domain::Number);
const E0_STRAIN: Arg = Arg::of("-E0", "strain", "strain range E0 of one cycle to failure").within(Domain::Positive);
const M_SLOPE: Arg =
    Arg::of("-m", "slope", "slope m of strain range over cycles, in logarithms").within(Domain::Number);
const DMAX_DAMAGE: Arg = Arg::of("-Dmax", "damage", "damage at failure Dmax").within(Domain::Number);
const STRAIN: Arg = Arg::number("strain", "initial strain");

const FACTOR: Arg = Arg::number("factor", "factor of the stress").also(&["multiplier"]);
const STRESS: Arg = Arg::number("stress", "initial stress").also(&["sig0", "f0", "F0"]);

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["Parallel"],
        usage: "uniaxialMaterial Parallel $tag $material1 $material2 ... <-factors $factor1 $factor2 ...>",
        text: Text::new("Adds the stresses of other laws.")
            .example("uniaxialMaterial Parallel 77 1 1")
            .arguments(&[Arg::thing("material1", things::MATERIAL)]),
        make: parallel,
    },
    Kind {
        names: &["Multiplier", "MultiplierMaterial"],
        usage: "uniaxialMaterial Multiplier $tag $material $factor",
        text: Text::new("A law whose stress is multiplied by a factor.")
            .example("uniaxialMaterial Multiplier 77 1 1")
            .arguments(&[FACTOR]),
        make: multiplier,
    },
    Kind {
        names: &["PathIndependent"],
        usage: "uniaxialMaterial PathIndependent $tag $material",
        text: Text::new("Another law without its history: unloading follows the backbone.")
            .example("uniaxialMaterial PathIndependent 77 1"),
        make: path_independent,
    },
    Kind {
        names: &["Series"],
        usage: "uniaxialMaterial Series $tag $material1 $material2 ... <-iter $maxIter $tol>",
        text: Text::new("Adds the strains of other laws.")
            .example("uniaxialMaterial Series 77 1 1")
            .arguments(&[Arg::thing("material1", things::MATERIAL)]),
        make: series,
    },
    Kind {
        names: &["MinMax", "MinMaxMaterial"],
        usage: "uniaxialMaterial MinMax $tag $material <-min $minStrain> <-max $maxStrain>",
        text: Text::new("Another law that fails for good beyond a strain.")
            .example("uniaxialMaterial MinMax 77 1")
            .arguments(&[MIN_MIN_STRAIN, MAX_MAX_STRAIN]),
        make: min_max,
    },
    Kind {
        names: &["Fatigue", "FatigueMaterial"],
        usage: "uniaxialMaterial Fatigue $tag $material <-E0 $strain> <-m $slope> <-min $minStrain> <-max $maxStrain> \
                <-Dmax $damage>",
        text: Text::new("Another law that fails by low-cycle fatigue.")
            .example("uniaxialMaterial Fatigue 77 1")
            .arguments(&[E0_STRAIN, M_SLOPE, MIN_MIN_STRAIN, MAX_MAX_STRAIN, DMAX_DAMAGE]),
        make: fatigue,
    },
    Kind {
        names: &["InitStrainMaterial", "InitStrain"],
        usage: "uniaxialMaterial InitStrainMaterial $tag $material $strain",
        text: Text::new("Another law with an initial strain.")
            .example("uniaxialMaterial InitStrainMaterial 77 1 1")
            .arguments(&[STRAIN]),
        make: init_strain,
    },
    Kind {
        names: &["InitStressMaterial", "InitStress"],
        usage: "uniaxialMaterial InitStressMaterial $tag $material $stress",
        text: Text::new("Another law with an initial stress.")
            .example("uniaxialMaterial InitStressMaterial 77 1 1")
            .arguments(&[STRESS]),
        make: init_stress,
    },
];

/// The tags of at least one material.
fn materials(interp: &Tcl, a: &mut Args<'_>) -> Result<Vec<(Material, i32)>, Exception> {
    let mut all = vec![a.of(&interp.host.builder.definitions.materials)?];
    while a.left() > 0 && !a.at_option() {
        all.push(a.of(&interp.host.builder.definitions.materials)?);
    }
    Ok(all)
}

fn parallel(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let all = materials(interp, a)?;
    let mut factors = vec![1.0; all.len()];
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-factors" => {
                factors = a.floats("factor")?;
                if factors.len() != all.len() {
                    let message = format!("{} factors for {} materials", factors.len(), all.len());
                    return Err(a.refuse(message, "expected a factor for each material"));
                }
            }
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok(Parallel::new(all, factors).shared())
}

fn multiplier(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let inner = a.of(&interp.host.builder.definitions.materials)?;
    let factor = a.read(interp, &FACTOR)?;
    Ok(Parallel::new(vec![inner], vec![factor]).shared())
}

fn path_independent(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let inner = a.of(&interp.host.builder.definitions.materials)?;
    Ok(PathIndependent::new(inner).shared())
}

fn series(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let all = materials(interp, a)?;
    let (mut rounds, mut tolerance) = (1, 1e-10);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-iter" => {
                rounds = a.count(&ITERATIONS)?;
                tolerance = a.number(&ITER_TOL)?;
            }
            _ => ignore_unknown(interp, a)?,
        }
    }
    let compat = interp.host.follows(&[slips::SERIES_ROUND]);
    let iteration = if compat { Iteration::FixedIterations(rounds, tolerance) } else { Iteration::Converged };
    Ok(Series::new(all, iteration).shared())
}

fn min_max(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let inner = a.of(&interp.host.builder.definitions.materials)?;
    let (mut min, mut max) = (-1e16, 1e16);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-min" | "-Min" | "-MIN" => min = a.number(&MIN_MIN_STRAIN)?,
            "-max" | "-Max" | "-MAX" => max = a.number(&MAX_MAX_STRAIN)?,
            _ => ignore_unknown(interp, a)?,
        }
    }
    if min >= max {
        return Err(a.refuse(format!("no strain lies between {min} and {max}"), "expected -min less than -max"));
    }
    let compat = interp.host.follows(&[slips::MIN_MAX_STRAIN]);
    Ok(MinMax::new(inner, min, max, compat).shared())
}

fn fatigue(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let inner = a.of(&interp.host.builder.definitions.materials)?;
    // Wide-flange braces of steel (Uriz and Mahin, 2008).
    let mut p = FatigueParameters { d_max: 1.0, e0: 0.191, m: -0.458, limits: (-1e16, 1e16) };
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-E0" => p.e0 = a.number(&E0_STRAIN)?,
            "-m" => {
                p.m = a.number(&M_SLOPE)?;
                if p.m >= 0.0 {
                    return Err(a.refuse(format!("the slope m is {}", p.m), "expected a negative number"));
                }
            }
            "-min" => p.limits.0 = a.number(&MIN_MIN_STRAIN)?,
            "-max" => p.limits.1 = a.number(&MAX_MAX_STRAIN)?,
            "-Dmax" => {
                p.d_max = a.number(&DMAX_DAMAGE)?;
                if !(0.0..=1.0).contains(&p.d_max) {
                    let message = format!("Fatigue: the damage at failure is {}, and is taken as 1", p.d_max);
                    warn(
                        interp,
                        Diagnostic::warning(&checks::words::REPLACED_VALUE, message)
                            .at(a.last_span(), "expected 0 to 1"),
                    )?;
                    p.d_max = 1.0;
                }
            }
            _ => ignore_unknown(interp, a)?,
        }
    }
    if p.limits.0 >= p.limits.1 {
        let message = format!("no strain lies between {} and {}", p.limits.0, p.limits.1);
        return Err(a.refuse(message, "expected -min less than -max"));
    }
    Ok(Fatigue::new(inner, p).shared())
}

fn init_strain(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let inner = a.of(&interp.host.builder.definitions.materials)?;
    let strain = a.number(&STRAIN)?;
    begun(a, InitialState::strain(inner, strain), "expected a strain that the material can have")
}

fn init_stress(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let inner = a.of(&interp.host.builder.definitions.materials)?;
    let stress = a.read(interp, &STRESS)?;
    begun(a, InitialState::stress(inner, stress), "expected a stress that the material can have")
}

fn begun(a: &Args<'_>, law: MaterialResult<InitialState>, label: &str) -> Result<Material, Exception> {
    match law {
        Ok(law) => Ok(law.shared()),
        Err(e) => Err(a.refuse(e.to_string(), label)),
    }
}
