//! Bearings whose sliding faces, rubber or lead do what the model leaves out, by formulas of their own.

use super::imposed::{DT, FY, K, K0, NOISE, Plastic, Test, along, pad, relaxing, test, two_tests};
use super::studies::{Channel, Concealed, Noise, PAD, Record};
use std::f64::consts::{PI, TAU};

/// Two cycles of some amplitudes, each of them after a rest, s.
fn with_rests(cycles: [(f64, f64); 5]) -> Vec<f64> {
    let moved = |amplitude: f64| (0..80).map(move |i| amplitude * (TAU * f64::from(i) / 40.0).sin()).chain([0.0]);
    let rest = |seconds: f64| std::iter::repeat_n(0.0, (seconds / DT) as usize);
    cycles.into_iter().flat_map(|(seconds, amplitude)| rest(seconds).chain(moved(amplitude))).collect()
}

/// Fitted to cycles after rests of 0.2 to 4 s, held out others.
fn rests() -> Vec<Test> {
    let fitted = with_rests([(0.0, 0.02), (0.2, 0.035), (4.0, 0.03), (0.6, 0.045), (1.8, 0.03)]);
    let held = with_rests([(0.0, 0.03), (1.0, 0.02), (0.4, 0.04), (3.0, 0.035), (0.1, 0.025)]);
    vec![test("rests", fitted, false), test("others", held, true)]
}

/// A slider beside the pad whose friction at the end of a rest has grown with the logarithm of its length (Dieterich 1972), and
/// falls to that of motion along a straight line over some slip (Ida 1972). It has rested for long before a test.
pub fn sticking(growth: f64) -> Concealed {
    let (friction, slip) = (0.5, 0.015);
    pad(rests(), |t| {
        let (mut slider, mut before) = (Plastic::default(), 0.0f64);
        let (mut rested, mut slipped) = (100.0f64, 0.0f64);
        along(&t.path, |u, q| {
            if u == before {
                rested = if slipped > 0.0 { 0.0 } else { rested } + DT;
                slipped = 0.0;
            }
            slipped += (u - before).abs();
            before = u;
            let more = growth * (1.0 + rested / 0.1).log10() * (1.0 - slipped / slip).max(0.0);
            K * u + q + slider.force(u, 2e4, friction + more)
        })
    })
}

/// Look-alike of a slider that sticks: the force relaxes at rest.
pub fn relaxing_at_rest() -> Concealed {
    relaxing(rests(), 150.0, 0.6)
}

/// Nothing is missing in cycles between rests.
pub fn rested() -> Concealed {
    pad(rests(), |t| along(&t.path, |u, q| K * u + q))
}

/// A stop beside the pad on one side of its stroke.
pub fn one_sided_stop() -> Concealed {
    pad(two_tests(), |t| along(&t.path, |u, q| K * u + q + 1500.0 * (u - 0.022).max(0.0)))
}

/// The pad was left with a permanent deformation: it begins elsewhere on its path, in plastic and in elastic equilibrium.
pub fn residual_offset(offset: f64) -> Concealed {
    pad(two_tests(), |t| {
        let mut spring = Plastic::default();
        spring.force(2.0 * offset, K0, FY);
        spring.force(offset, K0, FY);
        t.path.iter().map(|&u| K * (u + offset) + spring.force(u + offset, K0, FY)).collect()
    })
}

/// A spring that stands for a bearing's axis.
fn axis(name: &str, law: impl Fn(&mut f64, f64) -> f64) -> Concealed {
    let k = 5000.0 * NOISE / 0.8;
    let pull = |cycles: f64| -> Vec<f64> {
        (0..400).map(|i| f64::from(i) / 400.0).map(|x| 0.05 * x * (TAU * cycles * x).sin()).collect()
    };
    let tests = vec![test("pulled", pull(5.0), false), test("slower", pull(3.0), true)];
    let mut study = pad(tests, |t| {
        let mut most = 0.0;
        t.path.iter().map(|&u| k * law(&mut most, u)).collect()
    });
    study.model = PAD
        .replace("pset Fy 9.0\npset k 300.0", &format!("pset k {:?}", 0.9 * k))
        .replace("uniaxialMaterial Steel01 1 $Fy 2000.0 0.0\nuniaxialMaterial Elastic 2 $k\n", "")
        .replace("Parallel 3 1 2", &format!("{name} 3 $k"));
    study.parameters = vec![("k", 0.2 * k, 3.0 * k)];
    study
}

/// A bearing that the model holds down lifts off.
pub fn uplift() -> Concealed {
    axis("Elastic", |_, u| u.min(0.0))
}

/// Shear of one bearing in plane under a constant weight: a script of `element` with parameters, kN and m.
fn bearing(element: &str, parameters: &str, weight: f64) -> String {
    format!(
        "wipe\nmodel basic -ndm 2 -ndf 3\n{parameters}\nnode 1 0. 0.\nnode 2 0. 0.\nfix 1 1 1 1\nfix 2 0 0 1\n\
        uniaxialMaterial Elastic 7 1e7\n{element} -P 7 -Mz 7 -orient 0 1 0 -1 0 0\n\
        timeSeries Path 1 -dt $dt -filePath $motion\npattern Plain 1 1 {{ sp 2 1 1.0 }}\ntimeSeries Constant 2\n\
        pattern Plain 2 2 {{ load 2 0. {:?} 0. }}\nrecorder Element -file force.out -time -ele 1 force\n\
        constraints Transformation\ntest NormDispIncr 1e-10 30\nalgorithm Newton\nintegrator Newmark 0.6 0.3025\n\
        analysis Transient\nfor {{set i 1}} {{$i < $npts}} {{incr i}} {{ if {{[analyze 1 $dt] != 0}} {{ error \"no convergence\" }} }}\n",
        -weight
    )
}

/// Shear of a bearing along paths, from its displacement and speed.
fn sheared(
    model: String,
    parameters: Vec<(&'static str, f64, f64)>,
    paths: [(&'static str, Vec<f64>); 2],
    mut force: impl FnMut(&[f64]) -> Vec<f64>,
) -> Concealed {
    let mut noise = Noise::default();
    let runs = paths.into_iter().enumerate().map(|(i, (name, path))| {
        let pure = force(&path);
        let size = 0.01 * pure.iter().fold(0.0f64, |m, f| m.max(f.abs()));
        let columns = vec![("force[kN]".to_owned(), pure.iter().map(|f| f + size * noise.next()).collect())];
        Record { name, holdout: i > 0, set: String::new(), motions: vec![("motion", path)], columns }
    });
    let runs = runs.collect();
    Concealed {
        model,
        parameters,
        channels: vec![Channel { name: "force", output: "force.out", column: 4 }],
        dt: DT,
        runs,
    }
}

/// Strong cycles, a rest and strong cycles; others held out.
fn strong() -> [(&'static str, Vec<f64>); 2] {
    let cycles = |amplitude: f64, period: f64, number: f64| {
        // From rest and back to it without a jump of the speed.
        let grown = move |x: f64| if x < 0.5 { (PI * x).sin().powi(2) } else { 1.0 };
        let samples = (period * number / DT) as usize;
        let at = move |x: f64| amplitude * grown(x) * grown(number - x) * (TAU * x).sin();
        (0..samples).map(move |i| at(DT * i as f64 / period))
    };
    let rest = |seconds: f64| std::iter::repeat_n(0.0, (seconds / DT) as usize);
    let fitted = cycles(0.2, 1.4, 4.0).chain(rest(6.0)).chain(cycles(0.2, 1.4, 2.0)).chain(cycles(0.1, 1.2, 2.0));
    let held = cycles(0.12, 1.2, 3.0).chain(cycles(0.25, 1.6, 3.0)).chain(rest(4.0)).chain(cycles(0.18, 1.8, 1.0));
    [("strong", fitted.collect()), ("others", held.collect())]
}

/// A lead core heats by its work and loses heat to the plates (Kalpakidis and Constantinou 2009: lead's strength falls by
/// e^(-0.0069 T), and its heat goes into half-spaces of steel at both ends and into the shims). The model is a law of constant strength.
pub fn lead_core(heats: bool) -> Concealed {
    let (radius, height) = (0.09, 0.2);
    let area = PI * radius * radius;
    let capacity = 11.2 * 130.0 * area * height;
    let model = bearing(
        "element elastomericBearingPlasticity 1 1 2 [expr {12.0*$kd}] $q [expr {1.0/12.0}] 0.0 1.0",
        "pset q 200.0\npset kd 1000.0",
        1000.0,
    );
    sheared(model, vec![("q", 80.0, 600.0), ("kd", 400.0, 3000.0)], strong(), |path| {
        let (mut core, mut before, mut rise, mut time) = (Plastic::default(), 0.0, 0.0f64, 0.0f64);
        let step = |&u: &f64| {
            let cold = 10e3 * area;
            let f = core.force(u, 13200.0, if heats { cold * (-0.0069 * rise).exp() } else { cold });
            time += DT;
            // Half-spaces at both ends, in parts of the conduction of steel over its depth of penetration, kW per degree.
            let lost = 2.0 * 0.05 * area / (PI * 1.41e-5 * time).sqrt() * rise;
            rise += ((f * (u - before)).max(0.0) - lost * DT) / capacity;
            before = u;
            1200.0 * u + f
        };
        path.iter().map(step).collect()
    })
}

/// Dependences of the friction of a pendulum, whose weight may vary.
#[derive(Clone, Copy, Default)]
pub struct Dependences {
    pub heat: bool,
    pub speed: bool,
    pub pressure: bool,
    pub weight_varies: bool,
}

/// Friction of a pendulum that falls with the temperature and the pressure of its face and grows with the speed (Kumar,
/// Whittaker and Constantinou 2015). The model's is constant. It has the weight, which overturning may vary by a half.
pub fn pendulum(on: Dependences) -> Concealed {
    let (weight, radius) = (1000.0, 3.0);
    let area: f64 = if on.weight_varies { 0.02 } else { 0.05 };
    let sliding = "frictionModel Coulomb 4 $mu\nelement singleFPBearing 1 1 2 4 $R 1e5";
    let model = bearing(sliding, "pset mu 0.05\npset R 3.2", 1.0)
        .replace("timeSeries Constant 2", "timeSeries Path 2 -dt $dt -filePath $weights");
    let variation = if on.weight_varies { 0.5 } else { 0.0 };
    let weights = |(period, (_, path)): (f64, (&str, Vec<f64>))| -> Vec<f64> {
        (0..path.len()).map(|i| weight * (1.0 + variation * (TAU * DT * i as f64 / period).sin())).collect()
    };
    let weights: Vec<Vec<f64>> = [3.1, 4.3].into_iter().zip(strong()).map(weights).collect();
    let mut of_run = weights.iter();
    let mut study = sheared(model, vec![("mu", 0.01, 0.2), ("R", 1.5, 6.0)], strong(), |path| {
        let (mut face, mut before, mut fluxes) = (Plastic::default(), 0.0f64, Vec::<f64>::new());
        let step = |(i, (&u, &n)): (usize, (&f64, &f64))| {
            // Of a half-space: its surface warms by q √(α/π) / k ∫ dτ / √(t - τ); kW/m² and kW/(m K).
            let kernel = |k: usize| 2.0 * DT.sqrt() * (((i - k) as f64).sqrt() - ((i - k - 1) as f64).sqrt());
            let rise = (4.44e-6 / PI).sqrt() / 0.018 * (0..i).map(|k| fluxes[k] * kernel(k)).sum::<f64>();
            let speed = (path.get(i + 1).unwrap_or(&u) - before).abs() / (2.0 * DT);
            let warm = if on.heat { 0.789 * (0.7f64.powf(0.02 * (20.0 + rise)) + 0.4) } else { 1.0 };
            let fast = if on.speed { 1.0 - 0.5 * (-30.0 * speed).exp() } else { 1.0 };
            let pressed = if on.pressure { 0.7f64.powf(0.02e-3 * (n - weight) / area) } else { 1.0 };
            let mu = 0.08 * warm * fast * pressed;
            fluxes.push(if u.abs() < 0.5 * area.sqrt() { mu * n / area * speed } else { 0.0 });
            before = u;
            n / radius * u + face.force(u, 1e5, mu * n)
        };
        path.iter().zip(of_run.next().map_or(&[][..], |n| n)).enumerate().map(step).collect()
    });
    for (run, weights) in study.runs.iter_mut().zip(weights.clone()) {
        run.motions.push(("weights", weights));
    }
    study
}
