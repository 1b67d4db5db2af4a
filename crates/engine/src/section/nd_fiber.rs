//! Fiber sections whose fibers have shear stresses: `NDFiber`.

use super::nearest::{FiberPlace, select};
use super::plain_methods::plain_methods;
use super::{Resultant, Section, SectionStep};
use crate::material::{MaterialResult, SharedMultiaxial};
use crate::parameter::{Changed, NewValue, ParameterError};
use crate::probe::Probe;
use std::ops::Range;
use std::sync::Arc;

/// A fiber with a law of N stresses: 11 and 12 in a plane, 11, 12 and 13 in space.
#[derive(Clone, Debug)]
pub struct NdFiber<const N: usize> {
    /// Local y.
    pub y: f64,
    /// Local z.
    pub z: f64,
    /// Area.
    pub area: f64,
    /// Law and tag of its material.
    pub law: (SharedMultiaxial<N>, i32),
}

/// Fibers with the strains of a plane section and constant shear strains: ε = ε₀ - y κ_z + z κ_y, γ_12 = √α γ_y - z θ,
/// γ_13 = √α γ_z + y θ, with y and z from the centroid of the areas and a shape factor α.
///
/// State variables of a fiber: strains, stresses, and then those of its law.
#[derive(Clone, Debug)]
pub struct NdFiberSection<const N: usize> {
    fibers: Vec<PlacedFiber<N>>,
    centroid: (f64, f64),
    root_alpha: f64,
    state_len: usize,
}

#[derive(Clone, Debug)]
struct PlacedFiber<const N: usize> {
    fiber: NdFiber<N>,
    /// Strains per deformation of the section.
    rows: [Row; N],
    at: usize,
}

/// Largest number of resultants.
const MAX: usize = 6;
type Row = [f64; MAX];

const PLANE: [Resultant; 3] = [Resultant::P, Resultant::Mz, Resultant::Vy];
const SPACE: [Resultant; MAX] =
    [Resultant::P, Resultant::Mz, Resultant::My, Resultant::Vy, Resultant::Vz, Resultant::T];

const FIBER: u32 = 1;
const FIBER_DATA: u32 = 2;
const CENTROID: u32 = 3;
const FIBER_DATA_2: u32 = 4;
const STRESS: u32 = 1;
const STRAIN: u32 = 2;
const BOTH: u32 = 3;
const OWN: u32 = 4;

impl<const N: usize> NdFiberSection<N> {
    /// From fibers and the shape factor α of the shear strains. Bending is about the centroid of the areas, or with `origin`
    /// about the origin of the coordinates.
    pub fn new(fibers: Vec<NdFiber<N>>, alpha: f64, origin: bool) -> Self {
        let area: f64 = fibers.iter().map(|f| f.area).sum();
        let mean = |x: fn(&NdFiber<N>) -> f64| fibers.iter().map(|f| f.area * x(f)).sum::<f64>() / area;
        let centroid = if origin || area == 0.0 { (0.0, 0.0) } else { (mean(|f| f.y), mean(|f| f.z)) };
        let root_alpha = alpha.sqrt();
        let mut at = 0;
        let placed = |fiber: NdFiber<N>| {
            let (y, z) = (fiber.y - centroid.0, fiber.z - centroid.1);
            let rows = std::array::from_fn(|i| match (N, i) {
                (2, 0) => [1.0, -y, 0.0, 0.0, 0.0, 0.0],
                (2, _) => [0.0, 0.0, root_alpha, 0.0, 0.0, 0.0],
                (_, 0) => [1.0, -y, z, 0.0, 0.0, 0.0],
                (_, 1) => [0.0, 0.0, 0.0, root_alpha, 0.0, -z],
                _ => [0.0, 0.0, 0.0, 0.0, root_alpha, y],
            });
            let placed = PlacedFiber { rows, at, fiber };
            at += 2 * N + placed.fiber.law.0.state_len();
            placed
        };
        let fibers: Vec<_> = fibers.into_iter().map(placed).collect();
        Self { fibers, centroid, root_alpha, state_len: at }
    }

    /// Laws of the fibers, each with the range of its state variables.
    fn laws(&self) -> impl Iterator<Item = (Range<usize>, &SharedMultiaxial<N>)> {
        self.fibers.iter().map(|f| (f.at + 2 * N..f.at + 2 * N + f.fiber.law.0.state_len(), &f.fiber.law.0))
    }

    fn order() -> usize {
        if N == 2 { PLANE.len() } else { MAX }
    }

    /// Adds the stiffness of a fiber.
    fn add_stiffness(f: &PlacedFiber<N>, tangent: &[[f64; N]; N], k: &mut [f64]) {
        let n = Self::order();
        for (row, tangent) in f.rows.iter().zip(tangent) {
            for (other, d) in f.rows.iter().zip(tangent).filter(|(_, d)| **d != 0.0) {
                for (k, r) in k.chunks_exact_mut(n).zip(row).filter(|(_, r)| **r != 0.0) {
                    k.iter_mut().zip(other).for_each(|(k, o)| *k += f.fiber.area * d * r * o);
                }
            }
        }
    }

    /// Fiber selected by the words of a recorder, and the words after them.
    fn find<'a, 'b>(&self, words: &'a [&'b str]) -> Option<(usize, &'a [&'b str])> {
        let place = |f: &PlacedFiber<N>| FiberPlace { y: f.fiber.y, z: f.fiber.z, tag: f.fiber.law.1 };
        select(words, N > 2, self.fibers.iter().map(place))
    }

    fn names(stem: &str) -> impl Iterator<Item = String> {
        ["11", "12", "13"].into_iter().take(N).map(move |c| format!("{stem}{c}"))
    }
}

crate::watches_columns!([const N: usize] NdFiberSection<N> => |s| at s.laws());

#[deny(clippy::missing_trait_methods)]
impl<const N: usize> Section for NdFiberSection<N> {
    plain_methods! { elastic joined }
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
            let own = &mut state[f.at..f.at + 2 * N + f.fiber.law.0.state_len()];
            own[..2 * N].fill(0.0);
            f.fiber.law.0.init(&mut own[2 * N..]);
        }
    }
    fn is_linear(&self) -> bool {
        self.fibers.iter().all(|f| f.fiber.law.0.is_linear())
    }
    fn depends_on_time(&self) -> bool {
        self.fibers.iter().any(|f| f.fiber.law.0.depends_on_time())
    }

    fn update(&self, step: SectionStep<'_>) -> MaterialResult {
        let SectionStep { committed, e, dt, next, s, k } = step;
        for f in &self.fibers {
            let range = f.at..f.at + 2 * N + f.fiber.law.0.state_len();
            let (head, history) = next[range.clone()].split_at_mut(2 * N);
            let strain: [f64; N] = f.rows.each_ref().map(|row| row.iter().zip(e).map(|(r, e)| r * e).sum());
            let (stress, tangent) = f.fiber.law.0.update(&committed[range][2 * N..], &strain, dt, history)?;
            head[..N].copy_from_slice(&strain);
            head[N..].copy_from_slice(&stress);
            for (row, stress) in f.rows.iter().zip(stress) {
                s.iter_mut().zip(row).for_each(|(s, r)| *s += f.fiber.area * r * stress);
            }
            Self::add_stiffness(f, &tangent, k);
        }
        Ok(())
    }

    fn initial_stiffness(&self, k: &mut [f64]) {
        self.fibers.iter().for_each(|f| Self::add_stiffness(f, &f.fiber.law.0.initial_tangent(), k));
    }

    /// The shape factor `alpha`.
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<super::SharedSection> {
        if words != ["alpha"] {
            return Err(ParameterError::Unknown);
        }
        let before = self.root_alpha * self.root_alpha;
        let value = value.instead_of(before).unwrap_or(before);
        if value < 0.0 {
            return Err(ParameterError::Refused(format!("the shape factor alpha is {value}, less than 0")));
        }
        let mut new = self.clone();
        new.root_alpha = value.sqrt();
        for f in &mut new.fibers {
            for (i, row) in f.rows.iter_mut().enumerate().skip(1) {
                row[if N == 2 { 2 } else { 2 + i }] = new.root_alpha;
            }
        }
        Ok((Arc::new(new), before))
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match *words.first()? {
            "fiber" => {
                let (i, rest) = self.find(&words[1..])?;
                let probe = match *rest.first()? {
                    "stress" | "stresses" => Probe::new(STRESS, Self::names("sigma")),
                    "strain" | "strains" => Probe::new(STRAIN, Self::names("eps")),
                    "stressStrain" | "stressANDstrain" => {
                        Probe::new(BOTH, Self::names("sigma").chain(Self::names("eps")))
                    }
                    _ => self.fibers[i].fiber.law.0.probe(rest)?.inside(&[OWN]),
                };
                Some(probe.inside(&[FIBER, i as u32]))
            }
            "fiberData" => {
                let place = ["yCoord", "zCoord", "area"].map(str::to_owned);
                let columns: Vec<_> = place.into_iter().chain(Self::names("sigma")).chain(Self::names("eps")).collect();
                Some(Probe::new(FIBER_DATA, self.fibers.iter().flat_map(|_| columns.clone())))
            }
            "fiberData2" => {
                let place = ["yCoord", "zCoord", "area", "material"].map(str::to_owned);
                let columns: Vec<_> = place.into_iter().chain(Self::names("sigma")).chain(Self::names("eps")).collect();
                Some(Probe::new(FIBER_DATA_2, self.fibers.iter().flat_map(|_| columns.clone())))
            }
            "centroid" => Some(Probe::new(CENTROID, ["y", "z"])),
            _ => None,
        }
    }

    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        match *path {
            [FIBER, i, ref rest @ ..] => {
                let f = &self.fibers[i as usize];
                let own = &state[f.at..f.at + 2 * N + f.fiber.law.0.state_len()];
                match rest[0] {
                    STRESS => out.copy_from_slice(&own[N..2 * N]),
                    STRAIN => out.copy_from_slice(&own[..N]),
                    BOTH => {
                        out[..N].copy_from_slice(&own[N..2 * N]);
                        out[N..].copy_from_slice(&own[..N]);
                    }
                    _ => f.fiber.law.0.read(&rest[1..], &own[2 * N..], out),
                }
            }
            [kind @ (FIBER_DATA | FIBER_DATA_2)] => {
                let place = if kind == FIBER_DATA { 3 } else { 4 };
                for (f, row) in self.fibers.iter().zip(out.chunks_exact_mut(place + 2 * N)) {
                    let (of_fiber, law) = row.split_at_mut(place);
                    let all = [f.fiber.y, f.fiber.z, f.fiber.area, f64::from(f.fiber.law.1)];
                    of_fiber.copy_from_slice(&all[..place]);
                    law[..N].copy_from_slice(&state[f.at + N..f.at + 2 * N]);
                    law[N..].copy_from_slice(&state[f.at..f.at + N]);
                }
            }
            _ => out.copy_from_slice(&[self.centroid.0, self.centroid.1]),
        }
    }
}
