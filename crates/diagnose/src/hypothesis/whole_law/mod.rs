//! Whole laws: forms that replace the law of a device by another law of the library.
//!
//! An amendment adds one effect to the user's law. Rubber, or a joint that pinches, has several effects that belong together,
//! and a law that was fitted to tests has them in proportion. Such a law is fitted as a whole, so that few parameters stand
//! for many effects. After the fit, [`Phenomenon`]s are switched off one at a time to see which of them did the work.
//!
//! A new law is a file with a [`WholeLaw`], and a line in [`LAWS`]. `sites` finds the commands that a law can replace.
//! One group of devices is considered, that with the most work.

mod friction_with_pressure;
mod friction_with_speed;
mod friction_with_speed_and_pressure;
mod gallardo_shear;
mod hdr_rheology;
mod kikuchi_aiken_hdr;
mod pinched_hysteretic;
mod sites;

use super::context::{MovingGroup, ProposalContext};
use super::device_commands::device_commands;
use super::{AddedParameter, Proposal};
use crate::candidate::proposal::{Switch, TextEdit, WholeLawParts};
use crate::inspect::inventory::TagPurpose;
use crate::inspect::response::ResponseRange;
use hysteron_identify::study::DeviceMaterial;
use sites::Site;

/// A law that can stand in the place of a device's own.
struct WholeLaw {
    /// Cause of which it is a form.
    cause: &'static str,
    /// The law, in words.
    form: &'static str,
    /// Devices whose law it can replace.
    replaces: Replaces,
    /// Their materials.
    materials: &'static [DeviceMaterial],
    /// Kind and further words of its command. `{tag}` is the tag, `{old}` the last word of a replaced command, `{axial}`
    /// the axial force at rest, `{deformation}` the largest deformation, and parameters are `$::hy_name`.
    command: &'static str,
    /// Parameters that are fitted together.
    parameters: &'static [LawParameter],
    /// Phenomena that parameters can switch off.
    phenomena: &'static [Phenomenon],
    /// Behaviour without them, in words.
    basis: &'static str,
    /// Source of the law.
    #[cfg_attr(not(test), allow(dead_code))]
    source: &'static str,
}

/// Devices whose law can be replaced.
enum Replaces {
    /// Materials of these kinds in the directions in which a device moves, and parallel ones of them. With `bearings`, the
    /// law of [`sites::BEARINGS`] too.
    Shear { kinds: &'static [&'static str], bearings: bool },
    /// Friction of these kinds at a slider.
    Friction(&'static [&'static str]),
}

/// Place of the axial force at rest in a command.
const AXIAL: &str = "{axial}";
/// Place of the largest deformation in a command.
const DEFORMATION: &str = "{deformation}";

/// Materials that stand for a rubber bearing in scripts.
const LAWS_OF_RUBBER: &[&str] = &["Elastic", "Steel01", "Hardening", "BoucWen", "KikuchiAikenLRB"];

/// A parameter of a law. Start and range are multiples of its unit.
struct LawParameter {
    name: &'static str,
    start: f64,
    range: [f64; 2],
    logarithmic: bool,
    unit: LawUnit,
    /// Source of the range.
    #[cfg_attr(not(test), allow(dead_code))]
    source: &'static str,
}

/// Unit of a parameter: a size of the device as the user has fitted it.
#[derive(Clone, Copy)]
enum LawUnit {
    /// A number.
    One,
    /// Its largest deformation.
    Deformation,
    /// Its largest force.
    Force,
    /// The reciprocal of its largest speed.
    PerSpeed,
}

impl LawUnit {
    fn of(self, group: &MovingGroup<'_>) -> f64 {
        match self {
            Self::One => 1.0,
            Self::Deformation => group.deformation,
            Self::Force => group.force,
            Self::PerSpeed => 1.0 / group.speed,
        }
    }
}

impl LawParameter {
    const fn linear(name: &'static str, start: f64, range: [f64; 2], unit: LawUnit, source: &'static str) -> Self {
        Self { name, start, range, logarithmic: false, unit, source }
    }

    const fn log(name: &'static str, start: f64, range: [f64; 2], unit: LawUnit, source: &'static str) -> Self {
        Self { name, start, range, logarithmic: true, unit, source }
    }

    fn added(&self, group: &MovingGroup<'_>) -> AddedParameter {
        let unit = self.unit.of(group);
        let make = if self.logarithmic { AddedParameter::log } else { AddedParameter::linear };
        make(self.name, unit * self.range[0], unit * self.range[1], unit * self.start)
    }
}

/// A phenomenon of a law, with the values of parameters that switch it off, in their units.
struct Phenomenon {
    name: &'static str,
    /// Cause that it is an effect of; none where the library has no name for it.
    cause: Option<&'static str>,
    neutral: &'static [(&'static str, f64)],
}

/// All laws.
const LAWS: &[&WholeLaw] = &[
    &kikuchi_aiken_hdr::SOFTENING,
    &kikuchi_aiken_hdr::STIFFENING,
    &gallardo_shear::LAW,
    &hdr_rheology::LAW,
    &pinched_hysteretic::LAW,
    &friction_with_speed::LAW,
    &friction_with_pressure::LAW,
    &friction_with_speed_and_pressure::LAW,
];

impl WholeLaw {
    /// Switches of its phenomena for a device.
    fn switches(&self, group: &MovingGroup<'_>) -> Vec<Switch> {
        let value = |(name, x): &(&str, f64)| {
            let p = self.parameters.iter().find(|p| p.name == *name)?;
            Some((format!("hy_{name}"), x * p.unit.of(group)))
        };
        let switch = |p: &Phenomenon| {
            let neutral = p.neutral.iter().filter_map(value).collect();
            Switch { phenomenon: p.name, cause: p.cause, neutral }
        };
        self.phenomena.iter().map(switch).collect()
    }

    /// The law at some commands of the script; `None` if it needs an axial force and there is none.
    fn proposal(&self, group: &MovingGroup<'_>, site: Site, axial: Option<f64>) -> Option<Proposal> {
        let edit = |e: TextEdit| -> Option<TextEdit> {
            let text = e.text.replace(DEFORMATION, &format!("{:.6e}", group.deformation));
            let e = TextEdit { text, ..e };
            if !e.text.contains(AXIAL) {
                return Some(e);
            }
            Some(TextEdit { text: e.text.replace(AXIAL, &format!("{:.6e}", axial?)), ..e })
        };
        let option_edits = site.edits.into_iter().map(edit).collect::<Option<_>>()?;
        let parameters = self.parameters.iter().map(|p| p.added(group)).collect();
        let proposal = Proposal::script_edit(self.cause, self.form, group.location(), vec![], parameters);
        Some(Proposal {
            option_edits,
            declared_at: Some(site.first),
            whole_law: Some(WholeLawParts { switches: self.switches(group), basis: self.basis }),
            ..proposal
        })
    }
}

/// Forms of a cause that replace the law of the devices with the most work.
pub(super) fn proposals(cause: &'static str, s: &ProposalContext<'_>) -> Vec<Proposal> {
    let suits = |law: &WholeLaw| s.study.material.is_none_or(|m| law.materials.contains(&m));
    let laws = || LAWS.iter().filter(|law| law.cause == cause && suits(law));
    if laws().next().is_none() {
        return vec![];
    }
    let groups = s.moving_groups(false);
    let Some(group) = groups.iter().max_by(|a, b| a.work.total_cmp(&b.work)).filter(|g| g.work > 0.0) else {
        return vec![];
    };
    let commands = device_commands(s.text, s.model_end);
    let first_tag = s.inventory.first_tag(TagPurpose::WholeLaws);
    // A script may bring its weight on with the motion.
    let at_rest = |x: ResponseRange| if x.initial_force > 0.0 { x.initial_force } else { x.force };
    let axial = group.axial_range(s).map(at_rest).filter(|n| *n > 0.0);
    laws().filter_map(|law| law.proposal(group, sites::find(law, group, &commands, first_tag)?, axial)).collect()
}

#[cfg(test)]
mod tests {
    use super::{LAWS, LawUnit, Replaces};
    use crate::hypothesis;

    #[test]
    fn laws_are_complete() {
        for law in LAWS {
            assert!(hypothesis::of(law.cause).is_some() && !law.source.is_empty() && !law.basis.is_empty());
            for p in law.parameters {
                assert!(law.command.contains(&format!("$::hy_{}", p.name)), "{}: {}", law.form, p.name);
                assert!(p.range[0] <= p.start && p.start <= p.range[1], "{}: {}", law.form, p.name);
                assert!(!p.source.is_empty(), "{}: {}", law.form, p.name);
            }
            for (name, x) in law.phenomena.iter().flat_map(|p| p.neutral) {
                let parameter = law.parameters.iter().find(|p| p.name == *name);
                assert!(parameter.is_some(), "{}: {name}", law.form);
                assert!(x.is_finite(), "{}: {name}", law.form);
            }
            assert!(law.command.contains("{tag}"), "{}", law.form);
            // The friction of a slider keeps the user's coefficient.
            assert_eq!(law.command.contains("{old}"), matches!(law.replaces, Replaces::Friction(_)), "{}", law.form);
        }
        assert!(LAWS.iter().any(|law| law.parameters.iter().any(|p| matches!(p.unit, LawUnit::Force))));
    }
}
