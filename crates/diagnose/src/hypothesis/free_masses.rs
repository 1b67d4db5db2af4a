//! Masses that move against the ground without a device between them, and the ground beside them.

use super::ProposalContext;
use super::context::node_coordinates;
use crate::inspect::inventory::Mass;
use crate::inspect::response::NodeMotion;
use std::f64::consts::TAU;

/// Masses that get parts of their own, at most.
const MAX_MASSES: usize = 6;

/// A mass that moves horizontally and stands on no device on a support.
pub(super) struct FreeMass<'a> {
    pub(super) mass: &'a Mass,
    /// Horizontal directions in which it moves; not empty.
    pub(super) directions: Vec<MovingDirection>,
}

/// A direction of a mass in the fitted baseline.
pub(super) struct MovingDirection {
    /// Degree of freedom, from 1.
    pub(super) dof: usize,
    /// Range of its motion against the ground.
    pub(super) motion: NodeMotion,
    /// Largest force of inertia.
    pub(super) inertia: f64,
}

/// The free masses of a model, in its order. Beside a device on a support a part would be a matter of the device.
pub(super) fn free_masses<'a>(s: &ProposalContext<'a>) -> Vec<FreeMass<'a>> {
    s.inventory.masses.iter().filter_map(|mass| free_mass(s, mass)).take(MAX_MASSES).collect()
}

fn free_mass<'a>(s: &ProposalContext<'_>, mass: &'a Mass) -> Option<FreeMass<'a>> {
    // A chain along one axis moves along it.
    let horizontal = (1..s.inventory.ndm.max(2)).filter(|dof| mass.mass.get(dof - 1).is_some_and(|x| *x > 0.0));
    let directions: Vec<MovingDirection> = horizontal
        .filter_map(|dof| {
            let motion = *s.responses.node_motions.get(&(mass.node, dof))?;
            Some(MovingDirection { dof, motion, inertia: mass.mass[dof - 1] * motion.acceleration })
        })
        .filter(|d| d.motion.velocity > 0.0 && d.inertia > 0.0)
        .collect();
    let is_ground = |node: &i32| *node != mass.node && directions.iter().any(|d| s.inventory.is_held(*node, d.dof));
    let stands_on_device =
        s.inventory.devices.iter().any(|d| d.nodes.contains(&mass.node) && d.nodes.iter().any(is_ground));
    (!directions.is_empty() && !stands_on_device).then_some(FreeMass { mass, directions })
}

impl FreeMass<'_> {
    /// The direction in which it moves fastest.
    pub(super) fn fastest(&self) -> &MovingDirection {
        let faster = |a: &&MovingDirection, b: &&MovingDirection| a.motion.velocity.total_cmp(&b.motion.velocity);
        self.directions.iter().max_by(faster).unwrap_or(&self.directions[0])
    }

    /// Commands for a node of the ground at the place of the mass.
    pub(super) fn ground_node(&self, tag: i32, ndm: usize) -> [String; 2] {
        [
            format!("node {tag} {}", node_coordinates(self.mass.node, ndm)),
            format!("fix {tag} {}", vec!["1"; self.mass.mass.len()].join(" ")),
        ]
    }

    /// Commands for a mass beside it that stands on a spring on the node `ground`, with a damping ratio of its own. Its mass is
    /// the parameter `neighbour`, and its period the parameter `period`.
    pub(super) fn neighbour(&self, s: &ProposalContext<'_>, (ground, tag): (i32, i32), dof: usize) -> Vec<String> {
        /// Damping ratio of buildings (Chopra, Dynamics of Structures, 11.2).
        const RATIO: f64 = 0.03;
        let ndf = self.mass.mass.len();
        let of_dofs = |moving: &str, other: &str| {
            let words = (1..=ndf).map(|d| if d == dof { moving } else { other });
            words.collect::<Vec<_>>().join(" ")
        };
        let [spring, dashpot] = [tag + 1, tag + 2];
        vec![
            format!("node {tag} {}", node_coordinates(self.mass.node, s.inventory.ndm)),
            format!("fix {tag} {}", of_dofs("0", "1")),
            format!("mass {tag} {}", of_dofs("$hy_neighbour", "0.0")),
            format!("uniaxialMaterial Elastic {spring} [expr {{$hy_neighbour*pow({TAU:.10}/$hy_period,2)}}]"),
            format!(
                "uniaxialMaterial Viscous {dashpot} [expr {{{:.4}*$hy_neighbour*{TAU:.10}/$hy_period}}] 1.0",
                2.0 * RATIO
            ),
            format!("element zeroLength {spring} {ground} {tag} -mat {spring} {dashpot} -dir {dof} {dof}"),
        ]
    }

    /// The mass in words.
    pub(super) fn location(&self) -> String {
        format!("node {}", self.mass.node)
    }
}
