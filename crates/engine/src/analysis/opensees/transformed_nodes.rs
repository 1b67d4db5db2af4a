//! Constrained nodes as OpenSees' `Transformation` handler moves them.
//!
//! A static integrator adds the motion of the equations. A transient one sets the motion of node after node in passes: displacements
//! grow by what the equations and the retained degrees of freedom have moved since the last pass, also if that belongs to a step
//! that has failed. Velocities and accelerations are those of the retained node at the moment. Where loads are applied, a node that is
//! [late](TransformedNode::late) goes to where the degrees of freedom without an equation take it.

use crate::analysis::state::State;
use crate::analysis::system::System;
use crate::assembly::{TransformedNode, TransformedRow};

/// Parts of a motion that a pass sets: displacements, velocities, accelerations.
pub type Parts = [bool; 3];

/// Part of a step, for what a change of the motion or of the loads does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::analysis) enum Phase {
    /// No step is made.
    Outside,
    /// The model or the integrator is new: what has been followed is the present motion.
    Preparation,
    /// The step begins: the first loads come after a pass that sets these parts.
    Begin(Parts),
    /// Loads and corrections.
    Within,
    /// The trial motion goes to the end of the step, by a pass.
    End,
}

/// The constrained nodes, and the motion that they have followed.
#[derive(Debug)]
pub(in crate::analysis) struct TransformedNodes {
    nodes: Vec<TransformedNode>,
    /// A degree of freedom is held: OpenSees moves late nodes with the loads only then.
    with_loads: bool,
    phase: Phase,
    /// Displacements, velocities and accelerations before the change at hand.
    before: [Vec<f64>; 3],
    /// Displacements of the retained degrees of freedom without an equation in the last pass; empty before the first step.
    followed: Vec<f64>,
    /// Displacements of a step that has failed, less the committed ones, which the next pass takes off.
    lost: Option<Vec<f64>>,
    /// What a pass of this step has taken off.
    taken_off: Option<Vec<f64>>,
}

/// Motion of the equations' degrees of freedom of a row.
fn of_equations(row: &TransformedRow, motion: impl Fn(usize) -> f64) -> f64 {
    row.equations.iter().map(|&(dof, c)| c * motion(dof)).sum()
}

/// Motion of the retained degrees of freedom without an equation.
fn of_retained(row: &TransformedRow, motion: impl Fn(usize) -> f64) -> f64 {
    row.retained.iter().map(|&(i, c)| c * motion(i)).sum()
}

impl TransformedNodes {
    /// For the constrained nodes of a plan, if there are any.
    pub(in crate::analysis) fn new(nodes: &[TransformedNode], with_loads: bool, dofs: usize) -> Option<Box<Self>> {
        let zeros = || vec![0.0; dofs];
        (!nodes.is_empty()).then(|| {
            Box::new(Self {
                nodes: nodes.to_vec(),
                with_loads,
                phase: Phase::Outside,
                before: [zeros(), zeros(), zeros()],
                followed: vec![],
                lost: None,
                taken_off: None,
            })
        })
    }

    fn late(&self) -> impl DoubleEndedIterator<Item = &TransformedNode> {
        self.nodes.iter().filter(|n| n.late)
    }

    /// The first degree of freedom that is moved late.
    pub(in crate::analysis) fn first_late(&self) -> Option<usize> {
        self.late().flat_map(|n| &n.rows).map(|r| r.dof).next()
    }

    /// After a step that has failed: the first degree of freedom of a node that is late, or follows one that follows another.
    /// How OpenSees goes on with these is not known.
    pub(in crate::analysis) fn first_astray(&self) -> Option<usize> {
        self.lost.as_ref()?;
        self.nodes.iter().filter(|n| n.late || n.chained).flat_map(|n| &n.rows).map(|r| r.dof).next()
    }

    /// The first degree of freedom of a node whose mass joins what no element joins.
    pub(in crate::analysis) fn first_joined_alone(&self) -> Option<usize> {
        self.nodes.iter().filter(|n| n.joins_alone).flat_map(|n| &n.rows).map(|r| r.dof).next()
    }

    /// Put late nodes where the degrees of freedom without an equation are; the greatest tag comes first. True if one has moved.
    fn follow_loads(&self, now: &mut State) -> bool {
        let mut moved = false;
        for node in self.late().rev() {
            for row in &node.rows {
                let place = of_retained(row, |i| now.disp[node.retained[i]]);
                moved |= now.disp[row.dof] != place;
                now.disp[row.dof] = place;
            }
        }
        moved
    }

    /// Set parts of the motion of the constrained nodes after those of the others, each in the order of the tags.
    fn pass(&mut self, now: &mut State, parts: Parts, held: &[bool]) {
        let lost = if parts[0] { self.lost.take() } else { None };
        let mut at = 0;
        for node in self.nodes.iter().filter(|n| n.late) {
            for (part, values) in [&mut now.disp, &mut now.vel, &mut now.accel].into_iter().enumerate() {
                let before = &self.before[part];
                if !parts[part] {
                    node.rows.iter().for_each(|r| values[r.dof] = before[r.dof]);
                    continue;
                }
                let seen: Vec<f64> =
                    node.retained.iter().map(|&r| if node.moves_first { before[r] } else { values[r] }).collect();
                let followed = &mut self.followed[at..at + seen.len()];
                for row in node.rows.iter().filter(|r| !held[r.dof]) {
                    values[row.dof] = if part == 0 {
                        let moved = of_equations(row, |dof| values[dof] - before[dof]);
                        before[row.dof] + moved + of_retained(row, |i| seen[i] - followed[i])
                    } else {
                        of_equations(row, |dof| values[dof]) + of_retained(row, |i| seen[i])
                    };
                }
                if part == 0 {
                    followed.copy_from_slice(&seen);
                }
            }
            at += node.retained.len();
        }
        if let Some(lost) = lost {
            for node in &self.nodes {
                for row in node.rows.iter().filter(|r| !held[r.dof]) {
                    now.disp[row.dof] -= of_equations(row, |dof| lost[dof]);
                }
                node.own.iter().filter(|&&dof| !held[dof]).for_each(|&dof| now.disp[dof] -= lost[dof]);
            }
            self.taken_off = Some(lost);
        }
    }

    /// A transient step has failed: what the last pass has followed stays.
    fn keep_lost(&mut self, trial: &State, committed: &State) {
        let taken_off = self.taken_off.take();
        if self.lost.is_some() {
            return;
        }
        let mut lost: Vec<f64> = trial.disp.iter().zip(&committed.disp).map(|(t, c)| t - c).collect();
        if let Some(taken_off) = taken_off {
            self.nodes.iter().flat_map(|n| &n.own).for_each(|&dof| lost[dof] += taken_off[dof]);
        }
        self.lost = Some(lost);
    }
}

impl System<'_> {
    /// Enter a phase of the step: constrained nodes follow what changes from here on.
    pub(in crate::analysis) fn enter_phase(&mut self, phase: Phase) {
        let Some(nodes) = &mut self.work.transformed else { return };
        nodes.phase = phase;
        let late = nodes.late().map(|n| n.retained.len()).sum();
        if phase == Phase::Preparation || nodes.followed.len() != late {
            nodes.followed = nodes.late().flat_map(|n| &n.retained).map(|&dof| self.new.disp[dof]).collect();
        }
        if matches!(phase, Phase::Begin(_)) {
            nodes.taken_off = None;
        }
        if late == 0 {
            return;
        }
        for (kept, part) in nodes.before.iter_mut().zip([&self.new.disp, &self.new.vel, &self.new.accel]) {
            kept.copy_from_slice(part);
        }
    }

    /// The step has failed, or is over.
    pub(in crate::analysis) fn leave_phases(&mut self, failed: bool) {
        let Some(nodes) = &mut self.work.transformed else { return };
        if failed && self.dynamic && nodes.phase != Phase::Outside && nodes.phase != Phase::Preparation {
            nodes.keep_lost(self.new, self.old);
        }
        nodes.phase = Phase::Outside;
    }

    /// Loads have been applied.
    pub(in crate::analysis) fn follow_loads(&mut self) {
        let work = &mut *self.work;
        let Some(nodes) = &mut work.transformed else { return };
        let held = &work.plan.map.held;
        match nodes.phase {
            Phase::Outside => return,
            Phase::Begin(parts) if self.dynamic => nodes.pass(self.new, parts, held),
            Phase::Begin(_) | Phase::Within | Phase::Preparation => {}
            Phase::End if self.dynamic => return nodes.pass(self.new, [true; 3], held),
            Phase::End => return,
        }
        if nodes.phase != Phase::Preparation {
            nodes.phase = Phase::Within;
        }
        self.moved |= nodes.with_loads && nodes.follow_loads(self.new);
    }

    /// An integrator has taken a correction.
    pub(in crate::analysis) fn follow_correction(&mut self) {
        let work = &mut *self.work;
        if let (Some(nodes), true) = (&mut work.transformed, self.dynamic) {
            nodes.pass(self.new, [true; 3], &work.plan.map.held);
        }
    }
}
