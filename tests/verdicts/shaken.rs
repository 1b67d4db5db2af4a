//! Masses under earthquakes: motions by Runge's and Kutta's method.

use super::studies::{Channel, Concealed, Noise, Record, SHAKEN};

/// Step of the scripts and the recordings, s; the motions are made in steps of a part of it.
const DT: f64 = 0.01;
const PARTS: u32 = 20;
const SAMPLES: usize = 600;

/// Noise of a channel, as a part of its root mean square.
const NOISE: f64 = 0.03;

/// Acceleration of the ground.
fn ground(tones: [f64; 3]) -> Vec<f64> {
    let at = |t: f64| tones.iter().map(|w| 2.0 * (w * t + w * w).sin()).sum::<f64>() * (-0.1 * t).exp();
    (0..SAMPLES).map(|i| at(DT * i as f64)).collect()
}

/// Samples of what is seen of a state that begins at zero and changes at a rate given by state and ground acceleration.
pub fn moved<const N: usize>(ground: &[f64], rate: impl Fn(&[f64; N], f64) -> [f64; N]) -> Vec<[f64; N]> {
    let (h, mut x) = (DT / f64::from(PARTS), [0.0; N]);
    let go = |x: &[f64; N], d: &[f64; N], h: f64| -> [f64; N] { std::array::from_fn(|i| x[i] + h * d[i]) };
    let mut out = vec![x];
    for pair in ground.windows(2) {
        for part in 0..PARTS {
            let at = |more: f64| pair[0] + (pair[1] - pair[0]) * (f64::from(part) + more) / f64::from(PARTS);
            let a = rate(&x, at(0.0));
            let b = rate(&go(&x, &a, 0.5 * h), at(0.5));
            let c = rate(&go(&x, &b, 0.5 * h), at(0.5));
            let d = rate(&go(&x, &c, h), at(1.0));
            x = std::array::from_fn(|i| x[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        }
        out.push(x);
    }
    out
}

/// Rate of the hysteretic variable of Bouc and Wen with an exponent of one.
pub fn bouc_wen(v: f64, z: f64, uy: f64) -> f64 {
    v / uy * (1.0 - 0.5 * z.abs() * (1.0 + (v * z).signum()))
}

/// The study of two earthquakes, from what the channels show of the ground's acceleration.
pub fn study<const C: usize>(
    model: String,
    parameters: Vec<(&'static str, f64, f64)>,
    channels: [Channel; C],
    shows: impl Fn(&[f64]) -> [Vec<f64>; C],
) -> Concealed {
    study_of_tones(model, parameters, channels, |_, ground| shows(ground))
}

/// The same from the tones of the ground as well.
pub fn study_of_tones<const C: usize>(
    model: String,
    parameters: Vec<(&'static str, f64, f64)>,
    channels: [Channel; C],
    shows: impl Fn([f64; 3], &[f64]) -> [Vec<f64>; C],
) -> Concealed {
    let mut noise = Noise::default();
    let mut run = |name, holdout, tones| {
        let ground = ground(tones);
        let columns = shows(tones, &ground).into_iter().zip(&channels).map(|(values, channel)| {
            let size = NOISE * (values.iter().map(|u| u * u).sum::<f64>() / values.len() as f64).sqrt();
            let noisy = values.iter().map(|u| u + size * noise.next()).collect();
            (channel.name.to_owned(), noisy)
        });
        let columns = columns.collect();
        Record { name, holdout, set: String::new(), motions: vec![("motion", ground)], columns }
    };
    let runs = vec![run("first", false, [6.0, 11.0, 17.0]), run("second", true, [5.0, 13.0, 19.0])];
    Concealed { model, parameters, channels: channels.into(), dt: DT, runs }
}

pub fn disp(name: &'static str, column: usize) -> Channel {
    Channel { name, output: "disp.out", column }
}

/// Motions of the degrees of freedom that are first in each pair of a state.
pub fn displacements<const N: usize, const C: usize>(states: &[[f64; N]], at: [usize; C]) -> [Vec<f64>; C] {
    at.map(|i| states.iter().map(|x| x[i]).collect())
}

/// A mass on a spring that yields, with a force more on its displacement and velocity.
fn yielding_spring(more: impl Fn(f64, f64) -> f64, shows: impl Fn(Vec<f64>) -> Vec<f64>) -> Concealed {
    let (k, uy) = (100.0, 0.03);
    let model = SHAKEN.replace("pset k 400.0\npset uy 0.02", "pset k 110.0\npset uy 0.025");
    study(model, vec![("k", 50.0, 200.0), ("uy", 0.008, 0.1)], [disp("disp", 1)], |ground| {
        let states =
            moved(ground, |&[u, v, z], a| [v, -a - 0.6 * k * u - 0.4 * k * uy * z - more(u, v), bouc_wen(v, z, uy)]);
        displacements(&states, [0]).map(&shows)
    })
}

/// A wall of a stiffness on one side.
pub fn wall(stiffness: f64) -> Concealed {
    yielding_spring(|u, _| stiffness * (u - 0.05).max(0.0), |disp| disp)
}

/// A channel that reads no more than a level on one side, its noise neither.
pub fn clipped() -> Concealed {
    let mut study = yielding_spring(|_, _| 0.0, |disp| disp);
    for run in &mut study.runs {
        let values = &mut run.columns[0].1;
        let level = 0.7 * values.iter().fold(0.0, |m: f64, u| m.max(*u));
        values.iter_mut().for_each(|u| *u = u.min(level));
    }
    study
}

/// A channel that is late by three samples.
pub fn late() -> Concealed {
    yielding_spring(|_, _| 0.0, |disp| (0..disp.len()).map(|i| disp[i.saturating_sub(3)]).collect())
}

/// Two storeys on a line, without the commands of the analysis.
const STOREYS: &str = "wipe\nmodel basic -ndm 1 -ndf 1\npset k 130.0\npset c 1.5\nnode 1 0.\nnode 2 0. -mass 1.0\n\
    node 3 0. -mass 1.0\nfix 1 1\nuniaxialMaterial Elastic 1 $k\nuniaxialMaterial Viscous 2 $c 1.0\n";

/// The analysis of two storeys.
pub const SHAKE: &str = "timeSeries Path 1 -dt $dt -filePath $motion\npattern UniformExcitation 1 1 -accel 1\n\
    recorder Node -file disp.out -time -node 2 3 -dof 1 disp\nconstraints Plain\nsystem FullGeneral\n\
    test NormDispIncr 1e-10 30\nalgorithm Newton\nintegrator Newmark 0.5 0.25\nanalysis Transient\n\
    for {set i 1} {$i < $npts} {incr i} { if {[analyze 1 $dt] != 0} { error \"no convergence\" } }\n";

pub fn storeys(
    model: String,
    parameters: Vec<(&'static str, f64, f64)>,
    rate: impl Fn(&[f64; 6], f64) -> [f64; 6],
) -> Concealed {
    study(model, parameters, [disp("lower", 1), disp("upper", 2)], |ground| {
        displacements(&moved(ground, &rate), [0, 2])
    })
}

/// Two storeys with dashpots.
pub fn damped_storeys() -> String {
    format!("{STOREYS}element zeroLength 1 1 2 -mat 1 2 -dir 1 1\nelement zeroLength 2 2 3 -mat 1 2 -dir 1 1\n{SHAKE}")
}

/// Nothing is missing.
pub fn two_storeys() -> Concealed {
    storeys(damped_storeys(), vec![("k", 60.0, 300.0), ("c", 0.2, 8.0)], |&[u, v, w, s, ..], a| {
        let (lower, upper) = (150.0 * u + 2.0 * v, 150.0 * (w - u) + 2.0 * (s - v));
        [v, upper - lower - a, s, -upper - a, 0.0, 0.0]
    })
}

/// A wall beside the upper storey on one side, with the contact of Hunt and Crossley.
pub fn wall_above() -> Concealed {
    storeys(damped_storeys(), vec![("k", 60.0, 300.0), ("c", 0.2, 8.0)], |&[u, v, w, s, ..], a| {
        let (lower, upper) = (150.0 * u + 2.0 * v, 150.0 * (w - u) + 2.0 * (s - v));
        let contact = 2e4 * (w - 0.08).max(0.0).powf(1.5) * (1.0 + 0.3 * s).max(0.0);
        [v, upper - lower - a, s, -upper - contact - a, 0.0, 0.0]
    })
}

/// Two storeys of which the upper one is heavier than in the model.
pub fn stored_goods() -> Concealed {
    storeys(damped_storeys(), vec![("k", 60.0, 300.0), ("c", 0.2, 8.0)], |&[u, v, w, s, ..], a| {
        let (lower, upper) = (150.0 * u + 2.0 * v, 150.0 * (w - u) + 2.0 * (s - v));
        [v, upper - lower - a, s, -upper / 1.5 - a, 0.0, 0.0]
    })
}

/// The ground below the lower storey gives way: a spring and a dashpot, beneath which nothing has a mass.
pub fn soft_ground() -> Concealed {
    let (k, c, soil, dashpot) = (150.0, 2.0, 130.0, 3.0);
    storeys(damped_storeys(), vec![("k", 60.0, 300.0), ("c", 0.2, 8.0)], |&[u, v, w, s, base, _], a| {
        // The base takes the speed at which the dashpots above and below it are in balance with the springs.
        let speed = (k * (u - base) + c * v - soil * base) / (c + dashpot);
        let (lower, upper) = (k * (u - base) + c * (v - speed), k * (w - u) + c * (s - v));
        [v, upper - lower - a, s, -upper - a, speed, 0.0]
    })
}

/// Two storeys with dashpots whose drifts are recorded. The script has `stiffness`.
fn drifts_of_storeys<const N: usize>(
    stiffness: f64,
    rate: impl Fn(&[f64; N], f64) -> [f64; N],
    drifts: impl Fn(&[f64; N]) -> [f64; 2],
) -> Concealed {
    let model = damped_storeys().replace("pset k 130.0", &format!("pset k {stiffness:.1}")).replace(
        "recorder Node -file disp.out -time -node 2 3 -dof 1 disp",
        "recorder Element -file drift.out -time -ele 1 2 deformation",
    );
    let drift = |name, column| Channel { name, output: "drift.out", column };
    // Each element has a column for its spring and one for its dashpot.
    let channels = [drift("drift1", 1), drift("drift2", 3)];
    study(model, vec![("k", 40.0, 600.0), ("c", 0.2, 8.0)], channels, |ground| {
        let seen: Vec<[f64; 2]> = moved(ground, &rate).iter().map(&drifts).collect();
        [0, 1].map(|i| seen.iter().map(|d| d[i]).collect())
    })
}

/// A slab between two storeys and the ground, which has a force of its own on its displacement and speed.
fn storeys_on_slab(mass: f64, force: impl Fn(f64, f64) -> f64) -> Concealed {
    let (k, c) = (150.0, 2.0);
    let rate = |&[base, b, u, v, w, s]: &[f64; 6], a: f64| {
        let (lower, upper) = (k * (u - base) + c * (v - b), k * (w - u) + c * (s - v));
        [b, (lower - force(base, b)) / mass - a, v, upper - lower - a, s, -upper - a]
    };
    drifts_of_storeys(130.0, rate, |&[base, _, u, _, w, _]| [u - base, w - u])
}

/// Friction pendulums below the storeys, by Coulomb's law smoothed over the speed, that the model leaves out. Its friction grows
/// with the speed (Mokha, Constantinou and Reinhorn 1990).
pub fn pendulums() -> Concealed {
    storeys_on_slab(1.2, |u, v| 16.0 * u + (1.8 - 0.5 * (-20.0 * v.abs()).exp()) * (v / 0.01).tanh())
}

/// Look-alike of an isolation layer: elastic ground below a heavy slab.
pub fn heavy_soft_ground() -> Concealed {
    storeys_on_slab(0.8, |u, v| 120.0 * u + 3.0 * v)
}

/// Look-alike of an isolation layer: a stiffness that is far off, and nothing missing.
pub fn soft_model() -> Concealed {
    let rate = |&[u, v, w, s]: &[f64; 4], a: f64| {
        let (lower, upper) = (150.0 * u + 2.0 * v, 150.0 * (w - u) + 2.0 * (s - v));
        [v, upper - lower - a, s, -upper - a]
    };
    drifts_of_storeys(45.0, rate, |&[u, _, w, _]| [u, w - u])
}

/// Dashpots that the model does not have.
pub fn undamped_model() -> Concealed {
    let model = STOREYS.replace("pset c 1.5\n", "pset upper 130.0\n").replace("Viscous 2 $c 1.0", "Elastic 2 $upper");
    let model = format!(
        "{model}rayleigh 0.1 0. 0. 0.\nelement zeroLength 1 1 2 -mat 1 -dir 1\nelement zeroLength 2 2 3 -mat 2 -dir 1\n{SHAKE}"
    );
    storeys(model, vec![("k", 60.0, 300.0), ("upper", 60.0, 300.0)], |&[u, v, w, s, ..], a| {
        let (lower, upper) = (150.0 * u + 1.5 * v, 150.0 * (w - u) + 1.5 * (s - v));
        [v, upper - lower - a - 0.1 * v, s, -upper - a - 0.1 * s, 0.0, 0.0]
    })
}

/// An elastic storey with a dashpot on a bearing that yields.
fn storey_on_bearing() -> String {
    let model = STOREYS.replace("pset c 1.5", "pset uy 0.025").replace("pset k 130.0", "pset k 450.0").replace(
        "uniaxialMaterial Viscous 2 $c 1.0\n",
        "uniaxialMaterial Viscous 5 2.0 1.0\nuniaxialMaterial Elastic 2 60.0\n\
         uniaxialMaterial BoucWen 3 0.0 80.0 1.0 [expr {0.5/$uy}] [expr {0.5/$uy}] 1.0 0.0 0.0 0.0\n\
         uniaxialMaterial Parallel 4 2 3\n",
    );
    format!("{model}element zeroLength 1 1 2 -mat 4 -dir 1\nelement zeroLength 2 2 3 -mat 1 5 -dir 1 1\n{SHAKE}")
}

/// On a bearing that yields stands a storey that the model takes for elastic, and that yields too.
pub fn yielding_storey() -> Concealed {
    let (k, uy, storey_uy, hardening) = (400.0, 0.03, 0.008, 0.1);
    storeys(storey_on_bearing(), vec![("k", 150.0, 900.0), ("uy", 0.008, 0.1)], |&[u, v, w, s, z, y], a| {
        let lower = 60.0 * u + 80.0 * uy * z;
        let upper = k * (hardening * (w - u) + (1.0 - hardening) * storey_uy * y) + 2.0 * (s - v);
        [v, upper - lower - a, s, -upper - a, bouc_wen(v, z, uy), bouc_wen(s - v, y, storey_uy)]
    })
}

/// On a bearing that yields stands a storey whose mass has a drag against the ground, with the square of its speed.
pub fn drag() -> Concealed {
    let (k, uy, drag) = (400.0, 0.03, 4.0);
    storeys(storey_on_bearing(), vec![("k", 150.0, 900.0), ("uy", 0.008, 0.1)], |&[u, v, w, s, z, _], a| {
        let lower = 60.0 * u + 80.0 * uy * z;
        let upper = k * (w - u) + 2.0 * (s - v);
        [v, upper - lower - a, s, -upper - drag * s * s.abs() - a, bouc_wen(v, z, uy), 0.0]
    })
}

/// A floor in plan on springs, shaken along one axis.
pub fn floor_in_plan() -> String {
    let model = "wipe\nmodel basic -ndm 2 -ndf 3\npset k 110.0\npset turn 900.0\nnode 1 0. 0.\n\
        node 2 0. 0. -mass 1.0 1.0 4.0\nfix 1 1 1 1\nuniaxialMaterial Elastic 1 $k\nuniaxialMaterial Elastic 2 $turn\n\
        element zeroLength 1 1 2 -mat 1 1 2 -dir 1 2 6\nrayleigh 0.8 0. 0. 0.\n";
    format!("{model}{}", SHAKE.replace("-node 2 3 -dof 1 disp", "-node 2 -dof 1 3 disp"))
}

/// A floor in plan whose mass stands beside the springs' centre.
pub fn eccentric() -> Concealed {
    let (k, turn, off, radius) = (100.0, 800.0, 0.3, 2.0f64);
    let channels = [disp("along", 1), disp("turn", 2)];
    study(floor_in_plan(), vec![("k", 50.0, 250.0), ("turn", 300.0, 2000.0)], channels, |ground| {
        let states = moved(ground, |&[u, v, turned, spin], a| {
            // The mass moves by u - off * turned; both equations of a unit mass solved for the accelerations.
            let (force, moment) = (-k * u, -turn * turned);
            let square = radius * radius;
            let push = ((square + off * off) * force + off * moment) / square;
            let twist = (off * force + moment) / square;
            [v, push - a - 0.8 * v, spin, twist - 0.8 * spin]
        });
        displacements(&states, [0, 2])
    })
}
