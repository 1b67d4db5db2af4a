//! Verdicts of small studies whose truth is known: every cause of its library, recordings with nothing
//! missing, and such as no cause explains.
//!
//! The table pins what it says today, right or wrong, so that no verdict changes unseen. Where a change is meant, the test
//! prints the new table to be put in the place of the old one. `cargo test --release --test verdicts -- --ignored` runs the
//! whole table, a sample of it is among the other tests.

#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::print_stderr, unreachable_pub)]

#[path = "verdicts/bearings.rs"]
mod bearings;
#[path = "verdicts/conditions.rs"]
mod conditions;
#[path = "verdicts/imposed.rs"]
mod imposed;
#[path = "verdicts/invariance.rs"]
mod invariance;
#[path = "verdicts/parts.rs"]
mod parts;
#[path = "verdicts/rubber.rs"]
mod rubber;
#[path = "verdicts/shaken.rs"]
mod shaken;
#[path = "verdicts/structures.rs"]
mod structures;
#[path = "support/studies.rs"]
mod studies;
#[path = "verdicts/whole_laws.rs"]
mod whole_laws;

use bearings::Dependences;
use hysteron::diagnose::Settings;
use rubber::Filled;
use std::fmt::Write as _;
use std::fs;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;
use studies::{CheckpointRecorder, Concealed};
use whole_laws::Truth;

/// A study, its truth, the cause that the diagnosis names with a second one beside it, and its confidence, %.
type Row = (&'static str, &'static str, &'static str, u32);

/// A study by its name.
type Named = (&'static str, fn() -> Concealed);

/// Confidences are pinned to this, %.
const GRID: f64 = 5.0;
/// Largest difference of a confidence from the pinned one, %: half of the grid, and what the last bits of another
/// processor may add.
const FAR: f64 = 4.0;

/// Causes that are left out of the library for a study: what is missing there has no name.
const WITHOUT: &[(&str, &[&str])] = &[("pinching unnamed", &["pinching"])];

/// Pinned verdicts.
const TABLE: &[Row] = &[
    ("slow noise", "none", "none", 90),
    ("two storeys", "none", "none", 85),
    ("ridges", "unknown", "unknown", 95),
    ("pinching unnamed", "unknown", "unknown", 80),
    ("maxwell", "rate_dependence", "rate_dependence", 95),
    ("heating", "self_heating", "self_heating", 95),
    ("cold", "ambient_temperature", "ambient_temperature", 90),
    ("mullins", "mullins_softening", "mullins_softening", 95),
    ("degradation", "cyclic_degradation", "cyclic_degradation", 85),
    ("stiffening", "strain_stiffening", "strain_stiffening", 95),
    ("gradual yielding", "rounded_yielding", "rounded_yielding", 95),
    ("axial loads", "axial_shear_interaction", "axial_shear_interaction", 95),
    ("axial varies", "varying_axial_load", "varying_axial_load", 90),
    ("cavitation", "cavitation", "cavitation", 95),
    ("orbit", "bidirectional_coupling", "bidirectional_coupling", 95),
    ("friction", "friction", "friction", 95),
    ("sticking", "friction", "friction", 80),
    ("relaxing at rest", "rate_dependence", "rate_dependence", 90),
    ("rested", "none", "none", 85),
    ("one-sided stop", "gap_impact", "gap_impact", 95),
    ("residual offset", "unknown", "unknown", 90),
    ("uplift", "gap_impact", "gap_impact", 95),
    ("lead core", "self_heating", "self_heating", 85),
    ("cold lead", "none", "none", 85),
    ("warm pendulum", "self_heating", "self_heating", 95),
    ("fast pendulum", "rate_dependence", "rate_dependence", 95),
    ("warm fast pendulum", "rate_dependence + self_heating", "rate_dependence + self_heating", 95),
    ("plain pendulum", "none", "none", 85),
    ("pressed pendulum", "varying_axial_load", "varying_axial_load", 85),
    ("fast pendulum of varying weight", "rate_dependence", "rate_dependence", 95),
    ("pressed fast pendulum", "rate_dependence + varying_axial_load", "rate_dependence + varying_axial_load", 95),
    ("pressed warm fast pendulum", "rate_dependence + varying_axial_load + self_heating", "self_heating", 85),
    ("pendulum of varying weight", "none", "none", 85),
    ("filled rubber", "mullins_softening + cyclic_degradation + strain_stiffening", "mullins_softening", 75),
    (
        "filled rubber that wears not",
        "mullins_softening + strain_stiffening",
        "strain_stiffening + mullins_softening",
        75,
    ),
    (
        "filled rubber that stiffens not",
        "mullins_softening + cyclic_degradation",
        "mullins_softening + cyclic_degradation",
        95,
    ),
    ("plain rubber", "none", "none", 85),
    ("creep", "rate_dependence", "rate_dependence", 95),
    ("held forces", "none", "none", 85),
    ("permanent set", "unknown", "unknown", 90),
    ("held deformations", "none", "none", 85),
    ("crystallising", "changed_condition", "changed_condition", 90),
    ("cold without crystals", "none", "none", 85),
    ("pulled rubber", "none", "none", 85),
    ("pulled rubber that cavitates", "cavitation", "cavitation", 95),
    ("lead of a sharp model", "rounded_yielding", "rounded_yielding", 95),
    ("warm lead of a sharp model", "rounded_yielding + self_heating", "rounded_yielding + self_heating", 95),
    ("lead of a smooth model", "none", "none", 85),
    ("warm lead of a smooth model", "self_heating", "self_heating", 75),
    ("slider", "none", "none", 85),
    ("warm fast slider", "rate_dependence + self_heating", "rate_dependence + self_heating", 90),
    ("incoherent piers", "unknown", "unknown", 40),
    ("rocking ground", "unknown", "unknown", 60),
    ("turning floor", "unknown", "unknown", 90),
    ("wall", "gap_impact", "gap_impact", 95),
    ("wall above", "gap_impact", "gap_impact", 95),
    ("neighbour", "gap_impact", "gap_impact", 95),
    ("near neighbour", "gap_impact", "unknown", 75),
    ("lifting footing", "foundation_flexibility", "foundation_flexibility", 95),
    ("rocking footing", "foundation_flexibility", "sensor_gain", 50),
    ("following soil", "foundation_flexibility", "foundation_flexibility", 85),
    ("soil that stays", "foundation_flexibility", "foundation_flexibility", 95),
    ("late pier", "late_support", "late_support", 95),
    ("passing wave", "late_support", "late_support", 95),
    ("bridge at one time", "none", "none", 85),
    ("yielding footing", "foundation_flexibility", "foundation_flexibility", 50),
    ("louder pier", "unknown", "unknown", 55),
    ("cracking infill", "unknown", "unknown", 40),
    ("added damper", "damping", "damping", 75),
    ("partitions", "damping", "changed_condition", 40),
    ("middle layer", "isolation_layer", "isolation_layer", 95),
    ("soft ground", "foundation_flexibility", "foundation_flexibility", 90),
    ("pendulums", "isolation_layer", "isolation_layer", 95),
    ("heavy soft ground", "foundation_flexibility", "foundation_flexibility", 95),
    ("soft model", "none", "none", 85),
    ("yielding storey", "superstructure_yielding", "superstructure_yielding", 95),
    ("stored goods", "changed_mass", "changed_mass", 95),
    ("undamped model", "damping", "damping", 95),
    ("drag", "damping", "damping", 95),
    ("eccentric", "torsion", "torsion", 50),
    ("pinching", "pinching", "pinching", 95),
    ("tightened", "changed_condition", "changed_condition", 95),
    ("tightened for a time", "changed_condition", "changed_condition", 95),
    ("tightened on the way", "changed_condition", "changed_condition", 95),
    ("tightened slowly", "changed_condition", "changed_condition", 95),
    ("recovered", "changed_condition", "changed_condition", 85),
    ("loosened", "changed_condition", "changed_condition", 90),
    ("loosened by nothing", "unknown", "unknown", 65),
    ("repeated", "changed_condition", "changed_condition", 80),
    ("repeated by nothing", "unknown", "unknown", 60),
    ("tightened in steady motion", "changed_condition", "changed_condition", 70),
    ("steady motion", "unknown", "unknown", 55),
    ("aging", "changed_condition", "changed_condition", 75),
    ("loud for a time", "none", "none", 90),
    ("gain", "sensor_gain", "sensor_gain", 85),
    ("late", "sensor_lag", "sensor_lag", 85),
    ("jump", "sensor_drift", "sensor_drift", 85),
    ("clipped", "sensor_clipping", "sensor_clipping", 90),
    ("late stop", "gap_impact + sensor_lag", "gap_impact + sensor_lag", 85),
];

/// Friction that is constant, under a weight that is, and one that is not.
const CONSTANT: Dependences = Dependences { heat: false, speed: false, pressure: false, weight_varies: false };
const VARYING: Dependences = Dependences { weight_varies: true, ..CONSTANT };

/// Rubber with all of its phenomena.
const FILLED: Filled = Filled { softens: true, wears: true, stiffens: true };

/// Functions that make the studies.
const STUDIES: &[Named] = &[
    ("slow noise", imposed::slow_noise),
    ("two storeys", shaken::two_storeys),
    ("ridges", imposed::ridges),
    ("pinching unnamed", || imposed::pinching(0.7)),
    ("maxwell", || imposed::maxwell(500.0)),
    ("heating", || imposed::heating(true)),
    ("cold", imposed::cold),
    ("mullins", imposed::mullins),
    ("degradation", || imposed::degradation(0.09)),
    ("stiffening", imposed::stiffening),
    ("gradual yielding", imposed::gradual),
    ("axial loads", imposed::axial_loads),
    ("axial varies", imposed::axial_varies),
    ("cavitation", imposed::cavitation),
    ("orbit", imposed::orbit),
    ("friction", || imposed::friction(3.0)),
    ("sticking", || bearings::sticking(3.0)),
    ("relaxing at rest", bearings::relaxing_at_rest),
    ("rested", bearings::rested),
    ("one-sided stop", bearings::one_sided_stop),
    ("residual offset", || bearings::residual_offset(0.01)),
    ("uplift", bearings::uplift),
    ("lead core", || bearings::lead_core(true)),
    ("cold lead", || bearings::lead_core(false)),
    ("warm pendulum", || bearings::pendulum(Dependences { heat: true, ..CONSTANT })),
    ("fast pendulum", || bearings::pendulum(Dependences { speed: true, ..CONSTANT })),
    ("warm fast pendulum", || bearings::pendulum(Dependences { heat: true, speed: true, ..CONSTANT })),
    ("plain pendulum", || bearings::pendulum(CONSTANT)),
    ("pressed pendulum", || bearings::pendulum(Dependences { pressure: true, ..VARYING })),
    ("fast pendulum of varying weight", || bearings::pendulum(Dependences { speed: true, ..VARYING })),
    ("pressed fast pendulum", || bearings::pendulum(Dependences { pressure: true, speed: true, ..VARYING })),
    ("pressed warm fast pendulum", || {
        bearings::pendulum(Dependences { pressure: true, speed: true, heat: true, ..VARYING })
    }),
    ("pendulum of varying weight", || bearings::pendulum(VARYING)),
    ("filled rubber", || rubber::filled(FILLED)),
    ("filled rubber that wears not", || rubber::filled(Filled { wears: false, ..FILLED })),
    ("filled rubber that stiffens not", || rubber::filled(Filled { stiffens: false, ..FILLED })),
    ("plain rubber", || rubber::filled(Filled::default())),
    ("creep", || rubber::creep(0.25)),
    ("held forces", || rubber::creep(0.0)),
    ("permanent set", || rubber::permanent_set(0.3)),
    ("held deformations", || rubber::permanent_set(0.0)),
    ("crystallising", || rubber::crystallising(0.5)),
    ("cold without crystals", || rubber::crystallising(0.0)),
    ("pulled rubber", || rubber::pulled(false)),
    ("pulled rubber that cavitates", || rubber::pulled(true)),
    ("lead of a sharp model", || whole_laws::sharp_lead(Truth::Lead)),
    ("warm lead of a sharp model", || whole_laws::sharp_lead(Truth::WarmLead)),
    ("lead of a smooth model", || whole_laws::smooth_lead(Truth::Lead)),
    ("warm lead of a smooth model", || whole_laws::smooth_lead(Truth::WarmLead)),
    ("slider", || whole_laws::slider(Truth::Slider)),
    ("warm fast slider", || whole_laws::slider(Truth::WarmFastSlider)),
    ("incoherent piers", || structures::incoherent_piers(0.5)),
    ("rocking ground", || structures::rocking_ground(0.4)),
    ("turning floor", structures::turning_floor),
    ("wall", || shaken::wall(1500.0)),
    ("wall above", shaken::wall_above),
    ("neighbour", || structures::neighbour(0.07)),
    ("near neighbour", || structures::neighbour(0.03)),
    ("lifting footing", structures::lifting_footing),
    ("rocking footing", structures::rocking_footing),
    ("following soil", || structures::following_soil(true)),
    ("soil that stays", || structures::following_soil(false)),
    ("late pier", structures::late_pier),
    ("passing wave", structures::passing_wave),
    ("bridge at one time", structures::bridge_at_one_time),
    ("yielding footing", structures::yielding_footing),
    ("louder pier", structures::louder_pier),
    ("cracking infill", parts::cracking_infill),
    ("added damper", parts::added_damper),
    ("partitions", parts::partitions),
    ("middle layer", parts::middle_layer),
    ("soft ground", shaken::soft_ground),
    ("pendulums", shaken::pendulums),
    ("heavy soft ground", shaken::heavy_soft_ground),
    ("soft model", shaken::soft_model),
    ("yielding storey", shaken::yielding_storey),
    ("stored goods", shaken::stored_goods),
    ("undamped model", shaken::undamped_model),
    ("drag", shaken::drag),
    ("eccentric", shaken::eccentric),
    ("pinching", || imposed::pinching(0.7)),
    ("tightened", imposed::condition),
    ("tightened for a time", || imposed::condition_in_time(5.3)),
    ("tightened on the way", || imposed::condition_in_time(f64::INFINITY)),
    ("tightened slowly", imposed::tightened_slowly),
    ("recovered", conditions::recovered),
    ("loosened", || conditions::loosened(0.15)),
    ("loosened by nothing", || conditions::loosened(1.0)),
    ("repeated", || conditions::repeated(1.25)),
    ("repeated by nothing", || conditions::repeated(1.0)),
    ("tightened in steady motion", || conditions::tightened_in_steady_motion(1.35)),
    ("steady motion", || conditions::tightened_in_steady_motion(1.0)),
    ("aging", imposed::aging),
    ("loud for a time", imposed::loud_for_a_time),
    ("gain", imposed::gain),
    ("late", shaken::late),
    ("jump", imposed::jump),
    ("clipped", shaken::clipped),
    ("late stop", imposed::late_stop),
];

/// Cause with a second one beside it, and confidence, %.
fn verdict(name: &str, study: &Concealed) -> (String, f64) {
    let without = WITHOUT.iter().filter(|(of, _)| *of == name).flat_map(|(_, causes)| *causes);
    let settings =
        Settings { excluded_causes: without.map(|c| (*c).to_owned()).collect(), threads: 1, ..Settings::default() };
    let dir = study.write(&format!("verdict-{}", name.replace([' ', ','], "-")));
    let found = studies::attempt(&dir, &settings, &mut CheckpointRecorder::unlimited());
    let _ = fs::remove_dir_all(dir);
    let verdict = found.unwrap_or_else(|e| panic!("{name}: {e}")).outcome.verdict;
    let causes = std::iter::once(&verdict.cause).chain(&verdict.also);
    (causes.map(String::as_str).collect::<Vec<_>>().join(" + "), 100.0 * verdict.confidence)
}

/// The verdicts on studies in their order, several at once.
fn verdicts(studies: &[&Named]) -> Vec<(String, f64)> {
    let (next, found) = (AtomicUsize::new(0), Mutex::new(vec![Default::default(); studies.len()]));
    let work = || {
        loop {
            let i = next.fetch_add(1, Ordering::Relaxed);
            let Some((name, study)) = studies.get(i) else { return };
            let start = Instant::now();
            let said = verdict(name, &study());
            eprintln!("{name}: {} at {:.1} % after {:.1} s", said.0, said.1, start.elapsed().as_secs_f64());
            found.lock().unwrap()[i] = said;
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| (0..threads).for_each(|_| drop(scope.spawn(work))));
    found.into_inner().unwrap()
}

/// Studies of the daily tests: nothing missing, nothing of the library, and one of each kind of cause.
const SAMPLE: &[&str] = &["slow noise", "ridges", "maxwell", "orbit", "pinching", "soft ground", "tightened", "jump"];

/// Compares the verdicts on some studies with the table.
fn are_as_they_were(wants: impl Fn(&str) -> bool) {
    let studies: Vec<_> = STUDIES.iter().filter(|(name, _)| wants(name)).collect();
    let (mut table, mut differ) = (String::new(), vec![]);
    for ((name, _), (now, confidence)) in studies.iter().zip(verdicts(&studies)) {
        let (_, truth, was, pinned) = TABLE.iter().find(|row| row.0 == *name).unwrap();
        let same = now == *was && (confidence - f64::from(*pinned)).abs() <= FAR;
        let percent = if same { *pinned } else { (GRID * (confidence / GRID).round()) as u32 };
        writeln!(table, "    ({name:?}, {truth:?}, {now:?}, {percent}),").unwrap();
        if !same {
            differ.push(format!("{name}: {now} at {confidence:.1} %, was {was} at {pinned} %"));
        }
    }
    assert!(differ.is_empty(), "other verdicts than before:\n{}\n\nthe table now:\n{table}", differ.join("\n"));
}

#[test]
fn verdicts_of_a_sample_are_as_they_were() {
    are_as_they_were(|name| SAMPLE.contains(&name));
}

/// The whole table; `VERDICTS=name,name` in the environment takes some studies alone.
#[test]
#[ignore = "takes minutes"]
fn verdicts_are_as_they_were() {
    let wanted = std::env::var("VERDICTS").ok();
    are_as_they_were(|name| wanted.as_ref().is_none_or(|w| w.split(',').any(|w| w == name)));
}

/// Every cause of the library is the truth of a study.
#[test]
fn every_cause_has_a_study() {
    for h in hysteron::diagnose::hypothesis::ALL {
        let concealed = |row: &&Row| row.1.split(" + ").any(|truth| truth == h.cause);
        assert!(TABLE.iter().any(|row| concealed(&row)), "{}", h.cause);
    }
    let names = |row: &Named| TABLE.iter().filter(|r| r.0 == row.0).count();
    assert!(STUDIES.len() == TABLE.len() && STUDIES.iter().all(|row| names(row) == 1));
    assert!(SAMPLE.iter().all(|name| STUDIES.iter().any(|row| row.0 == *name)));
}
