//! Panel of reinforced concrete with struts at fixed angles (Ulugtekin, 2010; Orakcal, Massone and Ulugtekin, 2012;
//! Kolozvari, Orakcal and Wallace, 2015, PEER 2015/12): `FSAM`.

use super::plain_methods::plain_methods;
use super::{Multiaxial, PLANE, Tangent};
use crate::material::{
    ConcreteCm, ConcreteHistory, Material, MaterialResult, MultiaxialResult, Slot, Strain, UniaxialLaw,
};
use crate::numeric::axpy;
use crate::probe::{Probe, Response};
use crate::state_struct;
use crate::state_struct::StateStruct;
use std::f64::consts::FRAC_PI_2;

/// A panel in plane stress: concrete that cracks in one direction and then in the other, and bars along both axes.
#[derive(Clone, Debug)]
pub struct Fsam {
    concrete: ConcreteCm,
    /// The envelopes of the concrete, before the first crack.
    uncracked: ConcreteCm,
    /// Bars along the axes; their histories follow those of the concrete.
    bars: [Slot; 2],
    parameters: FsamParameters,
}

/// Parameters of a panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FsamParameters {
    /// Mass per volume.
    pub rho: f64,
    /// Areas of the bars along x and y as shares of that of the concrete.
    pub ratios: [f64; 2],
    /// Coefficient of friction of the interlock in cracks.
    pub friction: f64,
    /// Shear stiffness of the bars as a share of their modulus (dowel action).
    pub dowel: f64,
}

/// Shear stiffness of a closed crack over the modulus of the concrete.
const INTERLOCK_STIFFNESS: f64 = 0.4;
/// Loss of stress across a direction that has reached its strain at the strength.
const DAMAGE: f64 = 0.4;
/// Coefficients of the softening under tension across (Vecchio and Collins, 1993, model B).
const SOFTENING: [f64; 2] = [0.27, 0.37];
/// Cracking angle that records show before a crack.
const UNCRACKED_ANGLE: f64 = 10.0;

state_struct! {
    /// Histories of the concrete in two orthogonal directions, and of the interlock in the crack across the first.
    pub(super) struct Strut {
        /// Histories along and across.
        concrete: [ConcreteHistory; 2],
        /// Smallest strains along and across.
        peaks: [f64; 2],
        /// Slip and shear stress of the crack.
        slip: [f64; 2],
    }
}

state_struct! {
    /// History of a panel.
    pub(super) struct PanelState {
        /// Number of cracks.
        cracks: f64,
        /// Direction normal to the first crack.
        angle: f64,
        /// Smallest strains in the principal directions before the first crack.
        peaks: [f64; 2],
        /// First crack and second.
        struts: [Strut; 2],
        /// Strains.
        strain: [f64; PLANE],
        /// Stresses of concrete and of bars.
        parts: [[f64; PLANE]; 2],
        /// Strain and stress of the concrete along and across the first crack's normal.
        shown: [[f64; 2]; 2],
    }
}

/// Stresses along, across and in shear of a pair of orthogonal directions, their derivatives, and what is recorded.
struct Local {
    stress: [f64; PLANE],
    tangent: Tangent<PLANE>,
    shown: [[f64; 2]; 2],
}

/// Derivatives of the strains along and across a direction, and of the shear angle, by the strains of the axes.
fn rotation(angle: f64) -> Tangent<PLANE> {
    let (s, c) = angle.sin_cos();
    [[c * c, s * s, s * c], [s * s, c * c, -s * c], [-2.0 * s * c, 2.0 * s * c, c * c - s * s]]
}

fn times(rows: &Tangent<PLANE>, e: &[f64; PLANE]) -> [f64; PLANE] {
    rows.each_ref().map(|row| row.iter().zip(e).map(|(r, e)| r * e).sum())
}

/// A direction at a right angle.
fn across(angle: f64) -> f64 {
    if angle < 0.0 { angle + FRAC_PI_2 } else { angle - FRAC_PI_2 }
}

/// Adds stresses and derivatives of rotated directions.
fn add(local: &Local, rotation: &Tangent<PLANE>, stress: &mut [f64; PLANE], tangent: &mut Tangent<PLANE>) {
    for ((turned, s), row) in rotation.iter().zip(local.stress).zip(&local.tangent) {
        axpy(s, turned, stress);
        let mut by_axes = [0.0; PLANE];
        row.iter().zip(rotation).for_each(|(k, r)| axpy(*k, r, &mut by_axes));
        turned.iter().zip(tangent.iter_mut()).for_each(|(r, out)| axpy(*r, &by_axes, out));
    }
}

impl Fsam {
    /// A panel of bars along x and y, given with their tags, and a concrete.
    pub fn new(bars: [(Material, i32); 2], concrete: ConcreteCm, parameters: FsamParameters) -> Self {
        let uncracked = ConcreteCm { monotonic: true, ..concrete.clone() };
        let [x, y] = bars;
        let x = Slot::new(x.0, x.1, PanelState::LEN);
        let y = Slot::new(y.0, y.1, PanelState::LEN + x.len());
        Self { concrete, uncracked, bars: [x, y], parameters }
    }

    /// Factor of a stress, its derivative by the strain across, and the smallest strain across.
    fn softening(&self, across: f64, stress: f64, peak: f64) -> (f64, f64, f64) {
        let epcc = self.concrete.compression.strain;
        let peak_now = peak.min(across);
        let share = (peak_now / epcc).min(1.0);
        let damage = 1.0 - DAMAGE * share;
        let by_damage = if across < peak && share < 1.0 { -DAMAGE / epcc } else { 0.0 };
        let soft = 1.0 / (1.0 + SOFTENING[0] * (-across / epcc - SOFTENING[1]));
        if soft > 1.0 || across < 0.0 || stress > 0.0 {
            return (damage, by_damage, peak_now);
        }
        (soft * damage, soft * soft * SOFTENING[0] / epcc * damage + soft * by_damage, peak_now)
    }

    /// Softened stresses along and across with their derivatives; the shear is left out.
    fn pair(
        &self,
        law: &ConcreteCm,
        strains: [f64; 2],
        histories: &[ConcreteHistory; 2],
        peaks: &mut [f64; 2],
    ) -> MaterialResult<(Local, [ConcreteHistory; 2])> {
        let mut local = Local { stress: [0.0; PLANE], tangent: [[0.0; PLANE]; PLANE], shown: [[0.0; 2]; 2] };
        let (mut next, before) = (*histories, *peaks);
        for i in 0..2 {
            let j = 1 - i;
            let (stress, history) = law.update(&histories[i], Strain { value: strains[i], ..Strain::default() })?;
            let (factor, slope, peak) = self.softening(strains[j], stress.value, before[j]);
            peaks[j] = peak;
            local.stress[i] = factor * stress.value;
            local.tangent[i][i] = factor * stress.tangent;
            local.tangent[i][j] = slope * stress.value;
            local.shown[i] = [strains[i], stress.value];
            next[i] = history;
        }
        Ok((local, next))
    }

    /// Concrete before the first crack, in the directions of the principal strains. The angle is theirs.
    fn uncracked(&self, e: &[f64; PLANE], peaks: &mut [f64; 2]) -> MaterialResult<(Local, f64, [f64; 2])> {
        let difference = e[0] - e[1];
        let angle = 0.5 * if e[2] == 0.0 && difference == 0.0 { FRAC_PI_2 } else { (e[2] / difference).atan() };
        let [along, beside, _] = times(&rotation(angle), e);
        let (mut local, _) = self.pair(&self.uncracked, [along, beside], &Default::default(), peaks)?;
        // The directions turn with the strains.
        local.tangent[2][2] = if along == beside {
            0.5 * local.tangent[0][0]
        } else {
            0.5 * (local.stress[0] - local.stress[1]) / (along - beside)
        };
        Ok((local, angle, [along, beside]))
    }

    /// Concrete with a crack across the direction `angle`.
    fn cracked(&self, angle: f64, e: &[f64; PLANE], strut: &mut Strut) -> MaterialResult<Local> {
        let [along, beside, slip] = times(&rotation(angle), e);
        let (mut local, histories) =
            self.pair(&self.concrete, [along, beside], &strut.concrete.clone(), &mut strut.peaks)?;
        strut.concrete = histories;
        let (stress, by_slip, by_normal) = self.interlock(local.stress[0], slip, strut.slip);
        strut.slip = [slip, stress];
        local.stress[2] = stress;
        let [to_along, to_across, _] = local.tangent[0];
        local.tangent[2] = [by_normal * to_along, by_normal * to_across, by_slip];
        Ok(local)
    }

    /// Shear stress in a crack, and its derivatives by the slip and the normal stress.
    fn interlock(&self, normal: f64, slip: f64, [before, stress]: [f64; 2]) -> (f64, f64, f64) {
        let open = if slip < before { normal > 0.0 } else { normal >= 0.0 };
        if open {
            return (0.0, 0.0, 0.0);
        }
        let stiffness = INTERLOCK_STIFFNESS * self.concrete.ec;
        let elastic = stress + stiffness * (slip - before);
        let (friction, limit) = (self.parameters.friction, -self.parameters.friction * normal);
        if slip >= before && elastic > limit {
            (limit, 0.0, -friction)
        } else if slip <= before && elastic < -limit {
            (-limit, 0.0, friction)
        } else {
            (elastic, stiffness, 0.0)
        }
    }

    /// Adds the stresses of the concrete with one crack or two.
    fn add_cracked(
        &self,
        e: &[f64; PLANE],
        state: &mut PanelState,
        (stress, tangent): (&mut [f64; PLANE], &mut Tangent<PLANE>),
    ) -> MaterialResult {
        let both = state.cracks > 1.0;
        let angles = [state.angle, across(state.angle)];
        for (i, angle) in angles.into_iter().enumerate().take(if both { 2 } else { 1 }) {
            let mut local = self.cracked(angle, e, &mut state.struts[i])?;
            if i == 0 {
                state.shown = local.shown;
            }
            if both {
                // The other crack's strut carries the stress in this direction.
                local.stress[0] = 0.0;
                local.tangent[0] = [0.0; PLANE];
            }
            add(&local, &rotation(angle), stress, tangent);
        }
        Ok(())
    }

    /// Adds the stresses of the bars, with the stiffness of dowels in each crack.
    fn add_bars(
        &self,
        bars: &[[f64; 2]; 2],
        cracks: f64,
        e: &[f64; PLANE],
        stress: &mut [f64; PLANE],
    ) -> Tangent<PLANE> {
        let mut tangent = [[0.0; PLANE]; PLANE];
        for i in 0..2 {
            stress[i] += self.parameters.ratios[i] * bars[i][0];
            tangent[i][i] = self.parameters.ratios[i] * bars[i][1];
        }
        let dowels =
            cracks * self.parameters.ratios[1] * self.parameters.dowel * self.bars[1].material.initial_tangent();
        stress[2] += dowels * e[2];
        tangent[2][2] = dowels;
        tangent
    }

    /// Stresses of the concrete in a state after its step, with the cracks that the step has opened.
    fn crack(
        &self,
        e: &[f64; PLANE],
        (angle, principal): (f64, [f64; 2]),
        state: &mut PanelState,
        concrete: &mut [f64; PLANE],
    ) -> MaterialResult {
        let opened = match state.cracks {
            0.0 => principal[0].max(principal[1]) >= self.concrete.tension.strain,
            // The strain along the first crack has left the envelope in tension.
            1.0 => state.struts[0].concrete[1].strain >= state.struts[0].concrete[1].high[0],
            _ => false,
        };
        if !opened {
            return Ok(());
        }
        if state.cracks == 0.0 {
            state.angle = if principal[0] >= principal[1] { angle } else { across(angle) };
            state.struts[0].peaks = state.peaks;
        }
        state.cracks += 1.0;
        *concrete = [0.0; PLANE];
        self.add_cracked(e, state, (concrete, &mut [[0.0; PLANE]; PLANE]))
    }
}

crate::watches_columns!(Fsam => |s| in &s.bars);

#[deny(clippy::missing_trait_methods)]
impl Multiaxial<PLANE> for Fsam {
    plain_methods! { PLANE: of_length }
    fn state_len(&self) -> usize {
        PanelState::LEN + self.bars.iter().map(Slot::len).sum::<usize>()
    }
    fn init(&self, state: &mut [f64]) {
        PanelState { angle: UNCRACKED_ANGLE, ..PanelState::default() }.write(state);
        self.bars.iter().for_each(|bar| bar.init(state));
    }
    fn is_linear(&self) -> bool {
        false
    }
    fn is_symmetric(&self) -> bool {
        false
    }
    fn depends_on_time(&self) -> bool {
        self.bars.iter().any(|bar| bar.material.depends_on_time())
    }
    fn density(&self) -> f64 {
        self.parameters.rho
    }
    fn reinforcement(&self) -> f64 {
        self.parameters.ratios[0]
    }

    fn update(&self, committed: &[f64], e: &[f64; PLANE], dt: f64, next: &mut [f64]) -> MultiaxialResult<PLANE> {
        let mut state = PanelState { strain: *e, ..PanelState::read(committed) };
        let (mut concrete, mut tangent) = ([0.0; PLANE], [[0.0; PLANE]; PLANE]);
        let mut principal = (0.0, [0.0; 2]);
        if state.cracks == 0.0 {
            let (local, angle, strains) = self.uncracked(e, &mut state.peaks)?;
            principal = (angle, strains);
            state.shown = local.shown;
            add(&local, &rotation(angle), &mut concrete, &mut tangent);
        } else {
            self.add_cracked(e, &mut state, (&mut concrete, &mut tangent))?;
        }
        let mut bars = [[0.0; 2]; 2];
        for (i, bar) in self.bars.iter().enumerate() {
            let stress = bar.update(committed, Strain { value: e[i], rate: 0.0, dt }, next)?;
            bars[i] = [stress.value, stress.tangent];
        }
        let mut steel = [0.0; PLANE];
        let stiffness = self.add_bars(&bars, state.cracks, e, &mut steel);
        let stress = std::array::from_fn(|i| concrete[i] + steel[i]);
        tangent.iter_mut().zip(&stiffness).for_each(|(out, row)| axpy(1.0, row, out));
        self.crack(e, principal, &mut state, &mut concrete)?;
        steel = [0.0; PLANE];
        self.add_bars(&bars, state.cracks, e, &mut steel);
        state.parts = [concrete, steel];
        state.write(next);
        Ok((stress, tangent))
    }

    fn initial_tangent(&self) -> Tangent<PLANE> {
        let ec = self.concrete.ec;
        let bar = |i: usize| self.parameters.ratios[i] * self.bars[i].material.initial_tangent();
        [[ec + bar(0), 0.0, 0.0], [0.0, ec + bar(1), 0.0], [0.0, 0.0, 0.5 * ec]]
    }

    fn shown_stress(&self, next: &[f64], _: [f64; PLANE]) -> [f64; PLANE] {
        let [concrete, steel] = PanelState::read(next).parts;
        std::array::from_fn(|i| concrete[i] + steel[i])
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        Response::find(&RESPONSES, &words.first()?.to_lowercase())
    }

    fn read(&self, path: &[u32], state: &[f64], out: &mut [f64]) {
        Response::read(&RESPONSES, path[0], self, state, out);
    }
}

const STRAINS: [&str; PLANE] = ["eps11", "eps22", "eps12"];
const STRESSES: [&str; PLANE] = ["sigma11", "sigma22", "sigma12"];
const PAIR: [&str; 2] = ["eps11", "sig11"];

const RESPONSES: [Response<Fsam>; 11] = [
    Response::new(&["panel_strain"], &STRAINS, |_, s, out| out.copy_from_slice(&PanelState::read(s).strain)),
    Response::new(&["panel_stress"], &STRESSES, |p, s, out| out.copy_from_slice(&p.shown_stress(s, [0.0; PLANE]))),
    Response::new(&["panel_stress_concrete"], &STRESSES, |_, s, out| {
        out.copy_from_slice(&PanelState::read(s).parts[0])
    }),
    Response::new(&["panel_stress_steel"], &STRESSES, |_, s, out| out.copy_from_slice(&PanelState::read(s).parts[1])),
    Response::new(&["strain_stress_steelx"], &PAIR, |p, s, out| p.show_bar(0, s, out)),
    Response::new(&["strain_stress_steely"], &PAIR, |p, s, out| p.show_bar(1, s, out)),
    Response::new(&["strain_stress_concrete1"], &PAIR, |_, s, out| out.copy_from_slice(&PanelState::read(s).shown[0])),
    Response::new(&["strain_stress_concrete2"], &PAIR, |_, s, out| out.copy_from_slice(&PanelState::read(s).shown[1])),
    Response::new(&["strain_stress_interlock1"], &PAIR, |_, s, out| {
        out.copy_from_slice(&PanelState::read(s).struts[0].slip);
    }),
    Response::new(&["strain_stress_interlock2"], &PAIR, |_, s, out| {
        out.copy_from_slice(&PanelState::read(s).struts[1].slip);
    }),
    Response::new(&["cracking_angles"], &["alpha", "beta"], |_, s, out| {
        let s = PanelState::read(s);
        out.copy_from_slice(&[s.angle, if s.cracks > 1.0 { across(s.angle) } else { UNCRACKED_ANGLE }]);
    }),
];

impl Fsam {
    /// Strain and stress of a bar.
    fn show_bar(&self, bar: usize, state: &[f64], out: &mut [f64]) {
        out.copy_from_slice(&[self.bars[bar].strain(state), self.bars[bar].stress(state)]);
    }
}
