//! One parameter of the user's with another value in one run: a condition that has changed.

use super::quantity::digits;
use crate::fit::search_settings::{CHANGED_PARAMETER_STEPS, CHANGED_PARAMETER_TOLERANCE};
use crate::prior::BOUND_STEP;
use hysteron_identify::study::ParameterSpace;

/// A parameter with the values that suit each run best.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ChangedParameter {
    name: String,
    /// Runs, the changed one first.
    by_run: Vec<(String, f64)>,
}

impl ChangedParameter {
    /// The parameter that alone brings the squared error of a run to `enough`, and leaves least; `None` if none does.
    ///
    /// `residual` gives the residuals of a run at a point of the unit cube. From `point` each coordinate follows the secant
    /// of its residuals, and the last simulation decides.
    pub(super) fn find(
        space: &ParameterSpace,
        point: &[f64],
        (changed, others): (usize, &[usize]),
        enough: f64,
        residual: impl Fn(usize, &[f64]) -> Option<Vec<f64>>,
        name_of: impl Fn(usize) -> String,
    ) -> Option<Self> {
        let own = residual(changed, point)?;
        let alone = |(k, (index, _)): (usize, (usize, _))| {
            let (moved, error) = best_value(point, k, &own, &|at| residual(changed, at))?;
            Some((k, index, moved, error))
        };
        let found = space.free().enumerate().filter_map(alone).filter(|(.., error)| *error <= enough);
        let (k, index, moved, _) = found.min_by(|a, b| a.3.total_cmp(&b.3))?;
        let value = |at: &[f64]| space.values_at(at).ok().map(|values| values[index]);
        let mut by_run = vec![(name_of(changed), value(&moved)?)];
        for run in others {
            let (at, _) = best_value(point, k, &residual(*run, point)?, &|at| residual(*run, at))?;
            by_run.push((name_of(*run), value(&at)?));
        }
        Some(Self { name: space.parameters[index].name.clone(), by_run })
    }

    /// The change in words.
    pub(super) fn description(&self) -> String {
        let values: Vec<String> =
            self.by_run.iter().map(|(run, x)| format!("{} in the run {run}", digits(*x, 3))).collect();
        format!("a changed condition explains as much: {} of {}", self.name, values.join(", "))
    }
}

/// The point with the best value of a coordinate, and its squared error.
fn best_value(
    point: &[f64],
    k: usize,
    own: &[f64],
    residual: &impl Fn(&[f64]) -> Option<Vec<f64>>,
) -> Option<(Vec<f64>, f64)> {
    let squares = |r: &[f64]| r.iter().map(|x| x * x).sum::<f64>();
    let mut best = (point.to_vec(), squares(own));
    let (mut before, mut x, mut at) = (own.to_vec(), point[k], point.to_vec());
    at[k] += if point[k] > 0.5 { -BOUND_STEP } else { BOUND_STEP };
    for _ in 0..CHANGED_PARAMETER_STEPS {
        let now = residual(&at)?;
        let error = squares(&now);
        if error < best.1 {
            best = (at.clone(), error);
        }
        let step = at[k] - x;
        let slope: Vec<f64> = now.iter().zip(&before).map(|(a, b)| (a - b) / step).collect();
        let downhill = slope.iter().zip(&now).map(|(j, r)| j * r).sum::<f64>() / squares(&slope);
        let next = (at[k] - downhill).clamp(0.0, 1.0);
        if !next.is_finite() || (next - at[k]).abs() < CHANGED_PARAMETER_TOLERANCE {
            break;
        }
        (x, before) = (at[k], now);
        at[k] = next;
    }
    Some(best)
}

#[cfg(test)]
mod tests {
    use super::ChangedParameter;
    use hysteron_identify::study::{Parameter, ParameterKind, ParameterRange, ParameterSpace, Scale};

    fn space() -> ParameterSpace {
        let free = |name: &str, lower, upper| {
            let range = ParameterRange { lower, upper, scale: Scale::Log };
            Parameter { name: name.into(), kind: ParameterKind::Free(range) }
        };
        ParameterSpace::new(vec![free("Fn", 1.0, 100.0), free("k", 10.0, 1000.0)]).expect("two free parameters")
    }

    /// Residuals of two runs of a force of friction and of a spring. The second was recorded with other values.
    fn found(friction: f64, stiffness: f64) -> Option<ChangedParameter> {
        let residual = |run: usize, point: &[f64]| {
            let values = space().values_at(point).ok()?;
            let recorded = if run == 1 { (friction, stiffness) } else { (10.0, 100.0) };
            let force = |(f, k): (f64, f64), i: usize| if i.is_multiple_of(2) { f } else { -f } + k * 0.01 * i as f64;
            Some((0..40).map(|i| force((values[0], values[1]), i) - force(recorded, i)).collect())
        };
        let name = |run: usize| ["first", "second"][run].to_owned();
        ChangedParameter::find(&space(), &space().unit_point(&[11.0, 100.0]), (1, &[0]), 1.0, residual, name)
    }

    #[test]
    fn the_parameter_that_changed_is_found_with_its_value_in_each_run() {
        let told = "a changed condition explains as much: Fn of 13.9 in the run second, 10 in the run first";
        assert_eq!(found(13.9, 100.0).map(|c| c.description()).as_deref(), Some(told));
    }

    #[test]
    fn two_changed_parameters_are_not_one() {
        assert_eq!(found(13.9, 300.0), None);
    }
}
