//! A suite of motions with its spectra, intensities and scaling, as tables and pictures.

use crate::motion::{Motion, Pair};
use crate::scaling::{Scaling, scale};
use crate::spectrum::{Combination, PairSpectrum, Spectrum, default_periods, gm_rot_i, logarithmic};
use crate::target::Target;
use hysteron_identify::report::{Cell, Column, Table};
use hysteron_identify::study::unit::Unit;
use hysteron_opensees::chart::{Curve, Figure, Mark, sheet};
use hysteron_tcl::diagnostic::nearest;
use serde_json::{Value, json};

/// Grouping of motions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Grouping {
    /// Each by itself.
    Single,
    /// Pairs of consecutive motions.
    Pairs,
    /// Pairs turned to fault-normal and fault-parallel for a strike in degrees.
    FaultComponents(f64),
    /// Pairs turned to an azimuth in degrees.
    Turned(f64),
}

/// Options of a suite.
#[derive(Clone, Debug, Default)]
pub struct SuiteOptions {
    /// Shares of critical damping of the spectra, each from 0 to less than 1.
    pub damping: Vec<f64>,
    /// Periods of the spectra in s; the default ones if empty.
    pub periods: Vec<f64>,
    /// Target spectrum.
    pub target: Option<Target>,
    /// Periods in s between which the suite is scaled.
    pub range: Option<[f64; 2]>,
    /// Name of the combination that is scaled, for pairs.
    pub combination: String,
    /// Least ratio of the mean of the suite to the target in the range.
    pub least: Option<f64>,
}

/// Spectrum of a member of a suite.
enum MemberSpectrum {
    Single(Spectrum),
    Pair(PairSpectrum, Vec<f64>),
}

/// A suite of motions or pairs.
pub struct Suite {
    motions: Vec<Motion>,
    /// Components in a member: one or two.
    width: usize,
    damping: Vec<f64>,
    periods: Vec<f64>,
    /// By damping, by member.
    spectra: Vec<Vec<MemberSpectrum>>,
    target: Option<Target>,
    combination: Combination,
    range: Option<[f64; 2]>,
    scaling: Option<Scaling>,
}

/// Periods at which a suite is compared with its target.
const SCALING_PERIODS: usize = 40;

impl Suite {
    /// A suite with its spectra, scaled if there is a range.
    ///
    /// # Errors
    /// An option is out of its range, motions do not form pairs, or the suite cannot be scaled.
    pub fn new(motions: Vec<Motion>, grouping: Grouping, options: &SuiteOptions) -> Result<Self, String> {
        if let Some(d) = options.damping.iter().find(|d| !(0.0..1.0).contains(*d)) {
            return Err(format!("a damping of {} %: expected 0 to less than 100", 100.0 * d));
        }
        if options.damping.is_empty() || options.periods.iter().any(|t| *t <= 0.0 || !t.is_finite()) {
            return Err("expected a damping, and periods above 0".into());
        }
        let named = |name: &str| Combination::ALL.iter().find(|(n, _)| *n == name).map(|(_, c)| *c);
        let combination = named(&options.combination).ok_or_else(|| {
            let names = Combination::ALL.map(|(n, _)| n);
            let near = nearest(&options.combination, names).map_or(String::new(), |n| format!("; did you mean {n}?"));
            format!("\"{}\" is no combination: expected {}{near}", options.combination, names.join(", "))
        })?;
        let (motions, pairs) = grouped(motions, grouping)?;
        let mut periods = if options.periods.is_empty() { default_periods() } else { options.periods.clone() };
        periods.sort_by(f64::total_cmp);
        periods.dedup();
        let spectra = options
            .damping
            .iter()
            .map(|&damping| match &pairs {
                None => motions.iter().map(|m| MemberSpectrum::Single(Spectrum::new(m, &periods, damping))).collect(),
                Some(pairs) => pairs
                    .iter()
                    .map(|p| {
                        let gm = gm_rot_i(p, &periods, damping).0;
                        MemberSpectrum::Pair(PairSpectrum::new(p, &periods, damping), gm)
                    })
                    .collect(),
            })
            .collect();
        let scaling = match (options.range, &options.target) {
            (Some(range), Some(target)) => Some(scaled(&motions, &pairs, range, target, combination, options.least)?),
            _ => None,
        };
        let width = if pairs.is_some() { 2 } else { 1 };
        Ok(Self {
            motions,
            width,
            damping: options.damping.clone(),
            periods,
            spectra,
            target: options.target.clone(),
            combination,
            range: options.range,
            scaling,
        })
    }

    fn factor(&self, motion: usize) -> f64 {
        self.scaling.as_ref().map_or(1.0, |s| s.factors[motion / self.width])
    }

    /// The motions, multiplied by their factors.
    pub fn scaled_motions(&self) -> Vec<Motion> {
        self.motions.iter().enumerate().map(|(i, m)| m.scaled(self.factor(i))).collect()
    }

    /// The scaling, if there is a range.
    pub fn scaling(&self) -> Option<&Scaling> {
        self.scaling.as_ref()
    }

    /// Remarks on motions with a suspect baseline, and on an extreme factor.
    pub fn warnings(&self) -> Vec<String> {
        let mut out = vec![];
        for m in &self.motions {
            let b = m.baseline();
            if b.is_suspect() {
                let share = 100.0 * b.velocity;
                out.push(format!("{}: the velocity ends at {share:.0} % of its peak; look at the baseline", m.name));
            }
        }
        for (i, f) in self.scaling.iter().flat_map(|s| &s.factors).enumerate() {
            out.extend(extreme_factor(&self.motions[i * self.width].name, *f));
        }
        out
    }

    /// One row for each motion: factor, and measures of the motion after scaling.
    pub fn summary(&self) -> Table {
        let mut table = Table::new([
            ("motion", ""),
            ("azimuth", "deg"),
            ("dt", "s"),
            ("points", ""),
            ("factor", ""),
            ("misfit", "ln"),
            ("PGA", "g"),
            ("PGV", "m/s"),
            ("PGD", "m"),
            ("Arias", "m/s"),
            ("D5-75", "s"),
            ("D5-95", "s"),
            ("CAV", "m/s"),
            ("v_end", "%"),
        ]);
        for (i, m) in self.scaled_motions().iter().enumerate() {
            let x = m.intensity();
            let misfit = self.scaling.as_ref().map_or(Cell::Word(""), |s| s.misfits[i / self.width].into());
            table.rows.push(vec![
                m.name.clone().into(),
                m.azimuth.map_or(Cell::Word(""), Cell::from),
                m.dt.into(),
                (m.acceleration.len() as f64).into(),
                self.factor(i).into(),
                misfit,
                (x.pga / crate::motion::G).into(),
                x.pgv.into(),
                x.pgd.into(),
                x.arias.into(),
                x.d5_75.into(),
                x.d5_95.into(),
                x.cav.into(),
                (100.0 * m.baseline().velocity).into(),
            ]);
        }
        table
    }

    /// Spectra after scaling: periods by rows; columns of each motion or pair at one damping.
    fn spectra_table(&self, k: usize) -> Table {
        let mut names: Vec<(String, String)> = vec![("T".into(), "s".into())];
        let mut columns: Vec<Vec<f64>> = vec![self.periods.clone()];
        let mut put = |name: String, unit: &str, values: Vec<f64>| {
            names.push((name, unit.to_owned()));
            columns.push(values);
        };
        let g = crate::motion::G;
        for (i, s) in self.spectra[k].iter().enumerate() {
            let f = self.factor(i * self.width);
            let name = &self.motions[i * self.width].name;
            let times = |values: &[f64], by: f64| values.iter().map(|x| f * by * x).collect::<Vec<f64>>();
            match s {
                MemberSpectrum::Single(s) => {
                    let peak = |of: fn(&crate::spectrum::Peaks) -> f64| s.peaks.iter().map(of).collect::<Vec<_>>();
                    put(format!("PSA {name}"), "g", times(&s.pseudo_accelerations(), 1.0 / g));
                    put(format!("SA {name}"), "g", times(&peak(|p| p.acceleration), 1.0 / g));
                    put(format!("SD {name}"), "m", times(&peak(|p| p.displacement), 1.0));
                    put(format!("SV {name}"), "m/s", times(&peak(|p| p.velocity), 1.0));
                }
                MemberSpectrum::Pair(s, gm) => {
                    put(format!("PSA {name}"), "g", times(&s.components[0], 1.0 / g));
                    put(format!("PSA {}", self.motions[i * 2 + 1].name), "g", times(&s.components[1], 1.0 / g));
                    for (how, combination) in Combination::ALL {
                        put(format!("{how} {name}"), "g", times(&s.combined(combination), 1.0 / g));
                    }
                    put(format!("gmroti50 {name}"), "g", times(gm, 1.0 / g));
                    put(format!("direction {name}"), "deg", s.direction.clone());
                }
            }
        }
        if let Some(t) = &self.target {
            put("target".into(), "g", self.periods.iter().map(|p| t.at(*p) / g).collect());
        }
        let head = names.iter().map(|(name, unit)| Column { name: name.clone().into(), unit: unit.clone() }).collect();
        let rows = (0..self.periods.len()).map(|r| columns.iter().map(|c| known(c[r])).collect());
        Table { columns: head, rows: rows.collect() }
    }

    /// The spectrum that is scaled, after scaling, by member.
    fn curves(&self) -> Vec<(String, Vec<f64>)> {
        let of = |(i, s): (usize, &MemberSpectrum)| {
            let f = self.factor(i * self.width) / crate::motion::G;
            let values = match s {
                MemberSpectrum::Single(s) => s.pseudo_accelerations(),
                MemberSpectrum::Pair(s, _) => s.combined(self.combination),
            };
            (self.motions[i * self.width].name.clone(), values.iter().map(|x| f * x).collect())
        };
        self.spectra[0].iter().enumerate().map(of).collect()
    }

    /// Picture of the spectra with their mean and the target, and of each motion.
    fn picture(&self) -> Result<String, String> {
        let points = |ys: &[f64]| -> Vec<(f64, f64)> {
            self.periods.iter().copied().zip(ys.iter().copied()).filter(|p| p.1.is_finite()).collect()
        };
        let curves = self.curves();
        let n = curves.len() as f64;
        let mean: Vec<f64> =
            (0..self.periods.len()).map(|i| curves.iter().map(|(_, c)| c[i]).sum::<f64>() / n).collect();
        let mut drawn = vec![];
        if let Some(t) = &self.target {
            let ys: Vec<f64> = self.periods.iter().map(|p| t.at(*p) / crate::motion::G).collect();
            drawn.push(Curve { name: "target".into(), points: points(&ys), mark: Mark::Wide });
        }
        drawn.extend(curves.iter().map(|(name, c)| Curve { name: name.clone(), points: points(c), mark: Mark::Line }));
        if curves.len() > 1 {
            drawn.push(Curve { name: "mean".into(), points: points(&mean), mark: Mark::Line });
        }
        let spectra = Figure {
            title: format!("Response spectra, {} % damping", 100.0 * self.damping[0]),
            x_label: "Period [s]".into(),
            y_label: "Pseudo-acceleration [g]".into(),
            shaded: self.range.map(|r| (r[0], r[1])).into_iter().collect(),
            curves: drawn,
            ..Figure::default()
        };
        let mut figures = vec![spectra];
        for m in self.scaled_motions() {
            let ys = m.acceleration.iter().enumerate();
            let points = ys.map(|(i, a)| (m.dt * i as f64, a / crate::motion::G)).collect();
            figures.push(Figure {
                title: m.name.clone(),
                x_label: "Time [s]".into(),
                y_label: "Acceleration [g]".into(),
                curves: vec![Curve { name: String::new(), points, mark: Mark::Line }],
                ..Figure::default()
            });
        }
        sheet(&figures, 2).map_err(|e| e.to_string())
    }

    /// The files of the suite with their texts: tables, a picture, and a series of each motion in a unit of accelerations.
    ///
    /// # Errors
    /// There is nothing to draw.
    pub fn files(&self, unit: &Unit) -> Result<Vec<(String, String)>, String> {
        let mut out =
            vec![("motions.csv".to_owned(), self.summary().csv()), ("motions.json".to_owned(), self.json(None))];
        for (k, damping) in self.damping.iter().enumerate() {
            let name = if self.damping.len() == 1 { String::new() } else { format!("_{}", 100.0 * damping) };
            out.push((format!("spectra{name}.csv"), self.spectra_table(k).csv()));
        }
        out.push(("motions.svg".into(), self.picture()?));
        for (i, m) in self.scaled_motions().iter().enumerate() {
            let plain: String =
                m.name.chars().map(|c| if c.is_ascii_alphanumeric() || c == '-' { c } else { '_' }).collect();
            let mut text = String::new();
            for a in &m.acceleration {
                text += &format!("{:.8e}\n", a / unit.factor);
            }
            out.push((format!("{:02}_{plain}.txt", i + 1), text));
        }
        Ok(out)
    }

    /// The results as JSON: motions with factors and measures, the scaling, spectra, and medians of inelastic ones.
    pub fn json(&self, inelastic: Option<&Table>) -> String {
        let parsed = |text: String| serde_json::from_str::<Value>(&text).unwrap_or_default();
        let spectrum = |(k, d)| json!({"damping": d, "rows": parsed(self.spectra_table(k).json())});
        let spectra: Vec<Value> = self.damping.iter().enumerate().map(spectrum).collect();
        let scaling = self.scaling.as_ref().map(|s| {
            let lowest = s.ratios.iter().copied().fold(f64::INFINITY, f64::min);
            json!({"range_s": self.range, "common_factor": s.common, "least_ratio_of_mean": lowest})
        });
        let mut all = json!({"motions": parsed(self.summary().json()), "scaling": scaling, "spectra": spectra});
        if let Some(medians) = inelastic {
            all["inelastic"] = parsed(medians.json());
        }
        format!("{all:#}\n")
    }
}

/// A cell that is empty without a value.
fn known(x: f64) -> Cell {
    if x.is_finite() { Cell::Number(x) } else { Cell::Word("") }
}

/// Pairs in place of motions, where they are asked for.
fn grouped(motions: Vec<Motion>, grouping: Grouping) -> Result<(Vec<Motion>, Option<Vec<Pair>>), String> {
    if grouping == Grouping::Single {
        return Ok((motions, None));
    }
    if !motions.len().is_multiple_of(2) {
        return Err(format!("there are {} motions: expected an even number for pairs", motions.len()));
    }
    let mut pairs = vec![];
    for two in motions.chunks(2) {
        let pair = Pair::new(two[0].clone(), two[1].clone())?;
        pairs.push(match grouping {
            Grouping::FaultComponents(strike) => pair.fault_components(strike)?,
            Grouping::Turned(azimuth) => pair.turned_to(azimuth)?,
            Grouping::Single | Grouping::Pairs => pair,
        });
    }
    Ok((pairs.iter().flat_map(|p| p.components.clone()).collect(), Some(pairs)))
}

/// Factors of a motion that need no remark.
const USUAL_FACTORS: std::ops::RangeInclusive<f64> = 0.25..=4.0;

/// A remark on a factor of a motion that is extreme.
pub(crate) fn extreme_factor(name: &str, factor: f64) -> Option<String> {
    let (from, to) = (USUAL_FACTORS.start(), USUAL_FACTORS.end());
    (!USUAL_FACTORS.contains(&factor))
        .then(|| format!("{name}: the scale factor {factor:.2} is outside {from} to {to}"))
}

/// Scaling at periods of the range, for 5 % damping as targets have it.
fn scaled(
    motions: &[Motion],
    pairs: &Option<Vec<Pair>>,
    range: [f64; 2],
    target: &Target,
    combination: Combination,
    least: Option<f64>,
) -> Result<Scaling, String> {
    let [from, to] = range;
    if !(from > 0.0 && to > from && to.is_finite()) {
        return Err(format!("the range of periods is {from} to {to} s: expected rising and above 0"));
    }
    let periods = logarithmic(from, to, SCALING_PERIODS);
    let spectra: Vec<Vec<f64>> = match pairs {
        None => motions.iter().map(|m| Spectrum::new(m, &periods, 0.05).pseudo_accelerations()).collect(),
        Some(pairs) => pairs.iter().map(|p| PairSpectrum::new(p, &periods, 0.05).combined(combination)).collect(),
    };
    let wanted: Vec<f64> = periods.iter().map(|t| target.at(*t)).collect();
    scale(&spectra, &wanted, least)
}

#[cfg(test)]
mod tests {
    use super::extreme_factor;

    #[test]
    fn factors_within_the_usual_range_need_no_remark() {
        for factor in [0.25, 1.0, 3.99, 4.0] {
            assert_eq!(extreme_factor("A", factor), None);
        }
        assert_eq!(extreme_factor("A", 4.01).as_deref(), Some("A: the scale factor 4.01 is outside 0.25 to 4"));
        assert!(extreme_factor("A", 0.2).is_some());
    }
}
