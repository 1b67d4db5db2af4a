//! A section of normal springs: axial force and bending of a laminated bearing.

mod bundle;
mod lines;

use self::bundle::{At, Bundle, PLACES, Sum, add_to};
use self::lines::Lines;
use crate::element::bearing::laws::normal_layout::Layout;
use crate::material::{Material, MaterialError};
use std::ops::Range;

/// Forces of a section with derivatives: axial force, moment about y, moment about z.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Section {
    /// Forces.
    pub force: [f64; 3],
    /// Derivatives by the deformations.
    pub stiffness: [[f64; 3]; 3],
    /// Derivatives by the rates of the deformations, for viscous materials.
    pub damping: [[f64; 3]; 3],
}

/// State from which springs are updated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Memory {
    /// The committed state.
    Committed,
    /// The committed state and that of the last call in the step, as for some of OpenSees' laws.
    Calls,
    /// As `Calls`, and springs from this number on never commit: their committed state is the virgin one.
    Forgetful(usize),
}

/// Extent of the state variables in a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kept {
    /// None: all springs are virgin.
    None,
    /// One set for each line with the same lever, the first or the second.
    Lines(usize),
    /// One set for each spring.
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

    /// Returns true if a state of this extent can be updated with the extent `next`.
    fn goes_on_as(self, next: Self) -> bool {
        self == Self::None || self == next
    }
}

/// Springs of one material over a section.
///
/// State variables of the owner are, in order: section strains; extent of the spring states; one flag per block of
/// springs; spring states by block. The flag is 1 while all springs of a block are virgin. Their response is then
/// proportional to the strain and takes one product a block. The stored values of such a block are unused; its state is
/// the virgin one.
///
/// While the section bends in one plane only, one state is stored for each line of springs normal to it.
#[derive(Clone, Debug)]
pub struct NormalSprings {
    material: Material,
    at: usize,
    memory: Memory,
    /// Length of a spring: strain is extension over length.
    length: f64,
    each: Bundle,
    lines: [Option<Lines>; 2],
    /// Largest size of each lever.
    reach: [f64; 2],
}

/// Flag of a block of virgin springs.
const VIRGIN: f64 = 1.0;

/// Number of section strains.
const STRAINS: usize = 3;

/// Parts of a state: section strains, extent of the spring states, flag of each block, spring states.
struct Words<T> {
    strain: T,
    kept: T,
    virgin: T,
    histories: T,
}

impl NormalSprings {
    /// Makes springs of a layout and a length, with state variables from index `at` on.
    pub fn new(material: Material, layout: &Layout, length: f64, at: usize) -> Self {
        let lever = [layout.z.clone(), layout.y.iter().map(|y| -y).collect()];
        let reach = lever.each_ref().map(|l| l.iter().fold(0.0f64, |m, l| m.max(l.abs())));
        let each = Bundle::new(&material, (layout.area.clone(), lever), None, layout.area.len());
        // Rates may vary along a line with constant strains.
        let lines = [0, 1].map(|across| if material.is_viscous() { None } else { Lines::of(&material, &each, across) });
        Self { material, at, memory: Memory::Committed, length, each, lines, reach }
    }

    /// Moves the state variables to index `at`.
    pub fn at(self, at: usize) -> Self {
        Self { at, ..self }
    }

    /// Marks the springs as part of an element that counts its calls.
    pub fn counting_calls(self) -> Self {
        Self { memory: Memory::Calls, ..self }
    }

    /// Lets only the first `n` springs commit their state.
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

    /// Returns true without springs.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of state variables.
    pub fn state_len(&self) -> usize {
        STRAINS + 1 + self.each.blocks.len() + self.each.virgin.len()
    }

    /// Material of the springs.
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

    /// Writes the virgin state variables.
    pub fn init(&self, state: &mut [f64]) {
        let w = self.words_mut(state);
        w.strain.fill(0.0);
        w.kept[0] = Kept::None.word();
        w.virgin.fill(VIRGIN);
        w.histories.copy_from_slice(&self.each.virgin);
    }

    /// The springs, or lines of them, with stored states.
    fn bundle(&self, kept: Kept) -> &Bundle {
        match kept {
            Kept::Lines(across) => self.lines[across].as_ref().map_or(&self.each, |l| &l.bundle),
            Kept::None | Kept::Each => &self.each,
        }
    }

    /// Copies the state variables of a trial state.
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

    /// Range of the state variables of a block.
    fn places(&self, springs: &Range<usize>) -> Range<usize> {
        let words = self.material.state_len();
        springs.start * words..springs.end * words
    }

    /// Extent of the states to store at section strains, after the committed state and the last call.
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

    /// States of all springs from those of lines; `None` unless `kept` is lines.
    fn spread(&self, kept: Kept, virgin: &[f64], histories: &[f64]) -> Option<Vec<f64>> {
        let Kept::Lines(across) = kept else { return None };
        let virgin: Vec<bool> = virgin.iter().map(|v| *v == VIRGIN).collect();
        Some(self.lines[across].as_ref()?.spread(&self.material, &self.each, &virgin, histories))
    }

    /// Forces at deformations (extension, rotations about y and z) and their rates.
    ///
    /// # Errors
    /// Errors of the material.
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
        // Springs that leave their line start from the state of the line.
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
        // Sums for springs proportional to their strain, and for the others.
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

    /// Section response from the tangent moments of proportional springs and the sums over the others.
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

    /// Section matrix from moments, divided by the length of the springs.
    fn matrix(&self, moments: [f64; 6]) -> [[f64; 3]; 3] {
        let [a, b, c, d, e, f] = moments.map(|m| m / self.length);
        [[a, b, c], [b, d, e], [c, e, f]]
    }
}
