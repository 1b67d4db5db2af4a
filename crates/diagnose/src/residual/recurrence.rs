//! What comes again, several times within the stroke, wherever a device is deformed as much.
//!
//! A law of another form leaves what changes slowly along the stroke, and smooth functions of the motion see it. A force that
//! changes several times within the stroke (teeth, joints, a rough track) is seen by cells of the deformation: the mean of what
//! is left in a cell at other times tells what is left there now, and better so than wide cells do.

/// Cells along the stroke that see what a law of another form leaves.
const WIDE: usize = 12;
/// Cells that see what is finer.
const NARROW: [usize; 3] = [24, 48, 96];
/// Samples that a cell must have in the mean.
const LEAST: usize = 4;

/// The stroke of a device, in cells.
pub(crate) struct Stroke {
    wide: Vec<Cells>,
    narrow: Vec<Cells>,
}

impl Stroke {
    /// Of a deformation, cut as finely as its samples can bear; `blocks` of time each in turn are told by the others.
    pub(crate) fn new(deformation: &[f64], blocks: usize) -> Self {
        let of = |count: usize| Cells::along(deformation, count, blocks);
        Self { wide: of(WIDE), narrow: NARROW.into_iter().flat_map(of).collect() }
    }

    /// Part of the power of a series that comes again within the stroke, beyond what does along it; 0 where nothing does.
    pub(crate) fn comes_again_within(&self, x: &[f64]) -> f64 {
        (most(&self.narrow, x) - most(&self.wide, x)).max(0.0)
    }

    /// Part of the power of a series that comes again along the stroke, however slowly it changes there.
    pub(crate) fn comes_again(&self, x: &[f64]) -> f64 {
        most(&self.wide, x).max(most(&self.narrow, x))
    }
}

/// The largest part of the power of a series that one of some cuts tells.
fn most(all: &[Cells], x: &[f64]) -> f64 {
    all.iter().map(|c| c.explained(x)).fold(0.0, f64::max)
}

/// Samples in cells.
struct Cells {
    cell: Vec<usize>,
    count: usize,
    blocks: usize,
}

impl Cells {
    /// So many, whatever the sense of the motion, and twice as many by it, if the samples are enough.
    fn along(deformation: &[f64], count: usize, blocks: usize) -> Vec<Self> {
        let n = deformation.len();
        let [low, high] =
            deformation.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(*x), b.max(*x)]);
        if !(high - low).is_normal() || count * LEAST > n {
            return vec![];
        }
        let at = |x: f64| (((x - low) / (high - low) * count as f64) as usize).min(count - 1);
        let onward = |t: usize| deformation[(t + 1).min(n - 1)] > deformation[t.saturating_sub(1)];
        let cell: Vec<usize> = deformation.iter().map(|x| at(*x)).collect();
        let by_sense = cell.iter().enumerate().map(|(t, c)| 2 * c + usize::from(onward(t))).collect();
        let mut all = vec![Self { cell, count, blocks }];
        if 2 * count * LEAST <= n {
            all.push(Self { cell: by_sense, count: 2 * count, blocks });
        }
        all
    }

    /// Part of the power of a series that the means of the cells in the other blocks of time tell; 0 where they tell nothing.
    fn explained(&self, x: &[f64]) -> f64 {
        let n = x.len();
        let block = |t: usize| t * self.blocks / n;
        let mut own = vec![(0.0, 0.0); self.blocks * self.count];
        let mut all = vec![(0.0, 0.0); self.count];
        for (t, (c, x)) in self.cell.iter().zip(x).enumerate() {
            for sum in [&mut own[block(t) * self.count + c], &mut all[*c]] {
                *sum = (sum.0 + x, sum.1 + 1.0);
            }
        }
        let miss = |(t, (c, x)): (usize, (&usize, &f64))| {
            let (here, sum) = (own[block(t) * self.count + c], all[*c]);
            // One sample that says nothing beside those of the cell, so that few of them say little.
            (x - (sum.0 - here.0) / (sum.1 - here.1 + 1.0)).powi(2)
        };
        let error: f64 = self.cell.iter().zip(x).enumerate().map(miss).sum();
        let total: f64 = x.iter().map(|x| x * x).sum();
        if total > 0.0 { (1.0 - error / total).max(0.0) } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::Stroke;
    use crate::residual::noise::tests::noise;

    #[test]
    fn teeth_are_seen_and_noise_and_smooth_laws_are_not() {
        let at = |t: usize| (0.02 * t as f64).sin() + 0.7 * (0.0347 * t as f64 + 1.0).sin();
        let deformation: Vec<f64> = (0..1200).map(at).collect();
        let stroke = Stroke::new(&deformation, 6);
        let white = noise(5, 1200);
        assert!(stroke.comes_again_within(&white) < 0.02, "{}", stroke.comes_again_within(&white));
        let teeth: Vec<f64> =
            white.iter().zip(&deformation).map(|(x, e)| x / 3f64.sqrt() + 2.0 * (20.0 * e + 1.0).sin()).collect();
        assert!(stroke.comes_again_within(&teeth) > 0.5, "{}", stroke.comes_again_within(&teeth));
        // A force that has another sign on the way back is seen by the sense of the motion.
        let sense = |t: usize| if at(t + 1) > at(t) { 1.0 } else { -1.0 };
        let back: Vec<f64> = (0..1200).map(|t| sense(t) * (20.0 * at(t)).sin()).collect();
        assert!(stroke.comes_again_within(&back) > 0.5, "{}", stroke.comes_again_within(&back));
        // A loop that is too fat, and stiffens too much.
        let smooth: Vec<f64> =
            (0..1200).map(|t| 0.1 * white[t] + sense(t) * (1.0 - at(t).powi(2)) + at(t).powi(3)).collect();
        assert!(stroke.comes_again_within(&smooth) < 0.05, "{}", stroke.comes_again_within(&smooth));
        assert!(stroke.comes_again(&smooth) > 0.8 && stroke.comes_again(&white) < 0.02);
    }

    #[test]
    fn what_does_not_move_has_none() {
        for deformation in [&[0.0; 200][..], &[], &[0.0, 1.0, 2.0]] {
            assert!(Stroke::new(deformation, 6).comes_again(&noise(1, deformation.len())) == 0.0);
        }
    }
}
