//! `recorder PVD`: a file of the Visualization Toolkit for each step, and the list of them in time.

use super::recorder_file::make_room;
use super::recorder_options::{Placed, TIME_STEP, add};
use crate::args::Args;
use crate::checks;
use crate::files::series::FileSeries;
use crate::files::vtu::{CellField, PointField, collection, grid};
use crate::text::{Arg, Domain};
use crate::{Outcome, Tcl, warn};
use hysteron_engine::analysis::{Engine, ReactionKind};
use hysteron_engine::model::Model;
use hysteron_engine::record::{
    Cadence, ElementResponse, Group, Known, LiveFile, Missing, Output, RecordError, Recorder, Source,
};
use hysteron_tcl::Call;
use hysteron_tcl::diagnostic::Diagnostic;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// The files have all digits.
pub(super) const DIGITS: Arg = Arg::of("-precision", "digits", "number of digits").within(Domain::Count);

pub(super) const FILE: Arg = Arg::new("file", "name of the file");
pub(super) const TOLERANCE: Arg = Arg::of("-rTolDt", "tolerance", "tolerance rTolDt").within(Domain::NotNegative);
pub(super) const MODES: Arg = Arg::count("modes", "number of modes");

pub(super) const USAGE: &str = "recorder PVD $file <-dT $dt> <-rTolDt $tolerance> <-precision $digits> <disp> <vel> \
                                <accel> <incrDisp> <reaction> <unbalancedLoad> <mass> <eigen $modes> \
                                <eleResponse $response ...>";

/// Fields of the nodes in the files.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Field {
    Displacement,
    Velocity,
    Acceleration,
    Increment,
    Reaction,
    Unbalanced,
    Mass,
    /// This many mode shapes of the last `eigen`.
    Modes(usize),
}

/// Content of the files. They are written when the row is asked for, which is their time.
#[derive(Debug)]
struct Grids {
    files: Arc<Mutex<Box<dyn FileSeries>>>,
    fields: Vec<Field>,
    /// Words of the response of elements that is written; none if empty.
    response: Vec<String>,
    written: usize,
    /// Displacements of the file before.
    before: Vec<f64>,
    known: Known,
}

/// The list of the files, which is written where others may look.
#[derive(Debug)]
struct List(Arc<SharedList>);

#[derive(Debug)]
struct SharedList {
    files: Arc<Mutex<Box<dyn FileSeries>>>,
    folder: String,
    /// Times of the files, and the number of those in the list that is written.
    times: Mutex<(Vec<f64>, usize)>,
}

fn file_name(number: usize) -> String {
    format!("{number:06}.vtu")
}

fn write(files: &Mutex<Box<dyn FileSeries>>, name: Option<&str>, content: &str) -> Result<(), RecordError> {
    files.lock().unwrap_or_else(PoisonError::into_inner).write(name, content)
}

impl Grids {
    fn fields(&mut self, engine: &mut Engine) -> Result<Vec<(&'static str, Vec<f64>)>, RecordError> {
        let mut out = vec![];
        for field in &self.fields {
            let mut values = vec![];
            let failed = |e: hysteron_engine::analysis::Failure| RecordError(e.to_string());
            let name = match field {
                Field::Increment => {
                    self.before.resize(engine.state().disp.len(), 0.0);
                    values = engine.state().disp.iter().zip(&self.before).map(|(now, before)| now - before).collect();
                    self.before.clone_from(&engine.state().disp);
                    "IncrDisplacement"
                }
                Field::Reaction => {
                    engine.reactions(ReactionKind::Static, &mut values).map_err(failed)?;
                    "Reaction"
                }
                Field::Unbalanced => {
                    engine.unbalanced(false, &mut values).map_err(failed)?;
                    "UnbalancedLoad"
                }
                Field::Mass => {
                    values = masses(engine.model());
                    "NodeMass"
                }
                Field::Displacement | Field::Velocity | Field::Acceleration | Field::Modes(_) => continue,
            };
            out.push((name, values));
        }
        Ok(out)
    }

    fn content(&mut self, engine: &mut Engine) -> Result<String, RecordError> {
        let worked_out = self.fields(engine)?;
        let engine = &*engine;
        let mut fields = vec![];
        for field in &self.fields {
            match field {
                Field::Displacement => fields.push(PointField::displacement(engine)),
                Field::Velocity => fields.push(PointField::velocity(engine)),
                Field::Acceleration => fields.push(PointField::acceleration(engine)),
                Field::Modes(count) => fields.extend((0..*count).map_while(|i| PointField::mode(engine, i))),
                Field::Increment | Field::Reaction | Field::Unbalanced | Field::Mass => {}
            }
        }
        fields.extend(
            worked_out.into_iter().map(|(name, values)| PointField { name: name.into(), values: values.into() }),
        );
        let mut cells = vec![];
        if !self.response.is_empty() {
            let words: Vec<&str> = self.response.iter().map(String::as_str).collect();
            let ids = engine.model().elements_by_tag();
            let values =
                ids.map(|id| ElementResponse::evaluate(engine, id, &words, &mut self.known).unwrap_or_default());
            cells.push(CellField { name: words.join(" "), values: values.collect() });
        }
        Ok(grid(engine, &fields, &cells))
    }
}

/// Nodal masses, laid out as the displacements.
fn masses(model: &Model) -> Vec<f64> {
    model.nodes.iter().flat_map(|n| (0..n.ndf).map(|d| n.mass.get(d).copied().unwrap_or(0.0))).collect()
}

impl Source for Grids {
    fn find(&mut self, _: &Engine, _: &mut Vec<Missing>) -> Result<(), RecordError> {
        Ok(())
    }

    fn labels(&self) -> Vec<String> {
        vec!["time".into()]
    }

    fn groups(&self, _: &Engine) -> Vec<Group> {
        vec![]
    }

    fn makes_rows_only(&self) -> bool {
        false
    }

    fn row(&mut self, engine: &mut Engine, row: &mut Vec<f64>) -> Result<(), RecordError> {
        let content = self.content(engine)?;
        write(&self.files, Some(&file_name(self.written)), &content)?;
        self.written += 1;
        row.push(engine.state().time);
        Ok(())
    }
}

impl SharedList {
    fn write(&self) -> Result<(), RecordError> {
        let mut times = self.times.lock().unwrap_or_else(PoisonError::into_inner);
        let name = |(i, time): (usize, &f64)| (*time, format!("{}/{}", self.folder, file_name(i)));
        let listed: Vec<_> = times.0.iter().enumerate().map(name).collect();
        times.1 = listed.len();
        write(&self.files, None, &collection(&listed))
    }
}

impl LiveFile for SharedList {
    fn sync(&self) -> Result<(), RecordError> {
        let is_new = {
            let times = self.times.lock().unwrap_or_else(PoisonError::into_inner);
            times.0.len() > times.1
        };
        if is_new { self.write() } else { Ok(()) }
    }
}

impl Output for List {
    fn row(&mut self, row: &[f64]) -> Result<(), RecordError> {
        self.0.times.lock().unwrap_or_else(PoisonError::into_inner).0.extend(row);
        Ok(())
    }

    fn live(&self) -> Option<Arc<dyn LiveFile>> {
        Some(self.0.clone())
    }

    fn finish(&mut self) -> Result<(), RecordError> {
        self.0.write()
    }
}

/// Make the recorder. The file is named with or without its ending; the folder beside it is made.
pub(super) fn pvd(interp: &mut Tcl, call: &Call<'_>, mut a: Args<'_>) -> Outcome {
    a.usage(USAGE);
    let given = a.word(FILE.meaning)?.into_owned();
    let span = a.last_span();
    let name = if given.ends_with(".pvd") { given } else { format!("{given}.pvd") };
    let mut cadence = Cadence { tolerance: 1e-5, ..Cadence::default() };
    let (mut fields, mut response) = (vec![], vec![]);
    while let Some(word) = a.option() {
        let field = match word.as_ref() {
            "disp" => Field::Displacement,
            "vel" => Field::Velocity,
            "accel" => Field::Acceleration,
            "incrDisp" => Field::Increment,
            "reaction" => Field::Reaction,
            "unbalancedLoad" => Field::Unbalanced,
            "mass" => Field::Mass,
            "eigen" => Field::Modes(a.count(&MODES)?),
            "-dT" => {
                cadence.dt = a.number(&TIME_STEP)?;
                continue;
            }
            "-rTolDt" => {
                cadence.tolerance = a.number(&TOLERANCE)?;
                continue;
            }
            // The arrays have all digits.
            "-precision" => {
                a.count(&DIGITS)?;
                continue;
            }
            "eleResponse" => {
                while let Some(word) = a.option() {
                    response.push(word.into_owned());
                }
                continue;
            }
            _ => {
                let known =
                    ["disp", "vel", "accel", "incrDisp", "reaction", "unbalancedLoad", "mass", "eigen", "eleResponse"];
                crate::ignore_option(interp, &mut a, &known)?;
                continue;
            }
        };
        if !fields.contains(&field) {
            fields.push(field);
        }
    }
    if fields.is_empty() && response.is_empty() {
        let d = Diagnostic::warning(&checks::words::MISSING_WORD, "recorder PVD: the files have the model alone");
        warn(interp, d.at(span, "expected for instance disp after it"))?;
    }
    let path = interp.absolute(&name);
    make_room(interp, call, (&name, &path), span)?;
    let made = interp.host.output.outputs.series(&name, Path::new(&path));
    let files = made.map_err(|e| a.refuse_at(span, e.to_string(), "cannot write here"))?;
    let files = Arc::new(Mutex::new(files));
    let folder = Path::new(&path).file_stem().map(|f| f.to_string_lossy().into_owned()).unwrap_or_default();
    let list = List(Arc::new(SharedList { files: files.clone(), folder, times: Mutex::default() }));
    let grids = Grids { files, fields, response, written: 0, before: vec![], known: Known::default() };
    let recorder = Recorder::history(Box::new(grids), Box::new(list), cadence);
    Ok(add(interp, call, Placed::without_tags(recorder), Some((name, path))))
}
