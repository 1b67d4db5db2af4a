//! Spectra over periods, and levels of strength, reduction or ductility.

use super::law::{LawMaker, LawText};
use crate::motion::{G, Motion};
use crate::spectrum::{Oscillator, median};
use hysteron_engine::analysis::InelasticOscillator;
use hysteron_identify::report::{Cell, Table};
use hysteron_identify::study::WorkerPool;

/// A level of an inelastic spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Level {
    /// Yield strength as a part of the weight.
    Strength(f64),
    /// Elastic force over yield strength.
    Reduction(f64),
    /// Largest displacement over yield displacement.
    Ductility(f64),
}

impl Level {
    fn name(self) -> (&'static str, f64) {
        match self {
            Self::Strength(x) => ("strength", x),
            Self::Reduction(x) => ("reduction", x),
            Self::Ductility(x) => ("ductility", x),
        }
    }
}

/// Response of an oscillator at a level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InelasticPoint {
    /// Number of the motion, from 0.
    pub motion: usize,
    /// Period in s.
    pub period: f64,
    /// Level.
    pub level: Level,
    /// Largest elastic displacement in m.
    pub elastic: f64,
    /// Yield strength as a part of the weight.
    pub strength: f64,
    /// Elastic force over yield strength.
    pub reduction: f64,
    /// Largest displacement in m.
    pub displacement: f64,
    /// Largest displacement over yield displacement.
    pub ductility: f64,
}

/// Inelastic spectra of motions.
#[derive(Clone, Debug)]
pub struct InelasticSpectra {
    /// Names of the motions.
    pub motions: Vec<String>,
    /// Points by motion, period and level; none where a ductility is not reached.
    pub points: Vec<InelasticPoint>,
    /// Number of analyses.
    pub analyses: usize,
}

/// Ratio of the strengths among which one for a ductility is sought, from the elastic force down.
const RATIO: f64 = 1.05;
/// The largest reduction that is tried.
const LARGEST_REDUCTION: f64 = 100.0;
/// A ductility is met to this part.
const MET: f64 = 1e-3;
/// Halves of the interval at most: steps of a law may leave no strength with just that ductility.
const HALVES: usize = 24;

/// An oscillator under a motion.
struct Case<'a> {
    motion: &'a Motion,
    number: usize,
    oscillator: Oscillator,
    elastic: f64,
    maker: LawMaker<'a>,
    analyses: usize,
}

impl Case<'_> {
    /// The response where the elastic force is a number of times the yield strength.
    fn at(&mut self, level: Level, reduction: f64) -> Result<InelasticPoint, String> {
        let stiffness = self.oscillator.omega().powi(2);
        let yield_force = stiffness * self.elastic / reduction;
        let Oscillator { period, damping } = self.oscillator;
        let law = self.maker.law(yield_force, stiffness)?;
        self.analyses += 1;
        let displacement = InelasticOscillator { period, damping, law }
            .largest_displacement(self.motion.dt, &self.motion.acceleration)
            .map_err(|e| format!("{}, period {period} s, reduction {reduction:.4}: {e}", self.motion.name))?;
        Ok(InelasticPoint {
            motion: self.number,
            period,
            level,
            elastic: self.elastic,
            strength: yield_force / G,
            reduction,
            displacement,
            ductility: displacement * reduction / self.elastic,
        })
    }

    /// Points at all levels; those of ductility at the largest strength that has it (Chopra, section 7.5.3).
    fn points(&mut self, levels: &[Level]) -> Result<Vec<InelasticPoint>, String> {
        let mut out = vec![];
        let mut ductilities = vec![];
        for &level in levels {
            match level {
                Level::Strength(c) => {
                    let reduction = self.oscillator.omega().powi(2) * self.elastic / (c * G);
                    out.push(self.at(level, reduction)?);
                }
                Level::Reduction(r) => out.push(self.at(level, r)?),
                Level::Ductility(_) => ductilities.push(level),
            }
        }
        ductilities.sort_by(|a, b| a.name().1.total_cmp(&b.name().1));
        let mut wanted = ductilities.into_iter().peekable();
        let mut reduction = 1.0;
        while let Some(level) = wanted.peek().copied() {
            if reduction > LARGEST_REDUCTION {
                break;
            }
            let point = self.at(level, reduction)?;
            if point.ductility < level.name().1 {
                reduction *= RATIO;
                continue;
            }
            out.push(self.between(level, reduction)?);
            wanted.next();
        }
        Ok(out)
    }

    /// The point of a ductility that is reached at a reduction and not one ratio before it.
    fn between(&mut self, level: Level, reached: f64) -> Result<InelasticPoint, String> {
        let aim = level.name().1;
        let (mut low, mut high) = ((reached / RATIO).max(1.0), reached);
        let mut point = self.at(level, reached)?;
        for _ in 0..HALVES {
            if (point.ductility / aim - 1.0).abs() <= MET || high <= low {
                break;
            }
            let middle = 0.5 * (low + high);
            point = self.at(level, middle)?;
            if point.ductility < aim {
                low = middle;
            } else {
                high = middle;
            }
        }
        Ok(point)
    }
}

impl InelasticSpectra {
    /// Spectra of motions for a damping, a share of the critical one, on a number of threads. `done` is called once for each
    /// period of each motion.
    ///
    /// # Errors
    /// A level or a period is out of its range, or a law has no response.
    pub fn new(
        motions: &[Motion],
        law: &LawText,
        (damping, periods, levels): (f64, &[f64], &[Level]),
        threads: usize,
        done: &(dyn Fn() + Sync),
    ) -> Result<Self, String> {
        for level in levels {
            let (name, x) = level.name();
            let least = if matches!(level, Level::Ductility(_)) { 1.0 } else { 0.0 };
            if !(x > least && x.is_finite()) {
                return Err(format!("a {name} of {x}: expected more than {least}"));
            }
        }
        if let Some(t) = periods.iter().find(|t| !(**t > 0.0 && t.is_finite())) {
            return Err(format!("a period of {t} s: expected more than 0"));
        }
        let pool = WorkerPool::new(threads).map_err(|e| e.to_string())?;
        let cases = (0..motions.len()).flat_map(|m| periods.iter().map(move |t| (m, *t)));
        let found = pool.run(cases, |(number, period)| {
            let motion = &motions[number];
            let oscillator = Oscillator { period, damping };
            let elastic = oscillator.peaks(motion.dt, &motion.acceleration).displacement;
            if elastic <= 0.0 {
                return Err(format!("{}: the motion is zero", motion.name));
            }
            let mut case = Case { motion, number, oscillator, elastic, maker: law.maker(), analyses: 0 };
            let points = case.points(levels);
            done();
            Ok((points?, case.analyses))
        });
        let mut out = Self { motions: motions.iter().map(|m| m.name.clone()).collect(), points: vec![], analyses: 0 };
        for case in found {
            let (points, analyses) = case.unwrap_or_else(|| Err("a case panicked".into()))?;
            out.points.extend(points);
            out.analyses += analyses;
        }
        Ok(out)
    }

    /// One row for each period and level: medians over the motions, and the number of motions that have the level.
    pub fn medians(&self) -> Table {
        let mut table = Table::new([
            ("T", "s"),
            ("level", ""),
            ("value", ""),
            ("strength", "W"),
            ("reduction", ""),
            ("displacement", "m"),
            ("ductility", ""),
            ("motions", ""),
        ]);
        let mut kept: Vec<(f64, Level)> = vec![];
        for p in &self.points {
            if !kept.contains(&(p.period, p.level)) {
                kept.push((p.period, p.level));
            }
        }
        kept.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (period, level) in kept {
            let of: Vec<&InelasticPoint> =
                self.points.iter().filter(|p| p.period == period && p.level == level).collect();
            let middle = |value: fn(&InelasticPoint) -> f64| Cell::from(median(of.iter().map(|p| value(p)).collect()));
            let (name, value) = level.name();
            table.rows.push(vec![
                period.into(),
                Cell::Word(name),
                value.into(),
                middle(|p| p.strength),
                middle(|p| p.reduction),
                middle(|p| p.displacement),
                middle(|p| p.ductility),
                (of.len() as f64).into(),
            ]);
        }
        table
    }

    /// One row for each point.
    pub fn table(&self) -> Table {
        let mut table = Table::new([
            ("motion", ""),
            ("T", "s"),
            ("level", ""),
            ("value", ""),
            ("elastic", "m"),
            ("strength", "W"),
            ("reduction", ""),
            ("displacement", "m"),
            ("ductility", ""),
        ]);
        for p in &self.points {
            let (name, value) = p.level.name();
            table.rows.push(vec![
                self.motions[p.motion].clone().into(),
                p.period.into(),
                Cell::Word(name),
                value.into(),
                p.elastic.into(),
                p.strength.into(),
                p.reduction.into(),
                p.displacement.into(),
                p.ductility.into(),
            ]);
        }
        table
    }
}

#[cfg(test)]
mod tests {
    use super::{InelasticPoint, InelasticSpectra, LawText, Level};
    use crate::motion::Motion;
    use std::f64::consts::TAU;

    /// A motion that grows and dies away.
    fn motion(scale: f64) -> Motion {
        let at = |i: i32| {
            let t = 0.01 * f64::from(i);
            scale * (-((t - 4.0) / 2.0).powi(2)).exp() * ((TAU * 1.1 * t).sin() + 0.6 * (TAU * 2.7 * t + 1.0).sin())
        };
        let acceleration = (0..1200).map(at).collect();
        Motion { name: "pulse".into(), title: String::new(), azimuth: None, dt: 0.01, acceleration }
    }

    fn points(law: &str, motion: Motion, periods: &[f64], levels: &[Level]) -> Vec<InelasticPoint> {
        let law = LawText::new(law).expect("a law");
        InelasticSpectra::new(&[motion], &law, (0.05, periods, levels), 2, &|| {}).expect("spectra").points
    }

    /// Without yielding, the displacement is that of the exact linear oscillator.
    #[test]
    fn an_oscillator_that_does_not_yield_is_the_linear_one() {
        for p in points("Steel01 $tag $Fy $k 0.0", motion(2.0), &[0.1, 0.4, 1.5], &[Level::Reduction(0.5)]) {
            assert!((p.displacement / p.elastic - 1.0).abs() < 2e-3, "{p:?}");
            assert!((p.ductility - 0.5).abs() < 1e-3, "{p:?}");
        }
    }

    /// A period far above those of the motion keeps the displacement whatever the strength (Chopra, section 7.5), and the
    /// ductility is the reduction.
    #[test]
    fn long_periods_keep_their_displacement() {
        for p in
            points("Steel01 $tag $Fy $k 0.0", motion(2.0), &[40.0], &[Level::Reduction(2.0), Level::Ductility(4.0)])
        {
            assert!((p.ductility / p.reduction - 1.0).abs() < 0.05, "{p:?}");
        }
    }

    /// A spectrum of constant ductility has that ductility, and no larger strength has it.
    #[test]
    fn a_ductility_is_met_at_the_largest_strength_that_has_it() {
        let law = "Steel01 $tag $Fy $k 0.02";
        let levels = [Level::Ductility(6.0), Level::Ductility(2.0)];
        for p in points(law, motion(3.0), &[0.3, 0.8], &levels) {
            let Level::Ductility(aim) = p.level else { panic!("{p:?}") };
            assert!((p.ductility / aim - 1.0).abs() < 2e-3, "{p:?}");
            let stronger: Vec<Level> =
                (1..20).map(|i| Level::Strength(p.strength * (1.0 + 0.02 * f64::from(i)))).collect();
            let larger = points(law, motion(3.0), &[p.period], &stronger);
            assert!(larger.iter().all(|q| q.ductility < aim), "{p:?}");
        }
    }

    /// The same system in units of its yield displacement: response follows the strength over the motion alone.
    #[test]
    fn a_motion_twice_as_strong_needs_twice_the_strength() {
        let law = "Bilin02 $tag $k 0.02 0.02 $Fy [expr {-$Fy}] 0 0 0 0 1 1 1 1 [expr {9*$Dy}] [expr {9*$Dy}] [expr {20*$Dy}] [expr {20*$Dy}] 0 0 [expr {90*$Dy}] [expr {90*$Dy}] 1 1";
        let one = points(law, motion(1.5), &[0.6], &[Level::Reduction(3.0)]);
        let two = points(law, motion(3.0), &[0.6], &[Level::Reduction(3.0)]);
        assert!((two[0].strength / one[0].strength - 2.0).abs() < 1e-9);
        assert!((two[0].displacement / one[0].displacement - 2.0).abs() < 1e-6, "{one:?} {two:?}");
    }

    #[test]
    fn nonsense_is_refused() {
        assert!(LawText::new("Steel01 1 $Fy $k 0.0").is_err_and(|e| e.contains("has no $tag")));
        let law = LawText::new("Steel0 $tag $Fy $k 0.0").expect("words");
        let spectra = |levels: &[Level], periods: &[f64]| {
            InelasticSpectra::new(&[motion(1.0)], &law, (0.05, periods, levels), 1, &|| {}).map(|_| ())
        };
        let says = |found: Result<(), String>, what: &str| found.is_err_and(|e| e.contains(what));
        assert!(says(spectra(&[Level::Reduction(2.0)], &[0.5]), "unknown uniaxial material \"Steel0\""));
        assert!(says(spectra(&[Level::Ductility(1.0)], &[0.5]), "a ductility of 1: expected more than 1"));
        assert!(says(spectra(&[Level::Strength(0.0)], &[0.5]), "a strength of 0"));
        assert!(says(spectra(&[Level::Reduction(2.0)], &[-1.0]), "a period of -1 s"));
    }
}
