//! Loop of the device that a verdict is about, before and after the repair.

use super::place::{Place, direction_name};
use super::quantity::Units;
use super::residual_force::{ResidualForce, element_of};
use super::result_file::Mismatch;
use crate::candidate::proposal::Proposal;
use crate::candidate::repaired_script::edited_script;
use crate::candidate::variant::Variant;
use crate::inspect::insertion::InsertionPoint;
use crate::inspect::inventory::ModelInventory;
use crate::inspect::probe::{inspect_model, record_responses_of};
use crate::inspect::response::{ResponseHistory, ResponseRanges};
use crate::series::power;
use hysteron_identify::report::html::{labelled, line, recorded};
use hysteron_identify::study::unit::{self, Quantity};
use hysteron_identify::study::{ObservedChannel, Role, SimulatorFactory, Study};
use hysteron_opensees::chart::{Curve, Figure};

/// The loop of a device in one direction and one run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DeviceLoop {
    /// Name of the run.
    pub run: String,
    /// Tag of the element.
    pub element: i32,
    /// Direction along the global axes, in words.
    pub direction: String,
    /// Units of deformation and force; empty if they are not known.
    pub units: [String; 2],
    /// Deformation and force as recorded; empty where no channel shows that force of a known deformation.
    pub recorded: Vec<(f64, f64)>,
    /// The same of the user's fitted model.
    pub before: Vec<(f64, f64)>,
    /// The same of the repaired model; empty where its device is the same.
    pub after: Vec<(f64, f64)>,
}

/// Models and recordings from which a loop is drawn.
pub(super) struct LoopSources<'a> {
    pub(super) study: &'a Study,
    pub(super) inventory: &'a ModelInventory,
    /// Responses of the user's fitted model, and of the repaired one; none where it has the same devices.
    pub(super) before: &'a ResponseRanges,
    pub(super) after: Option<&'a ResponseRanges>,
    /// Names of the observed columns by run.
    pub(super) columns: &'a [Vec<String>],
    pub(super) units: &'a Units,
    /// True if motions of nodes are imposed, so that the recording has the deformation of the model.
    pub(super) imposed_motion: bool,
}

/// Parts of the model and the channel that a verdict blames.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct BlamedParts {
    /// Tags of elements.
    elements: Vec<i32>,
    /// Name of a faulty channel.
    channel: Option<String>,
}

/// The parts at the places of the effects, or else those with the largest missing force.
pub(super) fn blamed_parts(places: &[Place], residual_forces: &[ResidualForce]) -> BlamedParts {
    let of_places = places.iter().flat_map(|p| &p.elements);
    let of_forces = residual_forces.first().into_iter().flat_map(|f| &f.elements);
    let elements = if places.is_empty() { of_forces.copied().collect() } else { of_places.copied().collect() };
    BlamedParts { elements, channel: places.iter().map(|p| &p.channel).find(|c| !c.is_empty()).cloned() }
}

/// Responses of the devices of a repaired model in the fitted runs. `None` where the repair leaves the script `text` as it is.
pub(super) fn repaired_responses(
    factory: &SimulatorFactory,
    text: &str,
    point: &InsertionPoint,
    variant: &Variant,
    values: &[f64],
) -> Option<ResponseRanges> {
    let proposal = variant.proposal.as_ref().filter(|p| p.edits_script())?;
    // Another law has other columns.
    let (_, inventory) = inspect_model(factory, &variant.study, &variant.text, values)?;
    let starts: Vec<f64> = proposal.parameters.iter().map(|a| a.start).collect();
    let with_recorders = |recorders: &[String]| {
        let commands = [&proposal.commands[..], recorders].concat();
        edited_script(text, point, Some(&Proposal { commands, ..proposal.clone() }), &starts, vec![])
    };
    Some(record_responses_of(factory, &variant.study, values, &inventory, Role::Fit, &with_recorders))
}

/// Samples of a force that are not finite end a loop.
fn points(h: &ResponseHistory) -> Vec<(f64, f64)> {
    h.deformation.iter().copied().zip(h.force.iter().copied()).collect()
}

impl LoopSources<'_> {
    /// The loop of the device at the blamed parts, in the run with the largest error.
    ///
    /// Without such a device, as of a faulty channel, it is the one whose force that channel shows, or the one that does the
    /// most work. Of several devices and directions it is the one whose force the repair changes most.
    pub(super) fn of_parts(&self, blamed: &BlamedParts, mismatch: &[Mismatch]) -> Option<DeviceLoop> {
        let run = mismatch.iter().find_map(|m| self.study.runs.iter().position(|r| r.name == m.run))?;
        let at_fault = blamed.channel.as_ref().and_then(|channel| {
            let c = self.study.runs[run].observe.iter().position(|o| o.channel == *channel)?;
            element_of(self.columns.get(run)?.get(c)?)
        });
        let all = || self.before.histories.iter().filter(|((r, _, d), _)| *r == run && *d <= 3);
        let moves = |h: &ResponseHistory| h.range().deformation > 0.0;
        let of = |tags: &[i32]| {
            let members = all().filter(|((_, tag, _), h)| tags.contains(tag) && moves(h));
            members.max_by(|a, b| self.importance(a).total_cmp(&self.importance(b)))
        };
        let most_work = || all().filter(|(_, h)| moves(h)).max_by(|a, b| a.1.range().work.total_cmp(&b.1.range().work));
        let found = of(&blamed.elements).or_else(|| of(&[at_fault?])).or_else(most_work);
        found.map(|(key, before)| self.of_device(*key, before))
    }

    /// Change of the force by the repair over the force; of equal changes the one with more work.
    fn importance(&self, (key, before): &(&(usize, i32, usize), &ResponseHistory)) -> f64 {
        let work = before.range().work;
        let least = work / (1.0 + work) * f64::EPSILON;
        let Some(after) = self.after.and_then(|r| r.histories.get(*key)) else { return least };
        let change: Vec<f64> =
            after.force.iter().zip(&before.force).map(|(a, b)| a - b).filter(|x| x.is_finite()).collect();
        let force: Vec<f64> = before.force.iter().copied().filter(|x| x.is_finite()).collect();
        power(&change) / power(&force).max(f64::MIN_POSITIVE) + least
    }

    fn of_device(&self, key: (usize, i32, usize), before: &ResponseHistory) -> DeviceLoop {
        let (run, element, number) = key;
        let device = self.inventory.devices.iter().find(|d| d.tag == element);
        let axis = device.and_then(|d| d.directions.iter().find(|d| d.number == number)).map(|d| d.axis);
        DeviceLoop {
            run: self.study.runs[run].name.clone(),
            element,
            direction: axis.map_or_else(String::new, |a| direction_name(a, self.inventory)),
            units: [self.units.length.clone(), self.units.force.clone()],
            recorded: if self.imposed_motion { self.recorded(run, element, before) } else { vec![] },
            before: points(before),
            after: self.after.and_then(|r| r.histories.get(&key)).map_or_else(Vec::new, points),
        }
    }

    /// The recorded force of a device over its imposed deformation.
    fn recorded(&self, run: usize, element: i32, before: &ResponseHistory) -> Vec<(f64, f64)> {
        let observed = self.study.runs[run].observe.iter().enumerate();
        let is_shown = |(c, _): &(usize, _)| {
            let column = self.columns.get(run).and_then(|all| all.get(*c));
            column.and_then(|name| element_of(name)) == Some(element)
        };
        let product = |values: &[f64]| -> f64 {
            values.iter().zip(&before.force).map(|(v, f)| v * f).filter(|x| x.is_finite()).sum()
        };
        let square = |values: &[f64]| values.iter().map(|v| v * v).filter(|x| x.is_finite()).sum::<f64>();
        // Of several columns of the element the one that is nearest to this force, with its sign.
        let near = |values: &[f64]| product(values).powi(2) / square(values).max(f64::MIN_POSITIVE);
        // A stress has another scale.
        let is_force = |o: &ObservedChannel| unit::unit(&o.unit).is_none_or(|u| u.quantity == Quantity::Force);
        let shown = observed.filter(|(_, o)| o.is_resistance() && is_force(o)).filter(is_shown);
        let best = shown.max_by(|a, b| near(&a.1.values).total_cmp(&near(&b.1.values)));
        best.map_or_else(Vec::new, |(_, o)| {
            let sign = product(&o.values).signum();
            before.deformation.iter().zip(&o.values).map(|(u, f)| (*u, sign * f)).collect()
        })
    }
}

impl DeviceLoop {
    /// The loop as a chart.
    pub(super) fn figure(&self) -> Figure {
        let mut curves: Vec<Curve> = vec![];
        if !self.recorded.is_empty() {
            curves.push(recorded(self.recorded.clone()));
        }
        curves.push(line("model as it was", self.before.clone()));
        if !self.after.is_empty() {
            curves.push(line("repaired", self.after.clone()));
        }
        let along = if self.direction.is_empty() { String::new() } else { format!(", {}", self.direction) };
        Figure {
            title: format!("Loop of element {}{along}, run {}", self.element, self.run),
            x_label: labelled("deformation", &self.units[0]),
            y_label: labelled("force", &self.units[1]),
            curves,
            ..Figure::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{BlamedParts, DeviceLoop, LoopSources, blamed_parts};
    use crate::inspect::inventory::ModelInventory;
    use crate::inspect::response::{ResponseHistory, ResponseRanges};
    use crate::test_support::pad_study;
    use crate::verdict::place::Place;
    use crate::verdict::quantity::Units;
    use crate::verdict::result_file::Mismatch;

    /// Loops of devices by tag and stiffness: an ellipse each.
    fn responses(devices: &[(i32, f64)]) -> ResponseRanges {
        let history = |(tag, stiffness): &(i32, f64)| {
            let times: Vec<f64> = (0..200).map(|i| 0.1 * f64::from(i)).collect();
            let deformation: Vec<f64> = times.iter().map(|t| t.sin()).collect();
            let force = times.iter().map(|t| stiffness * (t.sin() + 0.3 * t.cos())).collect();
            ((0, *tag, 1), ResponseHistory { times, deformation, force })
        };
        ResponseRanges { histories: devices.iter().map(history).collect(), ..ResponseRanges::default() }
    }

    fn found(before: &[(i32, f64)], after: Option<&[(i32, f64)]>, blamed: &BlamedParts, column: &str) -> DeviceLoop {
        let (study, inventory) = (pad_study(), ModelInventory::default());
        let (before, after) = (responses(before), after.map(responses));
        let columns = vec![vec![column.to_owned()]; study.runs.len()];
        let units = Units { length: "m".into(), force: "kN".into() };
        let worst = Mismatch {
            run: study.runs[0].name.clone(),
            channel: study.runs[0].observe[0].channel.clone(),
            at: String::new(),
            windows: vec![],
            share: 0.0,
            regime: String::new(),
        };
        let sources = LoopSources {
            study: &study,
            inventory: &inventory,
            before: &before,
            after: after.as_ref(),
            columns: &columns,
            units: &units,
            imposed_motion: true,
        };
        sources.of_parts(blamed, &[worst]).expect("a loop")
    }

    #[test]
    fn the_loop_is_that_of_the_device_that_the_repair_changes_most() {
        let before = [(1, 10.0), (2, 1.0), (3, 2.0)];
        let of = |elements: &[i32]| BlamedParts { elements: elements.into(), channel: None };
        let after: &[(i32, f64)] = &[(1, 10.1), (2, 1.0), (3, 3.0)];
        let changed = found(&before, Some(after), &of(&[2, 3]), "");
        assert_eq!((changed.element, changed.after.len()), (3, 200));
        assert!(changed.figure().curves.iter().any(|c| c.name == "repaired") && changed.recorded.is_empty());
        // Of a complete model, and of a channel that shows no element, the device with the most work.
        let plain = found(&before, None, &BlamedParts::default(), "");
        assert_eq!((plain.element, plain.after.len()), (1, 0));
        assert!(plain.figure().curves.iter().all(|c| c.name != "repaired"));
    }

    #[test]
    fn a_faulty_channel_has_the_loop_of_its_element_with_the_recorded_one() {
        let study = pad_study();
        let channel = study.runs[0].observe[0].channel.clone();
        let places = [Place { channel, ..Place::default() }];
        let blamed = blamed_parts(&places, &[]);
        let found = found(&[(1, 10.0), (2, 1.0)], None, &blamed, "element 2 force");
        assert!(found.element == 2 && !found.recorded.is_empty());
        assert_eq!(blamed_parts(&[], &[]), BlamedParts::default());
    }
}
