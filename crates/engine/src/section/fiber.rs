//! Fiber sections.

mod points;

use super::{Resultant, Section, SharedSection};
use crate::material::{Material, MaterialError, Slot, Strain, Strains, Stresses};
use crate::numeric::lanes::BLOCK;
use crate::probe::Probe;
use points::Points;
use std::collections::HashMap;
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
/// all points, one quantity after the other. The variables of the laws follow, run after run, and then those of the
/// torsion.
#[derive(Clone, Debug)]
pub struct FiberSection {
    fibers: Vec<PlacedFiber>,
    points: Points,
    /// Number of points that belong to a run; the padding follows.
    updated: usize,
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
    /// Index of the point.
    point: usize,
    /// Index of the run.
    run: usize,
}

/// Consecutive points of the same material, evaluated in one dynamic call.
#[derive(Clone, Debug)]
struct FiberRun {
    /// The material with the slot of a single fiber.
    slot: Slot,
    /// Range of points.
    points: Range<usize>,
    /// Offset of the laws' state variables.
    at: usize,
}

/// Maximum number of points of a run; sizes a buffer on the stack.
const MAX_RUN_LENGTH: usize = 128;
/// Strain rates of fibers; zero, as in OpenSees.
const NO_RATE: [f64; MAX_RUN_LENGTH] = [0.0; MAX_RUN_LENGTH];
/// State variables of a point in front of those of its law.
const POINT_HEADER: usize = 4;
/// Distance of fibers that is round-off of their coordinates, as a part of the largest one.
const SAME_PLACE: f64 = 1e-14;

/// Fibers of each material in the order of their first fibers. Those of a material are in the order of y, then z in a
/// section that is bent about both axes.
fn groups(fibers: &[Fiber], biaxial: bool) -> Vec<(Material, i32, Vec<usize>)> {
    let mut groups: Vec<(Material, i32, Vec<usize>)> = vec![];
    let mut known = HashMap::new();
    for (i, f) in fibers.iter().enumerate() {
        let (material, tag) = &f.material;
        let group = *known.entry((*tag, Arc::as_ptr(material).cast::<()>())).or_insert_with(|| {
            groups.push((material.clone(), *tag, vec![]));
            groups.len() - 1
        });
        groups[group].2.push(i);
    }
    let place = |i: usize| (fibers[i].y, if biaxial { fibers[i].z } else { 0.0 });
    for (.., members) in &mut groups {
        members.sort_by(|a, b| {
            let ((y, z), (other_y, other_z)) = (place(*a), place(*b));
            y.total_cmp(&other_y).then(z.total_cmp(&other_z))
        });
    }
    groups
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

impl FiberRun {
    /// Range of the laws' state variables.
    fn words(&self) -> Range<usize> {
        self.at..self.at + self.points.len() * self.slot.material.state_len()
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
    /// From fibers. Bending is about the centroid of the areas, or with `origin` about the origin of the coordinates.
    pub fn new(fibers: Vec<Fiber>, bending: FiberBending, origin: bool) -> Self {
        let area: f64 = fibers.iter().map(|f| f.area).sum();
        let mean = |x: fn(&Fiber) -> f64| fibers.iter().map(|f| f.area * x(f)).sum::<f64>() / area;
        let centroid = if origin || area == 0.0 { (0.0, 0.0) } else { (mean(|f| f.y), mean(|f| f.z)) };
        let (biaxial, torsion) = match bending {
            FiberBending::Plane => (false, None),
            FiberBending::Space(torsion) => (true, torsion),
        };
        let mut placed: Vec<PlacedFiber> =
            fibers.iter().map(|f| PlacedFiber { y: f.y, z: f.z, area: f.area, point: 0, run: 0 }).collect();
        let (mut points, mut runs) = (Points::default(), Vec::<FiberRun>::new());
        let mut at = 0;
        for (material, tag, group) in groups(&fibers, biaxial) {
            let mut last: Option<&Fiber> = None;
            let largest = group.iter().map(|i| fibers[*i].y.abs().max(fibers[*i].z.abs())).fold(0.0, f64::max);
            for i in group {
                let f = &fibers[i];
                let near = |a: f64, b: f64| (a - b).abs() <= SAME_PLACE * largest;
                let shared = last.is_some_and(|l| near(l.y, f.y) && (!biaxial || near(l.z, f.z)));
                if shared {
                    points.enlarge(f.area);
                } else {
                    last = Some(f);
                    let n = points.push([-(f.y - centroid.0), f.z - centroid.1], f.area);
                    match runs.last_mut() {
                        Some(r)
                            if r.points.len() < MAX_RUN_LENGTH
                                && r.slot.tag == tag
                                && Arc::ptr_eq(&r.slot.material, &material) =>
                        {
                            r.points.end = n
                        }
                        _ => runs.push(FiberRun { slot: Slot::new(material.clone(), tag, 0), points: n - 1..n, at }),
                    }
                    at = runs.last().map_or(0, |r| r.words().end);
                }
                (placed[i].point, placed[i].run) = (points.len() - 1, runs.len() - 1);
            }
            // The padding of a law that is evaluated in blocks belongs to its run.
            let padded = points.pad(material.block_len().min(BLOCK));
            if let Some(run) = runs.last_mut() {
                run.points.end = padded;
                at = run.words().end;
            }
        }
        let updated = points.len();
        points.pad(BLOCK);
        at += POINT_HEADER * points.len();
        let torsion = torsion.map(|(material, tag)| Slot::new(material, tag, at));
        let state_len = at + torsion.as_ref().map_or(0, Slot::len);
        Self { fibers: placed, points, updated, runs, torsion, biaxial, centroid, state_len }
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
        let n = self.points.len();
        let (old, new) = (Parts::of(committed, n), Parts::of_mut(next, n));
        self.points.strains::<M>(e, new.strain);
        for padding in [&mut *new.stress, &mut *new.tangent] {
            padding[self.updated..].fill(0.0);
        }
        for run in &self.runs {
            let (range, words) = (run.points.clone(), run.words());
            let n = range.len();
            let strains = Strains { value: &new.strain[range.clone()], rate: &NO_RATE[..n], dt };
            let mut stresses = Stresses {
                value: &mut new.stress[range.clone()],
                tangent: &mut new.tangent[range],
                // A damping has no use in a section: the energies are written after it.
                damping: &mut new.energy[..n],
            };
            run.slot.material.update_all(&old.laws[words.clone()], &strains, &mut new.laws[words], &mut stresses)?;
        }
        let history = points::Work {
            strains: [old.strain, new.strain],
            stresses: [old.stress, new.stress],
            energies: (old.energy, new.energy),
        };
        let sums = self.points.integrate::<M>(new.tangent, history);
        sums.write(self.resultants().len(), s, k);
        Ok(())
    }

    /// Adds up the stiffness of the virgin fibers.
    fn virgin<const M: usize>(&self, k: &mut [f64]) {
        let n = self.points.len();
        let (zeros, mut tangent, mut energy) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
        self.runs.iter().for_each(|r| tangent[r.points.clone()].fill(r.slot.material.initial_tangent()));
        let history = points::Work { strains: [&zeros; 2], stresses: [&zeros; 2], energies: (&zeros, &mut energy) };
        let sums = self.points.integrate::<M>(&tangent, history);
        sums.write(self.resultants().len(), &mut [0.0; M], k);
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
        let (parts, fiber) = (Parts::of(state, self.points.len()), &self.fibers[i]);
        let (run, i) = (&self.runs[fiber.run], fiber.point);
        let mut words = vec![0.0; run.slot.len()];
        let header =
            run.slot.write_header(&mut words, [parts.strain[i], parts.stress[i], parts.tangent[i], parts.energy[i]]);
        // A run stores histories in the layout of the material, which only the material can copy.
        let from = (&parts.laws[run.words()], i - run.points.start, run.points.len());
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
        let parts = Parts::of_mut(state, self.points.len());
        for run in &self.runs {
            run.slot.material.init_all(run.points.len(), &mut parts.laws[run.words()]);
            parts.tangent[run.points.clone()].fill(run.slot.material.initial_tangent());
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
        let parts = Parts::of(state, self.points.len());
        match path[0] {
            FIBER => self.read_fiber(path[1] as usize, &path[2..], state, out),
            FIBER_DATA => {
                for (f, row) in self.fibers.iter().zip(out.chunks_exact_mut(5)) {
                    row.copy_from_slice(&[f.y, f.z, f.area, parts.stress[f.point], parts.strain[f.point]]);
                }
            }
            CENTROID => out.copy_from_slice(&[self.centroid.0, self.centroid.1]),
            ENERGY => out[0] = self.fibers.iter().map(|f| f.area * parts.energy[f.point]).sum(),
            _ => {
                if let Some(t) = &self.torsion {
                    t.read(&path[1..], state, out);
                }
            }
        }
    }
}
