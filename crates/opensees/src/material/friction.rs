//! `frictionModel`.

use crate::args::Args;
use crate::checks;
use crate::model::nodes::need_model;
use crate::text::Text;
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
    .defining(&[things::FRICTION], 2)
    .with_kinds(|| kind::usages(KINDS))];

/// A kind of friction model, made from the words after its tag.
type Kind = kind::Kind<fn(&mut Tcl, &mut Args<'_>) -> Result<Friction, Exception>>;

const KINDS: &[Kind] = &[
    Kind {
        names: &["Coulomb", "Constant"],
        usage: "frictionModel Coulomb $tag $mu",
        text: Text::new("A constant coefficient of friction."),
        make: coulomb,
    },
    Kind {
        names: &["VelDependent", "VDependent"],
        usage: "frictionModel VelDependent $tag $muSlow $muFast $transRate",
        text: Text::new("A coefficient that rises from slow to fast sliding."),
        make: vel_dependent,
    },
    Kind {
        names: &["VelPressureDep", "VPDependent"],
        usage: "frictionModel VelPressureDep $tag $muSlow $muFast0 $A $deltaMu $alpha $transRate",
        text: Text::new("A coefficient that depends on velocity and pressure."),
        make: vel_pressure_dep,
    },
    Kind {
        names: &["VelDepMultiLinear", "VDependentMultiLinear"],
        usage: "frictionModel VelDepMultiLinear $tag -vel $v1 $v2 ... -frn $mu1 $mu2 ...",
        text: Text::new("A coefficient given over velocity by points."),
        make: vel_dep_multi_linear,
    },
    Kind {
        names: &["VelNormalFrcDep", "VNDependent"],
        usage: "frictionModel VelNormalFrcDep $tag $aSlow $nSlow $aFast $nFast $alpha0 $alpha1 $alpha2 $maxMuFact",
        text: Text::new("A coefficient that depends on velocity and normal force."),
        make: vel_normal_frc_dep,
    },
];

fn friction_model(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    need_model(interp, call)?;
    let mut a = Args::new(call, USAGE);
    let kind = kind::take(&mut a, "kind of friction model", "friction model", KINDS.iter())?;
    interp.host.note_kind("frictionModel", kind.names[0]);
    let tag = a.int("tag of the friction model")?;
    let span = a.last_span();
    let made = (kind.make)(interp, &mut a)?;
    finish(interp, &a)?;
    if !interp.host.builder.definitions.frictions.add(tag, made) {
        return Err(a.exists_at(span, things::FRICTION, tag));
    }
    Ok(Value::EMPTY)
}

fn coulomb(_: &mut Tcl, a: &mut Args<'_>) -> Result<Friction, Exception> {
    Ok(Arc::new(Coulomb { mu: a.positive("coefficient of friction mu")? }))
}

/// The slow and the fast coefficient. Friction of sliding bearings grows with the speed: the other order is seldom meant.
fn slow_and_fast(interp: &mut Tcl, a: &mut Args<'_>, names: [&str; 2]) -> Result<(f64, f64), Exception> {
    let slow = a.positive(&format!("coefficient of friction at rest {}", names[0]))?;
    let fast = a.positive(&format!("coefficient of friction at high speed {}", names[1]))?;
    if slow > fast {
        let [s, f] = names;
        let d = Diagnostic::warning(
            &checks::materials::UNUSUAL_PARAMETER,
            format!("{s} is {slow}, more than {f}, {fast}: friction falls with the speed"),
        );
        warn(interp, d.at(a.last_span(), format!("expected a coefficient not less than {s}")))?;
    }
    Ok((slow, fast))
}

fn vel_dependent(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Friction, Exception> {
    let (slow, fast) = slow_and_fast(interp, a, ["muSlow", "muFast"])?;
    Ok(Arc::new(VelDependent { slow, fast, rate: a.not_negative("rate of the transition transRate")? }))
}

fn vel_pressure_dep(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Friction, Exception> {
    let (slow, fast) = slow_and_fast(interp, a, ["muSlow", "muFast0"])?;
    let area = a.positive("nominal contact area A")?;
    let delta = a.float("loss of friction under pressure deltaMu")?;
    if delta >= fast {
        let message = format!("deltaMu is {delta}: nothing is left of muFast0, {fast}, under high pressure");
        return Err(a.refuse(message, format!("expected a loss less than {fast}")));
    }
    let alpha = a.not_negative("pressure parameter alpha")?;
    Ok(Arc::new(VelPressureDep {
        slow,
        fast,
        area,
        delta,
        alpha,
        rate: a.not_negative("rate of the transition transRate")?,
    }))
}

fn vel_normal_frc_dep(_: &mut Tcl, a: &mut Args<'_>) -> Result<Friction, Exception> {
    let (a_slow, n_slow) = power(a, ["aSlow", "nSlow"])?;
    let (a_fast, n_fast) = power(a, ["aFast", "nFast"])?;
    let mut alpha = [0.0; 3];
    for (i, x) in alpha.iter_mut().enumerate() {
        *x = a.float(&format!("rate parameter alpha{i}"))?;
    }
    let max_factor = a.positive("largest coefficient over the fast one maxMuFact")?;
    Ok(Arc::new(VelNormalFrcDep { a_slow, n_slow, a_fast, n_fast, alpha, max_factor }))
}

/// Factor and exponent of a friction force a Nⁿ.
fn power(a: &mut Args<'_>, names: [&str; 2]) -> Result<(f64, f64), Exception> {
    let factor = a.positive(&format!("factor of the friction force {}", names[0]))?;
    let exponent = a.positive(&format!("exponent of the friction force {}", names[1]))?;
    if exponent > 1.0 {
        return Err(a.refuse(format!("{} is {exponent}", names[1]), "expected an exponent greater than 0, at most 1"));
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
