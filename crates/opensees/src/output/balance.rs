//! The balance of energy of a run, for those who ask for it.

use hysteron_engine::analysis::{Energies, EnergyBalance, Engine};

/// Balances of the models of a script, one after the other, with their histories.
#[derive(Debug, Default)]
pub struct Balances {
    current: EnergyBalance,
    /// Balances of models that the script has wiped, with their largest relative errors.
    finished: Vec<(Energies, f64)>,
    /// Rows of the history: number of the model, and energies.
    history: Option<Vec<(usize, Energies)>>,
}

impl Balances {
    /// Balances without their history, or with it.
    pub fn new(history: bool) -> Self {
        Self { history: history.then(Vec::new), ..Self::default() }
    }

    pub(crate) fn start(&mut self, engine: &mut Engine) {
        // A model whose constraints make no sense is refused by its first step.
        let _ = self.current.start(engine);
    }

    pub(crate) fn step(&mut self, engine: &mut Engine) -> Result<(), String> {
        self.current.step(engine).map_err(|f| f.to_string())?;
        if let Some(rows) = &mut self.history {
            rows.push((self.finished.len() + 1, self.current.energies().clone()));
        }
        Ok(())
    }

    /// The model has been wiped.
    pub(crate) fn next_model(&mut self) {
        let last = std::mem::take(&mut self.current);
        if !last.energies().classes.is_empty() {
            self.finished.push((last.energies().clone(), last.relative_error()));
        }
    }

    /// Energies at the end of each model that was analysed, and the largest error of its balance as a part of the largest
    /// energy in it.
    pub fn models(&self) -> Vec<(&Energies, f64)> {
        let current = (self.current.energies(), self.current.relative_error());
        let finished = self.finished.iter().map(|(e, error)| (e, *error));
        finished.chain((!current.0.classes.is_empty()).then_some(current)).collect()
    }

    /// The history as CSV: a row for each step, with the work of and the Rayleigh damping in each class of element.
    pub fn csv(&self) -> String {
        let rows = self.history.as_deref().unwrap_or_default();
        let mut classes: Vec<&str> = vec![];
        for (class, _) in rows.iter().flat_map(|(_, e)| &e.classes) {
            if !classes.contains(class) {
                classes.push(class);
            }
        }
        let mut head = vec!["model".to_owned(), "time".into(), "input".into(), "kinetic".into()];
        head.extend(["damping_of_nodal_masses".into(), "damping_of_modes".into()]);
        head.extend(classes.iter().flat_map(|c| [format!("work_{c}"), format!("damping_{c}")]));
        head.push("error".into());
        let mut out = head.join(",") + "\n";
        for (model, e) in rows {
            let of = |class: &&str| e.classes.iter().find(|(c, _)| c == class).map(|(_, e)| *e).unwrap_or_default();
            let by_class = classes.iter().map(of).flat_map(|c| [c.work, c.damping]);
            let all = [e.time, e.input, e.kinetic, e.nodal_damping, e.modal_damping];
            let values: Vec<String> =
                all.into_iter().chain(by_class).chain([e.error()]).map(|x| x.to_string()).collect();
            out += &format!("{model},{}\n", values.join(","));
        }
        out
    }
}
