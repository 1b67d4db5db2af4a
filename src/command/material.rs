//! `uniaxialMaterial`.

use super::args::Args;
use super::{Command, Outcome, Tcl, finish, warn};
use crate::diagnostic::Diagnostic;
use crate::material::{BoucWen, Elastic, ElasticPP, Material, Steel01, Viscous};
use crate::script::{Call, Exception, Value};
use std::sync::Arc;

pub(super) const COMMANDS: &[Command] =
    &[Command { name: "uniaxialMaterial", usage: "uniaxialMaterial $kind $tag ...", run: uniaxial_material }];

/// A kind of material and how it is made from the words after its tag.
struct Kind {
    name: &'static str,
    usage: &'static str,
    make: fn(&mut Tcl, &mut Args<'_>) -> Result<Material, Exception>,
}

const KINDS: &[Kind] = &[
    Kind { name: "Elastic", usage: "uniaxialMaterial Elastic $tag $E <$eta> <$Eneg>", make: elastic },
    Kind { name: "ElasticPP", usage: "uniaxialMaterial ElasticPP $tag $E $epsyP <$epsyN> <$eps0>", make: elastic_pp },
    Kind { name: "Steel01", usage: "uniaxialMaterial Steel01 $tag $Fy $E0 $b <$a1 $a2 $a3 $a4>", make: steel01 },
    Kind {
        name: "BoucWen",
        usage: "uniaxialMaterial BoucWen $tag $alpha $ko $n $gamma $beta $Ao $deltaA $deltaNu $deltaEta",
        make: bouc_wen,
    },
    Kind { name: "Viscous", usage: "uniaxialMaterial Viscous $tag $C $alpha <$minVel>", make: viscous },
];

fn uniaxial_material(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "uniaxialMaterial $kind $tag ...");
    let name = a.word("kind of material")?;
    let Some(kind) = KINDS.iter().find(|k| k.name == name) else {
        return Err(a.unknown_name("uniaxial material", KINDS.iter().map(|k| k.name)));
    };
    a.usage(kind.usage);
    let tag = a.int("tag of the material")?;
    let span = a.last_span();
    let material = (kind.make)(interp, &mut a)?;
    finish(interp, &a)?;
    if !interp.host.definitions.materials.add(tag, material) {
        return Err(a.refuse_at(span, format!("there is a uniaxial material {tag} already"), "expected a new tag"));
    }
    Ok(Value::EMPTY)
}

fn elastic(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = a.float("elastic modulus E")?;
    let eta = a.optional_float("damping modulus eta")?.unwrap_or(0.0);
    let e_neg = a.optional_float("modulus in compression Eneg")?.unwrap_or(e);
    Ok(Arc::new(Elastic { e_pos: e, eta, e_neg }))
}

fn elastic_pp(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = a.positive("elastic modulus E")?;
    let yield_strain = a.float("yield strain in tension epsyP")?;
    let compression = a.optional_float("yield strain in compression epsyN")?.unwrap_or(-yield_strain);
    let initial = a.optional_float("initial strain eps0")?.unwrap_or(0.0);
    Ok(Arc::new(ElasticPP::new(e, yield_strain, compression, initial)))
}

fn steel01(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let fy = a.positive("yield strength Fy")?;
    let e0 = a.positive("elastic modulus E0")?;
    let b = a.float("hardening ratio b")?;
    let mut isotropic = Steel01::NO_ISOTROPIC;
    if a.left() > 0 {
        for (value, name) in isotropic.iter_mut().zip(["a1", "a2", "a3", "a4"]) {
            *value = a.float(&format!("isotropic hardening parameter {name}"))?;
        }
    }
    Ok(Arc::new(Steel01 { fy, e0, b, a: isotropic }))
}

fn bouc_wen(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let law = BoucWen {
        alpha: a.float("ratio of post-yield stiffness alpha")?,
        ko: a.float("elastic stiffness ko")?,
        n: a.positive("exponent n")?,
        gamma: a.float("gamma")?,
        beta: a.float("beta")?,
        ao: a.float("Ao")?,
        delta_a: a.float("deltaA")?,
        delta_nu: a.float("deltaNu")?,
        delta_eta: a.float("deltaEta")?,
    };
    // Tolerance and number of iterations: the root is always found to round-off.
    a.optional_float("tolerance")?;
    a.optional_int("largest number of iterations")?;
    if law.beta + law.gamma <= 0.0 {
        let message = "BoucWen: beta + gamma is not greater than 0, so the hysteretic force is not bounded";
        warn(interp, Diagnostic::warning(message).at(None, ""))?;
    }
    Ok(Arc::new(law))
}

fn viscous(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let c = a.float("damping coefficient C")?;
    let alpha = a.float("velocity exponent alpha")?;
    let min_rate = a.optional_float("smallest velocity minVel")?.unwrap_or(1e-11).abs();
    // As in OpenSees a negative exponent stands for a linear dashpot, and a zero velocity for a very small one.
    let min_rate = if min_rate == 0.0 { 1e-21 } else { min_rate };
    Ok(Arc::new(Viscous { c, alpha: if alpha < 0.0 { 1.0 } else { alpha }, min_rate }))
}
