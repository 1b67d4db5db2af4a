//! Fiber sections.

use super::{Resultant, Section, SharedSection};
use crate::material::{Material, MaterialError, Slot, Strain, Strains, Stresses};
use crate::probe::Probe;
use std::ops::Range;
use std::sync::Arc;

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

/// Fibers with the strains of a plane section: ε = ε₀ - y κ_z + z κ_y, with y and z from the centroid of the areas.
/// Torsion is uncoupled in space.
///
/// The history holds strain, stress, tangent and energy of all fibers, one quantity after the other. The variables of
/// the laws follow, run after run, and then those of the torsion.
#[derive(Clone, Debug)]
pub struct FiberSection {
    fibers: Vec<PlacedFiber>,
    runs: Vec<FiberRun>,
    torsion: Option<Slot>,
    /// Bending about both axes.
    biaxial: bool,
    /// Reference point of bending, y and z.
    centroid: (f64, f64),
    state_len: usize,
}

#[derive(Clone, Debug)]
struct PlacedFiber {
    y: f64,
    z: f64,
    area: f64,
    /// Derivatives of the strain with respect to the deformations P, Mz and My.
    strain_gradient: [f64; 3],
    /// Index of the run.
    run: usize,
}

/// Consecutive fibers of the same material, evaluated in one dynamic call.
#[derive(Clone, Debug)]
struct FiberRun {
    /// The material with the slot of a single fiber.
    slot: Slot,
    /// Range of fibers.
    fibers: Range<usize>,
    /// Offset of the laws' state variables.
    at: usize,
}

/// Maximum number of fibers of a run; sizes a buffer on the stack.
const MAX_RUN_LENGTH: usize = 128;
/// Strain rates of fibers; zero, as in OpenSees.
const NO_RATE: [f64; MAX_RUN_LENGTH] = [0.0; MAX_RUN_LENGTH];
/// State variables of a fiber in front of those of its law.
const FIBER_HEADER: usize = 4;

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

impl FiberRun {
    /// Range of the laws' state variables.
    fn words(&self) -> Range<usize> {
        self.at..self.at + self.fibers.len() * self.slot.material.state_len()
    }
}

impl PlacedFiber {
    /// Adds the fiber's force and stiffness.
    #[inline]
    fn add<const M: usize>(&self, stress: f64, tangent: f64, force: &mut [f64; M], stiffness: &mut [[f64; M]; M]) {
        for i in 0..M {
            force[i] += self.strain_gradient[i] * stress * self.area;
            let row = tangent * self.area * self.strain_gradient[i];
            (0..M).for_each(|j| stiffness[i][j] += row * self.strain_gradient[j]);
        }
    }
}

const FIBER: u32 = 1;
const FIBER_DATA: u32 = 2;
const CENTROID: u32 = 3;
const TORSION: u32 = 4;
const ENERGY: u32 = 5;

const PLANE: [Resultant; 2] = [Resultant::P, Resultant::Mz];
const SPACE: [Resultant; 4] = [Resultant::P, Resultant::Mz, Resultant::My, Resultant::T];

impl FiberSection {
    /// From fibers, and in space a material for the torsion with its tag. Bending is about the centroid of the areas,
    /// or with `origin` about the origin of the coordinates.
    pub fn new(fibers: Vec<Fiber>, torsion: Option<(Material, i32)>, origin: bool) -> Self {
        let area: f64 = fibers.iter().map(|f| f.area).sum();
        let mean = |x: fn(&Fiber) -> f64| fibers.iter().map(|f| f.area * x(f)).sum::<f64>() / area;
        let centroid = if origin || area == 0.0 { (0.0, 0.0) } else { (mean(|f| f.y), mean(|f| f.z)) };
        let mut runs: Vec<FiberRun> = vec![];
        let mut at = 0;
        let mut placed = vec![];
        for (i, f) in fibers.into_iter().enumerate() {
            let (material, tag) = f.material;
            match runs.last_mut() {
                Some(r)
                    if r.fibers.len() < MAX_RUN_LENGTH
                        && r.slot.tag == tag
                        && Arc::ptr_eq(&r.slot.material, &material) =>
                {
                    r.fibers.end = i + 1;
                }
                _ => runs.push(FiberRun { slot: Slot::new(material, tag, 0), fibers: i..i + 1, at }),
            }
            at = runs.last().map_or(0, |r| r.words().end);
            let strain_gradient = [1.0, -(f.y - centroid.0), f.z - centroid.1];
            placed.push(PlacedFiber { y: f.y, z: f.z, area: f.area, strain_gradient, run: runs.len() - 1 });
        }
        at += FIBER_HEADER * placed.len();
        let torsion = torsion.map(|(material, tag)| Slot::new(material, tag, at));
        let state_len = at + torsion.as_ref().map_or(0, Slot::len);
        let biaxial = torsion.is_some();
        Self { fibers: placed, runs, torsion, biaxial, centroid, state_len }
    }

    /// The section bent about both axes, also without torsion.
    pub fn bent_about_both_axes(self) -> Self {
        Self { biaxial: true, ..self }
    }

    /// Evaluates the fibers at `M` section deformations and integrates stresses and tangents.
    fn integrate<const M: usize>(
        &self,
        committed: &[f64],
        e: &[f64],
        dt: f64,
        next: &mut [f64],
        (s, k): (&mut [f64], &mut [f64]),
    ) -> Result<(), MaterialError> {
        let e: [f64; M] = std::array::from_fn(|i| e[i]);
        let (old, new) = (Parts::of(committed, self.fibers.len()), Parts::of_mut(next, self.fibers.len()));
        let mut damping = NO_RATE;
        for run in &self.runs {
            let (range, words) = (run.fibers.clone(), run.words());
            for (value, f) in new.strain[range.clone()].iter_mut().zip(&self.fibers[range.clone()]) {
                *value = (0..M).map(|i| f.strain_gradient[i] * e[i]).sum();
            }
            let n = range.len();
            let strains = Strains { value: &new.strain[range.clone()], rate: &NO_RATE[..n], dt };
            let mut stresses = Stresses {
                value: &mut new.stress[range.clone()],
                tangent: &mut new.tangent[range],
                damping: &mut damping[..n],
            };
            run.slot.material.update_all(&old.laws[words.clone()], &strains, &mut new.laws[words], &mut stresses)?;
        }
        let (mut force, mut stiffness) = ([0.0; M], [[0.0; M]; M]);
        for (i, f) in self.fibers.iter().enumerate() {
            f.add(new.stress[i], new.tangent[i], &mut force, &mut stiffness);
            let work = 0.5 * (old.stress[i] + new.stress[i]) * (new.strain[i] - old.strain[i]);
            new.energy[i] = old.energy[i] + work;
        }
        let n = self.resultants().len();
        s[..M].copy_from_slice(&force);
        stiffness.iter().zip(k.chunks_exact_mut(n)).for_each(|(row, k)| k[..M].copy_from_slice(row));
        Ok(())
    }

    /// Adds up the stiffness of the virgin fibers.
    fn virgin<const M: usize>(&self, k: &mut [f64]) {
        let (mut force, mut stiffness) = ([0.0; M], [[0.0; M]; M]);
        for f in &self.fibers {
            let tangent = self.runs[f.run].slot.material.initial_tangent();
            f.add(0.0, tangent, &mut force, &mut stiffness);
        }
        let n = self.resultants().len();
        stiffness.iter().zip(k.chunks_exact_mut(n)).for_each(|(row, k)| k[..M].copy_from_slice(row));
    }

    /// Fiber selected by the words of a recorder, and the words after them. The selection is an index, or coordinates
    /// with an optional material tag.
    fn find<'a, 'b>(&self, words: &'a [&'b str]) -> Option<(usize, &'a [&'b str])> {
        let number = |w: &str| w.parse::<f64>().ok();
        let y = number(words.first()?)?;
        let Some(z) = words.get(1).and_then(|w| number(w)) else {
            return Some((y as usize, &words[1..])).filter(|f| f.0 < self.fibers.len());
        };
        let (tag, rest) = match words.get(2).and_then(|w| w.parse::<i32>().ok()) {
            Some(tag) => (Some(tag), &words[3..]),
            None => (None, &words[2..]),
        };
        // The z coordinate does not count in a plane section.
        let distance = |f: &PlacedFiber| (f.y - y).powi(2) + if self.biaxial { (f.z - z).powi(2) } else { 0.0 };
        let has_tag = |f: &PlacedFiber| tag.is_none_or(|t| self.runs[f.run].slot.tag == t);
        let candidates = self.fibers.iter().enumerate().filter(|(_, f)| has_tag(f));
        let nearest = candidates.min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)))?;
        Some((nearest.0, rest))
    }

    /// Materials of the fibers and of the torsion.
    fn slots(&self) -> impl Iterator<Item = &Slot> {
        self.runs.iter().map(|r| &r.slot).chain(&self.torsion)
    }

    /// Value of a probe of a fiber, through the state layout of a single fiber.
    fn read_fiber(&self, i: usize, path: &[u32], state: &[f64], out: &mut [f64]) {
        let (parts, run) = (Parts::of(state, self.fibers.len()), &self.runs[self.fibers[i].run]);
        let mut words = vec![0.0; run.slot.len()];
        let header =
            run.slot.write_header(&mut words, [parts.strain[i], parts.stress[i], parts.tangent[i], parts.energy[i]]);
        // A run stores histories in the layout of the material, which only the material can copy.
        let from = (&parts.laws[run.words()], i - run.fibers.start, run.fibers.len());
        run.slot.material.copy_history(from, (&mut words[header..], 0, 1));
        run.slot.read(path, &words, out);
    }
}

impl Section for FiberSection {
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
        let parts = Parts::of_mut(state, self.fibers.len());
        for run in &self.runs {
            run.slot.material.init_all(run.fibers.len(), &mut parts.laws[run.words()]);
            parts.tangent[run.fibers.clone()].fill(run.slot.material.initial_tangent());
        }
        self.torsion.iter().for_each(|t| t.init(state));
    }
    fn is_linear(&self) -> bool {
        self.slots().all(|s| s.material.is_linear())
    }
    fn depends_on_time(&self) -> bool {
        self.slots().any(|s| s.material.depends_on_time())
    }

    fn update(
        &self,
        committed: &[f64],
        e: &[f64],
        dt: f64,
        next: &mut [f64],
        s: &mut [f64],
        k: &mut [f64],
    ) -> Result<(), MaterialError> {
        if !self.biaxial {
            return self.integrate::<2>(committed, e, dt, next, (s, k));
        }
        self.integrate::<3>(committed, e, dt, next, (&mut *s, &mut *k))?;
        if let Some(torsion) = &self.torsion {
            let stress = torsion.update(committed, Strain { value: e[3], rate: 0.0, dt }, next)?;
            (s[3], k[15]) = (stress.value, stress.tangent);
        }
        Ok(())
    }

    fn initial_stiffness(&self, k: &mut [f64]) {
        if !self.biaxial {
            return self.virgin::<2>(k);
        }
        self.virgin::<3>(k);
        if let Some(torsion) = &self.torsion {
            k[15] = torsion.material.initial_tangent();
        }
    }

    /// Applies to one material by its tag, or to all that have the parameter.
    fn with_parameter(&self, words: &[&str], value: f64) -> Option<(SharedSection, f64)> {
        let mut new = self.clone();
        let (tag, rest) = match words {
            ["material", tag, rest @ ..] => (Some(tag.parse::<i32>().ok()?), rest),
            _ => (None, words),
        };
        let chosen = new.runs.iter_mut().map(|r| &mut r.slot).filter(|s| tag.is_none_or(|t| s.tag == t));
        let old = chosen.filter_map(|s| s.set_parameter(rest, value)).last()?;
        Some((Arc::new(new), old))
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
            "centroid" => Some(Probe::new(CENTROID, ["y", "z"])),
            "torsion" => Some(self.torsion.as_ref()?.probe(&words[1..])?.inside(&[TORSION])),
            "energy" | "Energy" => Some(Probe::new(ENERGY, ["energy"])),
            _ => None,
        }
    }

    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        let parts = Parts::of(state, self.fibers.len());
        match path[0] {
            FIBER => self.read_fiber(path[1] as usize, &path[2..], state, out),
            FIBER_DATA => {
                for ((i, f), row) in self.fibers.iter().enumerate().zip(out.chunks_exact_mut(5)) {
                    row.copy_from_slice(&[f.y, f.z, f.area, parts.stress[i], parts.strain[i]]);
                }
            }
            CENTROID => out.copy_from_slice(&[self.centroid.0, self.centroid.1]),
            ENERGY => out[0] = self.fibers.iter().zip(parts.energy).map(|(f, e)| f.area * e).sum(),
            _ => {
                if let Some(t) = &self.torsion {
                    t.read(&path[1..], state, out);
                }
            }
        }
    }
}
