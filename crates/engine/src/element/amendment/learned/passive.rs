//! Rules by which a learned law makes no energy.
//!
//! 1. Weights of stops, hysteresis, Maxwell elements, dashpots and friction are not negative; tails of the spring do not soften
//!    to a negative stiffness.
//! 2. Any factor may act on the strength: a level that falls cuts the force, and one that rises leaves it.
//! 3. A factor on a force may only fall as its variable goes on, since the stored energy would rise with it. Variables that
//!    change within a cycle act on the strength alone. A function of the deformation may act on the spring, which keeps a
//!    potential.
//!    Dashpots and friction store nothing: any factor may act on them where no Maxwell element stands beside them.
//! 4. A curve of slopes is at most as steep in loading as in unloading.
//! 5. Recovery from heat makes at most the work that has brought the heat.
//!
//! A recorded channel is a source of energy of its own and may act on any part.

use super::law::{Factor, LearnedLaw, Shape, Target};
use super::variable::Variable;

/// Signs of the coefficient with which a factor makes no energy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Admitted {
    /// Both.
    Both,
    /// Not above zero.
    NotPositive,
    /// Not below zero.
    NotNegative,
    /// None: the variable may not act on the part.
    None,
}

impl Admitted {
    /// Returns true if a coefficient has an admitted sign.
    pub fn takes(self, coefficient: f64) -> bool {
        match self {
            Self::Both => true,
            Self::NotPositive => coefficient <= 0.0,
            Self::NotNegative => coefficient >= 0.0,
            Self::None => false,
        }
    }
}

/// Signs of a coefficient of a variable on a part of a law with some shape. `relaxes` tells that it has Maxwell elements.
pub fn admitted(target: Target, variable: Variable, shape: &Shape, relaxes: bool) -> Admitted {
    use Variable as V;
    if target == Target::Viscous && !relaxes {
        return Admitted::Both;
    }
    if target == Target::Strength {
        return match shape {
            Shape::Own => Admitted::None,
            // The stored energy of a curve with several slopes of unloading depends on the strength.
            Shape::Curve(k) if k[..=k.len() / 2].iter().any(|x| (x - k[0]).abs() > 1e-12 * k[0]) => Admitted::None,
            _ => Admitted::Both,
        };
    }
    let is_elastic = target == Target::Elastic;
    match variable {
        V::Channel { .. } | V::ChannelSquare { .. } | V::ChannelLate { .. } => Admitted::Both,
        V::Rate { .. } | V::RateOver { .. } | V::Rest { .. } | V::Still { .. } => Admitted::None,
        // A place of the spring is one of its pieces, which have a tail.
        V::SideOver { .. } | V::Place { .. } => Admitted::None,
        V::Deformation { .. } | V::Side if is_elastic => Admitted::Both,
        V::Virgin { .. } if is_elastic => Admitted::NotNegative,
        V::Pinching { .. } if is_elastic => Admitted::NotPositive,
        V::Deformation { .. } | V::Side | V::Virgin { .. } | V::Pinching { .. } => Admitted::None,
        V::LargestOfSide | V::LargestDecayOfSide { .. } if !is_elastic => Admitted::None,
        V::LargestDecay { .. } | V::LargestDecayOfSide { .. } | V::RecentWorkSoftening { .. } => Admitted::NotNegative,
        V::Time
        | V::TimeSaturating { .. }
        | V::TimeStep { .. }
        | V::Work
        | V::WorkSaturating { .. }
        | V::RecentWork { .. }
        | V::Largest
        | V::LargestOfSide => Admitted::NotPositive,
    }
}

/// A rule that a law breaks: the option of the script that does, its place among those of its name, and the reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// Name of the option.
    pub option: &'static str,
    /// Place among the options of that name.
    pub place: usize,
    /// Reason.
    pub message: String,
}

/// Tail of a spring over its stiffest piece that counts as zero, since coefficients are written with few digits.
const ROUNDING: f64 = 1e-5;
/// Largest deformation over that of the law at which heat must pay for its recovery.
const HEAT_RANGE: f64 = 3.0;

impl LearnedLaw {
    /// The first rule that the law breaks.
    pub fn refusal(&self) -> Option<Refusal> {
        let refuse = |option, place, message: String| Some(Refusal { option, place, message });
        let lists = [
            ("-stop", &self.stops, "a level above 0 and a strength"),
            ("-maxwell", &self.maxwell, "a time above 0 and a stiffness"),
            ("-dashpot", &self.dashpots, "a power above 0 and a coefficient"),
            ("-viscous", &self.viscous, "a width above 0 and a force"),
        ];
        for (option, list, what) in lists {
            if let Some(place) = list.iter().position(|[first, weight]| *first <= 0.0 || *weight < 0.0) {
                return refuse(option, place, format!("expected {what} of at least 0: a negative one makes energy"));
            }
        }
        if self.strength < 0.0 {
            return refuse("-hysteresis", 0, "the strength is negative, which makes energy".into());
        }
        if self.strength + self.unequal < 0.0 {
            return refuse("-unequal", 0, "the strength of the positive side is negative, which makes energy".into());
        }
        if self.moving < 0.0 {
            return refuse("-moving", 0, "the stiffness is negative, which makes energy".into());
        }
        if let Some(message) = self.curve_refusal() {
            return refuse("-curve", 0, message);
        }
        for side in [1.0, -1.0] {
            let stiffest = self.pieces.iter().map(|p| p.stiffness.abs()).fold(self.spring.abs(), f64::max);
            if self.tail(side) < -ROUNDING * stiffest {
                let place = self.pieces.len().saturating_sub(1);
                let option = if self.pieces.is_empty() { "-spring" } else { "-piece" };
                return refuse(option, place, "the spring has a tail of negative stiffness".into());
            }
        }
        for (place, f) in self.factors.iter().enumerate() {
            if let Some(message) = self.factor_refusal(f) {
                return refuse("-factor", place, message);
            }
        }
        None
    }

    /// Stiffness of the spring beyond all pieces of a side, with what else holds it there.
    fn tail(&self, side: f64) -> f64 {
        let of_side = self.pieces.iter().filter(|p| p.side * side >= 0.0);
        self.spring + self.moving + of_side.map(|p| p.stiffness).sum::<f64>()
    }

    fn curve_refusal(&self) -> Option<String> {
        let Shape::Curve(knots) = &self.shape else { return None };
        let last = knots.len() - 1;
        let is_odd = knots.len() >= 3 && last.is_multiple_of(2);
        if !is_odd {
            return Some("expected an odd number of slopes, at least 3".into());
        }
        let is_positive = knots[..=last / 2].iter().all(|k| *k > 0.0) && knots.iter().all(|k| *k >= 0.0);
        if !is_positive {
            return Some("expected slopes above 0 in unloading and not below 0 in loading".into());
        }
        let makes = (0..last / 2).any(|i| knots[last - i] > knots[i]);
        makes.then(|| "loading is steeper than unloading at the same force, which makes energy".into())
    }

    fn factor_refusal(&self, f: &Factor) -> Option<String> {
        let admitted = admitted(f.target, f.variable, &self.shape, !self.maxwell.is_empty());
        if admitted == Admitted::None && f.target == Target::Strength {
            return Some("this form of the hysteretic part has no factor on its strength".into());
        }
        if admitted == Admitted::None {
            return Some(
                "a variable that changes within a cycle acts on the strength alone, or the law makes energy".into(),
            );
        }
        if !admitted.takes(f.coefficient) {
            return Some("a factor on a force that rises makes energy; on the strength it may rise".into());
        }
        if f.variable.channel().is_some_and(|c| c >= self.channels.len()) {
            return Some("there is no channel of that number".into());
        }
        let is_hot = matches!(f.variable, Variable::RecentWork { .. } | Variable::RecentWorkSoftening { .. });
        let stores = !matches!(f.target, Target::Strength | Target::Viscous);
        (is_hot && stores && !self.heat_pays(f))
            .then(|| "its recovery makes more energy than the work that has brought the heat".into())
    }

    /// Returns true if the work that heats the device is larger than the energy of its recovery.
    fn heat_pays(&self, f: &Factor) -> bool {
        let rate = match f.variable {
            Variable::RecentWorkSoftening { constant } => 4.0 * self.scales.duration / constant,
            _ => 1.0,
        };
        let u = HEAT_RANGE * self.scales.deformation;
        let pieces = self.pieces.iter().map(|p| p.stiffness.max(0.0) * (u - p.at).max(0.0).powi(2)).sum::<f64>();
        let stored = 0.5 * (self.spring.max(0.0) * u * u + pieces);
        let dissipated = self.strength / self.scales.level * self.scales.work;
        f.target == Target::Hysteretic || f.coefficient.abs() * rate * stored <= dissipated
    }
}
