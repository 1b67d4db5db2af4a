//! `hysteron run --balance`: the balance of energy of a run.

use super::files::write_atomically;
use hysteron::analysis::Energies;
use hysteron::opensees::Balances;
use std::path::Path;

/// Print the balances of the models of a script, and write their history to a file.
pub(super) fn print(balances: &Balances, history: Option<&Path>) -> Result<(), String> {
    let models = balances.models();
    if models.is_empty() {
        eprintln!("note: no analysis was made, so that there is no balance of energy");
    }
    for (i, model) in models.iter().enumerate() {
        let number = if models.len() > 1 { format!(" of model {}", i + 1) } else { String::new() };
        eprint!("energy{number} (force x length, relative to the ground)\n{}", table(&model.energies, model.error));
    }
    history.map_or(Ok(()), |path| write_atomically(path, &balances.csv()))
}

/// Energies of a balance by their names; sources of damping that there are not are left out.
pub(super) fn rows(e: &Energies) -> Vec<(String, f64)> {
    let mut lines = vec![("input".to_owned(), e.input), ("kinetic, at the end".into(), e.kinetic)];
    for (class, energy) in &e.classes {
        lines.push((format!("work on {class}"), energy.work));
        if energy.damping != 0.0 {
            lines.push((format!("Rayleigh damping of {class}"), energy.damping));
        }
    }
    for (name, energy) in [("damping of nodal masses", e.nodal_damping), ("damping of modes", e.modal_damping)] {
        if energy != 0.0 {
            lines.push((name.into(), energy));
        }
    }
    lines.push(("error".into(), e.error()));
    lines
}

/// Share of the input in per cent; empty where nothing came in.
pub(super) fn share_of_input(x: f64, e: &Energies) -> String {
    if e.input == 0.0 { String::new() } else { format!("{:.2} %", 100.0 * x / e.input) }
}

/// Lines of a balance: energy and its share of the input.
fn table(e: &Energies, largest_error: f64) -> String {
    let lines = rows(e);
    let width = lines.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    let line = |(name, x): &(String, f64)| format!("  {name:width$}  {x:12.5e}  {:>9}\n", share_of_input(*x, e));
    let all: String = lines.iter().map(line).collect();
    format!("{all}  largest error so far, of the largest energy: {:.2e} %\n", 100.0 * largest_error)
}
