//! A material by itself: `testUniaxialMaterial`, `setStrain`, `getStress` and the like.

use crate::args::Args;
use crate::text::Arg;
use crate::{Outcome, Tcl, finish};
use hysteron_engine::material::{Slot, Strain, Stress};
use hysteron_engine::model::Tag;
use hysteron_tcl::{Call, Value};
use std::collections::BTreeMap;

pub(super) const STRAIN: Arg = Arg::number("strain", "strain");
pub(super) const RATE: Arg = Arg::number("rate", "strain rate");

pub(super) const SET_STRAIN: &str = "setStrain $strain <$rate>";

/// Materials that are tested by themselves. Each keeps its state while others are tested.
#[derive(Debug, Default)]
pub(crate) struct MaterialTests {
    current: Option<Tag>,
    points: BTreeMap<Tag, Point>,
}

#[derive(Debug)]
struct Point {
    slot: Slot,
    state: Vec<f64>,
    stress: Stress,
}

pub(super) fn test(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, "testUniaxialMaterial $tag");
    let (material, tag) = a.of(&interp.host.builder.definitions.materials)?;
    finish(interp, &a)?;
    let tests = &mut interp.host.builder.material_tests;
    tests.current = Some(tag);
    tests.points.entry(tag).or_insert_with(|| {
        let slot = Slot::new(material, tag, 0);
        let mut state = vec![0.0; slot.len()];
        slot.init(&mut state);
        let stress = Stress { value: slot.stress(&state), tangent: slot.tangent(&state), damping: 0.0 };
        Point { slot, state, stress }
    });
    Ok(Value::EMPTY)
}

const NONE: &str = "no material is being tested";
const FIRST: &str = "expected testUniaxialMaterial before";

pub(super) fn set_strain(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, SET_STRAIN);
    let value = a.number(&STRAIN)?;
    let span = a.last_span();
    let rate = a.optional_number(&RATE)?.unwrap_or(0.0);
    finish(interp, &a)?;
    let tests = &mut interp.host.builder.material_tests;
    let Some(point) = tests.current.and_then(|tag| tests.points.get_mut(&tag)) else {
        return Err(a.refuse_at(span, NONE, FIRST));
    };
    let mut next = point.state.clone();
    // No time passes in a test.
    let strain = Strain { value, rate, dt: 0.0 };
    point.stress = point
        .slot
        .update(&point.state, strain, &mut next)
        .map_err(|e| a.refuse_at(span, e.to_string(), "expected a strain that the material can have"))?;
    point.state = next;
    Ok(Value::EMPTY)
}

/// `getStrain`, `getStress`, `getTangent`, `getDampTangent`.
pub(super) fn get(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let a = Args::new(call, "getStrain | getStress | getTangent | getDampTangent");
    finish(interp, &a)?;
    let tests = &interp.host.builder.material_tests;
    let Some(point) = tests.current.and_then(|tag| tests.points.get(&tag)) else {
        return Err(a.refuse(NONE, FIRST));
    };
    let value = match call.name().rsplit("::").next() {
        Some("getStrain") => point.slot.strain(&point.state),
        Some("getStress") => point.stress.value,
        Some("getTangent") => point.stress.tangent,
        _ => point.stress.damping,
    };
    Ok(Value::from(value))
}
