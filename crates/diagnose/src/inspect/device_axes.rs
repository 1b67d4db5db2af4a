//! Axial and lateral directions of devices, for every class of element and every orientation.
//!
//! Of the translations of a device:
//!
//! 1. The single direction of a device is that in which it acts.
//! 2. The axis of a bearing is its direction 1, by the definition of its class.
//! 3. The axis of springs with a law each is the vertical. Where heights do not show a vertical, it is the last axis of the
//!    model, if the springs carry force along it at rest.
//!
//! All others are lateral.

use super::inventory::{Device, Direction, ModelInventory};
use super::response::ResponseRanges;

/// Classes of elements with a law of its own in each direction: the class has no axis.
const SPRING_CLASSES: [&str; 2] = ["ZeroLength", "TwoNodeLink"];
/// Least force at rest, over the largest one, of a direction that carries weight.
const MIN_INITIAL_FORCE_SHARE: f64 = 0.1;
/// Distance of two nodes, in parts of the model's extent, from which it says which of them is in front.
const MIN_DISTANCE: f64 = 1e-6;

/// Direction that carries the axial force of a device.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct AxialDirection {
    /// Number of the direction.
    pub(crate) number: usize,
    /// Sign of the deformation that is tension, 1 or -1; none if neither nodes nor loads tell it.
    pub(crate) tension: Option<f64>,
}

/// Translations of devices by their role.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct DeviceAxes {
    /// The axis; none if there is none, or if devices of a group differ in it.
    pub(crate) axial: Option<AxialDirection>,
    /// All other translations, in the order of the device.
    pub(crate) lateral: Vec<usize>,
    /// True if the only translation is the axis, as of a vertical spring: it is lateral as well.
    pub(crate) is_single: bool,
}

/// Axes of devices of one kind.
pub(crate) fn device_axes(devices: &[&Device], inventory: &ModelInventory, responses: &ResponseRanges) -> DeviceAxes {
    let Some((first, others)) = devices.split_first() else { return DeviceAxes::default() };
    let mut axes = axes_of(first, inventory, responses);
    // A force that is compression in one device and tension in the next is no common axial force.
    if others.iter().any(|d| axes_of(d, inventory, responses).axial != axes.axial) {
        axes.axial = None;
    }
    axes
}

fn axes_of(device: &Device, inventory: &ModelInventory, responses: &ResponseRanges) -> DeviceAxes {
    let translations: Vec<&Direction> = device.directions.iter().filter(|d| d.number <= 3).collect();
    let axial = |d: &Direction| AxialDirection { number: d.number, tension: tension(device, d, inventory, responses) };
    if let ([only], [_]) = (&translations[..], &device.directions[..]) {
        let axial = Some(axial(only));
        return DeviceAxes { axial, lateral: vec![only.number], is_single: true };
    }
    let is_axis = |d: &&Direction| match vertical_component(d, inventory) {
        _ if !SPRING_CLASSES.contains(&device.class) => d.number == 1,
        Some(vertical) => vertical,
        None => d.along_last_axis && force_at_rest(device, d, responses).is_some(),
    };
    let axis = translations.iter().copied().find(is_axis);
    let lateral = translations.iter().map(|d| d.number).filter(|n| axis.is_none_or(|a| a.number != *n));
    DeviceAxes { axial: axis.map(axial), lateral: lateral.collect(), is_single: false }
}

/// True if a direction is vertical; none where the model does not tell which axis is.
fn vertical_component(direction: &Direction, inventory: &ModelInventory) -> Option<bool> {
    inventory.vertical_axis().map(|_| direction.along_last_axis)
}

/// Sign of the deformation that is tension: that which takes the nodes apart, or that against the force at rest.
fn tension(device: &Device, d: &Direction, inventory: &ModelInventory, responses: &ResponseRanges) -> Option<f64> {
    if !SPRING_CLASSES.contains(&device.class) {
        return Some(1.0);
    }
    let [i, j] = device.nodes.map(|n| inventory.coordinates.get(&n));
    let distance: f64 = i.zip(j).map_or(0.0, |(i, j)| j.iter().zip(i).zip(d.axis).map(|((j, i), a)| (j - i) * a).sum());
    if distance.abs() > MIN_DISTANCE * inventory.extent {
        return Some(distance.signum());
    }
    force_at_rest(device, d, responses).filter(|_| d.along_last_axis).map(|force| -force.signum())
}

/// Force of the first sample, if it is that of a load at rest.
fn force_at_rest(device: &Device, direction: &Direction, responses: &ResponseRanges) -> Option<f64> {
    let mut histories = responses.histories.iter();
    let (_, history) = histories.find(|((_, tag, d), _)| *tag == device.tag && *d == direction.number)?;
    let first = *history.force.first()?;
    let most = history.range().force;
    (first.abs() > MIN_INITIAL_FORCE_SHARE * most && most > 0.0).then_some(first)
}

#[cfg(test)]
mod tests {
    use super::{AxialDirection, DeviceAxes, device_axes};
    use crate::inspect::inventory::ModelInventory;
    use crate::inspect::probe::tests::inventory_of;
    use crate::inspect::response::{ResponseHistory, ResponseRanges};

    /// A block on a device between nodes 1 and 2, in elevation or in plan.
    fn model(elevation: bool, element: &str) -> ModelInventory {
        let top = if elevation { 3.0 } else { 0.0 };
        let text = format!(
            "model basic -ndm 2 -ndf 3\nnode 1 0. 0.\nnode 2 0. 0.\nnode 3 0. {top}\nfix 1 1 1 1\nfix 3 0 0 1\n\
             mass 3 1. 1. 1.\nrigidLink beam 3 2\nuniaxialMaterial Elastic 1 1e3\nuniaxialMaterial Elastic 7 1e6\n\
             uniaxialMaterial Viscous 8 1e2 1.0\nelement {element}\ntimeSeries Constant 2\n\
             pattern UniformExcitation 2 1 -accel 2\nconstraints Transformation\nsystem FullGeneral\n\
             integrator Newmark 0.5 0.25\nanalysis Transient\nanalyze 2 0.01\n"
        );
        inventory_of(&text)
    }

    /// Its axes, with a force at rest in a direction.
    fn axes(inventory: &ModelInventory, at_rest: Option<(usize, f64)>) -> DeviceAxes {
        let mut responses = ResponseRanges::default();
        if let Some((direction, force)) = at_rest {
            let history =
                ResponseHistory { times: vec![0.0, 1.0], deformation: vec![0.0, 0.0], force: vec![force, 1.5 * force] };
            responses.histories.insert((0, inventory.devices[0].tag, direction), history);
        }
        device_axes(&[&inventory.devices[0]], inventory, &responses)
    }

    fn of(axial: Option<(usize, Option<f64>)>, lateral: &[usize]) -> DeviceAxes {
        let axial = axial.map(|(number, tension)| AxialDirection { number, tension });
        DeviceAxes { axial, lateral: lateral.into(), is_single: false }
    }

    /// A bearing of springs has one axis, however its springs, local axes and nodes are written.
    #[test]
    fn one_bearing_has_one_axis_in_every_notation() {
        let upright = "-mat 1 7 8 -dir 1 2 2";
        let dashpot_first = "-mat 1 8 7 -dir 1 2 2";
        let turned = "-mat 7 8 1 -dir 1 1 2 -orient 0 1 0 -1 0 0";
        for (element, axis, lateral, at_rest) in [
            (format!("zeroLength 1 1 2 {upright}"), 2, 1, -5.0),
            (format!("zeroLength 1 1 2 {dashpot_first}"), 2, 1, -5.0),
            (format!("zeroLength 1 1 2 {turned}"), 1, 2, -5.0),
            (format!("twoNodeLink 1 1 2 {turned}"), 1, 2, -5.0),
            // With its nodes exchanged the weight is a positive force.
            (format!("zeroLength 1 2 1 {upright}"), 2, 1, 5.0),
        ] {
            let inventory = model(true, &element);
            let expected = of(Some((axis, Some(-f64::signum(at_rest)))), &[lateral]);
            assert_eq!(axes(&inventory, Some((axis, at_rest))), expected, "{element}");
            assert_eq!(axes(&inventory, None), of(Some((axis, None)), &[lateral]), "{element}");
            let columns: Vec<usize> = inventory.devices[0].directions.iter().map(|d| d.columns.len()).collect();
            assert_eq!(columns.iter().sum::<usize>(), 3, "{element}");
        }
    }

    /// In plan both directions are lateral; only a force at rest makes the last axis vertical.
    #[test]
    fn a_plan_has_no_axis_without_a_load_at_rest() {
        let inventory = model(false, "zeroLength 1 1 2 -mat 1 7 -dir 1 2");
        assert_eq!(axes(&inventory, None), of(None, &[1, 2]));
        assert_eq!(axes(&inventory, Some((1, -5.0))), of(None, &[1, 2]));
        assert_eq!(axes(&inventory, Some((2, -5.0))), of(Some((2, Some(1.0))), &[1]));
    }

    #[test]
    fn a_single_spring_acts_along_itself_and_a_bearing_has_the_axis_of_its_class() {
        let lift = model(true, "zeroLength 1 1 2 -mat 7 -dir 2");
        let axial = Some(AxialDirection { number: 2, tension: Some(1.0) });
        assert_eq!(axes(&lift, Some((2, -5.0))), DeviceAxes { axial, lateral: vec![2], is_single: true });
        let bearing = "elastomericBearingPlasticity 1 1 2 1e3 1e1 0.1 0. 1. -P 7 -Mz 7 -orient 0 1 0 -1 0 0";
        assert_eq!(axes(&model(true, bearing), None), of(Some((1, Some(1.0))), &[2]));
    }
}
