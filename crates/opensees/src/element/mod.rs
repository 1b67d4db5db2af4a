//! `element`.

pub(crate) mod amend;
mod amended_place;
mod amendments;
mod beam;
mod beam_column_joint;
mod bearing;
mod brick;
mod cable;
mod component;
mod contact;
mod corners;
pub(crate) mod damping;
mod fiber_beam;
mod heated_pendulum;
mod heated_triple;
mod inerter;
mod joint_2d;
mod joints;
mod kikuchi;
mod lead_units;
pub(crate) mod learned;
mod multiple_normal_spring;
mod multiple_shear_spring;
mod multiple_springs;
mod quad;
mod recipe;
mod rheology_bearing;
mod rubber_bearing;
mod shell;
mod sliding;
mod timoshenko;
mod triple;
mod truss;
mod tubular_joint;
mod two_node_link;
mod wall;
mod yamamoto;
mod zero_length;
mod zero_length_section;

use crate::args::Args;
use crate::model::nodes::{need_model, node_of};
use crate::text::{Arg, Domain};
use crate::things;
use crate::{Command, Outcome, Tcl, finish, kind};
use hysteron_engine::element::axes::Orientation;
use hysteron_engine::element::{Element, ElementError};
use hysteron_engine::model::NodeId;
use hysteron_tcl::{Call, Exception, Value};
use nalgebra::Vector3;
use std::sync::Arc;

pub use amendments::{AMENDMENTS, AmendmentKind, AmendmentOption};
pub use recipe::numbers_of_element;
pub(crate) use recipe::{domain_of, set_parameter, with_parameter};

pub(crate) const COMMANDS: &[Command] = &[Command::new("element", "element $kind $tag $iNode $jNode ...", element)
    .arguments(&[
        Arg::whole("tag", "tag of the element"),
        Arg::whole("i", "tag of node i"),
        Arg::whole("j", "tag of node j"),
        Arg::thing("transf", things::TRANSFORM),
        Arg::thing("frnMdlTag", things::FRICTION),
        Arg::thing("material", things::ND_MATERIAL),
        Arg::thing("section", things::PLATE),
    ])
    .about("Makes an element between nodes.")
    .defining(&[things::ELEMENT], 2)
    .with_kinds(|| kind::usages(KINDS))];

/// Mass of an element that refuses 0.
const MASS_ABOVE_ZERO: Arg = crate::text::any_command::MASS.within(Domain::Positive);

/// Makes an element between two nodes that are already known.
type MakeBetween = fn(&mut Tcl, &mut Args<'_>, &Ends) -> Result<Arc<dyn Element>, Exception>;
/// Makes an element and names its nodes.
type MakeAnywhere = fn(&mut Tcl, &mut Args<'_>) -> Result<(Vec<NodeId>, Arc<dyn Element>), Exception>;

/// Function that makes a kind of element.
enum Make {
    /// Between two nodes, from the words after them.
    TwoNodes(MakeBetween),
    /// From the words after the tag, which name the nodes.
    AnyNodes(MakeAnywhere),
}

/// A kind of element.
type Kind = kind::Kind<Make>;

const KINDS: &[Kind] = &[
    beam::ELASTIC,
    beam::MODIFIED,
    beam::MODIFIED_SPACE,
    component::COMPONENT,
    timoshenko::TIMOSHENKO,
    bearing::BOUC_WEN,
    bearing::PLASTICITY,
    rubber_bearing::HDR,
    rheology_bearing::RHEOLOGY,
    rubber_bearing::ELASTOMERIC_X,
    rubber_bearing::LEAD_RUBBER_X,
    sliding::FLAT,
    sliding::PENDULUM,
    heated_pendulum::HEATED_PENDULUM,
    sliding::RJ_WATSON,
    multiple_shear_spring::MULTIPLE_SHEAR_SPRING,
    triple::TRIPLE,
    heated_triple::TRIPLE_X,
    bearing::UFRP,
    kikuchi::KIKUCHI,
    multiple_normal_spring::MULTIPLE_NORMAL_SPRING,
    cable::CATENARY,
    truss::TRUSS,
    truss::COROT_TRUSS,
    truss::TRUSS_SECTION,
    truss::COROT_TRUSS_SECTION,
    two_node_link::TWO_NODE_LINK,
    inerter::INERTER,
    yamamoto::YAMAMOTO,
    zero_length::ZERO_LENGTH,
    zero_length::COUPLED,
    zero_length_section::ZERO_LENGTH_SECTION,
    contact::IMPACT,
    contact::CONTACT_2D,
    contact::CONTACT_3D,
    fiber_beam::DISPLACEMENT,
    fiber_beam::AXIAL_EQUILIBRIUM,
    fiber_beam::FORCE,
    fiber_beam::CURVATURE,
    fiber_beam::CURVATURE_SHEAR,
    fiber_beam::MIXED,
    fiber_beam::WITH_HINGES,
    quad::QUAD,
    quad::MEAN_DILATATION,
    quad::STABILISED,
    quad::TRIANGLE,
    quad::NINE_NODES,
    quad::EIGHT_NODES,
    quad::SIX_NODES,
    quad::ENHANCED,
    brick::BRICK,
    brick::MEAN_DILATATION,
    brick::STABILISED,
    brick::FOUR_NODES,
    brick::TEN_NODES,
    shell::MITC4,
    shell::DKGQ,
    shell::DKGT,
    shell::UPDATED,
    shell::ENHANCED,
    shell::ENHANCED_TRIANGLE,
    wall::MVLEM,
    wall::MVLEM_3D,
    wall::SFI_MVLEM,
    wall::E_SFI,
    wall::SFI_MVLEM_3D,
    wall::E_SFI_MVLEM_3D,
    joint_2d::JOINT_2D,
    beam_column_joint::BEAM_COLUMN_JOINT,
    tubular_joint::TUBULAR_JOINT,
];

/// The two nodes of an element.
struct Ends {
    nodes: [NodeId; 2],
    place: (Vector3<f64>, Vector3<f64>),
    /// Displacements of all degrees of freedom of i, then of j.
    disp: Vec<f64>,
    ndm: usize,
    /// Degrees of freedom of each node.
    ndf: usize,
}

impl Ends {
    fn take(interp: &Tcl, a: &mut Args<'_>) -> Result<Self, Exception> {
        let i = node_of(interp, a, "tag of node i")?;
        let j = node_of(interp, a, "tag of node j")?;
        let engine = &interp.host.engine;
        let (ni, nj) = (&engine.model().nodes[i.0], &engine.model().nodes[j.0]);
        if i == j {
            let e = a.refuse("the element joins a node with itself", "expected another node");
            return Err(e.by(&crate::checks::elements::SAME_NODE));
        }
        if ni.ndf != nj.ndf {
            let message = format!("node {} has {} degrees of freedom, node {} has {}", ni.tag, ni.ndf, nj.tag, nj.ndf);
            return Err(a.refuse(message, "expected as many as at node i"));
        }
        let disp = ni.dofs().chain(nj.dofs()).map(|d| engine.state().disp[d]).collect();
        Ok(Self { nodes: [i, j], place: (ni.place(), nj.place()), disp, ndm: ni.ndm(), ndf: ni.ndf })
    }

    /// Displacement of j less that of i.
    fn initial(&self) -> Vec<f64> {
        let (i, j) = self.disp.split_at(self.ndf);
        j.iter().zip(i).map(|(j, i)| j - i).collect()
    }

    /// Refuses nodes that have not so many dimensions and degrees of freedom.
    fn need(&self, a: &Args<'_>, (ndm, ndf): (usize, usize)) -> Result<(), Exception> {
        let fits = (self.ndm, self.ndf) == (ndm, ndf);
        if fits { Ok(()) } else { Err(self.wrong(a, &format!("{ndf} degrees of freedom in {ndm} dimensions"))) }
    }

    /// Refuses nodes that are not those of frames.
    fn need_frame(&self, a: &Args<'_>) -> Result<(), Exception> {
        let fits = matches!((self.ndm, self.ndf), (2, 3) | (3, 6));
        if fits { Ok(()) } else { Err(self.wrong(a, "3 degrees of freedom in 2 or 6 in 3 dimensions")) }
    }

    /// Refuses nodes that are neither those of trusses nor those of frames.
    fn need_any(&self, a: &Args<'_>) -> Result<(), Exception> {
        let fits = matches!((self.ndm, self.ndf), (1, 1) | (2, 2 | 3) | (3, 3 | 6));
        let wanted = "1 degree of freedom in 1, 2 or 3 in 2, 3 or 6 in 3 dimensions";
        if fits { Ok(()) } else { Err(self.wrong(a, wanted)) }
    }

    /// The error for nodes that the element cannot join.
    fn wrong(&self, a: &Args<'_>, wanted: &str) -> Exception {
        let message = format!(
            "the element needs {wanted}; its nodes have {} degrees of freedom in {} dimensions",
            self.ndf, self.ndm
        );
        a.refuse(message, "not between these nodes")
    }
}

fn element(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    need_model(interp, call)?;
    let mut a = Args::new(call, "element $kind $tag $iNode $jNode ...");
    let kind = kind::take(&mut a, "kind of element", "element", KINDS.iter())?;
    interp.host.note_kind("element", kind.names[0]);
    let tag = a.int("tag of the element")?;
    if interp.host.engine.model().element(tag).is_some() {
        return Err(a.exists(things::ELEMENT, tag));
    }
    let (nodes, made) = match &kind.make {
        Make::TwoNodes(make) => {
            let ends = Ends::take(interp, &mut a)?;
            let made = make(interp, &mut a, &ends)?;
            let words = recipe::words_of(call, &ends, &made);
            interp.host.builder.element_words.insert(tag, words);
            (ends.nodes.to_vec(), made)
        }
        Make::AnyNodes(make) => make(interp, &mut a)?,
    };
    finish(interp, &a)?;
    interp.host.engine.add_element(tag, nodes, made);
    interp.host.builder.components.insert(tag, a.taken);
    if let Some(span) = call.whole_span() {
        interp.host.builder.made_at.insert(tag, span);
    }
    Ok(Value::EMPTY)
}

/// An error of an element as one of the command.
fn refused(a: &Args<'_>, span: Option<hysteron_tcl::diagnostic::Span>, e: ElementError) -> Exception {
    a.refuse_at(span, e.0, "")
}

/// The words after `-orient`: x and y of the local axes (six numbers), or, in space, y alone (three).
fn orientation(a: &mut Args<'_>, ndm: usize) -> Result<Orientation, Exception> {
    use crate::model::transform::vector;
    let first = vector(a, 3, "vector after -orient")?;
    if ndm == 3 && !a.at_number() {
        return Ok(Orientation { x: None, y: Some(first) });
    }
    Ok(Orientation { x: Some(first), y: Some(vector(a, 3, "local x-y plane's vector after -orient")?) })
}
