//! The table of trust of README.md, from the files that the checks write.

use super::testing::{counted, folders, rows};
use super::{Sheet, root};
use std::fs;

/// Figures with the day and the commit of their measurement, where no test of every change measures them.
const MEASURED: &str = "validation/measured.csv";
/// The rows between these lines are written.
const MARKS: [&str; 2] =
    ["<!-- written by: HYSTERON_WRITE=1 cargo test --release --test manual -->\n", "<!-- end -->\n"];

/// Day and commit of a measurement.
fn measured(figure: &str) -> String {
    let text = fs::read_to_string(root().join(MEASURED)).unwrap();
    let row = text.lines().find_map(|l| l.strip_prefix(figure)?.strip_prefix(',')).unwrap();
    let (day, commit) = row.split_once(',').unwrap();
    format!("{day}, `{commit}`")
}

/// Answers of the sealed batch that was opened last: right ones, and all.
fn sealed() -> (usize, usize) {
    let text = fs::read_to_string(root().join("validation/diagnosis/outcomes.csv")).unwrap();
    let (header, lines) = text.split_once('\n').unwrap();
    let place = |name: &str| header.split(',').position(|n| n == name).unwrap();
    let cells: Vec<Vec<&str>> = lines.lines().map(|l| l.split(',').collect()).collect();
    let last = cells.iter().filter_map(|c| c[place("batch")].parse::<u32>().ok()).max().unwrap().to_string();
    let opened: Vec<_> = cells.iter().filter(|c| c[place("batch")] == last && c[place("state")] == "opened").collect();
    (opened.iter().filter(|c| c[place("right")] == "yes").count(), opened.len())
}

pub(crate) fn trust(sheets: &[&Sheet]) -> String {
    let checks: usize = sheets.iter().map(|s| s.checks.len()).sum();
    let scripts = |column| counted("validation/scripts.csv", column).1;
    let [equal, differs, refused] = ["equal", "differs", "refused"].map(scripts);
    let (right, asked) = sealed();
    let mut out = String::from("| what | measured | when |\n| --- | --- | --- |\n");
    out += &format!(
        "| [problems with a solution on paper](docs/verification/index.md) | {} problems, {checks} results | every change |\n",
        sheets.len()
    );
    out += &format!(
        "| [cases of the real OpenSees](validation/opensees) | {} cases with OpenSees' numbers | every change |\n",
        folders("validation/opensees")
    );
    out += &format!(
        "| [public scripts of {} repositories](validation/scripts.csv) | {equal} of {} with OpenSees' numbers, {differs} differ, {refused} are refused | {} |\n",
        rows("validation/scripts.csv"),
        equal + differs + refused,
        measured("scripts")
    );
    out += &format!(
        "| [concealed effects, sealed before the answer](validation/diagnosis/outcomes.md) | {right} of {asked} diagnoses right | {} |\n",
        measured("sealed")
    );
    out += "| [published tests done again](validation/identification/README.md) | each equation, table and figure with its merit | every change |\n";
    out + &format!(
        "| [measured recordings](validation/recordings/README.md) | {} answers with every miss | each with its build |\n",
        rows("validation/recordings/answers.csv")
    )
}

#[test]
fn the_table_of_trust_has_the_measured_figures() {
    let families = super::families();
    let sheets: Vec<&Sheet> = families.iter().flat_map(|(_, _, s)| s).collect();
    let path = root().join("README.md");
    let text = fs::read_to_string(&path).unwrap();
    let (before, rest) = text.split_once(MARKS[0]).unwrap();
    let (_, after) = rest.split_once(MARKS[1]).unwrap();
    let page = [before, MARKS[0], &trust(&sheets), MARKS[1], after].concat();
    assert!(
        super::held(&path, &page),
        "HYSTERON_WRITE=1 cargo test --release --test manual writes the table of README.md"
    );
    assert!(page.lines().count() <= 150, "README.md has {} lines", page.lines().count());
}
