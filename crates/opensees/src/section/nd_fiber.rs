//! `section NDFiber`: fibers with shear stresses.

use super::fiber::ContinuumFiber;
use super::{Kind, Make};
use crate::args::Args;
use crate::material::nd_material::{Family, form};
use crate::{Tcl, ignore_option};
use hysteron_engine::material::{NdMaterial, SharedMultiaxial};
use hysteron_engine::section::{NdFiber, NdFiberSection, SharedSection};
use hysteron_tcl::Exception;
use std::sync::Arc;

pub(super) const ND_FIBER: Kind = Kind {
    names: &["NDFiber"],
    usage: "section NDFiber $tag <-noCentroid> <-alpha $alpha> {fibers}",
    make: Make::Beam(make),
};

const OPTIONS: &[&str] = &["-noCentroid", "-alpha", "-shape"];

fn make(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let span = a.last_span();
    let (mut alpha, mut origin) = (1.0, false);
    while a.left() > 1 {
        match a.option().as_deref().unwrap_or_default() {
            "-noCentroid" => origin = true,
            "-alpha" | "-shape" => alpha = a.not_negative("shape factor alpha")?,
            _ => ignore_option(interp, a, OPTIONS)?,
        }
    }
    let body = a.value("body with the fibers")?;
    let outer = interp.host.builder.continuum_fibers.replace(vec![]);
    let done = interp.eval_value(&body);
    let fibers = std::mem::replace(&mut interp.host.builder.continuum_fibers, outer).unwrap_or_default();
    done?;
    if fibers.iter().map(|f| f.area).sum::<f64>() <= 0.0 {
        return Err(a.refuse_at(span, "the section has no area", "expected patches, layers or fibers in its body"));
    }
    if interp.host.builder.ndm == 3 {
        let fibers = laws(a, fibers, |material| material.beam.as_ref(), "of fibers of beams in space")?;
        return Ok(Arc::new(NdFiberSection::<3>::new(fibers, alpha, origin)));
    }
    let fibers = laws(a, fibers, |material| material.plane_beam.as_ref(), "of fibers of beams in the plane")?;
    Ok(Arc::new(NdFiberSection::<2>::new(fibers, alpha, origin)))
}

/// Fibers with the law of a form of their materials.
fn laws<const N: usize>(
    a: &Args<'_>,
    fibers: Vec<ContinuumFiber>,
    of: impl Fn(&NdMaterial) -> Option<&SharedMultiaxial<N>>,
    name: &str,
) -> Result<Vec<NdFiber<N>>, Exception> {
    let made = |ContinuumFiber { y, z, area, material }: ContinuumFiber| {
        let family: &Family = &material;
        Ok(NdFiber { y, z, area, law: (form(a, family, (of(&family.0), name))?, family.1) })
    };
    fibers.into_iter().map(made).collect()
}
