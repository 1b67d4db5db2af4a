//! Smooth hysteresis.

use super::Kind;
use crate::args::Args;
use crate::checks;
use crate::text::{Arg, Text};
use crate::{Tcl, slips, warn};
use hysteron_engine::material::{Bwbn, HystereticAsym, HystereticPoly, HystereticSmooth, Material, Sma, Sma3k};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["HystereticSmooth"],
        usage: "uniaxialMaterial HystereticSmooth $tag $ka $kb $fbar $beta <-alpha>",
        text: Text::new("Smooth hysteresis in closed form, symmetric."),
        make: smooth,
    },
    Kind {
        names: &["HystereticAsym"],
        usage: "uniaxialMaterial HystereticAsym $tag $ka $kb $fo $b1 $b2 $gamma <-alpha>",
        text: Text::new("Smooth hysteresis in closed form, asymmetric."),
        make: asym,
    },
    Kind {
        names: &["HystereticPoly"],
        usage: "uniaxialMaterial HystereticPoly $tag $ka $kb $a $b1 $b2 <$tol>",
        text: Text::new("Smooth hysteresis in closed form, by polynomials."),
        make: poly,
    },
    Kind {
        names: &["BWBN"],
        usage: "uniaxialMaterial BWBN $tag $alpha $ko $n $gamma $beta $Ao $q $zetas $p $Shi $deltaShi $lambda $tol \
                $maxIter",
        text: Text::new("Bouc-Wen hysteresis with pinching (Baber and Noori).")
            .example("uniaxialMaterial BWBN 77 0.1 1000. 1.7 15. 25. 1. 0.4 0.9 0.5 0.4 0.05 0.3 1e-8 100"),
        make: bwbn,
    },
    Kind {
        names: &["ASD_SMA_3K"],
        usage: "uniaxialMaterial ASD_SMA_3K $tag $k1 $k2 $k3 $sigAct $beta",
        text: Text::new("Shape-memory alloy with three stiffnesses.")
            .example("uniaxialMaterial ASD_SMA_3K 77 200. 5. 60. 2. 0.6")
            .arguments(&[
                Arg::new("sigAct", "force at which the upper plateau begins"),
                Arg::new("beta", "height of the flag over that force"),
            ]),
        make: sma_3k,
    },
    Kind {
        names: &["SMA"],
        usage: "uniaxialMaterial SMA $tag $E $epsL $sigAMs $sigAMf $sigMAs $sigMAf",
        text: Text::new("Superelastic shape-memory alloy (Auricchio, Taylor and Lubliner).")
            .example("uniaxialMaterial SMA 77 200. 0.04 2. 2.6 1.5 0.8"),
        make: sma,
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
    Ok(HystereticSmooth::new(k[0], k[1], height(a, k, given), beta).shared())
}

fn asym(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let k = stiffnesses(a)?;
    let given = a.positive("half the height of the loop fo")?;
    let b = [a.float("b1")?, a.float("b2")?];
    let gamma = a.float("growth of the loop gamma")?;
    Ok(HystereticAsym { ka: k[0], kb: k[1], fo: height(a, k, given), b, gamma }.shared())
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
    Ok(HystereticPoly { ka, kb, a: exponent, b, tolerance, compat }.shared())
}

fn bwbn(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let alpha = a.float("ratio of post-yield stiffness alpha")?;
    let ko = a.positive("elastic stiffness ko")?;
    let n = a.positive("exponent n")?;
    let gamma = a.float("gamma")?;
    let beta = a.float("beta")?;
    if beta + gamma <= 0.0 {
        return Err(a.refuse(format!("beta + gamma is {}", beta + gamma), "expected a sum greater than 0"));
    }
    Ok(Bwbn {
        alpha,
        ko,
        n,
        gamma,
        beta,
        ao: a.float("Ao")?,
        q: a.float("share q of the strength at which the loop is pinched most")?,
        zetas: a.not_negative("total slip zetas")?,
        p: a.not_negative("rate p of the pinching")?,
        shi: a.positive("spread Shi of the pinching")?,
        delta_shi: a.not_negative("growth deltaShi of the spread")?,
        lambda: a.positive("lambda")?,
        tolerance: a.positive("tolerance")?,
        iterations: a.count("largest number of iterations maxIter")?,
    }
    .shared())
}

fn sma(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let e = a.positive("elastic modulus E")?;
    let eps_l = a.positive("largest strain of transformation epsL")?;
    let forward = [
        a.float("stress sigAMs at the start of austenite to martensite")?,
        a.float("stress sigAMf at the finish of austenite to martensite")?,
    ];
    let reverse = [
        a.float("stress sigMAs at the start of martensite to austenite")?,
        a.float("stress sigMAf at the finish of martensite to austenite")?,
    ];
    let [start, finish] = forward;
    if !(0.0 < start && start <= finish && finish >= reverse[0] && 0.0 <= reverse[1] && reverse[1] <= reverse[0]) {
        let d = Diagnostic::warning(
            &checks::materials::UNUSUAL_PARAMETER,
            "the stresses of the transformations are out of order",
        );
        warn(interp, d.at(a.last_span(), "expected 0 <= sigMAf <= sigMAs, 0 < sigAMs <= sigAMf"))?;
    }
    Ok(Sma { e, eps_l, forward, reverse }.shared())
}

fn sma_3k(_: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let k1 = a.positive("elastic stiffness k1")?;
    let (k2, k3) = (a.not_negative("stiffness of the plateaus k2")?, a.positive("stiffness of unloading k3")?);
    if k2 >= k1 || k3 > k1 || k3 <= k2 {
        return Err(a.refuse(format!("k1, k2 and k3 are {k1}, {k2}, {k3}"), "expected k2 < k3 <= k1 and k2 < k1"));
    }
    let force = a.positive("force of activation sigAct")?;
    let beta = a.float("height of the flag beta")?;
    if !(0.0..=1.0).contains(&beta) {
        return Err(a.refuse(format!("the height of the flag beta is {beta}"), "expected 0 to 1"));
    }
    Ok(Sma3k { k1, k2, k3, force, beta }.shared())
}
