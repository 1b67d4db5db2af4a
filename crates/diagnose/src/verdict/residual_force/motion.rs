//! Parts of a force that follow the motion.

use super::{ResidualPart, STROKE};
use crate::prior::STRUCTURE_BLOCKS;
use crate::residual::recurrence::StrokeCells;
use crate::residual::regression::explained_share;

/// Speed over the largest one up to which a device is at rest.
const AT_REST: f64 = 1e-3;
/// Least share of a residual force that a part has to be told.
const MIN_PART: f64 = 0.1;

/// Signs of the motion at each sample.
pub(super) struct Motion {
    deformation: Vec<f64>,
    speed: Vec<f64>,
    stroke: StrokeCells,
}

impl Motion {
    /// Signs of a deformation and of its rate; 0 at rest.
    pub(super) fn of(times: &[f64], deformation: &[f64]) -> Self {
        let at = |i: usize| {
            let (a, b) = (i.saturating_sub(1), (i + 1).min(times.len() - 1));
            (deformation[b] - deformation[a]) / (times[b] - times[a])
        };
        let speeds: Vec<f64> = (0..times.len()).map(at).collect();
        let signs = |x: &[f64], least: f64| {
            let most = x.iter().filter(|x| x.is_finite()).fold(0.0f64, |m, x| m.max(x.abs()));
            let sign = |x: &f64| if x.is_finite() && x.abs() > least * most { x.signum() } else { 0.0 };
            x.iter().map(sign).collect()
        };
        Self {
            deformation: signs(deformation, 0.0),
            speed: signs(&speeds, AT_REST),
            stroke: StrokeCells::new(deformation, STRUCTURE_BLOCKS),
        }
    }

    /// Parts of a force that follow a sign or come again along the stroke, and have a share of [`MIN_PART`]; the largest first.
    pub(super) fn parts(&self, force: &[f64]) -> Vec<ResidualPart> {
        let force: Vec<f64> = force.iter().map(|f| if f.is_finite() { *f } else { 0.0 }).collect();
        let side = vec![1.0; force.len()];
        let columns = [("speed", &self.speed), ("deformation", &self.deformation), ("side", &side)];
        let part = |(follows, column): (&'static str, &Vec<f64>)| ResidualPart {
            follows,
            share: explained_share(&force, std::slice::from_ref(column), STRUCTURE_BLOCKS),
            sense: force.iter().zip(column).map(|(f, c)| f * c).sum::<f64>().signum(),
        };
        let along_stroke =
            ResidualPart { follows: STROKE, share: self.stroke.recurrence_along_stroke(&force), sense: 1.0 };
        let all = columns.map(part).into_iter().chain([along_stroke]);
        let mut out: Vec<ResidualPart> = all.filter(|p| p.share >= MIN_PART).collect();
        out.sort_by(|a, b| b.share.total_cmp(&a.share));
        out
    }

    /// Shares of the square and of the time by the signs of deformation and speed: ++, +-, --, -+.
    pub(super) fn quadrants(&self, force: &[f64]) -> [[f64; 2]; 4] {
        let mut out = [[0.0; 2]; 4];
        for (i, f) in force.iter().enumerate().filter(|(_, f)| f.is_finite()) {
            let (u, v) = (self.deformation[i], self.speed[i]);
            if u == 0.0 || v == 0.0 {
                continue;
            }
            let k = match (u > 0.0, v > 0.0) {
                (true, true) => 0,
                (true, false) => 1,
                (false, false) => 2,
                (false, true) => 3,
            };
            out[k] = [out[k][0] + f * f, out[k][1] + 1.0];
        }
        let totals = [0, 1].map(|j| out.iter().map(|q| q[j]).sum::<f64>().max(f64::MIN_POSITIVE));
        out.map(|q| [q[0] / totals[0], q[1] / totals[1]])
    }
}
