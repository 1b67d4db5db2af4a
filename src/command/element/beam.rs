//! `element elasticBeamColumn`.

use super::{Ends, Kind};
use crate::command::args::Args;
use crate::command::{Tcl, ignore_option};
use crate::element::Element;
use crate::element::beam::{Bending, ElasticBeam, Release};
use crate::element::transform::{self, TransformError};
use crate::script::Exception;
use std::sync::Arc;

pub(super) const ELASTIC: Kind = Kind {
    names: &["elasticBeamColumn", "ElasticBeamColumn", "elasticBeam"],
    usage: "element elasticBeamColumn $tag $i $j $A $E $Iz <$G $Avy> $transf (in the plane) or \
            $A $E $G $J $Iy $Iz <$Avy $Avz> $transf (in space) <-mass $m> <-cMass> <-release $code> \
            <-releasez $code> <-releasey $code>",
    make,
};

const OPTIONS: &[&str] = &["-mass", "-cMass", "-lMass", "-release", "-releasez", "-releasey"];

struct Options {
    rho: f64,
    consistent: bool,
    release: (Release, Release),
}

fn release(a: &mut Args<'_>) -> Result<Release, Exception> {
    Ok(match a.int("code of the release")? {
        0 => Release::None,
        1 => Release::I,
        2 => Release::J,
        3 => Release::Both,
        code => return Err(a.refuse(format!("{code} is no code of a release"), "expected 0 none, 1 i, 2 j, 3 both")),
    })
}

fn options(interp: &mut Tcl, a: &mut Args<'_>) -> Result<Options, Exception> {
    let mut o = Options { rho: 0.0, consistent: false, release: (Release::None, Release::None) };
    while let Some(option) = a.option() {
        match option.as_ref() {
            "-mass" => o.rho = a.not_negative("mass per length")?,
            "-cMass" => o.consistent = true,
            "-lMass" => o.consistent = false,
            "-release" | "-releasez" => o.release.0 = release(a)?,
            "-releasey" => o.release.1 = release(a)?,
            _ => ignore_option(interp, a, OPTIONS)?,
        }
    }
    Ok(o)
}

/// Numbers before the options: OpenSees tells the forms of the command apart by how many there are.
fn numbers_ahead(a: &Args<'_>) -> usize {
    a.ahead().take_while(|v| v.to_f64().is_ok()).count()
}

fn make(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    let span = a.last_span();
    match (ends.ndm, ends.ndf) {
        (2, 3) => plane(interp, a, ends, span),
        (3, 6) => space(interp, a, ends, span),
        _ => Err(ends.wrong(a, "3 degrees of freedom in 2 or 6 in 3 dimensions")),
    }
}

type Place = Option<crate::diagnostic::Span>;

fn no_transform(a: &Args<'_>, transf: Place, nodes: Place, e: TransformError) -> Exception {
    match e {
        TransformError::Axes(crate::element::axes::AxesError::NoLength) => {
            a.refuse_at(nodes, "the beam has no length", "expected a node at another place")
        }
        TransformError::Axes(e) => a.refuse_at(transf, e.message(), "expected a vector that is not along the beam"),
        TransformError::Unsupported(what) => a.refuse_at(transf, format!("{what} is not supported yet"), ""),
    }
}

fn plane(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends, span: Place) -> Result<Arc<dyn Element>, Exception> {
    let shear = numbers_ahead(a) >= 6;
    let area = a.positive("cross-sectional area A")?;
    let e = a.positive("elastic modulus E")?;
    let iz = a.positive("second moment of area Iz")?;
    let gav = if shear { Some(a.positive("shear modulus G")? * a.positive("shear area Avy")?) } else { None };
    let (spec, _) = a.of(&interp.host.definitions.transforms)?;
    let place = a.last_span();
    let o = options(interp, a)?;
    let ends = transform::Ends { place: ends.place, disp: &ends.disp };
    let transform = spec.plane(&ends).map_err(|e| no_transform(a, place, span, e))?;
    let bending = Bending { ei: e * iz, gav, release: o.release.0 };
    Ok(Arc::new(ElasticBeam::plane(transform, e * area, bending, o.rho, o.consistent)))
}

fn space(interp: &mut Tcl, a: &mut Args<'_>, ends: &Ends, span: Place) -> Result<Arc<dyn Element>, Exception> {
    let shear = numbers_ahead(a) >= 9;
    let area = a.positive("cross-sectional area A")?;
    let e = a.positive("elastic modulus E")?;
    let g = a.positive("shear modulus G")?;
    let j = a.positive("torsion constant J")?;
    let iy = a.positive("second moment of area Iy")?;
    let iz = a.positive("second moment of area Iz")?;
    let (gavy, gavz) = if shear {
        (Some(g * a.positive("shear area Avy")?), Some(g * a.positive("shear area Avz")?))
    } else {
        (None, None)
    };
    let (spec, _) = a.of(&interp.host.definitions.transforms)?;
    let place = a.last_span();
    let o = options(interp, a)?;
    let ends = transform::Ends { place: ends.place, disp: &ends.disp };
    let transform = spec.space(&ends).map_err(|e| no_transform(a, place, span, e))?;
    let z = Bending { ei: e * iz, gav: gavy, release: o.release.0 };
    let y = Bending { ei: e * iy, gav: gavz, release: o.release.1 };
    let consistent = o.consistent.then_some(j / area);
    Ok(Arc::new(ElasticBeam::space(transform, (e * area, g * j), (z, y), o.rho, consistent)))
}
