//! Work of shipped models, pinned: a change that costs one more factorisation fails.
//!
//! After an intended change of the counts, look at the table that the test writes beside the old one
//! (`tests/snapshots/work_counts.snap.new`) and rename it, or run the test with `INSTA_UPDATE=always`.
//!
//! All equations are dense here. Sparse factors come from faer, whose kernels depend on the processor, and with them the
//! last bits of a correction. The models were chosen so that no count hangs on these: sparse factors give the same, but
//! for `building_boucwen`, where old sparse factors stand for some of the new ones.

#![allow(clippy::unwrap_used, unreachable_pub)]

#[path = "support/counted_law.rs"]
mod counted_law;
#[path = "support/script.rs"]
mod script;

use counted_law::{count_laws, take_calls};
use script::Script;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

/// A model of the repository.
struct Case {
    /// Script from the root of the repository.
    script: &'static str,
    /// Words of the script that are replaced, and those in their place.
    edit: [&'static str; 2],
    /// OpenSees' slips are followed: elements that count their calls are called as often as there.
    compat: bool,
}

const fn case(script: &'static str) -> Case {
    Case { script, edit: ["", ""], compat: false }
}

const CASES: &[Case] = &[
    case("tcl-like-inputs/friction_pendulum.tcl"),
    case("tcl-like-inputs/high_damping_bearing.tcl"),
    case("validation/opensees/algorithms_same_answer/model.tcl"),
    case("validation/opensees/arclength_snapthrough/model.tcl"),
    case("validation/opensees/building_boucwen/model.tcl"),
    Case {
        edit: ["{Penalty 1.0e12 1.0e12}", "Lagrange"],
        ..case("validation/opensees/diaphragm_static_torsion/model.tcl")
    },
    case("validation/opensees/eigen_modes_frame3d/model.tcl"),
    case("validation/opensees/force_beams_space_pushed/model.tcl"),
    case("validation/opensees/isolators_hht_modes/model.tcl"),
    case("validation/opensees/kikuchi_round_cyclic/model.tcl"),
    Case { compat: true, ..case("validation/opensees/kikuchi_round_cyclic/model.tcl") },
    case("validation/opensees/kolay_ricles/model.tcl"),
    case("validation/opensees/steel_dispbeam_cyclic/model.tcl"),
];

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Let a script read the files of a folder, where there is one, in a folder of its own.
fn with_folder(mut script: Script, folder: &Path, place: &str) -> Script {
    let files = fs::read_dir(folder).into_iter().flatten().map(|e| e.unwrap().path());
    let files = files.filter(|p| p.is_file() && p.extension().is_none_or(|e| e != "gz"));
    for path in files {
        let name = path.file_name().unwrap().to_str().unwrap();
        script = script.with_file(&format!("{place}{name}"), &fs::read_to_string(&path).unwrap());
    }
    script
}

/// A row of the table: steps, iterations, factorisations, calls of elements, calls of uniaxial laws.
fn counts(case: &Case) -> [u64; 5] {
    let mut script = if case.compat { Script::compat() } else { Script::default() };
    script.options.dense = Some(true);
    let path = root().join(case.script);
    let folder = path.parent().unwrap();
    for (from, place) in [
        (folder.to_owned(), ""),
        (folder.join("ground_motions"), "ground_motions/"),
        (root().join("models"), "models/"),
    ] {
        script = with_folder(script, &from, place);
    }
    let model = fs::read_to_string(&path).unwrap();
    let [old, new] = case.edit;
    assert!(model.contains(old), "{}: no {old}", case.script);
    take_calls();
    let ran = script.run_with(&if old.is_empty() { model } else { model.replace(old, new) }, count_laws).done();
    let w = ran.work;
    [w.steps, w.iterations, w.factorizations, w.element_calls, take_calls()]
}

fn table() -> String {
    let mut table = format!("{:60}", "model");
    ["steps", "iterations", "factors", "elements", "laws"].iter().for_each(|w| write!(table, "{w:>11}").unwrap());
    for case in CASES {
        let name = format!("{}{}", case.script, if case.compat { " compat" } else { "" });
        write!(table, "\n{name:60}").unwrap();
        counts(case).iter().for_each(|n| write!(table, "{n:>11}").unwrap());
    }
    table
}

#[test]
fn shipped_models_take_as_much_work_as_before() {
    let mut settings = insta::Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!("work_counts", table()));
}
