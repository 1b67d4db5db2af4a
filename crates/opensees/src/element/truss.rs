//! `element truss` and `corotTruss`.

use super::{Ends, Kind, Make, refused};
use crate::args::Args;
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown};
use hysteron_engine::element::{BarOptions, CorotTruss, Element, Truss};
use hysteron_engine::material::Material;
use hysteron_engine::section::Axial;
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

const TRUSS_A: Arg = Arg::of_domain("A", "cross-sectional area A", Domain::UsuallyPositive);
const RHO: Arg = Arg::of("-rho", "rho", "mass per length rho").within(Domain::NotNegative);

pub(super) const TRUSS: Kind = Kind {
    names: &["truss", "Truss"],
    usage: "element truss $tag $i $j $A $matTag <-rho $rho> <-cMass $flag> <-doRayleigh $flag> <-useInitialDisp $flag>",
    text: Text::new("Axial bar.").example("element truss 2 1 2 1 1").arguments(&[
        TRUSS_A,
        Arg::new("matTag", "tag of the law"),
        RHO,
    ]),
    make: Make::TwoNodes(make),
};

pub(super) const COROT_TRUSS: Kind = Kind {
    names: &["corotTruss", "CorotTruss"],
    usage: "element corotTruss $tag $i $j $A $matTag <-rho $rho> <-cMass $flag> <-doRayleigh $flag>",
    text: Text::new("Axial bar with large displacements.").example("element corotTruss 2 1 2 1 1").arguments(&[
        TRUSS_A,
        Arg::new("matTag", "tag of the law"),
        RHO,
    ]),
    make: Make::TwoNodes(make_corot),
};

pub(super) const TRUSS_SECTION: Kind = Kind {
    names: &["trussSection", "TrussSection"],
    usage: "element trussSection $tag $i $j $section | $A $matTag <-rho $rho> <-cMass $flag> <-doRayleigh $flag> \
            <-useInitialDisp $flag>",
    text: Text::new("Axial bar with a section.").example("element trussSection 2 1 2 1").arguments(&[
        Arg::number("section", "tag of a section"),
        TRUSS_A,
        Arg::new("matTag", "tag of the law"),
        RHO,
    ]),
    make: Make::TwoNodes(make),
};

pub(super) const COROT_TRUSS_SECTION: Kind = Kind {
    names: &["corotTrussSection", "CorotTrussSection"],
    usage: "element corotTrussSection $tag $i $j $section | $A $matTag <-rho $rho> <-cMass $flag> <-doRayleigh $flag>",
    text: Text::new("Axial bar with a section and large displacements.")
        .example("element corotTrussSection 2 1 2 1")
        .arguments(&[Arg::number("section", "tag of a section"), TRUSS_A, Arg::new("matTag", "tag of the law"), RHO]),
    make: Make::TwoNodes(make_corot),
};

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let span = a.last_span();
    let mut initial = ends.initial();
    let (material, tag, mut options) = words(interp, a, ends, Some(&mut initial))?;
    let line = ends.place.1 - ends.place.0;
    let mut line: Vec<f64> = (0..ends.ndm).map(|i| line[i] + initial[i]).collect();
    if line.iter().all(|x| *x == 0.0) {
        a.doubt_at(interp, span, "the truss has no length", "expected a node at another place")?;
        // In OpenSees it has neither stiffness nor mass.
        line[0] = 1.0;
        (options.area, options.rho) = (0.0, 0.0);
    }
    let truss = Truss::new(material, tag, &line, ends.ndf, &initial, options);
    Ok(truss.map_err(|e| refused(a, span, e))?.shared())
}

/// The corotational bar measures from the nodes' coordinates, whatever their displacements are.
fn make_corot(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let span = a.last_span();
    let (material, tag, options) = words(interp, a, ends, None)?;
    let line = ends.place.1 - ends.place.0;
    let truss = CorotTruss::new(material, tag, &line.as_slice()[..ends.ndm], ends.ndf, options);
    Ok(truss.map_err(|e| refused(a, span, e))?.shared())
}

/// Area and material, or, with one number instead of two, a section whose axial force is the bar's.
fn axial(interp: &mut Tcl, a: &mut Args<'_>) -> Result<(f64, Material, i32), Exception> {
    if a.numbers_ahead() == 1 {
        let (section, tag) = a.of(&interp.host.builder.definitions.sections)?;
        let Some(axial) = Axial::new(section, tag) else {
            return Err(a.refuse(format!("section {tag} has no axial force"), "expected a section with P"));
        };
        return Ok((1.0, axial.shared(), tag));
    }
    let area = a.read(interp, &TRUSS_A)?;
    let (material, tag) = a.of(&interp.host.builder.definitions.materials)?;
    Ok((area, material, tag))
}

/// Material and constants; the displacements to measure from, where the kind of bar has them, may be given up.
fn words(
    interp: &mut Tcl,
    a: &mut Args<'_>,
    ends: &Ends,
    mut initial: Option<&mut Vec<f64>>,
) -> Result<(Material, i32, BarOptions), Exception> {
    let (area, material, tag) = axial(interp, a)?;
    let mut options = BarOptions { area, rho: 0.0, consistent: false, rayleigh: false };
    while let Some(option) = a.option() {
        match (option.as_ref(), &mut initial) {
            ("-rho", _) => options.rho = a.number(&RHO)?,
            ("-cMass", _) => options.consistent = a.switch(interp, "flag")?,
            ("-doRayleigh", _) => options.rayleigh = a.switch(interp, "flag")?,
            ("-useInitialDisp", Some(initial)) => {
                if !a.switch(interp, "flag")? {
                    initial.fill(0.0);
                }
            }
            _ => ignore_unknown(interp, a)?,
        }
    }
    ends.need_any(a)?;
    Ok((material, tag, options))
}
