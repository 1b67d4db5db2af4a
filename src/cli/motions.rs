//! `hysteron motions`: spectra, intensities, rotation and scaling of ground motions.

use super::files::{make_folder, write_atomically};
use super::pace::Pace;
use super::progress::count_bar;
use super::recording::ToldArgs;
use clap::Args;
use hysteron::design::codes::Code;
use hysteron::design::inelastic::{InelasticSpectra, LawText, Level};
use hysteron::design::motion::{ReadOptions, read};
use hysteron::design::spectrum::default_periods;
use hysteron::design::suite::{Grouping, Suite, SuiteOptions};
use hysteron::design::target::Target;
use hysteron::study::unit::{self, Quantity};
use indicatif::ProgressBar;
use std::path::PathBuf;

/// Files, and what is done with their motions.
#[derive(Args, Debug)]
pub(super) struct MotionsArgs {
    /// Files of any format that `recording` shows
    #[arg(required = true)]
    files: Vec<String>,
    /// Take the components two by two as pairs
    #[arg(long)]
    pairs: bool,
    #[command(flatten)]
    told: ToldArgs,
    /// Differentiate velocities and displacements of files without accelerations
    #[arg(long)]
    differentiate: bool,
    /// Azimuths of the components in degrees clockwise from north, in order, where files do not give them
    #[arg(long, value_name = "DEG", num_args = 1.., value_delimiter = ',')]
    azimuths: Vec<f64>,
    /// Turn pairs to fault-normal and fault-parallel for this strike in degrees
    #[arg(long, value_name = "DEG", conflicts_with = "turn")]
    strike: Option<f64>,
    /// Turn pairs to this azimuth in degrees and the direction 90 degrees clockwise from it
    #[arg(long, value_name = "DEG")]
    turn: Option<f64>,
    /// Damping of the spectra in per cent of the critical one
    #[arg(long, value_name = "PERCENT", default_value = "5", num_args = 1.., value_delimiter = ',')]
    damping: Vec<f64>,
    /// Periods of the spectra in s; from 0.02 to 10 if they are not given
    #[arg(long, value_name = "S", num_args = 1.., value_delimiter = ',')]
    periods: Vec<f64>,
    /// Target spectrum: asce7 sms=1.5 sm1=0.9 tl=8, or ec8 ag=0.35 ground=B type=1, or a file of periods and Sa[g]
    #[arg(long, value_name = "WORD", num_args = 1..)]
    target: Vec<String>,
    /// Scale to the target between these periods in s
    #[arg(long, value_name = "S", num_args = 2, requires = "target")]
    scale: Vec<f64>,
    /// Spectrum of a pair that is scaled: rotd50, rotd100, srss, geomean or larger
    #[arg(long, value_name = "NAME", default_value = "rotd100")]
    combination: String,
    /// Raise all factors so that the mean of the suite is not below this part of the target in the range
    #[arg(long, value_name = "PART", requires = "scale")]
    least: Option<f64>,
    /// Code whose rule gives that part: asce7-16, asce7-22
    #[arg(long, value_name = "NAME", requires = "scale", conflicts_with = "least")]
    code: Option<String>,
    /// Write series, tables and pictures into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Unit of the series that are written
    #[arg(long, value_name = "UNIT", default_value = "g")]
    out_unit: String,
    /// Inelastic spectra too, of the law that these words of a uniaxialMaterial make, such as "Steel01 $tag $Fy $k 0.05"
    #[arg(long, value_name = "LAW", requires = "levels")]
    inelastic: Option<String>,
    #[command(flatten)]
    levels: LevelArgs,
    /// Threads for inelastic spectra; all of the machine if it is not given
    #[arg(long, value_name = "N")]
    threads: Option<usize>,
    /// Print the results as JSON
    #[arg(long)]
    json: bool,
}

/// Levels of inelastic spectra.
#[derive(Args, Debug)]
#[group(id = "levels", multiple = true)]
struct LevelArgs {
    /// Yield strengths of inelastic spectra, as parts of the weight
    #[arg(long, value_name = "CY", num_args = 1.., value_delimiter = ',', requires = "inelastic")]
    strength: Vec<f64>,
    /// Reductions of inelastic spectra: elastic force over yield strength
    #[arg(long, value_name = "R", num_args = 1.., value_delimiter = ',', requires = "inelastic")]
    reduction: Vec<f64>,
    /// Ductilities of inelastic spectra: largest displacement over yield displacement
    #[arg(long, value_name = "MU", num_args = 1.., value_delimiter = ',', requires = "inelastic")]
    ductility: Vec<f64>,
}

impl LevelArgs {
    fn levels(&self) -> Vec<Level> {
        let of = |values: &[f64], level: fn(f64) -> Level| values.iter().map(|x| level(*x)).collect::<Vec<_>>();
        [
            of(&self.strength, Level::Strength),
            of(&self.reduction, Level::Reduction),
            of(&self.ductility, Level::Ductility),
        ]
        .concat()
    }
}

/// Inelastic spectra of the motions of a suite, if they are asked for.
fn inelastic(a: &MotionsArgs, suite: &Suite) -> Result<Option<InelasticSpectra>, String> {
    let Some(words) = &a.inelastic else { return Ok(None) };
    let law = LawText::new(words)?;
    let periods = if a.periods.is_empty() { default_periods() } else { a.periods.clone() };
    let levels = a.levels.levels();
    let motions = suite.scaled_motions();
    let threads = a.threads.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from));
    let [damping] = a.damping[..] else { return Err("inelastic spectra have one damping".into()) };
    let (pace, bar) = (Pace::begin(threads), count_bar("oscillators"));
    bar.iter().for_each(|bar| bar.set_length((motions.len() * periods.len()) as u64));
    let done = || bar.iter().for_each(|bar| bar.inc(1));
    let spectra = InelasticSpectra::new(&motions, &law, (damping / 100.0, &periods, &levels), threads, &done);
    bar.iter().for_each(ProgressBar::finish_and_clear);
    let spectra = spectra?;
    pace.report(spectra.analyses, 0, "analyses");
    Ok(Some(spectra))
}

/// Run the command; the text for standard output.
pub(super) fn motions(a: &MotionsArgs) -> Result<String, String> {
    let bytes = |file: &str| hysteron_files::read_input(file).map_err(|e| format!("cannot read \"{file}\": {e}"));
    let options =
        ReadOptions { told: a.told.told()?, channels: a.told.channels().to_vec(), differentiate: a.differentiate };
    let mut motions = vec![];
    for file in &a.files {
        let name = file.rsplit('/').next().unwrap_or(file);
        let beside = hysteron_files::read_beside(file);
        let found = read(name, &bytes(file)?, &options, &beside).map_err(|e| format!("\"{file}\": {e}"))?;
        found.notes.iter().for_each(|note| eprintln!("warning: {note}"));
        motions.extend(found.motions);
    }
    if !a.azimuths.is_empty() {
        if a.azimuths.len() != motions.len() {
            return Err(format!("there are {} azimuths for {} motions", a.azimuths.len(), motions.len()));
        }
        motions.iter_mut().zip(&a.azimuths).for_each(|(m, azimuth)| m.azimuth = Some(azimuth.rem_euclid(360.0)));
    }
    let grouping = match (a.pairs, a.strike, a.turn) {
        (false, None, None) => Grouping::Single,
        (true, None, None) => Grouping::Pairs,
        (_, Some(strike), _) => Grouping::FaultComponents(strike),
        (_, None, Some(azimuth)) => Grouping::Turned(azimuth),
    };
    let target = if a.target.is_empty() { None } else { Some(Target::parse(&a.target, bytes)?) };
    let least = match &a.code {
        None => a.least,
        Some(name) => {
            let code = Code::named(name)?;
            let least = code.value("scaling_range", "least");
            Some(least.ok_or_else(|| format!("{} has no rule about the mean of a suite", code.name))?)
        }
    };
    let out_unit = unit::unit(&a.out_unit).filter(|u| u.quantity == Quantity::Acceleration);
    let out_unit = out_unit.ok_or_else(|| format!("\"{}\" is no unit of accelerations", a.out_unit))?;
    let options = SuiteOptions {
        damping: a.damping.iter().map(|d| d / 100.0).collect(),
        periods: a.periods.clone(),
        target,
        range: <[f64; 2]>::try_from(a.scale.clone()).ok(),
        combination: a.combination.clone(),
        least,
    };
    let suite = Suite::new(motions, grouping, &options)?;
    for warning in suite.warnings() {
        eprintln!("warning: {warning}");
    }
    if let Some(name) = &a.code {
        eprintln!("note: {}", Code::named(name)?.remark());
    }
    let spectra = inelastic(a, &suite)?;
    if let Some(folder) = &a.out {
        make_folder(folder)?;
        for (name, text) in suite.files(&out_unit)? {
            write_atomically(&folder.join(name), &text)?;
        }
        if let Some(spectra) = &spectra {
            write_atomically(&folder.join("inelastic.csv"), &spectra.table().csv())?;
        }
    }
    let medians = spectra.as_ref().map(InelasticSpectra::medians);
    Ok(if a.json { suite.json(medians.as_ref()) } else { medians.map_or(suite.summary(), |m| m).text() })
}
