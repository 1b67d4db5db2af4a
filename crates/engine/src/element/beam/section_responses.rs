//! Responses of the sections of a beam, of one or of all.

use super::member::{ALL_SECTIONS, Member, SECTION};
use crate::probe::Probe;

impl<const N: usize, const B: usize> Member<N, B> {
    /// A response of one section, by its number, or of all sections that have it.
    pub(super) fn section_probe(&self, words: &[&str]) -> Option<Probe> {
        if let Ok(number) = words.first()?.parse::<usize>() {
            let i = number.checked_sub(1)?;
            return Some(self.sections.get(i)?.probe(&words[1..])?.inside(&[SECTION, i as u32]));
        }
        let mut all = Probe { labels: vec![], path: vec![ALL_SECTIONS] };
        for section in &self.sections {
            // The elastic middle of a beam with hinges has no fibers.
            let Some(probe) = section.probe(words) else {
                all.path.extend([0, 0]);
                continue;
            };
            all.path.extend([probe.len() as u32, probe.path.len() as u32]);
            all.path.extend(&probe.path);
            all.labels.extend(probe.labels);
        }
        (!all.labels.is_empty()).then_some(all)
    }

    /// Read a response of all sections. Path of each: number of columns, path length, path.
    pub(super) fn read_all_sections(&self, mut path: &[u32], state: &[f64], mut out: &mut [f64]) {
        for section in &self.sections {
            let (columns, end) = (path[0] as usize, 2 + path[1] as usize);
            let (own, rest) = out.split_at_mut(columns);
            if columns > 0 {
                section.read(&path[2..end], state, own);
            }
            (path, out) = (&path[end..], rest);
        }
    }

    /// Path of the energy of each section; `None` where one does not count it.
    fn energy_paths(&self) -> Option<Vec<Vec<u32>>> {
        self.sections.iter().map(|s| s.probe(&["energy"]).map(|p| p.path)).collect()
    }

    /// Returns true if all sections count their energy.
    pub(super) fn has_energy(&self) -> bool {
        self.energy_paths().is_some()
    }

    /// Work done on the sections along the beam.
    pub(super) fn energy(&self, state: &[f64]) -> f64 {
        let paths = self.energy_paths().unwrap_or_default();
        let sections = self.sections.iter().zip(&paths).zip(&self.points.1);
        let energy = sections.map(|((section, path), weight)| {
            let mut energy = [0.0];
            section.read(path, state, &mut energy);
            energy[0] * weight
        });
        energy.sum::<f64>() * self.length()
    }
}
