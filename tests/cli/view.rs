//! Pages and files of a run for those who look.

use super::{MODEL, Place};

/// The cantilever, analysed.
fn analysed() -> String {
    format!(
        "{MODEL}fix 3 1 1 1\nrecorder Node -file disp.out -node 2 -dof 1 disp\nintegrator LoadControl 0.1\nanalysis Static\nanalyze 10\n"
    )
}

#[test]
fn view_writes_the_page_alone() {
    let place = Place::new();
    place.write("model.tcl", analysed());
    let (status, _, err) = place.run(&["view", "model.tcl", "--modes", "0", "--units", "kN", "m"]);
    assert_eq!(status, Some(0), "{err}");
    let page = std::fs::read_to_string(place.0.join("model.html")).unwrap();
    assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
    assert!(!page.contains("http"), "the page names something outside");
    assert!(!place.0.join("disp.out").exists(), "what the script writes is discarded");
    let (status, _, err) = place.run(&["run", "model.tcl", "--view", "b.html"]);
    assert_eq!(status, Some(0), "{err}");
    assert!(place.0.join("disp.out").exists() && place.0.join("b.html").exists());
}

#[test]
fn a_step_each_for_paraview() {
    let place = Place::new();
    place.write("model.tcl", analysed());
    let (status, _, err) = place.run(&["view", "model.tcl", "--vtk", "vtk", "--every", "2"]);
    assert_eq!(status, Some(0), "{err}");
    let list = std::fs::read_to_string(place.0.join("vtk/motion.pvd")).unwrap();
    // The state at the beginning and five of ten steps.
    assert_eq!(list.matches("<DataSet").count(), 6, "{list}");
    assert!(list.contains("file=\"steps/000005.vtu\"") && place.0.join("vtk/steps/000005.vtu").exists());
    assert!(!place.0.join("model.html").exists());
}

#[test]
fn nothing_is_written_of_a_script_that_is_rejected() {
    let place = Place::new();
    place.write("bad.tcl", format!("{MODEL}elemnt truss 2 1 3 1 1\n"));
    let (status, _, err) = place.run(&["view", "bad.tcl"]);
    assert!(status == Some(2) && err.contains("bad.tcl:11") && err.contains("element"), "{status:?} {err}");
    assert!(!place.0.join("bad.html").exists());
    place.write("empty.tcl", "puts 1\n");
    let (status, _, err) = place.run(&["view", "empty.tcl"]);
    assert!(status == Some(2) && err.contains("no model"), "{status:?} {err}");
    let (status, _, err) = place.run(&["view", "missing.tcl"]);
    assert!(status == Some(2) && err.contains("missing.tcl"), "{status:?} {err}");
    place.write("model.tcl", analysed());
    let (status, _, err) = place.run(&["view", "model.tcl", "--out", "no/such/folder/a.html"]);
    assert!(status == Some(2) && err.contains("cannot write no/such/folder/a.html"), "{status:?} {err}");
    assert_eq!(place.run(&["view", "model.tcl", "--units", "kN"]).0, Some(2));
}

#[test]
fn a_failed_analysis_is_shown_up_to_its_failure() {
    let place = Place::new();
    place.write("model.tcl", format!("{MODEL}integrator LoadControl 0.1\nanalysis Static\nanalyze 10\n"));
    // Node 3 is loose.
    let (status, _, err) = place.run(&["view", "model.tcl"]);
    assert!(status == Some(1) && place.0.join("model.html").exists(), "{status:?} {err}");
}
