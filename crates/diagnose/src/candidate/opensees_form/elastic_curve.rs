//! `stiffening`: an elastic curve in parallel.

use super::{FormInput, StandardForm, Translation};
use std::fmt::Write as _;

pub(super) const STIFFENING: Translation = Translation {
    kind: "stiffening",
    form: "`ElasticMultiLinear` through points of the curve, in one direction",
    per_element: false,
    make,
};

/// Points of the curve on one side.
const POINTS: usize = 100;
/// Range of the points over the largest deformation of the model as it was.
const RANGE: f64 = 2.0;

fn make(input: &FormInput<'_>) -> Result<Vec<StandardForm>, String> {
    let a = input.amendment;
    let direction = a.one_direction("stiffening")?;
    let unknown = || "the curve depends on an expression of the script".to_owned();
    let factor = a.number("-factor").ok_or_else(unknown)?;
    let from = if a.has("-from") { a.number("-from").ok_or_else(unknown)? } else { 0.0 };
    let power = if a.has("-power") { a.number("-power").ok_or_else(unknown)? } else { 2.0 };
    let width = (RANGE * input.deformation(direction) - from).max(from) / POINTS as f64;
    let beyond: Vec<f64> = (1..=POINTS).map(|i| width * i as f64).collect();
    let side = |sign: f64| beyond.iter().map(move |x| (sign * (from + x), sign * factor * x.powf(power)));
    let middle = if from > 0.0 { vec![(-from, 0.0), (from, 0.0)] } else { vec![(0.0, 0.0)] };
    let points: Vec<(f64, f64)> = side(-1.0).rev().chain(middle).chain(side(1.0)).collect();
    let list = |of: fn(&(f64, f64)) -> f64| {
        points.iter().fold(String::new(), |mut out, p| {
            let _ = write!(out, " {:.6e}", of(p));
            out
        })
    };
    let mut form = StandardForm::default();
    let tag = input.next_material(&form);
    let (strains, stresses) = (list(|p| p.0), list(|p| p.1));
    form.commands.push(format!("uniaxialMaterial ElasticMultiLinear {tag} -strain{strains} -stress{stresses}"));
    form.add(direction, tag);
    Ok(vec![form])
}
