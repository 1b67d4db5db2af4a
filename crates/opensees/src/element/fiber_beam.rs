//! `element dispBeamColumn`, `AxEqDispBeamColumn2d`, `forceBeamColumn`, `nonlinearBeamColumn`, `mixedBeamColumn` and `beamWithHinges`.

use super::beam::{MASS_PER_LENGTH, Place, no_transform};
use super::damping::{damped, of_tag};
use super::{Ends, Kind, Make, refused};
use crate::args::Args;
use crate::checks;
use crate::section::beam_integration::{integration, simple, without_weight};
use crate::slips;
use crate::text::any_command::{ITERATIONS, TOLERANCE};
use crate::text::{Arg, Text};
use crate::things;
use crate::{Tcl, ignore_unknown, warn};
use hysteron_engine::element::Element;
use hysteron_engine::element::beam::{
    AxialEquilibrium, CurvatureBased, DisplacementBased, FiberBeam, ForceBased, Formulation, Hinge, Lacking,
    MAX_DEFORMATIONS, Mixed, Rule,
};
use hysteron_engine::element::damping::ElementDamping;
use hysteron_engine::element::transform::{self, TransformSpec};
use hysteron_engine::model::Integration;
use hysteron_engine::section::{Elastic, ElasticSection, Resultant, SharedSection};
use hysteron_engine::shared::Shared;
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Exception, Value};
use std::sync::Arc;

const AXIAL_TOL: Arg = Arg::positive("tol", "tolerance of the axial forces tol");
const E: Arg = Arg::positive("E", "elastic modulus E");
const A: Arg = Arg::positive("A", "cross-sectional area A");
const IZ: Arg = Arg::positive("Iz", "second moment of area Iz");
const IY: Arg = Arg::positive("Iy", "second moment of area Iy");
const G: Arg = Arg::positive("G", "shear modulus G");
const J: Arg = Arg::positive("J", "torsion constant J");
const POINTS: Arg = Arg::count("n", "number of integration points");

const INTEGRATION: Arg = Arg::new("integration", "integration");
const MIXED_BEAM_COLUMN_SECTION: Arg = Arg::new("section", "integration");
const LP_I: Arg = Arg::not_negative("lpI", "length of the hinge lpI");
const LP_J: Arg = Arg::not_negative("lpJ", "length of the hinge lpJ");

const SECTIONS: &[Arg] = &[
    Arg::new("integration", "tag of a beam integration"),
    POINTS,
    Arg::new("section", "tag of the section"),
    MASS_PER_LENGTH,
];

pub(super) const DISPLACEMENT: Kind = Kind {
    names: &["dispBeamColumn", "DispBeamColumn", "CubicFrame"],
    usage: "element dispBeamColumn $tag $i $j $transf $integration <-mass $m> <-cMass|-lMass> <-damp $damping> or \
            $tag $i $j $n $section $transf <-mass $m> <-cMass|-lMass> <-integration $rule>",
    text: Text::new("Displacement-based beam with sections.")
        .example("element dispBeamColumn 77 1 2 3 1 1")
        .arguments(&[Arg::whole("transf", "tag of a geometric transformation")])
        .groups(&[SECTIONS]),
    make: Make::TwoNodes(make_displacement),
};

pub(super) const AXIAL_EQUILIBRIUM: Kind = Kind {
    names: &["AxEqDispBeamColumn2d"],
    usage: "element AxEqDispBeamColumn2d $tag $i $j $n $section $transf $tol <-integration Lobatto|Legendre> <-iter $maxIter>",
    text: Text::new("Displacement-based beam whose sections have one axial force.")
        .example("element AxEqDispBeamColumn2d 77 1 2 3 1 1 1e-8")
        .arguments(&[
            POINTS,
            Arg::thing("section", things::SECTION),
            AXIAL_TOL,
            Arg::flag("-integration", "rule of integration; Legendre without"),
            ITERATIONS,
        ]),
    make: Make::TwoNodes(make_axial_equilibrium),
};

pub(super) const FORCE: Kind = Kind {
    names: &["forceBeamColumn", "ForceBeamColumn", "nonlinearBeamColumn", "NonlinearBeamColumn", "ForceFrame"],
    usage: "element forceBeamColumn $tag $i $j $transf $integration <-mass $m> <-iter $maxIter $tol> <-damp $damping> or \
            $tag $i $j $n $section|-sections $section1 ... $transf <-mass $m> <-iter $maxIter $tol> <-integration $rule>",
    text: Text::new("Force-based beam with sections.")
        .example("element forceBeamColumn 77 1 2 3 1 1")
        .arguments(&[Arg::whole("transf", "tag of a geometric transformation")])
        .groups(&[SECTIONS]),
    make: Make::TwoNodes(make_force),
};

pub(super) const CURVATURE: Kind = Kind {
    names: &["forceBeamColumnCBDI"],
    usage: "element forceBeamColumnCBDI $tag $i $j $transf $integration <-mass $m> <-iter $maxIter $tol> \
            <-shear> or $tag $i $j $n $section|-sections $section1 ... $transf <-mass $m> <-iter $maxIter $tol> \
            <-integration $rule>",
    text: Text::new("Force-based beam whose deflections follow its curvatures.")
        .example("element forceBeamColumnCBDI 77 1 2 3 1 1")
        .arguments(&[Arg::whole("transf", "tag of a geometric transformation")])
        .groups(&[SECTIONS]),
    make: Make::TwoNodes(make_curvature),
};

pub(super) const CURVATURE_SHEAR: Kind = Kind {
    names: &["forceBeamColumnCSBDI"],
    usage: "element forceBeamColumnCSBDI as forceBeamColumnCBDI with -shear",
    text: Text::new("Force-based beam whose deflections follow its curvatures and shear strains."),
    make: Make::TwoNodes(make_curvature_shear),
};

pub(super) const MIXED: Kind = Kind {
    names: &["mixedBeamColumn", "mixedBeamColumn2d", "mixedBeamColumn3d"],
    usage: "element mixedBeamColumn $tag $i $j $transf $integration <-mass $m> or $tag $i $j $n $section $transf \
            <-mass $m> <-integration $rule>",
    text: Text::new("Mixed beam with sections: forces in equilibrium, deformations compatible in the mean.")
        .example("element mixedBeamColumn 77 1 2 3 1 1")
        .arguments(&[INTEGRATION, POINTS, MIXED_BEAM_COLUMN_SECTION, MASS_PER_LENGTH]),
    make: Make::TwoNodes(make_mixed),
};

pub(super) const WITH_HINGES: Kind = Kind {
    names: &["beamWithHinges", "BeamWithHinges"],
    usage: "element beamWithHinges $tag $i $j $secI $lpI $secJ $lpJ $E $A $Iz <$Iy $G $J> $transf <-mass $m> \
            <-iter $maxIter $tol>",
    text: Text::new("Force-based beam with plastic regions at its ends.")
        .example("element beamWithHinges 2 1 2 1 1 1 1 1 1 1 1")
        .arguments(&[
            Arg::thing("secI", things::SECTION),
            LP_I,
            Arg::thing("secJ", things::SECTION),
            LP_J,
            E,
            A,
            IZ,
            IY,
            G,
            J,
            MASS_PER_LENGTH,
            Arg::whole("transf", "tag of a geometric transformation"),
        ]),
    make: Make::TwoNodes(make_with_hinges),
};

/// A beam as its words describe it.
struct Words {
    transform: TransformSpec,
    transform_at: Place,
    integration: Integration,
    rho: f64,
    consistent: bool,
    force_based: ForceBased,
    /// Deflections of shear count.
    shear: bool,
    /// A damping of its own.
    damping: Option<Arc<ElementDamping>>,
}

fn make_displacement(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    let words = take(interp, a, ends, Rule::Legendre, None)?;
    build(|_: &[f64]| Ok(DisplacementBased), (interp, a), words, ends, nodes)
}

fn make_axial_equilibrium(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need(a, (2, 3))?;
    let [n] = a.parts([&POINTS])?;
    let section = a.of(&interp.host.builder.definitions.sections)?;
    let (transform, _) = a.of(&interp.host.builder.definitions.transforms)?;
    let transform_at = a.last_span();
    let tolerance = a.number(&AXIAL_TOL)?;
    let (mut rule, mut iterations) = (Rule::Legendre, 20);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-iter" => iterations = a.count(&ITERATIONS)?,
            "-integration" => {
                rule = match a.word("rule of integration")?.as_ref() {
                    "Lobatto" => Rule::Lobatto,
                    "Legendre" => Rule::Legendre,
                    _ => return Err(a.unknown_name("rule of integration", ["Lobatto", "Legendre"])),
                };
                if rule.points(n, 1.0).is_none() {
                    let message = format!("the rule has no form with {n} points");
                    return Err(a.refuse(message, "expected a rule for as many points"));
                }
            }
            _ => ignore_unknown(interp, a)?,
        }
    }
    let words = Words {
        transform,
        transform_at,
        integration: Integration { rule, sections: vec![section; n] },
        rho: 0.0,
        consistent: false,
        force_based: follower(interp),
        shear: false,
        damping: None,
    };
    build(|_: &[f64]| Ok(AxialEquilibrium { tolerance, iterations }), (interp, a), words, ends, nodes)
}

fn make_force(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    let words = take(interp, a, ends, Rule::Lobatto, None)?;
    let force_based = words.force_based;
    build(|_: &[f64]| Ok(force_based), (interp, a), words, ends, nodes)
}

fn make_curvature(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    make_deflected(interp, a, ends, false)
}

fn make_curvature_shear(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    make_deflected(interp, a, ends, true)
}

fn make_deflected(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends, shear: bool) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    let words = take(interp, a, ends, Rule::Lobatto, Some(shear))?;
    let (iteration, shear) = (words.force_based, words.shear);
    let (compat, plane) = (interp.host.follows(&[slips::DEFLECTED_BEAM]), ends.ndm == 2);
    let size: usize = words.integration.sections.iter().map(|(s, _)| s.resultants().len()).sum();
    if size > MAX_DEFORMATIONS {
        let message = format!("the sections have {size} deformations together");
        return Err(a.refuse_at(nodes, message, format!("expected {MAX_DEFORMATIONS} at most: fewer sections")));
    }
    let refusal = || a.refuse_at(nodes, "two sections are at the same place", "expected another integration");
    if compat {
        let formulation =
            |places: &[f64]| CurvatureBased::as_opensees(iteration, places, shear, plane).ok_or_else(refusal);
        return build(formulation, (interp, a), words, ends, nodes);
    }
    let formulation = |places: &[f64]| CurvatureBased::new(iteration, places, shear).ok_or_else(refusal);
    build(formulation, (interp, a), words, ends, nodes)
}

fn make_mixed(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    if a.ahead().any(|word| word.as_str() == "-geomNonlinear") {
        let message = "-geomNonlinear is not known here: deflections within a mixed beam do not count";
        return Err(a.refuse_at(nodes, message, "expected more elements instead"));
    }
    let words = take(interp, a, ends, Rule::Lobatto, None)?;
    let mixed = Mixed { natural: words.force_based };
    build(|_: &[f64]| Ok(mixed), (interp, a), words, ends, nodes)
}

/// The words after the nodes, in any of the forms that OpenSees has had. `deflects` is given where deflections count, and says
/// whether those of shear do.
fn take(
    interp: &mut Tcl,
    a: &mut Args<'_>,
    ends: &Ends,
    default: Rule,
    deflects: Option<bool>,
) -> Result<Words, Exception> {
    ends.need_frame(a)?;
    // Others have lumped masses alone.
    let by_displacements = default == Rule::Legendre;
    let second_is_number = a.ahead().nth(1).is_some_and(|v| v.as_f64().is_some());
    let (transform, transform_at, integration_words, mut rule) = match (a.numbers_ahead(), second_is_number) {
        // The number of points and `-sections`, or with one section for all of them.
        (3.., _) => {
            let [n] = a.parts([&POINTS])?;
            let section = a.of(&interp.host.builder.definitions.sections)?;
            let (transform, _) = a.of(&interp.host.builder.definitions.transforms)?;
            (transform, a.last_span(), None, Some((default, vec![section; n])))
        }
        // Options by name, in any order.
        (1, _) if a.ahead().nth(1).is_some_and(|v| matches!(&*v.as_str(), "-section" | "-transform")) => {
            let [n] = a.parts([&POINTS])?;
            let (mut section, mut transform) = (None, None);
            loop {
                if a.flag("-section") {
                    section = Some(a.of(&interp.host.builder.definitions.sections)?);
                } else if a.flag("-transform") {
                    transform = Some((a.of(&interp.host.builder.definitions.transforms)?.0, a.last_span()));
                } else {
                    break;
                }
            }
            let missing = |what: &str| a.refuse(format!("the beam has no {what}"), "expected -section and -transform");
            let section = section.ok_or_else(|| missing("section"))?;
            let (transform, at) = transform.ok_or_else(|| missing("geometric transformation"))?;
            (transform, at, None, Some((default, vec![section; n])))
        }
        (1, _) if a.ahead().nth(1).is_some_and(|v| v.as_str() == "-sections") => {
            let [n] = a.parts([&POINTS])?;
            a.flag("-sections");
            let sections: Vec<_> =
                (0..n).map(|_| a.of(&interp.host.builder.definitions.sections)).collect::<Result<_, _>>()?;
            let (transform, _) = a.of(&interp.host.builder.definitions.transforms)?;
            (transform, a.last_span(), None, Some((default, sections)))
        }
        // A rule in words, after the transformation.
        (_, false) => {
            let (transform, _) = a.of(&interp.host.builder.definitions.transforms)?;
            let at = a.last_span();
            let mut words = vec![a.value(INTEGRATION.meaning)?.clone()];
            // Without quotes the numbers are words of their own.
            while words[0].to_list().is_ok_and(|l| l.len() == 1) && a.at_number() {
                words.push(a.value("number of the integration")?.clone());
            }
            let value = if words.len() == 1 { words.remove(0) } else { Value::list(words) };
            (transform, at, Some(value), None)
        }
        _ => {
            let (transform, _) = a.of(&interp.host.builder.definitions.transforms)?;
            let at = a.last_span();
            let (found, _) = a.of(&interp.host.builder.definitions.integrations)?;
            (transform, at, None, Some((found.rule, found.sections)))
        }
    };
    if let Some(value) = integration_words {
        let found = in_words(interp, a, &value)?;
        rule = Some((found.rule, found.sections));
    }
    let Some((mut rule, sections)) = rule else { unreachable!("each form has a rule") };
    let (mut rho, mut consistent, mut force_based, mut shear, mut damping) =
        (0.0, false, follower(interp), deflects.unwrap_or(false), None);
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-mass" => rho = a.number(&MASS_PER_LENGTH)?,
            "-shear" if deflects.is_some() => shear = true,
            "-cMass" if by_displacements => consistent = true,
            "-lMass" => consistent = false,
            "-damp" if deflects.is_none() => damping = Some(of_tag(interp, a)?),
            "-iter" => iterations(interp, a, &mut force_based)?,
            // Without --compat the step is cut into parts by itself.
            "-subdivide" => {
                force_based.parts = a.int("number of subdivisions")?.max(1) as u32;
                force_based.factor = a.float("factor of a subdivision")?.max(1.0);
            }
            "-integration" => rule = named_rule(interp, a)?,
            _ => ignore_unknown(interp, a)?,
        }
    }
    if rule.points(sections.len(), 1.0).is_none() && !matches!(rule, Rule::Hinges(..)) {
        let message = format!("the rule of integration has no form with {} points", sections.len());
        rule = without_weight(interp, a, rule, sections.len(), message)?;
    }
    let integration = Integration { rule, sections };
    Ok(Words { transform, transform_at, integration, rho, consistent, force_based, shear, damping })
}

/// The rule of integration of the option, a name alone.
fn named_rule(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Rule, Exception> {
    let words = a.word("rule of integration")?;
    let name = words.split_whitespace().next().unwrap_or_default().to_owned();
    if name.len() < words.trim().len() {
        let message = format!("-integration takes the name {name} alone");
        let d = Diagnostic::warning(&checks::words::WORDS_LEFT_OVER, message);
        warn(interp, d.at(a.last_span(), "what follows the name is ignored"))?;
    }
    simple(&name).ok_or_else(|| a.unknown_name("rule of integration", ["Lobatto", "Legendre", "Radau", "NewtonCotes"]))
}

/// A force-based beam as the run wants it.
fn follower(interp: &Tcl) -> ForceBased {
    ForceBased { compat: interp.host.follows(&[slips::FORCE_BEAM_TRIALS]), ..ForceBased::default() }
}

fn iterations(interp: &mut Tcl, a: &mut Args<'_>, force_based: &mut ForceBased) -> Result<(), Exception> {
    // OpenSees takes no notice of a number of iterations that is the last word.
    if a.left() == 1 && a.count(&ITERATIONS).is_ok() {
        let d =
            Diagnostic::warning(&checks::words::UNUSED_WORD, "-iter has no tolerance, and is ignored, as in OpenSees");
        return warn(interp, d.at(a.last_span(), "expected a tolerance behind it"));
    }
    force_based.max_iterations = a.count(&ITERATIONS)?;
    force_based.tolerance = a.number(&TOLERANCE)?;
    Ok(())
}

/// A rule of integration in the words of an element: its name and numbers in a list.
fn in_words(interp: &mut Tcl, a: &Args<'_>, value: &Value) -> Result<Integration, Exception> {
    let list = value.to_list().map(|l| l.to_vec()).unwrap_or_default();
    let numbers: Option<Vec<f64>> = list.iter().skip(1).map(Value::as_f64).collect();
    match (list.first(), numbers) {
        (Some(name), Some(numbers)) if !numbers.is_empty() => integration(interp, a, &name.as_str(), &numbers),
        _ => Err(a.refuse(
            format!("\"{}\" is no integration", value.as_str()),
            "expected the tag of a beamIntegration, or a rule with its numbers in one word",
        )),
    }
}

/// The beam of words, of a formulation for the places of its sections.
fn build<F>(
    formulation: impl FnOnce(&[f64]) -> Result<F, Exception>,
    (interp, a): (&mut Tcl, &Args<'_>),
    w: Words,
    ends: &Ends,
    nodes: Place,
) -> Result<Arc<dyn Element>, Exception>
where
    F: Formulation<6, 3> + Formulation<12, 6>,
    FiberBeam<F, 6, 3>: Shared<dyn Element>,
    FiberBeam<F, 12, 6>: Shared<dyn Element>,
{
    let stand = transform::Ends { place: ends.place, disp: &ends.disp };
    let wrong = |e| no_transform(a, w.transform_at, nodes, e);
    let mass = (w.rho, w.consistent);
    let sections = w.integration.sections;
    deformable(interp, a, &sections, (ends.ndm, <F as Formulation<12, 6>>::LACKING), nodes)?;
    let points = |length: f64| {
        let found = w.integration.rule.points(sections.len(), length);
        let good = found.filter(|(x, w)| x.iter().chain(w).all(|x| x.is_finite()));
        good.ok_or_else(|| a.refuse_at(nodes, "the integration has no points for this beam", ""))
    };
    if ends.ndm == 2 {
        let transform = w.transform.plane(&stand).map_err(wrong)?;
        let points = points(transform.length())?;
        let formulation = formulation(&points.0)?;
        let beam = FiberBeam::<F, 6, 3>::new(formulation, transform, sections, points, mass).shared();
        return damped(beam, w.damping).map_err(|e| refused(a, nodes, e));
    }
    let transform = w.transform.space(&stand).map_err(wrong)?;
    let points = points(transform.length())?;
    let formulation = formulation(&points.0)?;
    let beam = FiberBeam::<F, 12, 6>::new(formulation, transform, sections, points, mass).shared();
    damped(beam, w.damping).map_err(|e| refused(a, nodes, e))
}

/// Refuse sections that leave the beam without a stiffness, and warn of those that lack a resultant that others have.
fn deformable(
    interp: &mut Tcl,
    a: &Args<'_>,
    sections: &[(SharedSection, i32)],
    (ndm, lacking): (usize, Lacking),
    at: Place,
) -> Result<(), Exception> {
    let needed = &[Resultant::P, Resultant::Mz, Resultant::My, Resultant::T][..if ndm == 2 { 2 } else { 4 }];
    for r in needed {
        let without: Vec<i32> =
            sections.iter().filter(|(s, _)| !s.resultants().contains(r)).map(|(_, tag)| *tag).collect();
        let Some(tag) = without.first() else { continue };
        // OpenSees takes a beam of sections without torsion for nearly rigid, or for one without that stiffness.
        let some = without.len() < sections.len() || *r == Resultant::T;
        let consequence = match lacking {
            Lacking::Rigid if some => Some("the beam is rigid there"),
            Lacking::Free if some => Some("the beam has no stiffness there"),
            Lacking::Rigid | Lacking::Free | Lacking::Refused => None,
        };
        let message = format!("section {tag} has no {}", r.name());
        let Some(consequence) = consequence else {
            let label = "expected another section, or one with more resultants (Aggregator)";
            return Err(a.refuse_at(at, format!("{message}, which the beam needs"), label));
        };
        warn(
            interp,
            Diagnostic::warning(&checks::elements::NO_STIFFNESS, format!("{message}: {consequence}"))
                .at(at, "expected a section with it"),
        )?;
    }
    Ok(())
}

fn make_with_hinges(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let nodes = a.last_span();
    ends.need_frame(a)?;
    let sections = &interp.host.builder.definitions.sections;
    let (section_i, lp_i) = (a.of(sections)?, a.number(&LP_I)?);
    let (section_j, lp_j) = (a.of(sections)?, a.number(&LP_J)?);
    let (e, area, iz) = (a.number(&E)?, a.number(&A)?, a.number(&IZ)?);
    let mut s = ElasticSection { e, area, iz, iy: 0.0, g: 0.0, j: 0.0, shear: (None, None) };
    if ends.ndm == 3 {
        s.iy = a.number(&IY)?;
        (s.g, s.j) = (a.number(&G)?, a.number(&J)?);
    }
    let (transform, _) = a.of(&interp.host.builder.definitions.transforms)?;
    let transform_at = a.last_span();
    let (mut rho, mut force_based) = (0.0, follower(interp));
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-mass" => rho = a.number(&MASS_PER_LENGTH)?,
            "-iter" => iterations(interp, a, &mut force_based)?,
            _ => ignore_unknown(interp, a)?,
        }
    }
    let elastic: SharedSection = Elastic::new(s, ends.ndm == 2).shared();
    let all = [section_i, section_j, (elastic, 0)];
    let sections = Hinge::Radau.sections().iter().map(|i| all[*i].clone()).collect();
    let integration = Integration { rule: Rule::Hinges(Hinge::Radau, lp_i, lp_j), sections };
    let words = Words {
        transform,
        transform_at,
        integration,
        rho,
        consistent: false,
        force_based,
        shear: false,
        damping: None,
    };
    build(|_: &[f64]| Ok(force_based), (interp, a), words, ends, nodes)
}
