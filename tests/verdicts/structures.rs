//! Structures on footings and beside neighbours: motions by Runge's and Kutta's method.

use super::shaken::{
    SHAKE, bouc_wen, damped_storeys, disp, displacements, floor_in_plan, moved, storeys, study, study_of_tones,
};
use super::studies::Concealed;

/// Two masses on a column that the model fixes at its foot.
fn column() -> String {
    let model = "wipe\nmodel basic -ndm 2 -ndf 3\npset EI 4000.0\npset alpha 0.4\nnode 1 0. 0.\n\
        node 2 0. 3. -mass 1.0 1.0 0.\nnode 3 0. 6. -mass 1.0 1.0 0.\nfix 1 1 1 1\ngeomTransf Linear 1\n\
        element elasticBeamColumn 1 1 2 10. 100. [expr {$EI/100.}] 1\n\
        element elasticBeamColumn 2 2 3 10. 100. [expr {$EI/100.}] 1\nrayleigh $alpha 0. 0. 0.\n";
    format!("{model}{SHAKE}")
}

/// A column on a footing with a dashpot and a moment that depends on its rotation and a hysteretic variable, which yields at
/// 0.001.
fn column_on_footing(moment: impl Fn(f64, f64) -> f64) -> Concealed {
    // The stiffness of the masses is the inverse of the flexibility of a cantilever, 3 and 6 high.
    let (k, dashpot) = (5000.0 / 141.75, 60.0);
    let channels = [disp("lower", 1), disp("upper", 2)];
    study(column(), vec![("EI", 1000.0, 20000.0), ("alpha", 0.05, 3.0)], channels, |ground| {
        let states = moved(ground, |&[x, v, y, w, turned, z], a| {
            let (below, above) = (x - 3.0 * turned, y - 6.0 * turned);
            let (lower, upper) = (k * (72.0 * below - 22.5 * above), k * (9.0 * above - 22.5 * below));
            let turns = (3.0 * lower + 6.0 * upper - moment(turned, z)) / dashpot;
            [v, -lower - 0.6 * v - a, w, -upper - 0.6 * w - a, turns, bouc_wen(turns, z, 0.001)]
        });
        displacements(&states, [0, 2])
    })
}

/// A footing on tensionless ground of even stiffness lifts off: past the lift-off the moment follows the length in contact
/// (Chopra and Yim 1985, Simplified earthquake analysis of structures with foundation uplift).
pub fn lifting_footing() -> Concealed {
    let (stiffness, lift) = (12000.0, 14.0);
    let at = lift / stiffness;
    column_on_footing(move |turned: f64, _| match turned.abs() {
        small if small <= at => stiffness * turned,
        large => turned.signum() * lift * (3.0 - 2.0 * (at / large).sqrt()),
    })
}

/// Soil under a footing that yields smoothly as it rocks.
pub fn yielding_footing() -> Concealed {
    column_on_footing(|turned, z| 3000.0 * turned + 10.0 * z)
}

/// Look-alike of a footing that lifts off: elastic ground below it.
pub fn rocking_footing() -> Concealed {
    column_on_footing(|turned, _| 9000.0 * turned)
}

/// Soft ground below two storeys whose stiffness falls with the frequency: soil that follows the footing, as a mass behind a
/// dashpot that the motion of the ground itself does not drive (Wolf 1994, Foundation vibration analysis using simple physical
/// models). Without `follows` the dashpot goes to the ground.
pub fn following_soil(follows: bool) -> Concealed {
    let (k, c, soil, [near, far], mass) = (150.0, 2.0, 130.0, [1.0, 8.0], 1.5);
    storeys(damped_storeys(), vec![("k", 60.0, 300.0), ("c", 0.2, 8.0)], move |&[u, v, w, s, base, below], a| {
        // The base takes the speed at which the dashpots are in balance with the springs.
        let speed = (k * (u - base) + c * v - soil * base + far * below) / (c + near + far);
        let (lower, upper) = (k * (u - base) + c * (v - speed), k * (w - u) + c * (s - v));
        let dragged = if follows { far * (speed - below) / mass } else { 0.0 };
        [v, upper - lower - a, s, -upper - a, speed, dragged]
    })
}

/// A neighbour beside the upper storey that no model has, behind a gap: one mass on a spring, with the contact of Hunt and
/// Crossley.
pub fn neighbour(gap: f64) -> Concealed {
    let rate = move |&[u, v, w, s, other, o]: &[f64; 6], a: f64| {
        let (lower, upper) = (150.0 * u + 2.0 * v, 150.0 * (w - u) + 2.0 * (s - v));
        let into = (w - other - gap).max(0.0);
        let contact = 2e4 * into.powf(1.5) * (1.0 + 0.3 * (s - o)).max(0.0);
        let (mass, period) = (1.6, 0.42);
        let circular = std::f64::consts::TAU / period;
        let of_neighbour = contact / mass - circular * circular * other - 0.08 * circular * o;
        [v, upper - lower - a, s, -upper - contact - a, o, of_neighbour - a]
    };
    storeys(damped_storeys(), vec![("k", 60.0, 300.0), ("c", 0.2, 8.0)], rate)
}

/// A deck on three piers along the shaken axis, which the model shakes at one time.
const BRIDGE: &str = "wipe\nmodel basic -ndm 2 -ndf 2\npset k 100.0\npset alpha 0.4\n\
    uniaxialMaterial Elastic 1 $k\nuniaxialMaterial Elastic 2 400.0\n\
    foreach {n x} {1 0. 2 40. 3 80.} {\n node $n $x 0.\n fix $n 1 1\n node 1$n $x 0. -mass 1.0 1.0\n fix 1$n 0 1\n\
    element zeroLength $n $n 1$n -mat 1 -dir 1\n}\nelement twoNodeLink 21 11 12 -mat 2 -dir 1\n\
    element twoNodeLink 22 12 13 -mat 2 -dir 1\nrayleigh $alpha 0. 0. 0.\n";

/// Displacement of the ground at a time, in closed form: zero before it moves.
fn ground_displacement(tones: [f64; 3], t: f64) -> f64 {
    if t <= 0.0 {
        return 0.0;
    }
    let of_tone = |w: &f64| {
        // The imaginary part of exp(i w²) ((exp(λ t) - 1) / λ² - t / λ) with λ = -0.1 + i w.
        let times = |(a, b): (f64, f64), (c, d): (f64, f64)| (a * c - b * d, a * d + b * c);
        let square = 0.01 + w * w;
        let inverse = (-0.1 / square, -w / square);
        let (growth, angle) = ((-0.1 * t).exp(), w * t);
        let first = times((growth * angle.cos() - 1.0, growth * angle.sin()), times(inverse, inverse));
        let both = (first.0 - t * inverse.0, first.1 - t * inverse.1);
        2.0 * times(both, ((w * w).cos(), (w * w).sin())).1
    };
    tones.iter().map(of_tone).sum()
}

/// The ground moves below each pier later by a time.
fn bridge(delays: [f64; 3], scales: [f64; 3]) -> Concealed {
    bridge_on(move |tones, t, pier| scales[pier] * ground_displacement(tones, t - delays[pier]))
}

/// The ground below each pier has a displacement at a time, which depends on the tones.
fn bridge_on(displacement: impl Fn([f64; 3], f64, usize) -> f64) -> Concealed {
    let model = format!("{BRIDGE}{}", SHAKE.replace("-node 2 3 -dof 1 disp", "-node 11 12 13 -dof 1 disp"));
    let channels = [disp("first", 1), disp("second", 2), disp("third", 3)];
    study_of_tones(model, vec![("k", 40.0, 250.0), ("alpha", 0.05, 3.0)], channels, move |tones, ground| {
        let states = moved(ground, |&[u1, v1, u2, v2, u3, v3, t]: &[f64; 7], a| {
            let now = ground_displacement(tones, t);
            let pier = |u: f64, v: f64, i: usize| -110.0 * (u - displacement(tones, t, i) + now) - 0.6 * v - a;
            let (one, two) = (400.0 * (u2 - u1), 400.0 * (u3 - u2));
            let [first, second, third] = [pier(u1, v1, 0), pier(u2, v2, 1), pier(u3, v3, 2)];
            [v1, first + one, v2, second + two - one, v3, third - two, 1.0]
        });
        displacements(&states, [0, 2, 4])
    })
}

/// The ground motion reaches the last pier late.
pub fn late_pier() -> Concealed {
    bridge([0.0, 0.0, 0.11], [1.0; 3])
}

/// A wave passes below the bridge.
pub fn passing_wave() -> Concealed {
    bridge([0.0, 0.05, 0.1], [1.0; 3])
}

/// Look-alike of a late pier: nothing is missing.
pub fn bridge_at_one_time() -> Concealed {
    bridge([0.0; 3], [1.0; 3])
}

/// Soft soil below the last pier shakes it more than the others.
pub fn louder_pier() -> Concealed {
    bridge([0.0; 3], [1.0, 1.0, 1.4])
}

/// The ground loses coherence along the bridge: a share of the motion below each pier is its own.
pub fn incoherent_piers(own: f64) -> Concealed {
    bridge_on(move |tones, t, pier| {
        let [a, b, c] = tones;
        let shift = pier as f64;
        let other = ground_displacement([a + 0.7 * shift, b - 1.1 * shift, c + 1.3 * shift], t);
        match pier {
            0 => ground_displacement(tones, t),
            _ => (1.0 - own * own).sqrt() * ground_displacement(tones, t) + own * other,
        }
    })
}

/// Acceleration of a ground that turns, with tones of its own: of three, the last two.
fn turning_ground([_, b, c]: [f64; 3], t: f64) -> f64 {
    ((0.8 * b * t + 1.0).sin() + (1.1 * c * t).sin()) * (-0.1 * t).exp()
}

/// Two storeys, one and two heights above a ground that rocks by itself, beside its translation.
pub fn rocking_ground(acceleration: f64) -> Concealed {
    let channels = [disp("lower", 1), disp("upper", 2)];
    study_of_tones(damped_storeys(), vec![("k", 60.0, 300.0), ("c", 0.2, 8.0)], channels, move |tones, ground| {
        let states = moved(ground, |&[u, v, w, s, t]: &[f64; 5], a| {
            let (lower, upper) = (150.0 * u + 2.0 * v, 150.0 * (w - u) + 2.0 * (s - v));
            let turn = acceleration * turning_ground(tones, t);
            [v, upper - lower - a - turn, s, -upper - a - 2.0 * turn, 1.0]
        });
        displacements(&states, [0, 2])
    })
}

/// A floor in plan on springs whose ground turns about the vertical by itself, beside its translation.
pub fn turning_floor() -> Concealed {
    let channels = [disp("along", 1), disp("turn", 2)];
    study_of_tones(floor_in_plan(), vec![("k", 50.0, 250.0), ("turn", 300.0, 2000.0)], channels, |tones, ground| {
        let states = moved(ground, |&[u, v, turned, spin, t]: &[f64; 5], a| {
            let twist = 0.5 * turning_ground(tones, t);
            [v, -100.0 * u - a - 0.8 * v, spin, -200.0 * turned - 0.8 * spin - twist, 1.0]
        });
        displacements(&states, [0, 2])
    })
}
