//! A joint that yields as it turns: a hinge at the end of a beam, or soil below a footing.

use super::AddedParameter;

/// Starts of the strength over the largest elastic force. The minimum of a slight yielding is narrow: a structure that yields
/// much more, or not at all, moves quite differently.
pub(super) const STRENGTH_STARTS: [f64; 5] = [0.99, 0.96, 0.83, 0.75, 0.62];

/// Words `R0 cR1 cR2` of `Steel02`, the transition from elastic to plastic, as its authors advise (Filippou, Popov and Bertero
/// 1983, Effects of bond deterioration on hysteretic behavior of reinforced concrete joints, UCB/EERC-83/19).
const TRANSITION: &str = "18.0 0.925 0.15";

/// Names of its parameters, without their prefix.
pub(super) struct YieldingJoint<'a> {
    /// Yield moment.
    pub(super) strength: &'a str,
    /// Stiffness after yielding, moment per rotation.
    pub(super) plastic: &'a str,
    /// Stiffness before it, moment per rotation.
    pub(super) initial: &'a str,
}

impl YieldingJoint<'_> {
    /// Kind of its material, and the words behind the tag.
    pub(super) fn law(&self) -> (&'static str, String) {
        let Self { strength, plastic, initial } = self;
        ("Steel02", format!("$hy_{strength} $hy_{initial} [expr {{$hy_{plastic}/$hy_{initial}}}] {TRANSITION}"))
    }

    /// Its parameters on the scales of the elastic model: a moment, and a rotational stiffness.
    ///
    /// Joints start stiff, because the fitted model has lost some stiffness already, and a joint as soft as its beam cannot yield
    /// slightly.
    pub(super) fn parameters(&self, moment: f64, stiffness: f64) -> Vec<AddedParameter> {
        let strength = AddedParameter::log(self.strength, 0.03 * moment, 3.0 * moment, 0.9 * moment);
        vec![
            AddedParameter { further_starts: STRENGTH_STARTS.map(|part| part * moment).into(), ..strength },
            AddedParameter::log(self.plastic, 1e-3 * stiffness, stiffness, 0.05 * stiffness),
            AddedParameter::log(self.initial, 0.05 * stiffness, 100.0 * stiffness, 30.0 * stiffness),
        ]
    }
}
