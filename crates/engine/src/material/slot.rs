//! Storage of a material's state in an element, with the responses that every material has.

use super::{Material, MaterialResult, Strain, Strains, Stress, Stresses};
use crate::numeric::wide::Wide;
use crate::parameter::{NewValue, ParameterError};
use crate::probe::{Probe, Response};
use std::ops::Range;

/// A material at an offset in the state of its owner. The first five variables are strain, strain rate, stress,
/// tangent and energy, so that recorders read them for every law.
#[derive(Clone, Debug)]
pub struct Slot {
    /// The law.
    pub material: Material,
    /// Tag in the script.
    pub tag: i32,
    at: usize,
    len: usize,
    /// Stiffness of a linear elastic law without history, which is evaluated without a dynamic call.
    linear: Option<f64>,
}

/// What the strains of points are more than those given.
#[derive(Clone, Copy, Debug)]
pub enum Shift<'a> {
    /// The same of all points.
    All(f64),
    /// Of each point.
    Each(&'a [f64]),
}

const STRAIN: usize = 0;
const RATE: usize = 1;
const STRESS: usize = 2;
const TANGENT: usize = 3;
const ENERGY: usize = 4;
const HEADER: usize = 5;

/// First number of the path of a response specific to the law.
const OWN: u32 = 100;

crate::watches_columns!(Slot => |s| at [(s.own(), &s.material)]);

/// Writes the header of linear materials of several models side by side, as [`Slot::update`] does for a strain and its rate;
/// the length of the header.
#[inline(always)]
pub(crate) fn write_linear(
    stiffness: Wide,
    (strain, rate): (Wide, Wide),
    committed: &[Wide],
    trial: &mut [Wide],
) -> usize {
    let stress = stiffness * strain;
    let work = (committed[STRESS] + stress) * 0.5 * (strain - committed[STRAIN]);
    trial[STRAIN] = strain;
    trial[RATE] = rate;
    trial[STRESS] = stress;
    trial[TANGENT] = stiffness;
    trial[ENERGY] = committed[ENERGY] + work;
    HEADER
}

impl Slot {
    /// Places a material at offset `at` of the owner's state.
    pub fn new(material: Material, tag: i32, at: usize) -> Self {
        let len = HEADER + material.state_len();
        let linear = Self::stiffness_of(&material);
        Self { material, tag, at, len, linear }
    }

    fn stiffness_of(material: &Material) -> Option<f64> {
        let plain = material.is_linear() && !material.is_viscous() && material.state_len() == 0;
        plain.then(|| material.initial_tangent())
    }

    /// Places materials in sequence from offset `at`; returns the offset behind them too.
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

    /// Stiffness of a linear elastic law without history.
    pub fn stiffness(&self) -> Option<f64> {
        self.linear
    }

    /// Returns true for a linear elastic law without history.
    pub fn has_no_history(&self) -> bool {
        self.linear.is_some()
    }

    /// Number of state variables, header included.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Always false: every slot has a header.
    pub fn is_empty(&self) -> bool {
        false
    }

    /// Writes the virgin state.
    pub fn init(&self, state: &mut [f64]) {
        let words = &mut state[self.at..self.at + self.len()];
        words[..HEADER].fill(0.0);
        words[TANGENT] = self.material.initial_tangent();
        self.material.init(&mut words[HEADER..]);
    }

    /// Range of the law's own variables.
    fn own(&self) -> Range<usize> {
        self.at + HEADER..self.at + self.len
    }

    /// Takes the variables of the law back to those of the committed state, and leaves strain, stress and tangent of the trial.
    pub(super) fn keep_history(&self, committed: &[f64], trial: &mut [f64]) {
        trial[self.own()].copy_from_slice(&committed[self.own()]);
    }

    /// Copies to the committed state the variables that a trial changes without a commit.
    pub(super) fn leave_trace(&self, tried: &[f64], committed: &mut [f64]) {
        if let Some(law) = self.material.roles().trace {
            law.leave_trace(&tried[self.own()], &mut committed[self.own()]);
        }
    }

    /// Writes strain, stress, tangent and energy of a point at rest to the header. Returns the offset of the law's
    /// own variables.
    pub fn write_header(&self, words: &mut [f64], [strain, stress, tangent, energy]: [f64; 4]) -> usize {
        let words = &mut words[self.at..];
        (words[STRAIN], words[RATE], words[STRESS], words[TANGENT], words[ENERGY]) =
            (strain, 0.0, stress, tangent, energy);
        self.at + HEADER
    }

    /// Evaluates the material at a trial strain.
    ///
    /// # Errors
    /// The law has no response at this strain.
    #[inline(always)]
    pub fn update(&self, committed: &[f64], strain: Strain, trial: &mut [f64]) -> MaterialResult<Stress> {
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

    /// As [`Slot::update`], for many points that are always updated together, at strains that are `shift` more than
    /// given. A state holds each variable of the header for all points, then the histories in the layout of the material. The
    /// slot must begin the state.
    ///
    /// # Errors
    /// The law has no response at one of the strains.
    pub fn update_all(
        &self,
        committed: &[f64],
        shift: &Shift<'_>,
        strains: &Strains<'_>,
        trial: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> MaterialResult {
        let n = strains.value.len();
        let (was, old) = committed.split_at(HEADER * n);
        let (head, new) = trial.split_at_mut(HEADER * n);
        let (strain, head) = head.split_at_mut(n);
        let pairs = strain.iter_mut().zip(strains.value);
        match *shift {
            Shift::All(shift) => pairs.for_each(|(own, x)| *own = x + shift),
            Shift::Each(shifts) => pairs.zip(shifts).for_each(|((own, x), shift)| *own = x + shift),
        }
        let own = Strains { value: strain, ..*strains };
        self.material.update_all(old, &own, new, stresses)?;
        head[..n].copy_from_slice(strains.rate);
        head[(STRESS - 1) * n..STRESS * n].copy_from_slice(&stresses.value[..n]);
        head[(TANGENT - 1) * n..TANGENT * n].copy_from_slice(&stresses.tangent[..n]);
        let before = was[..n].iter().zip(&was[STRESS * n..]).zip(&was[ENERGY * n..]);
        let after = strain.iter().zip(&stresses.value[..n]);
        let energies = head[(ENERGY - 1) * n..].iter_mut();
        for (energy, (((e0, s0), was), (e1, s1))) in energies.zip(before.zip(after)) {
            *energy = was + 0.5 * (s0 + s1) * (e1 - e0);
        }
        Ok(())
    }

    /// Copies the state of one point between states as of [`Slot::update_all`]. Each triple is the state, the index of
    /// the point, and the number of points.
    pub fn copy_history(&self, (from, i, n): (&[f64], usize, usize), (to, j, m): (&mut [f64], usize, usize)) {
        (0..HEADER).for_each(|q| to[q * m + j] = from[q * n + i]);
        self.material.copy_history((&from[HEADER * n..], i, n), (&mut to[HEADER * m..], j, m));
    }

    /// Sets a parameter, named by the words of a `parameter` command, and returns the previous value.
    pub fn set_parameter(&mut self, words: &[&str], value: NewValue) -> Result<f64, ParameterError> {
        let (material, old) = self.material.with_parameter(words, value)?;
        self.linear = Self::stiffness_of(&material);
        self.material = material;
        Ok(old)
    }

    /// Strain in a state.
    pub fn strain(&self, state: &[f64]) -> f64 {
        state[self.at + STRAIN]
    }

    /// Strain in a state as reported by recorders, with the initial strain of materials that have one.
    pub fn shown_strain(&self, state: &[f64]) -> f64 {
        self.shown(self.strain(state), state)
    }

    /// Strain as reported by recorders for a given strain of the material.
    pub fn shown(&self, strain: f64, state: &[f64]) -> f64 {
        self.material.shown_strain(strain, &state[self.own()])
    }

    /// Stress in a state.
    pub fn stress(&self, state: &[f64]) -> f64 {
        state[self.at + STRESS]
    }

    /// Work per volume done on the material.
    pub fn energy(&self, state: &[f64]) -> f64 {
        state[self.at + ENERGY]
    }

    /// Tangent in a state.
    pub fn tangent(&self, state: &[f64]) -> f64 {
        state[self.at + TANGENT]
    }

    /// Responses of every material.
    pub(crate) const RESPONSES: &'static [Response<Self>] = &[
        Response::new(&["stress"], &["sigma11"], |s, state, out| out[0] = s.stress(state)),
        Response::new(&["strain"], &["eps11"], |s, state, out| out[0] = s.shown_strain(state)),
        Response::new(&["tangent"], &["C11"], |s, state, out| out[0] = s.tangent(state)),
        Response::new(&["stressStrain", "stressANDstrain", "stressAndStrain"], &["sig11", "eps11"], |s, state, out| {
            out.copy_from_slice(&[s.stress(state), s.shown_strain(state)])
        }),
        Response::new(
            &["stressStrainTangent", "stressANDstrainANDtangent"],
            &["sig11", "eps11", "C11"],
            |s, state, out| out.copy_from_slice(&[s.stress(state), s.shown_strain(state), s.tangent(state)]),
        ),
        Response::new(&["plasticStrain"], &["eps11"], |s, state, out| {
            out[0] = s.shown_strain(state) - s.stress(state) / s.material.initial_tangent();
        }),
        Response::new(&["strainRate"], &["epsDot11"], |s, state, out| out[0] = state[s.at + RATE]),
        Response::new(&["energy", "Energy"], &["energy"], |s, state, out| out[0] = s.energy(state)),
    ];

    /// Response named by the words of a recorder command: first those of every material, then those specific to the
    /// law.
    pub fn probe(&self, words: &[&str]) -> Option<Probe> {
        Response::find(Self::RESPONSES, words.first()?).or_else(|| self.material.probe(words).map(|p| p.inside(&[OWN])))
    }

    /// Value of a probe.
    pub fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        if !Response::read(Self::RESPONSES, path[0], self, state, out) {
            self.read_own(&path[1..], state, out);
        }
    }

    /// Value of a probe specific to the law, by the law's own path.
    pub fn read_own(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        self.material.read(path, &state[self.own()], out);
    }
}
