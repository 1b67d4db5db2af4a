//! An element with an amended force.

mod opensees;
mod responses;
mod strength;

use super::slack::ForceAndTangent;
use super::{AmendedForce, Amendment, DeformationState, Pair, Slack, SlackShare};
use crate::element::inner::Inner;
use crate::element::roles::{ElementParameters, LawRange, Roles};
use crate::element::{
    BasicRow, CallDependent, Class, Element, ElementError, ElementInput, ElementOutput, ElementResult, ElementTraits,
    Histories, MAX_DOFS, MatrixMask, OpenSeesTraits, OutsideRange, Snapshot, dot,
};
use crate::parameter::{Changed, NewValue};
use crate::probe::Probe;
use crate::series::Series;
use responses::AmendedResponse;
use std::sync::Arc;

/// An element whose force is amended in one direction, or in two coupled directions.
///
/// Basic deformations are e = a·u with the rows a. The element's force in direction i is q_i = t_i·f, where t_i is the
/// part of a_i at node j. The amended force is f + Σ a_i (q'_i - q_i). Moments of a shear force therefore change with
/// that shear force.
///
/// With [`Slack`] the element is evaluated at e - s, the deformation without the slack. All of its forces, moments of
/// the axial force included, are those at e - s.
///
/// An element that counts its calls keeps the tangent of its last call among the state variables: n x n, after those of
/// the law. With slack such an element is evaluated several times in a call.
#[derive(Clone, Debug)]
pub struct Amended {
    inner: Inner,
    law: Arc<dyn Amendment>,
    rows: Vec<BasicRow>,
    axial: Compression,
    /// Initial stiffness in the directions.
    stiffness: Pair,
    /// The force of the inner element depends on the number of calls.
    counts_calls: bool,
    /// Responses of the element that are amended when they are read.
    responses: Vec<AmendedResponse>,
}

/// Source of the axial compression that a law depends on.
#[derive(Clone, Debug)]
enum Compression {
    /// No compression.
    None,
    /// Compression from the element's force in a direction.
    Force(BasicRow),
    /// Compression as a function of time, such as the record of a load cell.
    History(Series),
}

/// Number of state variables before those of the law: committed deformation, force that was added, withheld
/// deformation; two of each. Then a factor of strength, and the hysteretic force that it had before.
const HEADER_LEN: usize = 9;
const WITHHELD_AT: usize = 4;
const STRENGTH_AT: usize = 6;
/// Row of the axial force among those of the two directions.
const AXIAL_ROW: usize = 2;

/// The error for a direction that cannot be amended.
fn no_direction(inner: &dyn Element, direction: usize, has: &[BasicRow]) -> ElementError {
    let known: Vec<String> = has.iter().map(|r| r.direction.to_string()).collect();
    let known = if known.is_empty() { "none that can be amended".into() } else { known.join(" ") };
    ElementError(format!("{} has no direction {direction}; it has {known}", inner.class().name).into())
}

impl Amended {
    /// Amends an element in one or two of its directions; without `directions`, in all of its shear directions.
    ///
    /// # Errors
    /// A direction that the element does not have; more than two directions.
    pub fn new(inner: Arc<dyn Element>, law: Arc<dyn Amendment>, directions: &[usize]) -> ElementResult<Self> {
        let has = inner.basic_rows();
        let find = |direction: usize| has.iter().find(|r| r.direction == direction);
        let shear: Vec<usize>;
        let chosen = if directions.is_empty() {
            // An element without shear directions is amended along its axis.
            shear = [2, 3].into_iter().filter(|d| find(*d).is_some()).collect();
            if shear.is_empty() { &[1][..] } else { &shear }
        } else {
            directions
        };
        let rows = chosen
            .iter()
            .map(|d| find(*d).cloned().ok_or_else(|| no_direction(inner.as_ref(), *d, &has)))
            .collect::<Result<Vec<_>, _>>()?;
        if rows.len() > 2 {
            return Err(ElementError("at most two directions are amended together".into()));
        }
        let axial = find(1).filter(|_| !chosen.contains(&1)).cloned().map_or(Compression::None, Compression::Force);
        let responses = responses::amended(inner.as_ref(), &rows);
        let counts_calls = inner.opensees().calls.is_some();
        let new = Self { law, rows, axial, stiffness: [0.0; 2], responses, counts_calls, inner: Inner::new(inner) };
        Ok(Self { stiffness: new.initial_stiffness(), ..new })
    }

    /// Takes the axial force from another direction than the first, for example the vertical one of springs along
    /// global axes. With `reversed`, a negative deformation of that direction is tension.
    ///
    /// # Errors
    /// A direction that the element does not have, or that is amended.
    pub fn with_axial(self, direction: usize, reversed: bool) -> ElementResult<Self> {
        let has = self.inner.basic_rows();
        if self.rows.iter().any(|r| r.direction == direction) {
            return Err(ElementError(format!("direction {direction} is amended itself").into()));
        }
        let row = has.iter().find(|r| r.direction == direction).cloned();
        let row = row.ok_or_else(|| no_direction(self.inner.as_ref(), direction, &has))?;
        let row = if reversed { row.reversed() } else { row };
        Ok(Self { axial: Compression::Force(row), ..self })
    }

    /// Takes the compression from a function of time instead of the element's axial force.
    #[must_use]
    pub fn with_axial_history(self, compression: Series) -> Self {
        Self { axial: Compression::History(compression), ..self }
    }

    /// Initial stiffness of the element in each amended direction, force per deformation.
    pub fn initial_stiffness(&self) -> Pair {
        let n = self.inner.dofs();
        let mut k = vec![0.0; n * n];
        self.inner.initial_tangent(&mut k);
        let mut out = [0.0; 2];
        for (out, row) in out.iter_mut().zip(&self.rows) {
            // A unit deformation of this direction by node j alone.
            let unit = row.at_j();
            *out = k.chunks_exact(n).zip(unit).map(|(k, t)| t * dot(k, unit)).sum();
        }
        out
    }

    fn deformation_state(&self, motion: &ElementInput<'_>, force: &[f64], before: Pair) -> DeformationState {
        let mut d = DeformationState { before, dt: motion.dt, time: motion.time, ..DeformationState::default() };
        for (i, row) in self.rows.iter().enumerate() {
            d.e[i] = row.deformation(motion.disp);
            d.q[i] = row.force(force);
        }
        d.axial = match &self.axial {
            Compression::None => 0.0,
            Compression::Force(row) => -row.force(force),
            Compression::History(compression) => compression.factor(motion.time),
        };
        d
    }

    /// Turns the tangent of the element into that of the amended force.
    fn add_tangent(&self, v: &AmendedForce, tangent: &mut [f64]) {
        let n = self.inner.dofs();
        // Rows of the element's tangent that belong to q_1, q_2 and the axial force.
        let mut by_u = [[0.0; MAX_DOFS]; 3];
        for (row, out) in self.rows.iter().zip(&mut by_u) {
            row.force_by_disp(tangent, &mut out[..n]);
        }
        if let Compression::Force(row) = &self.axial {
            row.force_by_disp(tangent, &mut by_u[AXIAL_ROW][..n]);
        }
        for (i, row) in self.rows.iter().enumerate() {
            let mut change = [0.0; MAX_DOFS];
            for (c, change) in change[..n].iter_mut().enumerate() {
                for (j, (other, by_u)) in self.rows.iter().zip(&by_u).enumerate() {
                    let unit = f64::from(u8::from(i == j));
                    *change += (v.by_force[i][j] - unit) * by_u[c] + v.by_deformation[i][j] * other.row[c];
                }
                *change -= v.by_axial[i] * by_u[AXIAL_ROW][c];
            }
            for (t, a) in tangent.chunks_exact_mut(n).zip(&row.row) {
                t.iter_mut().zip(&change[..n]).for_each(|(t, c)| *t += a * c);
            }
        }
    }

    /// Displacements with the deformations `by` subtracted at node j.
    fn element_displacements(&self, disp: &[f64], by: Pair) -> [f64; MAX_DOFS] {
        let mut out = [0.0; MAX_DOFS];
        out[..disp.len()].copy_from_slice(disp);
        for (row, s) in self.rows.iter().zip(by) {
            out.iter_mut().zip(row.at_j()).for_each(|(d, t)| *d -= s * t);
        }
        out
    }

    /// Multiplies the tangent by ∂(element displacements)/∂u, if the element gets 1 - `part` of the amended
    /// deformations.
    fn withhold(&self, part: f64, tangent: &mut [f64]) {
        for row in tangent.chunks_exact_mut(self.inner.dofs()) {
            let by: Pair = std::array::from_fn(|i| self.rows.get(i).map_or(0.0, |r| part * dot(row, r.at_j())));
            for (r, by) in self.rows.iter().zip(by) {
                row.iter_mut().zip(&r.row).for_each(|(t, a)| *t -= by * a);
            }
        }
    }

    /// Derivatives of the forces in the amended directions with respect to their deformations.
    fn by_deformation(&self, tangent: &[f64]) -> [Pair; 2] {
        let n = self.inner.dofs();
        let mut out = [[0.0; 2]; 2];
        for (row, out) in self.rows.iter().zip(&mut out) {
            let mut by_u = [0.0; MAX_DOFS];
            row.force_by_disp(tangent, &mut by_u[..n]);
            for (other, out) in self.rows.iter().zip(out) {
                *out = dot(&by_u[..n], other.at_j());
            }
        }
        out
    }

    /// The slack deformation s of a trial state, with derivatives.
    fn solve_slack(
        &self,
        slack: &Slack,
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
    ) -> ElementResult<SlackShare> {
        let n = self.inner.dofs();
        let mut e = [0.0; 2];
        e.iter_mut().zip(&self.rows).for_each(|(e, row)| *e = row.deformation(motion.disp));
        slack.solve(e, |by| -> ElementResult<ForceAndTangent> {
            let (mut force, mut tangent) = ([0.0; MAX_DOFS], [0.0; MAX_DOFS * MAX_DOFS]);
            let disp = self.element_displacements(motion.disp, by);
            let mut output = ElementOutput {
                force: &mut force[..n],
                tangent: Some(&mut tangent[..n * n]),
                damping: None,
                part: MatrixMask::ALL,
            };
            self.respond_inner(&ElementInput { disp: &disp[..n], ..*motion }, h, &mut output)?;
            let mut q = [0.0; 2];
            q.iter_mut().zip(&self.rows).for_each(|(q, row)| *q = row.force(&force[..n]));
            Ok((q, self.by_deformation(&tangent[..n * n])))
        })
    }

    /// Terms that the tangent of the amended force lacks if slack takes a part of the displacements of node j.
    ///
    /// For each direction: derivatives of the other end forces, such as moments of the axial force, by the slack s;
    /// then ∂s/∂u.
    fn shifts(
        &self,
        slack: &Slack,
        slack_share: &SlackShare,
        tangent: &[f64],
    ) -> [([f64; MAX_DOFS], [f64; MAX_DOFS]); 2] {
        let n = self.inner.dofs();
        let k = self.by_deformation(tangent);
        let mut by_u = [[0.0; MAX_DOFS]; 2];
        for (row, out) in self.rows.iter().zip(&mut by_u) {
            row.force_by_disp(tangent, &mut out[..n]);
            // Slack depends on the force without the elastic part.
            out.iter_mut().zip(&row.row).for_each(|(d, a)| *d -= slack.stiffness * a);
        }
        let mut out = [([0.0; MAX_DOFS], [0.0; MAX_DOFS]); 2];
        for (i, (row, (by_shift, shift))) in self.rows.iter().zip(&mut out).enumerate() {
            for (f, t) in by_shift.iter_mut().zip(tangent.chunks_exact(n)) {
                *f = dot(t, row.at_j());
            }
            for (j, other) in self.rows.iter().enumerate() {
                by_shift.iter_mut().zip(&other.row).for_each(|(f, a)| *f -= a * k[j][i]);
                let follows = slack_share.flexibility[i] * slack_share.follows[i][j];
                shift.iter_mut().zip(&by_u[j]).for_each(|(s, d)| *s += follows * d);
            }
        }
        out
    }

    fn law_at(&self) -> usize {
        self.inner.len() + HEADER_LEN
    }

    /// Force and tangent of the amended element.
    fn respond_amended(
        &self,
        motion: &ElementInput<'_>,
        h: &mut Histories<'_>,
        mut output: ElementOutput<'_>,
    ) -> ElementResult {
        // The correction below reads every entry of the tangent.
        if let Some(tangent) = output.tangent.as_deref_mut() {
            tangent.fill(0.0);
        }
        let (mut inner, mut own) = h.split_at(self.inner.len());
        let law_range = HEADER_LEN..HEADER_LEN + self.law.state_len();
        let before = [own.committed[0], own.committed[1]];
        let slack = self.law.slack(&own.committed[law_range.clone()], motion.dt);
        let weakening = self.law.weakening(&own.committed[law_range.clone()]).filter(|_| slack.is_none());
        let slack_share =
            slack.as_ref().map(|slack| self.solve_slack(slack, motion, &mut inner)).transpose()?.unwrap_or_default();
        let withheld =
            weakening.as_ref().map_or(slack_share.by, |w| self.withheld_by_strength(w, own.committed, motion));
        let disp = self.element_displacements(motion.disp, withheld);
        self.respond_inner(&ElementInput { disp: &disp[..motion.disp.len()], ..*motion }, &mut inner, &mut output)?;
        let deformation_state =
            DeformationState { slack: slack_share, ..self.deformation_state(motion, output.force, before) };
        let v = match weakening {
            Some(w) => {
                if let Some(tangent) = output.tangent.as_deref_mut() {
                    self.withhold(w.withheld_part(), tangent);
                }
                // The law gets the elastic part at the total deformation.
                let at_total = DeformationState {
                    q: std::array::from_fn(|i| deformation_state.q[i] + w.stiffness * withheld[i]),
                    ..deformation_state
                };
                let mut v = self.law.amend(&mut own.part(law_range), &at_total)?;
                for (by_e, by_q) in v.by_deformation.iter_mut().zip(&v.by_force) {
                    by_e.iter_mut().zip(by_q).for_each(|(e, q)| *e += q * w.stiffness * w.withheld_part());
                }
                v
            }
            None => self.law.amend(&mut own.part(law_range), &deformation_state)?,
        };
        own.trial[..2].copy_from_slice(&deformation_state.e);
        own.trial[WITHHELD_AT..STRENGTH_AT].copy_from_slice(&withheld);
        strength::note(weakening.as_ref(), &deformation_state, withheld, own.trial);
        for (i, row) in self.rows.iter().enumerate() {
            let added = v.q[i] - deformation_state.q[i];
            own.trial[2 + i] = added;
            output.force.iter_mut().zip(&row.row).for_each(|(f, a)| *f += added * a);
        }
        if let Some(tangent) = output.tangent {
            let shifts = slack.map(|slack| self.shifts(&slack, &deformation_state.slack, tangent));
            self.add_tangent(&v, tangent);
            for (by_shift, shift) in shifts.iter().flatten() {
                for (t, f) in tangent.chunks_exact_mut(self.inner.dofs()).zip(by_shift) {
                    t.iter_mut().zip(shift).for_each(|(t, s)| *t -= f * s);
                }
            }
        }
        Ok(())
    }
}

crate::watches_columns!(Amended => |s| at [(0..s.inner.len(), &**s.inner)]);

#[deny(clippy::missing_trait_methods)]
impl Element for Amended {
    fn class(&self) -> Class {
        self.inner.class()
    }
    fn dofs(&self) -> usize {
        self.inner.dofs()
    }
    fn state_len(&self) -> usize {
        self.tangent_at() + self.tangent_len()
    }
    fn init(&self, state: &mut [f64]) {
        self.inner.init(&mut state[..self.inner.len()]);
        state[self.inner.len()..self.law_at()].fill(0.0);
        let (law, tangent) = state[self.law_at()..].split_at_mut(self.law.state_len());
        self.law.init(law);
        if !tangent.is_empty() {
            tangent.fill(0.0);
            self.initial_tangent(tangent);
        }
    }
    fn traits(&self) -> ElementTraits {
        let inner = self.inner.traits();
        let elapses = inner.elapses || self.law.depends_on_time() || matches!(self.axial, Compression::History(_));
        ElementTraits { linear: false, symmetric: false, elapses, ..inner }
    }

    fn respond(&self, motion: &ElementInput<'_>, h: &mut Histories<'_>, output: ElementOutput<'_>) -> ElementResult {
        if !self.counts_calls {
            return self.respond_amended(motion, h, output);
        }
        let mut tangent = [0.0; MAX_DOFS * MAX_DOFS];
        let tangent = &mut tangent[..self.tangent_len()];
        let ElementOutput { force, tangent: tangent_out, damping, part } = output;
        let stored = ElementOutput { force, tangent: Some(&mut *tangent), damping, part };
        self.respond_amended(motion, h, stored)?;
        h.trial[self.tangent_at()..].copy_from_slice(tangent);
        if let Some(tangent_out) = tangent_out {
            tangent_out.copy_from_slice(tangent);
        }
        Ok(())
    }

    fn initial_tangent(&self, tangent: &mut [f64]) {
        self.inner.initial_tangent(tangent);
        let mut next = vec![0.0; self.law.state_len()];
        let mut virgin = next.clone();
        self.law.init(&mut virgin);
        // Loss of strength does not change the initial stiffness.
        if self.law.weakening(&virgin).is_some() {
            return;
        }
        let slack = self.law.slack(&virgin, 0.0).map(|s| s.at_rest(&self.by_deformation(tangent))).unwrap_or_default();
        let h = &mut Histories { committed: &virgin, trial: &mut next };
        if let Ok(v) = self.law.amend(h, &DeformationState { slack, ..DeformationState::default() }) {
            self.add_tangent(&v, tangent);
        }
    }

    fn commit(&self, trial: &[f64], committed: &mut [f64]) {
        self.inner.commit(trial, committed);
    }
    fn roles(&self) -> Roles<'_> {
        let inner = self.inner.roles(self);
        let calls = self.counts_calls.then_some(self as &dyn CallDependent);
        Roles { outside_range: Some(self), opensees: OpenSeesTraits { calls, ..inner.opensees }, ..inner }
    }

    fn probe(&self, words: &[&str]) -> Option<Probe> {
        self.inner.probe(words)
    }
    fn probe_names(&self) -> Vec<&'static str> {
        self.inner.probe_names()
    }
    // Paths equal those of the element, so recorders from before the amendment stay valid.
    fn read(&self, path: &[u32], s: &Snapshot<'_>, out: &mut [f64]) {
        let (state, own) = s.state.split_at(self.inner.len());
        self.inner.read(path, &Snapshot { state, ..*s }, out);
        if let Some(response) = self.responses.iter().find(|r| r.path == path) {
            response.amend(own, out);
        }
    }
}

impl ElementParameters for Amended {
    fn with_parameter(&self, words: &[&str], value: NewValue) -> Changed<Arc<dyn Element>> {
        let (inner, old) = self.inner.with_parameter(words, value)?;
        let mut new = Self { inner: Inner::new(inner), ..self.clone() };
        let has = new.inner.basic_rows();
        for row in &mut new.rows {
            if let Some(renewed) = has.iter().find(|r| r.direction == row.direction) {
                row.clone_from(renewed);
            }
        }
        new.responses = responses::amended(new.inner.as_ref(), &new.rows);
        new.stiffness = new.initial_stiffness();
        // A law with the previous stiffness would leave the difference in parallel.
        if new.stiffness[0] != self.stiffness[0]
            && let Some(law) = self.law.with_stiffness(new.stiffness[0])
        {
            new.law = law;
        }
        Ok((Arc::new(new), old))
    }
}

impl LawRange for Amended {
    fn outside_range(&self, history: &[f64]) -> Option<OutsideRange> {
        let own = self.law.outside_range(&history[self.law_at()..self.law_at() + self.law.state_len()]);
        own.or_else(|| self.inner.outside_range(&history[..self.inner.len()]))
    }
}
