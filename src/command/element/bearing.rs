//! `element elastomericBearingBoucWen` and `elastomericBearingPlasticity`.

use super::{Ends, Kind, orientation};
use crate::command::args::Args;
use crate::command::{Tcl, ignore_option};
use crate::diagnostic::Span;
use crate::element::Element;
use crate::element::axes::Orientation;
use crate::element::bearing::{Link, PlaneBearing, PlasticShear, ShearLaw, ShearParameters, SpaceBearing};
use crate::material::Material;
use crate::script::Exception;
use std::sync::Arc;

pub(super) const BOUC_WEN: Kind = Kind {
    names: &["elastomericBearingBoucWen", "ElastomericBearingBoucWen"],
    usage: "element elastomericBearingBoucWen $tag $i $j $kInit $qd $alpha1 $alpha2 $mu $eta $beta $gamma -P $mat \
            <-T $mat -My $mat> -Mz $mat <-orient <$x1 $x2 $x3> $y1 $y2 $y3> <-shearDist $sDratio> <-doRayleigh> \
            <-mass $m> <-iter $maxIter $tol>",
    make,
};

pub(super) const PLASTICITY: Kind = Kind {
    names: &["elastomericBearingPlasticity", "ElastomericBearingPlasticity", "elastomericBearing"],
    usage: "element elastomericBearingPlasticity $tag $i $j $kInit $qd $alpha1 $alpha2 $mu -P $mat <-T $mat -My $mat> \
            -Mz $mat <-orient <$x1 $x2 $x3> $y1 $y2 $y3> <-shearDist $sDratio> <-doRayleigh> <-mass $m>",
    make: make_plastic,
};

/// What the bearings of this family have in common besides their law.
struct Common {
    materials: Vec<(Material, i32)>,
    orientation: Orientation,
    orient_span: Option<Span>,
    shear_dist: f64,
    rayleigh: bool,
    mass: f64,
}

const OPTIONS: &[&str] = &["-P", "-T", "-My", "-Mz", "-orient", "-shearDist", "-doRayleigh", "-mass", "-iter"];

/// Materials by their options, which OpenSees wants in this order, then the options that may come in any order.
fn common(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Common, Exception> {
    let mut materials = vec![];
    let wanted: &[&str] = if ends.ndm == 2 { &["-P", "-Mz"] } else { &["-P", "-T", "-My", "-Mz"] };
    for option in wanted {
        let found = a.word(&format!("option {option} with a material"))?;
        if found != *option {
            let message = format!("expected the option {option} with a material, found \"{found}\"");
            return Err(a.refuse(message, format!("expected {option} here: the order is {}", wanted.join(" "))));
        }
        materials.push(a.of(&interp.host.definitions.materials)?);
    }
    let mut c = Common {
        materials,
        orientation: Orientation::default(),
        orient_span: None,
        shear_dist: 0.5,
        rayleigh: false,
        mass: 0.0,
    };
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-orient" => {
                c.orient_span = a.last_span();
                c.orientation = orientation(a, ends.ndm)?;
            }
            "-shearDist" => {
                c.shear_dist = a.float("place of the shear force as a fraction of the length")?;
                if !(0.0..=1.0).contains(&c.shear_dist) {
                    return Err(a.refuse(format!("-shearDist is {}", c.shear_dist), "expected a fraction, 0 to 1"));
                }
            }
            "-doRayleigh" => c.rayleigh = true,
            "-mass" => c.mass = a.not_negative("mass")?,
            "-iter" => {
                // z is always found to round-off.
                a.count("largest number of iterations")?;
                a.positive("tolerance")?;
            }
            _ => ignore_option(interp, a, OPTIONS)?,
        }
    }
    Ok(c)
}

/// Kinematics of the bearing.
fn link<const N: usize, const B: usize>(
    a: &Args<'_>,
    c: &Common,
    ends: &Ends,
    nodes: Option<Span>,
) -> Result<Link<N, B>, Exception> {
    let made = c.orientation.of_link(ends.place.0, ends.place.1, ends.ndm == 2);
    let (axes, length) = made.map_err(|e| {
        let at = c.orient_span.or(nodes);
        let label = if c.orient_span.is_some() { "" } else { "nodes at one place need -orient with the local axes" };
        a.refuse_at(at, format!("bearing: {}", e.message()), label)
    })?;
    Ok(Link::new(&axes, length, c.shear_dist))
}

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    let k_init = a.positive("initial stiffness kInit")?;
    let qd = a.positive("characteristic strength qd")?;
    let alpha1 = a.float("post-yield stiffness ratio alpha1")?;
    if alpha1 >= 1.0 {
        return Err(a.refuse(format!("alpha1 is {alpha1}"), "expected a ratio less than 1"));
    }
    let alpha2 = a.float("post-yield stiffness ratio alpha2 of the nonlinear hardening")?;
    let mu = a.float("exponent mu of the nonlinear hardening")?;
    let eta = a.positive("yielding exponent eta")?;
    let beta = a.float("first loop parameter beta")?;
    let gamma = a.float("second loop parameter gamma")?;
    if beta + gamma <= 0.0 {
        return Err(a.refuse(
            format!("beta + gamma is {}", beta + gamma),
            "expected a sum greater than 0: the hysteretic force would not be bounded",
        ));
    }
    let c = common(interp, a, ends)?;
    let shear = ShearParameters {
        k0: (1.0 - alpha1) * k_init,
        qd,
        k2: alpha1 * k_init,
        k3: alpha2 * k_init,
        mu,
        eta,
        beta,
        gamma,
    };
    around(a, shear, c, ends, nodes)
}

fn make_plastic(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    let k_init = a.positive("initial stiffness kInit")?;
    let qd = a.positive("characteristic strength qd")?;
    let alpha1 = a.float("post-yield stiffness ratio alpha1")?;
    if alpha1 >= 1.0 {
        return Err(a.refuse(format!("alpha1 is {alpha1}"), "expected a ratio less than 1"));
    }
    let alpha2 = a.float("post-yield stiffness ratio alpha2 of the nonlinear hardening")?;
    let mu = a.float("exponent mu of the nonlinear hardening")?;
    if alpha2 != 0.0 && mu < 1.0 {
        return Err(a.refuse(
            format!("mu is {mu}"),
            "expected an exponent of at least 1: the stiffness at rest would not be finite",
        ));
    }
    let c = common(interp, a, ends)?;
    let shear = PlasticShear { k0: (1.0 - alpha1) * k_init, qd, k2: alpha1 * k_init, k3: alpha2 * k_init, mu };
    around(a, shear, c, ends, nodes)
}

/// The bearing around a shear law, in the plane or in space.
fn around<L: ShearLaw<1> + ShearLaw<2> + 'static>(
    a: &Args<'_>,
    law: L,
    c: Common,
    ends: &Ends,
    nodes: Option<Span>,
) -> Result<Arc<dyn Element>, Exception> {
    match (ends.ndm, ends.ndf) {
        (2, 3) => {
            let link = link(a, &c, ends, nodes)?;
            let Ok(materials) = c.materials.try_into() else { unreachable!("taken one by one") };
            Ok(Arc::new(PlaneBearing::new(law, link, materials, c.mass, c.rayleigh)))
        }
        (3, 6) => {
            let link = link(a, &c, ends, nodes)?;
            let Ok(materials) = c.materials.try_into() else { unreachable!("taken one by one") };
            Ok(Arc::new(SpaceBearing::new(law, link, materials, c.mass, c.rayleigh)))
        }
        _ => Err(ends.wrong(a, "3 degrees of freedom in 2 or 6 in 3 dimensions")),
    }
}
