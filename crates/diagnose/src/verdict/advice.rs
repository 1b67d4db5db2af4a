//! Next steps that can be taken: at a building with its recordings, or with a specimen in a test rig.

use super::place::Place;
use super::quantity::duration;
use super::recorded_quantities::RecordedQuantities;
use crate::fit::step_error::StepError;
use crate::hypothesis;
use crate::hypothesis::declaration::Recordable;
use crate::prior::NEGLIGIBLE_STEP_ERROR;
use hysteron_identify::study::{Role, Run, Study};

/// Quantities that an unknown cause may depend on and no run records, in words; none where the runs have all.
pub(super) fn unrecorded(recorded: &RecordedQuantities<'_>) -> Option<String> {
    let quantities = [
        ("temperature", Recordable::Temperature),
        ("axial force", Recordable::AxialForce),
        ("both horizontal directions", Recordable::BothHorizontal),
    ];
    let nowhere = Place::default();
    let missing = quantities.iter().filter(|(_, what)| !recorded.has(*what, &nowhere)).map(|(name, _)| *name);
    let missing: Vec<&str> = missing.collect();
    (!missing.is_empty()).then(|| format!("record what may matter and is not recorded: {}", missing.join(", ")))
}

/// Measurement that shows a cause, in words; `None` where it is recorded already. `location` are the words for the place.
pub(super) fn measurement(
    cause: &str,
    location: &str,
    place: &Place,
    building: bool,
    recorded: &RecordedQuantities<'_>,
) -> Option<String> {
    let m = hypothesis::of(cause)?.measurement;
    let is_recorded = m.records[usize::from(!building)].is_some_and(|what| recorded.has(what, place));
    let text = match (building, is_recorded) {
        (true, true) => return None,
        (true, false) => m.building,
        (false, true) => m.left_in_rig?,
        (false, false) => m.rig,
    };
    Some(text.replace("{place}", if location.is_empty() { "the device" } else { location }))
}

/// Step of the script that a smaller error needs, in words; none if the error is negligible.
pub(super) fn shorter_step(error: &StepError, study: &Study, steps: Option<usize>) -> Option<String> {
    if error.share <= NEGLIGIBLE_STEP_ERROR {
        return None;
    }
    let parts = error.parts.max(2);
    let run = study.runs.iter().find(|r| r.role == Role::Fit)?;
    Some(match script_step(run, steps) {
        Some(step) => format!(
            "run the script with steps of {} instead of {}: the present ones add an error of their own",
            duration(step / f64::from(parts)),
            duration(step)
        ),
        None => format!("divide the steps of the script by {parts}: the present ones add an error of their own"),
    })
}

/// Tolerance of a number of steps that belong to loads before the motion.
const STEP_TOLERANCE: f64 = 0.05;

/// Time step of a script that makes `steps` steps in a run: its `dt`, or a whole part of it.
fn script_step(run: &Run, steps: Option<usize>) -> Option<f64> {
    let times = &run.recording.times;
    let dt = run.number("dt").filter(|dt| *dt > 0.0)?;
    let mean = (times.last()? - times.first()?) / steps.filter(|n| *n > 0)? as f64;
    let parts = (dt / mean).round().max(1.0);
    ((mean * parts / dt - 1.0).abs() < STEP_TOLERANCE).then_some(dt / parts)
}

#[cfg(test)]
mod tests {
    use super::script_step;
    use crate::hypothesis;
    use crate::inspect::inventory::ModelInventory;
    use crate::test_support::pad_study;
    use crate::verdict::place::{NodePlace, Place};
    use crate::verdict::recorded_quantities::RecordedQuantities;
    use hysteron_identify::study::{Column, Setting, Study};

    /// Advice where the channels are compared with a column of the model, about an effect at node 2.
    fn measurement(cause: &str, location: &str, building: bool, study: &Study, column: &str) -> Option<String> {
        let mut inventory = ModelInventory::default();
        inventory.ndm = 1;
        let columns = vec![vec![column.to_owned()]; study.runs.len()];
        let place = Place { nodes: vec![NodePlace { tag: 2, coordinates: vec![] }], ..Place::default() };
        let recorded = RecordedQuantities { study, inventory: &inventory, columns: &columns };
        super::measurement(cause, location, &place, building, &recorded)
    }

    fn unrecorded(study: &Study) -> String {
        let inventory = ModelInventory::default();
        super::unrecorded(&RecordedQuantities { study, inventory: &inventory, columns: &[] }).unwrap_or_default()
    }

    #[test]
    fn every_cause_has_a_measurement() {
        let text = measurement("gap_impact", "element 4", true, &pad_study(), "").expect("a measurement");
        assert!(text.starts_with("measure the clearance at element 4, "), "{text}");
        // Nobody orders an earthquake.
        for h in hypothesis::ALL {
            let texts = [h.measurement.building, h.measurement.rig];
            assert!(texts.iter().all(|t| !t.is_empty()), "{}", h.cause);
            assert!(!texts[0].contains("drive") && !texts[0].contains("repeat"), "{}", h.cause);
        }
    }

    /// Nobody is told to record what the recordings have.
    #[test]
    fn advice_asks_for_nothing_that_is_recorded() {
        let mut study = pad_study();
        study.runs.iter_mut().for_each(|r| r.recording.columns.retain(|c| !c.name.starts_with("temp")));
        let heating = |s: &_| measurement("self_heating", "element 1", false, s, "").expect("a measurement");
        assert!(heating(&study).contains("thermometer") && unrecorded(&study).contains("temperature"));
        for r in &mut study.runs {
            let values = vec![20.0; r.recording.times.len()];
            r.recording.columns.push(Column { name: "inside".into(), unit: "degC".into(), values });
        }
        assert!(!heating(&study).contains("thermometer") && !unrecorded(&study).contains("temperature"));
        assert!(
            heating(&study).contains("repeat a run") && measurement("self_heating", "", true, &study, "").is_none()
        );
    }

    /// A displacement across the device is asked for where none is recorded there.
    #[test]
    fn a_recorded_displacement_is_not_asked_for() {
        let mut study = pad_study();
        let asks = |study: &Study, column: &str| measurement("friction", "element 1", true, study, column).is_some();
        assert!(asks(&study, "node 2 dof 1"), "a force is no displacement");
        study.runs.iter_mut().for_each(|r| r.observe[0].unit = "mm".into());
        assert!(!asks(&study, "node 2 dof 1") && asks(&study, "node 9 dof 1"));
        // In a rig another run is asked for, whatever is recorded.
        assert!(measurement("friction", "element 1", false, &study, "node 2 dof 1").is_some());
    }

    #[test]
    fn the_step_is_a_whole_part_of_that_of_the_motion() {
        let mut run = pad_study().runs[0].clone();
        run.set = vec![("dt".into(), Setting::Number(0.01))];
        run.recording.times = (0..2201).map(|i| 0.01 * f64::from(i)).collect();
        assert_eq!(script_step(&run, Some(8810)), Some(0.0025));
        assert_eq!(script_step(&run, Some(2200)), Some(0.01));
        assert_eq!(script_step(&run, Some(1400)), None);
    }
}
