//! High damping rubber: rheology with rate, temperature, self-heating and softening.

mod overstress;
mod parameters;
mod plane;
mod thermal;

use crate::material::roles::{LawResponses, UniaxialRoles};
use crate::material::wrapper::softening::{Peak, Softening};
use crate::material::{MaterialError, MaterialResult, Strain, Stress, Uniaxial, UniaxialTraits, updates_each_point};
use crate::numeric::{Dual, sign};
use crate::probe::{Probe, Response};
use crate::state_struct::StateStruct;
use overstress::Branch;

pub use parameters::{Compound, NAMES, OutOfRange, Parameters};
pub use plane::{PlaneHistory, PlaneStep};
pub use thermal::{Stack, Thermal};

/// Rheology model of high damping rubber bearings. An elasto-plastic and a nonlinear elastic branch give the
/// equilibrium stress. An elasto-plastic part in series with a nonlinear dashpot gives the overstress. Source: D. A.
/// Nguyen, A rheology model of high damping rubber bearings for seismic analysis at room and low temperatures,
/// dissertation, Eqs 3.1 to 3.13, with its symbols.
///
/// The strain rate is constant over a step. In a step without time the dashpot does not move, which is the limit of a
/// very fast step.
///
/// With [`Thermal`], the work that the springs do not store heats the rubber. The parameters are those at the
/// temperature in the middle of the step, solved together with the stress. The first law of thermodynamics holds by
/// construction: work = elastic energy + heat in the bearing + heat lost.
#[derive(Clone, Debug, PartialEq)]
pub struct HdrRheology {
    /// Parameters as functions of the temperature.
    pub compound: Compound,
    /// Temperature of the surroundings, and initial temperature of the rubber.
    pub ambient: f64,
    /// Self-heating.
    pub thermal: Option<Thermal>,
    /// If true, a temperature outside the table of the compound uses the parameters of the nearest end.
    pub hold_ends: bool,
    /// Softening of virgin rubber.
    pub softening: Option<Softening>,
    /// Area A of the bearing: force is A τ; 1 for a law of stress.
    pub area: f64,
    /// Height h of the rubber: displacement is h γ; 1 for a law of strain.
    pub height: f64,
}

crate::state_struct! {
    /// History of [`HdrRheology`]; the modal amplitudes of heat flow follow it.
    pub struct History {
        /// Shear strain γ.
        strain: f64,
        /// Strain of the equilibrium slider, γ_s1.
        slip_eq: f64,
        /// Strain of the elasto-plastic part of the overstress branch, γ_b.
        gamma_b: f64,
        /// Strain of its slider, γ_s2.
        slip_oe: f64,
        /// Mean temperature of the rubber.
        temperature: f64,
        /// Elastic energy per volume.
        stored: f64,
        /// Generated heat per volume.
        heat: f64,
        /// Strain γₘ of the softening.
        peak: f64,
        /// All-time largest strain.
        ever: f64,
        /// Equilibrium stress τ_e.
        equilibrium: f64,
        /// Overstress τ_oe.
        overstress: f64,
    }
}

/// A state with its derivatives with respect to the strain at the end of the step.
#[derive(Clone, Copy, Debug)]
struct TrialState {
    strain: Dual,
    slip_eq: Dual,
    gamma_b: Dual,
    slip_oe: Dual,
    temperature: Dual,
    stored: Dual,
    heat: Dual,
    peak: Peak,
}

impl TrialState {
    fn new(h: &History) -> Self {
        Self {
            strain: Dual::constant(h.strain),
            slip_eq: Dual::constant(h.slip_eq),
            gamma_b: Dual::constant(h.gamma_b),
            slip_oe: Dual::constant(h.slip_oe),
            temperature: Dual::constant(h.temperature),
            stored: Dual::constant(h.stored),
            heat: Dual::constant(h.heat),
            peak: Peak { now: Dual::constant(h.peak), ever: h.ever },
        }
    }
}

/// The branches at one temperature.
struct Branches {
    c1: Dual,
    c2: Dual,
    c3: Dual,
    tau_cr: Dual,
    m: Dual,
    overstress: Branch,
}

impl Branches {
    fn new([c1, c2, c3, tau_cr, m, c1_oe, c2_oe, tau_cr_oe, a, n]: [Dual; 10]) -> Self {
        let overstress = Branch { c1: c1_oe, c2: c2_oe, tau_cr: tau_cr_oe, a, n };
        Self { c1, c2, c3, tau_cr, m, overstress }
    }

    /// Equilibrium stress (Eqs 3.4, 3.5, 3.7) and overstress (Eq 3.9).
    fn stress(&self, p: &TrialState) -> (Dual, Dual) {
        let power = self.c3 * p.strain.abs().powf(self.m);
        let spring = self.c2 * p.strain + if p.strain.value < 0.0 { -power } else { power };
        (self.c1 * (p.strain - p.slip_eq) + spring, self.overstress.stress(p.gamma_b, p.slip_oe))
    }

    /// Elastic energy per volume.
    fn stored(&self, p: &TrialState) -> Dual {
        let one = Dual::constant(1.0);
        let elastic = p.strain - p.slip_eq;
        let power = self.c3 / (self.m + one) * p.strain.abs().powf(self.m + one);
        0.5 * (self.c2 * p.strain * p.strain + self.c1 * elastic * elastic)
            + power
            + self.overstress.stored(p.gamma_b, p.slip_oe)
    }
}

/// Temperature rise that one set of parameters may cover, in degrees.
const MAX_TEMPERATURE_RISE: f64 = 1.0;
/// Maximum number of substeps that follow the temperature.
const MAX_SUBSTEPS: f64 = 64.0;
/// Maximum number of iterations for temperature and stress.
const MAX_ITERATIONS: usize = 30;
/// Tolerance of temperature and its derivative in the iterations, relative to 1 + |temperature|.
const TEMPERATURE_TOLERANCE: f64 = 1e-11;

impl HdrRheology {
    /// A law of stress and strain for a compound at a temperature, without self-heating or softening.
    pub fn new(compound: Compound, ambient: f64) -> Self {
        let (thermal, softening) = (None, None);
        Self { compound, ambient, thermal, hold_ends: false, softening, area: 1.0, height: 1.0 }
    }

    /// Strains after `time` at constant parameters, and the centroid of the heat generation in time.
    fn mechanics(
        &self,
        old: &TrialState,
        law: &Branches,
        strain: Dual,
        time: f64,
    ) -> MaterialResult<(TrialState, f64)> {
        let mut slip_eq = old.slip_eq;
        let trial = law.c1 * (strain - slip_eq);
        if trial.value.abs() > law.tau_cr.value && law.c1.value > 0.0 {
            slip_eq = strain - sign(trial.value) * (law.tau_cr / law.c1);
        }
        let sliding = law.tau_cr * (slip_eq - old.slip_eq).abs();
        let flow = law.overstress.flow((old.gamma_b, old.slip_oe), strain - old.strain, time)?;
        // Springs release energy if the temperature lowers their stiffness.
        let before = law.stored(old);
        let mut new = TrialState { strain, slip_eq, gamma_b: flow.b, slip_oe: flow.slip, ..*old };
        new.stored = law.stored(&new);
        new.heat = old.stored - before + sliding + flow.heat;
        let whole = sliding.value + flow.heat.value;
        let centre = if whole > 0.0 { (0.5 * time * sliding.value + flow.moment) / whole } else { 0.5 * time };
        Ok((new, centre))
    }

    /// Parameters at a temperature.
    fn parameters(&self, temperature: Dual) -> MaterialResult<[Dual; 10]> {
        if self.thermal.is_some() && !self.hold_ends {
            self.compound.at(temperature.value).map_err(|e| MaterialError(format!("HDRRheology: {e}")))?;
        }
        Ok(self.compound.held(temperature))
    }

    /// One substep.
    fn substep(&self, old: &TrialState, strain: Dual, time: f64, modes: &mut [f64]) -> MaterialResult<TrialState> {
        let peak = self.softening.map_or(old.peak, |s| s.advance(old.peak, strain, time));
        let (before, after) = (self.factor(old.peak), self.factor(peak));
        let mut end = old.temperature;
        let mut iterations = 0;
        loop {
            let law = Branches::new(self.parameters(0.5 * (old.temperature + end))?);
            let (mut new, centre) = self.mechanics(old, &law, strain, time)?;
            if self.thermal.is_some() {
                let stored = Branches::new(self.parameters(end)?).stored(&new);
                new.heat = new.heat + new.stored - stored;
                new.stored = stored;
            }
            if self.softening.is_some() {
                // The factor scales heat as it scales stress; softening turns stored energy into heat.
                let (lost, energy) = (before - after, 0.5 * (old.stored + new.stored));
                new.heat = 0.5 * (before + after) * new.heat;
                if lost.value > 0.0 {
                    new.heat = new.heat + energy * lost;
                }
            }
            let found = match &self.thermal {
                Some(thermal) => {
                    let (rise, slope, left) = thermal.after(modes, new.heat.value, centre, time);
                    Dual { value: self.ambient + rise, slope: left * old.temperature.slope + slope * new.heat.slope }
                }
                None => end,
            };
            let change = (found.value - end.value).abs() + (found.slope - end.slope).abs();
            iterations += 1;
            // The slope is part of the criterion, because the tangent needs a converged derivative.
            if change <= TEMPERATURE_TOLERANCE * (1.0 + end.value.abs()) || iterations == MAX_ITERATIONS {
                if let Some(thermal) = &self.thermal {
                    thermal.advance(modes, new.heat.value, centre, time);
                }
                let heat = old.heat + new.heat;
                return Ok(TrialState { temperature: found, heat, peak, ..new });
            }
            end = found;
        }
    }

    /// A step in `parts` substeps. Returns the state and the largest temperature change of a substep.
    fn integrate(
        &self,
        old: &TrialState,
        strain: Dual,
        time: f64,
        substeps: f64,
        modes: &mut [f64],
    ) -> MaterialResult<(TrialState, f64)> {
        let (mut point, mut largest_rise) = (*old, 0.0f64);
        for i in 1..=substeps as usize {
            let share = i as f64 / substeps;
            let to = (1.0 - share) * old.strain + share * strain;
            let next = self.substep(&point, to, time / substeps, modes)?;
            largest_rise = largest_rise.max((next.temperature.value - point.temperature.value).abs());
            point = next;
        }
        Ok((point, largest_rise))
    }

    /// Softening factor on all stresses.
    fn factor(&self, peak: Peak) -> Dual {
        self.softening.map_or(Dual::constant(1.0), |s| s.factor(peak.now))
    }

    /// Number of cells with a temperature.
    pub fn heat_cells(&self) -> usize {
        self.thermal.as_ref().map_or(1, Thermal::cells)
    }

    /// Heat in the bearing per volume of rubber, from the modal amplitudes.
    pub fn heat_content(&self, amplitudes: &[f64]) -> f64 {
        self.thermal.as_ref().map_or(0.0, |t| t.content(amplitudes))
    }

    /// Temperatures through the height, from the mean temperature rise of the rubber and the modal amplitudes.
    pub fn temperatures(&self, rise: f64, amplitudes: &[f64], out: &mut [f64]) {
        for (i, o) in out.iter_mut().enumerate() {
            *o = self.ambient + self.thermal.as_ref().map_or(rise, |t| t.layer(amplitudes, i));
        }
    }

    /// Factor from work per volume to work of force and displacement.
    fn volume(&self) -> f64 {
        self.area * self.height
    }
}

/// Responses besides the temperatures.
const RESPONSES: [Response<HdrRheology, Shown>; 9] = [
    Response::new(&["temperature"], &["temperature"], |_, s, out| out[0] = s.history.temperature),
    Response::new(&["equilibrium"], &["equilibrium"], |law, s, out| out[0] = law.area * s.history.equilibrium),
    Response::new(&["overstress"], &["overstress"], |law, s, out| out[0] = law.area * s.history.overstress),
    Response::new(&["heat"], &["heat"], |law, s, out| out[0] = law.volume() * s.history.heat),
    Response::new(&["stored"], &["stored"], |law, s, out| out[0] = law.volume() * s.factor * s.history.stored),
    Response::new(&["heatStored"], &["heatStored"], |law, s, out| out[0] = law.volume() * s.content),
    Response::new(&["heatLost"], &["heatLost"], |law, s, out| out[0] = law.volume() * (s.history.heat - s.content)),
    Response::new(&["factor"], &["factor"], |_, s, out| out[0] = s.factor),
    Response::new(&["dashpotStrain"], &["dashpotStrain"], |_, s, out| out[0] = s.history.strain - s.history.gamma_b),
];
/// The temperatures through the height.
const PROFILE: u32 = RESPONSES.len() as u32;

/// A state with its heat content and the factor of softening.
struct Shown {
    history: History,
    content: f64,
    factor: f64,
}

impl Uniaxial for HdrRheology {
    updates_each_point! {}
    fn name(&self) -> &'static str {
        "HDRRheology"
    }
    fn state_len(&self) -> usize {
        History::LEN + self.thermal.as_ref().map_or(0, Thermal::len)
    }
    fn init(&self, state: &mut [f64]) {
        state.fill(0.0);
        let peak = self.softening.map_or(0.0, |s| s.virgin().ever);
        History { temperature: self.ambient, peak, ever: peak, ..History::default() }.write(state);
    }
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        let old = TrialState::new(&History::read(committed));
        let gamma = Dual { value: strain.value / self.height, slope: 1.0 };
        // Negative steps of LoadControl remove a load, and they take time too.
        let time = strain.dt.abs();
        let mut substeps = 1.0;
        let (words, modes) = next.split_at_mut(History::LEN);
        let point = loop {
            modes.copy_from_slice(&committed[History::LEN..History::LEN + modes.len()]);
            let (point, rise) = self.integrate(&old, gamma, time, substeps, modes)?;
            if rise <= MAX_TEMPERATURE_RISE || substeps >= MAX_SUBSTEPS {
                break point;
            }
            substeps = (substeps * rise / MAX_TEMPERATURE_RISE).ceil().clamp(2.0 * substeps, MAX_SUBSTEPS);
        };
        let (equilibrium, overstress) = Branches::new(self.parameters(point.temperature)?).stress(&point);
        let factor = self.factor(point.peak);
        let (equilibrium, overstress) = (factor * equilibrium, factor * overstress);
        History {
            strain: point.strain.value,
            slip_eq: point.slip_eq.value,
            gamma_b: point.gamma_b.value,
            slip_oe: point.slip_oe.value,
            temperature: point.temperature.value,
            stored: point.stored.value,
            heat: point.heat.value,
            peak: point.peak.now.value,
            ever: point.peak.ever,
            equilibrium: equilibrium.value,
            overstress: overstress.value,
        }
        .write(words);
        let stress = equilibrium + overstress;
        if !stress.value.is_finite() || !stress.slope.is_finite() {
            return Err(MaterialError(format!("HDRRheology has no stress at a strain of {:.6e}", gamma.value)));
        }
        let tangent = self.area / self.height * stress.slope;
        Ok(Stress { value: self.area * stress.value, tangent, damping: 0.0 })
    }
    fn initial_tangent(&self) -> f64 {
        let factor = self.softening.map_or(1.0, |s| s.factor(s.virgin().now).value);
        let p = self.compound.held(Dual::constant(self.ambient)).map(|x| x.value);
        let tangent = Parameters::new(p).map_or(0.0, |p| p.initial_tangent());
        self.area / self.height * factor * tangent
    }
    fn traits(&self) -> UniaxialTraits {
        UniaxialTraits { elapses: true, ..UniaxialTraits::default() }
    }
    fn roles(&self) -> UniaxialRoles<'_> {
        UniaxialRoles { responses: Some(self), ..UniaxialRoles::default() }
    }
}

impl LawResponses for HdrRheology {
    fn probe(&self, words: &[&str]) -> Option<Probe> {
        match *words.first()? {
            "temperatures" => Some(Probe::new(PROFILE, (1..=self.heat_cells()).map(|i| format!("temperature{i}")))),
            word => Response::find(&RESPONSES, word),
        }
    }
    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        let history = History::read(state);
        let modes = &state[History::LEN..self.state_len()];
        if path[0] == PROFILE {
            return self.temperatures(history.temperature - self.ambient, modes, out);
        }
        let factor = self.softening.map_or(1.0, |s| s.factor(Dual::constant(history.peak)).value);
        Response::read(&RESPONSES, path[0], self, &Shown { history, content: self.heat_content(modes), factor }, out);
    }
}
