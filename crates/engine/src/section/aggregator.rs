//! Sections composed of uniaxial materials.

use super::plain_methods::plain_methods;
use super::{MAX_ORDER, Resultant, Section, SectionStep, SharedSection};
use crate::material::{Material, MaterialError, MaterialResult, Slot, Strain, WatchesColumns};
use crate::parameter::{Changed, NewValue, existing, last_of};
use crate::probe::Probe;
use std::ops::Range;
use std::sync::Arc;

/// An optional base section with additional resultants, each with an uncoupled uniaxial material.
#[derive(Clone, Debug)]
pub struct Aggregator {
    base: Option<SharedSection>,
    additions: Vec<Slot>,
    resultants: Vec<Resultant>,
    state_len: usize,
}

const BASE: u32 = 1;
const ADDITION: u32 = 2;

impl Aggregator {
    /// From materials with their tags and resultants, and an optional base section.
    ///
    /// # Errors
    /// The section has more than [`MAX_ORDER`] resultants.
    pub fn new(base: Option<SharedSection>, additions: Vec<(Material, i32, Resultant)>) -> MaterialResult<Self> {
        let mut resultants = base.as_ref().map_or(vec![], |s| s.resultants().to_vec());
        resultants.extend(additions.iter().map(|a| a.2));
        if resultants.len() > MAX_ORDER {
            return Err(MaterialError(format!("{} resultants are more than {MAX_ORDER}", resultants.len())));
        }
        let start = base.as_ref().map_or(0, |s| s.state_len());
        let (additions, state_len) = Slot::pack(additions.into_iter().map(|(m, tag, _)| (m, tag)), start);
        Ok(Self { base, additions, resultants, state_len })
    }

    /// Number of resultants of the base section.
    fn base_order(&self) -> usize {
        self.resultants.len() - self.additions.len()
    }

    /// The base section and the additions, each with the variables that it counts its own from.
    fn parts(&self) -> impl Iterator<Item = (Range<usize>, &dyn WatchesColumns)> {
        let base = self.base.iter().map(|base| (0..base.state_len(), &**base as &dyn WatchesColumns));
        base.chain(self.additions.iter().map(|slot| (0..self.state_len, slot as &dyn WatchesColumns)))
    }

    /// Copies the n x n matrix of the base section into the upper left corner of `k`.
    fn spread(&self, small: &[f64], k: &mut [f64]) {
        let (n, order) = (self.base_order(), self.resultants.len());
        for (i, row) in small.chunks_exact(n.max(1)).take(n).enumerate() {
            k[i * order..i * order + n].copy_from_slice(row);
        }
    }
}

crate::watches_columns!(Aggregator => |s| at s.parts());

#[deny(clippy::missing_trait_methods)]
impl Section for Aggregator {
    plain_methods! { elastic joined }
    fn class(&self) -> &'static str {
        if self.base.is_none() && self.additions.len() == 1 { "GenericSection1d" } else { "SectionAggregator" }
    }
    fn resultants(&self) -> &[Resultant] {
        &self.resultants
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        if let Some(base) = &self.base {
            base.init(&mut state[..base.state_len()]);
        }
        self.additions.iter().for_each(|s| s.init(state));
    }
    fn is_linear(&self) -> bool {
        self.base.as_ref().is_none_or(|s| s.is_linear()) && self.additions.iter().all(|s| s.material.is_linear())
    }
    fn depends_on_time(&self) -> bool {
        self.base.as_ref().is_some_and(|s| s.depends_on_time())
            || self.additions.iter().any(|s| s.material.depends_on_time())
    }

    fn update(&self, step: SectionStep<'_>) -> MaterialResult {
        let SectionStep { committed, e, dt, next, s, k } = step;
        let (n, order) = (self.base_order(), self.resultants.len());
        if let Some(base) = &self.base {
            let mut small = [0.0; MAX_ORDER * MAX_ORDER];
            let words = base.state_len();
            base.update(SectionStep {
                committed: &committed[..words],
                e: &e[..n],
                dt,
                next: &mut next[..words],
                s: &mut s[..n],
                k: &mut small[..n * n],
            })?;
            self.spread(&small[..n * n], k);
        }
        for (i, slot) in self.additions.iter().enumerate() {
            let i = n + i;
            let stress = slot.update(committed, Strain { value: e[i], rate: 0.0, dt }, next)?;
            (s[i], k[i * order + i]) = (stress.value, stress.tangent);
        }
        Ok(())
    }

    fn initial_stiffness(&self, k: &mut [f64]) {
        let (n, order) = (self.base_order(), self.resultants.len());
        if let Some(base) = &self.base {
            let mut small = [0.0; MAX_ORDER * MAX_ORDER];
            base.initial_stiffness(&mut small[..n * n]);
            self.spread(&small[..n * n], k);
        }
        for (i, slot) in self.additions.iter().enumerate() {
            k[(n + i) * order + n + i] = slot.material.initial_tangent();
        }
    }

    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<SharedSection> {
        let mut new = self.clone();
        let (tag, rest) = match words {
            ["material" | "addition", tag, rest @ ..] => (Some(existing(tag.parse::<i32>().ok())?), rest),
            _ => (None, words),
        };
        let chosen = new.additions.iter_mut().filter(|s| tag.is_none_or(|t| s.tag == t));
        let of_additions = last_of(chosen.map(|s| s.set_parameter(rest, value)));
        let of_base = self.base.as_ref().map(|b| b.with_parameter(words, value)).map(|changed| {
            let (base, old) = changed?;
            new.base = Some(base);
            Ok(old)
        });
        let old = last_of(std::iter::once(of_additions).chain(of_base))?;
        Ok((Arc::new(new), old))
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        if let ["addition" | "material", which, rest @ ..] = words {
            let names = self.resultants[self.base_order()..].iter().map(|r| r.name());
            let tag = which.parse::<i32>().ok();
            let found = names.zip(&self.additions).position(|(name, s)| name == *which || tag == Some(s.tag));
            // Another may be an addition of the base section itself.
            if let Some(i) = found {
                return Some(self.additions[i].probe(rest)?.inside(&[ADDITION, i as u32]));
            }
        }
        Some(self.base.as_ref()?.probe(words)?.inside(&[BASE]))
    }

    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        match (path[0], &self.base) {
            (ADDITION, _) => self.additions[path[1] as usize].read(&path[2..], state, out),
            (_, Some(base)) => base.read(&path[1..], &state[..base.state_len()], out),
            _ => {}
        }
    }
}
