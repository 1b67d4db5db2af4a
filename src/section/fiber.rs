//! Fiber sections.

use super::{Resultant, Section, SharedSection};
use crate::material::{Material, MaterialError, Slot, Strain, Stress};
use crate::probe::Probe;
use std::sync::Arc;

/// A fiber before it is part of a section: its place, its area, its material with its tag.
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

/// Fibers whose strains are those of a plane section: ε₀ - y κ_z + z κ_y, with y and z from the centroid of the areas.
/// In space the torsion is uncoupled.
#[derive(Clone, Debug)]
pub struct FiberSection {
    fibers: Vec<Placed>,
    torsion: Option<Slot>,
    /// Place that bending is about.
    centroid: (f64, f64),
    state_len: usize,
}

#[derive(Clone, Debug)]
struct Placed {
    y: f64,
    z: f64,
    area: f64,
    /// Shares of its strain in the deformations P, Mz and My.
    shares: [f64; 3],
    slot: Slot,
}

impl Placed {
    /// Add its force and its stiffness.
    #[inline]
    fn add<const M: usize>(&self, stress: &Stress, force: &mut [f64; M], stiffness: &mut [[f64; M]; M]) {
        for i in 0..M {
            force[i] += self.shares[i] * stress.value * self.area;
            let row = stress.tangent * self.area * self.shares[i];
            (0..M).for_each(|j| stiffness[i][j] += row * self.shares[j]);
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
    /// From its fibers; in space with a material for the torsion (and its tag). Bending is about the centroid of the
    /// areas, or with `origin` about the origin of the coordinates.
    pub fn new(fibers: Vec<Fiber>, torsion: Option<(Material, i32)>, origin: bool) -> Self {
        let area: f64 = fibers.iter().map(|f| f.area).sum();
        let mean = |x: fn(&Fiber) -> f64| fibers.iter().map(|f| f.area * x(f)).sum::<f64>() / area;
        let centroid = if origin || area == 0.0 { (0.0, 0.0) } else { (mean(|f| f.y), mean(|f| f.z)) };
        let mut at = 0;
        let mut place = |(material, tag): (Material, i32)| {
            let slot = Slot::new(material, tag, at);
            at += slot.len();
            slot
        };
        let placed = |f: Fiber| {
            let shares = [1.0, -(f.y - centroid.0), f.z - centroid.1];
            Placed { y: f.y, z: f.z, area: f.area, shares, slot: place(f.material) }
        };
        let fibers = fibers.into_iter().map(placed).collect();
        let torsion = torsion.map(&mut place);
        Self { fibers, torsion, centroid, state_len: at }
    }

    /// Set the trial strains of the fibers, `M` deformations of the section being theirs, and add up stresses and tangents.
    fn gather<const M: usize>(
        &self,
        committed: &[f64],
        e: &[f64],
        dt: f64,
        next: &mut [f64],
        (s, k): (&mut [f64], &mut [f64]),
    ) -> Result<(), MaterialError> {
        let n = self.resultants().len();
        let e: [f64; M] = std::array::from_fn(|i| e[i]);
        let (mut force, mut stiffness) = ([0.0; M], [[0.0; M]; M]);
        for f in &self.fibers {
            let value = (0..M).map(|i| f.shares[i] * e[i]).sum();
            // As in OpenSees, fibers know no rate of strain.
            let stress = f.slot.update(committed, Strain { value, rate: 0.0, dt }, next)?;
            f.add(&stress, &mut force, &mut stiffness);
        }
        s[..M].copy_from_slice(&force);
        stiffness.iter().zip(k.chunks_exact_mut(n)).for_each(|(row, k)| k[..M].copy_from_slice(row));
        Ok(())
    }

    /// Stiffness of the virgin fibers.
    fn virgin<const M: usize>(&self, k: &mut [f64]) {
        let (mut force, mut stiffness) = ([0.0; M], [[0.0; M]; M]);
        for f in &self.fibers {
            let tangent = f.slot.material.initial_tangent();
            f.add(&Stress { tangent, ..Stress::default() }, &mut force, &mut stiffness);
        }
        let n = self.resultants().len();
        stiffness.iter().zip(k.chunks_exact_mut(n)).for_each(|(row, k)| k[..M].copy_from_slice(row));
    }

    /// The fiber that the words of a recorder mean, and the words after them: its number, or a place, and a material.
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
        // In the plane a fiber has no z to be far from.
        let distance = |f: &Placed| (f.y - y).powi(2) + if self.torsion.is_some() { (f.z - z).powi(2) } else { 0.0 };
        let candidates = self.fibers.iter().enumerate().filter(|(_, f)| tag.is_none_or(|t| f.slot.tag == t));
        let nearest = candidates.min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)))?;
        Some((nearest.0, rest))
    }
}

impl Section for FiberSection {
    fn class(&self) -> &'static str {
        if self.torsion.is_some() { "FiberSection3d" } else { "FiberSection2d" }
    }
    fn resultants(&self) -> &[Resultant] {
        if self.torsion.is_some() { &SPACE } else { &PLANE }
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        self.fibers.iter().map(|f| &f.slot).chain(&self.torsion).for_each(|s| s.init(state));
    }
    fn is_linear(&self) -> bool {
        self.fibers.iter().map(|f| &f.slot).chain(&self.torsion).all(|s| s.material.is_linear())
    }
    fn depends_on_time(&self) -> bool {
        self.fibers.iter().map(|f| &f.slot).chain(&self.torsion).any(|s| s.material.depends_on_time())
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
        let Some(torsion) = &self.torsion else { return self.gather::<2>(committed, e, dt, next, (s, k)) };
        self.gather::<3>(committed, e, dt, next, (&mut *s, &mut *k))?;
        let stress = torsion.update(committed, Strain { value: e[3], rate: 0.0, dt }, next)?;
        (s[3], k[15]) = (stress.value, stress.tangent);
        Ok(())
    }

    fn initial_stiffness(&self, k: &mut [f64]) {
        let Some(torsion) = &self.torsion else { return self.virgin::<2>(k) };
        self.virgin::<3>(k);
        k[15] = torsion.material.initial_tangent();
    }

    /// Of one material, by its tag, or of all that have it.
    fn with_parameter(&self, words: &[&str], value: f64) -> Option<(SharedSection, f64)> {
        let mut new = self.clone();
        let (tag, rest) = match words {
            ["material", tag, rest @ ..] => (Some(tag.parse::<i32>().ok()?), rest),
            _ => (None, words),
        };
        let chosen = new.fibers.iter_mut().map(|f| &mut f.slot).filter(|s| tag.is_none_or(|t| s.tag == t));
        let old = chosen.filter_map(|s| s.set_parameter(rest, value)).last()?;
        Some((Arc::new(new), old))
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match *words.first()? {
            "fiber" => {
                let (i, rest) = self.find(&words[1..])?;
                Some(self.fibers[i].slot.probe(rest)?.inside(&[FIBER, i as u32]))
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
        match path[0] {
            FIBER => self.fibers[path[1] as usize].slot.read(&path[2..], state, out),
            FIBER_DATA => {
                for (f, row) in self.fibers.iter().zip(out.chunks_exact_mut(5)) {
                    row.copy_from_slice(&[f.y, f.z, f.area, f.slot.stress(state), f.slot.strain(state)]);
                }
            }
            CENTROID => out.copy_from_slice(&[self.centroid.0, self.centroid.1]),
            ENERGY => out[0] = self.fibers.iter().map(|f| f.area * f.slot.energy(state)).sum(),
            _ => {
                if let Some(t) = &self.torsion {
                    t.read(&path[1..], state, out);
                }
            }
        }
    }
}
