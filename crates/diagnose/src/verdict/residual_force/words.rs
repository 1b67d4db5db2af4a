//! A residual force in words.

use super::{ResidualForce, ResidualPart};
use crate::verdict::quantity::digits;
use crate::verdict::summary::percent;

/// Windows that a sentence lists, at most.
const MAX_WINDOWS: usize = 2;
/// Excess of the share of the square over that of the time from which a quadrant is told.
const MIN_EXCESS: f64 = 0.15;
impl ResidualForce {
    /// The first sentence: place, run, size and time.
    pub(super) fn where_and_when(&self) -> String {
        let length = |w: &&[f64; 2]| w[1] - w[0];
        let mut windows: Vec<&[f64; 2]> = self.windows.iter().collect();
        windows.sort_by(|a, b| length(b).total_cmp(&length(a)));
        windows.truncate(MAX_WINDOWS);
        windows.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let listed: Vec<String> =
            windows.iter().map(|w| format!("{} to {} s", digits(w[0], 3), digits(w[1], 3))).collect();
        let most = if self.windows.len() > MAX_WINDOWS { ", mostly at " } else { ", at " };
        let at = if listed.is_empty() { String::new() } else { format!("{most}{}", listed.join(" and ")) };
        let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        format!(
            "The missing force is largest in {}, run {}: {}{unit} r.m.s., {} of the recorded one{at}.",
            self.place,
            self.run,
            digits(self.rms, 3),
            percent(self.ratio)
        )
    }

    /// The second sentence: the part that follows the motion, and the quadrant that has most of it.
    pub(super) fn at_what_motion(&self) -> String {
        let Some((_, direction)) = &self.course.deformation else {
            return "No device of the model shows the deformation there: record it to see what the missing force follows."
                .into();
        };
        let resists = |p: &ResidualPart| p.sense > 0.0;
        let part = self.parts.first().map(|p| {
            let what = match (p.follows, resists(p)) {
                ("speed", true) => "acts against the speed: the recorded loops are wider".to_owned(),
                ("speed", false) => "acts along the speed: the recorded loops are narrower".to_owned(),
                ("deformation", true) => "acts against the deformation: the recorded part is stiffer".to_owned(),
                ("deformation", false) => "acts along the deformation: the recorded part is softer".to_owned(),
                (_, true) => format!("acts against {direction} all the time"),
                (_, false) => format!("acts towards {direction} all the time"),
            };
            format!("{} of its square {what}", percent(p.share))
        });
        let excess = |q: &[f64; 2]| q[0] - q[1];
        let quadrants = self.quadrants.iter().flatten().enumerate();
        let most = quadrants.max_by(|a, b| excess(a.1).total_cmp(&excess(b.1))).filter(|(_, q)| excess(q) > MIN_EXCESS);
        let quadrant = most.map(|(k, [square, time])| {
            let back = direction.replacen('+', "-", 1);
            let motion = match k {
                0 => format!("the deformation towards {direction} grows"),
                1 => format!("the deformation towards {direction} shrinks"),
                2 => format!("the deformation towards {back} grows"),
                _ => format!("the deformation towards {back} shrinks"),
            };
            format!("{} of it lies where {motion}, {} of the time", percent(*square), percent(*time))
        });
        match (part, quadrant) {
            (Some(part), Some(quadrant)) => format!("{part}; {quadrant}."),
            (Some(part), None) => format!("{part}."),
            (None, Some(quadrant)) => format!("{}.", quadrant.replacen("of it lies", "of its square lies", 1)),
            (None, None) => "It follows the sign neither of the deformation nor of the speed there.".into(),
        }
    }
}
