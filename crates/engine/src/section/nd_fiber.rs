//! Sections of fibers of continua: axial stress and shear in each fiber.

use super::{MAX_ORDER, Resultant, Section, SharedSection};
use crate::material::{CHARACTERISTIC_LENGTH, MaterialError, NdMaterial, SharedMultiaxial};
use crate::probe::Probe;
use std::sync::Arc;

/// Input of one fiber: coordinates, area, and material with its tag.
#[derive(Clone, Debug)]
pub struct NdFiber {
    /// Local y.
    pub y: f64,
    /// Local z.
    pub z: f64,
    /// Area.
    pub area: f64,
    /// Material and its tag.
    pub material: (NdMaterial, i32),
}

/// A fiber in its place: a law of `N` stresses, the first along the beam.
#[derive(Clone, Debug)]
struct Placed<const N: usize> {
    y: f64,
    z: f64,
    area: f64,
    law: SharedMultiaxial<N>,
    tag: i32,
    /// Offset of its strains, stresses and history in the state.
    at: usize,
}

/// Plane section of fibers with the stresses 11 and 12, in space 31 too. The strains are ε = ε₀ - y κ_z + z κ_y,
/// γ₁₂ = √α γ_y - z θ and γ₃₁ = √α γ_z + y θ, with y and z from the centroid of the areas. α is a shear factor.
#[derive(Clone, Debug)]
pub struct NdFiberSection<const N: usize> {
    fibers: Vec<Placed<N>>,
    /// Square root of the shear factor α.
    root: f64,
    state_len: usize,
}

const PLANE: [Resultant; 3] = [Resultant::P, Resultant::Mz, Resultant::Vy];
const SPACE: [Resultant; 6] = [Resultant::P, Resultant::Mz, Resultant::My, Resultant::Vy, Resultant::Vz, Resultant::T];

const STRESS: u32 = 1;
const STRAIN: u32 = 2;
const BOTH: u32 = 3;
const OWN: u32 = 4;

impl<const N: usize> NdFiberSection<N> {
    /// Fibers with their laws. Bending is about the centroid, or with `origin` about the origin of the coordinates.
    fn placed(fibers: Vec<NdFiber>, laws: Vec<SharedMultiaxial<N>>, shear_factor: f64, origin: bool) -> Self {
        let area: f64 = fibers.iter().map(|f| f.area).sum();
        let mean = |x: fn(&NdFiber) -> f64| fibers.iter().map(|f| f.area * x(f)).sum::<f64>() / area;
        let (y0, z0) = if origin { (0.0, 0.0) } else { (mean(|f| f.y), mean(|f| f.z)) };
        let mut at = 0;
        let place = |(f, law): (NdFiber, SharedMultiaxial<N>)| {
            let start = at;
            at += 2 * N + law.state_len();
            Placed { y: f.y - y0, z: f.z - z0, area: f.area, law, tag: f.material.1, at: start }
        };
        let fibers = fibers.into_iter().zip(laws).map(place).collect();
        Self { fibers, root: shear_factor.sqrt(), state_len: at }
    }

    fn order() -> usize {
        if N == 2 { PLANE.len() } else { SPACE.len() }
    }

    /// Strains of a fiber by the deformations of the section.
    fn rows(&self, f: &Placed<N>) -> [[f64; MAX_ORDER]; N] {
        let mut rows = [[0.0; MAX_ORDER]; N];
        if N == 2 {
            rows[0][..2].copy_from_slice(&[1.0, -f.y]);
            rows[1][2] = self.root;
        } else {
            rows[0][..3].copy_from_slice(&[1.0, -f.y, f.z]);
            (rows[1][3], rows[1][5]) = (self.root, -f.z);
            (rows[2][4], rows[2][5]) = (self.root, f.y);
        }
        rows
    }

    fn add_stiffness(rows: &[[f64; MAX_ORDER]; N], tangent: &[[f64; N]; N], area: f64, k: &mut [f64]) {
        let n = Self::order();
        for (a, d) in rows.iter().zip(tangent) {
            for (b, d) in rows.iter().zip(d) {
                for (row, a) in k.chunks_exact_mut(n).zip(a) {
                    row.iter_mut().zip(b).for_each(|(k, b)| *k += area * a * d * b);
                }
            }
        }
    }

    /// The fiber that words name by its number, or by a place and perhaps a material, with the words behind.
    fn find<'a, 'b>(&self, words: &'a [&'b str]) -> Option<(usize, &'a [&'b str])> {
        let number = |i: usize| words.get(i).and_then(|w| w.parse::<f64>().ok());
        let Some(z) = number(1) else {
            let i = words.first()?.parse::<usize>().ok()?;
            return (i < self.fibers.len()).then_some((i, &words[1..]));
        };
        let y = number(0)?;
        let tag = words.get(2).and_then(|w| w.parse::<i32>().ok());
        let rest = &words[if tag.is_some() { 3 } else { 2 }..];
        let distance = |f: &Placed<N>| (f.y - y).powi(2) + (f.z - z).powi(2);
        let all = self.fibers.iter().enumerate().filter(|(_, f)| tag.is_none_or(|t| t == f.tag));
        let nearest = all.min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)))?;
        Some((nearest.0, rest))
    }
}

/// A section of fibers in the plane, or in space.
///
/// # Errors
/// The tag of a material that has no law in space.
pub fn nd_fiber_section(
    fibers: Vec<NdFiber>,
    space: bool,
    shear_factor: f64,
    origin: bool,
) -> Result<SharedSection, i32> {
    let solid = |f: &NdFiber| f.material.0.solid.clone().ok_or(f.material.1);
    let solids = fibers.iter().map(solid).collect::<Result<Vec<_>, i32>>()?;
    Ok(if space {
        let laws = solids.iter().map(crate::material::Condensed::beam_space).collect();
        Arc::new(NdFiberSection::<3>::placed(fibers, laws, shear_factor, origin))
    } else {
        let laws = solids.iter().map(crate::material::Condensed::beam_plane).collect();
        Arc::new(NdFiberSection::<2>::placed(fibers, laws, shear_factor, origin))
    })
}

impl<const N: usize> Section for NdFiberSection<N> {
    fn class(&self) -> &'static str {
        if N == 2 { "NDFiberSection2d" } else { "NDFiberSection3d" }
    }
    fn resultants(&self) -> &[Resultant] {
        if N == 2 { &PLANE } else { &SPACE }
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        for f in &self.fibers {
            let (head, own) = state[f.at..].split_at_mut(2 * N);
            head.fill(0.0);
            f.law.init(&mut own[..f.law.state_len()]);
        }
    }
    fn is_linear(&self) -> bool {
        self.fibers.iter().all(|f| f.law.is_linear())
    }
    fn depends_on_time(&self) -> bool {
        self.fibers.iter().any(|f| f.law.depends_on_time())
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
        for f in &self.fibers {
            let (rows, own) = (self.rows(f), f.at + 2 * N..f.at + 2 * N + f.law.state_len());
            let strain = rows.map(|row| row.iter().zip(e).map(|(a, e)| a * e).sum());
            let (stress, tangent) = f.law.update(&committed[own.clone()], &strain, dt, &mut next[own.clone()])?;
            let shown = f.law.shown_stress(&next[own], stress);
            next[f.at..f.at + N].copy_from_slice(&strain);
            next[f.at + N..f.at + 2 * N].copy_from_slice(&shown);
            for (row, stress) in rows.iter().zip(stress) {
                s.iter_mut().zip(row).for_each(|(s, a)| *s += f.area * a * stress);
            }
            Self::add_stiffness(&rows, &tangent, f.area, k);
        }
        Ok(())
    }

    fn initial_stiffness(&self, k: &mut [f64]) {
        self.fibers.iter().for_each(|f| Self::add_stiffness(&self.rows(f), &f.law.initial_tangent(), f.area, k));
    }

    fn with_parameter(&self, words: &[&str], value: f64) -> Option<(SharedSection, f64)> {
        if words != [CHARACTERISTIC_LENGTH] {
            return None;
        }
        let (mut new, mut changed) = (self.clone(), false);
        for f in &mut new.fibers {
            if let Some(law) = f.law.of_length(value) {
                (f.law, changed) = (law, true);
            }
        }
        changed.then(|| (Arc::new(new) as SharedSection, value))
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let rest = words.strip_prefix(&["fiber"])?;
        let (i, rest) = self.find(rest)?;
        let stress = ["sigma11", "tau12", "tau31"].into_iter().take(N);
        let strain = ["eps11", "gamma12", "gamma31"].into_iter().take(N);
        let made = match *rest.first()? {
            "stress" | "stresses" => Probe::new(STRESS, stress),
            "strain" | "strains" => Probe::new(STRAIN, strain),
            "stressStrain" | "stressAndStrain" | "stressANDstrain" => Probe::new(BOTH, stress.chain(strain)),
            _ => self.fibers[i].law.probe(rest)?.inside(&[OWN]),
        };
        Some(made.inside(&[i as u32]))
    }

    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        let f = &self.fibers[path[0] as usize];
        let (strain, stress) = (&state[f.at..f.at + N], &state[f.at + N..f.at + 2 * N]);
        match path[1] {
            STRESS => out.copy_from_slice(stress),
            STRAIN => out.copy_from_slice(strain),
            BOTH => {
                out[..N].copy_from_slice(stress);
                out[N..].copy_from_slice(strain);
            }
            _ => f.law.read(&path[2..], &state[f.at + 2 * N..f.at + 2 * N + f.law.state_len()], out),
        }
    }
}
