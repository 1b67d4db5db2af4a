//! Springs of a section that are evaluated individually.

use crate::material::{Material, MaterialError, Strains, Stresses};
use std::ops::Range;

/// Largest number of springs of a block: their stresses are on the stack.
pub(super) const BLOCK: usize = 64;
/// Number of partial sums for vectorisation.
const LANES: usize = 4;

/// Sums over springs of a weight times 1, the levers a and b, a², a b and b².
pub(super) type Moments = [f64; 6];

/// Indices of the moments in a symmetric 3 x 3 matrix.
pub(super) const MOMENT_INDICES: [[usize; 3]; 3] = [[0, 1, 2], [1, 3, 4], [2, 4, 5]];

pub(super) fn add_to<const N: usize>(sums: &mut [f64; N], terms: &[f64; N]) {
    sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
}

/// Springs, each of which may represent a line of springs.
#[derive(Clone, Debug)]
pub(super) struct Bundle {
    /// Area of each times its relative stiffness.
    area: Vec<f64>,
    /// Extension of each per unit rotation about y and about z: its z, and its -y.
    lever: [Vec<f64>; 2],
    breadth: Option<Breadth>,
    /// Neighbouring springs that are updated in one call.
    pub(super) blocks: Vec<Block>,
    /// All springs as one block: while all are virgin, one evaluation gives the section.
    pub(super) whole: Option<Block>,
    /// Virgin state variables.
    pub(super) virgin: Vec<f64>,
}

/// Extent of the lines on both sides of their middle.
#[derive(Clone, Debug)]
pub(super) struct Breadth {
    /// Index of the lever that varies along a line.
    pub(super) axis: usize,
    /// Mean square deviation of that lever, for each line.
    pub(super) square: Vec<f64>,
}

/// Neighbouring springs that are updated in one call, and the moments of their areas.
#[derive(Clone, Debug)]
pub(super) struct Block {
    pub(super) springs: Range<usize>,
    pub(super) moments: Moments,
    /// Smallest and largest value of each lever.
    levers: [[f64; 2]; 2],
}

impl Block {
    /// Union with the following block.
    fn with(mut self, next: Self) -> Self {
        add_to(&mut self.moments, &next.moments);
        for (all, own) in self.levers.iter_mut().zip(next.levers) {
            *all = [all[0].min(own[0]), all[1].max(own[1])];
        }
        Self { springs: self.springs.start..next.springs.end, ..self }
    }

    /// Bounds of the strains of the springs for section strains.
    pub(super) fn range(&self, [axial, a, b]: [f64; 3]) -> [f64; 2] {
        let [a, b] = [self.levers[0].map(|l| l * a), self.levers[1].map(|l| l * b)];
        [axial + a[0].min(a[1]) + b[0].min(b[1]), axial + a[0].max(a[1]) + b[0].max(b[1])]
    }
}

/// Section strains, their committed values if the material needs them, and their rates.
#[derive(Clone, Copy)]
pub(super) struct SectionStrains {
    pub(super) before: Option<[f64; 3]>,
    pub(super) strain: [f64; 3],
    pub(super) rate: [f64; 3],
    pub(super) dt: f64,
}

/// Sums of forces and moments over springs.
#[derive(Default)]
pub(super) struct Sum {
    pub(super) force: [f64; 3],
    pub(super) stiffness: Moments,
    pub(super) damping: Moments,
}

/// Weights, levers and line extents of neighbouring springs.
struct Weights<'a> {
    area: &'a [f64],
    lever: [&'a [f64]; 2],
    breadth: Option<(usize, &'a [f64])>,
}

impl Weights<'_> {
    /// Sums over the springs of area times `factor` times `of` the levers. Independent partial sums allow
    /// vectorisation.
    #[inline(always)]
    fn sum<const N: usize>(&self, factor: &[f64], of: impl Fn(f64, f64, f64) -> [f64; N]) -> [f64; N] {
        let mut lanes = [[0.0; LANES]; N];
        let (area, area_rest) = self.area.as_chunks::<LANES>();
        let (factor, factor_rest) = factor.as_chunks::<LANES>();
        let [(a, a_rest), (b, b_rest)] = self.lever.map(|l| l.as_chunks::<LANES>());
        for (((area, factor), a), b) in area.iter().zip(factor).zip(a).zip(b) {
            for lane in 0..LANES {
                let terms = of(area[lane] * factor[lane], a[lane], b[lane]);
                (0..N).for_each(|k| lanes[k][lane] += terms[k]);
            }
        }
        let mut sums = lanes.map(|sum| sum.iter().sum());
        for (((area, factor), a), b) in area_rest.iter().zip(factor_rest).zip(a_rest).zip(b_rest) {
            add_to(&mut sums, &of(area * factor, *a, *b));
        }
        sums
    }

    /// Strains of the springs: axial strain plus rotations times levers.
    #[inline]
    fn spread(&self, e: [f64; 3], out: &mut [f64]) {
        for ((out, a), b) in out.iter_mut().zip(self.lever[0]).zip(self.lever[1]) {
            *out = e[0] + a * e[1] + b * e[2];
        }
    }

    /// Moments of the springs, each multiplied by a factor.
    fn moments(&self, factor: &[f64]) -> Moments {
        let mut moments = self.sum(factor, |w, a, b| [w, w * a, w * b, w * a * a, w * a * b, w * b * b]);
        if let Some((axis, along)) = self.along(factor) {
            moments[MOMENT_INDICES[1 + axis][1 + axis]] += along;
        }
        moments
    }

    /// Force and moments of the springs for their stresses.
    fn forces(&self, stress: &[f64]) -> [f64; 3] {
        self.sum(stress, |w, a, b| [w, w * a, w * b])
    }

    /// Second moment of the lines about their middle, each multiplied by a factor, with the index of its lever.
    fn along(&self, factor: &[f64]) -> Option<(usize, f64)> {
        let (axis, square) = self.breadth?;
        Some((axis, self.area.iter().zip(square).zip(factor).map(|((w, s), f)| w * s * f).sum()))
    }
}

impl Bundle {
    /// Makes springs of a material with areas and levers, or lines of them with a breadth. No block extends beyond the
    /// spring `cut`.
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
        let state_len = material.state_len();
        let mut virgin = vec![0.0; n * state_len];
        for b in &blocks {
            material.init_all(b.springs.len(), &mut virgin[b.springs.start * state_len..b.springs.end * state_len]);
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

    /// Adds the forces of a block, evaluated spring by spring.
    pub(super) fn respond(
        &self,
        material: &Material,
        block: &Block,
        at: &SectionStrains,
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
        match at.before.and_then(|e| Some((material.roles().last_trial?, e))) {
            None => material.update_all(old, &strains, next, &mut stresses)?,
            Some((law, e)) => {
                weights.spread(e, &mut before[..n]);
                law.update_all_on(old, &before[..n], &strains, next, &mut stresses)?;
            }
        }
        add_to(&mut sum.force, &weights.forces(&value[..n]));
        add_to(&mut sum.stiffness, &weights.moments(&tangent[..n]));
        if let Some((axis, along)) = weights.along(&tangent[..n]) {
            // Moment of the linear strain variation along a line.
            sum.force[1 + axis] += along * at.strain[1 + axis];
        }
        if viscous {
            add_to(&mut sum.damping, &weights.moments(&damping[..n]));
        }
        Ok(())
    }
}
