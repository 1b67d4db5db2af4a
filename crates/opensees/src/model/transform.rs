//! `geomTransf`.

use crate::args::Args;
use crate::checks;
use crate::model::nodes::need_model;
use crate::slips;
use crate::text::{Arg, Domain, Text};
use crate::things;
use crate::{Command, Outcome, Tcl, ignore_unknown, kind, warn};
use hysteron_engine::element::transform::{TransformKind, TransformSpec};
use hysteron_tcl::diagnostic::Diagnostic;
use hysteron_tcl::{Call, Exception, Value};
use nalgebra::Vector3;

const TAG: Arg = Arg::whole("tag", "tag of the transformation");

pub(crate) const COMMANDS: &[Command] = &[Command::new("geomTransf", USAGE, geom_transf)
    .about("Makes a transformation between local and global coordinates, for beams.")
    .arguments(&[
        Arg::number("x", "x of the vector in the local x-z plane"),
        Arg::number("y", "y of the vector in the local x-z plane"),
        Arg::number("z", "z of the vector in the local x-z plane"),
        TAG,
        Arg::of("-jntOffset", "dxi", "rigid ends at i and j, as vectors from the node to the end of the beam")
            .within(Domain::Number),
    ])
    .defining(&[things::TRANSFORM], 2)
    .with_kinds(|| kind::usages(KINDS))];

const USAGE: &str = "geomTransf Linear|PDelta|Corotational $tag <$x $y $z of a vector in the local x-z plane, in space> \
                     <-jntOffset $dxi $dyi <$dzi> $dxj $dyj <$dzj>>";

const KINDS: &[kind::Kind<TransformKind>] = &[
    kind::Kind {
        names: &["Linear"],
        usage: USAGE_LINEAR,
        text: Text::new("Displacements are small: equilibrium is formed in the undeformed geometry."),
        make: TransformKind::Linear,
    },
    kind::Kind {
        names: &["PDelta", "LinearWithPDelta"],
        usage: USAGE_PDELTA,
        text: Text::new("Equilibrium of the axial force in the displaced chord; else as `Linear`."),
        make: TransformKind::PDelta,
    },
    kind::Kind {
        names: &["Corotational", "Corotational2d", "Corotational3d"],
        usage: USAGE_COROTATIONAL,
        text: Text::new("Large displacements and rotations of the chord, with small deformations."),
        make: TransformKind::Corotational,
    },
];

const USAGE_LINEAR: &str = "geomTransf Linear $tag <$x $y $z of a vector in the local x-z plane, in space> \
                            <-jntOffset $dxi $dyi <$dzi> $dxj $dyj <$dzj>>";
const USAGE_PDELTA: &str = "geomTransf PDelta $tag <$x $y $z of a vector in the local x-z plane, in space> \
                            <-jntOffset $dxi $dyi <$dzi> $dxj $dyj <$dzj>>";
const USAGE_COROTATIONAL: &str = "geomTransf Corotational $tag <$x $y $z of a vector in the local x-z plane, in space> \
                                  <-jntOffset $dxi $dyi <$dzi> $dxj $dyj <$dzj>>";

fn geom_transf(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    need_model(interp, call)?;
    let mut a = Args::new(call, USAGE);
    let kind = kind::take(&mut a, "kind of transformation", "geometric transformation", KINDS.iter())?;
    interp.host.note_kind("geomTransf", kind.names[0]);
    let tag = a.int(TAG.meaning)?;
    let span = a.last_span();
    let ndm = interp.host.builder.ndm;
    let mut xz = Vector3::zeros();
    if ndm == 3 {
        // Some scripts name the vector.
        a.flag("-vecxz");
        xz = vector(&mut a, 3, "vector in the local x-z plane")?;
        if xz.norm() == 0.0 {
            let e = a.refuse("the vector in the local x-z plane is zero", "expected a direction");
            return Err(e.by(&checks::elements::ZERO_VECTOR));
        }
    }
    let mut offsets = (Vector3::zeros(), Vector3::zeros());
    while let Some(option) = a.option() {
        match option.as_ref() {
            // Packages on top of OpenSees write the option with an empty list.
            "-jntOffset" if a.peek().is_none() => {
                let d =
                    Diagnostic::warning(&checks::model::OFFSETS_IGNORED, "geomTransf: the joint offsets are missing");
                warn(interp, d.at(a.last_span(), "taken for zero"))?;
            }
            "-jntOffset" => {
                offsets = (vector(&mut a, ndm, "offset at node i")?, vector(&mut a, ndm, "offset at node j")?);
            }
            _ => ignore_unknown(interp, &mut a)?,
        }
    }
    let ignored = ndm == 3 && kind.make == TransformKind::Corotational && offsets != Default::default();
    if ignored && interp.host.follows(&[slips::COROTATIONAL_OFFSETS]) {
        offsets = Default::default();
        let d = Diagnostic::warning(
            &checks::model::OFFSETS_IGNORED,
            "geomTransf Corotational: the joint offsets are taken for zero, as in OpenSees",
        );
        warn(interp, d.at(a.last_span(), "not used"))?;
    }
    let transform =
        TransformSpec { kind: kind.make, xz, offsets, by_trials: interp.host.follows(&[slips::COROTATIONAL_TRIALS]) };
    if !interp.host.builder.definitions.transforms.add(tag, transform) {
        return Err(a.exists_at(span, things::TRANSFORM, tag));
    }
    Ok(Value::EMPTY)
}

/// A vector with the first `n` components given.
pub(crate) fn vector(a: &mut Args<'_>, n: usize, what: &str) -> Result<Vector3<f64>, Exception> {
    let mut v = Vector3::zeros();
    for (i, axis) in ["x", "y", "z"].into_iter().enumerate().take(n) {
        v[i] = a.float(&format!("{axis} of the {what}"))?;
    }
    Ok(v)
}
