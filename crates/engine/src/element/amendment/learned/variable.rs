//! Slow variables: quantities of the past on which a factor depends. They are of the order of one.

use super::history::{History, Scales};
use super::operators::{low_pass, rest};

/// Slip of a step over its length below which a contact is at rest.
const REST_SLIP: f64 = 1e-4;
/// Speed over V below which a device stands still.
const STILL_SPEED: f64 = 1e-3;

/// A slow variable. In the formulas, m is the largest deformation over U, x a channel less its mean over three standard
/// deviations, and D the work over that of the scales.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Variable {
    /// (|u|/U)^p.
    Deformation {
        /// Exponent p, at least 1.
        power: f64,
    },
    /// u/U.
    Side,
    /// sgn u times the sense of the deformation filtered with a time constant: the share of late that this side has had over
    /// that of the other one.
    SideOver {
        /// Time constant.
        constant: f64,
    },
    /// exp(-((u/U - p)/w)²).
    Place {
        /// Middle p over U.
        place: f64,
        /// Width w over U.
        width: f64,
    },
    /// t/T.
    Time,
    /// 1 - exp(-t/τ).
    TimeSaturating {
        /// Time τ.
        constant: f64,
    },
    /// A step at a time, smoothed over T/20.
    TimeStep {
        /// Time of its middle.
        at: f64,
    },
    /// D.
    Work,
    /// 1 - exp(-D/e).
    WorkSaturating {
        /// Work e.
        constant: f64,
    },
    /// Work L that leaks away with a time constant.
    RecentWork {
        /// Time constant τ.
        constant: f64,
    },
    /// 1/(1 + 4 L T/τ).
    RecentWorkSoftening {
        /// Time constant τ.
        constant: f64,
    },
    /// m.
    Largest,
    /// m of the side on which the device is.
    LargestOfSide,
    /// exp(-m/e).
    LargestDecay {
        /// Deformation e over U.
        constant: f64,
    },
    /// exp(-m/e) of the side on which the device is.
    LargestDecayOfSide {
        /// Deformation e over U.
        constant: f64,
    },
    /// (|u|/U/m)^p, at most one.
    Virgin {
        /// Exponent p, at least 1.
        power: f64,
    },
    /// exp(-(|u|/U/(e m))²).
    Pinching {
        /// Width e.
        width: f64,
    },
    /// ln(1 + |v|/(e V)) / ln(1 + 1/e).
    Rate {
        /// Speed e over V.
        reference: f64,
    },
    /// The same of a speed filtered with a time constant.
    RateOver {
        /// Speed e over V.
        reference: f64,
        /// Time constant.
        constant: f64,
    },
    /// A quarter of ln(1 + t/t₀) with the time t without slip, worn off by slip over a length.
    Rest {
        /// Length of slip.
        length: f64,
        /// Time t₀.
        time: f64,
    },
    /// The same with the time at which the device stands still. A contact that sticks while the device turns does not age.
    Still {
        /// Length of slip.
        length: f64,
        /// Time t₀.
        time: f64,
    },
    /// x.
    Channel {
        /// Number of the channel, from 0.
        channel: usize,
    },
    /// x².
    ChannelSquare {
        /// Number of the channel, from 0.
        channel: usize,
    },
    /// x filtered with a time constant.
    ChannelLate {
        /// Number of the channel, from 0.
        channel: usize,
        /// Time constant.
        constant: f64,
    },
}

/// Quantities of a moment, beside the history up to it.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a> {
    /// Deformation.
    pub deformation: f64,
    /// Channels, each less its mean over three standard deviations.
    pub channels: &'a [f64],
}

fn at(channels: &[f64], i: usize) -> f64 {
    channels.get(i).copied().unwrap_or(0.0)
}

/// Sense of a deformation: 1, -1, or 0 at the origin.
fn sense(deformation: f64) -> f64 {
    if deformation == 0.0 { 0.0 } else { deformation.signum() }
}

impl Variable {
    /// Returns true if it depends on the slip level of the law.
    pub fn depends_on_level(self) -> bool {
        matches!(
            self,
            Self::Work
                | Self::WorkSaturating { .. }
                | Self::RecentWork { .. }
                | Self::RecentWorkSoftening { .. }
                | Self::Rest { .. }
                | Self::Still { .. }
        )
    }

    /// The same with each of its constants times a ratio, one at a time. Exponents stay, and a place moves by its width.
    pub fn with_constants_times(self, ratio: f64) -> Vec<Self> {
        let r = ratio;
        match self {
            Self::TimeSaturating { constant } => vec![Self::TimeSaturating { constant: r * constant }],
            Self::TimeStep { at } => vec![Self::TimeStep { at: r * at }],
            Self::WorkSaturating { constant } => vec![Self::WorkSaturating { constant: r * constant }],
            Self::RecentWork { constant } => vec![Self::RecentWork { constant: r * constant }],
            Self::RecentWorkSoftening { constant } => vec![Self::RecentWorkSoftening { constant: r * constant }],
            Self::LargestDecay { constant } => vec![Self::LargestDecay { constant: r * constant }],
            Self::LargestDecayOfSide { constant } => vec![Self::LargestDecayOfSide { constant: r * constant }],
            Self::Pinching { width } => vec![Self::Pinching { width: r * width }],
            Self::Rate { reference } => vec![Self::Rate { reference: r * reference }],
            Self::RateOver { reference, constant } => vec![
                Self::RateOver { reference: r * reference, constant },
                Self::RateOver { reference, constant: r * constant },
            ],
            Self::Rest { length, time } => {
                vec![Self::Rest { length: r * length, time }, Self::Rest { length, time: r * time }]
            }
            Self::Still { length, time } => {
                vec![Self::Still { length: r * length, time }, Self::Still { length, time: r * time }]
            }
            Self::SideOver { constant } => vec![Self::SideOver { constant: r * constant }],
            Self::Place { place, width } => {
                vec![Self::Place { place: place + width * r.ln(), width }, Self::Place { place, width: r * width }]
            }
            Self::ChannelLate { channel, constant } => vec![Self::ChannelLate { channel, constant: r * constant }],
            Self::Deformation { .. }
            | Self::Side
            | Self::Time
            | Self::Work
            | Self::Largest
            | Self::LargestOfSide
            | Self::Virgin { .. }
            | Self::Channel { .. }
            | Self::ChannelSquare { .. } => vec![],
        }
    }

    /// Number of the channel that it follows.
    pub fn channel(self) -> Option<usize> {
        match self {
            Self::Channel { channel } | Self::ChannelSquare { channel } | Self::ChannelLate { channel, .. } => {
                Some(channel)
            }
            _ => None,
        }
    }

    /// Its own state variable after a step.
    pub fn next(self, slot: f64, scales: &Scales, from: &History, to: &History, channels: &[f64]) -> f64 {
        let dt = to.time - from.time;
        let slip = || (to.work - from.work) / scales.level;
        match self {
            Self::RecentWork { constant } | Self::RecentWorkSoftening { constant } => {
                (-dt / constant).exp() * slot + (to.work - from.work) / scales.work
            }
            Self::RateOver { constant, .. } => low_pass(slot, to.speed.abs() / scales.speed, dt, constant),
            Self::SideOver { constant } => low_pass(slot, sense(to.deformation), dt, constant),
            Self::Rest { length, time } => rest(slot, slip() < REST_SLIP * length, slip(), dt, length, time),
            Self::Still { length, time } => {
                rest(slot, to.speed.abs() < STILL_SPEED * scales.speed, slip(), dt, length, time)
            }
            Self::ChannelLate { channel, constant } => {
                let x = at(channels, channel);
                if from.steps > 0.0 { low_pass(slot, x, dt, constant) } else { x }
            }
            _ => slot,
        }
    }

    /// Value from a history, and its derivative with respect to the deformation of the moment.
    pub fn value(self, slot: f64, s: &Scales, h: &History, now: &Moment<'_>) -> (f64, f64) {
        let x = now.deformation.abs() / s.deformation;
        let sign = 1f64.copysign(now.deformation) / s.deformation;
        let rate = |v: f64, e: f64| (v / e).ln_1p() / (1.0 / e).ln_1p();
        let of_side = || h.largest[usize::from(now.deformation <= 0.0)] / s.deformation;
        let value = match self {
            Self::Deformation { power } => return (x.powf(power), power * x.powf(power - 1.0) * sign),
            Self::Side => return (now.deformation / s.deformation, 1.0 / s.deformation),
            Self::Place { place, width } => {
                let y = (now.deformation / s.deformation - place) / width;
                let value = (-y * y).exp();
                return (value, -2.0 * y * value / (width * s.deformation));
            }
            Self::Virgin { power } => {
                let m = h.largest_of_both(s);
                let y = x / m;
                if y >= 1.0 {
                    return (1.0, 0.0);
                }
                return (y.powf(power), power * y.powf(power - 1.0) * sign / m);
            }
            Self::Pinching { width } => {
                let y = x / (width * h.largest_of_both(s));
                let value = (-y * y).exp();
                return (value, -2.0 * y * value * sign / (width * h.largest_of_both(s)));
            }
            Self::Time => h.time / s.duration,
            Self::TimeSaturating { constant } => 1.0 - (-h.time / constant).exp(),
            Self::TimeStep { at } => 1.0 / (1.0 + ((at - h.time) / (0.05 * s.duration)).exp()),
            Self::Work => h.work / s.work,
            Self::WorkSaturating { constant } => 1.0 - (-h.work / s.work / constant).exp(),
            Self::RecentWork { .. } => slot,
            Self::SideOver { .. } => slot * sense(now.deformation),
            Self::RecentWorkSoftening { constant } => 1.0 / (1.0 + 4.0 * slot * s.duration / constant),
            Self::Largest => h.largest_of_both(s),
            Self::LargestOfSide => of_side(),
            Self::LargestDecay { constant } => (-h.largest_of_both(s) / constant).exp(),
            Self::LargestDecayOfSide { constant } => (-of_side() / constant).exp(),
            Self::Rate { reference } => rate(h.speed.abs() / s.speed, reference),
            Self::RateOver { reference, .. } => rate(slot, reference),
            Self::Rest { .. } | Self::Still { .. } => 0.25 * slot,
            Self::Channel { channel } => at(now.channels, channel),
            Self::ChannelSquare { channel } => at(now.channels, channel).powi(2),
            Self::ChannelLate { channel, .. } => {
                if h.steps > 0.0 {
                    slot
                } else {
                    at(now.channels, channel)
                }
            }
        };
        (value, 0.0)
    }
}
