//! A fitted law as one of the engine.

use super::law::{
    Coefficients, Fitter, Group, HINGES, Law, POWERS, SIDE_HINGES, STOP_LEVELS, Shape, WIDTHS, stop_level,
};
use super::slow_variables::{Builder, Kind};
use hysteron_engine::element::amendment::learned::{
    Channel, ChannelForce, Factor, LearnedLaw, Piece, Scales, Variable,
};
use std::collections::BTreeSet;

/// Digits with which the coefficients of a law are written.
const DIGITS: usize = 6;

/// A number with few digits.
fn short(x: f64) -> f64 {
    format!("{x:.*e}", DIGITS - 1).parse().unwrap_or(x)
}

/// Conditions that a law follows, in the order of its channels.
pub(super) fn used_conditions(law: &Law) -> Vec<usize> {
    let of_factors = law.factors.iter().filter_map(|(_, v)| match v.kind {
        Kind::Variable(variable) => variable.channel(),
        _ => None,
    });
    let of_forces = law.forces.iter().filter_map(|f| match f.kind {
        Kind::ChannelForce(i) => Some(i),
        _ => None,
    });
    of_factors.chain(of_forces).collect::<BTreeSet<usize>>().into_iter().collect()
}

/// Pieces of a spring of some stiffnesses between the ends of its segments.
fn pieces(side: f64, ends: &[f64], stiffness: &[f64]) -> Vec<Piece> {
    let rises = (0..ends.len()).map(|k| Piece { side, at: ends[k], stiffness: stiffness[k + 1] - stiffness[k] });
    rises.filter(|p| p.stiffness != 0.0).collect()
}

/// The law of the engine; `None` if the rules of energy refuse it.
pub(super) fn engine_law(fitter: &Fitter<'_>, law: &Law, c: &Coefficients) -> Option<LearnedLaw> {
    let data = fitter.data;
    let builder = Builder::new(data, law.level);
    let s = builder.scales();
    let u = short(s.deformation);
    let [e, h, x, _] = fitter.columns(law, &c.factors).counts;
    let (elastic, rest) = c.weights.split_at(e);
    let (hysteretic, rest) = rest.split_at(h);
    let (viscous, forces) = rest.split_at(x);
    let used = used_conditions(law);
    let place = |condition: usize| used.iter().position(|i| *i == condition).unwrap_or(0);
    let has = |g: Group| law.groups.contains(&g);
    let is_user = law.shape == Shape::User;
    let by_force = if is_user { data.scales.force.max(f64::MIN_POSITIVE) } else { 1.0 };
    let mut out = LearnedLaw {
        scales: Scales {
            deformation: u,
            speed: short(s.speed),
            duration: short(s.duration),
            work: short(s.work),
            level: short(s.level),
        },
        spring: 0.0,
        pieces: vec![],
        moving: 0.0,
        shape: law.shape.of_engine(),
        strength: short(hysteretic[0] / by_force),
        unequal: 0.0,
        stops: vec![],
        maxwell: vec![],
        dashpots: vec![],
        viscous: vec![],
        factors: vec![],
        channels: vec![],
        forces: vec![],
        goes_on: false,
    };
    add_elastic(&mut out, law, elastic, s.deformation);
    if has(Group::Unequal) {
        out.unequal = short(hysteretic[h - 1] / by_force - out.strength);
    }
    if has(Group::Stops) {
        let all = (0..STOP_LEVELS).map(|k| [short(s.deformation * stop_level(k)), short(hysteretic[1 + k])]);
        out.stops = all.filter(|[_, w]| *w > 0.0).collect();
    }
    let mut next = viscous.iter();
    for g in &law.groups {
        let mut pairs = |first: &[f64], scale: f64| -> Vec<[f64; 2]> {
            let all = first.iter().zip(next.by_ref().take(first.len()));
            all.map(|(a, w)| [short(*a), short(w / scale)]).filter(|[_, w]| *w > 0.0).collect()
        };
        match g {
            Group::Maxwell | Group::Creep => out.maxwell.extend(pairs(fitter.maxwell_times(*g), s.deformation)),
            Group::Dashpots => out.dashpots = pairs(&POWERS, 1.0),
            Group::Viscous => out.viscous = pairs(&WIDTHS, 1.0),
            _ => {}
        }
    }
    for (f, w) in law.forces.iter().zip(forces) {
        match f.kind {
            Kind::Moving => out.moving = short(w / s.deformation),
            Kind::ChannelForce(i) => {
                let force = ChannelForce { channel: place(i), coefficient: short(*w), range: f.range.map(short) };
                out.forces.push(force);
            }
            _ => {}
        }
    }
    for ((target, v), a) in law.factors.iter().zip(&c.factors) {
        let Kind::Variable(variable) = v.kind else { continue };
        let (name, numbers) = variable.words();
        let numbers: Vec<f64> = numbers.into_iter().map(short).collect();
        let variable = Variable::of(name, &numbers, variable.channel().map_or(0, place))?;
        out.factors.push(Factor { target: *target, variable, coefficient: short(*a), range: v.range.map(short) });
    }
    for i in used {
        let (mean, deviation) = data.scales.conditions[i];
        let name: String = data.runs[0].conditions[i].name.split_whitespace().collect::<Vec<_>>().join("_");
        out.channels.push(Channel { name, mean: short(mean), deviation: short(deviation) });
    }
    out.refusal().is_none().then_some(out)
}

fn add_elastic(out: &mut LearnedLaw, law: &Law, weights: &[f64], u: f64) {
    let k: Vec<f64> = weights.iter().map(|w| short(w / u)).collect();
    let mut rest = &k[..];
    if law.groups.contains(&Group::Hinges) {
        let (own, others) = rest.split_at(HINGES.len() + 1);
        out.spring = own[0];
        out.pieces.extend(pieces(0.0, &HINGES.map(|a| short(a * u)), own));
        rest = others;
    }
    if law.groups.contains(&Group::Sides) {
        for (side, own) in [1.0, -1.0].into_iter().zip(rest.chunks(SIDE_HINGES.len() + 1)) {
            out.pieces.push(Piece { side, at: 0.0, stiffness: own[0] });
            out.pieces.extend(pieces(side, &SIDE_HINGES.map(|a| short(a * u)), own));
        }
    } else if let [spring] = rest {
        out.spring = *spring;
    }
}
