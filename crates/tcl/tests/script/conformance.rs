//! Snippets with what tclsh 8.6.13 gives for them.
//!
//! `cases/NAME.tcl` holds snippets separated by blank lines, `cases/NAME.out` what `tclsh driver.tcl cases/NAME.tcl` wrote
//! in an empty folder with `TZ=UTC LC_ALL=C.UTF-8`. To add a case: add the snippet, write the file again with tclsh.

use std::path::{Path, PathBuf};

use hysteron_tcl::{Interp, OsFiles, Recorded, Value};

fn here() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/script")
}

/// An empty folder of its own for each test.
fn scratch(name: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("hysteron-script-{}-{name}", std::process::id()));
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

fn run(name: &str) {
    let folder = scratch(name);
    let console = Recorded::default();
    let mut interp = Interp::new((), Box::new(console.clone()), Box::new(OsFiles));
    interp.set_current_dir(&folder.to_string_lossy());
    let cases = here().join("cases").join(format!("{name}.tcl"));
    interp.set_global("argv", Value::list([Value::from(&*cases.to_string_lossy())])).unwrap();
    interp.eval_file(&here().join("driver.tcl").to_string_lossy()).unwrap();
    drop(interp);
    std::fs::remove_dir_all(&folder).unwrap();
    let expected = std::fs::read_to_string(cases.with_extension("out")).unwrap();
    compare(name, &expected, &console.out());
}

fn compare(name: &str, expected: &str, got: &str) {
    let split = |text: &str| text.split("\n% ").map(str::to_owned).collect::<Vec<_>>();
    let (expected, got) = (split(expected), split(got));
    let wrong: Vec<_> = expected.iter().zip(&got).filter(|(e, g)| e.trim_end() != g.trim_end()).collect();
    let shown: String = wrong.iter().take(10).map(|(e, g)| format!("tclsh: {e}\nhere:  {g}\n\n")).collect();
    assert!(wrong.is_empty(), "{name}: {} of {} differ\n{shown}", wrong.len(), expected.len());
    assert_eq!(expected.len(), got.len(), "{name}: number of snippets");
}

macro_rules! families {
    ($($name:ident)*) => {
        $(#[test]
        fn $name() {
            run(stringify!($name));
        })*

        #[test]
        fn no_family_is_forgotten() {
            let listed = [$(stringify!($name)),*];
            for entry in std::fs::read_dir(here().join("cases")).unwrap() {
                let path = entry.unwrap().path();
                let name = path.file_stem().unwrap().to_string_lossy().into_owned();
                assert!(listed.contains(&name.as_str()), "{name} is not run");
            }
        }
    };
}

families! { clock control dict expr file format inline list namespace proc programs regexp string unbraced }
