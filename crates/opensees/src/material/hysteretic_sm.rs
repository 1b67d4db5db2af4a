//! `uniaxialMaterial HystereticSM`.

use super::Kind;
use super::hysteretic::POINTS as POINT_NAMES;
use crate::args::Args;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown};
use hysteron_engine::material::{HystereticSm, Material, SmEnvelope};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;

const BETA: Arg = Arg::of("-beta", "beta", "exponent of the unloading stiffness beta").within(Domain::Number);

pub(super) const KINDS: &[Kind] = &[Kind {
    names: &["HystereticSM"],
    usage: "uniaxialMaterial HystereticSM $tag -posEnv $s1p $e1p $s2p $e2p ... <-negEnv $s1n $e1n $s2n $e2n ...> \
            <-pinch $pinchX $pinchY> <-damage $damage1 $damage2> <-beta $beta> <-degEnv $degEnvp <$degEnvn>> <-XYorder> \
            <-defoLimitStates $d1 ...> <-forceLimitStates $f1 ...> or $s1p $e1p ... $s1n $e1n ... $pinchX $pinchY \
            $damage1 $damage2 <$beta>",
    text: Text::new("Backbone of up to seven points a side with pinching, damage and a degrading envelope.")
        .example("uniaxialMaterial HystereticSM 77 -posEnv 1. 0.005 1.2 0.02 0.4 0.05 -pinch 0.7 0.4")
        .points(POINT_NAMES)
        .arguments(&[
            Arg::of("-posEnv", "s1p", "a number of the envelope in tension"),
            Arg::new("s1p", "stress at the first point in tension"),
            Arg::new("e1p", "strain at the first point in tension"),
            Arg::of("-negEnv", "s1n", "a number of the envelope in compression"),
            Arg::new("s1n", "stress at the first point in compression"),
            Arg::new("e1n", "strain at the first point in compression"),
            Arg::of("-pinch", "pinchX", "a factors of pinching"),
            Arg::new("pinchX", "pinching factor of strain"),
            Arg::new("pinchY", "pinching factor of stress"),
            Arg::of("-damage", "damage1", "a factors of damage"),
            Arg::new("damage1", "damage by ductility"),
            Arg::new("damage2", "damage by energy"),
            BETA,
            Arg::new("beta", "exponent of the unloading stiffness"),
            Arg::of("-degEnv", "degEnvp", "a losses of the envelopes"),
            Arg::flag("-XYorder", "points are given as strain and stress"),
            Arg::of("-defoLimitStates", "d1", "a limit state"),
            Arg::of("-forceLimitStates", "f1", "a limit state"),
        ]),
    make: hysteretic_sm,
}];

/// Largest and smallest number of the points of an envelope.
const POINTS: std::ops::RangeInclusive<usize> = 2..=7;

/// Numbers of an envelope as points (stress, strain), positive on both sides; `s` is the sign of the strains.
fn envelope(a: &Args<'_>, numbers: &[f64], s: f64) -> Result<SmEnvelope, Exception> {
    let side = if s > 0.0 { "in tension" } else { "in compression" };
    if !numbers.len().is_multiple_of(2) || !POINTS.contains(&(numbers.len() / 2)) {
        let message = format!("the envelope {side} has {} numbers", numbers.len());
        return Err(a.refuse(message, "expected 2 to 7 points of a stress and a strain"));
    }
    let points: Vec<(f64, f64)> = numbers.chunks_exact(2).map(|p| (s * p[0], s * p[1])).collect();
    let mut before = 0.0;
    for (i, (_, strain)) in points.iter().enumerate() {
        if *strain <= before {
            let message = format!("strain {} {side} is {}, not beyond {}", i + 1, s * strain, s * before);
            return Err(a.refuse(message, "expected strains that go away from zero"));
        }
        before = *strain;
    }
    let envelope = SmEnvelope::new(&points);
    if envelope.first_slopes().iter().any(|k| *k <= 0.0) {
        let message = format!("the envelope {side} falls in its first two parts");
        return Err(a.refuse(message, "expected stresses that rise up to the second point"));
    }
    Ok(envelope)
}

/// Up to two numbers; one stands for both.
fn pair(a: &mut Args<'_>, what: &str, default: [f64; 2]) -> Result<[f64; 2], Exception> {
    let numbers = a.floats(what)?;
    match *numbers.as_slice() {
        [] => Ok(default),
        [both] => Ok([both; 2]),
        [first, second] => Ok([first, second]),
        _ => Err(a.refuse(format!("{} numbers for the {what}", numbers.len()), "expected 2 at most")),
    }
}

/// Every pair of numbers in the other order.
fn swap(numbers: &mut [f64]) {
    numbers.chunks_exact_mut(2).for_each(|p| p.swap(0, 1));
}

fn hysteretic_sm(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let (mut positive, mut negative) = (vec![], vec![]);
    let (mut pinch, mut damage, mut beta, mut degrading, mut xy) = ([1.0; 2], [0.0; 2], 0.0, [0.0; 2], false);
    if a.at_number() {
        // As for Hysteretic: both envelopes, four factors, and the exponent if their number is odd.
        let mut numbers = a.floats("number of the envelopes")?;
        if numbers.len() % 2 == 1 {
            beta = numbers.pop().unwrap_or(0.0);
        }
        if numbers.len() < 12 {
            return Err(a.refuse(format!("HystereticSM: {} numbers", numbers.len()), "expected 12 at least"));
        }
        let factors = numbers.split_off(numbers.len() - 4);
        (pinch, damage) = ([factors[0], factors[1]], [factors[2], factors[3]]);
        negative = numbers.split_off(numbers.len() / 2);
        positive = numbers;
    }
    while let Some(option) = a.option() {
        match option.trim_start_matches('-') {
            "posEnv" | "Env" | "env" => positive = a.floats("number of the envelope in tension")?,
            "posEnvXY" | "EnvXY" | "envXY" => {
                xy = true;
                positive = a.floats("number of the envelope in tension")?;
            }
            "negEnv" | "negEnvXY" => negative = a.floats("number of the envelope in compression")?,
            "pinch" => pinch = pair(a, "factors of pinching", [1.0; 2])?,
            "damage" => damage = pair(a, "factors of damage", [0.0; 2])?,
            "beta" => beta = a.number(&BETA)?,
            "degEnv" => degrading = pair(a, "losses of the envelopes", [0.0; 2])?,
            "XYorder" | "xyOrder" => xy = true,
            // Of use to recorders of limit states alone.
            "defoLimitStates" | "defoLimitState" | "forceLimitStates" | "forceLimitState" => {
                a.floats("limit state")?;
            }
            "printInput" | "print" => {}
            _ => ignore_unknown(interp, a)?,
        }
    }
    if xy {
        swap(&mut positive);
        swap(&mut negative);
    }
    let tension = envelope(a, &positive, 1.0)?;
    let compression = if negative.is_empty() { tension.clone() } else { envelope(a, &negative, -1.0)? };
    Ok(HystereticSm::new([tension, compression], pinch, damage, beta, degrading).shared())
}
