//! The balance of energy of a run, for those who ask for it.

use hysteron_engine::analysis::{Energies, EnergyBalance, Engine};
use std::collections::BTreeMap;

/// Size of a model when its last analysis began.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ModelSize {
    /// Number of nodes.
    pub nodes: usize,
    /// Numbers of elements by class.
    pub elements: BTreeMap<&'static str, usize>,
}

/// A model of a script that was analysed.
#[derive(Clone, Debug, PartialEq)]
pub struct AnalysedModel {
    /// Its size.
    pub size: ModelSize,
    /// Energies at its end.
    pub energies: Energies,
    /// Largest error of its balance, as a part of the largest energy in it.
    pub error: f64,
}

/// Balances of the models of a script, one after the other, with their histories.
#[derive(Debug, Default)]
pub struct Balances {
    current: EnergyBalance,
    size: ModelSize,
    /// Models that the script has wiped.
    finished: Vec<AnalysedModel>,
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
        let model = engine.model();
        self.size = ModelSize { nodes: model.nodes.len(), elements: BTreeMap::new() };
        for e in &model.elements {
            *self.size.elements.entry(e.element.class().name).or_default() += 1;
        }
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
        self.finished.extend(self.now());
        (self.current, self.size) = Default::default();
    }

    /// The model as it is; `None` if it was not analysed.
    fn now(&self) -> Option<AnalysedModel> {
        let (energies, error) = (self.current.energies().clone(), self.current.relative_error());
        (!energies.classes.is_empty()).then(|| AnalysedModel { size: self.size.clone(), energies, error })
    }

    /// The models that were analysed, one after the other.
    pub fn models(&self) -> Vec<AnalysedModel> {
        self.finished.iter().cloned().chain(self.now()).collect()
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
