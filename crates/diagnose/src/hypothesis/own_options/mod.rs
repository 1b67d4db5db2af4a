//! Effects that a law has itself: forms that switch an option of a device's own command on.
//!
//! The words of the command are edited in the script. A command in a loop or a procedure makes several devices, and they
//! all change. A new form is a row in [`table`].

mod table;

use super::context::{MovingGroup, ProposalContext};
use super::device_commands::{DeviceCommand, device_commands};
use super::{AddedParameter, Proposal};
use crate::candidate::proposal::TextEdit;
use table::OWN_OPTIONS;

/// A form of an effect by options of a command. Words count from that of the command itself, from 0.
pub(super) struct OwnOption {
    /// Kinds of the `element` or `uniaxialMaterial` command.
    kinds: &'static [&'static str],
    /// Effect.
    cause: &'static str,
    /// Form, in words.
    form: &'static str,
    /// Numbers of words that the command may have; empty for any.
    lengths: &'static [usize],
    /// Words that it must have.
    needs: &'static [&'static str],
    /// Words that it must not have.
    without: &'static [&'static str],
    /// Words by index, the number that each must be, and what takes its place. `{old}` is the word itself, `{n}` word n.
    replaced: &'static [(usize, Option<f64>, &'static str)],
    /// Option whose value is replaced.
    after: Option<(&'static str, &'static str)>,
    /// Words behind the last; empty for none.
    appended: &'static str,
    /// Added parameters.
    parameters: &'static [OwnParameter],
    /// Source of the law and of the ranges.
    #[cfg_attr(not(test), allow(dead_code))]
    source: &'static str,
}

/// Parameter of an option.
pub(super) struct OwnParameter {
    name: &'static str,
    range: [f64; 2],
    start: f64,
    logarithmic: bool,
    unit: Unit,
}

/// Unit of a range.
#[derive(Clone, Copy)]
enum Unit {
    /// As it is written.
    One,
    /// Times its largest deformation.
    Deformation,
    /// Over its work.
    PerWork,
}

impl OwnParameter {
    const fn linear(name: &'static str, lower: f64, upper: f64, start: f64, unit: Unit) -> Self {
        Self { name, range: [lower, upper], start, logarithmic: false, unit }
    }

    const fn log(name: &'static str, lower: f64, upper: f64, start: f64, unit: Unit) -> Self {
        Self { name, range: [lower, upper], start, logarithmic: true, unit }
    }

    fn added(&self, group: &MovingGroup<'_>) -> AddedParameter {
        let scale = match self.unit {
            Unit::One => 1.0,
            Unit::Deformation => group.deformation,
            Unit::PerWork => 1.0 / group.work,
        };
        let make = if self.logarithmic { AddedParameter::log } else { AddedParameter::linear };
        make(self.name, scale * self.range[0], scale * self.range[1], scale * self.start)
    }
}

impl OwnOption {
    /// Edits of a command; `None` if the form does not suit it.
    fn edits(&self, command: &DeviceCommand<'_>) -> Option<Vec<TextEdit>> {
        let words = &command.words;
        let has = |option: &&str| words.iter().any(|w| w.text == *option);
        let suits = self.kinds.contains(&words.get(1)?.text)
            && (self.lengths.is_empty() || self.lengths.contains(&words.len()))
            && self.needs.iter().all(has)
            && !self.without.iter().any(has);
        if !suits {
            return None;
        }
        let mut out = vec![];
        for (index, number, with) in self.replaced {
            let word = words.get(*index)?;
            if number.is_some_and(|n| word.text.parse() != Ok(n)) {
                return None;
            }
            let named = with.replace("{old}", word.text);
            let text = words.iter().enumerate().fold(named, |text, (n, w)| text.replace(&format!("{{{n}}}"), w.text));
            out.push(TextEdit { start: word.start, end: word.end, text });
        }
        if let Some((option, with)) = self.after {
            let word = words.get(words.iter().position(|w| w.text == option)? + 1)?;
            out.push(TextEdit { start: word.start, end: word.end, text: with.to_owned() });
        }
        if !self.appended.is_empty() {
            let end = words.last()?.end;
            out.push(TextEdit { start: end, end, text: format!(" {}", self.appended) });
        }
        Some(out)
    }
}

/// Forms of a cause by options of the commands in the script.
pub(super) fn proposals(cause: &'static str, s: &ProposalContext<'_>) -> Vec<Proposal> {
    let rows = || OWN_OPTIONS.iter().filter(|row| row.cause == cause);
    if !rows().any(|row| row.kinds.iter().any(|kind| s.text.contains(kind))) {
        return vec![];
    }
    let groups = s.moving_groups(false);
    let Some(group) = groups.iter().max_by(|a, b| a.work.total_cmp(&b.work)).filter(|g| g.work > 0.0) else {
        return vec![];
    };
    let commands = device_commands(s.text, s.model_end);
    let form = |row: &OwnOption| {
        // Commands of one kind make identical devices, which share the parameters.
        let edited: Vec<(usize, Vec<TextEdit>)> =
            commands.iter().filter_map(|c| Some((c.outermost, row.edits(c)?))).collect();
        let declared_at = edited.iter().map(|(outermost, _)| *outermost).min()?;
        let edits = edited.into_iter().flat_map(|(_, edits)| edits).collect();
        let parameters = row.parameters.iter().map(|p| p.added(group)).collect();
        let proposal = Proposal::script_edit(cause, row.form, group.location(), vec![], parameters);
        Some(Proposal { option_edits: edits, declared_at: Some(declared_at), ..proposal })
    };
    rows().filter_map(form).collect()
}

#[cfg(test)]
mod tests {
    use super::table::OWN_OPTIONS;
    use crate::hypothesis;
    use crate::hypothesis::device_commands::device_commands;

    /// The script after the first form of a cause; `None` if no command takes it.
    fn edited(cause: &str, text: &str) -> Option<String> {
        let commands = device_commands(text, text.len());
        let rows = OWN_OPTIONS.iter().filter(|row| row.cause == cause);
        let mut edits = rows.flat_map(|row| commands.iter().filter_map(|c| row.edits(c))).next()?;
        edits.sort_by_key(|e| std::cmp::Reverse(e.start));
        let mut out = text.to_owned();
        edits.iter().for_each(|e| out.replace_range(e.start..e.end, &e.text));
        Some(out)
    }

    #[test]
    fn options_are_appended_and_replaced() {
        let rubber = "uniaxialMaterial HDRRheology 1 -compound HDR3 -temperature 23 ;# cold";
        let heated = "uniaxialMaterial HDRRheology 1 -compound HDR3 -temperature 23 -heatCapacity $::hy_heatCapacity \
                      -beyond hold ;# cold";
        assert_eq!(edited("self_heating", rubber).as_deref(), Some(heated));
        let cold = "uniaxialMaterial HDRRheology 1 -compound HDR3 -temperature $::hy_temperature ;# cold";
        assert_eq!(edited("ambient_temperature", rubber).as_deref(), Some(cold));
        // Ten numbers have no table over the temperature, and options that are there stay.
        let explicit = "uniaxialMaterial HDRRheology 1 1 2 3 4 5 6 7 8 9 0.5";
        assert_eq!(edited("self_heating", explicit), None);
        assert_eq!(edited("self_heating", heated), None);
        let steel = "uniaxialMaterial Hysteretic 2 1 .1 2 .2 -1 -.1 -2 -.2 $p 1 0.0 0.";
        assert_eq!(edited("pinching", steel), None);
        let damaged = steel.replace("0.0 0.", "$::hy_damageDuctility $::hy_damageEnergy");
        assert_eq!(edited("cyclic_degradation", steel), Some(damaged));
        // The Bouc-Wen law has the numbers of the bilinear one, in other places.
        let (sharp, scale) =
            ("uniaxialMaterial Steel01 2 $Fy 2000.0 0.02", "[expr {0.5/pow(double($Fy)/(2000.0),$::hy_exponent)}]");
        let smooth = format!("uniaxialMaterial BoucWen 2 0.02 2000.0 $::hy_exponent {scale} {scale} 1.0 0.0 0.0 0.0");
        assert_eq!(edited("rounded_yielding", sharp), Some(smooth));
        assert_eq!(edited("rounded_yielding", &format!("{sharp} 0 1 0 1")), None);
        let sharp = "element elastomericBearingPlasticity 1 1 2 $k $q 0.1 0.0 1.0 -P 7 -Mz 8";
        let smooth = "element elastomericBearingBoucWen 1 1 2 $k $q 0.1 0.0 1.0 $::hy_exponent 0.5 0.5 -P 7 -Mz 8";
        assert_eq!(edited("rounded_yielding", sharp).as_deref(), Some(smooth));
    }

    #[test]
    fn commands_inside_procedures_and_loops_are_found() {
        let text = "proc bearings {} {\n  foreach n {1 2} {\n    uniaxialMaterial BoucWen $n .1 9. 1 5 5 1 0 0 0\n  }\n}\nbearings\n";
        let commands = device_commands(text, text.len());
        assert_eq!((commands.len(), commands[0].outermost, commands[0].words.len()), (1, 0, 12));
        let last = commands[0].words.last().expect("words");
        assert_eq!(&text[last.start - 4..last.end], "0 0 0");
    }

    #[test]
    fn rows_are_complete() {
        for row in OWN_OPTIONS {
            assert!(hypothesis::of(row.cause).is_some() && !row.source.is_empty(), "{}", row.form);
            let words: Vec<&str> = row.replaced.iter().map(|r| r.2).chain(row.after.map(|a| a.1)).collect();
            let text = words.join(" ") + row.appended;
            for p in row.parameters {
                assert!(text.contains(&format!("$::hy_{}", p.name)), "{}: {}", row.form, p.name);
                assert!(p.range[0] <= p.start && p.start <= p.range[1], "{}: {}", row.form, p.name);
            }
        }
    }
}
