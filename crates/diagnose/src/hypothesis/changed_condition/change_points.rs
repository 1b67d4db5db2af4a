//! Times at which a parameter may have changed, from the derivatives of the fitted baseline.
//!
//! A parameter that has another value for a time adds c J_k(t) to the response there, with the derivatives J_k of the whole
//! run. The user's parameters follow, so that of both residual and addition only the part outside of all derivatives counts. Sums over
//! cells of time give the error that each span leaves.

use super::super::context::Sensitivities;
use crate::candidate::proposal::Course;
use crate::prior::{CHANGE_PLACES, HISTORY_SCALES, MIN_RAMP_PLACES};
use nalgebra::{Cholesky, DVector, Dyn};

/// Damping of the derivatives, in parts of their norm, as in the screening of proposals.
const DAMPING: f64 = 1e-3;
/// Part of an addition outside of the derivatives below which it is none of its own.
const MIN_OWN_PART: f64 = 1e-6;

/// A span of time with another value of a parameter, or on the way to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Span {
    /// Number of the run among the fitted ones; none for the same in all.
    pub(super) run: Option<usize>,
    /// Number of the parameter among the free ones.
    pub(super) coordinate: usize,
    pub(super) course: Course,
    /// Part of the run at which it begins; none for its beginning.
    pub(super) from: Option<f64>,
    /// Part of the run at which it ends; none for its end.
    pub(super) to: Option<f64>,
    /// Change of the coordinate.
    pub(super) change: f64,
    /// Share of the squared residual that it takes.
    pub(super) share: f64,
}

impl Span {
    /// Number of times at which the parameter changes.
    pub(super) fn change_points(&self) -> usize {
        usize::from(self.from.is_some()) + usize::from(self.to.is_some())
    }
}

/// A step without times and size.
const STEP: Span =
    Span { run: None, coordinate: 0, course: Course::Step, from: None, to: None, change: 0.0, share: 0.0 };

/// Place of a row of the residual in its run.
#[derive(Clone, Copy)]
struct Row {
    run: usize,
    /// Part of the run, from 0 to 1.
    part: f64,
}

/// Residual and derivatives with the part of both that the user's parameters do not take.
pub(super) struct ChangePoints<'a> {
    s: &'a Sensitivities<'a>,
    rows: Vec<Row>,
    normal: Cholesky<f64, Dyn>,
    /// Residual outside of the derivatives, and its square.
    residual: DVector<f64>,
    square: f64,
}

/// An addition to the response: its square, its product with the residual, and its products with all derivatives.
#[derive(Clone)]
struct Addition {
    square: f64,
    product: f64,
    derivatives: DVector<f64>,
}

impl Addition {
    fn none(parameters: usize) -> Self {
        Self { square: 0.0, product: 0.0, derivatives: DVector::zeros(parameters) }
    }

    /// Adds another with a weight.
    fn add(&mut self, other: &Self, weight: f64) {
        self.square += weight * weight * other.square;
        self.product += weight * other.product;
        self.derivatives.axpy(weight, &other.derivatives, 1.0);
    }

    fn minus(&self, other: &Self) -> Self {
        Self {
            square: self.square - other.square,
            product: self.product - other.product,
            derivatives: &self.derivatives - &other.derivatives,
        }
    }
}

impl<'a> ChangePoints<'a> {
    /// `channels` are the numbers of the channels of each fitted run. `None` for a residual that the derivatives take whole.
    pub(super) fn new(s: &'a Sensitivities<'a>, channels: &[usize]) -> Option<Self> {
        let runs = channels.iter().enumerate().flat_map(|(run, n)| std::iter::repeat_n(run, *n));
        let of_channel = |(run, n): (usize, &usize)| {
            let n = *n;
            (0..n).map(move |i| Row { run, part: (i as f64 + 0.5) / n as f64 })
        };
        let rows: Vec<Row> = runs.zip(s.channels).flat_map(of_channel).collect();
        if rows.len() != s.residual.len() || s.derivatives.nrows() != rows.len() {
            return None;
        }
        let j = s.derivatives;
        let mut normal = j.tr_mul(j);
        let damping = (DAMPING * j.norm()).powi(2).max(f64::MIN_POSITIVE);
        (0..normal.nrows()).for_each(|i| normal[(i, i)] += damping);
        let normal = normal.cholesky()?;
        let residual = s.residual - j * normal.solve(&j.tr_mul(s.residual));
        let square = residual.norm_squared();
        (square > 0.0).then_some(Self { s, rows, normal, residual, square })
    }

    /// The addition of rows with a weight each.
    fn addition(&self, coordinate: usize, weight: impl Fn(&Row) -> f64) -> Addition {
        let mut out = Addition::none(self.s.derivatives.ncols());
        for (i, row) in self.rows.iter().enumerate() {
            let x = weight(row) * self.s.derivatives[(i, coordinate)];
            if x != 0.0 {
                out.square += x * x;
                out.product += x * self.residual[i];
                out.derivatives.axpy(x, &self.s.derivatives.row(i).transpose(), 1.0);
            }
        }
        out
    }

    /// Share of the squared residual that an addition of the best size takes, and that size.
    fn taken(&self, a: &Addition) -> Option<(f64, f64)> {
        let own = a.square - a.derivatives.dot(&self.normal.solve(&a.derivatives));
        if own <= MIN_OWN_PART * a.square {
            return None;
        }
        // What rounding leaves of a perfect fit.
        let share = (a.product * a.product / (own * self.square)).min(1.0 - MIN_OWN_PART);
        Some((share, -a.product / own))
    }

    /// The best span of a parameter in a run: from a time on, up to one, and between two.
    pub(super) fn spans(&self, run: usize, coordinate: usize) -> Vec<Span> {
        // Sums up to each place.
        let mut sums = vec![Addition::none(self.s.derivatives.ncols())];
        for own in self.cells(run, coordinate) {
            let mut sum = sums[sums.len() - 1].clone();
            sum.add(&own, 1.0);
            sums.push(sum);
        }
        let pairs = (0..CHANGE_PLACES).flat_map(|begin| (begin + 1..=CHANGE_PLACES).map(move |end| (begin, end)));
        // Another value in the whole run has a form of its own.
        let partial = pairs.filter(|pair| *pair != (0, CHANGE_PLACES));
        let added = partial.map(|(begin, end)| ((begin, end), sums[end].minus(&sums[begin])));
        self.best(Span { run: Some(run), coordinate, ..STEP }, added)
    }

    /// Another value of a parameter in all of a run; none where that is another value of the parameter in all runs.
    pub(super) fn whole_run(&self, run: usize, coordinate: usize) -> Option<Span> {
        let (share, change) = self.taken(&self.addition(coordinate, |row| f64::from(u8::from(row.run == run))))?;
        Some(Span { run: Some(run), coordinate, change, share, ..STEP })
    }

    /// The best ramps of a parameter in a run: over all of it, from a time on, up to one, and between two; and the best ways
    /// back from a time on, up to the end and up to another time.
    pub(super) fn ramps(&self, run: usize, coordinate: usize) -> Vec<Span> {
        let cells = self.cells(run, coordinate);
        let of_course = |course: Course, first: usize| {
            let weight = |part: f64| match course {
                Course::Recovery if part < 0.0 => 0.0,
                Course::Recovery => (1.0 - part).max(0.0),
                _ => part.clamp(0.0, 1.0),
            };
            let ends = |begin| (begin + MIN_RAMP_PLACES..=CHANGE_PLACES).map(move |end| (begin, end));
            let added = (first..CHANGE_PLACES).flat_map(ends).map(|(begin, end)| {
                let mut sum = Addition::none(self.s.derivatives.ncols());
                for (m, own) in cells.iter().enumerate() {
                    sum.add(own, weight((m as f64 + 0.5 - begin as f64) / (end - begin) as f64));
                }
                ((begin, end), sum)
            });
            self.best(Span { run: Some(run), coordinate, course, ..STEP }, added)
        };
        // A way back from the beginning on is a ramp from another usual value.
        [of_course(Course::Ramp, 0), of_course(Course::Recovery, 1)].concat()
    }

    /// The best ramps of a parameter that follow a clock in all runs: over all of it, and up to a part of it.
    pub(super) fn ramps_by_clock(&self, coordinate: usize, clock: impl Fn(usize, f64) -> f64) -> Vec<Span> {
        let added = (MIN_RAMP_PLACES..=CHANGE_PLACES).map(|end| {
            let part = |row: &Row| (clock(row.run, row.part) * CHANGE_PLACES as f64 / end as f64).min(1.0);
            ((0, end), self.addition(coordinate, part))
        });
        self.best(Span { coordinate, course: Course::Ramp, ..STEP }, added)
    }

    /// The additions of a parameter in each of the places of a run.
    fn cells(&self, run: usize, coordinate: usize) -> Vec<Addition> {
        let cell = |row: &Row| ((row.part * CHANGE_PLACES as f64) as usize).min(CHANGE_PLACES - 1);
        let own = |m| self.addition(coordinate, |row| f64::from(u8::from(row.run == run && cell(row) == m)));
        (0..CHANGE_PLACES).map(own).collect()
    }

    /// The additions between two places that take most: one for each of with and without a time of beginning and of end. In one
    /// run a step from a time on is the same as one up to it; others tell them apart.
    fn best(&self, of: Span, added: impl Iterator<Item = ((usize, usize), Addition)>) -> Vec<Span> {
        let mut best: [Option<Span>; 4] = [None; 4];
        for ((begin, end), addition) in added {
            let Some((share, change)) = self.taken(&addition) else { continue };
            let part = |place: usize, none: usize| (place != none).then(|| place as f64 / CHANGE_PLACES as f64);
            let (from, to) = (part(begin, 0), part(end, CHANGE_PLACES));
            let best = &mut best[usize::from(from.is_some()) + 2 * usize::from(to.is_some())];
            if best.is_none_or(|b| share > b.share) {
                *best = Some(Span { from, to, change, share, ..of });
            }
        }
        best.into_iter().flatten().collect()
    }

    /// Largest share that a parameter takes which follows a history: in proportion to it, or towards a limit; in one run or in
    /// all. `histories` have a value for each run and part of it, from 0 to about 1.
    pub(super) fn share_of_histories(&self, histories: &[Box<dyn Fn(usize, f64) -> f64 + '_>]) -> f64 {
        let runs = self.rows.last().map_or(0, |row| row.run + 1);
        let mut most = 0.0f64;
        for (coordinate, history) in (0..self.s.derivatives.ncols()).flat_map(|k| histories.iter().map(move |h| (k, h)))
        {
            for scale in HISTORY_SCALES {
                let factor = |row: &Row| {
                    let x = history(row.run, row.part);
                    if scale.is_finite() { 1.0 - (-x / scale).exp() } else { x }
                };
                let of_runs = (0..runs).map(Some).chain([None]);
                let share = |run: Option<usize>| {
                    let in_run = |row: &Row| if run.is_none_or(|r| r == row.run) { factor(row) } else { 0.0 };
                    self.taken(&self.addition(coordinate, in_run)).map_or(0.0, |(share, _)| share)
                };
                most = of_runs.map(share).fold(most, f64::max);
            }
        }
        most
    }
}

/// Derivatives as they are averaged for the search: the same of all channels of a study.
#[cfg(test)]
pub(super) fn of_series(residual: &[f64], columns: &[Vec<f64>]) -> (DVector<f64>, nalgebra::DMatrix<f64>) {
    let matrix = nalgebra::DMatrix::from_fn(residual.len(), columns.len(), |i, k| columns[k][i]);
    (DVector::from_column_slice(residual), matrix)
}

#[cfg(test)]
mod tests {
    use super::{ChangePoints, Sensitivities, of_series};
    use crate::test_support::white_noise;

    const N: usize = 400;

    /// Friction and stiffness of a device under a sine in two runs of 400 points each: derivatives by both.
    fn derivatives() -> Vec<Vec<f64>> {
        let phase = |i: usize| 0.11 * (i % N) as f64;
        let friction = (0..2 * N).map(|i| phase(i).cos().signum()).collect();
        vec![friction, (0..2 * N).map(|i| phase(i).sin()).collect()]
    }

    /// The best spans where the second run has an effect on the friction, beside noise.
    fn found(effect: impl Fn(f64) -> f64, trend: bool) -> (Vec<super::Span>, f64) {
        let j = derivatives();
        let noise = white_noise(3, 2 * N);
        let residual: Vec<f64> = (0..2 * N)
            .map(|i| {
                let t = (i % N) as f64 / N as f64;
                let own = if i >= N || trend { effect(t) } else { 0.0 };
                0.1 * noise[i] - own * j[0][i]
            })
            .collect();
        let (residual, derivatives) = of_series(&residual, &j);
        let channels = [N, N];
        let s = Sensitivities { residual: &residual, derivatives: &derivatives, channels: &channels };
        let points = ChangePoints::new(&s, &[1, 1]).expect("a residual");
        let spans = (0..2).flat_map(|run| (0..2).flat_map(|k| points.spans(run, k)).collect::<Vec<_>>()).collect();
        let time = |_: usize, part: f64| part;
        (spans, points.share_of_histories(&[Box::new(time)]))
    }

    fn best(spans: &[super::Span], changes: usize) -> super::Span {
        // In two runs the parameters follow the first, so that a span has its beginning or its end.
        let of = spans.iter().filter(|s| s.change_points() == changes);
        *of.max_by(|a, b| a.share.total_cmp(&b.share)).expect("a span")
    }

    #[test]
    fn a_parameter_that_is_larger_for_a_time_is_found_with_its_times() {
        let (spans, history) = found(|t| f64::from(u8::from((0.25..0.7).contains(&t))), false);
        let s = best(&spans, 2);
        assert_eq!((s.run, s.coordinate, s.from, s.to), (Some(1), 0, Some(0.25), Some(0.7)));
        assert!((s.change - 1.0).abs() < 0.05 && s.share > 0.9 && history < 0.8, "{s:?} {history}");
    }

    #[test]
    fn a_step_needs_one_change() {
        let (spans, history) = found(|t| f64::from(u8::from(t >= 0.6)), false);
        let (one, two) = (best(&spans, 1), best(&spans, 2));
        assert_eq!((one.run, one.coordinate, one.from, one.to), (Some(1), 0, Some(0.6), None));
        assert!(two.share < one.share + 0.01 && history < one.share, "{one:?} {two:?} {history}");
    }

    /// A run with another strength from its first moment on. A change a little later takes hardly more.
    #[test]
    fn another_value_in_a_whole_run_takes_as_much_as_a_change_at_its_beginning() {
        let j = derivatives();
        let noise = white_noise(7, 2 * N);
        let residual: Vec<f64> = (0..2 * N).map(|i| 0.1 * noise[i] - if i < N { 0.0 } else { j[0][i] }).collect();
        let (residual, derivatives) = of_series(&residual, &j);
        let s = Sensitivities { residual: &residual, derivatives: &derivatives, channels: &[N, N] };
        let points = ChangePoints::new(&s, &[1, 1]).expect("a residual");
        let whole = points.whole_run(1, 0).expect("another value");
        let later = points.spans(1, 0).into_iter().map(|s| s.share).fold(0.0, f64::max);
        assert!(whole.share > 0.9 && later < whole.share + 0.01, "{whole:?} {later}");
    }

    #[test]
    fn a_trend_is_told_by_its_history() {
        let (spans, history) = found(|t| t, true);
        assert!(best(&spans, 1).share < history && best(&spans, 2).share < history, "{spans:?} {history}");
    }

    /// A strength that grows between two times, and one that follows the clock of both runs.
    #[test]
    fn ramps_are_found_with_their_times() {
        let j = derivatives();
        let noise = white_noise(5, 2 * N);
        let time = |i: usize| (i % N) as f64 / N as f64;
        let best = |effect: &dyn Fn(usize) -> f64| {
            let residual: Vec<f64> = (0..2 * N).map(|i| 0.05 * noise[i] - effect(i) * j[0][i]).collect();
            let (residual, derivatives) = of_series(&residual, &j);
            let s = Sensitivities { residual: &residual, derivatives: &derivatives, channels: &[N, N] };
            let points = ChangePoints::new(&s, &[1, 1]).expect("a residual");
            let one = points.ramps(1, 0).into_iter().max_by(|a, b| a.share.total_cmp(&b.share)).expect("a ramp");
            (one, points.ramps_by_clock(0, |_, part| part)[0].share)
        };
        let (one, clock) = best(&|i| if i < N { 0.0 } else { ((time(i) - 0.25) / 0.5).clamp(0.0, 1.0) });
        assert_eq!((one.from, one.to), (Some(0.25), Some(0.75)));
        assert!(one.share > 0.9 && clock < one.share, "{one:?} {clock}");
        let (one, clock) = best(&time);
        assert!(clock > 0.9 && one.share < clock, "{one:?} {clock}");
    }

    /// A strength that jumps, and is back at its own a while later.
    #[test]
    fn a_way_back_is_found_with_its_times() {
        let j = derivatives();
        let noise = white_noise(11, 2 * N);
        let effect = |i: usize| {
            let part = ((i % N) as f64 / N as f64 - 0.3) / 0.5;
            if i < N || part < 0.0 { 0.0 } else { (1.0 - part).max(0.0) }
        };
        let residual: Vec<f64> = (0..2 * N).map(|i| 0.05 * noise[i] - effect(i) * j[0][i]).collect();
        let (residual, derivatives) = of_series(&residual, &j);
        let s = Sensitivities { residual: &residual, derivatives: &derivatives, channels: &[N, N] };
        let points = ChangePoints::new(&s, &[1, 1]).expect("a residual");
        let best = points.ramps(1, 0).into_iter().max_by(|a, b| a.share.total_cmp(&b.share)).expect("a ramp");
        let steps = points.spans(1, 0).into_iter().map(|s| s.share).fold(0.0, f64::max);
        assert_eq!((best.course, best.from, best.to), (super::Course::Recovery, Some(0.3), Some(0.8)));
        assert!(best.share > 0.9 && steps < best.share, "{best:?} {steps}");
    }

    #[test]
    fn noise_takes_little() {
        let (spans, _) = found(|_| 0.0, false);
        assert!(spans.iter().all(|s| s.share < 0.05), "{spans:?}");
    }
}
