//! Rubber that softens, creeps, sets, crystallises or cavitates, by formulas of their own or by OpenSees.

use super::imposed::{DT, FY, K, K0, Plastic, Test, along, pad, test};
use super::studies::{Channel, Concealed, Noise, PAD, Record};
use std::f64::consts::TAU;

/// The error function, within 1.5e-7 (Abramowitz and Stegun 1964, 7.1.26).
fn erf(x: f64) -> f64 {
    let t = 1.0 / (1.0 + 0.327_591_1 * x.abs());
    let series = [0.254_829_592, -0.284_496_736, 1.421_413_741, -1.453_152_027, 1.061_405_429];
    let polynomial = series.iter().rev().fold(0.0, |sum, a| t * (sum + a));
    x.signum() * (1.0 - polynomial * (-x * x).exp())
}

/// Phenomena of filled rubber.
#[derive(Clone, Copy, Default)]
pub struct Filled {
    /// Softening below the largest strain.
    pub softens: bool,
    /// Loss of stiffness by the path that was travelled.
    pub wears: bool,
    /// Stiffening at large strain.
    pub stiffens: bool,
}

/// Rubber whose stress is a polynomial of the strain, times the softening of Ogden and Roxburgh (1999),
/// `1 - erf((Wm - W)/m)/r` with the strain energy `W` and its largest value `Wm`, times a decay over the path.
pub fn filled(on: Filled) -> Concealed {
    let block =
        |amplitude: f64, number: u32| (0..60 * number).map(move |i| amplitude * (TAU * f64::from(i) / 60.0).sin());
    let fitted =
        block(0.015, 2).chain(block(0.03, 3)).chain(block(0.05, 4)).chain(block(0.03, 2)).chain(block(0.05, 3));
    let held = block(0.022, 3).chain(block(0.045, 5)).chain(block(0.015, 2));
    pad(vec![test("blocks", fitted.collect(), false), test("others", held.collect(), true)], |t| {
        let (stiffness, cubic) = (1.6 * K, if on.stiffens { 2.5e5 } else { 0.0 });
        let (mut most, mut before, mut travelled) = (0.0f64, 0.0f64, 0.0);
        along(&t.path, |u, q| {
            let energy = stiffness * u * u / 2.0 + cubic * u.powi(4) / 4.0;
            most = most.max(energy);
            travelled += (u - before).abs();
            before = u;
            let softened = if on.softens { 1.0 - erf((most - energy) / 0.15) / 2.2 } else { 1.0 };
            let worn = if on.wears { 0.55 + 0.45 * (-travelled / 1.0f64).exp() } else { 1.0 };
            softened * worn * (stiffness * u + cubic * u.powi(3)) + q
        })
    })
}

/// Forces that are held, between some cycles.
fn held(levels: [(f64, f64); 4]) -> Vec<f64> {
    let hold = |(force, seconds): (f64, f64)| {
        let rise = (0..50).map(move |i| force * f64::from(i) / 50.0);
        let fall = (0..50).map(move |i| force * (1.0 - f64::from(i) / 50.0));
        rise.chain(std::iter::repeat_n(force, (seconds / DT) as usize)).chain(fall).chain([0.0; 40])
    };
    levels.into_iter().flat_map(hold).collect()
}

/// The pad under imposed forces, whose displacement is recorded. It creeps by the logarithm of the time under each part of
/// the force (linear superposition), `rate` times the elastic displacement for each factor of ten.
pub fn creep(rate: f64) -> Concealed {
    let paths = [
        ("held", held([(7.0, 4.0), (14.0, 6.0), (-12.0, 4.0), (9.0, 3.0)])),
        ("others", held([(10.0, 5.0), (-8.0, 3.0), (15.0, 4.0), (-6.0, 2.0)])),
    ];
    let mut noise = Noise::default();
    let record = |(i, (name, path)): (usize, (&'static str, Vec<f64>))| {
        let mut spring = Plastic::default();
        let (mut instant, mut steps) = (0.0f64, Vec::<f64>::new());
        let moved = |(j, &f): (usize, &f64)| {
            steps.push(f - if j > 0 { path[j - 1] } else { 0.0 });
            // The displacement at which elastic and plastic part carry the force.
            let (mut low, mut high) = (-1.0, 1.0);
            for _ in 0..60 {
                instant = (low + high) / 2.0;
                let carried = K * instant + spring.clone().force(instant, K0, FY);
                if carried > f { high = instant } else { low = instant }
            }
            spring.force(instant, K0, FY);
            let crept: f64 =
                steps.iter().enumerate().map(|(k, df)| df * (1.0 + DT * (j - k) as f64 / 0.2).log10()).sum();
            instant + rate * crept / (K + K0)
        };
        let pure: Vec<f64> = path.iter().enumerate().map(moved).collect();
        let size = 0.01 * pure.iter().fold(0.0f64, |m, u| m.max(u.abs()));
        let columns = vec![("disp[m]".to_owned(), pure.iter().map(|u| u + size * noise.next()).collect())];
        Record { name, holdout: i > 0, set: String::new(), motions: vec![("motion", path)], columns }
    };
    let runs = paths.into_iter().enumerate().map(record).collect();
    let model = PAD.replace("sp 2 1 1.0", "load 2 1.0").replace(
        "recorder Element -file force.out -time -ele 1 force",
        "recorder Node -file disp.out -time -node 2 -dof 1 disp",
    );
    Concealed {
        model,
        parameters: vec![("Fy", 4.0, 25.0), ("k", 100.0, 600.0)],
        channels: vec![Channel { name: "disp", output: "disp.out", column: 1 }],
        dt: DT,
        runs,
    }
}

/// Deformations that are held, between some cycles.
fn held_deformations() -> Vec<Test> {
    let scaled = |levels| held(levels).into_iter().map(|f| 0.003 * f).collect();
    let fitted = scaled([(7.0, 4.0), (12.0, 6.0), (-5.0, 2.0), (9.0, 3.0)]);
    let others = scaled([(10.0, 5.0), (-6.0, 3.0), (13.0, 4.0), (4.0, 2.0)]);
    vec![test("held", fitted, false), test("others", others, true)]
}

/// A part of the deformation that is held becomes permanent, at a rate that falls with what has become so. It never
/// comes back.
pub fn permanent_set(part: f64) -> Concealed {
    pad(held_deformations(), |t| {
        let mut set = 0.0f64;
        along(&t.path, |u, q| {
            set += DT / 3.0 * (part * u - set).max(0.0);
            1.6 * K * (u - set) + q
        })
    })
}

/// Rubber that crystallises in the cold, by Avrami's equation with an exponent of two: its stiffness grows by the clock,
/// between a few cycles and the next.
pub fn crystallising(growth: f64) -> Concealed {
    let cycles = |amplitude: f64| (0..60).map(move |i| amplitude * (TAU * f64::from(i) / 30.0).sin());
    let waits = |n: usize| std::iter::repeat_n(0.0, n);
    let fitted: Vec<f64> =
        [0.03, 0.02, 0.04, 0.03, 0.02, 0.04].into_iter().flat_map(|a| cycles(a).chain(waits(90))).collect();
    let held: Vec<f64> = [0.02, 0.035, 0.025, 0.045].into_iter().flat_map(|a| cycles(a).chain(waits(130))).collect();
    pad(vec![test("cold", fitted, false), test("others", held, true)], |t| {
        let mut time = -DT;
        along(&t.path, |u, q| {
            time += DT;
            (1.0 + growth * (1.0 - (-(time / 8.0).powi(2)).exp())) * K * u + q
        })
    })
}

/// A lead rubber bearing that is pulled and pressed: forces of OpenSees' element `LeadRubberX`, without and with its
/// cavitation, written by `validation/diagnosis/pulled_rubber.py`. The model's bearing has a linear axis.
pub fn pulled(cavitates: bool) -> Concealed {
    let rows = || include_str!("pulled_rubber.csv").lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>());
    let number = |word: &str| word.parse::<f64>().unwrap();
    let mut noise = Noise::default();
    let runs = ["strong", "others"].into_iter().map(|name| {
        let of_run = || rows().filter(|row| row[0] == name);
        let pure: Vec<f64> = of_run().map(|row| number(row[if cavitates { 3 } else { 2 }])).collect();
        let size = 0.01 * pure.iter().fold(0.0f64, |m, f| m.max(f.abs()));
        Record {
            name,
            holdout: name == "others",
            set: String::new(),
            motions: vec![("motion", of_run().map(|row| number(row[1]) / 1000.0).collect())],
            columns: vec![("force[kN]".to_owned(), pure.iter().map(|f| f + size * noise.next()).collect())],
        }
    });
    let model = "wipe\nmodel basic -ndm 3 -ndf 6\npset kv 7e5\nnode 1 0. 0. 0.\nnode 2 0. 0. 0.3\nfix 1 1 1 1 1 1 1\n\
        fix 2 0 1 0 1 1 1\n\
        uniaxialMaterial Elastic 7 $kv\nuniaxialMaterial Elastic 8 1e5\n\
        element elastomericBearingPlasticity 1 1 2 7e3 200. 0.1 0.0 1.0 -P 7 -T 8 -My 8 -Mz 8 -orient 0 0 1 1 0 0\n\
        timeSeries Path 1 -dt $dt -filePath $motion\npattern Plain 1 1 { sp 2 3 1.0 }\n\
        recorder Element -file force.out -time -ele 1 force\nconstraints Transformation\nsystem FullGeneral\n\
        test NormDispIncr 1e-9 50\nalgorithm Newton\nintegrator LoadControl $dt\nanalysis Static\n\
        for {set i 1} {$i < $npts} {incr i} { if {[analyze 1] != 0} { error \"no convergence\" } }\n";
    Concealed {
        model: model.to_owned(),
        parameters: vec![("kv", 2e5, 3e6)],
        channels: vec![Channel { name: "force", output: "force.out", column: 9 }],
        dt: DT,
        runs: runs.collect(),
    }
}
