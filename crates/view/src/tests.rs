//! The page of small models whose motion is known.

use crate::collector::{Motion, Observer, Units};
use crate::pack::Pack;
use crate::page::{LIBRARY, description, page};
use hysteron_engine::analysis::{Kind, Options};
use hysteron_engine::record::{Memory, Output, RecordError};
use hysteron_opensees::run::{Run, Settings};
use hysteron_opensees::{FileFormat, Mode, Outputs};
use hysteron_tcl::{MemoryFiles, Recorded};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::path::Path;

struct Nowhere;

impl Outputs for Nowhere {
    fn create(&mut self, _: &str, _: &Path, _: FileFormat) -> Result<Box<dyn Output>, RecordError> {
        Ok(Box::new(Memory::default()))
    }
}

/// A column on a bearing made of springs. Gravity, then a shaken mass.
const COLUMN: &str = "model BasicBuilder -ndm 2 -ndf 3
    node 5 0 0; node 3 0 0; node 9 0 4; fix 5 1 1 1; mass 9 2 2 0
    uniaxialMaterial Elastic 1 100.; uniaxialMaterial Elastic 2 1e6; uniaxialMaterial Elastic 3 1e6
    element zeroLength 7 5 3 -mat 1 2 3 -dir 1 2 6
    geomTransf Linear 1; element elasticBeamColumn 4 3 9 0.1 2e7 1e-3 1
    timeSeries Linear 1; pattern Plain 1 1 { load 9 0 -20 0 }
    integrator LoadControl 0.25; analysis Static; analyze 4; loadConst -time 0
    timeSeries Trig 2 0 1 0.5; pattern UniformExcitation 2 1 -accel 2
    integrator Newmark 0.5 0.25; analysis Transient; analyze 200 0.01\n";

fn motion(script: &str, modes: usize) -> (Option<Motion>, usize) {
    let files = MemoryFiles::default();
    files.insert("/model.tcl", script);
    let settings = Settings { mode: Mode::Run, strict: false, options: Options::default() };
    let mut run = Run::new(settings, Box::new(Recorded::default()), Box::new(files), Box::new(Nowhere));
    let observer = Observer::new(modes);
    run.interp.host.observe_motion(Box::new(observer.clone()));
    assert_eq!(run.script("model.tcl", &[]).status(), 0);
    let collector = observer.take();
    let models = collector.models;
    (collector.finish(&mut run.interp.host.engine), models)
}

fn described(motion: &Motion) -> (Value, Pack) {
    let mut pack = Pack::default();
    let value = description(motion, "column", &Units::default(), 1, &mut pack);
    (value, pack)
}

#[test]
fn the_model_is_that_of_the_script() {
    let Some(motion) = motion(COLUMN, 0).0 else { unreachable!("it has nodes") };
    let (d, pack) = described(&motion);
    let read = |v: &Value| pack.read(v);
    assert_eq!(read(&d["nodes"]["tags"]), [5.0, 3.0, 9.0]);
    assert_eq!(read(&d["nodes"]["places"]), [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 4.0, 0.0]);
    assert_eq!(read(&d["nodes"]["fixed"]), [7.0, 0.0, 0.0]);
    assert_eq!(read(&d["nodes"]["mass"]), [0.0, 0.0, 2.0]);
    assert_eq!(read(&d["nodes"]["load"])[6..], [0.0, -20.0, 0.0]);
    assert_eq!(read(&d["elements"]["tags"]), [7.0, 4.0]);
    assert_eq!(read(&d["elements"]["nodes"]), [0.0, 1.0, 1.0, 2.0]);
    let names: Vec<&str> =
        read(&d["elements"]["family"]).iter().map(|f| d["families"][*f as usize].as_str().unwrap_or("")).collect();
    assert_eq!(names, ["links", "beams"]);
    // The axes of a column: x upward, y to the left.
    assert_eq!(read(&d["elements"]["axes"])[9..15], [0.0, 1.0, 0.0, -1.0, 0.0, 0.0]);
    assert_eq!(d["shaken"], serde_json::json!([0]));
}

#[test]
fn stages_histories_and_peaks_are_those_of_the_run() {
    let Some(motion) = motion(COLUMN, 2).0 else { unreachable!("it has nodes") };
    let stages: Vec<_> = motion.stages.iter().map(|s| (s.kind, s.steps)).collect();
    assert_eq!(stages, [(Kind::Static, (0, 5)), (Kind::Transient, (5, 205))]);
    let (d, pack) = described(&motion);
    let device = &d["devices"][0];
    let roles: Vec<&str> = (0..3).filter_map(|k| device["directions"][k][1].as_str()).collect();
    assert_eq!(roles, ["shear", "axial", "rotation"]);
    // Gravity is in the axial force; in the elastic loop force is stiffness times deformation.
    let columns: Vec<Vec<f64>> = (0..6).map(|c| pack.read(&device["columns"][c])).collect();
    assert!(columns[4].last().is_some_and(|p| (p + 20.0).abs() < 1e-2));
    let most = columns[3].iter().fold(0.0f64, |m, f| m.max(f.abs()));
    assert!(most > 0.5, "{most}");
    assert!(columns[0].iter().zip(&columns[3]).all(|(u, f)| (100.0 * u - f).abs() < 1e-3 * most));
    // The table of peaks and the thinned history have the same largest number.
    let peak = device["peaks"][3][0].as_f64().unwrap_or(0.0);
    assert!((peak.abs() - most).abs() < 1e-4 * most, "{peak} {most}");
    // The first mode of 2 t on 100 kN/m with a stiff column.
    let modes = d["modes"].as_array().map_or(0, Vec::len);
    let lambda = d["modes"][0]["lambda"].as_f64().unwrap_or(0.0);
    assert!(modes == 2 && lambda > 40.0 && lambda < 50.0, "{modes} {lambda}");
}

#[test]
fn a_page_names_nothing_outside_itself() {
    let Some(motion) = motion(COLUMN, 0).0 else { unreachable!("it has nodes") };
    let text = page(&motion, "<column> & \"co\"", &Units { force: "kN".into(), length: "m".into() }, 1);
    for outside in ["http:", "https:", "src=", "href=", "//cdn", "@import", "url("] {
        assert!(!text.contains(outside), "{outside}");
    }
    assert!(text.contains("<title>&lt;column&gt; &amp; &quot;co&quot;</title>") && !text.contains("<column>"));
    assert!(text.len() < 2_500_000, "{} bytes", text.len());
}

#[test]
fn the_last_model_is_shown_after_a_wipe_and_a_model_at_rest_without_analysis() {
    let (seen, models) = motion(&format!("{COLUMN} wipe\n {COLUMN} wipe\n"), 1);
    let Some(seen) = seen else { unreachable!("it was analysed") };
    assert_eq!((models, seen.steps(), seen.modes.len()), (2, 205, 1));
    let (rest, _) = motion("model BasicBuilder -ndm 3 -ndf 6; node 1 0 0 0; node 2 1 0 0\n", 0);
    assert!(rest.is_some_and(|m| m.steps() == 1 && m.scene.elements.is_empty()));
    assert!(motion("puts 1\n", 0).0.is_none());
}

#[test]
fn the_page_of_many_steps_stays_small() {
    // 500 nodes, 8000 steps: what is kept is bounded, whatever the number of steps.
    let script = "model BasicBuilder -ndm 1 -ndf 1; node 0 0; fix 0 1
        uniaxialMaterial Steel01 1 50 4000 0.1
        for {set i 1} {$i <= 500} {incr i} { node $i $i -mass 1; element truss $i [expr $i - 1] $i 1.0 1 }
        timeSeries Trig 1 0 100 0.7 -factor 3; pattern UniformExcitation 1 1 -accel 1
        constraints Plain; system BandGeneral; algorithm Newton; integrator Newmark 0.5 0.25; analysis Transient; analyze 800 0.01\n";
    let Some(motion) = motion(script, 0).0 else { unreachable!("it has nodes") };
    assert_eq!(motion.steps(), 801);
    let text = page(&motion, "chain", &Units::default(), 1);
    assert!(text.len() < 6_000_000, "{} bytes", text.len());
}

#[test]
fn plotly_is_the_file_that_its_page_names() {
    let unpacked = miniz_oxide::inflate::decompress_to_vec_zlib(LIBRARY).expect("a packed file");
    let sum: String = Sha256::digest(&unpacked).iter().map(|b| format!("{b:02x}")).collect();
    assert!(include_str!("../plotly/README.md").contains(&sum), "{sum}");
}
