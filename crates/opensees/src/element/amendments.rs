//! Kinds of amendments of elements.

use super::{joints, learned};
use crate::args::Args;
use crate::text::{Arg, Domain};
use crate::{Outcome, Tcl};
use hysteron_engine::element::amendment::{
    Amendment, Axial, Bristles, Cavitation, Coupling, Creep, Damping, Degradation, Friction, Gap, Heating, Mullins,
    Overstress, PeakOriented, Pinching, Pressure, Relaxation, Share, Sides, Sliding, Slip, Stiffening, Temperature,
    Yielding,
};
use hysteron_engine::element::bearing::BoucWenShear;
use hysteron_engine::material::Softening;
use hysteron_engine::model::ElementId;
use std::sync::Arc;

/// An option with one number.
pub struct AmendmentOption {
    /// The option and its number.
    pub arg: Arg,
    /// Value where the script says nothing; `None` where it must.
    pub default: Option<f64>,
}

const fn needed(name: &'static str, what: &'static str, domain: Domain) -> AmendmentOption {
    AmendmentOption { arg: Arg::behind(name, what, domain), default: None }
}

const fn optional(name: &'static str, what: &'static str, domain: Domain, default: f64) -> AmendmentOption {
    AmendmentOption { arg: Arg::behind(name, what, domain), default: Some(default) }
}

/// Makes an amendment of a number for each option, what the factor acts on, and the stiffness of the element.
pub(super) trait MakeLaw: Sync {
    fn make(&self, numbers: &[f64], share: Share, stiffness: f64) -> Arc<dyn Amendment>;
}

/// A kind with N options. The function takes their numbers in the same order.
struct Law<const N: usize> {
    name: &'static str,
    about: &'static str,
    options: [AmendmentOption; N],
    make: fn([f64; N], Share, f64) -> Arc<dyn Amendment>,
}

impl<const N: usize> MakeLaw for Law<N> {
    fn make(&self, numbers: &[f64], share: Share, stiffness: f64) -> Arc<dyn Amendment> {
        (self.make)(std::array::from_fn(|i| numbers.get(i).copied().unwrap_or(f64::NAN)), share, stiffness)
    }
}

/// Making of an amendment.
pub(super) enum Make {
    /// From options with one number each.
    Law(&'static dyn MakeLaw),
    /// From words of its own, for these elements.
    Words(fn(&mut Tcl, &mut Args<'_>, &[ElementId]) -> Outcome),
}

/// A kind of amendment of elements.
pub struct AmendmentKind {
    /// Name.
    pub name: &'static str,
    /// Sentence about it; empty where the usage of the command says all.
    pub about: &'static str,
    /// Options with one number.
    pub options: &'static [AmendmentOption],
    pub(super) make: Make,
}

const fn law<const N: usize>(law: &'static Law<N>) -> AmendmentKind {
    AmendmentKind { name: law.name, about: law.about, options: &law.options, make: Make::Law(law) }
}

use Domain::{NotNegative, Number, Positive, Ratio};
use Make::Words;

/// All kinds of amendments of elements.
pub const AMENDMENTS: &[AmendmentKind] = &[
    law(&Law {
        name: "temperature",
        about: "Another temperature than that of the parameters.",
        options: [
            needed("-softening", "softening b per degree", Number),
            needed("-at", "temperature T", Number),
            needed("-reference", "temperature T0 that the parameters belong to", Number),
        ],
        make: |[softening, at, reference], share, _| Arc::new(Temperature { softening, at, reference, share }),
    }),
    law(&Law {
        name: "heating",
        about: "Dissipated work warms the device and softens it.",
        options: [
            needed("-softening", "softening b per degree", Number),
            needed("-capacity", "heat capacity C, work per degree", Positive),
            optional("-cooling", "cooling time", Positive, f64::INFINITY),
            optional("-conduction", "time of conduction into a half-space", Positive, f64::INFINITY),
            optional("-halfWidth", "half width of a slider, whose face heats where it covers", Positive, f64::INFINITY),
        ],
        make: |[softening, capacity, cooling, conduction, half_width], share, _| {
            Arc::new(Heating { softening, capacity, cooling, conduction, half_width, share })
        },
    }),
    law(&Law {
        name: "degradation",
        about: "Strength is lost with dissipated energy.",
        options: [
            needed("-loss", "part of the force lost in the end", Number),
            needed("-energy", "energy that brings 63 % of the loss", Positive),
        ],
        make: |[loss, energy], share, _| Arc::new(Degradation { loss, energy, share }),
    }),
    law(&Law {
        name: "mullins",
        about: "Virgin rubber is stiffer on its first way to a deformation.",
        options: [
            needed("-virgin", "excess of the virgin force", Number),
            optional("-power", "exponent of the way back to the virgin path; 0: there is none", NotNegative, 2.0),
            needed("-onset", "deformation by which softening has begun", Positive),
            optional("-healing", "time constant of healing", Positive, f64::INFINITY),
        ],
        make: |[virgin, power, onset, time], share, _| {
            let softening = Softening {
                excess: virgin,
                strain: onset,
                power: Some(power).filter(|p| *p > 0.0),
                healed: if time.is_finite() { 1.0 } else { 0.0 },
                time,
                preload: 0.0,
            };
            Arc::new(Mullins { softening, share })
        },
    }),
    law(&Law {
        name: "stiffening",
        about: "Hardening at large deformation.",
        options: [
            needed("-factor", "force at one unit of deformation beyond the onset", Number),
            optional("-from", "deformation where it begins", NotNegative, 0.0),
            optional("-power", "exponent", Positive, 2.0),
        ],
        make: |[factor, from, power], _, _| Arc::new(Stiffening { factor, from, power }),
    }),
    law(&Law {
        name: "overstress",
        about: "Viscous overstress in parallel.",
        options: [
            needed("-force", "overstress at the reference speed", Positive),
            optional("-speed", "reference speed", Positive, 1.0),
            optional("-power", "exponent n of the speed, above 0 and at most 1", Positive, 1.0),
            needed("-stiffness", "stiffness of its spring", Positive),
        ],
        make: |[force, speed, power, stiffness], _, _| Arc::new(Overstress { force, speed, power, stiffness }),
    }),
    law(&Law {
        name: "relaxation",
        about: "The force relaxes after each change.",
        options: [
            needed("-strength", "part by which the force of a sudden change is larger", NotNegative),
            needed("-time", "relaxation time, the shortest where there are several", Positive),
            optional(
                "-decades",
                "decades over which four relaxation times are spread; 0: there is one",
                NotNegative,
                0.0,
            ),
        ],
        make: |[strength, time, decades], _, _| Arc::new(Relaxation { strength, time, decades }),
    }),
    law(&Law {
        name: "creep",
        about: "The deformation goes on under a force that is held.",
        options: [
            needed("-compliance", "deformation per force that creep adds in the end", NotNegative),
            needed("-time", "retardation time, the shortest where there are several", Positive),
            optional(
                "-decades",
                "decades over which four retardation times are spread; 0: there is one",
                NotNegative,
                0.0,
            ),
        ],
        make: |[compliance, time, decades], _, _| Arc::new(Creep { compliance, time, decades }),
    }),
    law(&Law {
        name: "axial",
        about: "Lateral stiffness is lost under axial load.",
        options: [
            needed("-critical", "critical load at rest", Positive),
            optional("-power", "exponent of the load over the critical one", Positive, 2.0),
            optional("-width", "width of the plates", Positive, f64::INFINITY),
            optional("-load", "compression, where the model does not carry it", Number, f64::NAN),
            optional("-reference", "compression that the parameters belong to", NotNegative, 0.0),
        ],
        make: |[critical, power, width, load, reference], share, _| {
            let load = Some(load).filter(|p| !p.is_nan());
            Arc::new(Axial { critical, power, width, load, reference, share })
        },
    }),
    law(&Law {
        name: "coupling",
        about: "One yield surface for two directions.",
        options: [
            needed("-stiffness", "initial stiffness", Positive),
            needed("-strength", "characteristic strength", Positive),
            needed("-alpha", "post-yield over initial stiffness", Ratio),
            optional("-eta", "yielding exponent", Positive, 2.0),
        ],
        make: |[k, strength, alpha, eta], _, _| {
            let (k0, qd, k2) = ((1.0 - alpha) * k, strength, alpha * k);
            let (beta, gamma, compat) = (0.5, 0.5, false);
            Arc::new(Coupling { law: BoucWenShear { k0, qd, k2, k3: 0.0, mu: 1.0, eta, beta, gamma, compat } })
        },
    }),
    law(&Law {
        name: "pinching",
        about: "Loops narrow near zero.",
        options: [
            needed("-depth", "part of the force that is missing at zero deformation", Number),
            needed("-width", "width of the slack over the largest deformation", Positive),
            optional("-onset", "deformation from which there is slack", NotNegative, 0.0),
        ],
        make: |[depth, width, onset], share, _| Arc::new(Pinching { depth, width, onset, share }),
    }),
    law(&Law {
        name: "slip",
        about: "Slack in series with the hysteretic part.",
        options: [
            needed("-size", "deformation from end to end of the slack", NotNegative),
            optional("-growth", "more of it for each deformation that has been reached", NotNegative, 0.0),
            needed("-width", "hysteretic force within which it slips", Positive),
        ],
        make: |[size, growth, width], share, _| Arc::new(Slip { size, growth, width, share }),
    }),
    law(&Law {
        name: "pressure",
        about: "Strength follows the axial force.",
        options: [
            needed("-reference", "compression that the parameters belong to", Positive),
            optional("-power", "exponent", Positive, 1.0),
            optional("-lever", "compression per deformation of the first direction that overturning adds", Number, 0.0),
            optional("-load", "compression, where the model does not carry it", NotNegative, f64::NAN),
        ],
        make: |[reference, power, lever, load], share, _| {
            let load = Some(load).filter(|p| !p.is_nan());
            Arc::new(Pressure { reference, power, lever, load, share })
        },
    }),
    law(&Law {
        name: "friction",
        about: "Coulomb friction in parallel.",
        options: [
            needed("-force", "friction force", NotNegative),
            needed("-stiffness", "stiffness before it slips", Positive),
        ],
        make: |[force, stiffness], _, _| Arc::new(Friction { force, stiffness }),
    }),
    law(&Law {
        name: "bristles",
        about: "Friction whose bristles bend before they slip.",
        options: [
            needed("-force", "friction force of a fast motion", NotNegative),
            needed("-stiffness", "stiffness before it slips", Positive),
            optional("-breakaway", "what the friction of a slow motion has more", NotNegative, 0.0),
            optional("-speed", "speed by which that has gone", Positive, f64::INFINITY),
            optional("-slip", "slip by which that has gone", Positive, f64::INFINITY),
            optional("-rest", "time at rest in which it comes back", Positive, f64::INFINITY),
        ],
        make: |[force, stiffness, breakaway, speed, slip, rest], _, _| {
            Arc::new(Bristles { force, stiffness, breakaway, speed, slip, rest })
        },
    }),
    law(&Law {
        name: "sliding",
        about: "Friction smoothed over speed.",
        options: [
            needed("-force", "friction force of a fast motion", NotNegative),
            needed("-speed", "speed over which it is smoothed", Positive),
        ],
        make: |[force, speed], _, _| Arc::new(Sliding { force, speed }),
    }),
    law(&Law {
        name: "gap",
        about: "Contact beyond a gap.",
        options: [
            needed("-at", "deformation at which contact begins", NotNegative),
            needed("-stiffness", "contact stiffness", Positive),
            optional("-power", "exponent of the penetration", Positive, 1.0),
            optional("-damping", "damping, time per length", NotNegative, 0.0),
            optional("-side", "side of the wall: 1, -1, or 0 for both", Number, 0.0),
        ],
        make: |[at, stiffness, power, damping, side], _, _| {
            let sides = if side > 0.0 {
                Sides::Positive
            } else if side < 0.0 {
                Sides::Negative
            } else {
                Sides::Both
            };
            Arc::new(Gap { at, stiffness, power, damping, sides })
        },
    }),
    law(&Law {
        name: "damping",
        about: "Viscous damping in parallel.",
        options: [
            needed("-coefficient", "damping coefficient", NotNegative),
            optional("-power", "exponent of the rate", Positive, 1.0),
        ],
        make: |[coefficient, power], _, _| Arc::new(Damping { coefficient, power }),
    }),
    law(&Law {
        name: "yielding",
        about: "An elastic element yields.",
        options: [
            needed("-force", "yield force", Positive),
            optional("-hardening", "post-yield over elastic stiffness", Ratio, 0.0),
        ],
        make: |[force, hardening], _, stiffness| Arc::new(Yielding { force, stiffness, hardening }),
    }),
    law(&Law {
        name: "peakOriented",
        about: "An elastic element yields and reloads towards its largest deformation.",
        options: [
            needed("-force", "yield force", Positive),
            optional("-hardening", "post-yield over elastic stiffness", Ratio, 0.0),
            optional("-unloading", "exponent of the unloading stiffness", NotNegative, 0.0),
        ],
        make: |[force, hardening, unloading], _, stiffness| {
            Arc::new(PeakOriented { force, stiffness, hardening, unloading })
        },
    }),
    law(&Law {
        name: "cavitation",
        about: "Tension is limited and damaged.",
        options: [
            needed("-strength", "cavitation strength", Positive),
            needed("-extension", "extension at which it is reached", Positive),
            optional("-damage", "part of the strength lost in the end", Ratio, 0.0),
            optional("-rate", "rate of the loss", Positive, 1.0),
            optional("-rise", "gain far beyond the strength, as a part of it", NotNegative, 0.0),
            optional("-reach", "extension of the gain", Positive, f64::INFINITY),
            optional("-sign", "sign of the deformation that is tension, 1 or -1", Number, 1.0),
        ],
        make: |[strength, extension, damage, rate, rise, reach, sign], share, _| {
            let (rise, reach, sign) = (rise, reach, sign.signum());
            Arc::new(Cavitation { strength, extension, damage, rate, rise, reach, sign, share })
        },
    }),
    AmendmentKind { name: "hinges", about: "", options: &[], make: Words(joints::hinge) },
    AmendmentKind { name: "ends", about: "", options: &[], make: Words(joints::move_ends) },
    AmendmentKind {
        name: "learned",
        about: "A law with memory in place of the element's own, found from recordings.",
        options: &[],
        make: Words(learned::learned),
    },
];
