//! Smooth hysteresis.

use super::Kind;
use crate::args::Args;
use crate::checks;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, slips, warn};
use hysteron_engine::material::{
    BoucWenOriginal, Bwbn, HystereticAsym, HystereticPoly, HystereticSmooth, Material, Sma, Sma3k,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;

const STIFFNESSES: [Arg; 2] = [
    Arg::positive("ka", "stiffness ka at the beginning of a branch"),
    Arg::number("kb", "stiffness kb of the limit curves"),
];
const SYMMETRIC: [Arg; 2] = [Arg::positive("fbar", "half the height of the loop fbar"), Arg::number("beta", "beta")];
const ASYMMETRIC: [Arg; 4] = [
    Arg::positive("fo", "half the height of the loop fo"),
    Arg::number("b1", "b1"),
    Arg::number("b2", "b2"),
    Arg::number("gamma", "growth of the loop gamma"),
];
const EXPONENT: Arg = Arg::positive("a", "exponent a");
const SHAPE: [Arg; 2] = [Arg::number("b1", "b1"), Arg::number("b2", "b2")];
const TOLERANCE: Arg = Arg::positive("tol", "tolerance tol");

const BOUC_WEN: [Arg; 5] = [
    Arg::number("alpha", "ratio of post-yield stiffness alpha"),
    Arg::positive("ko", "elastic stiffness ko"),
    Arg::positive("n", "exponent n"),
    Arg::number("gamma", "gamma"),
    Arg::number("beta", "beta"),
];
const PINCHING: [Arg; 8] = [
    Arg::number("Ao", "Ao"),
    Arg::number("q", "share q of the strength at which the loop is pinched most"),
    Arg::not_negative("zetas", "total slip zetas"),
    Arg::not_negative("p", "rate p of the pinching"),
    Arg::positive("Shi", "spread Shi of the pinching"),
    Arg::not_negative("deltaShi", "growth deltaShi of the spread"),
    Arg::positive("lambda", "lambda"),
    Arg::positive("tol", "tolerance"),
];
const ITERATIONS: Arg = Arg::of_domain("maxIter", "largest number of iterations maxIter", Domain::Count);

const ORIGINAL: [Arg; 3] = [
    Arg::positive("E", "elastic modulus E"),
    Arg::positive("fy", "yield strength fy"),
    Arg::number("alphaL", "ratio alphaL of the linear stiffness to E"),
];
const ORIGINAL_SHAPE: [Arg; 5] = [
    Arg::number("alphaNL", "ratio alphaNL of the hardening part to E; 0 where it is left out"),
    Arg::positive("mu", "exponent mu of the hardening part; 2 where it is left out"),
    Arg::positive("eta", "exponent eta of the yielding; 1 where it is left out"),
    Arg::number("beta", "shape beta of the loop; 0.5 where it is left out"),
    Arg::number("gamma", "shape gamma of the loop; 0.5 where it is left out"),
];

const ALLOY: [Arg; 3] = [
    Arg::positive("k1", "elastic stiffness k1"),
    Arg::not_negative("k2", "stiffness of the plateaus k2"),
    Arg::positive("k3", "stiffness of unloading k3"),
];
const FLAG: [Arg; 2] =
    [Arg::positive("sigAct", "force of activation sigAct"), Arg::number("beta", "height of the flag beta")];

const AUSTENITE: [Arg; 6] = [
    Arg::positive("E", "elastic modulus E"),
    Arg::positive("epsL", "largest strain of transformation epsL"),
    Arg::number("sigAMs", "stress sigAMs at the start of austenite to martensite"),
    Arg::number("sigAMf", "stress sigAMf at the finish of austenite to martensite"),
    Arg::number("sigMAs", "stress sigMAs at the start of martensite to austenite"),
    Arg::number("sigMAf", "stress sigMAf at the finish of martensite to austenite"),
];

pub(super) const KINDS: &[Kind] = &[
    Kind {
        names: &["HystereticSmooth"],
        usage: "uniaxialMaterial HystereticSmooth $tag $ka $kb $fbar $beta <-alpha>",
        text: Text::new("Smooth hysteresis in closed form, symmetric.")
            .example("uniaxialMaterial HystereticSmooth 77 1 0.5 1 1")
            .groups(&[&STIFFNESSES, &SYMMETRIC]),
        make: smooth,
    },
    Kind {
        names: &["HystereticAsym"],
        usage: "uniaxialMaterial HystereticAsym $tag $ka $kb $fo $b1 $b2 $gamma <-alpha>",
        text: Text::new("Smooth hysteresis in closed form, asymmetric.")
            .example("uniaxialMaterial HystereticAsym 77 1 0.5 1 1 1 1")
            .groups(&[&STIFFNESSES, &ASYMMETRIC]),
        make: asym,
    },
    Kind {
        names: &["HystereticPoly"],
        usage: "uniaxialMaterial HystereticPoly $tag $ka $kb $a $b1 $b2 <$tol>",
        text: Text::new("Smooth hysteresis in closed form, by polynomials.")
            .example("uniaxialMaterial HystereticPoly 77 1 0.5 2 1 1")
            .groups(&[&STIFFNESSES, &[EXPONENT], &SHAPE, &[TOLERANCE]]),
        make: poly,
    },
    Kind {
        names: &["BWBN"],
        usage: "uniaxialMaterial BWBN $tag $alpha $ko $n $gamma $beta $Ao $q $zetas $p $Shi $deltaShi $lambda $tol \
                $maxIter",
        text: Text::new("Bouc-Wen hysteresis with pinching (Baber and Noori).")
            .example("uniaxialMaterial BWBN 77 0.1 1000. 1.7 15. 25. 1. 0.4 0.9 0.5 0.4 0.05 0.3 1e-8 100")
            .groups(&[&BOUC_WEN, &PINCHING, &[ITERATIONS]]),
        make: bwbn,
    },
    Kind {
        names: &["BoucWenOriginal"],
        usage: "uniaxialMaterial BoucWenOriginal $tag $E $fy $alphaL <$alphaNL> <$mu> <$eta> <$beta> <$gamma> <$tol> <$maxIter>",
        text: Text::new("Bouc-Wen hysteresis by its yield strength, with an elastic part that hardens.")
            .example("uniaxialMaterial BoucWenOriginal 77 200. 2. 0.05")
            .groups(&[&ORIGINAL, &ORIGINAL_SHAPE, &[TOLERANCE, ITERATIONS]]),
        make: bouc_wen_original,
    },
    Kind {
        names: &["ASD_SMA_3K"],
        usage: "uniaxialMaterial ASD_SMA_3K $tag $k1 $k2 $k3 $sigAct $beta",
        text: Text::new("Shape-memory alloy with three stiffnesses.")
            .example("uniaxialMaterial ASD_SMA_3K 77 200. 5. 60. 2. 0.6")
            .groups(&[&ALLOY, &FLAG]),
        make: sma_3k,
    },
    Kind {
        names: &["SMA"],
        usage: "uniaxialMaterial SMA $tag $E $epsL $sigAMs $sigAMf $sigMAs $sigMAf",
        text: Text::new("Superelastic shape-memory alloy (Auricchio, Taylor and Lubliner).")
            .example("uniaxialMaterial SMA 77 200. 0.04 2. 2.6 1.5 0.8")
            .groups(&[&AUSTENITE]),
        make: sma,
    },
];

fn bouc_wen_original(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [e, fy, alpha_l] = a.read_all(interp, &ORIGINAL)?;
    let mut shape = [0.0, 2.0, 1.0, 0.5, 0.5];
    for (value, arg) in shape.iter_mut().zip(&ORIGINAL_SHAPE) {
        *value = a.read_or(interp, arg, *value)?;
    }
    let [alpha_nl, mu, eta, beta, gamma] = shape;
    if alpha_nl != 0.0 && mu < 1.0 {
        return Err(a.refuse(
            format!("the exponent mu is {mu}"),
            "expected at least 1: the stiffness at rest would be infinite",
        ));
    }
    // Found to round-off here.
    a.read_optional(interp, &TOLERANCE)?;
    a.read_optional(interp, &ITERATIONS)?;
    Ok(BoucWenOriginal::new([e, fy], [alpha_l, alpha_nl, mu], [eta, beta, gamma]).shared())
}

/// ka and kb, which is less.
fn stiffnesses(interp: &mut Tcl, a: &mut Args<'_>) -> Result<[f64; 2], Exception> {
    let [ka, kb] = a.read_all(interp, &STIFFNESSES)?;
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

fn smooth(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let k = stiffnesses(interp, a)?;
    let [given, beta] = a.read_all(interp, &SYMMETRIC)?;
    Ok(HystereticSmooth::new(k[0], k[1], height(a, k, given), beta).shared())
}

fn asym(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let k = stiffnesses(interp, a)?;
    let [given, b1, b2, gamma] = a.read_all(interp, &ASYMMETRIC)?;
    Ok(HystereticAsym { ka: k[0], kb: k[1], fo: height(a, k, given), b: [b1, b2], gamma }.shared())
}

fn poly(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [ka, kb] = stiffnesses(interp, a)?;
    let exponent = a.read(interp, &EXPONENT)?;
    if exponent == 1.0 {
        return Err(a.refuse("the exponent a is 1", "expected a positive number other than 1"));
    }
    let b = a.read_all(interp, &SHAPE)?;
    let tolerance = match a.left() {
        0 => HystereticPoly::TOLERANCE,
        _ => a.read(interp, &TOLERANCE)?,
    };
    let compat = interp.host.follows(&[slips::HYSTERETIC_POLY_BRANCH]);
    Ok(HystereticPoly { ka, kb, a: exponent, b, tolerance, compat }.shared())
}

fn bwbn(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [alpha, ko, n, gamma, beta] = a.read_all(interp, &BOUC_WEN)?;
    if beta + gamma <= 0.0 {
        return Err(a.refuse(format!("beta + gamma is {}", beta + gamma), "expected a sum greater than 0"));
    }
    let [ao, q, zetas, p, shi, delta_shi, lambda, tolerance] = a.read_all(interp, &PINCHING)?;
    let iterations = a.count(&ITERATIONS)?;
    let law = Bwbn { alpha, ko, n, gamma, beta, ao, q, zetas, p, shi, delta_shi, lambda, tolerance, iterations };
    Ok(law.shared())
}

fn sma(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [e, eps_l, start, finish, back, end] = a.read_all(interp, &AUSTENITE)?;
    let (forward, reverse) = ([start, finish], [back, end]);
    if !(0.0 < start && start <= finish && finish >= reverse[0] && 0.0 <= reverse[1] && reverse[1] <= reverse[0]) {
        let d = Diagnostic::warning(
            &checks::materials::UNUSUAL_PARAMETER,
            "the stresses of the transformations are out of order",
        );
        warn(interp, d.at(a.last_span(), "expected 0 <= sigMAf <= sigMAs, 0 < sigAMs <= sigAMf"))?;
    }
    Ok(Sma { e, eps_l, forward, reverse }.shared())
}

fn sma_3k(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Material, Exception> {
    let [k1, k2, k3] = a.read_all(interp, &ALLOY)?;
    if k2 >= k1 || k3 > k1 || k3 <= k2 {
        return Err(a.refuse(format!("k1, k2 and k3 are {k1}, {k2}, {k3}"), "expected k2 < k3 <= k1 and k2 < k1"));
    }
    let [force, beta] = a.read_all(interp, &FLAG)?;
    if !(0.0..=1.0).contains(&beta) {
        return Err(a.refuse(format!("the height of the flag beta is {beta}"), "expected 0 to 1"));
    }
    Ok(Sma3k { k1, k2, k3, force, beta }.shared())
}
