//! Springs of a section that are asked one by one.

use crate::material::{Material, MaterialError, Strains, Stresses};
use std::ops::Range;

/// Largest number of springs of a block, so that their stresses stay on the stack.
pub(super) const BLOCK: usize = 64;
/// Sums that are taken side by side.
const LANES: usize = 4;

/// Products of a weight with 1, the levers a and b, a², a b and b², summed over springs.
pub(super) type Moments = [f64; 6];

/// Rows and columns of a symmetric matrix of moments.
pub(super) const PLACES: [[usize; 3]; 3] = [[0, 1, 2], [1, 3, 4], [2, 4, 5]];

pub(super) fn add_to<const N: usize>(sums: &mut [f64; N], terms: &[f64; N]) {
    sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
}

/// Springs, each of which may stand for a line of them.
#[derive(Clone, Debug)]
pub(super) struct Bundle {
    /// Area of each, times its part in the distribution.
    area: Vec<f64>,
    /// Extension of each per unit of rotation about y and about z: its z, and its y with the other sign.
    lever: [Vec<f64>; 2],
    breadth: Option<Breadth>,
    /// Neighbours that are updated together.
    pub(super) blocks: Vec<Block>,
    /// All together: while none of them has a history, they are asked once for the whole section.
    pub(super) whole: Option<Block>,
    /// Virgin histories.
    pub(super) virgin: Vec<f64>,
}

/// How far the springs of each line lie on both sides of its middle.
#[derive(Clone, Debug)]
pub(super) struct Breadth {
    /// Lever that they differ in.
    pub(super) axis: usize,
    /// Mean of the square of the difference, for each line.
    pub(super) square: Vec<f64>,
}

/// Neighbouring springs that are updated together, and the moments of their areas.
#[derive(Clone, Debug)]
pub(super) struct Block {
    pub(super) springs: Range<usize>,
    pub(super) moments: Moments,
    /// Smallest and largest of each lever.
    levers: [[f64; 2]; 2],
}

impl Block {
    /// Together with another that follows it.
    fn with(mut self, next: Self) -> Self {
        add_to(&mut self.moments, &next.moments);
        for (all, own) in self.levers.iter_mut().zip(next.levers) {
            *all = [all[0].min(own[0]), all[1].max(own[1])];
        }
        Self { springs: self.springs.start..next.springs.end, ..self }
    }

    /// Strains between which those of the springs are.
    pub(super) fn range(&self, [axial, a, b]: [f64; 3]) -> [f64; 2] {
        let [a, b] = [self.levers[0].map(|l| l * a), self.levers[1].map(|l| l * b)];
        [axial + a[0].min(a[1]) + b[0].min(b[1]), axial + a[0].max(a[1]) + b[0].max(b[1])]
    }
}

/// Strains of a section, those of its committed state where the material asks for them, and their rates.
#[derive(Clone, Copy)]
pub(super) struct At {
    pub(super) before: Option<[f64; 3]>,
    pub(super) strain: [f64; 3],
    pub(super) rate: [f64; 3],
    pub(super) dt: f64,
}

/// Forces and moments of springs.
#[derive(Default)]
pub(super) struct Sum {
    pub(super) force: [f64; 3],
    pub(super) stiffness: Moments,
    pub(super) damping: Moments,
}

/// What springs with neighbouring numbers weigh, their levers, and the breadth of their lines.
struct Weights<'a> {
    area: &'a [f64],
    lever: [&'a [f64]; 2],
    breadth: Option<(usize, &'a [f64])>,
}

impl Weights<'_> {
    /// Sums over the springs of area times `factor` times what `of` says of the levers, in several lanes: sums that wait
    /// for each other took longer than all the springs.
    #[inline(always)]
    fn sum<const N: usize>(&self, factor: &[f64], of: impl Fn(f64, f64, f64) -> [f64; N]) -> [f64; N] {
        let mut lanes = [[0.0; LANES]; N];
        let (area, area_left) = self.area.as_chunks::<LANES>();
        let (factor, factor_left) = factor.as_chunks::<LANES>();
        let [(a, a_left), (b, b_left)] = self.lever.map(|l| l.as_chunks::<LANES>());
        for (((area, factor), a), b) in area.iter().zip(factor).zip(a).zip(b) {
            for lane in 0..LANES {
                let terms = of(area[lane] * factor[lane], a[lane], b[lane]);
                (0..N).for_each(|k| lanes[k][lane] += terms[k]);
            }
        }
        let mut sums = lanes.map(|sum| sum.iter().sum());
        for (((area, factor), a), b) in area_left.iter().zip(factor_left).zip(a_left).zip(b_left) {
            add_to(&mut sums, &of(area * factor, *a, *b));
        }
        sums
    }

    /// Strains of the springs: that of the axis, and those of the rotations times levers.
    #[inline]
    fn spread(&self, e: [f64; 3], out: &mut [f64]) {
        for ((out, a), b) in out.iter_mut().zip(self.lever[0]).zip(self.lever[1]) {
            *out = e[0] + a * e[1] + b * e[2];
        }
    }

    /// Moments of the springs, each with a factor.
    fn moments(&self, factor: &[f64]) -> Moments {
        let mut moments = self.sum(factor, |w, a, b| [w, w * a, w * b, w * a * a, w * a * b, w * b * b]);
        if let Some((axis, along)) = self.along(factor) {
            moments[PLACES[1 + axis][1 + axis]] += along;
        }
        moments
    }

    /// Force and moments of the springs under stresses.
    fn forces(&self, stress: &[f64]) -> [f64; 3] {
        self.sum(stress, |w, a, b| [w, w * a, w * b])
    }

    /// Moment of inertia that lines have along themselves, each with a factor, and about which of the levers.
    fn along(&self, factor: &[f64]) -> Option<(usize, f64)> {
        let (axis, square) = self.breadth?;
        Some((axis, self.area.iter().zip(square).zip(factor).map(|((w, s), f)| w * s * f).sum()))
    }
}

impl Bundle {
    /// Springs of a material with areas and levers, lines of them if they have a breadth, in blocks of which none goes
    /// beyond spring `cut`.
    pub(super) fn new(
        material: &Material,
        (area, lever): (Vec<f64>, [Vec<f64>; 2]),
        breadth: Option<Breadth>,
        cut: usize,
    ) -> Self {
        let n = area.len();
        let mut bundle = Self { area, lever, breadth, blocks: vec![], whole: None, virgin: vec![] };
        let ranges = [0..cut, cut..n].into_iter().flat_map(|part| {
            let end = part.end;
            part.step_by(BLOCK).map(move |first| first..(first + BLOCK).min(end))
        });
        let block = |springs: Range<usize>| {
            let weights = bundle.weights(&springs);
            let moments = weights.moments(&[1.0; BLOCK][..springs.len()]);
            let ends = |l: &[f64]| l.iter().fold([f64::MAX, f64::MIN], |[low, high], l| [low.min(*l), high.max(*l)]);
            Block { moments, levers: weights.lever.map(ends), springs }
        };
        let blocks: Vec<Block> = ranges.map(block).collect();
        let words = material.state_len();
        let mut virgin = vec![0.0; n * words];
        for b in &blocks {
            material.init_all(b.springs.len(), &mut virgin[b.springs.start * words..b.springs.end * words]);
        }
        bundle.whole = blocks.iter().cloned().reduce(Block::with);
        (bundle.blocks, bundle.virgin) = (blocks, virgin);
        bundle
    }

    /// Number of springs or lines.
    pub(super) fn len(&self) -> usize {
        self.area.len()
    }

    /// Areas and levers.
    pub(super) fn parts(&self) -> (&[f64], [&[f64]; 2]) {
        (&self.area, self.lever.each_ref().map(|l| &l[..]))
    }

    fn weights(&self, springs: &Range<usize>) -> Weights<'_> {
        Weights {
            area: &self.area[springs.clone()],
            lever: self.lever.each_ref().map(|l| &l[springs.clone()]),
            breadth: self.breadth.as_ref().map(|b| (b.axis, &b.square[springs.clone()])),
        }
    }

    /// Add the forces of a block, spring by spring.
    pub(super) fn respond(
        &self,
        material: &Material,
        block: &Block,
        at: &At,
        old: &[f64],
        next: &mut [f64],
        sum: &mut Sum,
    ) -> Result<(), MaterialError> {
        let n = block.springs.len();
        let weights = self.weights(&block.springs);
        let viscous = material.is_viscous();
        let (mut strains, mut rates, mut before) = ([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]);
        let (mut value, mut tangent, mut damping) = ([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]);
        weights.spread(at.strain, &mut strains[..n]);
        if viscous {
            weights.spread(at.rate, &mut rates[..n]);
        }
        let strains = Strains { value: &strains[..n], rate: &rates[..n], dt: at.dt };
        let mut stresses = Stresses { value: &mut value[..n], tangent: &mut tangent[..n], damping: &mut damping[..n] };
        match at.before {
            None => material.update_all(old, &strains, next, &mut stresses)?,
            Some(e) => {
                weights.spread(e, &mut before[..n]);
                material.update_all_on(old, &before[..n], &strains, next, &mut stresses)?;
            }
        }
        add_to(&mut sum.force, &weights.forces(&value[..n]));
        add_to(&mut sum.stiffness, &weights.moments(&tangent[..n]));
        if let Some((axis, along)) = weights.along(&tangent[..n]) {
            // What its ends are strained more or less than its middle.
            sum.force[1 + axis] += along * at.strain[1 + axis];
        }
        if viscous {
            add_to(&mut sum.damping, &weights.moments(&damping[..n]));
        }
        Ok(())
    }
}
