//! Next steps that can be taken: at a building with its recordings, or with a specimen in a test rig.

use super::place::Place;
use super::quantity::duration;
use super::recorded_quantities::{Recordable, RecordedQuantities};
use crate::fit::step_error::StepError;
use crate::hypothesis::changed_condition::CAUSE as CHANGED_CONDITION;
use crate::prior::NEGLIGIBLE_STEP_ERROR;
use hysteron_identify::study::{Role, Run, Study};

/// Measurement that shows a cause.
struct Measurement {
    cause: &'static str,
    /// At a building or bridge, whose earthquakes cannot be chosen.
    building: &'static str,
    /// In a test rig, whose motion can.
    rig: &'static str,
    /// Quantities recorded at a building and in a rig; none where it asks for more than a recording.
    records: [Option<Recordable>; 2],
    /// The rest to be done in a rig where every run has that already.
    left_in_rig: Option<&'static str>,
}

const fn of(cause: &'static str, building: &'static str, rig: &'static str) -> Measurement {
    Measurement { cause, building, rig, records: [None; 2], left_in_rig: None }
}

impl Measurement {
    /// The same of a condition that the runs may have already; then `rig` is left to do.
    const fn unless(self, what: Recordable, rig: Option<&'static str>) -> Self {
        Self { records: [Some(what); 2], left_in_rig: rig, ..self }
    }

    /// The same of a quantity that the runs of a building may have already.
    const fn unless_at_building(self, what: Recordable) -> Self {
        Self { records: [Some(what), self.records[1]], ..self }
    }

    /// The same of a quantity that the runs of a rig may have already.
    const fn unless_in_rig(self, what: Recordable) -> Self {
        Self { records: [self.records[0], Some(what)], ..self }
    }
}

/// Measurements of all causes; `{place}` stands for the place of the effect.
const MEASUREMENTS: &[Measurement] = &[
    of(
        "rate_dependence",
        "test a device like {place} in a rig at two speeds: the faster loop must be the larger one",
        "repeat a run at a tenth of its speed: the force must fall",
    ),
    of(
        "self_heating",
        "put a thermometer on {place}: its strength must fall while it warms during strong shaking",
        "put a thermometer on {place}, and repeat a run after it has cooled: the first cycle must be strong again",
    )
    .unless(
        Recordable::Temperature,
        Some("repeat a run after {place} has cooled: the first cycle must be strong again"),
    ),
    of(
        "ambient_temperature",
        "record the temperature at {place} with every earthquake",
        "record the temperature of {place}, and repeat one run at the temperature of the model",
    )
    .unless(Recordable::Temperature, Some("repeat one run at the temperature of the model")),
    of(
        "mullins_softening",
        "compare earthquakes before and after the strongest one: {place} must be softer after it",
        "drive the same cycles twice without a rest: the second time must be softer",
    ),
    of(
        "cyclic_degradation",
        "inspect {place} for damage, and compare a small earthquake before the strong one with one after it",
        "drive small cycles before and after the strong ones: {place} must stay weaker after them",
    ),
    of(
        "strain_stiffening",
        "record the displacement across {place}: its stiffness must rise at the largest ones",
        "drive one cycle to the largest displacement that the rig allows: the stiffness must rise",
    )
    .unless_at_building(Recordable::Deformation),
    of(
        "axial_shear_interaction",
        "compute or measure the axial load of {place}: the lateral stiffness must fall as it grows",
        "repeat a run at another axial load: the lateral stiffness must change",
    )
    .unless(Recordable::AxialForce, Some("repeat a run at another axial load: the lateral stiffness must change")),
    of(
        "varying_axial_load",
        "record the vertical force of {place}, or vertical accelerations on both sides of the structure",
        "record the axial force of {place} during the run",
    )
    .unless(Recordable::AxialForce, None),
    of(
        "cavitation",
        "record the vertical displacement across {place}: it must lift",
        "pull twice to the same extension: the second pull must be weaker",
    )
    .unless_at_building(Recordable::VerticalDeformation),
    of(
        "bidirectional_coupling",
        "record both horizontal displacements across {place}",
        "drive one direction alone: its loops must be larger than in a motion of both",
    )
    .unless_at_building(Recordable::BothHorizontal),
    of(
        "friction",
        "record the displacement across {place} in small earthquakes: it must stick at each reversal",
        "drive a tiny, slow cycle: the loop must be as high as twice the friction force",
    )
    .unless_at_building(Recordable::Deformation),
    of(
        "gap_impact",
        "measure the clearance at {place}, and put an accelerometer beside it: contact shows as short peaks",
        "measure the clearance at {place}, and drive slowly to it: the force must rise there",
    ),
    of(
        "foundation_flexibility",
        "put one accelerometer on the foundation at {place} and one on free ground: they must differ",
        "record the displacement of the support at {place}",
    )
    .unless_at_building(Recordable::Acceleration)
    .unless_in_rig(Recordable::Deformation),
    of(
        "isolation_layer",
        "look for bearings below {place}, and record the displacement across them",
        "look for bearings below {place}, and record the displacement across them",
    )
    .unless_at_building(Recordable::Deformation)
    .unless_in_rig(Recordable::Deformation),
    of(
        "superstructure_yielding",
        "inspect {place} for cracks and a permanent drift, and record the drift there",
        "record the deformation at {place}: it must keep a permanent part",
    )
    .unless_in_rig(Recordable::Deformation),
    of(
        "damping",
        "record small vibrations after a shock or in wind, and compare their decay with that of the model",
        "record a free vibration, and compare its decay with that of the model",
    ),
    of(
        "torsion",
        "put two accelerometers of one direction on opposite edges of the floor of {place}: they must differ",
        "record opposite edges of the floor of {place}: they must differ",
    )
    .unless(Recordable::EdgesOfFloor, None),
    of(
        "pinching",
        "record the displacement across {place}: the loops must be thin near zero",
        "drive small cycles after large ones: their force must be small",
    )
    .unless_at_building(Recordable::Deformation),
    of(
        CHANGED_CONDITION,
        "ask what was adjusted, repaired or replaced between the earthquakes",
        "ask what was adjusted between the runs, and repeat one run under the condition of the others",
    ),
    of(
        "sensor_gain",
        "check the factor of this channel in the settings of the recorder, or put a second instrument beside it",
        "check the factor of this channel in the settings of the recorder, or calibrate it with a known load",
    ),
    of(
        "sensor_lag",
        "check clocks and filters of the recorder, or tap on two instruments at once and compare the times",
        "check clocks and filters of the recorder, or tap on two instruments at once and compare the times",
    ),
    of(
        "sensor_drift",
        "compare the zero of this channel before and after the earthquake",
        "record the zero of this channel before and after a run without motion",
    ),
    of(
        "sensor_clipping",
        "look for flat peaks in the recording, and choose a larger range of the recorder",
        "look for flat peaks in the recording, and repeat the run with a larger range",
    ),
];

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
    let m = MEASUREMENTS.iter().find(|m| m.cause == cause)?;
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
    use super::{MEASUREMENTS, script_step};
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
        let causes: Vec<&str> = hypothesis::ALL.iter().map(|h| h.cause).collect();
        assert_eq!(MEASUREMENTS.iter().map(|m| m.cause).collect::<Vec<_>>(), causes);
        let text = measurement("gap_impact", "element 4", true, &pad_study(), "").expect("a measurement");
        assert!(text.starts_with("measure the clearance at element 4, "), "{text}");
        // Nobody orders an earthquake.
        for m in MEASUREMENTS {
            assert!(!m.building.contains("drive") && !m.building.contains("repeat"), "{}", m.cause);
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
