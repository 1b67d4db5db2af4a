//! `section NDFiber`: fibers with shear stresses.

use super::fiber::ContinuumFiber;
use super::{Kind, Make};
use crate::args::Args;
use crate::material::nd_material::{Family, family, form};
use crate::text::{Arg, Domain, Text};
use crate::{Tcl, ignore_unknown};
use hysteron_engine::material::{NdMaterial, SharedMultiaxial};
use hysteron_engine::section::{NdFiber, NdFiberSection, SharedSection};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;

const ALPHA: Arg = Arg::of("-alpha", "alpha", "shape factor alpha").within(Domain::NotNegative);

pub(super) const ND_FIBER: Kind = Kind {
    names: &["NDFiber"],
    usage: "section NDFiber $tag <-noCentroid> <-alpha $alpha> {fibers}",
    text: Text::new("A section of fibres with shear stresses, of materials of continua.")
        .example("section NDFiber 77 {fiber 0.1 0.1 1. 1; fiber -0.1 0.1 1. 1; fiber 0. -0.1 1. 1}")
        .arguments(&[ALPHA]),
    make: Make::Beam(make),
};

/// The words of the section before its body.
pub(crate) struct NdFiberOptions {
    alpha: f64,
    origin: bool,
    space: bool,
}

impl NdFiberOptions {
    /// Take the options; the last `behind` words are left.
    pub(super) fn take(interp: &mut Tcl, a: &mut Args<'_>, behind: usize) -> Result<Self, Exception> {
        let mut options = Self { alpha: 1.0, origin: false, space: interp.host.builder.ndm == 3 };
        while a.left() > behind {
            match a.option().as_deref().unwrap_or_default() {
                "-noCentroid" => options.origin = true,
                "-alpha" | "-shape" => options.alpha = a.number(&ALPHA)?,
                _ => ignore_unknown(interp, a)?,
            }
        }
        Ok(options)
    }

    /// Section of these fibers, whose materials have the law that it needs.
    pub(super) fn section(&self, fibers: &[ContinuumFiber]) -> SharedSection {
        if self.space {
            let fibers = laws(fibers, |material| material.beam.clone());
            return NdFiberSection::<3>::new(fibers, self.alpha, self.origin).shared();
        }
        let fibers = laws(fibers, |material| material.plane_beam.clone());
        NdFiberSection::<2>::new(fibers, self.alpha, self.origin).shared()
    }
}

/// Fibers with the law of a form of their materials.
fn laws<const N: usize>(
    fibers: &[ContinuumFiber],
    of: impl Fn(&NdMaterial) -> Option<SharedMultiaxial<N>>,
) -> Vec<NdFiber<N>> {
    let made = |f: &ContinuumFiber| {
        let (material, tag) = &f.material;
        Some(NdFiber { y: f.y, z: f.z, area: f.area, law: (of(material)?, *tag) })
    };
    fibers.iter().filter_map(made).collect()
}

/// The material of a fiber that is made.
///
/// # Errors
/// There is none of that tag, or it has no law of fibers of beams.
pub(super) fn material(interp: &Tcl, a: &mut Args<'_>) -> Result<Family, Exception> {
    let found = family(interp, a)?;
    if interp.host.builder.ndm == 3 {
        form(a, &found, (found.0.beam.as_ref(), "of fibers of beams in space"))?;
    } else {
        form(a, &found, (found.0.plane_beam.as_ref(), "of fibers of beams in the plane"))?;
    }
    Ok(found)
}

fn make(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let span = a.last_span();
    let options = NdFiberOptions::take(interp, a, 1)?;
    let body = a.value("body with the fibers")?;
    let outer = interp.host.builder.continuum_fibers.replace(vec![]);
    let done = interp.eval_value(&body);
    let fibers = std::mem::replace(&mut interp.host.builder.continuum_fibers, outer).unwrap_or_default();
    done?;
    if fibers.iter().map(|f| f.area).sum::<f64>() <= 0.0 {
        return Err(a.refuse_at(span, "the section has no area", "expected patches, layers or fibers in its body"));
    }
    Ok(options.section(&fibers))
}
