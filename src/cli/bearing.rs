//! `hysteron bearing`: a test of a single bearing, as in a testing machine.

use super::args::{CheckpointArgs, EvidenceArgs, FolderArgs, ScriptArgs, StepArgs};
use super::console::Terminal;
use super::element_alone;
use super::limits::LimitArgs;
use super::loops::ReportArgs;
use super::progress::ProgressLine;
use super::recording::ToldArgs;
use super::run::{self, RunArgs};
use clap::{Args, ValueEnum};
use hysteron::analysis::Options;
use hysteron::measure::CycleDetection;
use hysteron::opensees::{Mode, NoFiles, Tcl};
use hysteron::protocol::{Bearing, Motion, Protocol, RecordedPath};
use hysteron::recordings::series::{channel_names, find_channel};
use hysteron::recordings::unit::{Quantity, Unit};
use hysteron::recordings::user_statements::Key;
use hysteron::recordings::{Clock, Fault, Measured, Series, Table as Columns, Way};
use hysteron::report::{Column, Record, Table};
use hysteron::run::{End, Run, Settings};
use hysteron::tcl::Silent;
use hysteron::tcl::{OsFiles, OverlayFiles, Value};
use std::path::Path;

/// Arguments of a bearing test.
#[derive(Args, Debug)]
pub(super) struct BearingArgs {
    #[command(flatten)]
    script_args: ScriptArgs,
    #[command(flatten)]
    limits: LimitArgs,
    /// A script that defines the bearing as element 1 (nodes and materials too, no supports, loads or analyses); or a file of
    /// models/, whose procedure of the same name makes it
    file: String,
    /// Take this element, between two nodes, out of the script of a whole model, with what its words name
    #[arg(long, value_name = "TAG", conflicts_with = "device")]
    element: Option<i32>,
    /// The procedure that makes the bearing, and its words after tag and nodes (else the one named like the file)
    #[arg(long, value_name = "\"NAME ARG ...\"")]
    device: Option<String>,
    /// How the upper end moves
    #[arg(long, short = 'm', value_enum, default_value_t = MotionKind::Cycles)]
    motion: MotionKind,
    /// Amplitudes of the displacement, one after the other
    #[arg(
        long,
        short = 'a',
        value_delimiter = ',',
        allow_negative_numbers = true,
        required_unless_present_any = ["strains", "recording"]
    )]
    amplitudes: Vec<f64>,
    /// Amplitudes as shear strains, displacements over --thickness
    #[arg(
        long,
        value_delimiter = ',',
        allow_negative_numbers = true,
        conflicts_with = "amplitudes",
        requires = "thickness"
    )]
    strains: Vec<f64>,
    /// Cycles of each amplitude
    #[arg(long, short = 'n', default_value_t = 3)]
    cycles: usize,
    /// Cycles in a unit of time
    #[arg(long, default_value_t = 1.0)]
    frequency: f64,
    /// Steps of a cycle (of a ramp as long as the largest amplitude)
    #[arg(long, default_value_t = 200)]
    steps: usize,
    /// Move the upper end as a measured file of any format says, instead of --motion: its channel of displacements, or two
    /// of them, along x and y. In the unit of length of --units, else in that of the file
    #[arg(long, value_name = "FILE", conflicts_with_all = ["amplitudes", "strains", "motion"])]
    recording: Option<String>,
    #[command(flatten)]
    told: ToldArgs,
    #[command(flatten)]
    axial_load: AxialLoadArgs,
    #[command(flatten)]
    details: MotionArgs,
    /// Folder of the results (else the name of the file with _test)
    #[arg(long, short = 'o', value_name = "FOLDER")]
    out: Option<String>,
    /// Write the script of the test, and do not run it
    #[arg(long)]
    script: bool,
    #[command(flatten)]
    report: ReportArgs,
}

/// The axial load during a test.
#[derive(Args, Debug)]
struct AxialLoadArgs {
    /// Axial load, compression positive
    #[arg(long, short = 'P', value_name = "LOAD", default_value_t = 0.0, allow_negative_numbers = true)]
    axial: f64,
    /// Amplitude of a sine about the axial load
    #[arg(long, value_name = "LOAD", default_value_t = 0.0, allow_negative_numbers = true)]
    axial_amplitude: f64,
    /// Cycles of the axial load in a cycle of the motion
    #[arg(long, value_name = "RATIO", default_value_t = 1.0)]
    axial_ratio: f64,
}

/// Details of the kinds of motion.
#[derive(Args, Debug)]
struct MotionArgs {
    /// Direction of cycles in degrees from x
    #[arg(long, default_value_t = 0.0, allow_negative_numbers = true)]
    angle: f64,
    /// Lateral displacement during axial cycles
    #[arg(long, default_value_t = 0.0, allow_negative_numbers = true)]
    offset: f64,
    /// Speed of ramps
    #[arg(long, default_value_t = 1.0)]
    speed: f64,
    /// Time for which ramps are held
    #[arg(long, default_value_t = 0.0)]
    hold: f64,
    /// Impose velocities too, in a transient analysis (done by itself for devices whose forces depend on velocity)
    #[arg(long)]
    rates: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum MotionKind {
    /// Sines of shear
    Cycles,
    /// Circles in plan
    Circles,
    /// Figures of eight in plan
    Eights,
    /// Axial sines
    Axial,
    /// Ramps and holds
    Ramps,
}

impl BearingArgs {
    fn protocol(&self, depends_on_velocity: bool) -> Result<Protocol, String> {
        let thickness = self.report.thickness().unwrap_or(1.0);
        let strains = self.strains.iter().map(|s| s * thickness);
        let recorded = self.recording.as_deref().map(|file| self.recorded_path(file)).transpose()?;
        let peak = recorded.iter().flat_map(|r| r.displacements.iter().flatten()).map(|x| x.abs()).reduce(f64::max);
        Ok(Protocol {
            motion: match self.motion {
                _ if recorded.is_some() => Motion::Recorded,
                MotionKind::Cycles => Motion::Cycles { angle: self.details.angle },
                MotionKind::Circles => Motion::Circles,
                MotionKind::Eights => Motion::Eights,
                MotionKind::Axial => Motion::Axial { offset: self.details.offset },
                MotionKind::Ramps => Motion::Ramps { speed: self.details.speed, hold: self.details.hold },
            },
            amplitudes: self.amplitudes.iter().copied().chain(strains).chain(peak).collect(),
            recorded: recorded.unwrap_or_default(),
            cycles: self.cycles,
            frequency: self.frequency,
            steps: self.steps,
            axial: self.axial_load.axial,
            axial_amplitude: self.axial_load.axial_amplitude,
            axial_ratio: self.axial_load.axial_ratio,
            rates: self.details.rates || depends_on_velocity,
        })
    }

    /// The path of a measured file.
    fn recorded_path(&self, file: &str) -> Result<RecordedPath, String> {
        let of_file = |e: String| format!("\"{file}\": {e}");
        let bytes = hysteron_files::read_input(file).map_err(|e| format!("cannot read \"{file}\": {e}"))?;
        let told = self.told.told()?;
        let measured = Measured::read_beside(file, &bytes, &hysteron_files::read_beside(file));
        let measured = measured.map_err(|e| of_file(e.to_string()))?;
        measured.notes.iter().for_each(|note| eprintln!("warning: \"{file}\": {note}"));
        let all = measured.stated_series(&told).map_err(|e| of_file(e.to_string()))?;
        let length = self.report.length_unit();
        let path = recorded_path(&measured, all, self.told.channels(), length).map_err(|e| of_file(e.to_string()))?;
        if length.is_none() {
            eprintln!("note: the displacements of \"{file}\" are taken as they are written; --units converts them");
        }
        Ok(path)
    }

    /// Find the bearing: run its file alone, and inspect the model. True if its forces depend on velocity.
    fn bearing(&self, file: &str) -> Result<(Bearing, bool), TestError> {
        let settings = Settings { mode: Mode::Run, strict: self.script_args.strict, options: Options::default() };
        let files = OverlayFiles::new(Box::new(OsFiles));
        let mut run =
            Run::new(settings, Box::new(Terminal::new(ProgressLine::new())), Box::new(files), Box::new(NoFiles));
        let end = run.script(file, &[]);
        if !matches!(end, End::Done) {
            run::print_end(&end, &run.interp);
            return Err(TestError::Printed(end.status()));
        }
        let mut eval = |text: &str| eval_to_text(&mut run.interp, text);
        let file = file.to_owned();
        if eval("expr {1 in [getEleTags]}").as_deref() == Some("1") && self.device.is_none() {
            let nodes: Option<Vec<i32>> =
                eval("eleNodes 1").map(|n| n.split_whitespace().filter_map(|n| n.parse().ok()).collect());
            let ndm = eval("getNDM").and_then(|n| n.parse().ok());
            return match (nodes.as_deref(), ndm) {
                (Some(&[lower, upper]), Some(ndm @ 2..=3)) => {
                    let depends = depends_on_velocity(&run);
                    Ok((Bearing { file, call: None, nodes: [lower, upper], ndm, is_held: false }, depends))
                }
                _ => Err(TestError::Message(format!(
                    "element 1 of \"{file}\" does not join two nodes in plane or space"
                ))),
            };
        }
        let stem = Path::new(&self.file).file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        let device = self.device.clone().unwrap_or(stem);
        let (name, words) = device.split_once(' ').unwrap_or((&device, ""));
        if eval(&format!("llength [info procs {{{name}}}]")).as_deref() != Some("1") {
            let problem = format!("\"{file}\" makes no element 1 and has no procedure \"{name}\"");
            let procedures = eval("lsort [info procs]").filter(|p| !p.is_empty());
            let procedures =
                procedures.map_or_else(|| "it has no procedures".into(), |p| format!("its procedures are {p}"));
            return Err(TestError::Message(format!("{problem}: {procedures} (see --device)")));
        }
        let call = format!("{name} 1 1 2 {words}").trim_end().to_owned();
        let bearing = Bearing { file, call: Some(call), nodes: [1, 2], ndm: 3, is_held: false };
        let depends = self.made_bearing_depends_on_velocity(&bearing);
        Ok((bearing, depends))
    }

    /// Hold the upper node along the vertical where nothing else does, and no axial load asks for it.
    fn hold(&self, bearing: &mut Bearing) {
        let is_axial = self.axial_load.axial != 0.0 || self.axial_load.axial_amplitude != 0.0;
        if is_axial || self.motion == MotionKind::Axial {
            return;
        }
        let mut run = silent();
        let step = eval_to_text(&mut run.interp, &bearing.vertical_step());
        if step.is_some_and(|code| code != "0") {
            bearing.is_held = true;
            eprintln!("note: the bearing has no stiffness along the vertical: its upper node is held there");
        }
    }

    /// Returns true if the forces of a bearing that a procedure makes depend on velocity. An error in it is left to the test.
    fn made_bearing_depends_on_velocity(&self, bearing: &Bearing) -> bool {
        let mut run = silent();
        eval_to_text(&mut run.interp, &bearing.definition());
        depends_on_velocity(&run)
    }

    /// Folder of the results.
    fn folder(&self) -> String {
        let stem = Path::new(&self.file).file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        let tag = self.element.map(|tag| format!("_{tag}")).unwrap_or_default();
        self.out.clone().unwrap_or_else(|| format!("{stem}{tag}_test"))
    }
}

/// A session without messages.
fn silent() -> Run {
    let settings = Settings { mode: Mode::Run, strict: false, options: Options::default() };
    let files = OverlayFiles::new(Box::new(OsFiles));
    Run::new(settings, Box::new(Silent), Box::new(files), Box::new(NoFiles))
}

/// The path along the channels of displacements, in a unit if one is asked for.
fn recorded_path(
    measured: &Measured,
    all: Vec<Series>,
    channels: &[String],
    to: Option<Unit>,
) -> Result<RecordedPath, Fault> {
    let series: Vec<Series> = match channels {
        [] => all.iter().filter(|s| s.quantity == Some(Quantity::Length)).cloned().collect(),
        _ => {
            let find = |word: &String| Ok(all[find_channel(all.iter(), word)?].clone());
            channels.iter().map(find).collect::<Result<_, Fault>>()?
        }
    };
    let Some(first) = series.first().filter(|_| series.len() <= 2) else {
        let key = Way::CommandLine.spelled(Key::Channel);
        let message = format!("there are {} channels of displacements", series.len());
        let expected = format!("say {key} with one or two of {}", channel_names(all.iter()));
        return Err(Fault::new(message).expected(expected));
    };
    if first.clock == Clock::Unknown {
        return Err(measured.no_step(Way::CommandLine));
    }
    let Some(dt) = first.clock.dt() else {
        let remedy = "write it at equal steps";
        return Err(Fault::new("the steps of time differ, and a test needs equal ones").help(remedy));
    };
    let mut displacements = vec![];
    for s in &series {
        let shown = if s.name.is_empty() { "the channel" } else { &s.name };
        if let Some(q) = s.quantity.filter(|q| *q != Quantity::Length) {
            return Err(Fault::new(format!("{shown} is {}, and a path needs displacements", q.word())));
        }
        if let Some(i) = s.values.iter().position(|x| !x.is_finite()) {
            return Err(Fault::new(format!("value {} of {shown} is missing or not finite", i + 1)));
        }
        if s.clock != first.clock || s.values.len() != first.values.len() {
            return Err(Fault::new("the two channels have other times"));
        }
        displacements.push(match to {
            Some(unit) => s.in_unit(unit, Way::CommandLine)?,
            None => s.values.clone(),
        });
    }
    Ok(RecordedPath { dt, displacements })
}

/// Returns true if the forces of an element of a model depend on velocity.
fn depends_on_velocity(run: &Run) -> bool {
    run.interp.host.engine.model().elements.iter().any(|e| e.element.traits().viscous)
}

/// Result of a Tcl script as text.
fn eval_to_text(interp: &mut Tcl, text: &str) -> Option<String> {
    interp.eval_str("bearing", text).ok().map(|v: Value| v.as_str().into_owned())
}

/// The error of a test.
enum TestError {
    /// The error is printed already: exit status.
    Printed(i32),
    /// The message to print.
    Message(String),
}

impl From<String> for TestError {
    fn from(message: String) -> Self {
        Self::Message(message)
    }
}

/// Run the command; the exit status.
pub(super) fn bearing(args: &BearingArgs) -> i32 {
    match run_test(args) {
        Ok(status) | Err(TestError::Printed(status)) => status,
        Err(TestError::Message(message)) => run::print(Err(message)),
    }
}

fn run_test(args: &BearingArgs) -> Result<i32, TestError> {
    let folder = args.folder();
    let in_folder = |name: &str| format!("{folder}/{name}");
    let cannot = |e: std::io::Error| format!("cannot write into \"{folder}\": {e}");
    let mut file = args.file.clone();
    if let Some(tag) = args.element {
        let alone = element_alone::script_of(&file, tag)?;
        hysteron_files::make_folders(&folder).map_err(cannot)?;
        file = in_folder("bearing.tcl");
        hysteron_files::write(&file, alone).map_err(cannot)?;
    }
    let (mut bearing, depends_on_velocity) = args.bearing(&file)?;
    args.hold(&mut bearing);
    let protocol = args.protocol(depends_on_velocity)?;
    protocol.check(bearing.ndm)?;
    hysteron_files::make_folders(&folder).map_err(cannot)?;
    let script = in_folder("test.tcl");
    let from_test = hysteron_files::path_from(Path::new(&folder), Path::new(&file)).map_err(cannot)?;
    hysteron_files::write(&script, protocol.script(&bearing, &from_test)).map_err(cannot)?;
    if args.script {
        return Ok(run::print(Ok(format!("{script}\n"))));
    }
    let folders = FolderArgs { allow_write: vec![folder.clone().into()], ..FolderArgs::default() };
    let (script_args, limits) = (&args.script_args, &args.limits);
    let (steps, evidence) = (&StepArgs::default(), &EvidenceArgs::default());
    let run_args = RunArgs {
        quiet: false,
        script: script_args,
        steps,
        limits,
        folders: &folders,
        evidence,
        checkpoints: &CheckpointArgs::default(),
    };
    let status = run::run(&run_args, &script, &[]);
    let read = |name: &str| -> Result<Columns, String> {
        let text = hysteron_files::read_text(in_folder(name)).map_err(|e| format!("there are no results: {e}"))?;
        Columns::parse(&text)
    };
    let (displacement, force) = (read("displacement.out")?, read("force.out")?);
    let columns: Vec<&Vec<f64>> = displacement.columns.iter().chain(force.columns.iter().skip(1)).collect();
    let names: &[&'static str] = if bearing.ndm == 2 {
        &["time", "u_x", "u_y", "F_x", "F_y"]
    } else {
        &["time", "u_x", "u_y", "u_z", "F_x", "F_y", "F_z"]
    };
    if columns.len() != names.len() {
        return Err(TestError::Message("there are no results: the test ended at once".into()));
    }
    hysteron_files::write(in_folder("loops.csv"), csv(names, &columns)).map_err(cannot)?;
    let (u, f) = (&columns[1..=bearing.ndm], &columns[bearing.ndm + 1..]);
    let table = measure(args, columns[0], u, f)?;
    hysteron_files::write(in_folder("cycles.csv"), table.csv()).map_err(cannot)?;
    if args.report.is_text() {
        eprintln!("test.tcl, loops.csv, cycles.csv and loops.svg are in {folder}");
    }
    run::print(Ok(args.report.format(&table)));
    Ok(status)
}

/// Table and charts of the direction of the motion.
fn measure(args: &BearingArgs, time: &[f64], u: &[&Vec<f64>], f: &[&Vec<f64>]) -> Result<Table, String> {
    let record = |u, f| Record { time: Some(time), u, f };
    let svg = format!("{}/loops.svg", args.folder());
    let detection = CycleDetection::default();
    if args.recording.is_some() {
        let moves = |d: &[f64]| d.iter().any(|x| *x != 0.0);
        return match u {
            [x, y, _] if moves(y) => args.report.measure(&[record(x, f[0]), record(y, f[1])], &detection, Some(&svg)),
            _ => args.report.measure(&[record(u[0], f[0])], &detection, Some(&svg)),
        };
    }
    match args.motion {
        MotionKind::Circles | MotionKind::Eights => {
            args.report.measure(&[record(u[0], f[0]), record(u[1], f[1])], &detection, Some(&svg))
        }
        MotionKind::Axial => {
            let vertical = u.len() - 1;
            args.report.measure(&[record(u[vertical], f[vertical])], &detection, Some(&svg))
        }
        MotionKind::Cycles if args.details.angle != 0.0 => {
            let (sin, cos) = args.details.angle.to_radians().sin_cos();
            let along = |v: &[&Vec<f64>]| v[0].iter().zip(v[1]).map(|(x, y)| cos * x + sin * y).collect::<Vec<f64>>();
            args.report.measure(&[record(&along(u), &along(f))], &detection, Some(&svg))
        }
        MotionKind::Cycles | MotionKind::Ramps => args.report.measure(&[record(u[0], f[0])], &detection, Some(&svg)),
    }
}

/// Columns of numbers under their names.
fn csv(names: &[&'static str], columns: &[&Vec<f64>]) -> String {
    let rows = columns.iter().map(|c| c.len()).min().unwrap_or(0);
    let table = Table {
        columns: names.iter().map(|&name| Column { name: name.into(), unit: String::new() }).collect(),
        rows: (0..rows).map(|i| columns.iter().map(|c| c[i].into()).collect()).collect(),
    };
    table.csv()
}
