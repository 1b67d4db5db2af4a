//! Lines of springs normal to the plane of bending.

use super::bundle::{BLOCK, Breadth, Bundle};
use crate::material::Material;

/// Relative difference of levers that are taken as equal: round-off.
const EQUAL_LEVERS: f64 = 1e-12;
/// Largest ratio of lines to springs; with more lines there is no gain in speed.
const MAX_LINE_RATIO: f64 = 0.6;
/// Relative difference of the strains along a line that is round-off.
const EQUAL_STRAINS: f64 = 1e-13;

/// The springs of a section in lines with equal levers for one of the rotations.
///
/// While the section rotates about that axis only, all springs of a line have equal strains and equal state variables.
/// One spring then represents the line.
#[derive(Clone, Debug)]
pub(super) struct Lines {
    /// One spring in the middle of each line.
    pub(super) bundle: Bundle,
    /// Line of each spring.
    of: Vec<usize>,
    /// Index of the lever along the lines, and its largest size.
    along: (usize, f64),
}

impl Lines {
    /// Makes lines of springs with an equal lever `across`; `None` if there are too many.
    pub(super) fn of(material: &Material, springs: &Bundle, across: usize) -> Option<Self> {
        let (area, lever) = springs.parts();
        let (own, other) = (lever[across], lever[1 - across]);
        let reach = |l: &[f64]| l.iter().fold(0.0f64, |m, l| m.max(l.abs()));
        let (width, length) = (reach(own), reach(other));
        let mut order: Vec<usize> = (0..area.len()).collect();
        order.sort_by(|a, b| own[*a].total_cmp(&own[*b]));
        let mut lines: Vec<Vec<usize>> = vec![];
        for i in order {
            match lines.last_mut() {
                Some(line) if own[i] - own[line[0]] <= EQUAL_LEVERS * width => line.push(i),
                _ => lines.push(vec![i]),
            }
        }
        if lines.len() as f64 > MAX_LINE_RATIO * area.len() as f64 {
            return None;
        }
        let sum = |line: &[usize], of: &dyn Fn(usize) -> f64| line.iter().map(|&i| area[i] * of(i)).sum::<f64>();
        let areas: Vec<f64> = lines.iter().map(|line| sum(line, &|_| 1.0)).collect();
        let mean = |of: &dyn Fn(usize) -> f64| -> Vec<f64> {
            lines.iter().zip(&areas).map(|(line, area)| sum(line, of) / area).collect()
        };
        let mut middle = mean(&|i| other[i]);
        // Lines that are symmetric about the axis.
        middle.iter_mut().filter(|m| m.abs() <= EQUAL_LEVERS * length).for_each(|m| *m = 0.0);
        let mut levers = [mean(&|i| own[i]), middle];
        let square = mean(&|i| other[i] * other[i]);
        let square = square.iter().zip(&levers[1]).map(|(s, m)| s - m * m).collect();
        if across == 1 {
            levers.swap(0, 1);
        }
        let mut of = vec![0; area.len()];
        for (n, line) in lines.iter().enumerate() {
            line.iter().for_each(|&i| of[i] = n);
        }
        let n = lines.len();
        let breadth = Breadth { axis: 1 - across, square };
        let bundle = Bundle::new(material, (areas, levers), Some(breadth), n);
        Some(Self { bundle, of, along: (1 - across, length) })
    }

    /// Returns true if section strains, of which `largest` is the largest, are equal along each line.
    pub(super) fn has_equal_strains(&self, strain: [f64; 3], largest: f64) -> bool {
        let (axis, length) = self.along;
        strain[1 + axis].abs() * length <= EQUAL_STRAINS * largest
    }

    /// State variables of all springs from those of their lines. `virgin` has one value per block.
    pub(super) fn spread(
        &self,
        material: &Material,
        springs: &Bundle,
        virgin: &[bool],
        line_states: &[f64],
    ) -> Vec<f64> {
        let state_len = material.state_len();
        let mut all = vec![0.0; springs.len() * state_len];
        for block in &springs.blocks {
            let n = block.springs.len();
            let to = &mut all[block.springs.start * state_len..block.springs.end * state_len];
            for (i, spring) in block.springs.clone().enumerate() {
                let line = self.of[spring];
                let from = &self.bundle.blocks[line / BLOCK];
                let states = if virgin[line / BLOCK] { &self.bundle.virgin[..] } else { line_states };
                let states = &states[from.springs.start * state_len..from.springs.end * state_len];
                material.copy_history((states, line % BLOCK, from.springs.len()), (to, i, n));
            }
        }
        all
    }
}
