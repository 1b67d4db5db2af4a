//! `nDMaterial` around others, and for fibres of beams.

use super::nd_material::{ELASTIC_ISOTROPIC_E, J2_BEAM_FIBER_RHO, NU, PARALLEL_WEIGHT, family, form, of_solid};
use crate::Tcl;
use crate::args::Args;
use crate::text::{Arg, Domain};
use hysteron_engine::material::{
    BEAM_FIBRE, BeamJ2, Condensed, InitialStrain, Multiaxial, NdMaterial, PLANE_BEAM_FIBRE, SOLID, SeriesSolids,
    SeriesTolerance, WeightedLaws, strain_of_stress,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

pub(super) const INITIAL_STRESS: Arg = Arg::number("sigma", "initial stress");
pub(super) const SIGMA_Y: Arg = Arg::positive("sigmaY", "yield stress sigmaY");
pub(super) const H_ISO: Arg = Arg::not_negative("Hiso", "modulus of isotropic hardening Hiso");
pub(super) const H_KIN: Arg = Arg::not_negative("Hkin", "modulus of kinematic hardening Hkin");
/// With the initial tangents there are ten times as many.
pub(super) const SERIES_ITERATIONS: Arg =
    Arg::of("-maxIter", "n", "largest number of iterations").within(Domain::Count);
pub(super) const SERIES_RELATIVE: Arg =
    Arg::of("-relTol", "tol", "relative tolerance of the stresses").within(Domain::Positive);
pub(super) const SERIES_ABSOLUTE: Arg = Arg::of("-absTol", "tol", "tolerance of the stresses").within(Domain::Positive);

/// `InitStress`: the strain at rest is that of a pressure in all directions.
pub(super) fn initial_stress(interp: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let law = of_solid(interp, a, Arc::clone)?;
    let sigma = a.number(&INITIAL_STRESS)?;
    let span = a.last_span();
    a.optional_int("number of dimensions, which is not used")?;
    let mut stress = [0.0; SOLID];
    stress[..3].fill(sigma);
    let strain = strain_of_stress(&law, &stress).map_err(|e| {
        a.refuse_at(span, format!("InitStress: {}", e.0), "expected a stress that the material can have")
    })?;
    Ok(NdMaterial::of_solid("InitStressNDMaterial", InitialStrain { law, strain }.shared()))
}

/// `Series3D`.
pub(super) fn series(interp: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let mut laws = vec![(of_solid(interp, a, Arc::clone)?, 1.0)];
    while a.at_number() {
        laws.push((of_solid(interp, a, Arc::clone)?, 1.0));
    }
    let mut tolerance = SeriesTolerance { iterations: 10, relative: 1e-4, absolute: 1e-8 };
    while let Some(word) = a.option() {
        match word.as_ref() {
            "-weights" => {
                for (i, (_, weight)) in laws.iter_mut().enumerate() {
                    *weight = a.nth_number(&PARALLEL_WEIGHT, i + 1)?;
                }
            }
            "-maxIter" => tolerance.iterations = a.count(&SERIES_ITERATIONS)?,
            "-relTol" => tolerance.relative = a.number(&SERIES_RELATIVE)?,
            "-absTol" => tolerance.absolute = a.number(&SERIES_ABSOLUTE)?,
            "-verbose" => {}
            _ => crate::ignore_unknown(interp, a)?,
        }
    }
    Ok(NdMaterial::of_solid("Series3DMaterial", SeriesSolids { laws: WeightedLaws(laws), tolerance }.shared()))
}

/// `BeamFiber`.
pub(super) fn beam_fiber(interp: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let law = of_solid(interp, a, Condensed::beam)?;
    Ok(NdMaterial::of_beams("BeamFiberMaterial", Some(law), None))
}

/// `BeamFiber2d`.
pub(super) fn plane_beam_fiber(interp: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let law = of_solid(interp, a, Condensed::plane_beam)?;
    Ok(NdMaterial::of_beams("BeamFiberMaterial2d", None, Some(law)))
}

/// `BeamFiber2dPS`.
pub(super) fn beam_fiber_of_plane_stress(interp: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let family = family(interp, a)?;
    let plane = form(a, &family, (family.0.plane_stress.as_ref(), "in plane stress"))?;
    Ok(NdMaterial::of_beams("BeamFiberMaterial2dPS", None, Some(Condensed::beam_of_plane(&plane))))
}

/// `J2BeamFiber`.
pub(super) fn j2_beam_fiber(_: &mut Tcl, a: &mut Args<'_>) -> Result<NdMaterial, Exception> {
    let e = a.number(&ELASTIC_ISOTROPIC_E)?;
    let nu = a.number(&NU)?;
    if nu <= -1.0 {
        return Err(a.refuse(format!("Poisson's ratio is {nu}"), "expected more than -1"));
    }
    let law = BeamJ2 {
        e,
        shear: 0.5 * e / (1.0 + nu),
        yield_stress: a.number(&SIGMA_Y)?,
        isotropic: a.number(&H_ISO)?,
        kinematic: a.number(&H_KIN)?,
        rho: a.optional_number(&J2_BEAM_FIBER_RHO)?.unwrap_or(0.0),
    };
    Ok(NdMaterial::of_beams(
        "J2BeamFiber",
        Some(Shared::<dyn Multiaxial<BEAM_FIBRE>>::shared(law)),
        Some(Shared::<dyn Multiaxial<PLANE_BEAM_FIBRE>>::shared(law)),
    ))
}
