//! Heat that has entered a surface, remembered in a fixed number of words.
//!
//! The temperature is a convolution of the heat flux with a kernel that falls with the age of the heat. Heat of one step is a *cell*: up to
//! two amounts at two times. Cells are kept in levels; where a level is full, its two oldest cells become one of the level
//! above, whose two amounts have the moments 0 to 3 of the four (Gauss' quadrature for the heat itself). A cell is then never
//! longer than a sixth of its age until [`STEPS`] have passed, and the error of the convolution is that of Gauss' rule with two points, some 1e-6
//! of it for the kernels of heat conduction (measured against the direct convolution in `tests/laws/heated.rs`).

/// Cells of a level.
const CELLS: usize = 8;
/// Levels: the heat of level n is that of 2^n steps.
const LEVELS: usize = 16;
/// State variables of a cell.
const CELL: usize = 4;
/// State variables of a history.
pub const LEN: usize = LEVELS * (1 + CELLS * CELL);
/// Steps after which the oldest cells grow with the history.
pub const STEPS: usize = 6 << (LEVELS - 1);

/// Heat of a step: time and amount, twice. Amounts are not negative.
pub type Cell = [f64; CELL];

/// One cell of two, with the moments 0 to 3 of their heat.
fn merge(a: &[f64], b: &[f64]) -> Cell {
    let points = || a.chunks_exact(2).chain(b.chunks_exact(2)).map(|p| (p[0], p[1]));
    let heat: f64 = points().map(|(_, q)| q).sum();
    if heat <= 0.0 {
        return [b[0], 0.0, b[2], 0.0];
    }
    let centre = points().map(|(t, q)| t * q).sum::<f64>() / heat;
    let moment = |n: i32| points().map(|(t, q)| (t - centre).powi(n) * q).sum::<f64>() / heat;
    let spread = moment(2);
    let reach = (b[0] - a[0]).abs().max((b[2] - a[0]).abs());
    if spread <= 1e-16 * reach * reach {
        return [centre, heat, centre, 0.0];
    }
    let skew = 0.5 * moment(3) / spread;
    let root = (skew * skew + spread).sqrt();
    let share = 0.5 * (1.0 + skew / root);
    [centre + skew - root, share * heat, centre + skew + root, (1.0 - share) * heat]
}

/// Add the heat of a step, the latest so far, to a history of [`LEN`] words.
pub fn push(words: &mut [f64], cell: Cell) {
    let (counts, cells) = words.split_at_mut(LEVELS);
    let mut next = cell;
    for (i, (count, level)) in counts.iter_mut().zip(cells.chunks_exact_mut(CELLS * CELL)).enumerate() {
        let n = *count as usize;
        let put = |level: &mut [f64], at: usize, cell: &Cell| {
            level[at * CELL..(at + 1) * CELL].copy_from_slice(cell);
        };
        if n < CELLS {
            put(level, n, &next);
            *count += 1.0;
            return;
        }
        let up = merge(&level[..CELL], &level[CELL..2 * CELL]);
        level.copy_within(2 * CELL.., 0);
        if i + 1 == LEVELS {
            level.copy_within(..(CELLS - 2) * CELL, CELL);
            put(level, 0, &up);
            put(level, CELLS - 1, &next);
        } else {
            put(level, CELLS - 2, &next);
            *count = (CELLS - 1) as f64;
        }
        next = up;
    }
}

/// Times and amounts of heat.
pub fn heat(words: &[f64]) -> impl Iterator<Item = (f64, f64)> {
    let (counts, cells) = words.split_at(LEVELS);
    counts
        .iter()
        .zip(cells.chunks_exact(CELLS * CELL))
        .flat_map(|(n, level)| level[..*n as usize * CELL].chunks_exact(2))
        .map(|p| (p[0], p[1]))
        .filter(|p| p.1 > 0.0)
}
