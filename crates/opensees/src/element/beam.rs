//! `element elasticBeamColumn`, `ModElasticBeam2d` and `ModElasticBeam3d`.

use super::damping::{damped, of_tag};
use super::{Ends, Kind, Make, refused};
use crate::args::Args;
use crate::checks;
use crate::text::{Arg, Domain, Text};
use crate::things;
use crate::{Tcl, ignore_unknown, warn};
use hysteron_engine::element::Element;
use hysteron_engine::element::axes::AxesError;
use hysteron_engine::element::beam::{ElasticBeam, ElasticOptions, Release};
use hysteron_engine::element::damping::ElementDamping;
use hysteron_engine::element::transform;
use hysteron_engine::section::{ElasticSection, Resultant, SharedSection};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use hysteron_tcl::diagnostic::Diagnostic;
use std::sync::Arc;

/// Properties of beams with factors.
const IN_PLANE: [Arg; 3] = [A.within(Domain::Positive), E.within(Domain::Positive), IZ.within(Domain::Positive)];
const IN_SPACE: [Arg; 6] = [
    IN_PLANE[0],
    IN_PLANE[1],
    G.within(Domain::Positive),
    J.within(Domain::Positive),
    IY.within(Domain::Positive),
    IN_PLANE[2],
];
/// Factors of the end rotation stiffness about an axis.
const FACTORS: [Arg; 3] =
    [Arg::positive("K11", "factor K11"), Arg::positive("K33", "factor K33"), Arg::number("K44", "factor K44")];
/// Factors of the end rotation stiffness about local y.
const FACTORS_Y: [Arg; 3] =
    [Arg::positive("K11y", "factor K11y"), Arg::positive("K33y", "factor K33y"), Arg::number("K44y", "factor K44y")];
/// Factors of the end rotation stiffness about local z.
const FACTORS_Z: [Arg; 3] =
    [Arg::positive("K11z", "factor K11z"), Arg::positive("K33z", "factor K33z"), Arg::number("K44z", "factor K44z")];
const RHO_M: Arg = MASS_PER_LENGTH.after("-rho");

pub(super) const MASS_PER_LENGTH: Arg = Arg::of("-mass", "m", "mass per length").within(Domain::NotNegative);
pub(super) const E: Arg = Arg::usually_positive("E", "elastic modulus E");
pub(super) const G: Arg = Arg::usually_positive("G", "shear modulus G");
pub(super) const A: Arg = Arg::usually_positive("A", "cross-sectional area A");
pub(super) const J: Arg = Arg::usually_positive("J", "torsion constant J");
pub(super) const IY: Arg = Arg::usually_positive("Iy", "second moment of area Iy");
pub(super) const IZ: Arg = Arg::usually_positive("Iz", "second moment of area Iz");
pub(super) const AVY: Arg = Arg::usually_positive("Avy", "shear area Avy");
pub(super) const AVZ: Arg = Arg::usually_positive("Avz", "shear area Avz");
/// The properties that may be 0.
const A_OR_0: Arg = A.within(Domain::UsuallyNotNegative);
const J_OR_0: Arg = J.within(Domain::UsuallyNotNegative);
const IY_OR_0: Arg = IY.within(Domain::UsuallyNotNegative);
const IZ_OR_0: Arg = IZ.within(Domain::UsuallyNotNegative);

pub(super) const ELASTIC: Kind = Kind {
    names: &["elasticBeamColumn", "ElasticBeamColumn", "elasticBeam", "PrismFrame"],
    usage: "element elasticBeamColumn $tag $i $j $A $E $Iz <$G $Avy> $transf (in the plane) or \
            $A $E $G $J $Iy $Iz <$Avy $Avz> $transf (in space) or $section $transf or -section $section -transform $transf \
            <-shear $flag> <-mass $m> <-cMass|-lMass> <-release $code> <-releasez $code> <-releasey $code> <-damp $damping>",
    text: Text::new("Elastic beam, Euler-Bernoulli or, with shear areas, Timoshenko.")
        .example("element elasticBeamColumn 2 1 2 1 1 1 1")
        .arguments(&[
            Arg::of("-section", "section", "tag of a section"),
            Arg::of("-transform", "transf", "tag of a geometric transformation"),
            Arg::of("-shear", "flag", "0: without shear deformations"),
            MASS_PER_LENGTH,
            A_OR_0,
            E,
            G,
            J_OR_0,
            IY_OR_0,
            IZ_OR_0,
            AVY,
            AVZ,
            Arg::thing("section", things::SECTION),
            Arg::thing("transf", things::TRANSFORM),
        ]),
    make: Make::TwoNodes(make),
};

pub(super) const MODIFIED: Kind = Kind {
    names: &["ModElasticBeam2d", "modElasticBeam2d", "ModElasticBeam", "modElasticBeam"],
    usage: "element ModElasticBeam2d $tag $i $j $A $E $Iz $K11 $K33 $K44 $transf <-rho $m> <-cMass|-lMass>",
    text: Text::new("Elastic beam with rotational stiffness coefficients of its own, in the plane.")
        .example("element ModElasticBeam2d 2 1 2 1 1 1 1 1 1 1")
        .groups(&[&IN_PLANE, &FACTORS, &[RHO_M]]),
    make: Make::TwoNodes(make_modified),
};

pub(super) const MODIFIED_SPACE: Kind = Kind {
    names: &["ModElasticBeam3d", "modElasticBeam3d"],
    usage: "element ModElasticBeam3d $tag $i $j $A $E $G $J $Iy $Iz $K11y $K33y $K44y $K11z $K33z $K44z $transf \
            <-mass $m> <-cMass|-lMass>",
    text: Text::new("Elastic beam with rotational stiffness coefficients of its own, in space.")
        .example("element ModElasticBeam3d 2 1 2 1 1 1 1 1 1 1 1 1 1 1 1 1")
        .groups(&[&IN_SPACE, &FACTORS_Y, &FACTORS_Z, &[MASS_PER_LENGTH]]),
    make: Make::TwoNodes(make_modified_space),
};

/// A damping of the element's own.
type Damping = Option<Arc<ElementDamping>>;

fn release(a: &mut Args<'_>) -> Result<Release, Exception> {
    Ok(match a.int("code of the release")? {
        0 => Release::None,
        1 => Release::I,
        2 => Release::J,
        3 => Release::Both,
        code => return Err(a.refuse(format!("{code} is no code of a release"), "expected 0 none, 1 i, 2 j, 3 both")),
    })
}

/// Options, and a damping of its own.
fn options(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(ElasticOptions, Damping), Exception> {
    let (mut o, mut damping) = (ElasticOptions::default(), None);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-mass" => o.rho = a.number(&MASS_PER_LENGTH)?,
            "-cMass" => o.consistent = true,
            "-lMass" => o.consistent = false,
            "-release" | "-releasez" => o.release.0 = release(a)?,
            "-releasey" => o.release.1 = release(a)?,
            "-damp" => damping = Some(of_tag(interp, a)?),
            // Of use to thermal loads alone.
            "-alpha" | "-depth" => drop(a.float("value")?),
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok((o, damping))
}

/// Numbers before the options. OpenSees distinguishes the forms of the command by their count.
pub(super) type Place = Option<hysteron_tcl::diagnostic::Span>;

pub(super) fn no_transform(a: &Args<'_>, transf: Place, nodes: Place, e: AxesError) -> Exception {
    match e {
        AxesError::NoLength => a.refuse_at(nodes, "the beam has no length", "expected a node at another place"),
        e => a.refuse_at(transf, e.message(), "expected a vector that is not along the beam"),
    }
}

/// An elastic section, or what a section is before anything has happened to it.
pub(super) fn elastic_part(section: &SharedSection) -> ElasticSection {
    section.elastic().unwrap_or_else(|| {
        let resultants = section.resultants();
        let n = resultants.len();
        let mut k = vec![0.0; n * n];
        section.initial_stiffness(&mut k);
        let of = |wanted: Resultant| resultants.iter().position(|r| *r == wanted).map(|i| k[i * (n + 1)]);
        let rigidity = |r| of(r).unwrap_or(0.0);
        ElasticSection {
            e: 1.0,
            area: rigidity(Resultant::P),
            iz: rigidity(Resultant::Mz),
            iy: rigidity(Resultant::My),
            g: 1.0,
            j: rigidity(Resultant::T),
            shear: (of(Resultant::Vy), of(Resultant::Vz)),
        }
    })
}

/// A property of a section. Zero is a mechanism or a beam without torsion, which OpenSees lets pass.
fn property(interp: &mut Tcl, a: &mut Args<'_>, arg: &Arg) -> Result<f64, Exception> {
    let (value, what) = (a.read(interp, arg)?, arg.meaning);
    if value == 0.0 {
        let d = Diagnostic::warning(
            &checks::elements::NO_STIFFNESS,
            format!("the {what} is 0: the beam has no stiffness there"),
        );
        warn(interp, d.at(a.last_span(), "expected a number greater than 0"))?;
    }
    Ok(value)
}

/// The section of the beam: by its tag, or number after number.
fn section(interp: &mut Tcl, a: &mut Args<'_>, ndm: usize) -> Result<ElasticSection, Exception> {
    let n = a.numbers_ahead();
    // With shear areas the last of the numbers is the tag of the transformation.
    let ends_with_tag = n > 0 && a.ahead().nth(n - 1).is_some_and(|w| w.as_str().parse::<i64>().is_ok());
    let has_shear = ends_with_tag && n == if ndm == 2 { 6 } else { 9 };
    match (ndm, n) {
        (_, 2) => Ok(elastic_part(&a.of(&interp.host.builder.definitions.sections)?.0)),
        (2, _) => {
            let (area, e) = (property(interp, a, &A_OR_0)?, a.read(interp, &E)?);
            let iz = property(interp, a, &IZ_OR_0)?;
            let (mut g, mut shear) = (0.0, None);
            // Any other count is OpenSees' form without shear areas, with words left over behind the transformation.
            if has_shear {
                g = a.read(interp, &G)?;
                shear = Some(a.read(interp, &AVY)?);
            }
            Ok(ElasticSection { e, area, iz, iy: 0.0, g, j: 0.0, shear: (shear, None) })
        }
        _ => {
            let (area, e) = (property(interp, a, &A_OR_0)?, a.read(interp, &E)?);
            let (g, j) = (a.read(interp, &G)?, property(interp, a, &J_OR_0)?);
            let (iy, iz) = (property(interp, a, &IY_OR_0)?, property(interp, a, &IZ_OR_0)?);
            let shear =
                if has_shear { (Some(a.read(interp, &AVY)?), Some(a.read(interp, &AVZ)?)) } else { (None, None) };
            Ok(ElasticSection { e, area, iz, iy, g, j, shear })
        }
    }
}

/// Section and transformation by their options.
fn named_parts(
    interp: &mut Tcl,
    a: &mut Args<'_>,
) -> Result<(ElasticSection, transform::TransformSpec, Place), Exception> {
    let (mut section, mut transform, mut shear) = (None, None, true);
    while let Some(option) = a.peek() {
        match option.as_ref() {
            "-section" => {
                a.option();
                section = Some(elastic_part(&a.of(&interp.host.builder.definitions.sections)?.0));
            }
            "-transform" => {
                a.option();
                transform = Some((a.of(&interp.host.builder.definitions.transforms)?.0, a.last_span()));
            }
            "-shear" => {
                a.option();
                shear = a.switch(interp, "flag of the shear deformations")?;
            }
            "-order" => {
                a.option();
                let order = a.int("order of the frame's kinematics")?;
                if order != 0 {
                    return Err(a.refuse(format!("a frame of order {order} is not supported"), "expected 0"));
                }
            }
            _ => break,
        }
    }
    let Some(mut section) = section else { return Err(a.refuse("the section is missing", "expected -section")) };
    let Some((transform, place)) = transform else {
        return Err(a.refuse("the transformation is missing", "expected -transform"));
    };
    if !shear {
        section.shear = (None, None);
    }
    Ok((section, transform, place))
}

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need_frame(a)?;
    let (s, spec, place) = if a.at_option() {
        named_parts(interp, a)?
    } else {
        let s = section(interp, a, ends.ndm)?;
        let (spec, _) = a.of(&interp.host.builder.definitions.transforms)?;
        (s, spec, a.last_span())
    };
    let (o, damping) = options(interp, a)?;
    let stand = transform::Ends { place: ends.place, disp: &ends.disp };
    let wrong = |e| no_transform(a, place, nodes, e);
    let beam: Arc<dyn Element> = if ends.ndm == 2 {
        ElasticBeam::new(spec.plane(&stand).map_err(wrong)?, s, o).shared()
    } else {
        ElasticBeam::new(spec.space(&stand).map_err(wrong)?, s, o).shared()
    };
    damped(beam, damping).map_err(|e| refused(a, place, e))
}

fn make_modified(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need(a, (2, 3))?;
    let [area, e, iz] = a.numbers(&IN_PLANE)?;
    let factors = [a.numbers(&FACTORS)?, [4.0, 4.0, 2.0]];
    let (spec, _) = a.of(&interp.host.builder.definitions.transforms)?;
    let place = a.last_span();
    let o = modified_options(interp, a)?;
    let stand = transform::Ends { place: ends.place, disp: &ends.disp };
    let transform = spec.plane(&stand).map_err(|e| no_transform(a, place, nodes, e))?;
    let section = ElasticSection { e, area, iz, iy: 0.0, g: 0.0, j: 0.0, shear: (None, None) };
    Ok(ElasticBeam::modified(transform, section, factors, o).shared())
}

fn modified_options(interp: &mut Tcl, a: &mut Args<'_>) -> Result<ElasticOptions, Exception> {
    let mut o = ElasticOptions::default();
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-rho" | "-RHO" | "-mass" => o.rho = a.number(&MASS_PER_LENGTH)?,
            "-cMass" => o.consistent = true,
            "-lMass" => o.consistent = false,
            // Of use to thermal loads alone.
            "-alpha" | "-d" => drop(a.float("value")?),
            _ => ignore_unknown(interp, a)?,
        }
    }
    Ok(o)
}

fn make_modified_space(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need(a, (3, 6))?;
    let [area, e, g, j, iy, iz] = a.numbers(&IN_SPACE)?;
    let about_y = a.numbers(&FACTORS_Y)?;
    let factors = [a.numbers(&FACTORS_Z)?, about_y];
    let (spec, _) = a.of(&interp.host.builder.definitions.transforms)?;
    let place = a.last_span();
    let o = modified_options(interp, a)?;
    let stand = transform::Ends { place: ends.place, disp: &ends.disp };
    let transform = spec.space(&stand).map_err(|e| no_transform(a, place, nodes, e))?;
    let section = ElasticSection { e, area, iz, iy, g, j, shear: (None, None) };
    Ok(ElasticBeam::modified(transform, section, factors, o).shared())
}
