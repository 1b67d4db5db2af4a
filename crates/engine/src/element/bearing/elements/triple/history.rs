//! History of the heat that entered a surface, in an array of fixed length.
//!
//! The temperature is the convolution of the heat flux with a kernel that decreases with the age of the heat. The heat
//! of one step is a *cell*: up to two amounts at two times. Cells are stored in levels. If a level is full, its two
//! oldest cells merge into one of the next level.
//!
//! The two amounts of the merged cell have the moments 0 to 3 of the four (Gauss quadrature with the heat as its
//! weight). Up to [`STEPS`] steps a cell is never longer than 1/6 of its age. The relative error of the convolution is
//! then that of Gauss' rule with two points. For the kernels of heat conduction it is about 10⁻⁶, measured against the
//! direct convolution in `tests/laws/heated.rs`.

/// Number of cells of a level.
const CELLS_PER_LEVEL: usize = 8;
/// Number of levels; a cell of level n has the heat of 2^n steps.
const LEVELS: usize = 16;
/// Number of state variables of a cell.
const CELL_LEN: usize = 4;
/// Number of state variables of a history.
pub const LEN: usize = LEVELS * (1 + CELLS_PER_LEVEL * CELL_LEN);
/// Number of steps up to which cells are at most 1/6 of their age.
pub const STEPS: usize = 6 << (LEVELS - 1);

/// Variance of the times of a cell, over the square of its extent, that is round-off.
const MIN_VARIANCE: f64 = 1e-16;

/// Heat of a step: two pairs of time and amount, with amounts ≥ 0.
pub type Cell = [f64; CELL_LEN];

/// Merges two cells into one with the moments 0 to 3 of their heat.
fn merge(a: &[f64], b: &[f64]) -> Cell {
    let points = || a.chunks_exact(2).chain(b.chunks_exact(2)).map(|p| (p[0], p[1]));
    let heat: f64 = points().map(|(_, q)| q).sum();
    if heat <= 0.0 {
        return [b[0], 0.0, b[2], 0.0];
    }
    let centre = points().map(|(t, q)| t * q).sum::<f64>() / heat;
    let moment = |n: i32| points().map(|(t, q)| (t - centre).powi(n) * q).sum::<f64>() / heat;
    let variance = moment(2);
    let extent = (b[0] - a[0]).abs().max((b[2] - a[0]).abs());
    if variance <= MIN_VARIANCE * extent * extent {
        return [centre, heat, centre, 0.0];
    }
    let skew = 0.5 * moment(3) / variance;
    let root = (skew * skew + variance).sqrt();
    let share = 0.5 * (1.0 + skew / root);
    [centre + skew - root, share * heat, centre + skew + root, (1.0 - share) * heat]
}

/// Adds the heat of the latest step to a history of length [`LEN`].
pub fn push(history: &mut [f64], cell: Cell) {
    let (counts, cells) = history.split_at_mut(LEVELS);
    let mut next = cell;
    for (i, (count, level)) in counts.iter_mut().zip(cells.chunks_exact_mut(CELLS_PER_LEVEL * CELL_LEN)).enumerate() {
        let n = *count as usize;
        let store = |level: &mut [f64], at: usize, cell: &Cell| {
            level[at * CELL_LEN..(at + 1) * CELL_LEN].copy_from_slice(cell);
        };
        if n < CELLS_PER_LEVEL {
            store(level, n, &next);
            *count += 1.0;
            return;
        }
        let merged = merge(&level[..CELL_LEN], &level[CELL_LEN..2 * CELL_LEN]);
        level.copy_within(2 * CELL_LEN.., 0);
        if i + 1 == LEVELS {
            level.copy_within(..(CELLS_PER_LEVEL - 2) * CELL_LEN, CELL_LEN);
            store(level, 0, &merged);
            store(level, CELLS_PER_LEVEL - 1, &next);
        } else {
            store(level, CELLS_PER_LEVEL - 2, &next);
            *count = (CELLS_PER_LEVEL - 1) as f64;
        }
        next = merged;
    }
}

/// Times and amounts of the heat.
pub fn heat(history: &[f64]) -> impl Iterator<Item = (f64, f64)> {
    let (counts, cells) = history.split_at(LEVELS);
    counts
        .iter()
        .zip(cells.chunks_exact(CELLS_PER_LEVEL * CELL_LEN))
        .flat_map(|(n, level)| level[..*n as usize * CELL_LEN].chunks_exact(2))
        .map(|p| (p[0], p[1]))
        .filter(|p| p.1 > 0.0)
}
