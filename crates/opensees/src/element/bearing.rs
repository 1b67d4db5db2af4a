//! `element elastomericBearingBoucWen`, `elastomericBearingPlasticity` and `elastomericBearingUFRP`.

use super::{Ends, Kind, Make, orientation};
use crate::args::Args;
use crate::slips;
use crate::text::any_command::{ITERATIONS, MASS, SHEAR_DIST, TOLERANCE};
use crate::text::{Arg, Text};
use crate::{Tcl, ignore_unknown};
use hysteron_engine::element::Element;
use hysteron_engine::element::axes::Orientation;
use hysteron_engine::element::bearing::{
    BoucWenShear, Link, PlaneBearing, PlasticShear, ShearLaw, SpaceBearing, UfrpShear,
};
use hysteron_engine::material::Material;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Span;
use std::sync::Arc;

const PARTS: [Arg; 3] = [
    Arg::positive("kInit", "initial stiffness kInit"),
    Arg::positive("qd", "characteristic strength qd"),
    Arg::number("alpha1", "post-yield stiffness ratio alpha1"),
];
const HARDENING: [Arg; 2] = [
    Arg::number("alpha2", "post-yield stiffness ratio alpha2 of the nonlinear hardening"),
    Arg::number("mu", "exponent mu of the nonlinear hardening"),
];
const LOOPS: [Arg; 3] = [
    Arg::positive("eta", "yielding exponent eta"),
    Arg::number("beta", "first loop parameter beta"),
    Arg::number("gamma", "second loop parameter gamma"),
];

const YIELD: Arg = Arg::positive("uy", "yield displacement uy");
const POLYNOMIAL: [Arg; 5] = [
    Arg::number("a1", "coefficient a1 of the polynomial"),
    Arg::number("a2", "coefficient a2 of the polynomial"),
    Arg::number("a3", "coefficient a3 of the polynomial"),
    Arg::number("a4", "coefficient a4 of the polynomial"),
    Arg::number("a5", "coefficient a5 of the polynomial"),
];
const FIBRES: [Arg; 2] =
    [Arg::positive("b", "hysteretic scaling factor b"), Arg::not_negative("c", "viscous damping coefficient c")];

pub(super) const BOUC_WEN: Kind = Kind {
    names: &["elastomericBearingBoucWen", "ElastomericBearingBoucWen"],
    usage: "element elastomericBearingBoucWen $tag $i $j $kInit $qd $alpha1 $alpha2 $mu $eta $beta $gamma -P $mat \
            <-T $mat -My $mat> -Mz $mat <-orient <$x1 $x2 $x3> $y1 $y2 $y3> <-shearDist $sDratio> <-doRayleigh> \
            <-mass $m> <-iter $maxIter $tol>",
    text: Text::new("Bearing with Bouc-Wen shear hysteresis.")
        .example("element elastomericBearingBoucWen 2 1 2 1 1 0.5 1 1 1 1 1 -P 1 -Mz 1")
        .groups(&[&PARTS, &HARDENING, &LOOPS]),
    make: Make::TwoNodes(make),
};

pub(super) const PLASTICITY: Kind = Kind {
    names: &["elastomericBearingPlasticity", "ElastomericBearingPlasticity", "elastomericBearing"],
    usage: "element elastomericBearingPlasticity $tag $i $j $kInit $qd $alpha1 $alpha2 $mu -P $mat <-T $mat -My $mat> \
            -Mz $mat <-orient <$x1 $x2 $x3> $y1 $y2 $y3> <-shearDist $sDratio> <-doRayleigh> <-mass $m>",
    text: Text::new("Bearing with plastic shear.")
        .example("element elastomericBearingPlasticity 2 1 2 1 1 0.5 1 1 -P 1 -Mz 1")
        .groups(&[&PARTS, &HARDENING]),
    make: Make::TwoNodes(make_plastic),
};

pub(super) const UFRP: Kind = Kind {
    names: &["elastomericBearingUFRP"],
    usage: "element elastomericBearingUFRP $tag $i $j $uy $a1 $a2 $a3 $a4 $a5 $b $c $eta $beta $gamma -P $mat -Mz $mat \
            <-orient $x1 $x2 $x3 $y1 $y2 $y3> <-shearDist $sDratio> <-doRayleigh> <-mass $m> <-iter $maxIter $tol>",
    text: Text::new("Unbonded fibre-reinforced bearing, in the plane.")
        .example("element elastomericBearingUFRP 2 1 2 1 1 1 1 1 1 1 1 1 1 1 -P 1 -Mz 1")
        .groups(&[&[YIELD], &POLYNOMIAL, &FIBRES, &LOOPS]),
    make: Make::TwoNodes(make_ufrp),
};

/// Position and axes of a bearing.
pub(super) struct Placement {
    pub(super) orientation: Orientation,
    /// Place of `-orient`.
    pub(super) orient_span: Option<Span>,
    nodes: Option<Span>,
}

impl Placement {
    /// Along the line between its nodes.
    pub(super) fn at_nodes(nodes: Option<Span>) -> Self {
        Self { orientation: Orientation::default(), orient_span: None, nodes }
    }

    /// Kinematics and length.
    pub(super) fn link<const N: usize, const B: usize>(
        &self,
        a: &Args<'_>,
        ends: &Ends,
        shear_dist: f64,
    ) -> Result<(Link<N, B>, f64), Exception> {
        let made = self.orientation.of_link(ends.place.0, ends.place.1, ends.ndm == 2);
        let (axes, length) = made.map_err(|e| {
            let at = self.orient_span.or(self.nodes);
            let label =
                if self.orient_span.is_some() { "" } else { "nodes at one place need -orient with the local axes" };
            a.refuse_at(at, format!("bearing: {}", e.message()), label)
        })?;
        Ok((Link::new(&axes, length, shear_dist), length))
    }
}

/// Options that the bearings of this family share.
struct Common {
    materials: Vec<(Material, i32)>,
    place: Placement,
    shear_dist: f64,
    rayleigh: bool,
    mass: f64,
    compat: bool,
}

/// Materials by their options, which OpenSees wants in this order.
pub(super) fn materials(interp: &Tcl, a: &mut Args<'_>, wanted: &[&str]) -> Result<Vec<(Material, i32)>, Exception> {
    let mut materials = vec![];
    for option in wanted {
        let found = a.word(&format!("option {option} with a material"))?;
        if found != *option {
            let message = format!("expected the option {option} with a material, found \"{found}\"");
            return Err(a.refuse(message, format!("expected {option} here: the order is {}", wanted.join(" "))));
        }
        materials.push(a.of(&interp.host.builder.definitions.materials)?);
    }
    Ok(materials)
}

/// The word after `-shearDist`.
pub(super) fn shear_dist(a: &mut Args<'_>) -> Result<f64, Exception> {
    let x = a.number(&SHEAR_DIST)?;
    if (0.0..=1.0).contains(&x) {
        Ok(x)
    } else {
        Err(a.refuse(format!("-shearDist is {x}"), "expected a fraction, 0 to 1"))
    }
}

/// Materials, then the options that may come in any order.
fn common(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends, nodes: Option<Span>) -> Result<Common, Exception> {
    let wanted: &[&str] = if ends.ndm == 2 { &["-P", "-Mz"] } else { &["-P", "-T", "-My", "-Mz"] };
    let materials = materials(interp, a, wanted)?;
    let (place, compat) = (Placement::at_nodes(nodes), interp.host.follows(&[slips::P_DELTA_TANGENT]));
    let mut c = Common { materials, place, shear_dist: 0.5, rayleigh: false, mass: 0.0, compat };
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-orient" => {
                c.place.orient_span = a.last_span();
                c.place.orientation = orientation(a, ends.ndm)?;
            }
            "-shearDist" => c.shear_dist = shear_dist(a)?,
            "-doRayleigh" => c.rayleigh = true,
            "-mass" => c.mass = a.number(&MASS)?,
            "-iter" => {
                // z is always found to round-off.
                a.count(&ITERATIONS)?;
                a.number(&TOLERANCE)?;
            }
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok(c)
}

/// Strength of the hysteretic part, stiffnesses of the parts, and exponent of the nonlinear hardening.
struct Stiffnesses {
    k0: f64,
    qd: f64,
    k2: f64,
    k3: f64,
    mu: f64,
}

impl Stiffnesses {
    fn read(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Self, Exception> {
        let [k_init, qd, alpha1] = a.read_all(interp, &PARTS)?;
        if alpha1 >= 1.0 {
            return Err(a.refuse(format!("alpha1 is {alpha1}"), "expected a ratio less than 1"));
        }
        let [alpha2, mu] = a.read_all(interp, &HARDENING)?;
        if alpha2 != 0.0 && mu < 1.0 {
            return Err(a.refuse(
                format!("mu is {mu}"),
                "expected an exponent of at least 1: the stiffness at rest would not be finite",
            ));
        }
        Ok(Self { k0: (1.0 - alpha1) * k_init, qd, k2: alpha1 * k_init, k3: alpha2 * k_init, mu })
    }
}

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    let Stiffnesses { k0, qd, k2, k3, mu } = Stiffnesses::read(interp, a)?;
    let [eta, beta, gamma] = loops(interp, a)?;
    let c = common(interp, a, ends, nodes)?;
    let shear =
        BoucWenShear { k0, qd, k2, k3, mu, eta, beta, gamma, compat: interp.host.follows(&[slips::BOUC_WEN_TANGENT]) };
    around(a, shear, c, ends)
}

/// Exponent and parameters of the loops, whose force is bounded.
fn loops(interp: &mut Tcl, a: &mut Args<'_>) -> Result<[f64; 3], Exception> {
    let [eta, beta, gamma] = a.read_all(interp, &LOOPS)?;
    if beta + gamma <= 0.0 {
        return Err(a.refuse(
            format!("beta + gamma is {}", beta + gamma),
            "expected a sum greater than 0: the hysteretic force would not be bounded",
        ));
    }
    Ok([eta, beta, gamma])
}

fn make_plastic(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    let Stiffnesses { k0, qd, k2, k3, mu } = Stiffnesses::read(interp, a)?;
    let c = common(interp, a, ends, nodes)?;
    let compat = interp.host.follows(&[slips::PLASTICITY_TRIAL]);
    let shear = PlasticShear { k0, qd, k2, k3, mu, compat };
    around(a, shear, c, ends)
}

fn make_ufrp(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need(a, (2, 3))?;
    let uy = a.read(interp, &YIELD)?;
    let polynomial = a.read_all(interp, &POLYNOMIAL)?;
    let [b, c] = a.read_all(interp, &FIBRES)?;
    let [eta, beta, gamma] = loops(interp, a)?;
    let o = common(interp, a, ends, nodes)?;
    let law = UfrpShear { uy, a: polynomial, b, c, eta, beta, gamma };
    let (link, _) = o.place.link(a, ends, o.shear_dist)?;
    let link = link.under_given_force(o.compat);
    let Ok(materials) = o.materials.try_into() else { unreachable!("taken one by one") };
    Ok(PlaneBearing::new(law, link, materials, o.mass, o.rayleigh).shared())
}

/// The bearing around a shear law, in the plane or in space.
fn around<L: ShearLaw<1> + ShearLaw<2>>(
    a: &Args<'_>,
    law: L,
    c: Common,
    ends: &Ends,
) -> Result<Arc<dyn Element>, Exception>
where
    PlaneBearing<L>: Shared<dyn Element>,
    SpaceBearing<L>: Shared<dyn Element>,
{
    match (ends.ndm, ends.ndf) {
        (2, 3) => {
            let (link, _) = c.place.link(a, ends, c.shear_dist)?;
            let link = link.under_given_force(c.compat);
            let Ok(materials) = c.materials.try_into() else { unreachable!("taken one by one") };
            Ok(PlaneBearing::new(law, link, materials, c.mass, c.rayleigh).shared())
        }
        (3, 6) => {
            let (link, _) = c.place.link(a, ends, c.shear_dist)?;
            let link = link.under_given_force(c.compat);
            let Ok(materials) = c.materials.try_into() else { unreachable!("taken one by one") };
            Ok(SpaceBearing::new(law, link, materials, c.mass, c.rayleigh).shared())
        }
        _ => Err(ends.wrong(a, "3 degrees of freedom in 2 or 6 in 3 dimensions")),
    }
}
