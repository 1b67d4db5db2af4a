//! `beamIntegration`, and the rules of quadrature that elements name.

use crate::args::Args;
use crate::text::{Arg, Text};
use crate::things;
use crate::{Command, Outcome, Tcl, finish, kind};
use hysteron_engine::element::beam::{Hinge, Rule};
use hysteron_engine::model::Integration;
use hysteron_tcl::{Call, Exception, Value};

const TAG: Arg = Arg::whole("tag", "tag of the integration");

pub(crate) const COMMANDS: &[Command] = &[Command::new("beamIntegration", USAGE, beam_integration)
    .about("Makes a rule of integration along a beam, with its sections.")
    .arguments(&[
        TAG,
        Arg::new("section", "tag of the section"),
        Arg::new("n", "number of sections"),
        Arg::new("secI", "tag of the section of the hinge at i"),
        Arg::new("lpI", "length of the hinge at i"),
        Arg::new("secJ", "tag of the section of the hinge at j"),
        Arg::new("lpJ", "length of the hinge at j"),
        Arg::new("secE", "tag of the section between the hinges"),
        Arg::new("sections", "tags of the sections"),
        Arg::new("places", "places over the length, 0 to 1"),
        Arg::new("weights", "weights over the length"),
    ])
    .defining(&[things::INTEGRATION], 2)
    .with_kinds(|| kind::usages(KINDS))];

const USAGE: &str = "beamIntegration Lobatto|Legendre|Radau|NewtonCotes|Trapezoidal|CompositeSimpson $tag $section $n | \
                     HingeRadau|HingeRadauTwo|HingeMidpoint|HingeEndpoint $tag $secI $lpI $secJ $lpJ $secE | \
                     UserHinge $tag $secE $n $sections ... $places ... $weights ... $n $sections ... $places ... $weights ... | \
                     UserDefined|FixedLocation|LowOrder|MidDistance $tag $n $sections ... $places ... <$weights ...>";

/// Family of the rules that take the same numbers.
enum Family {
    /// The same number of points for any length, without numbers of its own.
    Simple(fn() -> Rule),
    /// Two hinges of given lengths with an elastic interior.
    Hinges(Hinge),
    /// Points at both ends at given places, with an elastic interior.
    Ends,
    /// Points at given places, with the weights of some or all of them.
    Located(fn(Vec<f64>, Vec<f64>, usize) -> Option<Rule>),
}

type Kind = kind::Kind<Family>;

const KINDS: &[Kind] = &[
    Kind {
        names: &["Lobatto"],
        usage: "beamIntegration Lobatto $tag $section $n | $tag $n $sections ...",
        text: Text::new("Gauss-Lobatto points, the ends of the beam among them."),
        make: Family::Simple(|| Rule::Lobatto),
    },
    Kind {
        names: &["Legendre"],
        usage: "beamIntegration Legendre $tag $section $n | $tag $n $sections ...",
        text: Text::new("Gauss-Legendre points, all inside the beam."),
        make: Family::Simple(|| Rule::Legendre),
    },
    Kind {
        names: &["Radau"],
        usage: "beamIntegration Radau $tag $section $n | $tag $n $sections ...",
        text: Text::new("Gauss-Radau points, one of them at the first end."),
        make: Family::Simple(|| Rule::Radau),
    },
    Kind {
        names: &["NewtonCotes"],
        usage: "beamIntegration NewtonCotes $tag $section $n | $tag $n $sections ...",
        text: Text::new("Equally spaced points, the ends among them, with the weights of Newton and Cotes."),
        make: Family::Simple(|| Rule::NewtonCotes),
    },
    Kind {
        names: &["Trapezoidal"],
        usage: "beamIntegration Trapezoidal $tag $section $n | $tag $n $sections ...",
        text: Text::new("Equally spaced points, the ends among them, with the weights of the trapezoidal rule."),
        make: Family::Simple(|| Rule::Trapezoidal),
    },
    Kind {
        names: &["CompositeSimpson", "Simpson"],
        usage: "beamIntegration CompositeSimpson $tag $section $n | $tag $n $sections ...",
        text: Text::new("Equally spaced points, the ends among them, with the weights of Simpson's rule."),
        make: Family::Simple(|| Rule::Simpson),
    },
    Kind {
        names: &["HingeRadau"],
        usage: "beamIntegration HingeRadau $tag $secI $lpI $secJ $lpJ $secE",
        text: Text::new(
            "Plastic hinges of given lengths by Gauss-Radau points over four hinge lengths; the beam between them is \
             elastic.",
        ),
        make: Family::Hinges(Hinge::Radau),
    },
    Kind {
        names: &["HingeRadauTwo"],
        usage: "beamIntegration HingeRadauTwo $tag $secI $lpI $secJ $lpJ $secE",
        text: Text::new(
            "Plastic hinges of given lengths with two Gauss-Radau points each; the beam between them is elastic.",
        ),
        make: Family::Hinges(Hinge::RadauTwo),
    },
    Kind {
        names: &["HingeMidpoint"],
        usage: "beamIntegration HingeMidpoint $tag $secI $lpI $secJ $lpJ $secE",
        text: Text::new(
            "Plastic hinges of given lengths with a point in the middle of each; the beam between them is elastic.",
        ),
        make: Family::Hinges(Hinge::Midpoint),
    },
    Kind {
        names: &["HingeEndpoint"],
        usage: "beamIntegration HingeEndpoint $tag $secI $lpI $secJ $lpJ $secE",
        text: Text::new("Plastic hinges of given lengths with a point at each end; the beam between them is elastic."),
        make: Family::Hinges(Hinge::Endpoint),
    },
    Kind {
        names: &["UserHinge"],
        usage: "beamIntegration UserHinge $tag $secE $n $sections ... $places ... $weights ... $n $sections ... $places \
                ... $weights ...",
        text: Text::new(
            "Points of the hinge at i, then of that at j, at given places with given weights; two Gauss points between \
             the hinges.",
        ),
        make: Family::Ends,
    },
    Kind {
        names: &["UserDefined"],
        usage: "beamIntegration UserDefined $tag $n $sections ... $places ... $weights ...",
        text: Text::new("Points at given places with given weights."),
        make: Family::Located(|places, weights, n| (weights.len() == n).then_some(Rule::Given(places, weights))),
    },
    Kind {
        names: &["FixedLocation"],
        usage: "beamIntegration FixedLocation $tag $n $sections ... $places ...",
        text: Text::new("Points at given places, with weights that are exact for polynomials."),
        make: Family::Located(|places, weights, _| weights.is_empty().then_some(Rule::Located(places, weights))),
    },
    Kind {
        names: &["LowOrder"],
        usage: "beamIntegration LowOrder $tag $n $sections ... $places ... <$weights ...>",
        text: Text::new(
            "Points at given places, some with given weights; the other weights are exact for polynomials.",
        ),
        make: Family::Located(|places, weights, n| (weights.len() <= n).then_some(Rule::Located(places, weights))),
    },
    Kind {
        names: &["MidDistance"],
        usage: "beamIntegration MidDistance $tag $n $sections ... $places ...",
        text: Text::new("Points at given places, each with the length up to the middle between it and its neighbours."),
        make: Family::Located(|places, weights, _| weights.is_empty().then_some(Rule::MidDistance(places))),
    },
];

fn beam_integration(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    kind::take(&mut a, "kind of integration", "beam integration", KINDS.iter())?;
    let name = a.last_word();
    let tag = a.int(TAG.meaning)?;
    let span = a.last_span();
    let numbers = a.floats("number")?;
    finish(interp, &a)?;
    let made = integration(interp, &a, &name, &numbers)?;
    if !interp.host.builder.definitions.integrations.add(tag, made) {
        return Err(a.exists_at(span, things::INTEGRATION, tag));
    }
    Ok(Value::EMPTY)
}

/// Kind of integration of this name.
fn kind_of(name: &str) -> Option<&'static Kind> {
    KINDS.iter().find(|k| k.names.contains(&name))
}

/// A rule without numbers of its own.
pub(crate) fn simple(name: &str) -> Option<Rule> {
    match &kind_of(name)?.make {
        Family::Simple(rule) => Some(rule()),
        _ => None,
    }
}

/// One point of Gauss and Lobatto: a section that OpenSees gives no weight.
pub(crate) fn without_weight(
    interp: &mut Tcl,
    a: &Args<'_>,
    rule: Rule,
    points: usize,
    message: String,
) -> Result<Rule, Exception> {
    if rule != Rule::Lobatto || points != 1 {
        return Err(a.refuse(message, "expected a rule for as many points"));
    }
    a.doubt(interp, message, "expected at least 2 points")?;
    Ok(Rule::Given(vec![0.0], vec![0.0]))
}

/// Tags of the sections, places and weights of the points of two hinges, and of two Gauss points between them. `None` where
/// the numbers are not as many as they say, or the hinges are longer than the beam.
fn between_hinges(numbers: &[f64]) -> Option<[Vec<f64>; 3]> {
    let (interior, mut rest) = numbers.split_first()?;
    let mut all = [vec![], vec![], vec![]];
    let mut lengths = [0.0; 2];
    for length in &mut lengths {
        let (n, after) = rest.split_first()?;
        if !(1.0..=after.len() as f64).contains(n) || n.fract() != 0.0 {
            return None;
        }
        let n = *n as usize;
        for (all, part) in all.iter_mut().zip(after.get(..3 * n)?.chunks(n)) {
            all.extend(part);
        }
        *length = after[2 * n..3 * n].iter().sum();
        rest = &after[3 * n..];
    }
    let [at_i, at_j] = lengths;
    let (middle, half) = (0.5 * (1.0 + at_i - at_j), 0.5 * (1.0 - at_i - at_j));
    let offset = half / 3f64.sqrt();
    let between = [[*interior; 2], [middle - offset, middle + offset], [half; 2]];
    all.iter_mut().zip(between).for_each(|(all, x)| all.extend(x));
    (rest.is_empty() && half >= 0.0).then_some(all)
}

/// The rule of this name with its sections, made from the numbers after the tag.
pub(crate) fn integration(
    interp: &mut Tcl,
    a: &Args<'_>,
    name: &str,
    numbers: &[f64],
) -> Result<Integration, Exception> {
    let wrong = |message: String| a.refuse(message, "expected as below");
    let section = |tag: f64| {
        let tag = tag as i32;
        let found = interp.host.builder.definitions.sections.get(tag).map(|s| (s.clone(), tag));
        found.ok_or_else(|| wrong(format!("{name}: there is no section {tag}")))
    };
    let few = || wrong(format!("{name}: {} numbers are too few", numbers.len()));
    let count = |x: f64| {
        if (1.0..=100.0).contains(&x) && x.fract() == 0.0 {
            Ok(x as usize)
        } else {
            Err(wrong(format!("{name}: {x} is no number of sections, 1 to 100")))
        }
    };
    let within = |places: &[f64]| match places.iter().find(|x| !(0.0..=1.0).contains(*x)) {
        Some(x) => Err(wrong(format!("{name}: the place {x} is no fraction of the length, 0 to 1"))),
        None => Ok(()),
    };
    match kind_of(name).map(|k| &k.make) {
        None => Err(wrong(format!("unknown rule of integration \"{name}\""))),
        Some(Family::Simple(rule)) => {
            let rule = rule();
            let sections = match numbers {
                [tag, n] => vec![section(*tag)?; count(*n)?],
                [n, tags @ ..] if tags.len() == count(*n)? => {
                    tags.iter().map(|t| section(*t)).collect::<Result<_, _>>()?
                }
                _ => return Err(few()),
            };
            if rule.points(sections.len(), 1.0).is_none() {
                let message = format!("{name} has no rule with {} points", sections.len());
                return Ok(Integration { rule: without_weight(interp, a, rule, sections.len(), message)?, sections });
            }
            Ok(Integration { rule, sections })
        }
        Some(Family::Hinges(hinge)) => {
            let [i, lp_i, j, lp_j, e] = *numbers else { return Err(few()) };
            if lp_i < 0.0 || lp_j < 0.0 {
                return Err(wrong(format!("{name}: the lengths of the hinges are {lp_i} and {lp_j}")));
            }
            let all = [section(i)?, section(j)?, section(e)?];
            let sections = hinge.sections().iter().map(|s| all[*s].clone()).collect();
            Ok(Integration { rule: Rule::Hinges(*hinge, lp_i, lp_j), sections })
        }
        Some(Family::Ends) => {
            let [tags, places, weights] = between_hinges(numbers)
                .ok_or_else(|| wrong(format!("{name}: the numbers make no hinges within the length")))?;
            let sections = tags.iter().map(|t| section(*t)).collect::<Result<_, _>>()?;
            within(&places)?;
            Ok(Integration { rule: Rule::Given(places, weights), sections })
        }
        Some(Family::Located(rule)) => {
            let [n, rest @ ..] = numbers else { return Err(few()) };
            let n = count(*n)?;
            if rest.len() < 2 * n {
                return Err(few());
            }
            let sections = rest[..n].iter().map(|t| section(*t)).collect::<Result<_, _>>()?;
            let (places, weights) = (rest[n..2 * n].to_vec(), rest[2 * n..].to_vec());
            within(&places)?;
            let given = weights.len();
            let rule =
                rule(places, weights, n).ok_or_else(|| wrong(format!("{name}: {given} weights for {n} sections")))?;
            if rule.points(n, 1.0).is_none() {
                return Err(wrong(format!("{name}: the places give no weights")));
            }
            Ok(Integration { rule, sections })
        }
    }
}
