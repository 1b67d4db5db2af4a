//! Levels of intensity by hunting for the end of a record's curve and filling its gaps.

use super::Point;
use crate::performance::Hunt;

/// Share of the gap below the end at which it is divided: collapses are slow and tell little, so that the level stays low
/// (Vamvatsikos and Cornell 2004, Applied incremental dynamic analysis, Earthquake Spectra 20(2)).
const LOW_SHARE: f64 = 1.0 / 3.0;

/// The next level for the analyses made so far, in the order in which they were made; none if there are enough.
pub(super) fn next(plan: &Hunt, made: &[Point]) -> Option<f64> {
    if made.len() >= plan.runs {
        return None;
    }
    let mut points: Vec<&Point> = made.iter().collect();
    points.sort_by(|a, b| a.level.total_cmp(&b.level));
    let end = points.iter().position(|p| p.is_end());
    let Some(end) = end else {
        let Some(last) = points.last() else { return Some(plan.first) };
        if last.level < plan.highest {
            let step = plan.step + plan.growth * (made.len() - 1) as f64;
            return Some((last.level + step).min(plan.highest));
        }
        return crossings(plan, &points).or_else(|| widest(&points));
    };
    let (low, high) = (if end == 0 { 0.0 } else { points[end - 1].level }, points[end].level);
    if (high - low) / high > plan.resolution {
        return Some(low + LOW_SHARE * (high - low));
    }
    let below = &points[..=end];
    crossings(plan, below).or_else(|| widest(&below[..end]))
}

/// The middle of the widest gap in which a limit state is reached for the first time and that is still too wide.
fn crossings(plan: &Hunt, points: &[&Point]) -> Option<f64> {
    let states = points.first()?.reached.len();
    let gap = |k: usize| {
        let at = points.iter().position(|p| p.reached[k] == Some(true))?;
        let high = points[at].level;
        let below = points[..at].iter().rev().find(|p| p.reached[k] == Some(false));
        let low = below.map_or(0.0, |p| p.level);
        let share = (high - low) / high;
        (share > plan.resolution).then_some((share, 0.5 * (low + high)))
    };
    (0..states).filter_map(gap).reduce(|a, b| if b.0 > a.0 { b } else { a }).map(|g| g.1)
}

/// The middle of the widest gap between levels, from zero on.
fn widest(points: &[&Point]) -> Option<f64> {
    let levels = points.iter().map(|p| p.level);
    let lower = std::iter::once(0.0).chain(levels.clone());
    let gaps = lower.zip(levels).map(|(a, b)| (b - a, 0.5 * (a + b)));
    gaps.reduce(|a, b| if b.0 > a.0 * (1.0 + 1e-12) { b } else { a }).map(|g| g.1)
}

#[cfg(test)]
mod tests {
    use super::next;
    use crate::incremental::{Ending, Point};
    use crate::performance::Hunt;

    /// A record whose demand is 0.3 of the level, with a limit at 0.2 and collapse above a level.
    fn point(level: f64, collapse: f64) -> Point {
        let collapsed = level > collapse;
        let ending = if collapsed { Ending::Collapsed } else { Ending::Complete };
        let d = 0.3 * level;
        let reached = vec![Some(collapsed || d > 0.2), Some(collapsed)];
        Point { level, ending, failure: String::new(), demands: vec![d, f64::NAN], reached }
    }

    fn run(plan: &Hunt, collapse: f64) -> Vec<Point> {
        let mut made = vec![];
        while let Some(level) = next(plan, &made) {
            assert!(made.iter().all(|p: &Point| p.level != level), "{level} twice");
            made.push(point(level, collapse));
        }
        made
    }

    #[test]
    fn collapse_and_crossings_are_bracketed_to_the_resolution() {
        let plan = Hunt { first: 0.2, step: 0.2, growth: 0.1, highest: 5.0, runs: 16, resolution: 0.08 };
        let mut made = run(&plan, 1.7);
        assert_eq!(made.len(), 16);
        // The hunt: 0.2, 0.4, 0.7, 1.1, 1.6, 2.2 (collapse).
        let levels: Vec<f64> = made.iter().take(6).map(|p| (100.0 * p.level).round() / 100.0).collect();
        assert_eq!(levels, [0.2, 0.4, 0.7, 1.1, 1.6, 2.2]);
        made.sort_by(|a, b| a.level.total_cmp(&b.level));
        for (k, capacity) in [(0, 0.2 / 0.3), (1, 1.7)] {
            let at = made.iter().position(|p| p.reached[k] == Some(true)).expect("reached");
            let (low, high) = (made[at - 1].level, made[at].level);
            assert!(low <= capacity && capacity <= high && (high - low) / high <= 0.08, "{k}: {low} {high}");
        }
    }

    #[test]
    fn a_record_without_collapse_ends_at_the_highest_level() {
        let plan = Hunt { first: 0.5, step: 0.5, growth: 0.0, highest: 1.2, runs: 6, resolution: 0.1 };
        let made = run(&plan, 9.0);
        assert!(made.len() == 6 && made.iter().all(|p| p.level <= 1.2) && made[2].level == 1.2);
    }
}
