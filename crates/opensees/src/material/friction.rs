//! `frictionModel`.

use crate::args::Args;
use crate::checks;
use crate::model::nodes::need_model;
use crate::text::{Arg, Domain, Text};
use crate::things;
use crate::{Command, Outcome, Tcl, finish, kind, warn};
use hysteron_engine::element::friction::{
    Coulomb, Friction, VelDepMultiLinear, VelDependent, VelNormalFrcDep, VelPressureDep,
};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};
use std::sync::Arc;

const USAGE: &str = "frictionModel $kind $tag ...";

pub(crate) const COMMANDS: &[Command] = &[Command::new("frictionModel", USAGE, friction_model)
    .about("Makes a law of friction, for sliding bearings.")
    .arguments(&[TAG])
    .defining(&[things::FRICTION], 2)
    .with_kinds(|| kind::usages(KINDS))];

/// A kind of friction model, made from the words after its tag.
type Kind = kind::Kind<fn(&mut Tcl, &mut Args<'_>) -> Result<Friction, Exception>>;

const TAG: Arg = Arg::of_domain("tag", "tag of the friction model", Domain::Whole);

const MU: Arg = Arg::positive("mu", "coefficient of friction mu");
const COEFFICIENTS: [Arg; 2] = [
    Arg::positive("muSlow", "coefficient of friction at rest muSlow"),
    Arg::positive("muFast", "coefficient of friction at high speed muFast"),
];
const COEFFICIENTS_0: [Arg; 2] =
    [COEFFICIENTS[0], Arg::positive("muFast0", "coefficient of friction at high speed muFast0")];
const RATE: Arg = Arg::not_negative("transRate", "rate of the transition transRate");
const PRESSURE: [Arg; 2] =
    [Arg::positive("A", "nominal contact area A"), Arg::number("deltaMu", "loss of friction under pressure deltaMu")];
const ALPHA: Arg = Arg::not_negative("alpha", "pressure parameter alpha");

const SLOW: [Arg; 2] = [
    Arg::positive("aSlow", "factor of the friction force aSlow"),
    Arg::positive("nSlow", "exponent of the friction force nSlow"),
];
const FAST: [Arg; 2] = [
    Arg::positive("aFast", "factor of the friction force aFast"),
    Arg::positive("nFast", "exponent of the friction force nFast"),
];
const RATES: [Arg; 3] = [
    Arg::number("alpha0", "rate parameter alpha0"),
    Arg::number("alpha1", "rate parameter alpha1"),
    Arg::number("alpha2", "rate parameter alpha2"),
];
const LARGEST: Arg = Arg::positive("maxMuFact", "largest coefficient over the fast one maxMuFact");

const KINDS: &[Kind] = &[
    Kind {
        names: &["Coulomb", "Constant"],
        usage: "frictionModel Coulomb $tag $mu",
        text: Text::new("A constant coefficient of friction.").arguments(&[MU]),
        make: coulomb,
    },
    Kind {
        names: &["VelDependent", "VDependent"],
        usage: "frictionModel VelDependent $tag $muSlow $muFast $transRate",
        text: Text::new("A coefficient that rises from slow to fast sliding.").groups(&[&COEFFICIENTS, &[RATE]]),
        make: vel_dependent,
    },
    Kind {
        names: &["VelPressureDep", "VPDependent"],
        usage: "frictionModel VelPressureDep $tag $muSlow $muFast0 $A $deltaMu $alpha $transRate",
        text: Text::new("A coefficient that depends on velocity and pressure.").groups(&[
            &COEFFICIENTS_0,
            &PRESSURE,
            &[ALPHA, RATE],
        ]),
        make: vel_pressure_dep,
    },
    Kind {
        names: &["VelDepMultiLinear", "VDependentMultiLinear"],
        usage: "frictionModel VelDepMultiLinear $tag -vel $v1 $v2 ... -frn $mu1 $mu2 ...",
        text: Text::new("A coefficient given over velocity by points.")
            .arguments(&[Arg::of("-vel", "v1", "option -frn"), Arg::of("-frn", "mu1", "a coefficient of friction")]),
        make: vel_dep_multi_linear,
    },
    Kind {
        names: &["VelNormalFrcDep", "VNDependent"],
        usage: "frictionModel VelNormalFrcDep $tag $aSlow $nSlow $aFast $nFast $alpha0 $alpha1 $alpha2 $maxMuFact",
        text: Text::new("A coefficient that depends on velocity and normal force.").groups(&[
            &SLOW,
            &FAST,
            &RATES,
            &[LARGEST],
        ]),
        make: vel_normal_frc_dep,
    },
];

fn friction_model(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    need_model(interp, call)?;
    let mut a = Args::new(call, USAGE);
    let kind = kind::take(&mut a, "kind of friction model", "friction model", KINDS.iter())?;
    interp.host.note_kind("frictionModel", kind.names[0]);
    let tag = a.int(TAG.meaning)?;
    let span = a.last_span();
    let made = (kind.make)(interp, &mut a)?;
    finish(interp, &a)?;
    if !interp.host.builder.definitions.frictions.add(tag, made) {
        return Err(a.exists_at(span, things::FRICTION, tag));
    }
    Ok(Value::EMPTY)
}

fn coulomb(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Friction, Exception> {
    Ok(Arc::new(Coulomb { mu: a.read(interp, &MU)? }))
}

/// The slow and the fast coefficient. Friction of sliding bearings grows with the speed: the other order is seldom meant.
fn slow_and_fast(interp: &mut Tcl, a: &mut Args<'_>, args: &[Arg; 2]) -> Result<(f64, f64), Exception> {
    let [slow, fast] = a.read_all(interp, args)?;
    if slow > fast {
        let [s, f] = args.map(|arg| arg.name);
        let d = Diagnostic::warning(
            &checks::materials::UNUSUAL_PARAMETER,
            format!("{s} is {slow}, more than {f}, {fast}: friction falls with the speed"),
        );
        warn(interp, d.at(a.last_span(), format!("expected a coefficient not less than {s}")))?;
    }
    Ok((slow, fast))
}

fn vel_dependent(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Friction, Exception> {
    let (slow, fast) = slow_and_fast(interp, a, &COEFFICIENTS)?;
    Ok(Arc::new(VelDependent { slow, fast, rate: a.read(interp, &RATE)? }))
}

fn vel_pressure_dep(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Friction, Exception> {
    let (slow, fast) = slow_and_fast(interp, a, &COEFFICIENTS_0)?;
    let [area, delta] = a.read_all(interp, &PRESSURE)?;
    if delta >= fast {
        let message = format!("deltaMu is {delta}: nothing is left of muFast0, {fast}, under high pressure");
        return Err(a.refuse(message, format!("expected a loss less than {fast}")));
    }
    let [alpha, rate] = a.read_all(interp, &[ALPHA, RATE])?;
    Ok(Arc::new(VelPressureDep { slow, fast, area, delta, alpha, rate }))
}

fn vel_normal_frc_dep(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Friction, Exception> {
    let (a_slow, n_slow) = power(interp, a, &SLOW)?;
    let (a_fast, n_fast) = power(interp, a, &FAST)?;
    let alpha = a.read_all(interp, &RATES)?;
    let max_factor = a.read(interp, &LARGEST)?;
    Ok(Arc::new(VelNormalFrcDep { a_slow, n_slow, a_fast, n_fast, alpha, max_factor }))
}

/// Factor and exponent of a friction force a Nⁿ.
fn power(interp: &mut Tcl, a: &mut Args<'_>, args: &[Arg; 2]) -> Result<(f64, f64), Exception> {
    let [factor, exponent] = a.read_all(interp, args)?;
    if exponent > 1.0 {
        return Err(
            a.refuse(format!("{} is {exponent}", args[1].name), "expected an exponent greater than 0, at most 1")
        );
    }
    Ok((factor, exponent))
}

fn vel_dep_multi_linear(_: &mut Tcl, a: &mut Args<'_>) -> Result<Friction, Exception> {
    let speeds = points(a, "-vel", "speed")?;
    let span = a.last_span();
    let coefficients = points(a, "-frn", "coefficient of friction")?;
    if speeds.len() != coefficients.len() {
        let message = format!("{} speeds and {} coefficients of friction", speeds.len(), coefficients.len());
        return Err(a.refuse(message, "expected as many coefficients as speeds"));
    }
    if let Some(w) = speeds.windows(2).find(|w| w[0] >= w[1]) {
        return Err(a.refuse_at(
            span,
            format!("the speed {} does not follow {}", w[1], w[0]),
            "expected rising speeds",
        ));
    }
    let points = speeds.into_iter().zip(coefficients).map(|(v, mu)| [v, mu]).collect();
    let law =
        VelDepMultiLinear::new(points).ok_or_else(|| a.refuse("one point is given", "expected two points or more"))?;
    Ok(Arc::new(law))
}

/// Numbers not less than 0 after an option that must stand here.
fn points(a: &mut Args<'_>, option: &str, what: &str) -> Result<Vec<f64>, Exception> {
    let found = a.word(&format!("option {option}"))?;
    if found != option {
        return Err(a.refuse(format!("expected the option {option}, found \"{found}\""), format!("expected {option}")));
    }
    let all = a.floats(what)?;
    match all.iter().find(|x| **x < 0.0) {
        Some(x) => Err(a.refuse(format!("a {what} is {x}"), format!("expected each {what} not less than 0"))),
        None => Ok(all),
    }
}
