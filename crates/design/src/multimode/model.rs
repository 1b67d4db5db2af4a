//! Modes of the model of a script with its bearings linearized.

use super::linearized::Linearized;
use super::{Mode, PeriodMode};
use crate::isolate::{Study, run_to_transient};
use hysteron_engine::analysis::{ModalProperties, ModeRequest, Modes, ModesError};
use hysteron_engine::element::Element;
use hysteron_engine::model::ElementId;
use hysteron_opensees::run::Run;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Share of the effective mass below which a mode has none in a direction.
const NO_MASS: f64 = 1.0e-9;

type Bearing = (Arc<dyn Element>, ElementId, usize, [usize; 2]);

/// The model of a study before its transient analysis.
pub struct ModalModel {
    pub(super) run: Run,
    ndm: usize,
    wanted: usize,
    /// Bearings in the order of the study: element as the script made it, its place, the type, and the first global degrees of
    /// freedom of its lower and upper node.
    bearings: Vec<Bearing>,
    /// First global degree of freedom of each floor's node.
    floors: Vec<usize>,
    modes: Modes,
    factors: Vec<Vec<f64>>,
    masses: Vec<Vec<f64>>,
}

impl ModalModel {
    pub(super) fn new(study: &Study, bound: &'static str, wanted: usize) -> Result<Self, String> {
        let run = run_to_transient(study, bound, 0, &Arc::default())?;
        let model = run.interp.host.engine.model();
        let ndm = model.nodes.first().map_or(0, |n| n.coords.len());
        if ndm < 2 {
            return Err("the model has no vertical direction: expected two or three dimensions".into());
        }
        let node = |tag: i64| {
            let tag32 = i32::try_from(tag).ok();
            let id = tag32.and_then(|t| model.node(t)).ok_or_else(|| format!("there is no node {tag}"))?;
            Ok::<usize, String>(model.nodes[id.0].offset)
        };
        let mut bearings = vec![];
        for (kind, b) in study.bearings.iter().enumerate() {
            for tag in &b.tags {
                let id = i32::try_from(*tag).ok().and_then(|t| model.element(t));
                let id = id.ok_or_else(|| format!("there is no bearing {tag}"))?;
                let e = &model.elements[id.0];
                let [lower, upper] = e.nodes[..] else {
                    return Err(format!("the bearing {tag} has {} nodes: expected 2", e.nodes.len()));
                };
                let at = [lower, upper].map(|n| model.nodes[n.0].offset);
                bearings.push((e.element.clone(), id, kind, at));
            }
        }
        let floors = study.floors.iter().map(|f| node(f.node)).collect::<Result<Vec<_>, _>>()?;
        let modes = Modes { lambda: vec![], shapes: vec![], rigid: 0 };
        Ok(Self { run, ndm, wanted, bearings, floors, modes, factors: vec![], masses: vec![] })
    }

    /// Number of horizontal directions.
    pub fn horizontal(&self) -> usize {
        self.ndm - 1
    }

    /// Give the bearings of each type their stiffness, and find the modes.
    pub(super) fn linearize(&mut self, study: &Study, stiffnesses: &[f64]) -> Result<(), String> {
        let horizontal = self.horizontal();
        let engine = &mut self.run.interp.host.engine;
        let tags = study.bearings.iter().flat_map(|b| &b.tags);
        let mut linear: Vec<(_, Arc<dyn Element>)> = Vec::with_capacity(self.bearings.len());
        for ((of, id, kind, _), tag) in self.bearings.iter().zip(tags) {
            let new = Linearized::new(of.as_ref(), horizontal, stiffnesses[*kind]);
            linear.push((*id, Arc::new(new.map_err(|e| format!("the bearing {tag} {e}"))?)));
        }
        engine.replace_elements(linear);
        let mut count = self.wanted;
        self.modes = loop {
            match engine.find_modes(ModeRequest::smallest(count)) {
                Ok(modes) => break modes.clone(),
                Err(ModesError::TooFew { available }) if (1..count).contains(&available) => count = available,
                Err(ModesError::Failure(f)) => return Err(format!("the modes cannot be found: {f}")),
                Err(_) => return Err("the modes cannot be found: the structure has no mass that moves".into()),
            }
        };
        if self.modes.rigid > 0 {
            return Err("the structure on its bearings is a mechanism: it has a mode without stiffness".into());
        }
        let properties = ModalProperties::new(engine.model(), &self.modes, false);
        self.masses = properties.ratios();
        self.factors = properties.factors;
        Ok(())
    }

    /// Displacement of a mode shape at a bearing: upper less lower node.
    pub(super) fn bearing(&self, mode: usize, bearing: usize, h: usize) -> f64 {
        let [lower, upper] = self.bearings[bearing].3;
        self.modes.shapes[mode][upper + h] - self.modes.shapes[mode][lower + h]
    }

    /// Displacement of a mode shape at a floor.
    pub(super) fn floor(&self, mode: usize, floor: usize, h: usize) -> f64 {
        self.modes.shapes[mode][self.floors[floor] + h]
    }

    /// Type of a bearing.
    pub(super) fn kind(&self, bearing: usize) -> usize {
        self.bearings[bearing].2
    }

    /// Number of bearings.
    pub(super) fn count(&self) -> usize {
        self.bearings.len()
    }

    /// Amplitude of a mode: participation factor times spectral displacement.
    pub(super) fn amplitude(&self, mode: usize, direction: usize, acceleration: f64) -> f64 {
        self.factors[mode][direction] * acceleration / self.modes.lambda[mode]
    }

    /// Eigenvalue of a mode.
    pub(super) fn eigenvalue(&self, mode: usize) -> f64 {
        self.modes.lambda[mode]
    }

    /// The model and its modes with a stiffness of the bearings of each type.
    ///
    /// # Errors
    /// The script fails before its transient analysis, or the modes cannot be found.
    pub(crate) fn at(study: &Study, bound: &'static str, stiffnesses: &[f64], wanted: usize) -> Result<Self, String> {
        let mut model = Self::new(study, bound, wanted)?;
        model.linearize(study, stiffnesses)?;
        Ok(model)
    }

    /// Periods and shares of the effective mass by direction of motion.
    pub(crate) fn periods(&self) -> Vec<Vec<PeriodMode>> {
        let mode = |k: usize, direction: usize| PeriodMode {
            period: TAU / self.modes.lambda[k].sqrt(),
            mass: if self.masses[k][direction] < NO_MASS { 0.0 } else { self.masses[k][direction] },
        };
        let of = |direction: usize| (0..self.modes.lambda.len()).map(|k| mode(k, direction)).collect();
        (0..self.horizontal()).map(of).collect()
    }

    /// Periods, composite dampings and spectral values. The damping of a mode is Σ β k Δ²/λ of the bearings plus the damping
    /// of the structure on the rest of the energy; shapes have unit modal mass.
    pub(super) fn modes(
        &self,
        study: &Study,
        stiffnesses: &[f64],
        dampings: &[f64],
        direction: usize,
    ) -> Result<Vec<Mode>, String> {
        let most = study.code.value("modal_damping", "most").unwrap_or(f64::INFINITY);
        let of = |mode: usize| {
            let lambda = self.modes.lambda[mode];
            let (mut energy, mut damped) = (0.0, 0.0);
            for b in 0..self.count() {
                let square: f64 = (0..self.horizontal()).map(|h| self.bearing(mode, b, h).powi(2)).sum();
                let share = stiffnesses[self.kind(b)] * square / lambda;
                energy += share;
                damped += dampings[self.kind(b)] * share;
            }
            let damping = damped + study.structure_damping * (1.0 - energy).max(0.0);
            let damping = damping.min(most);
            let period = TAU / lambda.sqrt();
            let coefficient = study.code.damping_coefficient(damping).ok_or("the code has no damping coefficient")?;
            let acceleration = study.target.at(period) / crate::motion::G / coefficient;
            if !(acceleration.is_finite() && acceleration > 0.0) {
                return Err(format!("the target spectrum has no value at the period {period:.3} s of a mode"));
            }
            let mass = self.masses[mode][direction];
            Ok(Mode { period, damping, acceleration, mass, isolators: energy })
        };
        (0..self.modes.lambda.len()).map(of).collect()
    }
}
