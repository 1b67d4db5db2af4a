//! Load combinations of a code with the horizontal motion.

use crate::isolate::Study;

/// A combination: factors on the dead load D and the live load L, beside Q_E with either sign.
#[derive(Clone, Copy, Debug)]
pub(super) struct Combination {
    /// Name in tables.
    pub(super) name: &'static str,
    /// Factor on D, with the part of the vertical motion if the records have none.
    pub(super) dead: f64,
    /// Factor on L.
    pub(super) live: f64,
}

impl Combination {
    /// The vertical load of D and L.
    pub(super) fn of(&self, [dead, live]: [f64; 2]) -> f64 {
        self.dead * dead + self.live * live
    }
}

/// The combinations with the largest and with the least dead load. Factors that the code lacks are NaN.
pub(super) fn combinations(study: &Study) -> [Combination; 2] {
    let rule = |name: &str| study.code.value("load_combinations", name).unwrap_or(f64::NAN);
    // A vertical component of the motion is in Q_E already.
    let has_vertical = study.motions.iter().any(|p| p.vertical.is_some());
    let vertical = if has_vertical { 0.0 } else { rule("vertical") * study.sms.unwrap_or(0.0) };
    [
        Combination { name: "most dead", dead: rule("dead_max") + vertical, live: rule("live_max") },
        Combination { name: "least dead", dead: rule("dead_min") - vertical, live: 0.0 },
    ]
}

/// Dead load and full live load of a gravity load of the script.
pub(super) fn dead_and_live(study: &Study, gravity: f64) -> [f64; 2] {
    let (ratio, applied) = (study.live.over_dead, study.live.in_script);
    let dead = gravity / (1.0 + applied * ratio);
    [dead, ratio * dead]
}
