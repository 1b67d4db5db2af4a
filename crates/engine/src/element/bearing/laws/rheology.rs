//! Shear law of `HDRRheologyBearing`: the rheology of high damping rubber in two directions.

use crate::element::Class;
use crate::element::bearing::laws::axial::Axial;
use crate::element::bearing::laws::rubber_shear::{OWN, RubberShear, ShearInput, ShearStep};
use crate::element::bearing::laws::shear::Shear;
use crate::material::HdrRheology;
use crate::material::hdr::PlaneHistory;
use crate::probe::Probe;

/// The rheology with the axial law of layered rubber.
#[derive(Clone, Debug)]
pub struct RheologyShear {
    /// The law of the rubber, with area and thickness of the bearing.
    pub law: HdrRheology,
}

/// Own responses: name, columns, number.
const RESPONSES: [(&str, &[&str], u32); 7] = [
    ("temperature", &["temperature"], OWN),
    ("equilibrium", &["equilibrium2", "equilibrium3"], OWN + 1),
    ("overstress", &["overstress2", "overstress3"], OWN + 2),
    ("heat", &["heat"], OWN + 3),
    ("stored", &["stored"], OWN + 4),
    ("heatStored", &["heatStored"], OWN + 5),
    ("heatLost", &["heatLost"], OWN + 6),
];
/// Response of the temperatures through the height.
const PROFILE: u32 = OWN + 7;

impl RheologyShear {
    fn scaled(&self, stress: [f64; 2]) -> [f64; 2] {
        stress.map(|s| self.law.area * s)
    }
}

impl RubberShear for RheologyShear {
    type Memory = PlaneHistory;

    fn class(&self) -> Class {
        Class::own("HDRRheologyBearing")
    }

    fn depends_on_time(&self) -> bool {
        true
    }

    fn tail_len(&self) -> usize {
        self.law.heat_len()
    }

    fn advance(&self, from: &PlaneHistory, to: &PlaneHistory, dt: f64, tail: &mut [f64]) {
        self.law.plane_flow(from, to, dt, tail);
    }

    fn virgin(&self) -> (Shear<2>, PlaneHistory) {
        let k = self.law.area / self.law.height * self.law.plane_stiffness();
        (Shear { k: [[k, 0.0], [0.0, k]], ..Shear::default() }, self.law.plane_virgin())
    }

    fn step(&self, _: &Shear<2>, m: &PlaneHistory, _: &PlaneHistory, at: &ShearInput<'_>) -> ShearStep<PlaneHistory> {
        let step = self.law.plane_step(m, at.tail, at.u.map(|u| u / self.law.height), at.dt);
        let k = step.tangent.map(|row| row.map(|k| self.law.area / self.law.height * k));
        let shear = Shear { u: at.u, internal: step.next.slip_eq, q: self.scaled(step.stress), k };
        ShearStep { shear, memory: step.next, k_axial: [0.0; 2], damping: 0.0 }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        let word = *words.first()?;
        if word == "temperatures" {
            return Some(Probe::new(PROFILE, (1..=self.law.heat_cells()).map(|i| format!("temperature{i}"))));
        }
        let (_, columns, id) = RESPONSES.iter().find(|(name, ..)| *name == word)?;
        Some(Probe::new(*id, columns.iter().copied()))
    }

    fn probe_names(&self) -> &'static [&'static str] {
        &[
            "localForce",
            "basicForce",
            "localDisplacement",
            "deformation",
            "basicDeformation",
            "basicStiffness",
            "temperature",
            "equilibrium",
            "overstress",
            "heat",
            "stored",
            "heatStored",
            "heatLost",
            "temperatures",
        ]
    }

    fn read(&self, id: u32, _: &Shear<2>, m: &PlaneHistory, tail: &[f64], _: &Axial, out: &mut [f64]) {
        let volume = self.law.area * self.law.height;
        match id - OWN {
            0 => out[0] = self.law.ambient + m.rise,
            1 => out.copy_from_slice(&self.scaled(m.equilibrium)),
            2 => out.copy_from_slice(&self.scaled(m.overstress)),
            3 => out[0] = volume * m.heat,
            4 => out[0] = volume * m.stored,
            5 => out[0] = volume * self.law.heat_content(tail),
            6 => out[0] = volume * (m.heat - self.law.heat_content(tail)),
            _ => self.law.temperatures(m.rise, tail, out),
        }
    }
}
