//! `amend`: physics added to elements that a script has made.

use super::amended_place::Place;
use super::{joints, learned};
use crate::args::Args;
use crate::model::nodes::need_model;
use crate::model::parameter_change;
use crate::things;
use crate::{Command, Outcome, Tcl, finish};
use hysteron_engine::element::amendment::{
    Amendment, Axial, Bristles, Cavitation, Coupling, Damping, Degradation, Friction, Gap, Heating, Mullins,
    Overstress, PeakOriented, Pinching, Pressure, Relaxation, Share, Sides, Sliding, Slip, Stiffening, Temperature,
    Yielding,
};
use hysteron_engine::element::bearing::BoucWenShear;
use hysteron_engine::material::Softening;
use hysteron_engine::model::ElementId;
use hysteron_tcl::{Call, Exception, Value};
use std::collections::BTreeMap;
use std::sync::Arc;

pub(crate) const COMMANDS: &[Command] = &[Command::new("amend", USAGE, amend)
    .about("Adds physics to an element that exists; see [Amendments](../amendments.md).")];

const USAGE: &str = "amend element $tag <$tag ...> $kind -option $value ... <-dir $dir1 <$dir2>> <-axial $dir | -axialSeries $ts> <-share $k $elastic <$rest> | -strengthBeside $k> | \
                     amend element $tag <$tag ...> learned -range $U $V $T -hysteresis $form $level $strength <-spring $k> <-piece $side $at $k ...> <-moving $k> <-curve $slope ...> <-unequal $strength> <-stop $level $strength ...> <-maxwell $time $k ...> <-dashpot $power $c ...> <-viscous $width $force ...> <-work $D> <-factor $part $variable ...> <-channel $name $mean $deviation ...> <-force $name $a $low $high ...> <-series $ts ...> <-beyond clamp|continue> <-dir $dir1 <$dir2>> | \
                     amend element $tag <$tag ...> learned -file $file <-series $ts ...> <-dir $dir1 <$dir2>> | \
                     amend element $tag <$tag ...> hinges -mat $mat <-end i|j> | \
                     amend node $tag dampedAs $other | \
                     amend parameter $name -factor $f <-from $t1> <-reached $t2> <-to $t3>";

/// Range that the number of an option must lie in.
#[derive(Clone, Copy)]
enum Range {
    Any,
    Positive,
    NotNegative,
    /// From 0 to below 1.
    Ratio,
}

/// An option with one number.
struct Opt {
    name: &'static str,
    what: &'static str,
    range: Range,
    /// Value where the script says nothing; `None` where it must.
    default: Option<f64>,
}

const fn needed(name: &'static str, what: &'static str, range: Range) -> Opt {
    Opt { name, what, range, default: None }
}

const fn optional(name: &'static str, what: &'static str, range: Range, default: f64) -> Opt {
    Opt { name, what, range, default: Some(default) }
}

/// The numbers that a kind has been given.
struct Numbers(BTreeMap<&'static str, f64>);

impl Numbers {
    fn get(&self, name: &str) -> f64 {
        self.0.get(name).copied().unwrap_or(f64::NAN)
    }
}

/// A kind of amendment: its options, and how it is made from their values, what the factor acts on, and the stiffness
/// of the element.
struct Kind {
    name: &'static str,
    about: &'static str,
    options: &'static [Opt],
    make: fn(&Numbers, Share, f64) -> Arc<dyn Amendment>,
}

use Range::{Any, NotNegative, Positive, Ratio};

const KINDS: &[Kind] = &[
    Kind {
        name: "temperature",
        about: "Another temperature than that of the parameters.",
        options: &[
            needed("-softening", "softening b per degree", Any),
            needed("-at", "temperature T", Any),
            needed("-reference", "temperature T0 that the parameters belong to", Any),
        ],
        make: |n, share, _| {
            let (softening, at, reference) = (n.get("-softening"), n.get("-at"), n.get("-reference"));
            Arc::new(Temperature { softening, at, reference, share })
        },
    },
    Kind {
        name: "heating",
        about: "Dissipated work warms the device and softens it.",
        options: &[
            needed("-softening", "softening b per degree", Any),
            needed("-capacity", "heat capacity C, work per degree", Positive),
            optional("-cooling", "cooling time", Positive, f64::INFINITY),
            optional("-conduction", "time of conduction into a half-space", Positive, f64::INFINITY),
        ],
        make: |n, share, _| {
            let (softening, capacity) = (n.get("-softening"), n.get("-capacity"));
            let (cooling, conduction) = (n.get("-cooling"), n.get("-conduction"));
            Arc::new(Heating { softening, capacity, cooling, conduction, share })
        },
    },
    Kind {
        name: "degradation",
        about: "Strength is lost with dissipated energy.",
        options: &[
            needed("-loss", "part of the force lost in the end", Any),
            needed("-energy", "energy that brings 63 % of the loss", Positive),
        ],
        make: |n, share, _| Arc::new(Degradation { loss: n.get("-loss"), energy: n.get("-energy"), share }),
    },
    Kind {
        name: "mullins",
        about: "Virgin rubber is stiffer on its first way to a deformation.",
        options: &[
            needed("-virgin", "excess of the virgin force", Any),
            optional("-power", "exponent of the way back to the virgin path; 0: there is none", NotNegative, 2.0),
            needed("-onset", "deformation by which softening has begun", Positive),
            optional("-healing", "time constant of healing", Positive, f64::INFINITY),
        ],
        make: |n, share, _| {
            let time = n.get("-healing");
            let softening = Softening {
                excess: n.get("-virgin"),
                strain: n.get("-onset"),
                power: Some(n.get("-power")).filter(|p| *p > 0.0),
                healed: if time.is_finite() { 1.0 } else { 0.0 },
                time,
                preload: 0.0,
            };
            Arc::new(Mullins { softening, share })
        },
    },
    Kind {
        name: "stiffening",
        about: "Hardening at large deformation.",
        options: &[
            needed("-factor", "force at one unit of deformation beyond the onset", Any),
            optional("-from", "deformation where it begins", NotNegative, 0.0),
            optional("-power", "exponent", Positive, 2.0),
        ],
        make: |n, _, _| Arc::new(Stiffening { factor: n.get("-factor"), from: n.get("-from"), power: n.get("-power") }),
    },
    Kind {
        name: "overstress",
        about: "Viscous overstress in parallel.",
        options: &[
            needed("-force", "overstress at the reference speed", Positive),
            optional("-speed", "reference speed", Positive, 1.0),
            optional("-power", "exponent n of the speed, above 0 and at most 1", Positive, 1.0),
            needed("-stiffness", "stiffness of its spring", Positive),
        ],
        make: |n, _, _| {
            let (force, speed) = (n.get("-force"), n.get("-speed"));
            Arc::new(Overstress { force, speed, power: n.get("-power"), stiffness: n.get("-stiffness") })
        },
    },
    Kind {
        name: "relaxation",
        about: "The force relaxes after each change.",
        options: &[
            needed("-strength", "part by which the force of a sudden change is larger", NotNegative),
            needed("-time", "relaxation time, the shortest where there are several", Positive),
            optional(
                "-decades",
                "decades over which four relaxation times are spread; 0: there is one",
                NotNegative,
                0.0,
            ),
        ],
        make: |n, _, _| {
            Arc::new(Relaxation { strength: n.get("-strength"), time: n.get("-time"), decades: n.get("-decades") })
        },
    },
    Kind {
        name: "axial",
        about: "Lateral stiffness is lost under axial load.",
        options: &[
            needed("-critical", "critical load at rest", Positive),
            optional("-power", "exponent of the load over the critical one", Positive, 2.0),
            optional("-width", "width of the plates", Positive, f64::INFINITY),
            optional("-load", "compression, where the model does not carry it", Any, f64::NAN),
            optional("-reference", "compression that the parameters belong to", NotNegative, 0.0),
        ],
        make: |n, share, _| {
            let load = Some(n.get("-load")).filter(|p| !p.is_nan());
            let (critical, power, width) = (n.get("-critical"), n.get("-power"), n.get("-width"));
            Arc::new(Axial { critical, power, width, load, reference: n.get("-reference"), share })
        },
    },
    Kind {
        name: "coupling",
        about: "One yield surface for two directions.",
        options: &[
            needed("-stiffness", "initial stiffness", Positive),
            needed("-strength", "characteristic strength", Positive),
            needed("-alpha", "post-yield over initial stiffness", Ratio),
            optional("-eta", "yielding exponent", Positive, 2.0),
        ],
        make: |n, _, _| {
            let (k, alpha) = (n.get("-stiffness"), n.get("-alpha"));
            let (k0, qd, k2, eta) = ((1.0 - alpha) * k, n.get("-strength"), alpha * k, n.get("-eta"));
            let (beta, gamma, compat) = (0.5, 0.5, false);
            Arc::new(Coupling { law: BoucWenShear { k0, qd, k2, k3: 0.0, mu: 1.0, eta, beta, gamma, compat } })
        },
    },
    Kind {
        name: "pinching",
        about: "Loops narrow near zero.",
        options: &[
            needed("-depth", "part of the force that is missing at zero deformation", Any),
            needed("-width", "width of the slack over the largest deformation", Positive),
            optional("-onset", "deformation from which there is slack", NotNegative, 0.0),
        ],
        make: |n, share, _| {
            Arc::new(Pinching { depth: n.get("-depth"), width: n.get("-width"), onset: n.get("-onset"), share })
        },
    },
    Kind {
        name: "slip",
        about: "Slack in series with the hysteretic part.",
        options: &[
            needed("-size", "deformation from end to end of the slack", NotNegative),
            optional("-growth", "more of it for each deformation that has been reached", NotNegative, 0.0),
            needed("-width", "hysteretic force within which it slips", Positive),
        ],
        make: |n, share, _| {
            let (size, growth, width) = (n.get("-size"), n.get("-growth"), n.get("-width"));
            Arc::new(Slip { size, growth, width, share })
        },
    },
    Kind {
        name: "pressure",
        about: "Strength follows the axial force.",
        options: &[
            needed("-reference", "compression that the parameters belong to", Positive),
            optional("-power", "exponent", Positive, 1.0),
            optional("-lever", "compression per deformation of the first direction that overturning adds", Any, 0.0),
            optional("-load", "compression, where the model does not carry it", NotNegative, f64::NAN),
        ],
        make: |n, share, _| {
            let load = Some(n.get("-load")).filter(|p| !p.is_nan());
            let (reference, power, lever) = (n.get("-reference"), n.get("-power"), n.get("-lever"));
            Arc::new(Pressure { reference, power, lever, load, share })
        },
    },
    Kind {
        name: "friction",
        about: "Coulomb friction in parallel.",
        options: &[
            needed("-force", "friction force", NotNegative),
            needed("-stiffness", "stiffness before it slips", Positive),
        ],
        make: |n, _, _| Arc::new(Friction { force: n.get("-force"), stiffness: n.get("-stiffness") }),
    },
    Kind {
        name: "bristles",
        about: "Friction whose bristles bend before they slip.",
        options: &[
            needed("-force", "friction force of a fast motion", NotNegative),
            needed("-stiffness", "stiffness before it slips", Positive),
            optional("-breakaway", "what the friction of a slow motion has more", NotNegative, 0.0),
            optional("-speed", "speed by which that has gone", Positive, f64::INFINITY),
        ],
        make: |n, _, _| {
            let (force, stiffness) = (n.get("-force"), n.get("-stiffness"));
            Arc::new(Bristles { force, stiffness, breakaway: n.get("-breakaway"), speed: n.get("-speed") })
        },
    },
    Kind {
        name: "sliding",
        about: "Friction smoothed over speed.",
        options: &[
            needed("-force", "friction force of a fast motion", NotNegative),
            needed("-speed", "speed over which it is smoothed", Positive),
        ],
        make: |n, _, _| Arc::new(Sliding { force: n.get("-force"), speed: n.get("-speed") }),
    },
    Kind {
        name: "gap",
        about: "Contact beyond a gap.",
        options: &[
            needed("-at", "deformation at which contact begins", NotNegative),
            needed("-stiffness", "contact stiffness", Positive),
            optional("-power", "exponent of the penetration", Positive, 1.0),
            optional("-damping", "damping, time per length", NotNegative, 0.0),
            optional("-side", "side of the wall: 1, -1, or 0 for both", Any, 0.0),
        ],
        make: |n, _, _| {
            let side = n.get("-side");
            let sides = if side > 0.0 {
                Sides::Positive
            } else if side < 0.0 {
                Sides::Negative
            } else {
                Sides::Both
            };
            let (at, stiffness, power) = (n.get("-at"), n.get("-stiffness"), n.get("-power"));
            Arc::new(Gap { at, stiffness, power, damping: n.get("-damping"), sides })
        },
    },
    Kind {
        name: "damping",
        about: "Viscous damping in parallel.",
        options: &[
            needed("-coefficient", "damping coefficient", NotNegative),
            optional("-power", "exponent of the rate", Positive, 1.0),
        ],
        make: |n, _, _| Arc::new(Damping { coefficient: n.get("-coefficient"), power: n.get("-power") }),
    },
    Kind {
        name: "yielding",
        about: "An elastic element yields.",
        options: &[
            needed("-force", "yield force", Positive),
            optional("-hardening", "post-yield over elastic stiffness", Ratio, 0.0),
        ],
        make: |n, _, stiffness| {
            Arc::new(Yielding { force: n.get("-force"), stiffness, hardening: n.get("-hardening") })
        },
    },
    Kind {
        name: "peakOriented",
        about: "An elastic element yields and reloads towards its largest deformation.",
        options: &[
            needed("-force", "yield force", Positive),
            optional("-hardening", "post-yield over elastic stiffness", Ratio, 0.0),
            optional("-unloading", "exponent of the unloading stiffness", NotNegative, 0.0),
        ],
        make: |n, _, stiffness| {
            let (force, hardening, unloading) = (n.get("-force"), n.get("-hardening"), n.get("-unloading"));
            Arc::new(PeakOriented { force, stiffness, hardening, unloading })
        },
    },
    Kind {
        name: "cavitation",
        about: "Tension is limited and damaged.",
        options: &[
            needed("-strength", "cavitation strength", Positive),
            needed("-extension", "extension at which it is reached", Positive),
            optional("-damage", "part of the strength lost in the end", Ratio, 0.0),
            optional("-rate", "rate of the loss", Positive, 1.0),
            optional("-rise", "gain far beyond the strength, as a part of it", NotNegative, 0.0),
            optional("-reach", "extension of the gain", Positive, f64::INFINITY),
            optional("-sign", "sign of the deformation that is tension, 1 or -1", Any, 1.0),
        ],
        make: |n, share, _| {
            let (strength, extension) = (n.get("-strength"), n.get("-extension"));
            let (damage, rate) = (n.get("-damage"), n.get("-rate"));
            let (rise, reach, sign) = (n.get("-rise"), n.get("-reach"), n.get("-sign").signum());
            Arc::new(Cavitation { strength, extension, damage, rate, rise, reach, sign, share })
        },
    },
];

/// Name of each kind of amendment of an element that has options, with a sentence about it.
pub fn amendments() -> impl Iterator<Item = (&'static str, &'static str)> {
    KINDS.iter().map(|k| (k.name, k.about)).chain([learned::ABOUT])
}

fn amend(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    need_model(interp, call)?;
    let mut a = Args::new(call, USAGE);
    match a.word("kind of thing to amend")?.as_ref() {
        "element" => {}
        "node" => return joints::damped_as(interp, &mut a),
        "parameter" => return parameter_change::amend_parameter(interp, &mut a),
        _ => return Err(a.unknown_name("thing to amend", ["element", "node", "parameter"])),
    }
    let mut elements = vec![element_of(interp, &mut a)?];
    while a.at_number() {
        elements.push(element_of(interp, &mut a)?);
    }
    let name = a.word("kind of amendment")?;
    if name == "hinges" {
        return joints::hinge(interp, &mut a, &elements);
    }
    if name == learned::ABOUT.0 {
        return learned::learned(interp, &mut a, &elements);
    }
    let Some(kind) = KINDS.iter().find(|k| k.name == name) else {
        return Err(a.unknown_name("amendment", KINDS.iter().map(|k| k.name).chain(["hinges", learned::ABOUT.0])));
    };
    let words = Words::take(interp, &mut a, kind)?;
    finish(interp, &a)?;
    for id in elements {
        let make = |stiffness: f64| (kind.make)(&words.numbers, words.share, stiffness);
        words.place.amend(interp, &a, id, &make)?;
    }
    Ok(Value::EMPTY)
}

/// Returns true if a law has a strength that the element loses.
fn weakens(law: &dyn Amendment) -> bool {
    let mut virgin = vec![0.0; law.state_len()];
    law.init(&mut virgin);
    law.weakening(&virgin).is_some()
}

/// Words after the kind of an amendment.
struct Words {
    numbers: Numbers,
    share: Share,
    place: Place,
}

impl Words {
    fn take(interp: &mut Tcl, a: &mut Args<'_>, kind: &Kind) -> Result<Self, Exception> {
        let mut numbers: BTreeMap<_, _> = kind.options.iter().filter_map(|o| Some((o.name, o.default?))).collect();
        let (mut share, mut place) = (Share::default(), Place::default());
        while let Some(word) = a.option() {
            if place.takes(interp, a, &word)? {
                continue;
            }
            match word.as_ref() {
                "-share" | "-strengthBeside" if share != Share::default() => {
                    return Err(a.refuse("two words for what the factor acts on", "expected -share or -strengthBeside"));
                }
                "-strengthBeside" => share = Share::strength_beside(a.not_negative("stiffness of the elastic part")?),
                "-share" => {
                    share.stiffness = a.not_negative("stiffness of the elastic part")?;
                    share.elastic = a.float("measure in which it acts on the elastic part")?;
                    if a.at_number() {
                        share.hysteretic = a.float("measure in which it acts on the rest")?;
                    }
                }
                word => {
                    let Some(o) = kind.options.iter().find(|o| o.name == word) else {
                        let common = ["-axial", "-axialSeries", "-dir", "-share", "-strengthBeside"];
                        let known = kind.options.iter().map(|o| o.name).chain(common);
                        return Err(a.unknown_name("option", known));
                    };
                    numbers.insert(o.name, number(a, o)?);
                }
            }
        }
        if let Some(o) = kind.options.iter().find(|o| !numbers.contains_key(o.name)) {
            let message = format!("amend {}: {} $value is missing", kind.name, o.name);
            return Err(a.refuse(message, format!("expected the {} as well", o.what)));
        }
        let numbers = Numbers(numbers);
        if share.of_strength && !weakens((kind.make)(&numbers, share, 1.0).as_ref()) {
            let message = format!("amend {}: this law has no -strengthBeside", kind.name);
            return Err(a.refuse(message, "expected it of temperature, heating or degradation"));
        }
        Ok(Self { numbers, share, place })
    }
}

fn number(a: &mut Args<'_>, o: &Opt) -> Result<f64, Exception> {
    match o.range {
        Any => a.float(o.what),
        Positive => a.positive(o.what),
        NotNegative => a.not_negative(o.what),
        Ratio => {
            let x = a.not_negative(o.what)?;
            if x < 1.0 { Ok(x) } else { Err(a.refuse(format!("{} is {x}", o.what), "expected 0 to below 1")) }
        }
    }
}

/// An element at rest, by its tag.
fn element_of(interp: &Tcl, a: &mut Args<'_>) -> Result<ElementId, Exception> {
    let tag = a.tag(things::ELEMENT, "tag of the element")?;
    let engine = &interp.host.engine;
    let Some(id) = engine.model().element(tag) else {
        return Err(a.absent(things::ELEMENT, tag, "expected the tag of an element"));
    };
    if engine.model().elements[id.0].dofs.iter().any(|d| engine.state().disp[*d as usize] != 0.0) {
        let message = format!("element {tag} has been moved already");
        return Err(a.refuse(message, "amend it before the first analysis"));
    }
    Ok(id)
}
