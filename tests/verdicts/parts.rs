//! Parts of structures that the model leaves out: motions by Runge's and Kutta's method.

use super::shaken::{bouc_wen, damped_storeys, disp, displacements, moved, storeys, study};
use super::studies::Concealed;

/// Two storeys on the ground with a force more in the lower and in the upper storey, and two further states.
fn storeys_with(more: impl Fn(&[f64; 6]) -> [f64; 2], rates: impl Fn(&[f64; 6]) -> [f64; 2]) -> Concealed {
    storeys(damped_storeys(), vec![("k", 60.0, 300.0), ("c", 0.2, 8.0)], move |state, a| {
        let [u, v, w, s, ..] = *state;
        let [below, above] = more(state);
        let (lower, upper) = (150.0 * u + 2.0 * v + below, 150.0 * (w - u) + 2.0 * (s - v) + above);
        let [first, second] = rates(state);
        [v, upper - lower - a, s, -upper - a, first, second]
    })
}

/// An infill in the lower storey that cracks: its stiffness falls with the largest drift so far.
pub fn cracking_infill() -> Concealed {
    storeys_with(
        |&[u, _, _, _, most, _]| [200.0 * u * (-most / 0.06).exp(), 0.0],
        |&[u, v, _, _, most, _]| [if u.abs() >= most && u * v > 0.0 { v.abs() } else { 0.0 }, 0.0],
    )
}

/// A friction damper in a brace of the upper storey.
pub fn added_damper() -> Concealed {
    storeys_with(|&[_, _, _, _, z, _]| [0.0, 1.2 * z], |&[_, v, _, s, z, _]| [bouc_wen(s - v, z, 0.004), 0.0])
}

/// Sliding partitions in both storeys: friction side by side.
pub fn partitions() -> Concealed {
    storeys_with(
        |&[_, _, _, _, z, y]| [0.8 * z, 0.8 * y],
        |&[_, v, _, s, z, y]| [bouc_wen(v, z, 0.003), bouc_wen(s - v, y, 0.003)],
    )
}

/// A layer of sliders between the two storeys: the upper one stands on a slab that slides on the lower one.
pub fn middle_layer() -> Concealed {
    let model = damped_storeys();
    study(model, vec![("k", 60.0, 300.0), ("c", 0.2, 8.0)], [disp("lower", 1), disp("upper", 2)], |ground| {
        let states = moved(ground, |&[u, v, w, s, b, d, z]: &[f64; 7], a| {
            let layer = 8.0 * (b - u) + 0.9 * z;
            let (lower, upper) = (150.0 * u + 2.0 * v, 150.0 * (w - b) + 2.0 * (s - d));
            [v, layer - lower - a, s, -upper - a, d, (upper - layer) / 0.3 - a, bouc_wen(d - v, z, 0.002)]
        });
        displacements(&states, [0, 2])
    })
}
