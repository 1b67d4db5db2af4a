//! Commands that a host calls one by one: their words are data, and none of them is run as a script.

use crate::script::Tables;
use hysteron::analysis::Options;
use hysteron::opensees::{Mode, calls};
use hysteron::run::{Run, Settings};
use hysteron::tcl::{MemoryFiles, Recorded, Value};

#[test]
fn texts_of_a_host_are_not_run() {
    let files = MemoryFiles::default();
    let settings = Settings { mode: Mode::Run, strict: false, options: Options::default() };
    let (console, outputs) = (Box::new(Recorded::default()), Box::new(Tables::default()));
    let mut run = Run::for_calls(settings, console, Box::new(files.clone()), outputs);
    let mut call = |words: &[&str]| {
        let command = calls::command(words[0]).unwrap();
        let words: Vec<Value> = words.iter().map(|w| Value::from(*w)).collect();
        run.call(command, &words).map(|v| v.to_string()).map_err(|e| format!("{e:?}"))
    };
    call(&["model", "basic", "-ndm", "2", "-ndf", "2"]).unwrap();
    call(&["timeSeries", "Linear", "1"]).unwrap();
    call(&["nDMaterial", "ElasticIsotropic", "1", "100.", "0.25"]).unwrap();
    let attack = "close [open /made w]";
    let points = "1 0 0 2 4 0 3 4 3 4 0 3";
    for words in [
        &["pattern", "Plain", "1", "1", attack][..],
        &["pattern", "MultipleSupport", "2", attack],
        &["block2D", "1", "1", "1", "1", "quad", "1.0 PlaneStrain 1; close [open /made w]", points],
        &["block2D", "1", "1", "21", "21", "quad", "[close [open /made w]] PlaneStrain 1", points],
        &["block2D", "1", "1", "31", "31", "quad 1 [close [open /made w]];", "1.0 PlaneStrain 1", points],
    ] {
        let refused = call(words);
        assert!(refused.is_err() && files.get("/made").is_none(), "{words:?}: {refused:?}");
    }
    // What is asked for properly is made.
    call(&["block2D", "2", "1", "41", "41", "quad", "1.0 PlaneStrain 1", points]).unwrap();
    assert_eq!(call(&["getEleTags"]).unwrap(), "41 42");
}
