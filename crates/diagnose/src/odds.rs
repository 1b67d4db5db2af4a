//! How likely each cause is, that there is none, and that it is none of the library.

use super::bootstrap::Bootstrap;
use super::evidence::{INDEPENDENT, probabilities};
use super::hypothesis;
use super::noise::power;
use super::scale::Scales;
use super::structure::{recurs, structure};
use super::work::Explained;
use hysteron_identify::study::{Role, ScoredRun, Study};

/// More structure than this part of a residual says no more than this.
const TELLING: f64 = 0.6;

/// What `unknown` costs in log evidence, over noise and over an explanation with a name: nulls leave no structure, but no
/// law of the library is the one of nature.
const STRUCTURED: f64 = 4.0;
const NAMELESS: f64 = 9.0;

/// An explanation that takes more than this part of what can be taken is the harder to doubt the more it takes.
const MUCH: f64 = 0.5;
const NAMED: f64 = 45.0;
/// So is one that has gained more than this in log evidence over none, where something else is left as well: where the effect
/// was none of the library its laws had gained 2 at most in the first batches of validation/diagnosis.
const GAINED: f64 = 4.0;
/// Of less than [`MUCH`] it has gained by bending to what is none of its own: at this part of it the gain says nothing. Two
/// such laws had gained 9 and 20 where the effect was none of the library.
const LITTLE: f64 = 0.8;

/// How often a verdict without doubt is wrong all the same, on cases made by other formulas: estimated from the trials of
/// validation/diagnosis from seed 20000 on, rounded up. The batch after them, with these doubts: of 27 answers that were given
/// 95 % all are right, of 16 that were given 80 to 90 % all but one.
const DOUBT_OF_A_NAME: f64 = 0.05;
const DOUBT_OF_NO_NAME: f64 = 0.15;
/// How much oftener a name is wrong where all that it leaves has structure, and in part where a part of it has. Of 395 names in trials
/// of validation/diagnosis 97 % were right where nothing had structure, 93 % where up to two fifths had, 92 % up to three fifths, seven of
/// nine beyond. Of the names that are given with the truth taken out of the library, and are no equivalents, half stand beside structure
/// of a third and more. It is about what both say together where the library lacks the cause in one case of five.
const DOUBT_OF_A_LAW: f64 = 0.4;
/// Log evidence by which the first cause is ahead of those that the recordings do not tell it apart from: more than the doubts of a
/// name take from it.
const AHEAD: f64 = 0.3;
/// Part in which evidence counts between causes that look alike.
const TWINS: f64 = 0.5;

/// What was weighed, as probabilities.
pub(super) struct Odds {
    /// Causes, `none` and `unknown`, the likeliest first.
    pub(super) odds: Vec<(&'static str, f64)>,
    /// Part of what the best explanation leaves that has structure, and which.
    pub(super) left: f64,
    pub(super) signature: String,
    /// Log evidence of the model as it is.
    pub(super) none: f64,
}

/// How the best explanation stands.
#[derive(Clone, Copy, Debug)]
struct Standing {
    /// Its log evidence, and that of the model as it is.
    evidence: f64,
    none: f64,
    /// It has a name.
    named: bool,
    /// Part of what it leaves that has structure.
    left: f64,
    /// Part that it has explained of what there was to explain.
    done: f64,
}

impl Standing {
    /// Log evidence that the cause is none of the library.
    fn unknown(&self) -> f64 {
        let gained = self.evidence - self.none;
        let price = if self.named {
            let counts = ((self.done / MUCH - LITTLE) / (1.0 - LITTLE)).clamp(0.0, 1.0);
            NAMELESS + NAMED * (self.done - MUCH).max(0.0) + counts * (gained - GAINED).max(0.0)
        } else {
            STRUCTURED
        };
        self.evidence.max(self.none) + structured(self.left, price)
    }
}

/// What structure that is left says for `unknown`, at a price.
fn structured(left: f64, price: f64) -> f64 {
    -0.5 * INDEPENDENT * (1.0 - left.min(TELLING)).ln() - price
}

/// Whether the model as it is leaves more structure than noise may have by chance: the answer would be `unknown`.
pub(super) fn leaves_structure(study: &Study, scales: &Scales, as_it_is: &Explained) -> bool {
    structured(structure(study, scales, &as_it_is.fitted.fits, true).0, STRUCTURED) > 0.0
}

impl Odds {
    /// Of explanations, the best first; `baseline` is the fitted model.
    pub(super) fn of(
        study: &Study,
        scales: &Scales,
        baseline: &Explained,
        weighed: &[Explained],
        bootstrap: Option<&Bootstrap>,
    ) -> Self {
        let best = &weighed[0];
        let none = weighed.iter().find(|e| e.cause() == "none");
        // The best of each cause, alone or beside a second one, speaks for it.
        let mut causes: Vec<(&'static str, f64)> = vec![];
        for e in weighed {
            if causes.iter().all(|(cause, _)| *cause != e.cause()) {
                causes.push((e.cause(), e.evidence));
            }
        }
        let named = best.cause() != "none";
        // What the best explanation has explained of what there was to explain, and what structure it leaves.
        let (mut left, mut signature) = structure(study, scales, &best.fitted.fits, !named);
        let (before, after) = (misfit(study, &none.unwrap_or(baseline).fitted.fits), misfit(study, &best.fitted.fits));
        let floor = after * (1.0 - left);
        let done = if before > floor { ((before - after) / (before - floor)).clamp(0.0, 1.0) } else { 1.0 };
        let none = none.map_or(f64::NEG_INFINITY, |e| e.evidence);
        // What the recordings show by themselves is no matter of what else is left.
        let evidence = best.evidence - best.variant.seen();
        let mut unknown = Standing { evidence, none, named, left, done }.unknown();
        // No law of another form stands behind what a form that is exact leaves along the stroke.
        if best.variant.proposal.as_ref().is_some_and(|p| p.exact) {
            let (again, says) = recurs(study, scales, &best.fitted.fits);
            let doubted = best.evidence + structured(again, STRUCTURED);
            if again > 0.0 && doubted > unknown {
                (unknown, left, signature) = (doubted, left.max(again), says);
            }
        }
        causes.push(("unknown", unknown));
        // What is seen is no less sure for what else is left.
        let beside = if best.variant.seen() > 0.0 { 0.0 } else { left };
        Self { odds: among(causes, beside, none, bootstrap), left, signature, none }
    }
}

/// Probabilities of causes with their log evidences, the likeliest first. So much is `left` with structure; `none` is the
/// evidence of the model as it is.
fn among(
    mut causes: Vec<(&'static str, f64)>,
    left: f64,
    none: f64,
    bootstrap: Option<&Bootstrap>,
) -> Vec<(&'static str, f64)> {
    causes.sort_by(|a, b| b.1.total_cmp(&a.1));
    temper(&mut causes, left, none);
    bound(&mut causes, none, bootstrap);
    let mut p = probabilities(&causes.iter().map(|c| c.1).collect::<Vec<_>>());
    doubt(&causes, &mut p);
    doubt_the_library(&causes, left, &mut p);
    let mut odds: Vec<(&'static str, f64)> = causes.iter().map(|c| c.0).zip(p).collect();
    odds.sort_by(|a, b| b.1.total_cmp(&a.1));
    odds
}

/// What the evidence says of the first cause against others with a name counts in part. Causes that look alike are told apart
/// by the forms of their laws, which nature need not have. And evidence takes what the best explanation leaves for
/// noise: as far as that has structure no law is right, and a likelihood to a power below one is the more honest one
/// (Miller and Dunson, 2019, "Robust Bayesian inference via coarsening"), against a cause that gains over `none` as the first
/// does; one that gains nothing is no rival whatever is left.
fn temper(causes: &mut [(&'static str, f64)], left: f64, none: f64) {
    let (first, most) = causes[0];
    if matches!(first, "none" | "unknown") {
        return;
    }
    for (cause, evidence) in causes.iter_mut().skip(1).filter(|(cause, _)| !matches!(*cause, "none" | "unknown")) {
        let gained = ((*evidence - none) / (most - none).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        let part = if hypothesis::alike(first, cause) { TWINS } else { 1.0 };
        *evidence = most - part * (1.0 - left * gained) * (most - *evidence);
    }
}

/// What the evidence says of the first cause against one whose own recordings would have let it gain as much counts for little.
/// The first one stays ahead of each: that is what the gain still says. What one would stand for that gains nothing over `none` itself,
/// is for `unknown`: the gain of the first tells little, and that other is not seen.
fn bound(causes: &mut [(&'static str, f64)], none: f64, bootstrap: Option<&Bootstrap>) {
    let (first, most) = causes[0];
    let Some(b) = bootstrap.filter(|b| b.cause == first && first != "none") else { return };
    let mut unseen = 0.0;
    for (cause, evidence) in causes.iter_mut().skip(1) {
        let Some(ahead) = b.bound(cause) else { continue };
        let beside = most - ahead.max(AHEAD);
        if *evidence > none || *cause == "none" {
            *evidence = evidence.max(beside);
        } else {
            unseen += (beside - most).exp();
        }
    }
    if let Some((_, unknown)) = causes.iter_mut().find(|c| c.0 == "unknown") {
        *unknown = most + ((*unknown - most).exp() + unseen).ln();
    }
}

/// What the evidence cannot know, that an effect may be too weak to be seen and that no law of the library is the one of
/// nature, is taken from the first and given to the others: half to `unknown` (to the next where it is the first), the
/// rest in equal parts to the causes that look like it.
fn doubt(causes: &[(&'static str, f64)], p: &mut [f64]) {
    let first = causes[0].0;
    let amount = p[0] * if matches!(first, "none" | "unknown") { DOUBT_OF_NO_NAME } else { DOUBT_OF_A_NAME };
    let like = hypothesis::of(first).map_or(&[][..], |h| h.like);
    let others: Vec<usize> = (1..p.len()).filter(|i| like.contains(&causes[*i].0)).collect();
    let unknown = causes.iter().skip(1).position(|c| c.0 == "unknown").map_or(1, |i| i + 1);
    if p.len() < 2 {
        return;
    }
    p[0] -= amount;
    p[unknown] += if others.is_empty() { amount } else { 0.5 * amount };
    others.iter().for_each(|i| p[*i] += 0.5 * amount / others.len() as f64);
}

/// Where what a name leaves has structure, nature's law is none of those that have one: what all names lose by that is given to
/// `unknown`.
fn doubt_the_library(causes: &[(&'static str, f64)], left: f64, p: &mut [f64]) {
    let named = |cause: &str| !matches!(cause, "none" | "unknown");
    let Some(unknown) = causes.iter().position(|c| c.0 == "unknown").filter(|_| named(causes[0].0)) else { return };
    for i in (0..p.len()).filter(|i| named(causes[*i].0)) {
        let amount = DOUBT_OF_A_LAW * left * p[i];
        p[i] -= amount;
        p[unknown] += amount;
    }
}

/// Sum of the NMSE of all fitted channels.
fn misfit(study: &Study, fits: &[ScoredRun]) -> f64 {
    let runs = study.runs.iter().filter(|r| r.role == Role::Fit);
    let channels = runs.zip(fits).flat_map(|(r, f)| r.observe.iter().zip(&f.channels));
    channels
        .map(|(o, y)| {
            let r: Vec<f64> = y.iter().zip(&o.values).map(|(y, v)| y - v).filter(|d| d.is_finite()).collect();
            power(&r) / o.variance
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::{Standing, among};
    use crate::bootstrap::{Bootstrap, Share};

    /// How likely `unknown` is beside a named cause that has gained so much.
    fn unknown(gained: f64, left: f64, done: f64) -> f64 {
        let s = Standing { evidence: gained, none: 0.0, named: true, left, done };
        let odds = among(vec![("damping", gained), ("none", 0.0), ("unknown", s.unknown())], left, 0.0, None);
        assert!((odds.iter().map(|o| o.1).sum::<f64>() - 1.0).abs() < 1e-12);
        odds.iter().find(|o| o.0 == "unknown").map_or(0.0, |o| o.1)
    }

    /// The doubts that a name without structure beside it keeps are those of the library.
    #[test]
    fn a_name_that_leaves_noise_stands() {
        for done in [0.3, 0.6, 1.0] {
            assert!(unknown(20.0, 0.0, done) < 0.1);
        }
    }

    /// As structure grows beside a name that has done little, the name goes.
    #[test]
    fn a_name_that_leaves_most_of_the_structure_falls() {
        assert!(unknown(20.0, 0.9, 0.35) > 0.8);
        assert!(unknown(8.0, 0.6, 0.1) > 0.8);
        assert!((0.35..0.45).contains(&unknown(20.0, 0.9, 0.9)));
        let rising: Vec<f64> = (0..8).map(|k| unknown(10.0, 0.1 * f64::from(k), 0.3)).collect();
        assert!(rising.windows(2).all(|w| w[1] >= w[0]), "{rising:?}");
        let falling: Vec<f64> = (0..10).map(|k| unknown(10.0, 0.7, 0.1 * f64::from(k))).collect();
        assert!(falling.windows(2).all(|w| w[1] <= w[0]), "{falling:?}");
    }

    /// The more structure is left, the less sure is a name, and the order of names stays.
    #[test]
    fn a_name_beside_structure_is_less_sure() {
        let sure = |left| {
            let odds =
                among(vec![("damping", 30.0), ("torsion", 29.0), ("none", 0.0), ("unknown", -9.0)], left, 0.0, None);
            let names: Vec<&str> = odds.iter().map(|o| o.0).filter(|c| *c != "unknown").collect();
            assert_eq!(names, ["damping", "torsion", "none"]);
            assert!((odds.iter().map(|o| o.1).sum::<f64>() - 1.0).abs() < 1e-12);
            odds.iter().filter(|o| matches!(o.0, "damping" | "torsion")).map(|o| o.1).sum::<f64>()
        };
        assert!(sure(0.0) > 0.94 && (0.58..0.64).contains(&sure(0.9)), "{} {}", sure(0.0), sure(0.9));
    }

    /// What would have gained as much had another cause been true is hardly likelier than that one, but stays ahead; the others
    /// are as far behind as before.
    #[test]
    fn what_recordings_do_not_tell_apart_stands_side_by_side() {
        let causes =
            || vec![("friction", 30.0), ("damping", 10.0), ("gap_impact", 10.0), ("none", 0.0), ("unknown", 2.0)];
        let of = |odds: &[(&'static str, f64)], cause: &str| odds.iter().find(|o| o.0 == cause).map_or(0.0, |o| o.1);
        let sure = among(causes(), 0.0, 0.0, None);
        let share = Share { cause: "damping", share: 0.6, against: 0.0 };
        let b = Bootstrap {
            cause: "friction",
            recordings: 199,
            chance: Some(0.005),
            found: 0.5,
            not_told_apart: vec![share],
        };
        let beside = among(causes(), 0.0, 0.0, Some(&b));
        assert!(of(&sure, "damping") < 0.05 && of(&beside, "damping") > 0.35, "{beside:?}");
        assert_eq!(beside[0].0, "friction");
        assert!(of(&beside, "gap_impact") < 0.01 && of(&beside, "none") < 0.01);
        // The same of recordings of another first cause says nothing.
        assert_eq!(among(causes(), 0.0, 0.0, Some(&Bootstrap { cause: "torsion", ..b })), sure);
    }

    /// Causes that gain nothing do not stand beside one that they are not told apart from: it is not known then.
    #[test]
    fn what_gains_nothing_is_no_rival_but_a_doubt() {
        let of = |evidence| {
            let rivals = ["damping", "torsion", "sensor_lag"];
            let share = |cause| Share { cause, share: 0.6, against: 0.0 };
            let b = Bootstrap {
                cause: "friction",
                recordings: 199,
                chance: Some(0.005),
                found: 0.5,
                not_told_apart: rivals.map(share).into(),
            };
            let mut causes = vec![("friction", 4.0), ("none", 0.0), ("unknown", -4.0)];
            causes.extend(rivals.map(|cause| (cause, evidence)));
            let odds = among(causes, 0.0, 0.0, Some(&b));
            assert!((odds.iter().map(|o| o.1).sum::<f64>() - 1.0).abs() < 1e-12);
            odds[0].0
        };
        assert_eq!((of(1.0), of(-1.0)), ("friction", "unknown"));
    }

    /// A gain that chance would give does not make a cause sure.
    #[test]
    fn what_may_be_chance_stands_beside_nothing_missing() {
        let b = Bootstrap { cause: "friction", recordings: 199, chance: Some(0.3), found: 0.5, not_told_apart: vec![] };
        let odds = among(vec![("friction", 8.0), ("none", 0.0), ("unknown", -4.0)], 0.0, 0.0, Some(&b));
        let none = odds.iter().find(|o| o.0 == "none").map_or(0.0, |o| o.1);
        assert!(odds[0].0 == "friction" && none > 0.3, "{odds:?}");
    }

    /// Nothing named: structure alone decides between noise and an unknown cause.
    #[test]
    fn structure_that_nobody_explains_is_unknown() {
        let none = |left| {
            let s = Standing { evidence: 0.0, none: 0.0, named: false, left, done: 0.0 };
            among(vec![("none", 0.0), ("unknown", s.unknown())], left, 0.0, None)[0].0
        };
        assert_eq!(none(0.0), "none");
        assert_eq!(none(0.6), "unknown");
    }
}
