//! A section of normal springs: axial force and bending of a laminated bearing.

mod bundle;
mod lines;

use self::bundle::{At, Bundle, PLACES, Sum, add_to};
use self::lines::Lines;
use crate::element::bearing::laws::normal_layout::Layout;
use crate::material::{Material, MaterialError};
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

/// Whose histories a state holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kept {
    /// Nobody's: all springs are virgin.
    None,
    /// Those of lines with the same lever, the first or the second.
    Lines(usize),
    /// Each spring's.
    Each,
}

impl Kept {
    fn of(word: f64) -> Self {
        match word {
            0.0 => Self::None,
            1.0 => Self::Lines(0),
            2.0 => Self::Lines(1),
            _ => Self::Each,
        }
    }

    fn word(self) -> f64 {
        match self {
            Self::None => 0.0,
            Self::Lines(across) => 1.0 + across as f64,
            Self::Each => 3.0,
        }
    }

    /// Whether a state can go on with histories kept so.
    fn goes_on_as(self, next: Self) -> bool {
        self == Self::None || self == next
    }
}

/// Springs of one material over a section.
///
/// In the state of their owner lie first the strains of the section, then whose histories are kept, then a word for each
/// block of springs, then their histories, block after block. The word is 1 while all springs of the block are virgin: most of
/// them are, for most of the time, and what is in proportion to the strain takes one product a block. The histories
/// are then those of virgin springs, whatever their words hold.
///
/// While the section has bent in one plane only, one history is kept for each line of springs across it.
#[derive(Clone, Debug)]
pub struct NormalSprings {
    material: Material,
    at: usize,
    memory: Memory,
    /// Length of a spring, by which its extension becomes a strain.
    length: f64,
    each: Bundle,
    lines: [Option<Lines>; 2],
    /// Largest of each lever.
    reach: [f64; 2],
}

/// The word of a block of virgin springs.
const VIRGIN: f64 = 1.0;

/// Strains of a section.
const STRAINS: usize = 3;

/// Words of a state: strains of the section, whose histories are kept, whether each block is virgin, histories.
struct Words<T> {
    strain: T,
    kept: T,
    virgin: T,
    histories: T,
}

impl NormalSprings {
    /// Springs of a layout, of this length, with their histories from word `at` on.
    pub fn new(material: Material, layout: &Layout, length: f64, at: usize) -> Self {
        let lever = [layout.z.clone(), layout.y.iter().map(|y| -y).collect()];
        let reach = lever.each_ref().map(|l| l.iter().fold(0.0f64, |m, l| m.max(l.abs())));
        let each = Bundle::new(&material, (layout.area.clone(), lever), None, layout.area.len());
        // Rates may differ along a line whose strains do not.
        let lines = [0, 1].map(|across| if material.is_viscous() { None } else { Lines::of(&material, &each, across) });
        Self { material, at, memory: Memory::Committed, length, each, lines, reach }
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
        let (area, lever) = self.each.parts();
        let parts = (area.to_vec(), lever.map(<[f64]>::to_vec));
        let each = Bundle::new(&self.material, parts, None, n);
        Self { memory: Memory::Forgetful(n), each, lines: [None, None], ..self }
    }

    /// Number of springs.
    pub fn len(&self) -> usize {
        self.each.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of words that they take.
    pub fn state_len(&self) -> usize {
        STRAINS + 1 + self.each.blocks.len() + self.each.virgin.len()
    }

    /// Their material.
    pub fn material(&self) -> &Material {
        &self.material
    }

    fn words<'a>(&self, state: &'a [f64]) -> Words<&'a [f64]> {
        let (strain, rest) = state[self.at..self.at + self.state_len()].split_at(STRAINS);
        let (kept, rest) = rest.split_at(1);
        let (virgin, histories) = rest.split_at(self.each.blocks.len());
        Words { strain, kept, virgin, histories }
    }

    fn words_mut<'a>(&self, state: &'a mut [f64]) -> Words<&'a mut [f64]> {
        let (strain, rest) = state[self.at..self.at + self.state_len()].split_at_mut(STRAINS);
        let (kept, rest) = rest.split_at_mut(1);
        let (virgin, histories) = rest.split_at_mut(self.each.blocks.len());
        Words { strain, kept, virgin, histories }
    }

    /// Write the virgin state.
    pub fn init(&self, state: &mut [f64]) {
        let w = self.words_mut(state);
        w.strain.fill(0.0);
        w.kept[0] = Kept::None.word();
        w.virgin.fill(VIRGIN);
        w.histories.copy_from_slice(&self.each.virgin);
    }

    /// The springs, or lines of them, whose histories are kept.
    fn bundle(&self, kept: Kept) -> &Bundle {
        match kept {
            Kept::Lines(across) => self.lines[across].as_ref().map_or(&self.each, |l| &l.bundle),
            Kept::None | Kept::Each => &self.each,
        }
    }

    /// Take over their histories of a trial state.
    pub fn commit(&self, trial: &[f64], committed: &mut [f64]) {
        let (from, to) = (self.words(trial), self.words_mut(committed));
        to.strain.copy_from_slice(from.strain);
        to.kept.copy_from_slice(from.kept);
        let kept = Kept::of(from.kept[0]);
        if kept == Kept::None {
            return;
        }
        to.virgin.copy_from_slice(from.virgin);
        for (block, _) in self.bundle(kept).blocks.iter().zip(from.virgin).filter(|(_, v)| **v != VIRGIN) {
            let places = self.places(&block.springs);
            to.histories[places.clone()].copy_from_slice(&from.histories[places]);
        }
    }

    /// Where the histories of a block lie among all.
    fn places(&self, springs: &Range<usize>) -> Range<usize> {
        let words = self.material.state_len();
        springs.start * words..springs.end * words
    }

    /// Whose histories are to be kept at strains, after those of the committed state and of the last call.
    fn keep(&self, before: Kept, last: Kept, strain: [f64; 3]) -> Kept {
        let turned = [strain[1].abs() * self.reach[0], strain[2].abs() * self.reach[1]];
        let largest = strain[0].abs() + turned[0] + turned[1];
        let lines = |across: usize| {
            let kept = Kept::Lines(across);
            let held = self.lines[across].as_ref().is_some_and(|l| l.hold(strain, largest));
            (held && before.goes_on_as(kept) && last.goes_on_as(kept)).then_some(kept)
        };
        let first = usize::from(turned[1] > turned[0]);
        lines(first).or_else(|| lines(1 - first)).unwrap_or(Kept::Each)
    }

    /// Histories of all springs from those of lines, if it is lines that are kept.
    fn spread(&self, kept: Kept, virgin: &[f64], histories: &[f64]) -> Option<Vec<f64>> {
        let Kept::Lines(across) = kept else { return None };
        let virgin: Vec<bool> = virgin.iter().map(|v| *v == VIRGIN).collect();
        Some(self.lines[across].as_ref()?.spread(&self.material, &self.each, &virgin, histories))
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
        let (old, new) = (self.words(committed), self.words_mut(trial));
        new.strain.copy_from_slice(&strain);
        let calls = self.memory != Memory::Committed;
        let before = calls.then(|| [old.strain[0], old.strain[1], old.strain[2]]);
        let at = At { before, strain, rate, dt };
        let kept_before = Kept::of(old.kept[0]);
        let kept_last = if calls { Kept::of(new.kept[0]) } else { Kept::None };
        let start = if calls { kept_last } else { kept_before };
        if let (Kept::None, Some(all)) = (start, &self.each.whole)
            && let Some(tangent) = self.material.virgin_tangent(all.range(strain))
        {
            new.kept[0] = Kept::None.word();
            return Ok(self.section(&all.moments.map(|m| tangent * m), Sum::default(), strain));
        }
        let kept = self.keep(kept_before, kept_last, strain);
        let bundle = self.bundle(kept);
        // Springs that no longer move as lines go on from the histories of their lines.
        let spread = if kept == Kept::Each { self.spread(kept_before, old.virgin, old.histories) } else { None };
        let histories = spread.as_deref().unwrap_or(old.histories);
        let was_virgin = |block: usize| kept_before == Kept::None || spread.is_none() && old.virgin[block] == VIRGIN;
        if Kept::of(new.kept[0]) != kept {
            let spread = if kept == Kept::Each { self.spread(kept_last, new.virgin, new.histories) } else { None };
            new.virgin.fill(if spread.is_some() { 0.0 } else { VIRGIN });
            if let Some(all) = spread {
                new.histories.copy_from_slice(&all);
            }
            new.kept[0] = kept.word();
        }
        // What is in proportion to the strains, and the rest.
        let (mut straight, mut sum) = ([0.0; 6], Sum::default());
        for (n, (block, virgin)) in bundle.blocks.iter().zip(&mut *new.virgin).enumerate() {
            let starts_virgin = if calls { *virgin == VIRGIN } else { was_virgin(n) };
            let tangent = if starts_virgin { self.material.virgin_tangent(block.range(strain)) } else { None };
            if let Some(tangent) = tangent {
                add_to(&mut straight, &block.moments.map(|m| tangent * m));
                *virgin = VIRGIN;
                continue;
            }
            let places = self.places(&block.springs);
            let (next, fresh) = (&mut new.histories[places.clone()], &bundle.virgin[places.clone()]);
            if *virgin == VIRGIN {
                next.copy_from_slice(fresh);
            }
            let forgets = matches!(self.memory, Memory::Forgetful(cut) if block.springs.start >= cut);
            let old = if forgets || was_virgin(n) { fresh } else { &histories[places] };
            let at = if forgets { At { before: Some([0.0; 3]), ..at } } else { at };
            bundle.respond(&self.material, block, &at, old, next, &mut sum)?;
            *virgin = if self.material.are_virgin(next) { VIRGIN } else { 0.0 };
        }
        if new.virgin[..bundle.blocks.len()].iter().all(|v| *v == VIRGIN) {
            new.kept[0] = Kept::None.word();
        }
        Ok(self.section(&straight, sum, strain))
    }

    /// Of the moments of the tangent where springs are in proportion to their strains, and the sums over the others.
    fn section(&self, straight: &[f64; 6], mut sum: Sum, strain: [f64; 3]) -> Section {
        let mut force = sum.force;
        for (f, row) in force.iter_mut().zip(PLACES) {
            *f += row.iter().zip(strain).map(|(&place, e)| straight[place] * e).sum::<f64>();
        }
        add_to(&mut sum.stiffness, straight);
        let viscous = self.material.is_viscous();
        let damping = if viscous { self.matrix(sum.damping) } else { [[0.0; 3]; 3] };
        Section { force, stiffness: self.matrix(sum.stiffness), damping }
    }

    /// Stiffness of the virgin section.
    pub fn initial_stiffness(&self) -> [[f64; 3]; 3] {
        let e = self.material.initial_tangent();
        let mut moments = [0.0; 6];
        self.each.blocks.iter().for_each(|block| add_to(&mut moments, &block.moments));
        self.matrix(moments.map(|m| e * m))
    }

    /// Matrix of moments, by the length of the springs.
    fn matrix(&self, moments: [f64; 6]) -> [[f64; 3]; 3] {
        let [a, b, c, d, e, f] = moments.map(|m| m / self.length);
        [[a, b, c], [b, d, e], [c, e, f]]
    }
}
