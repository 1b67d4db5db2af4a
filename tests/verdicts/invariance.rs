//! The first name of a verdict follows from what happened, not from how it was written down: the number of samples, a part
//! of the record, units, and values from which the parameters start.

use super::imposed;
use super::studies::{self, CheckpointRecorder, Concealed};
use hysteron::diagnose::Settings;
use std::fs;
use std::path::Path;

/// A way to write the same tests down.
#[derive(Clone, Copy)]
struct View {
    name: &'static str,
    /// Rows of the recordings that are kept: from a share of the record on, one of some.
    from: f64,
    one_of: usize,
    /// Change of the study in memory.
    change: fn(&mut Concealed),
}

const PLAIN: View = View { name: "as it is", from: 0.0, one_of: 1, change: |_| {} };
const HALF: View = View { name: "every second sample", one_of: 2, ..PLAIN };
const FIFTH: View = View { name: "every fifth sample", one_of: 5, ..PLAIN };
const CUT: View = View { name: "without the first tenth", from: 0.1, ..PLAIN };
const NEWTONS: View = View { name: "in N in place of kN", change: in_newtons, ..PLAIN };
const ELSEWHERE: View =
    View { name: "from other values", change: |s| s.model = s.model.replace("pset Fy 9.0", "pset Fy 17.0"), ..PLAIN };

/// Forces of the pad in N.
fn in_newtons(s: &mut Concealed) {
    for (kilo, plain) in [("Fy 9.0", "Fy 9000.0"), ("k 300.0", "k 300000.0"), ("$Fy 2000.0", "$Fy 2000000.0")] {
        assert!(s.model.contains(kilo));
        s.model = s.model.replace(kilo, plain);
    }
    s.parameters.iter_mut().for_each(|(_, lower, upper)| (*lower, *upper) = (1e3 * *lower, 1e3 * *upper));
    for (header, values) in s.runs.iter_mut().flat_map(|r| &mut r.columns).filter(|(header, _)| header == "force[kN]") {
        *header = "force[N]".into();
        values.iter_mut().for_each(|f| *f *= 1e3);
    }
}

/// Keeps some rows of a recording.
fn keep_rows(file: &Path, view: View) {
    let text = fs::read_to_string(file).unwrap();
    let rows: Vec<&str> = text.lines().collect();
    let first = (view.from * (rows.len() - 1) as f64) as usize;
    let kept = rows[1 + first..].iter().step_by(view.one_of);
    fs::write(file, kept.fold(rows[0].to_owned(), |all, row| all + "\n" + row) + "\n").unwrap();
}

fn first_name(study: fn() -> Concealed, name: &str, view: View) -> (String, f64) {
    let mut study = study();
    (view.change)(&mut study);
    let dir = study.write(&format!("view-{name}-{}", view.name.replace(' ', "-")));
    study.runs.iter().for_each(|r| keep_rows(&dir.join(format!("{}.csv", r.name)), view));
    let settings = Settings { threads: 1, ..Settings::default() };
    let found = studies::attempt(&dir, &settings, &mut CheckpointRecorder::unlimited());
    let _ = fs::remove_dir_all(dir);
    let verdict = found.unwrap_or_else(|e| panic!("{name}, {}: {e}", view.name)).outcome.verdict;
    (verdict.cause, verdict.confidence)
}

/// Asserts that a study has the name of its truth in all of some views; the table of verdicts has it as it is.
fn has_one_name(name: &str, cause: &str, study: fn() -> Concealed, views: &[View]) {
    let found: Vec<(&str, (String, f64))> = views.iter().map(|v| (v.name, first_name(study, name, *v))).collect();
    assert!(found.iter().all(|(_, (first, _))| first == cause), "{name}: {found:#?}");
}

#[test]
#[ignore = "takes minutes"]
fn relaxation_has_one_name_in_all_views() {
    let views = [HALF, FIFTH, CUT, NEWTONS, ELSEWHERE];
    has_one_name("maxwell", "rate_dependence", || imposed::maxwell(500.0), &views);
}

#[test]
#[ignore = "takes minutes"]
fn softening_has_one_name_from_fewer_samples_and_without_its_first_cycle() {
    has_one_name("mullins", "mullins_softening", imposed::mullins, &[HALF, CUT]);
}

#[test]
#[ignore = "takes minutes"]
fn a_complete_model_is_complete_from_fewer_samples_and_in_other_units() {
    has_one_name("slow noise", "none", imposed::slow_noise, &[FIFTH, NEWTONS]);
}
