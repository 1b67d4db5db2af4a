//! Forces that recur wherever a device has the same deformation.
//!
//! The error of another form of law changes slowly along the stroke, and smooth functions of the motion describe it. A force
//! that changes within the stroke (teeth, joints, a rough track) needs cells. The mean residual of a fine cell at other times
//! predicts the residual there better than the mean of a coarse cell.

use crate::prior::{COARSE_STROKE_CELLS, FINE_STROKE_CELLS, SAMPLES_PER_CELL};

/// Cells along the stroke of a device.
pub(crate) struct StrokeCells {
    coarse: Vec<Cells>,
    fine: Vec<Cells>,
}

impl StrokeCells {
    /// Cells of a deformation, as fine as its samples allow. Each block of time is predicted from the others.
    pub(crate) fn new(deformation: &[f64], blocks: usize) -> Self {
        let cells = |count: usize| Cells::along(deformation, count, blocks);
        Self { coarse: cells(COARSE_STROKE_CELLS), fine: FINE_STROKE_CELLS.into_iter().flat_map(cells).collect() }
    }

    /// Share of a series' power that fine cells predict beyond coarse ones; at least 0.
    pub(crate) fn recurrence_within_stroke(&self, x: &[f64]) -> f64 {
        (largest_share(&self.fine, x) - largest_share(&self.coarse, x)).max(0.0)
    }

    /// Share of a series' power that coarse or fine cells predict.
    pub(crate) fn recurrence_along_stroke(&self, x: &[f64]) -> f64 {
        largest_share(&self.coarse, x).max(largest_share(&self.fine, x))
    }
}

/// The largest share of a series' power that one division into cells predicts.
fn largest_share(all: &[Cells], x: &[f64]) -> f64 {
    all.iter().map(|c| c.explained_share(x)).fold(0.0, f64::max)
}

/// A division of samples into cells.
struct Cells {
    /// Cell of each sample.
    cell: Vec<usize>,
    count: usize,
    blocks: usize,
}

impl Cells {
    /// `count` cells, and twice as many by the sense of the motion; without those that have too few samples.
    fn along(deformation: &[f64], count: usize, blocks: usize) -> Vec<Self> {
        let n = deformation.len();
        let [low, high] =
            deformation.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(*x), b.max(*x)]);
        if !(high - low).is_normal() || count * SAMPLES_PER_CELL > n {
            return vec![];
        }
        let at = |x: f64| (((x - low) / (high - low) * count as f64) as usize).min(count - 1);
        let increases = |t: usize| deformation[(t + 1).min(n - 1)] > deformation[t.saturating_sub(1)];
        let cell: Vec<usize> = deformation.iter().map(|x| at(*x)).collect();
        let by_sense = cell.iter().enumerate().map(|(t, c)| 2 * c + usize::from(increases(t))).collect();
        let mut all = vec![Self { cell, count, blocks }];
        if 2 * count * SAMPLES_PER_CELL <= n {
            all.push(Self { cell: by_sense, count: 2 * count, blocks });
        }
        all
    }

    /// Share of a series' power that the cell means of the other blocks predict; at least 0.
    fn explained_share(&self, x: &[f64]) -> f64 {
        let n = x.len();
        let block = |t: usize| t * self.blocks / n;
        let mut own = vec![(0.0, 0.0); self.blocks * self.count];
        let mut all = vec![(0.0, 0.0); self.count];
        for (t, (c, x)) in self.cell.iter().zip(x).enumerate() {
            for sum in [&mut own[block(t) * self.count + c], &mut all[*c]] {
                *sum = (sum.0 + x, sum.1 + 1.0);
            }
        }
        let squared_error = |(t, (c, x)): (usize, (&usize, &f64))| {
            let (here, sum) = (own[block(t) * self.count + c], all[*c]);
            // One zero sample more shrinks the mean of a cell with few samples.
            (x - (sum.0 - here.0) / (sum.1 - here.1 + 1.0)).powi(2)
        };
        let error: f64 = self.cell.iter().zip(x).enumerate().map(squared_error).sum();
        let total: f64 = x.iter().map(|x| x * x).sum();
        if total > 0.0 { (1.0 - error / total).max(0.0) } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::StrokeCells;
    use crate::test_support::white_noise;

    #[test]
    fn ripples_along_the_stroke_are_found_and_noise_and_smooth_laws_are_not() {
        let at = |t: usize| (0.02 * t as f64).sin() + 0.7 * (0.0347 * t as f64 + 1.0).sin();
        let deformation: Vec<f64> = (0..1200).map(at).collect();
        let stroke = StrokeCells::new(&deformation, 6);
        let white = white_noise(5, 1200);
        assert!(stroke.recurrence_within_stroke(&white) < 0.02, "{}", stroke.recurrence_within_stroke(&white));
        let rippled: Vec<f64> =
            white.iter().zip(&deformation).map(|(x, e)| x / 3f64.sqrt() + 2.0 * (20.0 * e + 1.0).sin()).collect();
        assert!(stroke.recurrence_within_stroke(&rippled) > 0.5, "{}", stroke.recurrence_within_stroke(&rippled));
        // Cells by the sense of the motion find a force that changes sign on the way back.
        let sense = |t: usize| if at(t + 1) > at(t) { 1.0 } else { -1.0 };
        let back: Vec<f64> = (0..1200).map(|t| sense(t) * (20.0 * at(t)).sin()).collect();
        assert!(stroke.recurrence_within_stroke(&back) > 0.5, "{}", stroke.recurrence_within_stroke(&back));
        // Error of a loop with too much dissipation and stiffening.
        let smooth: Vec<f64> =
            (0..1200).map(|t| 0.1 * white[t] + sense(t) * (1.0 - at(t).powi(2)) + at(t).powi(3)).collect();
        assert!(stroke.recurrence_within_stroke(&smooth) < 0.05, "{}", stroke.recurrence_within_stroke(&smooth));
        assert!(stroke.recurrence_along_stroke(&smooth) > 0.8 && stroke.recurrence_along_stroke(&white) < 0.02);
    }

    #[test]
    fn a_device_at_rest_has_no_recurrence() {
        for deformation in [&[0.0; 200][..], &[], &[0.0, 1.0, 2.0]] {
            assert!(
                StrokeCells::new(deformation, 6).recurrence_along_stroke(&white_noise(1, deformation.len())) == 0.0
            );
        }
    }
}
