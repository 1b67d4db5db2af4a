//! A section of normal springs: axial force and bending of a laminated bearing.

mod bundle;
mod lines;

use self::bundle::{Bundle, MOMENT_INDICES, SectionStrains, Sum, add_to};
use self::lines::Lines;
use crate::element::Histories;
use crate::element::bearing::laws::normal_layout::Layout;
use crate::material::{LimitCurve, Material, MaterialError, ObservedColumns, WatchesColumns, observe_points};
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
enum StartState {
    /// The committed state.
    Committed,
    /// The committed state and that of the last call in the step, as for some of OpenSees' laws.
    LastCall,
    /// As `LastCall`, and springs from this number on never commit: their committed state is the virgin one.
    PartialCommit(usize),
}

/// Extent of the state variables in a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum StoredStates {
    /// None: all springs are virgin.
    None,
    /// One set for each line with the same lever, the first or the second.
    Lines(usize),
    /// One set for each spring.
    Each,
}

impl StoredStates {
    fn of(flag: f64) -> Self {
        match flag {
            0.0 => Self::None,
            1.0 => Self::Lines(0),
            2.0 => Self::Lines(1),
            _ => Self::Each,
        }
    }

    fn flag(self) -> f64 {
        match self {
            Self::None => 0.0,
            Self::Lines(across) => 1.0 + across as f64,
            Self::Each => 3.0,
        }
    }

    /// Returns true if a state of this extent can be updated with the extent `next`.
    fn can_continue_as(self, next: Self) -> bool {
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
    start_state: StartState,
    /// Length of a spring: strain is extension over length.
    length: f64,
    each: Bundle,
    lines: [Option<Lines>; 2],
    /// Largest size of each lever.
    max_lever: [f64; 2],
}

/// Flag of a block of virgin springs.
const VIRGIN: f64 = 1.0;

/// Number of section strains.
const STRAINS: usize = 3;

/// Parts of a state: section strains, extent of the spring states, flag of each block, spring states.
struct StateParts<T> {
    strain: T,
    stored: T,
    virgin: T,
    states: T,
}

impl WatchesColumns for NormalSprings {
    fn limit_curves(&self) -> Vec<&LimitCurve> {
        self.material.limit_curves()
    }
    fn observe(&self, committed: &mut [f64], columns: &ObservedColumns<'_>) {
        let parts = self.parts_mut(committed);
        let stored = StoredStates::of(parts.stored[0]);
        if stored == StoredStates::None {
            return;
        }
        for (block, _) in self.bundle(stored).blocks.iter().zip(&*parts.virgin).filter(|(_, v)| **v != VIRGIN) {
            let range = self.state_range(&block.springs);
            observe_points(&self.material, block.springs.len(), &mut parts.states[range], columns);
        }
    }
}

impl NormalSprings {
    /// Makes springs of a layout and a length, with state variables from index `at` on.
    pub fn new(material: Material, layout: &Layout, length: f64, at: usize) -> Self {
        let lever = [layout.z.clone(), layout.y.iter().map(|y| -y).collect()];
        let max_lever = lever.each_ref().map(|l| l.iter().fold(0.0f64, |m, l| m.max(l.abs())));
        let each = Bundle::new(&material, (layout.area.clone(), lever), None, layout.area.len());
        // Rates may vary along a line with constant strains.
        let lines = [0, 1].map(|across| if material.is_viscous() { None } else { Lines::of(&material, &each, across) });
        Self { material, at, start_state: StartState::Committed, length, each, lines, max_lever }
    }

    /// Moves the state variables to index `at`.
    pub fn at(self, at: usize) -> Self {
        Self { at, ..self }
    }

    /// Marks the springs as part of an element that counts its calls.
    pub fn counting_calls(self) -> Self {
        Self { start_state: StartState::LastCall, ..self }
    }

    /// Lets only the first `n` springs commit their state.
    pub fn committing_first(self, n: usize) -> Self {
        let n = n.min(self.len());
        let (area, lever) = self.each.parts();
        let parts = (area.to_vec(), lever.map(<[f64]>::to_vec));
        let each = Bundle::new(&self.material, parts, None, n);
        Self { start_state: StartState::PartialCommit(n), each, lines: [None, None], ..self }
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

    fn parts<'a>(&self, state: &'a [f64]) -> StateParts<&'a [f64]> {
        let (strain, rest) = state[self.at..self.at + self.state_len()].split_at(STRAINS);
        let (stored, rest) = rest.split_at(1);
        let (virgin, states) = rest.split_at(self.each.blocks.len());
        StateParts { strain, stored, virgin, states }
    }

    fn parts_mut<'a>(&self, state: &'a mut [f64]) -> StateParts<&'a mut [f64]> {
        let (strain, rest) = state[self.at..self.at + self.state_len()].split_at_mut(STRAINS);
        let (stored, rest) = rest.split_at_mut(1);
        let (virgin, states) = rest.split_at_mut(self.each.blocks.len());
        StateParts { strain, stored, virgin, states }
    }

    /// Writes the virgin state variables.
    pub fn init(&self, state: &mut [f64]) {
        let w = self.parts_mut(state);
        w.strain.fill(0.0);
        w.stored[0] = StoredStates::None.flag();
        w.virgin.fill(VIRGIN);
        w.states.copy_from_slice(&self.each.virgin);
    }

    /// The springs, or lines of them, with stored states.
    fn bundle(&self, stored: StoredStates) -> &Bundle {
        match stored {
            StoredStates::Lines(across) => self.lines[across].as_ref().map_or(&self.each, |l| &l.bundle),
            StoredStates::None | StoredStates::Each => &self.each,
        }
    }

    /// Copies the state variables of a trial state.
    pub fn commit(&self, trial: &[f64], committed: &mut [f64]) {
        let (from, to) = (self.parts(trial), self.parts_mut(committed));
        to.strain.copy_from_slice(from.strain);
        to.stored.copy_from_slice(from.stored);
        let stored = StoredStates::of(from.stored[0]);
        if stored == StoredStates::None {
            return;
        }
        to.virgin.copy_from_slice(from.virgin);
        for (block, _) in self.bundle(stored).blocks.iter().zip(from.virgin).filter(|(_, v)| **v != VIRGIN) {
            let state_range = self.state_range(&block.springs);
            to.states[state_range.clone()].copy_from_slice(&from.states[state_range]);
        }
    }

    /// Range of the state variables of a block.
    fn state_range(&self, springs: &Range<usize>) -> Range<usize> {
        let len = self.material.state_len();
        springs.start * len..springs.end * len
    }

    /// Extent of the states to store at section strains, after the committed state and the last call.
    fn next_stored(&self, before: StoredStates, last: StoredStates, strain: [f64; 3]) -> StoredStates {
        let bending = [strain[1].abs() * self.max_lever[0], strain[2].abs() * self.max_lever[1]];
        let largest = strain[0].abs() + bending[0] + bending[1];
        let lines = |across: usize| {
            let stored = StoredStates::Lines(across);
            let equal_strains = self.lines[across].as_ref().is_some_and(|l| l.has_equal_strains(strain, largest));
            (equal_strains && before.can_continue_as(stored) && last.can_continue_as(stored)).then_some(stored)
        };
        let first = usize::from(bending[1] > bending[0]);
        lines(first).or_else(|| lines(1 - first)).unwrap_or(StoredStates::Each)
    }

    /// States of all springs from those of lines; `None` unless `stored` is lines.
    fn spread(&self, stored: StoredStates, virgin: &[f64], states: &[f64]) -> Option<Vec<f64>> {
        let StoredStates::Lines(across) = stored else { return None };
        let virgin: Vec<bool> = virgin.iter().map(|v| *v == VIRGIN).collect();
        Some(self.lines[across].as_ref()?.spread(&self.material, &self.each, &virgin, states))
    }

    /// Forces at deformations (extension, rotations about y and z) and their rates.
    ///
    /// # Errors
    /// Errors of the material.
    pub fn respond(
        &self,
        h: &mut Histories<'_>,
        deformation: [f64; 3],
        rate: [f64; 3],
        dt: f64,
    ) -> Result<Section, MaterialError> {
        let [strain, rate] = [deformation, rate].map(|e| e.map(|e| e / self.length));
        let virgin_points = self.material.roles().virgin;
        let (old, new) = (self.parts(h.committed), self.parts_mut(h.trial));
        new.strain.copy_from_slice(&strain);
        let calls = self.start_state != StartState::Committed;
        let before = calls.then(|| [old.strain[0], old.strain[1], old.strain[2]]);
        let at = SectionStrains { before, strain, rate, dt };
        let stored_committed = StoredStates::of(old.stored[0]);
        let stored_last = if calls { StoredStates::of(new.stored[0]) } else { StoredStates::None };
        let start = if calls { stored_last } else { stored_committed };
        if let (StoredStates::None, Some(all)) = (start, &self.each.whole)
            && let Some(tangent) = virgin_points.and_then(|law| law.virgin_tangent(all.range(strain)))
        {
            new.stored[0] = StoredStates::None.flag();
            return Ok(self.section(&all.moments.map(|m| tangent * m), Sum::default(), strain));
        }
        let stored = self.next_stored(stored_committed, stored_last, strain);
        let bundle = self.bundle(stored);
        // Springs that leave their line start from the state of the line.
        let spread =
            if stored == StoredStates::Each { self.spread(stored_committed, old.virgin, old.states) } else { None };
        let states = spread.as_deref().unwrap_or(old.states);
        let was_virgin =
            |block: usize| stored_committed == StoredStates::None || spread.is_none() && old.virgin[block] == VIRGIN;
        if StoredStates::of(new.stored[0]) != stored {
            let spread =
                if stored == StoredStates::Each { self.spread(stored_last, new.virgin, new.states) } else { None };
            new.virgin.fill(if spread.is_some() { 0.0 } else { VIRGIN });
            if let Some(all) = spread {
                new.states.copy_from_slice(&all);
            }
            new.stored[0] = stored.flag();
        }
        // Sums for springs proportional to their strain, and for the others.
        let (mut proportional, mut sum) = ([0.0; 6], Sum::default());
        for (n, (block, virgin)) in bundle.blocks.iter().zip(&mut *new.virgin).enumerate() {
            let starts_virgin = if calls { *virgin == VIRGIN } else { was_virgin(n) };
            if let Some(law) = virgin_points.filter(|_| starts_virgin)
                && let Some(tangent) = law.virgin_tangent(block.range(strain))
            {
                add_to(&mut proportional, &block.moments.map(|m| tangent * m));
                *virgin = VIRGIN;
                continue;
            }
            let state_range = self.state_range(&block.springs);
            let (next, virgin_state) = (&mut new.states[state_range.clone()], &bundle.virgin[state_range.clone()]);
            if *virgin == VIRGIN {
                next.copy_from_slice(virgin_state);
            }
            let never_commits =
                matches!(self.start_state, StartState::PartialCommit(cut) if block.springs.start >= cut);
            let old = if never_commits || was_virgin(n) { virgin_state } else { &states[state_range] };
            let at = if never_commits { SectionStrains { before: Some([0.0; 3]), ..at } } else { at };
            bundle.respond(&self.material, block, &at, old, next, &mut sum)?;
            *virgin = if virgin_points.is_some_and(|law| law.are_virgin(next)) { VIRGIN } else { 0.0 };
        }
        if new.virgin[..bundle.blocks.len()].iter().all(|v| *v == VIRGIN) {
            new.stored[0] = StoredStates::None.flag();
        }
        Ok(self.section(&proportional, sum, strain))
    }

    /// Section response from the tangent moments of proportional springs and the sums over the others.
    fn section(&self, proportional: &[f64; 6], mut sum: Sum, strain: [f64; 3]) -> Section {
        let mut force = sum.force;
        for (f, row) in force.iter_mut().zip(MOMENT_INDICES) {
            *f += row.iter().zip(strain).map(|(&place, e)| proportional[place] * e).sum::<f64>();
        }
        add_to(&mut sum.stiffness, proportional);
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
