//! Smooth hysteresis.

use super::Kind;
use crate::Tcl;
use crate::args::Args;
use crate::slips;
use hysteron_engine::material::{HystereticAsym, HystereticPoly, HystereticSmooth, Material};
use hysteron_tcl::Exception;
use std::sync::Arc;

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["HystereticSmooth"],
        usage: "uniaxialMaterial HystereticSmooth $tag $ka $kb $fbar $beta <-alpha>",
        make: smooth,
    },
    Kind {
        names: &["HystereticAsym"],
        usage: "uniaxialMaterial HystereticAsym $tag $ka $kb $fo $b1 $b2 $gamma <-alpha>",
        make: asym,
    },
    Kind {
        names: &["HystereticPoly"],
        usage: "uniaxialMaterial HystereticPoly $tag $ka $kb $a $b1 $b2 <$tol>",
        make: poly,
    },
];

/// ka and kb, which is less.
fn stiffnesses(a: &mut Args<'_>) -> Result<[f64; 2], Exception> {
    let ka = a.positive("stiffness ka at the beginning of a branch")?;
    let kb = a.float("stiffness kb of the limit curves")?;
    if kb >= ka {
        return Err(
            a.refuse(format!("the stiffness kb of the limit curves is {kb}"), format!("expected less than ka, {ka}"))
        );
    }
    Ok([ka, kb])
}

/// Half the height of the loop, which may be given by the parameter alpha = (ka - kb) / (2 f).
fn height(a: &mut Args<'_>, [ka, kb]: [f64; 2], given: f64) -> f64 {
    if a.flag("-alpha") { 0.5 * (ka - kb) / given } else { given }
}

fn smooth(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let k = stiffnesses(a)?;
    let given = a.positive("half the height of the loop fbar")?;
    let beta = a.float("beta")?;
    Ok(Arc::new(HystereticSmooth::new(k[0], k[1], height(a, k, given), beta)))
}

fn asym(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let k = stiffnesses(a)?;
    let given = a.positive("half the height of the loop fo")?;
    let b = [a.float("b1")?, a.float("b2")?];
    let gamma = a.float("growth of the loop gamma")?;
    Ok(Arc::new(HystereticAsym { ka: k[0], kb: k[1], fo: height(a, k, given), b, gamma }))
}

fn poly(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [ka, kb] = stiffnesses(a)?;
    let exponent = a.positive("exponent a")?;
    if exponent == 1.0 {
        return Err(a.refuse("the exponent a is 1", "expected a positive number other than 1"));
    }
    let b = [a.float("b1")?, a.float("b2")?];
    let tolerance = match a.left() {
        0 => HystereticPoly::TOLERANCE,
        _ => a.positive("tolerance tol")?,
    };
    let compat = interp.host.follows(&[slips::HYSTERETIC_POLY_BRANCH]);
    Ok(Arc::new(HystereticPoly { ka, kb, a: exponent, b, tolerance, compat }))
}
