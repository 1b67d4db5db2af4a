//! Spectra against an independent integration, and the shipped isolation study.

#![allow(clippy::unwrap_used)]

use hysteron_design::isolate::{Job, load, run_job};
use hysteron_design::motion::{ReadOptions, read};
use hysteron_design::prototype::{BoundFactors, Bounds, Factors, Nominal, PrototypeTest, TestCycle, script_lines};
use hysteron_design::review::{html, periods, review};
use hysteron_design::spectrum::Oscillator;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// El Centro 1940 in the Peknold version. scipy 1.x, `solve_ivp` with DOP853, rtol 1e-10, each step of the record by itself
/// with its straight line, 400 points a period: displacement [m], velocity [m/s], absolute acceleration [m/s²], 5 % damping.
#[test]
fn spectra_are_those_of_scipy() {
    let file = root().join("validation/opensees/flatslider2d_veldep_transient/elCentro.AT2");
    let bytes = std::fs::read(file).unwrap();
    let m = read("elCentro", &bytes, &ReadOptions::default(), &|_| None).unwrap().motions.remove(0);
    for (period, u, v, a) in [
        (0.05, 2.6130536e-04, 1.9969989e-02, 4.1334375),
        (0.2, 8.1504623e-03, 2.4118920e-01, 8.0816984),
        (1.0, 1.1304467e-01, 8.3157913e-01, 4.4940071),
        (3.0, 2.7470015e-01, 8.1932296e-01, 1.2106050),
    ] {
        let p = Oscillator { period, damping: 0.05 }.peaks(m.dt, &m.acceleration);
        for (got, expected) in [(p.displacement, u), (p.velocity, v), (p.acceleration, a)] {
            // scipy has samples; between them the largest value is missed by 3e-5 at most.
            assert!((got / expected - 1.0).abs() < 1e-4, "{period}: {got}, not {expected}");
        }
    }
}

#[test]
fn shipped_study_runs_at_its_bounds() {
    let mut study =
        load(&root().join("tcl-like-inputs/isolation_study/study.toml"), &Arc::default(), &mut Default::default())
            .unwrap();
    assert_eq!((study.motions.len(), study.bearings[0].tags.len()), (2, 9));
    // λ of Q_d: (1 + 0.75 (1.0 - 1)) 1.3 · 1.15, of K_d: (1 + 0.75 · 0.1) 1.05 · 1.15.
    let kind = study.bearings[0].clone();
    assert!((study.factor(&kind, "upper", 0) - 1.3 * 1.15).abs() < 1e-12);
    assert!((study.factor(&kind, "upper", 1) - 1.075 * 1.05 * 1.15).abs() < 1e-12);
    // The strong part of the record is enough here.
    for pair in &mut study.motions {
        pair.components.iter_mut().for_each(|m| m.acceleration.truncate(1200));
    }
    let stop = Arc::new(AtomicBool::new(false));
    let run = |bound: &'static str, eccentricity: usize| {
        let o = run_job(&study, &Job { bound, motion: 0, eccentricity, level: 1.0, draw: None }, &stop);
        assert_eq!(o.failure, "");
        o
    };
    let (lower, upper, off) = (run("lower", 0), run("upper", 0), run("lower", 1));
    // The weight of four floors on nine bearings.
    let weight: f64 = lower.bearings.iter().map(|b| b.gravity).sum();
    assert!((weight / (4.0 * 1177.2) - 1.0).abs() < 1e-6, "{weight}");
    assert!(lower.bearings[0].displacement > upper.bearings[0].displacement);
    // An eccentric mass turns the plan: the corners differ, and one moves more than the center.
    let (corner, center) = (off.bearings[8].displacement, off.bearings[4].displacement);
    assert!((corner / center - 1.0).abs() > 0.01);
    // Shear at the largest displacement is that of the law at most.
    let b = &lower.bearings[0];
    let (q, k) = (26.0 * study.factor(&kind, "lower", 0), 440.0 * study.factor(&kind, "lower", 1));
    assert!(b.shear <= (q + k * b.displacement) * 1.02 && b.shear >= 0.8 * (q + k * b.displacement), "{b:?}");
    assert_eq!(run("lower", 0), lower);
    let outcomes = [lower, upper, off];
    let results = review(&study, &outcomes, periods(&study));
    let page = html(&study, &outcomes, &results);
    assert!(page.contains("check against the standard") && page.contains("Bearing schedule"));
    assert!(results.checks.iter().any(|c| c.citation.clause.contains("17.2.4.4")));
}

#[test]
fn lines_of_bounds_are_complete() {
    let cycle = TestCycle { amplitude: 0.3, q_d: 50.0, k_d: 400.0, k_eff: 566.0, ..TestCycle::default() };
    let tests = [PrototypeTest { name: "t".into(), cycles: vec![cycle] }];
    let nominal = Nominal::of(&tests, None).unwrap();
    let code = hysteron_design::codes::Code::named("asce7-16").unwrap();
    let one = BoundFactors { aging: Factors::ONE, specification: Factors { q_d: 1.2, k_d: 1.1 } };
    let bounds = Bounds::new(&tests, &nominal, one, one, &code);
    let lines = script_lines(&bounds, 10.0, Some(1000.0), None);
    assert!(lines.contains("set Qd 6.00000000e1; set Kd 4.40000000e2; set K1 4.40000000e3"), "{lines}");
    assert!(lines.contains("set mu 0.06000000; set Reff 2.27272727e0"), "{lines}");
}
