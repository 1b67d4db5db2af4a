//! A pad under an imposed displacement: forces by formulas of their own.

use super::studies::{Channel, Concealed, Noise, PAD, Record};

pub const DT: f64 = 0.02;

/// Strength, stiffness before yielding, stiffness of the elastic part of the pad that was tested.
pub const FY: f64 = 11.0;
pub const K0: f64 = 2000.0;
pub const K: f64 = 260.0;

/// Standard deviation of the load cell's noise: about 3 % of the force's.
pub const NOISE: f64 = 0.3;

/// An elastic-plastic spring.
#[derive(Clone, Copy, Default)]
pub struct Plastic {
    plastic: f64,
}

impl Plastic {
    pub fn force(&mut self, u: f64, stiffness: f64, strength: f64) -> f64 {
        let f = (stiffness * (u - self.plastic)).clamp(-strength, strength);
        self.plastic = u - f / stiffness;
        f
    }
}

/// A sine that grows for 8 s.
pub fn growing() -> Vec<f64> {
    (0..400).map(|i| DT * f64::from(i)).map(|t| 0.006 * t * (4.0 * t).sin()).collect()
}

/// Two sines.
pub fn mixed() -> Vec<f64> {
    (0..400).map(|i| DT * f64::from(i)).map(|t| 0.03 * (2.5 * t).sin() + 0.02 * (7.0 * t).sin()).collect()
}

/// Two cycles at each of three amplitudes, a pause, and two at the largest again.
fn blocks() -> Vec<f64> {
    let cycles =
        |amplitude: f64| (0..120).map(move |i| amplitude * (std::f64::consts::TAU * f64::from(i) / 60.0).sin());
    [0.012, 0.026, 0.045].into_iter().flat_map(cycles).chain((0..100).map(|_| 0.0)).chain(cycles(0.045)).collect()
}

/// One run of the pad: what it is called, its motion, whether it is held out.
pub struct Test {
    pub name: &'static str,
    pub path: Vec<f64>,
    pub holdout: bool,
    set: String,
    beside: Vec<(&'static str, Vec<f64>)>,
}

pub fn test(name: &'static str, path: Vec<f64>, holdout: bool) -> Test {
    Test { name, path, holdout, set: String::new(), beside: vec![] }
}

/// Fitted to a growing sine, held out two sines.
pub fn two_tests() -> Vec<Test> {
    vec![test("growing", growing(), false), test("mixed", mixed(), true)]
}

/// Fitted to blocks of cycles, held out two sines.
fn blocks_first() -> Vec<Test> {
    vec![test("blocks", blocks(), false), test("mixed", mixed(), true)]
}

/// The study of some tests of the pad, from the force in each of them without noise.
pub fn pad(tests: Vec<Test>, force: impl Fn(&Test) -> Vec<f64>) -> Concealed {
    let mut noise = Noise::default();
    let runs = tests.into_iter().map(|t| {
        let force = force(&t).iter().map(|f| f + NOISE * noise.next()).collect();
        let beside = t.beside.into_iter().map(|(header, values)| (header.to_owned(), values));
        Record {
            name: t.name,
            holdout: t.holdout,
            set: t.set,
            motions: vec![("motion", t.path)],
            columns: std::iter::once(("force[kN]".to_owned(), force)).chain(beside).collect(),
        }
    });
    Concealed {
        model: PAD.to_owned(),
        parameters: vec![("Fy", 4.0, 25.0), ("k", 100.0, 600.0)],
        channels: vec![Channel { name: "force", output: "force.out", column: 2 }],
        dt: DT,
        runs: runs.collect(),
    }
}

/// Force along a path from the displacement and the plastic part of the force.
pub fn along(path: &[f64], mut law: impl FnMut(f64, f64) -> f64) -> Vec<f64> {
    let mut spring = Plastic::default();
    path.iter().map(|&u| law(u, spring.force(u, K0, FY))).collect()
}

/// A spring that yields gradually: its stiffness falls in proportion to its force while it is loaded (Bouc 1967, with an
/// exponent of one), and is elastic while it is unloaded.
pub fn gradual() -> Concealed {
    pad(two_tests(), |t| {
        let (mut force, mut before) = (0.0f64, 0.0);
        let law = |&u: &f64| {
            let mut du = u - before;
            before = u;
            if force * du < 0.0 {
                let elastic = du.abs().min(force.abs() / K0).copysign(du);
                force += K0 * elastic;
                du -= elastic;
            }
            if du != 0.0 {
                let limit = FY.copysign(du);
                force = limit + (force - limit) * (-K0 * du.abs() / FY).exp();
            }
            K * u + force
        };
        t.path.iter().map(law).collect()
    })
}

/// Nothing is missing; the noise has a memory of ten samples.
pub fn slow_noise() -> Concealed {
    let (mut noise, mut last) = (Noise::default(), 0.0);
    let mut slow = || {
        last = 0.9 * last + 0.2 * noise.next();
        last
    };
    let slow: Vec<f64> = (0..800).map(|_| slow()).collect();
    pad(two_tests(), |t| {
        let from = if t.holdout { 400 } else { 0 };
        along(&t.path, |u, q| K * u + q).iter().zip(&slow[from..]).map(|(f, n)| f + n).collect()
    })
}

/// A force that waves along the stroke.
pub fn ridges() -> Concealed {
    pad(two_tests(), |t| along(&t.path, |u, q| K * u + q + 2.5 * (u / 0.0025).sin()))
}

/// A spring of a stiffness, and a dashpot in series with it, beside the pad.
pub fn maxwell(stiffness: f64) -> Concealed {
    relaxing(two_tests(), stiffness, 0.1)
}

/// The same in some tests, with a relaxation time.
pub fn relaxing(tests: Vec<Test>, stiffness: f64, relaxation: f64) -> Concealed {
    pad(tests, |t| {
        let (mut before, mut over) = (0.0, 0.0);
        let decay = (-DT / relaxation).exp();
        along(&t.path, |u, q| {
            over = over * decay + stiffness * (u - before) * relaxation / DT * (1.0 - decay);
            before = u;
            K * u + q + over
        })
    })
}

/// The strength falls with the temperature, which work raises and time lowers; there may be a thermometer in the pad.
pub fn heating(thermometer: bool) -> Concealed {
    let (capacity, cooling, softening) = (0.15, 4.0, 0.02);
    let heated = |path: &[f64]| -> (Vec<f64>, Vec<f64>) {
        let (mut spring, mut before, mut rise) = (Plastic::default(), 0.0, 0.0f64);
        let step = |&u: &f64| {
            let q = spring.force(u, K0, FY * (-softening * rise).exp());
            rise += (q * (u - before)).max(0.0) / capacity - rise * DT / cooling;
            before = u;
            (K * u + q, rise)
        };
        path.iter().map(step).unzip()
    };
    let mut tests = blocks_first();
    let mut noise = Noise::default();
    for t in tests.iter_mut().filter(|_| thermometer) {
        t.beside =
            vec![("temperature[degC]", heated(&t.path).1.iter().map(|x| 20.0 + x + 0.2 * noise.next()).collect())];
    }
    pad(tests, |t| heated(&t.path).0)
}

/// All forces grow in the cold, by 27 % over 30 degrees.
pub fn cold() -> Concealed {
    let degrees = |name: &str| match name {
        "growing" => 20.0,
        "cold" => -10.0,
        _ => 5.0,
    };
    let mut tests = two_tests();
    tests.insert(1, test("cold", growing(), false));
    for t in &mut tests {
        t.beside = vec![("temperature[degC]", vec![degrees(t.name); t.path.len()])];
    }
    pad(tests, |t| along(&t.path, |u, q| (0.008 * (20.0 - degrees(t.name))).exp() * (K * u + q)))
}

/// The elastic part is the softer the farther it is from the largest deformation so far (Ogden and Roxburgh, 1999).
pub fn mullins() -> Concealed {
    pad(blocks_first(), |t| {
        let mut most = 0.0f64;
        along(&t.path, |u, q| {
            most = most.max(u.abs());
            (1.0 - 0.5 * ((most - u.abs()) / 0.008).tanh()) * 1.6 * K * u + q
        })
    })
}

/// A part of the strength is lost with each unit of energy taken in, and does not come back.
pub fn degradation(loss: f64) -> Concealed {
    pad(blocks_first(), |t| {
        let (mut spring, mut before, mut energy) = (Plastic::default(), 0.0, 0.0f64);
        let step = |&u: &f64| {
            let q = spring.force(u, K0, FY * (1.0 - loss * energy).max(0.3));
            energy += (q * (u - before)).max(0.0);
            before = u;
            K * u + q
        };
        t.path.iter().map(step).collect()
    })
}

/// A cubic spring beside the pad.
pub fn stiffening() -> Concealed {
    pad(two_tests(), |t| along(&t.path, |u, q| K * u + q + 1.5e5 * u.powi(3)))
}

/// The elastic stiffness falls with the square of the axial load, which differs from test to test.
pub fn axial_loads() -> Concealed {
    let load = |name: &str| match name {
        "growing" => 40.0,
        "middle" => 80.0,
        "heavy" => 120.0,
        _ => 100.0,
    };
    let mut tests = two_tests();
    tests.insert(1, test("middle", growing(), false));
    tests.insert(2, test("heavy", mixed(), false));
    for t in &mut tests {
        t.set = format!(", axial = {:?}", load(t.name));
    }
    pad(tests, |t| along(&t.path, |u, q| (1.0 - (load(t.name) / 200.0f64).powi(2)) * K * u + q))
}

/// The strength follows an axial force that a load cell records.
pub fn axial_varies() -> Concealed {
    let ratio = |i: usize| 1.0 + 0.35 * (3.1 * DT * i as f64).sin();
    let mut tests = two_tests();
    for t in &mut tests {
        t.beside = vec![("axial[kN]", (0..t.path.len()).map(|i| 100.0 * ratio(i)).collect())];
    }
    pad(tests, |t| {
        let mut spring = Plastic::default();
        let step = |(i, &u): (usize, &f64)| K * u + spring.force(u, K0, FY * ratio(i));
        t.path.iter().enumerate().map(step).collect()
    })
}

/// Dry friction of a strength beside a pad that yields late.
pub fn friction(strength: f64) -> Concealed {
    let late = 500.0;
    let mut study = pad(two_tests(), |t| {
        let (mut rubber, mut slider) = (Plastic::default(), Plastic::default());
        t.path.iter().map(|&u| K * u + rubber.force(u, late, FY) + slider.force(u, 2e4, strength)).collect()
    });
    study.model = PAD.replace("$Fy 2000.0", &format!("$Fy {late:?}"));
    study
}

/// Loops that lose a part of their force near zero.
pub fn pinching(part: f64) -> Concealed {
    pad(two_tests(), |t| {
        let mut most = 1e-9f64;
        along(&t.path, |u, q| {
            most = most.max(u.abs());
            (1.0 - part / (1.0 + (u / (0.25 * most)).powi(4))) * (K * u + q)
        })
    })
}

/// The load cell reads too much in one of two tests.
pub fn gain() -> Concealed {
    let mut tests = two_tests();
    tests.insert(1, test("again", mixed(), false));
    tests[2].path.reverse();
    pad(tests, |t| along(&t.path, |u, q| if t.name == "again" { 1.15 } else { 1.0 } * (K * u + q)))
}

/// The device is tightened before one of two tests.
pub fn condition() -> Concealed {
    let mut tests = two_tests();
    tests.insert(1, test("again", mixed(), false));
    tests[2].path.reverse();
    pad(tests, |t| {
        let strength = if t.name == "again" { 1.5 * FY } else { FY };
        let mut spring = Plastic::default();
        t.path.iter().map(|&u| K * u + spring.force(u, K0, strength)).collect()
    })
}

/// The device is tightened in the middle of a test, and loosened again. `loosened` is the time of that, s.
pub fn condition_in_time(loosened: f64) -> Concealed {
    pad(two_tests(), |t| {
        let mut spring = Plastic::default();
        let step = |(i, &u): (usize, &f64)| {
            let tight = !t.holdout && (3.1..loosened).contains(&(DT * i as f64));
            K * u + spring.force(u, K0, if tight { 1.5 * FY } else { FY })
        };
        t.path.iter().enumerate().map(step).collect()
    })
}

/// The device is tightened slowly in one test, along a smooth step.
pub fn tightened_slowly() -> Concealed {
    pad(two_tests(), |t| {
        let mut spring = Plastic::default();
        let step = |(i, &u): (usize, &f64)| {
            let x = if t.holdout { 0.0 } else { ((DT * i as f64 - 2.0) / 4.0).clamp(0.0, 1.0) };
            K * u + spring.force(u, K0, FY * (1.0 + 0.6 * x * x * (3.0 - 2.0 * x)))
        };
        t.path.iter().enumerate().map(step).collect()
    })
}

/// The elastic part loses stiffness with the seconds of each test, a pause among them, towards a limit.
pub fn aging() -> Concealed {
    pad(blocks_first(), |t| {
        let mut time = -DT;
        along(&t.path, |u, q| {
            time += DT;
            (0.6 + 0.4 * (-time / 6.0).exp()) * K * u + q
        })
    })
}

/// Nothing is missing; the load cell is noisier for the seconds of a machine beside it.
pub fn loud_for_a_time() -> Concealed {
    let mut noise = Noise::default();
    let loud: Vec<f64> = (0..400).map(|i| if (150..280).contains(&i) { 1.2 * noise.next() } else { 0.0 }).collect();
    pad(two_tests(), |t| {
        let force = along(&t.path, |u, q| K * u + q);
        force.iter().zip(&loud).map(|(f, n)| if t.holdout { *f } else { f + n }).collect()
    })
}

/// The zero of the load cell jumps.
pub fn jump() -> Concealed {
    pad(two_tests(), |t| {
        let force = along(&t.path, |u, q| K * u + q);
        force.iter().enumerate().map(|(i, f)| if !t.holdout && i > 230 { f + 3.0 } else { *f }).collect()
    })
}

/// A spring that stands for a bearing's axis, pulled: beyond its strength it gives way, and comes back to zero in a line.
pub fn cavitation() -> Concealed {
    let (k, strength) = (5000.0, 40.0);
    let pull = |cycles: f64| -> Vec<f64> {
        (0..400).map(|i| f64::from(i) / 400.0).map(|x| 0.05 * x * (std::f64::consts::TAU * cycles * x).sin()).collect()
    };
    let force = |t: &Test| -> Vec<f64> {
        let start = strength / k;
        let backbone = |u: f64| strength * (1.0 + 0.25 * (1.0 - (-(u - start) / 0.01).exp()));
        let mut most = start;
        let law = |&u: &f64| {
            most = most.max(u);
            if u <= 0.0 { k * u } else { u * backbone(most) / most }
        };
        t.path.iter().map(law).map(|f| f * NOISE / 0.8).collect()
    };
    let tests = vec![test("pulled", pull(5.0), false), test("slower", pull(3.0), true)];
    // Of a size at which the noise of the load cell is the same part of it.
    let scale = NOISE / 0.8;
    let mut study = pad(tests, force);
    study.model = PAD
        .replace("pset Fy 9.0\npset k 300.0", &format!("pset k {:?}", 0.9 * scale * k))
        .replace("uniaxialMaterial Steel01 1 $Fy 2000.0 0.0\nuniaxialMaterial Elastic 2 $k\n", "")
        .replace("Parallel 3 1 2", "Elastic 3 $k");
    study.parameters = vec![("k", 0.2 * scale * k, 3.0 * scale * k)];
    study
}

/// A pad with two directions whose strengths the model takes for independent, along an orbit.
pub fn orbit() -> Concealed {
    let mut noise = Noise::default();
    let mut run = |name: &'static str, holdout: bool, [wx, wy, lag]: [f64; 3]| {
        let path = |w: f64, lag: f64| -> Vec<f64> {
            (0..400).map(|i| DT * f64::from(i)).map(|t| 0.006 * t * (w * t + lag).sin()).collect()
        };
        let (x, y) = (path(wx, 0.0), path(wy, lag));
        let (mut plastic, mut forces) = ([0.0; 2], [vec![], vec![]]);
        for (x, y) in x.iter().zip(&y) {
            let trial = [K0 * (x - plastic[0]), K0 * (y - plastic[1])];
            let back = (FY / trial[0].hypot(trial[1])).min(1.0);
            for (d, u) in [x, y].into_iter().enumerate() {
                plastic[d] = u - back * trial[d] / K0;
                forces[d].push(K * u + back * trial[d] + NOISE * noise.next());
            }
        }
        let [fx, fy] = forces;
        Record {
            name,
            holdout,
            set: String::new(),
            motions: vec![("motion", x), ("across", y)],
            columns: vec![("fx[kN]".to_owned(), fx), ("fy[kN]".to_owned(), fy)],
        }
    };
    let model = PAD
        .replace("-ndm 1 -ndf 1", "-ndm 2 -ndf 2")
        .replace("node 1 0.\nnode 2 0.\nfix 1 1", "node 1 0. 0.\nnode 2 0. 0.\nfix 1 1 1")
        .replace("-mat 3 -dir 1", "-mat 3 3 -dir 1 2")
        .replace("pattern Plain 1 1 { sp 2 1 1.0 }", "pattern Plain 1 1 { sp 2 1 1.0 }\ntimeSeries Path 2 -dt $dt -filePath $across\npattern Plain 2 2 { sp 2 2 1.0 }");
    Concealed {
        model,
        parameters: vec![("Fy", 4.0, 25.0), ("k", 100.0, 600.0)],
        channels: vec![
            Channel { name: "fx", output: "force.out", column: 3 },
            Channel { name: "fy", output: "force.out", column: 4 },
        ],
        dt: DT,
        runs: vec![run("spiral", false, [4.0, 4.0, 1.3]), run("eight", true, [3.0, 6.0, 0.4])],
    }
}

/// A stop, and a load cell that is late.
pub fn late_stop() -> Concealed {
    pad(two_tests(), |t| {
        let force = along(&t.path, |u, q| K * u + q + 4000.0 * u.signum() * (u.abs() - 0.03).max(0.0));
        (0..force.len()).map(|i| force[i.saturating_sub(3)]).collect()
    })
}
