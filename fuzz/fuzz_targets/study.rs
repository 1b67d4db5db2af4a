//! Any text as a study, beside a script and a recording that exist.
#![no_main]

use hysteron::diagnostic::SourceMap;
use hysteron::study::Study;
use libfuzzer_sys::fuzz_target;
use std::fs;
use std::path::PathBuf;
use std::sync::OnceLock;

static FOLDER: OnceLock<PathBuf> = OnceLock::new();

fn folder() -> PathBuf {
    let folder = std::env::temp_dir().join(format!("hysteron-fuzz-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder of its own");
    fs::write(folder.join("model.tcl"), "pset k 1.0\n").expect("a script");
    fs::write(folder.join("r.csv"), "time[s],force[kN]\n0,0\n1,1\n2,0\n").expect("a recording");
    folder
}

fuzz_target!(|data: &[u8]| {
    let folder = FOLDER.get_or_init(folder);
    let file = folder.join("study.toml");
    fs::write(&file, data).expect("the study");
    let _ = Study::load(&file, &mut SourceMap::default());
});
