//! Pictures of a field: displacements of all nodes, end forces of all members, stresses of all fibers.

use crate::numbers::{largest, narrow};
use nalgebra::DMatrix;

/// Rows of numbers of some steps, at equal distances. Where there are too many, every second one is left out.
#[derive(Clone, Debug)]
pub(crate) struct Frames {
    /// Numbers of a row.
    pub(crate) width: usize,
    most: usize,
    every: usize,
    /// Step of each row.
    pub(crate) steps: Vec<u32>,
    /// The rows.
    pub(crate) values: Vec<f32>,
}

impl Frames {
    /// Numbers that are kept in memory, all rows together.
    const KEPT: usize = 24_000_000;

    /// Rows of `width` numbers, between `least` and `most` of them.
    pub(crate) fn new(width: usize, least: usize, most: usize, kept: usize) -> Self {
        let most = kept.min(Self::KEPT).checked_div(width).unwrap_or(most).clamp(least, most);
        Self { width, most, every: 1, steps: vec![], values: vec![] }
    }

    /// Returns true if the row of a step is wanted.
    pub(crate) fn wants(&self, step: usize) -> bool {
        step.is_multiple_of(self.every)
    }

    /// Take the row of a step.
    pub(crate) fn push(&mut self, step: usize, row: impl Iterator<Item = f64>) {
        if self.steps.last() == Some(&(step as u32)) {
            return;
        }
        self.steps.push(step as u32);
        let end = self.values.len() + self.width;
        self.values.extend(row.map(narrow).take(self.width));
        self.values.resize(end, 0.0);
        if self.steps.len() > self.most {
            self.every *= 2;
            let kept: Vec<usize> = (0..self.steps.len()).filter(|i| self.wants(self.steps[*i] as usize)).collect();
            self.values = kept.iter().flat_map(|i| &self.values[i * self.width..][..self.width]).copied().collect();
            self.steps = kept.iter().map(|i| self.steps[*i]).collect();
        }
    }

    /// The row of a frame.
    pub(crate) fn row(&self, frame: usize) -> &[f32] {
        &self.values[frame * self.width..][..self.width]
    }

    /// The rows as sums of few shapes.
    pub(crate) fn reduced(&self, tolerance: f32, most_numbers: usize) -> Reduced {
        Reduced::new(self, tolerance, most_numbers)
    }
}

/// Rows as sums of shapes: row = Σ coefficient × shape.
#[derive(Clone, Debug)]
pub(crate) struct Reduced {
    /// Number of shapes.
    pub(crate) rank: usize,
    /// The shapes behind each other.
    pub(crate) shapes: Vec<f32>,
    /// Coefficients, row after row.
    pub(crate) coefficients: Vec<f32>,
    /// Largest difference from the rows, over the largest number of all.
    pub(crate) error: f32,
}

impl Reduced {
    /// The shapes are the eigenvectors of the rows' scalar products (the method of snapshots, L. Sirovich, Turbulence and
    /// the dynamics of coherent structures, Q. Appl. Math. 45, 1987). As many are taken as the tolerance needs, or as
    /// `most_numbers` allows.
    fn new(frames: &Frames, tolerance: f32, most_numbers: usize) -> Self {
        let (count, width) = (frames.steps.len(), frames.width);
        let dot = |a: &[f32], b: &[f32]| -> f64 {
            a.chunks(1024)
                .zip(b.chunks(1024))
                .map(|(a, b)| f64::from(a.iter().zip(b).map(|(x, y)| x * y).sum::<f32>()))
                .sum()
        };
        let mut products = DMatrix::zeros(count, count);
        for i in 0..count {
            for j in 0..=i {
                let p = dot(frames.row(i), frames.row(j));
                (products[(i, j)], products[(j, i)]) = (p, p);
            }
        }
        let eigen = products.symmetric_eigen();
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|a, b| eigen.eigenvalues[*b].total_cmp(&eigen.eigenvalues[*a]));
        let most = most_numbers.checked_div(width).unwrap_or(1).clamp(1, count.max(1));
        let peak = largest(&frames.values);
        let mut rest = frames.values.clone();
        let (mut shapes, mut columns, mut error) = (vec![], vec![], largest(&rest));
        for &k in order.iter().take(most) {
            let lambda = eigen.eigenvalues[k];
            if error <= tolerance * peak || lambda <= 0.0 {
                break;
            }
            let vector = eigen.eigenvectors.column(k);
            let mut shape = vec![0.0f32; width];
            for i in 0..count {
                let c = (vector[i] / lambda.sqrt()) as f32;
                shape.iter_mut().zip(frames.row(i)).for_each(|(s, x)| *s += c * x);
            }
            let column: Vec<f32> = (0..count).map(|i| (vector[i] * lambda.sqrt()) as f32).collect();
            for (row, c) in rest.chunks_exact_mut(width).zip(&column) {
                row.iter_mut().zip(&shape).for_each(|(x, s)| *x -= c * s);
            }
            error = largest(&rest);
            shapes.extend(shape);
            columns.push(column);
        }
        let rank = columns.len();
        let coefficients = (0..count).flat_map(|i| columns.iter().map(move |c| c[i])).collect();
        Self { rank, shapes, coefficients, error: if peak > 0.0 { error / peak } else { 0.0 } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A travelling wave of two frequencies, which is a sum of four shapes.
    fn wave(steps: usize) -> Frames {
        let mut frames = Frames::new(50, 10, 200, usize::MAX);
        for step in 0..steps {
            let t = step as f64 * 0.02;
            if frames.wants(step) {
                frames.push(
                    step,
                    (0..50).map(|x| (f64::from(x) * 0.1 - t).sin() + 0.3 * (f64::from(x) * 0.3 - 2.0 * t).sin()),
                );
            }
        }
        frames
    }

    #[test]
    fn frames_stay_below_their_number_at_equal_distances() {
        let frames = wave(5000);
        assert!(frames.steps.len() <= 200 && frames.steps.len() > 90, "{}", frames.steps.len());
        assert_eq!(frames.values.len(), frames.steps.len() * 50);
        assert!(frames.steps.windows(2).all(|w| w[1] - w[0] == frames.steps[1]));
    }

    #[test]
    fn a_sum_of_four_shapes_is_found() {
        let frames = wave(300);
        let reduced = frames.reduced(1e-3, usize::MAX);
        assert_eq!(reduced.rank, 4);
        assert!(reduced.error < 1e-3, "{}", reduced.error);
        for i in [0, 50, 100] {
            for (k, x) in frames.row(i).iter().enumerate() {
                let sum: f32 = (0..4).map(|r| reduced.coefficients[i * 4 + r] * reduced.shapes[r * 50 + k]).sum();
                assert!((sum - x).abs() < 2e-3, "{sum} for {x}");
            }
        }
    }
}
