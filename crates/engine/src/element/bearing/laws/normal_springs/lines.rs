//! Lines of springs across the plane that a section bends in.

use super::bundle::{BLOCK, Breadth, Bundle};
use crate::material::Material;

/// Levers that are as good as the same, in parts of the largest.
const SAME: f64 = 1e-12;
/// Largest part of the springs that there may be lines: with more of them there is little to gain.
const FEW: f64 = 0.6;
/// Strains by which the springs of a line may differ, in parts of the largest of the section: round-off.
const ALIKE: f64 = 1e-13;

/// The springs of a section in lines, each with the same lever for one of the rotations.
///
/// As long as the section has turned about that axis only, all springs of a line have had the same strains and have the
/// same history, so that one of them tells of all.
#[derive(Clone, Debug)]
pub(super) struct Lines {
    /// A spring in the middle of each line.
    pub(super) bundle: Bundle,
    /// Line of each spring.
    of: Vec<usize>,
    /// Lever along the lines, and how long they are on both sides.
    along: (usize, f64),
}

impl Lines {
    /// Lines of springs whose lever `across` is the same; `None` where there are not few.
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
                Some(line) if own[i] - own[line[0]] <= SAME * width => line.push(i),
                _ => lines.push(vec![i]),
            }
        }
        if lines.len() as f64 > FEW * area.len() as f64 {
            return None;
        }
        let sum = |line: &[usize], of: &dyn Fn(usize) -> f64| line.iter().map(|&i| area[i] * of(i)).sum::<f64>();
        let areas: Vec<f64> = lines.iter().map(|line| sum(line, &|_| 1.0)).collect();
        let mean = |of: &dyn Fn(usize) -> f64| -> Vec<f64> {
            lines.iter().zip(&areas).map(|(line, area)| sum(line, of) / area).collect()
        };
        let mut middle = mean(&|i| other[i]);
        // Of lines that are the same on both sides.
        middle.iter_mut().filter(|m| m.abs() <= SAME * length).for_each(|m| *m = 0.0);
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

    /// Whether strains of a section, the largest of which is `largest`, are the same along each line.
    pub(super) fn hold(&self, strain: [f64; 3], largest: f64) -> bool {
        let (axis, length) = self.along;
        strain[1 + axis].abs() * length <= ALIKE * largest
    }

    /// Histories of all springs, each that of its line, of which `virgin` says for each block whether it is virgin.
    pub(super) fn spread(&self, material: &Material, springs: &Bundle, virgin: &[bool], histories: &[f64]) -> Vec<f64> {
        let words = material.state_len();
        let mut all = vec![0.0; springs.len() * words];
        for block in &springs.blocks {
            let n = block.springs.len();
            let to = &mut all[block.springs.start * words..block.springs.end * words];
            for (i, spring) in block.springs.clone().enumerate() {
                let line = self.of[spring];
                let from = &self.bundle.blocks[line / BLOCK];
                let kept = if virgin[line / BLOCK] { &self.bundle.virgin[..] } else { histories };
                let kept = &kept[from.springs.start * words..from.springs.end * words];
                material.copy_history((kept, line % BLOCK, from.springs.len()), (to, i, n));
            }
        }
        all
    }
}
