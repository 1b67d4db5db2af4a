//! Springs between supports and the ground, in the place of fixities.

use super::ProposalContext;
use super::context::node_coordinates;
use crate::inspect::inventory::{ModelInventory, Support, TagPurpose};

/// Supports that change one at a time, at most, and together.
pub(super) const MAX_SINGLE_SUPPORTS: usize = 6;
pub(super) const MAX_JOINT_SUPPORTS: usize = 20;

/// Place of the tag of a material in the words of others.
pub(super) const PART: &str = "{part}";

/// A spring in some degrees of freedom, equal at all supports.
pub(super) struct SupportSpring<'a> {
    /// Kinds of the materials side by side, with their words behind the tag.
    pub(super) materials: Vec<(&'static str, String)>,
    /// A material that acts only inside of others, which name it [`PART`].
    pub(super) part: Option<(&'static str, String)>,
    /// Degrees of freedom, from 1.
    pub(super) dofs: &'a [usize],
}

/// Supports that springs take the place of.
pub(super) struct FreedSupports<'a> {
    pub(super) inventory: &'a ModelInventory,
    pub(super) supports: &'a [&'a Support],
    /// Purpose of the tags of added nodes, elements and materials.
    pub(super) purpose: TagPurpose,
}

impl FreedSupports<'_> {
    /// Commands that free the supports and put springs below them. `mass` is the parameter of the mass that each support gets.
    pub(super) fn commands(&self, springs: &[SupportSpring<'_>], mass: Option<&str>) -> Vec<String> {
        let (ndm, first_tag) = (self.inventory.ndm, self.inventory.first_tag(self.purpose));
        let (mut block, mut all_materials, mut all_directions) = (vec![], vec![], vec![]);
        let mut free_tag = first_tag..;
        for spring in springs {
            let part = spring.part.as_ref().and_then(|(kind, words)| {
                let tag = free_tag.next()?;
                block.push(format!("uniaxialMaterial {kind} {tag} {words}"));
                Some(tag.to_string())
            });
            let tags: Vec<i32> = free_tag.by_ref().take(spring.materials.len()).collect();
            for (tag, (kind, words)) in tags.iter().zip(&spring.materials) {
                let words = words.replace(PART, part.as_deref().unwrap_or_default());
                block.push(format!("uniaxialMaterial {kind} {tag} {words}"));
            }
            for dof in spring.dofs {
                let direction = if ndm == 2 && *dof == 3 { 6 } else { *dof };
                all_materials.extend(tags.iter().map(i32::to_string));
                all_directions.extend(tags.iter().map(|_| direction.to_string()));
            }
        }
        for (support, tag) in self.supports.iter().zip(first_tag..) {
            block.push(format!("node {tag} {}", node_coordinates(support.node, ndm)));
            block.push(format!("fix {tag} {}", vec!["1"; support.ndf].join(" ")));
            for dof in springs.iter().flat_map(|spring| spring.dofs) {
                block.push(format!("remove sp {} {dof}", support.node));
            }
            block.push(format!(
                "element zeroLength {tag} {tag} {} -mat {} -dir {}",
                support.node,
                all_materials.join(" "),
                all_directions.join(" ")
            ));
            block.extend(mass.map(|mass| self.mass_command(support, mass)));
        }
        block
    }

    /// Command for a mass more at a support.
    fn mass_command(&self, support: &Support, mass: &str) -> String {
        let own = self.inventory.masses.iter().find(|m| m.node == support.node).map_or(&[][..], |m| &m.mass);
        let of = |i: usize| own.get(i).copied().unwrap_or(0.0);
        let words = (0..support.ndf).map(|i| match i {
            0 => format!("[expr {{{:e}+$hy_{mass}}}]", of(0)),
            _ => format!("{:e}", of(i)),
        });
        format!("mass {} {}", support.node, words.collect::<Vec<_>>().join(" "))
    }
}

/// Supports that carry elements and are fixed against translations.
pub(super) fn carrying_supports<'a>(s: &'a ProposalContext<'_>) -> Vec<&'a Support> {
    let carries = |p: &&Support| !p.elements.is_empty() && p.fixed.len() >= s.inventory.ndm;
    s.inventory.supports.iter().filter(carries).collect()
}

/// Largest stiffness of the elements on some supports in a degree of freedom.
pub(super) fn largest_stiffness(supports: &[&Support], dof: usize) -> f64 {
    supports.iter().fold(0.0, |a: f64, p| a.max(p.stiffness[dof - 1]))
}

/// Fixed horizontal degrees of freedom with a stiffness above; a chain along one axis moves along it.
pub(super) fn horizontal_dofs(supports: &[&Support], ndm: usize) -> Vec<usize> {
    let fixed = &supports[0].fixed;
    (1..ndm.max(2)).filter(|d| fixed.contains(d) && largest_stiffness(supports, *d) > 0.0).collect()
}
