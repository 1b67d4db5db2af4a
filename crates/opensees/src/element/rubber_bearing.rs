//! `element HDR`, `ElastomericX` and `LeadRubberX`.

use super::lead_units::ThermalUnits;
use super::{Ends, Kind, Make};
use crate::args::Args;
use crate::checks;
use crate::slips;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, warn};
use hysteron_engine::element::Element;
use hysteron_engine::element::axes::Orientation;
use hysteron_engine::element::bearing::{
    AxialLaw, GrantShear, Layers, LeadCore, Link, PI, Rubber, RubberBearing, RubberBoucWen, RubberShear,
};
use hysteron_engine::rules::{Consistent, OpenSees};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::{Diagnostic, Span};
use nalgebra::Vector3;
use std::sync::Arc;

const YIELDING: [Arg; 2] =
    [Arg::positive("Fy", "yield force Fy"), Arg::positive("alpha", "post-yield stiffness ratio alpha")];
const LAYERS: [Arg; 7] = [
    Arg::positive("Gr", "shear modulus Gr"),
    Arg::positive("Kbulk", "bulk modulus Kbulk"),
    Arg::not_negative("D1", "inner diameter D1"),
    Arg::positive("D2", "outer diameter D2"),
    Arg::not_negative("ts", "thickness of a shim ts"),
    Arg::positive("tr", "thickness of a rubber layer tr"),
    Arg::number("n", "number of layers n"),
];
const SHEAR: [Arg; 10] = [
    Arg::positive("a1", "parameter a1 of the elastic shear force"),
    Arg::number("a2", "parameter a2 of the elastic shear force"),
    Arg::number("a3", "parameter a3 of the elastic shear force"),
    Arg::not_negative("b1", "parameter b1 of the bounding force"),
    Arg::number("b2", "parameter b2 of the bounding force"),
    Arg::not_negative("b3", "parameter b3 of the hysteretic force"),
    Arg::not_negative("c1", "scragging parameter c1"),
    Arg::not_negative("c2", "scragging parameter c2"),
    Arg::number("c3", "Mullins parameter c3"),
    Arg::not_negative("c4", "Mullins parameter c4"),
];
const X_AXIS: [Arg; 3] = [
    Arg::number("x1", "x of the local x axis"),
    Arg::number("x2", "y of the local x axis"),
    Arg::number("x3", "z of the local x axis"),
];
const Y_AXIS: [Arg; 3] = [
    Arg::number("y1", "x of the vector in the local x-y plane"),
    Arg::number("y2", "y of the vector in the local x-y plane"),
    Arg::number("y3", "z of the vector in the local x-y plane"),
];
pub(super) const KC: Arg = Arg::not_negative("kc", "cavitation parameter kc");
pub(super) const PHI_M: Arg =
    Arg::of_domain("PhiM", "largest damage of the cavitation strength PhiM", Domain::Fraction);
pub(super) const AC: Arg = Arg::not_negative("ac", "strength degradation parameter ac");
pub(super) const SHEAR_DIST: Arg = Arg::of_domain("sDratio", "place of the shear force sDratio", Domain::Fraction);
pub(super) const MASS: Arg = Arg::not_negative("m", "mass m");
const CD: Arg = Arg::not_negative("cd", "viscous damping cd");
pub(super) const COVER: Arg = Arg::not_negative("tc", "cover thickness tc");
const LEAD: [Arg; 4] = [
    Arg::positive("qL", "density of lead qL"),
    Arg::positive("cL", "specific heat of lead cL"),
    Arg::positive("kS", "thermal conductivity of steel kS"),
    Arg::positive("aS", "thermal diffusivity of steel aS"),
];

pub(super) const HDR: Kind = Kind {
    names: &["HDR"],
    usage: "element HDR $tag $i $j $Gr $Kbulk $D1 $D2 $ts $tr $n $a1 $a2 $a3 $b1 $b2 $b3 $c1 $c2 $c3 $c4 \
            <$x1 $x2 $x3 $y1 $y2 $y3 <$kc <$PhiM <$ac <$sDratio <$m <$tc>>>>>>>",
    text: Text::new("High damping rubber bearing (Grant) with the axial law of layered rubber.")
        .example("element HDR 2 1 2 1 1 1 2 1 1 1 1 1 1 1 1 1 1 1 1 1")
        .groups(&[&LAYERS, &SHEAR, &X_AXIS, &Y_AXIS, &[KC, PHI_M, AC, SHEAR_DIST, MASS, COVER]]),
    make: Make::TwoNodes(make_hdr),
};

pub(super) const ELASTOMERIC_X: Kind = Kind {
    names: &["ElastomericX"],
    usage: "element ElastomericX $tag $i $j $Fy $alpha $Gr $Kbulk $D1 $D2 $ts $tr $n \
            <$x1 $x2 $x3 $y1 $y2 $y3 <$kc <$PhiM <$ac <$sDratio <$m <$cd <$tc <$tag1 ... $tag4>>>>>>>>",
    text: Text::new("Elastomeric bearing with the axial law of layered rubber.")
        .example("element ElastomericX 2 1 2 1 0.5 1 1 1 2 1 1 1")
        .arguments(&[
            Arg::new("tag1", "1: cavitation; 0: not"),
            Arg::new("tag4", "1: vertical stiffness varies with shear; 0: not"),
        ])
        .groups(&[&YIELDING, &LAYERS, &X_AXIS, &Y_AXIS, &[KC, PHI_M, AC, SHEAR_DIST, MASS, CD, COVER]]),
    make: Make::TwoNodes(make_elastomeric),
};

pub(super) const LEAD_RUBBER_X: Kind = Kind {
    names: &["LeadRubberX"],
    usage: "element LeadRubberX $tag $i $j $Fy $alpha $Gr $Kbulk $D1 $D2 $ts $tr $n <$x1 $x2 $x3 $y1 $y2 $y3 \
            <$kc <$PhiM <$ac $sDratio $m $cd <$tc <$qL $cL $kS $aS <$tag1 ... $tag5>>>>>>>",
    text: Text::new("Lead rubber bearing whose core heats, with the axial law of layered rubber.")
        .example("element LeadRubberX 2 1 2 1 0.5 1 1 1 2 1 1 1")
        .arguments(&[Arg::new("tag1", "1: cavitation; 0: not"), Arg::new("tag5", "1: the lead core heats; 0: not")])
        .groups(&[&YIELDING, &LAYERS, &X_AXIS, &Y_AXIS, &[KC, PHI_M, AC, SHEAR_DIST, MASS, CD, COVER], &LEAD]),
    make: Make::TwoNodes(make_leaded),
};

/// Options that the bearings of this family share, with OpenSees' defaults.
pub(super) struct Common {
    orientation: Orientation,
    orient_at: Option<Span>,
    pub(super) kc: f64,
    pub(super) phi: f64,
    pub(super) ac: f64,
    pub(super) shear_dist: f64,
    pub(super) mass: f64,
    cd: f64,
    pub(super) cover: f64,
}

impl Common {
    pub(super) fn new(nodes: Option<Span>) -> Self {
        Self {
            // Without -orient the local y axis is opposite to the global X.
            orientation: Orientation { x: None, y: Some(-Vector3::x()) },
            orient_at: nodes,
            kc: 10.0,
            phi: 0.5,
            ac: 1.0,
            shear_dist: 0.5,
            mass: 0.0,
            cd: 0.0,
            cover: 0.0,
        }
    }

    pub(super) fn axes(&mut self, interp: &mut Tcl, a: &mut Args<'_>) -> Result<(), Exception> {
        let x = a.read_all(interp, &X_AXIS)?;
        self.orient_at = a.last_span();
        let y = a.read_all(interp, &Y_AXIS)?;
        self.orientation = Orientation { x: Some(x.into()), y: Some(y.into()) };
        Ok(())
    }

    /// Kinematics between the nodes.
    pub(super) fn link(&self, a: &Args<'_>, ends: &Ends) -> Result<Link<12, 6>, Exception> {
        let made = self.orientation.of_link(ends.place.0, ends.place.1, false);
        let (axes, length) = made.map_err(|e| {
            let label = "expected nodes apart or a local x axis, and a vector that is not parallel to it";
            a.refuse_at(self.orient_at, format!("bearing: {}", e.message()), label)
        })?;
        Ok(Link::new(&axes, length, self.shear_dist))
    }

    /// The bearing of an axial law and a shear law, by OpenSees' rules or by consistent ones as the axial law is.
    fn around<O: RubberShear, C: RubberShear>(
        &self,
        a: &Args<'_>,
        ends: &Ends,
        axial: AxialLaw,
        (opensees, consistent): (O, C),
    ) -> Result<Arc<dyn Element>, Exception>
    where
        RubberBearing<O>: Shared<dyn Element>,
        RubberBearing<C>: Shared<dyn Element>,
    {
        let (compat, link) = (axial.compat, self.link(a, ends)?.under_given_force(axial.compat));
        Ok(match compat {
            true => RubberBearing::new(axial, opensees, link, self.mass).shared(),
            false => RubberBearing::new(axial, consistent, link, self.mass).shared(),
        })
    }

    /// The axial law, where `switches` say whether the bearing cavitates, buckles and softens.
    pub(super) fn axial(&self, rubber: Rubber, [cavitates, buckles, softens]: [bool; 3], compat: bool) -> AxialLaw {
        // Zero stands for a bearing that hardens; OpenSees puts a small number there.
        let kc = if self.kc < f64::EPSILON { 1e-4 } else { self.kc };
        AxialLaw { rubber, kc, phi: self.phi, ac: self.ac, cavitates, buckles, softens, compat }
    }
}

/// Material and geometry: G, K, D1, D2, ts, tr, n.
pub(super) fn layers(interp: &mut Tcl, a: &mut Args<'_>, plugged: bool) -> Result<Layers, Exception> {
    let [g_r, k_bulk, d1, d2, ts, tr, n] = &LAYERS;
    let (g, bulk) = (a.read(interp, g_r)?, a.read(interp, k_bulk)?);
    let (inner, outer) = (a.read(interp, d1)?, a.read(interp, d2)?);
    if outer <= inner {
        return Err(a.refuse(
            format!("outer diameter D2 is {outer}, inner diameter D1 is {inner}"),
            format!("expected an outer diameter greater than {inner}"),
        ));
    }
    let (shim, layer) = (a.read(interp, ts)?, a.read(interp, tr)?);
    if layer >= outer {
        return Err(a.refuse(
            format!("thickness of a rubber layer tr is {layer}"),
            format!("expected less than the outer diameter, {outer}"),
        ));
    }
    let count = a.read(interp, n)?;
    if count < 1.0 {
        return Err(a.refuse(format!("number of layers n is {count}"), "expected at least 1"));
    }
    if count.fract() != 0.0 {
        let d = Diagnostic::warning(&checks::materials::UNUSUAL_PARAMETER, format!("number of layers n is {count}"));
        warn(interp, d.at(a.last_span(), "expected a whole number"))?;
    }
    Ok(Layers { g, bulk, inner, outer, shim, layer, count, cover: 0.0, plugged })
}

/// The error for words after the last argument.
fn nothing_left(a: &Args<'_>) -> Result<(), Exception> {
    match a.left() {
        0 => Ok(()),
        n => {
            let words: Vec<String> = a.ahead().map(|v| v.as_str().into_owned()).collect();
            let s = if n == 1 { "" } else { "s" };
            let message = format!("{n} argument{s} too many: {}", words.join(" "));
            Err(a.refuse_at(a.next_span(), message, "nothing more was expected"))
        }
    }
}

/// Returns true if the numbers can be G, K, D1, D2, ts, tr, n of a bearing.
fn can_be_layers(v: &[f64]) -> bool {
    matches!(v, [g, k, d1, d2, ts, tr, n, ..]
        if *g > 0.0 && *k > 0.0 && *d1 >= 0.0 && d2 > d1 && (0.0..*d2).contains(ts) && (0.0..*d2).contains(tr)
            && *n >= 1.0 && n.fract() == 0.0)
}

/// Scripts for the first `HDR` give a yield force and a yield displacement before the shear modulus.
fn first_form(a: &Args<'_>) -> Result<(), Exception> {
    let numbers: Vec<f64> = a.ahead().map_while(|v| v.as_f64()).collect();
    if numbers.len() < 19 || can_be_layers(&numbers) || !can_be_layers(&numbers[2..]) {
        return Ok(());
    }
    let two: Vec<String> = a.ahead().take(2).map(|v| v.as_str().into_owned()).collect();
    let message = format!("HDR: 2 arguments too many before the shear modulus: {}", two.join(" "));
    let label = "this one and the next, a yield force and displacement, are no arguments of HDR any more";
    Err(a.refuse_at(a.next_span(), message, label))
}

fn make_hdr(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    ends.need(a, (3, 6))?;
    let mut c = Common::new(a.last_span());
    first_form(a)?;
    let mut layers = layers(interp, a, false)?;
    layers.count = layers.count.trunc();
    let [a1, a2, a3, b1, b2, b3, c1, c2, c3, c4] = a.read_all(interp, &SHEAR)?;
    if a.left() > 0 {
        c.axes(interp, a)?;
    }
    let values = [c.kc, c.phi, c.ac, c.shear_dist, c.mass, c.cover];
    [c.kc, c.phi, c.ac, c.shear_dist, c.mass, c.cover] =
        a.read_leading(interp, [&KC, &PHI_M, &AC, &SHEAR_DIST, &MASS, &COVER], values)?;
    nothing_left(a)?;
    layers.cover = c.cover;
    let compat = interp.host.follows(&[
        slips::P_DELTA_TANGENT,
        slips::RUBBER_LAG,
        slips::RUBBER_TENSION,
        slips::RUBBER_COMPRESSION,
        slips::HDR_TRIAL,
    ]);
    let shear = GrantShear { a: [a1, a2, a3], b: [b1, b2, b3], c: [c1, c2, c3, c4], rules: Consistent };
    let axial = c.axial(layers.bearing(), [true; 3], compat);
    c.around(a, ends, axial, (shear.with(OpenSees), shear))
}

/// Yield force and the ratio of stiffnesses after and before yielding.
fn yielding(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(f64, f64), Exception> {
    let [qy, alpha] = a.read_all(interp, &YIELDING)?;
    if alpha >= 1.0 {
        return Err(a.refuse(
            format!("post-yield stiffness ratio alpha is {alpha}"),
            "expected a number greater than 0 and less than 1",
        ));
    }
    Ok((qy, alpha))
}

/// Switches, which are 1 or off.
fn switches<const N: usize>(interp: &mut Tcl, a: &mut Args<'_>, what: [&str; N]) -> Result<[bool; N], Exception> {
    let mut on = [false; N];
    for (i, (on, what)) in on.iter_mut().zip(what).enumerate() {
        if a.left() == 0 {
            break;
        }
        let switch = a.int(&format!("tag{} ({what})", i + 1))?;
        *on = switch == 1;
        if !(0..=1).contains(&switch) {
            let d = Diagnostic::warning(
                &checks::words::REPLACED_VALUE,
                format!("tag{} ({what}) is {switch} and counts as 0", i + 1),
            );
            warn(interp, d.at(a.last_span(), "expected 0 or 1"))?;
        }
    }
    Ok(on)
}

fn make_elastomeric(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    ends.need(a, (3, 6))?;
    let mut c = Common::new(a.last_span());
    let (qy, alpha) = yielding(interp, a)?;
    let mut layers = layers(interp, a, false)?;
    if a.left() > 0 {
        c.axes(interp, a)?;
    }
    let values = [c.kc, c.phi, c.ac, c.shear_dist, c.mass, c.cd, c.cover];
    [c.kc, c.phi, c.ac, c.shear_dist, c.mass, c.cd, c.cover] =
        a.read_leading(interp, [&KC, &PHI_M, &AC, &SHEAR_DIST, &MASS, &CD, &COVER], values)?;
    let [cavitates, buckles, varies, softens] =
        switches(interp, a, ["cavitation", "critical load", "shear stiffness", "axial stiffness"])?;
    nothing_left(a)?;
    layers.cover = c.cover;
    let compat = interp.host.follows(&[
        slips::P_DELTA_TANGENT,
        slips::RUBBER_LAG,
        slips::RUBBER_TENSION,
        slips::RUBBER_COMPRESSION,
        slips::RUBBER_REST,
    ]);
    let rubber = layers.bearing();
    let shear = RubberBoucWen {
        qy,
        k0: (1.0 / alpha - 1.0) * rubber.shear,
        rubber: rubber.shear,
        cd: c.cd,
        varies,
        leaded: false,
        core: None,
        heats: false,
        rules: Consistent,
    };
    let axial = c.axial(rubber, [cavitates, buckles, softens], compat);
    c.around(a, ends, axial, (shear.with(OpenSees), shear))
}

fn make_leaded(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    ends.need(a, (3, 6))?;
    let mut c = Common::new(a.last_span());
    let (qy, alpha) = yielding(interp, a)?;
    let mut layers = layers(interp, a, true)?;
    if a.left() > 0 {
        c.axes(interp, a)?;
    }
    // OpenSees takes some of them together or not at all.
    [c.kc, c.phi] = a.read_leading(interp, [&KC, &PHI_M], [c.kc, c.phi])?;
    let values = [c.ac, c.shear_dist, c.mass, c.cd];
    [c.ac, c.shear_dist, c.mass, c.cd] = a.read_all_or(interp, &[AC, SHEAR_DIST, MASS, CD], values)?;
    [c.cover] = a.read_all_or(interp, &[COVER], [c.cover])?;
    let is_default = a.left() == 0;
    let [density, heat, conductivity, diffusivity] = a.read_all_or(interp, &LEAD, [11200.0, 130.0, 50.0, 1.41e-5])?;
    let [cavitates, buckles, varies, softens, heats] =
        switches(interp, a, ["cavitation", "critical load", "shear stiffness", "axial stiffness", "heating"])?;
    if heats && layers.inner == 0.0 {
        return Err(a.refuse(
            "tag5 (heating) is 1, but the inner diameter D1 is 0: there is no lead core",
            "expected 0, or a D1 greater than 0",
        ));
    }
    nothing_left(a)?;
    layers.cover = c.cover;
    let compat = interp.host.follows(&[
        slips::P_DELTA_TANGENT,
        slips::RUBBER_LAG,
        slips::RUBBER_TENSION,
        slips::RUBBER_COMPRESSION,
        slips::RUBBER_REST,
        slips::LEAD_HEATING,
    ]);
    let radius = 0.5 * layers.inner;
    if heats {
        let units = ThermalUnits { density, heat, conductivity, diffusivity, rubber: layers.g, radius, is_default };
        units.finding(a.last_span()).map_or(Ok(()), |d| warn(interp, d))?;
    }
    let rubber = layers.bearing();
    let core = (radius > 0.0).then(|| LeadCore {
        radius,
        area: PI * radius * radius,
        height: rubber.height,
        shims: layers.shims(),
        density,
        heat,
        conductivity,
        diffusivity,
    });
    let k0 = (1.0 / alpha - 1.0) * rubber.shear;
    let shear =
        RubberBoucWen { qy, k0, rubber: rubber.shear, cd: c.cd, varies, leaded: true, core, heats, rules: Consistent };
    let axial = c.axial(rubber, [cavitates, buckles, softens], compat);
    c.around(a, ends, axial, (shear.with(OpenSees), shear))
}
