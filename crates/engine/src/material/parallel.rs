//! Materials in parallel.

use super::{Material, MaterialError, Slot, Strain, Stress, Uniaxial};
use crate::probe::Probe;
use std::sync::Arc;

/// Materials with the same strain. The stress is the sum of their stresses, each multiplied by its factor.
#[derive(Clone, Debug)]
pub struct Parallel {
    parts: Vec<(Slot, f64)>,
    state_len: usize,
}

const STRESSES: u32 = 1;
const PART: u32 = 2;

impl Parallel {
    /// From materials with their tags, and a factor for each.
    pub fn new(materials: Vec<(Material, i32)>, factors: Vec<f64>) -> Self {
        let (slots, state_len) = Slot::pack(materials, 0);
        Self { parts: slots.into_iter().zip(factors).collect(), state_len }
    }

    fn laws(&self) -> impl Iterator<Item = &Material> {
        self.parts.iter().map(|(slot, _)| &slot.material)
    }
}

impl Uniaxial for Parallel {
    fn name(&self) -> &'static str {
        "Parallel"
    }
    fn state_len(&self) -> usize {
        self.state_len
    }
    fn init(&self, state: &mut [f64]) {
        self.parts.iter().for_each(|(slot, _)| slot.init(state));
    }
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> Result<Stress, MaterialError> {
        let mut sum = Stress::default();
        for (slot, factor) in &self.parts {
            let s = slot.update(committed, strain, next)?;
            sum.value += factor * s.value;
            sum.tangent += factor * s.tangent;
            sum.damping += factor * s.damping;
        }
        Ok(sum)
    }
    fn initial_tangent(&self) -> f64 {
        self.parts.iter().map(|(slot, factor)| factor * slot.material.initial_tangent()).sum()
    }
    fn is_viscous(&self) -> bool {
        self.laws().any(|m| m.is_viscous())
    }
    fn depends_on_time(&self) -> bool {
        self.laws().any(|m| m.depends_on_time())
    }
    fn is_linear(&self) -> bool {
        self.laws().all(|m| m.is_linear())
    }
    /// Applies to one component, or to all components that have the parameter.
    fn with_parameter(&self, words: &[&str], value: f64) -> Option<(Material, f64)> {
        let mut new = self.clone();
        let old = match words {
            ["material" | "component", i, rest @ ..] => {
                let i = i.parse::<usize>().ok()?.checked_sub(1)?;
                new.parts.get_mut(i)?.0.set_parameter(rest, value)?
            }
            _ => new.parts.iter_mut().filter_map(|(slot, _)| slot.set_parameter(words, value)).last()?,
        };
        Some((Arc::new(new), old))
    }
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match *words.first()? {
            "stresses" => Some(Probe::new(STRESSES, self.parts.iter().map(|_| "sigma11"))),
            "material" | "component" => {
                let i = words.get(1)?.parse::<usize>().ok()?.checked_sub(1)?;
                Some(self.parts.get(i)?.0.probe(&words[2..])?.inside(&[PART, i as u32]))
            }
            _ => None,
        }
    }
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        match path[0] {
            STRESSES => out.iter_mut().zip(&self.parts).for_each(|(o, (slot, _))| *o = slot.stress(state)),
            _ => self.parts[path[1] as usize].0.read(&path[2..], state, out),
        }
    }
}
