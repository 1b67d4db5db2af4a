//! Materials made from other materials.

use super::Kind;
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::{Arg, Text};
use crate::{Tcl, ignore_option, warn};
use hysteron_engine::material::{
    Fatigue, FatigueParameters, InitialState, Iteration, Material, MaterialError, MinMax, Parallel, Series,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

const FACTOR: Arg = Arg::number("factor", "factor of the stress").also(&["multiplier"]);
const STRESS: Arg = Arg::number("stress", "initial stress").also(&["sig0", "f0", "F0"]);

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["Parallel"],
        usage: "uniaxialMaterial Parallel $tag $material1 $material2 ... <-factors $factor1 $factor2 ...>",
        text: Text::new("Adds the stresses of other laws."),
        make: parallel,
    },
    Kind {
        names: &["Multiplier", "MultiplierMaterial"],
        usage: "uniaxialMaterial Multiplier $tag $material $factor",
        text: Text::new("A law whose stress is multiplied by a factor.").arguments(&[FACTOR]),
        make: multiplier,
    },
    Kind {
        names: &["Series"],
        usage: "uniaxialMaterial Series $tag $material1 $material2 ... <-iter $maxIter $tol>",
        text: Text::new("Adds the strains of other laws."),
        make: series,
    },
    Kind {
        names: &["MinMax", "MinMaxMaterial"],
        usage: "uniaxialMaterial MinMax $tag $material <-min $minStrain> <-max $maxStrain>",
        text: Text::new("Another law that fails for good beyond a strain."),
        make: min_max,
    },
    Kind {
        names: &["Fatigue", "FatigueMaterial"],
        usage: "uniaxialMaterial Fatigue $tag $material <-E0 $strain> <-m $slope> <-min $minStrain> <-max $maxStrain> \
                <-Dmax $damage>",
        text: Text::new("Another law that fails by low-cycle fatigue."),
        make: fatigue,
    },
    Kind {
        names: &["InitStrainMaterial", "InitStrain"],
        usage: "uniaxialMaterial InitStrainMaterial $tag $material $strain",
        text: Text::new("Another law with an initial strain."),
        make: init_strain,
    },
    Kind {
        names: &["InitStressMaterial", "InitStress"],
        usage: "uniaxialMaterial InitStressMaterial $tag $material $stress",
        text: Text::new("Another law with an initial stress.").arguments(&[STRESS]),
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
            _ => ignore_option(interp, a, &["-factors"])?,
        }
    }
    Ok(Parallel::new(all, factors).shared())
}

fn multiplier(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let inner = a.of(&interp.host.builder.definitions.materials)?;
    let factor = a.read(interp, &FACTOR)?;
    Ok(Parallel::new(vec![inner], vec![factor]).shared())
}

fn series(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let all = materials(interp, a)?;
    let (mut rounds, mut tolerance) = (1, 1e-10);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-iter" => {
                rounds = a.count("largest number of iterations maxIter")?;
                tolerance = a.not_negative("tolerance")?;
            }
            _ => ignore_option(interp, a, &["-iter"])?,
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
            "-min" | "-Min" | "-MIN" => min = a.float("smallest strain")?,
            "-max" | "-Max" | "-MAX" => max = a.float("largest strain")?,
            _ => ignore_option(interp, a, &["-min", "-max"])?,
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
            "-E0" => p.e0 = a.positive("strain range E0 of one cycle to failure")?,
            "-m" => {
                p.m = a.float("slope m of strain range over cycles, in logarithms")?;
                if p.m >= 0.0 {
                    return Err(a.refuse(format!("the slope m is {}", p.m), "expected a negative number"));
                }
            }
            "-min" => p.limits.0 = a.float("smallest strain")?,
            "-max" => p.limits.1 = a.float("largest strain")?,
            "-Dmax" => {
                p.d_max = a.float("damage at failure Dmax")?;
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
            _ => ignore_option(interp, a, &["-E0", "-m", "-min", "-max", "-Dmax"])?,
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
    let strain = a.float("initial strain")?;
    begun(a, InitialState::strain(inner, strain), "expected a strain that the material can have")
}

fn init_stress(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let inner = a.of(&interp.host.builder.definitions.materials)?;
    let stress = a.read(interp, &STRESS)?;
    begun(a, InitialState::stress(inner, stress), "expected a stress that the material can have")
}

fn begun(a: &Args<'_>, law: Result<InitialState, MaterialError>, label: &str) -> Result<Material, Exception> {
    match law {
        Ok(law) => Ok(law.shared()),
        Err(e) => Err(a.refuse(e.to_string(), label)),
    }
}
