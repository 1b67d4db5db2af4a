//! A section of normal springs: axial force and bending of a laminated bearing.

use super::normal_layout::Layout;
use crate::material::{Material, MaterialError, Strains, Stresses};
use std::ops::Range;

/// Forces of a section and their derivatives: axial force, moment about y, moment about z.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Section {
    /// Forces.
    pub force: [f64; 3],
    /// Derivatives by the deformations.
    pub stiffness: [[f64; 3]; 3],
    /// Derivatives by the rates of the deformations, of viscous materials.
    pub damping: [[f64; 3]; 3],
}

/// From which histories springs go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Memory {
    /// From the committed ones.
    Committed,
    /// Also from those that the last call of the step left, as laws of OpenSees' do.
    Calls,
    /// The same, and those from this number on never commit: for them the virgin history is the committed one.
    Forgetful(usize),
}

/// Springs of one material over a section.
///
/// In the state of their owner lie first the strains of the section, then a word for each block of springs, then their
/// histories, block after block. The word is 1 while all springs of the block are virgin: most of them are, for most of the
/// time, and what is in proportion to the strain takes one product a block. The histories are then those of virgin springs,
/// whatever their words hold.
#[derive(Clone, Debug)]
pub struct NormalSprings {
    material: Material,
    at: usize,
    memory: Memory,
    /// Length of a spring, by which its extension becomes a strain.
    length: f64,
    /// Area of each, times its part in the distribution.
    area: Vec<f64>,
    /// Extension of each per unit of rotation about y and about z: its z, and its y with the other sign.
    lever: [Vec<f64>; 2],
    blocks: Vec<Block>,
    /// All springs: while none of them has a history, they are asked once for the whole section.
    whole: Option<Block>,
    /// Virgin histories.
    virgin: Vec<f64>,
}

/// Neighbouring springs that are updated together, and the moments of their areas.
#[derive(Clone, Debug)]
struct Block {
    springs: Range<usize>,
    moments: Moments,
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
    fn range(&self, [axial, a, b]: [f64; 3]) -> [f64; 2] {
        let [a, b] = [self.levers[0].map(|l| l * a), self.levers[1].map(|l| l * b)];
        [axial + a[0].min(a[1]) + b[0].min(b[1]), axial + a[0].max(a[1]) + b[0].max(b[1])]
    }
}

/// The word of a block of virgin springs.
const VIRGIN: f64 = 1.0;

/// Largest number of springs of a block, so that their stresses stay on the stack.
const BLOCK: usize = 64;
/// Sums that are taken side by side.
const LANES: usize = 4;
/// Strains of a section.
const STRAINS: usize = 3;

/// Products of a weight with 1, the levers a and b, a², a b and b², summed over springs.
type Moments = [f64; 6];

/// Rows and columns of a symmetric matrix of moments.
const PLACES: [[usize; 3]; 3] = [[0, 1, 2], [1, 3, 4], [2, 4, 5]];

/// What springs with neighbouring numbers weigh, and their levers.
struct Weights<'a> {
    area: &'a [f64],
    lever: [&'a [f64]; 2],
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
        self.sum(factor, |w, a, b| [w, w * a, w * b, w * a * a, w * a * b, w * b * b])
    }

    /// Force and moments of the springs under stresses.
    fn forces(&self, stress: &[f64]) -> [f64; 3] {
        self.sum(stress, |w, a, b| [w, w * a, w * b])
    }
}

impl NormalSprings {
    /// Springs of a layout, of this length, with their histories from word `at` on.
    pub fn new(material: Material, layout: &Layout, length: f64, at: usize) -> Self {
        let lever = [layout.z.clone(), layout.y.iter().map(|y| -y).collect()];
        let springs = Self {
            material,
            at,
            memory: Memory::Committed,
            length,
            area: layout.area.clone(),
            lever,
            blocks: vec![],
            whole: None,
            virgin: vec![],
        };
        springs.divided(layout.area.len())
    }

    /// The same springs in blocks, of which none goes beyond spring `cut`.
    fn divided(mut self, cut: usize) -> Self {
        let block = |springs: Range<usize>| {
            let weights = self.weights(&springs);
            let moments = weights.moments(&[1.0; BLOCK][..springs.len()]);
            let ends = |l: &[f64]| l.iter().fold([f64::MAX, f64::MIN], |[low, high], l| [low.min(*l), high.max(*l)]);
            Block { moments, levers: weights.lever.map(ends), springs }
        };
        let parts = [0..cut, cut..self.len()];
        let ranges = parts.into_iter().flat_map(|part| {
            let end = part.end;
            part.step_by(BLOCK).map(move |first| first..(first + BLOCK).min(end))
        });
        let blocks = ranges.map(block).collect();
        self.blocks = blocks;
        self.whole = self.blocks.iter().cloned().reduce(Block::with);
        let mut virgin = vec![0.0; self.len() * self.material.state_len()];
        self.blocks.iter().for_each(|b| self.material.init_all(b.springs.len(), &mut virgin[self.places(&b.springs)]));
        self.virgin = virgin;
        self
    }

    fn weights(&self, springs: &Range<usize>) -> Weights<'_> {
        Weights { area: &self.area[springs.clone()], lever: self.lever.each_ref().map(|l| &l[springs.clone()]) }
    }

    /// The same springs with their histories from word `at` on.
    pub fn at(self, at: usize) -> Self {
        Self { at, ..self }
    }

    /// The same springs, asked by an element that counts its calls.
    pub fn counting_calls(self) -> Self {
        Self { memory: Memory::Calls, ..self }
    }

    /// The same, of which only the first `n` commit their histories.
    pub fn remembering(self, n: usize) -> Self {
        let n = n.min(self.len());
        Self { memory: Memory::Forgetful(n), ..self.divided(n) }
    }

    /// Number of springs.
    pub fn len(&self) -> usize {
        self.area.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of words that they take.
    pub fn state_len(&self) -> usize {
        STRAINS + self.blocks.len() + self.len() * self.material.state_len()
    }

    /// Their material.
    pub fn material(&self) -> &Material {
        &self.material
    }

    /// Words of the state: strains of the section, whether each block is virgin, histories.
    fn words<'a>(&self, state: &'a [f64]) -> (&'a [f64], &'a [f64], &'a [f64]) {
        let (strain, rest) = state[self.at..self.at + self.state_len()].split_at(STRAINS);
        let (virgin, histories) = rest.split_at(self.blocks.len());
        (strain, virgin, histories)
    }

    fn words_mut<'a>(&self, state: &'a mut [f64]) -> (&'a mut [f64], &'a mut [f64], &'a mut [f64]) {
        let (strain, rest) = state[self.at..self.at + self.state_len()].split_at_mut(STRAINS);
        let (virgin, histories) = rest.split_at_mut(self.blocks.len());
        (strain, virgin, histories)
    }

    /// Write the virgin state.
    pub fn init(&self, state: &mut [f64]) {
        let (strain, virgin, histories) = self.words_mut(state);
        strain.fill(0.0);
        virgin.fill(VIRGIN);
        histories.copy_from_slice(&self.virgin);
    }

    /// Take over their histories of a trial state.
    pub fn commit(&self, trial: &[f64], committed: &mut [f64]) {
        let (strain, virgin, histories) = self.words(trial);
        let (to_strain, to_virgin, to) = self.words_mut(committed);
        to_strain.copy_from_slice(strain);
        to_virgin.copy_from_slice(virgin);
        for (Block { springs, .. }, _) in self.blocks.iter().zip(virgin).filter(|(_, v)| **v != VIRGIN) {
            let places = self.places(springs);
            to[places.clone()].copy_from_slice(&histories[places]);
        }
    }

    /// Where the histories of a block lie among all.
    fn places(&self, springs: &Range<usize>) -> Range<usize> {
        let words = self.material.state_len();
        springs.start * words..springs.end * words
    }

    /// Forces at deformations: extension, rotations about y and z; with the rates of these.
    pub fn respond(
        &self,
        committed: &[f64],
        deformation: [f64; 3],
        rate: [f64; 3],
        dt: f64,
        trial: &mut [f64],
    ) -> Result<Section, MaterialError> {
        let [strain, rate] = [deformation, rate].map(|e| e.map(|e| e / self.length));
        let (before, virgin_before, old) = self.words(committed);
        let (now, virgin, next) = self.words_mut(trial);
        now.copy_from_slice(&strain);
        let section = At { before: [before[0], before[1], before[2]], strain, rate, dt };
        // What is in proportion to the strains, and the rest.
        let (mut straight, mut sum) = ([0.0; 6], Sum::default());
        let from = if self.memory == Memory::Committed { virgin_before } else { &*virgin };
        let whole = self.whole.as_ref().filter(|_| from.iter().all(|word| *word == VIRGIN));
        let whole = whole.and_then(|all| Some((all, self.material.virgin_tangent(all.range(strain))?)));
        if let Some((all, tangent)) = whole {
            straight = all.moments.map(|m| tangent * m);
            virgin.fill(VIRGIN);
        }
        let blocks = if whole.is_some() { &[] } else { &self.blocks[..] };
        for ((block, virgin), virgin_before) in blocks.iter().zip(virgin).zip(virgin_before) {
            let from = if self.memory == Memory::Committed { *virgin_before } else { *virgin };
            let tangent = if from == VIRGIN { self.material.virgin_tangent(block.range(strain)) } else { None };
            if let Some(tangent) = tangent {
                add_to(&mut straight, &block.moments.map(|m| tangent * m));
                *virgin = VIRGIN;
                continue;
            }
            let places = self.places(&block.springs);
            let (next, fresh) = (&mut next[places.clone()], &self.virgin[places.clone()]);
            if *virgin == VIRGIN {
                next.copy_from_slice(fresh);
            }
            let forgets = matches!(self.memory, Memory::Forgetful(cut) if block.springs.start >= cut);
            let old = if forgets || *virgin_before == VIRGIN { fresh } else { &old[places] };
            let at = if forgets { At { before: [0.0; 3], ..section } } else { section };
            self.respond_block(block, &at, old, next, &mut sum)?;
            *virgin = if self.material.are_virgin(next) { VIRGIN } else { 0.0 };
        }
        let mut force = sum.force;
        for (f, row) in force.iter_mut().zip(PLACES) {
            *f += row.iter().zip(strain).map(|(&place, e)| straight[place] * e).sum::<f64>();
        }
        add_to(&mut sum.stiffness, &straight);
        Ok(Section { force, stiffness: self.matrix(sum.stiffness), damping: self.matrix(sum.damping) })
    }

    /// Add the forces of a block, spring by spring.
    fn respond_block(
        &self,
        block: &Block,
        at: &At,
        old: &[f64],
        next: &mut [f64],
        sum: &mut Sum,
    ) -> Result<(), MaterialError> {
        let n = block.springs.len();
        let weights = self.weights(&block.springs);
        let viscous = self.material.is_viscous();
        let (mut strains, mut rates, mut before) = ([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]);
        let (mut value, mut tangent, mut damping) = ([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]);
        weights.spread(at.strain, &mut strains[..n]);
        if viscous {
            weights.spread(at.rate, &mut rates[..n]);
        }
        let strains = Strains { value: &strains[..n], rate: &rates[..n], dt: at.dt };
        let mut stresses = Stresses { value: &mut value[..n], tangent: &mut tangent[..n], damping: &mut damping[..n] };
        if self.memory == Memory::Committed {
            self.material.update_all(old, &strains, next, &mut stresses)?;
        } else {
            weights.spread(at.before, &mut before[..n]);
            self.material.update_all_on(old, &before[..n], &strains, next, &mut stresses)?;
        }
        add_to(&mut sum.force, &weights.forces(&value[..n]));
        add_to(&mut sum.stiffness, &weights.moments(&tangent[..n]));
        if viscous {
            add_to(&mut sum.damping, &weights.moments(&damping[..n]));
        }
        Ok(())
    }

    /// Stiffness of the virgin section.
    pub fn initial_stiffness(&self) -> [[f64; 3]; 3] {
        let e = self.material.initial_tangent();
        let mut moments = [0.0; 6];
        self.blocks.iter().for_each(|block| add_to(&mut moments, &block.moments));
        self.matrix(moments.map(|m| e * m))
    }

    /// Matrix of moments, by the length of the springs.
    fn matrix(&self, moments: Moments) -> [[f64; 3]; 3] {
        PLACES.map(|row| row.map(|place| moments[place] / self.length))
    }
}

/// Strains of a section, those of its committed state, and their rates.
#[derive(Clone, Copy)]
struct At {
    before: [f64; 3],
    strain: [f64; 3],
    rate: [f64; 3],
    dt: f64,
}

/// Forces and moments of springs.
#[derive(Default)]
struct Sum {
    force: [f64; 3],
    stiffness: Moments,
    damping: Moments,
}

fn add_to<const N: usize>(sums: &mut [f64; N], terms: &[f64; N]) {
    sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
}
