//! What the weighing would say of recordings of which the truth is known: those that an explanation makes, with the noise that
//! the best one leaves.
//!
//! Whether a gain may be chance, and whether another cause would have let this one gain as much, depends on the motion, the
//! channels, the noise and the library of the study at hand. It is seen on recordings made by each explanation in turn, with noise of
//! the spectrum of what the best one leaves (a parametric bootstrap, as Williams, J. R. Stat. Soc. B 32 (1970), proposed it for
//! hypotheses none of which contains the other). On each of them all explanations are fitted again and weighed. Near their fits they
//! are taken for linear in their parameters, so that this takes no analysis beyond the derivatives. What is weighed is what a
//! fit leaves, on the real recording too, and not what it predicts of blocks held back: without those, what they determine moves
//! farther than derivatives are good for.

use crate::evidence::likelihood::{Noise, POINTS, Residuals, priced};
use crate::fit::evaluator::damped_step;
use crate::residual::noise::averaged;
use crate::residual::surrogates::Surrogates;
use nalgebra::{DMatrix, DVector};
use serde::Serialize;

/// Recordings that each explanation makes.
const RECORDINGS: usize = 199;
/// An explanation whose recordings let another one gain so much in no more than this part of them is refuted by the gain.
const REFUTED: f64 = 0.05;
/// Parameters follow at most by this part of their range: as far as derivatives may be trusted.
const FAR: f64 = 0.4;

/// An explanation near its fit, averaged as it is weighed.
#[derive(Clone)]
pub(crate) struct Near {
    /// What it leaves, channel after channel.
    residual: DVector<f64>,
    /// Derivatives of that by its coordinates.
    derivatives: DMatrix<f64>,
    /// Points of each channel.
    channels: Vec<usize>,
}

impl Near {
    /// From weighted residuals of samples and their derivatives, channel after channel with so many samples each.
    pub(crate) fn new(residual: &[f64], derivatives: &DMatrix<f64>, samples: &[usize]) -> Self {
        let mut channels = vec![];
        let mut fewer = |x: &[f64]| -> Vec<f64> {
            let mut rest = x;
            let parts: Vec<Vec<f64>> = samples
                .iter()
                .map(|n| {
                    let (own, after) = rest.split_at(*n);
                    rest = after;
                    averaged(own, POINTS)
                })
                .collect();
            channels = parts.iter().map(Vec::len).collect();
            parts.concat()
        };
        let columns: Vec<Vec<f64>> = derivatives.column_iter().map(|c| fewer(c.as_slice())).collect();
        let residual = DVector::from_vec(fewer(residual));
        let derivatives = DMatrix::from_fn(residual.len(), columns.len(), |i, k| columns[k][i]);
        Self { residual, derivatives, channels }
    }

    fn by_channel(&self, x: &DVector<f64>) -> Residuals {
        let mut rest = x.as_slice();
        let own = |n: &usize| {
            let (own, after) = rest.split_at(*n);
            rest = after;
            own.to_vec()
        };
        self.channels.iter().map(own).collect()
    }
}

/// An explanation that takes part.
pub(crate) struct Rival {
    /// Its cause.
    pub(crate) cause: &'static str,
    /// Log odds before anything is seen.
    pub(crate) before: f64,
    /// The point of the unit cube where it stands.
    pub(crate) point: Vec<f64>,
    /// What it is there.
    pub(crate) near: Near,
}

/// What came of it for the cause with the most evidence.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bootstrap {
    /// The cause.
    pub cause: &'static str,
    /// Recordings that each explanation made.
    pub recordings: usize,
    /// Part of the recordings of the model as it is in which some cause gains as much; none where that is the cause.
    pub chance: Option<f64>,
    /// Part of its own recordings in which it has the most evidence.
    pub found: f64,
    /// Other causes that a cause with a name is not told apart from: part of their recordings in which it gains as much over them.
    pub not_told_apart: Vec<Share>,
}

/// A part of the recordings of a cause.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Share {
    /// The cause.
    pub cause: &'static str,
    /// The part, between 0 and 1.
    pub share: f64,
    /// Log odds against it before anything was seen: no gain.
    #[serde(skip)]
    pub against: f64,
}

impl Bootstrap {
    /// What the evidence of the cause over another one may count for, where it would have been as much had the other one been
    /// true: at most the factor 1/(-e p ln p) for a share p (Sellke, Bayarri and Berger, The American Statistician 55 (2001)), as
    /// its logarithm; what speaks against it beforehand stands.
    pub(crate) fn bound(&self, other: &str) -> Option<f64> {
        let of_none = self.chance.filter(|p| *p > REFUTED && other == "none").map(|p| (p, 0.0));
        let of_other = || self.not_told_apart.iter().find(|s| s.cause == other).map(|s| (s.share, s.against));
        let (p, against) = of_none.or_else(of_other)?;
        Some(against + if p < (-1.0f64).exp() { -(-p * p.ln()).ln() - 1.0 } else { 0.0 })
    }

    /// In words, for the verdict.
    pub(crate) fn says(&self) -> String {
        let Some(chance) = self.chance else { return String::new() };
        let mut text = if chance * (self.recordings + 1) as f64 <= 1.5 {
            format!(" In none of {} recordings", self.recordings)
        } else {
            format!(" In {} of the recordings", part(chance))
        };
        text += " that the model as it is would make with this noise any cause gains as much.";
        for s in &self.not_told_apart {
            text += &format!(
                " Were it {}, {} would gain as much in {} of the recordings: this one does not tell them apart.",
                s.cause,
                self.cause,
                part(s.share)
            );
        }
        text
    }
}

/// A part in words.
pub(crate) fn part(p: f64) -> String {
    format!("{:.1} %", 100.0 * p)
}

/// What is worked out once for an explanation.
struct Prepared<'a> {
    rival: &'a Rival,
    normal: DMatrix<f64>,
}

impl<'a> Prepared<'a> {
    fn new(rival: &'a Rival) -> Self {
        let j = &rival.near.derivatives;
        Self { rival, normal: j.tr_mul(j) }
    }

    /// What it leaves of a recording that it is fitted to, of which it leaves a residual where it stands.
    fn fitted(&self, residual: &DVector<f64>) -> Option<DVector<f64>> {
        let j = &self.rival.near.derivatives;
        let square = residual.norm_squared();
        let step = damped_step(self.normal.clone(), &j.tr_mul(residual), square)?;
        // It stays in the cube.
        let within = DVector::from_fn(step.len(), |i, _| {
            let p = self.rival.point[i];
            (p + step[i].clamp(-FAR, FAR)).clamp(0.0, 1.0) - p
        });
        let after = residual + j * within;
        Some(if after.norm_squared() < square { after } else { residual.clone() })
    }
}

/// Log evidence of all explanations on a recording, of which each leaves a residual where it stands.
fn weighed(all: &[Prepared<'_>], residuals: &[DVector<f64>]) -> Option<Vec<f64>> {
    let left: Vec<DVector<f64>> = all.iter().zip(residuals).map(|(p, r)| p.fitted(r)).collect::<Option<_>>()?;
    let parameters = |p: &Prepared<'_>| p.rival.point.len();
    let price =
        |(p, r): &(&Prepared<'_>, &DVector<f64>)| priced(r.norm_squared().max(f64::MIN_POSITIVE), parameters(p), 0.0);
    let (best, of_best) = all.iter().zip(&left).min_by(|a, b| price(a).total_cmp(&price(b)))?;
    let noise = Noise::of(&best.rival.near.by_channel(of_best));
    let evidence = |(p, r): (&Prepared<'_>, &DVector<f64>)| {
        p.rival.before + noise.evidence(&best.rival.near.by_channel(r), parameters(p))
    };
    Some(all.iter().zip(&left).map(evidence).collect())
}

/// The most evidence among the explanations by a cause.
fn most(all: &[Prepared<'_>], evidence: &[f64], of: impl Fn(&str) -> bool) -> f64 {
    let own = all.iter().zip(evidence).filter(|(p, _)| of(p.rival.cause)).map(|(_, e)| *e);
    own.fold(f64::NEG_INFINITY, f64::max)
}

/// Explanations with what they come to on the real recording.
struct Made<'a> {
    all: Vec<Prepared<'a>>,
    /// What each leaves of it.
    seen: Vec<DVector<f64>>,
    evidence: Vec<f64>,
    /// What the best one leaves, channel after channel.
    noise: Residuals,
    /// The cause of the best one.
    cause: &'static str,
}

impl Made<'_> {
    /// By how much the best of some causes is ahead of one.
    fn ahead(&self, evidence: &[f64], of: impl Fn(&str) -> bool, over: &str) -> f64 {
        most(&self.all, evidence, of) - most(&self.all, evidence, |c| c == over)
    }

    /// Whether on a recording made by `truth` the cause is found where that is it, or gains over `truth` as it does on the real one;
    /// over `none` any cause.
    fn counts(&self, truth: &str, evidence: &[f64]) -> bool {
        let gains =
            |of: &dyn Fn(&str) -> bool| self.ahead(evidence, of, truth) >= self.ahead(&self.evidence, of, truth);
        match truth {
            _ if truth == self.cause => {
                most(&self.all, evidence, |c| c == truth) >= most(&self.all, evidence, |_| true)
            }
            "none" => gains(&|c| c != "none"),
            _ => gains(&|c| c == self.cause),
        }
    }

    /// The explanation of a cause with the most evidence.
    fn best_of(&self, cause: &str) -> Option<usize> {
        let forms = (0..self.all.len()).filter(|i| self.all[*i].rival.cause == cause);
        forms.max_by(|a, b| self.evidence[*a].total_cmp(&self.evidence[*b]))
    }

    /// In how many recordings made by the best explanation of a cause it counts.
    fn count(&self, truth: &str) -> Option<usize> {
        let maker = &self.seen[self.best_of(truth)?];
        let mut noise: Vec<Surrogates> = self.noise.iter().zip(1..).map(|(x, k)| Surrogates::seeded(x, k)).collect();
        let mut count = 0;
        for _ in 0..RECORDINGS {
            let noise = DVector::from_vec(noise.iter_mut().flat_map(Surrogates::draw).collect());
            let residuals: Vec<DVector<f64>> = self.seen.iter().map(|r| r - maker + &noise).collect();
            count += usize::from(self.counts(truth, &weighed(&self.all, &residuals)?));
        }
        Some(count)
    }
}

/// Recordings by the explanation of each cause with the most evidence; the first of all is the one with the most of all, and leaves
/// the noise. Explanations that answered for other samples are left out.
pub(crate) fn bootstrap(rivals: &[Rival]) -> Option<Bootstrap> {
    let first = rivals.first()?;
    let comparable = |r: &&Rival| r.near.channels == first.near.channels;
    let all: Vec<Prepared<'_>> = rivals.iter().filter(comparable).map(Prepared::new).collect();
    let seen: Vec<DVector<f64>> = all.iter().map(|p| p.rival.near.residual.clone()).collect();
    let evidence = weighed(&all, &seen)?;
    let noise = first.near.by_channel(&first.near.residual);
    let mut causes: Vec<&'static str> = vec![];
    for p in &all {
        if !causes.contains(&p.rival.cause) {
            causes.push(p.rival.cause);
        }
    }
    let cause = first.cause;
    let made = Made { all, seen, evidence, noise, cause };
    let mut out = Bootstrap { cause, recordings: RECORDINGS, chance: None, found: 0.0, not_told_apart: vec![] };
    for truth in causes {
        let count = made.count(truth)?;
        let share = (1 + count) as f64 / (1 + RECORDINGS) as f64;
        match truth {
            _ if truth == cause => out.found = count as f64 / RECORDINGS as f64,
            "none" => out.chance = Some(share),
            _ if cause != "none" && share > REFUTED => {
                let against = first.before - made.all[made.best_of(truth)?].rival.before;
                out.not_told_apart.push(Share { cause: truth, share, against });
            }
            _ => {}
        }
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::{Bootstrap, Near, Rival, bootstrap};
    use crate::residual::noise::tests::noise;
    use nalgebra::DMatrix;

    /// An explanation that can add any multiple of a shape to a recording, fitted to it.
    fn rival(cause: &'static str, recorded: &[f64], shapes: &[&[f64]]) -> Rival {
        let n = recorded.len();
        let j = DMatrix::from_fn(n, shapes.len(), |t, k| shapes[k][t]);
        let b = nalgebra::DVector::from_column_slice(recorded);
        let left = match (j.tr_mul(&j)).cholesky() {
            Some(normal) if !shapes.is_empty() => &b - &j * normal.solve(&j.tr_mul(&b)),
            _ => b,
        };
        let before = if cause == "none" { 3.0 } else { 0.0 };
        Rival { cause, before, point: vec![0.5; shapes.len()], near: Near::new(left.as_slice(), &j, &[n]) }
    }

    /// Of recordings with an effect of one shape and a size; another shape is nearly the same in a part.
    fn of(size: f64, alike: f64) -> Option<Bootstrap> {
        let n = 300;
        let at = |k: f64| (0..n).map(|t| (k * f64::from(t)).sin()).collect::<Vec<f64>>();
        let (own, apart) = (at(0.11), at(0.173));
        let other: Vec<f64> = own.iter().zip(&apart).map(|(a, b)| alike * a + (1.0 - alike) * b).collect();
        let recorded: Vec<f64> = noise(7, n as usize).iter().zip(&own).map(|(x, s)| x + size * s).collect();
        let rivals = [("friction", vec![&own[..]]), ("damping", vec![&other]), ("none", vec![])];
        let rivals: Vec<Rival> = rivals.iter().map(|(cause, shapes)| rival(cause, &recorded, shapes)).collect();
        bootstrap(&rivals)
    }

    #[test]
    fn what_is_far_above_the_noise_is_no_chance() {
        let b = of(2.0, 0.2).expect("an answer");
        assert_eq!(b.chance, Some(1.0 / 200.0));
        assert!(b.found > 0.99 && b.not_told_apart.is_empty(), "{b:?}");
        assert!(b.bound("damping").is_none() && b.bound("none").is_none());
        assert!(b.says().contains("none of 199"));
    }

    #[test]
    fn what_is_within_the_noise_may_be_chance() {
        let b = of(0.02, 0.2).expect("an answer");
        assert!(b.chance.is_some_and(|p| p > 0.05), "{b:?}");
        assert!(b.bound("none").is_some_and(|ahead| ahead < 1.0));
    }

    #[test]
    fn shapes_that_are_nearly_the_same_are_not_told_apart() {
        let b = of(2.0, 0.995).expect("an answer");
        assert_eq!(b.not_told_apart.iter().map(|s| s.cause).collect::<Vec<_>>(), ["damping"]);
        assert!(b.bound("damping").is_some_and(|ahead| ahead < 1.5), "{b:?}");
        // The same every time.
        assert_eq!(of(2.0, 0.995), Some(b));
    }
}
