//! Load patterns.

use super::{ElementId, GroundMotion, NodeId, Tag};
use crate::element::ElementLoad;
use crate::series::Series;
use std::collections::BTreeMap;

/// A force on a node.
#[derive(Clone, Debug, PartialEq)]
pub struct NodalLoad {
    /// Node.
    pub node: NodeId,
    /// Reference force of each degree of freedom.
    pub values: Vec<f64>,
    /// Does not follow the series.
    pub constant: bool,
}

/// A motion of the ground at a support.
#[derive(Clone, Debug)]
pub struct Ground {
    /// The motion.
    pub motion: GroundMotion,
    /// Velocity and acceleration are imposed too, and not the displacement alone.
    pub rates: bool,
}

/// A displacement imposed by a pattern.
#[derive(Clone, Debug)]
pub struct SupportMotion {
    /// Node.
    pub node: NodeId,
    /// Local degree of freedom, from 0.
    pub dof: usize,
    /// Reference displacement.
    pub value: f64,
    /// Does not follow the series.
    pub constant: bool,
    /// Displacement that the value is added to; zero by default.
    pub initial: f64,
    /// Number by which OpenSees' `remove sp` knows it.
    pub tag: Tag,
    /// Moves as the ground does, instead of as the series of the pattern.
    pub ground: Option<Ground>,
}

/// A uniform motion of all supports.
#[derive(Clone, Debug)]
pub struct Excitation {
    /// Direction, from 0: translations, then rotations.
    pub direction: usize,
    /// Ground acceleration.
    pub accel: Series,
    /// Multiplies the influence of the motion (`-fact`).
    pub influence: f64,
    /// Velocity of the model at the start (`-vel0`).
    pub initial_velocity: f64,
}

/// Kind of a pattern.
#[derive(Clone, Debug)]
pub enum PatternKind {
    /// Loads times a series and a constant factor.
    Plain {
        /// The series; `None` for one that is zero.
        series: Series,
        /// The constant factor (`-fact`).
        factor: f64,
    },
    /// Inertia forces of a uniform motion of the ground.
    Uniform(Excitation),
    /// Motions of the ground, by tag, that single supports follow.
    MultipleSupport(BTreeMap<Tag, GroundMotion>),
}

/// Source of the load factor of a pattern.
#[derive(Clone, Debug)]
pub enum Drive {
    /// It stays what it is.
    Held(f64),
    /// A series times a constant factor.
    Series(Series, f64),
    /// The acceleration of the ground, which rests before time zero.
    Ground(Series),
}

impl Drive {
    /// Returns true if another one has the same factor at all times.
    pub fn equals(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Held(own), Self::Held(other)) => own == other,
            (Self::Series(own, factor), Self::Series(other, by)) => factor == by && own.equals(&**other),
            (Self::Ground(own), Self::Ground(other)) => own.equals(&**other),
            _ => false,
        }
    }

    /// First and second derivative of the load factor at a time.
    #[inline]
    pub fn derivatives(&self, time: f64) -> [f64; 2] {
        match self {
            Self::Held(_) => [0.0; 2],
            Self::Series(series, factor) => series.derivatives(time).map(|rate| factor * rate),
            Self::Ground(accel) => {
                if time < 0.0 {
                    [0.0; 2]
                } else {
                    accel.derivatives(time)
                }
            }
        }
    }

    /// The load factor at a time.
    #[inline]
    pub fn factor(&self, time: f64) -> f64 {
        match self {
            Self::Held(factor) => *factor,
            Self::Series(series, factor) => factor * series.factor(time),
            Self::Ground(accel) => {
                if time < 0.0 {
                    0.0
                } else {
                    accel.factor(time)
                }
            }
        }
    }
}

/// A load pattern.
#[derive(Clone, Debug)]
pub struct Pattern {
    /// Its kind.
    pub kind: PatternKind,
    /// Forces on nodes.
    pub nodal_loads: Vec<NodalLoad>,
    /// Imposed displacements.
    pub motions: Vec<SupportMotion>,
    /// Loads on elements.
    pub element_loads: Vec<(ElementId, ElementLoad)>,
    /// Set by `loadConst`: the factor it had, or the time at which its motion stopped.
    pub held: Option<f64>,
}

impl Pattern {
    /// A pattern without loads.
    pub fn new(kind: PatternKind) -> Self {
        Self { kind, nodal_loads: vec![], motions: vec![], element_loads: vec![], held: None }
    }

    /// Returns true if there is more in it than imposed motions.
    pub fn has_loads(&self) -> bool {
        let inertia = matches!(self.kind, PatternKind::Uniform(_));
        inertia || !self.nodal_loads.is_empty() || !self.element_loads.is_empty()
    }

    /// Load factor at a time; for a uniform excitation the ground acceleration.
    pub fn factor(&self, time: f64) -> f64 {
        self.drive().factor(time)
    }

    /// Returns true if its loads grow when the time does: one more of the time changes their factor.
    pub fn grows(&self, time: f64) -> bool {
        self.has_loads() && self.factor(time + 1.0) != self.factor(time)
    }

    /// Source of its load factor.
    pub fn drive(&self) -> Drive {
        match (&self.kind, self.held) {
            (PatternKind::Plain { .. }, Some(factor)) => Drive::Held(factor),
            (PatternKind::Plain { series, factor }, None) => Drive::Series(series.clone(), *factor),
            (PatternKind::Uniform(e), None) => Drive::Ground(e.accel.clone()),
            (PatternKind::Uniform(e), Some(time)) => Drive::Held(Drive::Ground(e.accel.clone()).factor(time)),
            (PatternKind::MultipleSupport(_), _) => Drive::Held(0.0),
        }
    }

    /// Hold what it gives at this time.
    pub fn hold(&mut self, time: f64) {
        if self.held.is_none() {
            self.held = Some(match &self.kind {
                PatternKind::Plain { .. } => self.factor(time),
                PatternKind::Uniform(_) | PatternKind::MultipleSupport(_) => time,
            });
        }
    }

    /// Forget the loads and motions of a node.
    pub(super) fn remove_node(&mut self, node: NodeId) {
        self.nodal_loads.retain(|l| l.node != node);
        self.motions.retain(|m| m.node != node);
    }

    pub(super) fn nodes_mut(&mut self) -> impl Iterator<Item = &mut NodeId> {
        self.nodal_loads.iter_mut().map(|l| &mut l.node).chain(self.motions.iter_mut().map(|m| &mut m.node))
    }
}
