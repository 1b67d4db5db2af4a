//! Why a force-based beam has no forces for its deformations.

use super::member::Member;
use super::per_section::PerSection;
use super::point::Point;
use crate::element::ElementError;
use crate::material::MaterialError;
use crate::section::MAX_ORDER;

/// A section that does not carry the forces along its beam.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shortfall {
    /// Index along the beam.
    section: usize,
    /// Index among the resultants of the section.
    resultant: usize,
    /// Resultant of the section.
    carried: f64,
    /// Resultant in equilibrium with the basic forces and the loads.
    asked: f64,
}

impl Shortfall {
    /// The section with the largest work of its imbalance; `None` if all are balanced.
    pub(super) fn new<const N: usize, const B: usize, const M: usize>(
        member: &Member<N, B>,
        points: &PerSection<Point<B, M>>,
        q: &[f64; B],
    ) -> Option<Self> {
        let all = member.points.1.iter().zip(points).map(|(weight, point)| {
            let (resultant, work, forces) = point.worst(q);
            (weight.abs() * work, resultant, forces)
        });
        let (section, (work, resultant, [carried, asked])) = all.enumerate().max_by(|a, b| a.1.0.total_cmp(&b.1.0))?;
        (work > 0.0).then_some(Self { section, resultant, carried, asked })
    }

    /// A resultant of a section along the beam, by their indices.
    pub(super) fn of(section: usize, resultant: usize, carried: f64, asked: f64) -> Self {
        Self { section, resultant, carried, asked }
    }
}

/// Part of the virgin stiffness of a section that counts as none.
const NO_STIFFNESS: f64 = 1e-6;

/// The first section along a beam without stiffness for one of its resultants, in words. Of several resultants the last is
/// named: bending moments come after the axial force.
pub(super) fn exhausted<const N: usize, const B: usize>(member: &Member<N, B>, state: &[f64]) -> Option<String> {
    let mut sections = member.sections.iter().enumerate().filter(|(_, s)| !s.section.is_linear());
    sections.find_map(|(i, section)| {
        let n = section.order();
        let mut virgin = [0.0; MAX_ORDER * MAX_ORDER];
        section.section.initial_stiffness(&mut virgin[..n * n]);
        let (_, forces, stiffness) = section.parts(state);
        let none = |r: &usize| stiffness[r * n + r].abs() < NO_STIFFNESS * virgin[r * n + r].abs();
        let r = (0..n).rfind(none)?;
        let (name, force, count) = (section.resultants()[r].name(), forces[r], member.sections.len());
        let (number, tag) = (i + 1, section.tag);
        Some(format!("section {number} of {count} (tag {tag}) carries {name} = {force:.4e} and has no stiffness left"))
    })
}

/// Why an attempt found no basic forces.
#[derive(Debug)]
pub(super) enum Miss {
    /// A section has no response or no stiffness.
    Section(MaterialError),
    /// A section does not carry the forces along the beam.
    Unbalanced(Shortfall),
    /// The section deformations do not add up to those of the beam.
    Incompatible,
}

impl From<MaterialError> for Miss {
    fn from(error: MaterialError) -> Self {
        Self::Section(error)
    }
}

impl Miss {
    /// Returns true if one section stopped the attempt.
    pub(super) fn is_of_a_section(&self) -> bool {
        !matches!(self, Self::Incompatible)
    }

    /// The reason that says more, of this one and one before it.
    pub(super) fn or(self, before: Option<Self>) -> Self {
        let rank = |miss: &Self| match miss {
            Self::Incompatible => 0,
            Self::Section(_) => 1,
            Self::Unbalanced(_) => 2,
        };
        match before {
            Some(before) if rank(&before) > rank(&self) => before,
            _ => self,
        }
    }

    /// The message.
    pub(super) fn error<const N: usize, const B: usize>(self, member: &Member<N, B>) -> ElementError {
        match self {
            Self::Section(error) => error.into(),
            Self::Incompatible => {
                ElementError("the deformations of the sections do not come to add up to those of the beam".into())
            }
            Self::Unbalanced(Shortfall { section, resultant, carried, asked }) => {
                let slot = &member.sections[section];
                let name = slot.resultants().get(resultant).map_or("force", |r| r.name());
                let message = format!(
                    "section {} of {} (tag {}) carries {name} = {carried:.4e}, and equilibrium along the beam asks for \
                     {asked:.4e}: the load is above its strength, or the step is too long",
                    section + 1,
                    member.sections.len(),
                    slot.tag
                );
                ElementError(message.into())
            }
        }
    }
}
