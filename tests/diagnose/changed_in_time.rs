//! A parameter of the user's that has another value for a part of a run.

use super::studies::{self, Channel, CheckpointRecorder, Concealed, Noise, PAD, Record};
use hysteron::diagnose::Settings;
use std::fs;

const DT: f64 = 0.02;

/// The pad of a study whose strength is 16.5 in place of 11 from 3.1 to 5.3 s of the run that is fitted.
fn tightened() -> Concealed {
    let mut noise = Noise::default();
    let mut run = |name, holdout: bool, motion: fn(f64) -> f64| {
        let path: Vec<f64> = (0..400).map(|i| motion(DT * f64::from(i))).collect();
        let mut plastic = 0.0;
        let force = |(i, u): (usize, &f64)| {
            let strength = if !holdout && (3.1..5.3).contains(&(DT * i as f64)) { 16.5 } else { 11.0 };
            let q = (2000.0 * (u - plastic)).clamp(-strength, strength);
            plastic = u - q / 2000.0;
            q + 260.0 * u + 0.3 * noise.next()
        };
        let force = path.iter().enumerate().map(force).collect();
        let columns = vec![("force[kN]".to_owned(), force)];
        Record { name, holdout, set: String::new(), motions: vec![("motion", path)], columns }
    };
    let runs = vec![
        run("growing", false, |t| 0.006 * t * (4.0 * t).sin()),
        run("mixed", true, |t| 0.03 * (2.5 * t).sin() + 0.02 * (7.0 * t).sin()),
    ];
    let channels = vec![Channel { name: "force", output: "force.out", column: 2 }];
    Concealed { model: PAD.into(), parameters: vec![("Fy", 4.0, 25.0), ("k", 100.0, 600.0)], channels, dt: DT, runs }
}

/// The parameter, its values and the times are in the answer, and the repaired script has them.
#[test]
fn the_time_of_a_change_is_part_of_the_answer() {
    let dir = tightened().write("changed-in-time");
    let settings = Settings { threads: 2, ..Settings::default() };
    let d = studies::attempt(&dir, &settings, &mut CheckpointRecorder::unlimited()).unwrap();
    let _ = fs::remove_dir_all(dir);
    let o = &d.outcome;
    assert_eq!(o.verdict.cause, "changed_condition", "{:?}", o.verdict);
    let parameters = &o.corrected.parameters;
    let near = |name: &str, expected: f64, within: f64| (parameters[name] - expected).abs() < within;
    assert!(near("hy_factor_on_Fy", 1.5, 0.05), "{parameters:?}");
    assert!(near("hy_from", 3.1, 0.1) && near("hy_to", 5.3, 0.1), "{parameters:?}");
    let span = o.verdict.summary.places[0].span.as_ref().unwrap();
    assert_eq!((span.run.as_str(), span.from), ("growing", Some(parameters["hy_from"])));
    let what = &o.verdict.summary.what;
    assert!(what.contains("Fy is 16") && what.contains(" s in the run growing, and 1"), "{what}");
    assert!(
        o.verdict.summary.what_next.iter().any(|n| n.contains("find out whether Fy of it is")),
        "{:?}",
        o.verdict.summary
    );
    let told = "if {$::motion eq {growing-motion.dat}} {amend parameter Fy -factor $::hy_factor_on_Fy -from $::hy_from -to $::hy_to}";
    assert!(d.repaired_script.contains(told), "{}", d.repaired_script);
    // The fit of the run is that of the noise, which is a hundredth of the force.
    assert!(o.corrected.fit_nmse < 0.2 * o.baseline.fit_nmse, "{} {}", o.baseline.fit_nmse, o.corrected.fit_nmse);
    let reason = o.corrected.opensees_reason.as_deref().unwrap();
    assert!(d.opensees_script.is_none() && reason.starts_with("OpenSees changes few numbers of its laws"), "{reason}");
}
