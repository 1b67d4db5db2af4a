//! `element KikuchiBearing`.

use super::multiple_springs::{LAMBDA, Orient, distribution, divisions, once, option_missing, shape};
use super::{Ends, Kind, Make, refused};
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown, warn};
use hysteron_engine::element::Element;
use hysteron_engine::element::bearing::{
    Balance, Distribution, KikuchiBearing, KikuchiParameters, Layout, Mean, Scheme, Shape,
};
use hysteron_engine::material::Material;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::{Diagnostic, Span};
use std::sync::Arc;

const SIZE: Arg = Arg::of("-size", "size", "diameter or edge of the bearing").within(Domain::Positive);
const TOTAL_RUBBER: Arg = Arg::of("-size", "totalRubber", "total thickness of the rubber").within(Domain::Positive);
const CI: Arg = Arg::of("-adjustPDOutput", "ci", "share ci of the P-Delta moment at i").within(Domain::Positive);
const CJ: Arg = Arg::of("-adjustPDOutput", "cj", "share cj at j").within(Domain::Positive);
const LIM_FO: Arg = Arg::of("-doBalance", "limFo", "largest unbalanced external force limFo").within(Domain::Positive);
const LIM_FI: Arg = Arg::of("-doBalance", "limFi", "largest unbalanced internal force limFi").within(Domain::Positive);
const N_ITER: Arg = Arg::of("-doBalance", "nIter", "largest number nIter of corrections").within(Domain::Count);

const TOTAL_HEIGHT_HEIGHT: Arg =
    Arg::of("-totalHeight", "height", "total height of the bearing").within(Domain::Positive);
const N_MSS: Arg = Arg::of("-nMSS", "nMSS", "number nMSS of shear springs").within(Domain::Count);
const N_MNS: Arg = Arg::of("-nMNS", "nMNS", "number nMNS of normal springs across the section").within(Domain::Count);
const LIM_DISP: Arg = Arg::of("-limDisp", "limDisp", "displacement limDisp of the scaling").within(Domain::NotNegative);

pub(super) const KIKUCHI: Kind = Kind {
    names: &["KikuchiBearing"],
    usage: "element KikuchiBearing $tag $i $j -shape round|square -size $size $totalRubber <-totalHeight $height> \
            -nMSS $nMSS -matMSS $mat <-limDisp $limDisp> -nMNS $nMNS -matMNS $mat <-lambda $lambda> \
            <-orient <$x1 $x2 $x3> $yp1 $yp2 $yp3> <-mass $m> <-noPDInput> <-noTilt> <-adjustPDOutput $ci $cj> \
            <-doBalance $limFo $limFi $nIter>",
    text: Text::new("Bearing of shear springs between two sections of normal springs, with P-Delta and tilt.")
        .example("element KikuchiBearing 2 1 2 -shape round -size 1 1 -nMSS 1 -matMSS 1 -nMNS 1 -matMNS 1")
        .arguments(&[
            SIZE,
            TOTAL_RUBBER,
            TOTAL_HEIGHT_HEIGHT,
            N_MSS,
            Arg::of("-matMSS", "mat", "tag of a uniaxial material").within(Domain::Whole),
            LIM_DISP,
            N_MNS,
            Arg::of("-matMNS", "mat", "tag of a uniaxial material").within(Domain::Whole),
            LAMBDA,
            super::MASS_ABOVE_ZERO,
            CI,
            CJ,
            LIM_FO,
            LIM_FI,
            N_ITER,
        ]),
    make: Make::TwoNodes(make),
};

const NAME: &str = "KikuchiBearing";

/// The options as they have been given.
struct Options {
    shape: Option<Shape>,
    size: Option<(f64, f64)>,
    height: Option<f64>,
    shear_springs: Option<usize>,
    shear: Option<Material>,
    limit: Option<f64>,
    normal_springs: Option<usize>,
    normal: Option<Material>,
    lambda: Option<Distribution>,
    orient: Option<Orient>,
    mass: Option<f64>,
    p_delta: bool,
    tilt: bool,
    shares: Option<[f64; 2]>,
    balance: Option<Balance>,
}

fn options(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Options, Exception> {
    let mut o = Options {
        shape: None,
        size: None,
        height: None,
        shear_springs: None,
        shear: None,
        limit: None,
        normal_springs: None,
        normal: None,
        lambda: None,
        orient: None,
        mass: None,
        p_delta: true,
        tilt: true,
        shares: None,
        balance: None,
    };
    /// Keep the value of an option that may stand once.
    macro_rules! keep {
        ($field:ident, $option:expr, $value:expr) => {{
            once(a, &o.$field, $option)?;
            o.$field = Some($value);
        }};
    }
    while let Some(option) = a.option() {
        let option = option.as_ref();
        match option {
            "-shape" => keep!(shape, option, shape(a)?),
            "-size" => {
                let size = |a: &mut Args<'_>| Ok::<_, Exception>((a.number(&SIZE)?, a.number(&TOTAL_RUBBER)?));
                keep!(size, option, size(a)?)
            }
            "-totalHeight" => keep!(height, option, a.number(&TOTAL_HEIGHT_HEIGHT)?),
            "-nMSS" => keep!(shear_springs, option, divisions(a, &N_MSS)?),
            "-matMSS" => keep!(shear, option, a.of(&interp.host.builder.definitions.materials)?.0),
            "-limDisp" => keep!(limit, option, limit(a)?),
            "-nMNS" => {
                keep!(normal_springs, option, divisions(a, &N_MNS)?)
            }
            "-matMNS" => keep!(normal, option, a.of(&interp.host.builder.definitions.materials)?.0),
            "-lambda" => keep!(lambda, option, distribution(a)?),
            "-orient" => {
                let mut orient = Orient::default();
                orient.take(a)?;
                keep!(orient, option, orient)
            }
            "-mass" => keep!(mass, option, a.number(&super::MASS_ABOVE_ZERO)?),
            "-noPDInput" => o.p_delta = false,
            "-noTilt" => o.tilt = false,
            "-adjustPDOutput" => {
                let shares = [a.number(&CI)?, a.number(&CJ)?];
                keep!(shares, option, shares)
            }
            "-doBalance" => {
                a.number(&LIM_FO)?;
                let tolerance = a.number(&LIM_FI)?;
                let rounds = a.count(&N_ITER)? as u32;
                keep!(balance, option, Balance { tolerance, rounds })
            }
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok(o)
}

/// The displacement from which on the shear forces are scaled.
fn limit(a: &mut Args<'_>) -> Result<f64, Exception> {
    let limit = a.number(&LIM_DISP)?;
    if limit == 0.0 {
        let label = "expected a displacement greater than 0: at rest there is no force to scale";
        return Err(a.refuse("-limDisp is 0", label));
    }
    Ok(limit)
}

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need(a, (3, 6))?;
    let o = options(interp, a)?;
    let missing = |option, what| option_missing(a, nodes, NAME, option, what);
    let shape = o.shape.ok_or_else(|| missing("-shape", "round or square"))?;
    let (size, rubber) =
        o.size.ok_or_else(|| missing("-size", "the diameter or edge and the total thickness of the rubber"))?;
    let shear_springs = o.shear_springs.ok_or_else(|| missing("-nMSS", "the number of shear springs"))?;
    let shear = o.shear.ok_or_else(|| missing("-matMSS", "the tag of their material"))?;
    let n = o.normal_springs.ok_or_else(|| missing("-nMNS", "the number of normal springs across the section"))?;
    let normal = o.normal.ok_or_else(|| missing("-matMNS", "the tag of their material"))?;
    let (axes, length) = o.orient.unwrap_or_default().axes(a, ends, nodes)?;
    let height = o.height.unwrap_or(length);
    if height == 0.0 {
        let message = format!("{NAME}: its nodes are at one place, and -totalHeight is missing");
        return Err(a.refuse_at(nodes, message, "expected nodes at a distance, or -totalHeight"));
    }
    if o.limit.is_none() && shear_springs > 2 {
        warn_unscaled(interp, nodes, shear_springs)?;
    }
    let scheme = match interp.host.follows(&[
        slips::KIKUCHI_ITERATION,
        slips::KIKUCHI_SHARED,
        slips::KIKUCHI_OFFSET,
        slips::KIKUCHI_TILT,
        slips::KIKUCHI_LIMIT,
        slips::KIKUCHI_FIRST_STIFFNESS,
        slips::KIKUCHI_INITIAL,
    ]) {
        true => Scheme::OpenSees(o.balance.unwrap_or(Balance { tolerance: 0.0, rounds: 0 })),
        false => Scheme::Converged,
    };
    let parameters = KikuchiParameters {
        shape,
        size,
        rubber,
        height,
        shear,
        shear_springs,
        limit: o.limit,
        normal,
        layout: Layout::new(shape, size, n, o.lambda.unwrap_or(Distribution::Uniform), Mean::Springs),
        tilt: o.tilt,
        p_delta: o.p_delta,
        shares: o.shares.unwrap_or([0.5; 2]),
        mass: o.mass.unwrap_or(0.0),
    };
    let bearing = KikuchiBearing::new(parameters, &axes, &ends.disp, scheme);
    Ok(bearing.map_err(|e| refused(a, nodes, e))?.shared())
}

/// Without a limit all springs act with their full force.
fn warn_unscaled(interp: &mut Tcl, nodes: Option<Span>, n: usize) -> Result<(), Exception> {
    let times = 0.5 * n as f64;
    let message =
        format!("{NAME}: without -limDisp the {n} shear springs are not scaled: {times} times as stiff as one");
    let label = "expected -limDisp with the displacement from which on they are scaled to the material given";
    warn(interp, Diagnostic::warning(&checks::elements::UNSCALED_SPRINGS, message).at(nodes, label))
}
