//! Flexible soil or supports below a fixed base.

use super::declaration::{Dimension, Measurement, Quantity, Recordable};
use super::support_springs::{
    FreedSupports, MAX_JOINT_SUPPORTS, MAX_SINGLE_SUPPORTS, PART, SupportSpring, carrying_supports, horizontal_dofs,
    largest_stiffness,
};
use super::yielding_joint::YieldingJoint;
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext, superstructure_yielding};
use crate::inspect::conditions::amplitudes_differ;
use crate::inspect::inventory::{Support, TagPurpose, grouped};

/// Name of the cause.
pub(super) const CAUSE: &str = "foundation_flexibility";

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: CAUSE,
    statement: "the soil or the support below the fixed base of the model gives way",
    refuted_by: "the base of the structure does not move against the free field",
    look_alikes: &["superstructure_yielding", "isolation_layer", "damping"],
    shows: "a longer period than the model's; a base that moves or rocks against the free field",
    parted_by: "the period is longer at small amplitudes too; a record of the footing's rotation tells soil that yields from a hinge above it",
    place: "supports of a shaken model: 6 alone, and groups of 2 to 20",
    forms: "horizontal spring, rocking spring, or both, each with a dashpot, and each of them alone without one; a spring that yields in sliding or rocking; a footing with mass; soil that follows the footing; a footing that lifts off",
    needs_clock: false,
    memory: &[],
    materials: &[],
    measurement: Measurement::new(
        "put one accelerometer on the foundation at {place} and one on free ground: they must differ",
        "record the displacement of the support at {place}",
    )
    .unless_at_building(Recordable::Acceleration)
    .unless_in_rig(Recordable::Deformation),
    quantities: &[
        Quantity::new("sway", "horizontal stiffness", Dimension::Stiffness),
        Quantity::new("sway_dashpot", "horizontal damping", Dimension::Dashpot),
        Quantity::new("rocking", "rocking stiffness", Dimension::RotationalStiffness),
        Quantity::new("rocking_dashpot", "rocking damping", Dimension::RotationalDashpot),
        Quantity::new("sway_follows", "part of the dashpot behind which soil follows the footing", Dimension::Ratio),
        Quantity::new("sway_time", "time in which the soil follows", Dimension::Time),
        Quantity::new("sway_yield", "yield force", Dimension::Force),
        Quantity::new("sway_hardening", "hardening ratio", Dimension::Ratio),
        Quantity::new("rocking_yield", "yield moment", Dimension::Moment),
        Quantity::new("rocking_plastic", "rocking stiffness after yielding", Dimension::RotationalStiffness),
        Quantity::new("rocking_lift", "moment at which the footing lifts off", Dimension::Moment),
        Quantity::new(
            "rocking_lifted",
            "rocking stiffness of the lifted footing over that in full contact",
            Dimension::Ratio,
        ),
        Quantity::new("footing", "mass of the footing", Dimension::Unnamed),
    ],
    propose,
};

/// Times in which soil follows a footing, s. A cone that a footing rotates is exactly this model with the time τ = z₀/c of its
/// waves c over the depth z₀ of its apex. Its inertia I ∝ z⁴ has θ'' + 4 θ'/z + (ω/c)² θ = 0 with waves that leave,
/// θ ∝ e^(-iωz/c) (1 + iωz/c) / z³. The moment -ρ c² I θ' at the footing is (3 - (ωτ)²/(1 + iωτ)) ρ c² I / z₀ times θ: a spring
/// 3 ρ c² I / z₀ and a dashpot ρ c I to the mass that follows. With the static stiffness of a disk τ is
/// (9π/32)(1 - ν)(c/cₛ) r/cₛ in rocking and (9π/32) r/cₛ in torsion: 0.88 to 1.25 times the time of shear waves over the
/// radius. Waves of compression are taken at most twice as fast as those of shear, as in Wolf and Deeks (2004), Foundation
/// Vibration Analysis, section 3.4. Radii are 2 to 20 m, soils have 100 to 400 m/s.
const FOLLOWING_TIMES: [f64; 2] = [0.003, 0.3];

/// Difference of stiffnesses that count as similar, in parts of the larger one. A choice.
const SIMILAR_STIFFNESS: f64 = 0.5;

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    if !s.inventory.base_excited {
        return out;
    }
    let supports = carrying_supports(s);
    for support in supports.iter().take(MAX_SINGLE_SUPPORTS) {
        add_forms(s, &[support], &mut out);
    }
    // Supports with equal fixities together: ends of a bridge, columns of a frame. Among them those with similar stiffness:
    // piers without abutments.
    let all = || supports.iter().copied();
    let equally_fixed = grouped(all(), |a, b| a.fixed == b.fixed);
    let similar = grouped(all(), |a, b| a.fixed == b.fixed && similar_stiffness(a, b));
    let further = similar.into_iter().filter(|g| !equally_fixed.contains(g)).collect::<Vec<_>>();
    for group in equally_fixed.iter().chain(&further).filter(|g| (2..=MAX_JOINT_SUPPORTS).contains(&g.len())) {
        add_forms(s, group, &mut out);
    }
    out
}

/// Returns true if the elements on two supports have similar stiffnesses.
fn similar_stiffness(a: &Support, b: &Support) -> bool {
    let near = |(a, b): (&f64, &f64)| (a - b).abs() <= SIMILAR_STIFFNESS * a.abs().max(b.abs());
    a.stiffness.iter().zip(&b.stiffness).all(near)
}

/// Addition to the springs and dashpots of a support.
#[derive(Clone, Copy, PartialEq)]
enum Addition {
    None,
    /// The dashpots are left out: the support is softer and loses no energy.
    NoDashpot,
    /// Yielding of the springs, with a scale of the yield force.
    Yielding {
        force: f64,
    },
    /// Yielding in rocking without dashpots, with a scale of the yield moment.
    RockingYield {
        moment: f64,
    },
    /// A footing with mass.
    Footing,
    /// Soil that follows the footing: a mass behind a part of the dashpot.
    FollowingSoil,
    /// Lift-off of the footing, with a scale of its moment.
    Lifting {
        moment: f64,
    },
}

impl Addition {
    fn has_dashpot(self) -> bool {
        !matches!(self, Self::NoDashpot | Self::RockingYield { .. })
    }
}

/// Adds all forms of equal springs and dashpots below some supports.
fn add_forms(s: &ProposalContext<'_>, supports: &[&Support], out: &mut Vec<Proposal>) {
    let ndm = s.inventory.ndm;
    let total = s.inventory.total_mass();
    let (first, stiffest) = (supports[0], |dof: usize| largest_stiffness(supports, dof));
    let horizontal = horizontal_dofs(supports, ndm);
    let rotations: &[usize] = if ndm == 2 { &[3] } else { &[4, 5] };
    let rocking: Vec<usize> = rotations
        .iter()
        .copied()
        .filter(|d| first.fixed.contains(d) && first.ndf >= *d && stiffest(*d) > 0.0)
        .collect();
    let named: Vec<String> = supports.iter().map(|p| p.node.to_string()).collect();
    let at = format!("node {}", named.join(" "));
    let freed = FreedSupports { inventory: s.inventory, supports, purpose: TagPurpose::Foundation };
    let mut form = |form: &str, springs: &[(&str, &[usize])], addition: Addition| {
        let mut added = vec![];
        let mut spring = |name: &str, dofs| {
            added.extend(spring_parameters(name, scale_of(dofs, stiffest), addition));
            SupportSpring { materials: spring_materials(name, addition), part: spring_part(name, addition), dofs }
        };
        let springs: Vec<_> = springs.iter().map(|(name, dofs)| spring(name, dofs)).collect();
        let is_footing = addition == Addition::Footing;
        if is_footing {
            added.push(AddedParameter::log("footing", 1e-3 * total, total, 0.05 * total));
        }
        let block = freed.commands(&springs, is_footing.then_some("footing"));
        let proposal = Proposal::script_edit(CAUSE, form, at.clone(), block, added);
        let one_column = |p: &&Support| s.inventory.carries_one_column(p);
        let is_hinge = matches!(addition, Addition::RockingYield { .. }) && supports.iter().all(one_column);
        out.push(Proposal { same_model: is_hinge.then_some(superstructure_yielding::CAUSE), ..proposal });
    };
    // Yielding shows below elements that do not yield themselves, in sliding where amplitudes differ.
    let softens = |tag: &i32| s.inventory.devices.iter().any(|d| d.tag == *tag && !d.linear);
    let is_softest = !supports.iter().any(|p| p.elements.iter().any(softens));
    if !horizontal.is_empty() {
        form("horizontal spring", &[("sway", &horizontal)], Addition::None);
        form("horizontal spring without a dashpot", &[("sway", &horizontal)], Addition::NoDashpot);
        let force = s.responses.largest_force();
        if force > 0.0 && is_softest && amplitudes_differ(s.study) {
            form("horizontal spring that yields", &[("sway", &horizontal)], Addition::Yielding { force });
        }
        if s.has_clock {
            let follows = Addition::FollowingSoil;
            form("horizontal spring, and soil that follows the footing", &[("sway", &horizontal)], follows);
        }
        if total > 0.0 {
            form("horizontal spring and a footing with mass", &[("sway", &horizontal)], Addition::Footing);
        }
    }
    if !rocking.is_empty() {
        form("rocking spring", &[("rocking", &rocking)], Addition::None);
        form("rocking spring without a dashpot", &[("rocking", &rocking)], Addition::NoDashpot);
        let moment = largest_moment(s, supports);
        if moment > 0.0 && is_softest {
            form("rocking spring that yields", &[("rocking", &rocking)], Addition::RockingYield { moment });
        }
        if moment > 0.0 {
            form("rocking spring of a footing that lifts off", &[("rocking", &rocking)], Addition::Lifting { moment });
        }
    }
    if !horizontal.is_empty() && !rocking.is_empty() {
        form("horizontal and rocking spring", &[("sway", &horizontal), ("rocking", &rocking)], Addition::None);
    }
}

/// Scale of the stiffness of a spring: that of the elements above. A much stiffer spring is a fixed base.
fn scale_of(dofs: &[usize], stiffest: impl Fn(usize) -> f64) -> f64 {
    dofs.iter().map(|d| stiffest(*d)).fold(0.0, f64::max)
}

/// Largest moment of the fitted baseline at the ends of the beams on some supports.
fn largest_moment(s: &ProposalContext<'_>, supports: &[&Support]) -> f64 {
    let of_beams = supports.iter().flat_map(|p| &p.elements).filter_map(|tag| s.responses.end_moments.get(tag));
    of_beams.fold(0.0, |most: f64, moment| most.max(*moment))
}

/// Soil that yields in rocking: a hinge at the foot of a column has the same law, and no motion above parts them.
const ROCKING_JOINT: YieldingJoint<'_> =
    YieldingJoint { strength: "rocking_yield", plastic: "rocking_plastic", initial: "rocking" };

/// Materials of a spring side by side.
///
/// A footing that lifts off comes down on the way on which it went up, without a loss in the spring: Psycharis and Jennings
/// (1983), Rocking of slender rigid bodies allowed to uplift, Earthquake Engineering and Structural Dynamics 11.
fn spring_materials(name: &str, addition: Addition) -> Vec<(&'static str, String)> {
    let law = match addition {
        Addition::Yielding { .. } => ("Steel01", format!("$hy_{name}_yield $hy_{name} $hy_{name}_hardening")),
        Addition::RockingYield { .. } => ROCKING_JOINT.law(),
        Addition::Lifting { .. } => (
            "ElasticBilin",
            format!("$hy_{name} [expr {{$hy_{name}*$hy_{name}_lifted}}] [expr {{$hy_{name}_lift/$hy_{name}}}]"),
        ),
        Addition::None | Addition::NoDashpot | Addition::Footing | Addition::FollowingSoil => {
            ("Elastic", format!("$hy_{name}"))
        }
    };
    let dashpot = addition.has_dashpot().then(|| ("Viscous", format!("$hy_{name}_dashpot 1.0")));
    let follows = (addition == Addition::FollowingSoil)
        .then(|| ("Parallel", format!("{PART} -factors [expr {{-$hy_{name}_follows}}]")));
    std::iter::once(law).chain(dashpot).chain(follows).collect()
}

/// Material inside of those of a spring.
///
/// A dashpot c to a mass m, which the ground itself does not drive, has the force c (v - w) at the speeds v and w with
/// ẇ = (v - w) / τ and τ = m / c. c w is the force of a spring c / τ and a dashpot c in series: that is taken from the dashpot c.
/// [`FOLLOWING_TIMES`] has the source of the model.
fn spring_part(name: &str, addition: Addition) -> Option<(&'static str, String)> {
    (addition == Addition::FollowingSoil).then(|| {
        let dashpot = format!("$hy_{name}_dashpot");
        ("Maxwell", format!("[expr {{{dashpot}/$hy_{name}_time}}] {dashpot} 1.0 1.0"))
    })
}

/// Starts of the moment at which a footing lifts off, over the largest moment on the fixed base. A choice.
const LIFT_STARTS: [f64; 2] = [0.7, 0.25];

/// Parameters of a spring on the scale of its stiffness.
fn spring_parameters(name: &str, scale: f64, addition: Addition) -> Vec<AddedParameter> {
    let mut added = vec![AddedParameter::log(name, 3e-3 * scale, 100.0 * scale, scale)];
    if addition.has_dashpot() {
        // A weak dashpot takes no soil with it.
        let start = if addition == Addition::FollowingSoil { 0.05 } else { 3e-3 };
        added.push(AddedParameter::log(&format!("{name}_dashpot"), 1e-5 * scale, 0.3 * scale, start * scale));
    }
    match addition {
        Addition::Yielding { force } => {
            added.push(AddedParameter::log(&format!("{name}_yield"), 3e-3 * force, 10.0 * force, 0.1 * force));
            added.push(AddedParameter::linear(&format!("{name}_hardening"), 0.0, 0.9, 0.1));
        }
        Addition::RockingYield { moment } => added = ROCKING_JOINT.parameters(moment, scale),
        Addition::Lifting { moment } => {
            let lift = AddedParameter::log(&format!("{name}_lift"), 0.03 * moment, 3.0 * moment, 0.45 * moment);
            // Another mechanism than a spring, which says little of it: the parameter that lifts comes first.
            added.insert(0, AddedParameter { further_starts: LIFT_STARTS.map(|part| part * moment).into(), ..lift });
            added.push(AddedParameter::linear(&format!("{name}_lifted"), 0.0, 0.9, 0.1));
        }
        Addition::FollowingSoil => {
            // Another mechanism than a spring: what follows comes first.
            added.insert(0, AddedParameter::linear(&format!("{name}_follows"), 0.0, 1.0, 0.7));
            let [least, most] = FOLLOWING_TIMES;
            added.push(AddedParameter::log(&format!("{name}_time"), least, most, (least * most).sqrt()));
        }
        Addition::None | Addition::NoDashpot | Addition::Footing => {}
    }
    added
}

#[cfg(test)]
mod tests {
    use super::{FOLLOWING_TIMES, propose};
    use crate::inspect::response::ResponseRanges;
    use crate::test_support::{pad_study, proposal_context, shaken_inventory};
    use nalgebra::Complex;
    use std::f64::consts::PI;

    /// A footing lifts off where the column above it bends, at a moment on the scale of that; springs come with a dashpot and
    /// without one.
    #[test]
    fn a_footing_below_a_bent_column_lifts_off() {
        let text = "model basic -ndm 2 -ndf 3
            node 1 0. 0.; node 2 0. 3. -mass 1. 1. 0.; fix 1 1 1 1
            geomTransf Linear 1
            element elasticBeamColumn 1 1 2 1. 1e3 1. 1";
        let (inventory, study) = (shaken_inventory(text), pad_study());
        let forms = |moment: Option<f64>| -> Vec<(String, Vec<String>)> {
            let end_moments = moment.map(|m| (1, m)).into_iter().collect();
            let responses = ResponseRanges { end_moments, ..ResponseRanges::default() };
            let proposals = propose(&proposal_context(&inventory, &study, &responses));
            let names =
                |p: &crate::candidate::proposal::Proposal| p.parameters.iter().map(|a| a.name.clone()).collect();
            proposals.iter().map(|p| (p.form.clone(), names(p))).collect()
        };
        let rocking = |all: Vec<(String, Vec<String>)>| -> Vec<String> {
            all.into_iter()
                .filter(|(f, _)| f.starts_with("rocking"))
                .map(|(f, n)| format!("{f}: {}", n.join(" ")))
                .collect()
        };
        let springs = ["rocking spring: hy_rocking hy_rocking_dashpot", "rocking spring without a dashpot: hy_rocking"];
        let yields = "rocking spring that yields: hy_rocking_yield hy_rocking_plastic hy_rocking";
        assert_eq!(rocking(forms(None)), springs);
        let lifts = "rocking spring of a footing that lifts off: \
                     hy_rocking_lift hy_rocking hy_rocking_dashpot hy_rocking_lifted";
        assert_eq!(rocking(forms(Some(5.0))), [springs[0], springs[1], yields, lifts]);
    }

    /// The moment of a rotating cone, from the slope of the waves that leave it, over ρ c² I / z₀: that of a spring, and of a
    /// dashpot to a mass that follows.
    #[test]
    fn a_rotating_cone_is_a_spring_and_a_mass_that_follows() {
        let i = Complex::<f64>::i();
        for x in [0.05, 0.4, 1.0, 3.0, 12.0] {
            let wave = |z: f64| (-i * x * z).exp() * (1.0 + i * x * z) / z.powi(3);
            let slope = (wave(1.0 + 1e-5) - wave(1.0 - 1e-5)) / 2e-5;
            let follows = 1.0 / (1.0 + i * x);
            let model = 3.0 + i * x * (1.0 - follows);
            assert!((-slope / wave(1.0) - model).norm() < 1e-6 * model.norm(), "{x}");
        }
    }

    /// From the rocking stiffness 8 G r³ / (3 (1 - ν)) of a disk and 3 ρ c² I / z₀ of a cone, with c the speed of waves of
    /// compression, at most twice that of shear.
    #[test]
    fn rocking_cones_have_times_between_the_bounds() {
        for poisson in [0.0f64, 0.2, 1.0 / 3.0, 0.45, 0.5] {
            let ratio = if poisson > 1.0 / 3.0 { 2.0 } else { (2.0 * (1.0 - poisson) / (1.0 - 2.0 * poisson)).sqrt() };
            for (radius, speed) in [(2.0f64, 400.0), (20.0, 100.0)] {
                let disk = 8.0 * radius.powi(3) / (3.0 * (1.0 - poisson));
                let apex = 3.0 * ratio * ratio * PI * radius.powi(4) / 4.0 / disk;
                let time = apex / (ratio * speed);
                assert!((FOLLOWING_TIMES[0]..FOLLOWING_TIMES[1]).contains(&time), "{poisson}, {radius}: {time}");
                assert!((0.88..1.26).contains(&(time * speed / radius)), "{poisson}");
            }
        }
    }
}
