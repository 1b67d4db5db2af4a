//! Responses of nodes.

use super::{Group, Missing, RecordError, Source};
use crate::analysis::{Engine, ReactionKind, Recorded, State};
use crate::model::Tag;
use crate::series::Series;

/// Recorded quantity of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NodeQuantity {
    /// Displacement.
    Disp,
    /// Velocity.
    Vel,
    /// Acceleration, relative to the ground under a uniform excitation.
    Accel,
    /// Displacement of the last step. OpenSees writes zeros: it forgets it when the step is committed.
    IncrDisp,
    /// Force of the supports.
    Reaction(ReactionKind),
    /// Loads.
    Unbalance {
        /// Less inertia and mass-proportional damping of the node.
        inertia: bool,
    },
    /// Shape of a mode, from 1.
    Mode(usize),
    /// Shapes of all modes: a row of each.
    Modes,
    /// Derivative of a motion with respect to a parameter.
    Derivative(Motion, Tag),
    /// Length of the displacement over the chosen degrees of freedom: one column a node.
    DispNorm,
}

/// Motion of which there are derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// Displacement.
    Disp,
    /// Velocity.
    Vel,
    /// Acceleration.
    Accel,
}

impl Motion {
    /// Names of its derivative in a recorder command, before the tag of the parameter.
    const DERIVATIVES: [(&'static str, Self); 3] =
        [("sensitivity", Self::Disp), ("velSensitivity", Self::Vel), ("accSensitivity", Self::Accel)];

    /// Its values at all degrees of freedom.
    fn of(self, state: &State) -> &[f64] {
        match self {
            Self::Disp => &state.disp,
            Self::Vel => &state.vel,
            Self::Accel => &state.accel,
        }
    }
}

impl NodeQuantity {
    /// A derivative by its name.
    fn derivative(name: &str) -> Option<Self> {
        let mut of = Motion::DERIVATIVES.into_iter().filter_map(|(of, motion)| Some((name.strip_prefix(of)?, motion)));
        let (tag, motion) = of.next()?;
        Some(Self::Derivative(motion, tag.trim().parse().ok()?))
    }

    /// By its name in a recorder command.
    pub fn parse(name: &str) -> Option<Self> {
        Some(match name {
            "disp" => Self::Disp,
            "vel" => Self::Vel,
            "accel" => Self::Accel,
            "incrDisp" | "incrDeltaDisp" => Self::IncrDisp,
            "reaction" => Self::Reaction(ReactionKind::Static),
            "reactionIncInertia" | "reactionInclInertia" | "reactionIncludingInertia" => {
                Self::Reaction(ReactionKind::Dynamic)
            }
            "rayleighForces" | "rayleighDampingForces" => Self::Reaction(ReactionKind::Rayleigh),
            "unbalance" => Self::Unbalance { inertia: false },
            "unbalanceInclInertia" | "unbalanceIncInertia" | "unbalanceIncludingInertia" => {
                Self::Unbalance { inertia: true }
            }
            "dispNorm" => Self::DispNorm,
            "eigen" => Self::Modes,
            _ => match name.strip_prefix("eigen").map(|mode| mode.trim().parse()) {
                Some(Ok(0)) => Self::Modes,
                Some(Ok(mode)) => Self::Mode(mode),
                Some(Err(_)) => return None,
                None => Self::derivative(name)?,
            },
        })
    }

    /// Name of the columns of the degrees of freedom in OpenSees' XML files, before the number.
    fn symbol(self) -> String {
        match self {
            Self::Disp | Self::DispNorm => "D".to_owned(),
            Self::Vel => "V".to_owned(),
            Self::Accel => "A".to_owned(),
            Self::IncrDisp => "dD".to_owned(),
            Self::Reaction(_) => "R".to_owned(),
            Self::Unbalance { .. } => "U".to_owned(),
            Self::Mode(m) => format!("E{m}"),
            Self::Modes => "E".to_owned(),
            Self::Derivative(motion, parameter) => match motion {
                Motion::Disp => format!("sD{parameter}_"),
                Motion::Vel => format!("sV{parameter}_"),
                Motion::Accel => format!("sA{parameter}_"),
            },
        }
    }

    /// Names that [`NodeQuantity::parse`] knows, to suggest the nearest to a misspelled one.
    pub const NAMES: &'static [&'static str] = &[
        "disp",
        "vel",
        "accel",
        "incrDisp",
        "incrDeltaDisp",
        "reaction",
        "reactionIncludingInertia",
        "rayleighForces",
        "unbalance",
        "unbalanceIncludingInertia",
        "dispNorm",
        "eigen 1",
        "sensitivity 1",
        "velSensitivity 1",
        "accSensitivity 1",
    ];
}

/// Responses of some degrees of freedom of some nodes.
#[derive(Debug)]
pub struct NodeResponse {
    quantity: NodeQuantity,
    /// Nodes by tag; `None` for all of them.
    nodes: Option<Vec<Tag>>,
    /// Local degrees of freedom from 0; empty for all.
    dofs: Vec<usize>,
    /// Series added to each degree of freedom, in the order of `dofs`.
    series: Vec<Option<Series>>,
    /// Degrees of freedom found; `None` where a node has not got it.
    found: Vec<Option<usize>>,
    tags: Vec<Tag>,
    width: usize,
    reactions: Vec<f64>,
    last: Vec<f64>,
    /// Mode of the next row of all modes, from 0.
    mode: usize,
}

impl NodeResponse {
    /// Of nodes (all of them for `None`) and local degrees of freedom from 0 (all for none).
    pub fn new(quantity: NodeQuantity, nodes: Option<Vec<Tag>>, dofs: Vec<usize>, series: Vec<Option<Series>>) -> Self {
        let (found, tags, reactions, last) = (vec![], vec![], vec![], vec![]);
        Self { quantity, nodes, dofs, series, found, tags, width: 0, reactions, last, mode: 0 }
    }

    /// Values of all degrees of freedom that the quantity is taken from.
    fn field<'a>(&'a self, engine: &'a Engine) -> Option<&'a [f64]> {
        let state = engine.state();
        Some(match self.quantity {
            NodeQuantity::Disp | NodeQuantity::DispNorm => &state.disp,
            NodeQuantity::Vel => &state.vel,
            NodeQuantity::Accel => &state.accel,
            NodeQuantity::Mode(m) => engine.modes()?.shapes.get(m.checked_sub(1)?)?,
            NodeQuantity::Modes => engine.modes()?.shapes.get(self.mode)?,
            NodeQuantity::IncrDisp
            | NodeQuantity::Reaction(_)
            | NodeQuantity::Unbalance { .. }
            | NodeQuantity::Derivative(..) => &self.reactions,
        })
    }

    /// Work out what is not simply there.
    fn work_out(&mut self, engine: &mut Engine) -> Result<(), RecordError> {
        let failed = |f: crate::analysis::Failure| RecordError(f.to_string());
        match self.quantity {
            NodeQuantity::Reaction(kind) => {
                engine.reactions(kind, &mut self.reactions).map_err(failed)?;
                engine.keep_reactions(&self.reactions);
            }
            NodeQuantity::Unbalance { inertia } => engine.unbalanced(inertia, &mut self.reactions).map_err(failed)?,
            NodeQuantity::Derivative(motion, parameter) => {
                self.reactions.clear();
                if let Some(derivative) = engine.derivative(parameter) {
                    for i in 0..engine.model().dofs() {
                        self.reactions.push(derivative.of(|e| motion.of(e.state())[i]).map_err(failed)?);
                    }
                }
            }
            NodeQuantity::IncrDisp => {
                let disp = &engine.state().disp;
                self.last.resize(disp.len(), 0.0);
                self.reactions.clear();
                if engine.options.compat {
                    self.reactions.resize(disp.len(), 0.0);
                } else {
                    self.reactions.extend(disp.iter().zip(&self.last).map(|(u, last)| u - last));
                }
                self.last.copy_from_slice(disp);
            }
            _ => {}
        }
        Ok(())
    }
}

impl Source for NodeResponse {
    fn find(&mut self, engine: &Engine, missing: &mut Vec<Missing>) -> Result<(), RecordError> {
        let model = engine.model();
        let wanted: Vec<Tag> = self.nodes.clone().unwrap_or_else(|| model.node_tags().collect());
        self.found.clear();
        self.tags.clear();
        let all: Vec<usize>;
        let dofs = if self.dofs.is_empty() {
            all = (0..model.nodes.iter().map(|n| n.ndf).max().unwrap_or(0)).collect();
            &all
        } else {
            &self.dofs
        };
        self.width = dofs.len();
        for tag in wanted {
            let Some(id) = model.node(tag) else {
                missing.push(Missing::Node(tag));
                continue;
            };
            let node = &model.nodes[id.0];
            self.tags.push(tag);
            self.found.extend(dofs.iter().map(|&d| (d < node.ndf).then_some(node.offset + d)));
        }
        let ndf = |tag: &Tag| model.node(*tag).map_or(0, |id| model.nodes[id.0].ndf);
        if let (Some(first), Some(most)) = (self.tags.first(), self.tags.iter().map(ndf).max()) {
            let beyond = dofs.iter().filter(|d| **d >= most);
            missing.extend(beyond.map(|d| Missing::Dof { dof: d + 1, node: *first, ndf: ndf(first) }));
        }
        Ok(())
    }

    fn labels(&self) -> Vec<String> {
        let dofs = |i: usize| self.dofs.get(i).copied().unwrap_or(i) + 1;
        if self.quantity == NodeQuantity::DispNorm {
            return self.tags.iter().map(|t| format!("node {t}")).collect();
        }
        self.tags.iter().flat_map(|t| (0..self.width).map(move |i| format!("node {t} dof {}", dofs(i)))).collect()
    }

    fn groups(&self, engine: &Engine) -> Vec<Group> {
        let model = engine.model();
        let symbol = self.quantity.symbol();
        let dof = |i: usize| self.dofs.get(i).copied().unwrap_or(i) + 1;
        let columns: Vec<String> = if self.quantity == NodeQuantity::DispNorm {
            vec![symbol]
        } else {
            (0..self.width).map(|i| format!("{symbol}{}", dof(i))).collect()
        };
        let group = |tag: &Tag| Group {
            name: "NodeOutput",
            attributes: vec![("nodeTag", tag.to_string())],
            place: model.node(*tag).map(|id| model.nodes[id.0].place().into()),
            columns: columns.clone(),
        };
        self.tags.iter().map(group).collect()
    }

    fn makes_rows_only(&self) -> bool {
        self.quantity != NodeQuantity::Modes
    }

    fn next_row(&mut self, engine: &Engine) -> bool {
        let modes = engine.modes().map_or(0, |m| m.shapes.len());
        self.mode = if self.quantity == NodeQuantity::Modes && self.mode + 1 < modes { self.mode + 1 } else { 0 };
        self.mode > 0
    }

    fn numbers(&self, _: &Engine) -> Option<Vec<(Recorded, Option<Series>)>> {
        let number = match self.quantity {
            NodeQuantity::Disp => Recorded::Disp,
            NodeQuantity::Vel => Recorded::Vel,
            NodeQuantity::Accel => Recorded::Accel,
            _ => return None,
        };
        let series = |i: usize| self.series.get(i % self.width.max(1)).cloned().flatten();
        self.found.iter().enumerate().map(|(i, dof)| dof.map(|dof| (number(dof), series(i)))).collect()
    }

    fn row(&mut self, engine: &mut Engine, row: &mut Vec<f64>) -> Result<(), RecordError> {
        self.work_out(engine)?;
        let time = engine.state().time;
        let start = row.len();
        let field = self.field(engine);
        row.extend(self.found.iter().map(|d| match (d, field) {
            (Some(d), Some(f)) => f.get(*d).copied().unwrap_or(0.0),
            _ => 0.0,
        }));
        let adds = matches!(
            self.quantity,
            NodeQuantity::Disp | NodeQuantity::Vel | NodeQuantity::Accel | NodeQuantity::DispNorm
        );
        for (i, series) in self.series.iter().enumerate().filter(|_| adds) {
            if let Some(s) = series {
                let value = s.factor(time);
                row[start..].iter_mut().skip(i).step_by(self.width).for_each(|x| *x += value);
            }
        }
        if self.quantity == NodeQuantity::DispNorm && self.width > 0 {
            let n = (row.len() - start) / self.width;
            for i in 0..n {
                let part = &row[start + i * self.width..start + (i + 1) * self.width];
                row[start + i] = part.iter().map(|x| x * x).sum::<f64>().sqrt();
            }
            row.truncate(start + n);
        }
        Ok(())
    }
}
