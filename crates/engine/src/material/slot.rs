//! Where an element keeps a material's state, with what recorders ask of every material.

use super::{Material, MaterialError, Strain, Stress};
use crate::probe::Probe;

/// A material at a place in its owner's state. The first words hold strain, strain rate, stress, tangent and energy,
/// so that recorders read them whatever the law.
#[derive(Clone, Debug)]
pub struct Slot {
    /// The law.
    pub material: Material,
    /// Tag in the script.
    pub tag: i32,
    at: usize,
    len: usize,
    /// Stiffness of a law without history whose stress is proportional to the strain: there is nothing to ask it.
    linear: Option<f64>,
}

const STRAIN: usize = 0;
const RATE: usize = 1;
const STRESS: usize = 2;
const TANGENT: usize = 3;
const ENERGY: usize = 4;
const HEADER: usize = 5;

/// First number of the path of a response that the law itself answers.
const OWN: u32 = 100;

impl Slot {
    /// Place a material at word `at` of the owner's state.
    pub fn new(material: Material, tag: i32, at: usize) -> Self {
        let len = HEADER + material.state_len();
        let linear = Self::stiffness_of(&material);
        Self { material, tag, at, len, linear }
    }

    fn stiffness_of(material: &Material) -> Option<f64> {
        let plain = material.is_linear() && !material.is_viscous() && material.state_len() == 0;
        plain.then(|| material.initial_tangent())
    }

    /// Place materials one after the other from word `at`; also the first word after them.
    pub fn pack(materials: impl IntoIterator<Item = (Material, i32)>, mut at: usize) -> (Vec<Self>, usize) {
        let slots = materials
            .into_iter()
            .map(|(m, tag)| {
                let s = Self::new(m, tag, at);
                at += s.len();
                s
            })
            .collect();
        (slots, at)
    }

    /// Number of words it takes.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Never: there is always the header.
    pub fn is_empty(&self) -> bool {
        false
    }

    /// Write the virgin state.
    pub fn init(&self, state: &mut [f64]) {
        let words = &mut state[self.at..self.at + self.len()];
        words[..HEADER].fill(0.0);
        words[TANGENT] = self.material.initial_tangent();
        self.material.init(&mut words[HEADER..]);
    }

    /// Write strain, stress, tangent and energy of a point at rest into the words of a slot; where the law's own begin.
    pub fn write_header(&self, words: &mut [f64], [strain, stress, tangent, energy]: [f64; 4]) -> usize {
        let words = &mut words[self.at..];
        (words[STRAIN], words[RATE], words[STRESS], words[TANGENT], words[ENERGY]) =
            (strain, 0.0, stress, tangent, energy);
        self.at + HEADER
    }

    /// Set the trial strain.
    #[inline(always)]
    pub fn update(&self, committed: &[f64], strain: Strain, trial: &mut [f64]) -> Result<Stress, MaterialError> {
        let (was, old) = committed[self.at..].split_at(HEADER);
        let (head, new) = trial[self.at..].split_at_mut(HEADER);
        let s = match self.linear {
            Some(k) => Stress { value: k * strain.value, tangent: k, damping: 0.0 },
            None => {
                let own = ..self.len - HEADER;
                self.material.update(&old[own], strain, &mut new[own])?
            }
        };
        head[STRAIN] = strain.value;
        head[RATE] = strain.rate;
        head[STRESS] = s.value;
        head[TANGENT] = s.tangent;
        head[ENERGY] = was[ENERGY] + 0.5 * (was[STRESS] + s.value) * (strain.value - was[STRAIN]);
        Ok(s)
    }

    /// Give a parameter of the material, by the words of a `parameter` command, another value; the one it had.
    pub fn set_parameter(&mut self, words: &[&str], value: f64) -> Option<f64> {
        let (material, old) = self.material.with_parameter(words, value)?;
        self.linear = Self::stiffness_of(&material);
        self.material = material;
        Some(old)
    }

    /// Strain in a state.
    pub fn strain(&self, state: &[f64]) -> f64 {
        state[self.at + STRAIN]
    }

    /// Strain in a state as recorders show it: with the initial strain of materials that have one.
    pub fn shown_strain(&self, state: &[f64]) -> f64 {
        self.shown(self.strain(state), state)
    }

    /// The same for another strain than that of the state.
    pub fn shown(&self, strain: f64, state: &[f64]) -> f64 {
        self.material.shown_strain(strain, &state[self.at + HEADER..self.at + self.len()])
    }

    /// Stress in a state.
    pub fn stress(&self, state: &[f64]) -> f64 {
        state[self.at + STRESS]
    }

    /// Energy that has gone in per volume.
    pub fn energy(&self, state: &[f64]) -> f64 {
        state[self.at + ENERGY]
    }

    /// Tangent in a state.
    pub fn tangent(&self, state: &[f64]) -> f64 {
        state[self.at + TANGENT]
    }

    /// A response by the words of a recorder command: those of every material, then the law's own.
    pub fn probe(&self, words: &[&str]) -> Option<Probe> {
        let common = match *words.first()? {
            "stress" => Probe::new(1, ["sigma11"]),
            "tangent" => Probe::new(2, ["C11"]),
            "strain" => Probe::new(3, ["eps11"]),
            "stressStrain" | "stressANDstrain" | "stressAndStrain" => Probe::new(4, ["sig11", "eps11"]),
            "stressStrainTangent" | "stressANDstrainANDtangent" => Probe::new(5, ["sig11", "eps11", "C11"]),
            "plasticStrain" => Probe::new(6, ["eps11"]),
            "strainRate" => Probe::new(7, ["epsDot11"]),
            "energy" | "Energy" => Probe::new(9, ["energy"]),
            _ => return self.material.probe(words).map(|p| p.inside(&[OWN])),
        };
        Some(common)
    }

    /// Value of a probe.
    pub fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        let words = &state[self.at..self.at + self.len()];
        let strain = self.shown_strain(state);
        match path[0] {
            1 => out[0] = words[STRESS],
            2 => out[0] = words[TANGENT],
            3 => out[0] = strain,
            4 => out.copy_from_slice(&[words[STRESS], strain]),
            5 => out.copy_from_slice(&[words[STRESS], strain, words[TANGENT]]),
            6 => out[0] = strain - words[STRESS] / self.material.initial_tangent(),
            7 => out[0] = words[RATE],
            9 => out[0] = words[ENERGY],
            _ => self.material.read(&path[1..], &words[HEADER..], out),
        }
    }

    /// Value of a probe that the law itself answers, by the law's own path.
    pub fn read_own(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        self.material.read(path, &state[self.at + HEADER..self.at + self.len()], out);
    }
}
