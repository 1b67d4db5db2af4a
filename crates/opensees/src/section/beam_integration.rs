//! `beamIntegration`, and the rules of quadrature that elements name.

use crate::args::Args;
use crate::{Command, Outcome, Tcl, finish};
use hysteron_engine::element::beam::{Hinge, Rule};
use hysteron_engine::model::Integration;
use hysteron_tcl::{Call, Exception, Value};

pub(crate) const COMMANDS: &[Command] = &[Command { name: "beamIntegration", usage: USAGE, run: beam_integration }];

const USAGE: &str = "beamIntegration Lobatto|Legendre|Radau|NewtonCotes|Trapezoidal|CompositeSimpson $tag $section $n | \
                     HingeRadau|HingeRadauTwo|HingeMidpoint|HingeEndpoint $tag $secI $lpI $secJ $lpJ $secE | \
                     UserDefined|FixedLocation|LowOrder|MidDistance $tag $n $sections ... $places ... <$weights ...>";

const NAMES: [&str; 14] = [
    "Lobatto",
    "Legendre",
    "Radau",
    "NewtonCotes",
    "Trapezoidal",
    "CompositeSimpson",
    "HingeRadau",
    "HingeRadauTwo",
    "HingeMidpoint",
    "HingeEndpoint",
    "UserDefined",
    "FixedLocation",
    "LowOrder",
    "MidDistance",
];

fn beam_integration(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, USAGE);
    let name = a.word("kind of integration")?.into_owned();
    if !NAMES.contains(&name.as_str()) && simple(&name).is_none() {
        return Err(a.unknown_name("beam integration", NAMES));
    }
    let tag = a.int("tag of the integration")?;
    let span = a.last_span();
    let numbers = a.floats("number")?;
    finish(interp, &a)?;
    let made = integration(interp, &a, &name, &numbers)?;
    if !interp.host.definitions.integrations.add(tag, made) {
        return Err(a.refuse_at(span, format!("there is a beam integration {tag} already"), "expected a new tag"));
    }
    Ok(Value::EMPTY)
}

/// A rule without numbers of its own.
pub(crate) fn simple(name: &str) -> Option<Rule> {
    Some(match name {
        "Lobatto" => Rule::Lobatto,
        "Legendre" => Rule::Legendre,
        "Radau" => Rule::Radau,
        "NewtonCotes" => Rule::NewtonCotes,
        "Trapezoidal" => Rule::Trapezoidal,
        "Simpson" | "CompositeSimpson" => Rule::Simpson,
        _ => return None,
    })
}

/// A rule by its name, with its sections, from the numbers after the tag.
pub(crate) fn integration(interp: &Tcl, a: &Args<'_>, name: &str, numbers: &[f64]) -> Result<Integration, Exception> {
    let wrong = |message: String| a.refuse(message, "expected as below");
    let section = |tag: f64| {
        let tag = tag as i32;
        let found = interp.host.definitions.sections.get(tag).map(|s| (s.clone(), tag));
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
    if let Some(rule) = simple(name) {
        let sections = match numbers {
            [tag, n] => vec![section(*tag)?; count(*n)?],
            [n, tags @ ..] if tags.len() == count(*n)? => tags.iter().map(|t| section(*t)).collect::<Result<_, _>>()?,
            _ => return Err(few()),
        };
        if rule.points(sections.len(), 1.0).is_none() {
            return Err(wrong(format!("{name} has no rule with {} points", sections.len())));
        }
        return Ok(Integration { rule, sections });
    }
    let hinge = match name {
        "HingeRadau" => Some(Hinge::Radau),
        "HingeRadauTwo" => Some(Hinge::RadauTwo),
        "HingeMidpoint" => Some(Hinge::Midpoint),
        "HingeEndpoint" => Some(Hinge::Endpoint),
        _ => None,
    };
    if let Some(hinge) = hinge {
        let [i, lp_i, j, lp_j, e] = *numbers else { return Err(few()) };
        if lp_i < 0.0 || lp_j < 0.0 {
            return Err(wrong(format!("{name}: the lengths of the hinges are {lp_i} and {lp_j}")));
        }
        let all = [section(i)?, section(j)?, section(e)?];
        let sections = hinge.sections().iter().map(|s| all[*s].clone()).collect();
        return Ok(Integration { rule: Rule::Hinges(hinge, lp_i, lp_j), sections });
    }
    let [n, rest @ ..] = numbers else { return Err(few()) };
    let n = count(*n)?;
    if rest.len() < 2 * n {
        return Err(few());
    }
    let sections = rest[..n].iter().map(|t| section(*t)).collect::<Result<_, _>>()?;
    let (places, weights) = (rest[n..2 * n].to_vec(), rest[2 * n..].to_vec());
    if let Some(x) = places.iter().find(|x| !(0.0..=1.0).contains(*x)) {
        return Err(wrong(format!("{name}: the place {x} is no fraction of the length, 0 to 1")));
    }
    let rule = match name {
        "UserDefined" if weights.len() == n => Rule::Given(places, weights),
        "FixedLocation" if weights.is_empty() => Rule::Located(places, vec![]),
        "LowOrder" if weights.len() <= n => Rule::Located(places, weights),
        "MidDistance" if weights.is_empty() => Rule::MidDistance(places),
        _ => return Err(wrong(format!("{name}: {} weights for {n} sections", weights.len()))),
    };
    if rule.points(n, 1.0).is_none() {
        return Err(wrong(format!("{name}: the places give no weights")));
    }
    Ok(Integration { rule, sections })
}
