//! Fiber sections.

mod joined;
mod points;
mod runs;

use super::nearest::{FiberPlace, select};
use super::plain_methods::plain_methods;
use super::{Resultant, Section, SectionStep, SharedSection};
use crate::material::{
    LimitCurve, Material, MaterialResult, ObservedColumns, Slot, Strain, Strains, Stresses, WatchesColumns,
};
use crate::numeric::lanes::BLOCK;
use crate::parameter::{Changed, NewValue, existing, last_of};
use crate::probe::Probe;
use points::Points;
use runs::{FiberRun, MAX_BLOCK_LENGTH, PlacedFiber, Placement, RunBlock};
use std::sync::Arc;

/// Strain rates of fibers; zero, as in OpenSees.
const NO_RATE: [f64; MAX_BLOCK_LENGTH] = [0.0; MAX_BLOCK_LENGTH];
/// State variables of a point in front of those of its law.
const POINT_HEADER: usize = 4;

/// Input of one fiber: coordinates, area, and material with its tag.
#[derive(Clone, Debug)]
pub struct Fiber {
    /// Local y.
    pub y: f64,
    /// Local z.
    pub z: f64,
    /// Area.
    pub area: f64,
    /// Material and its tag.
    pub material: (Material, i32),
}

/// Bending that a section of fibers resists.
#[derive(Clone, Debug)]
pub enum FiberBending {
    /// In a plane: fibers of one material at the same y have the same strain.
    Plane,
    /// In space, with a material for the torsion and its tag.
    Space(Option<(Material, i32)>),
}

/// Fibers with the strains of a plane section: ε = ε₀ - y κ_z + z κ_y, with y and z from the centroid of the areas.
/// Torsion is uncoupled in space.
///
/// Fibers of one material with the same strain share a point. Points of laws that are evaluated in blocks are padded by
/// points without an area. The history holds strain, stress, tangent and energy of
/// all points, one quantity after the other. The variables of the laws follow, block after block, and then those of the
/// torsion. Where all laws are linear, it holds only the deformations of the section in place of these, and the points have
/// what follows from them.
#[derive(Clone, Debug)]
pub struct FiberSection {
    fibers: Vec<PlacedFiber>,
    points: Points,
    /// Number of points that belong to a block; the padding follows.
    updated: usize,
    runs: Vec<FiberRun>,
    blocks: Vec<RunBlock>,
    /// All fibers are linear.
    linear: bool,
    /// Stiffness of the virgin fibers, by rows.
    virgin_stiffness: Vec<f64>,
    torsion: Option<Slot>,
    /// Bending about both axes.
    biaxial: bool,
    /// Reference point of bending, y and z.
    centroid: (f64, f64),
    state_len: usize,
}

/// Slices of a history.
struct Parts<T> {
    strain: T,
    stress: T,
    tangent: T,
    energy: T,
    /// State variables of the laws, and of the torsion.
    laws: T,
}

impl<'a> Parts<&'a [f64]> {
    fn of(state: &'a [f64], n: usize) -> Self {
        let (strain, rest) = state.split_at(n);
        let (stress, rest) = rest.split_at(n);
        let (tangent, rest) = rest.split_at(n);
        let (energy, laws) = rest.split_at(n);
        Self { strain, stress, tangent, energy, laws }
    }
}

impl<'a> Parts<&'a mut [f64]> {
    fn of_mut(state: &'a mut [f64], n: usize) -> Self {
        let (strain, rest) = state.split_at_mut(n);
        let (stress, rest) = rest.split_at_mut(n);
        let (tangent, rest) = rest.split_at_mut(n);
        let (energy, laws) = rest.split_at_mut(n);
        Self { strain, stress, tangent, energy, laws }
    }
}

const FIBER: u32 = 1;
const FIBER_DATA: u32 = 2;
const FIBER_DATA_2: u32 = 9;
const CENTROID: u32 = 3;
const TORSION: u32 = 4;
const ENERGY: u32 = 5;

const PLANE: [Resultant; 2] = [Resultant::P, Resultant::Mz];
const SPACE: [Resultant; 4] = [Resultant::P, Resultant::Mz, Resultant::My, Resultant::T];

impl FiberSection {
    /// From fibers. Bending is about the centroid of the areas, or with `origin` about the origin of the coordinates.
    pub fn new(fibers: Vec<Fiber>, bending: FiberBending, origin: bool) -> Self {
        let area: f64 = fibers.iter().map(|f| f.area).sum();
        let mean = |x: fn(&Fiber) -> f64| fibers.iter().map(|f| f.area * x(f)).sum::<f64>() / area;
        let centroid = if origin || area == 0.0 { (0.0, 0.0) } else { (mean(|f| f.y), mean(|f| f.z)) };
        let (biaxial, torsion) = match bending {
            FiberBending::Plane => (false, None),
            FiberBending::Space(torsion) => (true, torsion),
        };
        let Placement { placed, mut points, runs, blocks } = Placement::new(&fibers, centroid, biaxial);
        let updated = points.len();
        points.pad(updated, BLOCK);
        let is_linear = runs.iter().all(|r| r.slot.has_no_history());
        let words = blocks.last().map_or(0, |b| b.words(&runs).end) + POINT_HEADER * points.len();
        let at = if is_linear { if biaxial { 3 } else { 2 } } else { words };
        let torsion = torsion.map(|(material, tag)| Slot::new(material, tag, at));
        let state_len = at + torsion.as_ref().map_or(0, Slot::len);
        let mut section = Self {
            fibers: placed,
            points,
            updated,
            runs,
            blocks,
            linear: is_linear,
            virgin_stiffness: vec![],
            torsion,
            biaxial,
            centroid,
            state_len,
        };
        section.take_stiffness();
        section
    }

    /// Number of resultants of the fibers.
    fn fiber_order(&self) -> usize {
        if self.biaxial { 3 } else { 2 }
    }

    /// Keeps the stiffness of the virgin fibers.
    fn take_stiffness(&mut self) {
        let m = self.fiber_order();
        let mut k = vec![0.0; m * m];
        if self.biaxial {
            self.virgin::<3>(&mut k)
        } else {
            self.virgin::<2>(&mut k)
        }
        self.virgin_stiffness = k;
    }

    /// Strain, stress, tangent and energy of a point.
    fn header(&self, i: usize, state: &[f64]) -> [f64; POINT_HEADER] {
        if !self.linear {
            let parts = Parts::of(state, self.points.len());
            return [parts.strain[i], parts.stress[i], parts.tangent[i], parts.energy[i]];
        }
        let strain = self.points.strain(i, &state[..self.fiber_order()]);
        let of_point = |b: &&RunBlock| b.points.contains(&i);
        let tangent =
            self.blocks.iter().find(of_point).map_or(0.0, |b| self.runs[b.runs.start].slot.material.initial_tangent());
        [strain, tangent * strain, tangent, 0.5 * tangent * strain * strain]
    }

    /// Evaluates the fibers at `M` section deformations and integrates stresses and tangents.
    fn integrate<const M: usize>(&self, step: &mut SectionStep<'_>) -> MaterialResult {
        let SectionStep { committed, e, dt, next, s, k } = step;
        let n = self.points.len();
        if self.linear {
            let (rows, stiffness) = (self.resultants().len(), self.virgin_stiffness.chunks_exact(M));
            next[..M].copy_from_slice(&e[..M]);
            for ((s, k), own) in s.iter_mut().zip(k.chunks_exact_mut(rows)).zip(stiffness) {
                *s = own.iter().zip(*e).map(|(k, e)| k * e).sum();
                k[..M].copy_from_slice(own);
            }
            return Ok(());
        }
        let (old, mut new) = (Parts::of(committed, n), Parts::of_mut(next, n));
        self.strain::<M>(e, &mut new);
        self.blocks.iter().try_for_each(|block| self.update_block(block, &old, *dt, &mut new))?;
        self.sum::<M>(step);
        Ok(())
    }

    /// Writes the strains of the points for `M` section deformations, and zeros for those that belong to no block.
    fn strain<const M: usize>(&self, e: &[f64], new: &mut Parts<&mut [f64]>) {
        self.points.strains::<M>(e, new.strain);
        for padding in [&mut *new.stress, &mut *new.tangent] {
            padding[self.updated..].fill(0.0);
        }
    }

    /// Evaluates the points of a block.
    fn update_block(
        &self,
        block: &RunBlock,
        old: &Parts<&[f64]>,
        dt: f64,
        new: &mut Parts<&mut [f64]>,
    ) -> MaterialResult {
        let (range, words) = (block.points.clone(), block.words(&self.runs));
        let n = range.len();
        let strains = Strains { value: &new.strain[range.clone()], rate: &NO_RATE[..n], dt };
        let mut stresses = Stresses {
            value: &mut new.stress[range.clone()],
            tangent: &mut new.tangent[range],
            // A damping has no use in a section: the energies are written after it.
            damping: &mut new.energy[..n],
        };
        block.update(&self.runs, &old.laws[words.clone()], &strains, &mut new.laws[words], &mut stresses)
    }

    /// Adds up resultants and tangent, and writes the energies.
    fn sum<const M: usize>(&self, step: &mut SectionStep<'_>) {
        let n = self.points.len();
        let (old, new) = (Parts::of(step.committed, n), Parts::of_mut(step.next, n));
        let history = points::Work {
            strains: [old.strain, new.strain],
            stresses: [old.stress, new.stress],
            energies: (old.energy, new.energy),
        };
        let sums = self.points.integrate::<M>(new.tangent, history);
        sums.write(self.resultants().len(), step.s, step.k);
    }

    /// Adds the torsion in space.
    fn add_torsion(&self, step: &mut SectionStep<'_>) -> MaterialResult {
        if let Some(torsion) = &self.torsion {
            let strain = Strain { value: step.e[3], rate: 0.0, dt: step.dt };
            let stress = torsion.update(step.committed, strain, step.next)?;
            (step.s[3], step.k[15]) = (stress.value, stress.tangent);
        }
        Ok(())
    }

    /// Adds up the stiffness of the virgin fibers.
    fn virgin<const M: usize>(&self, k: &mut [f64]) {
        let n = self.points.len();
        let (zeros, mut tangent, mut energy) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
        self.runs.iter().for_each(|r| tangent[r.points.clone()].fill(r.slot.material.initial_tangent()));
        let history = points::Work { strains: [&zeros; 2], stresses: [&zeros; 2], energies: (&zeros, &mut energy) };
        let sums = self.points.integrate::<M>(&tangent, history);
        sums.write(M, &mut [0.0; M], k);
    }

    /// Fiber selected by the words of a recorder, and the words after them.
    fn find<'a, 'b>(&self, words: &'a [&'b str]) -> Option<(usize, &'a [&'b str])> {
        let place = |f: &PlacedFiber| FiberPlace { y: f.y, z: f.z, tag: self.runs[f.run].slot.tag };
        select(words, self.biaxial, self.fibers.iter().map(place))
    }

    /// Materials of the fibers and of the torsion.
    fn slots(&self) -> impl Iterator<Item = &Slot> {
        self.runs.iter().map(|r| &r.slot).chain(&self.torsion)
    }

    /// Value of a probe of a fiber, through the state layout of a single fiber.
    fn read_fiber(&self, i: usize, path: &[u32], state: &[f64], out: &mut [f64]) {
        let fiber = &self.fibers[i];
        let (run, i) = (&self.runs[fiber.run], fiber.point);
        let mut words = vec![0.0; run.slot.len()];
        let header = run.slot.write_header(&mut words, self.header(i, state));
        if !self.linear {
            // A block stores histories in the layout of the material, which only the material can copy.
            let (parts, block) = (Parts::of(state, self.points.len()), &self.blocks[run.block]);
            let from = (&parts.laws[block.words(&self.runs)], i - block.points.start, block.points.len());
            run.slot.material.copy_history(from, (&mut words[header..], 0, 1));
        }
        run.slot.read(path, &words, out);
    }
}

impl WatchesColumns for FiberSection {
    fn limit_curves(&self) -> Vec<&LimitCurve> {
        self.slots().flat_map(Slot::limit_curves).collect()
    }
    fn observe(&self, committed: &mut [f64], columns: &ObservedColumns<'_>) {
        if !self.linear {
            let parts = Parts::of_mut(committed, self.points.len());
            for block in &self.blocks {
                block.observe(&self.runs, &mut parts.laws[block.words(&self.runs)], columns);
            }
        }
        self.torsion.iter().for_each(|torsion| torsion.observe(committed, columns));
    }
}

#[deny(clippy::missing_trait_methods)]
impl Section for FiberSection {
    plain_methods! { elastic }
    fn class(&self) -> &'static str {
        if self.biaxial { "FiberSection3d" } else { "FiberSection2d" }
    }
    fn resultants(&self) -> &[Resultant] {
        match (self.biaxial, &self.torsion) {
            (false, _) => &PLANE,
            (true, None) => &SPACE[..3],
            (true, Some(_)) => &SPACE,
        }
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        state.fill(0.0);
        if !self.linear {
            let parts = Parts::of_mut(state, self.points.len());
            for block in &self.blocks {
                block.init(&self.runs, &mut parts.laws[block.words(&self.runs)]);
                parts.tangent[block.points.clone()].fill(self.runs[block.runs.start].slot.material.initial_tangent());
            }
        }
        self.torsion.iter().for_each(|t| t.init(state));
    }
    fn is_linear(&self) -> bool {
        self.slots().all(|s| s.material.is_linear())
    }
    fn depends_on_time(&self) -> bool {
        self.slots().any(|s| s.material.depends_on_time())
    }

    fn update(&self, mut step: SectionStep<'_>) -> MaterialResult {
        if !self.biaxial {
            return self.integrate::<2>(&mut step);
        }
        self.integrate::<3>(&mut step)?;
        self.add_torsion(&mut step)
    }

    /// A section with blocks of a few points, which fill vectors together with those of other places.
    fn joined(&self) -> Option<&FiberSection> {
        let has_few = || self.blocks.iter().any(|b| b.is_few(&self.runs));
        (!self.linear && has_few()).then_some(self)
    }

    fn initial_stiffness(&self, k: &mut [f64]) {
        let (n, m) = (self.resultants().len(), self.fiber_order());
        k.chunks_exact_mut(n)
            .zip(self.virgin_stiffness.chunks_exact(m))
            .for_each(|(k, own)| k[..m].copy_from_slice(own));
        if let Some(torsion) = &self.torsion {
            k[15] = torsion.material.initial_tangent();
        }
    }

    /// Applies to one material by its tag, or to all that have the parameter.
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<SharedSection> {
        let mut new = self.clone();
        let (tag, rest) = match words {
            ["material", tag, rest @ ..] => (Some(existing(tag.parse::<i32>().ok())?), rest),
            _ => (None, words),
        };
        let chosen = new.runs.iter_mut().map(|r| &mut r.slot).filter(|s| tag.is_none_or(|t| s.tag == t));
        let old = last_of(chosen.map(|s| s.set_parameter(rest, value)))?;
        new.blocks.iter_mut().for_each(|b| b.renew(&new.runs));
        new.take_stiffness();
        Ok((Arc::new(new), old))
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match *words.first()? {
            "fiber" => {
                let (i, rest) = self.find(&words[1..])?;
                Some(self.runs[self.fibers[i].run].slot.probe(rest)?.inside(&[FIBER, i as u32]))
            }
            "fiberData" => {
                let columns = ["yCoord", "zCoord", "area", "stress", "strain"];
                Some(Probe::new(FIBER_DATA, self.fibers.iter().flat_map(|_| columns)))
            }
            // With the material of each fiber, as programs that draw sections ask for it.
            "fiberData2" => {
                let columns = ["yCoord", "zCoord", "area", "material", "stress", "strain"];
                Some(Probe::new(FIBER_DATA_2, self.fibers.iter().flat_map(|_| columns)))
            }
            "centroid" => Some(Probe::new(CENTROID, ["y", "z"])),
            "torsion" => Some(self.torsion.as_ref()?.probe(&words[1..])?.inside(&[TORSION])),
            "energy" | "Energy" => Some(Probe::new(ENERGY, ["energy"])),
            _ => None,
        }
    }

    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        match path[0] {
            FIBER => self.read_fiber(path[1] as usize, &path[2..], state, out),
            FIBER_DATA => {
                for (f, row) in self.fibers.iter().zip(out.chunks_exact_mut(5)) {
                    let [strain, stress, ..] = self.header(f.point, state);
                    row.copy_from_slice(&[f.y, f.z, f.area, stress, strain]);
                }
            }
            FIBER_DATA_2 => {
                for (f, row) in self.fibers.iter().zip(out.chunks_exact_mut(6)) {
                    let [strain, stress, ..] = self.header(f.point, state);
                    row.copy_from_slice(&[f.y, f.z, f.area, f64::from(self.runs[f.run].slot.tag), stress, strain]);
                }
            }
            CENTROID => out.copy_from_slice(&[self.centroid.0, self.centroid.1]),
            ENERGY => out[0] = self.fibers.iter().map(|f| f.area * self.header(f.point, state)[3]).sum(),
            _ => {
                if let Some(t) = &self.torsion {
                    t.read(&path[1..], state, out);
                }
            }
        }
    }
}
