//! `section`.

pub(crate) mod beam_integration;
pub(crate) mod fiber;
mod isolator;
mod nd_fiber;
pub(crate) mod open;
mod plate;
mod shapes;

use crate::args::Args;
use crate::checks;
use crate::model::nodes::need_model;
use crate::text::{Arg, Domain, Text};
use crate::things;
use crate::{Command, Outcome, Tcl, finish, ignore_option, ignore_unknown, kind, warn};
use hysteron_engine::material::Elastic as ElasticMaterial;
use hysteron_engine::section::plate::SharedPlateSection;
use hysteron_engine::section::{
    Aggregator, Elastic, ElasticSection, Fiber, FiberBending, FiberSection, ParallelSections, Resultant, SharedSection,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};

const FIBER_GJ: Arg = Arg::of("-GJ", "GJ", "torsional rigidity GJ").within(Domain::NotNegative);

const TAG: Arg = Arg::whole("tag", "tag of the section");
const ELASTIC_E: Arg = Arg::of_domain("E", "elastic modulus E", Domain::UsuallyPositive);
const ELASTIC_A: Arg = Arg::of_domain("A", "cross-sectional area A", Domain::UsuallyPositive);
const ELASTIC_IZ: Arg = Arg::of_domain("Iz", "second moment of area Iz", Domain::UsuallyPositive);
const ELASTIC_G: Arg = Arg::of_domain("G", "shear modulus G", Domain::UsuallyPositive);
/// In the plane 0 is none.
const PLANE_G: Arg = ELASTIC_G.within(Domain::UsuallyNotNegative);
const PLANE_ALPHA_Y: Arg = ALPHA_Y.within(Domain::UsuallyNotNegative);
const ALPHA_Y: Arg = Arg::of_domain("alphaY", "shear factor alphaY", Domain::UsuallyPositive);
const ELASTIC_IY: Arg = Arg::of_domain("Iy", "second moment of area Iy", Domain::UsuallyPositive);
const ELASTIC_J: Arg = Arg::of_domain("J", "torsion constant J", Domain::UsuallyPositive);
const ALPHA_Z: Arg = Arg::of_domain("alphaZ", "shear factor alphaZ", Domain::UsuallyPositive);
/// Properties of a frame's section by their names.
const FRAME: [Arg; 8] = [
    ELASTIC_E.after("-E"),
    ELASTIC_A.after("-A"),
    ELASTIC_IZ.after("-Iz"),
    ELASTIC_IY.after("-Iy"),
    ELASTIC_G.after("-G"),
    ELASTIC_J.after("-J"),
    Arg::of("-Ay", "Avy", "shear area Avy").within(Domain::UsuallyPositive),
    Arg::of("-Az", "Avz", "shear area Avz").within(Domain::UsuallyPositive),
];

pub(crate) const COMMANDS: &[Command] = &[Command::new("section", SECTION, section)
    .arguments(&[TAG])
    .about("Makes a cross-section.")
    .defining(&[things::SECTION, things::PLATE], 2)
    .with_kinds(|| kind::usages(KINDS))];

const SECTION: &str = "section $kind $tag ...";

/// Maker of a section from the words after its tag.
#[derive(Clone, Copy)]
enum Make {
    /// Of beams.
    Beam(fn(&mut Tcl, &mut Args<'_>) -> Result<SharedSection, Exception>),
    /// Of plates and shells.
    Plate(fn(&mut Tcl, &mut Args<'_>) -> Result<SharedPlateSection, Exception>),
}

/// A kind of section.
type Kind = kind::Kind<Make>;

const KINDS: &[Kind] = &[
    Kind {
        names: &["Elastic", "ElasticSection", "elastic"],
        usage: "section Elastic $tag $E $A $Iz <$G $alphaY> (in the plane) or $E $A $Iz $Iy $G $J <$alphaY $alphaZ> \
                (in space)",
        text: Text::new("A linear elastic section.")
            .example("section Elastic 77 1 1 1")
            .arguments(&[ELASTIC_E, ELASTIC_A, ELASTIC_IZ, ELASTIC_G, ALPHA_Y, ELASTIC_IY, ELASTIC_J, ALPHA_Z]),
        make: Make::Beam(elastic),
    },
    Kind {
        names: &["ElasticFrame", "FrameElastic"],
        usage: "section ElasticFrame $tag <$E $A $Iz $Iy $G $J> <-E $E> <-A $A> <-Iz $Iz> <-Iy $Iy> <-G $G> <-J $J> \
                <-Ay $Avy> <-Az $Avz>",
        text: Text::new(
            "An elastic section whose properties are given by their names, or in the order of `section Elastic`.",
        )
        .example("section ElasticFrame 9 -E 2e8 -A 0.1 -Iz 1e-3 -Iy 1e-3 -G 8e7 -J 1e-3")
        .arguments(&[ELASTIC_E, ELASTIC_A, ELASTIC_IZ, ELASTIC_IY, ELASTIC_G, ELASTIC_J])
        .groups(&[&FRAME]),
        make: Make::Beam(elastic_frame),
    },
    Kind {
        names: &["Fiber", "fiberSec", "FiberSec", "FiberSection", "fiber"],
        usage: "section Fiber $tag <-GJ $GJ | -torsion $material> <-noCentroid> {fibers}",
        text: Text::new("A section of fibres, which `fiber`, `patch` and `layer` in its body make.")
            .example("section Fiber 77 -GJ 1. {fiber 0.1 0.1 1. 1; fiber -0.1 0.1 1. 1; fiber 0. -0.1 1. 1}")
            .arguments(&[FIBER_GJ, Arg::of("-torsion", "material", "law of torsion")]),
        make: Make::Beam(fibers),
    },
    Kind {
        names: &["Aggregator", "AddDeformation"],
        usage: "section Aggregator $tag $material1 P|Mz|Vy|My|Vz|T <$material2 ...> <-section $section>",
        text: Text::new("A section of uniaxial laws, one for each resultant, optionally added to another section.")
            .example("section Aggregator 77 1 P")
            .arguments(&[
                Arg::new("material1", "tags of the laws, each followed by the response that it adds"),
                Arg::of("-section", "section", "tag of a section").within(Domain::Whole),
            ]),
        make: Make::Beam(aggregator),
    },
    Kind {
        names: &["Parallel", "ParallelSection"],
        usage: "section Parallel $tag $section1 <$section2 ...>",
        text: Text::new("Other sections with the same deformations, whose resultants are added.")
            .example("section Parallel 77 1 1")
            .arguments(&[Arg::thing("section1", things::SECTION)]),
        make: Make::Beam(parallel),
    },
    Kind {
        names: &["Uniaxial", "Generic1D", "Generic1d"],
        usage: "section Uniaxial $tag $material P|Mz|Vy|My|Vz|T",
        text: Text::new("A section with one resultant.")
            .example("section Uniaxial 77 1 P")
            .arguments(&[Arg::thing("material", things::MATERIAL)]),
        make: Make::Beam(uniaxial),
    },
    nd_fiber::ND_FIBER,
    isolator::BIDIRECTIONAL,
    isolator::ELLIPTICAL,
    isolator::TWO_SPRINGS,
    shapes::WIDE_FLANGE,
    shapes::RECTANGULAR_CONCRETE,
    shapes::CIRCULAR_CONCRETE,
    plate::ELASTIC,
    plate::UNIFORM,
    plate::LAYERED,
];

fn section(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    need_model(interp, call)?;
    let mut a = Args::new(call, SECTION);
    let kind = kind::take(&mut a, "kind of section", "section", KINDS.iter())?;
    interp.host.note_kind("section", kind.names[0]);
    let tag = a.int(TAG.meaning)?;
    let span = a.last_span();
    interp.host.builder.open_section = None;
    let continua = kind.names == nd_fiber::ND_FIBER.names;
    if interp.host.called_by_host && (continua || kind.names.contains(&"Fiber")) {
        return open::open(interp, &mut a, tag, continua);
    }
    let added = match kind.make {
        Make::Beam(make) => {
            let made = make(interp, &mut a)?;
            finish(interp, &a)?;
            interp.host.builder.definitions.sections.add(tag, made)
        }
        Make::Plate(make) => {
            let made = make(interp, &mut a)?;
            finish(interp, &a)?;
            interp.host.builder.definitions.plates.add(tag, made)
        }
    };
    if !added {
        return Err(a.exists_at(span, things::SECTION, tag));
    }
    Ok(Value::EMPTY)
}

fn elastic(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let (e, area) = (a.read(interp, &ELASTIC_E)?, a.read(interp, &ELASTIC_A)?);
    let iz = a.read(interp, &ELASTIC_IZ)?;
    let mut s = ElasticSection { e, area, iz, iy: 0.0, g: 0.0, j: 0.0, shear: (None, None) };
    let plane = interp.host.builder.ndm != 3;
    if !plane {
        s.iy = a.read(interp, &ELASTIC_IY)?;
        s.g = a.read(interp, &ELASTIC_G)?;
        s.j = a.read(interp, &ELASTIC_J)?;
        if a.left() > 0 {
            s.shear.0 = Some(area * a.read(interp, &ALPHA_Y)?);
            s.shear.1 = Some(area * a.read(interp, &ALPHA_Z)?);
        }
    } else if a.left() > 0 {
        s.g = a.read(interp, &PLANE_G)?;
        s.shear.0 = Some(area * a.read(interp, &PLANE_ALPHA_Y)?);
        // Most beams have no use for it: packages on top give zeros by default.
        if s.shear_rigidity().0.is_none() {
            warn_of_no_stiffness(interp, a, "the section has no stiffness in shear, which beams by forces need")?;
        }
    }
    Ok(Elastic::new(s, plane).shared())
}

/// Properties in the order of `section Elastic`, or each by its name; those of a plane frame are enough in the plane.
fn elastic_frame(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    const NAMES: [&str; 8] = ["-E", "-A", "-Iz", "-Iy", "-G", "-J", "-Ay", "-Az"];
    let mut values = [None; 8];
    for (value, arg) in values.iter_mut().zip(&FRAME).take(6) {
        if !a.at_number() {
            break;
        }
        *value = Some(a.read(interp, arg)?);
    }
    while let Some(option) = a.option() {
        match NAMES.iter().position(|n| *n == option.as_ref()) {
            Some(i) => values[i] = Some(a.read(interp, &FRAME[i])?),
            None => ignore_option(interp, a, &NAMES)?,
        }
    }
    let plane = interp.host.builder.ndm != 3;
    let needed = if plane { 3 } else { 6 };
    if let Some(i) = values.iter().take(needed).position(Option::is_none) {
        return Err(a.refuse(format!("the {} is missing", FRAME[i].meaning), format!("expected {}", NAMES[i])));
    }
    let [e, area, iz, iy, g, j, ..] = values.map(|v| v.unwrap_or(0.0));
    Ok(Elastic::new(ElasticSection { e, area, iz, iy, g, j, shear: (values[6], values[7]) }, plane).shared())
}

/// The words of a fiber section before its body.
pub(crate) struct FiberOptions {
    torsion: Option<(hysteron_engine::material::Material, i32)>,
    origin: bool,
    space: bool,
}

impl FiberOptions {
    /// Section of these fibers.
    pub(crate) fn section(&self, fibers: Vec<Fiber>) -> SharedSection {
        let bending = if self.space { FiberBending::Space(self.torsion.clone()) } else { FiberBending::Plane };
        FiberSection::new(fibers, bending, self.origin).shared()
    }
}

/// Take the options of a fiber section; the last `behind` words are left.
fn fiber_options(interp: &mut Tcl, a: &mut Args<'_>, behind: usize) -> Result<FiberOptions, Exception> {
    let span = a.last_span();
    let (mut torsion, mut origin) = (None, false);
    // The words before the body that are no options, such as a shear centre, go unused in OpenSees.
    while a.left() > behind {
        match a.option().as_deref().unwrap_or_default() {
            "-GJ" => {
                let gj = a.number(&FIBER_GJ)?;
                if gj == 0.0 {
                    warn_of_no_stiffness(interp, a, "the section has no torsional stiffness")?;
                }
                let material: hysteron_engine::material::Material = ElasticMaterial::new(gj).shared();
                torsion = Some((material, 0));
            }
            "-torsion" => torsion = Some(a.of(&interp.host.builder.definitions.materials)?),
            "-noCentroid" => origin = true,
            _ => ignore_unknown(interp, a)?,
        }
    }
    let space = interp.host.builder.ndm == 3;
    if space && torsion.is_none() {
        warn_of_torsion(interp, span)?;
    }
    Ok(FiberOptions { torsion, origin, space })
}

fn fibers(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let span = a.last_span();
    let options = fiber_options(interp, a, 1)?;
    let body = a.value("body with the fibers")?;
    let outer = interp.host.builder.fibers.replace(vec![]);
    let done = interp.eval_value(&body);
    let fibers = std::mem::replace(&mut interp.host.builder.fibers, outer).unwrap_or_default();
    done?;
    if fibers.iter().map(|f| f.area).sum::<f64>() <= 0.0 {
        return Err(a.refuse_at(span, "the section has no area", "expected patches, layers or fibers in its body"));
    }
    Ok(options.section(fibers))
}

/// Warn of the last word taken, a stiffness of zero.
fn warn_of_no_stiffness(interp: &mut Tcl, a: &Args<'_>, message: &str) -> Result<(), Exception> {
    let d = Diagnostic::warning(&checks::elements::NO_STIFFNESS, message);
    warn(interp, d.at(a.last_span(), "expected more than 0"))
}

/// OpenSees 2 knew no torsion of fiber sections; OpenSees 3 refuses one without.
fn warn_of_torsion(interp: &mut Tcl, span: Option<hysteron_tcl::diagnostic::Span>) -> Result<(), Exception> {
    let d =
        Diagnostic::warning(&checks::elements::NO_STIFFNESS, "a fiber section in space without a torsional stiffness");
    warn(interp, d.at(span, "expected -GJ or -torsion after the tag, or an Aggregator with T around it"))
}

fn resultant(a: &mut Args<'_>) -> Result<Resultant, Exception> {
    let name = a.word("resultant")?;
    let found = Resultant::ALL.into_iter().find(|r| r.name() == name);
    found.ok_or_else(|| a.unknown_name("resultant", Resultant::ALL.map(Resultant::name)))
}

fn aggregator(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let span = a.last_span();
    let (mut base, mut additions) = (None, vec![]);
    while a.left() > 0 {
        if a.flag("-section") {
            base = Some(a.of(&interp.host.builder.definitions.sections)?.0);
            continue;
        }
        let (material, tag) = a.of(&interp.host.builder.definitions.materials)?;
        additions.push((material, tag, resultant(a)?));
    }
    if additions.is_empty() {
        return Err(a.refuse_at(span, "there is nothing to aggregate", "expected materials and their resultants"));
    }
    let made = Aggregator::new(base, additions).map_err(|e| a.refuse_at(span, e.0, ""))?;
    Ok(made.shared())
}

fn parallel(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let mut sections = vec![a.of(&interp.host.builder.definitions.sections)?];
    while a.left() > 0 {
        sections.push(a.of(&interp.host.builder.definitions.sections)?);
    }
    Ok(ParallelSections::new(sections).shared())
}

fn uniaxial(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let (material, tag) = a.of(&interp.host.builder.definitions.materials)?;
    let addition = (material, tag, resultant(a)?);
    let made = Aggregator::new(None, vec![addition]).map_err(|e| a.refuse(e.0, ""))?;
    Ok(made.shared())
}
