//! `pattern MultipleSupport` and its motions.

use crate::args::Args;
use crate::load::series::series_of;
use crate::model::nodes::{DOF, NODE, node_of};
use crate::slips;
use crate::text::{Arg, Domain};
use crate::things;
use crate::{Command, Outcome, Tcl, finish, ignore_unknown};
use hysteron_engine::model::{Ground, GroundMotion, Pattern, PatternKind, SupportMotion, Tag};
use hysteron_tcl::diagnostic::Span;
use hysteron_tcl::{Call, Exception, Value};
use std::collections::BTreeMap;

const FACTOR: Arg = Arg::of("-fact", "factor", "factor").within(Domain::Number);

const DT_INT: Arg = Arg::of("-dtInt", "dt", "step of the integration").within(Domain::Positive);

const TAG: Arg = Arg::whole("tag", "tag of the ground motion");
const IMPOSED_MOTION_GROUND_MOTION: Arg = Arg::whole("groundMotion", "tag of a ground motion");

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("groundMotion", GROUND, ground_motion)
        .about("Makes a motion of supports, in a pattern `MultipleSupport`.")
        .arguments(&[
            TAG,
            Arg::of("-accel", "series", "tag of a series of accelerations"),
            Arg::of("-vel", "series", "tag of a series of velocities"),
            Arg::of("-disp", "series", "tag of a series of displacements"),
            Arg::flag("-int", "rule of integration of a series that is not given"),
            DT_INT,
            FACTOR,
            Arg::new("motion", "tags of ground motions"),
        ])
        .defining(&[things::GROUND_MOTION], 1),
    Command::new("imposedMotion", IMPOSED, imposed_motion).about("Moves a support by a ground motion.").arguments(&[
        NODE,
        DOF,
        IMPOSED_MOTION_GROUND_MOTION,
        Arg::flag("-other", "the support follows the displacements without their rates"),
    ]),
    Command::new("imposedSupportMotion", IMPOSED, imposed_motion).about("Moves a support by a ground motion."),
];

const GROUND: &str = "groundMotion $tag Plain <-accel $series> <-vel $series> <-disp $series> <-int Trapezoidal> \
                      <-dtInt $dt> <-fact $factor> | groundMotion $tag Interpolated $motion ... -fact $factor ...";
const IMPOSED: &str = "imposedMotion $node $dof $groundMotion <-other>";

/// `pattern MultipleSupport`, after the tag.
pub(crate) fn multiple_support(interp: &mut Tcl, tag: Tag, mut a: Args<'_>) -> Outcome {
    let pattern = Pattern::new(PatternKind::MultipleSupport(BTreeMap::new()));
    interp.host.engine.change_model(|m| m.patterns.insert(tag, pattern));
    let before = interp.host.builder.pattern.replace(tag);
    if a.left() > 0 {
        let body = a.value("motions")?;
        finish(interp, &a)?;
        a.refuse_body(interp, "groundMotion")?;
        let done = interp.eval_value(&body);
        interp.host.builder.pattern = before;
        done?;
    }
    Ok(Value::EMPTY)
}

/// The motions of the pattern that is being read.
fn motions<'a>(interp: &'a Tcl, a: &Args<'_>) -> Result<(Tag, &'a BTreeMap<Tag, GroundMotion>), Exception> {
    let model = interp.host.engine.model();
    let current = interp.host.builder.pattern.and_then(|tag| Some((tag, &model.patterns.get(&tag)?.kind)));
    match current {
        Some((tag, PatternKind::MultipleSupport(motions))) => Ok((tag, motions)),
        _ => Err(a.refuse_at(
            None,
            "there is no pattern MultipleSupport to put this in",
            "expected inside a pattern MultipleSupport",
        )),
    }
}

fn motion_of(interp: &Tcl, a: &mut Args<'_>) -> Result<GroundMotion, Exception> {
    let tag = a.tag(things::GROUND_MOTION, IMPOSED_MOTION_GROUND_MOTION.meaning)?;
    let (_, all) = motions(interp, a)?;
    all.get(&tag).cloned().ok_or_else(|| {
        let known: Vec<String> = all.keys().map(ToString::to_string).collect();
        a.absent(things::GROUND_MOTION, tag, format!("defined: {}", known.join(" ")))
    })
}

fn ground_motion(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, GROUND);
    let tag = a.int(TAG.meaning)?;
    let (pattern, all) = motions(interp, &a)?;
    if all.contains_key(&tag) {
        return Err(a.exists(things::GROUND_MOTION, tag));
    }
    let motion = match a.word("kind of ground motion")?.as_ref() {
        "Plain" | "Series" => plain(interp, &mut a)?,
        "Interpolated" => interpolated(interp, &mut a)?,
        _ => return Err(a.unknown_name("ground motion", ["Plain", "Interpolated"])),
    };
    interp.host.engine.change_model(|m| {
        if let Some(PatternKind::MultipleSupport(all)) = m.patterns.get_mut(&pattern).map(|p| &mut p.kind) {
            all.insert(tag, motion);
        }
    });
    Ok(Value::EMPTY)
}

fn plain(interp: &mut Tcl, a: &mut Args<'_>) -> Result<GroundMotion, Exception> {
    let kind = a.last_span();
    let (mut series, mut dt, mut factor) = ([None, None, None], 0.01, 1.0);
    while let Some(option) = a.option() {
        let mut given = |i: usize, interp: &mut Tcl, a: &mut Args<'_>| -> Result<(), Exception> {
            series[i] = Some(series_of(interp, a)?);
            Ok(())
        };
        match option.as_ref() {
            "-disp" | "-displacement" => given(0, interp, a)?,
            "-vel" | "-velocity" => given(1, interp, a)?,
            "-accel" | "-acceleration" => given(2, interp, a)?,
            "-int" | "-integrator" => match a.word("kind of integration")?.as_ref() {
                "Trapezoidal" | "Simpson" => {}
                _ => return Err(a.unknown_name("integration of a series", ["Trapezoidal", "Simpson"])),
            },
            "-dtInt" | "-dtIntegrator" | "-deltaT" => dt = a.number(&DT_INT)?,
            "-fact" | "-factor" => factor = a.number(&FACTOR)?,
            _ => ignore_unknown(interp, a)?,
        }
    }
    // OpenSees integrates missing histories, but differentiates none: supports given displacements have no velocity.
    let motion = if interp.host.follows(&[slips::GROUND_MOTION_RATES, slips::GROUND_MOTION_INTEGRAL]) {
        GroundMotion::as_opensees(series, dt, factor)
    } else {
        GroundMotion::from_series(series, dt, factor)
    };
    no_series(motion, a, kind)
}

fn no_series(motion: Option<GroundMotion>, a: &Args<'_>, span: Option<Span>) -> Result<GroundMotion, Exception> {
    motion.ok_or_else(|| a.refuse_at(span, "the ground motion has no series", "expected -accel, -vel or -disp"))
}

fn interpolated(interp: &mut Tcl, a: &mut Args<'_>) -> Result<GroundMotion, Exception> {
    let mut parts = vec![];
    while a.at_number() {
        parts.push(motion_of(interp, a)?);
    }
    if !(a.flag("-fact") || a.flag("-factor")) {
        return Err(a.refuse_at(a.next_span(), "the factors of the motions are missing", "expected -fact"));
    }
    let factors = a.floats("factor")?;
    if factors.len() != parts.len() || parts.is_empty() {
        let message = format!("{} motions but {} factors", parts.len(), factors.len());
        return Err(a.refuse(message, "expected a factor for each motion"));
    }
    finish(interp, a)?;
    Ok(GroundMotion::Interpolated(factors.into_iter().zip(parts).collect()))
}

fn imposed_motion(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, IMPOSED);
    let node = node_of(interp, &mut a, NODE.meaning)?;
    let ndf = interp.host.engine.model().nodes[node.0].ndf;
    let dof = a.dof(DOF.meaning, ndf)?;
    let motion = motion_of(interp, &mut a)?;
    let rates = !a.flag("-other");
    finish(interp, &a)?;
    let (pattern, _) = motions(interp, &a)?;
    let tag = interp.host.sp_tag();
    let ground = Some(Ground { motion, rates });
    interp.host.engine.change_model(|m| {
        if let Some(p) = m.patterns.get_mut(&pattern) {
            p.motions.push(SupportMotion { node, dof, value: 1.0, constant: false, initial: 0.0, tag, ground });
        }
    });
    Ok(Value::EMPTY)
}
