//! Elements of a script, made by a second run of it.

use super::{Run, Settings};
use crate::model::parameter_change::{Elements, ScriptStart};
use crate::{Mode, NoFiles, Tcl};
use hysteron_tcl::{Exception, FileInfo, Files, MemoryFiles, OpenMode, OverlayFiles, Silent, Stream};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::io;
use std::rc::Rc;
use std::time::Duration;

/// Elements of the script up to its first analysis, with values of its parameters.
pub(super) fn made_elements(
    interp: &mut Tcl,
    start: &ScriptStart,
    parameters: BTreeMap<String, f64>,
) -> Result<Elements, Exception> {
    let files = Rc::new(RefCell::new(std::mem::replace(&mut interp.files, Box::new(MemoryFiles::default()))));
    let made = from_files(interp, start, parameters, &files);
    interp.files = match Rc::try_unwrap(files) {
        Ok(files) => files.into_inner(),
        Err(files) => Box::new(SharedFiles(files)),
    };
    made
}

fn from_files(
    interp: &Tcl,
    start: &ScriptStart,
    parameters: BTreeMap<String, f64>,
    files: &Rc<RefCell<Box<dyn Files>>>,
) -> Result<Elements, Exception> {
    let session = &interp.host;
    let settings = Settings { mode: Mode::Run, strict: false, options: session.engine.options.clone() };
    // What the script writes has been written.
    let files = OverlayFiles::new(Box::new(SharedFiles(files.clone())));
    let mut again = Run::new(settings, Box::new(Silent), Box::new(files), Box::new(NoFiles));
    again.interp.interrupt = interp.interrupt.clone();
    again.interp.deadline = interp.deadline;
    again.interp.group_interrupt = interp.group_interrupt.clone();
    again.interp.budget = interp.budget;
    again.interp.host.number_files = session.number_files.clone();
    again.interp.host.parameters = parameters;
    again.interp.host.ends_at_analysis = true;
    for (name, value) in &start.globals {
        again.interp.set_global(name, value.clone())?;
    }
    match again.begin(&start.path, &start.args) {
        Ok(_) | Err(Exception::Exit(_)) => {}
        Err(e) => return Err(e),
    }
    let model = again.interp.host.engine.model();
    Ok(model.elements.iter().map(|e| (e.tag, e.element.clone())).collect())
}

/// Files of another interpreter.
struct SharedFiles(Rc<RefCell<Box<dyn Files>>>);

impl Files for SharedFiles {
    fn current_dir(&self) -> String {
        self.0.borrow().current_dir()
    }
    fn open(&mut self, path: &str, mode: OpenMode) -> io::Result<Box<dyn Stream>> {
        self.0.borrow_mut().open(path, mode)
    }
    fn info(&self, path: &str, follow: bool) -> io::Result<FileInfo> {
        self.0.borrow().info(path, follow)
    }
    fn list(&self, path: &str) -> io::Result<Vec<String>> {
        self.0.borrow().list(path)
    }
    fn make_dir(&mut self, path: &str) -> io::Result<()> {
        self.0.borrow_mut().make_dir(path)
    }
    fn remove(&mut self, path: &str) -> io::Result<()> {
        self.0.borrow_mut().remove(path)
    }
    fn rename(&mut self, from: &str, to: &str) -> io::Result<()> {
        self.0.borrow_mut().rename(from, to)
    }
    fn set_modified(&mut self, path: &str, time: Duration) -> io::Result<()> {
        self.0.borrow_mut().set_modified(path, time)
    }
    fn read(&mut self, path: &str) -> io::Result<Vec<u8>> {
        self.0.borrow_mut().read(path)
    }
}
