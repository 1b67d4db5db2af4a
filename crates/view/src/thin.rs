//! Rows that can be left out of a table without a difference that an eye sees.

use crate::numbers::range;

/// Rows of a table to keep, rising: the first, the last, those with the extremes of each column, and as many others as
/// a straight line between the kept rows needs to differ by no more than `tolerance` times the range of each column.
/// The tolerance is doubled until no more than `most` rows are kept.
///
/// `rows` has `columns` numbers a row. The rows are found by the method of Ramer (1972) and of Douglas and Peucker
/// (1973), with distances along the ordinate.
pub fn thinned(rows: &[f32], columns: usize, tolerance: f32, most: usize) -> Vec<usize> {
    let count = rows.len().checked_div(columns).unwrap_or(0);
    if count <= 2 {
        return (0..count).collect();
    }
    let column = |c: usize| (0..count).map(move |i| rows[i * columns + c]);
    let scales: Vec<f32> = (0..columns)
        .map(|c| {
            let (low, high) = range(column(c));
            if high > low { 1.0 / (high - low) } else { 0.0 }
        })
        .collect();
    let mut extremes = vec![0, count - 1];
    for c in (0..columns).filter(|c| scales[*c] > 0.0) {
        let (mut low, mut high) = (0, 0);
        for i in 1..count {
            if rows[i * columns + c] < rows[low * columns + c] {
                low = i;
            }
            if rows[i * columns + c] > rows[high * columns + c] {
                high = i;
            }
        }
        extremes.extend([low, high]);
    }
    extremes.sort_unstable();
    extremes.dedup();
    let mut tolerance = tolerance.max(f32::EPSILON);
    loop {
        let kept = within(rows, columns, &scales, &extremes, tolerance);
        if kept.len() <= most.max(extremes.len()) || tolerance > 1.0 {
            return kept;
        }
        tolerance *= 2.0;
    }
}

/// Rows that keep the distance of all others below the tolerance, among them the given ones.
fn within(rows: &[f32], columns: usize, scales: &[f32], given: &[usize], tolerance: f32) -> Vec<usize> {
    let mut kept = given.to_vec();
    let mut open: Vec<(usize, usize)> = given.windows(2).map(|w| (w[0], w[1])).collect();
    while let Some((from, to)) = open.pop() {
        let (mut worst, mut at) = (tolerance, None);
        let (a, b) = (&rows[from * columns..][..columns], &rows[to * columns..][..columns]);
        for i in from + 1..to {
            let share = (i - from) as f32 / (to - from) as f32;
            let row = &rows[i * columns..][..columns];
            for c in 0..columns {
                let distance = (row[c] - a[c] - share * (b[c] - a[c])).abs() * scales[c];
                if distance > worst {
                    (worst, at) = (distance, Some(i));
                }
            }
        }
        if let Some(i) = at {
            kept.push(i);
            open.extend([(from, i), (i, to)]);
        }
    }
    kept.sort_unstable();
    kept
}

#[cfg(test)]
mod tests {
    use super::thinned;

    /// A decaying oscillation with a single spike, and a second column.
    fn table() -> Vec<f32> {
        (0..5000)
            .flat_map(|i| {
                let t = i as f32 * 0.01;
                let spike = if i == 3333 { 2.0 } else { 0.0 };
                [(-0.05 * t).exp() * (6.0 * t).sin() + spike, (2.0 * t).cos()]
            })
            .collect()
    }

    #[test]
    fn peaks_stay_to_the_bit() {
        let rows = table();
        for most in [10, 100, 1000] {
            let kept = thinned(&rows, 2, 1e-3, most);
            assert!(kept.len() <= most.max(6), "{} rows for {most}", kept.len());
            for c in 0..2 {
                let all = (0..5000).map(|i| rows[2 * i + c]);
                let (low, high) = all.fold((f32::MAX, f32::MIN), |(l, h), x| (l.min(x), h.max(x)));
                assert!(kept.iter().any(|i| rows[2 * i + c] == high) && kept.iter().any(|i| rows[2 * i + c] == low));
            }
        }
    }

    #[test]
    fn rows_left_out_lie_on_the_line_between_their_neighbours() {
        let rows = table();
        let kept = thinned(&rows, 2, 1e-3, 5000);
        assert!(kept.len() < 2500, "{} rows are kept", kept.len());
        for w in kept.windows(2) {
            for i in w[0]..w[1] {
                for (c, range) in [(0, 3.0), (1, 2.0)] {
                    let share = (i - w[0]) as f32 / (w[1] - w[0]) as f32;
                    let (a, b) = (rows[2 * w[0] + c], rows[2 * w[1] + c]);
                    assert!((rows[2 * i + c] - a - share * (b - a)).abs() <= 1.1e-3 * range);
                }
            }
        }
    }

    #[test]
    fn short_and_flat_tables() {
        assert!(thinned(&[], 3, 1e-3, 10).is_empty());
        assert_eq!(thinned(&[1.0, 2.0], 1, 1e-3, 10), [0, 1]);
        assert_eq!(thinned(&[1.0; 50], 1, 1e-3, 10), [0, 49]);
    }
}
