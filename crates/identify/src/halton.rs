//! The Halton sequence (Halton 1960, Numer. Math. 2, 84-90): points that fill a unit cube evenly.

/// Prime bases, one a coordinate.
const BASES: [usize; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];

/// Largest number of coordinates. Points of more are of no use.
pub const MAX_COORDINATES: usize = BASES.len();

/// Coordinate `k`, from 0, of point `i` of the sequence, between 0 and 1; `None` from [`MAX_COORDINATES`] on.
pub fn halton(i: usize, k: usize) -> Option<f64> {
    let base = *BASES.get(k)?;
    let (mut rest, mut out, mut digit) = (i, 0.0, 1.0 / base as f64);
    while rest > 0 {
        out += (rest % base) as f64 * digit;
        rest /= base;
        digit /= base as f64;
    }
    Some(out)
}
