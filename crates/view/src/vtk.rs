//! Files for ParaView: a grid for each step, and a list of them in time.

use hysteron_engine::analysis::Engine;
use hysteron_opensees::MotionObserver;
use hysteron_opensees::files::vtu::{PointField, collection, end_forces, grid};
use std::cell::RefCell;
use std::io;
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// Writes a file for each step of a run. The script and the owner of the writer share it.
#[derive(Clone, Debug)]
pub struct Writer(Rc<RefCell<Series>>);

#[derive(Debug)]
struct Series {
    folder: PathBuf,
    every: usize,
    steps: usize,
    files: Vec<(f64, String)>,
    failure: Option<io::Error>,
}

/// Name of the list of the files.
const LIST: &str = "motion.pvd";
/// Name of the folder of the files beside it.
const STEPS: &str = "steps";

impl Writer {
    /// A writer of every `every`-th step into a folder, which is made.
    ///
    /// # Errors
    /// The folder cannot be made.
    pub fn new(folder: &Path, every: usize) -> io::Result<Self> {
        hysteron_files::make_inner_folder(folder.join(STEPS))?;
        let series = Series { folder: folder.into(), every: every.max(1), steps: 0, files: vec![], failure: None };
        Ok(Self(Rc::new(RefCell::new(series))))
    }

    /// Write the list of the files, with that of the model at rest where nothing has been analysed. The times are those of
    /// the domain, or the numbers of the steps where time goes back. The number of files.
    ///
    /// # Errors
    /// A file could not be written.
    pub fn finish(&self, engine: &Engine) -> io::Result<usize> {
        let mut series = self.0.borrow_mut();
        if series.files.is_empty() {
            series.write(engine);
        }
        if let Some(e) = series.failure.take() {
            return Err(e);
        }
        hysteron_files::write(series.folder.join(LIST), collection(&series.files))?;
        Ok(series.files.len())
    }
}

impl Series {
    fn write(&mut self, engine: &Engine) {
        let fields = [PointField::displacement, PointField::velocity, PointField::acceleration].map(|f| f(engine));
        let name = format!("{STEPS}/{:06}.vtu", self.files.len());
        match hysteron_files::write(self.folder.join(&name), grid(engine, &fields, &end_forces(engine))) {
            Ok(()) => self.files.push((engine.state().time, name)),
            Err(e) => self.failure = self.failure.take().or(Some(e)),
        }
    }
}

impl MotionObserver for Writer {
    fn start(&mut self, engine: &Engine) {
        let mut series = self.0.borrow_mut();
        if series.steps == 0 {
            series.write(engine);
        }
    }

    fn step(&mut self, engine: &Engine) {
        let mut series = self.0.borrow_mut();
        series.steps += 1;
        if series.steps.is_multiple_of(series.every) {
            series.write(engine);
        }
    }

    fn wipe(&mut self, _: &mut Engine) {}
}

/// Two observers, of which each may be missing.
#[derive(Debug)]
pub struct Both<A, B>(pub Option<A>, pub Option<B>);

impl<A: MotionObserver, B: MotionObserver> MotionObserver for Both<A, B> {
    fn start(&mut self, engine: &Engine) {
        self.0.iter_mut().for_each(|o| o.start(engine));
        self.1.iter_mut().for_each(|o| o.start(engine));
    }

    fn step(&mut self, engine: &Engine) {
        self.0.iter_mut().for_each(|o| o.step(engine));
        self.1.iter_mut().for_each(|o| o.step(engine));
    }

    fn wipe(&mut self, engine: &mut Engine) {
        self.0.iter_mut().for_each(|o| o.wipe(engine));
        self.1.iter_mut().for_each(|o| o.wipe(engine));
    }
}
