//! Storage of a section's state in an element, with the responses that every section has.

use super::{MAX_ORDER, Resultant, SectionStep, SharedSection};
use crate::material::{MaterialError, MaterialResult};
use crate::numeric::invert;
use crate::parameter::{NewValue, ParameterError};
use crate::probe::Probe;

/// A section at an offset in the state of its owner. The state begins with deformations (n), resultants (n) and
/// tangent (n x n by rows), so that they are read alike for every section.
#[derive(Clone, Debug)]
pub struct SectionSlot {
    /// The section.
    pub section: SharedSection,
    /// Tag in the script.
    pub tag: i32,
    at: usize,
    order: usize,
    len: usize,
}

const DEFORMATION: u32 = 1;
const FORCE: u32 = 2;
const FORCE_AND_DEFORMATION: u32 = 4;
const STIFFNESS: u32 = 12;
const FLEXIBILITY: u32 = 13;
const CODE: u32 = 14;
/// First number of the path of a response specific to the section.
const OWN: u32 = 100;

crate::watches_columns!(SectionSlot => |s| at [(s.at + s.header()..s.at + s.len, &s.section)]);

impl SectionSlot {
    /// Places a section at offset `at` of the owner's state.
    pub fn new(section: SharedSection, tag: i32, at: usize) -> Self {
        let order = section.resultants().len();
        let len = order * (2 + order) + section.state_len();
        Self { section, tag, at, order, len }
    }

    /// Number of state variables, header included.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Always false: every section has deformations.
    pub fn is_empty(&self) -> bool {
        false
    }

    fn header(&self) -> usize {
        self.order * (2 + self.order)
    }

    /// Resultants in the order of the deformations.
    pub fn resultants(&self) -> &[Resultant] {
        self.section.resultants()
    }

    /// Writes the virgin state.
    pub fn init(&self, state: &mut [f64]) {
        let (head, own) = state[self.at..self.at + self.len()].split_at_mut(self.header());
        head.fill(0.0);
        self.section.initial_stiffness(&mut head[2 * self.order..]);
        self.section.init(own);
        if !self.section.is_linear() {
            self.add_prestress(head, own);
        }
    }

    /// Sets the resultants to those of the virgin section without deformations, which initial stresses have.
    fn add_prestress(&self, head: &mut [f64], own: &[f64]) {
        let none = [0.0; MAX_ORDER];
        let (mut s, mut k) = ([0.0; MAX_ORDER], [0.0; MAX_ORDER * MAX_ORDER]);
        let (n, mut next) = (self.order, own.to_vec());
        let (e, next, s, k) = (&none[..n], &mut next[..], &mut s[..n], &mut k[..n * n]);
        if self.section.update(SectionStep { committed: own, e, dt: 0.0, next, s, k }).is_ok() {
            head[n..2 * n].copy_from_slice(&s[..n]);
        }
    }

    /// Deformations, resultants and tangent in a state.
    pub fn response<'a>(&self, state: &'a [f64]) -> &'a [f64] {
        &state[self.at..self.at + self.header()]
    }

    /// Deformations, resultants and tangent for overwriting; excludes the history.
    pub fn response_mut<'a>(&self, state: &'a mut [f64]) -> &'a mut [f64] {
        &mut state[self.at..self.at + self.header()]
    }

    /// Evaluates the section at trial deformations `e`.
    ///
    /// # Errors
    /// A material has no response at these deformations.
    pub fn update(&self, committed: &[f64], e: &[f64], dt: f64, trial: &mut [f64]) -> MaterialResult {
        self.set_deformation(e, trial);
        self.section.update(self.step(committed, dt, trial))
    }

    /// The step to the trial deformations that a state holds.
    #[inline]
    pub(crate) fn step<'a>(&self, committed: &'a [f64], dt: f64, trial: &'a mut [f64]) -> SectionStep<'a> {
        let ([e, s, k], next) = self.split(trial);
        SectionStep { committed: self.own(committed), e, dt, next, s, k }
    }

    /// Writes trial deformations `e`, with zeros for resultants and tangent.
    #[inline]
    pub(crate) fn set_deformation(&self, e: &[f64], trial: &mut [f64]) {
        let (deformation, rest) = self.response_mut(trial).split_at_mut(self.order);
        deformation.copy_from_slice(&e[..self.order]);
        rest.fill(0.0);
    }

    /// Deformations, resultants and tangent of a state for overwriting, and the state variables of the section.
    #[inline]
    pub(crate) fn split<'a>(&self, state: &'a mut [f64]) -> ([&'a mut [f64]; 3], &'a mut [f64]) {
        let (head, own) = state[self.at..self.at + self.len()].split_at_mut(self.header());
        let (e, rest) = head.split_at_mut(self.order);
        let (s, k) = rest.split_at_mut(self.order);
        ([e, s, k], own)
    }

    /// State variables of the section in a state.
    #[inline]
    pub(crate) fn own<'a>(&self, state: &'a [f64]) -> &'a [f64] {
        &state[self.at + self.header()..self.at + self.len()]
    }

    /// Deformations, resultants and tangent in a state, apart.
    pub fn parts<'a>(&self, state: &'a [f64]) -> (&'a [f64], &'a [f64], &'a [f64]) {
        let (deformation, rest) = self.response(state).split_at(self.order);
        let (resultant, stiffness) = rest.split_at(self.order);
        (deformation, resultant, stiffness)
    }

    /// Deformations in a state.
    pub fn deformation<'a>(&self, state: &'a [f64]) -> &'a [f64] {
        &state[self.at..self.at + self.order]
    }

    /// Resultants in a state.
    pub fn resultant<'a>(&self, state: &'a [f64]) -> &'a [f64] {
        &state[self.at + self.order..self.at + 2 * self.order]
    }

    /// Tangent in a state, n x n by rows.
    pub fn stiffness<'a>(&self, state: &'a [f64]) -> &'a [f64] {
        &state[self.at + 2 * self.order..self.at + self.header()]
    }

    /// Number of resultants.
    pub fn order(&self) -> usize {
        self.order
    }

    /// Inverse of a section stiffness, n x n by rows; `out` has at least as many entries.
    ///
    /// # Errors
    /// The stiffness is singular.
    pub fn flexibility(&self, stiffness: &[f64], out: &mut [f64]) -> MaterialResult {
        let n = self.order;
        if let (2, [a, b, c, d, ..]) = (n, stiffness) {
            // The section of a beam in the plane: by determinants.
            let inverse = 1.0 / (a * d - b * c);
            if inverse.is_finite() && inverse != 0.0 {
                out[..4].copy_from_slice(&[d * inverse, -b * inverse, -c * inverse, a * inverse]);
                return Ok(());
            }
        }
        out[..n * n].copy_from_slice(&stiffness[..n * n]);
        if invert(&mut out[..n * n], n) {
            return Ok(());
        }
        Err(MaterialError(format!("section {} has no stiffness left", self.tag)))
    }

    /// Sets a parameter, named by the words of a `parameter` command, and returns the previous value.
    pub fn set_parameter(&mut self, words: &[&str], value: NewValue) -> Result<f64, ParameterError> {
        let (section, old) = self.section.with_parameter(words, value)?;
        self.section = section;
        Ok(old)
    }

    /// Names of the responses of every section, to suggest the nearest to a misspelled one.
    pub(crate) const RESPONSES: &'static [&'static str] =
        &["force", "deformation", "forceAndDeformation", "stiffness", "flexibility", "code"];

    /// Response named by the words of a recorder command: first those of every section, then those specific to the
    /// section.
    pub fn probe(&self, words: &[&str]) -> Option<Probe> {
        let forces = || self.resultants().iter().map(|r| r.name());
        let deformations = || self.resultants().iter().map(|r| r.deformation());
        let square = |stem: &'static str| (1..=self.order * self.order).map(move |i| format!("{stem}{i}"));
        Some(match *words.first()? {
            "force" | "forces" => Probe::new(FORCE, forces()),
            "deformation" | "deformations" => Probe::new(DEFORMATION, deformations()),
            "forceAndDeformation" => Probe::new(FORCE_AND_DEFORMATION, deformations().chain(forces())),
            "stiffness" => Probe::new(STIFFNESS, square("k")),
            "flexibility" => Probe::new(FLEXIBILITY, square("f")),
            "code" => Probe::new(CODE, forces()),
            _ => return self.section.probe(words).map(|p| p.inside(&[OWN])),
        })
    }

    /// Value of a probe.
    pub fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        match path[0] {
            DEFORMATION => out.copy_from_slice(self.deformation(state)),
            FORCE => out.copy_from_slice(self.resultant(state)),
            FORCE_AND_DEFORMATION => {
                out[..self.order].copy_from_slice(self.deformation(state));
                out[self.order..].copy_from_slice(self.resultant(state));
            }
            STIFFNESS => out.copy_from_slice(self.stiffness(state)),
            FLEXIBILITY => {
                let mut f = [0.0; MAX_ORDER * MAX_ORDER];
                if self.flexibility(self.stiffness(state), &mut f).is_ok() {
                    out.copy_from_slice(&f[..out.len()]);
                }
            }
            CODE => out.iter_mut().zip(self.resultants()).for_each(|(o, r)| *o = r.code()),
            _ => self.section.read(&path[1..], self.own(state), out),
        }
    }
}
