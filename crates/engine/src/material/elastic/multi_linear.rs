//! Multilinear plasticity by Masing's rule.

use crate::material::{MaterialResult, Strain, Stress, Uniaxial, UniaxialRoles, UniaxialTraits, updates_each_point};

/// Hysteresis with a symmetric piecewise linear envelope. Every branch after a reversal is the envelope scaled by
/// two.
#[derive(Clone, Debug, PartialEq)]
pub struct MultiLinear {
    /// Strains and stresses at the ends of the segments.
    points: Vec<[f64; 2]>,
    /// Slope of each segment.
    slope: Vec<f64>,
    /// Strain length of each segment.
    length: Vec<f64>,
    /// As in OpenSees, a yielded state that is committed again at the same strain counts as yielded in compression.
    compat: bool,
}

/// State variables before the segment ends.
const HEADER: usize = 4;
const STRAIN: usize = 0;
const STRESS: usize = 1;
/// Tangent minus the initial tangent.
const SOFTENING: usize = 2;
/// Segment at the end of the last step.
const SEGMENT: usize = 3;

/// Present end of a segment: strain in compression and in tension, stress in compression and in tension.
type End = [f64; 4];

impl MultiLinear {
    /// From positive strains and stresses with increasing strains. `None` if the points are invalid.
    pub fn new(points: Vec<[f64; 2]>, compat: bool) -> Option<Self> {
        let good = points.first().is_some_and(|p| p[0] > 0.0) && points.windows(2).all(|w| w[1][0] > w[0][0]);
        let before = |i: usize| if i == 0 { [0.0; 2] } else { points[i - 1] };
        let length: Vec<f64> = points.iter().enumerate().map(|(i, p)| p[0] - before(i)[0]).collect();
        let slope = points.iter().enumerate().map(|(i, p)| (p[1] - before(i)[1]) / length[i]).collect();
        good.then_some(Self { points, slope, length, compat })
    }

    /// Moves the ends of the segments before `line` to the end of the step on the yielded side (1 tension, 0
    /// compression). The ends of the other side follow at twice the segment length.
    fn move_ends(&self, ends: &mut [End], segment: usize, strain: f64, stress: f64, side: usize) {
        let (here, there) = (side, 1 - side);
        let s = if side == 1 { -2.0 } else { 2.0 };
        for i in 0..segment {
            (ends[i][here], ends[i][2 + here]) = (strain, stress);
            let from = if i == 0 { [strain, stress] } else { [ends[i - 1][there], ends[i - 1][2 + there]] };
            ends[i][there] = from[0] + s * self.length[i];
            ends[i][2 + there] = from[1] + s * self.length[i] * self.slope[i];
        }
        for i in segment.max(1)..ends.len() {
            let covered = s * self.length[i] + ends[i][here] - ends[i - 1][here];
            ends[i][there] = ends[i - 1][there] + covered;
            ends[i][2 + there] = ends[i - 1][2 + there] + (ends[i][there] - ends[i - 1][there]) * self.slope[i];
        }
    }
}

/// The state variables of the segment ends, four for each.
fn ends(words: &mut [f64]) -> &mut [End] {
    words[HEADER..].as_chunks_mut::<4>().0
}

impl Uniaxial for MultiLinear {
    updates_each_point! {}
    fn name(&self) -> &'static str {
        "MultiLinear"
    }
    fn state_len(&self) -> usize {
        HEADER + 4 * self.points.len()
    }
    fn init(&self, state: &mut [f64]) {
        state[..HEADER].fill(0.0);
        for (end, [strain, stress]) in ends(state).iter_mut().zip(&self.points) {
            *end = [-strain, *strain, -stress, *stress];
        }
    }

    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        next.copy_from_slice(&committed[..next.len()]);
        let x = strain.value;
        let rests = (x - committed[STRAIN]).abs() < f64::EPSILON;
        if rests {
            let segment = committed[SEGMENT] as usize;
            if self.compat && segment > 0 {
                let side = usize::from(x > committed[HEADER + 1]);
                self.move_ends(ends(next), segment, x, committed[STRESS], side);
            }
            let tangent = self.slope[0] + committed[SOFTENING];
            return Ok(Stress { value: committed[STRESS], tangent, damping: 0.0 });
        }
        let now = ends(next);
        let side = usize::from(x > now[0][1]);
        let s = if side == 1 { 1.0 } else { -1.0 };
        // The last segment extends beyond the last point.
        let found = now.iter().position(|end| s * x <= s * end[side]).unwrap_or(now.len() - 1);
        let segment = if x >= now[0][0] && x <= now[0][1] { 0 } else { found.max(usize::from(now.len() > 1)) };
        let value = now[segment][2 + side] + (x - now[segment][side]) * self.slope[segment];
        if segment > 0 {
            self.move_ends(now, segment, x, value, side);
        }
        let tangent = self.slope[segment];
        next[..HEADER].copy_from_slice(&[x, value, tangent - self.slope[0], segment as f64]);
        Ok(Stress { value, tangent, damping: 0.0 })
    }

    fn initial_tangent(&self) -> f64 {
        self.slope[0]
    }
    fn traits(&self) -> UniaxialTraits {
        UniaxialTraits::default()
    }
    fn roles(&self) -> UniaxialRoles<'_> {
        UniaxialRoles::default()
    }
}
